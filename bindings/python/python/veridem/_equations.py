"""The equations, by id and by the name of their function."""

from __future__ import annotations

from collections.abc import Callable
from inspect import Parameter, Signature
from typing import TYPE_CHECKING, Any

from . import _veridem

if TYPE_CHECKING:
    import pandas

_BY_ID: dict[str, _veridem.Equation] = {equation.id: equation for equation in _veridem.all_equations()}


def eq(id: str) -> _veridem.Equation:
    """The equation with this id, such as `wear-3`; case, leading zeros and separators do not matter."""
    return _BY_ID.get(id) or _BY_ID[_veridem.id_of(id)]


def equations() -> pandas.DataFrame:
    """All equations as a table, by id: paper, numbers in the paper, function, title, and names of arguments and results."""
    import pandas

    rows = [
        {
            "id": equation.id,
            "paper": equation.paper,
            "numbers": ", ".join(equation.numbers),
            "function": equation.function,
            "title": equation.title,
            "arguments": ", ".join(quantity.name for quantity in equation.arguments),
            "results": ", ".join(quantity.name for quantity in equation.results),
        }
        for equation in _BY_ID.values()
    ]
    return pandas.DataFrame(rows).set_index("id")


def functions(paper: str) -> dict[str, Callable[..., Any]]:
    """The equations of a paper as functions, by name; one that carries several numbers is taken once."""
    found: dict[str, Callable[..., Any]] = {}
    for equation in _BY_ID.values():
        if equation.paper == paper and equation.function not in found:
            found[equation.function] = _function(equation)
    return found


def _function(equation: _veridem.Equation) -> Callable[..., Any]:
    def function(*positional: Any, **keywords: Any) -> Any:
        return equation(*positional, **keywords)

    function.__name__ = function.__qualname__ = equation.function
    function.__module__ = f"veridem.{equation.paper}"
    function.__doc__ = equation.documentation
    arguments = [Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in equation.parameters]
    check = Parameter("check", Parameter.KEYWORD_ONLY, default=True)
    function.__signature__ = Signature([*arguments, check])  # type: ignore[attr-defined]
    return function
