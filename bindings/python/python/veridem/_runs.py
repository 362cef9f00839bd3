"""Run folders: series as tables, frames as arrays, results as numbers with units."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np

from . import _veridem

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray


class Result(NamedTuple):
    """A final quantity of a run. The value is None if what defines it did not happen, for this reason."""

    value: float | int | str | NDArray[np.float64] | None
    unit: str
    error: float | None
    target: float | None
    reason: str | None

    def __float__(self) -> float:
        if isinstance(self.value, (int, float)):
            return float(self.value)
        raise TypeError(f"found {self.reason or self.value!r}, expected a number")


class Frame:
    """The state of all spheres at some time: arrays in the order of their ids, in nm, ns, ag, hence m/s, pN and zJ."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Reads a frame in extended XYZ, with the pairs and surfaces in the files beside it."""
        self.path = Path(path)
        read = _veridem.frame(os.fspath(path))
        self.stage: str = read["stage"]
        self.time: float = read["time"]
        self.sides: NDArray[np.float64] = read["sides"]
        self.periodic: NDArray[np.bool_] = read["periodic"]
        self.columns: dict[str, NDArray[Any]] = read["columns"]
        self.pairs: NDArray[np.int64] = read["pairs"]
        self.pair_columns: dict[str, NDArray[Any]] = read["pair_columns"]
        self.corners: NDArray[np.float64] = read["corners"]
        self.triangles: NDArray[np.int64] = read["triangles"]

    @property
    def positions(self) -> NDArray[np.float64]:
        """The centres, nm."""
        return self.columns["pos"]

    @property
    def radii(self) -> NDArray[np.float64]:
        """The radii, nm."""
        return self.columns["radius"]

    @property
    def forces(self) -> NDArray[np.float64]:
        """The forces of pairs and surfaces, pN."""
        return self.columns["force"]

    def __getitem__(self, column: str) -> NDArray[Any]:
        return self.columns[column]

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        return f"<frame of {self.stage} at {self.time:g} ns: {len(self)} spheres, {len(self.pairs)} pairs>"


class Frames(Sequence[Frame]):
    """The frames of a run in the order of its stages and of time, read when they are asked for."""

    def __init__(self, paths: Sequence[str | os.PathLike[str]]) -> None:
        self.paths = [Path(path) for path in paths]

    @overload
    def __getitem__(self, at: int) -> Frame: ...
    @overload
    def __getitem__(self, at: slice) -> Frames: ...
    def __getitem__(self, at: int | slice) -> Frame | Frames:
        return Frames(self.paths[at]) if isinstance(at, slice) else Frame(self.paths[at])

    def __len__(self) -> int:
        return len(self.paths)

    def __iter__(self) -> Iterator[Frame]:
        return map(Frame, self.paths)

    def __repr__(self) -> str:
        return f"<{len(self)} frames>"


class Run:
    """A run folder, finished or not. Everything is read when it is asked for."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self._files: dict[str, Path] = {what: Path(file) for what, file in _veridem.files(os.fspath(path)).items()}

    def __fspath__(self) -> str:
        return os.fspath(self.path)

    @property
    def title(self) -> str:
        """The title of its case."""
        return _veridem.summary(self)[0]

    @property
    def status(self) -> str:
        """Running, stopped, halted, failed, interrupted, finished or killed."""
        return _veridem.summary(self)[1].lower()

    @property
    def manifest(self) -> dict[str, Any]:
        """Version, compiler, seed, and hashes of inputs and outputs."""
        manifest: dict[str, Any] = json.loads(_veridem.summary(self)[2])
        return manifest

    @property
    def report(self) -> Path:
        """Its report for people, an HTML file."""
        return self._files["report"]

    @property
    def series(self) -> pandas.DataFrame:
        """The time series: columns with units, one row per output; not a number where a stage does not have a column."""
        import pandas

        series = _table(self._files["series"])
        parts = []
        for stage, file in _veridem.stages(self):
            rows = series[series["stage"] == stage]
            if os.path.exists(file):
                own = _table(file).drop(columns="time [ns]")
                rows = rows.merge(own, on="step", how="left")
            parts.append(rows)
        return pandas.concat(parts, ignore_index=True) if parts else series

    @property
    def windows(self) -> pandas.DataFrame | None:
        """Means over windows, such as the size of a third body, if the run has any."""
        file = self._files["windows"]
        return _table(file) if file.exists() else None

    @property
    def profiles(self) -> pandas.DataFrame | None:
        """Profiles over the height, such as that of the velocity between two sliding bodies, if the run has any."""
        file = self._files["profiles"]
        return _table(file) if file.exists() else None

    @property
    def events(self) -> pandas.DataFrame:
        """Its events with their times."""
        import pandas

        return pandas.DataFrame(_veridem.events(self), columns=["stage", "time [ns]", "event"])

    @property
    def results(self) -> dict[str, Result]:
        """The final quantities by name; none before the run has finished."""
        return {name: Result(*rest) for name, *rest in _veridem.results(self)}

    @property
    def frames(self) -> Frames:
        """The states of the spheres."""
        return Frames(_veridem.frame_files(self))

    def __repr__(self) -> str:
        return f"<run {self.path}: {self.title}, {self.status}>"


def open(path: str | os.PathLike[str]) -> Run:
    """Opens a run folder."""
    return Run(path)


def _table(file: str | os.PathLike[str]) -> pandas.DataFrame:
    import pandas

    return pandas.DataFrame(_veridem.table(os.fspath(file)))
