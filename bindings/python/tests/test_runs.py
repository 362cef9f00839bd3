"""Cases are checked, run, stopped, resumed and read."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import veridem

CASE = {
    "title": "A small coated aggregate",
    "model": {"soot": {}},
    "sample": {"aggregate": {"spheres": 30}},
    "experiment": {"restructuring": {"duration": "0.1 ns", "dt": "5 fs"}},
    "output": {"series": "10 ps", "frames": "50 ps"},
}
LONG = {**CASE, "experiment": {"restructuring": {"duration": "2 us", "dt": "5 fs"}}}
QUIET = {"progress": False}


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    return veridem.run(CASE, tmp_path_factory.mktemp("runs") / "done", **QUIET)


def contents(run):
    files = sorted(file for file in run.path.rglob("*") if file.suffix in {".csv", ".xyz", ".bonds", ".jsonl"})
    return {file.relative_to(run.path): file.read_bytes() for file in files}


def test_a_checked_case_has_its_defaults_and_its_plan():
    checked = veridem.check(CASE)
    assert checked["sample"]["aggregate"]["spheres"] == 30
    assert "fractal_dimension" in checked["sample"]["aggregate"] and "plan" in checked and "derived" in checked


def test_a_case_may_be_a_file_a_text_or_a_dict(tmp_path):
    text = veridem._veridem.yaml_of(__import__("json").dumps(CASE))
    file = tmp_path / "case.yaml"
    file.write_text(text)
    plans = [veridem.check(case) for case in (CASE, text, file, str(file))]
    for plan in plans:
        plan.pop("plan")
    assert plans[1:] == plans[:-1]


def test_numbers_of_numpy_and_paths_may_stand_in_a_dict():
    sample = {"aggregate": {"spheres": np.int64(30), "fractal_dimension": np.float64(1.8)}}
    assert veridem.check({**CASE, "sample": sample})["sample"]["aggregate"]["spheres"] == 30
    with pytest.raises(TypeError, match="found object in a case"):
        veridem.check({**CASE, "title": object()})
    with pytest.raises(ValueError, match="found in a case"):
        veridem.check({**CASE, "seed": float("nan")})


def test_wrong_keys_are_told_with_file_line_and_key(tmp_path):
    with pytest.raises(veridem.InputError, match="spheres") as told:
        veridem.check({**CASE, "sample": {"aggregate": {"sphere": 30}}})
    error = told.value
    assert (error.file, error.line) == ("<dict>", 6) and "sphere" in str(error)
    file = tmp_path / "wrong.yaml"
    file.write_text("title: t\nmodel: {soot: {}}\nsample: {aggregate: {spheres: -3}}\nexperiment: {restructuring: {}}\n")
    with pytest.raises(ValueError) as told:
        veridem.run(file, tmp_path / "out", **QUIET)
    assert told.value.problems[0].file == str(file) and told.value.line == 3 and not (tmp_path / "out").exists()
    with pytest.raises(FileNotFoundError) as told:
        veridem.check(tmp_path / "missing.yaml")
    assert told.value.filename == str(tmp_path / "missing.yaml")


def test_a_finished_run_is_read(done):
    assert done.status == "finished" and done.title == CASE["title"] and done.report.exists()
    series = done.series
    assert len(series) == 11 and series["time [ns]"].iloc[-1] == pytest.approx(0.1)
    assert series["stage"].unique().tolist() == ["restructuring"] and series.notna().all().all()
    assert done.events["event"].iloc[0] == "begin"
    assert done.manifest["status"] == "finished"
    assert done.windows is None
    result = next(iter(done.results.values()))
    assert result.unit is not None and any(isinstance(r.value, (int, float)) for r in done.results.values())


def test_frames_are_arrays(done):
    frames = done.frames
    assert len(frames) == 3 and len(frames[1:]) == 2
    frame = frames[-1]
    assert frame.positions.shape == frame.forces.shape == (30, 3) and frame.radii.shape == (30,)
    assert frame["id"].dtype.kind == "i" and frame.time == pytest.approx(0.1) and frame.stage == "restructuring"
    i, j = frame.pairs.T
    distance = np.linalg.norm(frame.positions[i] - frame.positions[j], axis=1)
    assert np.allclose(distance - frame.radii[i] - frame.radii[j], frame.pair_columns["gap"], atol=1e-4)
    assert len(frame.pair_columns["kind"]) == len(frame.pairs) > 28


def test_a_run_is_not_overwritten_unless_forced(done):
    before = contents(done)
    with pytest.raises(FileExistsError, match="force=True"):
        veridem.run(CASE, done.path, **QUIET)
    assert contents(veridem.run(CASE, done.path, force=True, threads=1, **QUIET)) == before


def test_a_case_without_a_file_needs_a_folder():
    with pytest.raises(TypeError, match="`out` is missing"):
        veridem.run(CASE)


def test_a_folder_that_cannot_be_written_is_an_os_error(tmp_path):
    file = tmp_path / "file"
    file.write_text("")
    with pytest.raises(OSError):
        veridem.run(CASE, file / "run", **QUIET)
    with pytest.raises(OSError):
        veridem.open(tmp_path / "missing")


@pytest.mark.skipif(os.name == "nt", reason="limits")
def test_a_full_disk_is_an_os_error_and_leaves_a_run_that_is_resumed(done, tmp_path):
    """A limit on the size of files stands for a full disk: writing fails in the same way, at a place that can be chosen."""
    out = tmp_path / "run"
    case = {**CASE, "output": {**CASE["output"], "checkpoints": "10 ps", "series": "1 steps", "frames": "50 ps"}}
    program = f"""
import resource, veridem
resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, resource.RLIM_INFINITY))
try:
    veridem.run({case!r}, {str(out)!r}, progress=False)
except OSError as error:
    print(type(error).__name__, error.errno, error.filename)
"""
    child = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=300)
    assert child.returncode == 0 and "OSError 27" in child.stdout and str(out) in child.stdout, child.stdout + child.stderr
    assert veridem.open(out).status in ("interrupted", "failed")
    run = veridem.resume(out, **QUIET)
    assert run.status == "finished" and run.frames[-1].positions.tolist() == done.frames[-1].positions.tolist()


def test_a_run_that_is_stopped_by_time_is_resumed_with_the_same_bits(done, tmp_path):
    with pytest.raises(veridem.Stopped, match="veridem.resume") as told:
        veridem.run(CASE, tmp_path / "run", max_time=0.0, **QUIET)
    assert told.value.run == tmp_path / "run" and veridem.open(tmp_path / "run").status == "stopped"
    run = veridem.resume(told.value.run, **QUIET)
    series = run.series
    assert series.equals(done.series) and run.frames[-1].positions.tolist() == done.frames[-1].positions.tolist()
    with pytest.raises(ValueError, match="nothing to resume"):
        veridem.resume(run)


def test_progress_is_told_and_an_exception_in_it_stops_the_run(tmp_path):
    told = []

    def tell(share, text):
        told.append((share, text))
        if len(told) == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        veridem.run(LONG, tmp_path / "run", progress=tell)
    assert all(0 <= share <= 1 and "restructuring" in text for share, text in told)
    assert veridem.open(tmp_path / "run").status == "stopped"


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_ctrl_c_leaves_a_run_that_can_be_resumed(tmp_path):
    program = f"import veridem; veridem.run({LONG!r}, {str(tmp_path / 'run')!r}, progress=print)"
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    child.stdout.readline()
    child.send_signal(signal.SIGINT)
    _, errors = child.communicate(timeout=60)
    assert "KeyboardInterrupt" in errors and "veridem.resume(" in errors
    run = veridem.open(tmp_path / "run")
    assert run.status == "stopped"
    with pytest.raises(veridem.Stopped):
        veridem.resume(run, max_time=0.2, **QUIET)


def test_other_threads_go_on_while_a_case_runs(tmp_path):
    """Two runs at a time, while Python counts."""
    begun, runs = time.monotonic(), {}
    workers = [
        threading.Thread(target=lambda k=k: runs.setdefault(k, veridem.run(CASE, tmp_path / str(k), threads=1, **QUIET)))
        for k in range(2)
    ]
    [worker.start() for worker in workers]
    counted = 0
    while any(worker.is_alive() for worker in workers):
        counted += 1
        assert time.monotonic() < begun + 60
    assert counted > 10 and runs[0].series.equals(runs[1].series)


@pytest.mark.parametrize("threads", [0, 100_000])
def test_numbers_of_threads_have_limits(threads, tmp_path):
    with pytest.raises(ValueError, match="`threads`"):
        veridem.run(CASE, tmp_path / "run", threads=threads)


