/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "fix_plane.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_step.h"
#include "force.h"
#include "pair_veridem.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* fix ID all veridem/plane substrate|tip px py pz nx ny nz [velocity vx vy vz] */
FixVeridemPlane::FixVeridemPlane(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
  bool moves = narg == 14 && strcmp(arg[10], "velocity") == 0;
  if (narg != 10 && !moves)
    error->all(FLERR, "fix veridem/plane: expected substrate or tip, a point, a normal, and perhaps velocity with three numbers");
  if (igroup != 0) error->all(FLERR, "fix veridem/plane acts on the group all");
  if (strcmp(arg[3], "substrate") != 0 && strcmp(arg[3], "tip") != 0)
    error->all(FLERR, "fix veridem/plane: found {}, expected substrate or tip", arg[3]);
  material = strcmp(arg[3], "tip") == 0;
  for (int a = 0; a < 3; a++) {
    point[a] = utils::numeric(FLERR, arg[4 + a], false, lmp);
    normal[a] = utils::numeric(FLERR, arg[7 + a], false, lmp);
    if (moves) velocity[a] = utils::numeric(FLERR, arg[11 + a], false, lmp);
  }
  double length = std::hypot(normal[0], normal[1], normal[2]);
  if (std::fabs(length - 1.0) > 1e-12) error->all(FLERR, "fix veridem/plane: the normal has the length {}, expected 1", length);
  pair = dynamic_cast<PairVeridem *>(Pointers::force->pair);
  if (!pair) error->all(FLERR, "fix veridem/plane needs pair_style veridem/soot before it");
  number = pair->number();
  width = static_cast<int>(pair->width) - 1;
  stored.assign(pair->stored.size(), 0.0);
  lost.assign(pair->lost.size() - 1, 0.0);
  begun = time(0);
  vector_flag = 1;
  size_vector = static_cast<int>(3 + stored.size() + lost.size());
  extvector = 1;
  global_freq = 1;
  restart_peratom = 1;
  restart_global = 1;
  create_attribute = 1;
  maxexchange = width;
  FixVeridemPlane::grow_arrays(atom->nmax);
  std::fill(history.begin(), history.end(), 0.0);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixVeridemPlane::~FixVeridemPlane() {
  if (copymode) return;
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

/* The time some steps ago; the time step may have changed since the beginning. */
double FixVeridemPlane::time(int ago) const { return update->atime + (update->ntimestep - update->atimestep - ago) * update->dt; }

int FixVeridemPlane::setmask() { return FixConst::POST_FORCE; }

void FixVeridemPlane::init() {
  bool same = Pointers::force->pair == pair && pair->number() == number && static_cast<int>(pair->width) == width + 1;
  if (!same) error->all(FLERR, "fix veridem/plane: the pair style that it was made for is gone");
  last = FixVeridemStep::moves_last(modify);
}

void FixVeridemPlane::setup(int vflag) { post_force(vflag); }

void FixVeridemPlane::post_force(int) {
  veridem_spheres of = pair->spheres();
  int advance = update->setupflag == 0;
  // Where spheres move last, the forces are those at the positions of the step before.
  double moved = time(advance && last) - begun, at[3];
  for (int a = 0; a < 3; a++) at[a] = point[a] + velocity[a] * moved;
  force[0] = force[1] = force[2] = 0.0;
  std::fill(stored.begin(), stored.end(), 0.0);
  pair->expect(veridem_plane_step(pair->law, &of, material, at, normal, velocity, history.data(), advance ? update->dt : 0.0,
                                  advance, force, lost.data(), lost.size(), stored.data(), stored.size()));
}

/* Force of the spheres on the plane, energies stored at it, and those lost since the beginning. */
double FixVeridemPlane::compute_vector(int place) {
  auto k = static_cast<size_t>(place);
  double here = k < 3 ? force[k] : k < 3 + stored.size() ? stored[k - 3] : lost[k - 3 - stored.size()], all = 0.0;
  MPI_Allreduce(&here, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

void FixVeridemPlane::write_restart(FILE *fp) {
  std::vector<double> sum(lost.size());
  MPI_Reduce(lost.data(), sum.data(), static_cast<int>(sum.size()), MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  sum.insert(sum.begin(), {static_cast<double>(width), static_cast<double>(sum.size())});
  int bytes = static_cast<int>(sum.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(sum.data(), sizeof(double), sum.size(), fp);
}

void FixVeridemPlane::restart(char *buf) {
  const auto *numbers = reinterpret_cast<double *>(buf);
  if (numbers[0] != width || numbers[1] != static_cast<double>(lost.size()))
    error->all(FLERR, "fix veridem/plane: the restart file is that of another law");
  if (comm->me == 0) std::copy_n(numbers + 2, lost.size(), lost.begin());
}

void FixVeridemPlane::grow_arrays(int nmax) { history.resize(static_cast<size_t>(nmax) * width, 0.0); }

void FixVeridemPlane::copy_arrays(int i, int j, int) { std::copy_n(&history[i * width], width, &history[j * width]); }

void FixVeridemPlane::set_arrays(int i) { std::fill_n(&history[i * width], width, 0.0); }

int FixVeridemPlane::pack_exchange(int i, double *buf) {
  std::copy_n(&history[i * width], width, buf);
  return width;
}

int FixVeridemPlane::unpack_exchange(int nlocal, double *buf) {
  std::copy_n(buf, width, &history[nlocal * width]);
  return width;
}

int FixVeridemPlane::pack_restart(int i, double *buf) {
  buf[0] = size_restart(i);
  std::copy_n(&history[i * width], width, buf + 1);
  return size_restart(i);
}

void FixVeridemPlane::unpack_restart(int nlocal, int nth) {
  double *extra = atom->extra[nlocal];
  int begin = 0;
  for (int n = 0; n < nth; n++) begin += static_cast<int>(extra[begin]);
  std::copy_n(extra + begin + 1, width, &history[nlocal * width]);
}

int FixVeridemPlane::size_restart(int) { return 1 + width; }

int FixVeridemPlane::maxsize_restart() { return 1 + width; }
