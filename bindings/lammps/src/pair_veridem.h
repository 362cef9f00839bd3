/* SPDX-License-Identifier: GPL-2.0-or-later
 * A contact law of veridem as a pair style of LAMMPS. */
#ifndef PAIR_VERIDEM_H
#define PAIR_VERIDEM_H

#include "pair.h"
#include "veridem.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixVeridemHistory;

class PairVeridem : public Pair {
 public:
  PairVeridem(class LAMMPS *, const char *law);
  ~PairVeridem() override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void compute(int, int) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  double memory_usage() override;

  /* Lists the pairs anew, after LAMMPS has. */
  void relist();
  /* The pairs: false if none are listed. */
  bool pairs(size_t &count, const uint32_t *&i, const uint32_t *&j, double *&history);
  /* The spheres of this process. */
  veridem_spheres spheres();
  /* Lets the law forget what it does not keep when neighbours are listed anew. */
  void forget();
  /* Breaks the necks that are loaded beyond their strength at the end of a step. */
  void break_necks();
  /* The ids of all spheres of all processes, ascending. */
  std::vector<tagint> ids();
  /* The place of the law among those of the plugin. */
  int number() const;
  /* Ends LAMMPS with the reason of a failed call on any process. */
  void expect(int code);

  veridem_law *law = nullptr;
  size_t width = 0;             /* numbers of the history of a pair */
  std::vector<double> stored;   /* energies stored now, of this process */
  std::vector<double> lost;     /* energies lost since the beginning, of this process; the last to the breaking of necks */
  bool sums_virial = false;     /* whether the virial is summed in every step */
  double virial_of_step[6];     /* of this process */
  bool stepped = false;         /* whether springs have advanced since they were gathered */

 private:
  std::string name;
  std::vector<std::string> words;
  std::vector<double> largest;    /* radius of each type */
  std::vector<double> moment, contacts;
  veridem_list *pair_list = nullptr;
  bool listed = false;

  FixVeridemHistory *kept() const;
  void make_law(const std::vector<double> &radii);
  void share_inertia(veridem_spheres &);
  void evaluate_again();
  template <class Number> std::vector<Number> gathered(const std::vector<Number> &, MPI_Datatype);
  size_t causes() const { return lost.size() - 1; }
  void refuse_what_cannot_work();
  void refuse_new_sizes();
  void look_at_spheres();
};

}    // namespace LAMMPS_NS

#endif
