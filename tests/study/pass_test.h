/* For tests of the statistics of a study: a pass of a plate in closed form. Until the shadow's
 * edge its light hangs on the emittance of its cells, behind it, where they are as cold as the bus
 * behind them, on the heat inside; visible light hangs on neither but on the cells alone. */
#ifndef UMBRA_TESTS_STUDY_PASS_TEST_H
#define UMBRA_TESTS_STUDY_PASS_TEST_H

#include <string.h>

#include "base/uncertainty/design.h"
#include "base/uncertainty/surrogate.h"
#include "study/result.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

enum { PASS_NTIME = 121, PASS_NPARAMETER = 3, PASS_NVALUE = 3 * PASS_NTIME + 1 };
#define PASS_EDGE 0.55 /* of the pass: the shadow's */

static inline double pass_sunlit(size_t k)
{
  double t = (double)k / (PASS_NTIME - 1);
  return t < PASS_EDGE ? 1.0 : t > PASS_EDGE + 0.03 ? 0.0 : 1.0 - (t - PASS_EDGE) / 0.03;
}

/* emittance of the cells, heat inside [W], factor of the blankets' emittance; vis, lwir [W/m2],
 * temperature [K], a metric. Nothing is seen at the first instant. */
static inline void pass_values(const double *p, double *v)
{
  for (size_t k = 0; k < PASS_NTIME; k++) {
    double t = (double)k / (PASS_NTIME - 1), s = pass_sunlit(k),
           shape = exp(-8.0 * (t - 0.45) * (t - 0.45));
    double after = fmax(t - PASS_EDGE, 0.0) / (1.0 - PASS_EDGE);
    double cool = 60.0 * (1.0 - exp(-3.0 * after)) * p[0];
    double kelvin = 285.0 + 0.03 * p[1] * (0.2 + after) - cool - 4.0 * (p[2] - 1.0);
    v[k] = 3e-11 * shape * s * (1.3 - p[0]);
    v[PASS_NTIME + k] =
        2e-10 * shape * (0.3 + p[0] * (1.0 - after)) * exp(0.012 * (kelvin - 290.0));
    v[2 * PASS_NTIME + k] = kelvin;
  }
  v[0] = v[PASS_NTIME] = NAN;
  v[3 * PASS_NTIME] = 1e3 * fabs(p[0] - 0.82) + 0.02 * fabs(p[1] - 350.0);
}

static inline enum um_status pass_evaluate(struct um_context *with, void *user, const double *place,
                                           size_t n, double *value)
{
  const struct um_study_result *r = user;
  (void)with;
  for (size_t i = 0; i < n; i++) {
    double p[PASS_NPARAMETER];
    for (size_t k = 0; k < PASS_NPARAMETER; k++)
      p[k] = um_uncertainty_distribution_at_place(&r->distribution[k], place[i * 3 + k]);
    pass_values(p, value + i * PASS_NVALUE);
  }
  return UM_OK;
}

static inline void pass_quantity(struct um_study_quantity *q, const char *name, const char *unit,
                                 const char *of, size_t first, size_t count)
{
  q->first = first;
  q->count = count;
  q->light = strcmp(unit, "W/m2") == 0;
  assert_int_equal(um_core_strdup(context, name, &q->name), UM_OK);
  assert_int_equal(um_core_strdup(context, unit, &q->unit), UM_OK);
  assert_int_equal(um_core_strdup(context, of, &q->of), UM_OK);
}

/* A block of n doubles of the result. */
static inline double *pass_doubles(size_t n)
{
  double *out;
  assert_int_equal(um_core_allocate(context, n, sizeof *out, &out), UM_OK);
  return out;
}

static inline void pass_parameters(struct um_study_result *r)
{
  static const char *const name[3] = {"cell_silicon emittance", "parts.bus.interior.power_W",
                                      "mli_emittance"};
  static const char *const unit[3] = {"1", "W", "1"};
  assert_int_equal(um_core_allocate(context, 3, sizeof(char *), &r->parameter_name), UM_OK);
  assert_int_equal(um_core_allocate(context, 3, sizeof(char *), &r->parameter_unit), UM_OK);
  assert_int_equal(um_core_allocate(context, 3, sizeof *r->distribution, &r->distribution), UM_OK);
  for (size_t k = 0; k < 3; k++) {
    assert_int_equal(um_core_strdup(context, name[k], &r->parameter_name[k]), UM_OK);
    assert_int_equal(um_core_strdup(context, unit[k], &r->parameter_unit[k]), UM_OK);
  }
  r->distribution[0] =
      (struct um_uncertainty_distribution){.kind = UM_UNCERTAINTY_UNIFORM, .from = 0.7, .to = 0.9};
  r->distribution[1] = (struct um_uncertainty_distribution){
      .kind = UM_UNCERTAINTY_UNIFORM, .from = 0.0, .to = 600.0};
  r->distribution[2] = (struct um_uncertainty_distribution){
      .kind = UM_UNCERTAINTY_NORMAL, .from = -INFINITY, .to = INFINITY, .mean = 1.0, .sigma = 0.1};
}

/* A surrogate of the pass in place of the result's; held_out, evaluations 0: the default. */
static inline void pass_surrogate(struct um_study_result *r, size_t held_out, size_t evaluations)
{
  struct um_uncertainty_group group = {
      .name = "curves", .count = 3 * PASS_NTIME, .relative = 1e-4, .floor = 0.01};
  struct um_uncertainty_surrogate_request request = {.d = 3,
                                                     .nvalue = PASS_NVALUE,
                                                     .ngroup = 1,
                                                     .group = &group,
                                                     .evaluate = pass_evaluate,
                                                     .user = r,
                                                     .held_out = held_out,
                                                     .evaluations_max = evaluations};
  um_uncertainty_surrogate_destroy(context, &r->surrogate);
  if (um_uncertainty_surrogate_create(context, &request, &r->surrogate) != UM_OK)
    fail_msg("%s", um_core_message(context));
}

/* Points of a design, u [npoint][3], which the result takes, each exactly; with a surrogate or
 * without. The caller destroys. */
static inline struct um_study_result *pass_result(enum um_study_design design, size_t base,
                                                  size_t npoint, double *u, bool surrogate)
{
  struct um_study_result *r;
  assert_int_equal(um_core_allocate(context, 1, sizeof *r, &r), UM_OK);
  assert_int_equal(um_core_strdup(context, "cells and heat", &r->name), UM_OK);
  assert_int_equal(um_core_strdup(context, "plate", &r->scenario), UM_OK);
  r->nparameter = PASS_NPARAMETER;
  r->npoint = npoint;
  r->nvalue = PASS_NVALUE;
  r->ntime = PASS_NTIME;
  r->nquantity = 4;
  r->design = design;
  r->base = base;
  r->coordinate = u;
  pass_parameters(r);
  r->time = pass_doubles(r->ntime);
  r->sunlit = pass_doubles(r->ntime);
  r->parameter = pass_doubles(npoint * 3);
  r->value = pass_doubles(npoint * r->nvalue);
  r->nominal = pass_doubles(r->nvalue);
  r->at_nominal = pass_doubles(3);
  r->error = pass_doubles(4);
  r->error[3] = NAN;
  for (size_t k = 0; k < r->ntime; k++) {
    r->time[k] = 5.2783e8 + 720.0 * (double)k / (PASS_NTIME - 1); /* 2016, 12 minutes */
    r->sunlit[k] = pass_sunlit(k);
  }
  assert_int_equal(um_core_allocate(context, npoint, sizeof(char *), &r->reason), UM_OK);
  assert_int_equal(um_core_allocate(context, 4, sizeof *r->quantity, &r->quantity), UM_OK);
  pass_quantity(&r->quantity[0], "irradiance:vis", "W/m2", "vis", 0, PASS_NTIME);
  pass_quantity(&r->quantity[1], "irradiance:lwir", "W/m2", "lwir", PASS_NTIME, PASS_NTIME);
  pass_quantity(&r->quantity[2], "temperature:bus", "K", "bus", 2 * PASS_NTIME, PASS_NTIME);
  pass_quantity(&r->quantity[3], "rms:lwir", "1", "lwir", 3 * PASS_NTIME, 1);
  r->at_nominal[0] = 0.8;
  r->at_nominal[1] = 300.0;
  r->at_nominal[2] = 1.0;
  pass_values(r->at_nominal, r->nominal);
  for (size_t i = 0; i < npoint; i++) {
    for (size_t k = 0; k < 3; k++)
      r->parameter[i * 3 + k] =
          um_uncertainty_distribution_value(&r->distribution[k], u[i * 3 + k]);
    pass_values(r->parameter + i * 3, r->value + i * r->nvalue);
  }
  if (surrogate) pass_surrogate(r, 0, 0);
  return r;
}

static inline struct um_study_result *pass_sobol(size_t npoint, bool surrogate)
{
  double *u;
  assert_int_equal(um_uncertainty_sobol_sequence(context, 3, npoint, 1, &u), UM_OK);
  return pass_result(UM_STUDY_SOBOL, 0, npoint, u, surrogate);
}

#endif
