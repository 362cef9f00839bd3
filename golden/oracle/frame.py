"""What the oracles share: numbers of 60 digits, vectors, the list of functions, the files of golden vectors.

An oracle is a function with the names of the equation's table as keywords. It gets `mpf` for a number, `Vector` for a vector
and a list of nine `mpf`, by rows, for a tensor, and returns a dictionary with every result of the table, or `None` for a result that it does not compute.
"""

import json
import re
from fractions import Fraction
from pathlib import Path

from mpmath import mp, mpf

GOLDEN = Path(__file__).parent.parent
DIGITS, MORE_DIGITS = 60, 90
WRITTEN = 34
TOLERANCE = mpf("1e-33")

mp.dps = DIGITS
EQUATIONS = {}
TRAJECTORIES = {}


class Wrong(Exception):
    """A value that does not agree, or a function that cannot be used."""


class Vector:
    """Three numbers."""

    def __init__(self, x, y, z):
        self.parts = (mpf(x), mpf(y), mpf(z))

    def __iter__(self):
        return iter(self.parts)

    def __getitem__(self, k):
        return self.parts[k]

    def __add__(self, other):
        return Vector(*(a + b for a, b in zip(self, other)))

    def __sub__(self, other):
        return Vector(*(a - b for a, b in zip(self, other)))

    def __neg__(self):
        return Vector(*(-a for a in self))

    def __mul__(self, factor):
        return Vector(*(a * factor for a in self))

    __rmul__ = __mul__

    def __truediv__(self, divisor):
        return Vector(*(a / divisor for a in self))

    def dot(self, other):
        return sum((a * b for a, b in zip(self, other)), mpf(0))

    def cross(self, other):
        (a, b, c), (u, v, w) = self, other
        return Vector(b * w - c * v, c * u - a * w, a * v - b * u)

    def norm(self):
        return mp.sqrt(self.dot(self))


def equation(id, cases=(), defined=lambda **_: True):
    """Registers the oracle of an equation. `cases`: inputs of vectors to write, as f64 literals that are taken exactly.
    `defined`: whether the oracle has a value for these arguments; the project has some for arguments without a meaning."""

    def register(function):
        if id in EQUATIONS:
            raise Wrong(f"{id} has two oracles")
        module = function.__module__.replace(".", "/")
        EQUATIONS[id] = (function, list(cases), f"golden/oracle/{module}.py", defined)
        return function

    return register


def trajectory(file, tolerance="1e-24"):
    """Registers the oracle of a file of trajectories: a function of a run (a dictionary, numbers as `mpf`, `samples` as rows)
    that returns what it computes, `samples` among it. They agree with the file to `tolerance` of the largest of their column."""

    def register(function):
        if file in TRAJECTORIES:
            raise Wrong(f"{file} has two oracles")
        TRAJECTORIES[file] = (function, mpf(tolerance))
        return function

    return register


def exact(value):
    """A value of JSON as exact numbers: floats as they are, text as decimals or fractions; other text is kept."""
    if isinstance(value, (list, tuple)):
        return [exact(part) for part in value]
    if isinstance(value, dict):
        return {name: exact(part) for name, part in value.items()}
    if isinstance(value, str) and re.fullmatch(r"-?[0-9.]+(e[-+]?[0-9]+)?(/[0-9]+)?", value):
        over, _, under = value.partition("/")
        return mpf(over) / mpf(under or 1)
    return value if isinstance(value, (str, bool)) or value is None else mpf(value)


def printed(number):
    """A constant that the paper prints in a formula: this decimal, not the f64 next to it."""
    return mpf(repr(number))


def argument(value):
    """An argument as an oracle takes it."""
    numbers = exact(value)
    return Vector(*numbers) if isinstance(numbers, list) and len(numbers) == 3 else numbers


def parts(value):
    """The numbers of a result."""
    if isinstance(value, Fraction):
        return [mpf(value.numerator) / value.denominator]
    if isinstance(value, (Vector, list, tuple)):
        return [number for part in value for number in parts(part)]
    return [mpf(value)]


def decimal(number):
    """34 significant digits."""
    if number == 0:
        return "0.0"
    text = mp.nstr(number, WRITTEN, strip_zeros=False, min_fixed=1, max_fixed=0, show_zero_exponent=False)
    return text.replace("e+", "e")


def literal(value):
    """The shortest decimal of an f64, written as in the files."""
    if isinstance(value, (list, tuple, Vector)):
        return "[" + ",".join(literal(float(part)) for part in value) + "]"
    text = repr(float(value))
    digits, _, exponent = text.partition("e")
    if exponent == "-05":
        sign, digits = digits[: digits.startswith("-")], digits.lstrip("-").replace(".", "").removesuffix("0" * digits.endswith(".0"))
        return f"{sign}0.0000{digits}"
    return f"{digits}e{int(exponent)}" if exponent else text


def results(id, inputs):
    """What the oracle of an equation computes from these inputs, as lists of numbers; the same with more digits."""
    function = EQUATIONS[id][0]
    found = []
    for digits in (DIGITS, MORE_DIGITS):
        with mp.workdps(digits):
            out = function(**{name: argument(value) for name, value in inputs.items()})
            found.append({name: value if value is None else parts(value) for name, value in out.items()})
    less, more = found
    for name, numbers in more.items():
        if numbers and not all(agree(a, b, TOLERANCE / 100) for a, b in zip(less[name], numbers)):
            raise Wrong(f"`{name}` of {inputs} loses too many digits: {less[name]}, {numbers}")
    return more


def agree(found, expected, tolerance):
    return abs(found - expected) <= tolerance * abs(expected)


def line(vector):
    """A vector as one line of its file."""
    inputs = ",".join(f'"{name}":{literal(value)}' for name, value in vector["in"].items())
    out = ",".join(f'"{name}":{json.dumps(value, separators=(",", ":"))}' for name, value in vector["out"].items())
    return f'    {{"flag":"independent","source":"{vector["source"]}","in":{{{inputs}}},"out":{{{out}}}}}'


def written(id, inputs, names, source):
    """The line of a new vector. `names`: of the arguments and of the results, in order."""
    arguments, result_names = names
    if set(inputs) != set(arguments):
        raise Wrong(f"a case has the arguments {sorted(inputs)}, expected {arguments}")
    out = results(id, inputs)
    if set(out) != set(result_names):
        raise Wrong(f"the oracle returns {sorted(out)}, expected {result_names}")
    texts = {name: [decimal(number) for number in out[name]] for name in result_names if out[name] is not None}
    texts = {name: text[0] if len(text) == 1 else text for name, text in texts.items()}
    return line({"source": source, "in": {name: inputs[name] for name in arguments}, "out": texts})


def check_kept(id, vector):
    """Compares a vector that somebody else computed with the oracle, but for what the oracle does not compute."""
    found = results(id, vector["in"])
    for name, value in vector["out"].items():
        if found.get(name, ()) is None:
            continue
        expected = [exact(text) for text in (value if isinstance(value, list) else [value])]
        if len(found.get(name, ())) != len(expected):
            raise Wrong(f"the oracle lacks `{name}`")
        if not all(agree(a, b, TOLERANCE) for a, b in zip(found[name], expected)):
            now = [decimal(number) for number in found[name]]
            other = vector.get("source", "the project")
            raise Wrong(f"`{name}` of {vector['in']}: the oracle computes {now}, {other} has {value}")


def vectors(id):
    """The file of an equation's vectors as it must be: the text, and the number of independent vectors. The others, which the
    project generated, are compared too."""
    _, cases, source, defined = EQUATIONS[id]
    path = file_of(id)
    if not path.exists():
        raise Wrong(f"{path} is missing: run `veridem golden regenerate` first")
    lines = path.read_text().split("\n")
    start, end = lines.index('  "vectors": [') + 1, lines.index("  ]")
    kept, count = [], 0
    for text in lines[start:end]:
        vector = json.loads(text.rstrip(","))
        if vector.get("source", "").startswith("golden/oracle/"):
            continue
        kept.append(text.rstrip(","))
        if "source" in vector or defined(**{name: argument(value) for name, value in vector["in"].items()}):
            check_kept(id, vector)
        count += "source" in vector
    first = json.loads(kept[0])
    names = list(first["in"]), list(first["out"])
    kept += [written(id, case, names, source) for case in cases]
    return "\n".join(lines[:start] + [",\n".join(kept)] + lines[end:]), count + len(cases)


def file_of(id):
    paper, _, name = id.partition("-")
    return GOLDEN / paper / f"{name}.json"
