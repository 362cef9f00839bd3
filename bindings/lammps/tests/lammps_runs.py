# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of LAMMPS with the plugin."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PLUGIN = ROOT / "target/lammps/veridemplugin.so"
BIN = Path(sys.executable).parent

HEAD = f"""units nano
atom_style sphere
newton off
comm_modify vel yes
plugin load {PLUGIN}
"""
DUMP = """dump last all custom {every} {file} id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz
dump_modify last format float %.17g first no
"""


def script(frame, style, dt, *, skin=1.0, before="", after="", step="fix step all veridem/step wall wall 1 NULL NULL NULL"):
    """The script of a state, up to its runs."""
    boundary = " ".join("p" if periodic else "s" for periodic in frame.periodic)
    return f"""{HEAD}boundary {boundary}
fix bodies all property/atom mol d_moment ghost yes
{before}
read_data state.data fix bodies NULL Members
pair_style {style}
pair_coeff * * history state.history
group wall type 2
neighbor {skin} bin
neigh_modify every 1 delay 0 check yes exclude group wall wall
timestep {dt!r}
{step}
compute energies all pair {style.split()[0]}
thermo 1000000
thermo_style custom step c_energies[*]
thermo_modify norm no format float %.15g
{after}
"""


def run(folder, text, ranks=1, fails=False, name="in", wrap=()):
    """Runs a script; returns what LAMMPS printed."""
    (Path(folder) / name).write_text(text)
    command = [str(BIN / "lmp"), "-in", name, "-log", "none"]
    if ranks > 1:
        command = [str(BIN / "mpiexec"), "-n", str(ranks), *command]
    done = subprocess.run([*wrap, *command], cwd=folder, capture_output=True, text=True, timeout=600)
    if (done.returncode != 0) != fails:
        raise SystemExit(f"{' '.join(command)} in {folder} gave {done.returncode}\n{done.stdout[-3000:]}\n{done.stderr[-2000:]}")
    return done.stdout + done.stderr


def thermo(out):
    """The rows of the log, one for each time that it shows: step, energies stored, energies lost."""
    lines = out.splitlines()
    heads = [k for k, line in enumerate(lines) if line.split()[:1] == ["Step"]]
    rows = []
    for head in heads:
        for line in lines[head + 1 :]:
            if line.startswith("Loop time"):
                break
            if line.startswith("veridem:"):
                continue
            rows.append([float(word) for word in line.split()])
    return rows
