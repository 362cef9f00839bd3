#!/usr/bin/env python3
"""Compares the engine with LIGGGHTS on a film of titania, whole process against whole process, in alternating pairs.

    apt-get install liggghts
    python3 benches/peers/liggghts.py [--spheres N] [--pairs N] [--instructions NAME]

Both start from the same film, with the same time step and skin, on one core: its aggregates once as rigid bodies (LIGGGHTS: `fix rigid
molecule`, as in the paper), once with all their spheres by themselves. The engine runs the law of the titania paper. LIGGGHTS as it is
packaged has no such law and runs the nearest that it is optimised for: Hertzian springs with tangential history and cohesion in proportion
to the contact area, but no meniscus beyond contact, no solvation and no resistance to rolling. Every figure is the difference of a long and
a short run, so that building the film and reading input cancel.
"""

import argparse
import shutil
import statistics
import subprocess
from pathlib import Path

from process import HOME, ROOT, TARGET, cost_of_step

HERE = Path(__file__).resolve().parent
ENGINE = TARGET / "release" / "film_steps"
STEPS = {"rigid": 10_000, "free": 3000}
DENSITY = 4.23e-3  # ag/nm^3


def write_film(bonding, spheres):
    """Writes the film for LIGGGHTS; returns the file, the number of spheres, and the engine's numbers of contacts and of pairs in range."""
    words = subprocess.run([ENGINE, bonding, str(spheres), "0"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    a, b, c, touching, in_range = words[0].split()
    data = HOME / f"film-{bonding}.data"
    with open(data, "w") as file:
        file.write(f"a film\n\n{len(words) - 1} atoms\n2 atom types\n\n0 {a} xlo xhi\n0 {b} ylo yhi\n-10 {float(c) + 100} zlo zhi\n\nAtoms\n\n")
        for number, line in enumerate(words[1:], 1):
            aggregate, x, y, z, radius, _, fixed = line.split()
            kind, x, y = 1 + int(fixed), float(x) % float(a), float(y) % float(b)
            file.write(f"{number} {kind} {x} {y} {z} {2 * float(radius)} {DENSITY} {int(aggregate) + 1}\n")
    return data, len(words) - 1, int(touching), int(in_range)


def liggghts(binary, data, bonding, steps, screen="none"):
    """The command that makes LIGGGHTS advance the film by a number of steps."""
    variables = [word for pair in (("data", data), ("rigid", int(bonding == "rigid")), ("steps", steps)) for word in ("-var", *pair)]
    return [binary, "-in", HERE / "liggghts.in", "-log", "none", "-screen", screen, *variables]


def contacts(binary, data, bonding):
    """Contacts that LIGGGHTS finds in the film as it is given."""
    report = HOME / "liggghts.txt"
    subprocess.run([str(word) for word in liggghts(binary, data, bonding, 0, report)], check=True, stdout=subprocess.DEVNULL)
    lines = report.read_text().splitlines()
    row = next(number for number, line in enumerate(lines) if line.split()[:2] == ["Step", "Atoms"]) + 1
    return round(0.5 * float(lines[row].split()[1]) * float(lines[row].split()[2]))


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--spheres", type=int, default=20_000, help="spheres of the film (default 20,000)")
    arguments.add_argument("--pairs", type=int, default=5, help="how often both are measured (default 5)")
    arguments.add_argument("--instructions", nargs=1, default=(), help="those of the engine: baseline, avx2 or avx512 (default: the widest)")
    options = arguments.parse_args()
    binary = shutil.which("liggghts")
    if binary is None:
        raise SystemExit("liggghts is missing; on Debian: apt-get install liggghts")
    subprocess.run(["cargo", "build", "--release", "--package", "veridem-peers", "--bin", "film_steps"], check=True, cwd=ROOT)
    HOME.mkdir(parents=True, exist_ok=True)

    print("| spheres are | number | contacts, LIGGGHTS | contacts, veridem | pairs in range, veridem | LIGGGHTS, ns | veridem, ns | ratio |")
    print("|---|---|---|---|---|---|---|---|")
    for bonding, long in STEPS.items():
        data, spheres, touching, in_range = write_film(bonding, options.spheres)
        found = contacts(binary, data, bonding)
        programs = (
            lambda steps: liggghts(binary, data, bonding, steps),
            lambda steps: [ENGINE, bonding, options.spheres, steps, *options.instructions],
        )
        turns = [[cost_of_step(program, 1, long // 10, long)[0] / spheres for program in programs] for _ in range(options.pairs)]
        theirs, ours = (1e9 * statistics.median(costs) for costs in zip(*turns))
        ratio = statistics.median(a / b for a, b in turns)
        per_sphere = [f"{number / spheres:.3f}" for number in (found, touching, in_range)]
        what = {"rigid": "in rigid aggregates", "free": "by themselves"}[bonding]
        print("|", " | ".join([what, str(spheres), *per_sphere, f"{theirs:.1f}", f"{ours:.1f}", f"{ratio:.2f}"]), "|", flush=True)


if __name__ == "__main__":
    main()
