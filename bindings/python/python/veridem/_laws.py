"""Contact laws over arrays of pairs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _veridem
from ._cases import yaml_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Pairs(NamedTuple):
    """What a contact law makes of pairs; the last axis is that of the components of a vector, or of the names that the law has."""

    force: NDArray[np.float64]
    """Force on `i`, pN; that on `j` is its negative."""
    torque_i: NDArray[np.float64]
    """Torque on `i` about its centre, pN nm."""
    torque_j: NDArray[np.float64]
    """Torque on `j` about its centre, pN nm."""
    springs: NDArray[np.float64]
    """The springs with which the next step starts, by `law.springs`."""
    losses: NDArray[np.float64]
    """Energy lost in this step, zJ, by `law.losses`."""
    stored: NDArray[np.float64]
    """Energy stored before this step, zJ, by `law.stored`."""


class Law:
    """The contact law of a paper. Units: nm, ns, ag; hence m/s, pN and zJ.

    `model` is the section of that name of a case, as a dict, as text or as the name of a paper: `{"wear": {"young_modulus": "73 GPa"}}`, `"wear"`.
    For spheres of these `radii` (nm) attractions that must be solved for are tabulated, as in large simulations.
    """

    def __init__(self, model: str | Mapping[str, Any], radii: Sequence[float] | None = None) -> None:
        if isinstance(model, str) and model.isidentifier():
            model = {model: {}}
        self._model = model if isinstance(model, str) else yaml_of(model)
        self._radii = None if radii is None else [float(radius) for radius in radii]
        self._law = _veridem.Law(self._model, self._radii)

    def __reduce__(self) -> tuple[Any, ...]:
        return Law, (self._model, self._radii)

    @property
    def paper(self) -> str:
        """The paper."""
        return self._law.paper

    @property
    def springs(self) -> list[str]:
        """The springs of a contact, by name."""
        return self._law.springs

    @property
    def losses(self) -> list[str]:
        """The causes by which a pair loses energy."""
        return self._law.losses

    @property
    def stored(self) -> list[str]:
        """The causes by which a pair stores energy."""
        return self._law.stored

    def range(self, r_i: float, r_j: float) -> float:
        """The largest distance of the centres, nm, at which spheres of these radii act on each other."""
        return self._law.range(r_i, r_j)

    def critical_time_step(self, r: float, m: float) -> float:
        """The largest stable time step, ns, of two equal spheres of this radius (nm) and mass (ag) in contact."""
        return self._law.critical_time_step(r, m)

    def pairs(
        self,
        x: ArrayLike,
        v: ArrayLike = (0.0, 0.0, 0.0),
        omega_i: ArrayLike = (0.0, 0.0, 0.0),
        omega_j: ArrayLike = (0.0, 0.0, 0.0),
        *,
        r_i: ArrayLike,
        r_j: ArrayLike,
        m_i: ArrayLike,
        m_j: ArrayLike,
        dt: float,
        springs: ArrayLike | None = None,
        joined: bool = False,
    ) -> Pairs:
        """Evaluates pairs of spheres `i` and `j`, whose arrays are broadcast.

        `x = x_i - x_j` (nm) and `v = v_i - v_j` (m/s) are the differences of positions and velocities, `omega` the angular velocities (1/ns), `r`
        the radii (nm), `m` the masses (ag), `springs` those of the contacts before the step `dt` (ns), none by default. A neck holds pairs that
        are `joined`.
        """
        return Pairs(*self._law.pairs((x, v, omega_i, omega_j), (r_i, r_j, m_i, m_j), springs, joined, dt))

    def __repr__(self) -> str:
        return f"<contact law of {self.paper}>"
