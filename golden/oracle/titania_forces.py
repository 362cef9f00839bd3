"""Laube et al. 2018: the forces and torques of Eqs. 1 to 8 and the attraction."""

from frame import Vector, equation, mp, mpf


@equation("titania-1")
def total_force(f_na, f_nr, f_nd, f_t):
    return dict(force=Vector(*(mp.fsum(parts) for parts in zip(f_na, f_nr, f_nd, f_t))))
