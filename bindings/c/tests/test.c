/* Tests the C library: a law over arrays of pairs and over a list agree, history is carried, equations, errors. */
#include "veridem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                        \
    do {                                                                         \
        if (!(condition)) {                                                      \
            printf("%s:%d: not true: %s (%s)\n", __FILE__, __LINE__, #condition, veridem_message()); \
            failures++;                                                          \
        }                                                                        \
    } while (0)

static const char *const SILICA[] = {"young_modulus", "73000", "poisson_ratio", "0.17", "tensile_strength", "16000",
    "shear_strength", "9000", "surface_energy", "1500", "restitution", "0.9", "scaling", "0.5"};
static const char *const SOOT[] = {"neck_springs", "1e5", "1e5", "1e5", "1e5", "125", "25", "6", "6", "contact", "1e4", "1e4",
    "1e4", "1e4", "5", "1", "0.25", "0.25"};
#define COUNT(words) (sizeof(words) / sizeof *(words))

enum { SPHERES = 3, MOST = 40 };
static double x[3 * SPHERES] = {0, 0, 0, 2.9, 0.1, 0, 1.5, 2.5, 0.2}, v[3 * SPHERES] = {1, 0, 0, 0, 2, 0, 0, 0, -3},
              omega[3 * SPHERES] = {0, 0.1, 0, 0.2, 0, 0, 0, 0, 0.3}, radius[SPHERES] = {1.5, 1.4, 1.6}, mass[SPHERES] = {30, 25, 36};
static double force[3 * SPHERES], torque[3 * SPHERES];
static int32_t id[SPHERES] = {7, 3, 5};

static veridem_spheres spheres(void) {
    memset(force, 0, sizeof force);
    memset(torque, 0, sizeof torque);
    veridem_spheres s = {VERIDEM_ABI, sizeof(veridem_spheres), SPHERES, SPHERES, x, v, omega, radius, mass, id, force, torque, NULL, NULL};
    return s;
}

static void build(veridem_list *list) {
    const int32_t rows[] = {0, 1, 2}, numbers[] = {2, 1, 0}, first[] = {1, 2}, second[] = {2 | 1 << 30};
    const int32_t *const neighbours[] = {first, second, NULL};
    EXPECT(veridem_list_build(list, SPHERES, SPHERES, id, 3, rows, numbers, neighbours, 0x1FFFFFFF) == 0);
}

/* The forces of a list are those of its pairs, one by one. */
static void list_and_pairs_agree(const char *name, const char *const *words, size_t count, int neck) {
    veridem_law *law = NULL;
    veridem_list *list = NULL;
    double dt = 1e-4, expected[3 * SPHERES] = {0};
    size_t width, losses, stored, pairs;
    const uint32_t *i, *j;
    double *history;
    EXPECT(veridem_law_new(name, words, count, NULL, 0, &law) == 0);
    EXPECT(veridem_law_count(law, VERIDEM_HISTORY, &width) == 0 && veridem_law_count(law, VERIDEM_LOSSES, &losses) == 0);
    EXPECT(veridem_law_count(law, VERIDEM_STORED, &stored) == 0);
    EXPECT(veridem_list_new(law, &list) == 0);
    build(list);
    EXPECT(veridem_list_pairs(list, &pairs, &i, &j, &history) == 0 && pairs == 3);
    for (size_t k = 0; k < pairs; k++) {
        EXPECT(id[i[k]] < id[j[k]]);
        for (size_t n = 1; n < width; n++) history[width * k + n] = 0.01 * (double)(n + k);
        history[width * k] = neck && k == 1;
    }
    double results[MOST][3], *to[MOST];
    for (size_t k = 0; k < pairs; k++) {
        double numbers[MOST];
        const double *from[MOST];
        for (int a = 0; a < 3; a++) {
            numbers[a] = x[3 * i[k] + a] - x[3 * j[k] + a];
            numbers[3 + a] = v[3 * i[k] + a] - v[3 * j[k] + a];
            numbers[6 + a] = omega[3 * i[k] + a];
            numbers[9 + a] = omega[3 * j[k] + a];
        }
        numbers[12] = radius[i[k]], numbers[13] = radius[j[k]], numbers[14] = mass[i[k]], numbers[15] = mass[j[k]];
        memcpy(numbers + 16, history + width * k, width * sizeof(double));
        for (size_t n = 0; n < 16 + width; n++) from[n] = numbers + n;
        for (size_t n = 0; n < MOST; n++) to[n] = &results[n][k];
        EXPECT(veridem_law_pairs(law, 1, from, 16 + width, to, 9 + width - 1 + losses, dt) == 0);
        for (int a = 0; a < 3; a++) expected[3 * i[k] + a] += results[a][k], expected[3 * j[k] + a] -= results[a][k];
    }
    /* The law may go before the list. */
    veridem_law_free(law);
    double lost[MOST] = {0}, held[MOST] = {0}, virial[6] = {0}, before = history[1];
    veridem_spheres s = spheres();
    EXPECT(veridem_list_step(list, &s, dt, 0, lost, losses, held, stored, virial) == 0);
    EXPECT(memcmp(force, expected, sizeof force) == 0 && history[1] == before && virial[0] != 0.0);
    s = spheres();
    EXPECT(veridem_list_step(list, &s, dt, 1, lost, losses, NULL, 0, NULL) == 0);
    for (size_t k = 0; k < pairs; k++)
        for (size_t n = 1; n < width; n++) EXPECT(history[width * k + n] == results[8 + n][k]);
    double contacts[SPHERES] = {0};
    EXPECT(veridem_list_contacts(list, &s, contacts) == 0 && contacts[0] + contacts[1] + contacts[2] == (neck ? 2 : 4));
    veridem_list_free(list);
}

/* A law of these words and more, and a list of its pairs. */
static veridem_list *listed(const char *name, const char *const *words, size_t count, const char *const *more, size_t others, veridem_law **law) {
    const char *all[MOST];
    veridem_list *list = NULL;
    memcpy(all, words, count * sizeof *all);
    memcpy(all + count, more, others * sizeof *all);
    EXPECT(veridem_law_new(name, all, count + others, NULL, 0, law) == 0);
    EXPECT(veridem_list_new(*law, &list) == 0);
    build(list);
    return list;
}

static void a_neck_breaks(void) {
    veridem_law *law = NULL;
    const char *const weak[] = {"break_energy", "0.001"};
    veridem_list *list = listed("soot", SOOT, COUNT(SOOT), weak, 2, &law);
    size_t pairs, count, width;
    const uint32_t *i, *j, *found;
    double *history, lost = 0;
    uint64_t every = 0;
    EXPECT(veridem_law_neck_checks(law, &every) == 0 && every > 0);
    EXPECT(veridem_law_count(law, VERIDEM_HISTORY, &width) == 0);
    EXPECT(veridem_list_pairs(list, &pairs, &i, &j, &history) == 0);
    history[width] = 1, history[width + 1] = 0.1;
    veridem_spheres s = spheres();
    EXPECT(veridem_list_overloaded(list, &s, &count, &found) == 0 && count == 1 && found[0] == 1);
    const uint32_t broken[] = {1}, none[] = {0};
    EXPECT(veridem_list_break(list, &s, 1, broken, &lost) == 0 && lost > 0.001 && history[width] == 0 && history[width + 1] == 0);
    EXPECT(veridem_list_overloaded(list, &s, &count, &found) == 0 && count == 0);
    EXPECT(veridem_list_break(list, &s, 1, none, &lost) == 65);
    veridem_list_free(list);
    veridem_law_free(law);
}

static void stretched_springs_are_forgotten_where_the_law_says_so(void) {
    veridem_law *law = NULL;
    const char *const forget[] = {"forget_stretched_springs", "true"}, *const keep[] = {"forget_stretched_springs", "false"};
    for (int forgets = 0; forgets < 2; forgets++) {
        veridem_list *list = listed("wear", SILICA, COUNT(SILICA), forgets ? forget : keep, 2, &law);
        size_t pairs, touching = 0;
        const uint32_t *i, *j;
        double *history, losses[3] = {0};
        int says = -1;
        EXPECT(veridem_law_forgets(law, &says) == 0 && says == forgets);
        EXPECT(veridem_list_pairs(list, &pairs, &i, &j, &history) == 0);
        for (size_t k = 0; k < pairs; k++) history[4 * k + 1] = 0.01;
        veridem_spheres s = spheres();
        EXPECT(veridem_list_forget(list, &s, losses, 3) == 0 && (losses[2] > 0) == forgets);
        for (size_t k = 0; k < pairs; k++) touching += history[4 * k + 1] != 0;
        EXPECT(forgets ? touching < pairs : touching == pairs);
        veridem_list_free(list);
        veridem_law_free(law);
    }
}

static void a_plane_holds_a_sphere(void) {
    veridem_law *law = NULL;
    const double point[3] = {0, 0, -1.4}, normal[3] = {0, 0, 1}, still[3] = {0, 0, 0};
    double history[8 * SPHERES] = {0}, on_plane[3] = {0};
    EXPECT(veridem_law_new("soot", SOOT, COUNT(SOOT), NULL, 0, &law) == 0);
    veridem_spheres s = spheres();
    EXPECT(veridem_plane_step(law, &s, 0, point, normal, still, history, 1e-4, 1, on_plane, NULL, 0, NULL, 0) == 0);
    EXPECT(fabs(force[2] + force[5] + force[8] + on_plane[2]) < 1e-9 && history[0] != 0.0);
    EXPECT(veridem_plane_step(law, &s, 2, point, normal, still, history, 1e-4, 1, on_plane, NULL, 0, NULL, 0) == 65);
    veridem_law_free(law);
}

static void equations_are_found_by_id(void) {
    size_t arguments, results;
    EXPECT(veridem_equation_shape("wear-3", &arguments, &results) == 0 && arguments == 4 && results == 1);
    const double k_n[] = {2, 2}, delta_e[] = {0.2, 0.2}, delta_f[] = {0.5, 0.5}, delta_n[] = {0.1, 0.6};
    const double *const from[] = {k_n, delta_e, delta_f, delta_n};
    double f[2], *const to[] = {f};
    EXPECT(veridem_equation("wear-3", 2, from, 4, to, 1) == 0 && f[0] == 0.2 && f[1] == 0.0);
    EXPECT(veridem_equation("wear-3", 2, from, 3, to, 1) == 65);
    EXPECT(veridem_equation("wear-333", 2, from, 4, to, 1) == 65 && strstr(veridem_message(), "wear-333"));
}

static void a_sphere_falls(void) {
    double at[3] = {0, 0, 0}, speed[3] = {0, 0, 1}, spin[3] = {0, 0, 0}, weight[3] = {0, 0, -60}, none[3] = {0, 0, 0}, drag = 0;
    const int32_t moves[] = {1};
    EXPECT(veridem_advance(1, at, speed, spin, radius, mass, weight, none, moves, 0.0, 0.5, &drag) == 0);
    EXPECT(speed[2] == 0.0 && at[2] == 0.0 && drag == 0.0);
}

static void wrong_input_has_a_reason(void) {
    veridem_law *law = NULL;
    veridem_list *list = NULL;
    const char *const typo[] = {"young_modulos", "1"}, *const text[] = {"young_modulus", "much"}, *const few[] = {"young_modulus"};
    EXPECT(veridem_law_new("wear", typo, 2, NULL, 0, &law) == 65 && strstr(veridem_message(), "young_modulus"));
    EXPECT(veridem_law_new("wear", text, 2, NULL, 0, &law) == 65 && strstr(veridem_message(), "much"));
    EXPECT(veridem_law_new("wear", few, 1, NULL, 0, &law) == 65);
    EXPECT(veridem_law_new("wear", SILICA, 2, NULL, 0, &law) == 65 && strstr(veridem_message(), "missing"));
    EXPECT(veridem_law_new("rubber", NULL, 0, NULL, 0, &law) == 65 && veridem_law_new(NULL, NULL, 0, NULL, 0, &law) == 65);
    EXPECT(veridem_law_new("wear", SILICA, COUNT(SILICA), NULL, 0, NULL) == 65 && law == NULL);
    EXPECT(veridem_law_new("wear", SILICA, COUNT(SILICA), NULL, 0, &law) == 0);
    EXPECT(veridem_list_new(law, &list) == 0);
    build(list);
    veridem_spheres s = spheres();
    s.bytes = 8;
    EXPECT(veridem_list_step(list, &s, 1e-4, 1, NULL, 0, NULL, 0, NULL) == 65 && strstr(veridem_message(), "ABI"));
    s = spheres();
    s.count = s.owned = 2;
    EXPECT(veridem_list_step(list, &s, 1e-4, 1, NULL, 0, NULL, 0, NULL) == 65);
    s = spheres();
    double kept = x[0];
    x[0] = NAN;
    EXPECT(veridem_list_step(list, &s, 1e-4, 1, NULL, 0, NULL, 0, NULL) == 5 && strstr(veridem_message(), "finite"));
    x[0] = kept;
    const int32_t rows[] = {0}, numbers[] = {1, 0, 0}, far[] = {17};
    const int32_t *const neighbours[] = {far, NULL, NULL};
    EXPECT(veridem_list_build(list, SPHERES, SPHERES, id, 1, rows, numbers, neighbours, 0x1FFFFFFF) == 65);
    veridem_list_free(list);
    veridem_law_free(law);
}

int main(void) {
    EXPECT(veridem_abi() == VERIDEM_ABI);
    list_and_pairs_agree("wear", SILICA, COUNT(SILICA), 0);
    list_and_pairs_agree("soot", SOOT, COUNT(SOOT), 1);
    list_and_pairs_agree("titania", NULL, 0, 0);
    a_neck_breaks();
    stretched_springs_are_forgotten_where_the_law_says_so();
    a_plane_holds_a_sphere();
    equations_are_found_by_id();
    a_sphere_falls();
    wrong_input_has_a_reason();
    veridem_law_free(NULL);
    veridem_list_free(NULL);
    if (failures == 0) puts("all tests of the C library passed");
    return failures != 0;
}
