"""Frames of veridem, and states of LAMMPS made from them."""

import re
from pathlib import Path

import numpy as np

SPRINGS = "spring_"


class Frame:
    """Spheres of an extended XYZ frame by column, with the pairs beside it."""

    def __init__(self, path):
        path = Path(path)
        with open(path) as lines:
            self.count = int(next(lines))
            head = next(lines)
            table = np.array([line.split()[1:] for line in lines], dtype=float).reshape(self.count, -1)
        lattice = re.search(r'Lattice="([^"]*)"', head)
        self.sides = np.array([float(x) for x in lattice[1].split()])[[0, 4, 8]] if lattice else None
        periodic = re.search(r'pbc="([^"]*)"', head)
        self.periodic = [letter == "T" for letter in periodic[1].split()] if periodic else [False] * 3
        self.step = int(re.search(r"step=(\d+)", head)[1])
        self.time = float(re.search(r"Time=(\S+)", head)[1])
        self.columns, at = {}, 0
        for name, _, width in re.findall(r"(\w+):([IR]):(\d+)", head):
            values = table[:, at : at + int(width)]
            self.columns[name] = values[:, 0] if int(width) == 1 else values
            at += int(width)
        self.pairs = Pairs(path.with_suffix(".bonds"))

    def __getitem__(self, name):
        return self.columns[name]

    def reorder(self):
        """The places of the spheres by id."""
        return np.argsort(self["id"].astype(int))


class Pairs:
    """A local dump of pairs: ids, kind, springs."""

    def __init__(self, path):
        with open(path) as file:
            lines = file.read().splitlines()
        head = next(k for k, line in enumerate(lines) if line.startswith("ITEM: ENTRIES"))
        names = lines[head].split()[2:]
        rows = np.array([line.split() for line in lines[head + 1 :]], dtype=float).reshape(-1, len(names))
        self.ids = rows[:, :2].astype(int)
        self.kind = rows[:, names.index("btype")].astype(int)
        springs = [k for k, name in enumerate(names) if name.startswith(SPRINGS)]
        self.springs = rows[:, springs]


def write_state(folder, frame, margin=50.0, properties=None):
    """Writes `state.data` and `state.history`; ids of LAMMPS begin with 1."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    x, ids = frame["pos"], frame["id"].astype(int) + 1
    low, high = x.min(axis=0) - margin, x.max(axis=0) + margin
    for a in range(3):
        if frame.periodic[a]:
            low[a], high[a] = 0.0, frame.sides[a]
    wall = frame["wall"].astype(int) if "wall" in frame.columns else np.zeros(frame.count, dtype=int)
    number = lambda value: repr(float(value))
    density = frame["mass"] / (4.0 / 3.0 * np.pi * frame["radius"] ** 3)
    with open(folder / "state.data", "w") as out:
        out.write(f"state at {frame.time} ns\n\n{frame.count} atoms\n2 atom types\n\n")
        for a, name in enumerate("xyz"):
            out.write(f"{number(low[a])} {number(high[a])} {name}lo {name}hi\n")
        out.write("\nAtoms # sphere\n\n")
        for k in range(frame.count):
            kind = 2 if wall[k] else 1
            numbers = [2.0 * frame["radius"][k], density[k], *x[k]]
            out.write(f"{ids[k]} {kind} {' '.join(map(number, numbers))}\n")
        out.write("\nVelocities\n\n")
        for k in range(frame.count):
            numbers = [*frame["velo"][k], *frame["angular_velocity"][k]]
            out.write(f"{ids[k]} {' '.join(map(number, numbers))}\n")
        for title, values in (properties or {}).items():
            out.write(f"\n{title}\n\n")
            for k in range(frame.count):
                out.write(f"{ids[k]} {values[k]}\n")
    pairs = frame.pairs
    with open(folder / "state.history", "w") as out:
        out.write("# ids of both spheres, 1 for a neck, springs\n")
        for (i, j), kind, springs in zip(pairs.ids, pairs.kind, pairs.springs):
            if kind == 2 or springs.any():
                out.write(f"{i + 1} {j + 1} {int(kind == 2)} {' '.join(map(number, springs))}\n")


def read_dump(path):
    """The last snapshot of a custom dump, sorted by id: a dictionary of columns."""
    with open(path) as file:
        lines = file.read().splitlines()
    head = max(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
    names = lines[head].split()[2:]
    rows = np.array([line.split() for line in lines[head + 1 :]], dtype=float)
    rows = rows[np.argsort(rows[:, names.index("id")])]
    return {name: rows[:, k] for k, name in enumerate(names)}
