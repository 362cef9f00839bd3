"""Pham-Ba & Molinari 2022: solids, drags, stresses and samples of Sections 2 and 3."""

from frame import equation, mp, mpf


def gauss(function, end):
    """The integral of a polynomial from zero, without error."""
    return mp.quad(function, [0, end], method="gauss-legendre")


def ball(r):
    """The volume of a ball, of its slices on both sides of the middle."""
    return 2 * gauss(lambda z: mp.pi * (r**2 - z**2), r)


@equation(
    "wear-sphere-mass",
    [dict(rho=2200.0, r=0.75e-9), dict(rho=2200.0, r=3.75e-9), dict(rho=1.0, r=75.0), dict(rho=7850.0, r=1.5e-9)],
)
def sphere_mass(rho, r):
    return dict(m=rho * ball(r))


def inertia(m, r):
    """Of thin shells, two thirds of their mass times the square of their radius."""
    return m * gauss(lambda s: mpf(2) / 3 * s**2 * 3 * s**2, r) / r**3


@equation("wear-inertia", [dict(m=3.89e-24, r=0.75e-9), dict(m=4.86e-22, r=3.75e-9), dict(m=1.77e6, r=75.0), dict(m=1.1e-22, r=1.5e-9)])
def moment_of_inertia(m, r):
    return dict(i=inertia(m, r))


@equation("wear-sliding-mass", [dict(m_eff=1.945e-24), dict(m_eff=2.4e-23), dict(m_eff=3.3e5), dict(m_eff=0.5)])
def sliding_mass(m_eff):
    """Two solid spheres of unit radius, each accelerated and turned by a unit force at its surface."""
    m = 2 * m_eff
    return dict(m_t=1 / (2 / m + 2 / inertia(m, mpf(1))))


@equation(
    "wear-global-damping",
    [
        dict(c=2.13e-12, v=[12.5, -3.25, 4.75]),
        dict(c=4.26e-12, v=[-7.5, 0.0, 1.125]),
        dict(c=0.0, v=[10.0, 20.0, 30.0]),
        dict(c=53.0, v=[0.002, -0.001, 0.0005]),
        dict(c=2.13e-13, v=[0.0, 0.0, -10.0]),
        dict(c=1.0e-11, v=[-1.0e3, 2.0e3, 4.0e2]),
    ],
)
def global_damping(c, v):
    """What slows a unit mass down in a unit of time."""
    return dict(force=[0 - c * part for part in v])


def outer(a, b):
    """By rows."""
    return list(mp.matrix(list(a)) * mp.matrix(list(b)).T)


@equation(
    "wear-virial",
    [
        dict(volume=9.6e-23, r=[-1.1e-9, -0.55e-9, -1.15e-9], f=[-4.0e-9, -2.5e-9, -4.5e-9]),
        dict(volume=9.6e-23, r=[1.1e-9, 0.55e-9, 1.15e-9], f=[-4.0e-9, -2.5e-9, -4.5e-9]),
        dict(volume=1.0e-24, r=[0.0, 0.0, 1.5e-9], f=[0.0, 0.0, 2.0e-9]),
        dict(volume=5.4e8, r=[70.0, -40.0, 80.0], f=[0.125, 3.5, -2.0]),
        dict(volume=2.5e-25, r=[2.0e-9, 0.0, -1.0e-9], f=[0.0, 3.0e-9, 1.5e-9]),
        dict(volume=1.0, r=[1.0, 2.0, 3.0], f=[5.0, 7.0, 11.0]),
    ],
)
def pair_stress(volume, r, f):
    return dict(sigma=outer(r / volume, f))


@equation(
    "wear-virial-kinetic",
    [
        dict(volume=9.6e-23, m=3.89e-24, v=[12.5, -3.25, 4.75]),
        dict(volume=9.6e-23, m=4.86e-22, v=[-7.5, 0.0, 1.125]),
        dict(volume=5.4e8, m=1.77e6, v=[0.002, -0.001, 0.0005]),
        dict(volume=1.0e-24, m=3.89e-24, v=[0.0, 0.0, 10.0]),
        dict(volume=2.5e-25, m=1.1e-22, v=[-1.0e3, 2.0e3, 4.0e2]),
        dict(volume=1.0, m=2.0, v=[3.0, 5.0, 7.0]),
    ],
)
def kinetic_stress(volume, m, v):
    """Momentum leaves with the velocity, and pushes back."""
    return dict(sigma=outer(v * (-m), v / volume))


def spread(d_0, d_s, d_l):
    """The variance of the logarithm: the w = e^(s^2) > 1 for which the standard deviation is the one of the paper,
    w^3 (w - 1) = (0.2 (d_l - d_s) / d_0)^2, a root of a polynomial."""
    wanted = ((d_l - d_s) / 5 / d_0) ** 2
    high = 1 + min(wanted, mp.sqrt(mp.sqrt(wanted)))
    return mp.log(mp.findroot(lambda w: w**3 * (w - 1) - wanted, (mpf(1), high), solver="anderson", tol=mp.eps**2))


@equation("wear-lognormal")
def lognormal(d_0, d_s, d_l):
    variance = spread(d_0, d_s, d_l)
    return dict(mu=mp.log(d_0) + variance, sigma=mp.sqrt(variance))


# The smallest diameter thirteen deviations below the median.
@equation("wear-lognormal-truncated", [dict(d_0=6.0e-9, d_s=0.65e-9, d_l=6.125e-9)])
def truncated_moments(d_0, d_s, d_l):
    """By quadrature of the density over the logarithm of the diameter as a multiple of the mode."""
    variance = spread(d_0, d_s, d_l)
    low, high = mp.log(d_s / d_0), mp.log(d_l / d_0)
    inner = [variance + k * mp.sqrt(variance) for k in range(-12, 13, 3)]
    corners = [low] + [corner for corner in inner if low < corner < high] + [high]

    def mean(weight):
        density = lambda y: weight(mp.exp(y)) * mp.exp(-((y - variance) ** 2) / (2 * variance))
        return mp.quad(density, corners) / mp.sqrt(2 * mp.pi * variance)

    kept = mean(lambda d: 1)
    middle = mean(lambda d: d) / kept
    return dict(
        kept=kept,
        mean=d_0 * middle,
        std=d_0 * mp.sqrt(mean(lambda d: (d - middle) ** 2) / kept),
        m3=d_0**3 * mean(lambda d: d**3) / kept,
    )


@equation(
    "wear-volume-fraction",
    [
        dict(sum_d3=1.37e-22, volume=9.6e-23),
        dict(sum_d3=7.75e8, volume=5.4e8),
        dict(sum_d3=0.0, volume=9.6e-23),
        dict(sum_d3=1.35e-22, volume=9.55e-23),
    ],
)
def volume_fraction(sum_d3, volume):
    """The volume of a ball of unit diameter, as often as its cube is in the sum."""
    return dict(phi=ball(mpf(1) / 2) * sum_d3 / volume)


@equation(
    "wear-mass-factor",
    [
        dict(rho=2200.0, volume=9.6e-23, sum_m=1.58e-19),
        dict(rho=1.0, volume=5.4e8, sum_m=4.0e8),
        dict(rho=2200.0, volume=2.5e-25, sum_m=5.5e-22),
        dict(rho=7850.0, volume=1.0, sum_m=9000.0),
    ],
)
def mass_factor(rho, volume, sum_m):
    """The density that is wanted over the one that is."""
    return dict(alpha=rho / (sum_m / volume))
