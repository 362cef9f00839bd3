"""Mechanics: kicks, drifts, energies and work; the box; oscillations and stable steps."""

from frame import Vector, equation, mp

# A sphere of a few nanometres, a coarse grain, a wall: SI units.
MASSES = [1.1e-21, 5e-20, 2.3e-15, 8e-23]
INERTIAS = [7e-39, 2.6e-36, 9e-28, 7.2e-41]
VELOCITIES = [[0.5, -0.02, 1.3], [0.0, 0.0, -0.5], [12.0, 3.0, -7.0], [-1e-3, 2e-4, 5e-5]]
SPINS = [[1e8, -3e8, 2e7], [4e7, 0.0, -1e9], [-2e6, 5e6, 1e6], [1e3, 2e3, -4e3]]
FORCES = [[1e-9, -2.5e-9, 3e-10], [0.0, 4e-8, -1e-9], [-6e-6, 2e-7, 1e-5], [3e-13, 0.0, 0.0]]
TORQUES = [[1e-18, -2e-18, 5e-19], [0.0, 3e-17, -1e-17], [4e-13, 5e-14, -2e-13], [0.0, 1e-22, 2e-22]]
PLACES = [[4e-9, -1e-8, 2.2e-8], [0.0, 7e-9, 0.0], [-3e-6, 5e-7, 1e-6], [1.1e-8, 1.1e-8, -1.1e-8]]
STEPS = [5e-13, 1e-12, 2e-10, 4e-14]
FOUR = range(4)


def _energy(m, v):
    return m * sum(part * part for part in v) / 2


@equation("mechanics-kick", cases=[dict(v=VELOCITIES[k], force=FORCES[k], m=MASSES[k], dt=STEPS[k]) for k in FOUR])
def kick(v, force, m, dt):
    return dict(v_next=(v * m + force * dt) / m)


@equation("mechanics-drift", cases=[dict(x=PLACES[k], v=VELOCITIES[k], dt=STEPS[k]) for k in FOUR])
def drift(x, v, dt):
    return dict(x_next=Vector(*(mp.fdot([(1, a), (b, dt)]) for a, b in zip(x, v))))


@equation("mechanics-kinetic-energy", cases=[dict(m=MASSES[k], v=VELOCITIES[k], i=INERTIAS[k], omega=SPINS[k]) for k in FOUR])
def kinetic_energy(m, v, i, omega):
    return dict(energy=_energy(m, v) + _energy(i, omega))


@equation("mechanics-translational-energy", cases=[dict(m=MASSES[k], v=VELOCITIES[k]) for k in FOUR])
def translational_energy(m, v):
    return dict(energy=(m * v.norm()) ** 2 / (2 * m))


@equation("mechanics-axial-energy", cases=[dict(m=MASSES[k], v_a=v) for k, v in zip(FOUR, (0.5, -2.5, 40.0, 1e-4))])
def axial_energy(m, v_a):
    # The impulse that stops the mass, times the mean velocity.
    return dict(energy=mp.quad(lambda v: m * v, [0, v_a]))


@equation("mechanics-kick-excess", cases=[dict(force=FORCES[k], m=MASSES[k], dt=STEPS[k]) for k in FOUR])
def kick_excess(force, m, dt):
    # From the left side, at any velocity before.
    v = Vector(2, -1, 3) * (force.norm() * dt / m)
    return dict(excess=_energy(m, v + force * (dt / m)) - _energy(m, v) - force.dot(v) * dt)


@equation(
    "mechanics-work",
    cases=[dict(force=FORCES[k], v=VELOCITIES[k], torque=TORQUES[k], omega=SPINS[k], dt=STEPS[k]) for k in FOUR],
)
def work(force, v, torque, omega, dt):
    return dict(work=force.dot(v * dt) + torque.dot(omega * dt))


@equation(
    "mechanics-axial-work",
    cases=[dict(f_a=f, v_a=v, dt=dt) for f, v, dt in zip((1e-9, -4e-8, 1e-5, 3e-13), (0.5, -2.5, 40.0, 1e-4), STEPS)],
)
def axial_work(f_a, v_a, dt):
    return dict(work=f_a * (v_a * dt))


@equation("mechanics-drag-loss", cases=[dict(c=c, v=VELOCITIES[k], dt=STEPS[k]) for k, c in zip(FOUR, (1e-11, 3e-12, 2e-7, 1e-10))])
def drag_loss(c, v, dt):
    # The work of the force -c v, reversed.
    return dict(loss=-(v * -c).dot(v) * dt)


@equation("mechanics-path-work", cases=[dict(before=FORCES[k], after=FORCES[k - 1], path=PLACES[k]) for k in FOUR])
def path_work(before, after, path):
    # The force changes linearly along the path.
    return dict(work=mp.quad(lambda s: (before * (1 - s) + after * s).dot(path), [0, 1]))


@equation("mechanics-momentum-flux", cases=[dict(m=MASSES[k], v=VELOCITIES[k]) for k in FOUR])
def momentum_flux(m, v):
    return dict(flux=[m * part * part for part in v])


VIRIALS = [[1e-18, -3e-18, 2e-19], [5e-15, 0.0, -4e-15], [-2e-12, 1e-12, 3e-12], [7e-20, 7e-20, 6e-20]]
FLUXES = [[2e-21, 3e-21, 1e-21], [0.0, 0.0, 1e-16], [4e-13, 5e-13, 2e-13], [6e-20, 8e-20, 5e-20]]
FACTORS = [[1.00001, 0.99998, 1.0], [1.5, 1.0, 0.75], [0.9999999, 1.0000003, 1.0000001], [1.0, 1.0, 1.0001]]
VOLUMES = [1e-24, 3.3e-21, 2.7e-16, 5e-25]


@equation("mechanics-box-stress", cases=[dict(virial=VIRIALS[k], flux=FLUXES[k], volume=VOLUMES[k]) for k in FOUR])
def box_stress(virial, flux, volume):
    return dict(sigma=virial / volume - flux / volume)


@equation("mechanics-box-work", cases=[dict(virial=VIRIALS[k], factor=FACTORS[k]) for k in FOUR])
def box_work(virial, factor):
    return dict(work=virial.dot(factor) - sum(virial))


@equation(
    "mechanics-box-inertia", cases=[dict(mass=m, side=side) for m, side in [(2e-18, 1e-7), (4e-15, 2.5e-6), (1.1e-21, 8e-9), (3e-12, 1e-5)]]
)
def box_inertia(mass, side):
    # The slab in slices.
    return dict(inertia=mp.quad(lambda x: x * x * mass / side, [-side / 2, side / 2]))


@equation(
    "mechanics-box-strain-rate",
    cases=[
        dict(rate=rate, excess=excess, modulus=modulus, volume=VOLUMES[k], inertia=inertia, dt=dt)
        for k, (rate, excess, modulus, inertia, dt) in enumerate(
            [
                (1e5, 2e6, 1e9, 1.7e-33, 1e-12),
                (-3e4, -5e5, 3e10, 2e-27, 2e-11),
                (0.0, 1e5, 2e11, 3e-23, 1e-10),
                (2e6, 0.0, 0.0, 6e-39, 1e-13),
            ]
        )
    ],
)
def box_strain_rate(rate, excess, modulus, volume, inertia, dt):
    # J x'' + c x' + V E x = -V (sigma - sigma_0), with the c that makes the roots of the left side equal.
    stiffness = volume * modulus
    damping = mp.sqrt(4 * inertia * stiffness)
    return dict(rate_next=rate - dt * (volume * excess + damping * rate) / inertia)


@equation("mechanics-growth", cases=[dict(rate=rate, dt=dt) for rate, dt in zip((1e5, -3e7, 2.5e8, -7.0), STEPS)])
def growth(rate, dt):
    return dict(factor=mp.fdot([(rate, dt), (1, 1)]))


@equation(
    "mechanics-growing-rate",
    cases=[
        dict(rate=rate, owed=owed, dt=dt)
        for rate, owed, dt in (
            (1e5, 0.0, 1e-13),
            (-3e-4, -2e-4, 1e-13),
            (2e-3, -5e-3, 2e-13),
            (5e-3, 4e-3, 1e-13),
            (-0.4, 0.39, 1e-13),
            (7e-6, 3e-5, 2e-11),
        )
    ],
)
def growing_rate(rate, owed, dt):
    # A double between one half and one has 53 digits: eight of its last are 2^-50.
    due = mp.fdot([(rate, 1), (owed, 1)])
    moves = mp.fabs(due) * dt >= mp.ldexp(1, -50)
    return dict(growing=due if moves else mp.mpf(0), owed_next=mp.mpf(0) if moves else due)


@equation("mechanics-period", cases=[dict(m=m, k=k) for m, k in zip(MASSES, (58.6, 160.0, 4e4, 0.02))])
def period(m, k):
    # exp(i omega t) is back at one, with the root of m s^2 + k = 0.
    root = mp.sqrt(mp.mpc(-k / m))
    return dict(t=mp.re(2j * mp.pi / root))


@equation(
    "mechanics-speed-of-fall",
    cases=[dict(m=m, u_0=a, u=b) for m, a, b in zip(MASSES, (-1e-19, 2e-17, 0.0, 3e-20), (-7e-19, 1e-17, -4e-13, 3e-20))],
)
def speed_of_fall(m, u_0, u):
    return dict(v=mp.sqrt(2 / m) * mp.sqrt(u_0 - u))


@equation("mechanics-coordinated-step", cases=[dict(dt_c=dt, z=z) for dt, z in zip(STEPS, (1.0, 6.0, 12.0, 2.0))])
def coordinated_step(dt_c, z):
    # The frequency 2 / dt grows with the square root of z.
    return dict(dt_z=2 / mp.sqrt(z * (2 / dt_c) ** 2))


@equation("mechanics-thermal-energy", cases=[dict(k_b=1.380649e-23, t=t) for t in (300.0, 293.15, 77.0, 1800.0)])
def thermal_energy(k_b, t):
    return dict(kt=t * k_b)


@equation("mechanics-inertia-share", cases=[dict(i=i, n=n) for i, n in zip(INERTIAS, (0.0, 1.0, 3.0, 12.0))])
def inertia_share(i, n):
    return dict(share=i if n < 1 else i / n)


@equation(
    "mechanics-elongation", cases=[dict(delta=a, delta_0=b) for a, b in [(-1e-10, -3e-10), (2e-10, 0.0), (1e-10, 2.5e-10), (-3e-11, 1e-11)]]
)
def elongation(delta, delta_0):
    return dict(xi=-(delta_0 - delta))


@equation(
    "mechanics-contact-rest",
    cases=[dict(delta=a, delta_0=b) for a, b in [(-1e-10, -3e-10), (-1e-10, 2e-10), (1e-10, -3e-10), (0.0, -3e-10), (-4e-10, 0.0)]],
)
def contact_rest(delta, delta_0):
    return dict(delta_c=delta_0 if delta < 0 and delta_0 < 0 else 0)


@equation(
    "mechanics-carried-spring",
    cases=[
        dict(xi=[1e-11, -3e-12, 2e-12], n=[0.0, 0.0, 1.0], omega_i=SPINS[0], omega_j=SPINS[1], dt=2e-10),
        dict(xi=[2e-9, 1e-9, -5e-10], n=[0.6, 0.0, -0.8], omega_i=SPINS[1], omega_j=SPINS[2], dt=5e-9),
        dict(xi=[-4e-10, 0.0, 7e-10], n=[0.0, -1.0, 0.0], omega_i=SPINS[2], omega_j=SPINS[3], dt=1e-6),
        dict(xi=[5e-10, 6e-10, 0.0], n=[0.0, 0.8, 0.6], omega_i=SPINS[3], omega_j=[-part for part in SPINS[3]], dt=1e-3),
    ],
)
def carried_spring(xi, n, omega_i, omega_j, dt):
    # By Rodrigues' formula, about the normal by the angle of the midpoint rule.
    angle = 2 * mp.atan((omega_i + omega_j).dot(n) * dt / 4)
    b = n.cross(xi)
    return dict(carried=xi + b * mp.sin(angle) + n.cross(b) * (2 * mp.sin(angle / 2) ** 2))


@equation(
    "mechanics-weibull-quantile",
    cases=[dict(p=p, scale=scale, shape=shape) for p, scale, shape in ((0.5, 1.0, 3.0), (0.01, 2.5, 1.0), (0.99, 0.7, 12.0), (0.25, 4.0, 0.5))],
)
def weibull_quantile(p, scale, shape):
    # The logarithm of x over the scale at which the share of those that are stronger is p.
    def stronger(folds):
        return mp.e ** -(mp.e ** (shape * folds)) - p

    folds = mp.findroot(stronger, (-100 / shape, 5 / shape), solver="bisect", tol=mp.mpf(10) ** (-1.9 * mp.dps), maxsteps=600)
    return dict(x=scale * mp.e**folds)
