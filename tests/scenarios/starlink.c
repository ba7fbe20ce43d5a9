/* scenarios/starlink-v15: 800 magnitudes of Starlink v1.5 satellites against two plates whose
 * reflection is fitted to laboratory BRDFs, nothing fitted to the sky.
 *
 * Fankhauser, Tyson & Askari 2023 (AJ 166, 59) publish a Pearson correlation of magnitudes of 0.69
 * for their two plates with laboratory BRDFs and no earthshine: with the same data and surfaces
 * ours must not be worse. Earthshine is light that they say is there: with it the rms of the
 * residual in flux must be lower. 44 of the rows see the Sun through 5 to 40 km of the Earth's air,
 * which the publication leaves out: with it all three figures must be better.
 *
 * The materials are held against the laboratory's BRDF itself: rms of ln f as the fit left it
 * (scenarios/starlink-v15/README.md, printed to 0.001), 10 deg and more off the mirror direction.
 */
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "evidence/comparison/compare.h"
#include "evidence/measurements/measurements.h"
#include "materials/bsdf.h"
#include "materials/materials.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/materials/check.h"
#include "tests/materials/table.h"
#include "tests/scenarios/support.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/starlink-v15"
#define MEASURED SCENARIO "/measured.csv"

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

/* Residuals of rows [mag], above 0 where the model is too bright, whose straight line to the Sun is
 * lowest at 5 to 40 km over the ellipsoid: their mean, less the median of those above 60 km. */
struct below_40km {
  size_t count;
  double mean; /* [mag] */
};

/* That height [m], to 0.1 km. */
static double tangent_height(const struct um_environment_sample *at)
{
  struct um_vec3 low =
      um_vec3_sub(at->r, um_vec3_scale(at->sun, fmin(um_vec3_dot(at->r, at->sun), 0.0)));
  double sine = um_vec3_dot(low, at->pole) / um_vec3_norm(low);
  return um_vec3_norm(low) - UM_EARTH_RADIUS * (1.0 - UM_EARTH_FLATTENING * sine * sine);
}

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static struct below_40km below_40km(const struct um_compare_comparison *c)
{
  static double above[800];
  struct below_40km out = {0, 0.0};
  size_t nabove = 0;
  for (size_t i = 0; i < c->run.plan->measurements->count; i++) {
    size_t place = c->run.plan->observation[i];
    if (place == UM_COMPARE_NOWHERE || !(c->residual[i].model > 0.0)) continue;
    double h = tangent_height(&c->run.tables->sample[place * c->run.tables->nsub]);
    double off = -2.5 * log10(c->residual[i].measured / c->residual[i].model);
    if (h > 60e3) above[nabove++] = off;
    if (h < 5e3 || h >= 40e3) continue;
    out.mean += off;
    out.count++;
  }
  qsort(above, nabove, sizeof *above, ascending);
  out.mean = out.mean / (double)out.count - above[nabove / 2];
  return out;
}

/* Metrics of the only channel; and of what the air takes, unless NULL. */
static struct um_compare_metrics metrics_and_air(const struct um_model_options *options,
                                                 struct below_40km *air)
{
  struct um_compare_measurements *measurements;
  struct um_model *model;
  struct um_compare_plan *plan;
  struct um_model_tables *tables;
  struct um_model_result *result;
  struct um_compare_comparison *comparison;
  need(um_compare_measurements_read(context, MEASURED, &measurements));
  need(um_model_create(context, SCENARIO, options, &model));
  need(um_compare_plan_create(context, model, measurements, &plan));
  need(um_compare_plan_trace(context, model, plan, &tables));
  need(um_model_run(context, model, tables, &result));
  struct um_compare_run run = {model, plan, tables, result};
  need(um_compare_create(context, &run, 0.0, &comparison));
  assert_int_equal(comparison->nchannel, 1);
  struct um_compare_metrics all = comparison->channel[0].all;
  if (air != NULL) *air = below_40km(comparison);
  um_compare_destroy(context, &comparison);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_compare_plan_destroy(context, &plan);
  um_model_destroy(context, &model);
  um_compare_measurements_destroy(context, &measurements);
  return all;
}

static struct um_compare_metrics metrics_of(const struct um_model_options *options)
{
  return metrics_and_air(options, NULL);
}

/* 44 rows with a scatter of 0.75 mag: 0.11 mag of the mean. It must be below 0.15, with the air of
 * climatology; without air it is 1.28, with ozone in one layer at 20 km and straight rays 0.30. */
static void air_below_40_km(void **state)
{
  static const char *const air[] = {"shadow_refraction"};
  struct um_model_options vacuum = {.without = air, .nwithout = 1};
  struct below_40km with, without;
  (void)state;
  metrics_and_air(NULL, &with);
  metrics_and_air(&vacuum, &without);
  print_message("%zu rows: %+.3f mag, without air %+.3f\n", with.count, with.mean, without.mean);
  assert_int_equal(with.count, 44);
  assert_true(fabs(with.mean) < 0.15);
  assert_true(without.mean > 1.0);
}

static void magnitudes(void **state)
{
  (void)state;
  static const char *const earthshine[] = {"earthshine"}, *const air[] = {"shadow_refraction"};
  struct um_model_options without = {.without = earthshine, .nwithout = 1};
  struct um_model_options vacuum = {.without = air, .nwithout = 1};
  struct um_compare_metrics with = metrics_of(NULL), dark = metrics_of(&without);
  struct um_compare_metrics airless = metrics_of(&vacuum);
  print_message("with earthshine: correlation %.4f, rms %.8g, median measured/model %.3f\n",
                with.correlation, with.rms, with.median_ratio);
  print_message("without:         correlation %.4f, rms %.8g\n", dark.correlation, dark.rms);
  print_message("without air:     correlation %.4f, rms %.8g\n", airless.correlation, airless.rms);
  assert_int_equal(with.count, 800);
  assert_true(with.correlation >= 0.69);
  assert_true(with.rms < dark.rms);
  assert_true(with.chi2 < dark.chi2);
  assert_true(with.correlation > airless.correlation);
  assert_true(with.rms < airless.rms && with.chi2 < airless.chi2);
}

/* What the sky alone decides, as fitted and printed on the scenario's page: the level of the
 * chassis' lobe, a zero point and a background bring the rms of magnitudes below 0.6. */
static void magnitudes_with_what_the_sky_decides(void **state)
{
  (void)state;
  static const char *const with[] = {"zero_point:v,factor=2.079",
                                     "background:v,irradiance_W_m2=2.649e-12",
                                     "specular_level:starlink_chassis,factor=0.3643",
                                     "specular_level:starlink_array,factor=1.008"};
  struct um_model_options options = {.with = with, .nwith = 4};
  struct um_compare_metrics m = metrics_of(&options);
  print_message("fitted: correlation %.4f, rms %.4f mag\n", m.correlation, m.rms_mag);
  assert_true(m.rms_mag < 0.6);
  assert_true(m.correlation > 0.796);
}

/* rms of ln f of a record over the rows that its fit used; their number. */
static double residual(const struct um_materials_record *record, const char *surface, size_t *count)
{
  struct um_core_csv *csv = NULL;
  double squares = 0.0;
  *count = 0;
  need(um_core_csv_read(context, SCENARIO "/brdf.csv", &csv));
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    double in, out, brdf;
    need(um_core_csv_number(context, csv, i, 1, &in));
    need(um_core_csv_number(context, csv, i, 2, &out));
    need(um_core_csv_number(context, csv, i, 3, &brdf));
    double half = 0.5 * fabs(in - out);
    if (strcmp(um_core_csv_text(csv, i, 0), surface) != 0 || half < 10.0 || fabs(out) > 85.0)
      continue;
    double cos_h = cos(half * UM_DEG);
    double lobe = um_materials_beckmann_lobe(um_materials_roughness(record, NULL), cos_h,
                                             cos(in * UM_DEG), cos(out * UM_DEG));
    double model = um_materials_diffuse_reflectance(record, NULL, 532e-9) / UM_PI +
                   um_materials_specular_reflectance(record, NULL, 532e-9, cos_h) * lobe;
    squares += pow(log(brdf / model), 2.0);
    (*count)++;
  }
  um_core_csv_destroy(&csv);
  return sqrt(squares / (double)*count);
}

static void materials_are_the_laboratory(void **state)
{
  (void)state;
  static const struct {
    const char *surface, *record;
    size_t count;
    double rms;
  } fits[] = {{"chassis", "starlink_chassis", 536, 0.284}, {"array", "starlink_array", 536, 0.207}};
  for (size_t i = 0; i < 2; i++) {
    char path[1024];
    size_t count;
    struct um_materials_library *library;
    snprintf(path, sizeof path, SCENARIO "/materials/%s.yaml", fits[i].record);
    need(library_under_e490(context, &library));
    need(um_materials_library_read_file(context, library, path, NULL, 0));
    double rms = residual(um_materials_library_at(library, 0), fits[i].surface, &count);
    print_message("%s: %zu rows, rms of ln f %.4f\n", fits[i].surface, count, rms);
    assert_int_equal(count, fits[i].count);
    support_close(fits[i].record, rms, fits[i].rms, 6e-4);
    um_materials_library_destroy(&library);
  }
}

/* The authors' own fit, log10 f = B0 + B1 D + 1/2 sum_k C_k log10(1 + 3^(k + l) D^2) with D between
 * the direction cosines (authors_brdf.py has its source). */
struct published {
  const char *surface, *record;
  double b[2], c[10];
  int n, l;
  double rms; /* of ln f over the same rows, by the scenario's page */
};
static const struct published published[2] = {
    {"chassis",
     "starlink_chassis",
     {3.34, -98.085},
     {-999.999, 867.538, 1000.0, 1000.0, -731.248, 618.552, -294.054, 269.248, -144.853, 75.196},
     10,
     -5,
     0.187},
    {"array",
     "starlink_array",
     {0.534, -20.409},
     {-527.765, 1000.0, -676.579, 430.596, -175.806, 57.879},
     6,
     -3,
     0.182}};

static double published_brdf(const struct published *p, double d)
{
  double log_f = p->b[0] + p->b[1] * d;
  for (int k = 0; k < p->n; k++) log_f += 0.5 * p->c[k] * log10(1.0 + pow(3.0, k + p->l) * d * d);
  return pow(10.0, log_f);
}

static void published_rows(const struct published *p)
{
  struct um_core_csv *csv = NULL;
  double squares = 0.0;
  size_t count = 0;
  need(um_core_csv_read(context, SCENARIO "/brdf.csv", &csv));
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    double in, out, brdf;
    need(um_core_csv_number(context, csv, i, 1, &in));
    need(um_core_csv_number(context, csv, i, 2, &out));
    need(um_core_csv_number(context, csv, i, 3, &brdf));
    if (strcmp(um_core_csv_text(csv, i, 0), p->surface) != 0 || fabs(in - out) < 20.0 ||
        fabs(out) > 85.0)
      continue;
    double d = fabs(sin(in * UM_DEG) - sin(out * UM_DEG));
    squares += pow(log(brdf / published_brdf(p, d)), 2.0);
    count++;
  }
  um_core_csv_destroy(&csv);
  support_close(p->surface, sqrt(squares / (double)count), p->rms, 6e-4);
}

/* A record of it as a table every 2.5 deg, the spike held at D = 0.1. */
static void published_record(const struct published *p, char table[UM_TEST_PATH],
                             char path[UM_TEST_PATH])
{
  const struct test_brdf none = {{0}, 1.0, 0.0};
  struct um_materials_measured_grid g = test_grid(&none, 2.5, 85.0, 2.5);
  char text[1024];
  for (size_t k = 0; k < g.npolar * g.npolar * g.nazimuth; k++) {
    double i = sin(g.polar[k / g.nazimuth / g.npolar]), o = sin(g.polar[k / g.nazimuth % g.npolar]);
    double phi = g.azimuth[k % g.nazimuth];
    g.f[k] = published_brdf(p, fmax(0.1, hypot(o * cos(phi) - i, o * sin(phi))));
  }
  um_test_file_create(table, "", 0);
  test_grid_write(&g, table);
  test_grid_free(&g);
  snprintf(text, sizeof text,
           "name: %s\nsummary: test\ncitation: test\nreflectance: {wavelength_um: [0.3, 2.5], "
           "diffuse: [0, 0], specular: [1, 1]}\nlobe: {kind: measured, file: %s}\n",
           p->record, table);
  um_test_file_create(path, text, strlen(text));
}

/* Both fits of the laboratory's rows in the plane, out of it: what the page says of either. */
static void out_of_the_plane(void **state)
{
  static const struct {
    size_t from, count;
    double correlation;
  } cases[] = {{0, 2, 0.7387}, {0, 1, 0.7320}, {1, 1, 0.7680}};
  char table[2][UM_TEST_PATH], path[2][UM_TEST_PATH], set[2][UM_TEST_PATH + 32];
  const char *overrides[2] = {set[0], set[1]};
  (void)state;
  for (size_t s = 0; s < 2; s++) {
    published_rows(&published[s]);
    published_record(&published[s], table[s], path[s]);
    snprintf(set[s], sizeof set[s], "material_files.+=%.*s", UM_TEST_PATH - 1, path[s]);
  }
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_model_options options = {.overrides = overrides + cases[k].from,
                                       .noverride = cases[k].count};
    struct um_compare_metrics m = metrics_of(&options);
    print_message("%s: correlation %.4f, bias %.3f mag\n",
                  cases[k].count == 2 ? "both by their authors" : published[cases[k].from].surface,
                  m.correlation, m.bias_mag);
    support_close("correlation", m.correlation, cases[k].correlation, 6e-4);
  }
  for (size_t s = 0; s < 2; s++) {
    unlink(table[s]);
    unlink(path[s]);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(magnitudes), cmocka_unit_test(air_below_40_km),
      cmocka_unit_test(magnitudes_with_what_the_sky_decides),
      cmocka_unit_test(materials_are_the_laboratory), cmocka_unit_test(out_of_the_plane)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
