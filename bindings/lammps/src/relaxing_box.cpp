/* SPDX-License-Identifier: GPL-2.0-or-later */
#include "relaxing_box.h"

#include "atom.h"
#include "domain.h"
#include "equation.h"
#include "force.h"
#include "pair_veridem.h"
#include "update.h"

using namespace LAMMPS_NS;

void RelaxingBox::init() {
  pair = dynamic_cast<PairVeridem *>(force->pair);
  if (!pair) error->all(FLERR, "fix veridem/step relax needs a pair_style veridem");
  if (!domain->xperiodic || !domain->yperiodic || !domain->zperiodic || domain->triclinic)
    error->all(FLERR, "fix veridem/step relax needs a box that is periodic along all axes");
  pair->sums_virial = true;
  double here = 0.0;
  for (int i = 0; i < atom->nlocal; i++) here += atom->rmass[i];
  MPI_Allreduce(&here, &mass, 1, MPI_DOUBLE, MPI_SUM, world);
}

void RelaxingBox::follow() {
  // The virial of LAMMPS is positive in compression.
  double virial[3];
  MPI_Allreduce(pair->virial_of_step, virial, 3, MPI_DOUBLE, MPI_SUM, world);
  double volume = domain->xprd * domain->yprd * domain->zprd, dt = update->dt;
  auto stress = equation<3>(error, "mechanics-box-stress", {-virial[0], -virial[1], -virial[2], flux[0], flux[1], flux[2], volume});
  for (int a = 0; a < 3; a++) {
    double inertia = equation<1>(error, "mechanics-box-inertia", {mass, domain->prd[a]})[0];
    rate[a] = equation<1>(error, "mechanics-box-strain-rate", {rate[a], stress[a], modulus, volume, inertia, dt})[0];
    auto [growing, rest] = equation<2>(error, "mechanics-growing-rate", {rate[a], owed[a], dt});
    owed[a] = rest;
    growth[a] = equation<1>(error, "mechanics-growth", {growing, dt})[0];
  }
}

void RelaxingBox::grow() {
  for (int a = 0; a < 3; a++) {
    double side = domain->prd[a], low = domain->boxlo[a];
    for (int i = 0; i < atom->nlocal; i++) atom->x[i][a] = low + (atom->x[i][a] - low) * growth[a];
    domain->boxhi[a] = low + side * growth[a];
  }
  domain->set_global_box();
  domain->set_local_box();
  double here[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    auto of_sphere = equation<3>(error, "mechanics-momentum-flux", {atom->rmass[i], v[0], v[1], v[2]});
    for (int a = 0; a < 3; a++) here[a] += of_sphere[a];
  }
  MPI_Allreduce(here, flux.data(), 3, MPI_DOUBLE, MPI_SUM, world);
}
