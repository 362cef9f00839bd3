"""Mechanics that the papers share. The equations, by the names of their functions."""

from ._equations import functions as _functions_of

_functions = _functions_of(__name__.rpartition(".")[2])
globals().update(_functions)
__all__ = sorted(_functions)
