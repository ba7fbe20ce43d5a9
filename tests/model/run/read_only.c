/* A model is read, never written: eight threads with a context each compute on one model, and on
 * one set of geometry tables and its heat, at once, and all find the bits that one thread finds.
 * ThreadSanitizer (make tsan) says whether any of them wrote what another reads. */
#include <assert.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/products/run_response.h"
#include "model/products/thermal_sensitivity.h"
#include "model/run/balance.h"
#include "model/run/run.h"
#include "model/run/thermal_solution_group.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

enum { THREADS = 8, ROOM = 1 << 16 };

/* Solids want TetGen. */
#ifdef UMBRA_TETGEN
#define BLOCK                                                                                      \
  "  - {name: block, box: {size_m: [0.4, 0.4, 0.4]}, pose: {position_m: [0, 0, -1.2]},\n"          \
  "     outside: white_paint, facet_size_m: 0.4, solid: {material: aluminium_bare}}\n"
#else
#define BLOCK ""
#endif

/* A mirror beside a panel whose wall is of a metal that goes with temperature, MLI by a law, an
 * interior; exposures of three instants; a periodic start. */
static const char scenario[] =
    "schema: 1\n"
    "name: shared\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:04:00Z, step_s: 60,\n"
    "  exposure_s: 20, exposure_samples: 3}\n"
    "orbit: {circular: {altitude_km: 600, beta_deg: 20, epoch_utc: 2020-03-20T12:10:00Z}}\n"
    "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0.6, 0.8], period_s: 700,\n"
    "  at_utc: 2020-03-20T12:01:00Z}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: bus, box: {size_m: [1, 1, 1]}, outside: mli_kapton,\n"
    "     materials: {\"+y\": fep_silver}, lumped: true, facet_size_m: 1,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000},\n"
    "     mli: {effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 300},\n"
    "     interior: {capacity_J_K: 4000, power_W: 20, conductance_W_K: 2}}\n"
    "  - {name: wing, plate: {size_m: [1, 1]}, pose: {position_m: [0, 1.5, 0]},\n"
    "     front: grey_panel, back: white_paint, facet_size_m: 1,\n"
    "     shell: {material: aluminium_bare, thickness_mm: 2}}\n" BLOCK
    "thermal: {start: periodic, orbits_before: 1, samples: 32, exchange_patches: 32,\n"
    "  view_factor_rays: 64, step_s: 60,\n"
    "  relative_tolerance: 1.0e-5, absolute_tolerance_K: 1.0e-3}\n"
    "optics: {samples: 8, interreflection_samples: 4}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

/* What all threads read. */
struct shared {
  const struct um_model *model;
  const struct um_model_tables *tables;
  const struct um_model_thermal_solution *heat;
};

/* One thread's, and what it found. */
struct work {
  const struct shared *shared;
  struct um_context *context;
  enum um_status status;
  size_t count;
  double value[ROOM];
};

static void keep(struct work *w, const double *value, size_t n)
{
  assert(w->count + n <= ROOM);
  memcpy(w->value + w->count, value, n * sizeof *value);
  w->count += n;
}

static void keep_result(struct work *w, const struct um_model_result *r)
{
  keep(w, r->irradiance, r->nobs * r->nband);
  keep(w, r->irradiance_error, r->nobs * r->nband);
  keep(w, r->surface_temperature, r->nobs * r->nsurface);
  keep(w, r->node_temperature, r->nobs * r->nnode);
}

/* Everything anew: geometry, a run, and one with more points. */
static enum um_status anew(struct work *w, const struct um_model *model)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  struct um_model_thermal_solution *heat = NULL;
  struct um_model_result *result = NULL, *finer = NULL;
  UM_CHECK(um_model_precompute(w->context, model, &tables));
  UM_CHECK(um_model_thermal_solution_create(w->context, model, tables, NULL, 1.0, &heat));
  UM_CHECK(um_model_run_with(w->context, model, tables, heat, &result));
  keep_result(w, result);
  UM_CHECK(um_model_tables_resample(w->context, model, tables, (struct um_model_sampling){16, 8}));
  UM_CHECK(um_model_run_with(w->context, model, tables, heat, &finer));
  keep_result(w, finer);
done:
  um_model_result_destroy(w->context, &result);
  um_model_result_destroy(w->context, &finer);
  um_model_thermal_solution_destroy(w->context, &heat);
  um_model_tables_destroy(w->context, &tables);
  return status;
}

static enum um_status balances(struct work *w)
{
  const struct shared *s = w->shared;
  size_t n = um_thermal_network_nodes(s->model->body->network);
  double *t = NULL;
  UM_TRY(um_core_allocate(w->context, n, sizeof *t, &t));
  enum um_status status = um_model_balance_steady(w->context, s->model, s->tables, t);
  keep(w, t, n);
  if (status == UM_OK) status = um_model_balance_orbit(w->context, s->model, s->tables, t);
  keep(w, t, n);
  um_core_free(w->context, t);
  return status;
}

static enum um_status take(void *user, size_t k, const double *temperature, const double *response)
{
  struct work *w = user;
  size_t n = um_thermal_network_nodes(w->shared->model->body->network);
  (void)k;
  keep(w, temperature, n);
  keep(w, response, n);
  return UM_OK;
}

static enum um_status respond(struct work *w)
{
  const uint32_t node = 0;
  const double one = 1.0, from = w->shared->tables->t_first;
  const struct um_thermal_pulse pulse = {&node, &one, 1, from, from + 60.0};
  return um_model_thermal_solution_response(w->context, w->shared->heat, &pulse, 1, 0.0, take, w);
}

/* A variant of the shared model with an effect at a value. */
static enum um_status variant(struct work *w, const char *effect, const char *target,
                              const double *value, size_t nvalue, struct um_model **out)
{
  struct um_model_addition a = {.effect = um_effects_find(effect), .target = target};
  for (size_t p = 0; p < a.effect->nparameter; p++) a.value[p] = a.effect->parameters[p].null_value;
  memcpy(a.value, value, nvalue * sizeof *value);
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
  return um_model_variant_create(w->context, w->shared->model, &changes, out);
}

/* Temperatures of a model with more power inside, by the sensitivity to it. */
static enum um_status move(struct work *w)
{
  const struct shared *s = w->shared;
  const double step = 1e-3;
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_thermal_sensitivity *sensitivity = NULL;
  struct um_model_thermal_solution *heat = NULL;
  UM_CHECK(variant(w, "internal_power", "bus", &step, 1, &model));
  const struct um_model_thermal_move of = {.model = model, .tables = s->tables, .step = step};
  UM_CHECK(um_model_thermal_sensitivity_create(w->context, s->heat, &of, 1, 0.0, &sensitivity));
  UM_CHECK(um_model_thermal_solution_move(w->context, s->heat, sensitivity, 0, 1e3 * step, model,
                                          s->tables, &heat));
  keep(w, heat->run.history->temperature, heat->run.history->ntime * heat->run.history->nnode);
done:
  um_model_thermal_solution_destroy(w->context, &heat);
  um_model_thermal_sensitivity_destroy(w->context, &sensitivity);
  um_model_destroy(w->context, &model);
  return status;
}

/* A variant with a heater: a network of its own, all else of the shared model. */
static enum um_status heated(struct work *w)
{
  const double heater[] = {15.0, 285.0, 2.0}; /* [W], [K], [K] */
  enum um_status status;
  struct um_model *model = NULL;
  UM_CHECK(variant(w, "heater", "bus.interior", heater, 3, &model));
  UM_CHECK(anew(w, model));
done:
  um_model_destroy(w->context, &model);
  return status;
}

static enum um_status compute(struct work *w)
{
  const struct shared *s = w->shared;
  struct um_model_result *result = NULL;
  UM_TRY(anew(w, s->model));
  UM_TRY(um_model_run_with(w->context, s->model, s->tables, s->heat, &result));
  keep_result(w, result);
  um_model_result_destroy(w->context, &result);
  UM_TRY(balances(w));
  UM_TRY(respond(w));
  UM_TRY(move(w));
  return heated(w);
}

static void *begin(void *self)
{
  struct work *w = self;
  w->status = compute(w);
  return NULL;
}

static struct work *work_make(const struct shared *shared, int threads)
{
  struct work *w = test_calloc(1, sizeof *w);
  w->shared = shared;
  assert_int_equal(um_core_context_create(NULL, &w->context), UM_OK);
  um_core_context_set_threads(w->context, threads);
  return w;
}

static void eight_threads(void **state)
{
  (void)state;
  char path[UM_TEST_PATH];
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_thermal_solution *heat = NULL;
  struct work *w[THREADS + 1];
  pthread_t thread[THREADS];
  um_test_file_create(path, scenario, strlen(scenario));
  if (um_model_create(context, path, NULL, &model) != UM_OK ||
      um_model_precompute(context, model, &tables) != UM_OK ||
      um_model_thermal_solution_create(context, model, tables, NULL, 1.0, &heat) != UM_OK)
    fail_msg("%s", um_core_message(context));
  remove(path);
  const struct shared shared = {model, tables, heat};
  for (int i = 0; i <= THREADS; i++) w[i] = work_make(&shared, 1 + i % 2);
  begin(w[THREADS]); /* alone */
  for (int i = 0; i < THREADS; i++)
    assert_int_equal(pthread_create(&thread[i], NULL, begin, w[i]), 0);
  for (int i = 0; i < THREADS; i++) assert_int_equal(pthread_join(thread[i], NULL), 0);
  print_message("%zu numbers each\n", w[THREADS]->count);
  for (int i = THREADS; i >= 0; i--) {
    if (w[i]->status != UM_OK) fail_msg("thread %d: %s", i, um_core_message(w[i]->context));
    assert_int_equal(w[i]->count, w[THREADS]->count);
    for (size_t k = 0; k < w[i]->count; k++)
      if (memcmp(&w[i]->value[k], &w[THREADS]->value[k], sizeof(double)) != 0)
        fail_msg("thread %d: number %zu is %.17g, alone %.17g", i, k, w[i]->value[k],
                 w[THREADS]->value[k]);
  }
  for (int i = 0; i <= THREADS; i++) {
    um_core_context_destroy(&w[i]->context);
    test_free(w[i]);
  }
  um_model_thermal_solution_destroy(context, &heat);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(eight_threads)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
