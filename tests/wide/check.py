#!/usr/bin/env python3
"""The pair loops are compiled to wide instructions, whatever the instruction set: results cannot show it, as their bits are the same.

    cargo build --release
    python3 tests/wide/check.py target/release/veridem

Counts the multiplications in the disassembly of every contact law. On x86-64, where the program holds a loop for each instruction set.
"""

import re
import subprocess
import sys

REGISTER = {"baseline": "xmm", "avx2": "ymm", "avx512": "zmm"}
# Multiplications of constants before the loop.
SCALAR_SHARE = 0.05
# The titania law without tables solves for the meniscus of one pair after the other: its loops call it.
SOLVED = "veridem_spec..titania..law..Titania$u20$as$u20$veridem_spec..model..PairModel$GT$4pair"


def loops(program):
    """Of every pair loop that evaluates its law: instruction set, function, and its multiplications by register, scalar ones under `scalar`."""
    words = ["objdump", "--disassemble", "--no-show-raw-insn", program]
    text = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout
    for function in text.split("\n\n"):
        name = re.search(r"^[0-9a-f]+ <(.*kernel\d+(baseline|avx2|avx512)\d+(act|act_far)17h.*)>:", function, re.MULTILINE)
        if name is None or re.search(r"\tcall .*" + re.escape(SOLVED), function):
            continue
        count = {}
        for scalar_or_packed, operands in re.findall(r"\tv?mul([sp])d +(.*)", function):
            register = re.search("[xyz]mm", operands)[0] if scalar_or_packed == "p" else "scalar"
            count[register] = count.get(register, 0) + 1
        yield name[2], name[1], count


def main():
    faults, found = [], dict.fromkeys(REGISTER, 0)
    for instructions, name, count in loops(sys.argv[1]):
        found[instructions] += 1
        wide = count.get(REGISTER[instructions], 0)
        if sum(count.values()) - wide > SCALAR_SHARE * wide:
            faults.append(f"{instructions}: {name}: multiplications {count}")
    faults += [f"{instructions}: no pair loop found" for instructions, number in found.items() if number == 0]
    for fault in faults:
        print(fault, file=sys.stderr)
    print("pair loops in wide instructions:", ", ".join(f"{number} {instructions}" for instructions, number in found.items()))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
