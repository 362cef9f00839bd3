/* SPDX-License-Identifier: GPL-2.0-or-later
 * What LAMMPS calls when it loads the plugin. */
#include "fix_history.h"
#include "fix_plane.h"
#include "fix_pull.h"
#include "fix_step.h"
#include "library.h"
#include "pair_veridem.h"

#include <cstring>
#include <string>

using namespace LAMMPS_NS;

namespace {

/* The structure with which a plugin registers a style, as the manual of LAMMPS documents it. */
struct Style {
  const char *version, *style, *name, *info, *author;
  union {
    void *(*pair)(void *);
    void *(*fix)(void *, int, char **);
  } creator;
  void *handle;
};

void *wear(void *lmp) { return static_cast<Pair *>(new PairVeridem(static_cast<LAMMPS *>(lmp), "wear")); }
void *soot(void *lmp) { return static_cast<Pair *>(new PairVeridem(static_cast<LAMMPS *>(lmp), "soot")); }
void *titania(void *lmp) { return static_cast<Pair *>(new PairVeridem(static_cast<LAMMPS *>(lmp), "titania")); }

template <class Made> void *fix(void *lmp, int narg, char **arg) {
  return static_cast<Fix *>(new Made(static_cast<LAMMPS *>(lmp), narg, arg));
}

}    // namespace

extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void *lmp, void *handle, void *registered) {
  // Only functions of the library interface before the versions are known to agree: they do not depend on the layout of classes.
  if (lammps_version(lmp) != VERIDEM_LAMMPS_VERSION || lammps_extract_setting(lmp, "tagint") != sizeof(int32_t)) {
    std::string reason = "veridem: the plugin was built for LAMMPS " + std::to_string(VERIDEM_LAMMPS_VERSION) +
        " with ids of 4 bytes, found LAMMPS " + std::to_string(lammps_version(lmp)) + " with ids of " +
        std::to_string(lammps_extract_setting(lmp, "tagint")) + " bytes: build it again with bindings/lammps/build";
    lammps_error(lmp, LMP_ERROR_ALL, reason.c_str());
    return;
  }
  if (veridem_abi() != VERIDEM_ABI) {
    lammps_error(lmp, LMP_ERROR_ALL, "veridem: the plugin was built with the header of another version of the C library");
    return;
  }
  auto add = reinterpret_cast<void (*)(Style *, void *)>(registered);
  Style style = {};
  style.version = VERIDEM_LAMMPS_DATE;
  style.author = "the authors of veridem";
  style.handle = handle;
  auto pair = [&](const char *name, const char *info, void *(*creator)(void *)) {
    style.style = "pair", style.name = name, style.info = info, style.creator.pair = creator;
    add(&style, lmp);
  };
  auto of_fix = [&](const char *name, const char *info, void *(*creator)(void *, int, char **)) {
    style.style = "fix", style.name = name, style.info = info, style.creator.fix = creator;
    add(&style, lmp);
  };
  pair("veridem/wear", "A cohesive solid, Pham-Ba & Molinari 2022", wear);
  pair("veridem/soot", "Soot aggregates with necks, Demidov, Gor & Khalizov 2024", soot);
  pair("veridem/titania", "Water-covered nanoparticles, Laube et al. 2018", titania);
  of_fix("veridem/history", "History of the pairs of a pair_style veridem", fix<FixVeridemHistory>);
  of_fix("veridem/step", "The step of veridem's engine", fix<FixVeridemStep>);
  of_fix("veridem/pull", "A spring that pulls the centre of mass of some spheres", fix<FixVeridemPull>);
  of_fix("veridem/plane", "A plane that acts on spheres of pair_style veridem/soot", fix<FixVeridemPlane>);
}
