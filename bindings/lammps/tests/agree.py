# SPDX-License-Identifier: GPL-2.0-or-later
"""Compares a frame of the engine with a dump of LAMMPS, sphere by sphere: python agree.py FRAME DUMP WHAT..., of positions, velocities and
forces. Forces in a dump are those of the step that led to it, in a frame those of the step that follows. Fails where they differ by more than
the digits of a frame."""

import sys

import numpy as np

from frames import Frame, read_dump

# Of the largest number of each kind; frames have eight or nine digits unless a case asks for more.
WITHIN = 1e-6


KINDS = {"positions": ("pos", ""), "velocities": ("velo", "v"), "forces": ("force", "f")}


def main(frame, dump, *kinds):
    frame, dump, worst = Frame(frame), read_dump(dump), 0.0
    order = frame.reorder()
    for kind in kinds:
        column, letter = KINDS[kind]
        here = frame[column][order]
        there = np.stack([dump[letter + axis] for axis in "xyz"], axis=1)
        error = abs(there - here).max() / abs(here).max()
        print(f"{kind} of {len(here)} spheres: {error:.1e} of the largest, at most {WITHIN:.0e}")
        worst = max(worst, error)
    return worst <= WITHIN


sys.exit(0 if main(*sys.argv[1:]) else "they differ")
