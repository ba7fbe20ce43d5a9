/* The registry: every descriptor is complete, and a core switch changes its own field alone. */
#include <stdio.h>
#include <string.h>

#include "effects/effects.h"
#include "effects/half.h"
#include "environment/environment.h"
#include "tests/support/cmocka_all.h"

static void descriptors_are_complete(void **state)
{
  (void)state;
  assert_true(um_effects_count() >= 6);
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *e = um_effects_at(i);
    assert_int_equal(um_effects_check(NULL, e), UM_OK);
    assert_true(e->separated_by != NULL && strchr(e->separated_by, ':') != NULL);
    for (size_t p = 0; p < e->nparameter; p++)
      assert_true(e->parameters[p].prior != NULL && strlen(e->parameters[p].prior) > 0);
    assert_ptr_equal(um_effects_find(e->name), e);
    for (size_t k = 0; k < i; k++) assert_string_not_equal(e->name, um_effects_at(k)->name);
  }
  assert_null(um_effects_find("no_such_effect"));
}

/* One of each hook, and those of which hooks do not say it. */
static void halves_are_said(void **state)
{
  (void)state;
  static const struct {
    const char *effect;
    enum um_effects_half half;
  } known[] = {{"internal_power", UM_HALF_HEAT},
               {"mli_emittance", UM_HALF_HEAT},
               {"contact_conductance", UM_HALF_HEAT},
               {"free_molecular_heating", UM_HALF_HEAT},
               {"solar_absorptance", UM_HALF_SURFACE},
               {"roughness", UM_HALF_SURFACE},
               {"inter_reflection", UM_HALF_SURFACE},
               {"area", UM_HALF_GEOMETRY},
               {"attitude_offset", UM_HALF_GEOMETRY},
               {"nutation", UM_HALF_GEOMETRY},
               {"along_track", UM_HALF_GEOMETRY},
               {"panel_flatness", UM_HALF_GEOMETRY},
               {"albedo", UM_HALF_EARTH},
               {"shadow_radius", UM_HALF_EARTH},
               {"moonlight", UM_HALF_EARTH},
               {"solar_irradiance", UM_HALF_EARTH},
               {"aerosol", UM_HALF_AIR},
               {"extinction", UM_HALF_AIR},
               {"twilight", UM_HALF_AIR},
               {"atmosphere", UM_HALF_AIR},
               {"zero_point", UM_HALF_INSTRUMENT},
               {"time_tag", UM_HALF_INSTRUMENT},
               {"exposure", UM_HALF_INSTRUMENT},
               {"saturation", UM_HALF_INSTRUMENT}};
  size_t count[UM_HALVES] = {0};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const struct um_effect *e = um_effects_find(known[i].effect);
    if (e != NULL && um_effects_half_of(e) != known[i].half)
      fail_msg("%s is called %s", e->name, um_effects_half_name(um_effects_half_of(e)));
  }
  for (size_t i = 0; i < um_effects_count(); i++) count[um_effects_half_of(um_effects_at(i))]++;
  for (size_t h = 0; h < UM_HALVES; h++) assert_true(count[h] > 0);
}

static bool ends_with(const char *name, const char *end)
{
  size_t n = strlen(name), m = strlen(end);
  return n >= m && strcmp(name + n - m, end) == 0;
}

/* The rule of effects/effect.h, where descriptors show of which kind a parameter is. */
static void the_same_kind_has_the_same_name(void **state)
{
  (void)state;
  size_t factors = 0, shifts = 0;
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *e = um_effects_at(i);
    for (size_t k = 0; k < e->nparameter; k++) {
      const struct um_effect_parameter *p = &e->parameters[k];
      bool plain = strcmp(p->unit, "1") == 0, factor = strcmp(p->name, "factor") == 0;
      if (plain && p->null_value == 1.0 && p->change == UM_CHANGE_SCALES && !factor)
        fail_msg("%s: %s; a factor is called 'factor'", e->name, p->name);
      if (plain && ends_with(p->name, "_factor"))
        fail_msg("%s: %s; a factor is called 'factor'", e->name, p->name);
      if (factor && !plain) fail_msg("%s: a factor in %s", e->name, p->unit);
      /* one quantity would be said twice, by the effect and by the parameter */
      if (strstr(p->name, "_shift_") != NULL || strstr(p->name, "delta") != NULL ||
          strstr(p->name, "bias") != NULL || strstr(p->name, "offset") != NULL)
        fail_msg("%s: %s; a difference is called 'shift_UNIT'", e->name, p->name);
      if (strcmp(p->name, "shift") == 0 && !plain)
        fail_msg("%s: shift without its unit %s", e->name, p->unit);
      if (strncmp(p->name, "shift_", 6) == 0 && strcmp(p->name + 6, p->unit) != 0)
        fail_msg("%s: %s in %s", e->name, p->name, p->unit);
      factors += factor;
      shifts += strncmp(p->name, "shift", 5) == 0;
    }
  }
  assert_true(factors > 0 && shifts > 0);
}

/* Both names lead to one parameter; the former one is warned of once a use. */
static void former_names(void **state)
{
  (void)state;
  struct um_context *context;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  size_t n = 0;
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *e = um_effects_at(i);
    assert_int_equal(um_effects_parameter_find(e, "no_such_parameter"), e->nparameter);
    for (size_t k = 0; k < e->nparameter; k++) {
      const struct um_effect_parameter *p = &e->parameters[k];
      const char *const name[] = {p->name, p->formerly};
      for (size_t j = 0; j < 2 && name[j] != NULL; j++) {
        struct um_effects_said said = {{NULL}};
        size_t which;
        um_core_log_clear(context);
        assert_int_equal(um_effects_parameter_find(e, name[j]), k);
        assert_int_equal(um_effects_parameter_read(context, e, name[j], &said, &which), UM_OK);
        assert_int_equal(which, k);
        assert_int_equal(strstr(um_core_log_text(context), " is now called ") != NULL, j == 1);
        um_core_log_clear(context);
        assert_int_equal(um_effects_parameter_read(context, e, name[j], &said, &which), UM_OK);
        assert_string_equal(um_core_log_text(context), "");
        if (p->formerly == NULL) continue;
        assert_int_equal(um_effects_parameter_read(context, e, name[1 - j], &said, &which),
                         UM_ERR_INPUT);
        assert_non_null(strstr(um_core_message(context), "are one parameter; accepted: "));
        um_core_message_clear(context);
        n++;
      }
    }
  }
  assert_true(n > 0);
  um_core_context_destroy(&context);
}

/* A former name that something else has is refused. */
static void former_names_are_free(void **state)
{
  (void)state;
  struct um_context *context;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  const struct um_effect *base = um_effects_find("background");
  static const struct {
    const char *name[2], *formerly[2], *words;
  } cases[] = {
      {{"a", "b"}, {"c", "d"}, NULL},
      {{"a", "b"}, {"a", NULL}, "parameter 1 was called 'a'"},
      {{"a", "b"}, {NULL, "a"}, "parameter 2 was called 'a'"},
      {{"a", "b"}, {"b", NULL}, "parameter 2 is called 'b'"},
      {{"a", "b"}, {"c", "c"}, "parameter 2 was called 'c'"},
      {{"a", "b"}, {"target", NULL}, "parameter 1 was called 'target'"},
      {{"a", "b"}, {"no word", NULL}, "parameter 1 was called 'no word'"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct um_effect_parameter two[2] = {base->parameters[0], base->parameters[0]};
    struct um_effect effect = *base;
    for (size_t k = 0; k < 2; k++) {
      two[k].name = cases[i].name[k];
      two[k].formerly = cases[i].formerly[k];
    }
    effect.parameters = two;
    effect.nparameter = 2;
    um_core_message_clear(context);
    enum um_status expected = cases[i].words == NULL ? UM_OK : UM_ERR_INPUT;
    assert_int_equal(um_effects_check(context, &effect), expected);
    if (cases[i].words != NULL && strstr(um_core_message(context), cases[i].words) == NULL)
      fail_msg("case %zu said: %s", i, um_core_message(context));
  }
  um_core_context_destroy(&context);
}

static void names_are_cut_to_size(void **state)
{
  (void)state;
  char names[4096], few[8];
  um_effects_registry_names(NULL, names, sizeof names);
  for (size_t i = 0; i < um_effects_count(); i++)
    assert_non_null(strstr(names, um_effects_at(i)->name));
  um_effects_registry_names(NULL, few, sizeof few);
  assert_true(strlen(few) < sizeof few);
}

/* What each switch is to change, and nothing else. */
static void check_switch(const char *name, void (*change)(struct um_environment *))
{
  struct um_environment expected, got;
  memset(&expected, 0, sizeof expected);
  memset(&got, 0, sizeof got);
  um_environment_defaults(&expected);
  um_environment_defaults(&got);
  change(&expected);
  const struct um_effect *e = um_effects_find(name);
  assert_non_null(e);
  assert_non_null(e->switch_off);
  assert_int_equal(e->switch_off(NULL, &got), UM_OK);
  assert_memory_equal(&got, &expected, sizeof got);
}

static void no_albedo(struct um_environment *e) { e->albedo_on = false; }
static void no_earth_ir(struct um_environment *e) { e->planet_on = false; }
static void no_earthshine(struct um_environment *e) { e->earthshine_on = false; }
static void no_reflection(struct um_environment *e) { e->earth_reflection_on = false; }
static void no_penumbra(struct um_environment *e) { e->disc = UM_DISC_POINT; }
static void no_oblateness(struct um_environment *e) { e->shadow = UM_SHADOW_SPHERE; }

static void no_refraction(struct um_environment *e) { e->shadow_refraction_on = false; }
static void no_lobe(struct um_environment *e) { e->earthlight_lobe_on = false; }
static void no_mutual(struct um_environment *e) { e->mutual_radiation_on = false; }
static void no_solar_reflection(struct um_environment *e) { e->solar_reflection_on = false; }
static void no_mirrors(struct um_environment *e) { e->specular_exchange_on = false; }
static void no_passing_on(struct um_environment *e) { e->multiple_scattering_on = false; }
static void no_scatter(struct um_environment *e) { e->umbra_scatter_on = false; }
static void no_moon(struct um_environment *e) { e->moonlight_on = false; }
static void no_light_between(struct um_environment *e) { e->inter_reflection_on = false; }

static void switches_change_one_field(void **state)
{
  (void)state;
  check_switch("albedo", no_albedo);
  check_switch("earth_ir", no_earth_ir);
  check_switch("earthshine", no_earthshine);
  check_switch("reflected_earth_ir", no_reflection);
  check_switch("penumbra", no_penumbra);
  check_switch("oblateness", no_oblateness);
  check_switch("shadow_refraction", no_refraction);
  check_switch("earthlight_lobe", no_lobe);
  check_switch("mutual_radiation", no_mutual);
  check_switch("solar_multiple_reflection", no_solar_reflection);
  check_switch("specular_exchange", no_mirrors);
  check_switch("multiple_scattering", no_passing_on);
  check_switch("inter_reflection", no_light_between);
  check_switch("umbra_scatter", no_scatter);
  check_switch("moonlight", no_moon);
}

/* Without an ellipsoid there is nothing to make round. */
static void oblateness_leaves_other_shadows(void **state)
{
  (void)state;
  const struct um_effect *e = um_effects_find("oblateness");
  const enum um_environment_shadow other[] = {UM_SHADOW_NONE, UM_SHADOW_CYLINDER, UM_SHADOW_SPHERE};
  for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
    struct um_environment environment;
    um_environment_defaults(&environment);
    environment.shadow = other[i];
    assert_int_equal(e->switch_off(NULL, &environment), UM_OK);
    assert_int_equal(environment.shadow, other[i]);
  }
}

/* What a scenario's key holds off is turned on; what is on stays as it is, to the byte. */
static void switches_turn_on(void **state)
{
  (void)state;
  const struct um_effect *oblateness = um_effects_find("oblateness");
  const struct um_effect *penumbra = um_effects_find("penumbra");
  const enum um_environment_shadow shadow[] = {UM_SHADOW_NONE, UM_SHADOW_CYLINDER, UM_SHADOW_SPHERE,
                                               UM_SHADOW_OBLATE};
  const enum um_environment_disc disc[] = {UM_DISC_POINT, UM_DISC_UNIFORM, UM_DISC_LIMB_DARKENED};
  for (size_t i = 0; i < 4; i++)
    for (size_t k = 0; k < 3; k++) {
      struct um_environment e, expected;
      memset(&e, 0, sizeof e);
      um_environment_defaults(&e);
      e.shadow = shadow[i];
      e.disc = disc[k];
      expected = e;
      bool round = shadow[i] == UM_SHADOW_CYLINDER || shadow[i] == UM_SHADOW_SPHERE;
      assert_int_equal(oblateness->is_off(&e), round);
      assert_int_equal(penumbra->is_off(&e), disc[k] == UM_DISC_POINT);
      if (round) expected.shadow = UM_SHADOW_OBLATE;
      if (disc[k] == UM_DISC_POINT) expected.disc = UM_DISC_LIMB_DARKENED;
      assert_int_equal(oblateness->switch_on(NULL, &e), UM_OK);
      assert_int_equal(penumbra->switch_on(NULL, &e), UM_OK);
      assert_memory_equal(&e, &expected, sizeof e);
    }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(halves_are_said),
      cmocka_unit_test(descriptors_are_complete),
      cmocka_unit_test(the_same_kind_has_the_same_name),
      cmocka_unit_test(former_names),
      cmocka_unit_test(former_names_are_free),
      cmocka_unit_test(names_are_cut_to_size),
      cmocka_unit_test(switches_change_one_field),
      cmocka_unit_test(oblateness_leaves_other_shadows),
      cmocka_unit_test(switches_turn_on),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
