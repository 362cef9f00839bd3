"""The trajectories of Laube et al. 2018: two particles relax and meet under a constant attraction; the sawtooth of sliding."""

from extrapolation import DIGITS, after, crossing, once
from frame import mp, mpf, trajectory
from motions import meant


class Contact:
    """Two equal particles in units of their equilibrium: overlap, rate and time are near one."""

    def __init__(self, run):
        r, h, k, f, gamma, m = (run[name] for name in ("r_i", "h_n", "k_n", "f_a", "gamma_n", "m_eff"))
        # Eq. 8: (R + h)* of equal particles is R + h
        hertz = k * mp.sqrt((r + h) / 2)
        self.overlap = (f / hertz) ** (mpf(2) / 3)
        self.time = mp.sqrt(self.overlap * m / f)
        self.damping = gamma * self.time / m
        self.pull = f / m

    def rates(self, state):
        overlap, rate = state
        return [rate, 1 - overlap * mp.sqrt(overlap) - self.damping * rate]

    def si(self, state):
        return state[0] * self.overlap, state[1] * self.overlap / self.time


@trajectory("titania_relaxation.json", tolerance="1e-11")
def relaxation(run):
    with mp.workdps(DIGITS):
        contact = Contact(run)
        if run["name"] == "relaxation":
            return dict(samples=relaxed(contact, [row[0] for row in run["samples"]]))
        return dict(samples=met(contact, run))


def relaxed(contact, times):
    """From rest at seven tenths of the overlap in equilibrium."""
    state, before, rows = [mpf(7) / 10, mpf(0)], mpf(0), []
    for time in times:
        state, before = after(contact.rates, state, (time - before) / contact.time, mpf("0.25")), time
        rows.append((time, *contact.si(state)))
    return rows


def met(contact, run):
    """From a distance to first touch, and on to where they part: steps are short next to zero overlap, where the force has no derivatives."""
    gap = -run["samples"][0][1]
    touch = mp.sqrt(2 * gap / contact.pull)
    rate = contact.pull * touch * contact.time / contact.overlap
    time, state, path = mpf(0), [mpf(0), rate], []
    step = mpf("1e-10")
    while True:
        path.append((time, state))
        later = once(lambda s: contact.rates([abs(s[0]), s[1]]), state, step)[0]
        time, state = time + step, later
        left = -state[0] / state[1] if state[1] < 0 else mpf(1)
        if left < mpf("1e-10"):
            break
        step = min(time * mpf("0.15"), left * mpf("0.15"), mpf("0.25"))
    # to second order in what is left
    end = time + left
    path.append((end, [mpf(0), state[1] + left]))
    rows = [(0, -gap, 0), (touch, 0, contact.si([0, rate])[1])]
    count = len(run["samples"]) - 2
    for number in range(1, count + 1):
        at = end * number / count
        begin, state = [leg for leg in path if leg[0] <= at][-1]
        state = state if at == begin else once(contact.rates, state, at - begin)[0]
        rows.append((touch + at * contact.time, *contact.si(state)))
    return rows


@trajectory("titania_sawtooth.json", tolerance="2e-16")
def sawtooth(run):
    stress, area, tooth = (meant(run[name]) for name in ("tau_s_gpa", "a_nm2", "lambda_t_nm"))
    stiffness = stress * area / tooth
    rows, spring, before, slips = [], mpf(0), mpf(0), 0
    for s in (meant(row[0]) for row in run["samples"]):
        # whole teeth are taken from the spring
        spring += s - before
        before = s
        teeth = int(abs(spring) / tooth + mpf("1e-40"))
        slips += teeth
        spring -= mp.sign(spring) * teeth * tooth
        within = abs(s) - tooth * int(abs(s) / tooth + mpf("1e-40"))
        rows.append((s, spring, -stiffness * spring, -stiffness * within * (mp.sign(s) or 1)))
    return dict(samples=rows, slips=slips, lost_per_slip_nn_nm=stiffness * tooth**2 / 2)
