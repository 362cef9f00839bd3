"""Pham-Ba & Molinari 2022: stress, strain and energy of a pair, A.20 to A.33."""

from frame import equation, mpf
from wear_material import bar


@equation("wear-A20")
def normal_stress(f_n, a_n):
    return dict(sigma_n=f_n / a_n)


@equation("wear-A21")
def tangential_stress(f_t, a_t):
    return dict(sigma_t=f_t / a_t)


@equation("wear-A22")
def normal_strain(delta_n, r_i, r_j):
    """The distance of the centres over that at rest, less one."""
    return dict(epsilon_n=delta_n / (r_i + r_j))


@equation(
    "wear-A23",
    [
        dict(e=7.3e10, epsilon_n=0.2191780821917808),
        dict(e=7.3e10, epsilon_n=-0.0125),
        dict(e=1.0, epsilon_n=0.2),
        dict(e=2.1e11, epsilon_n=0.0),
    ],
)
def elastic_stress(e, epsilon_n):
    """The force of a bar of unit cross section and length."""
    return dict(sigma_n=bar(1, e, mpf(1)) * epsilon_n)


@equation(
    "wear-A24",
    [
        dict(f_n=5.87e-9, delta_n=1.0e-10),
        dict(f_n=-2.9e-9, delta_n=-5.0e-11),
        dict(f_n=4.75, delta_n=0.3),
        dict(f_n=-0.07, delta_n=-0.0011),
    ],
)
def stiffness_of_force(f_n, delta_n):
    return dict(k_n=f_n / delta_n)


@equation(
    "wear-A25",
    [
        dict(a_n=1.2e-18, sigma_n=1.6e10, r_i=0.75e-9, r_j=0.75e-9, epsilon_n=0.2191780821917808),
        dict(a_n=4.8e-18, sigma_n=-3.0e8, r_i=1.5e-9, r_j=2.25e-9, epsilon_n=-0.0041),
        dict(a_n=5050.0, sigma_n=0.2, r_i=50.0, r_j=60.0, epsilon_n=0.2),
        dict(a_n=2.1e-17, sigma_n=7.3e6, r_i=3.75e-9, r_j=3.0e-9, epsilon_n=1.0e-4),
    ],
)
def stiffness_of_stress(a_n, sigma_n, r_i, r_j, epsilon_n):
    """The force over the extension."""
    force, extension = sigma_n * a_n, epsilon_n * (r_i + r_j)
    return dict(k_n=force / extension)


@equation("wear-A28")
def elastic_strain(sigma_mn, e):
    return dict(epsilon_e=sigma_mn / e)


@equation("wear-A31")
def work_of_separation(k_n, delta_e, delta_f):
    """The area of the triangle of Figure 2, or of what A.1 leaves of it: side by side, from the left and from the right."""
    peak = min(delta_e, delta_f)
    return dict(u_gamma=k_n * peak * peak / 2 + k_n * peak * (delta_f - peak) / 2)


@equation("wear-A32")
def work_of_strength(a_n, sigma_mn, delta_f):
    return dict(u_gamma=a_n * (sigma_mn / 2) * delta_f)


@equation(
    "wear-A33",
    [
        dict(u_gamma=3.6e-18, a_n=1.2e-18),
        dict(u_gamma=1.44e-17, a_n=4.8e-18),
        dict(u_gamma=15150.0, a_n=5050.0),
        dict(u_gamma=0.0, a_n=1.2e-18),
    ],
)
def surface_energy(u_gamma, a_n):
    """The energy per area of two surfaces."""
    return dict(gamma=u_gamma / (a_n + a_n))
