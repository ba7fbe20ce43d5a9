/* Scenario options whose effect on a run is known beforehand: exposure, material means, tracking
 * joints, frozen Sun, isothermal start. Scenarios are a plate and a box of grey materials. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/constants.h"
#include "model/model.h"
#include "orbit/time.h"
#include "tests/support/cmocka_all.h"

#define FILE_NAME "model_options_scenario.yaml"

static const char *const scenario =
    "schema: 1\n"
    "name: options\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:10:00Z, step_s: 300}\n"
    "orbit:\n"
    "  circular: {altitude_km: 600, beta_deg: 20}\n"
    "attitude: [{lvlh: {}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 3, 0]},\n"
    "     joint: {axis: [0, 1, 0], track: sun, normal: [0, 0, 1]},\n"
    "     front: grey_panel, back: grey_white, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: isothermal, start_temperature_K: 290, orbits_before: 0}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

struct run {
  struct um_model *model;
  struct um_model_trace *trace;
  struct um_model_result *result;
};

static struct um_context *context;

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static struct run compute(const char *const *overrides, size_t n)
{
  struct run run = {0};
  const struct um_model_options options = {.overrides = overrides, .noverride = n};
  need(um_model_create(context, FILE_NAME, &options, &run.model));
  need(um_model_trace_create(context, run.model, &run.trace));
  need(um_model_run(context, run.model, run.trace, &run.result));
  return run;
}

static void release(struct run *run)
{
  um_model_result_destroy(context, &run->result);
  um_model_trace_destroy(context, &run->trace);
  um_model_destroy(context, &run->model);
}

static int setup(void **state)
{
  (void)state;
  FILE *f = fopen(FILE_NAME, "w");
  if (f == NULL) return -1;
  fputs(scenario, f);
  fclose(f);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int teardown(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return remove(FILE_NAME);
}

/* An exposure is the mean of its instants: five of 60 s stand 60/sqrt(24) s apart about
 * mid-exposure. The same instants observed one by one have the same mean; their heat histories
 * differ by the integrator's tolerance alone, which is made tight. The joint stands still: what the
 * satellite covers of its own sky is taken at the start, which differs. */
static void exposure_is_the_mean_of_its_instants(void **state)
{
  (void)state;
  static const char *const exposed[] = {"time.exposure_s=60",
                                        "time.exposure_samples=5",
                                        "time.start_utc=2020-03-20T12:01:00Z",
                                        "time.stop_utc=2020-03-20T12:01:00Z",
                                        "thermal.relative_tolerance=1e-10",
                                        "thermal.absolute_tolerance_K=1e-8",
                                        "parts.wing.joint.track=none"};
  static const char *const single[] = {"time.step_s=12.247448714",
                                       "time.start_utc=2020-03-20T12:00:35.505102572Z",
                                       "time.stop_utc=2020-03-20T12:01:24.5Z",
                                       "orbit.circular.epoch_utc=2020-03-20T12:01:00Z",
                                       "thermal.relative_tolerance=1e-10",
                                       "thermal.absolute_tolerance_K=1e-8",
                                       "parts.wing.joint.track=none"};
  struct run a = compute(exposed, 7), b = compute(single, 7);
  assert_int_equal(a.result->nobs, 1);
  assert_int_equal(b.result->nobs, 5);
  for (size_t band = 0; band < 2; band++) {
    double mean = 0.0, irradiance = 0.0;
    for (size_t k = 0; k < 5; k++) {
      mean += 0.2 * um_model_result_intensity(b.result, k, band, -1);
      irradiance += 0.2 * b.result->irradiance[k * 2 + band];
    }
    assert_true(mean > 0.0);
    assert_true(fabs(um_model_result_intensity(a.result, 0, band, -1) - mean) <= 2e-6 * mean);
    assert_true(fabs(a.result->irradiance[band] - irradiance) <= 2e-6 * irradiance);
  }
  release(&a);
  release(&b);
}

/* The joint turns the wing as far toward the Sun as one axis can: with the axis along y the cosine
 * is sqrt(1 - s_y^2). */
static void tracking_joint_follows_the_sun(void **state)
{
  (void)state;
  struct run a = compute(NULL, 0);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(a.model->geometry);
  for (size_t k = 0; k < a.trace->nobs; k++) {
    struct um_vec3 sun = um_quat_apply(a.trace->sample[k].q, a.trace->sample[k].sun);
    double expected = sqrt(1.0 - sun.y * sun.y);
    const float *row = a.trace->loads->sun + a.trace->load_row[k] * mesh->nsurface;
    for (size_t s = 0; s < mesh->nsurface; s++)
      if (mesh->surface[s].part == 1 && !mesh->surface[s].back)
        assert_true(fabs((double)row[s] - expected) <= 1e-6); /* float */
  }
  release(&a);
}

/* Every surface of a material takes the material's area-weighted mean. */
static void material_mean_levels_temperatures(void **state)
{
  (void)state;
  static const char *const mean[] = {"thermal.temperature_in_optics=material_mean"};
  struct run a = compute(NULL, 0), b = compute(mean, 1);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(a.model->geometry);
  size_t last = a.result->nobs - 1;
  const double *own = a.result->surface_temperature + last * mesh->nsurface;
  const double *level = b.result->surface_temperature + last * mesh->nsurface;
  for (uint32_t m = 0; m < a.result->nmaterial; m++) {
    double sum = 0.0, area = 0.0, low = INFINITY, high = -INFINITY;
    for (size_t s = 0; s < mesh->nsurface; s++) {
      if (mesh->surface[s].material != m) continue;
      double w = mesh->area[mesh->surface[s].facet];
      sum += w * own[s];
      area += w;
      low = fmin(low, level[s]);
      high = fmax(high, level[s]);
    }
    assert_true(high - low <= 1e-9);
    assert_true(fabs(low - sum / area) <= 1e-6);
  }
  release(&a);
  release(&b);
}

/* A frozen Sun stands still in GCRS; the true one moves about 0.04 deg an hour. */
static void frozen_sun_stands_still(void **state)
{
  (void)state;
  static const char *const frozen[] = {"environment.sun=frozen", "environment.sun_distance_au=1",
                                       "time.stop_utc=2020-03-20T14:00:00Z", "time.step_s=7200"};
  struct run a = compute(frozen, 4);
  struct um_vec3 from = um_vec3_axpy(a.trace->sample[0].r, UM_AU, a.trace->sample[0].sun);
  struct um_vec3 to = um_vec3_axpy(a.trace->sample[1].r, UM_AU, a.trace->sample[1].sun);
  /* both look at one point from places 14000 km apart at most */
  assert_true(um_vec3_angle(from, to) <= 1e-6);
  assert_true(a.trace->sample[1].sun_distance == UM_AU);
  release(&a);
}

/* Without orbits before the window everything starts at the temperature that was given. */
static void isothermal_start_is_taken(void **state)
{
  (void)state;
  struct run a = compute(NULL, 0);
  for (size_t p = 0; p < a.result->nplace; p++)
    assert_true(fabs(a.result->place[p].mean[0] - 290.0) <= 1e-9);
  assert_true(isnan(a.result->periodic_drift));
  release(&a);
}

/* A point that does not move has no orbit to repeat: the start is the steady state. */
static void fixed_point_starts_steady(void **state)
{
  (void)state;
  static const char *const fixed[] = {"orbit={fixed: {position_gcrs_km: [7000, 0, 0]}}",
                                      "attitude=[{fixed: {q_gcrs: [1, 0, 0, 0]}}]",
                                      "thermal.start=periodic"};
  struct run a = compute(fixed, 3);
  for (size_t p = 0; p < a.result->nplace; p++)
    assert_true(fabs(a.result->place[p].mean[1] - a.result->place[p].mean[0]) <= 0.05);
  release(&a);
}

/* A spinning satellite in MLI behind hard shadow edges: the noise of integrating its fast skins
 * must not keep the periodic state from being found. What is found repeats: starting an orbit
 * earlier gives the same slow temperatures. */
static void spinning_blanket_finds_its_periodic_state(void **state)
{
  (void)state;
  static const char *const once[] = {
      "attitude=[{spin: {axis_gcrs: [0.2, 0.3, 0.9], axis_body: [0, 0, 1], period_s: 751}}]",
      "environment.shadow=cylinder",
      "environment.sun=frozen",
      "thermal={start: periodic}",
      "time.stop_utc=2020-03-20T12:00:00Z",
      "parts.box.lumped=false",
      "parts.box.facet_size_m=0.5",
      "parts.box.outside=grey_mli",
      "parts.box.mli={effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 40, wraps: interior}",
      "parts.box.interior={capacity_J_K: 5e5, power_W: 50}",
      "thermal.orbits_before=2"};
  struct run a = compute(once, 10), b = compute(once, 11);
  size_t inside = um_thermal_body_place_find(a.model->body, "box.interior");
  assert_true(inside != (size_t)-1);
  assert_true(fabs(a.result->place[inside].mean[0] - b.result->place[inside].mean[0]) <= 0.02);
  assert_true(a.result->periodic_drift <= 0.01);
  release(&a);
  release(&b);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(exposure_is_the_mean_of_its_instants),
      cmocka_unit_test(tracking_joint_follows_the_sun),
      cmocka_unit_test(material_mean_levels_temperatures),
      cmocka_unit_test(frozen_sun_stands_still),
      cmocka_unit_test(isothermal_start_is_taken),
      cmocka_unit_test(fixed_point_starts_steady),
      cmocka_unit_test(spinning_blanket_finds_its_periodic_state),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
