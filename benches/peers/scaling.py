#!/usr/bin/env python3
"""Cost per particle and step, and memory per particle, of HCP crystals from 6,000 to 1,000,000 spheres.

    python3 benches/peers/scaling.py [--repeat N]
"""

import argparse
import statistics

from process import build_engine, count, engine, per_particle_step, run

CRYSTALS = [(18, 12, 7), (29, 17, 26), (60, 34, 37), (85, 49, 60)]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--repeat", type=int, default=3, help="how often each size is measured (default 3)")
    options = arguments.parse_args()
    build_engine()
    empty = run(engine(1)((2, 2, 2), 0), 1)[2]
    # Every size in each round: what else the machine does in the meantime falls on all of them.
    rounds = [
        [[per_particle_step(engine(threads), threads, cells)[threads - 1] for threads in (1, 2)] for cells in CRYSTALS]
        for _ in range(options.repeat)
    ]
    print("| particles | CPU ns per particle and step, 1 thread | wall, 2 threads | bytes per particle |\n|---|---|---|---|")
    for size, cells in enumerate(CRYSTALS):
        one, two = (statistics.median(sizes[size][column] for sizes in rounds) for column in (0, 1))
        memory = (run(engine(1)(cells, 2), 1)[2] - empty) * 1024 / count(cells)
        print(f"| {count(cells)} | {1e9 * one:.1f} | {1e9 * two:.1f} | {memory:.0f} |")
    growth = [statistics.median(sizes[-1][column] / sizes[0][column] for sizes in rounds) for column in (0, 1)]
    print(f"\nLargest against smallest, median of the rounds: {growth[0]:.2f} (CPU), {growth[1]:.2f} (wall)")

if __name__ == "__main__":
    main()
