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
    print("| particles | CPU ns per particle and step, 1 thread | wall, 2 threads | bytes per particle |\n|---|---|---|---|")
    for cells in CRYSTALS:
        one, two = (
            statistics.median(per_particle_step(engine(threads), threads, cells)[column] for _ in range(options.repeat))
            for threads, column in ((1, 0), (2, 1))
        )
        memory = (run(engine(1)(cells, 2), 1)[2] - empty) * 1024 / count(cells)
        print(f"| {count(cells)} | {1e9 * one:.1f} | {1e9 * two:.1f} | {memory:.0f} |", flush=True)


if __name__ == "__main__":
    main()
