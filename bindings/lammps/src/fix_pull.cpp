/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "fix_pull.h"

#include "atom.h"
#include "comm.h"
#include "equation.h"
#include "fix_step.h"
#include "group.h"
#include "update.h"

#include <cstring>

using namespace LAMMPS_NS;

/* fix ID group veridem/pull kx ky kz vx vy vz ramp ox oy oz age */
FixVeridemPull::FixVeridemPull(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
  if (narg != 14) error->all(FLERR, "fix veridem/pull: expected three stiffnesses, a velocity, a ramp, an origin and an age");
  auto number = [&](int k) { return utils::numeric(FLERR, arg[k], false, lmp); };
  for (int a = 0; a < 3; a++) {
    stiffness[a] = number(3 + a);
    velocity[a] = number(6 + a);
    origin[a] = number(10 + a);
    if (!(stiffness[a] >= 0.0)) error->all(FLERR, "fix veridem/pull: found a stiffness of {}, expected 0 or more", arg[3 + a]);
  }
  ramp = number(9);
  age = number(13);
  vector_flag = 1;
  size_vector = 3;
  extvector = 1;
  global_freq = 1;
  restart_global = 1;
}

int FixVeridemPull::setmask() { return FixConst::POST_FORCE; }

void FixVeridemPull::init() {
  mass = group->mass(igroup);
  if (!(mass > 0.0)) error->all(FLERR, "fix veridem/pull: the group {} is empty", group->names[igroup]);
  last = FixVeridemStep::moves_last(modify);
}

void FixVeridemPull::setup(int) { pull(); }

/* The age is that of the positions. */
void FixVeridemPull::post_force(int) {
  bool advance = update->setupflag == 0;
  if (advance && !last) age += update->dt;
  pull();
  if (advance && last) age += update->dt;
}

void FixVeridemPull::pull() {
  double centre[3];
  group->xcm(igroup, mass, centre);
  double tau = equation<1>(error, "titania-ramp", {age, ramp})[0];
  for (int a = 0; a < 3; a++)
    force[a] = equation<1>(error, "titania-harmonic", {stiffness[a], centre[a] - origin[a], 0.0, velocity[a], tau})[0];
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      for (int a = 0; a < 3; a++) atom->f[i][a] += force[a] * (atom->rmass[i] / mass);
}

void FixVeridemPull::write_restart(FILE *fp) {
  if (comm->me != 0) return;
  int bytes = sizeof age;
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(&age, sizeof age, 1, fp);
}

void FixVeridemPull::restart(char *buf) { memcpy(&age, buf, sizeof age); }
