"""The trajectories of Demidov, Gor & Khalizov 2024: falls, triangles, the tip and its cantilever; springs are in `motions_springs`."""

from frame import mp, mpf, trajectory
from motions import meant

# SI units.
RADIUS, DENSITY = mpf("1.4e-8"), mpf(1700)


def mass(r, rho):
    return 4 * mp.pi * rho * r**3 / 3


def energy_of_spheres(r, delta, a):
    """Eq. 19."""
    inner, outer = (4 * r + delta) * delta, (2 * r + delta) ** 2
    return -a / 6 * (2 * r * r / inner + 2 * r * r / outer + mp.log(inner / outer))


def energy_of_plane(r, delta, a):
    """Eq. 21."""
    return -a / 6 * (r / delta + r / (2 * r + delta) + mp.log(delta / (2 * r + delta)))


def fall(energy, inertia, start, gaps):
    """Times and speeds at some gaps, after a release from rest at another: `inertia / 2` times the square of the speed is the energy set free.

    The time is integrated over the root of the way, so that nothing is infinite at the start.
    """
    speed = lambda gap: mp.sqrt(2 * (energy(start) - energy(gap)) / inertia)
    slowness = lambda s: 2 * s / speed(start - s * s)
    rows, time, before = [], mpf(0), mpf(0)
    for gap in gaps:
        root = mp.sqrt(start - gap)
        time += mp.quad(slowness, [before, root], method="gauss-legendre")
        before = root
        rows.append((gap, time, speed(gap)))
    return rows


@trajectory("soot_falls.json", tolerance="1e-20")
def falls(run):
    r, a, start = run["r"], run["a"], run["delta_start"]
    plane = run["partner"] == "plane"
    energy = energy_of_plane if plane else energy_of_spheres
    inertia = mass(r, run["rho"]) * (1 if plane else mpf(1) / 2)
    rows = fall(lambda gap: energy(r, gap, a), inertia, start, [row[0] for row in run["samples"]])
    return dict(samples=rows, total_time=rows[-1][1], final_speed=rows[-1][2])


def oscillation(stiffness, damping, inertia, speed, time):
    """Elongation and rate of a damped oscillator that starts at rest length: the exponential of its matrix."""
    motion = mp.matrix([[0, 1], [-stiffness / inertia, -damping / inertia]]) * time
    later = mp.expm(motion, method="taylor") * mp.matrix([0, speed])
    return later[0], later[1]


@trajectory("soot_triangles.json", tolerance="1e-20")
def triangles(run):
    # each sphere is pulled along its axis by two pairs, so that a pair moves with a third of the mass
    inertia = mass(RADIUS, DENSITY) / 3
    if "a" in run:
        rows = fall(lambda gap: energy_of_spheres(RADIUS, gap, run["a"]), inertia, run["delta_start"], [row[1] for row in run["samples"]])
        return dict(samples=[(time, gap, -speed) for gap, time, speed in rows])
    k, eta = run["k_n"], run["eta_n"]
    moves = lambda time: oscillation(k, eta, inertia, -run["speed"], time)
    zeta = eta / 2 / mp.sqrt(k * inertia)
    period = 2 * mp.pi / mp.sqrt(k / inertia * (1 - zeta * zeta))
    count = len(run["samples"])
    # a collision lasts until its force, k delta + eta rate, is zero; necks are followed for three periods
    lasts = 3 * period
    if run["name"].startswith("collision"):
        force = lambda time: mp.fdot([k, eta], moves(time)) / (k * run["speed"] * period)
        lasts = mp.findroot(force, (period * mpf("0.3"), period / 2), solver="anderson")
    times = [lasts * (number + 1) / count for number in range(count)]
    return dict(samples=[(time, *moves(time)) for time in times])


@trajectory("soot_filter.json", tolerance="1e-22")
def filtered(run):
    omega, period, peak = run["omega_0"], meant(run["period"]), meant(run["peak"])
    rise = peak / period
    # reading, its rate, the force, its slope
    motion = mp.matrix([[0, 1, 0, 0], [-(omega**2), -2 * omega, omega**2, 0], [0, 0, 0, 1], [0, 0, 0, 0]])
    per_tooth = 10
    step = period / per_tooth
    state, rows = mp.matrix([0, 0, 0, rise]), [(0, 0, 0)]
    advance = mp.expm(motion * step, method="taylor")
    for number in range(1, len(run["samples"])):
        state = advance * state
        if number % per_tooth == 0:
            state[2] = mpf(0)
        rows.append((step * number, state[2], state[0]))
    return dict(samples=rows)


@trajectory("soot_tip.json", tolerance="1e-32")
def tip(run):
    speed, rate, turn = mpf("1.5"), mpf("1e8"), mpf("1.08e-8")
    velocity = lambda t: speed * mp.tanh(rate * (t - turn))
    way = lambda t: mp.quad(velocity, mp.linspace(0, t, int(mp.ceil(rate * t)) + 1)) if t > 0 else mpf(0)
    return dict(samples=[(t, velocity(t), way(t)) for t, _, _ in run["samples"]])
