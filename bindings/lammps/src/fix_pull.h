/* SPDX-License-Identifier: GPL-2.0-or-later
 * A spring that pulls the centre of mass of some spheres, its far end moving at a velocity. */
#ifndef FIX_VERIDEM_PULL_H
#define FIX_VERIDEM_PULL_H

#include "fix.h"

#include <cstdio>

namespace LAMMPS_NS {

class FixVeridemPull : public Fix {
 public:
  FixVeridemPull(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_vector(int a) override { return force[a]; }
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  double stiffness[3], velocity[3], ramp, origin[3], age;
  double force[3] = {0.0, 0.0, 0.0}, mass = 0.0;
  bool last = false;    /* whether spheres move after the forces */

  void pull();
};

}    // namespace LAMMPS_NS

#endif
