/* Scenario options whose effect on a run is known beforehand: exposure, material means, tracking
 * joints, frozen Sun, isothermal start. Scenarios are a plate and a box of grey materials. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/build/model.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
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
  struct um_model_tables *tables;
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
  need(um_model_precompute(context, run.model, &run.tables));
  need(um_model_run(context, run.model, run.tables, &run.result));
  return run;
}

static void release(struct run *run)
{
  um_model_result_destroy(context, &run->result);
  um_model_tables_destroy(context, &run->tables);
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
  for (size_t k = 0; k < a.tables->nobs; k++) {
    struct um_vec3 sun = um_quat_apply(a.tables->sample[k].q, a.tables->sample[k].sun);
    double expected = sqrt(1.0 - sun.y * sun.y);
    const float *row = a.tables->seen->sun + a.tables->load_row[k] * mesh->nsurface;
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
  struct um_vec3 from = um_vec3_axpy(a.tables->sample[0].r, UM_AU, a.tables->sample[0].sun);
  struct um_vec3 to = um_vec3_axpy(a.tables->sample[1].r, UM_AU, a.tables->sample[1].sun);
  /* both look at one point from places 14000 km apart at most */
  assert_true(um_vec3_angle(from, to) <= 1e-6);
  assert_true(a.tables->sample[1].sun_distance == UM_AU);
  release(&a);
}

/* Without orbits before the window everything starts at the temperature that was given. */
static void isothermal_start_is_taken(void **state)
{
  (void)state;
  struct run a = compute(NULL, 0);
  for (size_t p = 0; p < a.result->nplace; p++)
    assert_true(fabs(a.result->place[p].mean[0] - 290.0) <= 1e-9);
  assert_true(isnan(a.result->periodic_distance));
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
  assert_true(a.result->periodic_distance <= 0.01);
  release(&a);
  release(&b);
}

/* States of the scenario's own orbit every 30 s, to nine digits of a kilometre and a second, over
 * [from, to]. */
static void write_table(const char *path, double from, double to)
{
  struct um_model *model = NULL;
  need(um_model_create_orbit(context, FILE_NAME, NULL, &model));
  FILE *f = fopen(path, "w");
  assert_non_null(f);
  fputs("time_utc,x_km,y_km,z_km,vx_km_s,vy_km_s,vz_km_s\n", f);
  for (double t = from; t <= to + 1e-6; t += 30.0) {
    struct um_vec3 r, v;
    char time[32];
    need(um_orbit_trajectory_state(context, model->trajectory, t, &r, &v));
    um_orbit_time_format(t, time);
    fprintf(f, "%s,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f\n", time, 1e-3 * r.x, 1e-3 * r.y, 1e-3 * r.z,
            1e-3 * v.x, 1e-3 * v.y, 1e-3 * v.z);
  }
  fclose(f);
  um_model_destroy(context, &model);
}

/* A table that covers the observations and nothing else is enough for an isothermal start without
 * orbits before, and the run is that of the orbit it was made from: cubic Hermite over 30 s of a
 * circle of 7 000 km leaves r w^4 30^4 / 384 = 2e-8 of r. A periodic start wants an orbit of it. */
static void table_of_the_span_is_enough(void **state)
{
  (void)state;
  static const char path[] = "model_options_table.csv";
  static const char *const set[] = {"orbit={table: model_options_table.csv}", "time.step_s=60",
                                    "parts.wing.joint.track=none", "thermal.start=periodic"};
  double start;
  need(um_orbit_time_parse(context, "2020-03-20T12:00:00Z", &start));
  write_table(path, start, start + 600.0);
  struct run a = compute(set + 1, 2), b = compute(set, 3);
  assert_int_equal(b.result->nobs, 11);
  for (size_t i = 0; i < 22; i++)
    assert_true(fabs(b.result->irradiance[i] / a.result->irradiance[i] - 1.0) <= 1e-5);
  /* one instant, where the run has no length at all */
  static const char *const once[] = {"orbit={table: model_options_table.csv}",
                                     "time.stop_utc=2020-03-20T12:00:00Z"};
  struct run c = compute(once, 2);
  assert_true(fabs(c.result->place[0].mean[0] - 290.0) <= 1e-9);
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  const struct um_model_options periodic = {.overrides = set, .noverride = 4};
  need(um_model_create(context, FILE_NAME, &periodic, &model));
  assert_int_equal(um_model_precompute(context, model, &tables), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "the table covers 2020-03-20T12:00:00.000Z to"));
  um_core_message_clear(context);
  um_model_destroy(context, &model);
  release(&a);
  release(&b);
  release(&c);
  remove(path);
}

/* Who moves on the far side of the Earth sees nothing; on this side, the satellite: two tables of a
 * point 20 000 km out, over the satellite and opposite to it. */
static void earth_hides_from_a_moving_observer(void **state)
{
  (void)state;
  static const char path[] = "model_options_observer.csv";
  static const char *const set[] = {"observer={trajectory: {table: model_options_observer.csv}}",
                                    "time.stop_utc=2020-03-20T12:00:00Z"};
  struct um_model *model = NULL;
  struct um_vec3 r;
  need(um_model_create_orbit(context, FILE_NAME, NULL, &model));
  need(um_orbit_trajectory_state(context, model->trajectory, model->scenario->time->start, &r,
                                 NULL));
  um_model_destroy(context, &model);
  for (int far = 0; far < 2; far++) {
    struct um_vec3 x = um_vec3_scale(um_vec3_unit(r), far ? -2e4 : 2e4); /* [km] */
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs("time_utc,x_km,y_km,z_km\n", f);
    for (int minute = 59; minute < 62; minute++)
      fprintf(f, "2020-03-20T%d:%02d:00Z,%.6f,%.6f,%.6f\n", 11 + minute / 60, minute % 60, x.x, x.y,
              x.z);
    fclose(f);
    struct run run = compute(set, 2);
    assert_true(run.tables->hidden[0] == (far == 1));
    assert_true(isnan(run.result->irradiance[1]) == (far == 1));
    assert_true(isnan(run.result->magnitude_ab[1]) == (far == 1));
    assert_true(um_model_result_intensity(run.result, 0, 1, -1) > 0.0);
    bool said =
        strstr(um_core_log_text(context),
               "the Earth stands between satellite and observer in 1 of 1 observations") != NULL;
    assert_true(said == (far == 1));
    release(&run);
  }
  remove(path);
}

/* A blanket's outer layer without a blanket, and an inside that is heated: each way out is one. */
static void blankets_and_insides(void **state)
{
  (void)state;
  static const char warning[] = "parts.box: 'mli_kapton' is the outer layer of a blanket, but";
  static const struct {
    const char *set[4];
    bool warned;
  } cases[] = {
      {{"parts.box.outside=mli_kapton"}, true},
      {{"parts.box.outside=mli_kapton",
        "parts.box.mli={effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 40, wraps: wall}",
        "parts.box.interior={capacity_J_K: 5e4, power_W: 5, conductance_W_K: 1}"},
       false},
      {{"parts.box.outside=mli_kapton",
        "parts.box.mli={effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 40, wraps: "
        "interior}",
        "parts.box.interior={capacity_J_K: 5e4, power_W: 5}"},
       false},
      {{"parts.box.interior={capacity_J_K: 5e4, power_W: 5}",
        "contacts=[{a: box.interior, b: wing, conductance_W_K: 1}]"},
       false},
      {{"parts.box.interior={capacity_J_K: 5e4, power_W: 5}",
        "parts.box.groups={+x: {interior_conductance_W_K: 1}}"},
       false},
      {{"parts.box.interior={capacity_J_K: 5e4}"}, false},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct um_context *own = NULL;
    struct um_model *model = NULL;
    size_t n = 0;
    while (n < 4 && cases[i].set[n] != NULL) n++;
    const struct um_model_options options = {.overrides = cases[i].set, .noverride = n};
    assert_int_equal(um_core_context_create(NULL, &own), UM_OK);
    if (um_model_create(own, FILE_NAME, &options, &model) != UM_OK)
      fail_msg("%zu: %s", i, um_core_message(own));
    bool warned = strstr(um_core_log_text(own), warning) != NULL;
    if (warned != cases[i].warned) fail_msg("%zu: %s", i, um_core_log_text(own));
    um_model_destroy(own, &model);
    um_core_context_destroy(&own);
  }
}

/* The wing ends at (1, 3.5, 0): 3.64 m from the origin. */
static void observer_inside_is_refused(void **state)
{
  (void)state;
  static const char *const inside[] = {"observer.direction.range_km=0.0036"};
  static const char *const outside[] = {"observer.direction.range_km=0.0037"};
  const struct um_model_options options = {.overrides = inside, .noverride = 1};
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  need(um_model_create(context, FILE_NAME, &options, &model));
  assert_int_equal(um_model_precompute(context, model, &tables), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "observer.direction.range_km: 0.0036 (3.6 m) "));
  assert_non_null(strstr(um_core_message(context), "reaches 3.64005 m"));
  um_core_message_clear(context);
  um_model_destroy(context, &model);
  struct run run = compute(outside, 1);
  assert_true(run.result->irradiance[0] > 0.0);
  release(&run);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(table_of_the_span_is_enough),
      cmocka_unit_test(earth_hides_from_a_moving_observer),
      cmocka_unit_test(observer_inside_is_refused),
      cmocka_unit_test(blankets_and_insides),
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
