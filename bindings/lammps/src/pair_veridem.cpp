/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "pair_veridem.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_history.h"
#include "fix_step.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

using namespace LAMMPS_NS;

PairVeridem::PairVeridem(LAMMPS *lmp, const char *which) : Pair(lmp), name(which) {
  restartinfo = 0;
  one_coeff = 1;
  single_enable = 0;
  manybody_flag = 1;    // no pairwise computes that call single()
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  comm_forward = 2;
}

PairVeridem::~PairVeridem() {
  if (copymode) return;
  if (kept()) modify->delete_fix(FixVeridemHistory::ID);
  veridem_list_free(pair_list);
  veridem_law_free(law);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
  delete[] pvector;
}

int PairVeridem::number() const { return name == "wear" ? 0 : name == "soot" ? 1 : 2; }

/* The fix that keeps the history of the pairs of this style, if there is one: scripts can remove it. */
FixVeridemHistory *PairVeridem::kept() const {
  auto *found = dynamic_cast<FixVeridemHistory *>(modify->get_fix_by_id(FixVeridemHistory::ID));
  return found && found->pair == this ? found : nullptr;
}

void PairVeridem::expect(int code) {
  if (code != 0) error->one(FLERR, "veridem: {}", veridem_message());
}

void PairVeridem::make_law(const std::vector<double> &radii) {
  std::vector<const char *> pointers;
  for (const auto &word : words) pointers.push_back(word.c_str());
  veridem_law *made = nullptr;
  int code = veridem_law_new(name.c_str(), pointers.data(), pointers.size(), radii.data(), radii.size(), &made);
  // The same on every process: all of them stop together.
  if (code != 0) error->all(FLERR, "veridem: {}", veridem_message());
  veridem_law_free(law);
  law = made;
}

/* The words of the law: keys and their values. */
void PairVeridem::settings(int narg, char **arg) {
  if (strcmp(update->unit_style, "nano") != 0)
    error->all(FLERR, "pair_style veridem/{}: found units {}, expected units nano", name, update->unit_style);
  words.assign(arg, arg + narg);
  make_law({});
  size_t kept_width, losses, energies;
  veridem_law_count(law, VERIDEM_HISTORY, &kept_width);
  veridem_law_count(law, VERIDEM_LOSSES, &losses);
  veridem_law_count(law, VERIDEM_STORED, &energies);
  uint64_t every = 0;
  expect(veridem_law_neck_checks(law, &every));
  bool other_checks = kept() && kept()->nevery != static_cast<int>(every);
  if ((width != 0 && width != kept_width) || other_checks)
    error->all(FLERR, "pair_style veridem/{}: these keys change the history of pairs or when necks break; use clear first", name);
  width = kept_width;
  stored.assign(energies, 0.0);
  lost.assign(losses + 1, 0.0);
  nextra = static_cast<int>(energies + lost.size());
  delete[] pvector;
  pvector = new double[nextra];
  if (comm->me == 0) {
    std::string meaning = fmt::format("veridem/{}: compute pair gives", name);
    for (int what : {VERIDEM_STORED, VERIDEM_LOSSES}) {
      size_t count = what == VERIDEM_STORED ? energies : losses;
      meaning += what == VERIDEM_STORED ? " the energies stored:" : "; and lost:";
      for (size_t place = 0; place < count; place++) {
        char text[64];
        veridem_law_name(law, what, place, text, sizeof text);
        meaning += fmt::format(" {}{}", text, what == VERIDEM_LOSSES || place + 1 < count ? "," : "");
      }
    }
    meaning += " breaking";
    utils::logmesg(lmp, meaning + "\n");
  }
}

/* pair_coeff * * [history FILE] */
void PairVeridem::coeff(int narg, char **arg) {
  bool file = narg == 4 && strcmp(arg[2], "history") == 0;
  if ((narg != 2 && !file) || strcmp(arg[0], "*") != 0 || strcmp(arg[1], "*") != 0)
    error->all(FLERR, "pair_coeff of veridem/{}: expected * * or * * history FILE", name);
  int n = atom->ntypes;
  if (!allocated) {
    memory->create(setflag, n + 1, n + 1, "pair:setflag");
    memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
    allocated = 1;
  }
  for (int i = 1; i <= n; i++)
    for (int j = i; j <= n; j++) setflag[i][j] = 1;
  if (!kept()) {
    if (modify->get_fix_by_id(FixVeridemHistory::ID))
      error->all(FLERR, "pair_style veridem/{}: found the fix {}, which another pair style has made or a script; one pair style veridem "
                        "can be used at a time", name, FixVeridemHistory::ID);
    uint64_t every = 0;
    expect(veridem_law_neck_checks(law, &every));
    modify->add_fix(fmt::format("{} all veridem/history {} {}", FixVeridemHistory::ID, width, every));
    auto *made = dynamic_cast<FixVeridemHistory *>(modify->get_fix_by_id(FixVeridemHistory::ID));
    made->pair = this;
    made->restore_losses();
  }
  if (file) kept()->read(arg[3]);
}

void PairVeridem::refuse_what_cannot_work() {
  auto wants = [&](const char *found, const char *expected) {
    error->all(FLERR, "pair_style veridem/{}: found {}, expected {}", name, found, expected);
  };
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    wants("an atom style without radius, mass per atom and angular velocity", "atom_style sphere");
  if (strcmp(update->unit_style, "nano") != 0) wants("other units", "units nano");
  if (force->newton_pair) wants("newton on", "newton off before the box is made");
  if (!comm->ghost_velocity) wants("ghosts without velocities", "comm_modify vel yes");
  if (!atom->tag_enable) wants("atoms without ids", "atom_modify id yes");
  if (!neighbor->dist_check) wants("neigh_modify check no", "neigh_modify check yes, which tests the skin");
  if (neighbor->skin <= 0.0) wants("a skin of zero", "a skin above 0");
  if (neighbor->build_once) wants("neigh_modify once yes", "neigh_modify once no, as spheres find new neighbours");
  if (domain->dimension != 3) wants("dimension 2", "dimension 3");
  if (update->whichflag == 2) wants("minimize", "run: these forces have no energy to be minimised");
  if (!kept()) wants("no history of the pairs", "that the fix which keeps it is not removed");
  if (utils::strmatch(update->integrate_style, "^respa")) wants("run_style respa", "run_style verlet");
}

/* The numbers of all processes, one after the other. */
template <class Number> std::vector<Number> PairVeridem::gathered(const std::vector<Number> &mine, MPI_Datatype type) {
  int here = static_cast<int>(mine.size()), all = 0;
  std::vector<int> counts(comm->nprocs), places(comm->nprocs);
  MPI_Allgather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  for (int p = 0; p < comm->nprocs; p++) places[p] = all, all += counts[p];
  std::vector<Number> every(all);
  MPI_Allgatherv(mine.data(), here, type, every.data(), counts.data(), places.data(), type, world);
  return every;
}

void PairVeridem::init_style() {
  refuse_what_cannot_work();

  // All radii, each once, on every process.
  std::vector<double> radii(atom->radius, atom->radius + atom->nlocal);
  auto once = [](std::vector<double> &numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  };
  once(radii);
  auto every = gathered(radii, MPI_DOUBLE);
  once(every);
  // Only this law needs them, and they may be as many as the spheres.
  if (name == "titania") make_law(every);

  largest.assign(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; i++) largest[atom->type[i]] = std::max(largest[atom->type[i]], atom->radius[i]);
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), atom->ntypes + 1, MPI_DOUBLE, MPI_MAX, world);

  look_at_spheres();

  veridem_list_free(pair_list);
  pair_list = nullptr;
  listed = false;
  expect(veridem_list_new(law, &pair_list));
  // A plain list with the range of each two types: those of granular styles end at the skin and forget stretched pairs.
  neighbor->add_request(this);
}

/* Refuses spheres without size or mass; warns of a time step that is too long for one of them. */
void PairVeridem::look_at_spheres() {
  double most = *std::max_element(largest.begin(), largest.end()), least = HUGE_VAL;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->radius[i] > 0.0 && atom->rmass[i] > 0.0))
      error->one(FLERR, "pair_style veridem/{}: sphere {} has the radius {} and the mass {}, expected more than 0", name, atom->tag[i],
                 atom->radius[i], atom->rmass[i]);
    double limit = 0.0;
    expect(veridem_law_time_step(law, atom->radius[i], atom->rmass[i], most, &limit));
    least = std::min(least, limit);
  }
  MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE, MPI_MIN, world);
  if (!(update->dt < least) && comm->me == 0)
    error->warning(FLERR, "pair_style veridem/{}: the time step {} is not below the limit of stability, {}", name, update->dt, least);
}

double PairVeridem::init_one(int i, int j) {
  double range = 0.0;
  if (largest[i] > 0.0 && largest[j] > 0.0) expect(veridem_law_range(law, largest[i], largest[j], &range));
  return range;
}

/* Pairs are listed for the sizes that were there when the run began. */
void PairVeridem::refuse_new_sizes() {
  for (int i = 0; i < atom->nlocal; i++)
    if (!(atom->radius[i] <= largest[atom->type[i]]))
      error->one(FLERR, "pair_style veridem/{}: sphere {} has a radius of {}, larger than all of its type at the beginning of the run: "
                        "contacts of it would be missed", name, atom->tag[i], atom->radius[i]);
}

std::vector<tagint> PairVeridem::ids() {
  auto all = gathered(std::vector<tagint>(atom->tag, atom->tag + atom->nlocal), MPI_LMP_TAGINT);
  std::sort(all.begin(), all.end());
  return all;
}

void PairVeridem::relist() {
  refuse_new_sizes();
  // Pairs are told apart by the ids of their spheres: an image of a neighbour must not be a neighbour, too.
  const double *inverse = domain->h_inv;
  const double across[3] = {1.0 / std::hypot(inverse[0], inverse[5], inverse[4]), 1.0 / std::hypot(inverse[1], inverse[3]), 1.0 / inverse[2]};
  for (int a = 0; a < 3; a++) {
    double width_of_box = domain->triclinic ? across[a] : domain->prd[a];
    if (domain->periodicity[a] && width_of_box < 2.0 * neighbor->cutneighmax)
      error->all(FLERR, "pair_style veridem/{}: found a periodic side of {}, expected at least {}, twice the reach of neighbours",
                 name, width_of_box, 2.0 * neighbor->cutneighmax);
  }
  expect(veridem_list_build(pair_list, atom->nlocal + atom->nghost, atom->nlocal, atom->tag, list->inum, list->ilist,
                            list->numneigh, list->firstneigh, NEIGHMASK));
  listed = true;
}

bool PairVeridem::pairs(size_t &count, const uint32_t *&i, const uint32_t *&j, double *&history) {
  if (!listed) return false;
  expect(veridem_list_pairs(pair_list, &count, &i, &j, &history));
  return true;
}

veridem_spheres PairVeridem::spheres() {
  size_t owned = atom->nlocal, count = owned + atom->nghost;
  veridem_spheres of = {};
  of.abi = VERIDEM_ABI;
  of.bytes = sizeof of;
  if (count == 0) return of;
  of.count = count, of.owned = owned, of.id = atom->tag;
  of.x = atom->x[0], of.v = atom->v[0], of.omega = atom->omega[0];
  of.radius = atom->radius, of.mass = atom->rmass;
  of.force = atom->f[0], of.torque = atom->torque[0];
  return of;
}

/* Counts the contacts of each sphere, or of its molecule if the spheres have the property d_moment. */
void PairVeridem::share_inertia(veridem_spheres &spheres) {
  int shares = 0;
  expect(veridem_law_shares_inertia(law, &shares));
  if (!shares) return;
  int all = atom->nlocal + atom->nghost, is_double, columns;
  moment.assign(all, 0.0);
  contacts.assign(all, 0.0);
  expect(veridem_list_contacts(pair_list, &spheres, contacts.data()));
  int place = atom->find_custom("moment", is_double, columns);
  if (place >= 0 && is_double == 1 && columns == 0) {
    if (!atom->molecule) error->all(FLERR, "pair_style veridem/{}: d_moment needs the molecules of the spheres", name);
    std::copy(atom->dvector[place], atom->dvector[place] + atom->nlocal, moment.begin());
    for (int i = 0; i < atom->nlocal; i++)
      if (!(moment[i] >= 0.0))
        error->one(FLERR, "pair_style veridem/{}: sphere {} has the moment {}, expected 0 or more", name, atom->tag[i], moment[i]);
    tagint most = 0;
    for (int i = 0; i < atom->nlocal; i++) most = std::max(most, atom->molecule[i]);
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_LMP_TAGINT, MPI_MAX, world);
    // One number for each molecule on every process.
    constexpr bigint MANY = 1 << 24;
    if (most > std::max(MANY, 16 * atom->natoms))
      error->all(FLERR, "pair_style veridem/{}: found the molecule {} of {} spheres, expected that molecules are numbered from 1", name, most,
                 atom->natoms);
    std::vector<double> of(most + 1, 0.0);
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->molecule[i] > 0) of[atom->molecule[i]] += contacts[i];
    MPI_Allreduce(MPI_IN_PLACE, of.data(), most + 1, MPI_DOUBLE, MPI_SUM, world);
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->molecule[i] > 0) contacts[i] = of[atom->molecule[i]];
  }
  comm->forward_comm(this);
  spheres.moment = moment.data();
  spheres.contacts = contacts.data();
}

int PairVeridem::pack_forward_comm(int n, int *ghosts, double *buf, int, int *) {
  for (int k = 0; k < n; k++) buf[2 * k] = contacts[ghosts[k]], buf[2 * k + 1] = moment[ghosts[k]];
  return 2 * n;
}

void PairVeridem::unpack_forward_comm(int n, int first, double *buf) {
  for (int k = 0; k < n; k++) contacts[first + k] = buf[2 * k], moment[first + k] = buf[2 * k + 1];
}

void PairVeridem::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (eflag_atom || vflag_atom) error->all(FLERR, "pair_style veridem/{} has no energy or virial per atom", name);
  veridem_spheres of = spheres();
  share_inertia(of);
  // At the start of a run forces are evaluated for the same time as at the end of the last one.
  int advance = update->setupflag == 0;
  double dt = advance ? update->dt : 0.0;
  stepped = stepped || advance;
  std::fill(stored.begin(), stored.end(), 0.0);
  std::fill(virial_of_step, virial_of_step + 6, 0.0);
  expect(veridem_list_step(pair_list, &of, dt, advance, lost.data(), causes(), eflag_either ? stored.data() : nullptr,
                           eflag_either ? stored.size() : 0, vflag_either || sums_virial ? virial_of_step : nullptr));
  if (vflag_either) std::copy_n(virial_of_step, 6, virial);
  if (eflag_either) {
    for (double energy : stored) eng_vdwl += energy;
    std::copy(stored.begin(), stored.end(), pvector);
    std::copy(lost.begin(), lost.end(), pvector + stored.size());
  }
}

void PairVeridem::forget() {
  int forgets = 0;
  expect(veridem_law_forgets(law, &forgets));
  if (!forgets || !listed) return;
  comm->forward_comm();
  veridem_spheres of = spheres();
  expect(veridem_list_forget(pair_list, &of, lost.data(), causes()));
}

/* The owner of the sphere with the lower id decides about a neck, so that all processes that list it agree. */
void PairVeridem::break_necks() {
  // Spheres may have moved since the copies of those of other processes were sent.
  comm->forward_comm();
  veridem_spheres of = spheres();
  size_t count, pairs_here;
  const uint32_t *places, *i, *j;
  double *history;
  expect(veridem_list_overloaded(pair_list, &of, &count, &places));
  expect(veridem_list_pairs(pair_list, &pairs_here, &i, &j, &history));
  std::vector<tagint> mine;
  for (size_t k = 0; k < count; k++)
    if (i[places[k]] < static_cast<uint32_t>(atom->nlocal)) mine.insert(mine.end(), {atom->tag[i[places[k]]], atom->tag[j[places[k]]]});
  auto all = gathered(mine, MPI_LMP_TAGINT);
  if (all.empty()) return;
  std::set<std::pair<tagint, tagint>> broken;
  for (size_t k = 0; k < all.size(); k += 2) broken.insert({all[k], all[k + 1]});
  std::vector<uint32_t> here;
  for (size_t k = 0; k < pairs_here; k++)
    if (history[k * width] > 0.5 && broken.count({atom->tag[i[k]], atom->tag[j[k]]})) here.push_back(static_cast<uint32_t>(k));
  expect(veridem_list_break(pair_list, &of, here.size(), here.data(), &lost.back()));
  stepped = true;
  if (comm->me == 0)
    for (const auto &neck : broken)
      utils::logmesg(lmp, "veridem: step {}: the neck of {} and {} breaks\n", update->ntimestep, neck.first, neck.second);
  // Velocity Verlet takes the forces at the end of a step for the next one.
  if (!FixVeridemStep::moves_last(modify)) evaluate_again();
}

/* The forces at the end of a step without advancing any spring, as at the start of a run. */
void PairVeridem::evaluate_again() {
  if (atom->nlocal > 0) {
    memset(atom->f[0], 0, 3 * sizeof(double) * atom->nlocal);
    memset(atom->torque[0], 0, 3 * sizeof(double) * atom->nlocal);
  }
  update->setupflag = 1;
  compute(update->eflag_global == update->ntimestep ? ENERGY_GLOBAL : 0, update->vflag_global == update->ntimestep ? VIRIAL_PAIR : 0);
  for (auto *fix : modify->get_fix_list())
    if (modify->get_fix_mask(fix) & FixConst::POST_FORCE) fix->post_force(0);
  update->setupflag = 0;
}

double PairVeridem::memory_usage() {
  size_t count = 0;
  const uint32_t *i, *j;
  double *history;
  if (!pairs(count, i, j, history)) return 0.0;
  return static_cast<double>(count) * (width + 12) * sizeof(double);
}
