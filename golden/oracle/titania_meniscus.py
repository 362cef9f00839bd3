"""Laube et al. 2018: the liquid bridge of two particles in the circular approximation, from its geometry."""

from frame import equation, mp, mpf


def _gap(r_eff, r_k, theta, beta):
    """The distance at which 1/r - 1/l = 1/r_K, with the arc r, the neck l = R sin(beta) - r (1 - sin(theta + beta)) > 0 and
    the height 2 r cos(theta + beta)."""
    a, s = r_eff * mp.sin(beta), mp.sin(theta + beta)
    # (1 - s) r^2 - (a + (2 - s) r_K) r + a r_K = 0, the root with the positive neck.
    half = (a + (2 - s) * r_k) / 2
    arc = a * r_k / (half + mp.sqrt(half**2 - (1 - s) * a * r_k))
    return 2 * arc * mp.cos(theta + beta) - 2 * r_eff * (1 - mp.cos(beta))


def _gap_slope(r_eff, r_k, theta, beta):
    return mp.diff(lambda angle: _gap(r_eff, r_k, theta, angle), beta)


def _force(gamma, r_k, r_eff, theta, beta):
    wetted = r_eff * mp.sin(beta)
    return 2 * mp.pi * wetted * gamma * mp.sin(theta + beta) + mp.pi * wetted**2 * gamma / r_k


def _rupture_angle(r_eff, r_k, theta):
    slope = lambda angle: _gap_slope(r_eff, r_k, theta, angle)
    # Between an angle where the gap grows and one where it falls.
    low, high = mpf("1e-6"), mp.pi / 2 - theta
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if slope(middle) > 0 else (low, middle)
    return mp.findroot(slope, (low, high), tol=mpf(10) ** (-1.6 * mp.dps))


@equation(
    "titania-meniscus-gap",
    cases=[
        dict(r_eff=4.153312960445846e-9, r_k=1.1273674384933128e-9, theta=0.0, beta=0.6),
        dict(r_eff=8.25e-9, r_k=0.95e-9, theta=0.2, beta=0.15),
        dict(r_eff=2e-9, r_k=1.5e-9, theta=0.3, beta=1.1),
    ],
)
def meniscus_gap(r_eff, r_k, theta, beta):
    return dict(gap=_gap(r_eff, r_k, theta, beta), slope=_gap_slope(r_eff, r_k, theta, beta))


# The distance is flat in the angle: sixty bisections leave the angle to 18 places, so it is not compared, and the distance where the
# angle is small has fewer digits than are compared.
@equation(
    "titania-rupture",
    defined=lambda r_eff, r_k, theta: r_k > r_eff / 1000,
    cases=[dict(r_eff=4.153312960445846e-9, r_k=1.1273674384933128e-9, theta=0.1), dict(r_eff=1.1e-8, r_k=9.5e-10, theta=0.0)],
)
def rupture(r_eff, r_k, theta):
    return dict(beta_r=None, gap_r=_gap(r_eff, r_k, theta, _rupture_angle(r_eff, r_k, theta)))


@equation("titania-half-filling")
def half_filling_angle(r_eff, r_k, theta, gap):
    beta_r, largest = _rupture_angle(r_eff, r_k, theta), mp.pi / 2 - theta
    if gap >= _gap(r_eff, r_k, theta, beta_r):
        return dict(beta=0)
    if gap <= _gap(r_eff, r_k, theta, largest):
        return dict(beta=largest)
    excess = lambda angle: (_gap(r_eff, r_k, theta, angle) - gap) / r_eff
    return dict(beta=mp.findroot(excess, (beta_r, largest), solver="anderson", tol=mpf(10) ** (-1.9 * mp.dps), maxsteps=200))


@equation("titania-capillary")
def capillary_force(gamma, r_k, r_eff, theta, beta):
    return dict(f_cap=_force(gamma, r_k, r_eff, theta, beta))


# Two equal particles of 4 nm at half humidity, one of 10 nm with a contact angle, and two others.
BRIDGES = [
    dict(gamma=0.108, r_k=1.1273674384933128e-9, r_eff=4.153312960445846e-9, theta=0.0),
    dict(gamma=0.091, r_k=0.95e-9, r_eff=1.015e-8, theta=0.25),
    dict(gamma=0.072, r_k=1.5e-9, r_eff=2e-9, theta=0.3),
    dict(gamma=0.065, r_k=5.3e-10, r_eff=5.9e-9, theta=0.0),
]


@equation("titania-capillary-slope", cases=[BRIDGES[k] | dict(beta=beta) for k, beta in [(0, 0.6), (1, 0.25), (2, 1.1), (3, 0.9)]])
def capillary_slope(gamma, r_k, r_eff, theta, beta):
    slope = mp.diff(lambda angle: _force(gamma, r_k, r_eff, theta, angle), beta)
    return dict(slope=slope / _gap_slope(r_eff, r_k, theta, beta))


def _gauss():
    """The ten points of Gauss's rule: roots of the Legendre polynomial, as the nearest f64."""
    rule = []
    for k in range(5):
        x = mp.findroot(lambda x: mp.legendre(10, x), mp.cos(mp.pi * (k + mpf(3) / 4) / mpf("10.5")))
        slope = 10 * mp.legendre(9, x) / (1 - x**2)
        weight = mpf(float(2 / ((1 - x**2) * slope**2)))
        rule += [(mpf(float(x)), weight), (-mpf(float(x)), weight)]
    return rule


def _by_the_rule_of_gauss(function, begin, end):
    middle, half = (begin + end) / 2, (end - begin) / 2
    return half * sum(weight * function(middle + half * x) for x, weight in _gauss())


@equation(
    "titania-capillary-work",
    cases=[BRIDGES[k] | dict(beta=a, beta_r=b) for k, a, b in [(0, 0.65, 0.2663), (1, 0.4, 0.16), (2, 1.1, 0.35), (3, 0.5, 0.17)]],
    defined=lambda theta, beta, beta_r, **_: theta + max(beta, beta_r) <= mp.pi / 2,
)
def capillary_work(gamma, r_k, r_eff, theta, beta, beta_r):
    power = lambda angle: _force(gamma, r_k, r_eff, theta, angle) * _gap_slope(r_eff, r_k, theta, angle)
    by_rule = _by_the_rule_of_gauss(power, beta, beta_r)
    # The integral itself, as far as the rule goes.
    whole = mp.quad(power, [beta, beta_r])
    assert abs(by_rule - whole) <= mpf("1e-9") * abs(whole), (by_rule, whole)
    return dict(w=by_rule)
