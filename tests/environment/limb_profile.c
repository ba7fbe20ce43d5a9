/* What the air holds by height and latitude, against what satellites saw, and the way of rays
 * through it against another program. */
#include "environment/limb_air.h"

#include <string.h>

#include "base/core/constants.h"
#include "environment/environment.h"
#include "environment/standard_air.h"
#include "tests/environment/check.h"
#include "tests/support/reference.h"
#include "tests/support/with_context.h"

static struct um_environment_limb_profile profile_of(int zone)
{
  return um_environment_limb_standard((enum um_environment_limb_zone)zone);
}

/* Density between two heights [km], times 1 km, by steps of 10 m. */
static double between(int zone, enum um_environment_limb_constituent which, double from, double to)
{
  struct um_environment_limb_profile p = profile_of(zone);
  double sum = 0.0;
  for (double z = from + 0.005; z < to; z += 0.01) sum += 0.01 * p.density(p.self, which, 1e3 * z);
  return sum;
}

/* Ciddor 1996, table 1: dry air of 20 deg C, 100 kPa and 450 ppm at 633 nm has 26824.4e-8; by the
 * law of ideal gases, which is 6e-5 off there. Peck & Reeder 1972 at three wavelengths, 300 ppm:
 * 8e-5 less. */
static void refractivity(void **state)
{
  static const struct {
    double um, refractivity;
  } peck_reeder[] = {{0.4, 2.8275e-4}, {0.55, 2.7782e-4}, {1.0, 2.7415e-4}};
  (void)state;
  double cooler = (100e3 / 101325.0) * (288.15 / 293.15);
  check_near("Ciddor", um_environment_refractivity(633e-9) * cooler / 26824.4e-8, 1.0, 1e-4);
  for (size_t i = 0; i < 3; i++)
    check_near("Peck & Reeder",
               um_environment_refractivity(peck_reeder[i].um * 1e-6) / peck_reeder[i].refractivity,
               1.0, 1e-4);
}

static void zones(void **state)
{
  double share[UM_LIMB_ZONES];
  (void)state;
  um_environment_limb_zones(-10.0 * UM_DEG, share);
  check_near("tropics", share[UM_LIMB_TROPICAL], 1.0, 1e-12);
  um_environment_limb_zones(37.5 * UM_DEG, share);
  check_near("three quarters of the way", share[UM_LIMB_MIDDLE], 0.75, 1e-12);
  um_environment_limb_zones(-52.5 * UM_DEG, share);
  check_near("half way", share[UM_LIMB_HIGH], 0.5, 1e-12);
  um_environment_limb_zones(89.0 * UM_DEG, share);
  check_near("high", share[UM_LIMB_HIGH], 1.0, 1e-12);
}

/* Columns of SBUV to 1 DU, its layers above 25 km to 15 %: of the shapes of others. */
static void ozone_is_what_sbuv_saw(void **state)
{
  struct um_core_csv *csv = reference_open(context, "ozone-sbuv");
  double worst = 0.0;
  size_t layers = 0;
  (void)state;
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    int zone = (int)reference_number(context, csv, i, "zone");
    double from = reference_number(context, csv, i, "base_km");
    double to = reference_number(context, csv, i, "top_km");
    double seen = reference_number(context, csv, i, "ozone_DU");
    double ours = between(zone, UM_LIMB_OZONE, from, to);
    if (to > 99.0) {
      check_near("column", um_environment_limb_zone_ozone((enum um_environment_limb_zone)zone),
                 seen, 1.0);
      check_near("of the table", ours / seen, 1.0, 0.015);
    } else if (from > 25.0) {
      worst = fmax(worst, fabs(ours / seen - 1.0));
      layers++;
    }
  }
  um_core_csv_destroy(&csv);
  print_message("worst of %zu layers: %.0f %%\n", layers, 100.0 * worst);
  assert_true(layers == 24);
  check_below("layers", worst, 0.15);
}

/* Aerosol at the depth of um_environment_defaults within a factor of 1.6 of the typical profiles,
 * the mean of both hemispheres' logarithms at middle latitudes, and above the low ones. */
static void aerosol_is_what_sage_saw(void **state)
{
  struct um_core_csv *csv = reference_open(context, "aerosol-sage3");
  struct um_environment e;
  double whole[UM_LIMB_ZONES], typical[2][6] = {{0.0}}, worst = 0.0;
  (void)state;
  um_environment_defaults(&e);
  for (int z = 0; z < UM_LIMB_ZONES; z++) whole[z] = between(z, UM_LIMB_AEROSOL, 0.0, 130.0);
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    bool tropical = strcmp(reference_text(context, csv, i, "band"), "tropical") == 0;
    double km = reference_number(context, csv, i, "height_km");
    typical[tropical][(int)(km - 18.0) / 2] +=
        log(reference_number(context, csv, i, "typical")) * (tropical ? 1.0 : 0.5);
  }
  um_core_csv_destroy(&csv);
  for (int tropical = 0; tropical < 2; tropical++)
    for (int k = 0; k < 6; k++) {
      int zone = tropical ? UM_LIMB_TROPICAL : UM_LIMB_MIDDLE;
      struct um_environment_limb_profile p = profile_of(zone);
      double ours = e.aerosol / whole[zone] * p.density(p.self, UM_LIMB_AEROSOL, 18e3 + 2e3 * k);
      print_message("%d, %d km: %.2e, SAGE III %.2e 1/km\n", zone, 18 + 2 * k, ours,
                    exp(typical[tropical][k]));
      worst = fmax(worst, fabs(log(ours) - typical[tropical][k]));
    }
  check_below("factor", exp(worst), 1.6);
  /* of the troposphere, as SAGE I and II had it from 6 to 12 km: 7e-4 1/km */
  check_near("haze",
             e.haze / between(1, UM_LIMB_HAZE, 0.0, 60.0) * between(1, UM_LIMB_HAZE, 6, 12) / 6.0,
             7e-4, 2e-4);
}

/* The share of rays that reached 7 km (Woodbury & McCormick 1986): 30 % and 60 %, spread 2.5 km. */
static void clouds_are_what_sage_saw(void **state)
{
  (void)state;
  double tropics = um_environment_limb_zone_cloud(UM_LIMB_TROPICAL) - 7e3;
  double high = um_environment_limb_zone_cloud(UM_LIMB_HIGH) - 7e3;
  check_near("tropics", 0.5 * erfc(tropics / 2.5e3 / sqrt(2.0)), 0.3, 0.01);
  check_near("high latitudes", 0.5 * erfc(high / 2.5e3 / sqrt(2.0)), 0.6, 0.01);
}

/* Rays through the same air by sasktran2, straight and bent. Rayleigh's depth is Bates' there, 0.8
 * % below ours, and its layers are 250 m thick: 1.5 % of the depth above 4 km, 0.5 % of ozone. */
static void rays_are_those_of_another_program(void **state)
{
  static struct um_environment_limb_air straight, bent;
  const struct um_environment_limb_profile p = profile_of(UM_LIMB_MIDDLE);
  struct um_core_csv *csv = reference_open(context, "sasktran2-limb");
  double worst[2] = {0.0}, least = 0.0;
  (void)state;
  um_environment_limb_air_make(&p, UM_EARTH_RADIUS, &straight);
  um_environment_limb_air_bent(&p, UM_EARTH_RADIUS, &bent);
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    double km = reference_number(context, csv, i, "height_km"), depth[UM_LIMB_CONSTITUENTS];
    double through[2] = {reference_number(context, csv, i, "air_straight"),
                         reference_number(context, csv, i, "air_bent")};
    size_t k = (size_t)(2.0 * km + 0.5);
    um_environment_limb_depth(reference_number(context, csv, i, "wavelength_nm") * 1e-9, depth);
    double ours[2] = {depth[UM_LIMB_AIR] * straight.column[UM_LIMB_AIR][k],
                      depth[UM_LIMB_AIR] * bent.column[UM_LIMB_AIR][k]};
    for (int b = 0; b < 2; b++) {
      if (km > 4.0) check_near("depth", ours[b] / through[b], 1.0, 0.015);
      worst[b] = fmax(worst[b], fabs(exp(-ours[b]) - exp(-through[b])));
    }
    least = fmax(least, fabs(exp(-ours[0]) - exp(-through[1])));
    check_near("ozone",
               bent.column[UM_LIMB_OZONE][k] / reference_number(context, csv, i, "ozone_bent"), 1.0,
               5e-3);
  }
  um_core_csv_destroy(&csv);
  print_message("transmission: straight %.4f, bent %.4f; straight for bent %.4f\n", worst[0],
                worst[1], least);
  check_below("bent", worst[1], 0.006);
  assert_true(least > 0.03);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(refractivity),
      cmocka_unit_test(zones),
      cmocka_unit_test(ozone_is_what_sbuv_saw),
      cmocka_unit_test(aerosol_is_what_sage_saw),
      cmocka_unit_test(clouds_are_what_sage_saw),
      cmocka_unit_test(rays_are_those_of_another_program),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
