"""Demidov, Gor & Khalizov 2024, Eqs. 24 to 33: size of aggregates, the tip, the cantilever that reads its force.

The readings in time are those of the first-order system of the cantilever, by the exponential of its matrix and by gamma functions.
"""

from frame import equation, mp


@equation("soot-24", cases=[])
def fractal_number(k_f, r_g, r, d_f):
    return dict(n=k_f * mp.exp(d_f * (mp.log(r_g) - mp.log(r))))


@equation("soot-24-inv", cases=[])
def gyration_radius(k_f, n, r, d_f):
    return dict(r_g=mp.exp(mp.log(r) + mp.log(n / k_f) / d_f))


TIP = dict(v_tip=1.5, rate=1e8, t_reversal=1.08e-8)
TIMES = [
    dict(TIP, t=0.0),
    dict(TIP, t=3e-9),
    dict(TIP, t=1.08e-8),
    dict(TIP, t=5e-7),
    dict(t=-0.3, v_tip=2.0, rate=1.25, t_reversal=1.5),
]


@equation("soot-25", cases=TIMES)
def tip_velocity(t, v_tip, rate, t_reversal):
    rise = mp.exp(2 * rate * (t - t_reversal))
    return dict(v=v_tip * (rise - 1) / (rise + 1))


@equation("soot-25-way", cases=TIMES)
def tip_way(t, v_tip, rate, t_reversal):
    if t == 0:
        return dict(z=0)
    # in parts that are short compared with the distance of the poles of the hyperbolic tangent
    edges = mp.linspace(0, t, int(mp.ceil(abs(rate * t))) + 1)
    return dict(z=mp.quad(lambda s: v_tip * mp.tanh(rate * (s - t_reversal)), edges))


@equation("soot-26", cases=[])
def coordination_number(sum, n):
    return dict(c=sum / n)


NEIGHBOURS = dict(x_i=[0.0, 0.0, 0.0], r_i=1.4e-8, r_j=1.4e-8, threshold=0.01)


@equation("soot-neighbours", cases=[
    dict(NEIGHBOURS, x_j=[2.82e-8, 0.0, 0.0]),
    dict(NEIGHBOURS, x_j=[2.83e-8, 0.0, 0.0]),
    dict(NEIGHBOURS, x_j=[1.6e-8, 1.6e-8, 1.6e-8]),
    dict(NEIGHBOURS, x_j=[1e-8, 1.9e-8, -1.7e-8], r_j=9e-9),
    dict(NEIGHBOURS, x_j=[1e-8, 1.9e-8, -1.7e-8]),
    dict(x_i=[0.0, 0.0, 0.0], x_j=[3.0, 4.0, 0.0], r_i=2.0, r_j=2.0, threshold=0.25),
])
def are_neighbours(x_i, x_j, r_i, r_j, threshold):
    apart = x_j - x_i
    return dict(neighbours=int(apart.dot(apart) < ((1 + threshold) * (r_i + r_j)) ** 2))


@equation("soot-edge-curvature", cases=[
    dict(length=2.8e-8, theta=6.283185307179586),
    dict(length=2.8e-8, theta=1.5707963267948966),
    dict(length=0.0, theta=1.0),
    dict(length=3.96e-8, theta=0.0),
    dict(length=1.5, theta=2.25),
])
def edge_curvature(length, theta):
    # a rounded edge is a part of a cylinder, whose mean curvature is half of 1/r, over its area
    return dict(m_0=mp.quad(lambda angle: length / 2, [0, theta]))


@equation("soot-hull", cases=[
    dict(v_0=0.0, s_0=0.0, m_0=8.796459430051421e-8, r=1.4e-8),
    dict(v_0=2.2e-23, s_0=4.7e-15, m_0=2.639e-7, r=1.4e-8),
    dict(v_0=0.0, s_0=0.0, m_0=0.0, r=1.4e-8),
    dict(v_0=8.0, s_0=24.0, m_0=18.84955592153876, r=1.0),
])
def hull_volume(v_0, s_0, m_0, r):
    # layer by layer, each with the area of the parallel surface
    return dict(v_hull=v_0 + mp.quad(lambda s: s_0 + 2 * m_0 * s + 4 * mp.pi * s * s, [0, r]))


@equation("soot-convexity", cases=[
    dict(v_spheres=2.2988080643867e-23, v_hull=2.87351008048338e-23),
    dict(v_spheres=1.149404032193385e-23, v_hull=1.149404032193385e-23),
    dict(v_spheres=1.724e-21, v_hull=9.31e-21),
    dict(v_spheres=0.3, v_hull=7.0),
])
def convexity(v_spheres, v_hull):
    return dict(convexity=v_spheres / v_hull)


@equation("soot-27", cases=[])
def cantilever_force(m_c, eta_c, k_c, u, u_dot, u_ddot):
    return dict(f=mp.fdot([m_c, eta_c, k_c], [u_ddot, u_dot, u]))


@equation("soot-28", cases=[])
def force_of_reading(m_c, eta_c, k_c, g, g_dot, g_ddot):
    # Eq. 27 for the deflection g / k_c
    return dict(f=mp.fdot([m_c, eta_c, k_c], [g_ddot, g_dot, g]) / k_c)


@equation("soot-29", cases=[])
def cantilever_damping(m_c, k_c):
    # without discriminant the polynomial m s^2 + eta s + k has a double root
    return dict(eta_c=mp.sqrt(4 * m_c * k_c))


@equation("soot-31", cases=[])
def natural_frequency(k_c, m_c):
    return dict(omega_0=mp.sqrt(k_c) / mp.sqrt(m_c))


@equation("soot-30", cases=[])
def transfer_function(omega_0, s_re, s_im):
    h = (omega_0 / mp.mpc(omega_0 + s_re, s_im)) ** 2
    return dict(h_re=h.real, h_im=h.imag, gain=omega_0**2 / ((omega_0 + s_re) ** 2 + s_im**2))


@equation("soot-32", cases=[])
def preserved(omega_0, s):
    return dict(h=1 / (1 + s / omega_0) ** 2)


@equation("soot-33", cases=[])
def attenuated(omega_0, s):
    return dict(h=1 / (1 + s / omega_0) ** 2)


@equation("soot-30-time", cases=[])
def time_response(omega_0, t):
    y = omega_0 * t
    share = lambda n: mp.gammainc(n, 0, y, regularized=True)
    return dict(impulse=omega_0 * y * mp.exp(-y), step=share(2), ramp=t * share(2) - 2 / omega_0 * share(3))


READING = dict(omega_0=1e8, g=2.1e-10, g_dot=-0.013, f_0=4e-10, f_1=5.5e-10)


@equation("soot-filter", cases=[
    dict(READING, dt=5e-14),
    dict(READING, dt=5e-9),
    dict(READING, dt=1.3e-7),
    dict(READING, dt=1.5e-8, g=0.0, g_dot=0.0, f_0=0.0),
    dict(omega_0=0.7, dt=2.5, g=1.5, g_dot=-0.3, f_0=0.25, f_1=-2.0),
])
def filter_step(omega_0, dt, g, g_dot, f_0, f_1):
    # in units of the time constant: g, its rate, the force and the slope of the force
    y = omega_0 * dt
    with mp.workdps(mp.dps + 20 + int(y)):
        motion = mp.matrix([[0, 1, 0, 0], [-1, -2, 1, 0], [0, 0, 0, 1], [0, 0, 0, 0]])
        now = mp.expm(motion * y, method="taylor") * mp.matrix([g, g_dot / omega_0, f_0, (f_1 - f_0) / y])
        return dict(g_next=now[0], g_dot_next=now[1] * omega_0)
