"""Cases: checked, run and resumed."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from . import _veridem
from ._runs import Run

if TYPE_CHECKING:
    import pandas

Case = Union[str, "os.PathLike[str]", Mapping[str, Any]]
"""A case: its file, its YAML text (of more than one line), or its sections as a dict."""

Progress = Callable[[float, str], Any]
"""Receives the share of a run that is done, and that in words."""


def check(case: Case, *, excess: bool = False, threads: int | None = None) -> dict[str, Any]:
    """The case with every default and derived value, the plan of its run, and warnings; raises `InputError` if it is wrong.

    `excess` accepts cases that ask for more steps, output or memory than is usual.
    """
    file, text = _source(case)
    checked: dict[str, Any] = json.loads(_veridem.check(file, text, excess, threads))
    return checked


def run(
    case: Case,
    out: str | os.PathLike[str] | None = None,
    *,
    force: bool = False,
    excess: bool = False,
    threads: int | None = None,
    max_time: float | None = None,
    progress: Progress | bool | None = None,
) -> Run:
    """Runs a case into the new folder `out`, by default `run/` and the name of its file, and returns the run.

    `force` replaces an earlier run. `max_time` (s) ends it with `Stopped`, Ctrl-C with `KeyboardInterrupt`: both leave a run that `resume`
    completes, with the bits of an uninterrupted one. `progress` receives the share that is done and a line of text; by default, and with True,
    that line is shown, by default only on a terminal.
    """
    file, text = _source(case)
    if out is None:
        if text is not None:
            raise TypeError("`out` is missing: the run folder of a case that is not in a file")
        out = Path("run") / Path(file).stem
    with _Line(progress) as tell:
        _veridem.run(file, text, os.fspath(out), force, excess, threads, max_time, tell)
    return Run(out)


def resume(
    run: str | os.PathLike[str] | Run,
    *,
    threads: int | None = None,
    max_time: float | None = None,
    progress: Progress | bool | None = None,
) -> Run:
    """Resumes a stopped run, and returns it: the output is byte for byte that of an uninterrupted run."""
    path = os.fspath(run)
    with _Line(progress) as tell:
        _veridem.resume(path, threads, max_time, tell)
    return Run(path)


def sweep(
    case: Case,
    keys: Mapping[str, Any],
    out: str | os.PathLike[str],
    *,
    force: bool = False,
    excess: bool = False,
    threads: int | None = None,
    max_time: float | None = None,
    progress: Progress | bool | None = None,
) -> pandas.DataFrame:
    """Runs a case for all combinations of the values of some of its keys, such as `{"seed": [1, 2], "output.series": ["1 ps", "2 ps"]}`.

    Returns a table of the runs: keys, status, results, reason of a failure, and run folder. The folder `out` has a folder for every run,
    `summary.csv` and a report. Runs that have finished are not repeated unless forced: the same call resumes a sweep that was stopped.
    """
    import pandas

    file, text = _source(case)
    words = [f"{key}={_values(key, values)}" for key, values in keys.items()]
    with _Line(progress) as tell:
        runs = json.loads(_veridem.sweep(file, text, words, os.fspath(out), force, excess, threads, max_time, tell))
    rows = []
    for run in runs:
        results = {}
        for name, result in run["results"].items():
            unit = f" [{result['unit']}]" if result.get("unit") else ""
            results[name + unit] = result.get("value", result.get("values", result.get("verdict")))
        rows.append({**run["keys"], "status": run["status"], **results, "reason": run["reason"], "run": run["run"]})
    return pandas.DataFrame(rows)


def _values(key: str, values: Any) -> str:
    """The values of a key as on the command line."""
    if isinstance(values, str) or not hasattr(values, "__iter__"):
        raise TypeError(f"`{key}`: found {values!r}, expected a list of values")
    return ",".join(_value(value) for value in values)


def _value(value: Any) -> str:
    # Words stand as they are, so that the folders of runs have plain names.
    if isinstance(value, str) and not set(value) & set(",[]{}\"'"):
        return value
    return json.dumps(value, default=_plain, allow_nan=False)


def _source(case: Case) -> tuple[str, str | None]:
    """The file of a case, and its text if it is not in a file."""
    if isinstance(case, Mapping):
        return "<dict>", yaml_of(case)
    if isinstance(case, str) and "\n" in case:
        return "<text>", case
    return os.fspath(case), None


def yaml_of(sections: Mapping[str, Any]) -> str:
    """Sections of a case as text."""
    try:
        return _veridem.yaml_of(json.dumps(sections, default=_plain, allow_nan=False))
    except ValueError as error:
        raise ValueError(f"found in a case what no file can hold: {error}") from error


def _plain(value: Any) -> Any:
    """What a dict holds beside numbers, texts and lists: paths, and the numbers and arrays of numpy."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return dict(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"found {type(value).__name__} in a case, expected sections, lists, texts and numbers")


class _Line:
    """Shows progress as a line that is written again and again."""

    def __init__(self, progress: Progress | bool | None) -> None:
        self.show = progress if callable(progress) else None
        self.visible = sys.stderr.isatty() if progress is None else progress is True
        self.written = 0

    def __enter__(self) -> Callable[[float | None, str], None]:
        return self.tell

    def __exit__(self, *_: object) -> None:
        if self.written:
            print(file=sys.stderr)

    def tell(self, share: float | None, text: str) -> None:
        if share is None:
            if self.visible or self.show:
                print(f"{chr(10) if self.written else ''}veridem: {text}", file=sys.stderr)
                self.written = 0
        elif self.show:
            self.show(share, text)
        elif self.visible:
            print(f"\r{text:{self.written}}", end="", file=sys.stderr, flush=True)
            self.written = len(text)
