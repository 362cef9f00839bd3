"""What the README of the repository says works."""

from pathlib import Path

import matplotlib
import veridem

ROOT = Path(__file__).parents[3]


def test_the_lines_from_import_to_plot_run(tmp_path, monkeypatch):
    matplotlib.use("agg")
    readme = (ROOT / "README.md").read_text()
    program = readme.split("## Use it from Python")[1].split("```python\n")[1].split("```")[0]
    (tmp_path / "cases").symlink_to(ROOT / "cases")
    monkeypatch.chdir(tmp_path)
    exec(program, {})
    assert (tmp_path / "approach.png").stat().st_size > 1000
    assert veridem.open("run/pair").status == "finished"
