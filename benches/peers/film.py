#!/usr/bin/env python3
"""Cost of a step of a film: the paper's film is built and relaxed for a while, then taken up from there again and again.

    python3 benches/peers/film.py [--case FILE] [--settle STEPS] [--steps STEPS] [--repeat N]

The figure is the difference of a long and a short run, so setting up counts nothing.
"""

import argparse
import shutil
import statistics
import subprocess
from pathlib import Path

from process import HOME, ROOT, STOPPED, TARGET, run

SHORT = 50


def veridem(*arguments):
    """Runs the program to where it is told to stop; CPU seconds, wall-clock seconds, largest memory in kB."""
    return run([TARGET / "release" / "veridem", "--quiet", *arguments], 1, STOPPED)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--case", default=ROOT / "cases" / "titania" / "film-full.yaml", type=Path)
    arguments.add_argument("--settle", type=int, default=6000, help="steps before anything is measured")
    arguments.add_argument("--steps", type=int, default=1000, help="steps that are measured")
    arguments.add_argument("--repeat", type=int, default=3)
    options = arguments.parse_args()
    subprocess.run(["cargo", "build", "--release"], check=True, cwd=ROOT)
    HOME.mkdir(parents=True, exist_ok=True)
    film, start = HOME / "run" / "film", HOME / "run" / "film-start"
    shutil.rmtree(start, ignore_errors=True)
    case = options.case.resolve()
    built = veridem("run", case, "--out", HOME / "run", "--name", "film", "--force", "--stop-after-steps", options.settle)
    film.rename(start)
    print(f"built and settled: {built[0]:.0f} s of CPU, {built[2] / 1024:.0f} MB")

    def measure(threads, steps):
        shutil.rmtree(film, ignore_errors=True)
        shutil.copytree(start, film)
        return veridem("--threads", threads, "resume", film, "--stop-after-steps", steps)

    for threads, column in ((1, 0), (2, 1)):
        cost = [
            (measure(threads, SHORT + options.steps)[column] - measure(threads, SHORT)[column]) / options.steps
            for _ in range(options.repeat)
        ]
        print(f"{threads} threads, {('CPU', 'wall')[column]}: {1e3 * statistics.median(cost):.2f} ms a step")


if __name__ == "__main__":
    main()
