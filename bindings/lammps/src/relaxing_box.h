/* SPDX-License-Identifier: GPL-2.0-or-later
 * A periodic box whose sides follow the stress inside it, as the engine relaxes a sample. */
#ifndef VERIDEM_RELAXING_BOX_H
#define VERIDEM_RELAXING_BOX_H

#include "pointers.h"

#include <array>

namespace LAMMPS_NS {

class RelaxingBox : protected Pointers {
 public:
  std::array<double, 3> rate;    /* of strain of the sides, 1/ns */
  std::array<double, 3> owed;    /* sum of the rates of the steps before in which a side did not grow, 1/ns */
  std::array<double, 3> flux;    /* of momentum after the last step */

  RelaxingBox(class LAMMPS *lmp, double young_modulus) : Pointers(lmp), modulus(young_modulus) {}
  /* Before the first step of a run. */
  void init();
  /* The growth of the sides under the stress of a step. */
  void follow();
  /* After all spheres have moved: lets the sides grow, and all spheres with them. */
  void grow();

 private:
  double modulus, mass = 0.0, growth[3];
  class PairVeridem *pair = nullptr;
};

}    // namespace LAMMPS_NS

#endif
