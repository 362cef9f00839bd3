"""Pham-Ba & Molinari 2022: from a material to the parameters of a pair, Eqs. 7 to 20 and 22."""

from frame import equation, mp, mpf

# Silica (Table 5), and the material of the patch tests (Table 4).
SILICA = dict(e=7.3e10, nu=0.17, sigma_mn=1.6e10, sigma_mt=9.0e9, gamma=1.5, eta=0.9)
PATCH = dict(e=1.0, nu=0.15, sigma_mn=0.2, sigma_mt=0.1, gamma=1.5, eta=0.95)


def lame(e, nu):
    """C11 and C12 of an isotropic solid, without their common factor, and that factor."""
    return 1 - nu, nu, e / ((1 + nu) * (1 - 2 * nu))


def springs(e, nu, r):
    """The stiffnesses whose A.60 and A.61 are the constants of an isotropic solid: two equations,
    3 k_N + 2 k_T = 5 r C11 / sqrt 2 and k_N - k_T = 5 r C12 / sqrt 2."""
    c_11, c_12, factor = lame(e, nu)
    factor *= 5 * r / mp.sqrt(2)
    return (c_11 + 2 * c_12) / 5 * factor, (c_11 - 3 * c_12) / 5 * factor


def bar(area, e, length):
    """The stiffness of a bar: the force over the extension, at a strain of one half."""
    strain = mpf(1) / 2
    return area * (e * strain) / (strain * length)


@equation("wear-7")
@equation("wear-A26")
def normal_stiffness(a_n, e, r_i, r_j):
    return dict(k_n=bar(a_n, e, r_i + r_j))


@equation("wear-8")
@equation("wear-A27")
def tangential_stiffness(a_t, e, r_i, r_j):
    return dict(k_t=bar(a_t, e, r_i + r_j))


@equation("wear-9")
@equation("wear-A29")
def elastic_separation(r_i, r_j, sigma_mn, e):
    """Where the force of a unit cross section is its strength."""
    return dict(delta_e=sigma_mn / bar(1, e, r_i + r_j))


def scale(r_i, r_j, d_c, s):
    """What the size takes from strength and range, by the logarithm to base two."""
    return mp.power(2, s * (mp.log(d_c, 2) - mp.log(r_i + r_j, 2)))


@equation(
    "wear-10",
    [
        dict(gamma=1.5, sigma_mn=1.6e10, r_i=0.75e-9, r_j=0.8125e-9, d_c=1.71e-9, delta_e=3.42e-10, s=0.5),
        dict(gamma=1.5, sigma_mn=1.6e10, r_i=1.5e-9, r_j=2.25e-9, d_c=1.71e-9, delta_e=8.22e-10, s=0.5),
        dict(gamma=1.5, sigma_mn=1.6e10, r_i=3.0e-9, r_j=3.75e-9, d_c=1.71e-9, delta_e=1.48e-9, s=0.0),
        dict(gamma=1.5, sigma_mn=0.25, r_i=45.0, r_j=51.0, d_c=96.0, delta_e=24.0, s=0.5),
        dict(gamma=1.5, sigma_mn=0.25, r_i=45.0, r_j=51.00000000000001, d_c=96.0, delta_e=24.0, s=0.5),
        dict(gamma=1.5, sigma_mn=0.2, r_i=5760.0, r_j=4320.0, d_c=150.0, delta_e=2016.0, s=1.0),
    ],
)
def fracture_separation(gamma, sigma_mn, r_i, r_j, d_c, delta_e, s):
    """For small particles, the base of the triangle of Figure 2 that is as large as two surfaces of the energy."""
    if r_i + r_j <= d_c:
        return dict(delta_f=2 * gamma / (sigma_mn / 2))
    return dict(delta_f=delta_e * scale(r_i, r_j, d_c, s))


@equation("wear-A49")
def rescaled_separation(delta_e, r_i, r_j, d_c, s):
    return dict(delta_f=delta_e * scale(r_i, r_j, d_c, s))


@equation("wear-20")
def matched_strength(sigma_mn, r_i, r_j, d_c, s):
    return dict(sigma_mn_matched=sigma_mn * scale(r_i, r_j, d_c, s) if r_i + r_j > d_c else sigma_mn)


@equation("wear-11")
@equation("wear-A30")
def maximum_tangential_force(a_t, sigma_mt):
    return dict(f_mt=sigma_mt * a_t)


def damping(eta, k, m_eff):
    """A.44 solved for the damping: 1 - eta over what a unit of damping takes."""
    return 2 * (1 - eta) * mp.sqrt(k) * mp.sqrt(m_eff) / mp.pi


WEAK = [dict(eta=0.9, m_eff=1.945e-24), dict(eta=0.0, m_eff=2.4e-23), dict(eta=0.625, m_eff=3.3e5)]


@equation("wear-12", [dict(case, k_n=k_n) for case, k_n in zip(WEAK, (58.7, 117.5, 42.5))])
def normal_damping(eta, k_n, m_eff):
    return dict(c_n=damping(eta, k_n, m_eff))


@equation("wear-A45")
def normal_damping_again(eta, k_n, m_eff):
    return dict(c_n=damping(eta, k_n, m_eff))


@equation("wear-13", [dict(case, k_t=k_t) for case, k_t in zip(WEAK, (16.05, 32.125, 0.0))])
def tangential_damping(eta, k_t, m_eff):
    return dict(c_t=damping(eta, k_t, m_eff))


@equation("wear-A47")
def tangential_damping_again(eta, k_t, m_eff):
    return dict(c_t=damping(eta, k_t, m_eff))


@equation(
    "wear-A46",
    [dict(eta=0.9, c_c=2.13e-11), dict(eta=0.95, c_c=3.1e-10), dict(eta=0.0, c_c=1.4142), dict(eta=1.0, c_c=6.5e-11)],
)
def damping_of_critical(eta, c_c):
    """The damping of a pair of unit mass and the stiffness for which that is critical."""
    return dict(c_n=damping(eta, (c_c / 2) ** 2, mpf(1)))


@equation("wear-14")
@equation("wear-A66")
def effective_radius(r_i, r_j):
    return dict(r_eff=r_j if r_j < r_i else r_i)


@equation("wear-15")
@equation("wear-A64")
def normal_cross_section(r_eff, nu):
    """A.26 solved for it, with the springs of two spheres of that radius and a unit modulus."""
    return dict(a_n=springs(mpf(1), nu, r_eff)[0] * 2 * r_eff)


@equation("wear-16")
@equation("wear-A65")
def tangential_cross_section(r_eff, nu):
    return dict(a_t=springs(mpf(1), nu, r_eff)[1] * 2 * r_eff)


@equation("wear-A62")
def normal_stiffness_of_body(e, r, nu):
    return dict(k_n=springs(e, nu, r)[0])


@equation("wear-A63")
def tangential_stiffness_of_body(e, r, nu):
    return dict(k_t=springs(e, nu, r)[1])


@equation("wear-17")
@equation("wear-A3")
def effective_mass(m_i, m_j):
    return dict(m_eff=1 / (1 / m_i + 1 / m_j))


@equation("wear-18")
@equation("wear-A48")
def critical_diameter(gamma, e, sigma_mn):
    """Of which the elastic separation, a share of it, is the range."""
    return dict(d_c=range_of(gamma, sigma_mn) / (sigma_mn / e))


def range_of(gamma, sigma_mn):
    return 2 * gamma / (sigma_mn / 2)


@equation("wear-19")
def minimum_diameter(gamma, sigma_mn):
    return dict(d_min=range_of(gamma, sigma_mn))


@equation("wear-A34")
def separation_of_surface_energy(gamma, sigma_mn):
    return dict(delta_f=range_of(gamma, sigma_mn))


@equation("wear-parameters")
def force_parameters(e, nu, sigma_mn, sigma_mt, gamma, eta, s, r_i, r_j, m_i, m_j):
    r_eff = effective_radius(r_i, r_j)["r_eff"]
    a_n, a_t = (springs(mpf(1), nu, r_eff)[k] * 2 * r_eff for k in (0, 1))
    k_n, k_t = bar(a_n, e, r_i + r_j), bar(a_t, e, r_i + r_j)
    m_eff = effective_mass(m_i, m_j)["m_eff"]
    delta_e = elastic_separation(r_i, r_j, sigma_mn, e)["delta_e"]
    d_c = critical_diameter(gamma, e, sigma_mn)["d_c"]
    return dict(
        k_n=k_n,
        k_t=k_t,
        delta_e=delta_e,
        delta_f=fracture_separation(gamma, sigma_mn, r_i, r_j, d_c, delta_e, s)["delta_f"],
        f_mt=a_t * sigma_mt,
        c_n=damping(eta, k_n, m_eff),
        c_t=damping(eta, k_t, m_eff),
    )


@equation(
    "wear-22",
    [
        dict(gamma=1.5, g=3.12e10, sigma_mt=9.0e9),
        dict(gamma=1.5, g=0.4347826086956522, sigma_mt=0.1),
        dict(gamma=1.02, g=2.65e10, sigma_mt=4.4e9),
        dict(gamma=0.05, g=1.25e9, sigma_mt=3.0e7),
    ],
)
def critical_length(gamma, g, sigma_mt):
    """Thirty-two times the surface energy over the energy density of shear, twice over."""
    density = sigma_mt**2 / (2 * g)
    return dict(d_star=16 * gamma / density)


@equation("wear-shear-modulus")
def shear_modulus(e, nu):
    c_11, c_12, factor = lame(e, nu)
    return dict(g=(c_11 - c_12) * factor / 2)


@equation(
    "wear-wave-velocity",
    [dict(e=7.3e10, rho=2200.0), dict(e=1.0, rho=1.0), dict(e=2.1e11, rho=7850.0), dict(e=3.2e9, rho=1190.0)],
)
def wave_velocity(e, rho):
    """By logarithms."""
    return dict(c=mp.exp((mp.log(e) - mp.log(rho)) / 2))
