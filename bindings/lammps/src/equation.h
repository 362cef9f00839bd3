/* SPDX-License-Identifier: GPL-2.0-or-later
 * Equations by id: `veridem eq show ID` tells what they are. */
#ifndef VERIDEM_EQUATION_H
#define VERIDEM_EQUATION_H

#include "error.h"
#include "veridem.h"

#include <array>

namespace LAMMPS_NS {

/* The results of an equation for single numbers. */
template <size_t RESULTS, size_t ARGUMENTS>
std::array<double, RESULTS> equation(Error *error, const char *id, const double (&numbers)[ARGUMENTS]) {
  const double *from[ARGUMENTS];
  double *to[RESULTS];
  std::array<double, RESULTS> results;
  for (size_t k = 0; k < ARGUMENTS; k++) from[k] = numbers + k;
  for (size_t k = 0; k < RESULTS; k++) to[k] = results.data() + k;
  if (veridem_equation(id, 1, from, ARGUMENTS, to, RESULTS) != 0) error->one(FLERR, "veridem: {}", veridem_message());
  return results;
}

}    // namespace LAMMPS_NS

#endif
