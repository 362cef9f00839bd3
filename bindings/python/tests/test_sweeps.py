"""A case for several values of its keys."""

import pytest
import veridem

CASE = {
    "title": "A small coated aggregate",
    "model": {"soot": {}},
    "sample": {"aggregate": {"spheres": 20}},
    "experiment": {"restructuring": {"duration": "0.02 ns", "dt": "5 fs"}},
}


def test_every_combination_is_a_row(tmp_path):
    told = []
    keys = {"seed": [1, 2], "sample.aggregate.spheres": [20, 30]}
    table = veridem.sweep(CASE, keys, tmp_path / "sweep", progress=lambda share, text: told.append(share))
    assert table["status"].tolist() == ["finished"] * 4 and sorted(told) == [0.25, 0.5, 0.75, 1.0]
    assert table["sample.aggregate.spheres"].tolist() == ["20", "30"] * 2
    assert veridem.open(table["run"][3]).results and (tmp_path / "sweep" / "summary.csv").exists()
    number = next(column for column in table if column.startswith("final coordination"))
    assert table[number].dtype.kind == "f"
    again = veridem.sweep(CASE, keys, tmp_path / "sweep", progress=False)
    assert again.equals(table)


def test_what_fails_stands_in_the_table(tmp_path):
    keys = {"limits.overlap": [1e-9, 0.9]}
    table = veridem.sweep(CASE, keys, tmp_path / "sweep", progress=False)
    assert table["status"].tolist() == ["halted", "finished"] and "halted" in table["reason"][0]


def test_a_sweep_that_is_stopped_is_resumed(tmp_path):
    with pytest.raises(veridem.Stopped, match="the same call resumes it"):
        veridem.sweep(CASE, {"seed": [1, 2, 3]}, tmp_path / "sweep", max_time=0, progress=False)
    table = veridem.sweep(CASE, {"seed": [1, 2, 3]}, tmp_path / "sweep", progress=False)
    assert (table["status"] == "finished").all()


@pytest.mark.parametrize(
    ("keys", "error", "message"),
    [
        ({"sample.aggregate.sphere": [1]}, ValueError, "sphere"),
        ({"seed": 1}, TypeError, "`seed`: found 1, expected a list of values"),
        ({"seed": "1,2"}, TypeError, "expected a list of values"),
        ({"seed": [1, 1]}, ValueError, "are the same case"),
        ({"seed": []}, ValueError, "a value is empty"),
    ],
)
def test_wrong_keys_are_told(tmp_path, keys, error, message):
    with pytest.raises(error, match=message):
        veridem.sweep(CASE, keys, tmp_path / "sweep", progress=False)
