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

        A radius, mass or velocity may be one for all. `necks` are pairs of spheres. Without a `box` (nm) it has the extent of the spheres and is
        not periodic. Neighbours are listed up to `skin` (nm) beyond the range of the law, by default a tenth of the smallest radius. `damping` is
        the coefficient of a drag on every sphere (ag/ns). A simulation whose overlaps exceed the part `max_overlap` of the sum of the radii halts.
        Velocities are half a step behind the positions, also those given, unless the start is `synchronous` or the integrator is velocity Verlet.
        """
        import numpy as np

        if integrator not in ("half-step", "velocity-verlet"):
            raise ValueError(f"`integrator` = {integrator!r}: expected 'half-step' or 'velocity-verlet'")
        self.law = law
        if skin is None:
            sizes = np.asarray(radii, dtype=float)
            skin = 0.1 * float(sizes.min()) if sizes.size else 0.0
        self._simulation = _veridem.Simulation(
            law._law,
            (positions, velocities, spins),
            (radii, masses),
            [(int(i), int(j)) for i, j in necks],
            None if box is None else (tuple(map(float, box)), tuple(map(bool, periodic))),
            (dt, skin, damping, max_overlap),
            (integrator == "velocity-verlet", synchronous),
            threads,
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
        """The energy balance, zJ: kinetic, stored and lost by cause; its residual, which shrinks with the time step, and the energy converted."""
        return self._simulation.energies

    @property
    def pairs(self) -> Contacts:
        """The pairs that act."""
        return Contacts(**self._simulation.pairs)

    def __len__(self) -> int:
        return len(self.radii)

    def __repr__(self) -> str:
        return f"<simulation of {len(self)} spheres under {self.law!r} at {self.time:g} ns>"
