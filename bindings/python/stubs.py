"""Writes the type stubs of the papers' equations, with their documentation, from the tables of the specification.

python stubs.py           writes them
python stubs.py --check   fails if they are not what would be written
"""

from __future__ import annotations

import sys
from pathlib import Path

import veridem

PAPERS = ("mechanics", "soot", "titania", "wear")
FOLDER = Path(__file__).parent / "python" / "veridem"
HEAD = '''# Written by stubs.py.
# mypy: disable-error-code="overload-overlap"
"""{doc}"""

from typing import Any, NamedTuple, overload, type_check_only

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
{names}]
'''


def kind(quantity: veridem.Quantity) -> str:
    """What a result is, as far as the arguments do not decide it."""
    return "Any" if quantity.size == 1 else "NDArray[np.float64]"


def parameters(equation: veridem.Equation, type_of_number: str) -> str:
    names = zip(equation.parameters, equation.arguments, strict=True)
    typed = [f"{name}: {type_of_number if row.size == 1 else 'ArrayLike'}" for name, row in names]
    return ", ".join([*typed, "*", "check: bool = True"])


def text(documentation: str) -> str:
    lines = documentation.replace("\\", "\\\\").replace('"""', '\\"\\"\\"').rstrip().splitlines()
    return '    """' + "\n".join([lines[0], *(f"    {line}".rstrip() for line in lines[1:])]) + '\n    """\n'


def stub(equation: veridem.Equation) -> str:
    name, results = equation.function, equation.results
    documented = text(equation.documentation)
    if len(results) > 1:
        record = "_" + name.title().replace("_", "")
        fields = "".join(f"    {row.name}: {kind(row)}\n" for row in results)
        head = f"@type_check_only\nclass {record}(NamedTuple):\n{fields}\n"
        return f"{head}def {name}({parameters(equation, 'ArrayLike | str')}) -> {record}:\n{documented}"
    if results[0].size > 1 or any(row.size > 1 for row in equation.arguments):
        return f"def {name}({parameters(equation, 'ArrayLike | str')}) -> {kind(results[0])}:\n{documented}"
    single = f"@overload\ndef {name}({parameters(equation, 'float | str')}) -> float:\n{documented}"
    many = f"@overload\ndef {name}({parameters(equation, 'ArrayLike | str')}) -> NDArray[np.float64]: ...\n"
    return f"{single}{many}"


def written(paper: str) -> str:
    module = getattr(veridem, paper)
    found: dict[str, veridem.Equation] = {}
    for id in veridem._equations._BY_ID:
        equation = veridem.eq(id)
        if equation.paper == paper:
            found.setdefault(equation.function, equation)
    names = "".join(f'    "{name}",\n' for name in sorted(found))
    stubs = (stub(found[name]) for name in found)
    return HEAD.format(doc=module.__doc__, names=names) + "\n" + "\n".join(stubs)


def main() -> int:
    stale = []
    for paper in PAPERS:
        file, new = FOLDER / f"{paper}.pyi", written(paper)
        if not file.exists() or file.read_text() != new:
            stale.append(file.name)
            if "--check" not in sys.argv:
                file.write_text(new)
    if stale and "--check" in sys.argv:
        print(f"stale stubs: {', '.join(stale)}; run `python stubs.py`")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
