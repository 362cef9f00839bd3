#!/usr/bin/env python3
"""Cost of a step of a soot aggregate that restructures, for every instruction set, beside the authors' program.

    python3 benches/peers/soot.py [--case FILE] [--repeat N]

The case is run with the attraction of distant pairs evaluated in every step and in every tenth. Every figure is the difference of a long and a short run,
so that starting up counts nothing; output is included. The authors' program takes 478 ns per sphere and step in this initial state on an AMD EPYC with AVX-512, and
1467 ns on one of an older make.
"""

import argparse
import statistics
import subprocess
from pathlib import Path

from process import HOME, ROOT, STOPPED, TARGET, cost_of_step

SPHERES = 150
SHORT, LONG = 5_000, 105_000
AUTHORS = 478


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--case", default=ROOT / "cases" / "soot" / "restructuring.yaml", type=Path)
    arguments.add_argument("--repeat", type=int, default=5, help="how often each is measured (default 5)")
    arguments.add_argument("--authors", type=float, default=AUTHORS, help=f"ns per sphere and step of the authors' program (default {AUTHORS})")
    options = arguments.parse_args()
    subprocess.run(["cargo", "build", "--release"], check=True, cwd=ROOT)
    HOME.mkdir(parents=True, exist_ok=True)
    text = options.case.read_text()
    cases = {every: HOME / f"soot-{every}.yaml" for every in (1, 10)}
    for every, file in cases.items():
        file.write_text(text.replace("attraction_every: 10", f"attraction_every: {every}"))

    def command(instructions, every):
        program = [TARGET / "release" / "veridem", "--quiet", "--threads", 1, "--instructions", instructions]
        return lambda steps: [*program, "run", cases[every], "--out", HOME / "run", "--force", "--stop-after-steps", steps]

    print("| instructions | attraction every | ns per sphere and step, CPU | authors' program over it |\n|---|---|---|---|")
    sets = ("avx512", "avx2", "baseline")
    rounds = [
        {(name, every): cost_of_step(command(name, every), 1, SHORT, LONG, STOPPED)[0] / SPHERES for name in sets for every in cases}
        for _ in range(options.repeat)
    ]
    for name, every in rounds[0]:
        cost = 1e9 * statistics.median(costs[name, every] for costs in rounds)
        print(f"| {name} | {every} | {cost:.1f} | {options.authors / cost:.1f} |")


if __name__ == "__main__":
    main()
