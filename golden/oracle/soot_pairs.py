"""Demidov, Gor & Khalizov 2024, Eqs. 1 to 11: motion of a particle, geometry and kinematics of a pair.

Velocities of the contact point are those of material points of two rigid bodies, rotations are matrices, and projections
are double vector products or quotients without a root, where the specification has unit normals and sums.
"""

from frame import Vector, equation, mp


def shells(m, r, weight):
    """The integral of `weight * s^2` over the mass of a solid sphere, as a pile of thin shells of radius `s`."""
    return mp.quad(lambda s: weight * s * s * (3 * m / r) * (s / r) ** 2, [0, r])


@equation("soot-solid-inertia", cases=[])
def solid_inertia(m, r):
    return dict(i=shells(m, r, mp.mpf(2) / 3))


@equation("soot-hollow-inertia", cases=[
    dict(m=1.954e-20, r=1.4e-8),
    dict(m=7.3e-19, r=5e-8),
    dict(m=0.3, r=2.5),
    dict(m=8.1e-21, r=4.9e-9),
])
def hollow_inertia(m, r):
    # the squared distance from the axis, averaged over the zones of a thin wall: all zones of one height have the same area
    return dict(i=m * mp.quad(lambda z: r * r - z * z, [-r, r]) / (2 * r))


@equation("soot-1", cases=[])
def acceleration(force, m):
    return dict(a=force / m)


@equation("soot-2", cases=[
    dict(torque=[1e-17, 2e-17, 3e-17], i=1.532e-36),
    dict(torque=[-4.7e-18, 0.0, 9.1e-21], i=1.532e-36),
    dict(torque=[6.5, -0.25, 1e-7], i=0.4),
    dict(torque=[3.3e-25, 1.7e-25, -8.8e-25], i=2.553e-36),
])
def angular_acceleration(torque, i):
    return dict(alpha=torque / i)


STATE = dict(x=[1.4e-8, -2.8e-8, 3.3e-9], v=[-1.0, 0.37, 0.011], omega=[2.5e7, -1e8, 4.4e6])
LOAD = dict(force=[1.01e-10, -3.7e-11, 2e-12], torque=[-1e-18, 2.2e-19, 7e-20], m=1.954e-20, i=1.532e-36)
MOVED = [
    dict(STATE, **LOAD, dt=5e-15),
    dict(STATE, **dict(LOAD, force=[0.0, 1e-9, 0.0]), dt=5e-14),
    dict(STATE, **dict(LOAD, i=2.553e-36, torque=[3e-17, 0.0, -1e-17]), dt=1e-12),
    dict(x=[2.0, 0.0, -7.0], v=[0.1, 0.02, 0.3], omega=[0.01, -0.02, 0.03], force=[0.5, -0.7, 0.11], torque=[0.3, 0.2, 0.1],
         m=1.5, i=0.6, dt=0.01),
]


def cases_of(names):
    return [{name: case[name] for name in names.split()} for case in MOVED]


def kicked(velocity, load, inertia, time):
    """The velocity after a load that is constant for a time: an impulse over the inertia."""
    return (velocity * inertia + load * time) / inertia


@equation("soot-half-step", cases=MOVED)
def half_step(x, v, omega, force, torque, m, i, dt):
    after = kicked(v, force, m, dt)
    return dict(v_next=after, x_next=x + after * dt, omega_next=kicked(omega, torque, i, dt))


@equation("soot-half-step-start", cases=cases_of("v omega force torque m i dt"))
def half_step_start(v, omega, force, torque, m, i, dt):
    return dict(v_before=kicked(v, force, m, -dt / 2), omega_before=kicked(omega, torque, i, -dt / 2))


@equation("soot-verlet-begin", cases=MOVED)
def verlet_begin(x, v, omega, force, torque, m, i, dt):
    # the position in its closed form x + v dt + f dt^2 / 2m
    return dict(v_half=kicked(v, force, m, dt / 2), x_next=x + v * dt + force * (dt * dt / (2 * m)),
                omega_half=kicked(omega, torque, i, dt / 2))


@equation("soot-verlet-end", cases=[
    dict(v_half=case["v"], omega_half=case["omega"], **{k: case[k] for k in "force torque m i dt".split()}) for case in MOVED
])
def verlet_end(v_half, omega_half, force, torque, m, i, dt):
    return dict(v=kicked(v_half, force, m, dt / 2), omega=kicked(omega_half, torque, i, dt / 2))


def across(vector, axis):
    """The part of a vector perpendicular to an axis of any length, as a double vector product."""
    return axis.cross(vector.cross(axis)) / axis.dot(axis)


def along(vector, axis):
    """The part of a vector along an axis of any length."""
    return axis * (vector.dot(axis) / axis.dot(axis))


@equation("soot-3", cases=[])
def normal(x_i, x_j):
    return dict(n=(x_j - x_i) / (x_j - x_i).norm())


def separation(x_i, x_j, r_i, r_j):
    return (x_j - x_i).norm() - r_i - r_j


@equation("soot-5", cases=[
    dict(r=1.4e-8, delta=-1e-10),
    dict(r=1.4e-8, delta=2.8e-10),
    dict(r=5e-9, delta=-3.7e-11),
    dict(r=2.5, delta=0.0),
])
def arm(r, delta):
    # halfway between the centre of an equal sphere and this one
    return dict(a=((r + delta) + r) / 2)


@equation("soot-6", cases=[])
def gap(x_i, x_j, r_i, r_j):
    return dict(delta=separation(x_i, x_j, r_i, r_j))


@equation("soot-mean-arm", cases=[
    dict(a_i=1.4e-8, a_j=1.4e-8),
    dict(a_i=1.395e-8, a_j=4.9e-9),
    dict(a_i=5e-9, a_j=2.3e-8),
    dict(a_i=1.0, a_j=1e6),
])
def mean_arm(a_i, a_j):
    return dict(a_mean=harmonic(a_i, a_j))


def harmonic(a, b):
    return 2 / (1 / a + 1 / b)


def turning(omega):
    """The matrix that takes a place in a body to its velocity."""
    x, y, z = omega
    return mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def carried(x, v, omega, place):
    """Velocity of the material point of a rigid body that is at a place."""
    return v + Vector(*(turning(omega) * mp.matrix(list(place - x))))


def contact_point(x_i, x_j, r_i, r_j):
    """Halfway between the surfaces, on the line of centres."""
    delta = separation(x_i, x_j, r_i, r_j)
    return x_i + (x_j - x_i) * ((r_i + delta / 2) / (x_j - x_i).norm())


def sliding(x_i, x_j, v_i, v_j, omega_i, omega_j, r_i, r_j):
    """Eq. 4 as it is meant: what the material points of j and of i at the contact point do to each other."""
    place = contact_point(x_i, x_j, r_i, r_j)
    return carried(x_j, v_j, omega_j, place) - carried(x_i, v_i, omega_i, place)


@equation("soot-4", cases=[])
def relative_velocity(**pair):
    return dict(v_ij=sliding(**pair))


@equation("soot-7", cases=[])
def normal_velocity(x_i, x_j, v_i, v_j, **_):
    # the change of the distance: spins have no part in it
    return dict(v_n=along(v_j - v_i, x_j - x_i))


@equation("soot-8", cases=[])
def tangential_velocity(x_i, x_j, **rest):
    return dict(v_t=across(sliding(x_i=x_i, x_j=x_j, **rest), x_j - x_i))


@equation("soot-9", cases=[])
def relative_spin(omega_i, omega_j):
    return dict(omega_ij=omega_j - omega_i)


@equation("soot-10", cases=[])
def torsional_spin(x_i, x_j, omega_i, omega_j):
    return dict(omega_n=along(omega_j - omega_i, x_j - x_i))


@equation("soot-11", cases=[])
def rolling_spin(x_i, x_j, omega_i, omega_j):
    return dict(omega_r=across(omega_j - omega_i, x_j - x_i))


def arms(x_i, x_j, r_i, r_j):
    """The arms of i and j, and the lengths that represent both in rolling and in torsion."""
    half = separation(x_i, x_j, r_i, r_j) / 2
    return r_i + half, r_j + half, harmonic(r_i + half, r_j + half), harmonic(r_i, r_j)


@equation("soot-rates", cases=[])
def turning_rates(x_i, x_j, omega_i, omega_j, r_i, r_j):
    apart, spin = x_j - x_i, omega_j - omega_i
    _, _, a, r = arms(x_i, x_j, r_i, r_j)
    return dict(rate_rolling=spin.cross(apart) * (a / apart.norm()), rate_torsion=along(spin, apart) * r)
