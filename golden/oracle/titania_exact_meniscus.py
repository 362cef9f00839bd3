"""Laube et al. 2018: the liquid bridge of two particles with the profile of constant curvature, by elliptic integrals."""

from frame import equation, mp, mpf
from titania_meniscus import BRIDGES, _by_the_rule_of_gauss, _force


def _gap(r_eff, r_k, theta, beta):
    """Twice the height of the profile from the neck to the sphere, less the two caps. Along it y / sqrt(1 + y'^2) + y^2 / (2 r_K) is constant, so
    dz/dy = (n m - y^2) / sqrt((y^2 - n^2) (m^2 - y^2)) with the radius n of the neck and m = n + 2 r_K; y = m sqrt(1 - k^2 sin^2(phi)) makes it
    elliptic integrals in the form of Legendre."""
    # The heights of narrow bridges are small differences.
    with mp.extradps(mp.dps):
        return _twice_the_height(r_eff, r_k, theta, beta) - 2 * r_eff * (1 - mp.cos(beta))


def _twice_the_height(r_eff, r_k, theta, beta):
    wetted, lean = r_eff * mp.sin(beta), mp.sin(theta + beta)
    constant = wetted * lean + wetted**2 / (2 * r_k)
    neck = 2 * r_k * constant / (r_k + mp.sqrt(r_k**2 + 2 * r_k * constant))
    m = neck + 2 * r_k
    k2 = 1 - (neck / m) ** 2
    # The angle against the neck, where phi is pi / 2: of the wetted circle, and without a loss of digits near it.
    cos_phi = mp.sqrt(max((wetted**2 - neck**2) / (m**2 - neck**2), 0))
    phi = mp.pi / 2 - mp.sign(mp.cos(theta + beta)) * mp.asin(cos_phi)
    first, second = mp.ellipk(k2) - mp.ellipf(phi, k2), mp.ellipe(k2) - mp.ellipe(phi, k2)
    return 2 * (neck * first - m * second)


def _gap_slope(r_eff, r_k, theta, beta):
    return mp.diff(lambda angle: _gap(r_eff, r_k, theta, angle), beta, h=beta * mpf(10) ** (-mp.dps // 3))


def _has_meniscus(theta, beta, **_):
    return theta + beta <= mp.pi / 2


def _secants(function, low, high):
    values = [function(low), function(high)]
    for _ in range(5):
        if values[1] == values[0]:
            break
        low, high = high, high - values[1] * (high - low) / (values[1] - values[0])
        values = [values[1], function(high)]
    return high


def _rupture_angle(r_eff, r_k, theta):
    slope = lambda angle: _gap_slope(r_eff, r_k, theta, angle)
    low, high = mpf("1e-4"), mp.pi / 2 - theta - mpf("1e-4")
    with mp.workdps(20):
        for _ in range(24):
            middle = (low + high) / 2
            low, high = (middle, high) if slope(middle) > 0 else (low, middle)
    # The gap is flat there: half the digits of the angle are all of the gap.
    return _secants(slope, low, high)


@equation(
    "titania-exact-gap",
    cases=[
        dict(r_eff=4.153312960445846e-9, r_k=1.1273674384933128e-9, theta=0.0, beta=0.6),
        dict(r_eff=8.25e-9, r_k=0.95e-9, theta=0.2, beta=0.15),
        dict(r_eff=2e-9, r_k=1.5e-9, theta=0.3, beta=1.1),
        dict(r_eff=1e-9, r_k=8e-9, theta=0.0, beta=1.5),
    ],
    defined=_has_meniscus,
)
def exact_gap(r_eff, r_k, theta, beta):
    return dict(gap=_gap(r_eff, r_k, theta, beta), slope=_gap_slope(r_eff, r_k, theta, beta))


# The angle itself is flat in the distance: sixty bisections leave it to 18 digits, so it is not compared.
@equation(
    "titania-exact-rupture",
    cases=[
        dict(r_eff=4.153312960445846e-9, r_k=1.1273674384933128e-9, theta=0.0),
        dict(r_eff=4.153312960445846e-9, r_k=1.1273674384933128e-9, theta=0.1),
        dict(r_eff=1.1e-8, r_k=9.5e-10, theta=0.0),
        dict(r_eff=2e-9, r_k=1.5e-9, theta=0.3),
    ],
)
def exact_rupture(r_eff, r_k, theta):
    return dict(beta_r=None, gap_r=_gap(r_eff, r_k, theta, _rupture_angle(r_eff, r_k, theta)))


@equation(
    "titania-exact-half-filling",
    cases=[
        dict(r_eff=4.153312960445846e-9, r_k=1.1273674384933128e-9, theta=0.0, gap=gap)
        for gap in (-5.0662592089169e-10, -3.066e-10, 3.934e-10, 7e-10)
    ],
)
def exact_half_filling_angle(r_eff, r_k, theta, gap):
    beta_r, largest = _rupture_angle(r_eff, r_k, theta), mp.pi / 2 - theta
    if gap >= _gap(r_eff, r_k, theta, beta_r):
        return dict(beta=0)
    if gap <= _gap(r_eff, r_k, theta, largest):
        return dict(beta=largest)
    excess = lambda angle: (_gap(r_eff, r_k, theta, angle) - gap) / r_eff
    with mp.workdps(20):
        low = high = mp.findroot(excess, (beta_r, largest), solver="anderson", tol=mpf("1e-16"), verify=False)
        low -= mpf("1e-9") * (low - beta_r)
    return dict(beta=_secants(excess, low, high))


@equation(
    "titania-exact-slope",
    cases=[BRIDGES[k] | dict(beta=beta) for k, beta in [(0, 0.6), (1, 0.25), (2, 1.1), (3, 0.9)]],
    defined=_has_meniscus,
)
def exact_slope(gamma, r_k, r_eff, theta, beta):
    slope = mp.diff(lambda angle: _force(gamma, r_k, r_eff, theta, angle), beta)
    return dict(slope=slope / _gap_slope(r_eff, r_k, theta, beta))


@equation(
    "titania-exact-work",
    cases=[BRIDGES[k] | dict(beta=a, beta_r=b) for k, a, b in [(0, 0.65, 0.2789), (1, 0.4, 0.17), (2, 1.1, 0.35), (3, 0.5, 0.17)]],
    defined=lambda theta, beta, beta_r, **_: theta + max(beta, beta_r) <= mp.pi / 2,
)
def exact_work(gamma, r_k, r_eff, theta, beta, beta_r):
    power = lambda angle: _force(gamma, r_k, r_eff, theta, angle) * _gap_slope(r_eff, r_k, theta, angle)
    by_rule = _by_the_rule_of_gauss(power, beta, beta_r)
    # The integral itself, as far as the rule goes.
    with mp.workdps(15):
        whole = mp.quad(power, [beta, beta_r])
    assert abs(by_rule - whole) <= mpf("1e-6") * abs(whole), (by_rule, whole)
    return dict(w=by_rule)
