# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks the plugin against the engine: python check.py VERIDEM [--full]. Run it with the Python of the environment of the plugin.

Forces of one step, trajectories, numbers of processes, restarts, the history over rebuilds and migration, refusals."""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

import cases
import misuse
from exports import Continued
from frames import Frame, cells, ledger, read_dump, write_state
from lammps_runs import DUMP, HEAD, PLUGIN, ROOT, run, script, thermo

WORK = ROOT / "target/lammps/check"
RIGID = "neigh_modify exclude molecule/intra all"
failed = []


def say(what, value, limit):
    """Reports a number that must not exceed a limit."""
    good = value <= limit
    print(f"{'ok' if good else 'FAILED':7}{what}: {value:.1e}, at most {limit:.0e}", flush=True)
    if not good:
        failed.append(what)


def engine(veridem, name, case):
    """Runs a case with the engine; returns its frames by stage."""
    folder = WORK / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "case.yaml").write_text(case)
    subprocess.run([veridem, "--quiet", "run", "case.yaml", "--out", "run", "--force"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    frames = {}
    for path in sorted((folder / "run/case/frames").glob("*.xyz")):
        frames.setdefault(path.name.split(".")[0], []).append(Frame(path))
    return folder, frames


def columns(table, *names):
    return np.stack([table[name] for name in names], axis=1)


def difference(table, frame, of=None):
    """Largest differences of position, nm, and of velocity, m/s."""
    order = frame.reorder()
    way = columns(table, "x", "y", "z") - frame["pos"][order]
    for a in range(3):
        if frame.periodic[a]:
            way[:, a] -= frame.sides[a] * np.round(way[:, a] / frame.sides[a])
    return abs(way).max(), abs(columns(table, "vx", "vy", "vz") - frame["velo"][order]).max()


def forces(folder, frame, style, dt, what, after="", among=()):
    """Forces and torques of one step are the engine's, to rounding of the largest, `among` other frames too: where spheres are at rest, forces of pairs cancel."""
    write_state(folder, frame)
    run(folder, script(frame, style, dt, after=after) + DUMP.format(every=1, file="one.dump") + "run 1\n")
    table, order = read_dump(folder / "one.dump"), frame.reorder()
    free = frame["wall"][order] == 0
    for kind, names in (("force", ("fx", "fy", "fz")), ("torque", ("tqx", "tqy", "tqz"))):
        theirs = frame[kind][order]
        error = abs(columns(table, *names) - theirs)[free].max() / max(abs(other[kind]).max() for other in (frame, *among))
        say(f"{what}: {kind}s of one step, of the largest", error, 1e-12)


def trajectory(folder, begin, end, style, dt, what, limits, ranks=(1,), **options):
    """The state after some steps is the engine's, on any number of processes."""
    write_state(folder, begin)
    steps = end.step - begin.step
    tables = {}
    for count in ranks:
        file = f"end-{count}.dump"
        text = script(begin, style, dt, **options) + DUMP.format(every=steps, file=file) + f"run {steps}\n"
        out = run(folder, text, ranks=count)
        rebuilds = int(re.search(r"Neighbor list builds = (\d+)", out)[1])
        tables[count] = read_dump(folder / file)
        x, v = difference(tables[count], end)
        say(f"{what}: positions after {steps} steps on {count} processes, {rebuilds} rebuilds, nm", x, limits[0])
        say(f"{what}: velocities, m/s", v, limits[1])
        accounts(folder, begin, end, thermo(out), f"{what}, {count} processes")
    return tables


def accounts(folder, begin, end, rows, what):
    """Energies by cause are the engine's: stored at the beginning, lost on the way."""
    (stored, before), (_, after) = [ledger(folder / "run/case", begin.stage, frame.step) for frame in (begin, end)]
    first, last = (np.array(row[1:]) for row in (rows[0], rows[-1]))
    error = abs(first[: len(stored)] - stored).max() / abs(stored).max()
    say(f"{what}: energies stored, {len(stored)} causes, of the largest", error, 1e-11)
    error = abs(last[len(stored) :] - (after - before)).max() / abs(after - before).max()
    say(f"{what}: energies lost, {len(before)} causes, of the largest", error, 1e-8)


def step_of(frames):
    """The time step of a stage, ns."""
    a, b = frames[0], frames[-1]
    return (b.time - a.time) / (b.step - a.step)


def wear(veridem):
    folder, frames = engine(veridem, "junction", cases.JUNCTION)
    for frame in frames["shearing"][1:]:
        forces(folder, frame, cases.WEAR, step_of(frames["shearing"]), f"junction at step {frame.step}")
    folder, frames = engine(veridem, "patch", cases.PATCH)
    shear, dt = frames["shear"], step_of(frames["shear"])
    # The wall of a shear test keeps its velocity.
    damped = "fix step all veridem/step damping 0.5 wall wall 1 NULL NULL NULL"
    trajectory(folder, shear[1], shear[2], cases.WEAR, dt, "patch in shear", (1e-9, 1e-6), ranks=(1, 2, 4), step=damped)
    many_rebuilds(folder, shear[1], dt, damped)
    restart(folder, shear[1], cases.WEAR, dt, "patch", 1e-10, step=damped)


def many_rebuilds(folder, frame, dt, step):
    """History goes with spheres that change processes at every rebuild: a stream through the box, with a skin that is soon used up."""
    tables = {}
    stream = "velocity all set 300 NULL -300 sum yes units box\n"
    for count, skin in ((1, 1.0), (4, 0.2)):
        text = script(frame, cases.WEAR, dt, skin=skin, step=step.replace(" damping 0.5", ""), before="atom_modify sort 100 0.0", after=stream)
        out = run(folder, text + DUMP.format(every=1000, file="stream.dump") + "run 1000\n", ranks=count)
        tables[count] = read_dump(folder / "stream.dump")
        rebuilds = int(re.search(r"Neighbor list builds = (\d+)", out)[1])
    say("stream: 30 over rebuilds on 4 processes", 30 / max(rebuilds, 1), 1)
    way = columns(tables[1], "x", "y", "z") - columns(tables[4], "x", "y", "z")
    for a in range(3):
        if frame.periodic[a]:
            way[:, a] -= frame.sides[a] * np.round(way[:, a] / frame.sides[a])
    say(f"stream: positions after {rebuilds} rebuilds with migration, nm", abs(way).max(), 1e-9)


def restart(folder, frame, style, dt, what, limit, **options):
    """A run that is continued from a restart file, on another number of processes, ends where the whole run ends."""
    write_state(folder, frame)
    whole = script(frame, style, dt, **options)
    run(folder, whole + DUMP.format(every=400, file="whole.dump") + "run 200\nwrite_restart half.restart\nrun 200\n", ranks=2)
    begin = whole.index("fix bodies")
    rest = whole[begin:].replace("read_data state.data fix bodies NULL Members", "read_restart half.restart")
    rest = rest.replace("pair_coeff * * history state.history", "pair_coeff * *").replace("group wall type 2\n", "")
    lines = rest.splitlines()
    bodies = lines.pop(0)
    lines.insert([line.startswith("read_restart") for line in lines].index(True) + 1, bodies)
    text = HEAD + "\n".join(lines) + "\n" + DUMP.format(every=400, file="rest.dump") + "run 200\n"
    run(folder, text, ranks=4)
    one, two = read_dump(folder / "whole.dump"), read_dump(folder / "rest.dump")
    way = columns(one, "x", "y", "z") - columns(two, "x", "y", "z")
    for a in range(3):
        if frame.periodic[a]:
            way[:, a] -= frame.sides[a] * np.round(way[:, a] / frame.sides[a])
    say(f"{what}: positions after a restart on 4 processes, nm", abs(way).max(), limit)


def soot(veridem):
    folder, frames = engine(veridem, "aggregate", cases.AGGREGATE)
    begin, end = frames["restructuring"][-2:]
    for frame in (begin, end):
        forces(folder, frame, cases.SOOT, 5e-6, f"aggregate at step {frame.step}")
    trajectory(folder, begin, end, cases.SOOT, 5e-6, "aggregate", (1e-9, 1e-6), ranks=(1, 2, 4))
    restart(folder, begin, cases.SOOT, 5e-6, "aggregate", 1e-10)


def titania(veridem):
    folder, frames = engine(veridem, "film", cases.FILM)
    for frame in frames["retraction"]:
        if abs(frame["force"]).max() > 100.0:
            what = f"film at step {frame.step}"
            forces(folder, frame, cases.TITANIA, 5e-4, what, after=RIGID, among=frames["retraction"])


def exported(veridem, name, source, end, what, limits, ranks=1):
    """What `veridem export --lammps` writes runs in LAMMPS and ends where the engine does; `veridem import` reads the result."""
    folder = WORK / "exported" / name
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([veridem, "--quiet", "export", "--lammps", source, "--out", folder], check=True, stdout=subprocess.DEVNULL)
    text = (folder / "in.lammps").read_text()
    run(folder, f"variable plugin index {PLUGIN}\n{text}", ranks=ranks)
    x, v = difference(read_dump(sorted(folder.glob("frames.*.dump"))[-1]), end)
    say(f"{what}: positions at the end, nm", x, limits[0])
    say(f"{what}: velocities, m/s", v, limits[1])
    imported = [veridem, "--json", "import", folder / "end.data", "--disconnected", "--unit", "1 nm"]
    read = json.loads(subprocess.run(imported, check=True, capture_output=True, text=True, timeout=600).stdout)
    spheres = read["report"]["number"]
    say(f"{what}: spheres that `veridem import` misses", abs(end.count - spheres), 0)
    return x


def exports(veridem):
    folder, frames = engine(veridem, "junction", cases.JUNCTION)
    run_folder = folder / "run/case"
    exported(veridem, "junction", run_folder, frames["shearing"][-1], "exported junction under a load", (1e-9, 1e-6), ranks=2)
    folder, frames = engine(veridem, "aggregate", cases.AGGREGATE)
    exported(veridem, "aggregate", folder / "case.yaml", frames["restructuring"][-1], "exported aggregate", (1e-6, 1e-3))
    folder, frames = engine(veridem, "deposition", cases.DEPOSITION)
    exported(veridem, "deposition", folder / "case.yaml", frames["deposition"][-1], "exported deposition on a plane", (1e-9, 1e-6), ranks=2)
    # LAMMPS turns rigid bodies with a scheme of its own: the same up to the error of the time step.
    errors = []
    for dt in (0.5, 0.25):
        case = cases.COLLISION.format(file=ROOT / "tests/data/aggregates/two_bodies.csv", dt=dt)
        folder, frames = engine(veridem, f"collision-{dt}", case)
        (end,) = [stage[-1] for stage in frames.values()]
        errors.append(exported(veridem, f"collision-{dt}", folder / "case.yaml", end, f"exported rigid bodies, {dt} ps", (0.1, 1.0)))
    say("exported rigid bodies: error at half the time step, of that at the whole", errors[1] / errors[0], 0.7)


def continued(veridem, name, case, stage, begin, steps, what, limits, ranks=1, before=0):
    """A stage from a step on, exported and continued by both programs: `before` steps of other stages come first. The results come back through
    `veridem import` and are compared by `veridem inspect --diff`."""
    both = Continued(veridem, WORK / "continued" / name, case, before + begin, steps, ranks)
    if f": {stage}, from step {begin}" not in both.title:
        raise SystemExit(f"{what}: expected {stage} from step {begin}, found {both.title}")
    for column, limit in zip(("pos", "velo", "angular_velocity"), limits):
        say(f"{what}: {column} after {steps} steps on {ranks} processes", both.apart[column], limit)
    say(f"{what}: positions in the dump beside those in the data file", abs(both.dump_apart["pos"] - both.apart["pos"]), 1e-12)
    return both


def balance(both, stage, begin, what, lost=1e-8):
    """Energies by cause are the engine's, as its series and the log of LAMMPS have them: stored at the beginning, lost on the way."""
    rows, shown = thermo(both.out), 5
    (stored, before), (_, after) = [ledger(both.run_folder, stage, step) for step in (begin, begin + both.steps)]
    first, last = (np.array(row[shown:]) for row in (rows[0], rows[-1]))
    count, end = len(stored), len(stored) + len(before)
    say(f"{what}: energies stored, {count} causes, of the largest", abs(first[:count] - stored).max() / abs(stored).max(), 1e-9)
    gone = after - before
    say(f"{what}: energies lost, {len(gone)} causes, of the largest", abs(last[count:end] - gone).max() / abs(gone).max(), lost)
    return last[end:]


def breaking(veridem):
    """Necks that break in both programs at the same step, and the energy that they lose."""
    stress = "break_stress: {tension: 5 GPa, shear: 5 GPa, neck_radius: 5 nm}"
    energy = "break_energy: 1e-20 J"
    for name, strength, integrator, ranks in (
        ("stress", stress, "half-step", 1),
        ("energy", energy, "half-step", 4),
        ("stress-verlet", stress, "velocity-verlet", 2),
    ):
        case, what = cases.BREAKING.format(strength=strength, integrator=integrator), f"necks that break by {name}"
        both = continued(veridem, f"breaking-{name}", case, "restructuring", 0, 3000, what, (1e-6, 1e-3, 1e-3), ranks)
        agree(*both.breaks(), what)
        balance(both, "restructuring", 0, what)
    what = "necks that break in a film"
    both = continued(veridem, "breaking-film", cases.NECKS, "relaxation", 0, 600, what, (1e-6, 1e-3, 1e-3), 2)
    agree(*both.breaks(), what)
    balance(both, "relaxation", 0, what)


def agree(here, there, what):
    """The same necks break at the same steps."""
    say(f"{what}: one over {len(here)} necks", 1 / max(len(here), 1e-9), 1)
    say(f"{what}: necks that break at another step or not at all", len(set(here) ^ set(there)), 0)


def relaxation(veridem):
    """A box whose sides follow the stress, and the reading of the authors' program."""
    what = "box that relaxes"
    for begin, steps in ((1, 100), (100, 80)):
        both = continued(veridem, f"relaxation-{begin}", cases.RELAXATION, "cohesion", begin, steps, what, (1e-10, 1e-6, 1e-6), 2, before=100)
        say(f"{what}: sides of the box, nm", both.sides(), 1e-10)
    balance(both, "cohesion", begin, what)
    # Before neighbours are listed anew, after which both programs forget other springs.
    what = "law of the published program"
    both = continued(veridem, "published", cases.PUBLISHED, "shear", 0, 40, what, (1e-10, 1e-6, 1e-6), 2)
    balance(both, "shear", 0, what)


def pulling(veridem):
    """Springs that pull an agglomerate."""
    for hold, along in (("springs", "all"), ("frozen", "x")):
        case, what = cases.CHAIN.format(hold=hold, along=along), f"agglomerate that a spring pulls along {along}, held: {hold}"
        both = continued(veridem, f"pulling-{hold}", case, "pulling", 100, 400, what, (1e-8, 1e-4, 1e-4), 2, before=200)
        balance(both, "pulling", 100, what)


def planes(veridem):
    """Energies stored and lost at a plane."""
    what = "deposition"
    both = continued(veridem, "deposition", cases.DEPOSITION, "deposition", 0, 11900, what, (1e-9, 1e-6, 1e-6), 2)
    stored, lost = np.split(balance(both, "deposition", 0, what, 1e-6)[3:], [7])
    here = cells(both.run_folder, "deposition", 11900)["lost at surfaces [zJ]"]
    say(f"{what}: energy lost at the plane, of {here:.1f} zJ", abs(lost.sum() - here) / here, 1e-6)


def tip(veridem):
    """A tip that approaches a film of rigid aggregates, reverses and returns."""
    folder, frames = engine(veridem, "film", cases.FILM)
    events = [json.loads(line) for line in (folder / "run/case/events.jsonl").read_text().splitlines()]
    before = sum(event["step"] for event in events if event["event"] == "end" and event["stage"] != "retraction")
    what, begin, steps = "tip that returns", 2000, 8000
    both = continued(veridem, "tip", cases.FILM, "retraction", begin, steps, what, (1.0, 30.0, 30.0), 2, before=before)
    height = [np.loadtxt(both.folder / file, skiprows=2, usecols=3) for file in ("here.xyz", "there.xyz")]
    types = dict(re.findall(r"^(\d+) ([123]) ", both.atoms(), flags=re.MULTILINE))
    is_tip = [types[str(k + 1)] == "3" for k in range(len(types))]
    say(f"{what}: height of the tip after {steps} steps", abs(height[0] - height[1])[is_tip].max(), 1e-9)


def hosts(veridem):
    """Two hosts that reach each other over sockets give what one process gives."""
    if os.geteuid() != 0 or not shutil.which("ip"):
        print("left out: two hosts, which need root and iproute2")
        return
    folder, frames = engine(veridem, "patch", cases.PATCH)
    begin, end = frames["shear"][1:3]
    write_state(folder, begin)
    damped = "fix step all veridem/step damping 0.5 wall wall 1 NULL NULL NULL"
    steps = end.step - begin.step
    text = script(begin, cases.WEAR, step_of(frames["shear"]), step=damped) + DUMP.format(every=steps, file="hosts.dump") + f"run {steps}\n"
    (folder / "in.hosts").write_text(text)
    command = [Path(__file__).with_name("hosts.sh"), folder, "in.hosts"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    sent = re.search(r"bytes sent to the other host: (\d+)", done.stdout)
    if done.returncode != 0 or "on 2 procs" not in done.stdout or not sent:
        raise SystemExit(done.stdout[-2000:] + done.stderr[-2000:])
    x, v = difference(read_dump(folder / "hosts.dump"), end)
    say(f"two hosts, {int(sent[1]) / 1e6:.1f} MB sent from one to the other: positions after {steps} steps, nm", x, 1e-9)
    say("two hosts: a step whose neighbours were not sent, 1000 bytes per step", 1000.0 * steps / int(sent[1]), 1)


def refusals(veridem):
    """Wrong input ends LAMMPS with an error that names it, on every process; what is merely unusual works."""
    patch = engine(veridem, "patch", cases.PATCH)[1]["shear"][1]
    film = engine(veridem, "film", cases.FILM)[1]["retraction"][-1]
    aggregate = engine(veridem, "aggregate", cases.AGGREGATE)[1]["restructuring"][-2]
    folder = WORK / "refusals"
    shutil.rmtree(folder, ignore_errors=True)
    for what, good in misuse.outcomes(folder, patch, aggregate, film):
        say(what, 0 if good else 1, 0)
    other_version(folder, patch)


def other_version(folder, frame):
    """A plugin for another version of LAMMPS."""
    other = folder / "otherplugin.so"
    library = PLUGIN.read_bytes()
    version = 20250722
    assert library.count(version.to_bytes(4, "little")) > 0
    other.write_bytes(library.replace(version.to_bytes(4, "little"), (20240829).to_bytes(4, "little")))
    write_state(folder, frame)
    out = run(folder, script(frame, cases.WEAR, 6e-5).replace(str(PLUGIN), str(other)) + "run 2\n", fails=True)
    say("refused: a plugin for another LAMMPS", 0 if "ERROR" in out and "the plugin was built for LAMMPS" in out else 1, 0)


CHECKS = (wear, soot, titania, exports, breaking, relaxation, pulling, planes, tip, hosts, refusals)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("veridem")
    parser.add_argument("--only", choices=[check.__name__ for check in CHECKS])
    arguments = parser.parse_args()
    veridem = str(Path(arguments.veridem).resolve())
    for check in CHECKS:
        if arguments.only in (None, check.__name__):
            check(veridem)
    if failed:
        sys.exit(f"{len(failed)} checks failed")


main()
