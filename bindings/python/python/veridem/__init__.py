"""Three published contact models for the discrete element method: their equations, contact laws and simulations."""

from __future__ import annotations

from . import mechanics, soot, titania, wear
from ._aggregates import Aggregate
from ._cases import Case, check, resume, run, sweep
from ._equations import eq, equations
from ._laws import Law, Pairs
from ._runs import Frame, Frames, Result, Run, open
from ._simulation import Bodies, Contacts, Mesh, Plane, Simulation, Surfaces, Wall, Walls
from ._veridem import Equation, Quantity, __version__
from .errors import BrokenInvariant, Error, Halted, InputError, Problem, RunsFailed, Stopped, VerificationFailed

__all__ = [
    "Aggregate",
    "Bodies",
    "BrokenInvariant",
    "Case",
    "Contacts",
    "Equation",
    "Error",
    "Frame",
    "Frames",
    "Halted",
    "InputError",
    "Law",
    "Mesh",
    "Pairs",
    "Plane",
    "Problem",
    "Quantity",
    "Result",
    "Run",
    "RunsFailed",
    "Simulation",
    "Stopped",
    "Surfaces",
    "VerificationFailed",
    "Wall",
    "Walls",
    "__version__",
    "check",
    "eq",
    "equations",
    "mechanics",
    "open",
    "resume",
    "run",
    "soot",
    "sweep",
    "titania",
    "wear",
]
