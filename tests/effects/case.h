/* A small scene in the dark and in the light, run with and without effects; shared by the tests of
 * effects. Every function fails the running test instead of returning an error. */
#ifndef UMBRA_TESTS_EFFECTS_CASE_H
#define UMBRA_TESTS_EFFECTS_CASE_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"

struct case_run {
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};

/* Group fixtures of CMocka: the context. */
int case_begin(void **state);
int case_end(void **state);
struct um_context *case_context(void);

/* Text into a file. */
void case_write(const char *file_name, const char *text);
/* Build and run `scenario` (YAML text) with effects as of --with and --without, and overrides as of
 * --set; lists end with NULL and may be NULL. Release the run. */
struct case_run case_compute(const char *scenario, const char *const *with,
                             const char *const *without, const char *const *set);
void case_release(struct case_run *run);
/* One effect as of --with, NULL for none. */
struct case_run case_with(const char *scenario, const char *with);
/* Expect the scenario to be refused with a message that holds `part`. */
void case_refused(const char *scenario, const char *with, const char *part);

/* Every number of the two results is the same to the bit. */
bool case_same(const struct case_run *a, const struct case_run *b);
bool case_same_temperatures(const struct case_run *a, const struct case_run *b);
bool case_same_intensities(const struct case_run *a, const struct case_run *b);

/* Radiant intensity of one observation, band, material and mechanism [W/sr]. */
double case_intensity(const struct case_run *run, size_t k, const char *band, const char *material,
                      int mechanism);
/* fail_msg unless |value - expected| <= tolerance |expected|; NaN fails. */
void case_near(const char *what, double value, double expected, double tolerance);

/* A plate seen and lit from its front: 2 m x 1 m, normal +x, Sun 26 deg and observer 35 deg off it,
 * fixed in space beside the Earth; grey_panel in front. Nothing shadows anything. */
extern const char *const case_plate;
/* A box and a tracking wing in a circular orbit, of grey and spectral materials, that shadow and
 * mirror each other. */
extern const char *const case_satellite;
/* A spinning plate with a joint in the same orbit: nothing shadows anything. */
extern const char *const case_spinner;

#endif
