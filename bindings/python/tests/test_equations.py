"""Equations over numbers and arrays."""

import inspect
import pickle

import numpy as np
import pytest
import veridem
from veridem.wear import normal_force

GOOD = {"k_n": 10.0, "delta_e": 1.0, "delta_f": 3.0, "delta_n": 2.0}


def test_a_number_for_numbers_and_an_array_for_arrays():
    assert normal_force(**GOOD) == 5.0 and type(normal_force(**GOOD)) is float
    assert normal_force(10, 1, 3, np.float32(0.5)) == 5.0
    assert type(normal_force(10, 1, 3, np.array(2.0))) is float
    assert normal_force(10, 1, 3, [0.5, 2.0]).tolist() == [5.0, 5.0]


def test_ids_are_found_leniently_and_functions_have_their_names():
    assert veridem.eq("WEAR 03").id == "wear-3"
    assert veridem.eq("wear-3")(**GOOD) == 5.0
    with pytest.raises(KeyError, match="nearest is `wear-"):
        veridem.eq("wear-normal")


def test_documentation_comes_from_the_table():
    assert list(inspect.signature(normal_force).parameters) == ["k_n", "delta_e", "delta_f", "delta_n", "check"]
    for part in ["Eq. 3", "k_n : float or array [N/m], > 0", "Erratum", "begin{cases}"]:
        assert part in normal_force.__doc__
    assert pickle.loads(pickle.dumps(normal_force)) is normal_force
    assert pickle.loads(pickle.dumps(veridem.eq("wear-3"))).id == "wear-3"
    row = veridem.eq("wear-3").arguments[0]
    assert (row.name, row.unit, row.domain, row.size) == ("k_n", "N/m", "> 0", 1)


def test_the_table_lists_every_equation_once():
    table = veridem.equations()
    assert table.index.is_unique and table.loc["wear-3", "function"] == "normal_force"
    modules = {"wear": veridem.wear, "soot": veridem.soot, "titania": veridem.titania, "mechanics": veridem.mechanics}
    for id, row in table.iterrows():
        assert callable(getattr(modules[row.paper], row.function)), id


def test_one_function_stands_for_all_equations_of_its_name():
    """Equations that share a name in a paper are one function that carries several numbers."""
    seen = {}
    for id in veridem.equations().index:
        equation = veridem.eq(id)
        assert seen.setdefault((equation.paper, equation.function), equation.source) == equation.source


def samples(equation, count, rng):
    """Numbers within the domains of the arguments, most of them near one."""
    for quantity in equation.arguments:
        shape = (count, 3) if quantity.size == 3 else (count,)
        values = rng.uniform(0.1, 0.9, shape)
        if "unit" in quantity.domain:
            values /= np.linalg.norm(values, axis=-1, keepdims=True)
        yield values


def parts(result):
    return result if isinstance(result, tuple) else (result,)


@pytest.mark.parametrize("id", veridem.equations().index)
def test_arrays_have_the_bits_of_single_numbers(id):
    equation = veridem.eq(id)
    arguments = list(samples(equation, 37, np.random.default_rng(1)))
    together = parts(equation(*arguments, check=False))
    for at in range(37):
        alone = parts(equation(*[argument[at] for argument in arguments], check=False))
        for quantity, one, many in zip(equation.results, alone, together, strict=True):
            assert np.shape(one) == {1: (), 3: (3,), 9: (3, 3)}[quantity.size]
            assert np.asarray(one).tobytes() == np.ascontiguousarray(many[at]).tobytes()


def test_long_arrays_are_evaluated_in_full():
    delta_n = np.linspace(-1, 4, 100_003)
    long = normal_force(10, 1, 3, delta_n)
    assert long[::1000].tolist() == [normal_force(10, 1, 3, x) for x in delta_n[::1000]]
    assert long[-1] == normal_force(10, 1, 3, delta_n[-1])


def test_shapes_are_broadcast():
    forces = normal_force(np.ones((4, 1, 2)), 1, 3, np.linspace(0, 1, 6).reshape(3, 2))
    assert forces.shape == (4, 3, 2)
    assert np.array_equal(forces[1], forces[0])
    drift = veridem.mechanics.drift
    assert drift(np.zeros(3), np.ones((5, 3)), 0.5).shape == (5, 3)
    assert drift(np.zeros((2, 1, 3)), np.ones((5, 3)), np.ones((2, 5))).shape == (2, 5, 3)
    assert drift([0, 0, 0], [1, 2, 3], 1).tolist() == [1, 2, 3]
    with pytest.raises(ValueError, match=r"cannot be broadcast together: k_n \(2,\), delta_e \(3,\)"):
        normal_force([1, 2], [1, 2, 3], 2, 0)
    with pytest.raises(ValueError, match=r"`x` has the shape \(2,\), expected \(..., 3\)"):
        drift([0, 0], [1, 2, 3], 1)
    with pytest.raises(ValueError, match=r"`v` has the shape \(\)"):
        drift([0, 0, 0], 1.0, 1)


@pytest.mark.parametrize(
    "delta_n",
    [
        np.linspace(-1, 4, 24)[::2],
        np.linspace(-1, 4, 12)[::-1],
        np.asfortranarray(np.linspace(-1, 4, 12).reshape(3, 4)),
        np.linspace(-1, 4, 12, dtype=np.float32),
        np.linspace(-1, 4, 12).astype(">f8"),
        np.arange(-1, 4),
        np.array([True, False]),
        np.frombuffer(b"x" + np.linspace(-1, 4, 12).tobytes(), offset=1),
        np.array([]),
        np.empty((0, 3)),
        [[0.5], [2]],
        range(3),
    ],
    ids=str,
)
def test_any_array_of_real_numbers_will_do(delta_n):
    plain = np.array(delta_n, dtype=float)
    expected = np.array([normal_force(10, 1, 3, float(x)) for x in plain.ravel()]).reshape(plain.shape)
    assert np.array_equal(normal_force(10, 1, 3, delta_n), expected)


def test_masked_numbers_are_refused():
    masked = np.ma.masked_array([0.5, 2.0], [False, True])
    with pytest.raises(ValueError, match="`delta_n`: some of its numbers are masked"):
        normal_force(10, 1, 3, masked)
    assert normal_force(10, 1, 3, masked[:1]).tolist() == normal_force(10, 1, 3, np.ma.masked_array([0.5])).tolist() == [5.0]


def test_arguments_are_left_as_they_are():
    delta_n = np.linspace(-1, 4, 12)
    delta_n.flags.writeable = False
    forces = normal_force(10, 1, 3, delta_n)
    assert forces.flags.writeable and forces.flags.c_contiguous and not np.shares_memory(forces, delta_n)


def test_quantities_may_have_units():
    force = normal_force(k_n="58.6 N/m", delta_e="0.33 nm", delta_f="375 pm", delta_n="-0.1 nm")
    assert force == 58.6 * -0.1e-9
    with pytest.raises(ValueError, match="wrong dimension, expected one number in N/m"):
        normal_force(k_n="58.6 N", delta_e=1, delta_f=2, delta_n=0)


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        ({"k_n": -1}, ValueError, "`k_n` = -1 is outside its domain: > 0"),
        ({"k_n": [1, 2, -1]}, ValueError, r"`k_n\[2\]` = -1 is outside"),
        ({"delta_n": [[0, 1], [2, np.nan]]}, ValueError, r"`delta_n\[1, 1\]` = NaN is outside"),
        ({"delta_n": np.inf}, ValueError, "outside its domain"),
        ({"delta_m": 0}, TypeError, "no argument `delta_m`, the nearest is `delta_n`"),
        ({"deltaN": 0}, TypeError, "`delta_n` is given twice"),
        ({"delta_n": None}, TypeError, "`delta_n`: found <class 'NoneType'>, expected real numbers"),
        ({"delta_n": 1j}, TypeError, "expected real numbers"),
        ({"delta_n": ["1"]}, TypeError, "expected real numbers"),
        ({"delta_n": [[1], [1, 2]]}, ValueError, "inhomogeneous"),
        ({"delta_n": "x"}, ValueError, "`delta_n` = `x`"),
    ],
)
def test_wrong_arguments_are_told(wrong, error, message):
    with pytest.raises(error, match=message):
        normal_force(**{**GOOD, **wrong})


def test_missing_and_surplus_arguments_are_told():
    with pytest.raises(TypeError, match=r"`delta_n` is missing \(separation of the surfaces"):
        normal_force(1, 1, 2)
    with pytest.raises(TypeError, match="wear-3 has 4 arguments, found 5"):
        normal_force(1, 1, 2, 0, 0)


def test_results_that_are_not_finite_are_refused_unless_nothing_is_checked():
    with pytest.raises(ValueError, match=r"wear-3 has no finite value for the arguments at \[1\]"):
        normal_force(1e200, 1e200, 2e300, [0, 1e200])
    assert np.isinf(normal_force(1e200, 1e200, 2e300, [0, 1e200], check=False)[1])
    assert np.isnan(normal_force(10, 1, 3, np.nan, check=False)) or normal_force(10, 1, 3, np.nan, check=False) == 0


def test_several_results_have_names():
    table = veridem.equations()
    several = [id for id in table.index if "," in table.loc[id, "results"]]
    equation = veridem.eq(several[0])
    result = equation(*[argument[0] for argument in samples(equation, 1, np.random.default_rng(2))], check=False)
    assert result._fields == tuple(quantity.name for quantity in equation.results)
