/* veridem: the equations and contact laws of three models for the discrete element method, as C functions.
 *
 * Units. An equation is coherent in any system of units. The laws `wear` and `soot` are, too; `titania` computes with nm, ns and ag
 * (1e-21 kg), hence pN, zJ, MPa and mN/m, and the defaults of all laws, those of case files but for
 * the capillary force of soot, which is 0, are in these units.
 *
 * Errors. A function that can fail returns an int: 0 when it is done, 65 for a wrong argument, 5 for a pair that left the domain of
 * the law, 70 for a defect of this library. veridem_message() then has the reason. Nothing unwinds into the caller and nothing is
 * printed, but for the message of a defect, which goes to standard error. After 5 the forces of that step are incomplete.
 *
 * Ownership. Laws and lists are made by ..._new and released by ..._free, which accepts NULL. A list keeps what it needs of its law,
 * which may be released before it. Arrays are the caller's; the library keeps none of them beyond a call. The arrays that
 * veridem_list_pairs shows are the list's, until it is built anew or released. Arrays of a call must not overlap.
 *
 * Threads. A law may be used by any number of threads at once, a list by one at a time. The message is that of the calling thread.
 *
 * Vectors lie in memory as x, y, z, one sphere after the other.
 */
#ifndef VERIDEM_H
#define VERIDEM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this header. Compare it with veridem_abi() of the library that was loaded. */
#define VERIDEM_ABI 2u
uint32_t veridem_abi(void);

/* The reason why the last failed call of this thread failed; valid until the next one. */
const char *veridem_message(void);

/* ---- Contact laws ---- */

typedef struct veridem_law veridem_law;

/* The law `name`: "wear", "soot" or "titania". Its parameters are words, keys and their values in turn, such as
 * {"young_modulus", "73000", "poisson_ratio", "0.17", ...}: the keys of a case file, of which a wrong one names all others.
 * `radii` are those of all spheres of the system, each once, ascending: `titania` tabulates the attraction of every two sizes. Without
 * radii it solves for the meniscus at every evaluation, as the other laws need none. */
int veridem_law_new(const char *name, const char *const *words, size_t word_count, const double *radii, size_t radius_count,
                    veridem_law **law);
void veridem_law_free(veridem_law *law);

/* Numbers of the history of a pair, of the energies that it loses in a step, and of those that it stores, with their names. The first
 * number of the history is 1 for a pair that is joined by a neck and 0 for any other; the springs follow. */
#define VERIDEM_HISTORY 0
#define VERIDEM_LOSSES 1
#define VERIDEM_STORED 2
int veridem_law_count(const veridem_law *law, int what, size_t *count);
int veridem_law_name(const veridem_law *law, int what, size_t place, char *buffer, size_t bytes);

/* Largest distance of centres at which two spheres without a neck act on each other. */
int veridem_law_range(const veridem_law *law, double r_i, double r_j, double *range);

/* Largest stable time step of two equal spheres, among others of the same density with radii up to `largest`. */
int veridem_law_time_step(const veridem_law *law, double r, double m, double largest, double *dt);

/* 1 if friction is limited by the inertia it may stop, which the contacts of a sphere share: see `moment` below. */
int veridem_law_shares_inertia(const veridem_law *law, int *shares);

/* 1 if pairs forget springs when they are listed anew, as wear with `forget_stretched_springs`. */
int veridem_law_forgets(const veridem_law *law, int *forgets);

/* Steps between two checks of the strength of necks, in the keys `break_energy` and `break_stress`; 0 if necks never break. */
int veridem_law_neck_checks(const veridem_law *law, uint64_t *every);

/* The law over arrays of pairs: one column for each number of the arguments, one for each of the results, all of `length` numbers.
 * Arguments: branch vector x_i - x_j (3), relative velocity v_i - v_j (3), angular velocities of i and of j (3 each), radii, masses (2
 * each), the history. Results: force on i (3), torques on i and on j (3 each), the springs (the history but for its first number) after
 * `dt`, the losses. The force on j is the negative of that on i. */
int veridem_law_pairs(const veridem_law *law, size_t length, const double *const *arguments, size_t argument_count,
                      double *const *results, size_t result_count, double dt);

/* ---- Steps of a list of pairs ---- */

/* The spheres of a process: those that it owns come first, then ghosts, which only act. */
typedef struct veridem_spheres {
    uint32_t abi;            /* VERIDEM_ABI */
    uint32_t bytes;          /* sizeof(veridem_spheres) */
    size_t count;            /* of all spheres */
    size_t owned;            /* of the first spheres */
    const double *x;         /* centres, 3 each */
    const double *v;         /* velocities, 3 each */
    const double *omega;     /* angular velocities, 3 each */
    const double *radius;    /* radii */
    const double *mass;      /* masses */
    const int32_t *id;       /* ids, the same for a sphere and its ghosts; the springs of a pair belong to that with the lower one */
    double *force;           /* to which forces on owned spheres are added, 3 each */
    double *torque;          /* the same of torques */
    const double *moment;    /* least moment of inertia of the body of a sphere, 0 for a sphere by itself, 1e300 or more for one that
                                cannot turn; NULL if contacts do not share inertia */
    const double *contacts;  /* number of contacts that share it; NULL if `moment` is */
} veridem_spheres;

typedef struct veridem_list veridem_list;

int veridem_list_new(const veridem_law *law, veridem_list **list);
void veridem_list_free(veridem_list *list);

/* Lists the pairs: spheres row_sphere[0..row_count], and of each sphere p of these neighbour_count[p] neighbours[p], whose bits
 * `mask` are places of spheres. A pair of owned spheres is listed once, a pair with a ghost by the owner of either. The history of all
 * pairs is zero; `id` is that of the spheres. */
int veridem_list_build(veridem_list *list, size_t count, size_t owned, const int32_t *id, size_t row_count,
                       const int32_t *row_sphere, const int32_t *neighbour_count, const int32_t *const *neighbours, int32_t mask);

/* The pairs that are listed: places of the sphere with the lower id and of the other, and the history, which may be written. */
int veridem_list_pairs(veridem_list *list, size_t *count, const uint32_t **i, const uint32_t **j, double **history);

/* Adds 1 to contacts[p] of each owned sphere for every pair that touches without a neck. */
int veridem_list_contacts(veridem_list *list, veridem_spheres *spheres, double *contacts);

/* Before the list is built anew: the pairs forget the springs that the law does not keep, whose energies are added to `losses`. */
int veridem_list_forget(veridem_list *list, veridem_spheres *spheres, double *losses, size_t loss_count);

/* Pairs whose necks are loaded beyond their strength: places in the list, to which the pointer is valid until the next call with it. */
int veridem_list_overloaded(veridem_list *list, veridem_spheres *spheres, size_t *count, const uint32_t **pairs);

/* Breaks the necks of these pairs, which may be those that veridem_list_overloaded shows in an array of the caller. To `lost` is added the
 * energy that they held, less that of the contacts that take their place; of a pair with a ghost one half. */
int veridem_list_break(veridem_list *list, veridem_spheres *spheres, size_t count, const uint32_t *pairs, double *lost);

/* Adds the forces and torques of all pairs. With `advance` not 0 their springs advance by `dt`, and `losses` receives the energies lost;
 * otherwise the history stays as it is. `losses`, `stored` and `virial` (branch vector times force: xx, yy, zz, xy, xz, yz) are sums to
 * which the pairs of owned spheres are added whole, those with a ghost by half; each may be NULL. */
int veridem_list_step(veridem_list *list, veridem_spheres *spheres, double dt, int advance, double *losses, size_t loss_count,
                      double *stored, size_t stored_count, double *virial);

/* ---- Planes and motion ---- */

/* Adds the forces of a plane, of the surface `material` of a law with surfaces (`soot`: 0 the substrate, 1 the tip), on the owned
 * spheres. `history` has as many numbers for each owned sphere as the history of a pair but one; `force` receives the force on the
 * plane. */
int veridem_plane_step(const veridem_law *law, veridem_spheres *spheres, size_t material, const double point[3],
                       const double normal[3], const double velocity[3], double *history, double dt, int advance, double force[3],
                       double *losses, size_t loss_count, double *stored, size_t stored_count);

/* One step of symplectic Euler with global damping; velocities belong to half a step before the positions. A sphere with moves[p] of 1
 * moves under its forces, with 2 at its velocity, with 0 not at all. `drag` receives the energy lost to the damping. */
int veridem_advance(size_t count, double *x, double *v, double *omega, const double *radius, const double *mass,
                    const double *force, const double *torque, const int32_t *moves, double damping, double dt, double *drag);

/* The velocity of a rigid wall of this mass after a step, under the force of the spheres on it and a load: along an axis whose load is
 * NAN it stays as it is. */
int veridem_push_wall(double velocity[3], const double force[3], const double load[3], double mass, double dt);

/* ---- Equations ---- */

/* Numbers of the arguments and of the results of an equation, such as "wear-3": vectors count three, tensors nine.
 * `veridem eq show ID` has their names and units. */
int veridem_equation_shape(const char *id, size_t *arguments, size_t *results);

/* The equation over columns of `length` numbers. Domains are not checked: outside of them results may be anything. */
int veridem_equation(const char *id, size_t length, const double *const *arguments, size_t argument_count,
                     double *const *results, size_t result_count);

#ifdef __cplusplus
}
#endif

#endif
