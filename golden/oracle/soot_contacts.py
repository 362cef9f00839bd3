"""Demidov, Gor & Khalizov 2024, Sections 2.1.1 to 2.1.3 and 3.1: a neck, a frictional contact, a sphere at a wall.

A step of the four springs from the kinematics of two rigid bodies. Torques follow from the forces as moments about the
centres; those of rolling and torsion from their power, which is that of the springs.
"""

from frame import equation, mp
from soot_pairs import across, arms, separation, sliding
from soot_springs import in_plane

KINDS = "tro"


def rubbed(k, eta, spring, rate, static, dynamic):
    """Eqs. 12 to 17: the force of a spring with friction, and the spring that causes it; whether it slips. Numbers or vectors."""
    size = lambda s: s.norm() if hasattr(s, "norm") else abs(s)
    test = spring * k + rate * eta
    if static is None or size(test) <= static:
        return test, spring, False
    force = test * (dynamic / size(test))
    return force, (force - rate * eta) / k if k > 0 else spring * 0, True


def step(given, n, delta, rates, before, late=False):
    """Normal attraction, and the force and the next length of the other springs, by kind. `late`: they act before they are stretched."""
    bonded, dt = "mu_t" not in given, given["dt"]
    approach, stretching = rates["n"], {kind: rates[kind] for kind in KINDS}
    if not bonded and delta >= 0:
        return mp.mpf(0), {kind: (spring * 0, spring * 0) for kind, spring in before.items()}
    attraction = given["k_n"] * delta + given["eta_n"] * approach
    if not bonded:
        attraction = min(attraction, mp.mpf(0))
    out = {}
    for kind in KINDS:
        limits = (None, None) if bonded else [mu * -attraction for mu in (given["mu_" + kind], given["phi"] * given["mu_" + kind])]
        later = before[kind] + stretching[kind] * dt
        force, spring, slips = rubbed(given["k_" + kind], given["eta_" + kind], before[kind] if late else later, stretching[kind], *limits)
        out[kind] = force, (later if late and not slips else spring)
    return attraction, out


def of_spheres(given, late=False):
    x_i, x_j, r_i, r_j = (given[name] for name in ("x_i", "x_j", "r_i", "r_j"))
    apart = x_j - x_i
    n = apart / apart.norm()
    spin = given["omega_j"] - given["omega_i"]
    a_i, a_j, a, r = arms(x_i, x_j, r_i, r_j)
    slide = sliding(**{name: given[name] for name in "x_i x_j v_i v_j omega_i omega_j r_i r_j".split()})
    rates = dict(n=(given["v_j"] - given["v_i"]).dot(n), t=across(slide, apart), r=spin.cross(n) * a, o=spin.dot(n) * r)
    torsion = in_plane(given["xi_o"], n) if late else given["xi_o"]
    if late:
        rates["o"] = n * rates["o"]
    before = dict(t=in_plane(given["xi_t"], n), r=in_plane(given["xi_r"], n), o=torsion)
    attraction, springs = step(given, n, separation(x_i, x_j, r_i, r_j), rates, before, late)
    (f_t, xi_t), (f_r, xi_r), (f_o, xi_o) = (springs[kind] for kind in KINDS)
    turning = n.cross(f_r) * a + (f_o * r if late else n * (f_o * r))
    return dict(force=n * attraction + f_t, torque_i=(n * a_i).cross(f_t) + turning, torque_j=(n * a_j).cross(f_t) - turning,
                xi_t_next=xi_t, xi_r_next=xi_r, xi_o_next=xi_o)


# Two spherules of the paper that meet obliquely; stiffnesses of the order of its Fig. 3.
PAIR = dict(x_i=[1e-9, -2e-9, 3e-9], v_i=[0.5, -1.0, 0.25], v_j=[-0.7, 1.1, 0.6], omega_i=[3e7, -1e8, 2e7], omega_j=[-4e7, 5e7, 9e7], r_i=1.4e-8,
            r_j=1.4e-8)
NEAR, APART, UNEQUAL = dict(x_j=[1.72e-8, 1.75e-8, 1.41e-8]), dict(x_j=[1.8e-8, 1.85e-8, 1.5e-8]), dict(x_j=[1.1e-8, 1.2e-8, 9.5e-9], r_j=6e-9)
SPRINGS = dict(k_n=1000.0, k_t=600.0, k_r=300.0, k_o=200.0, eta_n=1.5e-10, eta_t=1e-10, eta_r=5e-11, eta_o=4e-11, xi_t=[2e-13, -1e-13, 3e-13],
               xi_r=[-1e-13, 4e-13, 2e-13], xi_o=3e-13, dt=5e-14)
RUBBING = dict(mu_t=0.5, mu_r=0.1, mu_o=0.05, phi=0.8)
STICKING = dict(mu_t=50.0, mu_r=50.0, mu_o=50.0, phi=1.0)
BARE = dict(k_n=10.0, k_t=0.0, k_r=0.0, k_o=0.0)
# Parting so fast that the dashpot outweighs the overlap.
PARTING = dict(v_i=[-40.0, -45.0, -30.0], v_j=[60.0, 50.0, 30.0], eta_n=1.5e-9)

NECKS = [
    dict(PAIR, **NEAR, **SPRINGS),
    dict(PAIR, **APART, **SPRINGS),
    dict(PAIR, **UNEQUAL, **SPRINGS),
    dict(PAIR, **NEAR, **dict(SPRINGS, eta_n=0.0, eta_t=0.0, eta_r=0.0, eta_o=0.0, dt=1e-12)),
    dict(PAIR, **APART, **dict(SPRINGS, xi_t=[0.0, 0.0, 0.0], xi_r=[0.0, 0.0, 0.0], xi_o=0.0)),
]
CONTACTS = [
    dict(PAIR, **NEAR, **SPRINGS, **RUBBING),
    dict(PAIR, **NEAR, **SPRINGS, **STICKING),
    dict(PAIR, **APART, **SPRINGS, **RUBBING),
    dict(PAIR, **UNEQUAL, **SPRINGS, **RUBBING),
    dict(PAIR, **UNEQUAL, **SPRINGS, **STICKING),
    dict(PAIR, **NEAR, **dict(SPRINGS, **BARE), **RUBBING),
    dict(dict(PAIR, **NEAR, **SPRINGS, **RUBBING), **PARTING),
    dict(PAIR, **NEAR, **SPRINGS, **dict(RUBBING, mu_t=50.0, mu_o=50.0)),
]


@equation("soot-neck", cases=NECKS)
def neck(**given):
    return of_spheres(given)


@equation("soot-contact", cases=CONTACTS)
def frictional_contact(**given):
    return of_spheres(given)


@equation("soot-published-contact", cases=[dict(case, xi_o=[3e-13, 1e-13, -2e-13]) for case in CONTACTS])
def published_contact(**given):
    return of_spheres(given, late=True)


WALL = dict(n=[0.0, 0.0, 1.0], v=[0.5, -0.3, -1.0], omega=[3e7, -1e8, 2e7], r=1.4e-8, **SPRINGS)


@equation("soot-wall", cases=[
    dict(WALL, **RUBBING, delta=-1e-10),
    dict(WALL, **STICKING, delta=-1e-10),
    dict(WALL, **RUBBING, delta=1e-10),
    dict(WALL, **RUBBING, delta=0.0),
    dict(dict(WALL, n=[0.48, -0.64, 0.6], v=[-0.5, 0.9, -0.3]), **RUBBING, delta=-2e-11),
    dict(dict(WALL, v=[0.5, -0.3, 40.0], eta_n=1.5e-8), **RUBBING, delta=-1e-10),
    dict(dict(WALL, **BARE), **RUBBING, delta=-1e-10),
])
def wall_contact(n, delta, v, omega, r, **given):
    # in the convention of the paper: from the sphere to the wall, which stands still and does not turn
    n, arm = -n, r + delta
    flat = lambda vector: vector - n * vector.dot(n)
    rates = dict(n=-v.dot(n), t=flat(-(v + omega.cross(n * arm))), r=(-omega).cross(n) * arm, o=-omega.dot(n) * r)
    before = dict(t=in_plane(given["xi_t"], n), r=in_plane(given["xi_r"], n), o=given["xi_o"])
    attraction, springs = step(given, n, delta, rates, before)
    (f_t, xi_t), (f_r, xi_r), (f_o, xi_o) = (springs[kind] for kind in KINDS)
    torque = n.cross(f_t) * arm + n.cross(f_r) * arm + n * (f_o * r)
    return dict(force=n * attraction + f_t, torque=torque, xi_t_next=xi_t, xi_r_next=xi_r, xi_o_next=xi_o)
