/* Every heat effect: at its null value the result is bit-identical to that without it; at its
 * default it changes what it is to change and leaves the rest bit for bit; the slope at the null
 * value is not zero and the same from both sides. */
#include "effects/effects.h"
#include "heat_help.h"
#include "model/run/result.h"

enum { T = 1, V = 2, L = 4 }; /* temperatures, visible, thermal infrared */

struct use {
  const char *effect, *target; /* target "": none */
  int changes;                 /* or-ed T, V, L */
  double step;                 /* for slopes, in units of the parameter */
  const char *override;        /* where the effect is seen; NULL: the common scenario */
};

/* Half lit: a point of the limb at the height of the Sun's centre, see penumbra_is_half_lit(). */
#define PENUMBRA  "orbit={fixed: {position_gcrs_km: [-2918, 6375, 0]}}"
#define TRANSIENT "thermal.start=isothermal"
/* Cells that are stated to give something can give less. */
#define CELLS "parts.panel.electrical_extraction=0.1"

/* Steps are so small that the slopes of both sides agree to 5 %: they differ by f'' step/f', which
 * for a power law x^n about 1 is (n - 1) step, for a conductance between temperatures about 2 step
 * and for the Planck function at 270 K about 0.015 step. A kink would differ by 100 %. */
#define SLOPES_AGREE 0.05
static const struct use uses[] = {
    {"internal_power", ":bus", T | L, 1.0, NULL},
    {"stored_heat", ":bus", T | L, 1.0, NULL},
    {"mli_emittance", ":bus", T | L, 0.01, NULL},
    {"mli_temperature_law", ":bus", T | L, 0.01, NULL},
    {"heat_capacity", ":bus", T | L, 0.01, TRANSIENT},
    {"specific_heat_law", ":bus", T | L, 1e-4, TRANSIENT},
    {"interior_capacity", ":bus", T | L, 200.0, TRANSIENT},
    {"solar_absorptance", ":grey_panel", T | V | L, 0.005, NULL},
    {"emittance", ":grey_white", T | L, 0.01, NULL},
    {"panel_extraction", ":panel", T | L, 0.005, CELLS},
    {"panel_extraction", ":panel.front", T | L, 0.005, CELLS},
    {"panel_extraction", ":panel.plate", T | L, 0.005, CELLS},
    {"through_conductance", ":panel", T | L, 0.01, NULL},
    {"contact_conductance", "", T | L, 0.01, NULL},
    {"contact_conductance", ":bus", T | L, 0.01, NULL},
    {"contact_conductance", ":panel.back", T | L, 0.01, NULL},
    {"albedo_level", "", T | V | L, 0.01, NULL},
    {"earth_ir_level", "", T | L, 0.01, NULL},
    {"earth_brightness", "", L, 0.5, NULL},
    {"solar_irradiance", "", T | V | L, 0.01, NULL},
    {"shadow_radius", "", T | V | L, 0.2, PENUMBRA},
};
#define USES (sizeof uses / sizeof uses[0])

static struct heat_run compute(const struct use *use, double value)
{
  char text[128];
  const struct um_effect *effect = um_effects_find(use->effect);
  assert_non_null(effect);
  snprintf(text, sizeof text, "%s%s,%s=%.17g", use->effect, use->target, effect->parameters[0].name,
           value);
  return heat_compute(LIST(use->override), LIST(text), NONE);
}

/* The run without effects of each override, which is computed once. */
static struct heat_run *without_of(const char *override)
{
  static struct {
    const char *override;
    struct heat_run run;
  } known[4];
  static size_t nknown;
  for (size_t i = 0; i < nknown; i++)
    if (known[i].override == override) return &known[i].run;
  assert_true(nknown < sizeof known / sizeof known[0]);
  known[nknown].override = override;
  known[nknown].run = heat_compute(LIST(override), NONE, NONE);
  return &known[nknown++].run;
}

static void expect_null(const struct use *use, const struct heat_run *at_null)
{
  const struct heat_run *without = without_of(use->override);
  if (!heat_same_temperatures(without, at_null) || !heat_same_band(without, at_null, "vis") ||
      !heat_same_band(without, at_null, "lwir"))
    fail_msg("%s%s at its null value changes the result", use->effect, use->target);
}

static void default_changes_what_it_should(void **state)
{
  (void)state;
  for (size_t i = 0; i < USES; i++) {
    const struct use *use = &uses[i];
    const struct heat_run *without = without_of(use->override);
    struct heat_run with = compute(use, um_effects_find(use->effect)->parameters[0].default_value);
    int changed = heat_same_temperatures(without, &with) ? 0 : T;
    if (!heat_same_reflected(without, &with, "vis")) changed |= V;
    if (!heat_same_band(without, &with, "lwir")) changed |= L;
    if (changed != use->changes)
      fail_msg("%s%s changes %d, expected %d (1 temperatures, 2 visible, 4 infrared)", use->effect,
               use->target, changed, use->changes);
    heat_release(&with);
  }
}

/* The most sensitive of the last temperatures and of the band irradiances, in relative change. */
static void slopes(const struct heat_run *at_null, const struct heat_run *low,
                   const struct heat_run *high, double *below, double *above)
{
  const struct um_model_result *r = at_null->result;
  size_t last = (r->nobs - 1) * r->nnode, ntotal = r->nnode + r->nband;
  *below = *above = 0.0;
  for (size_t i = 0; i < ntotal; i++) {
    size_t k = i < r->nnode ? last + i : i - r->nnode;
    const struct um_model_result *const three[3] = {low->result, r, high->result};
    double value[3];
    for (int j = 0; j < 3; j++)
      value[j] = i < r->nnode ? three[j]->node_temperature[k] : three[j]->irradiance[k];
    double a = (value[1] - value[0]) / value[1], b = (value[2] - value[1]) / value[1];
    if (fabs(a + b) > fabs(*below + *above)) {
      *below = a;
      *above = b;
    }
  }
}

/* At the null value no bit changes. The slopes of both sides agree; where the null value is a
 * bound, the step is taken twice on the one side. */
static void null_is_null_and_smooth(void **state)
{
  (void)state;
  for (size_t i = 0; i < USES; i++) {
    const struct use *use = &uses[i];
    const struct um_effect_parameter *p = &um_effects_find(use->effect)->parameters[0];
    bool on_bound = p->null_value == p->minimum;
    double middle = on_bound ? p->null_value + use->step : p->null_value;
    struct heat_run low = compute(use, middle - use->step), at = compute(use, middle),
                    high = compute(use, middle + use->step);
    double below, above;
    expect_null(use, on_bound ? &low : &at);
    slopes(&at, &low, &high, &below, &above);
    print_message("  %-20s%-12s relative change per step %+.3e, sides differ by %.1e\n",
                  use->effect, use->target, 0.5 * (below + above), fabs(below / above - 1.0));
    /* the integrator's tolerance is 1e-9 of a temperature */
    assert_true(fabs(above) > 1e-7);
    assert_true(fabs(below / above - 1.0) <= SLOPES_AGREE);
    heat_release(&low);
    heat_release(&at);
    heat_release(&high);
  }
}

static void penumbra_is_half_lit(void **state)
{
  (void)state;
  struct heat_run run = heat_compute(LIST(PENUMBRA), NONE, NONE);
  print_message("  sunlit fraction %.3f\n", run.tables->sunlit[0]);
  assert_true(run.tables->sunlit[0] > 0.3 && run.tables->sunlit[0] < 0.7);
  heat_release(&run);
}

/* What cannot act is refused in one line that names it. */
static void refusals_name_the_part(void **state)
{
  (void)state;
  static const char *const bad[][2] = {
      {"internal_power:panel", "'panel' has no interior"},
      {"interior_capacity:panel", "'panel' has no interior"},
      {"stored_heat:panel", "'panel' has no interior"},
      {"mli_emittance:panel", "'panel' has no MLI"},
      {"mli_emittance:panel.plate", "'panel.plate' has no MLI"},
      {"mli_temperature_law:panel", "'panel' has no MLI"},
      {"mli_seams:panel.plate", "'panel.plate' has no MLI"},
      {"mli_emittance:bus,factor=60", "1.2; accepted: up to 1"},
      {"mli_emittance", "needs a target"},
      {"panel_extraction:bus.-x,efficiency=0.1", "'bus.-x' is MLI; accepted: a side with cells"},
      {"panel_extraction:bus,efficiency=0.1", "'bus' is all MLI; accepted: a part with cells"},
      {"panel_extraction:panel,efficiency=-0.1", "'panel.plate' -0.1; accepted: 0 or more in all"},
      {"internal_power:bus,power_W=-20.5", "'bus' -0.5 W; accepted: 0 or more in all"},
      {"interior_capacity:bus,capacity_J_K=-20001", "-1 J/K; accepted: 0 or more in all"},
      {"through_conductance:bus", "'bus' are one layer"},
      {"through_conductance:bus.+x", "'bus.+x' is one layer"},
      {"albedo_level,factor=3.5", "accepted: 0 to 3"},
      {"albedo_level:bus", "accepted: no target"},
  };
  char message[512];
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    heat_refused(NONE, LIST(bad[i][0]), message, sizeof message);
    if (strstr(message, bad[i][1]) == NULL) fail_msg("%s: '%s'", bad[i][0], message);
  }
  heat_refused(LIST("thermal.start=isothermal", "thermal.start_temperature_K=150"),
               LIST("stored_heat:bus,shift_K=-200"), message, sizeof message);
  assert_non_null(strstr(message, "node 'bus.interior' begins at -50 K, -200 K off; accepted: "));
  heat_refused(LIST("parts.panel.electrical_extraction=0.7"),
               LIST("panel_extraction:panel,efficiency=0.4"), message, sizeof message);
  assert_non_null(strstr(message, "1.1, more than it absorbs; accepted: up to "));
  heat_refused(LIST("environment.shadow=none"), LIST("shadow_radius"), message, sizeof message);
  assert_non_null(strstr(message, "no shadow"));
  heat_refused(LIST("environment.albedo=0.6"), LIST("albedo_level,factor=2"), message,
               sizeof message);
  assert_non_null(strstr(message, "makes the albedo 1.2; accepted: up to 1"));
  heat_refused(LIST("environment.brightness_temperature_K=100"),
               LIST("earth_brightness,shift_K=-100"), message, sizeof message);
  assert_non_null(strstr(message, "accepted: above 0"));
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("effects_heat_null.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(penumbra_is_half_lit),
      cmocka_unit_test(default_changes_what_it_should),
      cmocka_unit_test(null_is_null_and_smooth),
      cmocka_unit_test(refusals_name_the_part),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
