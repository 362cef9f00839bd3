"""Demidov, Gor & Khalizov 2024: soot aggregates with necks. The equations, by the names of their functions."""

from ._equations import functions as _functions_of

_functions = _functions_of(__name__.rpartition(".")[2])
globals().update(_functions)
__all__ = sorted(_functions)
