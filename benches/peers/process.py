"""What a whole process costs."""

import os
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
HOME = TARGET / "peers"
STOPPED = 75  # the status of a run that was told to stop
PARTICLE_STEPS = 12_000_000  # of one measurement: a few seconds
FEWEST_STEPS = 60  # a large crystal takes seconds to set up, and what is measured must outweigh how much those seconds vary


def run(command, threads, expected=0):
    """CPU seconds, wall-clock seconds, and largest memory in kB of a command that ends with the expected status."""
    environment = os.environ | {"OMP_NUM_THREADS": str(threads), "LD_LIBRARY_PATH": str(HOME / "lib")}
    begin = time.perf_counter()
    words = [str(word) for word in command]
    process = subprocess.Popen(words, env=environment, stderr=subprocess.DEVNULL if expected else None)
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) != expected:
        raise SystemExit(f"failed: {command}")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - begin, usage.ru_maxrss


def per_particle_step(command, threads, cells):
    """CPU and wall-clock seconds per particle and step, from the difference of a long and a short run."""
    particles = count(cells)
    long = max(PARTICLE_STEPS // particles, FEWEST_STEPS)
    return [cost / particles for cost in cost_of_step(lambda steps: command(cells, steps), threads, long // 10, long)]


def cost_of_step(command, threads, short, long, expected=0):
    """CPU and wall-clock seconds per step, from the difference of a run of `long` and one of `short` steps."""
    (cpu_a, wall_a, _), (cpu_b, wall_b, _) = (run(command(steps), threads, expected) for steps in (short, long))
    return [(b - a) / (long - short) for a, b in ((cpu_a, cpu_b), (wall_a, wall_b))]


def count(cells):
    """Spheres in a crystal of orthogonal hexagonal cells."""
    return 4 * cells[0] * cells[1] * cells[2]


def engine(threads, instructions=()):
    """The command that makes the engine advance a crystal by a number of steps, with the widest instructions or those that are named."""
    binary = TARGET / "release" / "hcp_steps"
    return lambda cells, steps: [binary, *cells, steps, threads, *instructions]


def build_engine():
    """Compiles that command."""
    subprocess.run(["cargo", "build", "--release", "--package", "veridem-peers", "--bin", "hcp_steps"], check=True, cwd=ROOT)
