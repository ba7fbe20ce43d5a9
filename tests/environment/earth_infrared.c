/* The Earth's infrared by wavelength and angle against LOWTRAN7's upward radiance
 * (tests/reference/lowtran7_upward.csv), its limb darkening against what was measured of the whole
 * Earth, and its parts against what they are made of. Zones against published means. */
#include "environment/earth_infrared.h"

#include <string.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/earth_seen.h"
#include "environment/environment.h"
#include "environment/ground_view.h"
#include "environment/zones.h"
#include "tests/environment/check.h"
#include "tests/support/reference.h"
#include "tests/support/with_context.h"

#define ROWS 29 /* wavelengths, every 15 1/cm */

/* Trapezoid over wavelength, which falls from row to row. */
static double band(const double *wavelength, const double *radiance)
{
  double sum = 0.0;
  for (int i = 1; i < ROWS; i++)
    sum += 0.5 * (radiance[i] + radiance[i - 1]) * (wavelength[i - 1] - wavelength[i]);
  return sum;
}

/* Water vapour is that of the profile in LOWTRAN7 and Stephens' mean over such ground in ours: 11 %
 * less over the tropics' ground, 12 % less over the standard's. */
static void lowtran(void **state)
{
  (void)state;
  struct um_core_csv *csv = reference_open(context, "lowtran7_upward");
  size_t rows = um_core_csv_rows(csv);
  double worst_band = 0.0, cold_band = 0.0, ozone_line = 0.0, sum = 0.0, black = 0.0;
  assert_int_equal(rows, 6 * 3 * ROWS);
  for (size_t first = 0; first < rows; first += ROWS) {
    double wavelength[ROWS], expected[ROWS], got[ROWS];
    double surface = reference_number(context, csv, first, "surface_K");
    double zenith = reference_number(context, csv, first, "zenith_deg");
    for (size_t i = 0; i < ROWS; i++) {
      wavelength[i] = reference_number(context, csv, first + i, "wavelength_um");
      expected[i] = reference_number(context, csv, first + i, "radiance_W_m2_sr_um");
      double at = wavelength[i] * 1e-6, b = um_core_planck_radiance(at, surface) * 1e-6;
      got[i] = 1e-6 * um_environment_earth_upward(at, surface, 0.0, surface, cos(zenith * UM_DEG));
      sum += fabs(got[i] - expected[i]);
      black += fabs(b - expected[i]);
      if (zenith == 0.0 && fabs(wavelength[i] - 9.6) < 0.15)
        ozone_line = fmax(ozone_line, fabs(got[i] / expected[i] - 1.0));
    }
    double miss = band(wavelength, got) / band(wavelength, expected) - 1.0;
    print_message("ground of %.1f K, %2.0f deg: 8-12 um %+.4f\n", surface, zenith, miss);
    double *worst = surface < 260.0 ? &cold_band : &worst_band;
    *worst = fmax(*worst, fabs(miss));
  }
  um_core_csv_destroy(&csv);
  print_message("a black body of the ground's temperature is off by %.1f times as much\n",
                black / sum);
  print_message("9.6 um toward the zenith within %.3f\n", ozone_line);
  check_below("9.6 um toward the zenith", ozone_line, 0.1);
  check_below("8-12 um", worst_band, 0.02);
  check_below("8-12 um, subarctic winter", cold_band, 0.025);
  check_below("of what the air changes", sum / black, 0.08);
}

static double clear_ratio(double from, double to, double temperature, double cosine)
{
  double clear, cloud;
  um_environment_earth_ratios(from, to, temperature, &cosine, 1, &clear, &cloud);
  return clear;
}

static double cloud_ratio(double from, double to, double temperature, double cosine)
{
  double clear, cloud;
  um_environment_earth_ratios(from, to, temperature, &cosine, 1, &clear, &cloud);
  return cloud;
}

/* The flux stays, and the zenith has 1.06 of its mean: ERBE's scanners along the track, 1.02 to
 * 1.09 and typically 1.06 (Smith et al. 1989). The band's limb is that of clear ground of 288 K and
 * cloud tops of 262 K, whose cover is the mean of the Earth. */
static void limbs(void **state)
{
  (void)state;
  double flux = 0.0, worst = 0.0, upright = 0.0;
  const int n = 100, bins = 40;
  for (int i = 0; i < n; i++) {
    double w = (i + 0.5) / n;
    flux += 2.0 * w * um_environment_earth_anisotropy(w) / n;
  }
  assert_close(flux, 1.0, 1e-4);
  assert_close(um_environment_earth_anisotropy(1.0), 1.06, 0.01);
  for (double w = 1.0; w > 0.1; w -= 0.1) {
    double sum = 0.0;
    for (int b = 0; b < bins; b++) {
      double from = 8e-6 + 4e-6 * b / bins, to = from + 4e-6 / bins;
      sum += 0.36 * clear_ratio(from, to, 288.0, w) * um_core_planck_band(from, to, 288.0) +
             0.64 * cloud_ratio(from, to, 262.0, w) * um_core_planck_band(from, to, 262.0);
    }
    if (w == 1.0) upright = sum;
    worst = fmax(worst, fabs(sum / upright - um_environment_earth_limb(w)));
  }
  check_below("limb in 8-12 um", worst, 0.005);
}

/* Over ozone the Earth is darker than through the window, and cloud tops show it less. */
static void ozone(void **state)
{
  (void)state;
  double clear = clear_ratio(9.5e-6, 9.7e-6, 288.0, 1.0);
  double window = clear_ratio(11e-6, 11.2e-6, 288.0, 1.0);
  double cloud = cloud_ratio(9.5e-6, 9.7e-6, 240.0, 1.0);
  print_message("clear %.3f, window %.3f, cloud %.3f\n", clear, window, cloud);
  assert_true(clear < 0.65 && window > 0.95 && cloud > clear + 0.1 && cloud < window);
  /* where nothing is known of the air it does nothing */
  assert_close(clear_ratio(3e-6, 5e-6, 250.0, 0.5), 1.0, 0.0);
  assert_close(um_environment_earth_upward(4e-6, 250.0, 0.0, 288.0, 0.5),
               um_core_planck_radiance(4e-6, 250.0), 0.0);
}

/* Ground and cloud together are as bright from above as the place is said to be. */
static void split_keeps_the_level(void **state)
{
  (void)state;
  double ratio[UM_EARTH_TEMPERATURES], worst = 0.0;
  um_environment_earth_window_fill(ratio);
  for (double surface = 215.0; surface < 316.0; surface += 20.0)
    for (double brightness = 180.0; brightness < 301.0; brightness += 10.0)
      for (double cloud = 0.0; cloud < 1.01; cloud += 0.25) {
        struct um_environment_ground g = {0.3, 237.0, brightness, surface, cloud, 0.29, 0.3};
        struct um_environment_ground_parts p = um_environment_ground_split(&g, ratio);
        double at = UM_EARTH_NADIR_WINDOW, place = um_core_planck_radiance(at, brightness);
        double clear = um_environment_earth_upward(at, p.surface, 0.0, p.surface, 1.0);
        double sum = (1.0 - p.cover) * clear + p.cover * um_core_planck_radiance(at, p.top);
        assert_true(p.cover >= 0.0 && p.cover <= 1.0 && p.top > 179.0 && p.top < 320.0);
        worst = fmax(worst, fabs(sum / place - 1.0));
      }
  print_message("radiance in the window within %.4f\n", worst);
  /* the ratio is linear between its nodes */
  check_below("radiance in the window", worst, 0.01);
}

/* A field that is linear between rings along every azimuth comes back; weights sum to 1. */
static void seen_interpolates(void **state)
{
  (void)state;
  struct um_environment e;
  um_environment_defaults(&e);
  e.earth = UM_EARTH_KNOCKE;
  const struct um_environment_globe globe = {5e8, {0, 0, 1}, {1, 0, 0}};
  static struct um_environment_earth_seen seen;
  struct um_vec3 r = um_vec3_scale(um_vec3_unit(um_vec3(0.3, 0.5, 0.8)), 7.1e6);
  struct um_vec3 sun = um_vec3_unit(um_vec3(1.0, 0.2, -0.1));
  um_environment_earth_seen(&e, &globe, r, sun, UM_AU, &seen);
  const struct um_environment_earth_axes *axes = &seen.axes;
  double sum = 0.0, worst = 0.0;
  for (int i = 0; i < UM_EARTH_SEEN_RINGS; i++) sum += seen.share[i];
  assert_close(sum, 1.0, 1e-12);
  for (int i = 0; i < 200; i++) {
    double y = (i + 0.5) / 200.0, phi = 0.37 * i;
    double w = um_environment_earth_seen_cosine(y * (UM_EARTH_SEEN_RINGS - 1)),
           se = sqrt(1.0 - w * w);
    double x = se / axes->h, z = sqrt(1.0 - x * x);
    struct um_vec3 to =
        um_vec3_axpy(um_vec3_axpy(um_vec3_scale(axes->nadir, z), x * cos(phi), axes->sunward),
                     x * sin(phi), axes->side);
    unsigned short node[4];
    double weight[4], all = 0.0, field = 0.0, surface = 0.0;
    um_environment_earth_seen_at(axes, to, node, weight);
    for (int k = 0; k < 4; k++) {
      all += weight[k];
      field += weight[k] * (node[k] / UM_EARTH_SEEN_AROUND);
      surface += weight[k] * seen.ground[node[k]].surface;
    }
    assert_close(all, 1.0, 1e-12);
    assert_close(field, y * (UM_EARTH_SEEN_RINGS - 1), 1e-6);
    /* the ground where the direction meets the sphere */
    double h = axes->h, t = h * z - sqrt(fmax(0.0, 1.0 - h * h * x * x));
    struct um_vec3 place = um_vec3_axpy(um_vec3_scale(axes->nadir, -h), t, to);
    struct um_environment_ground_view ground = um_environment_ground_view(&e, &globe, UM_AU);
    worst = fmax(worst, fabs(um_environment_ground_at(&ground, place).surface - surface));
  }
  print_message("temperature of the ground within %.2f K\n", worst);
  check_below("temperature of the ground", worst, 1.0); /* belts of 10 deg */
}

/* 14.0 deg C is the mean of 1961-1990 over the sphere and the year (Jones et al. 1999); cloud
 * covers 64.8 % of the sea (Warren et al. 1988, NCAR/TN-317). */
static void zones(void **state)
{
  (void)state;
  double surface = 0.0, cloud = 0.0;
  const int n = 180;
  for (int i = 0; i < n; i++)
    for (int m = 0; m < 12; m++) {
      double s, c, sine = (2.0 * i + 1.0) / n - 1.0;
      um_environment_zones(asin(sine), m, &s, &c);
      surface += s / (12.0 * n);
      cloud += c / (12.0 * n);
    }
  print_message("mean ground %.2f K, cover %.3f\n", surface, cloud);
  assert_close(surface, 287.15, 0.3);
  assert_close(cloud, 0.648, 0.02);
  double january, july, cover;
  um_environment_zones(65.0 * UM_DEG, 0.0, &january, &cover);
  um_environment_zones(65.0 * UM_DEG, 6.0, &july, &cover);
  assert_close(january, 251.0, 1e-9);
  assert_close(july, 283.0, 1e-9);
  double december, between;
  um_environment_zones(65.0 * UM_DEG, 11.0, &december, &cover);
  um_environment_zones(65.0 * UM_DEG, -0.5, &between, &cover);
  assert_close(between, 0.5 * (december + january), 1e-9);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(lowtran),
                                     cmocka_unit_test(limbs),
                                     cmocka_unit_test(ozone),
                                     cmocka_unit_test(split_keeps_the_level),
                                     cmocka_unit_test(seen_interpolates),
                                     cmocka_unit_test(zones)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
