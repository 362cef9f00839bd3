#!/usr/bin/env python3
"""Do the exported equations have the bits of the program? Evaluates each in C, Python, JavaScript and Fortran at the inputs of its golden vectors.

    tests/languages/check.py target/debug/veridem

A language is left out, with a line that says so, if its compiler or interpreter (cc, node, gfortran) is not installed.
"""

import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = {"c": "veridem_equations.h", "python": "veridem_equations.py", "javascript": "veridem_equations.mjs", "fortran": "veridem_equations.f90"}
FLAGS = ["-O2", "-ffp-contract=off"]
BREAK = ", &\n"
# Exported sines and cosines have no value from 2^20 quarter turns on: four to each period of the solvation.
LARGEST = 2**20
QUARTER_TURNS = {
    "titania-4": lambda given: 4 * (given["d"] - given["r_i"] - given["r_j"]) / given["sigma"],
    "titania-04-int": lambda given: 4 * given["x"] / given["sigma"],
    "titania-04-slope": lambda given: 4 * given["x"] / given["sigma"],
}


def output(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr[-2000:]}")
    return done.stdout


def flat(value):
    return [number for part in value for number in flat(part)] if isinstance(value, list) else [float(value)]


def bits(numbers):
    return " ".join(f"{struct.unpack('<Q', struct.pack('<d', number))[0]:016x}" for number in numbers)


def expected(veridem, equations):
    """Every input at which the program has a value: the place of its equation, the arguments, the bits of the results."""
    asked = []
    for place, equation in enumerate(equations):
        paper, name = equation["id"].split("-", 1)
        for vector in json.loads((ROOT / "golden" / paper / f"{name}.json").read_text())["vectors"]:
            asked.append((place, vector["in"]))
    lines = "".join(json.dumps({"id": equations[place]["id"], "in": given}) + "\n" for place, given in asked)
    answers = subprocess.run([veridem, "eq", "eval", "--batch"], input=lines, capture_output=True, text=True).stdout.splitlines()
    assert len(answers) == len(asked)
    out = []
    for (place, given), answer in zip(asked, map(json.loads, answers)):
        equation = equations[place]
        turns = QUARTER_TURNS.get(equation["id"], lambda given: 0)
        if "out" in answer and abs(turns(given)) < LARGEST:
            value = answer["out"]
            named = [value] if len(equation["results"]) == 1 else [value[q["name"]] for q in equation["results"]]
            out.append((place, [x for q in equation["arguments"] for x in flat(given[q["name"]])], bits(flat(named))))
    missing = {equation["id"] for equation in equations} - {equations[place]["id"] for place, _, _ in out}
    assert not missing, f"no vector of {missing} has a finite value"
    return out


def offsets(quantities):
    places, at = [], 0
    for quantity in quantities:
        places.append((at, quantity["size"]))
        at += quantity["size"]
    return places, at


def procedure(equation):
    name = equation["id"].replace("-", "_")
    return f"{name}_{equation['function']}" if equation["numbers"] else name


def single(equation):
    return [q["size"] for q in equation["results"]] == [1]


def c_driver(equations):
    cases = []
    for place, equation in enumerate(equations):
        (inputs, taken), (outputs, given) = offsets(equation["arguments"]), offsets(equation["results"])
        arguments = [f"in[{at}]" if size == 1 else f"in + {at}" for at, size in inputs]
        call = f"veridem_{procedure(equation)}"
        if single(equation):
            cases.append((taken, given, f"out[0] = {call}({', '.join(arguments)});"))
        else:
            cases.append((taken, given, f"{call}({', '.join(arguments + [f'out + {at}' for at, _ in outputs])});"))
    body = "\n".join(f"case {k}: taken = {t}; given = {g}; READ; {call} break;" for k, (t, g, call) in enumerate(cases))
    return f"""#include "veridem_equations.h"
#include <inttypes.h>
#include <stdio.h>
#define READ for (int k = 0; k < taken; k++) if (scanf("%lf", in + k) != 1) return 1
int main(void) {{
    double in[99], out[99];
    int place, taken, given;
    while (scanf("%d", &place) == 1) {{
        switch (place) {{
{body}
        default: return 1;
        }}
        for (int k = 0; k < given; k++) {{
            uint64_t bits;
            memcpy(&bits, out + k, 8);
            printf("%s%016" PRIx64, k ? " " : "", bits);
        }}
        puts("");
    }}
}}
"""


def script_driver(equations, language):
    shapes = json.dumps([[procedure(e), [q["size"] for q in e["arguments"]], [q["name"] for q in e["results"]]] for e in equations])
    if language == "python":
        return f"""import struct, sys, veridem_equations
def flat(value):
    return [x for part in value for x in flat(part)] if isinstance(value, tuple) else [value]
shapes = {shapes}
for line in sys.stdin:
    place, *words = line.split()
    name, sizes, _ = shapes[int(place)]
    numbers = iter(map(float, words))
    arguments = [next(numbers) if size == 1 else [next(numbers) for _ in range(size)] for size in sizes]
    out = flat(getattr(veridem_equations, name)(*arguments))
    print(" ".join(f"{{struct.unpack('<Q', struct.pack('<d', x))[0]:016x}}" for x in out))
"""
    return f"""import * as equations from "./veridem_equations.mjs";
import {{ readFileSync }} from "fs";
const view = new DataView(new ArrayBuffer(8));
const hex = (x) => (view.setFloat64(0, x), view.getBigUint64(0).toString(16).padStart(16, "0"));
const shapes = {shapes};
for (const line of readFileSync(0, "utf8").trim().split("\\n")) {{
  const [place, ...words] = line.split(" ").map(Number);
  const [name, sizes, results] = shapes[place];
  let at = 0;
  const given = sizes.map((size) => (size === 1 ? words[at++] : words.slice(at, (at += size))));
  const out = equations[name](...given);
  const named = results.length === 1 ? [out] : Object.values(out);
  console.log(named.flat().map(hex).join(" "));
}}
"""


def fortran_driver(equations):
    cases = []
    for place, equation in enumerate(equations):
        (inputs, taken), (outputs, given) = offsets(equation["arguments"]), offsets(equation["results"])
        part = lambda name, at, size: f"{name}({at + 1})" if size == 1 else f"{name}({at + 1}:{at + size})"
        arguments = [part("in", at, size) for at, size in inputs]
        if single(equation):
            call = f"out(1) = {procedure(equation)}({BREAK.join(arguments)})"
        else:
            call = f"call {procedure(equation)}({BREAK.join(arguments + [part('out', at, size) for at, size in outputs])})"
        cases.append(f"case ({place})\nread (*, *) in(1:{taken})\n{call}\ngiven = {given}")
    body = "\n".join(cases)
    return f"""program driver
use veridem
use iso_fortran_env, only: int64, real64
implicit none
real(real64) :: in(99), out(99)
integer :: place, given, k, status
do
read (*, *, iostat=status) place
if (status /= 0) exit
select case (place)
{body}
end select
write (*, '(*(z16.16, 1x))') (transfer(out(k), 0_int64), k = 1, given)
end do
end program
"""


def run(language, folder, equations, stdin):
    """The lines that the equations answer with; nothing if the language is not installed."""
    tool = {"c": "cc", "python": sys.executable, "javascript": "node", "fortran": "gfortran"}[language]
    if not shutil.which(tool):
        return None
    if language == "c":
        (folder / "driver.c").write_text(c_driver(equations))
        output([tool, "-std=c99", "-Wall", "-Wextra", "-Werror", *FLAGS, "driver.c", "-o", "driver-c", "-lm"], cwd=folder)
        command = ["./driver-c"]
    elif language == "fortran":
        (folder / "driver.f90").write_text(fortran_driver(equations))
        output([tool, "-std=f2018", *FLAGS, "-fno-range-check", NAMES[language], "driver.f90", "-o", "driver-f"], cwd=folder)
        command = ["./driver-f"]
        stdin = "\n".join(line.replace(" ", "\n", 1) for line in stdin.splitlines())
    else:
        name = {"python": "driver.py", "javascript": "driver.mjs"}[language]
        (folder / name).write_text(script_driver(equations, language))
        command = [tool, name]
    return output(command, cwd=folder, input=stdin).lower().splitlines()


def main(veridem):
    equations = json.loads(output([veridem, "--json", "eq", "list"]))
    vectors = expected(veridem, equations)
    stdin = "".join(f"{place} {' '.join(map(repr, given))}\n" for place, given, _ in vectors)
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for language, name in NAMES.items():
            output([veridem, "eq", "export", "--language", language, "--out", folder / name])
            answers = run(language, folder, equations, stdin)
            if answers is None:
                print(f"{language}: left out, as its compiler or interpreter is not installed")
                continue
            assert len(answers) == len(vectors), f"{language}: {len(answers)} answers to {len(vectors)} questions"
            bad = [(v, a) for v, a in zip(vectors, answers) if a.strip() != v[2]]
            for (place, given, bits_), answer in bad[:5]:
                print(f"{language}: {equations[place]['id']} of {given} is {answer}, not {bits_}", file=sys.stderr)
            wrong += len(bad)
            print(f"{language}: {len({place for place, _, _ in vectors})} equations, {len(vectors) - len(bad)} of {len(vectors)} vectors have the bits of the program")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
