"""Simulations that are built from arrays and stepped from Python."""

import signal
import threading

import numpy as np
import pytest
import veridem

@pytest.fixture(scope="module")
def law(silica):
    return veridem.Law(silica)


@pytest.fixture
def collision(law):
    """Makes two spheres on their way to each other."""

    def make(**changes):
        settings = {"dt": 1e-5, "velocities": [[5, 0, 0], [-5, 0, 0]], "threads": 1, **changes}
        return veridem.Simulation(law, [[0, 0, 0], [7, 0, 0]], 3.0, 0.25, **settings)

    return make


@pytest.fixture
def block(law):
    """Makes spheres on a lattice, about to move."""

    def make(count=4, **changes):
        places = np.stack(np.meshgrid(*[np.arange(count)] * 3), axis=-1).reshape(-1, 3) * 6.0
        velocities = np.random.default_rng(1).normal(size=places.shape)
        return veridem.Simulation(law, places, 3.0, 0.25, dt=1e-5, velocities=velocities, **changes)

    return make


def test_spheres_move_freely_until_they_meet(collision):
    simulation = collision()
    simulation.step(100)
    assert simulation.steps == 100 and simulation.time == pytest.approx(1e-3) and len(simulation) == 2
    assert np.allclose(simulation.positions, [[0.005, 0, 0], [6.995, 0, 0]])
    assert np.allclose(simulation.velocities, [[5, 0, 0], [-5, 0, 0]]) and not simulation.spins.any()


def test_energy_is_balanced(collision, law):
    simulation = collision().step(20_000)
    energies = simulation.energies
    assert abs(energies["residual"]) < 1e-2 * energies["turnover"]
    assert simulation.pairs.ids.tolist() == [[0, 1]] and simulation.pairs.gap[0] < law.range(3, 3) - 6


def test_the_bits_do_not_depend_on_the_threads_nor_on_how_steps_are_called(block):
    one, two = block(threads=1).step(300), block(threads=2)
    for _ in range(100):
        two.step(3)
    assert one.positions.tobytes() == two.positions.tobytes()
    assert one.energies == two.energies and len(one.pairs.gap) > 100
    assert np.array_equal(one.pairs.force, two.pairs.force)


def test_observers_are_called_and_may_end_the_steps(collision):
    seen = []
    simulation = collision().step(1000, lambda now: seen.append(now.steps), every=300)
    assert seen == [300, 600, 900, 1000]
    simulation.step(1000, lambda now: now.steps >= 1100, every=50)
    assert simulation.steps == 1100


def test_an_observer_that_raises_leaves_a_simulation_that_goes_on(collision):
    simulation = collision()
    with pytest.raises(ZeroDivisionError):
        simulation.step(100, lambda now: 1 / 0, every=10)
    assert simulation.steps == 10 and simulation.step(5).steps == 15


def test_an_observer_may_take_steps(collision):
    simulation = collision().step(10, lambda now: now.step(1) and None, every=2)
    assert simulation.steps >= 10


def test_ctrl_c_ends_the_steps(block):
    simulation = block(6, threads=1)
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        simulation.step(10**12)
    taken = simulation.steps
    assert 0 < taken < 10**12 and simulation.step(1).steps == taken + 1


def test_threads_take_turns(block):
    simulation = block(threads=1)
    workers = [threading.Thread(target=simulation.step, args=(50,)) for _ in range(4)]
    [worker.start() for worker in workers]
    [worker.join() for worker in workers]
    # Each takes at least its steps from where it found the simulation.
    assert 50 <= simulation.steps <= 200


def test_what_leaves_its_domain_halts(collision):
    simulation = collision(velocities=[[3000, 0, 0], [-3000, 0, 0]], max_overlap=0.1)
    with pytest.raises(veridem.Halted, match="halted at") as told:
        simulation.step(100_000)
    assert told.value.step > 0 and told.value.time > 0
    with pytest.raises(veridem.Halted, match="time step"):
        collision(dt=1.0)


def test_necks_join_spheres():
    law = veridem.Law("soot")
    spheres = [[0, 0, 0], [28, 0, 0]]
    settings = {"dt": 1e-6, "velocities": [[-1, 0, 0], [1, 0, 0]], "threads": 1}
    joined = veridem.Simulation(law, spheres, 14.0, 20.0, necks=[(0, 1)], **settings).step(1000)
    loose = veridem.Simulation(law, spheres, 14.0, 20.0, **settings).step(1000)
    assert np.ptp(joined.positions[:, 0]) < np.ptp(loose.positions[:, 0])


def test_spheres_may_be_in_a_periodic_box(law):
    simulation = veridem.Simulation(
        law, [[0.5, 5, 5], [9.5, 5, 5]], 1.0, 0.01, dt=1e-6, box=(10, 10, 10), periodic=(True, False, False)
    )
    assert simulation.pairs.gap.tolist() == [pytest.approx(-1.0)]


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        ({"positions": np.empty((0, 3))}, ValueError, ""),
        ({"radii": [1.0, 2.0, 3.0]}, ValueError, "`radii` are of 3 spheres, `positions` of 2"),
        ({"radii": -1.0}, ValueError, "radius"),
        ({"masses": 0.0}, ValueError, "mass"),
        ({"positions": [[0, 0, 0], [0, 0, 0]]}, ValueError, ""),
        ({"positions": [[0, 0, np.nan], [7, 0, 0]]}, ValueError, ""),
        ({"velocities": [[0, 0, 0]] * 3}, ValueError, "`velocities` are of 3"),
        ({"positions": np.zeros((2, 2, 3))}, ValueError, "one row for each sphere"),
        ({"necks": [(0, 7)]}, ValueError, "no sphere 7"),
        ({"integrator": "euler"}, ValueError, "`integrator`"),
        ({"dt": -1.0}, veridem.Halted, ""),
        ({"dt": float("nan")}, veridem.Halted, ""),
        ({"skin": -1.0}, veridem.Halted, ""),
        ({"damping": 1.0, "integrator": "velocity-verlet"}, veridem.Halted, "`damping` is 1, expected 0 with velocity Verlet"),
        ({"damping": 1.0, "synchronous": True}, veridem.Halted, "`damping` is 1"),
        ({"box": (1e-5, 9, 9), "periodic": (True, False, False)}, veridem.Halted, "`periodic side` is 0.00001"),
        ({"box": (0, 9, 9)}, ValueError, "side 0 is 0"),
        ({"threads": 0}, ValueError, "`threads`"),
        ({"necks": [(0, -1)]}, OverflowError, ""),
    ],
    ids=str,
)
def test_wrong_arguments_are_told(law, wrong, error, message):
    given = {"positions": [[0, 0, 0], [7, 0, 0]], "radii": 3.0, "masses": 0.25, "dt": 1e-5, **wrong}
    with pytest.raises(error) as told:
        veridem.Simulation(law, **given)
    assert message in str(told.value)


def test_wrong_numbers_of_steps_are_told(collision):
    with pytest.raises(ValueError, match="found -1 steps"):
        collision().step(-1)
    with pytest.raises(ValueError, match="every 0"):
        collision().step(1, print, every=0)
