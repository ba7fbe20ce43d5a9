/* The air at the edge of the shadow: each parameter changes its own amount and no other, and where
 * no air is at the edge the effect has nothing to do. */
#include <math.h>

#include "effects/effects.h"
#include "tests/support/near.h"

static const struct um_effect *effect(void)
{
  const struct um_effect *found = um_effects_find("shadow_air");
  assert_non_null(found);
  return found;
}

static struct um_environment with(const double value[4])
{
  struct um_environment e;
  struct um_effect_use use = {effect(), NULL, value, 0.0};
  um_environment_defaults(&e);
  assert_int_equal(effect()->hooks.environment(NULL, &use, &e), UM_OK);
  return e;
}

static size_t index_of(const char *name)
{
  size_t i = 0;
  while (strcmp(effect()->parameters[i].name, name) != 0) i++;
  return i;
}

static void each_changes_its_own(void **state)
{
  static const char *const names[] = {"ozone_percent", "aerosol_depth", "haze_depth",
                                      "cloud_top_km"};
  struct um_environment before;
  (void)state;
  um_environment_defaults(&before);
  for (size_t i = 0; i < 4; i++) {
    double value[4] = {0.0, 0.0, 0.0, 0.0};
    value[index_of(names[i])] = 1.5;
    struct um_environment e = with(value);
    check_near("ozone", e.ozone_factor, i == 0 ? 1.015 : 1.0, 1e-15);
    check_near("aerosol", e.aerosol - before.aerosol, i == 1 ? 1.5 : 0.0, 1e-15);
    check_near("haze", e.haze - before.haze, i == 2 ? 1.5 : 0.0, 1e-15);
    check_near("clouds [m]", e.cloud_shift, i == 3 ? 1500.0 : 0.0, 1e-12);
    assert_true(e.air_factor == before.air_factor);
  }
}

/* What is said to change is the whole, where it is one number: no height that goes by latitude. */
static void says_the_whole(void **state)
{
  struct um_environment e;
  struct um_effect_nominal nominal = {.environment = &e};
  struct um_effect_stated haze = {0}, clouds = {0};
  (void)state;
  um_environment_defaults(&e);
  effect()->parameters[3].stated(&nominal, &clouds);
  assert_true(isnan(clouds.value));
  e.haze = 0.25;
  e.cloud_top = 9e3;
  e.cloud_shift = -2e3;
  effect()->parameters[2].stated(&nominal, &haze);
  effect()->parameters[3].stated(&nominal, &clouds);
  check_near("haze", haze.value, 0.25, 1e-15);
  check_near("clouds [km]", clouds.value, 7.0, 1e-12);
}

/* No depth is below nothing. */
static void refuses_less_than_none(void **state)
{
  struct um_context *context;
  struct um_environment e;
  const double value[4] = {0.0, -0.02, 0.0, 0.0};
  struct um_effect_use use = {effect(), NULL, value, 0.0};
  (void)state;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  um_environment_defaults(&e);
  assert_int_equal(effect()->hooks.environment(context, &use, &e), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "aerosol_depth -0.02"));
  um_core_context_destroy(&context);
}

static void has_nothing_to_do_without_air(void **state)
{
  struct um_environment e;
  struct um_effect_nominal nominal = {.environment = &e};
  (void)state;
  um_environment_defaults(&e);
  assert_null(effect()->refusal(&nominal));
  e.shadow_refraction_on = false;
  assert_non_null(effect()->refusal(&nominal));
  um_environment_defaults(&e);
  e.disc = UM_DISC_POINT;
  assert_non_null(effect()->refusal(&nominal));
  um_environment_defaults(&e);
  e.shadow = UM_SHADOW_CYLINDER;
  assert_non_null(effect()->refusal(&nominal));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(each_changes_its_own),
      cmocka_unit_test(says_the_whole),
      cmocka_unit_test(refuses_less_than_none),
      cmocka_unit_test(has_nothing_to_do_without_air),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
