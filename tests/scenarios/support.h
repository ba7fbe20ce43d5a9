/* What the tests of this folder share: a scenario computed from beginning to end. */
#ifndef UMBRA_TESTS_SCENARIOS_SUPPORT_H
#define UMBRA_TESTS_SCENARIOS_SUPPORT_H

#include <math.h>
#include <stdio.h>

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "tests/support/cmocka_all.h"

struct support_run {
  struct um_context *context;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};

/* Compute a scenario with overrides ("key=value"); fails the test with the program's message. */
void support_compute(const char *path, const char *const *overrides, size_t noverride,
                     struct support_run *run);
void support_release(struct support_run *run);
/* Mean temperature of a place at every observation, shape [nobs] [K]; fails without the place. */
const double *support_temperature(const struct support_run *run, const char *place);
/* Time of observation k since the first [s]. */
double support_time(const struct support_run *run, size_t k);
/* |value - expected| <= tolerance, all in one unit; NaN fails. */
void support_close(const char *what, double value, double expected, double tolerance);

#endif
