/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "fix_history.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "neighbor.h"
#include "pair_veridem.h"
#include "update.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <unordered_map>

using namespace LAMMPS_NS;

FixVeridemHistory::FixVeridemHistory(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
  if (narg != 5) error->all(FLERR, "fix veridem/history is made by pair_coeff of a pair_style veridem");
  width = utils::inumeric(FLERR, arg[3], false, lmp);
  nevery = utils::inumeric(FLERR, arg[4], false, lmp);
  restart_peratom = 1;
  restart_global = 1;
  create_attribute = 1;
  stores_ids = 1;
  maxexchange_dynamic = 1;
  maxexchange = 2;
  spheres = atom->natoms;
  FixVeridemHistory::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixVeridemHistory::~FixVeridemHistory() {
  if (copymode) return;
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixVeridemHistory::setmask() {
  using namespace FixConst;
  int necks_break = nevery > 0 ? END_OF_STEP : 0;
  return PRE_EXCHANGE | POST_NEIGHBOR | POST_RUN | necks_break;
}

void FixVeridemHistory::init() {
  dangerous = neighbor->ndanger;
  if (!pair) error->all(FLERR, "fix veridem/history belongs to a pair_style veridem that is gone");
  if (atom->natoms != spheres) forget_deleted();
  spheres = atom->natoms;
}

/* What spheres have with others that were deleted between two runs. */
void FixVeridemHistory::forget_deleted() {
  const auto ids = pair->ids();
  bigint gone = 0;
  for (int p = 0; p < atom->nlocal; p++) {
    std::vector<double> of;
    for (size_t entry = 0; entry < kept[p].size(); entry += 1 + width) {
      const auto begin = kept[p].begin() + entry;
      if (std::binary_search(ids.begin(), ids.end(), static_cast<tagint>(*begin)))
        of.insert(of.end(), begin, begin + 1 + width);
      else
        gone++;
    }
    kept[p] = of;
  }
  MPI_Allreduce(MPI_IN_PLACE, &gone, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (gone > 0 && comm->me == 0) utils::logmesg(lmp, "veridem: {} contacts and necks with deleted spheres are forgotten\n", gone);
}

int FixVeridemHistory::largest() const {
  size_t most = 0;
  for (int i = 0; i < atom->nlocal; i++) most = std::max(most, kept[i].size());
  return static_cast<int>(most);
}

/* From the list to the spheres: a pair belongs to each of its spheres that this process owns. */
void FixVeridemHistory::gather() {
  size_t count;
  const uint32_t *i, *j;
  double *history;
  // Without a step since then, what the spheres hold is what the list was given.
  if (pair->stepped && pair->pairs(count, i, j, history)) {
    pair->stepped = false;
    for (int p = 0; p < atom->nlocal; p++) kept[p].clear();
    for (size_t k = 0; k < count; k++) {
      const double *numbers = history + k * width;
      if (std::all_of(numbers, numbers + width, [](double number) { return number == 0.0; })) continue;
      const uint32_t ends[2] = {i[k], j[k]};
      for (int end = 0; end < 2; end++) {
        if (ends[end] >= static_cast<uint32_t>(atom->nlocal)) continue;
        auto &of = kept[ends[end]];
        of.push_back(static_cast<double>(atom->tag[ends[1 - end]]));
        of.insert(of.end(), numbers, numbers + width);
      }
    }
  }
  maxexchange = 2 + largest();
}

/* From the spheres to a new list. */
void FixVeridemHistory::scatter() {
  size_t count;
  const uint32_t *i, *j;
  double *history;
  pair->relist();
  if (!pair->pairs(count, i, j, history)) return;
  for (int p = 0; p < atom->nlocal; p++) {
    if (known[p] != 0 && known[p] != atom->tag[p])
      error->one(FLERR, "veridem: sphere {} has become {}, so that contacts would be taken for others: use delete_atoms with compress no, "
                        "and keep the ids", known[p], atom->tag[p]);
    known[p] = atom->tag[p];
  }
  std::vector<int> necks(atom->nlocal, 0);
  for (size_t k = 0; k < count; k++) {
    uint32_t owned = i[k] < static_cast<uint32_t>(atom->nlocal) ? i[k] : j[k];
    uint32_t other = owned == i[k] ? j[k] : i[k];
    auto partner = static_cast<double>(atom->tag[other]);
    const auto &of = kept[owned];
    for (size_t entry = 0; entry < of.size(); entry += 1 + width) {
      if (of[entry] != partner) continue;
      std::copy_n(of.begin() + entry + 1, width, history + k * width);
      if (of[entry + 1] > 0.5)
        for (uint32_t end : {owned, other})
          if (end < static_cast<uint32_t>(atom->nlocal)) necks[end]++;
      break;
    }
  }
  for (int p = 0; p < atom->nlocal; p++) {
    int expected = 0;
    for (size_t entry = 0; entry < kept[p].size(); entry += 1 + width) expected += kept[p][entry + 1] > 0.5;
    if (expected != necks[p])
      error->one(FLERR, "veridem: sphere {} has {} necks, of which {} are not among the neighbours: they are longer than the "
                        "cutoff and the skin, or their spheres were excluded or are gone", atom->tag[p], expected, expected - necks[p]);
  }
}

void FixVeridemHistory::post_neighbor() {
  if (neighbor->ndanger > dangerous)
    error->all(FLERR, "veridem: at step {} spheres had moved by more than half the skin of {} when neighbours were listed: a "
                      "contact may have been missed; use a larger skin, or neigh_modify every 1 delay 0", update->ntimestep, neighbor->skin);
  scatter();
}

/* Neighbours are to be listed anew. */
void FixVeridemHistory::pre_exchange() {
  if (pair->stepped) pair->forget();
  gather();
}

void FixVeridemHistory::end_of_step() { pair->break_necks(); }

void FixVeridemHistory::grow_arrays(int nmax) {
  kept.resize(nmax);
  known.resize(nmax, 0);
}

void FixVeridemHistory::copy_arrays(int i, int j, int) {
  kept[j] = kept[i];
  known[j] = known[i];
}

void FixVeridemHistory::set_arrays(int i) {
  kept[i].clear();
  known[i] = 0;
}

int FixVeridemHistory::pack_exchange(int i, double *buf) {
  buf[0] = static_cast<double>(kept[i].size());
  buf[1] = static_cast<double>(known[i]);
  std::copy(kept[i].begin(), kept[i].end(), buf + 2);
  return 2 + static_cast<int>(kept[i].size());
}

int FixVeridemHistory::unpack_exchange(int nlocal, double *buf) {
  int count = static_cast<int>(buf[0]);
  known[nlocal] = static_cast<tagint>(buf[1]);
  kept[nlocal].assign(buf + 2, buf + 2 + count);
  return 2 + count;
}

/* The losses so far, and before the spheres are written, their history. */
void FixVeridemHistory::write_restart(FILE *fp) {
  gather();
  std::vector<double> sum(pair->lost.size());
  MPI_Reduce(pair->lost.data(), sum.data(), static_cast<int>(sum.size()), MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  sum.insert(sum.begin(), {static_cast<double>(width), static_cast<double>(pair->number()), static_cast<double>(sum.size())});
  int bytes = static_cast<int>(sum.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(sum.data(), sizeof(double), sum.size(), fp);
}

void FixVeridemHistory::restart(char *buf) {
  auto *numbers = reinterpret_cast<double *>(buf);
  if (static_cast<int>(numbers[0]) != width)
    error->all(FLERR, "veridem: the restart file has {} numbers for each pair, expected {}: it is that of another law",
               static_cast<int>(numbers[0]), width);
  restored.assign(numbers + 1, numbers + 3 + static_cast<int>(numbers[2]));
}

void FixVeridemHistory::restore_losses() {
  if (restored.empty()) return;
  if (restored[0] != pair->number() || restored.size() != 2 + pair->lost.size())
    error->all(FLERR, "veridem: the restart file is that of another law than {}", force->pair_style);
  if (comm->me == 0) pair->lost.assign(restored.begin() + 2, restored.end());
}

int FixVeridemHistory::pack_restart(int i, double *buf) {
  buf[0] = static_cast<double>(size_restart(i));
  std::copy(kept[i].begin(), kept[i].end(), buf + 1);
  return size_restart(i);
}

void FixVeridemHistory::unpack_restart(int nlocal, int nth) {
  double *extra = atom->extra[nlocal];
  int begin = 0;
  for (int n = 0; n < nth; n++) begin += static_cast<int>(extra[begin]);
  int count = static_cast<int>(extra[begin]) - 1;
  kept[nlocal].assign(extra + begin + 1, extra + begin + 1 + count);
  known[nlocal] = atom->tag[nlocal];
}

int FixVeridemHistory::size_restart(int i) { return 1 + static_cast<int>(kept[i].size()); }

int FixVeridemHistory::maxsize_restart() {
  int here = 1 + largest(), all = here;
  MPI_Allreduce(&here, &all, 1, MPI_INT, MPI_MAX, world);
  return all;
}

double FixVeridemHistory::memory_usage() {
  double bytes = static_cast<double>(kept.capacity() * sizeof(kept[0]));
  for (const auto &of : kept) bytes += static_cast<double>(of.capacity() * sizeof(double));
  return bytes;
}

void FixVeridemHistory::read(const char *file) {
  std::unordered_map<tagint, int> places;
  for (int i = 0; i < atom->nlocal; i++) {
    places[atom->tag[i]] = i;
    kept[i].clear();
  }
  FILE *fp = nullptr;
  if (comm->me == 0 && !(fp = fopen(file, "r")))
    error->one(FLERR, "veridem: cannot open the history file {}: {}", file, utils::getsyserror());
  constexpr int LINES = 1024, LENGTH = 1024;
  std::vector<char> buffer(LINES * LENGTH);
  bigint line = 0, pairs_of_file = 0, found = 0;
  for (bool more = true; more;) {
    int lines = 0, bytes = 0;
    if (comm->me == 0)
      while (lines < LINES && fgets(buffer.data() + bytes, LENGTH, fp)) {
        bytes += static_cast<int>(strlen(buffer.data() + bytes));
        lines++;
      }
    MPI_Bcast(&lines, 1, MPI_INT, 0, world);
    MPI_Bcast(&bytes, 1, MPI_INT, 0, world);
    MPI_Bcast(buffer.data(), bytes, MPI_CHAR, 0, world);
    more = lines == LINES;
    std::vector<double> numbers;
    for (const auto &text : utils::split_lines(std::string(buffer.data(), bytes))) {
      line++;
      auto words = utils::split_words(text);
      if (words.empty() || words[0][0] == '#') continue;
      if (words.size() != static_cast<size_t>(2 + width))
        error->all(FLERR, "veridem: {}, line {}: found {} numbers, expected two ids and {} numbers", file, line, words.size(), width);
      numbers.clear();
      for (size_t k = 2; k < words.size(); k++) numbers.push_back(utils::numeric(FLERR, words[k], false, lmp));
      if (numbers[0] != 0.0 && numbers[0] != 1.0)
        error->all(FLERR, "veridem: {}, line {}: found {}, expected 1 for a neck or 0", file, line, words[2]);
      tagint ids[2] = {utils::tnumeric(FLERR, words[0], false, lmp), utils::tnumeric(FLERR, words[1], false, lmp)};
      if (ids[0] >= ids[1]) error->all(FLERR, "veridem: {}, line {}: expected the lower id first", file, line);
      pairs_of_file++;
      for (int end = 0; end < 2; end++) {
        auto place = places.find(ids[end]);
        if (place == places.end()) continue;
        auto &of = kept[place->second];
        for (size_t entry = 0; entry < of.size(); entry += 1 + width)
          if (of[entry] == static_cast<double>(ids[1 - end]))
            error->one(FLERR, "veridem: {}, line {}: the pair {}, {} is given twice", file, line, ids[0], ids[1]);
        of.push_back(static_cast<double>(ids[1 - end]));
        of.insert(of.end(), numbers.begin(), numbers.end());
        found++;
      }
    }
  }
  if (fp && ferror(fp)) error->one(FLERR, "veridem: cannot read the history file {}: {}", file, utils::getsyserror());
  if (fp) fclose(fp);
  MPI_Allreduce(MPI_IN_PLACE, &found, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (found != 2 * pairs_of_file)
    error->all(FLERR, "veridem: {} has {} spheres that do not exist", file, 2 * pairs_of_file - found);
}
