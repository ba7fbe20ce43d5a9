#include "tests/effects/case.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"

/* At the equinox the Sun stands along +x of GCRS, within 0.2 deg at noon. */
const char *const case_plate =
    "schema: 1\n"
    "name: plate\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:02:00Z, step_s: 60}\n"
    "orbit: {fixed: {position_gcrs_km: [3000, 6500, 1000]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "observer: {direction: {unit_gcrs: [0.8, -0.5, 0.3], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: plate, plate: {size_m: [2, 1]}, pose: {rotation_deg: [0, 64, 0]},\n"
    "     joint: {axis: [0, 1, 0], angle_deg: 0},\n"
    "     front: grey_panel, back: grey_white, lumped: true, facet_size_m: 0.3,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: isothermal, start_temperature_K: 290, orbits_before: 0, accuracy_K: 0.01}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

#define ORBIT                                                                                      \
  "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:04:00Z, step_s: 120}\n"         \
  "orbit: {circular: {altitude_km: 600, beta_deg: 20, epoch_utc: 2020-03-20T12:10:00Z}}\n"         \
  "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0.6, 0.8], period_s: 700,\n"            \
  "  at_utc: 2020-03-20T12:01:00Z}}]\n"                                                            \
  "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
#define WING                                                                                       \
  "     front: grey_panel, back: white_paint, lumped: true,\n"                                     \
  "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"              \
  "thermal: {start: isothermal, start_temperature_K: 280, orbits_before: 0.02}\n"                  \
  "optics: {interreflection_samples: 8}\n"                                                         \
  "bands:\n"                                                                                       \
  "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"                                                 \
  "  lwir: {from_um: 8, to_um: 12, bins: 3}\n"

const char *const case_satellite =
    "schema: 1\n"
    "name: satellite\n" ORBIT "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: mli_kapton, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 300}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, parent: box, pose: {position_m: [0, 1.5, 0]},\n"
    "     joint: {axis: [0, 1, 0], track: sun, normal: [0, 0, 1]},\n" WING;

const char *const case_spinner =
    "schema: 1\n"
    "name: spinner\n" ORBIT "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {rotation_deg: [0, 60, 0]},\n"
    "     joint: {axis: [0, 1, 0], angle_deg: 5},\n" WING;

static struct um_context *context;

int case_begin(void **state)
{
  (void)state;
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

int case_end(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return 0;
}

struct um_context *case_context(void) { return context; }

void case_write(const char *file_name, const char *text)
{
  FILE *f = fopen(file_name, "w");
  assert_non_null(f);
  fputs(text, f);
  fclose(f);
}

static size_t length(const char *const *list)
{
  size_t n = 0;
  while (list != NULL && list[n] != NULL) n++;
  return n;
}

static enum um_status create(const char *scenario, const char *const *with,
                             const char *const *without, const char *const *set,
                             struct um_model **out)
{
  const struct um_model_options options = {.allow_effects = true,
                                           .overrides = set,
                                           .noverride = length(set),
                                           .with = with,
                                           .nwith = length(with),
                                           .without = without,
                                           .nwithout = length(without)};
  char file_name[64]; /* tests run beside each other in one folder */
  snprintf(file_name, sizeof file_name, "effects_case_%ld.yaml", (long)getpid());
  case_write(file_name, scenario);
  enum um_status status = um_model_create(context, file_name, &options, out);
  remove(file_name);
  return status;
}

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

struct case_run case_compute(const char *scenario, const char *const *with,
                             const char *const *without, const char *const *set)
{
  struct case_run run = {0};
  need(create(scenario, with, without, set, &run.model));
  need(um_model_precompute(context, run.model, &run.tables));
  need(um_model_run(context, run.model, run.tables, &run.result));
  return run;
}

struct case_run case_with(const char *scenario, const char *with)
{
  const char *const list[] = {with, NULL};
  return case_compute(scenario, list, NULL, NULL);
}

void case_release(struct case_run *run)
{
  um_model_result_destroy(context, &run->result);
  um_model_tables_destroy(context, &run->tables);
  um_model_destroy(context, &run->model);
}

void case_refused(const char *scenario, const char *with, const char *part)
{
  const char *const list[] = {with, NULL};
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  um_core_message_clear(context); /* the first message is kept */
  enum um_status status = create(scenario, list, NULL, NULL, &model);
  if (status == UM_OK) status = um_model_precompute(context, model, &tables);
  if (status == UM_OK) fail_msg("%s was accepted", with);
  if (strstr(um_core_message(context), part) == NULL)
    fail_msg("'%s' does not hold '%s'", um_core_message(context), part);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

static bool same(const double *a, const double *b, size_t n)
{
  return memcmp(a, b, n * sizeof *a) == 0;
}

bool case_same_temperatures(const struct case_run *a, const struct case_run *b)
{
  const struct um_model_result *x = a->result, *y = b->result;
  return x->nobs == y->nobs && x->nsurface == y->nsurface && x->nnode == y->nnode &&
         same(x->surface_temperature, y->surface_temperature, x->nobs * x->nsurface) &&
         same(x->node_temperature, y->node_temperature, x->nobs * x->nnode);
}

bool case_same_intensities(const struct case_run *a, const struct case_run *b)
{
  const struct um_model_result *x = a->result, *y = b->result;
  return x->nobs == y->nobs && x->nband == y->nband && x->nmaterial == y->nmaterial &&
         x->nbin == y->nbin &&
         same(x->intensity, y->intensity, x->nobs * x->nband * x->nmaterial * UM_MECHANISM_COUNT) &&
         same(x->spectral, y->spectral, x->nobs * x->nbin * UM_MECHANISM_COUNT) &&
         same(x->standard_error, y->standard_error, x->nobs * x->nband);
}

bool case_same(const struct case_run *a, const struct case_run *b)
{
  const struct um_model_result *x = a->result, *y = b->result;
  return case_same_temperatures(a, b) && case_same_intensities(a, b) &&
         same(x->irradiance, y->irradiance, x->nobs * x->nband) &&
         same(x->magnitude_ab, y->magnitude_ab, x->nobs * x->nband) && x->nplace == y->nplace &&
         memcmp(x->heat, y->heat, x->nobs * x->nplace * sizeof *x->heat) == 0;
}

double case_intensity(const struct case_run *run, size_t k, const char *band, const char *material,
                      int mechanism)
{
  const struct um_model_result *r = run->result;
  size_t b = um_model_band_find(run->model, band), m = 0;
  assert_true(b < r->nband);
  while (m < r->nmaterial &&
         strcmp(um_geometry_material_name(run->model->geometry, m), material) != 0)
    m++;
  assert_true(m < r->nmaterial);
  return r
      ->intensity[((k * r->nband + b) * r->nmaterial + m) * UM_MECHANISM_COUNT + (size_t)mechanism];
}

void case_near(const char *what, double value, double expected, double tolerance)
{
  if (!(fabs(value - expected) <= tolerance * fabs(expected)))
    fail_msg("%s: computed %.12g, expected %.12g within %g", what, value, expected, tolerance);
}
