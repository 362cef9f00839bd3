"""Demidov, Gor & Khalizov 2024, Eqs. 18 to 23 and Section 3.1: van der Waals attraction, capillary force, facets.

Energies and forces of bodies are integrals of the pair potential -A / (pi^2 s^6) over their volumes, as Hamaker did it: none of the
paper's closed forms is used, and nothing cancels, however far the bodies are apart.
"""

from frame import equation, mp


def panels(lo, hi, near):
    """Breakpoints from the end `hi`, next to which the integrand has a pole at the distance `near`."""
    points, width = [hi], near
    while hi - points[-1] + 2 * width < hi - lo:
        points.append(points[-1] - width)
        width *= 2
    return [lo, *reversed(points)]


def over_sphere(r, potential, near):
    """The integral over a sphere of something that depends on the coordinate along one axis, which has a pole at the distance `near`."""
    return mp.quad(lambda u: mp.pi * (r * r - u * u) * potential(u), panels(-r, r, near))


def sphere_energy(r_1, r_2, delta, a):
    """Energy of two spheres: that of a point outside the second, over shells around its centre through the first."""
    d = r_1 + r_2 + delta
    point = lambda s: 4 * a * r_2**3 / (3 * mp.pi * (s * s - r_2 * r_2) ** 3)
    return -over_sphere(r_1, lambda u: (1 - u / d) * point(d - u), delta)


def sphere_force(r_1, r_2, delta, a):
    """Its slope: under the integral the distance changes both the shells and the potential on them."""
    d = r_1 + r_2 + delta

    def pull(u):
        s = d - u
        below = s * s - r_2 * r_2
        return (6 * s * (s / d) / below - u / (d * d)) * 4 * a * r_2**3 / (3 * mp.pi * below**3)

    return over_sphere(r_1, pull, delta)


def plane_energy(r, delta, a):
    """Energy of a sphere in front of a half-space."""
    return -over_sphere(r, lambda u: a / (6 * mp.pi * (r + delta - u) ** 3), delta)


def plane_force(r, delta, a):
    return over_sphere(r, lambda u: a / (2 * mp.pi * (r + delta - u) ** 4), delta)


def saturated(energy, force, delta, delta_0):
    """Force and energy, whose slope is kept below the saturation distance."""
    at = max(delta, delta_0)
    pull = force(at)
    return dict(f=pull, u=energy(at) - pull * (at - delta))


@equation("soot-18", cases=[])
def hamaker_energy(r_1, r_2, delta, a):
    return dict(u=sphere_energy(r_1, r_2, delta, a))


@equation("soot-hamaker-force", cases=[])
def hamaker_force(r_1, r_2, delta, a):
    return dict(f=sphere_force(r_1, r_2, delta, a))


@equation("soot-19", cases=[])
def equal_energy(r, delta, a):
    return dict(u=sphere_energy(r, r, delta, a))


@equation("soot-20", cases=[])
def equal_force(r, delta, a):
    return dict(f=sphere_force(r, r, delta, a))


@equation("soot-20-sat", cases=[])
def saturated_spheres(r_1, r_2, delta, a, delta_0):
    return saturated(lambda s: sphere_energy(r_1, r_2, s, a), lambda s: sphere_force(r_1, r_2, s, a), delta, delta_0)


@equation("soot-21", cases=[])
def energy_of_plane(r, delta, a):
    return dict(u=plane_energy(r, delta, a))


@equation("soot-22", cases=[])
def force_of_plane(r, delta, a):
    return dict(f=plane_force(r, delta, a))


@equation("soot-22-sat", cases=[
    dict(r=1.4e-8, delta=2e-9, a=1e-18, delta_0=4e-10),
    dict(r=1.4e-8, delta=1e-10, a=1e-18, delta_0=4e-10),
    dict(r=1.4e-8, delta=-3e-10, a=1e-18, delta_0=1e-9),
    dict(r=1.4e-8, delta=1e-9, a=1e-18, delta_0=1e-9),
    dict(r=2.5, delta=40.0, a=3.0, delta_0=0.5),
])
def saturated_plane(r, delta, a, delta_0):
    return saturated(lambda s: plane_energy(r, s, a), lambda s: plane_force(r, s, a), delta, delta_0)


def sigmoid(psi, kappa, d, d_cutoff):
    """Eq. 23 as printed, with the digits that the difference takes at large distances."""
    x = kappa * (d - d_cutoff)
    with mp.workdps(mp.dps + int(max(0, 2 * x / mp.log(10))) + 5):
        return psi / 2 * (1 - mp.tanh(x))


def capillary_work(psi, kappa, d, d_cutoff):
    """The work of taking two spheres apart."""
    x = kappa * (d - d_cutoff)
    # up to where the force has fallen by one part in 10^(dps + 5)
    end = max(x, mp.mpf(0)) + (mp.dps + 5) * mp.log(10) / 2
    edges = mp.linspace(x, end, int(mp.ceil((end - x) / 2)) + 1)
    return -psi / kappa * mp.quad(lambda s: 1 / (mp.exp(2 * s) + 1), edges)


@equation("soot-23", cases=[])
def capillary_force(psi, kappa, d, d_cutoff):
    return dict(f=sigmoid(psi, kappa, d, d_cutoff))


@equation("soot-23-energy", cases=[])
def capillary_energy(psi, kappa, d, d_cutoff):
    return dict(u=capillary_work(psi, kappa, d, d_cutoff))


COATED = dict(r_i=1.4e-8, r_j=1.4e-8, a=1e-19, delta_0=1e-9, psi=1e-9, kappa=1.8e8, d_cutoff=5.6e-8, cutoff=7e-8)


@equation("soot-attraction", cases=[
    dict(COATED, d=3.1e-8),
    dict(COATED, d=2.79e-8),
    dict(COATED, d=6.3e-8, r_j=9e-9),
    dict(COATED, d=7.1e-8),
    dict(COATED, d=4.2e-8, cutoff=4.2e-8),
    dict(COATED, d=2.85e-8, cutoff=2.88e-8),
    dict(COATED, d=6.99e-8),
    dict(COATED, d=2.81e-8, cutoff=2.885e-8),
    dict(COATED, d=2.88e-8, cutoff=2.885e-8),
    dict(d=3.5, r_i=1.0, r_j=2.0, a=0.7, delta_0=0.3, psi=0.2, kappa=1.5, d_cutoff=4.0, cutoff=6.0),
])
def attraction(d, r_i, r_j, a, delta_0, psi, kappa, d_cutoff, cutoff):
    if d > cutoff:
        return dict(f=0, u_vdw=0, u_cap=0)
    at = lambda s: saturated(lambda g: sphere_energy(r_i, r_j, g, a), lambda g: sphere_force(r_i, r_j, g, a), s - r_i - r_j, delta_0)
    near, far = at(d), at(cutoff)
    work = lambda s: capillary_work(psi, kappa, s, d_cutoff)
    return dict(f=near["f"] + sigmoid(psi, kappa, d, d_cutoff), u_vdw=near["u"] - far["u"], u_cap=work(d) - work(cutoff))


GROOVES = [
    dict(d=[3e-9, 4e-9, 1e-9], d_0=[2e-9, 1e-9, -2e-9]),
    dict(d=[-3e-9, 4e-9, 1e-9], d_0=[2e-9, 1e-9, -2e-9]),
    dict(d=[1e-8, 2e-9, 0.0], d_0=[1e-9, 2e-9, 3e-10]),
    dict(d=[0.7, 0.2, -0.1], d_0=[0.3, 0.6, 0.2]),
    dict(d=[0.0, 2.0, 0.0], d_0=[1.0, 0.0, 0.0]),
]


@equation("soot-facet-share", cases=GROOVES, defined=lambda d_0, **_: d_0.norm() > 0)
def facet_share(d, d_0):
    return dict(s=1 - min(mp.mpf(1), max(mp.mpf(0), d.dot(d_0) / d_0.dot(d_0))))


@equation("soot-facet-share-slope", cases=[
    dict(GROOVES[0], q_d_0=[5e-10, 2e-9, -3e-10], q_0_d=[1e-9, 0.0, 4e-9]),
    dict(GROOVES[1], q_d_0=[5e-10, 2e-9, -3e-10], q_0_d=[1e-9, 0.0, 4e-9]),
    dict(GROOVES[2], q_d_0=[5e-10, 2e-9, -3e-10], q_0_d=[1e-9, 0.0, 4e-9]),
    dict(GROOVES[3], q_d_0=[0.25, 0.5, 0.1], q_0_d=[0.2, -0.3, 0.6]),
])
def facet_share_slope(d, d_0, q_d_0, q_0_d):
    # the quotient rule; `d_0` is the gradient of half its square
    product, square = d.dot(d_0), d_0.dot(d_0)
    if not 0 < product < square:
        return dict(slope=d * 0)
    return dict(slope=-((q_d_0 + q_0_d) * square - d_0 * (2 * product)) / square**2)
