"""Are exported aggregates what programs for optics, mobility and meshes take them for? Called with the program; needs pymstm, miepython, trimesh.

ZENO has no package: its estimate of the capacitance, walks on spheres, is repeated here on the file that it reads.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

os.environ["MIEPYTHON_USE_JIT"] = "0"

import miepython
import numpy
import trimesh
from pymstm import MSTM

WAVELENGTH = 532.0
SOOT = complex(1.95, 0.79)
RADIUS = 14.0
CASE = """title: An aggregate for optics
model: {soot: {}}
sample: {aggregate: {spheres: 20}}
experiment: {restructuring: {duration: 10 ps, dt: 5 fs}}
"""


def exported(program, folder, source, kind):
    """The rows of an exported file, as numbers where they are, and the file."""
    file = folder / f"{source.stem}.{kind}"
    subprocess.run([program, "--quiet", "export", f"--{kind}", source, "--out", file], check=True, stdout=subprocess.DEVNULL)
    return file.read_text().splitlines(), file


def rows(lines, word=None):
    """Rows `x y z r`, behind a word if there is one."""
    words = [line.split() for line in lines]
    if word:
        assert all(row[0] == word for row in words)
        words = [row[1:] for row in words]
    table = numpy.array(words, dtype=float)
    assert table.shape == (len(lines), 4)
    return table


def cross_sections(table, apart=1.0):
    """Extinction and absorption of the spheres by MSTM, nm^2, with their distances multiplied; lengths are size parameters there."""
    x = 2.0 * math.pi / WAVELENGTH * table
    solved = MSTM(
        radii=x[:, 3].tolist(),
        positions=[tuple(apart * centre) for centre in x[:, :3] - x[:, :3].mean(axis=0)],
        ref_re=[SOOT.real] * len(x),
        ref_im=[SOOT.imag] * len(x),
    ).solve()
    area = math.pi * (table[:, 3] ** 3).sum() ** (2.0 / 3.0)
    return solved.q_ext_total * area, solved.q_abs_total * area


def mie(table):
    """The sum of what single spheres take out of the light, nm^2: extinction and absorption."""
    sums = numpy.zeros(2)
    for r in table[:, 3]:
        extinction, scattering, *_ = miepython.efficiencies_mx(SOOT.conjugate(), 2.0 * math.pi * r / WAVELENGTH)
        sums += numpy.array([extinction, extinction - scattering]) * math.pi * r**2
    return sums


def capacitance(table, walks, seed=1):
    """Of spheres, nm: walkers from a sphere around them that reach them before they are lost."""
    rng = numpy.random.default_rng(seed)
    middle = 0.5 * (table[:, :3].min(axis=0) + table[:, :3].max(axis=0))
    launch = (numpy.linalg.norm(table[:, :3] - middle, axis=1) + table[:, 3]).max()
    skin = 1e-5 * launch
    x, inside = launch * directions(rng, walks), 0
    centres = table[:, :3] - middle
    while len(x):
        distance = (numpy.linalg.norm(x[:, None] - centres, axis=2) - table[:, 3]).min(axis=1)
        arrived = distance < skin
        inside += int(arrived.sum())
        x, distance = x[~arrived], distance[~arrived]
        x = x + distance[:, None] * directions(rng, len(x))
        far = numpy.linalg.norm(x, axis=1)
        out = far > launch
        # A walker beyond the launch sphere comes back to it with the probability launch / distance, else never.
        lost = out & (rng.random(len(x)) > launch / numpy.maximum(far, launch))
        back = out & ~lost
        x[back] = returned(rng, x[back], launch)
        x = x[~lost]
    return launch * inside / walks, launch * math.sqrt(inside / walks * (1.0 - inside / walks) / walks)


def directions(rng, count):
    vectors = rng.normal(size=(count, 3))
    return vectors / numpy.linalg.norm(vectors, axis=1, keepdims=True)


def returned(rng, x, launch):
    """Where walkers come back to the launch sphere, by the Poisson kernel of its outside."""
    far = numpy.linalg.norm(x, axis=1)
    rho, u = far / launch, rng.random(len(x))
    cosine = (1.0 + rho**2 - ((rho**2 - 1.0) / (rho - 1.0 + 2.0 * u)) ** 2) / (2.0 * rho)
    axis = x / far[:, None]
    side = numpy.cross(axis, directions(rng, len(x)))
    side /= numpy.linalg.norm(side, axis=1, keepdims=True)
    return launch * (cosine[:, None] * axis + numpy.sqrt(numpy.maximum(1.0 - cosine**2, 0.0))[:, None] * side)


def near(what, found, expected, within):
    print(f"{what}: {found:.6g}, expected {expected:.6g} within {within:.2g}")
    assert abs(found - expected) <= within, what


def optics(program, folder, one, aggregate):
    table = rows(exported(program, folder, one, "mstm")[0])
    assert table.tolist() == [[0.0, 0.0, 0.0, RADIUS]]
    for name, found, expected in zip(("extinction", "absorption"), cross_sections(table), mie(table), strict=True):
        near(f"{name} of a sphere by MSTM, nm^2", found, expected, 1e-4 * expected)
    table = rows(exported(program, folder, aggregate, "mstm")[0])
    sums = mie(table)
    near("extinction of the spheres of an aggregate, forty times as far apart, nm^2", cross_sections(table, 40.0)[0], sums[0], 0.03 * sums[0])
    extinction, absorption = cross_sections(table)
    # Neighbours raise the absorption of soot by some 10 or 20 %; scattering grows with the size of the aggregate.
    near("absorption of the aggregate, nm^2", absorption, 1.15 * sums[1], 0.15 * sums[1])
    assert absorption < extinction < 2.0 * sums[0]


def mobility(program, folder, one, two, aggregate):
    """A sphere has its radius, two that touch 2 ln 2 radii; the hydrodynamic radius of the program is the capacitance of an aggregate."""
    for source, expected in ((one, RADIUS), (two, 2.0 * math.log(2.0) * RADIUS)):
        found, error = capacitance(rows(exported(program, folder, source, "bod")[0], "SPHERE"), 40_000)
        near(f"capacitance of {source.stem}, nm", found, expected, 4.0 * error + 1e-4 * RADIUS)
    done = subprocess.run([program, "--json", "import", aggregate, "--unit", "1 nm"], check=True, capture_output=True, text=True)
    told = json.loads(done.stdout)["shape"]["hydrodynamic radius"]
    found, error = capacitance(rows(exported(program, folder, aggregate, "bod")[0], "SPHERE"), 40_000)
    near("capacitance of the aggregate, nm", found, told["value"], 4.0 * math.hypot(error, told["spread"]))


def meshes(program, folder, one, aggregate):
    for source, spheres in ((one, 1), (aggregate, 20)):
        mesh = trimesh.load(exported(program, folder, source, "ply")[1])
        assert mesh.is_watertight and mesh.is_winding_consistent and mesh.body_count == spheres
        whole = spheres * 4.0 / 3.0 * math.pi * RADIUS**3
        near(f"volume of the mesh of {source.stem}, nm^3", mesh.volume, 0.97 * whole, 0.025 * whole)


def main(program):
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        one, two = folder / "one.xyz", folder / "two.xyz"
        one.write_text(f"1\n\nC 0 0 0 {RADIUS}\n")
        two.write_text(f"2\n\nC 0 0 0 {RADIUS}\nC {2 * RADIUS} 0 0 {RADIUS}\n")
        (folder / "case.yaml").write_text(CASE)
        subprocess.run([program, "--quiet", "run", "case.yaml"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        aggregate = folder / "run/case/frames/restructuring.000001.xyz"
        optics(program, folder, one, aggregate)
        mobility(program, folder, one, two, aggregate)
        meshes(program, folder, one, aggregate)


main(str(pathlib.Path(sys.argv[1]).resolve()))
