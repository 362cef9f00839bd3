/* SPDX-License-Identifier: GPL-2.0-or-later
 * The history of pairs: carried with the spheres from one neighbour list to the next, over processes and restarts. */
#ifndef FIX_VERIDEM_HISTORY_H
#define FIX_VERIDEM_HISTORY_H

#include "fix.h"

#include <cstdio>
#include <vector>

namespace LAMMPS_NS {

class FixVeridemHistory : public Fix {
 public:
  static constexpr const char *ID = "VERIDEM_HISTORY";
  class PairVeridem *pair = nullptr;

  FixVeridemHistory(class LAMMPS *, int, char **);
  ~FixVeridemHistory() override;
  int setmask() override;
  void init() override;
  void setup_pre_exchange() override { gather(); }
  void pre_exchange() override;
  void setup_post_neighbor() override { scatter(); }
  void post_neighbor() override;
  void end_of_step() override;
  void post_run() override { gather(); }

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  double memory_usage() override;

  /* Reads a file of pairs: two ids, and the numbers of their history. */
  void read(const char *);
  /* The losses that a restart has brought; refuses those of another law. */
  void restore_losses();

 private:
  int width;
  /* Of each sphere the partners and histories, 1 + width numbers each: those that are not all zero. */
  std::vector<std::vector<double>> kept;
  /* Its id when its neighbours were listed last, 0 for a sphere that is new. */
  std::vector<tagint> known;
  std::vector<double> restored;
  bigint dangerous = 0, spheres;

  void gather();
  void scatter();
  void forget_deleted();
  int largest() const;
};

}    // namespace LAMMPS_NS

#endif
