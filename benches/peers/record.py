#!/usr/bin/env python3
"""Runs a short selection of the benchmarks, adds their times to benches/history.csv, and prints the change since the last entry of the same processor.

    python3 benches/peers/record.py

Times are compared as multiples of the time of a copy, taken in the same run: a busy machine slows both.
"""

import csv
import datetime
import json
import re
import subprocess
from time import time as now

from process import ROOT, TARGET

HISTORY = ROOT / "benches" / "history.csv"
COLUMNS = ["date", "commit", "processor", "benchmark", "ns", "copies"]
SELECTION = {
    "kernels": "^(wear-3|titania-8|wear, pairs|soot, pairs|titania, pairs)/",
    "engine": "^(step/6048 spheres, 1 threads|step of a soot aggregate/)",
}
COPY = "wear, pairs/copy"
SLOWER = 1.15  # what repeats do not explain


def processor():
    """Name, family and model, as the name alone may stand for several."""
    text = open("/proc/cpuinfo").read()
    entry = lambda key: re.search(rf"^{key}\s*: (.*)$", text, re.MULTILINE).group(1)
    return f"{entry('model name')} {entry('cpu family')}/{entry('model')}"


def measure():
    """Nanoseconds per element of every benchmark of the selection."""
    begin = now()
    for bench, names in SELECTION.items():
        subprocess.run(["cargo", "bench", "--bench", bench, "--", names], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
    times = {}
    for file in (TARGET / "criterion").glob("**/new/benchmark.json"):
        samples = file.with_name("sample.json")
        if samples.stat().st_mtime >= begin:
            about, sample = json.loads(file.read_text()), json.loads(samples.read_text())
            # The shortest: whatever else the machine does only adds to it.
            shortest = min(time / count for time, count in zip(sample["times"], sample["iters"]))
            times[about["full_id"]] = shortest / about["throughput"]["Elements"]
    return times


def last(rows, host):
    """The newest multiples of a copy that were taken on a processor, by benchmark."""
    return {row["benchmark"]: float(row["copies"]) for row in rows if row["processor"] == host}


def main():
    rows = list(csv.DictReader(HISTORY.open())) if HISTORY.exists() else []
    host, date = processor(), datetime.date.today().isoformat()
    commit = subprocess.check_output(["git", "describe", "--always", "--dirty"], cwd=ROOT, text=True).strip()
    before, times = last(rows, host), measure()
    new = not HISTORY.exists()
    with HISTORY.open("a", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        if new:
            table.writerow(COLUMNS)
        for name, ns in sorted(times.items()):
            copies = ns / times[COPY]
            table.writerow([date, commit, host, name, f"{ns:.4g}", f"{copies:.4g}"])
            change = copies / before[name] if name in before else None
            note = "new" if change is None else f"{change:.2f} times the last" + (" SLOWER" if change > SLOWER else "")
            print(f"{name}: {ns:.4g} ns, {copies:.4g} copies, {note}")


if __name__ == "__main__":
    main()
