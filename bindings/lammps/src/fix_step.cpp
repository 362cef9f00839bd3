/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "fix_step.h"

#include "atom.h"
#include "error.h"
#include "group.h"
#include "update.h"
#include "veridem.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* fix ID group veridem/step [damping C] [wall GROUP MASS LOAD LOAD LOAD]... : along an axis whose load is NULL a wall keeps its velocity */
FixVeridemStep::FixVeridemStep(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
  for (int k = 3; k < narg;) {
    if (strcmp(arg[k], "damping") == 0 && k + 1 < narg) {
      damping = utils::numeric(FLERR, arg[k + 1], false, lmp);
      if (!(damping >= 0.0)) error->all(FLERR, "fix veridem/step: found a damping of {}, expected 0 or more", arg[k + 1]);
      k += 2;
    } else if (strcmp(arg[k], "wall") == 0 && k + 5 < narg) {
      int place = group->find(arg[k + 1]);
      if (place < 0) error->all(FLERR, "fix veridem/step: there is no group {}", arg[k + 1]);
      Wall wall;
      wall.bit = group->bitmask[place];
      wall.mass = utils::numeric(FLERR, arg[k + 2], false, lmp);
      if (!(wall.mass > 0.0)) error->all(FLERR, "fix veridem/step: found a wall of mass {}, expected more than 0", arg[k + 2]);
      for (int a = 0; a < 3; a++)
        wall.load[a] = strcmp(arg[k + 3 + a], "NULL") == 0 ? NAN : utils::numeric(FLERR, arg[k + 3 + a], false, lmp);
      walls.push_back(wall);
      k += 6;
    } else {
      error->all(FLERR, "fix veridem/step: found {}, expected damping C or wall GROUP MASS LOAD LOAD LOAD", arg[k]);
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

/* All spheres of a wall have one velocity: that of any, pushed by the forces on all. */
void FixVeridemStep::push(Wall &wall) {
  if (std::isnan(wall.load[0]) && std::isnan(wall.load[1]) && std::isnan(wall.load[2])) return;
  double sums[4] = {0.0, 0.0, 0.0, 0.0}, velocity[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & wall.bit)) continue;
    for (int a = 0; a < 3; a++) sums[a] += atom->f[i][a], velocity[a] = atom->v[i][a];
    sums[3] += 1.0;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 4, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, velocity, 3, MPI_DOUBLE, MPI_MAX, world);
  if (sums[3] == 0.0) return;
  if (veridem_push_wall(velocity, sums, wall.load, wall.mass, update->dt) != 0) error->one(FLERR, "veridem: {}", veridem_message());
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & wall.bit) std::copy_n(velocity, 3, atom->v[i]);
}

void FixVeridemStep::final_integrate() {
  int held = 0;
  for (auto &wall : walls) push(wall), held |= wall.bit;
  int n = atom->nlocal;
  if (n == 0) return;
  moves.resize(n);
  for (int i = 0; i < n; i++) moves[i] = atom->mask[i] & groupbit ? (atom->mask[i] & held ? 2 : 1) : 0;
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
