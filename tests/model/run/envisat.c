/* The demo's pass, coarser in time and mesh: ENVISAT over Graz on 2016-09-21.
 *
 *   20:31 .......... 20:36:52 20:36:59 20:37:05 .......... 20:44
 *   umbra            0        1/2      1         sunlit
 *
 * Geometry and events: computed with astropy, Skyfield and sgp4 by people who did not write this
 * program (docs/physics/orbit.md); software checks, since the TLE is 15 days old. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "environment/moonlight.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/build/model.h"
#include "model/build/timeline.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "orbit/time.h"
#include "tests/support/cmocka_all.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"

struct pass {
  struct um_context *context;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};

static void need(struct um_context *context, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static double utc(struct um_context *context, const char *text)
{
  double t = NAN;
  need(context, um_orbit_time_parse(context, text, &t));
  return t;
}

static int compute(void **state)
{
  static struct pass pass;
  static const char *const overrides[] = {"time.step_s=10", "time.light_time=false",
                                          "thermal.facets=''", "thermal.facet_size_m=3",
                                          "environment.disc=uniform"};
  static const char *const without[] = {"umbra_scatter"}; /* it outshines the Moon */
  const struct um_model_options options = {.overrides = overrides,
                                           .noverride = sizeof overrides / sizeof overrides[0],
                                           .without = without,
                                           .nwithout = 1};
  need(NULL, um_core_context_create(NULL, &pass.context));
  need(pass.context, um_model_create(pass.context, SCENARIO, &options, &pass.model));
  need(pass.context, um_model_precompute(pass.context, pass.model, &pass.tables));
  need(pass.context, um_model_run(pass.context, pass.model, pass.tables, &pass.result));
  *state = &pass;
  return 0;
}

static int release(void **state)
{
  struct pass *pass = *state;
  um_model_result_destroy(pass->context, &pass->result);
  um_model_tables_destroy(pass->context, &pass->tables);
  um_model_destroy(pass->context, &pass->model);
  um_core_context_destroy(&pass->context);
  return 0;
}

/* As docs/physics/orbit.md has it at 20:33:00: printed digits, 1e-3 deg and 10 m. */
static void geometry_at_the_epoch_of_the_paper(void **state)
{
  struct pass *pass = *state;
  struct um_environment_sample s;
  struct um_orbit_look look;
  need(pass->context, um_model_sample_seen(pass->context, pass->model,
                                           utc(pass->context, "2016-09-21T20:33:00Z"), &s, &look));
  assert_true(fabs(look.azimuth / UM_DEG - 215.6793) <= 1e-3);
  assert_true(fabs(look.elevation / UM_DEG - 6.6881) <= 1e-3);
  assert_true(fabs(look.range - 2562928.0) <= 10.0);
  assert_true(fabs(um_vec3_angle(s.sun, s.to_observer) / UM_DEG - 76.868) <= 1e-3);
}

static double event_time(const struct um_environment_event *event, size_t n,
                         enum um_environment_event_kind kind)
{
  for (size_t i = 0; i < n; i++)
    if (event[i].kind == kind) return event[i].t_tai;
  return NAN;
}

/* docs/physics/orbit.md: the light returns, uniform disc; 0.1 s is the accuracy asked for. */
static void check_return(struct pass *pass, const char *zero, const char *half, const char *one)
{
  struct um_environment_event *event = NULL;
  size_t n = 0;
  need(pass->context,
       um_model_events(pass->context, pass->model, utc(pass->context, "2016-09-21T20:31:02Z"),
                       utc(pass->context, "2016-09-21T20:44:12Z"), &event, &n));
  assert_int_equal(n, 3);
  assert_true(fabs(event_time(event, n, UM_EVENT_UMBRA_EXIT) - utc(pass->context, zero)) <= 0.1);
  assert_true(fabs(event_time(event, n, UM_EVENT_HALF_EXIT) - utc(pass->context, half)) <= 0.1);
  assert_true(fabs(event_time(event, n, UM_EVENT_PENUMBRA_EXIT) - utc(pass->context, one)) <= 0.1);
  um_core_free(pass->context, event);
}

static void light_returns_behind_an_oblate_earth(void **state)
{
  check_return(*state, "2016-09-21T20:36:51.86Z", "2016-09-21T20:36:58.68Z",
               "2016-09-21T20:37:05.48Z");
}

static void light_returns_behind_a_sphere(void **state)
{
  struct pass *pass = *state;
  struct pass sphere = {.context = pass->context};
  static const char *const overrides[] = {"environment.disc=uniform", "environment.shadow=sphere"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 2};
  need(pass->context, um_model_create_orbit(pass->context, SCENARIO, &options, &sphere.model));
  check_return(&sphere, "2016-09-21T20:36:57.65Z", "2016-09-21T20:37:04.50Z",
               "2016-09-21T20:37:11.34Z");
  um_model_destroy(pass->context, &sphere.model);
}

/* The point of the program: in the umbra VIS has no sunlight, but what the Earth's air bends into
 * its edge and less than a thousandth of full light; LWIR glows on. */
static void umbra_is_dark_in_vis_alone(void **state)
{
  struct pass *pass = *state;
  size_t vis = um_model_band_find(pass->model, "vis");
  size_t lwir = um_model_band_find(pass->model, "lwir");
  size_t umbra = 0, dark = 0, lit = 0;
  for (size_t k = 0; k < pass->tables->nobs; k++) {
    double sun = um_model_result_intensity(pass->result, k, vis, UM_MECHANISM_SUN);
    lit += sun > 0.0;
    dark += sun == 0.0 && pass->tables->sunlit[k] == 0.0;
    umbra += pass->tables->sunlit[k] < 1e-3;
    assert_true((sun > 0.0) <= (pass->tables->sunlit[k] > 0.0));
    assert_true(um_model_result_intensity(pass->result, k, lwir, UM_MECHANISM_EMITTED) > 100.0);
  }
  print_message("%zu instants dark, %zu below 1e-3 of sunlight, %zu lit\n", dark, umbra, lit);
  /* 350 s and 430 s at 10 s, 20 s of refracted light between; some instants show no lit face */
  assert_true(dark >= 31 && umbra >= 33 && lit >= 30);
}

/* In the umbra VIS is moonlight alone, where the air scatters nothing into it. The Moon's last
 * quarter is 37.5 h later (2016-09-23 09:56 UTC, US Naval Observatory) and its elongation falls
 * by 12.2 to 14.4 deg a day near perigee (361 900 km on the 18th): 67 to 71 deg of phase. Light at
 * that phase by V = -12.73 + 0.026 g + 4e-9 g^4 at 384 400 km against the Sun's -26.74 (Krisciunas
 * & Schaefer 1991), within 0.25 mag: 0.1 between the models, 0.07 for the waning side, 0.08 for the
 * width of VIS. */
static void the_moon_lights_the_umbra(void **state)
{
  struct pass *pass = *state;
  size_t vis = um_model_band_find(pass->model, "vis"), moonlit = 0;
  for (size_t k = 0; k < pass->tables->nobs; k++) {
    const struct um_environment_sample *s = &pass->tables->sample[k];
    double moon = um_model_result_intensity(pass->result, k, vis, UM_MECHANISM_OTHER);
    double all = um_model_result_intensity(pass->result, k, vis, -1);
    assert_true((s->moon_distance > 0.0) == (s->sunlit_fraction < 0.004));
    assert_true((moon > 0.0) == (s->moon_distance > 0.0));
    if (s->sunlit_fraction > 0.0) continue;
    assert_true(moon > (1.0 - 1e-12) * all);
    struct um_environment_moonlight light;
    um_environment_moonlight(&pass->model->environment, s, &light);
    double g = light.phase / UM_DEG, near = 384400e3 / s->moon_distance;
    double law = pow(10.0, -0.4 * (-12.73 + 0.026 * g + 4e-9 * pow(g, 4) + 26.74)) * near * near;
    double off = -2.5 * log10(um_environment_moonlight_at(&light, 0.55e-6) / law);
    if (moonlit++ == 0)
      print_message("phase %.1f deg, %.2e of the Sun, %.2f mag from the law\n", g,
                    um_environment_moonlight_at(&light, 0.55e-6), off);
    assert_true(g > 67.0 && g < 71.0 && light.longitude < 0.0 && fabs(off) < 0.25);
  }
  assert_true(moonlit >= 31);
}

/* Spectra, mechanisms and materials are three cuts of one intensity. */
static void sums_agree(void **state)
{
  const struct pass *pass = *state;
  const struct um_model_result *r = pass->result;
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t b = 0; b < r->nband; b++)
      for (int m = 0; m < UM_MECHANISM_COUNT; m++) {
        double total = um_model_result_intensity(r, k, b, m), spectrum = 0.0;
        for (size_t i = 0; i < r->nbin; i++)
          if (r->bin_band[i] == b)
            spectrum +=
                r->spectral[(k * r->nbin + i) * UM_MECHANISM_COUNT + (size_t)m] * r->bin_width[i];
        assert_true(fabs(spectrum - total) <= 1e-12 * fabs(total));
      }
}

/* Theoretical study of ENVISAT's thermal IR light curves: "the main part of the satellite thermal
 * IR signature comes from the solar panel". */
static void the_panel_carries_most_of_the_lwir(void **state)
{
  const struct pass *pass = *state;
  const struct um_model_result *r = pass->result;
  size_t lwir = um_model_band_find(pass->model, "lwir"), best = 0;
  double energy[16] = {0.0};
  assert_true(r->nmaterial <= 16);
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t m = 0; m < r->nmaterial; m++)
      for (size_t i = 0; i < UM_MECHANISM_COUNT; i++)
        energy[m] +=
            r->intensity[((k * r->nband + lwir) * r->nmaterial + m) * UM_MECHANISM_COUNT + i];
  for (size_t m = 1; m < r->nmaterial; m++)
    if (energy[m] > energy[best]) best = m;
  assert_string_equal(um_geometry_material_name(pass->model->geometry, best), "cell_silicon");
}

/* E = I / R^2 while above the horizon; energy is conserved to the program's own limit; the start
 * repeats after an orbit within what was asked of it. */
static void run_is_consistent(void **state)
{
  const struct pass *pass = *state;
  const struct um_model_result *r = pass->result;
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t b = 0; b < r->nband; b++) {
      double range = pass->tables->look[k].range;
      double expected = um_model_result_intensity(r, k, b, -1) / (range * range);
      assert_true(fabs(r->irradiance[k * r->nband + b] - expected) <= 1e-12 * expected);
    }
  assert_true(r->audit_error <= 1e-6);
  assert_true(r->periodic_distance <= 0.01);
  for (size_t p = 0; p < r->nplace; p++)
    for (size_t k = 0; k < r->nobs; k++)
      assert_true(r->place[p].minimum[k] > 50.0 && r->place[p].maximum[k] < 420.0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(geometry_at_the_epoch_of_the_paper),
      cmocka_unit_test(light_returns_behind_an_oblate_earth),
      cmocka_unit_test(light_returns_behind_a_sphere),
      cmocka_unit_test(umbra_is_dark_in_vis_alone),
      cmocka_unit_test(the_moon_lights_the_umbra),
      cmocka_unit_test(sums_agree),
      cmocka_unit_test(the_panel_carries_most_of_the_lwir),
      cmocka_unit_test(run_is_consistent),
  };
  return cmocka_run_group_tests(tests, compute, release);
}
