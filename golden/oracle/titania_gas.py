"""Laube et al. 2018, Eq. 14 and Section 5.3: aggregates in a gas, their sizes, and the walks that measure and deposit them."""

from frame import equation, mp, mpf, printed


@equation("titania-14")
def friction_factor(mu, lam, r_h, pa):
    kn = lam * mp.pi * r_h / pa
    # Davies
    slip = 1 + kn * (printed(1.257) + printed(0.4) * mp.exp(-printed(1.1) / kn))
    return dict(kn=kn, cc=slip, f=6 * mp.pi * mu * r_h / slip)


@equation("titania-diffusion", cases=[dict(kt=4.141947e-21, f=f) for f in (1.1e-12, 3.7e-11, 9e-13)] + [dict(kt=5.5e-21, f=2e-12)])
def diffusion(kt, f):
    return dict(d=kt / f)


@equation(
    "titania-exit",
    cases=[
        dict(u=u, v=v, ell=ell, d=1e-9)
        for u, v, ell in [(0.3, 0.5, 2e-9), (0.97, 0.5, 4e-8), (1.0, 0.01, 1e-9), (0.02, 2.0, 1e-9), (0.5, 1e-4, 1e-8), (1e-9, 0.5, 2e-7)]
    ],
)
def exit_cosine(u, v, ell, d):
    kappa = v * ell / (2 * d)
    # The density exp(kappa c), integrated from -1, is u of the whole.
    below = lambda c: mp.expm1(kappa * (c + 1)) / mp.expm1(2 * kappa)
    if u == 1:
        return dict(cosine=1)
    return dict(cosine=_inverse(below, u))


def _inverse(below, u):
    """The place in [-1, 1] at which an increasing function is u, by bisection to the last digit: Newton's method leaves the interval
    where the function is steep."""
    low, high = mpf(-1), mpf(1)
    for _ in range(mp.prec):
        middle = (low + high) / 2
        low, high = (middle, high) if below(middle) < u else (low, middle)
    return (low + high) / 2


@equation("titania-capacity", cases=[dict(p=p, radius=r) for p, r in [(0.731, 1.4e-7), (0.25, 3e-8), (1.0, 5e-9), (0.0, 1e-8)]])
def capacity(p, radius):
    return dict(c=p * radius)


@equation("titania-return", cases=[dict(radius=1.4e-7, rho=rho) for rho in (1.4e-7, 1.5e-7, 9e-7)] + [dict(radius=3e-8, rho=4.1e-8)])
def return_probability(radius, rho):
    return dict(q=1 / (rho / radius))


@equation("titania-return-cosine", cases=[dict(u=u, q=q) for u, q in [(0.3, 0.5), (0.97, 0.99), (0.02, 0.9), (0.5, 0.001), (0.75, 0.25)]])
def return_cosine(u, q):
    # The integral of the density (1 - q^2) / 2 / (1 + q^2 - 2 q c)^(3/2) from -1.
    below = lambda c: (1 - q * q) / (2 * q) * (1 / mp.sqrt(1 + q * q - 2 * q * c) - 1 / (1 + q))
    return dict(cosine=_inverse(below, u))


@equation("titania-kf")
def fractal_number(k_f, d_g, d_s, d_f):
    return dict(n_p=k_f * mp.exp(d_f * (mp.log(d_g) - mp.log(d_s))))


@equation("titania-kf-inv")
def fractal_diameter(k_f, n_p, d_s, d_f):
    return dict(d_g=d_s * mp.exp((mp.log(n_p) - mp.log(k_f)) / d_f))


@equation("titania-km")
def mobility_number(k_m, d_m, d_s, d_fm):
    return dict(n_p=k_m * mp.power(d_m / d_s, d_fm))


@equation(
    "titania-sauter", cases=[dict(v_tot=v, a_tot=a) for v, a in [(2.7e-25, 2e-16), (9.5e-22, 4.7e-13), (1.4e-26, 2.8e-17), (5e-24, 3e-15)]]
)
def sauter_diameter(v_tot, a_tot):
    return dict(d_s=v_tot * 6 / a_tot)


def _classes(median, s_g, lo, hi):
    """Every class with its weight: the normal density of the logarithm, over the diameter."""
    weight = lambda d: mp.npdf(mp.log(d), mp.log(median), mp.log(s_g)) / d
    return {d: weight(d) for d in (lo + k for k in range(int(hi - lo) + 1))}, weight


@equation("titania-lognormal-share")
def lognormal_share(d, median, s_g, lo, hi):
    classes, weight = _classes(median, s_g, lo, hi)
    return dict(p=weight(d) / mp.fsum(classes.values()))


@equation("titania-lognormal")
def lognormal(median, s_g, lo, hi):
    classes, _ = _classes(median, s_g, lo, hi)
    moment = lambda power: mp.fsum(weight * d**power for d, weight in classes.items())
    return dict(mean=moment(1) / moment(0), sauter=moment(3) / moment(2), d_30=mp.cbrt(moment(3) / moment(0)))
