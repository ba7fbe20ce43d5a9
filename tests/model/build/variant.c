/* A variant has the bits of a model of its own from a file that says the same: what it borrows from
 * its origin is what it would have made. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "orbit/time.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static const char *const scenario =
    "schema: 1\n"
    "name: variant\n"
    "time: {start_utc: 2016-09-21T09:17:00Z, stop_utc: 2016-09-21T09:18:00Z, step_s: 60}\n"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude: [{lvlh: {}}]\n"
    "observer:\n"
    "  station: {latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "  air: {profile: mid_latitude_summer, aerosol: 0.1}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     interior: {capacity_J_K: 1000, power_W: 5, conductance_W_K: 1},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "thermal: {start: isothermal, start_temperature_K: 290, orbits_before: 0.02}\n"
    "environment: {albedo: 0.3, earth: {model: map, file: earth.csv}}\n"
    "optics: {samples: 4}\n"
    "bands:\n"
    "  vis: {from_um: 0.51, to_um: 0.54, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n"
    "effects: [{effect: aerosol, depth: 0.02}, {effect: twilight, area_arcsec2: 50}]\n";

/* The Earth of two months, darker in the north in September. */
static const char *const earth = "month,latitude_deg,albedo,olr_W_m2\n"
                                 "8,-60,0.3,230\n"
                                 "8,60,0.5,200\n"
                                 "9,-60,0.3,230\n"
                                 "9,60,0.1,200\n";

static char base[UM_TEST_PATH], path[UM_TEST_PATH + 32], map[UM_TEST_PATH + 32];

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

/* Light and temperatures of a model; the caller destroys. */
static struct um_model_result *run(const struct um_model *model)
{
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  need(um_model_precompute(context, model, &tables));
  need(um_model_run(context, model, tables, &result));
  um_model_tables_destroy(context, &tables);
  return result;
}

static bool same(const double *a, const double *b, size_t n)
{
  return memcmp(a, b, n * sizeof *a) == 0;
}

static bool results_equal(const struct um_model_result *a, const struct um_model_result *b)
{
  size_t n = a->nobs * a->nband;
  return a->nobs == b->nobs && a->nband == b->nband && a->nsurface == b->nsurface &&
         same(a->irradiance, b->irradiance, n) && same(a->magnitude_ab, b->magnitude_ab, n) &&
         same(a->measured_intensity, b->measured_intensity, n) &&
         same(a->surface_temperature, b->surface_temperature, a->nobs * a->nsurface);
}

static double utc(const char *text)
{
  double t;
  char why[64];
  if (!um_orbit_time_parse_hook(text, &t, why, sizeof why)) fail_msg("%s: %s", text, why);
  return t;
}

/* NAN: the text is YAML. `utc`: a time, whose number is what the text says. */
static const struct {
  const char *key, *text;
  double number;
  bool utc;
} keys[] = {
    {"parts.box.interior.power_W", "50", 50.0, false},
    {"parts.box.size_factor", NULL, 0.0, false},
    {"environment.albedo", "0.25", 0.25, false},
    {"environment.earth.model", "uniform", NAN, false},
    {"time.start_utc", "2016-09-21T09:16:00Z", NAN, true},
    {"time.step_s", "30", 30.0, false},
    {"environment.earth.local", "{albedo_factor: 0.8}", NAN, false},
    {"orbit.earth_orientation.ut1_utc_s", "0.2", 0.2, false},
    {"observer.station.latitude_deg", "46.5", 46.5, false},
    {"observer.station.height_m", "900", 900.0, false},
    {"observer.air.aerosol", "0.2", 0.2, false},
    {"bands.vis.to_um", "0.56", 0.56, false},
    {"optics.samples", "8", 8.0, false},
    {"effects.aerosol.depth", "0.05", 0.05, false},
    {"effects.+", "{effect: zero_point, target: vis, factor: 0.9}", NAN, false},
};

static void test_keys(void **state)
{
  (void)state;
  struct um_model *origin = NULL;
  size_t wrong = 0;
  need(um_model_create(context, path, NULL, &origin));
  struct um_model_result *before = run(origin);
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    struct um_model *variant = NULL, *own = NULL;
    char set[160];
    const char *sets[] = {set};
    const struct um_document_change key = {.key = keys[i].key,
                                           .number =
                                               keys[i].utc ? utc(keys[i].text) : keys[i].number,
                                           .text = isnan(keys[i].number) ? keys[i].text : NULL};
    const struct um_model_changes changes = {.key = &key, .nkey = 1};
    const struct um_model_options options = {.overrides = sets, .noverride = 1};
    if (keys[i].text == NULL) { /* what a file is refused for, a variant is refused for */
      assert_int_equal(um_model_variant_create(context, origin, &changes, &variant),
                       UM_ERR_REFUSED);
      um_core_message_clear(context);
      continue;
    }
    snprintf(set, sizeof set, "%s=%s", keys[i].key, keys[i].text);
    need(um_model_create(context, path, &options, &own));
    need(um_model_variant_create(context, origin, &changes, &variant));
    struct um_model_result *a = run(variant), *b = run(own);
    if (!results_equal(a, b)) {
      print_error("%s: other bits than a model of its own\n", set);
      wrong++;
    }
    um_model_result_destroy(context, &a);
    um_model_result_destroy(context, &b);
    um_model_destroy(context, &variant);
    um_model_destroy(context, &own);
  }
  struct um_model_result *after = run(origin);
  assert_true(results_equal(before, after)); /* none of them wrote into it */
  um_model_result_destroy(context, &before);
  um_model_result_destroy(context, &after);
  um_model_destroy(context, &origin);
  assert_int_equal(wrong, 0);
}

/* What the command line adds and takes off holds for a variant; an addition is the same as --with.
 */
static void test_effects(void **state)
{
  (void)state;
  static const char *const with[] = {"zero_point:vis,factor=0.8"}, *const without[] = {"twilight"};
  static const char *const both[] = {"zero_point:vis,factor=0.8",
                                     "emittance:grey_white,factor=0.9"};
  const struct um_model_options some = {
      .with = with, .nwith = 1, .without = without, .nwithout = 1};
  const struct um_model_options all = {.with = both, .nwith = 2, .without = without, .nwithout = 1};
  const struct um_model_addition addition = {
      .effect = um_effects_find("emittance"), .target = "grey_white", .value = {0.9}};
  const struct um_document_change key = {.key = "environment.albedo", .number = 0.25};
  const struct um_document_change alike = {.key = "environment.albedo", .number = 0.3};
  const struct um_model_changes added[] = {
      {.addition = &addition, .naddition = 1},
      {.with = &both[1], .nwith = 1},
      {.addition = &addition, .naddition = 1, .key = &alike, .nkey = 1}};
  struct um_model *origin = NULL, *own = NULL, *variant = NULL;
  need(um_model_create(context, path, &some, &origin));
  need(um_model_create(context, path, &all, &own));
  struct um_model_result *expected = run(own);
  for (size_t i = 0; i < sizeof added / sizeof added[0]; i++) {
    need(um_model_variant_create(context, origin, &added[i], &variant));
    struct um_model_result *result = run(variant);
    assert_true(results_equal(result, expected));
    um_model_result_destroy(context, &result);
    um_model_destroy(context, &variant);
  }
  /* another list of effects is read anew, with what the command line said */
  const struct um_model_changes keyed = {.key = &key, .nkey = 1};
  need(um_model_variant_create(context, origin, &keyed, &variant));
  assert_int_equal(variant->neffect, origin->neffect);
  um_model_destroy(context, &variant);
  um_model_result_destroy(context, &expected);
  um_model_destroy(context, &own);
  um_model_destroy(context, &origin);
}

/* A variant keeps what it was told; effects of a variant are not listed anew, which would lose
 * some.
 */
static void test_of_its_own(void **state)
{
  (void)state;
  char *target = strdup("grey_white");
  const struct um_model_addition addition = {
      .effect = um_effects_find("emittance"), .target = target, .value = {0.9}};
  const struct um_document_change key = {.key = "environment.albedo", .number = 0.25};
  const struct um_model_changes added = {.addition = &addition, .naddition = 1},
                                keyed = {.key = &key, .nkey = 1};
  struct um_model *origin = NULL, *variant = NULL, *again = NULL;
  assert_non_null(target);
  need(um_model_create(context, path, NULL, &origin));
  need(um_model_variant_create(context, origin, &added, &variant));
  memset(target, 'x', strlen(target));
  free(target);
  assert_string_equal(variant->effect[variant->neffect - 1].target, "grey_white");
  assert_int_equal(um_model_variant_create(context, variant, &keyed, &again), UM_ERR_REFUSED);
  assert_null(again);
  um_core_message_clear(context);
  um_model_destroy(context, &variant);
  um_model_destroy(context, &origin);
}

/* What surfaces hide of each other's half space is traced once for all variants of a body, and anew
 * for another body. */
static void test_shares(void **state)
{
  (void)state;
  static const char *const wing[] = {
      "parts.+={name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 1.2, 0]}, "
      "front: grey_white, back: grey_white, lumped: true, shell: {areal_heat_capacity_J_m2_K: "
      "3000, through_conductance_W_m2_K: 50}}"};
  static const char *const without[] = {"mutual_radiation", "solar_multiple_reflection"};
  const struct um_model_options alone = {
      .overrides = wing, .noverride = 1, .without = without, .nwithout = 2};
  const struct um_model_addition warmer = {
      .effect = um_effects_find("emittance"), .target = "grey_white", .value = {0.9}};
  const struct um_model_addition larger = {
      .effect = um_effects_find("area"), .target = "wing", .value = {1.2}};
  const struct um_model_addition exchanging = {.effect = um_effects_find("mutual_radiation")};
  const struct um_model_changes same = {.addition = &warmer, .naddition = 1},
                                other = {.addition = &larger, .naddition = 1},
                                none = {.addition = &exchanging, .naddition = 1};
  struct um_model *origin = NULL, *variant = NULL;
  need(um_model_create(context, path, &alone, &origin));
  assert_non_null(origin->blocked);
  double most = 0.0;
  for (size_t s = 0; s < origin->nblocked; s++)
    if (!isnan(origin->blocked[s])) most = fmax(most, origin->blocked[s]);
  assert_true(most > 0.05 && most < 1.0);
  need(um_model_variant_create(context, origin, &same, &variant));
  assert_ptr_equal(variant->blocked, origin->blocked);
  um_model_destroy(context, &variant);
  need(um_model_variant_create(context, origin, &other, &variant));
  assert_non_null(variant->blocked);
  assert_ptr_not_equal(variant->blocked, origin->blocked);
  um_model_destroy(context, &variant);
  need(um_model_variant_create(context, origin, &none, &variant));
  assert_null(variant->blocked);
  um_model_destroy(context, &variant);
  um_model_destroy(context, &origin);
}

/* Two months of one cell each, with other albedos. */
static int set_up(void **state)
{
  if (um_test_folder_create(base) != 0) return -1;
  snprintf(path, sizeof path, "%s/scenario.yaml", base);
  snprintf(map, sizeof map, "%s/earth.csv", base);
  FILE *file = fopen(path, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  fclose(file);
  file = fopen(map, "w");
  if (file == NULL) return -1;
  fputs(earth, file);
  fclose(file);
  if (context_set_up(state) != 0) return -1;
  um_core_context_set_threads(context, 1); /* short runs */
  return 0;
}

static int tear_down(void **state)
{
  remove(path);
  remove(map);
  return um_test_folder_remove(base) == 0 ? context_tear_down(state) : -1;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_keys), cmocka_unit_test(test_effects),
                                     cmocka_unit_test(test_of_its_own),
                                     cmocka_unit_test(test_shares)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
