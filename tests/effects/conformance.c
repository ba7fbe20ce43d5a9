/* What every entry of the list of effects is held to. A new effect needs one line in `cases` below
 * and one in the laboratory (tests/lab/cases.c); without them the suite fails by its name.
 *
 *   null      at its null values, or as a switch that is on, it changes no bit
 *   slope     away from them some observation changes
 *   two ways  where the null value lies inside the bounds, steps to both sides change the
 *             observations in opposite directions; where it lies on a bound, the case says why
 *   reach     what is kept of other evaluations (effects/reach.c) gives the bits of a fresh run
 *   targets   a target of a kind it does not act on, or none where it needs one, is refused
 *   manual    it has its page in docs/effects.md
 *   laboratory  it is hidden in a world */
#include "effects/effects.h"

#include "tests/evidence/sensitivity/satellite_test.h"
#include "tests/lab/lab.h"

#define ROWS 60 /* of the measurements, in use */

struct entry {
  const char *effect, *target; /* NULL: global */
  double step;                 /* of the first parameter, from its null value; of a logarithm */
  const char *wrong;           /* a target that is there and not its kind; "": it needs one */
  const char *one_way;         /* why the null value is a bound; NULL: it is not */
};

/* A part has a name that is no material and no band; "bus" is a part, "vis" a band, "grey_panel" a
 * material of the world below. */
static const struct entry cases[] = {
    {"albedo", NULL, 0.0, "bus", "a switch"},
    {"earth_ir", NULL, 0.0, "bus", "a switch"},
    {"earthshine", NULL, 0.0, "bus", "a switch"},
    {"reflected_earth_ir", NULL, 0.0, "bus", "a switch"},
    {"earthlight_lobe", NULL, 0.0, "bus", "a switch"},
    {"penumbra", NULL, 0.0, "bus", "a switch"},
    {"oblateness", NULL, 0.0, "bus", "a switch"},
    {"shadow_refraction", NULL, 0.0, "bus", "a switch"},
    {"umbra_scatter", NULL, 0.0, "bus", "a switch"},
    {"atmosphere", NULL, 0.0, "bus", "a switch"},
    {"earth_map", NULL, 0.0, "bus", "a switch"},
    {"earth_spectrum", NULL, 0.0, "bus", "a switch"},
    {"earth_anisotropy", NULL, 0.0, "bus", "a switch"},
    {"absorptance_angle", NULL, 0.0, "bus", "a switch"},
    {"emittance_temperature", NULL, 0.0, "bus", "a switch"},
    {"bulk_temperature", NULL, 0.0, "bus", "a switch"},
    {"mutual_radiation", NULL, 0.0, "bus", "a switch"},
    {"solar_multiple_reflection", NULL, 0.0, "bus", "a switch"},
    {"specular_exchange", NULL, 0.0, "bus", "a switch"},
    {"multiple_scattering", NULL, 0.0, "bus", "a switch"},
    {"inter_reflection", NULL, 0.0, "bus", "a switch"},
    {"moonlight", NULL, 0.0, "bus", "a switch"},
    {"internal_power", "bus", 5.0, "vis", NULL},
    {"heater", "bus.+x", 20.0, "vis", "a heater does not cool"},
    {"stored_heat", "bus", 5.0, "vis", NULL},
    {"mli_emittance", "box", 0.1, "panel", NULL},
    {"mli_temperature_law", "box", 0.3, "panel", NULL},
    {"mli_seams", "box", 0.02, "panel", "seams do not insulate"},
    {"mli_sheets", "box", 20.0, "panel", "sheets do not store less than nothing"},
    {"mli_creases", "box", 2.0, "vis", NULL},
    {"panel_flatness", "wing", 2.0, "vis", NULL},
    {"heat_capacity", "panel", 0.1, "vis", NULL},
    {"specific_heat_law", "panel", 2e-4, "vis", NULL},
    {"interior_capacity", "bus", 500.0, "panel", NULL},
    {"interior_gradient", "bus", 200.0, "vis", "nothing follows early"},
    {"solar_absorptance", "grey_panel", 0.02, "vis", NULL},
    {"contamination", "grey_panel", 10.0, "vis", NULL},
    {"emittance", "grey_panel", 0.05, "vis", NULL},
    {"panel_extraction", "panel", 0.05, "vis", NULL},
    {"through_conductance", "panel", 0.1, "vis", NULL},
    {"contact_conductance", "panel", 0.2, "vis", NULL},
    {"albedo_level", NULL, 0.1, "bus", NULL},
    {"earth_ir_level", NULL, 0.05, "bus", NULL},
    {"earth_brightness", NULL, 5.0, "bus", NULL},
    {"local_albedo", NULL, 0.2, "bus", NULL},
    {"local_earth_ir", NULL, 0.1, "bus", NULL},
    {"cloud_in_mirror", NULL, 0.2, "bus", NULL},
    {"free_molecular_heating", NULL, 30.0, "bus", "no density is below 0"},
    {"solar_irradiance", NULL, 0.02, "bus", NULL},
    {"shadow_radius", NULL, 10.0, "bus", NULL},
    {"shadow_air", NULL, 10.0, "bus", NULL},
    {"band_emissivity", "grey_panel", 0.05, "vis", NULL},
    {"directional_emissivity", "grey_panel", 0.3, "vis", NULL},
    {"roughness", "grey_panel", 0.1, "vis", NULL},
    {"anisotropy", "grey_panel", 0.1, "vis", NULL},
    {"thin_film", "mli_kapton", 0.2, "vis", NULL},
    {"specular_level", "grey_panel", 0.1, "vis", NULL},
    {"diffuse_level", "grey_panel", 0.1, "vis", NULL},
    {"area", "panel", 0.1, "vis", NULL},
    {"array_angle", "wing", 3.0, "vis", NULL},
    {"attitude_offset", NULL, 2.0, "bus", NULL},
    {"spin_period", NULL, 0.01, "bus", NULL},
    {"nutation", NULL, 2.0, "bus", NULL},
    {"time_tag", NULL, 1.0, "bus", NULL},
    {"along_track", NULL, 2.0, "bus", NULL},
    {"exposure", NULL, 64.0, "bus", NULL},
    {"earthshine_level", NULL, 0.3, "bus", NULL},
    {"earth_reflection_level", NULL, 0.1, "bus", NULL},
    {"water_vapour", NULL, 0.3, "bus", NULL},
    {"aerosol", NULL, 0.05, "bus", "air without aerosol is clear"},
    {"cirrus", NULL, 0.05, "bus", "air without ice is clear"},
    {"extinction", "lwir", 0.05, "bus", NULL},
    {"aperture_loss", "vis", 0.02, "bus", "a circle does not hold more than all"},
    {"zero_point", "vis", 0.1, "bus", NULL},
    {"nonlinearity", "vis", 0.1, "bus", NULL},
    {"saturation", NULL, 0.0, "bus", "a switch"},
    {"background", "lwir", 1e-13, "bus", NULL},
    {"sky_background", "lwir", 1e-13, "bus", NULL},
    {"path_radiance", "lwir", 1e-13, "bus", NULL},
    {"twilight", "vis", 1e-4, "bus", "less light than none has no magnitude"},
};

/* Everything that is wrong is said before the test fails. */
static int complaints;
#define COMPLAIN(...)                                                                              \
  do {                                                                                             \
    print_error(__VA_ARGS__);                                                                      \
    print_error("\n");                                                                             \
    complaints++;                                                                                  \
  } while (0)

static const struct entry *entry_of(const struct um_effect *effect)
{
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    if (strcmp(cases[i].effect, effect->name) == 0) return &cases[i];
  COMPLAIN("effect '%s' has no line in tests/effects/conformance.c", effect->name);
  return NULL;
}

#define ISOTHERMAL 8 /* at most, of each world */
#define ISOTHERMAL_KEYS                                                                            \
  "thermal.start=isothermal", "thermal.orbits_before=0.1",                                         \
      "parts.panel.electrical_extraction=0.2", "time.exposure_s=10", "time.exposure_samples=2",    \
      "environment.earth=knocke"
/* Light between surfaces is noise to all effects but the one that is it; air costs each world its
 * light of the sky. */
static const char *const isothermal[ISOTHERMAL] = {ISOTHERMAL_KEYS,
                                                   "optics.interreflection_samples=0"};
static const char *const with_paths[ISOTHERMAL] = {ISOTHERMAL_KEYS,
                                                   "optics.interreflection_samples=4"};
static const char *const with_air[ISOTHERMAL] = {
    ISOTHERMAL_KEYS, "optics.interreflection_samples=0", "observer.air={profile: us_standard}"};
static const char *const of_air[] = {"atmosphere", "water_vapour", "aerosol", "cirrus", "twilight"};

/* At null plus `steps` times the step of its case. */
static struct um_model_addition away(const struct um_effect *effect, const struct entry *entry,
                                     double steps)
{
  struct um_model_addition a = {.effect = effect, .target = entry->target};
  for (size_t p = 0; p < effect->nparameter; p++)
    a.value[p] = p == 0 ? effect->parameters[p].null_value : effect->parameters[p].default_value;
  if (effect->nparameter > 0)
    a.value[0] = effect->parameters[0].logarithmic
                     ? effect->parameters[0].null_value * exp(steps * entry->step)
                     : effect->parameters[0].null_value + steps * entry->step;
  return a;
}

static void check_null(struct um_sensitivity_forward *f, const struct um_effect *effect,
                       const struct entry *entry, const double *base)
{
  double value[ROWS];
  struct um_model_addition a = away(effect, entry, 0.0);
  for (size_t p = 0; p < effect->nparameter; p++) a.value[p] = effect->parameters[p].null_value;
  if (um_sensitivity_forward_evaluate(context, f, &a, 1, value) != UM_OK)
    COMPLAIN("%s at null: %s", effect->name, um_core_message(context));
  if (memcmp(value, base, sizeof value) != 0) COMPLAIN("%s: its null changes bits", effect->name);
}

static double product(const struct um_sensitivity_forward *f, const double *a, const double *b,
                      const double *base)
{
  double sum = 0.0;
  for (size_t j = 0; j < f->observations.count; j++)
    sum +=
        (a[j] - base[j]) * (b[j] - base[j]) / (f->observations.sigma[j] * f->observations.sigma[j]);
  return sum;
}

/* To the bit; loads of another level are made of the scenario's, to the last of 24 bits. */
static bool as_fresh(const struct um_sensitivity_forward *f, const struct um_effect *effect,
                     const double *value, const double *fresh)
{
  static const char *const levels[] = {"albedo_level", "earth_ir_level", "solar_irradiance"};
  bool scaled = false;
  for (size_t i = 0; i < sizeof levels / sizeof levels[0]; i++)
    scaled = scaled || strcmp(effect->name, levels[i]) == 0;
  for (size_t j = 0; scaled && j < ROWS; j++)
    if (!(fabs(value[j] - fresh[j]) < 1e-6 * f->observations.sigma[j])) return false;
  return scaled || memcmp(value, fresh, ROWS * sizeof *value) == 0;
}

static void check_slope(const struct um_model_options *options, struct um_sensitivity_forward *f,
                        const struct um_effect *effect, const struct entry *entry,
                        const double *base)
{
  const struct um_effect_parameter *p = &effect->parameters[0];
  double up[ROWS], down[ROWS], fresh[ROWS];
  struct um_model_addition a = away(effect, entry, 1.0);
  if (um_sensitivity_forward_evaluate(context, f, &a, 1, up) != UM_OK) {
    COMPLAIN("%s: %s", effect->name, um_core_message(context));
    um_core_message_clear(context);
    return;
  }
  if (!(product(f, up, up, base) > 0.0)) COMPLAIN("%s: no slope", effect->name);
  assert_ok(fresh_values(options, f, &a, 1, fresh));
  if (!as_fresh(f, effect, up, fresh))
    COMPLAIN("%s: differs from a fresh run: effects/reach.c", effect->name);
  bool on_bound = p->null_value == p->minimum || p->null_value == p->maximum;
  if (on_bound != (entry->one_way != NULL))
    COMPLAIN("%s: null value %g of %g to %g, %s", effect->name, p->null_value, p->minimum,
             p->maximum, entry->one_way != NULL ? entry->one_way : "no reason to go one way");
  if (on_bound) return;
  a = away(effect, entry, -1.0);
  if (um_sensitivity_forward_evaluate(context, f, &a, 1, down) != UM_OK) {
    COMPLAIN("%s downward: %s", effect->name, um_core_message(context));
    um_core_message_clear(context);
    return;
  }
  if (!(product(f, up, down, base) < 0.0)) COMPLAIN("%s: both ways are one", effect->name);
}

/* The world that an effect is tried in. */
static const char *const *keys_of(const struct um_effect *effect)
{
  for (size_t i = 0; i < sizeof of_air / sizeof of_air[0]; i++)
    if (strcmp(effect->name, of_air[i]) == 0) return with_air;
  return strcmp(effect->name, "inter_reflection") == 0 ? with_paths : isothermal;
}

static size_t count_of(const char *const *keys)
{
  size_t n = 0;
  while (n < ISOTHERMAL && keys[n] != NULL) n++;
  return n;
}

/* A switch that is on is left out of the analyst's world, and put in again. */
static void check_switch(const struct um_effect *effect, const struct entry *entry,
                         const struct um_sensitivity_forward *with, const double *base)
{
  char samples[40], paths[48]; /* those of `base`: without an effect fewer might do */
  const char *overrides[ISOTHERMAL + 2] = {NULL};
  size_t n = count_of(keys_of(effect));
  memcpy(overrides, keys_of(effect), n * sizeof *overrides);
  snprintf(samples, sizeof samples, "optics.samples=%d", with->samples);
  snprintf(paths, sizeof paths, "optics.interreflection_samples=%d", with->paths);
  overrides[n] = samples;
  overrides[n + 1] = paths;
  const char *const without[] = {effect->name};
  const struct um_model_options options = {
      .overrides = overrides, .noverride = n + 2, .without = without, .nwithout = 1};
  struct um_sensitivity_forward *f = forward_of(&options, with->measurements);
  struct um_model_addition a = away(effect, entry, 0.0);
  double off[ROWS], on[ROWS];
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, off));
  assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, on));
  if (memcmp(off, base, sizeof off) == 0) COMPLAIN("%s: no slope", effect->name);
  if (memcmp(on, base, sizeof on) != 0)
    COMPLAIN("%s: turned on it is not what it was: effects/reach.c", effect->name);
  um_sensitivity_forward_destroy(context, &f);
}

static void check_refuses(struct um_sensitivity_forward *f, const struct um_effect *effect,
                          const struct entry *entry)
{
  struct um_model_addition a = away(effect, entry, 1.0);
  double value[ROWS];
  const char *const wrong[] = {entry->wrong, "no_such_thing",
                               effect->targets == UM_TARGET_GLOBAL ? "vis" : NULL};
  bool with_or_without =
      (effect->targets & UM_TARGET_GLOBAL) != 0 && effect->targets != UM_TARGET_GLOBAL;
  for (size_t i = 0; i < (with_or_without ? 2U : 3U); i++) {
    a.target = wrong[i];
    enum um_status status = um_sensitivity_forward_evaluate(context, f, &a, 1, value);
    if (status != UM_ERR_REFUSED)
      COMPLAIN("%s: target '%s': %s", effect->name, wrong[i] == NULL ? "" : wrong[i],
               um_core_status_text(status));
    um_core_message_clear(context);
  }
}

/* The measurements' forward model in the world of these keys, and its values. */
static struct um_sensitivity_forward *world_with(const struct um_model_options *options,
                                                 const struct um_compare_measurements *m,
                                                 double *base)
{
  struct um_sensitivity_forward *f = forward_of(options, m);
  assert_int_equal(f->observations.count, ROWS);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, base));
  return f;
}

static void check_all(const struct um_model_options *options, struct um_sensitivity_forward *f,
                      const struct um_effect *effect, const struct entry *entry, const double *base)
{
  check_null(f, effect, entry, base);
  check_refuses(f, effect, entry);
  if (effect->on_by_default)
    check_switch(effect, entry, f, base);
  else
    check_slope(options, f, effect, entry, base);
}

/* Air, and light between surfaces, are on in worlds of their own. */
static void test_physics(void **state)
{
  (void)state;
  const struct um_model_options options = {.overrides = isothermal,
                                           .noverride = count_of(isothermal)};
  double base[ROWS], own[ROWS];
  put_satellite();
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = world_with(&options, m, base);
  for (size_t i = 0; i < um_effects_count(); i++) {
    const struct um_effect *effect = um_effects_at(i);
    const struct entry *entry = entry_of(effect);
    if (entry == NULL) continue;
    if (um_effects_reach(effect) == 0) COMPLAIN("%s: reaches nothing", effect->name);
    if (keys_of(effect) == isothermal) {
      check_all(&options, f, effect, entry, base);
      continue;
    }
    const struct um_model_options others = {.overrides = keys_of(effect),
                                            .noverride = count_of(keys_of(effect))};
    struct um_sensitivity_forward *g = world_with(&others, m, own);
    check_all(&others, g, effect, entry, own);
    um_sensitivity_forward_destroy(context, &g);
  }
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
  assert_int_equal(complaints, 0);
}

static void test_manual(void **state)
{
  (void)state;
  static char page[1 << 18];
  FILE *file = fopen(UMBRA_SOURCE_DIR "/docs/effects.md", "r");
  assert_non_null(file);
  page[fread(page, 1, sizeof page - 1, file)] = '\0';
  fclose(file);
  for (size_t i = 0; i < um_effects_count(); i++) {
    char heading[96];
    snprintf(heading, sizeof heading, "\n## %s\n", um_effects_at(i)->name);
    if (strstr(page, heading) == NULL) fail_msg("docs/effects.md lacks '%s'", heading);
  }
}

static void test_laboratory(void **state)
{
  (void)state;
  const struct lab_options options = {.seeds = 1, .complete = 0};
  struct lab_case *all = NULL;
  size_t count = lab_cases_make(&options, &all);
  for (size_t i = 0; i < um_effects_count(); i++) {
    const char *name = um_effects_at(i)->name;
    bool hidden = false;
    for (size_t k = 0; k < count; k++) {
      hidden =
          hidden || (all[k].world->without != NULL && strcmp(all[k].world->without, name) == 0);
      for (size_t h = 0; h < all[k].nhidden; h++)
        hidden = hidden || strcmp(all[k].hidden[h].effect, name) == 0;
    }
    if (!hidden) fail_msg("effect '%s' is hidden in no world of tests/lab/cases.c", name);
  }
  free(all);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_physics, model_set_up, model_tear_down),
      cmocka_unit_test(test_manual),
      cmocka_unit_test(test_laboratory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
