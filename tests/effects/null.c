/* The effects on surfaces, geometry, motion, light of the Earth and photometry: null values leave
 * every number as it is, to the bit; and every parameter has a slope there: halving a small step
 * halves the change. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

/* One parameter of one use, and a small step from its null value. */
static const struct {
  const char *use, *parameter;
  double null_value, step;
} slopes[] = {
    {"band_emissivity:mli_kapton", "factor", 1.0, 0.01},
    {"directional_emissivity:mli_kapton", "tilt", 0.0, -0.02},
    {"directional_emissivity:grey_panel", "tilt", 0.0, 0.02},
    {"roughness:grey_panel", "factor", 1.0, 0.003},
    {"specular_level:grey_panel", "factor", 1.0, 0.01},
    {"diffuse_level:grey_panel", "factor", 1.0, 0.01},
    {"area:wing", "factor", 1.0, 0.01},
    {"array_angle:wing", "angle_deg", 0.0, 0.2},
    {"attitude_offset", "x_deg", 0.0, 0.2},
    {"attitude_offset", "y_deg", 0.0, 0.2},
    {"attitude_offset", "z_deg", 0.0, 0.2},
    {"spin_period", "relative_shift", 0.0, 0.001},
    {"time_tag", "shift_s", 0.0, 0.5},
    {"along_track", "shift_s", 0.0, 4.0},
    {"exposure", "square_s2", 0.0, 100.0},
    {"earthshine_level", "factor", 1.0, 0.1},
    {"earth_reflection_level", "factor", 1.0, 0.1},
    {"zero_point:vis", "factor", 1.0, 0.1},
    {"background:vis", "irradiance_W_m2", 0.0, 1e-13},
};

#define NSLOPE (sizeof slopes / sizeof slopes[0])

/* The effect at a share of its step from the null value, with temperatures to 1e-6 K, where the
 * default leaves some mK, 5e-5 of 8-12 um. */
static struct case_run step_from_null(const char *scenario, size_t i, double share)
{
  static const char *const set[] = {"thermal.relative_tolerance=1e-9",
                                    "thermal.absolute_tolerance_K=1e-6", NULL};
  char text[128];
  snprintf(text, sizeof text, "%s,%s=%.17g", slopes[i].use, slopes[i].parameter,
           slopes[i].null_value + share * slopes[i].step);
  const char *const with[] = {text, NULL};
  static const char *const lobe[] = {"earthlight_lobe", NULL};
  return case_compute(scenario, with, scenario == case_spinner ? lobe : NULL, set);
}

/* All of them at once. */
static void null_values_change_nothing(void **state)
{
  (void)state;
  char text[NSLOPE][128];
  const char *with[NSLOPE + 1] = {NULL};
  for (size_t i = 0; i < NSLOPE; i++) {
    snprintf(text[i], sizeof text[i], "%s,%s=%.17g", slopes[i].use, slopes[i].parameter,
             slopes[i].null_value);
    with[i] = text[i];
  }
  struct case_run plain = case_compute(case_satellite, NULL, NULL, NULL);
  struct case_run run = case_compute(case_satellite, with, NULL, NULL);
  assert_true(run.model->neffect >= plain.model->neffect + 17);
  assert_true(case_same(&plain, &run));
  case_release(&run);
  case_release(&plain);
}

/* Irradiances of both bands, scaled to their own mean, change by d(h) at a step h; the curvature
 * that is left in d(h) - 2 d(h/2) is small beside d(h). On the spinner, because shadows that are
 * sampled move by whole samples; its steps are a few percent of the plausible range. There without
 * the Earth in the lobe, whose facets leave kinks of 3e-5 of the light where they pass the Earth's
 * edge: too many for what an exposure changes at second order. */
static void every_parameter_has_a_slope(void **state)
{
  (void)state;
  struct case_run plain[2] = {step_from_null(case_satellite, 0, 0.0),
                              step_from_null(case_spinner, NSLOPE - 1, 0.0)};
  for (size_t i = 0; i < NSLOPE; i++) {
    bool kapton = strstr(slopes[i].use, "mli_kapton") != NULL;
    const char *scenario = kapton ? case_satellite : case_spinner;
    const struct um_model_result *r = plain[kapton ? 0 : 1].result;
    struct case_run whole = step_from_null(scenario, i, 1.0);
    struct case_run half = step_from_null(scenario, i, 0.5);
    double size = 0.0, curvature = 0.0;
    for (size_t j = 0; j < r->nobs * r->nband; j++) {
      double d = (whole.result->irradiance[j] - r->irradiance[j]) / r->irradiance[j];
      double d2 = (half.result->irradiance[j] - r->irradiance[j]) / r->irradiance[j];
      size += d * d;
      curvature += (d - 2.0 * d2) * (d - 2.0 * d2);
    }
    size = sqrt(size);
    curvature = sqrt(curvature);
    if (!(size > 1e-4 && curvature <= 0.02 * size))
      fail_msg("%s: change %g, curvature %g", slopes[i].use, size, curvature);
    case_release(&whole);
    case_release(&half);
  }
  case_release(&plain[0]);
  case_release(&plain[1]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(null_values_change_nothing),
      cmocka_unit_test(every_parameter_has_a_slope),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
