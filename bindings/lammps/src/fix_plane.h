/* SPDX-License-Identifier: GPL-2.0-or-later
 * A plane, the substrate or a blunt tip of veridem/soot, that acts on spheres. */
#ifndef FIX_VERIDEM_PLANE_H
#define FIX_VERIDEM_PLANE_H

#include "fix.h"

#include <cstdio>
#include <vector>

namespace LAMMPS_NS {

class FixVeridemPlane : public Fix {
 public:
  FixVeridemPlane(class LAMMPS *, int, char **);
  ~FixVeridemPlane() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:
  class PairVeridem *pair = nullptr;
  int material = 0, width = 0, number = 0;
  double point[3], normal[3], velocity[3] = {0.0, 0.0, 0.0};
  double begun;    /* time at which the plane went through the point */
  double force[3] = {0.0, 0.0, 0.0};
  bool last = false;    /* whether spheres move after the forces */
  std::vector<double> history, stored, lost;

  double time(int steps_ago) const;
};

}    // namespace LAMMPS_NS

#endif
