# SPDX-License-Identifier: GPL-2.0-or-later
"""Frames of veridem, and states of LAMMPS made from them."""

import csv
import re
from pathlib import Path

import numpy as np

SPRINGS = "spring_"
LOST_TO_DRAG = "lost to drag [zJ]"


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
        self.stage = re.search(r'stage="?([^" ]+)', head)[1]
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

    def moments(self):
        """Least principal moment of inertia of the body of each sphere, as `d_moment` wants it: 0 for a sphere by itself, 1e300 for a wall."""
        mass, radius, found = self["mass"], self["radius"], np.zeros(self.count)
        for body in set(self["body"]):
            members = np.flatnonzero(self["body"] == body)
            if self["wall"][members].any():
                found[members] = 1e300
            elif len(members) > 1:
                arms = self.together(members)
                arms = arms - mass[members] @ arms / mass[members].sum()
                own = 0.4 * radius[members] ** 2 + (arms**2).sum(axis=1)
                tensor = (mass[members] * own).sum() * np.eye(3) - (mass[members, None] * arms).T @ arms
                found[members] = np.linalg.eigvalsh(tensor)[0]
        return found

    def together(self, members):
        """The centres of spheres that touch each other, not folded into the box."""
        x, front, left = self["pos"][members].copy(), [0], set(range(1, len(members)))
        sides = np.where(self.periodic, self.sides, 1e30)
        while front and left:
            here = front.pop()
            for other in sorted(left):
                way = x[other] - x[here]
                way -= sides * np.round(way / sides)
                if np.linalg.norm(way) < 1.05 * self["radius"][members[[here, other]]].sum():
                    x[other] = x[here] + way
                    left.discard(other)
                    front.append(other)
        return x


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


def write_state(folder, frame, margin=50.0):
    """Writes `state.data` and `state.history`; ids of LAMMPS begin with 1, spheres of walls have the type 2."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    x, ids, wall = frame["pos"].copy(), frame["id"].astype(int) + 1, frame["wall"].astype(int)
    low, high = x.min(axis=0) - margin, x.max(axis=0) + margin
    for a in range(3):
        if frame.periodic[a]:
            low[a], high[a] = 0.0, frame.sides[a]
    image = np.zeros((frame.count, 3), dtype=int)
    for body in set(frame["body"]):
        members = np.flatnonzero(frame["body"] == body)
        if len(members) < 1000 and not wall[members].any():
            for a in range(3):
                if frame.periodic[a]:
                    image[members, a] = np.round((frame.together(members) - x[members])[:, a] / frame.sides[a])
    density = frame["mass"] / (4.0 / 3.0 * np.pi * frame["radius"] ** 3)
    bodies, moments = frame["body"].astype(int), frame.moments()

    def rows(out, title, values):
        out.write(f"\n{title}\n\n")
        out.writelines(f"{ids[k]} {' '.join(map(number, values(k)))}\n" for k in range(frame.count))

    with open(folder / "state.data", "w") as out:
        out.write(f"state at {frame.time} ns\n\n{frame.count} atoms\n2 atom types\n\n")
        out.writelines(f"{number(low[a])} {number(high[a])} {name}lo {name}hi\n" for a, name in enumerate("xyz"))
        rows(out, "Atoms # sphere", lambda k: [2 if wall[k] else 1, 2.0 * frame["radius"][k], density[k], *x[k], *image[k]])
        rows(out, "Velocities", lambda k: [*frame["velo"][k], *frame["angular_velocity"][k]])
        rows(out, "Members", lambda k: [bodies[k], moments[k]])
    with open(folder / "state.history", "w") as out:
        out.write("# ids of both spheres, 1 for a neck, springs\n")
        for (i, j), kind, springs in zip(frame.pairs.ids, frame.pairs.kind, frame.pairs.springs):
            if kind == 2 or springs.any():
                out.write(f"{i + 1} {j + 1} {int(kind == 2)} {' '.join(map(number, springs))}\n")


def number(value):
    """A number with all its digits."""
    return str(value) if isinstance(value, (int, np.integer)) else repr(float(value))


def read_dump(path):
    """The last snapshot of a custom dump, sorted by id: a dictionary of columns."""
    with open(path) as file:
        lines = file.read().splitlines()
    head = max(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
    names = lines[head].split()[2:]
    rows = np.array([line.split() for line in lines[head + 1 :]], dtype=float)
    rows = rows[np.argsort(rows[:, names.index("id")])]
    return {name: rows[:, k] for k, name in enumerate(names)}


def cells(folder, stage, step):
    """The numbers in the row of a stage at a step."""
    with open(Path(folder) / "series.csv") as file:
        rows = list(csv.DictReader(file))
    (row,) = [row for row in rows if row["stage"] == stage and row["step"] == str(step)]
    return {name: float(value) for name, value in row.items() if name != "stage" and value}


def ledger(folder, stage, step):
    """Energies stored and energies lost by pairs and in breaking by cause, from the row of a stage at a step."""
    row = cells(folder, stage, step)
    stored = [row[name] for name in row if name.endswith(" energy [zJ]") and not name.startswith("kinetic")]
    lost = [row[name] for name in row if name.startswith("lost to ") and name != LOST_TO_DRAG]
    return np.array(stored), np.array(lost)
