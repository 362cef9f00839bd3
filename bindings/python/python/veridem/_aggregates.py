"""Aggregates of spheres: grown, imported, measured."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Literal

from . import _veridem
from ._runs import Result

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Aggregate:
    """Spheres that touch: centres and radii, nm."""

    def __init__(self, positions: ArrayLike, radii: ArrayLike) -> None:
        import numpy as np

        self.positions: NDArray[np.float64] = _veridem.numbers(positions, "positions", 3)
        if self.positions.ndim != 2:
            raise ValueError("`positions`: expected one row for each sphere")
        sizes = _veridem.numbers(radii, "radii", 1)
        self.radii: NDArray[np.float64] = np.broadcast_to(sizes, self.positions.shape[:1]).copy()

    @classmethod
    def grow(
        cls,
        spheres: int,
        *,
        radius: float,
        deviation: float = 1.0,
        fractal_dimension: float,
        prefactor: float,
        method: Literal["clusters", "spheres"] = "clusters",
        seed: int = 1,
    ) -> Aggregate:
        """Grows an aggregate that meets the fractal law `N = prefactor * (R_g / radius) ** fractal_dimension`.

        `radius` (nm) is the geometric mean, `deviation` the geometric standard deviation. By the method `clusters` clusters of similar size are
        joined; by `spheres` one sphere after the other, for compact aggregates.
        """
        if method not in ("clusters", "spheres"):
            raise ValueError(f"`method` = {method!r}: expected 'clusters' or 'spheres'")
        law, sizes = (fractal_dimension, prefactor), (radius, deviation)
        return cls(*_veridem.grow(spheres, law, sizes, method == "spheres", seed))

    @classmethod
    def read(
        cls,
        file: str | os.PathLike[str],
        *,
        unit: float | None = None,
        radius: float | None = None,
        format: str | None = None,
        disconnected: bool = False,
    ) -> Aggregate:
        """Reads a file of FLAGE, MSTM, FracVAL, PyFracVAL, soot-dem or LAMMPS, an XYZ or a CSV file.

        `unit` is the unit of length of the file and `radius` that of all spheres (nm), if the file does not say them; `disconnected` accepts
        spheres that do not form one aggregate.
        """
        return cls(*_veridem.import_(os.fspath(file), unit, radius, format, disconnected)[0])

    @property
    def shape(self) -> dict[str, Result]:
        """Coordination number, convexity, radius of gyration, fractal dimension, projected area, hydrodynamic and mobility radius."""
        return {name: Result(*rest) for name, *rest in _veridem.shape(self.positions, self.radii)}

    def necks(self, distance: float = 0.01, *, length: Literal["touching", "as-given"] = "touching") -> NDArray[np.int64]:
        """Pairs of spheres whose surfaces are less than `distance` (nm) apart or overlap by less, as a forest; overlaps of any length count if
        the necks are at rest as given."""
        if length not in ("touching", "as-given"):
            raise ValueError(f"`length` = {length!r}: expected 'touching' or 'as-given'")
        return _veridem.neck_pairs(self.positions, self.radii, distance, length == "as-given")

    def write(self, file: str | os.PathLike[str]) -> None:
        """Writes the spheres as extended XYZ, in nm."""
        _veridem.write(os.fspath(file), self.positions, self.radii)

    def __len__(self) -> int:
        return len(self.radii)

    def __repr__(self) -> str:
        return f"<aggregate of {len(self)} spheres>"
