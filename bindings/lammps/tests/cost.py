# SPDX-License-Identifier: GPL-2.0-or-later
"""Cost of a step: python cost.py [--cells X Y Z] [--ranks N ...] [--steps N] [--turns N]. Run it with the Python of the environment of the plugin.

A periodic HCP crystal of touching spheres, twelve neighbours each, listed once: the plugin's wear law beside LAMMPS's own
gran/hooke/history, taking turns; nanoseconds per particle and step of one process, by the
loop time that LAMMPS prints: CPU time of one process, wall time of several."""

import argparse
import re
import statistics

from lammps_runs import PLUGIN, ROOT, run

CRYSTAL = """units nano
atom_style sphere
newton {newton}
boundary p p p
comm_modify vel yes
plugin load {plugin}
lattice hcp 5.94
region box block 0 {x} 0 {y} 0 {z}
create_box 1 box
create_atoms 1 box
set group all diameter 6.0 density 2.2
velocity all create 0.001 20220207 loop geom
pair_style {style}
pair_coeff * *
neighbor 0.6 bin
neigh_modify every 1 delay 0 check yes
fix motion {motion}
timestep 0.0001
thermo 1000000
run {warm}
run {steps}
"""
STYLES = {
    "gran/hooke/history": ("gran/hooke/history 200000 100000 100 50 0.5 1", "on", "all nve/sphere"),
    "veridem/wear": (
        "veridem/wear young_modulus 73000 poisson_ratio 0.17 tensile_strength 16000 shear_strength 11000 surface_energy 1500 "
        "restitution 0.95 scaling 0.5",
        "off",
        "all veridem/step",
    ),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--cells", type=int, nargs=3, default=[18, 12, 7])
    parser.add_argument("--ranks", type=int, nargs="+", default=[1])
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--only", choices=list(STYLES))
    options = parser.parse_args()
    x, y, z = options.cells
    count = 4 * x * y * z
    folder = ROOT / "target/lammps/cost"
    folder.mkdir(parents=True, exist_ok=True)
    for ranks in options.ranks:
        times = {name: [] for name in STYLES if options.only in (None, name)}
        for _ in range(options.turns):
            for name in times:
                style, newton, motion = STYLES[name]
                text = CRYSTAL.format(
                    newton=newton, plugin=PLUGIN, x=x, y=y, z=z, style=style, motion=motion, warm=options.steps // 10, steps=options.steps
                )
                out = run(folder, text, ranks=ranks)
                assert f"Created {count} atoms" in out, out[:2000]
                wall = float(re.findall(r"Loop time of (\S+) on", out)[-1])
                share = float(re.findall(r"(\S+)% CPU use with", out)[-1]) / 100.0
                seconds = wall * min(share, 1.0) if ranks == 1 else wall
                memory = [float(m) for m in re.findall(r"Per MPI rank memory allocation \(min/avg/max\) = \S+ \| (\S+)", out)]
                times[name].append(1e9 * seconds * ranks / count / options.steps)
        for name, samples in times.items():
            spread = ", ".join(f"{sample:.0f}" for sample in sorted(samples))
            print(f"{count} spheres, {ranks} processes, {name}: {statistics.median(samples):.0f} ns ({spread}); {memory[-1] * ranks:.0f} MB counted by LAMMPS", flush=True)


main()
