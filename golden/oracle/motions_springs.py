"""The trajectories of two solid spheres of unit mass and radius with the four springs of Demidov, Gor & Khalizov 2024.

Time is continuous: a spring that holds grows with its rate and turns with the normal; one that slips has the direction of its
friction instead, and the length that belongs to it. Where one begins to slip, and where contact ends, is solved for.
"""

from extrapolation import DIGITS, after, crossing, once
from frame import Vector, mp, mpf, trajectory
from motions import meant

INERTIA = mpf(2) / 5
RADIUS = 1
# Of the state: two places, two velocities, two spins, then two springs, or the directions of their friction, and the torsion.
VECTORS, TORSION = ("x_i", "v_i", "omega_i", "x_j", "v_j", "omega_j", "t", "r"), 24


class Pair:
    """A pair and the springs of a run. `friction` is None for a neck; `slipping` is the set of the springs that slip."""

    def __init__(self, run, necked=False):
        get = lambda name: meant(run.get(name, 0))
        self.k = {kind: get(f"k_{kind}") for kind in "ntro"}
        self.eta = {kind: get(f"eta_{kind}") for kind in "ntro"}
        self.mu = None if necked else {kind: get(f"mu_{kind}") for kind in "tro"}
        self.slipping = set()

    def at(self, state):
        """What the kinematics and the springs are in a state."""
        now = {name: Vector(*state[3 * k : 3 * k + 3]) for k, name in enumerate(VECTORS)}
        apart, v = now["x_j"] - now["x_i"], now["v_j"] - now["v_i"]
        now["d"] = d = apart.norm()
        now["n"] = n = apart / d
        now["d_dot"] = d_dot = v.dot(n)
        now["n_dot"] = (v - n * d_dot) / d
        a, spin = d / 2, now["omega_j"] - now["omega_i"]
        now["f_n"] = -(self.k["n"] * (d - 2 * RADIUS) + self.eta["n"] * d_dot)
        rates = dict(t=v - n * d_dot - (now["omega_i"] + now["omega_j"]).cross(n) * a, r=spin.cross(n) * a, o=spin.dot(n) * RADIUS)
        now["o"] = state[TORSION]
        now["rates"], now["xi"], now["force"] = rates, {}, {}
        for kind in "tro":
            k, eta, rate = self.k[kind], self.eta[kind], rates[kind]
            if kind in self.slipping:
                now["force"][kind] = now[kind] * (self.mu[kind] * now["f_n"])
                now["xi"][kind] = (now["force"][kind] - rate * eta) / k
            else:
                now["force"][kind], now["xi"][kind] = now[kind] * k + rate * eta, now[kind]
        return now

    def rates(self, state):
        now = self.at(state)
        n, d = now["n"], now["d"]
        f_t, f_r, f_o = (now["force"][kind] for kind in "tro")
        pull = f_t - n * now["f_n"]
        couple, sliding = n.cross(f_r) * (d / 2) + n * (f_o * RADIUS), n.cross(f_t) * (d / 2)
        out = [now["v_i"], pull, (sliding + couple) / INERTIA, now["v_j"], -pull, (sliding - couple) / INERTIA]
        for kind in "tr":
            change = now["rates"][kind]
            if kind in self.slipping:
                limit = self.mu[kind] * now["f_n"]
                # what is across the friction turns it: nothing, where all happens in one plane
                across = n.cross(now[kind])
                change = across * (change.dot(across) * self.k[kind] / limit if limit > 0 else 0)
            out.append(change - n * now["n_dot"].dot(now[kind]))
        return [part for vector in out for part in vector] + [mpf(0) if "o" in self.slipping else now["rates"]["o"]]

    def excess(self, kind):
        """How far a spring is below its limit, as a function of the state."""

        def room(state):
            now = self.at(state)
            force = now["force"][kind]
            size = abs(force) if kind == "o" else force.norm()
            return self.mu[kind] * now["f_n"] - size

        return room

    def slip(self, kind, state):
        """The state in which a spring begins to slip: along its force or, where it has none yet, its rate."""
        now = self.at(state)
        self.slipping.add(kind)
        if kind == "o":
            return [*state[:TORSION], mp.sign(now["force"][kind] or now["rates"][kind])]
        along = next(vector for vector in (now["force"][kind], now["rates"][kind]) if vector.norm() > 0)
        start = 3 * VECTORS.index(kind)
        return [*state[:start], *(along / along.norm()), *state[start + 3 :]]


def start(x_j, v_i, v_j, omega_i, omega_j):
    zero = [mpf(0)] * 3
    return [*zero, *v_i, *omega_i, *x_j, *v_j, *omega_j, *zero, *zero, mpf(0)]


class Contact:
    """A contact with friction from first touch on: its legs, each with the springs that slip, the time and the state at its start."""

    def __init__(self, pair, state, longest):
        self.pair, self.longest, self.legs, self.end = pair, longest, [], None
        time, state = mpf(0), self.slip_at_once(state)
        while self.end is None:
            time, state = self.next_leg(time, state)

    def slip_at_once(self, state):
        """The state at first touch, with the springs slipping that are over their limit as soon as there is one."""
        soon = once(self.pair.rates, state, self.longest / 1000)[0]
        over = [kind for kind in "tro" if self.pair.k[kind] > 0 and self.pair.excess(kind)(soon) < 0]
        for kind in over:
            state = self.pair.slip(kind, state)
        return state

    def next_leg(self, time, state):
        pair = self.pair
        self.legs.append((time, set(pair.slipping), state))
        events = {kind: pair.excess(kind) for kind in "tro" if kind not in pair.slipping and pair.k[kind] > 0}
        events["end"] = lambda now: pair.at(now)["f_n"]
        while True:
            # near the end the friction of a slipping spring turns the faster the weaker it is
            now = pair.at(state)
            left = now["f_n"] / max(now["d_dot"] * pair.k["n"], mpf("1e-30")) if now["d_dot"] > 0 else mpf(1)
            span = min(self.longest, left / 2) if pair.slipping and left < mpf("1e-2") else self.longest
            if left < mpf("1e-11"):
                span = 2 * left
            later, _ = once(pair.rates, state, span)
            passed = {name: crossing(pair.rates, state, span, event) for name, event in events.items() if event(later) < 0}
            if passed:
                # a spring without force reaches its limit where that is zero
                name = min(passed, key=passed.get)
                if "end" in passed and passed["end"] - passed[name] < mpf("1e-15"):
                    name = "end"
                time, state = time + passed[name], once(pair.rates, state, passed[name])[0]
                if name == "end":
                    self.end, self.last = time, (set(pair.slipping), state)
                    return time, state
                return time, pair.slip(name, state)
            time, state = time + span, later
            self.legs.append((time, set(pair.slipping), state))

    def at(self, time):
        """What the contact is at a time."""
        if time >= self.end:
            self.pair.slipping, state = self.last
            return self.pair.at(state)
        begin, slipping, state = [leg for leg in self.legs if leg[0] <= time][-1]
        self.pair.slipping = slipping
        return self.pair.at(after(self.pair.rates, state, time - begin, self.longest))


def planar(x, y):
    return Vector(x, y, 0)


def spin(omega):
    return Vector(0, 0, omega)


@trajectory("soot_necks.json", tolerance="1e-15")
def necks(run):
    with mp.workdps(DIGITS):
        pair, rows = Pair(run, necked=True), []
        state, time = start(planar(2, 0), planar(0, 0), planar(0, meant(run["kick"])), spin(0), spin(0)), mpf(0)
        for number in range(len(run["samples"])):
            state, time = after(pair.rates, state, 4 * number - time, mpf(1)), mpf(4 * number)
            now = pair.at(state)
            k, side = pair.k, planar(-now["n"][1], now["n"][0])
            xi_t, xi_r = now["xi"]["t"].dot(side), now["xi"]["r"].dot(side)
            # in the frame of the centre of mass
            v = (now["v_j"] - now["v_i"]) / 2
            kinetic = v.dot(v) + INERTIA / 2 * (now["omega_i"][2] ** 2 + now["omega_j"][2] ** 2)
            stored = (k["n"] * (now["d"] - 2) ** 2 + k["t"] * xi_t**2 + k["r"] * xi_r**2) / 2
            places = now["x_i"][0], now["x_i"][1], now["x_j"][0], now["x_j"][1]
            rows.append((time, *places, now["omega_i"][2], now["omega_j"][2], xi_t, xi_r, kinetic + stored))
        return dict(samples=rows)


@trajectory("soot_planar.json", tolerance="3e-14")
def meeting_in_the_plane(run):
    with mp.workdps(DIGITS):
        spins = [spin(meant(run[name])) for name in ("omega_i", "omega_j")]
        contact = Contact(Pair(run), start(planar(2, 0), *(planar(*map(meant, run[name])) for name in ("v_i", "v_j")), *spins), mpf("0.25"))
        rows, last = [], len(run["samples"]) - 1
        for number in range(last + 1):
            time = contact.end * number / last
            now = contact.at(time)
            side = planar(-now["n"][1], now["n"][0])
            springs = (now["xi"][kind].dot(side) for kind in "tr")
            rows.append((time, now["d"], now["d_dot"], now["omega_i"][2], now["omega_j"][2], *springs))
        bodies = [(*list(now["v_" + body])[:2], now["omega_" + body][2]) for body in "ij"]
        return dict(samples=rows, contact_time=contact.end, final=[part for body in bodies for part in body])


@trajectory("soot_oblique.json", tolerance="3e-15")
def meeting_obliquely(run):
    with mp.workdps(DIGITS):
        _, x_i, v_i, omega_i, x_j, v_j, omega_j = (lambda row: [row[0], *(Vector(*map(meant, row[1 + 3 * k : 4 + 3 * k])) for k in range(6))])(run["samples"][0])
        contact = Contact(Pair(run), start(x_j, v_i, v_j, omega_i, omega_j), mpf("0.25"))
        rows, last = [], len(run["samples"]) - 1
        for number in range(last + 1):
            time = contact.end * number / last
            now = contact.at(time)
            bodies = [part for name in VECTORS[:6] for part in now[name]]
            rows.append((time, *bodies, *now["xi"]["t"], *now["xi"]["r"], now["xi"]["o"]))
        return dict(samples=rows, contact_time=contact.end, final=bodies)
