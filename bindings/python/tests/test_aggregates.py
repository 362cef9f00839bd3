"""Aggregates are grown, imported and measured."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import veridem


@pytest.fixture(scope="module")
def grown():
    return veridem.Aggregate.grow(60, radius=14.0, fractal_dimension=1.8, prefactor=1.3, seed=3)


def test_a_grown_aggregate_touches_and_meets_its_law(grown):
    assert len(grown) == 60 and grown.positions.shape == (60, 3) and (grown.radii == 14.0).all()
    assert len(grown.necks()) == 59
    i, j = grown.necks().T
    assert np.allclose(np.linalg.norm(grown.positions[i] - grown.positions[j], axis=1), 28.0)
    radius = grown.shape["radius of gyration"].value
    assert 1.3 * (radius / 14.0) ** 1.8 == pytest.approx(60, rel=2e-3)


def test_the_same_seed_gives_the_same_bits(grown):
    law = {"radius": 14.0, "fractal_dimension": 1.8, "prefactor": 1.3}
    assert np.array_equal(veridem.Aggregate.grow(60, **law, seed=3).positions, grown.positions)
    assert not np.array_equal(veridem.Aggregate.grow(60, **law, seed=4).positions, grown.positions)


def test_shape_has_units_and_errors(grown):
    shape = grown.shape
    assert shape["hydrodynamic radius"].unit == "nm" and shape["hydrodynamic radius"].error > 0
    assert float(shape["coordination number"]) > 1.9
    pair = veridem.Aggregate([[0, 0, 0], [28, 0, 0]], 14.0).shape
    assert pair["fractal dimension"].value is None and pair["fractal dimension"].reason == "too few spheres"


def test_an_aggregate_is_written_and_read(grown, tmp_path):
    grown.write(tmp_path / "aggregate.xyz")
    again = veridem.Aggregate.read(tmp_path / "aggregate.xyz", unit=1.0)
    assert np.array_equal(again.positions, grown.positions) and np.array_equal(again.radii, grown.radii)


def test_an_aggregate_can_be_simulated(grown):
    law = veridem.Law("soot")
    simulation = veridem.Simulation(law, grown.positions, grown.radii, 20.0, dt=1e-6, necks=grown.necks(), threads=1)
    assert simulation.step(100).pairs.ids.shape[1] == 2


@pytest.mark.skipif(os.name == "nt", reason="signals")
@pytest.mark.parametrize(
    "work",
    [
        "veridem.Aggregate.grow(2_000_000, radius=14.0, fractal_dimension=1.8, prefactor=1.3)",
        "veridem.Aggregate.grow(30_000, radius=14.0, fractal_dimension=2.6, prefactor=1.3, method='spheres')",
        "veridem.Aggregate(np.random.default_rng(1).uniform(0, 3e4, (300_000, 3)), 14.0).shape",
        "veridem.Aggregate.read(sys.argv[1], unit=1.0, radius=14.0)",
    ],
)
def test_ctrl_c_ends_what_takes_long(work, tmp_path):
    file = tmp_path / "many.csv"
    if "read" in work:
        places = np.random.default_rng(1).uniform(0, 3e3, (2_000_000, 3))
        np.savetxt(file, places, "%.1f", ",", header="x,y,z", comments="")
    program = f"import sys, numpy as np, veridem\nprint('begun', flush=True)\n{work}\nprint('done')"
    child = subprocess.Popen([sys.executable, "-c", program, file], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    child.stdout.readline()
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    rest, errors = child.communicate(timeout=60)
    assert "KeyboardInterrupt" in errors and "done" not in rest and "defect" not in errors


def test_aggregates_are_of_real_numbers_that_are_there():
    with pytest.raises(ValueError, match="masked"):
        veridem.Aggregate(np.ma.masked_array([[0, 0, 0.0]], [[0, 0, 1]]), 1.0)
    with pytest.raises(TypeError, match="expected real numbers"):
        veridem.Aggregate([[0, 0, 1j]], 1.0)
    with pytest.raises(ValueError, match="one row for each sphere"):
        veridem.Aggregate([0, 0, 1], 1.0)


def test_wrong_files_and_recipes_are_told(tmp_path):
    with pytest.raises(FileNotFoundError):
        veridem.Aggregate.read(tmp_path / "missing.xyz")
    file = tmp_path / "wrong.xyz"
    file.write_text("2\n\nX 0 0 0 1\nX 2 0 zero 1\n")
    with pytest.raises(veridem.InputError, match="found `zero`") as told:
        veridem.Aggregate.read(file, unit=1.0)
    assert told.value.line == 4
    with pytest.raises(ValueError, match="parts that do not touch"):
        file.write_text("2\n\nX 0 0 0 1\nX 9 0 0 1\n")
        veridem.Aggregate.read(file, unit=1.0)
    with pytest.raises(ValueError, match="expected at least one sphere"):
        veridem.Aggregate.grow(0, radius=14.0, fractal_dimension=1.8, prefactor=1.3)
    with pytest.raises(ValueError, match="`method`"):
        veridem.Aggregate.grow(5, radius=14.0, fractal_dimension=1.8, prefactor=1.3, method="slowly")
    with pytest.raises(ValueError, match="`format`"):
        veridem.Aggregate.read(file, format="doc")
    with pytest.raises(ValueError, match="`distance` = 0"):
        veridem.Aggregate([[0, 0, 0]], 1.0).necks(0.0)
    with pytest.raises(ValueError, match="expected at least one sphere, positions"):
        veridem.Aggregate([[0, 0, np.inf]], 1.0).shape
