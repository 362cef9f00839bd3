"""The files of golden trajectories: what an oracle computes is compared with them, and written where it differs."""

import json

from frame import GOLDEN, TRAJECTORIES, Wrong, exact, mp, mpf, parts

# Digits of a number that is written anew.
WRITTEN = 25


def meant(number):
    """The decimal that a double of a file stands for."""
    return mpf(repr(float(number)))


def compact(value):
    return json.dumps(value, ensure_ascii=False)


def rewritten(old, new):
    """A number as the file has it: text stays text, a float stays a float."""
    return mp.nstr(new, WRITTEN) if isinstance(old, str) else float(new)


def merged(name, old, new, tolerance, size=None):
    """The value of a file where it agrees with the oracle's, else the oracle's; and what was replaced."""
    if isinstance(old, list):
        new = list(new)
        if len(old) != len(new):
            raise Wrong(f"{name}: found {len(new)} values, expected {len(old)}")
        pairs = [merged(f"{name} {k}", a, b, tolerance, size) for k, (a, b) in enumerate(zip(old, new))]
        return [value for value, _ in pairs], [change for _, changes in pairs for change in changes]
    (number,) = parts(new)
    if abs(number - exact(old)) <= tolerance * (abs(number) if size is None else size):
        return old, []
    return rewritten(old, number), [f"{name}: file {old}, oracle {mp.nstr(number, WRITTEN)}"]


def samples(name, old, new, tolerance):
    """Like `merged`, by rows; the size is that of the column."""
    rows, changes = [list(row) for row in old], []
    new = [parts(row) for row in new]
    if [len(row) for row in old] != [len(row) for row in new]:
        raise Wrong(f"{name}: the rows differ in number or length")
    for k, column in enumerate(zip(*new)):
        size = max(abs(number) for number in column)
        for at, number in enumerate(column):
            rows[at][k], found = merged(f"{name} {at}, column {k}", old[at][k], number, tolerance, size)
            changes += found
    return rows, changes


def text_of(file):
    """A file of trajectories as it is written: a run in a line, but for its samples, which have one each."""
    head = [f"  {compact(key)}: {compact(value)}," for key, value in file.items() if key != "runs"]
    runs = []
    for run in file["runs"]:
        keys = ", ".join(f"{compact(key)}: {compact(value)}" for key, value in run.items() if key != "samples")
        rows = ",\n".join(f"      {compact(row)}" for row in run["samples"])
        runs.append(f'    {{{keys}, "samples": [\n{rows}\n    ]}}')
    return "\n".join(["{", *head, '  "runs": [', ",\n".join(runs), "  ]", "}"]) + "\n"


def motions(name):
    """The file as it must be, and what differs from what it is."""
    function, tolerance = TRAJECTORIES[name]
    path = GOLDEN / "trajectories" / name
    file = json.loads(path.read_text())
    changes = []
    for run in file["runs"]:
        for key, value in function(exact(run)).items():
            compare = samples if key == "samples" else merged
            run[key], found = compare(f"{name}, {run['name']}: {key}", run[key], value, tolerance)
            changes += found
    return text_of(file), changes
