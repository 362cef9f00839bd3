"""Pham-Ba & Molinari 2022: the impact of two particles, A.35 to A.44, and the restitution of a damping."""

from frame import equation, mp, mpf


def motion(k, m, c, t):
    """Position and velocity at a time after a start with unit velocity: the exponential of the matrix of the motion, the same
    below, at and beyond critical damping, with a complex gap between its eigenvalues. In units of the natural frequency."""
    rate = mp.sqrt(k / m)
    turn, zeta = rate * t, c / m / rate / 2
    gap = mp.sqrt(mp.mpc((zeta - 1) * (zeta + 1)))
    swing = mp.sinh(gap * turn) / gap if gap != 0 else turn
    decay = mp.exp(-zeta * turn)
    return decay * mp.re(swing) / rate, decay * mp.re(mp.cosh(gap * turn) - zeta * swing)


def roots(k, m, c):
    """The real and the imaginary part of the rates of decay, and which of them differ."""
    middle, gap = c / (2 * m), k / m - (c / (2 * m)) ** 2
    return middle, mp.sqrt(abs(gap)), gap > 0


@equation("wear-A35")
def impact_separation(k_n, m_eff, c_n, v_0, t):
    return dict(x=v_0 * motion(k_n, m_eff, c_n, t)[0])


@equation("wear-A36")
def impact_velocity(k_n, m_eff, c_n, v_0, t):
    return dict(v=v_0 * motion(k_n, m_eff, c_n, t)[1])


@equation("wear-A37")
def damped_frequency(k_n, m_eff, c_n):
    return dict(omega=roots(k_n, m_eff, c_n)[1])


@equation("wear-A38")
def natural_frequency(k_n, m_eff):
    return dict(omega_0=roots(k_n, m_eff, mpf(0))[1])


@equation("wear-impact-duration", [dict(omega=5.49e12), dict(omega=2.2e12), dict(omega=0.0113), dict(omega=1.0), dict(omega=7.5e13)])
def impact_duration(omega):
    """Half a period."""
    return dict(t_f=1 / (omega / mp.pi))


def comes_back(k, m, c):
    """The velocity of separation after the impact of a unit velocity, none at and beyond critical damping."""
    _, omega, returns = roots(k, m, c)
    return -motion(k, m, c, mp.pi / omega)[1] if returns else mpf(0)


@equation("wear-A39")
@equation("wear-A40")
def final_velocity(k_n, m_eff, c_n, v_0):
    return dict(v_f=-v_0 * comes_back(k_n, m_eff, c_n))


@equation(
    "wear-A41",
    [
        dict(v_0=14.5, v_f=-13.05),
        dict(v_0=20.0, v_f=-19.0),
        dict(v_0=0.002, v_f=0.0),
        dict(v_0=100.0, v_f=-60.263),
        dict(v_0=1.0, v_f=-1.0),
    ],
)
def velocity_ratio(v_0, v_f):
    """The share of the velocity that comes back."""
    return dict(eta=1 - (v_0 + v_f) / v_0)


@equation("wear-A42")
def pair_restitution(k_n, m_eff, c_n):
    return dict(eta=comes_back(k_n, m_eff, c_n))


@equation("wear-A43")
def weak_restitution(k_n, m_eff, c_n):
    """One less the phase of half a period times the ratio of decay to turning."""
    decay, omega, _ = roots(k_n, m_eff, c_n)
    return dict(eta=1 - mp.pi * decay / omega)


@equation("wear-A44")
def weaker_restitution(k_n, m_eff, c_n):
    decay, omega, _ = roots(k_n, m_eff, mpf(0))
    return dict(eta=1 - mp.pi * (c_n / (2 * m_eff) + decay) / omega)


@equation("wear-damping-ratio")
def damping_ratio_of(c, k, m_eff):
    """The damping over that for which both rates of decay coincide."""
    return dict(zeta=c / mp.sqrt(4 * k * m_eff))


RATIOS = [dict(zeta=zeta) for zeta in (0.0318309886183791, 0.01591549430918954, 0.0, 0.2155, 0.5, 0.984375)]


@equation("wear-restitution", RATIOS)
def restitution(zeta):
    """What comes back of a collision of unit mass and stiffness."""
    return dict(eta=comes_back(mpf(1), mpf(1), 2 * zeta))


def ratio(eta):
    """The decay of the logarithm over half a turn is the tangent of an angle, the ratio its sine. A right angle if nothing comes back."""
    return mp.sin(mp.atan(mp.log(1 / eta) / mp.pi) if eta > 0 else mp.pi / 2)


@equation("wear-damping-ratio-exact")
def damping_ratio(eta):
    return dict(zeta=ratio(eta))


@equation("wear-damping-exact")
def exact_damping(eta, k, m_eff):
    return dict(c=ratio(eta) * mp.sqrt(4 * k * m_eff))


@equation("wear-sliding-damping")
def sliding_damping_ratio(eta):
    """The damping of Eq. 13 for a unit mass and stiffness, over the critical one of the 2/7 that slide."""
    return dict(zeta_t=2 * (1 - eta) / mp.pi / mp.sqrt(4 * mpf(2) / 7))


def phase_without_force(zeta):
    """The phase at which x + 2 zeta v first vanishes: of (1 - 2 zeta^2) sin + 2 zeta sqrt(1 - zeta^2) cos, one sine."""
    return mp.pi - mp.atan2(2 * zeta * mp.sqrt(1 - zeta**2), 1 - 2 * zeta**2)


@equation(
    "wear-zero-force-duration",
    [dict(case, omega=omega) for case, omega in zip(RATIOS, (5.49e12, 2.2e12, 0.0113, 1.0, 7.5e13, 3.25e12))],
)
def zero_force_duration(omega, zeta):
    return dict(t_f=phase_without_force(zeta) / omega)


@equation("wear-zero-force-restitution", RATIOS)
def zero_force_restitution(zeta):
    """The velocity of a unit mass on a unit spring then."""
    return dict(eta=-motion(mpf(1), mpf(1), 2 * zeta, phase_without_force(zeta) / mp.sqrt(1 - zeta**2))[1])
