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


def test_a_loaded_wall_moves_with_its_load_and_a_driven_one_keeps_its_velocity(law):
    """Two layers that are far apart: nothing but the load acts."""
    places = [[x, y, z] for z in (0.0, 40.0) for x in (0.0, 6.0) for y in (0.0, 6.0)]
    walls = [veridem.Wall(range(4), velocity=(0, 3, 0)), veridem.Wall(range(4, 8), load=(None, None, 2.0))]
    simulation = veridem.Simulation(law, places, 3.0, 0.25, dt=1e-5, walls=walls, threads=1).step(1000)
    assert np.allclose(simulation.walls.displacement[0], [0, 0.03, 0]) and np.allclose(simulation.positions[:4, 1], [0.03, 6.03] * 2)
    # Force over mass, ag m/s per ns: half a step behind.
    assert simulation.walls.velocity[1].tolist() == pytest.approx([0, 0, 2.0 / 1.0 * 1e-2])
    assert simulation.energies["work"] == pytest.approx(0.5 * 1.0 * 0.02**2, rel=1e-2)


def test_spheres_between_walls_are_sheared(block):
    """The force on a wall that holds is that of the spheres on the wall that moves, once nothing moves in between."""
    upper = [k for k in range(64) if k % 4 == 3]
    lower = [k for k in range(64) if k % 4 == 0]
    walls = [veridem.Wall(lower), veridem.Wall(np.array(upper), velocity=(5, 0, 0))]
    simulation = block(walls=walls, damping=1e4, threads=1).step(2000)
    force = simulation.walls.force
    assert force[1, 0] < 0 < force[0, 0] and simulation.energies["work"] > 0
    energies = simulation.energies
    assert abs(energies["residual"]) < 1e-2 * energies["turnover"]


def test_a_sphere_falls_on_a_plane_and_on_triangles():
    law = veridem.Law("soot")
    corners = np.array([[-99, -99, 0], [99, -99, 0], [0, 99, 0]], dtype=float)
    ends = []
    for surface in (veridem.Plane((0, 0, 0), (0, 0, 2)), veridem.Mesh([corners], material="substrate")):
        settings = {"dt": 1e-5, "velocities": [0, 0, -5], "surfaces": [surface], "threads": 1}
        simulation = veridem.Simulation(law, [[0, 0, 15.0]], 14.0, 20.0, **settings)
        lowest = []
        simulation.step(60_000, lambda now: lowest.append(now.positions[0, 2]), every=100)
        assert 13.0 < min(lowest) < 14.0 and simulation.surfaces.displacement.tolist() == [[0, 0, 0]]
        energies = simulation.energies
        assert any(name.startswith("lost at surfaces") for name in energies)
        assert abs(energies["residual"]) < 1e-2 * energies["turnover"]
        ends.append(simulation.positions)
    assert np.allclose(*ends)


def test_a_surface_moves_as_its_reversal_says():
    law = veridem.Law("soot")
    plane = veridem.Plane((0, 0, 100), (0, 0, -1), material="tip", reversal=(1.5, 0.1, 10.8))
    simulation = veridem.Simulation(law, [[0, 0, 0]], 14.0, 20.0, dt=1e-5, surfaces=[plane], threads=1).step(100)
    expected = veridem.soot.tip_velocity(0.001, 1.5, 0.1, 10.8)
    assert simulation.surfaces.velocity[0, 2] == pytest.approx(expected, rel=1e-3)


def test_bodies_move_as_one(law):
    pair = [[0, 0, 0], [6, 0, 0], [20, 0, 0]]
    velocities = [[0, 2, 0], [0, 2, 0], [0, 0, 0]]
    simulation = veridem.Simulation(law, pair, 3.0, 0.25, dt=1e-5, velocities=velocities, bodies=[[0, 1]], threads=1).step(500)
    assert np.allclose(simulation.bodies.position, [[3, 0.01, 0]]) and np.allclose(simulation.bodies.velocity, [[0, 2, 0]])
    assert np.allclose(simulation.positions[:2], [[0, 0.01, 0], [6, 0.01, 0]])


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"walls": [veridem.Wall([0, 9])]}, "no sphere 9"),
        ({"walls": [veridem.Wall([])]}, "no spheres"),
        ({"walls": [veridem.Wall([0], velocity=(np.nan, 0, 0))]}, "finite"),
        ({"walls": [veridem.Wall([0], load=(None, np.inf, None))]}, "finite"),
        ({"walls": [veridem.Wall([0]), veridem.Wall([0])]}, "belongs to wall 0"),
        ({"bodies": [[0, 0]]}, "given twice"),
        ({"bodies": [[]]}, "no spheres"),
        ({"surfaces": [veridem.Plane((0, 0, 0), (0, 0, 0))]}, "normal is zero"),
        ({"surfaces": [veridem.Plane((0, 0, np.nan), (0, 0, 1))]}, "finite numbers"),
        ({"surfaces": [veridem.Plane((0, 0, -9), (0, 0, 1), reversal=(1, 0, 1))]}, "a rate above 0"),
        ({"surfaces": [veridem.Plane((0, 0, -9), (0, 0, 1), material="glass")]}, "'substrate' or 'tip'"),
        ({"surfaces": [veridem.Mesh(np.zeros((2, 3)))]}, "(number, 3, 3)"),
        ({"surfaces": [veridem.Mesh(np.zeros((1, 3, 3)))]}, "no triangle with an area"),
        ({"surfaces": [veridem.Mesh(np.empty((0, 3, 3)))]}, "no triangle"),
    ],
    ids=str,
)
def test_wrong_walls_bodies_and_surfaces_are_told(wrong, message):
    with pytest.raises(ValueError) as told:
        veridem.Simulation(veridem.Law("soot"), [[0, 0, 0], [40, 0, 0]], 14.0, 20.0, dt=1e-6, **wrong)
    assert message in str(told.value)


def test_laws_without_surfaces_and_integrators_without_walls_say_so(law, collision):
    with pytest.raises(ValueError, match="this law has no such surfaces"):
        collision(surfaces=[veridem.Plane((0, 0, -9), (0, 0, 1))])
    for held in ({"walls": [veridem.Wall([0])]}, {"bodies": [[0]]}):
        for start in ({"integrator": "velocity-verlet"}, {"synchronous": True}):
            with pytest.raises(ValueError, match="bodies and walls need"):
                collision(velocities=[0, 0, 0], **held, **start)
    with pytest.raises(TypeError, match="expected Plane or Mesh"):
        collision(surfaces=[((0, 0, 0), (0, 0, 1))])


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        ({"positions": np.empty((0, 3))}, ValueError, ""),
        ({"radii": [1.0, 2.0, 3.0]}, ValueError, "`radii` are of 3 spheres, `positions` of 2"),
        ({"radii": -1.0}, ValueError, "radius"),
        ({"masses": 0.0}, ValueError, "mass"),
        ({"positions": [[0, 0, 0], [0, 0, 0]]}, ValueError, ""),
        ({"positions": [[0, 0, np.nan], [7, 0, 0]]}, ValueError, ""),
        ({"positions": np.ma.masked_array([[0, 0, 0], [7.0, 0, 0]], [[0, 1, 0], [0, 0, 0]])}, ValueError, "masked"),
        ({"radii": np.array([3j, 3j])}, TypeError, "expected real numbers"),
        ({"radii": "3 nm"}, TypeError, "expected real numbers"),
        ({"masses": np.array([1, None])}, TypeError, "expected real numbers"),
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
        ({"necks": [(0, -1)]}, ValueError, "there is no sphere -1"),
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
