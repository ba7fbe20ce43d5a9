/* With which models geometry tables are compatible: for every key below the answer is that of
 * tracing anew and comparing all that was traced, number for number; and for every member of the
 * environment, whether what is traced depends on it. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "environment/daylight.h"
#include "model/build/build.h"
#include "model/geometry/compatible.h"
#include "model/geometry/precompute.h"
#include "tests/model/traced_help.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define FILE_NAME "compatible_scenario.yaml"

static const char *const scenario =
    "schema: 1\n"
    "name: compatible\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:06:00Z, step_s: 60}\n"
    "orbit:\n"
    "  circular: {altitude_km: 600, beta_deg: 20}\n"
    "attitude: [{lvlh: {}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     interior: {capacity_J_K: 1000, power_W: 5, conductance_W_K: 1},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 3, 0]},\n"
    "     joint: {axis: [0, 1, 0], track: sun, normal: [0, 0, 1]},\n"
    "     front: grey_panel, back: grey_white, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "contacts:\n"
    "  - {a: box, b: wing, conductance_W_K: 0.5}\n"
    "thermal: {start: isothermal, start_temperature_K: 290, orbits_before: 0.02,\n"
    "          view_factor_rays: 256}\n"
    "environment: {albedo: 0.3}\n"
    "optics: {samples: 4}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

/* COMPATIBLE, ANOTHER: tracing anew gives the same, or not. BY_CHANCE: it gives the same here, but
 * of numbers that decide what is traced elsewhere: the answer is no. */
enum expected { ANOTHER, COMPATIBLE, BY_CHANCE };
static const struct {
  const char *set, *with;
  enum expected expected;
} changes[] = {
    {"parts.box.interior.power_W=50", NULL, COMPATIBLE},
    {"parts.box.interior.capacity_J_K=2000", NULL, COMPATIBLE},
    {"parts.box.shell.areal_heat_capacity_J_m2_K=5000", NULL, COMPATIBLE},
    {"contacts.0.conductance_W_K=2", NULL, COMPATIBLE},
    {"bands.vis.bins=7", NULL, COMPATIBLE},
    {"bands.lwir.from_um=9", NULL, COMPATIBLE},
    {"parts.box.outside=grey_panel", NULL, ANOTHER}, /* a material less: other indices */
    {"parts.wing.front=black", NULL, COMPATIBLE},    /* a name behind the same index */
    {"name=other", NULL, COMPATIBLE},
    {"thermal.accuracy_K=0.05", NULL, COMPATIBLE},
    {"thermal.start=periodic", NULL, ANOTHER}, /* an orbit at least: another span */
    {"thermal.orbits_before=2", NULL, ANOTHER},
    {"thermal.step_s=30", NULL, ANOTHER},
    {"thermal.samples=9", NULL, BY_CHANCE}, /* no surface is partly hidden .. */
    {"optics.samples=5", NULL, ANOTHER},    /* .. but how many points the view has is kept in it */
    {"optics.interreflection_samples=3", NULL, COMPATIBLE},
    {"environment.albedo=0.31", NULL, ANOTHER},
    {"environment.olr_W_m2=200", NULL, ANOTHER},
    {"environment.brightness_temperature_K=280", NULL,
     COMPATIBLE}, /* uniform: of the light alone */
    {"environment.solar_irradiance_W_m2=1400", NULL, ANOTHER},
    {"environment.disc=point", NULL, BY_CHANCE}, /* full sunlight */
    {"time.step_s=30", NULL, ANOTHER},
    {"time.exposure_s=1", NULL, ANOTHER},
    {"time.stop_utc=2020-03-20T12:07:00Z", NULL, ANOTHER},
    {"orbit.circular.altitude_km=600.001", NULL, ANOTHER},
    {"orbit.circular.beta_deg=20.001", NULL, ANOTHER},
    {"attitude.0.lvlh.yaw_deg=0.01", NULL, ANOTHER},
    {"observer.direction.range_km=1001", NULL, ANOTHER},
    {"parts.wing.pose.position_m=[0,3.001,0]", NULL, BY_CHANCE}, /* too far to shade */
    {"parts.wing.pose.position_m=[0,1.2,0]", NULL, ANOTHER},
    {"parts.wing.plate.size_m=[2,1.001]", NULL, ANOTHER},
    {"parts.wing.joint.normal=[0,0.01,1]", NULL, ANOTHER},
    {"parts.box.facet_size_m=0.7", NULL, ANOTHER},
    {NULL, "emittance:grey_white,factor=0.9", COMPATIBLE},
    {NULL, "solar_absorptance:grey_panel", COMPATIBLE},
    {NULL, "roughness:grey_panel", COMPATIBLE},
    {NULL, "internal_power:box", COMPATIBLE},
    {NULL, "earthshine_level", COMPATIBLE},
    {NULL, "zero_point:vis", COMPATIBLE},
    {NULL, "albedo_level", ANOTHER},
    {NULL, "area:wing", ANOTHER},
    {NULL, "time_tag", ANOTHER},
    {NULL, "along_track", ANOTHER},
    {NULL, "attitude_offset,x_deg=1", ANOTHER},
    {NULL, "shadow_radius", BY_CHANCE}, /* full sunlight */
};
#define CHANGES (sizeof changes / sizeof changes[0])

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static void test_as_traced(void **state)
{
  (void)state;
  struct um_model *made = NULL;
  struct um_model_tables *own = NULL;
  size_t wrong = 0;
  FILE *file = fopen(FILE_NAME, "w");
  assert_non_null(file);
  fputs(scenario, file);
  fclose(file);
  need(um_model_create(context, FILE_NAME, NULL, &made));
  need(um_model_precompute(context, made, &own));
  for (size_t i = 0; i < CHANGES; i++) {
    struct um_model *model = NULL;
    struct um_model_tables *anew = NULL;
    const struct um_model_options options = {.overrides = &changes[i].set,
                                             .noverride = changes[i].set != NULL ? 1 : 0,
                                             .with = &changes[i].with,
                                             .nwith = changes[i].with != NULL ? 1 : 0};
    const char *name = changes[i].set != NULL ? changes[i].set : changes[i].with;
    bool compatible = false;
    if (um_model_create(context, FILE_NAME, &options, &model) != UM_OK)
      fail_msg("%s: %s", name, um_core_message(context));
    need(um_model_precompute(context, model, &anew));
    need(um_model_tables_are_compatible(context, made, own, NULL, model, &compatible));
    bool equal = traced_equal(own, anew);
    if (compatible != (changes[i].expected == COMPATIBLE) ||
        equal != (changes[i].expected != ANOTHER)) {
      print_error("%s: compatible %d, traced anew %d\n", name, compatible, equal);
      wrong++;
    }
    um_model_tables_destroy(context, &anew);
    um_model_destroy(context, &model);
  }
  um_model_tables_destroy(context, &own);
  um_model_destroy(context, &made);
  remove(FILE_NAME);
  assert_int_equal(wrong, 0);
}

static const struct um_environment_daylight one;

/* An Earth that varies, behind air, in the order of the members: one more, and it has no value here
 * (-Wmissing-field-initializers); it also wants a line below. */
static const struct um_environment every = {
    1361.0,
    UM_SPECTRUM_E490,
    5772.0,
    UM_EARTH_KNOCKE,
    NULL, /* map */
    0.3,
    237.0,
    270.0,
    1.0,
    1.0, /* longwave_factor */
    0.0,
    true, /* earth_spectrum_on */
    true, /* earth_anisotropy_on */
    &one, /* daylight */
    0.0,  /* mirror_cloud */
    {true, 0.1, 0.2, 0.3, 0.4, -INFINITY, INFINITY, 1.0, 1.1, 0.1, 1.1, 1.0, 2.0},
    6.4e6,
    UM_SHADOW_OBLATE,
    6.4e6,
    UM_DISC_LIMB_DARKENED,
    0.6, /* limb_darkening */
    true,
    NULL, /* limb */
    true,
    NULL, /* umbra_scatter */
    1.0,
    300.0,
    1.0,
    0.1,
    1.0,
    1.0e4, /* cloud_top */
    0.0,
    true,
    true,
    true,
    true,
    true,
    1.0,
    1.0, /* earth_reflection_factor */
    true,
    true,
    true,
    true,
    true,
    false, /* specular_exchange_on */
    true,
    true,
    0.0, /* gas_density_factor */
    {true, true, 290.0, 230.0, 10.0, 300.0, 0.1, 1.3, 1.0, 0.0, 230.0, NULL},
    true, /* bulk_by_temperature */
};
#define MEMBER(name, expected)                                                                     \
  {                                                                                                \
#name, offsetof(struct um_environment, name), sizeof every.name, expected                      \
  }
static const struct {
  const char *name;
  size_t offset, size;
  enum expected expected;
} members[] = {
    MEMBER(solar_irradiance, ANOTHER),
    MEMBER(spectrum, COMPATIBLE), /* .. of light and what materials absorb */
    MEMBER(solar_temperature, COMPATIBLE),
    MEMBER(earth, ANOTHER),
    MEMBER(map, ANOTHER),
    MEMBER(albedo, ANOTHER),
    MEMBER(outgoing_longwave, ANOTHER),
    MEMBER(brightness_temperature, ANOTHER),
    MEMBER(albedo_factor, ANOTHER),
    MEMBER(longwave_factor, ANOTHER),
    MEMBER(brightness_shift, ANOTHER),
    MEMBER(earth_spectrum_on, ANOTHER),
    MEMBER(earth_anisotropy_on, ANOTHER),
    MEMBER(daylight, COMPATIBLE), /* there is but one */
    MEMBER(mirror_cloud, COMPATIBLE),
    MEMBER(region.everywhere, ANOTHER),
    MEMBER(region.latitude, ANOTHER),
    MEMBER(region.longitude, ANOTHER),
    MEMBER(region.radius, ANOTHER),
    MEMBER(region.edge, ANOTHER),
    MEMBER(region.from_tai, ANOTHER),
    MEMBER(region.to_tai, ANOTHER),
    MEMBER(region.ramp, ANOTHER),
    MEMBER(region.albedo_factor, ANOTHER),
    MEMBER(region.albedo_offset, ANOTHER),
    MEMBER(region.longwave_factor, ANOTHER),
    MEMBER(region.longwave_offset, ANOTHER),
    MEMBER(region.brightness_shift, ANOTHER),
    MEMBER(earth_radius, ANOTHER),
    MEMBER(shadow, ANOTHER),
    MEMBER(shadow_radius, ANOTHER),
    MEMBER(disc, ANOTHER),
    MEMBER(limb_darkening, ANOTHER),
    MEMBER(shadow_refraction_on, ANOTHER),
    MEMBER(limb, ANOTHER),
    MEMBER(umbra_scatter_on, ANOTHER), /* rays to the Sun */
    MEMBER(umbra_scatter, COMPATIBLE), /* of the air, whose members are here */
    MEMBER(air_factor, ANOTHER),
    MEMBER(ozone_dobson, ANOTHER),
    MEMBER(ozone_factor, ANOTHER),
    MEMBER(haze, ANOTHER),
    MEMBER(aerosol, ANOTHER),
    MEMBER(cloud_top, ANOTHER),
    MEMBER(cloud_shift, ANOTHER),
    MEMBER(albedo_on, COMPATIBLE), /* switches and factors act behind the tables */
    MEMBER(planet_on, COMPATIBLE),
    MEMBER(earthshine_on, COMPATIBLE),
    MEMBER(earth_reflection_on, COMPATIBLE),
    MEMBER(moonlight_on, ANOTHER), /* rays to the Moon */
    MEMBER(earthshine_factor, COMPATIBLE),
    MEMBER(earth_reflection_factor, COMPATIBLE),
    MEMBER(earthlight_lobe_on, COMPATIBLE),
    MEMBER(multiple_scattering_on, COMPATIBLE),
    MEMBER(inter_reflection_on, COMPATIBLE),
    MEMBER(mutual_radiation_on, COMPATIBLE),
    MEMBER(solar_reflection_on, COMPATIBLE),
    MEMBER(specular_exchange_on, ANOTHER),    /* from off to on: there are no paths by mirrors */
    MEMBER(absorptance_by_angle, COMPATIBLE), /* laws of surfaces say so, by which moments are */
    MEMBER(emittance_by_temperature, COMPATIBLE),
    MEMBER(gas_density_factor, ANOTHER),
    MEMBER(sky, COMPATIBLE), /* of the station */
    MEMBER(bulk_by_temperature, COMPATIBLE),
};

static void test_every_member_of_the_light(void **state)
{
  (void)state;
  size_t wrong = 0;
  struct um_model *model = NULL;
  FILE *file = fopen(FILE_NAME, "w");
  assert_non_null(file);
  fputs(scenario, file);
  fclose(file);
  need(um_model_create(context, FILE_NAME, NULL, &model));
  struct um_model made = *model, moved = *model;
  made.environment = every;
  for (size_t m = 0; m < sizeof members / sizeof members[0]; m++)
    for (size_t byte = 0; byte < members[m].size; byte += sizeof(double)) {
      moved.environment = every;
      ((unsigned char *)&moved.environment)[members[m].offset + byte] ^= 1;
      if (um_model_light_is_compatible(&made, &moved) == (members[m].expected == COMPATIBLE))
        continue;
      print_error("%s: byte %zu\n", members[m].name, byte);
      wrong++;
    }
  /* an Earth that sends nothing is not traced: no view factors to reflect it by */
  um_environment_defaults(&made.environment);
  made.environment.albedo = made.environment.outgoing_longwave = 0.0;
  moved.environment = made.environment;
  made.environment.brightness_temperature = 0.0;
  assert_false(um_model_light_is_compatible(&made, &moved));
  moved.environment.brightness_temperature = 0.0;
  assert_true(um_model_light_is_compatible(&made, &moved));
  um_model_destroy(context, &model);
  remove(FILE_NAME);
  assert_int_equal(wrong, 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_as_traced),
                                     cmocka_unit_test(test_every_member_of_the_light)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
