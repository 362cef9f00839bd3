"""Do other programs read what a run writes? Called with the program; needs ovito, ase, pyvista and pandas."""

import pathlib
import subprocess
import sys
import tempfile

import ase.io
import numpy
import pandas
import pyvista
from ovito.io import import_file
from ovito.modifiers import LoadTrajectoryModifier
from vtkmodules.vtkIOHDF import vtkHDFReader

CASES = pathlib.Path(__file__).parent.parent / "cases" / "good"
NECK = 2


def runs(program, folder):
    """The run folders of small cases, with frames for OVITO, ASE and ParaView."""
    for name in ["soot-short", "junction", "titania-agglomerate"]:
        case = (CASES / f"{name}.yaml").read_text()
        case = case.replace("output:\n", "output:\n  format: [extxyz, vtp, vtkhdf]\n").replace(
            "output: {", "output: {format: [extxyz, vtp, vtkhdf], "
        )
        if "format:" not in case:
            case += "output: {format: [extxyz, vtp, vtkhdf]}\n"
        (folder / f"{name}.yaml").write_text(case)
        subprocess.run([program, "--quiet", "run", f"{name}.yaml"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        yield folder / "run" / name


def tables(run):
    """Every cell of every table holds a value."""
    paths = sorted(run.glob("*.csv"))
    assert paths
    for path in paths:
        table = pandas.read_csv(path)
        assert not table.isna().any().any(), path
    series = pandas.read_csv(run / "series.csv")
    assert series["time [ns]"].is_monotonic_increasing
    return list(series["stage"].unique())


def pairs_of(path):
    """The pairs of a local dump: ids, kinds and gaps."""
    lines = path.read_text().splitlines()
    names = lines[8].split()[2:]
    rows = [dict(zip(names, map(float, line.split()))) for line in lines[9:]]
    assert len(rows) == int(lines[3])
    return names, rows


def read_vtkhdf(path):
    """What VTK reads from a file."""
    reader = vtkHDFReader()
    assert reader.CanReadFile(str(path)), path
    reader.SetFileName(str(path))
    reader.Update()
    return pyvista.wrap(reader.GetOutput())


def vtkhdf(file, other, atoms, points, lines):
    """VTK reads the same from VTKHDF as from XML and as ASE from the extended XYZ file, under the names of ON-DEM."""
    spheres = read_vtkhdf(file.with_suffix(".vtkhdf"))
    assert spheres.n_points == spheres.n_verts == len(atoms)
    assert spheres.field_data["TimeValue"] == [atoms.info["Time"]]
    assert numpy.allclose(spheres.points, atoms.positions, rtol=1e-6)
    assert numpy.array_equal(spheres["body_id"], atoms.arrays["id"])
    assert numpy.allclose(spheres["velocity"], atoms.arrays["velo"], rtol=1e-6)
    theirs = {"body_id": "id", "velocity": "velo"}
    assert set(points.point_data) == {theirs.get(name, name) for name in spheres.point_data}
    for name in spheres.point_data:
        assert numpy.allclose(spheres[name], points[theirs.get(name, name)], rtol=1e-6), name
    joined = read_vtkhdf(other("pairs", ".vtkhdf"))
    assert joined.n_lines == lines.n_lines
    assert set(joined.cell_data) - {"id1", "id2"} == set(lines.cell_data) - {"ids"}
    if lines.n_lines:
        assert numpy.allclose(joined.points, lines.points, rtol=1e-6)
        assert numpy.array_equal(numpy.stack([joined["id1"], joined["id2"]], axis=1), lines["ids"])
    for name in set(joined.cell_data) - {"id1", "id2"}:
        sign = -1 if name == "normal_force" else 1
        assert numpy.allclose(sign * joined[name], lines[name], rtol=1e-6), name
    if other("surfaces", ".vtp").exists():
        triangles = read_vtkhdf(other("surfaces", ".vtkhdf"))
        expected = pyvista.read(other("surfaces", ".vtp"))
        assert triangles.n_cells == expected.n_cells > 0
        assert numpy.array_equal(triangles["surface"], expected["surface"])
        assert numpy.allclose(triangles.points, expected.points, rtol=1e-6)


def frames(run, stage):
    """OVITO, ASE and VTK find the same spheres and pairs, in every frame."""
    stage = stage.replace(" ", "-")
    files = sorted((run / "frames").glob(f"{stage}.*.xyz"))
    names, _ = pairs_of(files[0].with_suffix(".bonds"))
    pipeline = import_file(str(run / "frames" / f"{stage}.*.xyz"))
    bonds = LoadTrajectoryModifier()
    columns = ["Particle Identifiers.1", "Particle Identifiers.2", "Bond Type"] + names[3:]
    bonds.source.load(str(run / "frames" / f"{stage}.*.bonds"), columns=columns)
    pipeline.modifiers.append(bonds)
    assert pipeline.source.num_frames == bonds.source.num_frames == len(files)
    reader = pyvista.get_reader(run / "frames" / f"{stage}.pvd")
    assert len(reader.time_values) == len(files)
    for number, file in enumerate(files):
        _, pairs = pairs_of(file.with_suffix(".bonds"))
        data = pipeline.compute(number)
        atoms = ase.io.read(file)

        def other(kind, ending):
            return (file.parent / file.name.replace(f"{stage}.", f"{stage}-{kind}.")).with_suffix(ending)

        points = pyvista.read(file.with_suffix(".vtp"))
        lines = pyvista.read(other("pairs", ".vtp"))
        vtkhdf(file, other, atoms, points, lines)
        assert data.particles.count == len(atoms) == points.n_points
        assert data.particles.bonds.count == len(pairs) == lines.n_lines
        assert numpy.allclose(data.particles.positions, atoms.positions, rtol=1e-6)
        assert numpy.allclose(atoms.positions, points.points, rtol=1e-6)
        assert numpy.allclose(data.particles["Force"], points["force"], rtol=1e-5)
        assert abs(data.attributes["Time"] - reader.time_values[number]) < 1e-9
        # Each contact and neck counts for both of its spheres.
        kinds = numpy.array([pair["btype"] for pair in pairs])
        assert points["coordination"].sum() == 2 * (kinds < 3).sum()
        assert points["necks"].sum() == 2 * (kinds == NECK).sum()
        length = numpy.linalg.norm(lines.points[1::2] - lines.points[0::2], axis=1)
        radius = dict(zip(points["id"], points["radius"]))
        gaps = [d - radius[i] - radius[j] for d, (i, j) in zip(length, lines["ids"])]
        assert numpy.allclose(gaps, lines["gap"], atol=1e-3)
    return len(files), max(kinds, default=0)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        for run in runs(program, pathlib.Path(folder)):
            for stage in tables(run):
                number, _ = frames(run, stage)
                print(f"{run.name}, {stage}: {number} frames are read alike by OVITO, ASE and VTK")


main()
