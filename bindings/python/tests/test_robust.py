"""Whatever is handed over, no panic reaches Python."""

import numpy as np
import pytest
import veridem

STRANGE = [
    *[np.nan, np.inf, -np.inf, 0, -1, -0.0, 1e300, 1e-300, 2**70, True, None, "x", "1 nm", b"abc", [], [[]], {}, set(), object()],
    *[np.empty((0, 3)), np.zeros((2, 2)), np.zeros(3), np.array(1.0), np.zeros((1,) * 32), np.zeros((3, 0)), np.float16(3)],
    *[np.array([1, 2, 3], dtype=object), np.array(["a"]), np.ones(3, dtype=complex), np.array([1, 2], dtype="M8[s]")],
    *[np.ones((3, 3), dtype=">f8"), np.ones((6, 6))[::2, ::2], np.asfortranarray(np.ones((4, 3))), np.broadcast_to(1.0, (5, 3))],
    *[np.ma.masked_array([1.0, 2, 3], [0, 1, 0]), np.array([(1, 2.0)], dtype=[("a", int), ("b", float)]), np.longdouble(1)],
]
LAW = veridem.Law("soot")
SPHERES = {"positions": [[0, 0, 0], [28, 0, 0]], "radii": 14.0, "masses": 20.0, "dt": 1e-6, "threads": 1}
PAIR = {"x": [28.0, 0, 0], "r_i": 14.0, "r_j": 14.0, "m_i": 20.0, "m_j": 20.0, "dt": 1e-6}
GROWN = {"spheres": 2, "radius": 1.0, "fractal_dimension": 1.8, "prefactor": 1.3}
CALLS = {
    "simulation": (lambda **given: veridem.Simulation(LAW, **given).step(1), SPHERES),
    "walls": (lambda **given: veridem.Simulation(LAW, **given), SPHERES),
    "pairs": (LAW.pairs, PAIR),
    "grown": (veridem.Aggregate.grow, GROWN),
    "aggregate": (lambda **given: veridem.Aggregate(**given).shape, {"positions": [[0.0, 0, 0], [2, 0, 0]], "radii": 1.0}),
    "necks": (lambda distance: veridem.Aggregate([[0.0, 0, 0], [2, 0, 0]], 1.0).necks(distance), {"distance": 0.1}),
    "read": (lambda **given: veridem.Aggregate.read("/none.xyz", **given), {}),
    "law": (veridem.Law, {"model": "titania"}),
}
KEYS = [
    *[("simulation", key) for key in [*SPHERES, "velocities", "spins", "necks", "box", "skin", "damping", "max_overlap", "integrator"]],
    *[("walls", key) for key in ["walls", "bodies", "surfaces"]],
    *[("pairs", key) for key in [*PAIR, "v", "omega_i", "omega_j", "springs"]],
    *[("grown", key) for key in [*GROWN, "deviation", "method", "seed"]],
    *[("aggregate", key) for key in ["positions", "radii"]],
    *[("necks", "distance"), ("read", "unit"), ("read", "radius"), ("read", "format"), ("law", "model"), ("law", "radii")],
]


def tried(call, *positional, **given):
    """Anything may be refused; a defect may not show."""
    try:
        call(*positional, **given)
    except veridem.BrokenInvariant:
        raise
    except Exception as refused:
        assert str(refused) or isinstance(refused, (RecursionError, OverflowError)), refused


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("what", "key"), KEYS, ids=str)
def test_strange_arguments_make_no_panic(what, key):
    call, good = CALLS[what]
    for strange in STRANGE:
        if key == "spheres" and isinstance(strange, int) and strange > 1000:
            continue
        tried(call, **{**good, key: strange})
    if key in ("walls", "bodies", "surfaces"):
        for strange in STRANGE:
            inner = {"walls": [veridem.Wall([0], velocity=strange)], "bodies": [[strange]], "surfaces": [veridem.Mesh(strange)]}
            tried(call, **{**good, key: inner[key]})


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("id", veridem.equations().index)
def test_strange_arguments_of_equations_make_no_panic(id):
    equation, rng = veridem.eq(id), np.random.default_rng(1)
    for _ in range(30):
        given = [STRANGE[rng.integers(len(STRANGE))] if rng.random() < 0.3 else rng.normal(size=row.size) for row in equation.arguments]
        tried(equation, *given, check=bool(rng.random() < 0.5))
