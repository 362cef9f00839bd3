/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "fix_step.h"

#include "atom.h"
#include "comm.h"
#include "equation.h"
#include "group.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

static const char *const EXPECTED = "first, damping C, wall GROUP MASS DRIVE DRIVE DRIVE, or relax MODULUS with nine numbers";

/* fix ID group veridem/step [first] [damping C] [wall GROUP MASS DRIVE DRIVE DRIVE]... [relax MODULUS RATES OWED FLUXES]; a drive is a load, NULL for
 * the velocity that the wall has, or return SPEED TURN AGE */
FixVeridemStep::FixVeridemStep(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
  auto number = [&](int k) { return utils::numeric(FLERR, arg[k], false, lmp); };
  for (int k = 3; k < narg;) {
    if (strcmp(arg[k], "first") == 0) {
      first = true;
      k++;
    } else if (strcmp(arg[k], "damping") == 0 && k + 1 < narg) {
      damping = number(k + 1);
      if (!(damping >= 0.0)) error->all(FLERR, "fix veridem/step: found a damping of {}, expected 0 or more", arg[k + 1]);
      k += 2;
    } else if (strcmp(arg[k], "relax") == 0 && k + 10 < narg) {
      box.reset(new RelaxingBox(lmp, number(k + 1)));
      for (int a = 0; a < 3; a++) box->rate[a] = number(k + 2 + a), box->owed[a] = number(k + 5 + a), box->flux[a] = number(k + 8 + a);
      box_change |= BOX_CHANGE_SIZE;
      k += 11;
    } else if (strcmp(arg[k], "wall") == 0 && k + 5 < narg) {
      int place = group->find(arg[k + 1]);
      if (place < 0) error->all(FLERR, "fix veridem/step: there is no group {}", arg[k + 1]);
      Wall wall;
      wall.bit = group->bitmask[place], wall.group = place;
      wall.mass = number(k + 2);
      if (!(wall.mass > 0.0)) error->all(FLERR, "fix veridem/step: found a wall of mass {}, expected more than 0", arg[k + 2]);
      k += 3;
      for (int a = 0; a < 3; a++) k += read_drive(wall, a, narg - k, arg + k);
      walls.push_back(wall);
    } else {
      error->all(FLERR, "fix veridem/step: found {}, expected {}", arg[k], EXPECTED);
    }
  }
  time_integrate = 1;
  scalar_flag = 1;
  extscalar = 1;
  global_freq = 1;
  restart_global = 1;
}

/* Reads what drives a wall along an axis; returns the number of words. */
int FixVeridemStep::read_drive(Wall &wall, int a, int narg, char **arg) {
  auto number = [&](int k) { return utils::numeric(FLERR, arg[k], false, lmp); };
  wall.load[a] = wall.speed[a] = wall.turn[a] = NAN;
  if (narg > 3 && strcmp(arg[0], "return") == 0) {
    wall.speed[a] = number(1), wall.turn[a] = number(2), wall.age = number(3);
    if (!(wall.turn[a] > 0.0)) error->all(FLERR, "fix veridem/step: found a reversal of {}, expected a duration above 0", arg[2]);
    return 4;
  }
  if (narg < 1) error->all(FLERR, "fix veridem/step: a wall has a drive along each axis, expected {}", EXPECTED);
  if (strcmp(arg[0], "NULL") != 0) wall.load[a] = number(0);
  return 1;
}

int FixVeridemStep::setmask() { return first ? FixConst::INITIAL_INTEGRATE : FixConst::FINAL_INTEGRATE; }

bool FixVeridemStep::moves_last(Modify *modify) {
  for (auto *fix : modify->get_fix_by_style("^veridem/step$"))
    if (!dynamic_cast<FixVeridemStep *>(fix)->first) return true;
  return false;
}

void FixVeridemStep::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "fix veridem/step needs atom_style sphere");
  for (const auto &wall : walls) {
    bigint beside = 0;
    for (int i = 0; i < atom->nlocal; i++) beside += (atom->mask[i] & wall.bit) && !(atom->mask[i] & groupbit);
    MPI_Allreduce(MPI_IN_PLACE, &beside, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    if (beside > 0)
      error->all(FLERR, "fix veridem/step: {} spheres of the wall {} are not in the group {} that it moves", beside,
                 group->names[wall.group], group->names[igroup]);
  }
  for (auto *other : modify->get_fix_list()) {
    if (other == this || !other->time_integrate) continue;
    bigint twice = 0;
    for (int i = 0; i < atom->nlocal; i++) twice += (atom->mask[i] & groupbit) && (atom->mask[i] & other->groupbit);
    MPI_Allreduce(MPI_IN_PLACE, &twice, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    if (twice > 0) error->all(FLERR, "fix veridem/step: {} spheres are moved by fix {} {}, too", twice, other->id, other->style);
  }
  if (box) box->init();
}

/* All spheres of a wall have one velocity: that of any, as the forces on all and its schedule change it. */
void FixVeridemStep::drive(Wall &wall) {
  double age = wall.age;
  wall.age += update->dt;
  auto follows = [&](int a) { return !std::isnan(wall.load[a]) || !std::isnan(wall.speed[a]); };
  if (!follows(0) && !follows(1) && !follows(2)) return;
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
  for (int a = 0; a < 3; a++)
    if (!std::isnan(wall.speed[a])) velocity[a] = equation<2>(error, "titania-tip-linear", {wall.speed[a], wall.turn[a], age})[0];
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & wall.bit) std::copy_n(velocity, 3, atom->v[i]);
}

void FixVeridemStep::advance() {
  int held = 0;
  for (auto &wall : walls) drive(wall), held |= wall.bit;
  if (box) box->follow();
  int n = atom->nlocal;
  if (n > 0) {
    moves.resize(n);
    for (int i = 0; i < n; i++) moves[i] = atom->mask[i] & groupbit ? (atom->mask[i] & held ? 2 : 1) : 0;
    int code = veridem_advance(n, atom->x[0], atom->v[0], atom->omega[0], atom->radius, atom->rmass, atom->f[0], atom->torque[0],
                               moves.data(), damping, update->dt, &drag);
    if (code != 0) error->one(FLERR, "veridem: {}", veridem_message());
  }
  if (box) box->grow();
}

/* Energy lost to the damping so far. */
double FixVeridemStep::compute_scalar() {
  double all = 0.0;
  MPI_Allreduce(&drag, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* The energy lost, the age of each wall, and the state of the box. */
void FixVeridemStep::write_restart(FILE *fp) {
  std::vector<double> state = {static_cast<double>(walls.size()), box ? 1.0 : 0.0, compute_scalar()};
  for (const auto &wall : walls) state.push_back(wall.age);
  if (box)
    for (const auto &numbers : {box->rate, box->owed, box->flux}) state.insert(state.end(), numbers.begin(), numbers.end());
  if (comm->me != 0) return;
  int bytes = static_cast<int>(state.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(state.data(), sizeof(double), state.size(), fp);
}

void FixVeridemStep::restart(char *buf) {
  auto *state = reinterpret_cast<double *>(buf);
  if (state[0] != static_cast<double>(walls.size()) || (state[1] != 0.0) != (box != nullptr))
    error->all(FLERR, "fix veridem/step: the restart file has {} walls{}: give it what it had, or another ID", state[0],
               state[1] != 0.0 ? " and a box that relaxes" : "");
  state += 2;
  drag = comm->me == 0 ? *state : 0.0;
  state++;
  for (auto &wall : walls) wall.age = *state++;
  if (box)
    for (auto *numbers : {&box->rate, &box->owed, &box->flux}) std::copy_n(state, 3, numbers->begin()), state += 3;
}
