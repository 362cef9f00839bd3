# SPDX-License-Identifier: GPL-2.0-or-later
"""Scripts that are wrong or unusual: what the plugin must refuse by name, and what it must take."""

import subprocess

import cases
from frames import write_state
from lammps_runs import HEAD, run, script

STREAM = "velocity all set 300 0 0 sum yes units box\n"
TWO_LAWS = f"hybrid {cases.TITANIA} {cases.SOOT}\npair_coeff * * veridem/titania\npair_coeff * * veridem/soot"
UNSTABLE = "limit of stability"
EARLIER = "run 5\nwrite_restart earlier.restart\n"

# What stands in a good script, what replaces it, and what the error must say; None where the script works all the same.
IN_PATCH = [
    ("newton off", "newton on", "newton on"),
    ("comm_modify vel yes", "comm_modify vel no", "comm_modify vel yes"),
    ("units nano", "units si", "units nano"),
    ("check yes", "check no", "neigh_modify check"),
    ("check yes", "check yes once yes", "once no"),
    ("neighbor 1.0", "neighbor 0.0", "skin"),
    ("run 2", STREAM.replace("300", "9000") + "run 100", "skin"),
    ("run 2", f"{STREAM}neighbor 1e-6 bin\nrun 20", "skin"),
    ("young_modulus 73000", "young_modulos 73000", "young_modulos"),
    ("young_modulus 73000", "young_modulus nan", "found `nan`"),
    ("young_modulus 73000", "young_modulus 1e999", "found `1e999`"),
    ("poisson_ratio 0.17", "poisson_ratio 0.4", "0.4"),
    ("scaling 0.5", "", "`scaling` is missing"),
    ("scaling 0.5", "scaling 0.5 scaling 0.5", "twice"),
    ("scaling 0.5", "scaling", "found 0 values"),
    ("history state.history", "history none.history", "none.history"),
    ("history state.history", "history short.history", "line 2"),
    ("history state.history", "history stray.history", "do not exist"),
    ("history state.history", "history neck.history", "necks"),
    ("history state.history", "history half.history", "expected 1 for a neck or 0"),
    ("history state.history", "history twice.history", "is given twice"),
    ("history state.history", "history nan.history", "nan"),
    ("history state.history", "history .", "cannot read the history file"),
    ("pair_coeff * * history state.history", "pair_coeff 1 2", "* *"),
    ("pair_coeff * * history state.history", "", "coeffs are not set"),
    ("pair_style veridem/wear", "pair_style veridem/rubber", "veridem/rubber"),
    ("run 2", "set atom 5 x NAN\nrun 2", ""),
    ("run 2", "set atom 5 vx 1e308\nrun 2", "not finite"),
    ("run 2", "set atom 5 diameter 0\nrun 2", "the radius 0"),
    ("run 2", "compute s all stress/atom NULL\nthermo_style custom step c_t\ncompute t all reduce sum c_s[1]\nrun 2", ""),
    ("run 2", "minimize 0 1e-8 10 10", "minimize"),
    ("run 2", "run_style respa 2 2\nrun 1", "respa"),
    ("run 2", "run 5\ngroup few id 10:20\ndelete_atoms group few\nrun 5", "compress no"),
    ("run 2", "run 5\nreset_atoms id\nrun 5", "storing atom IDs"),
    ("run 2", "run 2\nunfix VERIDEM_HISTORY\nrun 2", "not removed"),
    ("run 2", "fix mine all veridem/history 4 0\nrun 2", "that is gone"),
    ("pair_style", "fix VERIDEM_HISTORY all veridem/history 4 0\npair_style", "VERIDEM_HISTORY"),
    ("run 2", "change_box all x scale 0.3 remap\nrun 2", "a periodic side"),
    ("fix step all", "group mobile subtract all wall\nfix step mobile", "not in the group mobile"),
    ("fix step all", "fix before all nve/sphere\nfix step all", "moved by fix before"),
    ("fix step all veridem/step", "fix step all veridem/step damping -1", "damping"),
    ("run 2", "fix pull all veridem/pull 1 2 3\nrun 1", "three stiffnesses"),
    ("run 2", "group none empty\nfix pull none veridem/pull 1 1 1 0 0 0 0 0 0 0 0\nrun 1", "the group none is empty"),
    ("run 2", "fix plane all veridem/plane substrate 0 0 0 0 0 1\nrun 1", "no such surface"),
    ("run 2", "run 0\nrun 0\nrun 2", None),
    ("run 2", "run 5\nrun 5 pre no post no\nrun 5", None),
    ("run 2", "run 5\nreset_timestep 0\nrun 5", None),
    ("run 2", "run 5\ngroup few id 10:20\ndelete_atoms group few compress no\nrun 5", None),
    ("run 2", "run 2\nunfix VERIDEM_HISTORY\npair_coeff * *\nrun 2", None),
    ("run 2", f"run 2\npair_style {cases.WEAR}\nrun 2", None),
    ("run 2", "change_box all triclinic\nchange_box all xy final 3\nrun 5", None),
    ("run 2", "fix shape all deform 1 x erate 0.01 remap v\nrun 20", None),
    ("run 2", "run 5\nbalance 1.0 shift xyz 5 1.0\nrun 5", None),
    ("pair_style veridem/wear", "comm_style tiled\nfix even all balance 5 1.0 rcb\npair_style veridem/wear", None),
    ("run 2", "dump all all custom 5 all.dump id type x y z vx vy vz\nrun 20\nundump all\nrerun all.dump dump x y z vx vy vz\nrun 5", None),
]
IN_AGGREGATE = [
    ("run 2", "run 5\ngroup few id 10:12\ndelete_atoms group few compress no\nrun 5", None),
    ("run 2", "region all block -1e4 1e4 -1e4 1e4 -1e4 1e4\nfix gone all evaporate 1 1 all 1234\nrun 5", "are gone"),
    ("run 2", f"run 1\npair_style {cases.SOOT} break_energy 5\nrun 1", "when necks break"),
    (f"{cases.SOOT}\npair_coeff * * history state.history", TWO_LAWS, "one pair style veridem"),
    ("run 2", "timestep 1\nrun 0", UNSTABLE),
]
IN_FILM = [
    ("state.data", "molecule.data", "the molecule 2000000000"),
    ("state.data", "moment.data", "the moment -1"),
]
AFTER_RESTART = [
    (cases.WEAR, "", None),
    (cases.WEAR, "group few id 10:20\ndelete_atoms group few compress no\n", None),
    (cases.SOOT, "", "of another law"),
    (cases.TITANIA, "", "of another law"),
    (f"{cases.WEAR}\nfix step all veridem/step damping 1", "", "has 1 walls"),
]


def outcomes(folder, patch, aggregate, film):
    """Each script in words, and whether it ended as it must."""
    files(folder / "patch", patch)
    yield from tried(folder / "patch", script(patch, cases.WEAR, 6e-5) + "run 2\n", IN_PATCH)
    files(folder / "aggregate", aggregate)
    step = "fix step all veridem/step"
    yield from tried(folder / "aggregate", script(aggregate, cases.SOOT, 5e-6, step=step) + "run 2\n", IN_AGGREGATE)
    files(folder / "film", film)
    members(folder / "film")
    rigid = "neigh_modify exclude molecule/intra all"
    yield from tried(folder / "film", script(film, cases.TITANIA, 5e-4, after=rigid) + "run 2\n", IN_FILM)
    yield from restarted(folder / "patch", script(patch, cases.WEAR, 6e-5) + EARLIER)


def files(folder, frame):
    """A state, and histories that are wrong."""
    write_state(folder, frame)
    head, *rows = (folder / "state.history").read_text().splitlines()
    first = rows[0].split() if rows else ["1", "2", "0", "0.1"]
    wrong = {
        "short": first[:-1],
        "stray": ["1", "99999", *first[2:]],
        "neck": ["1", "400", "1", *first[3:]],
        "half": [*first[:2], "0.5", *first[3:]],
        "nan": [*first[:3], "nan", *first[4:]],
    }
    for name, row in wrong.items():
        (folder / f"{name}.history").write_text(f"{head}\n{' '.join(row)}\n")
    (folder / "twice.history").write_text("\n".join([head, " ".join(first), " ".join(first), ""]))


def members(folder):
    """States whose bodies are wrong."""
    head, rows = (folder / "state.data").read_text().split("\nMembers\n\n")
    words = [row.split() for row in rows.splitlines()]
    for name, place, value in (("molecule", 1, "2000000000"), ("moment", 2, "-1")):
        wrong = [[*row[:place], value, *row[place + 1 :]] if row[0] == "7" else row for row in words]
        (folder / f"{name}.data").write_text(f"{head}\nMembers\n\n" + "\n".join(map(" ".join, wrong)) + "\n")


def tried(folder, good, scripts):
    """Runs a script with each of the replacements on two processes."""
    for find, replace, expected in scripts:
        assert find in good, find
        yield tell(folder, good.replace(find, replace, 1), replace or f"without {find}", expected)


def tell(folder, text, what, expected):
    what = what.strip().replace("\n", "; ")
    # A warning does not end the run.
    fails = expected not in (None, UNSTABLE)
    try:
        out = run(folder, text, ranks=2, fails=fails)
    except (SystemExit, subprocess.TimeoutExpired) as error:
        return f"{'refused' if fails else 'taken'}: {what}: {error}", False
    named = (expected or "") in out and ("ERROR" in out) == fails and "panicked" not in out
    return f"{'refused' if fails else 'taken'}: {what}", named


def restarted(folder, earlier):
    """Scripts that go on from a restart file."""
    run(folder, earlier, ranks=2)
    for style, before, expected in AFTER_RESTART:
        fix = "" if "fix step" in style else "fix step all veridem/step wall wall 1 NULL NULL NULL"
        text = f"""{HEAD}read_restart earlier.restart
fix bodies all property/atom mol d_moment ghost yes
neighbor 1.0 bin
neigh_modify every 1 delay 0 check yes one 100000 page 1000000
{before}pair_style {style.split(chr(10))[0]}
pair_coeff * *
timestep 6e-05
{fix or style.split(chr(10))[1]}
run 2
"""
        yield tell(folder, text, f"after a restart: {before}{style}", expected)
