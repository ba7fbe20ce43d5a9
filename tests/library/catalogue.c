/* What the library says of effects, keys and sources. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "library/key_unit_impl.h"
#include "library/umbra.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_session.h"

/* Every effect has what a doc string is made of; one is known whole. */
static void test_effects(void **state)
{
  (void)state;
  const struct umbra_effect *effect, *emittance = NULL;
  size_t n = 0, on = 0;
  for (; (effect = umbra_effect_at(umbra, n)) != NULL; n++) {
    assert_true(effect->name[0] != '\0' && effect->summary[0] != '\0' && effect->reference != NULL);
    assert_true(effect->targets != 0);
    on += effect->on_by_default != 0;
    for (size_t p = 0; p < effect->nparameter; p++) {
      const struct umbra_parameter *parameter = &effect->parameter[p];
      assert_true(parameter->minimum < parameter->maximum && parameter->help[0] != '\0');
      assert_true(parameter->default_value >= parameter->minimum &&
                  parameter->default_value <= parameter->maximum);
    }
    if (strcmp(effect->name, "emittance") == 0) emittance = effect;
  }
  assert_true(n > 60 && on > 5 && on < n);
  assert_non_null(emittance);
  assert_int_equal(emittance->targets, UMBRA_TARGET_MATERIAL);
  assert_int_equal(emittance->nparameter, 1);
  assert_string_equal(emittance->parameter->name, "factor");
  assert_string_equal(emittance->parameter->unit, "1");
  assert_close(emittance->parameter->null_value, 1.0, 0.0);
  assert_close(emittance->parameter->prior_sigma, 0.12, 0.0);
  assert_true(emittance->parameter->fitted);
  assert_null(umbra_effect_at(umbra, (size_t)-1));
}

/* By name, with the nearest one where there is none. */
static void test_find(void **state)
{
  (void)state;
  const struct umbra_effect *effect;
  assert_int_equal(umbra_effect_find(umbra, "albedo", &effect), UMBRA_OK);
  assert_string_equal(effect->name, "albedo");
  assert_int_equal(umbra_effect_find(umbra, "albeda", &effect), UMBRA_ERR_INPUT);
  assert_null(effect);
  assert_non_null(strstr(umbra_message(umbra), "did you mean 'albedo'?; accepted: albedo"));
}

static double last_irradiance(const struct umbra_effect_change *change)
{
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *result;
  assert_int_equal(
      umbra_scenario_read(umbra, UMBRA_SOURCE_DIR "/tests/app/data/box.yaml", NULL, &scenario),
      UMBRA_OK);
  if (change != NULL) assert_int_equal(umbra_scenario_effect(umbra, scenario, change), UMBRA_OK);
  assert_int_equal(umbra_model_build(umbra, scenario, &model), UMBRA_OK);
  assert_int_equal(umbra_run(umbra, model, &result), UMBRA_OK);
  const struct umbra_array *a = umbra_result_array(result, "irradiance");
  double value = a->data[(a->shape[0] - 1) * a->shape[1]];
  umbra_result_close(&result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  return value;
}

/* A scenario does not have code loaded by itself. */
static enum umbra_status build_with_file(void)
{
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  assert_int_equal(
      umbra_scenario_read(umbra, UMBRA_SOURCE_DIR "/tests/app/data/box.yaml", NULL, &scenario),
      UMBRA_OK);
  assert_int_equal(umbra_scenario_set(umbra, scenario, "effect_files", "[" PILEUP "]"), UMBRA_OK);
  enum umbra_status status = umbra_model_build(umbra, scenario, &model);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  return status;
}

/* E' = E (1 + q E), examples/effects/pileup.c. */
static void test_own_effect(void **state)
{
  (void)state;
  static const char *const name[] = {"q_m2_W"};
  static const double q[] = {-1e8};
  size_t n = 0;
  struct umbra_effect_change change = UMBRA_EFFECT_CHANGE;
  const struct umbra_effect *before = umbra_effect_at(umbra, 0);
  while (umbra_effect_at(umbra, n) != NULL) n++;
  change.effect = "pileup";
  change.target = "vis";
  change.parameter = name;
  change.value = q;
  change.nparameter = 1;
  double plain = last_irradiance(NULL);
  assert_int_equal(umbra_effects_load(umbra, "no-such.so"), UMBRA_ERR_IO);
  assert_null(umbra_effect_at(umbra, n));
  assert_int_equal(build_with_file(), UMBRA_ERR_INPUT);
  assert_int_equal(umbra_effects_load(umbra, PILEUP), UMBRA_OK);
  assert_int_equal(build_with_file(), UMBRA_OK);
  assert_string_equal(umbra_effect_at(umbra, n)->name, "pileup");
  assert_string_equal(umbra_effect_at(umbra, n)->parameter->name, "q_m2_W");
  assert_null(umbra_effect_at(umbra, n + 1));
  assert_string_equal(before->name, umbra_effect_at(umbra, 0)->name); /* what is borrowed stays */
  assert_close(last_irradiance(NULL), plain, 0.0);
  assert_close(last_irradiance(&change), plain * (1.0 + q[0] * plain), 1e-14 * plain);
  struct umbra *other; /* knows nothing of it */
  assert_int_equal(umbra_open(NULL, &other), UMBRA_OK);
  assert_null(umbra_effect_at(other, n));
  umbra_close(&other);
}

static bool holds(const char *const *name, size_t n, const char *wanted)
{
  bool found = false;
  for (size_t i = 0; i < n; i++) found = found || strcmp(name[i], wanted) == 0;
  return found;
}

static void test_data_names(void **state)
{
  (void)state;
  const char *const *material, *const *sensor, *const *again;
  size_t nmaterial, nsensor, n;
  assert_int_equal(umbra_data_names(umbra, UMBRA_MATERIALS, &material, &nmaterial), UMBRA_OK);
  assert_int_equal(umbra_data_names(umbra, UMBRA_SENSORS, &sensor, &nsensor), UMBRA_OK);
  assert_true(holds(material, nmaterial, "grey_white") && holds(material, nmaterial, "mli_kapton"));
  assert_true(holds(sensor, nsensor, "ufo") && !holds(sensor, nsensor, "grey_white"));
  assert_int_equal(umbra_data_names(umbra, UMBRA_MATERIALS, &again, &n), UMBRA_OK);
  assert_ptr_equal(again, material);
  assert_int_equal(n, nmaterial);
  assert_int_equal(umbra_data_names(umbra, UMBRA_PARTS, &again, &n), UMBRA_ERR_INPUT);
  assert_null(again);
  assert_int_equal(umbra_data_names(umbra, (enum umbra_names) - 1, &again, &n), UMBRA_ERR_INPUT);
  assert_int_equal(n, 0);
}

static const struct umbra_key *find(const char *path)
{
  for (size_t i = 0; umbra_key_at(umbra, i) != NULL; i++)
    if (strcmp(umbra_key_at(umbra, i)->path, path) == 0) return umbra_key_at(umbra, i);
  fail_msg("no key %s", path);
  return NULL;
}

static void test_keys(void **state)
{
  (void)state;
  size_t n = 0;
  for (const struct umbra_key *key; (key = umbra_key_at(umbra, n)) != NULL; n++) {
    if ((key->help == NULL && key->type < UMBRA_KEY_MAP) || key->accepted[0] == '\0')
      fail_msg("%s", key->path);
    if (key->type == UMBRA_KEY_CHOICE) assert_non_null(key->choice[0]);
    if (!isnan(key->minimum) && !isnan(key->maximum)) assert_true(key->minimum < key->maximum);
  }
  assert_true(n > 300);
  const struct umbra_key *step = find("time.step_s");
  assert_string_equal(step->unit, "s");
  assert_int_equal(step->type, UMBRA_KEY_NUMBER);
  assert_true(step->minimum >= 0.0 && step->maximum > 600.0);
  assert_int_equal(find("time")->required, 1);
  assert_int_equal(find("parts")->type, UMBRA_KEY_LIST);
  assert_int_equal(find("environment.shadow")->type, UMBRA_KEY_CHOICE);
  assert_null(find("environment.shadow")->unit);
  assert_string_equal(find("parts.shell.areal_heat_capacity_J_m2_K")->unit, "J/(m^2 K)");
}

static void test_units_of_keys(void **state)
{
  (void)state;
  static const struct {
    const char *key, *unit;
  } pairs[] = {{"power_W", "W"},
               {"areal_heat_capacity_J_m2_K", "J/(m^2 K)"},
               {"conductance_W_K", "W/K"},
               {"density_kg_m3", "kg/m^3"},
               {"inertia_kg_m2", "kg m^2"},
               {"acceleration_deg_s2", "deg/s^2"},
               {"layers_per_cm", "1/cm"},
               {"start_utc", "UTC"},
               {"sky_mag_arcsec2", "mag/arcsec^2"},
               {"dark_e_s", "e/s"},
               {"e", ""},
               {"front_share", ""},
               {"earth_orientation", ""}};
  char unit[UM_LIBRARY_UNIT];
  for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
    um_library_key_unit(pairs[i].key, unit);
    assert_string_equal(unit, pairs[i].unit);
  }
}

/* Braces in balance, each entry named once. */
static void check_bibtex(const char *text)
{
  int depth = 0, entries = 0;
  for (const char *c = text; *c != '\0'; c++) {
    depth += *c == '{' ? 1 : *c == '}' ? -1 : 0;
    assert_true(depth >= 0);
    if (*c != '@') continue;
    char name[128];
    const char *from = strchr(c, '{') + 1, *end = strchr(from, ',');
    snprintf(name, sizeof name, "{%.*s,", (int)(end - from), from);
    if (strstr(end, name) != NULL) fail_msg("%s twice", name);
    entries++;
  }
  assert_int_equal(depth, 0);
  assert_true(entries > 5);
}

/* The sphere on a circle has no two-line elements and no solid; turned around, they are cited. */
static void test_citation(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *result;
  const struct umbra_citation *citation, *again;
  struct umbra_effect_change change = UMBRA_EFFECT_CHANGE;
  change.effect = "emittance";
  change.target = "grey_sphere";
  assert_int_equal(
      umbra_scenario_read(umbra, UMBRA_SOURCE_DIR "/scenarios/sphere", NULL, &scenario), UMBRA_OK);
  assert_int_equal(umbra_scenario_set(umbra, scenario, "time.step_s", "600"), UMBRA_OK);
  assert_int_equal(umbra_scenario_effect(umbra, scenario, &change), UMBRA_OK);
  change = (struct umbra_effect_change)UMBRA_EFFECT_CHANGE;
  change.effect = "albedo";
  change.off = 1;
  assert_int_equal(umbra_scenario_effect(umbra, scenario, &change), UMBRA_OK);
  assert_int_equal(umbra_model_build(umbra, scenario, &model), UMBRA_OK);
  assert_int_equal(umbra_run(umbra, model, &result), UMBRA_OK);
  assert_int_equal(umbra_cite(umbra, result, &citation), UMBRA_OK);
  assert_non_null(strstr(citation->sentence, umbra_version()));
  assert_non_null(strstr(citation->sentence, "the scenario sphere"));
  assert_non_null(strstr(citation->sentence, "SUNDIALS (Hindmarsh et al. 2005)"));
  assert_null(strstr(citation->sentence, "SGP4"));
  assert_null(strstr(citation->sentence, "TetGen"));
  assert_non_null(strstr(citation->bibtex, "@software{umbra,"));
  assert_non_null(strstr(citation->bibtex, "@misc{umbra:material:grey_sphere,"));
  assert_non_null(strstr(citation->bibtex, "@misc{umbra:effect:emittance,"));
  assert_null(strstr(citation->bibtex, "vallado2006"));
  assert_null(strstr(citation->bibtex, "umbra:effect:albedo,"));
  check_bibtex(citation->bibtex);
  assert_int_equal(umbra_cite(umbra, result, &again), UMBRA_OK);
  assert_ptr_equal(again, citation);
  umbra_result_close(&result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

static void test_citation_of_elements(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *result;
  const struct umbra_citation *citation;
  assert_int_equal(
      umbra_scenario_read(umbra, UMBRA_SOURCE_DIR "/tests/app/data/box.yaml", NULL, &scenario),
      UMBRA_OK);
  assert_int_equal(umbra_model_build(umbra, scenario, &model), UMBRA_OK);
  assert_int_equal(umbra_run(umbra, model, &result), UMBRA_OK);
  assert_int_equal(umbra_cite(umbra, result, &citation), UMBRA_OK);
  assert_non_null(strstr(citation->sentence, "SGP4 (Vallado et al. 2006)"));
  assert_non_null(strstr(citation->sentence, "GeographicLib"));
  assert_non_null(strstr(citation->bibtex, "vallado2006"));
  check_bibtex(citation->bibtex);
  umbra_result_close(&result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_effects, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(test_find, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(test_own_effect, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(test_data_names, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(test_keys, session_set_up, session_tear_down),
      cmocka_unit_test(test_units_of_keys),
      cmocka_unit_test_setup_teardown(test_citation, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(test_citation_of_elements, session_set_up, session_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
