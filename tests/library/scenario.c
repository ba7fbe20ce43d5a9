/* Keys that are set by number: all bits arrive, in the scenario and in its text, and what is wrong
 * is refused in the words that a text would be. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "library/scenario_impl.h"
#include "model/scenario/scenario_read.h"
#include "tests/support/cmocka_all.h"

#define X "orbit.fixed.position_gcrs_km.0" /* takes every finite number */

static const char fixed[] =
    "schema: 1\nname: fixed\n"
    "time: {start_utc: 2016-09-06T18:07:00Z, stop_utc: 2016-09-06T18:11:00Z, step_s: 60}\n"
    "orbit: {fixed: {position_gcrs_km: [7000, 0, 0]}}\n"
    "attitude:\n  - lvlh: {}\n"
    "parts:\n  - {name: bus, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "bands:\n  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n";

static struct umbra *umbra;
static struct umbra_scenario *scenario;

static int enter(void **state)
{
  (void)state;
  if (umbra_open(NULL, &umbra) != UMBRA_OK) return -1;
  return umbra_scenario_read(umbra, NULL, fixed, &scenario) == UMBRA_OK ? 0 : -1;
}

static int leave(void **state)
{
  (void)state;
  umbra_scenario_close(&scenario);
  umbra_close(&umbra);
  return 0;
}

/* What a model is built from, and the text that results keep. */
static double read_back(char **text)
{
  const struct um_library_source *s = &scenario->source;
  struct um_document *document;
  const struct um_scenario *read;
  assert_int_equal(um_model_scenario_read(umbra->context, s->path, s->text, NULL, 0, s->set,
                                          s->nset, &document, &read),
                   UM_OK);
  double x = read->orbit->fixed->position_gcrs_km[0];
  if (text != NULL) assert_int_equal(um_document_text(umbra->context, document, text), UM_OK);
  um_document_destroy(&document);
  return x;
}

static void expect_bits(double value)
{
  char *text;
  assert_int_equal(umbra_scenario_set_number(umbra, scenario, X, value), UMBRA_OK);
  double got = read_back(&text);
  assert_memory_equal(&got, &value, sizeof value);
  umbra_scenario_close(&scenario);
  assert_int_equal(umbra_scenario_read(umbra, NULL, text, &scenario), UMBRA_OK);
  um_core_free(umbra->context, text);
  got = read_back(NULL);
  assert_memory_equal(&got, &value, sizeof value);
}

static void test_every_bit(void **state)
{
  (void)state;
  const double values[] = {0.0,
                           -0.0,
                           0.1,
                           1.0 / 3.0,
                           -2.0 / 3.0,
                           0.1 + 0.2,
                           DBL_MAX,
                           -DBL_MAX,
                           DBL_MIN,
                           DBL_TRUE_MIN,
                           -DBL_TRUE_MIN,
                           3.0 * DBL_TRUE_MIN,
                           nextafter(DBL_MIN, 0.0),
                           nextafter(1.0, 2.0),
                           nextafter(1.0, 0.0),
                           9007199254740993.0,
                           1e22,
                           1e23};
  uint64_t random = 88172645463325252U; /* xorshift64 */
  for (size_t i = 0; i < sizeof values / sizeof *values; i++) expect_bits(values[i]);
  for (int i = 0; i < 500; i++) {
    double value;
    random ^= random << 13;
    random ^= random >> 7;
    random ^= random << 17;
    memcpy(&value, &random, sizeof value);
    if (isfinite(value)) expect_bits(value);
  }
}

static const struct umbra_value *get(const char *key)
{
  const struct umbra_value *value;
  assert_int_equal(umbra_scenario_get(umbra, scenario, key, &value), UMBRA_OK);
  return value;
}

/* What a key says is what was set last, bit by bit; what is not stated is not made up. */
static void test_get(void **state)
{
  (void)state;
  const struct umbra_value *value;
  const double odd = nextafter(7000.0, 8000.0);
  assert_int_equal(umbra_scenario_set_number(umbra, scenario, X, odd), UMBRA_OK);
  assert_int_equal(get(X)->kind, UMBRA_VALUE_NUMBER);
  assert_memory_equal(&get(X)->number, &odd, sizeof odd);
  assert_int_equal(umbra_scenario_set(umbra, scenario, X, "7000"), UMBRA_OK);
  assert_close(get(X)->number, 7000.0, 0.0);
  assert_string_equal(get(X)->text, "7000");
  assert_int_equal(get("parts.bus.lumped")->kind, UMBRA_VALUE_FLAG);
  assert_close(get("parts.bus.lumped")->number, 1.0, 0.0);
  assert_int_equal(get("parts.0.name")->kind, UMBRA_VALUE_TEXT);
  assert_string_equal(get("parts.0.name")->text, "bus");
  value = get("parts.bus.box.size_m");
  assert_int_equal(value->kind, UMBRA_VALUE_LIST);
  assert_int_equal(value->count, 3);
  value = get("bands.vis");
  assert_int_equal(value->kind, UMBRA_VALUE_GROUP);
  assert_int_equal(value->nname, 3);
  assert_string_equal(value->name[2], "bins");
  static const char *const none[] = {"environment.albedo", "time.stap_s", "parts.7",
                                     "time..step_s"};
  for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
    assert_int_equal(umbra_scenario_get(umbra, scenario, none[i], &value), UMBRA_ERR_INPUT);
    assert_null(value);
    assert_true(umbra_message(umbra)[0] != '\0');
  }
}

/* A number by number is refused, or taken, as the same number by text. */
static void test_refused_as_text(void **state)
{
  (void)state;
  static const struct {
    const char *key;
    double number;
    const char *text;
  } cases[] = {{"time.step", 3.0, "3"},
               {"time.step_m", 3.0, "3"},
               {"time.step_s", -1.0, "-1"},
               {"time.step_s", 0.1 + 0.2 - 1.0, "-0.7"},
               {"time.start_utc", 5e8, "500000000"},
               {"environment.albedo", 2.0, "2"},
               {"environment.shadow", 1.0, "1"},
               {"optics.samples", 2.5, "2.5"},
               {"optics.samples", 70000.0, "70000"},
               {"parts.bus.lumped", 1.0, "1"},
               {"parts.box.lumped", 1.0, "1"},
               {"orbit.fixed", 1.0, "1"},
               {"name.part", 1.0, "1"},
               {"time..step_s", 1.0, "1"},
               {"", 1.0, "1"},
               {"a=b", 1.0, "1"}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    enum umbra_status status = umbra_scenario_set(umbra, scenario, cases[i].key, cases[i].text);
    char said[1024];
    snprintf(said, sizeof said, "%s", umbra_message(umbra));
    if (status != UMBRA_ERR_INPUT || said[0] == '\0') fail_msg("%s is taken", cases[i].key);
    assert_int_equal(umbra_scenario_set_number(umbra, scenario, cases[i].key, cases[i].number),
                     UMBRA_ERR_INPUT);
    assert_string_equal(umbra_message(umbra), said);
  }
  assert_int_equal(umbra_scenario_set_number(umbra, scenario, X, (double)INFINITY),
                   UMBRA_ERR_INPUT);
  assert_string_equal(umbra_message(umbra), X ": inf; accepted: a finite number");
  assert_close(read_back(NULL), 7000.0, 0.0); /* none of them stayed */
  assert_int_equal(umbra_scenario_set_number(umbra, scenario, "name", 5.0), UMBRA_OK);
}

/* Later changes go before earlier ones, whether by number or by text. */
static void test_order(void **state)
{
  (void)state;
  assert_int_equal(umbra_scenario_set_number(umbra, scenario, X, 8000.0), UMBRA_OK);
  assert_int_equal(
      umbra_scenario_set(umbra, scenario, "orbit.fixed", "{position_gcrs_km: [9, 8, 7]}"),
      UMBRA_OK);
  assert_close(read_back(NULL), 9.0, 0.0);
  assert_int_equal(umbra_scenario_set(umbra, scenario, X, "10"), UMBRA_OK);
  assert_int_equal(umbra_scenario_set_number(umbra, scenario, X, 11.0), UMBRA_OK);
  assert_close(read_back(NULL), 11.0, 0.0);
}

static void put(struct umbra_change *change, const char *key, const char *text)
{
  *change = (struct umbra_change)UMBRA_CHANGE;
  change->key = key;
  change->text = text;
}

/* A window that moves beyond its end: neither of its edges may be set before the other. */
static void test_together(void **state)
{
  (void)state;
  const char *start = "2016-09-07T18:07:00Z", *stop = "2016-09-07T18:11:00Z";
  struct umbra_effect_change albedo = UMBRA_EFFECT_CHANGE;
  struct umbra_change change[3];
  albedo.effect = "albedo";
  albedo.off = 1;
  put(&change[0], "time.start_utc", start);
  put(&change[1], "time.stop_utc", stop);
  change[2] = (struct umbra_change)UMBRA_CHANGE;
  change[2].effect = &albedo;
  assert_int_equal(umbra_scenario_set(umbra, scenario, "time.start_utc", start), UMBRA_ERR_INPUT);
  assert_int_equal(umbra_scenario_change(umbra, scenario, change, 3), UMBRA_OK);
  assert_int_equal(scenario->source.nset, 2);
  assert_int_equal(scenario->source.nchange, 1);
  assert_close(read_back(NULL), 7000.0, 0.0);
  put(&change[1], "time.stop_utc", "2016-09-05T18:11:00Z");
  assert_int_equal(umbra_scenario_change(umbra, scenario, change, 3), UMBRA_ERR_INPUT);
  assert_non_null(strstr(umbra_message(umbra), "stop_utc"));
  put(&change[1], "time.stop_utc", stop);
  albedo.effect = "albeda";
  assert_int_equal(umbra_scenario_change(umbra, scenario, change, 3), UMBRA_ERR_INPUT);
  change[2].key = "name";
  assert_int_equal(umbra_scenario_change(umbra, scenario, change, 3), UMBRA_ERR_INPUT);
  assert_string_equal(umbra_message(umbra), "change 3; accepted: a key or an effect");
  assert_int_equal(umbra_scenario_set(umbra, scenario, "name", NULL), UMBRA_ERR_INPUT);
  assert_int_equal(scenario->source.nset, 2); /* none of them stayed */
  assert_int_equal(scenario->source.nchange, 1);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_every_bit, enter, leave),
      cmocka_unit_test_setup_teardown(test_get, enter, leave),
      cmocka_unit_test_setup_teardown(test_refused_as_text, enter, leave),
      cmocka_unit_test_setup_teardown(test_order, enter, leave),
      cmocka_unit_test_setup_teardown(test_together, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
