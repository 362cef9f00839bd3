"""Laube et al. 2018, Eqs. 1, 2 and 6 to 13: forces and torques of a contact."""

from frame import Vector, equation, mp, mpf, printed


def _contact_radius(r_i, r_j, h_n):
    """The harmonic mean of the spheres with their layers, (R + h_n)*."""
    return 2 / (1 / (r_i + h_n) + 1 / (r_j + h_n))


def _across(v, n):
    """The part of a vector across a normal."""
    return v - n * v.dot(n)


@equation("titania-1")
def total_force(f_na, f_nr, f_nd, f_t):
    return dict(force=Vector(*(mp.fsum(parts) for parts in zip(f_na, f_nr, f_nd, f_t))))


@equation(
    "titania-arm",
    cases=[
        dict(r_i=4e-9, r_j=4e-9, d=8.57e-9),
        dict(r_i=1.5e-9, r_j=1.15e-8, d=1.36e-8),
        dict(r_i=5e-9, r_j=2e-9, d=6.5e-9),
        dict(r_i=2e-9, r_j=5e-9, d=6.5e-9),
    ],
)
def moment_arm(r_i, r_j, d):
    # The middle of the gap between the surfaces.
    return dict(arm=(r_i + (d - r_j)) / 2)


@equation("titania-arm-layer", cases=[dict(r_i=r_i, h_n=3.6e-10) for r_i in (1.5e-9, 4e-9, 7.3e-9, 1.15e-8)])
def layered_arm(r_i, h_n):
    return dict(arm=mp.fsum([r_i, h_n / 2]))


@equation("titania-2")
def torques(x_i, x_j, r_i, r_j, f_t, omega_i, omega_j, m_r):
    branch = x_i - x_j
    d = branch.norm()
    n = branch / d
    l_i, l_j = (d + r_i - r_j) / 2, (d + r_j - r_i) / 2
    force = _across(f_t, n)
    rolling = _across(omega_i - omega_j, n)
    resistance = rolling * (m_r / rolling.norm()) if rolling.norm() != 0 else Vector(0, 0, 0)
    # The force on i acts at x_i - l_i n, its reaction at x_j + l_j n.
    m_i = (-(n * l_i)).cross(force) - resistance
    m_j = (n * l_j).cross(-force) + resistance
    return dict(n=n, l_i=l_i, l_j=l_j, m_i=m_i, m_j=m_j)


@equation("titania-6")
def normal_damping(gamma_n, v_i, v_j, x_i, x_j):
    branch = x_i - x_j
    return dict(f_nd=branch * (-gamma_n * (v_i - v_j).dot(branch) / branch.dot(branch)))


@equation("titania-7")
def damping_coefficient(r_star, gamma_0):
    return dict(gamma_n=gamma_0 * r_star**2)


@equation("titania-8")
def repulsion(k_n, delta_n, r_i, r_j, h_n):
    radius = _contact_radius(r_i, r_j, h_n)
    force = lambda overlap: k_n * mp.sqrt(overlap**3 * radius / 2) if overlap > 0 else mpf(0)
    if delta_n <= 0:
        return dict(rhn_star=radius, f_nr=0, stiffness=0, energy=0)
    # From the energy 2/5 k_n sqrt(R/2) delta^(5/2), a power law.
    energy = force(delta_n) * delta_n * 2 / 5
    return dict(rhn_star=radius, f_nr=energy * 5 / 2 / delta_n, stiffness=energy * 15 / 4 / delta_n**2, energy=energy)


@equation("titania-9")
def stiffness(f_na_0, delta_n_0, r_i, r_j, h_n):
    # The k_n for which Eq. 8 balances the attraction.
    return dict(k_n=-f_na_0 / mp.sqrt(delta_n_0**3 * _contact_radius(r_i, r_j, h_n) / 2))


@equation(
    "titania-9-mixed", cases=[dict(k_i=a, k_j=b) for a, b in [(2.4e10, 5.5e10), (3.3e10, 3.3e10), (4.5e10, 2.1e10), (2.45e10, 2.9e10)]]
)
def mixed_stiffness(k_i, k_j):
    return dict(k_n=2 * k_i * k_j / (k_i + k_j))


@equation("titania-10")
def peak_friction(a, tau_s, tau_r):
    return dict(f_ts=tau_s * a, f_tr=tau_r * a)


@equation("titania-deltan")
def overlap(r_i, r_j, h_n, d):
    return dict(delta_n=(r_i + h_n) + (r_j + h_n) - d)


@equation(
    "titania-radii",
    cases=[dict(d_nom=d, gap=gap, h_n=3.6e-10) for d, gap in [(3e-9, 5.7e-10), (8e-9, 5.7e-10), (1.1e-8, 0.0), (2.3e-8, 5.7e-10)]],
)
def radii(d_nom, gap, h_n):
    core = (d_nom - gap) / 2
    return dict(core=core, nominal=d_nom / 2, contact=core + h_n)


@equation("titania-11")
def contact_area(r_i, r_j, h_n, d):
    a, b = r_i + h_n, r_j + h_n
    # Distance of the plane of the circle from the centre of i.
    height = (a**2 - b**2 + d**2) / (2 * d)
    square = a**2 - height**2
    return dict(a=mp.pi * square if square > 0 else 0, delta_n=a + b - d)


@equation("titania-11-plane")
def plane_area(r, h_n, delta):
    a = r + h_n
    return dict(a=mp.pi * (a**2 - (a - delta) ** 2))


@equation("titania-12")
def sawtooth(tau_s, a, delta_t, lambda_t, t):
    part = delta_t / lambda_t - mp.floor(delta_t / lambda_t)
    return dict(frac=part, f_t=t * (-tau_s * a * part))


SPRING = dict(tau_s=6.5e8, a=1.9e-18, lambda_t=5e-10)


@equation(
    "titania-12-spring",
    cases=[
        SPRING | dict(xi=xi, slip=slip)
        for xi, slip in [
            ([1e-10, -2e-10, 3e-10], 1.0),
            ([1e-10, -2e-10, 3e-10], 0.0),
            ([4e-10, -2e-10, 3e-10], 1.0),
            ([4e-10, -2e-10, 3e-10], 0.0),
            ([-7e-10, 1.1e-9, 2e-10], 1.0),
            ([-7e-10, 1.1e-9, 2e-10], 0.0),
        ]
    ],
    defined=lambda slip, **_: slip in (0, 1),
)
def sliding_spring(tau_s, a, lambda_t, xi, slip):
    length = xi.norm()
    left = xi
    if length >= lambda_t:
        left = xi * ((length % lambda_t) / length) if slip == 1 else Vector(0, 0, 0)
        if slip == 0:
            return dict(f_t=xi * (-tau_s * a / length), xi_next=left)
    return dict(f_t=left * (-tau_s * a / lambda_t), xi_next=left)


@equation(
    "titania-12-energy",
    cases=[SPRING | dict(xi=xi) for xi in ([1e-10, -2e-10, 3e-10], [0.0, 4.9e-10, 0.0], [-3e-11, 2e-11, 7e-12])]
    + [dict(tau_s=6.5e8, a=3.7e-18, lambda_t=4e-10, xi=[2e-10, 1e-10, -1e-10])],
)
def spring_energy(tau_s, a, lambda_t, xi):
    # The work of the growing spring, from zero to its length.
    length = xi.norm()
    return dict(v_t=mp.quad(lambda s: tau_s * a * s / lambda_t, [0, length]))


@equation("titania-13")
def rolling_resistance(r_i, r_j, h_n, tau_r, a):
    return dict(m_r=_contact_radius(r_i, r_j, h_n) / 2 * tau_r * a)


SPINS = [
    dict(omega_i=[3e8, -2e8, 1e8], omega_j=[-1e8, 4e8, 2e8], n=[0.6, 0.0, 0.8]),
    dict(omega_i=[1e7, 2e7, -9e8], omega_j=[3e7, -1e7, 8e8], n=[0.0, 0.0, 1.0]),
    dict(omega_i=[-4e9, 1e9, 0.0], omega_j=[0.0, 0.0, 0.0], n=[-0.36, 0.48, 0.8]),
    dict(omega_i=[1e3, -2e3, 5e2], omega_j=[-1e3, 1e3, 1e3], n=[0.0, -0.6, 0.8]),
]


@equation(
    "titania-13-torque",
    cases=[
        SPINS[0] | dict(m_r=1.1e-18, inertia=3e-39, dt=5e-13),
        SPINS[1] | dict(m_r=1.1e-18, inertia=3e-39, dt=5e-13),
        SPINS[2] | dict(m_r=4e-18, inertia=6e-38, dt=1e-12),
        SPINS[3] | dict(m_r=1.1e-18, inertia=3e-39, dt=5e-13),
        SPINS[3] | dict(m_r=1.1e-18, inertia=3e-39, dt=0.5),
        dict(omega_i=[1e8, 2e8, 3e8], omega_j=[1e8, 2e8, 3e8], n=[0.6, 0.0, 0.8], m_r=1.1e-18, inertia=3e-39, dt=5e-13),
    ],
    defined=lambda dt, **_: dt > 0,
)
def rolling_torque(m_r, omega_i, omega_j, n, inertia, dt):
    rolling = _across(omega_i - omega_j, n)
    speed = rolling.norm()
    if speed == 0:
        return dict(torque=rolling)
    stopping = inertia * speed / dt
    return dict(torque=-(rolling / speed) * (m_r if m_r < stopping else stopping))


@equation("titania-13-share", cases=SPINS + [dict(omega_i=[1e8, 0.0, 0.0], omega_j=[1e8, 0.0, 0.0], n=[0.6, 0.0, 0.8])])
def rolling_share(omega_i, omega_j, n):
    whole = omega_i - omega_j
    return dict(share=_across(whole, n).norm() / whole.norm() if whole.norm() != 0 else 1)


@equation("titania-rayleigh")
def rayleigh_time(r, rho, g, nu):
    return dict(t_r=mp.pi * r / mp.sqrt(g / rho) / (printed(0.1631) * nu + printed(0.8766)))


@equation("titania-relax-lin")
def relaxation(k_n, r_i, r_j, h_n, f_a, rho, gamma_0):
    radius = _contact_radius(r_i, r_j, h_n) / 2
    force = lambda overlap: k_n * mp.sqrt(radius) * overlap ** mpf(1.5)
    delta_0 = mp.cbrt((f_a / k_n) ** 2 / radius)
    k = mpf(3) / 2 * force(delta_0) / delta_0
    mass = [mpf(4) / 3 * mp.pi * rho * r**3 for r in (r_i, r_j)]
    m_eff = mass[0] * mass[1] / sum(mass)
    gamma_n = gamma_0 * (2 * r_i * r_j / (r_i + r_j)) ** 2
    # m x'' + gamma x' + k x = 0
    omega_0 = mp.sqrt(k / m_eff)
    return dict(
        delta_0=delta_0,
        k_lin=k,
        m_eff=m_eff,
        gamma_n=gamma_n,
        omega_0=omega_0,
        zeta=gamma_n / (2 * m_eff * omega_0),
        tau=2 * m_eff / gamma_n,
    )
