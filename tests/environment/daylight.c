/* What the sunlit Earth reflects by angle: layers against discrete ordinates (PythonicDISORT 1.8,
 * Ho 2024, J. Open Source Softw. 9:6442); energy; clear land against the angular distribution
 * models of CERES (Loeb et al. 2003, J. Appl. Meteor. 42:240; its table of land with trees and
 * shrubs, Sun at 70 to 80 deg); glint where the sea mirrors the Sun. */
#include "check.h"

#include "base/core/constants.h"
#include "environment/ground_view.h"
#include "environment/scatter_layer_impl.h"
#include "environment/zones.h"
#include "tests/environment/daylight_help.h"

static struct um_environment_daylight_pair pair(double sun, double view, double azimuth)
{
  return (struct um_environment_daylight_pair){cos(sun * UM_DEG), cos(view * UM_DEG),
                                               -cos(azimuth * UM_DEG)};
}

/* Drops of depth 8 that absorb nothing, asymmetry 0.85, over Lambert ground of 0.1: terms 0, 1 and
 * 4 in azimuth at four views, and the albedo, for two Suns. */
static void test_layers(void **state)
{
  (void)state;
  static const int node[4] = {2, 6, 10, 14}, sun[2] = {7, 12}, mode[3] = {0, 1, 4};
  static const double albedo[2] = {0.60140, 0.43586};
  static const double expected[3][2][4] = {
      {{0.87359, 0.81126, 0.55234, 0.42690}, {0.32724, 0.46472, 0.44558, 0.39269}},
      {{0.44662, 0.27352, 0.08880, 0.01840}, {0.04929, 0.05102, 0.02576, 0.00706}},
      {{0.07315, 0.01884, 0.00111, 0.00007}, {-0.00154, 0.00171, 0.00011, 0.00008}}};
  struct um_environment_scatter_phase drops = {.albedo = 1.0};
  for (int l = 0; l < UM_SCATTER_MODES; l++) drops.moment[l] = pow(0.85, l);
  for (int m = 0; m < 3; m++) {
    struct um_environment_scatter_layer cloud;
    struct um_environment_scatter_matrix ground = {{{0.0}}}, out;
    um_environment_scatter_thin(&drops, mode[m], ldexp(8.0, -16), &cloud);
    for (int k = 0; k < 16; k++) um_environment_scatter_double(&cloud);
    for (int i = 0; i < UM_SCATTER_NODES && m == 0; i++)
      for (int j = 0; j < UM_SCATTER_NODES; j++)
        ground.of[i][j] = 0.1 * um_environment_scatter_root(i) * um_environment_scatter_root(j);
    um_environment_scatter_over(&cloud, &ground, &out);
    for (int s = 0; s < 2; s++) {
      double root = um_environment_scatter_root(sun[s]), sum = 0.0, kept = 0.0;
      for (int v = 0; v < 4; v++)
        check_near("a term",
                   out.of[node[v]][sun[s]] / (root * um_environment_scatter_root(node[v])),
                   expected[m][s][v], 1.5e-5);
      for (int i = 0; i < UM_SCATTER_NODES; i++) {
        sum += um_environment_scatter_root(i) * out.of[i][sun[s]] / root;
        kept += um_environment_scatter_root(i) *
                (cloud.reflect.of[i][sun[s]] + cloud.pass.of[i][sun[s]]) / root;
      }
      if (m == 0) check_near("albedo", sum, albedo[s], 1.5e-5);
      if (m == 0) check_near("nothing is lost in the cloud", kept, 1.0, 1e-9);
    }
  }
}

/* Mean of the factor over the views, by a fine sum that knows no nodes. */
static double mean_over_views(const struct um_environment_daylight_place *place, double sun)
{
  enum { RINGS = 1000, AROUND = 96 };
  double sum = 0.0;
  for (int i = 0; i < RINGS; i++)
    for (int j = 0; j < AROUND; j++) {
      double view = (i + 0.5) / RINGS, weight = 2.0 * view / (RINGS * AROUND);
      struct um_environment_daylight_pair p = {sun, view, cos(UM_PI * (j + 0.5) / AROUND)};
      sum += weight * um_environment_daylight_factor(daylight, place, p);
    }
  return sum;
}

static void test_the_albedo_stays(void **state)
{
  (void)state;
  static const struct um_environment_ground places[] = {
      {0.10, 240.0, 285.0, 290.0, 0.0, 0.0, 0.10},  {0.25, 240.0, 285.0, 290.0, 0.0, 1.0, 0.25},
      {0.70, 240.0, 255.0, 255.0, 0.3, 0.5, 0.70},  {0.30, 240.0, 275.0, 288.0, 0.65, 0.29, 0.30},
      {0.50, 240.0, 275.0, 268.0, 0.8, 0.29, 0.50}, {0.95, 240.0, 285.0, 290.0, 1.0, 0.0, 0.95}};
  double worst = 0.0;
  for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
    struct um_environment_daylight_place place =
        um_environment_daylight_place(daylight, &places[k]);
    double all = 0.0;
    for (int s = 0; s < 5; s++) all += place.share[s];
    check_near("shares", all, 1.0, 1e-12);
    for (double sun = 0.0; sun <= 1.0; sun += 0.04)
      worst = fmax(worst, fabs(mean_over_views(&place, sun) - 1.0));
  }
  print_message("mean over the views: off by %.1e\n", worst);
  check_below("flux", worst, 1e-3);
}

/* Where cloud can, all scenes together have the albedo of the place. */
static void test_clouds_fit(void **state)
{
  (void)state;
  for (double albedo = 0.25; albedo < 0.6; albedo += 0.05) {
    const struct um_environment_ground ground = {albedo, 240.0, 275.0, 290.0, 0.7, 0.3, albedo};
    struct um_environment_daylight_place p = um_environment_daylight_place(daylight, &ground);
    double sum = 0.0;
    for (int k = 0; k < 3; k++) sum += p.share[k] * daylight->albedo[k];
    for (int k = 0; k < 2; k++)
      sum += p.share[3 + k] * daylight->albedo[UM_DAYLIGHT_CLOUD + p.cloud + k];
    check_near("albedo", sum, albedo, 1e-9);
  }
}

/* The angle between two bounds by cosines: the middle of the bins of CERES. */
static void test_land_of_ceres(void **state)
{
  (void)state;
  static const double azimuth[5] = {5, 40, 80, 120, 175};
  static const struct {
    double view, factor[5];
  } row[] = {{5, {0.5903, 0.5702, 0.5787, 0.5908, 0.6232}},
             {25, {0.6240, 0.6283, 0.6120, 0.6721, 0.7291}},
             {35, {0.7403, 0.6843, 0.6502, 0.7358, 0.8821}},
             {45, {0.8771, 0.7948, 0.7148, 0.8170, 1.0264}},
             {55, {1.1588, 1.0017, 0.8225, 0.9309, 1.2712}},
             {65, {1.5741, 1.3083, 0.9896, 1.1217, 1.6390}},
             {75, {2.3979, 2.0388, 1.3768, 1.3790, 1.9334}},
             {85, {4.3764, 3.4082, 1.8246, 2.1978, 2.5858}}};
  double sun = 75.0,
         flux = um_environment_daylight_flux(daylight, UM_DAYLIGHT_LAND, cos(sun * UM_DEG));
  double worst = 0.0, square = 0.0;
  for (size_t i = 0; i < 8; i++)
    for (int j = 0; j < 5; j++) {
      double ours = um_environment_daylight_reflectance(daylight, UM_DAYLIGHT_LAND,
                                                        pair(sun, row[i].view, azimuth[j])) /
                    flux;
      double off = ours / row[i].factor[j] - 1.0;
      worst = fmax(worst, fabs(off));
      square += off * off / 40.0;
    }
  print_message("land: off by %.3f rms, %.3f at most\n", sqrt(square), worst);
  check_below("rms", sqrt(square), 0.09);
  check_below("worst", worst, 0.26);
}

/* The brightest sea, seen from above, is where it mirrors the Sun. */
static void test_glint(void **state)
{
  (void)state;
  for (double sun = 10.0; sun <= 30.0; sun += 5.0) {
    double most = 0.0, at[2] = {0.0};
    for (double view = 0.0; view <= 50.0; view += 1.0)
      for (double azimuth = 0.0; azimuth <= 180.0; azimuth += 7.5) {
        double rho = um_environment_daylight_reflectance(daylight, UM_DAYLIGHT_SEA,
                                                         pair(sun, view, azimuth));
        if (rho > most) most = rho, at[0] = view, at[1] = azimuth;
      }
    print_message("Sun at %.0f deg: brightest at %.0f deg, azimuth %.1f\n", sun, at[0], at[1]);
    assert_true(at[1] == 0.0);
    check_near("its angle", at[0], sun + 2.0, 6.0); /* Fresnel's and the limb draw it outward */
  }
}

/* Over a planet of clear sea: the brightest place is the one whose zenith halves the angle between
 * Sun and satellite. */
static void test_glint_from_above(void **state)
{
  (void)state;
  struct um_environment e;
  const struct um_environment_globe globe = {0.0, {0, 0, 1}, {1, 0, 0}};
  const struct um_environment_ground ground = {0.1, 240.0, 285.0, 290.0, 0.0, 0.0, 0.1};
  um_environment_defaults(&e);
  e.earth = UM_EARTH_KNOCKE;
  e.daylight = daylight;
  struct um_environment_ground_view view = um_environment_ground_view(&e, &globe, UM_AU);
  struct um_vec3 sun = um_vec3_unit(um_vec3(0.8, 0.5, 0.33)), up = {1, 0, 0}, best = up, x, y;
  double most = 0.0;
  um_core_vec3_frame(up, &x, &y);
  for (double psi = 0.0; psi < 30.0; psi += 0.25)
    for (double phi = 0.0; phi < 360.0; phi += 1.0) {
      double s = sin(psi * UM_DEG);
      struct um_vec3 place =
          um_vec3_axpy(um_vec3_axpy(um_vec3_scale(up, cos(psi * UM_DEG)), s * cos(phi * UM_DEG), x),
                       s * sin(phi * UM_DEG), y);
      struct um_vec3 toward = um_vec3_unit(um_vec3_axpy(um_vec3_scale(place, -1.0), 1.3, up));
      if (um_vec3_dot(place, toward) < 0.6) continue;
      double factor = um_environment_ground_toward(&view, &ground, place, sun, toward);
      if (factor > most) most = factor, best = place;
    }
  struct um_vec3 toward = um_vec3_unit(um_vec3_axpy(um_vec3_scale(best, -1.0), 1.3, up));
  double off = um_vec3_angle(um_vec3_unit(um_vec3_add(toward, sun)), best) / UM_DEG;
  print_message("factor %.2f, the zenith %.1f deg beside the half of the angle\n", most, off);
  check_below("beside the mirror point", off, 4.0);
  e.earth_anisotropy_on = false;
  view = um_environment_ground_view(&e, &globe, UM_AU);
  assert_true(um_environment_ground_toward(&view, &ground, best, sun, toward) == 1.0);
  e.earth_anisotropy_on = true;
  e.earth = UM_EARTH_UNIFORM;
  assert_false(um_environment_earth_is_anisotropic(&e));
}

static void test_land_of_the_zones(void **state)
{
  (void)state;
  double sum = 0.0;
  for (int k = 0; k < 1800; k++)
    sum += um_environment_zone_land(asin(-1.0 + (k + 0.5) / 900.0)) / 1800.0;
  check_near("land", sum, 0.292, 0.005);
  check_near("40 to 50 deg north", um_environment_zone_land(45.0 * UM_DEG), 0.52, 1e-9);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_layers),
                                     cmocka_unit_test(test_the_albedo_stays),
                                     cmocka_unit_test(test_clouds_fit),
                                     cmocka_unit_test(test_land_of_ceres),
                                     cmocka_unit_test(test_glint),
                                     cmocka_unit_test(test_glint_from_above),
                                     cmocka_unit_test(test_land_of_the_zones)};
  return cmocka_run_group_tests(tests, daylight_set_up, daylight_tear_down);
}
