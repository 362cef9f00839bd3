"""Three published contact models for the discrete element method: their equations, contact laws and simulations."""

from __future__ import annotations

from . import mechanics, soot, titania, wear
from ._cases import Case, check, resume, run
from ._equations import eq, equations
from ._runs import Frame, Frames, Result, Run, open
from ._veridem import Equation, Quantity, __version__
from .errors import BrokenInvariant, Error, Halted, InputError, Problem, RunsFailed, Stopped, VerificationFailed

__all__ = [
    "BrokenInvariant",
    "Case",
    "Equation",
    "Error",
    "Frame",
    "Frames",
    "Halted",
    "InputError",
    "Problem",
    "Quantity",
    "Result",
    "Run",
    "RunsFailed",
    "Stopped",
    "VerificationFailed",
    "__version__",
    "check",
    "eq",
    "equations",
    "mechanics",
    "open",
    "resume",
    "run",
    "soot",
    "titania",
    "wear",
]
