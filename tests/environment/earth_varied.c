/* What an Earth that differs from place to place sends to plates.
 *
 * Knocke's Earth above ENVISAT's orbit by 2.9 million areas of the cap, computed independently
 * (docs/physics/loads.md); any plate against areas here; a whole sphere of plates round the Earth,
 * which receives all that it emits; a half of the Earth that is brighter than the other. */
#include "check.h"

#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/earth_infrared.h"
#include "environment/ground_view.h"
#include "environment/knocke.h"
#include "tests/environment/daylight_help.h"

#define DAY     86400.0
#define EQUINOX (6107.5 * DAY) /* 2016-09-21 0 h */

static const struct um_environment_globe globe = {
    .t_tai = EQUINOX, .pole = {0, 0, 1}, .greenwich = {1, 0, 0}};

static struct um_environment knocke(void)
{
  struct um_environment e;
  um_environment_defaults(&e);
  e.earth = UM_EARTH_KNOCKE;
  return e;
}

static struct um_environment_earth_flux flux(const struct um_environment *e,
                                             const struct um_environment_globe *g, struct um_vec3 r,
                                             struct um_vec3 sun, double distance,
                                             struct um_vec3 normal)
{
  struct um_environment_earth_flux out;
  um_environment_earth_flux(e, g, r, sun, distance, &normal, 1, &out);
  return out;
}

/* The definition, area by area over the cap, as in tests/environment/earth.c. */
static void by_areas(const struct um_environment_ground_view *view, struct um_vec3 up, double h,
                     struct um_vec3 sun, double irradiance, struct um_vec3 normal, int n,
                     struct um_environment_earth_flux *out)
{
  struct um_vec3 x, y;
  double cap = acos(1.0 / h), window = 0.0;
  um_core_vec3_frame(up, &x, &y);
  *out = (struct um_environment_earth_flux){0};
  for (int i = 0; i < n; i++) {
    double u = (i + 0.5) / n, psi = cap * u * u * (3.0 - 2.0 * u);
    double dpsi = cap * 6.0 * u * (1.0 - u) / n, dphi = UM_PI / n;
    for (int j = 0; j < 2 * n; j++) {
      double phi = dphi * (j + 0.5), s = sin(psi);
      struct um_vec3 ground =
          um_vec3_axpy(um_vec3_axpy(um_vec3_scale(up, cos(psi)), s * cos(phi), x), s * sin(phi), y);
      struct um_vec3 d = um_vec3_axpy(ground, -h, up);
      double d2 = um_vec3_dot(d, d), at_plate = um_vec3_dot(d, normal);
      if (at_plate <= 0.0) continue;
      double element = -um_vec3_dot(d, ground) * at_plate / (d2 * d2) * s * dpsi * dphi / UM_PI;
      struct um_environment_ground g = um_environment_ground_at(view, ground);
      double w = -um_vec3_dot(d, ground) / sqrt(d2);
      double limb = view->spectral ? um_environment_earth_limb(w) : 1.0;
      double anisotropy = view->spectral ? um_environment_earth_anisotropy(w) : 1.0;
      out->view_factor += element;
      out->planet += anisotropy * g.longwave * element;
      g.albedo *=
          um_environment_ground_toward(view, &g, ground, sun, um_vec3_scale(d, -1.0 / sqrt(d2)));
      out->albedo += g.albedo * irradiance * fmax(um_vec3_dot(ground, sun), 0.0) * element;
      window += limb * um_core_planck_radiance(10e-6, g.brightness) * element;
    }
  }
  out->brightness = window / fmax(out->view_factor, 1e-300); /* a radiance */
}

/* Nadir plate and mean over all plates, 765 km over 47.067 deg north at the equinox, the Sun 0.3787
 * deg north of the equator on the same meridian; and over the equator in midwinter, Sun overhead.
 */
static void knocke_table(void **state)
{
  (void)state;
  struct um_environment e = knocke();
  e.earth_spectrum_on = false;
  double r = UM_EARTH_RADIUS + 765e3, latitude = 47.067 * UM_DEG, distance = 1.0037221 * UM_AU;
  struct um_vec3 up = {cos(latitude), 0, sin(latitude)};
  struct um_vec3 sun = {cos(0.3787 * UM_DEG), 0, sin(0.3787 * UM_DEG)};
  struct um_environment_earth_flux nadir =
      flux(&e, &globe, um_vec3_scale(up, r), sun, distance, um_vec3_scale(up, -1.0));
  check_near("nadir, infrared", nadir.planet, 168.932, 1e-3);
  check_near("nadir, albedo", nadir.albedo, 307.092, 1e-2);
  double planet = 0.0, albedo = 0.0;
  enum { TILTS = 100, TURNS = 100 };
  static struct um_vec3 normal[TILTS * TURNS];
  static struct um_environment_earth_flux all[TILTS * TURNS];
  for (int i = 0; i < TILTS; i++)
    for (int j = 0; j < TURNS; j++) {
      double c = -1.0 + 2.0 * (i + 0.5) / TILTS, s = sqrt(1.0 - c * c);
      double phi = 2.0 * UM_PI * (j + 0.5) / TURNS;
      normal[i * TURNS + j] = um_vec3(s * cos(phi), s * sin(phi), c);
    }
  um_environment_earth_flux(&e, &globe, um_vec3_scale(up, r), sun, distance, normal, TILTS * TURNS,
                            all);
  for (int i = 0; i < TILTS * TURNS; i++)
    planet += all[i].planet / (TILTS * TURNS), albedo += all[i].albedo / (TILTS * TURNS);
  check_near("sphere, infrared", planet, 58.287, 5e-3);
  check_near("sphere, albedo", albedo, 105.031, 5e-3);

  struct um_environment_globe winter = globe;
  winter.t_tai = -6584.5 * DAY;
  nadir = flux(&e, &winter, um_vec3(r, 0, 0), um_vec3(1, 0, 0), UM_AU, um_vec3(-1, 0, 0));
  check_near("equator, infrared", nadir.planet, 208.108, 1e-3);
  check_near("equator, albedo", nadir.albedo, 214.158, 1e-2);
}

/* Any plate, any Sun, any place: 1e-3 of what a nadir plate gets; 5e-4 is measured. */
static void any_plate_before(bool spectral, const struct um_environment_daylight *by_angle)
{
  struct um_environment e = knocke();
  e.daylight = by_angle;
  e.earth_spectrum_on = spectral;
  const double altitude[] = {300e3, 765e3, 2000e3, 35786e3};
  double worst[3] = {0};
  for (int i = 0; i < 40; i++) {
    double h = 1.0 + altitude[i % 4] / UM_EARTH_RADIUS, c = cos(1.3 * i), s = sqrt(1.0 - c * c);
    double z = cos(0.7 * i), q = sqrt(1.0 - z * z);
    struct um_vec3 up = um_vec3(q * cos(2.1 * i), q * sin(2.1 * i), z);
    struct um_vec3 sun = um_vec3_unit(um_vec3(cos(0.9 * i), sin(0.9 * i), 0.4 * sin(1.0 * i)));
    struct um_vec3 normal = um_vec3(s * cos(3.1 * i), c, s * sin(3.1 * i));
    struct um_environment_ground_view view = um_environment_ground_view(&e, &globe, UM_AU);
    struct um_environment_earth_flux expected, got;
    by_areas(&view, up, h, sun, 1361.0, normal, 300, &expected);
    got = flux(&e, &globe, um_vec3_scale(up, h * UM_EARTH_RADIUS), sun, UM_AU, normal);
    double nadir = 1.0 / (h * h);
    worst[0] = fmax(worst[0], fabs(got.albedo - expected.albedo) / (0.34 * 1361.0 * nadir));
    worst[1] = fmax(worst[1], fabs(got.planet - expected.planet) / (231.0 * nadir));
    if (got.view_factor > 1e-3 * nadir)
      worst[2] =
          fmax(worst[2],
               fabs(um_core_planck_radiance(10e-6, got.brightness) / expected.brightness - 1.0));
  }
  print_message("largest differences from areas: albedo %.1e, infrared %.1e of a nadir plate; "
                "radiance in the window %.1e\n",
                worst[0], worst[1], worst[2]);
  check_below("albedo", worst[0], 1e-3);
  check_below("infrared", worst[1], 1e-3);
  check_below("window", worst[2], 1e-2); /* plates that see a sliver of the limb */
}

/* The cap as directions against the cap as cells: what plates get that stand any way. */
static void cap_is_the_same(void **state)
{
  (void)state;
  struct um_environment e = knocke();
  e.daylight = daylight;
  double worst = 0.0;
  for (int i = 0; i < 12; i++) {
    double h = 1.0 + 765e3 / UM_EARTH_RADIUS, z = cos(0.7 * i), q = sqrt(1.0 - z * z), sum = 0.0;
    struct um_vec3 up = um_vec3(q * cos(2.1 * i), q * sin(2.1 * i), z);
    struct um_vec3 sun = um_vec3_unit(um_vec3_axpy(up, 0.9, um_vec3(cos(i), sin(i), 0.2)));
    struct um_vec3 normal = um_vec3_unit(um_vec3_axpy(um_vec3(sin(i), 0.3, cos(i)), -1.5, up));
    struct um_vec3 r = um_vec3_scale(up, h * UM_EARTH_RADIUS);
    struct um_environment_cap_point cap[UM_EARTH_CAP_POINTS];
    size_t n = um_environment_earth_cap(&e, &globe, r, sun, UM_AU, cap);
    for (size_t k = 0; k < n; k++)
      sum += cap[k].albedo_radiance * cap[k].solid_angle *
             fmax(um_vec3_dot(cap[k].direction, normal), 0.0);
    double got = flux(&e, &globe, r, sun, UM_AU, normal).albedo;
    worst = fmax(worst, fabs(sum - got) / got);
  }
  print_message("128 directions against cells: %.1e\n", worst);
  check_below("albedo", worst, 0.03);
}

static void any_plate(void **state)
{
  (void)state;
  any_plate_before(false, NULL);
  any_plate_before(true, NULL);
  any_plate_before(true, daylight);
}

/* All that the Earth emits or reflects passes a sphere round it: with plates that face nadir,
 * r^2 <E> = R^2 <M>. <M> = 0.68 * 1361/4; with the Sun over the equator, and s the sine of the
 * latitude, <a cos SZA> = 1/pi int (0.34 + 0.29 P2(s)) sqrt(1 - s^2) ds/2 = 0.34/4 - 0.29/32. 7200
 * midpoints of the sphere meet the terminator to 1e-3. How it goes by angle changes nothing. */
static void power_balance_of(const struct um_environment_daylight *by_angle)
{
  struct um_environment e = knocke();
  e.daylight = by_angle;
  const double altitude[] = {400e3, 765e3, 35786e3};
  for (int k = 0; k < 3; k++) {
    double h = 1.0 + altitude[k] / UM_EARTH_RADIUS, planet = 0.0, albedo = 0.0;
    const int n = 60;
    for (int i = 0; i < n; i++)
      for (int j = 0; j < 2 * n; j++) {
        double s = -1.0 + (2.0 * i + 1.0) / n, c = sqrt(1.0 - s * s), l = UM_PI * (j + 0.5) / n;
        struct um_vec3 up = {c * cos(l), c * sin(l), s};
        struct um_environment_earth_flux f =
            flux(&e, &globe, um_vec3_scale(up, h * UM_EARTH_RADIUS), um_vec3(1, 0, 0), UM_AU,
                 um_vec3_scale(up, -1.0));
        planet += f.planet * h * h / (2.0 * n * n);
        albedo += f.albedo * h * h / (2.0 * n * n);
      }
    print_message("%g km: infrared %.6g, albedo %.6g W/m^2 in the mean\n", altitude[k] * 1e-3,
                  planet, albedo);
    check_near("infrared", planet, 0.68 * 1361.0 / 4.0, 231.37 * 1e-4);
    double reflected = 1361.0 * (0.34 / 4.0 - 0.29 / 32.0);
    check_near("albedo", albedo, reflected, reflected * 1.5e-3);
  }
}

static void power_balance(void **state)
{
  (void)state;
  power_balance_of(NULL);
  power_balance_of(daylight);
}

/* The same level everywhere is the uniform Earth, whatever the way it is said. */
static void uniform_is_uniform(void **state)
{
  (void)state;
  struct um_environment e, f;
  um_environment_defaults(&e);
  um_environment_defaults(&f);
  f.region.everywhere = true;
  f.region.albedo_factor = 0.5;
  f.region.longwave_offset = -100.0;
  f.region.brightness_shift = -10.0;
  e.albedo *= 0.5;
  e.outgoing_longwave -= 100.0;
  e.brightness_temperature -= 10.0;
  for (int i = 0; i < 50; i++) {
    double z = cos(1.1 * i), q = sqrt(1.0 - z * z);
    struct um_vec3 r = um_vec3_scale(um_vec3(q * cos(2.9 * i), q * sin(2.9 * i), z), 7.1e6);
    struct um_vec3 n = um_vec3_unit(um_vec3(cos(1.7 * i), sin(2.3 * i), cos(0.3 * i)));
    struct um_environment_earth_flux a = flux(&e, &globe, r, um_vec3(1, 0, 0), UM_AU, n);
    struct um_environment_earth_flux b = flux(&f, &globe, r, um_vec3(1, 0, 0), UM_AU, n);
    check_near("albedo", b.albedo, a.albedo, 1e-10);
    check_near("infrared", b.planet, a.planet, 1e-10);
    check_near("brightness", b.brightness, a.brightness, a.view_factor > 0.0 ? 1e-9 : 300.0);
    struct um_environment_cap_point x[UM_EARTH_CAP_POINTS], y[UM_EARTH_CAP_POINTS];
    size_t count = um_environment_earth_cap(&e, &globe, r, um_vec3(1, 0, 0), UM_AU, x);
    um_environment_earth_cap(&f, &globe, r, um_vec3(1, 0, 0), UM_AU, y);
    for (size_t k = 0; k < count; k++) {
      check_near("cap, albedo", y[k].albedo_radiance, x[k].albedo_radiance, 1e-10);
      check_near("cap, infrared", y[k].planet_radiance, x[k].planet_radiance, 1e-10);
    }
  }
}

/* One hemisphere of the Earth radiates twice what the other does. Above their border a nadir plate
 * gets the mean; a plate along the horizon toward the brighter half sees only that, its back only
 * the other. The border goes over in a degree: 5e-3 of the step is what cells of 11 deg cost. */
static void half_and_whole(void **state)
{
  (void)state;
  struct um_environment e;
  um_environment_defaults(&e);
  e.region = (struct um_environment_region){.longitude = 90 * UM_DEG,
                                            .radius = 90 * UM_DEG,
                                            .edge = 1 * UM_DEG,
                                            .from_tai = -INFINITY,
                                            .to_tai = INFINITY,
                                            .albedo_factor = 1.0,
                                            .longwave_factor = 2.0};
  double h = 1.0 + 765e3 / UM_EARTH_RADIUS, m = e.outgoing_longwave;
  struct um_vec3 r = {h * UM_EARTH_RADIUS, 0, 0}, sun = {0, 0, 1};
  double side = um_environment_plate_view_factor(h, 0.5 * UM_PI);
  check_near("nadir", flux(&e, &globe, r, sun, UM_AU, um_vec3(-1, 0, 0)).planet, 1.5 * m / (h * h),
             5e-3 * m);
  check_near("toward it", flux(&e, &globe, r, sun, UM_AU, um_vec3(0, 1, 0)).planet, 2.0 * m * side,
             5e-3 * m);
  check_near("away", flux(&e, &globe, r, sun, UM_AU, um_vec3(0, -1, 0)).planet, m * side, 5e-3 * m);
  struct um_vec3 over = {0, h * UM_EARTH_RADIUS, 0};
  check_near("over its middle", flux(&e, &globe, over, sun, UM_AU, um_vec3(0, -1, 0)).planet,
             2.0 * m / (h * h), 1e-10);
  check_near("over the rest",
             flux(&e, &globe, um_vec3_scale(over, -1.0), sun, UM_AU, um_vec3(0, 1, 0)).planet,
             m / (h * h), 1e-10);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(knocke_table),       cmocka_unit_test(cap_is_the_same),
      cmocka_unit_test(any_plate),          cmocka_unit_test(power_balance),
      cmocka_unit_test(uniform_is_uniform), cmocka_unit_test(half_and_whole),
  };
  return cmocka_run_group_tests(tests, daylight_set_up, daylight_tear_down);
}
