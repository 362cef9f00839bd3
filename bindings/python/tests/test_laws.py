"""Contact laws over arrays of pairs."""

import pickle

import numpy as np
import pytest
import veridem

MODELS = ["wear", "soot", {"soot": {"torsion": "as-published"}}, "titania"]
SIZES = {"r_i": 3.0, "r_j": 3.2, "m_i": 0.25, "m_j": 0.3, "dt": 1e-5}


@pytest.fixture(params=MODELS, ids=str)
def law(request, silica):
    return veridem.Law(silica if request.param == "wear" else request.param)


def pairs(count, rng, law):
    """Pairs near contact, moving and turning."""
    n = rng.normal(size=(count, 3))
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    return {
        "x": n * rng.uniform(6.1, 6.3, (count, 1)),
        "v": rng.normal(size=(count, 3)),
        "omega_i": rng.normal(size=(count, 3)),
        "omega_j": rng.normal(size=(count, 3)),
        "springs": 1e-3 * rng.normal(size=(count, len(law.springs))),
    }


def test_arrays_of_pairs_have_the_bits_of_single_pairs(law):
    arguments = pairs(1037, np.random.default_rng(1), law)
    together = law.pairs(**arguments, **SIZES)
    assert together.losses.shape == (1037, len(law.losses)) and together.stored.shape == (1037, len(law.stored))
    for at in range(0, 1037, 61):
        alone = law.pairs(**{name: argument[at] for name, argument in arguments.items()}, **SIZES)
        for one, many in zip(alone, together, strict=True):
            assert one.tobytes() == many[at].tobytes()


def test_constants_of_a_size_are_those_of_every_pair_of_that_size(law):
    arguments = pairs(40, np.random.default_rng(2), law)
    of_all = law.pairs(**arguments, **SIZES)
    each = {name: np.full(40, value) if name != "dt" else value for name, value in SIZES.items()}
    for one, many in zip(of_all, law.pairs(**arguments, **each), strict=True):
        assert np.array_equal(one, many)


def test_a_law_is_composed_of_its_equations(silica):
    """Eq. 3 along the line of centres of two resting spheres that are pulled apart."""
    law = veridem.Law(silica)
    gap = np.linspace(-0.2, 1.5, 50)
    x = np.outer(6.2 + gap, [1.0, 0.0, 0.0])
    force = law.pairs(x, **SIZES).force
    # Units of the engine are coherent, so that the equations serve as they are.
    names = ["k_n", "k_t", "delta_e", "delta_f", "f_mt", "c_n", "c_t"]
    material = [73e3, 0.17, 16e3, 11e3, 1500.0]
    given = veridem.wear.force_parameters(*material, 0.8, 0.5, 3.0, 3.2, 0.25, 0.3)
    constants = dict(zip(names, given, strict=True))
    expected = veridem.wear.normal_force(constants["k_n"], constants["delta_e"], constants["delta_f"], gap)
    assert np.allclose(force[:, 0], -expected, rtol=1e-9, atol=1e-6) and not force[:, 1:].any()
    assert law.range(3.0, 3.2) == pytest.approx(6.2 + constants["delta_f"])


def test_the_published_program_reads_the_law_otherwise(silica):
    """Its cap limits spring and dashpot together."""
    own, published = veridem.Law(silica), veridem.Law({"wear": {**silica["wear"], "readings": "as-published"}})
    moving = {"x": [6.0, 0, 0], "v": [0, 1e4, 0], **SIZES}
    assert np.abs(published.pairs(**moving).force[1]) < np.abs(own.pairs(**moving).force[1])


def test_action_is_reaction():
    law = veridem.Law("soot")
    arguments = pairs(100, np.random.default_rng(3), law)
    arguments.pop("springs")
    one = law.pairs(**arguments, **SIZES)
    swapped = {"x": -arguments["x"], "v": -arguments["v"], "omega_i": arguments["omega_j"], "omega_j": arguments["omega_i"]}
    other = law.pairs(**swapped, r_i=3.2, r_j=3.0, m_i=0.3, m_j=0.25, dt=1e-5)
    assert np.allclose(one.force, -other.force, rtol=1e-9, atol=1e-9)
    assert np.allclose(one.torque_i, other.torque_j, rtol=1e-9, atol=1e-9)


def test_necks_hold_pairs_that_are_joined():
    law = veridem.Law("soot")
    x = [[29.0, 0.0, 0.0]]
    sizes = {"r_i": 14.0, "r_j": 14.0, "m_i": 20.0, "m_j": 20.0, "dt": 1e-5}
    assert abs(law.pairs(x, joined=True, **sizes).force[0, 0]) > 10 * abs(law.pairs(x, **sizes).force[0, 0])


def test_attractions_are_tabulated_for_given_radii():
    radii = [2.0, 3.0]
    solved, tabulated = veridem.Law("titania"), veridem.Law("titania", radii=radii)
    x = np.outer(np.linspace(4.9, 6.5, 30), [0.0, 0.6, 0.8])
    sizes = {"r_i": 2.0, "r_j": 3.0, "m_i": 0.2, "m_j": 0.5, "dt": 1e-5}
    one, other = solved.pairs(x, **sizes).force, tabulated.pairs(x, **sizes).force
    assert np.abs(one - other)[10:].max() < 1.0


@pytest.mark.parametrize(
    ("model", "message"),
    [
        ("wear", "missing key `young_modulus`"),
        ({"soot": {"hamaker": "1 zJ"}}, "hamaker"),
        ("wood", "found `wood`, expected one of `wear`"),
        ({}, "found nothing"),
        ("- 1\n- 2\n", "found nothing"),
    ],
)
def test_wrong_models_are_told(model, message):
    with pytest.raises(veridem.InputError, match=message):
        veridem.Law(model)


@pytest.mark.parametrize(
    ("change", "key"),
    [({"young_modulus": "73 nm"}, "young_modulus"), ({"poisson_ratio": 0.4}, "poisson_ratio"), ({"youn": 1}, "youn")],
)
def test_wrong_values_are_told_by_key(silica, change, key):
    with pytest.raises(veridem.InputError, match=key) as told:
        veridem.Law({"wear": {**silica["wear"], **change}})
    assert told.value.file == "<model>" and told.value.line is not None and "model.wear" in told.value.key


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"r_i": 0.0}, "`r_i`: found 0, expected numbers above 0"),
        ({"m_j": [-1.0, 1.0]}, "`m_j`: found -1"),
        ({"x": [0.0, 0.0, np.nan]}, "`x`: found NaN"),
        ({"x": [0.0, 0.0, 0.0]}, "do two centres coincide"),
        ({"x": [1.0, 2.0]}, r"`x` has the shape \(2,\)"),
        ({"dt": 0.0}, "`dt` = 0"),
        ({"springs": [0.0]}, r"`springs` has the shape \(1,\), expected \(..., 3\)"),
    ],
)
def test_wrong_pairs_are_told(silica, wrong, message):
    with pytest.raises(ValueError, match=message):
        veridem.Law(silica).pairs(**{"x": [6.0, 0.0, 0.0], **SIZES, **wrong})


def test_laws_go_to_other_processes(silica):
    law = veridem.Law(silica)
    again = pickle.loads(pickle.dumps(law))
    assert np.array_equal(again.pairs([5.9, 0, 0], **SIZES).force, law.pairs([5.9, 0, 0], **SIZES).force)


def test_no_pairs_have_no_forces(silica):
    assert veridem.Law(silica).pairs(np.empty((0, 3)), **SIZES).force.shape == (0, 3)
