/* Every key of a scenario that holds a number, a switch or a choice is changed, one after another:
 * an evaluator, which keeps what a change leaves the same, gives the bits of a model of its own. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "model/scenario/scenario_schema.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"
#include "variant/evaluator.h"

#define PATH 200

#define TIME "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:02:00Z, step_s: 60"
#define ENDS                                                                                       \
  "optics: {samples: 2, interreflection_samples: 2, seed: 3}\n"                                    \
  "bands:\n"                                                                                       \
  "  vis: {from_um: 0.51, to_um: 0.56, bins: 2}\n"                                                 \
  "  lwir: {from_um: 8, to_um: 12, bins: 2}\n"
#define SHELL                                                                                      \
  "shell: {areal_heat_capacity_J_m2_K: 3000, conductance_W_K: 0.1,\n"                              \
  "      through_conductance_W_m2_K: 50, front_share: 0.4}"

/* Together they hold nearly all of the schema. */
static const char *const scenarios[] = {
    /* A station, elements by Kepler, a detector, an Earth with a region of its own, MLI. */
    "schema: 1\nname: station\n" TIME ", exposure_s: 2, exposure_samples: 2, light_time: true}\n"
    "orbit: {kepler: {epoch_utc: 2020-03-20T12:00:00Z, a_km: 6978, e: 0.01, i_deg: 98, raan_deg: "
    "30,\n"
    "  argp_deg: 40, mean_anomaly_deg: 10}, earth_orientation: {ut1_utc_s: 0.1}}\n"
    "attitude: [{spin: {axis_body: [0, 0, 1], axis_gcrs: [0.3, 0.1, 1], period_s: 200}}]\n"
    "observer:\n"
    "  station: {latitude_deg: 40, longitude_deg: 20, height_m: 100}\n"
    "environment: {albedo: 0.3, earth: {model: knocke, local: {albedo_factor: 0.9}}, shadow_air: "
    "{}}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true, " SHELL ",\n"
    "     mli: {effective_emittance: 0.03, areal_heat_capacity_J_m2_K: 80, wraps: interior,\n"
    "       seam_length_m: 3, seam_conductance_W_m_K: 0.02},\n"
    "     interior: {capacity_J_K: 1000, power_W: 5, conductance_W_K: 1},\n"
    "     groups: {\"+z\": {bare: true, " SHELL ", interior_conductance_W_K: 2, power_W: 1}}}\n"
    "  - {name: cap, cone: {radius_m: 0.3, height_m: 0.2, radius_top_m: 0.1}, outside: "
    "grey_panel,\n"
    "     pose: {position_m: [0, 0, 0.7], rotation_deg: [0, 10, 0]}, lumped: true, " SHELL "}\n"
    "contacts: [{a: box.interior, b: cap, conductance_W_K: 0.5}]\n"
    "thermal: {start: isothermal, start_temperature_K: 290, orbits_before: 0.02, step_s: 60,\n"
    "  view_factor_rays: 64, samples: 1, facet_size_m: 2, exchange_patches: 64}\n"
    "sensors: {eye: {band: vis, aperture_m: 0.5, pixel_arcsec: 1, read_noise_e: 3, dark_e_s: 1}}\n"
    "effects: [{effect: zero_point, target: vis, factor: 0.9}, {effect: emittance,\n"
    "  target: grey_white, factor: 0.95}]\n" ENDS,
    /* An observer in a direction, a circular orbit with its periodic state, joints, solids. */
    "schema: 1\nname: direction\n" TIME "}\n"
    "orbit: {circular: {altitude_km: 600, beta_deg: 20}}\n"
    "attitude: [{lvlh: {}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "environment: {earth: {model: uniform}, sun: frozen}\n"
    "parts:\n"
    "  - {name: can, cylinder: {radius_m: 0.3, height_m: 0.5}, outside: aluminium_bare,\n"
    "     inside_emittance: 0.8, lumped: true, start_temperature_K: 285, " SHELL ",\n"
    "     interiors: {boards: {capacity_J_K: 500, power_W: 3, conductance_W_K: 0.5}}}\n"
    "  - {name: wing, plate: {size_m: [1, 0.5]}, pose: {position_m: [0, 1, 0]}, lumped: true,\n"
    "     front: grey_panel, back: grey_white, electrical_extraction: 0.2, " SHELL ",\n"
    "     joint: {axis: [1, 0, 0], angle_deg: 5}, flatness: {tilt_rms_deg: 1, patch_m: 0.1}}\n"
    "  - {name: block, box: {size_m: [0.2, 0.3, 0.2]}, pose: {position_m: [1, 0, 0]},\n"
    "     outside: grey_white, solid: {density_kg_m3: 2700, specific_heat_J_kg_K: 900,\n"
    "       conductivity_W_m_K: 150, tetrahedron_size_m: 0.5, power_W: 1}}\n"
    "contacts: [{a: can.boards, b: wing, exchange_area_m2: 0.1}]\n"
    "thermal: {start: periodic, step_s: 300, view_factor_rays: 64, samples: 1, facet_size_m: 2,\n"
    "  accuracy_K: 0.1}\n" ENDS,
    /* A body with creases that tumbles at a place that stands still, seen through air. */
    "schema: 1\nname: tumble\n" TIME "}\n"
    "orbit: {fixed: {position_gcrs_km: [7000, 0, 0]}}\n"
    "attitude: [{tumble: {q_gcrs: [1, 0, 0, 0], rates_deg_s: [0.1, 0.2, 1],\n"
    "  inertia_kg_m2: [10, 20, 15]}}]\n"
    "observer:\n"
    "  station: {latitude_deg: 0, longitude_deg: 0}\n"
    "  air: {profile: us_standard, aerosol: 0.1, cirrus: 0.05}\n"
    "parts: [{name: wing, disc: {radius_m: 0.5}, front: grey_panel, back: grey_white,\n"
    "  lumped: true, creases: {tilt_rms_deg: 3, patch_m: 0.2, seed: 2}, " SHELL "}]\n"
    "thermal: {start: isothermal, orbits_before: 0.01, step_s: 60, facet_size_m: 2, samples: "
    "1}\n" ENDS,
};

static char folder[UM_TEST_PATH], path[UM_TEST_PATH + 16];

/* --- a key with another value ---------------------------------------------------------------- */

struct walk {
  struct um_variant_evaluator *evaluator;
  struct um_model_thermal_solution *heat; /* of the scenario as it stands, by a run of its own */
  const char *const *sections;            /* that are changed, ending with NULL; NULL: all */
  size_t tried, refused, reused, wrong;   /* reused: heat of the scenario as it stands */
};

static struct um_model_result *own_run(const char *override)
{
  const char *sets[] = {override};
  const struct um_model_options options = {.overrides = sets, .noverride = 1};
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  if (um_model_create(context, path, &options, &model) == UM_OK &&
      um_model_precompute(context, model, &tables) == UM_OK)
    (void)um_model_run(context, model, tables, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  um_core_message_clear(context);
  return result;
}

/* With the heat of the scenario as it stands where that is said to be the same. */
static struct um_model_result *variant_run(struct walk *walk, const struct um_document_change *key)
{
  static const struct um_variant_heat how = {.start = UM_VARIANT_COLD};
  const struct um_model_changes changes = {.key = key, .nkey = 1};
  struct um_variant v;
  struct um_model_result *result = NULL;
  bool compatible = false;
  enum um_status status = um_variant_open(context, walk->evaluator, &changes, NULL, &v);
  if (status == UM_OK)
    status = um_model_thermal_solution_is_compatible(context, walk->heat, v.model, v.tables,
                                                     &compatible);
  if (status == UM_OK && compatible)
    v.heat = walk->heat;
  else if (status == UM_OK)
    status = um_variant_find_heat(context, walk->evaluator, &how, &v);
  if (status == UM_OK) (void)um_variant_observe(context, walk->evaluator, &v, &result);
  walk->reused += compatible;
  um_variant_close(context, &v);
  um_core_message_clear(context);
  return result;
}

static bool same(const void *a, const void *b, size_t bytes) { return memcmp(a, b, bytes) == 0; }

static bool results_equal(const struct um_model_result *a, const struct um_model_result *b)
{
  size_t n = a->nobs * a->nband;
  return a->nobs == b->nobs && a->nband == b->nband && a->nsurface == b->nsurface &&
         same(a->irradiance, b->irradiance, n * sizeof(double)) &&
         same(a->magnitude_ab, b->magnitude_ab, n * sizeof(double)) &&
         same(a->measured_intensity, b->measured_intensity, n * sizeof(double)) &&
         same(a->surface_temperature, b->surface_temperature,
              a->nobs * a->nsurface * sizeof(double));
}

/* number NAN: the text alone. A change that one refuses, the other refuses. */
static void try_key(struct walk *walk, const char *key, double number, const char *text)
{
  char override[2 * PATH];
  const struct um_document_change change = {
      .key = key, .number = number, .text = isnan(number) ? text : NULL};
  snprintf(override, sizeof override, "%s=%s", key, text);
  struct um_model_result *own = own_run(override), *variant = variant_run(walk, &change);
  walk->tried++;
  if (own == NULL && variant == NULL) {
    walk->refused++;
  } else if (own == NULL || variant == NULL || !results_equal(own, variant)) {
    print_error("%s: %s\n", override,
                own == NULL || variant == NULL ? "one is refused" : "other bits than of its own");
    walk->wrong++;
  }
  um_model_result_destroy(context, &own);
  um_model_result_destroy(context, &variant);
}

/* --- the walk -------------------------------------------------------------------------------- */

/* A number beside `value` that the field accepts; NAN: there is none yet. */
static double other_number(const struct um_schema_field *f, double value)
{
  bool bound = f->minimum != f->maximum;
  double up = isnan(value) ? 0.0 : value == 0.0 ? 0.02 : 1.02 * value;
  if (isnan(value)) up = bound ? fmax(f->minimum, fmin(1.0, f->maximum)) : 1.0;
  if (bound && up == f->minimum && f->open_minimum) up = fmin(f->minimum + 1.0, f->maximum);
  if (bound && (up > f->maximum || up < f->minimum)) up = 0.98 * value;
  return up;
}

static void walk_scalar(struct walk *walk, const struct um_schema_field *f, const void *member,
                        const char *key)
{
  char text[PATH];
  double number = NAN;
  if (f->type == UM_SCHEMA_NUMBER) {
    number = other_number(f, *(const double *)member);
    snprintf(text, sizeof text, "%.17g", number);
  } else if (f->type == UM_SCHEMA_INTEGER) {
    int value = *(const int *)member;
    number = value < 0 ? fmax(f->minimum, 1.0) : value + 1 > f->maximum ? value - 1 : value + 1;
    snprintf(text, sizeof text, "%.0f", number);
  } else if (f->type == UM_SCHEMA_BOOL) {
    snprintf(text, sizeof text, "%s", *(const bool *)member ? "false" : "true");
  } else {
    int value = *(const int *)member;
    const char *next = value < 0 ? NULL : f->choices[value + 1];
    snprintf(text, sizeof text, "%s", next == NULL ? f->choices[0] : next);
  }
  try_key(walk, key, number, text);
}

static void walk_vector(struct walk *walk, const double *value, size_t n, const char *key)
{
  for (size_t which = 0; which < n; which++) {
    char text[PATH] = "[";
    for (size_t i = 0; i < n; i++) {
      double x = i != which ? value[i] : value[i] == 0.0 ? 0.02 : 1.02 * value[i];
      snprintf(text + strlen(text), sizeof text - strlen(text), "%s%.17g", i > 0 ? ", " : "", x);
    }
    strncat(text, "]", sizeof text - strlen(text) - 1);
    try_key(walk, key, NAN, text);
  }
}

/* "above.key"; a path that does not fit fails the test. */
static void join(char key[PATH], const char *above, const char *format, ...) UM_PRINTF(3, 4);
static void join(char key[PATH], const char *above, const char *format, ...)
{
  va_list list;
  char name[PATH];
  va_start(list, format);
  vsnprintf(name, sizeof name, format, list);
  va_end(list);
  assert_true(strlen(above) + strlen(name) + 2 < PATH);
  strcpy(key, above);
  if (above[0] != '\0') strcat(key, ".");
  strcat(key, name);
}

static void walk_object(struct walk *walk, const struct um_schema_object *object, const void *bound,
                        const char *above);

static void walk_list(struct walk *walk, const struct um_schema_field *f,
                      const struct um_schema_list *list, const char *key)
{
  for (size_t i = 0; i < list->count; i++) {
    char below[PATH];
    const char *item = (const char *)list->items + i * f->object->size;
    if (f->type == UM_SCHEMA_LIST)
      join(below, key, "%zu", i);
    else
      join(below, key, "%s", *(const char *const *)(const void *)(item + sizeof(struct um_mark)));
    walk_object(walk, f->object, item, below);
  }
}

static void walk_rest(struct walk *walk, const struct um_schema_list *list, const char *above)
{
  for (size_t i = 0; i < list->count; i++) {
    char key[PATH], text[32];
    const struct um_schema_number *number = (const struct um_schema_number *)list->items + i;
    join(key, above, "%s", number->name);
    snprintf(text, sizeof text, "%.17g", 1.02 * number->value);
    try_key(walk, key, 1.02 * number->value, text);
  }
}

static bool wanted(const struct walk *walk, const char *section)
{
  if (walk->sections == NULL) return true;
  for (const char *const *s = walk->sections; *s != NULL; s++)
    if (strcmp(*s, section) == 0) return true;
  return false;
}

static void walk_field(struct walk *walk, const struct um_schema_field *f, const void *bound,
                       const char *above)
{
  char key[PATH];
  const char *member = (const char *)bound + f->offset;
  const struct um_schema_list *list = (const struct um_schema_list *)(const void *)member;
  join(key, above, "%s", f->key);
  if (above[0] == '\0' && !wanted(walk, f->key)) return;
  switch (f->type) {
  case UM_SCHEMA_NUMBER:
  case UM_SCHEMA_INTEGER:
  case UM_SCHEMA_BOOL:
  case UM_SCHEMA_CHOICE:
    walk_scalar(walk, f, member, key);
    break;
  case UM_SCHEMA_VECTOR:
    walk_vector(walk, (const double *)(const void *)member, f->length, key);
    break;
  case UM_SCHEMA_NUMBERS:
    walk_vector(walk, list->items, list->count, key);
    break;
  case UM_SCHEMA_MAP: {
    const void *below = *(const void *const *)(const void *)member;
    if (below != NULL) walk_object(walk, f->object, below, key);
    break;
  }
  case UM_SCHEMA_LIST:
  case UM_SCHEMA_DICT:
    walk_list(walk, f, list, key);
    break;
  case UM_SCHEMA_REST:
    walk_rest(walk, list, above);
    break;
  case UM_SCHEMA_TEXT:
  case UM_SCHEMA_TEXTS:
  case UM_SCHEMA_PARSED:
    break;
  }
}

static void walk_object(struct walk *walk, const struct um_schema_object *object, const void *bound,
                        const char *above)
{
  for (size_t i = 0; i < object->nfield; i++) walk_field(walk, &object->fields[i], bound, above);
}

/* of: the sections that are changed, ending with NULL; NULL: all. */
static void change_every_key(const char *scenario, const char *const *of)
{
  const struct um_variant_settings settings = {.base = {1.0, UM_MODEL_PERIODIC_TOLERANCE}};
  struct walk walk = {.sections = of};
  struct um_model *model = NULL;
  struct um_variant base;
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(scenario, file);
  fclose(file);
  if (um_model_create(context, path, NULL, &model) != UM_OK ||
      um_variant_evaluator_create(context, model, &settings, &walk.evaluator) != UM_OK ||
      um_variant_base(context, walk.evaluator, &base) != UM_OK ||
      um_model_thermal_solution_create(context, model, base.tables, NULL, 1.0, &walk.heat) != UM_OK)
    fail_msg("%s", um_core_message(context));
  walk_object(&walk, &um_model_scenario_schema, model->scenario, "");
  um_model_thermal_solution_destroy(context, &walk.heat);
  um_variant_evaluator_destroy(context, &walk.evaluator);
  um_model_destroy(context, &model);
  remove(path);
  print_message("%zu keys changed, %zu of them refused, heat of %zu is the same\n", walk.tried,
                walk.refused, walk.reused);
  assert_int_equal(walk.wrong, 0);
}

static void test_station(void **state)
{
  (void)state;
  change_every_key(scenarios[0], NULL);
}

static void test_direction(void **state)
{
  static const char *const of[] = {"orbit", "environment", "parts", "contacts", "thermal", NULL};
  (void)state;
  change_every_key(scenarios[1], of);
}

static void test_tumble(void **state)
{
  static const char *const of[] = {"orbit", "attitude", "observer", "parts", NULL};
  (void)state;
  change_every_key(scenarios[2], of);
}

static int set_up(void **state)
{
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(path, sizeof path, "%s/scenario.yaml", folder);
  if (context_set_up(state) != 0) return -1;
  um_core_context_set_threads(context, 1); /* short runs */
  return 0;
}

static int tear_down(void **state)
{
  return um_test_folder_remove(folder) == 0 ? context_tear_down(state) : -1;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_station),
                                     cmocka_unit_test(test_direction),
                                     cmocka_unit_test(test_tumble)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
