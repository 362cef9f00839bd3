/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "fix_step.h"

#include "atom.h"
#include "error.h"
#include "group.h"
#include "update.h"
#include "veridem.h"

#include <cstring>

using namespace LAMMPS_NS;

/* fix ID group veridem/step [damping C] [wall GROUP] */
FixVeridemStep::FixVeridemStep(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
  for (int k = 3; k < narg; k += 2) {
    if (k + 1 == narg) error->all(FLERR, "fix veridem/step: {} needs a value", arg[k]);
    if (strcmp(arg[k], "damping") == 0) {
      damping = utils::numeric(FLERR, arg[k + 1], false, lmp);
      if (!(damping >= 0.0)) error->all(FLERR, "fix veridem/step: found a damping of {}, expected 0 or more", arg[k + 1]);
    } else if (strcmp(arg[k], "wall") == 0) {
      int place = group->find(arg[k + 1]);
      if (place < 0) error->all(FLERR, "fix veridem/step: there is no group {}", arg[k + 1]);
      wall = group->bitmask[place];
    } else {
      error->all(FLERR, "fix veridem/step: found {}, expected damping or wall", arg[k]);
    }
  }
  time_integrate = 1;
  scalar_flag = 1;
  extscalar = 1;
  global_freq = 1;
}

int FixVeridemStep::setmask() { return FixConst::FINAL_INTEGRATE; }

void FixVeridemStep::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "fix veridem/step needs atom_style sphere");
}

void FixVeridemStep::final_integrate() {
  int n = atom->nlocal;
  if (n == 0) return;
  moves.resize(n);
  for (int i = 0; i < n; i++) moves[i] = atom->mask[i] & groupbit ? (atom->mask[i] & wall ? 2 : 1) : 0;
  int code = veridem_advance(n, atom->x[0], atom->v[0], atom->omega[0], atom->radius, atom->rmass, atom->f[0], atom->torque[0],
                             moves.data(), damping, update->dt, &drag);
  if (code != 0) error->one(FLERR, "veridem: {}", veridem_message());
}

/* Energy lost to the damping so far. */
double FixVeridemStep::compute_scalar() {
  double all = 0.0;
  MPI_Allreduce(&drag, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}
