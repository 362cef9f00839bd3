"""Computes the independent golden vectors and trajectories: `python3 golden/oracle [--check] [name ...]`.

A name is the id of an equation, a paper or the file of a trajectory. With `--check`, nothing is written.
"""

import argparse
import importlib
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from frame import EQUATIONS, GOLDEN, TRAJECTORIES, Wrong, vectors, file_of  # noqa: E402
from motions import motions  # noqa: E402

# The number of independent vectors of every equation, which `veridem golden check` compares.
COUNTS = GOLDEN / "independent.json"


def wanted(known, names):
    return [name for name in known if not names or any(name == chosen or name.split("-")[0] == chosen for chosen in names)]


def ids():
    """Every equation that has a file of vectors."""
    folders = [path for path in GOLDEN.iterdir() if path.is_dir() and path.name not in ("oracle", "results", "trajectories")]
    return [f"{folder.name}-{path.stem}" for folder in sorted(folders) for path in sorted(folder.glob("*.json"))]


def main():
    parser = argparse.ArgumentParser(prog="python3 golden/oracle", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare with the files; write nothing")
    parser.add_argument("names", nargs="*", help="equations, papers or files of trajectories; all of them if none is given")
    chosen = parser.parse_args()
    for path in sorted(Path(__file__).parent.glob("*.py")):
        if path.stem not in ("__main__", "frame", "motions"):
            importlib.import_module(path.stem)
    files = sorted(path.name for path in (GOLDEN / "trajectories").glob("*.json"))
    known = ids()
    equations, trajectories = wanted(known, chosen.names), wanted(files, chosen.names)
    wrong = [f"there is no `{name}`" for name in chosen.names if not wanted(known + files, [name])]
    wrong += [f"{name} has no oracle" for name in equations if name not in EQUATIONS]
    wrong += [f"{name} has no oracle" for name in trajectories if name not in TRAJECTORIES]
    wrong += [f"the oracle of {name} has no file" for name in [*EQUATIONS, *TRAJECTORIES] if name not in known + files]
    counts = json.loads(COUNTS.read_text())
    for name in equations:
        if name not in EQUATIONS:
            continue
        try:
            text, count = vectors(name)
        except (Wrong, ArithmeticError, TypeError, ValueError) as error:
            wrong.append(f"{name}: {error}")
            continue
        path = file_of(name)
        if count < counts.get(name, 0):
            wrong.append(f"{name}: {count} independent vectors, there were {counts[name]}: restore {path}")
        elif chosen.check and (text != path.read_text() or count != counts.get(name)):
            wrong.append(f"{name}: the vectors or their number are not what the oracle writes")
        elif not chosen.check:
            path.write_text(text)
            counts[name] = count
    for name in trajectories:
        if name not in TRAJECTORIES:
            continue
        try:
            text, changes = motions(name)
        except Wrong as error:
            wrong.append(str(error))
            continue
        path = GOLDEN / "trajectories" / name
        if chosen.check:
            wrong += changes
        elif text != path.read_text():
            print("\n".join(changes))
            path.write_text(text)
    if not chosen.check:
        COUNTS.write_text(json.dumps({name: counts.get(name, 0) for name in known}, indent=1) + "\n")
    done = sum(name in EQUATIONS for name in equations), sum(name in TRAJECTORIES for name in trajectories)
    print(f"{done[0]} equations and {done[1]} files of trajectories computed")
    if wrong:
        sys.exit("\n".join(wrong))


main()
