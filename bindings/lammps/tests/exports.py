# SPDX-License-Identifier: GPL-2.0-or-later
"""A run of the engine that is stopped, exported, continued by both programs and compared."""

import json
import re
import shutil
import subprocess

from lammps_runs import PLUGIN, run


def engine(veridem, *words, codes=(0,), **options):
    """Runs the engine; returns what it prints."""
    done = subprocess.run([veridem, "--quiet", *map(str, words)], capture_output=True, text=True, timeout=1200, **options)
    if done.returncode not in codes:
        raise SystemExit(f"{veridem} {' '.join(map(str, words))} gave {done.returncode}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return done.stdout


# The exit status of a run that can be resumed.
STOPPED = 75


class Continued:
    """Some steps of a case from a step on, by both programs: differences of their states, and what they say on the way."""

    def __init__(self, veridem, folder, case, begin, steps, ranks=1):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self.folder, self.steps, stopped = folder, steps, (0, STOPPED)
        (folder / "case.yaml").write_text(case)
        run_folder = folder / "run"
        source = folder / "case.yaml"
        if begin > 0:
            engine(veridem, "run", source, "--out", run_folder, "--stop-after-steps", begin, codes=stopped)
            self.run_folder = source = run_folder / "case"
        engine(veridem, "export", "--lammps", source, "--out", folder / "there")
        text = (folder / "there/in.lammps").read_text()
        self.title = text.splitlines()[0]
        text = re.sub(r"^run \d+$", f"run {steps}", text, flags=re.MULTILINE)
        text += "write_dump all custom end.dump id radius xu yu zu vx vy vz omegax omegay omegaz modify format float %.17g sort id\n"
        self.out = run(folder / "there", f"variable plugin index {PLUGIN}\n{text}", ranks=ranks)
        if begin > 0:
            engine(veridem, "resume", self.run_folder, "--stop-after-steps", steps, codes=stopped)
        else:
            engine(veridem, "run", source, "--out", run_folder, "--stop-after-steps", steps, codes=stopped)
            self.run_folder = run_folder / "case"
        engine(veridem, "export", "--lammps", self.run_folder, "--out", folder / "here")
        # Back through `veridem import`, from both files that LAMMPS writes.
        for file, there in (("here/state.data", "here.xyz"), ("there/end.data", "there.xyz"), ("there/end.dump", "dump.xyz")):
            words = ["import", folder / file, "--unit", "1 nm", "--disconnected", "--out", folder / there]
            engine(veridem, *words)
        self.apart = self.diff(veridem, "there.xyz")
        self.dump_apart = self.diff(veridem, "dump.xyz")

    def diff(self, veridem, file):
        """The largest differences between the engine's state and that of LAMMPS, by column."""
        words = ["--json", "inspect", "--diff", self.folder / "here.xyz", self.folder / file]
        found = json.loads(engine(veridem, *words, codes=(0, 4)))
        return {column["column"]: column["difference"] for column in found["columns"]}

    def atoms(self):
        """The rows of the spheres in the data file."""
        return (self.folder / "there/state.data").read_text().split("Atoms # sphere")[1].split("Velocities")[0]

    def sides(self):
        """The largest difference of a side of the box."""
        ends = []
        for file in ("here/state.data", "there/end.data"):
            text = (self.folder / file).read_text()
            ends.append([float(high) - float(low) for low, high in re.findall(r"^(\S+) (\S+) [xyz]lo", text, flags=re.MULTILINE)])
        return max(abs(a - b) for a, b in zip(*ends))

    def breaks(self):
        """The necks that break: step and ids, as the engine and as LAMMPS tell."""
        pattern = r"the neck of (\d+) and (\d+) breaks"
        events = (json.loads(line) for line in (self.run_folder / "events.jsonl").read_text().splitlines())
        told = [(event["step"], re.search(pattern, event["event"])) for event in events]
        here = [(step, int(found[1]), int(found[2])) for step, found in told if found]
        log = re.findall(r"^veridem: step (\d+): " + pattern, self.out, flags=re.MULTILINE)
        there = [(int(step), int(i) - 1, int(j) - 1) for step, i, j in log]
        return sorted(here), sorted(there)
