"""Simulations built from arrays, and stepped from Python."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from . import _veridem
from ._laws import Law

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Contacts(NamedTuple):
    """The pairs of a simulation that act, in the order of their ids."""

    ids: NDArray[np.int64]
    """The two spheres, the lower id first."""
    gap: NDArray[np.float64]
    """Distance of the surfaces, nm, negative for an overlap."""
    force: NDArray[np.float64]
    """Force on the first sphere in the next step, pN."""
    stored: NDArray[np.float64]
    """Stored energy, zJ, by `law.stored`."""


class Wall(NamedTuple):
    """Spheres that move as one and do not turn."""

    spheres: Iterable[int]
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Velocity, m/s, whatever acts on it: along the axes without a load."""
    load: tuple[float | None, float | None, float | None] = (None, None, None)
    """Force that drives it along an axis, pN, or None: the wall moves there as one body of the mass of its spheres, from rest."""


class Plane(NamedTuple):
    """The half-space behind a plane, as a surface that acts on spheres. Only the law of soot knows surfaces."""

    point: tuple[float, float, float]
    """A point of the plane, nm."""
    normal: tuple[float, float, float]
    """To the side of the spheres, of any length."""
    material: Literal["substrate", "tip"] = "substrate"
    """Which parameters of the model it has."""
    reversal: tuple[float, float, float] | None = None
    """Motion along z (Eq. 25): final velocity (m/s), rate (1/ns) and time (ns) of the reversal; by default it stands still."""


class Mesh(NamedTuple):
    """Triangles as a surface that acts on spheres; a closed one bounds a body."""

    triangles: ArrayLike
    """Corners, nm, of the shape (number, 3, 3): each triangle counterclockwise as seen from outside."""
    material: Literal["substrate", "tip"] = "tip"
    """Which parameters of the model it has."""
    reversal: tuple[float, float, float] | None = None
    """Motion along z, as of a plane."""


class Walls(NamedTuple):
    """The walls of a simulation, in their order."""

    velocity: NDArray[np.float64]
    """Velocity, m/s."""
    displacement: NDArray[np.float64]
    """Displacement since the beginning, nm."""
    force: NDArray[np.float64]
    """Force of the other spheres in the last step, pN."""
    torque: NDArray[np.float64]
    """Sum of the torques on its spheres, pN nm."""


class Surfaces(NamedTuple):
    """The surfaces of a simulation, in their order."""

    velocity: NDArray[np.float64]
    """Velocity, m/s."""
    displacement: NDArray[np.float64]
    """Displacement since the beginning, nm."""
    force: NDArray[np.float64]
    """Force of the spheres in the last step, pN."""


class Bodies(NamedTuple):
    """The rigid bodies of a simulation, in their order."""

    position: NDArray[np.float64]
    """Centre of mass, nm."""
    velocity: NDArray[np.float64]
    """Its velocity, m/s."""


class Simulation:
    """Spheres under a contact law. Units: nm, ns, ag; hence m/s, pN and zJ. Arrays are in the order in which the spheres were given."""

    def __init__(
        self,
        law: Law,
        positions: ArrayLike,
        radii: ArrayLike,
        masses: ArrayLike,
        *,
        dt: float,
        velocities: ArrayLike = (0.0, 0.0, 0.0),
        spins: ArrayLike = (0.0, 0.0, 0.0),
        necks: Iterable[tuple[int, int]] = (),
        bodies: Iterable[Iterable[int]] = (),
        walls: Iterable[Wall] = (),
        surfaces: Iterable[Plane | Mesh] = (),
        box: tuple[float, float, float] | None = None,
        periodic: tuple[bool, bool, bool] = (False, False, False),
        skin: float | None = None,
        damping: float = 0.0,
        max_overlap: float = float("inf"),
        integrator: Literal["half-step", "velocity-verlet"] = "half-step",
        synchronous: bool = False,
        threads: int | None = None,
    ) -> None:
        """Puts spheres under a law.

        A radius, mass or velocity may be one for all. Spheres are named by their places, from 0: `necks` are pairs of them, `bodies` the members
        of rigid aggregates, `walls` move as they are driven; bodies and walls need the half-step integrator without a synchronous start. Without
        a `box` (nm) it has the extent of the spheres and is not periodic. Neighbours are listed up to `skin` (nm) beyond the range of the law, by
        default a tenth of the smallest radius. `damping` is the coefficient of a drag on every sphere (ag/ns). A simulation whose overlaps exceed
        the part `max_overlap` of the sum of the radii halts. Velocities are half a step behind the positions, also those given, unless the start
        is `synchronous` or the integrator is velocity Verlet.
        """
        if integrator not in ("half-step", "velocity-verlet"):
            raise ValueError(f"`integrator` = {integrator!r}: expected 'half-step' or 'velocity-verlet'")
        self.law = law
        if skin is None:
            sizes = _veridem.numbers(radii, "radii", 1)
            skin = 0.1 * float(sizes.min()) if sizes.size else 0.0
        parts: dict[str, Any] = {
            "positions": positions,
            "velocities": velocities,
            "spins": spins,
            "radii": radii,
            "masses": masses,
            "necks": [(_place(i), _place(j)) for i, j in necks],
            "bodies": [[_place(sphere) for sphere in body] for body in bodies],
            "walls": [_driven(wall) for wall in walls],
            "surfaces": [_shaped(surface) for surface in surfaces],
            "domain": None if box is None else (tuple(map(float, box)), tuple(map(bool, periodic))),
        }
        if (integrator == "velocity-verlet" or synchronous) and (parts["bodies"] or parts["walls"]):
            raise ValueError("bodies and walls need the integrator 'half-step', and a start that is not synchronous")
        settings = (dt, skin, damping, max_overlap)
        self._simulation = _veridem.Simulation(
            law._law, parts, settings, (integrator == "velocity-verlet", synchronous), threads
        )

    def step(
        self, number: int = 1, observer: Callable[[Simulation], Any] | None = None, *, every: int = 1
    ) -> Simulation:
        """Takes a number of steps, and returns the simulation.

        After `every` so many of them the `observer` is called; where it returns True, no further step is taken. An exception that it raises, and
        Ctrl-C, end the steps; the simulation can be stepped on from there.
        """
        if number < 0 or every < 1:
            raise ValueError(f"found {number} steps, observed every {every}: expected at least 0 and 1")
        last = self.steps + number
        if observer is None:
            self._simulation.advance(last)
            return self
        while self.steps < last:
            self._simulation.advance(min(last, self.steps + every))
            if observer(self) is True:
                break
        return self

    @property
    def steps(self) -> int:
        """Number of steps taken."""
        return self._simulation.steps

    @property
    def time(self) -> float:
        """Time, ns."""
        return self._simulation.time

    @property
    def dt(self) -> float:
        """Time step, ns."""
        return self._simulation.dt

    @property
    def positions(self) -> NDArray[np.float64]:
        """Centres, nm; a copy, like all arrays."""
        return self._simulation.positions

    @property
    def velocities(self) -> NDArray[np.float64]:
        """Velocities, m/s."""
        return self._simulation.velocities

    @property
    def spins(self) -> NDArray[np.float64]:
        """Angular velocities, 1/ns."""
        return self._simulation.spins

    @property
    def radii(self) -> NDArray[np.float64]:
        """Radii, nm."""
        return self._simulation.radii

    @property
    def masses(self) -> NDArray[np.float64]:
        """Masses, ag."""
        return self._simulation.masses

    @property
    def overlap(self) -> float:
        """The largest overlap of two spheres, relative to the sum of their radii."""
        return self._simulation.overlap

    @property
    def energies(self) -> dict[str, float]:
        """The energy balance, zJ: kinetic, stored and lost by cause, work of walls and surfaces; its residual, which shrinks with the time step, and the energy converted."""
        return self._simulation.energies

    @property
    def pairs(self) -> Contacts:
        """The pairs that act."""
        return Contacts(**self._simulation.pairs)

    @property
    def walls(self) -> Walls:
        """The walls, and what acts on them."""
        return Walls(**self._simulation.walls)

    @property
    def surfaces(self) -> Surfaces:
        """The surfaces, and what acts on them."""
        return Surfaces(**self._simulation.surfaces)

    @property
    def bodies(self) -> Bodies:
        """The rigid bodies."""
        return Bodies(**self._simulation.bodies)

    def __len__(self) -> int:
        return len(self.radii)

    def __repr__(self) -> str:
        return f"<simulation of {len(self)} spheres under {self.law!r} at {self.time:g} ns>"


def _place(sphere: int) -> int:
    """The place of a sphere."""
    place = int(sphere)
    if not 0 <= place < 2**32:
        raise ValueError(f"there is no sphere {place}")
    return place


def _driven(wall: Wall) -> tuple[Any, ...]:
    """A wall of plain numbers."""
    spheres, velocity, load = Wall(*wall)
    loads = tuple(None if force is None else float(force) for force in load)
    return [_place(sphere) for sphere in spheres], tuple(map(float, velocity)), loads


def _shaped(surface: Plane | Mesh) -> dict[str, Any]:
    """The numbers of a surface."""
    if not isinstance(surface, (Plane, Mesh)):
        raise TypeError(f"`surfaces`: found {type(surface).__name__}, expected Plane or Mesh")
    if surface.material not in ("substrate", "tip"):
        raise ValueError(f"`material` = {surface.material!r}: expected 'substrate' or 'tip'")
    shape = _veridem.numbers((surface.point, surface.normal) if isinstance(surface, Plane) else surface.triangles, "shape", 3)
    if shape.ndim != (2 if isinstance(surface, Plane) else 3):
        raise ValueError("a surface has a point and a normal, or triangles of the shape (number, 3, 3)")
    reversal = None if surface.reversal is None else tuple(map(float, surface.reversal))
    return {"shape": shape, "material": int(surface.material == "tip"), "reversal": reversal}
