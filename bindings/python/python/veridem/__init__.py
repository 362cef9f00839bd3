"""Three published contact models for the discrete element method: their equations, contact laws and simulations."""

from __future__ import annotations

from . import mechanics, soot, titania, wear
from ._equations import eq, equations
from ._veridem import Equation, Quantity, __version__
from .errors import BrokenInvariant, Error, Halted, InputError, Problem, RunsFailed, Stopped, VerificationFailed

__all__ = [
    "BrokenInvariant",
    "Equation",
    "Error",
    "Halted",
    "InputError",
    "Problem",
    "Quantity",
    "RunsFailed",
    "Stopped",
    "VerificationFailed",
    "__version__",
    "eq",
    "equations",
    "mechanics",
    "soot",
    "titania",
    "wear",
]
