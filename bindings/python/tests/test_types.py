"""The stubs are those of the module, and the package is typed."""

import subprocess
import sys
from pathlib import Path

import pytest
import veridem

HERE = Path(__file__).parents[1]


def passes(*command):
    done = subprocess.run([sys.executable, *command], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_are_those_of_the_tables():
    passes(HERE / "stubs.py", "--check")


def test_stubs_have_the_names_and_arguments_of_the_module():
    pytest.importorskip("mypy")
    passes("-m", "mypy.stubtest", "veridem", "--concise", "--ignore-disjoint-bases")


def test_the_package_is_typed():
    pytest.importorskip("mypy")
    passes("-m", "mypy", "--strict", "-p", "veridem")


def test_a_program_of_a_user_is_typed(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text(
        "import numpy as np\n"
        "import veridem\n"
        "from typing import assert_type\n"
        "from numpy.typing import NDArray\n"
        "assert_type(veridem.wear.normal_force(1.0, 1.0, 2.0, 0.5), float)\n"
        "assert_type(veridem.wear.normal_force(1.0, 1.0, 2.0, np.zeros(3)), NDArray[np.float64])\n"
        "run = veridem.run('case.yaml', out='run/case', threads=2)\n"
        "print(run.series['time [ns]'], run.results['x'].unit, run.frames[-1].positions)\n"
    )
    passes("-m", "mypy", "--strict", str(program))
    program.write_text("import veridem\nveridem.wear.normal_force(1.0, 1.0, 2.0, delta_m=0.5)\n")
    with pytest.raises(AssertionError, match="delta_m"):
        passes("-m", "mypy", "--strict", str(program))
    assert veridem.__version__
