/* SPDX-License-Identifier: GPL-2.0-or-later
 * The step of veridem's engine: symplectic Euler with global damping. Positions move after the forces, so that those of a step, its
 * velocities and its springs are in the same order as there; or before them, as those of other fixes that move spheres. */
#ifndef FIX_VERIDEM_STEP_H
#define FIX_VERIDEM_STEP_H

#include "fix.h"
#include "relaxing_box.h"

#include <cstdio>
#include <memory>
#include <vector>

namespace LAMMPS_NS {

class FixVeridemStep : public Fix {
 public:
  FixVeridemStep(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void initial_integrate(int) override { advance(); }
  void final_integrate() override { advance(); }
  double compute_scalar() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  /* Whether the forces of a step are those at the positions of the step before. */
  static bool moves_last(class Modify *);

 private:
  bool first = false;
  double damping = 0.0, drag = 0.0;
  /* A rigid wall: its spheres move as one, along some axes under a load, and else at a velocity: a constant one, or that of an approach
   * which is reversed. */
  struct Wall {
    int bit, group;
    double mass = 1.0, load[3], speed[3], turn[3], age = 0.0;
  };
  std::vector<Wall> walls;
  std::vector<int> moves;
  std::unique_ptr<RelaxingBox> box;

  int read_drive(Wall &, int axis, int narg, char **arg);
  void advance();
  void drive(Wall &);
};

}    // namespace LAMMPS_NS

#endif
