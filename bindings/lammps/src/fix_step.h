/* SPDX-License-Identifier: GPL-2.0-or-later
 * The step of veridem's engine: symplectic Euler with global damping. Positions move after the forces, so that those of a step, its
 * velocities and its springs are in the same order as there. */
#ifndef FIX_VERIDEM_STEP_H
#define FIX_VERIDEM_STEP_H

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

class FixVeridemStep : public Fix {
 public:
  FixVeridemStep(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void final_integrate() override;
  double compute_scalar() override;

 private:
  double damping = 0.0, drag = 0.0;
  /* A rigid wall: its spheres move as one, at a constant velocity or along some axes under a load. */
  struct Wall {
    int bit;
    double mass = 1.0, load[3];
  };
  std::vector<Wall> walls;
  std::vector<int> moves;

  void push(Wall &);
};

}    // namespace LAMMPS_NS

#endif
