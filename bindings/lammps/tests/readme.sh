#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Does what the README says about LAMMPS, word by word.
set -euo pipefail
cd "$(dirname "$0")/../../.."
rm -rf run/there
steps=$(sed -n '/^## Use it in LAMMPS/,/^## /{/^```sh/,/^```$/{/^```/!p}}' README.md)
[ -n "$steps" ]
bash -euxo pipefail -c "$steps"
