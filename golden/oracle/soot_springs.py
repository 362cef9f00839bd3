"""Demidov, Gor & Khalizov 2024, Eqs. 12 to 17: springs, their transport, friction, torques, frequencies."""

from frame import equation, mp
from soot_pairs import arms


@equation("soot-rotated", cases=[
    dict(xi=[1e-11, 2e-11, 3e-11], n=[0.6, 0.0, 0.8]),
    dict(xi=[-4.4e-13, 1.7e-12, 9e-14], n=[-0.48, 0.64, 0.6]),
    dict(xi=[0.7, -0.2, 1.3], n=[0.0, 1.0, 0.0]),
    dict(xi=[3.1e-9, 2.2e-10, -5e-9], n=[0.36, 0.48, -0.8]),
])
def rotated_spring(xi, n):
    return dict(rotated=in_plane(xi, n))


def in_plane(xi, n):
    """A spring turned into the plane across a normal, as given: a normal of doubles is not quite of unit length."""
    flat = xi - n * xi.dot(n)
    return flat * mp.sqrt(xi.dot(xi) / flat.dot(flat)) if flat.norm() > 0 else flat


@equation("soot-rotated-torsion", cases=[
    dict(xi=[1e-11, 2e-11, 3e-11], n=[0.6, 0.0, 0.8]),
    dict(xi=[-4.4e-13, 1.7e-12, 9e-14], n=[0.48, -0.64, 0.6]),
    dict(xi=[0.7, -0.2, 1.3], n=[0.0, 1.0, 0.0]),
    dict(xi=[3.1e-9, 2.2e-10, -5e-9], n=[0.36, 0.48, -0.8]),
])
def rotated_torsion(xi, n):
    return dict(rotated=n * (xi.norm() * mp.sign(xi.dot(n))))


@equation("soot-spring", cases=[
    dict(xi=[1e-11, 2e-11, 3e-11], n=[0.6, 0.0, 0.8], xi_dot=[0.8, 1.5, -0.6], dt=5e-15),
    dict(xi=[-4.4e-13, 1.7e-12, 9e-14], n=[0.48, -0.64, 0.6], xi_dot=[1.0, 0.3, -0.48], dt=5e-14),
    dict(xi=[0.7, -0.2, 1.3], n=[0.0, 1.0, 0.0], xi_dot=[0.01, 0.0, -0.07], dt=0.25),
    dict(xi=[3.1e-9, 2.2e-10, -5e-9], n=[0.36, 0.48, -0.8], xi_dot=[8e-3, 0.0, 3.6e-3], dt=0.0),
])
def stretched_spring(xi, n, xi_dot, dt):
    return dict(xi_next=in_plane(xi, n) + xi_dot * dt)


@equation("soot-lag-limit", cases=[
    dict(k=1000.0, eta=1.5e-10),
    dict(k=10.0, eta=0.0),
    dict(k=0.05, eta=2.2e-11),
    dict(k=3.0, eta=7.0),
])
def lag_limit(k, eta):
    # the step whose stiffness takes all of the dashpot
    return dict(dt_max=eta / k)


@equation("soot-12", cases=[
    dict(k=1000.0, xi=[1e-11, -2.5e-12, 3e-13], eta=1.5e-10, xi_dot=[0.3, 0.02, -1.1]),
    dict(k=0.0, xi=[1e-11, 2e-11, 3e-11], eta=2e-12, xi_dot=[1.0, -2.0, 0.5]),
    dict(k=50.0, xi=[-7e-12, 1e-12, 4e-12], eta=0.0, xi_dot=[1.0, -2.0, 0.5]),
    dict(k=1.3, xi=[0.7, 0.2, -0.1], eta=0.4, xi_dot=[0.25, -3.0, 0.125]),
])
def spring_force(k, xi, eta, xi_dot):
    return dict(f=xi * k + xi_dot * eta)


@equation("soot-spring-energy", cases=[
    dict(k=1000.0, xi=[1e-11, -2.5e-12, 3e-13]),
    dict(k=0.0, xi=[1e-11, 2e-11, 3e-11]),
    dict(k=50.0, xi=[0.0, 0.0, 4e-12]),
    dict(k=1.3, xi=[0.7, 0.2, -0.1]),
])
def spring_energy(k, xi):
    # the work of stretching it from zero
    return dict(u=mp.quad(lambda s: (xi * (k * s)).dot(xi), [0, 1]))


@equation("soot-torques", cases=[])
def contact_torques(x_i, x_j, r_i, r_j, f_t, f_r, f_o):
    apart = x_j - x_i
    n = apart / apart.norm()
    a_i, a_j, a, r = arms(x_i, x_j, r_i, r_j)
    # the tangential force acts on i at +a_i n and, reversed, on j at -a_j n
    couple = n.cross(f_r) * a + n * (f_o.dot(n) * r)
    return dict(tau_i=(n * a_i).cross(f_t) + couple, tau_j=(n * -a_j).cross(f_t * -1) - couple)


@equation("soot-neck-stress", cases=[
    dict(f_n=3.1e-9, f_t=[2e-10, -1e-10, 0.0], m=[1e-18, 3e-18, -2e-18], n=[0.0, 0.0, 1.0], r_b=3e-9),
    dict(f_n=-8e-9, f_t=[0.0, 4e-10, 3e-10], m=[5e-19, 0.0, 2e-19], n=[1.0, 0.0, 0.0], r_b=5e-9),
    dict(f_n=0.0, f_t=[1e-9, 0.0, 0.0], m=[-7e-18, 1e-18, 6e-18], n=[0.48, -0.64, 0.6], r_b=2.2e-9),
    dict(f_n=0.7, f_t=[0.1, 0.2, -0.2], m=[0.3, 0.4, 1.2], n=[0.6, 0.0, 0.8], r_b=0.35),
])
def neck_stress(f_n, f_t, m, n, r_b):
    area = mp.quad(lambda s: 2 * mp.pi * s, [0, r_b])
    polar = mp.quad(lambda s: 2 * mp.pi * s**3, [0, r_b])
    bending, torsion = (m - n * m.dot(n)).norm(), abs(m.dot(n))
    return dict(sigma=f_n / area + bending * r_b / (polar / 2), tau=f_t.norm() / area + torsion * r_b / polar)


def mobility(rates, inertias):
    """How fast generalised forces along some rates accelerate these rates: J M^-1 J^T."""
    return mp.matrix([[sum(p * q / m for p, q, m in zip(a, b, inertias)) for b in rates] for a in rates])


@equation("soot-frequencies", cases=[
    dict(k_n=1000.0, k_t=500.0, k_r=250.0, k_o=125.0, m=1.954e-20, i=1.532e-36, r=1.4e-8),
    dict(k_n=10.0, k_t=10.0, k_r=10.0, k_o=10.0, m=1.954e-20, i=2.553e-36, r=1.4e-8),
    dict(k_n=3e4, k_t=0.7, k_r=0.02, k_o=55.0, m=7.1e-21, i=2.2e-37, r=9e-9),
    dict(k_n=1.0, k_t=0.7, k_r=0.3, k_o=0.4, m=1.0, i=0.4, r=1.0),
])
def neck_frequencies(k_n, k_t, k_r, k_o, m, i, r):
    # velocities: v_i and v_j along the motion, omega_i and omega_j about its axis
    motions = dict(omega_n=(k_n, [-1, 1, 0, 0]), omega_t=(k_t, [-1, 1, -r, -r]), omega_r=(k_r, [0, 0, -r, r]),
                   omega_o=(k_o, [0, 0, -r, r]))
    return {name: mp.sqrt(k * mobility([rate], [m, m, i, i])[0, 0]) for name, (k, rate) in motions.items()}


@equation("soot-slide-and-roll", cases=[
    dict(s_t=1.1e-21, s_r=7e-22, r_i=1.4e-8, r_j=1.4e-8, m_i=1.954e-20, m_j=1.954e-20),
    dict(s_t=2.5e-21, s_r=1e-21, r_i=1.4e-8, r_j=4.2e-8, m_i=1.954e-20, m_j=5.2758e-19),
    dict(s_t=3e-22, s_r=4e-21, r_i=2.3e-8, r_j=6e-9, m_i=8.66e-20, m_j=1.54e-21),
    dict(s_t=0.7, s_r=0.3, r_i=1.0, r_j=2.0, m_i=1.0, m_j=8.0),
    dict(s_t=0.5, s_r=0.0, r_i=1.0, r_j=2.0, m_i=1.0, m_j=8.0),
])
def slide_and_roll(s_t, s_r, r_i, r_j, m_i, m_j):
    inertia = lambda m, r: 2 * m * r * r / 5
    a = 2 / (1 / r_i + 1 / r_j)
    scaled = [[w * q for q in rate] for w, rate in
              [(mp.sqrt(s_t), [-1, 1, -r_i, -r_j]), (mp.sqrt(s_r), [0, 0, -a, a])]]
    eigenvalues, _ = mp.eigsy(mobility(scaled, [m_i, m_j, inertia(m_i, r_i), inertia(m_j, r_j)]))
    return {"lambda": max(eigenvalues)}


LIMITS = [
    dict(f_0=[1e-10, 2e-10, -3e-10], f_cs=1e-9),
    dict(f_0=[1e-10, 2e-9, -3e-10], f_cs=1e-9),
    dict(f_0=[3.0, 4.0, 0.0], f_cs=5.0),
    dict(f_0=[3.0, 4.0, 1e-6], f_cs=5.0),
    dict(f_0=[0.0, 0.0, 0.0], f_cs=0.0),
]


@equation("soot-13", cases=LIMITS)
def is_static(f_0, f_cs):
    return dict(holds=int(f_0.dot(f_0) <= f_cs * f_cs))


@equation("soot-14", cases=LIMITS)
def is_dynamic(f_0, f_cs):
    return dict(slips=int(f_0.dot(f_0) > f_cs * f_cs))


@equation("soot-15", cases=[])
def static_friction(mu_s, f_n):
    return dict(f_cs=mu_s * f_n)


@equation("soot-16", cases=[])
def dynamic_friction(mu_d, f_n):
    return dict(f_cd=mu_d * f_n)


def slipped(k, eta, f_cd, f_0, xi_dot):
    """The spring whose force with the same rate is the friction that was applied."""
    return (f_0 * (f_cd / f_0.norm()) - xi_dot * eta) / k if k > 0 else f_0 * 0


@equation("soot-17", cases=[
    dict(k=100.0, eta=1e-12, f_cd=5e-10, f_0=[1e-10, 2e-10, 3e-9], xi_dot=[0.0, 0.5, 1.0]),
    dict(k=1000.0, eta=0.0, f_cd=2.2e-9, f_0=[-4e-9, 0.0, 1e-9], xi_dot=[0.3, -0.1, 0.2]),
    dict(k=0.0, eta=1e-12, f_cd=5e-10, f_0=[1e-10, 2e-10, 3e-9], xi_dot=[0.0, 0.5, 1.0]),
    dict(k=1.3, eta=0.7, f_cd=0.0, f_0=[1.0, 2.0, -2.0], xi_dot=[0.25, 0.1, -3.0]),
])
def slipped_spring(k, eta, f_cd, f_0, xi_dot):
    return dict(xi_next=slipped(k, eta, f_cd, f_0, xi_dot))


@equation("soot-friction", cases=[])
def spring_with_friction(xi, xi_dot, k, eta, mu_s, mu_d, f_n):
    test, static, dynamic = xi * k + xi_dot * eta, mu_s * f_n, mu_d * f_n
    slips = test.dot(test) > static * static
    force = test * (dynamic / test.norm()) if slips else test
    return dict(slip=int(slips), f_cs=static, f_cd=dynamic, f=force, xi_next=(force - xi_dot * eta) / k if slips else xi)
