"""The trajectories of Pham-Ba & Molinari 2022: the symplectic Euler scheme, collisions, passages, quasi-static paths, the lattice."""

from frame import mp, mpf, trajectory
from motions import meant


@trajectory("euler.json")
def euler(run):
    # a kick and a drift as a matrix, and its powers
    h = run["h"]
    step = mp.matrix([[1 - h * h, h], [-h, 1]])
    begin = mp.matrix([mpf(3) / 5, mpf(4) / 5] if run["name"].endswith("pyth") else [1, 0])
    at = lambda n: step ** int(n) * begin
    return dict(samples=[(n, *at(n)) for n, _, _ in run["samples"]])


def linear(matrix, time, state):
    """A linear motion by the exponential of its matrix."""
    return mp.expm(mp.matrix(matrix) * time, method="taylor") * mp.matrix(state)


@trajectory("collisions.json")
def collisions(run):
    m_i, m_j, k, c, v0 = (run[name] for name in ("m_i", "m_j", "k_n", "c_n", "v0"))
    m = m_i * m_j / (m_i + m_j)
    moves = lambda t: linear([[0, 1], [-k / m, -c / m]], t, [0, -v0])
    guess = mp.pi * mp.sqrt(m / k)
    end = mp.findroot(lambda t: moves(t)[0] / guess, (guess * mpf("0.9"), guess * mpf("1.2")), solver="anderson")
    deepest = mp.findroot(lambda t: moves(t)[1], (guess * mpf("0.3"), guess * mpf("0.6")), solver="anderson")
    last, rows = len(run["samples"]) - 1, []
    for number in range(last + 1):
        time = end * number / last
        delta, rate = moves(time)
        rows.append((time, delta, rate, rate * m_j / (m_i + m_j), -rate * m_i / (m_i + m_j), -k * delta - c * rate))
    out = moves(end)[1]
    return dict(samples=rows, t_f=end, restitution=out / v0, max_overlap=-moves(deepest)[0], energy_lost=m / 2 * (v0**2 - out**2))


class Passage:
    """The legs of a passage: time, zone and state at their start. Zones: `elastic` below delta_e, `weakening` above it."""

    def __init__(self, run):
        get = lambda name: run[name]
        m, k, delta_e, delta_f, c = map(get, ("m_eff", "k_n", "delta_e", "delta_f", "c_n"))
        # state: separation, rate, one
        self.zones = dict(elastic=[[0, 1, 0], [-k / m, -c / m, 0], [0, 0, 0]])
        if delta_f > delta_e:
            softening = k * delta_e / (delta_f - delta_e) / m
            self.zones["weakening"] = [[0, 1, 0], [softening, -c / m, -softening * delta_f], [0, 0, 0]]
        self.top, self.corner, self.span = delta_f, delta_e, mp.pi * mp.sqrt(m / k)
        self.legs = [(mpf(0), "weakening" if delta_f > delta_e else "elastic", [delta_f, -run["v0"], mpf(1)])]
        self.end = None
        while self.end is None:
            self.leave()

    def leave(self):
        """Follows the last leg to the separation at which it leaves its zone."""
        begin, zone, state = self.legs[-1]
        other = "weakening" if zone == "elastic" else "elastic"
        inwards = zone == "weakening" and state[1] < 0
        # outwards from the elastic zone to the weakening one, if there is one
        ends = not inwards and (zone == "weakening" or other not in self.zones)
        level = self.top if ends else self.corner
        sign = -1 if inwards else 1
        beyond = lambda time: sign * (linear(self.zones[zone], time, state)[0] - level)
        # in short strides to the first place beyond, then to the root
        stride = self.span / 50
        late = stride
        while beyond(late) < 0:
            late += stride
        time = mp.findroot(beyond, (late - stride, late), solver="anderson")
        now = linear(self.zones[zone], time, state)
        if ends:
            self.end, self.speed = begin + time, now[1]
        else:
            self.legs.append((begin + time, other, list(now)))

    def at(self, time):
        begin, zone, state = [leg for leg in self.legs if leg[0] <= time][-1]
        return linear(self.zones[zone], time - begin, state)


@trajectory("passages.json", tolerance="1e-23")
def passages(run):
    passage = Passage(run)
    last = len(run["samples"]) - 1
    times = [passage.end * number / last for number in range(last + 1)]
    rows = [(time, *list(passage.at(time))[:2]) for time in times]
    return dict(samples=rows, exit_t=passage.end, exit_v=passage.speed)


@trajectory("quasistatic_loop.json")
def quasistatic_loop(run):
    k, delta_e, delta_f = (meant(run[name]) for name in ("k_n", "delta_e", "delta_f"))

    # the smaller of the two straight lines, and nothing below zero on the right
    def force(delta):
        return min(k * delta, max(mpf(0), k * delta_e * (delta_f - delta) / (delta_f - delta_e)))

    rows = [(hundredths, force(hundredths / 100)) for hundredths, _ in run["samples"]]
    corners = [rows[0][0] / 100, mpf(0), delta_e, delta_f, rows[-1][0] / 100]
    return dict(samples=rows, work_outward=mp.quad(force, corners, method="gauss-legendre"))


@trajectory("tangential_path.json", tolerance="2e-16")
def tangential_path(run):
    k, strength, delta_f = (meant(run[name]) for name in ("k_t", "f_mt", "delta_f"))
    rows, xi, before = [], mpf(0), mpf(0)
    for s, delta, *_ in ([meant(number) for number in row] for row in run["samples"]):
        cap = strength * min(max((delta_f - delta) / delta_f, mpf(0)), mpf(1))
        # the way, kept within the band that the cap allows
        xi = min(max(xi + s - before, -cap / k), cap / k)
        before = s
        rows.append((s, delta, xi, cap, k * xi))
    return dict(samples=rows)


def bonds(lattice):
    """Contacts of the spheres of a cell, of radius 1, as (sphere, partner, vector between the centres), each from both of its ends."""
    if lattice == "fcc":
        edge = mp.sqrt(2)
        return [(0, 0, b) for p in (edge, -edge) for q in (edge, -edge) for b in ((p, q, 0), (p, 0, q), (0, p, q))]
    # layers A and B: above and below each sphere the same triangle, in A pointing one way and in B the other
    ring = [(2 * mp.cos(k * mp.pi / 3), 2 * mp.sin(k * mp.pi / 3), 0) for k in range(6)]
    height, shift = mp.sqrt(mpf(8) / 3), 2 / mp.sqrt(3)
    found = [(layer, layer, b) for layer in (0, 1) for b in ring]
    for layer, side in ((0, shift), (1, -shift)):
        corners = [(-side * mp.sin(2 * k * mp.pi / 3), side * mp.cos(2 * k * mp.pi / 3)) for k in range(3)]
        found += [(layer, 1 - layer, (x, y, z)) for x, y in corners for z in (height, -height)]
    return found


def stiffness(b, k_n, k_t):
    """Force on a sphere per displacement of its partner."""
    n = mp.matrix([part / 2 for part in b])
    return k_t * mp.eye(3) + (k_n - k_t) * (n * n.T)


@trajectory("lattice.json", tolerance="3e-15")
def lattice(run):
    rows = [(nu, *moduli(run["lattice"], bool(run["relaxed"]), meant(nu))) for nu, *_ in run["samples"]]
    return dict(samples=rows)


def moduli(name, relaxed, nu):
    # Eqs. 7, 8, 15, 16 with E = 1, r = 1 and hence an effective radius of 1
    k_n = mp.sqrt(2) / (1 - 2 * nu) / 2
    k_t = k_n * (1 - 4 * nu) / (1 + nu)
    pairs = [(p, q, mp.matrix(b), stiffness(b, k_n, k_t)) for p, q, b in bonds(name)]
    volume = len({p for p, *_ in pairs}) * 4 * mp.sqrt(2)

    def energy(strain, shift):
        """Energy of a cell for a strain and a displacement of the second sphere against the first; turning spheres have no part in it."""
        total = mpf(0)
        for p, q, b, k in pairs:
            u = strain * b + (q - p) * shift
            total += (u.T * k * u)[0] / 4
        return total

    def stress(strain):
        shift = mp.matrix([0, 0, 0])
        if relaxed:
            between = sum((k for p, q, _, k in pairs if p == 0 and q == 1), mp.zeros(3))
            pull = sum((k * (strain * b) for p, q, b, k in pairs if p == 0 and q == 1), mp.zeros(3, 1))
            shift = -mp.lu_solve(between, pull)
        # the slope of a quadratic form along x, y, z
        out = []
        for axis in range(3):
            other = mp.zeros(3)
            other[axis, axis] = 1
            slope = energy(strain + other, shift) - energy(strain, shift) - energy(other, shift * 0)
            out.append(slope / volume)
        return out

    def along(axis):
        strain = mp.zeros(3)
        strain[axis, axis] = 1
        return stress(strain)

    y, z = along(1), along(2)
    return y[1], y[0], y[2], z[2]
