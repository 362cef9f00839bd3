"""Exceptions of veridem. Files that cannot be read or written raise `OSError`, wrong arguments `ValueError` and `TypeError`."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Problem(NamedTuple):
    """Something that is wrong with the input; what is not known is None."""

    file: str | None
    line: int | None
    key: str | None
    what: str


class Error(Exception):
    """Any error of veridem."""


class InputError(Error, ValueError):
    """The input is wrong; nothing was written."""

    problems: list[Problem] = []

    @property
    def file(self) -> str | None:
        """The file of the first problem."""
        return self.problems[0].file if self.problems else None

    @property
    def line(self) -> int | None:
        """The line of the first problem, counted from 1."""
        return self.problems[0].line if self.problems else None

    @property
    def key(self) -> str | None:
        """The key of the first problem, with its sections."""
        return self.problems[0].key if self.problems else None


class Halted(Error):
    """The simulation left its domain of validity at this step and time (ns); the state is in a file, if one was written."""

    step: int
    time: float
    state: Path | None = None


class VerificationFailed(Error):
    """A stage failed, or a verification."""


class RunsFailed(Error):
    """Some runs of a sweep did not finish."""


class Stopped(Error):
    """The run reached its limit of time, and can be resumed."""

    run: Path | None = None


class BrokenInvariant(Error, RuntimeError):
    """A defect of veridem."""
