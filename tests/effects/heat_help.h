/* What the tests of heat effects share: a small satellite at a fixed point over the subsolar Earth,
 * the Sun standing still, so that its start is a steady state with closed-form balances.
 *
 *        Sun  <---- +x                    panel: 2 m x 1 m, front to the Sun, two layers
 *   (                |panel|  [bus]       bus:   1 m cube in its shade, MLI over walls, interior
 *   ( Earth                               contact panel.back - bus.+x, 2 W/K; surfaces do
 *   (                                      not exchange radiation
 * (tests/thermal/exchange/exchange.c)
 *   (
 */
#ifndef UMBRA_TESTS_EFFECTS_HEAT_HELP_H
#define UMBRA_TESTS_EFFECTS_HEAT_HELP_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "tests/support/cmocka_all.h"

struct heat_run {
  struct um_context *context;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};

/* Texts of one list, ended by NULL. */
#define LIST(...) ((const char *const[]){__VA_ARGS__, NULL})
#define NONE      ((const char *const[]){NULL})

/* Compute the small satellite with overrides, effects added and effects left out; a failure fails
 * the test with the program's message. */
struct heat_run heat_compute(const char *const *overrides, const char *const *with,
                             const char *const *without);
void heat_release(struct heat_run *run);
/* The scenario is refused; the message is copied into out. */
void heat_refused(const char *const *overrides, const char *const *with, char *out, size_t size);

/* Temperature of a place at observation k [K]. */
double heat_temperature(const struct heat_run *run, const char *place, size_t k);
/* At the first observation, summed over the surfaces of a part and side (part NULL: over all) [W]:
 * emitted to space, absorbed, and incident direct sunlight, albedo and Earth IR. */
struct heat_budget {
  double area; /* [m^2] */
  double emitted, absorbed, sun, albedo, planet;
  double absorptance, emittance; /* of the last surface [1] */
};
struct heat_budget heat_budget(const struct heat_run *run, const char *part, bool back);
/* Intensity in a band by mechanism, first observation, material NULL: all [W/sr]. */
double heat_intensity(const struct heat_run *run, const char *band, int mechanism,
                      const char *material);

/* |value - expected| <= relative |expected|; NaN fails. */
void heat_close(const char *what, double value, double expected, double relative);
/* Bit for bit: temperatures; a band's irradiance and intensities by material and mechanism; the
 * same without what is emitted (a wall at 300 K emits 1e-26 of sunlight in the visible). */
bool heat_same_temperatures(const struct heat_run *a, const struct heat_run *b);
bool heat_same_band(const struct heat_run *a, const struct heat_run *b, const char *band);
bool heat_same_reflected(const struct heat_run *a, const struct heat_run *b, const char *band);

/* Of the test program: its scenario is written to a file of the given name, and removed. */
int heat_setup(const char *file);
int heat_teardown(void);

#endif
