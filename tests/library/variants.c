/* Variants by the library, one and many. */
#include <math.h>

#include "tests/library/session_test.h"

static double last(const struct umbra_result *result, const char *name)
{
  const struct umbra_array *a = umbra_result_array(result, name);
  assert_non_null(a);
  return a->data[a->shape[0] * a->shape[1] - 1];
}

static struct umbra_result *variant(struct umbra_variants *variants,
                                    const struct umbra_change *change, size_t n)
{
  struct umbra_result *result;
  ok(umbra_variant_run(umbra, variants, change, n, &result));
  return result;
}

/* A variant has the bits of a scenario with its changes where that is asked for, and is near
 * otherwise; the name that a parameter had before means the same; the model stays; objects are
 * closed in any order. */
static void test_variants(void **state)
{
  (void)state;
  static const char *const name[] = {"factor"}, *const former[] = {"emittance_factor"};
  static const double value[] = {0.7};
  struct umbra_effect_change emittance = UMBRA_EFFECT_CHANGE;
  struct umbra_variants_settings exact = UMBRA_VARIANTS_SETTINGS;
  struct umbra_change change[2] = {UMBRA_CHANGE, UMBRA_CHANGE};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *cold, *warm;
  emittance.effect = "emittance";
  emittance.target = "grey_white";
  emittance.parameter = former;
  emittance.value = value;
  emittance.nparameter = 1;
  change[0].effect = &emittance;
  change[1].key = "environment.albedo";
  change[1].number = 0.2;
  exact.exact = 1;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_variants_open(umbra, model, &exact, &cold));
  ok(umbra_variants_open(umbra, model, NULL, &warm));
  struct umbra_result *nominal = variant(cold, NULL, 0), *a = variant(cold, change, 2),
                      *b = variant(warm, change, 2), *again = variant(cold, NULL, 0);
  umbra_variants_close(&cold);
  umbra_variants_close(&warm);
  ok(umbra_scenario_set_number(umbra, scenario, change[1].key, change[1].number));
  emittance.parameter = name;
  ok(umbra_scenario_effect(umbra, scenario, &emittance));
  struct umbra_result *own = session_run(scenario);
  const char *const of[] = {"intensity", "temperature"};
  for (size_t i = 0; i < 2; i++) {
    assert_true(last(a, of[i]) == last(own, of[i]));
    assert_true(last(nominal, of[i]) == last(again, of[i]));
    assert_true(last(nominal, of[i]) != last(own, of[i]));
  }
  assert_close(last(b, "temperature"), last(own, "temperature"), 0.1);
  refused(umbra_result_write(umbra, a, "variant", NULL), UMBRA_ERR_INPUT,
          "a variant is not written");
  umbra_model_close(&model);
  umbra_result_close(&nominal);
  umbra_result_close(&a);
  umbra_result_close(&b);
  umbra_result_close(&again);
  umbra_result_close(&own);
  umbra_scenario_close(&scenario);
}

static void test_variants_refused(void **state)
{
  (void)state;
  struct umbra_variants_settings settings = UMBRA_VARIANTS_SETTINGS;
  struct umbra_change change = UMBRA_CHANGE;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *variants;
  struct umbra_result *result;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  settings.temperature_K = -1.0;
  refused(umbra_variants_open(umbra, model, &settings, &variants), UMBRA_ERR_INPUT, "0 to 10 K");
  ok(umbra_variants_open(umbra, model, NULL, &variants));
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT,
          "a key or an effect");
  change.key = "parts.bus.no_such_key";
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT, "no_such_key");
  assert_null(result);
  change.key = "environment.albedo";
  change.number = 2.0;
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT, "out of range");
  change.key = "time.start_utc"; /* no clock that counts seconds is meant */
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT, "a UTC time");
  umbra_variants_close(&variants);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

/* A set of one key. */
static void put(struct umbra_change *change, struct umbra_changes *set, const char *key, double to)
{
  *change = (struct umbra_change)UMBRA_CHANGE;
  change->key = key;
  change->number = to;
  *set = (struct umbra_changes){change, 1};
}

/* Numbers of a set are those of the same variant alone, for any number of processes, and NaN where
 * the model refuses it. */
static void expect_sets(const struct umbra_result *many, struct umbra_variants *variants,
                        const struct umbra_changes *set, size_t nset)
{
  for (size_t a = 0; a < 2; a++) {
    const struct umbra_array *all = umbra_result_array_at(many, a);
    assert_int_equal(all->shape[0], nset);
    assert_string_equal(all->axis[0], "set");
    for (size_t i = 0; i < nset; i++) {
      struct umbra_result *one = NULL;
      enum umbra_status status =
          umbra_variant_run(umbra, variants, set[i].change, set[i].nchange, &one);
      size_t n = all->shape[1] * all->shape[2];
      if (status == UMBRA_OK) {
        const struct umbra_array *alone = umbra_result_array(one, all->name);
        assert_null(umbra_result_refusal(many, i));
        assert_int_equal(alone->dimensions + 1, all->dimensions);
        assert_memory_equal(alone->data, all->data + i * n, n * sizeof *all->data);
      } else {
        assert_string_equal(umbra_result_refusal(many, i), umbra_message(umbra));
        assert_true(isnan(all->data[i * n]));
      }
      umbra_result_close(&one);
    }
  }
}

static void test_many(void **state)
{
  (void)state;
  static const char *const wanted[] = {"intensity", "temperature"};
  struct umbra_variants_settings exact = UMBRA_VARIANTS_SETTINGS;
  struct umbra_many how = UMBRA_MANY;
  struct umbra_change change[6];
  struct umbra_changes set[6];
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *variants;
  struct umbra_result *result;
  put(&change[0], &set[0], "environment.albedo", 2.0); /* out of range */
  put(&change[1], &set[1], "environment.albedo", 0.2);
  put(&change[2], &set[2], "parts.box.no_such_key", 1.0);
  put(&change[3], &set[3], "environment.olr_W_m2", 200.0);
  put(&change[4], &set[4], "time.step_s", 5.0); /* has more rows */
  put(&change[5], &set[5], "environment.albedo", 0.4);
  how.array = wanted;
  how.narray = 2;
  exact.exact = 1;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  for (int i = 0; i < 2; i++) {
    ok(umbra_variants_open(umbra, model, i == 0 ? &exact : NULL, &variants));
    for (how.workers = 1; how.workers < 4; how.workers += 2) {
      ok(umbra_evaluate_many(umbra, variants, set, 4, &how, &result));
      expect_sets(result, variants, set, 4);
      umbra_result_close(&result);
    }
    ok(umbra_evaluate_many(umbra, variants, set + 3, 3, &how, &result));
    assert_non_null(strstr(umbra_result_refusal(result, 1), "not as large"));
    assert_null(umbra_result_refusal(result, 2));
    umbra_variants_close(&variants); /* the result keeps it */
    refused(umbra_result_write(umbra, result, "many", NULL), UMBRA_ERR_INPUT, "are not written");
    umbra_result_close(&result);
  }
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

static void test_many_refused(void **state)
{
  (void)state;
  static const char *const wanted[] = {"intensity_parts", "brightness"};
  struct umbra_effect_change effect = UMBRA_EFFECT_CHANGE;
  struct umbra_many how = UMBRA_MANY;
  struct umbra_change change[2];
  struct umbra_changes set[2];
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *variants;
  struct umbra_result *result;
  put(&change[0], &set[0], "environment.albedo", 2.0);
  put(&change[1], &set[1], "environment.albedo", 0.2);
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_variants_open(umbra, model, NULL, &variants));
  refused(umbra_evaluate_many(umbra, variants, set, 0, NULL, &result), UMBRA_ERR_INPUT, "no set");
  refused(umbra_evaluate_many(umbra, variants, set, 1, NULL, &result), UMBRA_ERR_INPUT,
          "out of range");
  assert_null(result);
  how.narray = 1;
  for (size_t i = 0; i < 2; i++) {
    how.array = &wanted[i];
    refused(umbra_evaluate_many(umbra, variants, set, 2, &how, &result), UMBRA_ERR_INPUT,
            wanted[i]);
  }
  ok(umbra_evaluate_many(umbra, variants, set, 2, NULL, &result));
  assert_string_equal(umbra_result_array_at(result, 0)->name, "irradiance");
  assert_null(umbra_result_array_at(result, 1));
  umbra_result_close(&result);
  effect.effect = "no_such_effect";
  change[1] = (struct umbra_change)UMBRA_CHANGE;
  change[1].effect = &effect;
  refused(umbra_evaluate_many(umbra, variants, set, 2, NULL, &result), UMBRA_ERR_INPUT, "set 2: ");
  umbra_variants_close(&variants);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_variants, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_variants_refused, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_many, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_many_refused, session_enter, session_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
