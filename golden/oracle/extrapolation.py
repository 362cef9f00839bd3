"""Integration of ordinary differential equations by extrapolation of the midpoint rule (Gragg, Bulirsch and Stoer), of order 24."""

from frame import Wrong, mp, mpf

ROWS = 12
# Digits of the numbers while integrating, and the error of a step relative to the largest number of the state.
DIGITS, ERROR = 30, mpf("1e-20")


def moved(state, rates, time):
    return [y + time * rate for y, rate in zip(state, rates)]


def midpoint(rates, state, time, steps):
    """A time in an even number of steps of the midpoint rule."""
    step = time / steps
    before, now = state, moved(state, rates(state), step)
    for _ in range(steps - 1):
        before, now = now, moved(before, rates(now), 2 * step)
    return now


def once(rates, state, time):
    """The state a time later, and its error."""
    row = []
    for k in range(1, ROWS + 1):
        below, row = row, [midpoint(rates, state, time, 2 * k)]
        for j, coarser in enumerate(below, 1):
            ratio = mpf(k) ** 2 / mpf(k - j) ** 2 - 1
            row.append([fine + (fine - other) / ratio for fine, other in zip(row[-1], coarser)])
    size = max(abs(y) for y in row[-1])
    return row[-1], max(abs(a - b) for a, b in zip(row[-1], row[-2])) / size


def after(rates, state, time, longest):
    """The state a time later, in steps of `longest` at most; a step that is not accurate is halved."""
    left = time
    while left != 0:
        step = left if abs(left) <= longest else longest * mp.sign(left)
        later, error = once(rates, state, step)
        while error > ERROR:
            step /= 2
            if abs(step) < longest / 1e6:
                raise Wrong(f"no step is short enough {time - left} after the start")
            later, error = once(rates, state, step)
        state, left = later, left - step
    return state


def crossing(rates, state, span, event):
    """The time within `span` at which an event changes its sign."""
    at = lambda time: event(once(rates, state, time)[0])
    return mp.findroot(at, (mpf(0), span), solver="anderson", tol=mpf(10) ** -2 * ERROR**2, verify=False)
