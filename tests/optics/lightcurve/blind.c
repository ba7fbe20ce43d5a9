/* Optics alone against an independent simulator (sets b and d of the blind measurements, Python, no
 * common code): its face temperatures, albedo and Earth-IR loads go in, its irradiances by
 * mechanism must come out. Directions are our own: SGP4, frames, Sun, attitude, shadow.
 *
 * Accepted: 1e-4 of the value, wherever it is above 1 % of its peak. The reference tells five
 * digits of temperatures and loads, and leaves out the Sun's disc as roughness (4e-5 at the peak of
 * the lobe). Two of its own quadratures are coarser: the sunlit fraction in the penumbra (rays;
 * 2e-4 of the disc are added there) and the albedo over the Earth's cap, where its irradiances
 * scatter about its own printed loads by up to 0.8 % (here 1 %, of values above a tenth of the
 * peak). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "orbit/observer.h"
#include "orbit/sun.h"
#include "orbit/time.h"
#include "tests/optics/fixture.h"
#include "tests/support/reference.h"

#define OLR 237.0 /* [W/m^2] */

struct set {
  const char *name, *tle;
  double latitude, longitude, height; /* [deg], [deg], [m] */
  double ut1_utc, xp, yp;             /* [s], [arcsec] */
  struct um_quat body_to_gcrs;        /* zero: nadir */
  struct um_geometry_part_spec part;
  const char *const *face;  /* column names in the order of `group` */
  const char *const *group; /* NULL-terminated; a plate: front, back */
};

static size_t column(struct fixture *f, const struct um_core_csv *csv, const char *format,
                     const char *face)
{
  char name[64];
  snprintf(name, sizeof name, format, face);
  return reference_column(f->context, csv, name);
}

static double number(struct fixture *f, const struct um_core_csv *csv, size_t row, size_t at)
{
  double value;
  FIXTURE_OK(f, um_core_csv_number(f->context, csv, row, at, &value));
  return value;
}

/* Face of a surface: a plate has front and back, a box has groups. */
static size_t face_of(const struct fixture *f, const struct set *set, size_t surface)
{
  const struct um_geometry_surface *s = &um_geometry_mesh(f->geometry)->surface[surface];
  const char *name = um_geometry_group(f->geometry, s->group)->name;
  size_t i = 0;
  if (strcmp(name, "plate") == 0) return s->back;
  while (set->group[i] != NULL && strcmp(set->group[i], name) != 0) i++;
  assert_non_null(set->group[i]);
  return i;
}

static void fill_loads(struct fixture *f, const struct set *set, const struct um_core_csv *csv)
{
  size_t n = um_geometry_mesh(f->geometry)->nsurface;
  for (size_t s = 0; s < n; s++) {
    const char *face = set->face[face_of(f, set, s)];
    size_t temperature = column(f, csv, "temperature_%s_K", face);
    size_t albedo = column(f, csv, "albedo_%s_W_m2", face);
    size_t planet = column(f, csv, "earth_ir_%s_W_m2", face);
    for (size_t t = 0; t < f->ntime; t++) {
      f->temperature[t * n + s] = number(f, csv, t, temperature);
      f->albedo[t * n + s] = (float)fmax(0.0, number(f, csv, t, albedo));
      f->view_factor[t * n + s] = (float)fmax(0.0, number(f, csv, t, planet) / OLR);
    }
  }
}

static void fill_samples(struct fixture *f, const struct set *set, const struct um_core_csv *csv)
{
  struct um_orbit_earth_orientation orientation = {set->ut1_utc, set->xp * UM_ARCSEC,
                                                   set->yp * UM_ARCSEC, NULL, NULL};
  struct um_orbit_tle tle;
  struct um_orbit_trajectory *trajectory;
  FIXTURE_OK(f, um_orbit_tle_parse(f->context, set->tle, 1, &tle));
  FIXTURE_OK(f, um_orbit_trajectory_create_tle(f->context, &tle, &orientation, &trajectory));
  struct um_orbit_observer station = {.kind = UM_OBSERVER_STATION,
                                      .latitude = set->latitude * UM_DEG,
                                      .longitude = set->longitude * UM_DEG,
                                      .height = set->height,
                                      .orientation = orientation};
  for (size_t t = 0; t < f->ntime; t++) {
    struct um_environment_sample *s = &f->samples[t];
    struct um_orbit_look look;
    FIXTURE_OK(f, um_orbit_time_parse(f->context, um_core_csv_text(csv, t, 0), &s->t_tai));
    FIXTURE_OK(f, um_orbit_observer_look(f->context, &station, trajectory, s->t_tai, &look));
    s->r = look.r_gcrs;
    s->v = look.v_gcrs;
    s->to_observer = look.to_observer;
    s->range = look.range;
    /* seen from the geocentre's frame: aberration by the satellite's own motion would move the limb
     * of the Earth along with the Sun */
    um_orbit_sun_apparent(NULL, s->t_tai, s->r, um_vec3(0.0, 0.0, 0.0), &s->sun, &s->sun_distance);
    struct um_mat3 itrf;
    FIXTURE_OK(f, um_orbit_frames_gcrs_to_itrf(f->context, &orientation, s->t_tai, &itrf));
    s->pole = um_vec3(itrf.m[2][0], itrf.m[2][1], itrf.m[2][2]);
    s->sunlit_fraction =
        um_environment_sunlit_fraction(&f->environment, s->r, s->sun, s->sun_distance, s->pole);
    if (set->body_to_gcrs.w != 0.0) {
      s->q = set->body_to_gcrs; /* turning vectors to GCRS is the passive rotation from it */
    } else {
      struct um_vec3 z = um_vec3_scale(um_vec3_unit(s->r), -1.0);
      struct um_vec3 y = um_vec3_scale(um_vec3_unit(um_vec3_cross(s->r, s->v)), -1.0);
      s->q = um_core_quat_from_matrix(um_mat3_from_axes(um_vec3_cross(y, z), y, z));
    }
  }
  um_orbit_trajectory_destroy(&trajectory);
}

struct column_check {
  const char *column;
  enum um_optics_mechanism mechanism;
  double accepted; /* relative */
  double floor;    /* of the peak, below which rows are not compared */
};

static void compare(struct fixture *f, const struct um_core_csv *csv,
                    const struct column_check *check)
{
  double peak = 0.0, worst = 0.0;
  size_t a = reference_column(f->context, csv, check->column), count = 0;
  for (size_t t = 0; t < f->ntime; t++) peak = fmax(peak, number(f, csv, t, a));
  for (size_t t = 0; t < f->ntime; t++) {
    double expected = number(f, csv, t, a);
    double fraction = f->samples[t].sunlit_fraction, range = f->samples[t].range;
    double value = fixture_intensity(f, t, 0, check->mechanism) / (range * range);
    bool sun = check->mechanism == UM_MECHANISM_SUN;
    if (sun && fraction == 0.0) assert_true(value == 0.0 && expected == 0.0);
    if (!(expected > check->floor * peak)) continue;
    double penumbra = sun && fraction < 1.0 ? 2e-4 / fraction : 0.0;
    double error = fabs(value / expected - 1.0) / (check->accepted + penumbra);
    worst = fmax(worst, error);
    assert_true(error <= 1.0);
    count++;
  }
  print_message("  %-26s peak %.4g W/m^2, %zu rows, worst at %.2f of what is accepted (%.0e)\n",
                check->column, peak, count, worst, check->accepted);
  assert_true(count > 20);
}

static void run_set(struct fixture *f, const struct set *set)
{
  char name[16];
  snprintf(name, sizeof name, "blind-%s", set->name);
  struct um_core_csv *csv = reference_open(f->context, name);
  f->environment.spectrum = UM_SPECTRUM_BLACK_BODY;
  f->environment.solar_temperature = 5772.0;
  f->environment.brightness_temperature = 270.0;
  f->environment.shadow = UM_SHADOW_OBLATE;
  f->environment.disc = UM_DISC_UNIFORM;
  f->environment.earthlight_lobe_on = false; /* the reference reflects the Earth diffusely */
  fixture_scene(f, &set->part, 1, um_core_csv_rows(csv));
  fill_samples(f, set, csv);
  fill_loads(f, set, csv);
  print_message("set %s\n", set->name);
  static const struct column_check vis[] = {{"vis_sun_W_m2", UM_MECHANISM_SUN, 1e-4, 0.01},
                                            {"vis_earth_W_m2", UM_MECHANISM_EARTH, 1e-2, 0.1}};
  static const struct column_check lwir[] = {
      {"lwir_emitted_W_m2", UM_MECHANISM_EMITTED, 1e-5, 0.01},
      {"lwir_earth_W_m2", UM_MECHANISM_EARTH, 1e-5, 0.01},
      {"lwir_sun_W_m2", UM_MECHANISM_SUN, 1e-4, 0.01}};
  fixture_run(f, 1, &fixture_vis, 1);
  for (int i = 0; i < 2; i++) compare(f, csv, &vis[i]);
  f->environment.earthshine_on = false; /* the reference has none in 8-12 um */
  fixture_run(f, 1, &fixture_lwir, 1);
  for (int i = 0; i < 3; i++) compare(f, csv, &lwir[i]);
  um_core_csv_destroy(&csv);
  fixture_destroy(f);
}

/* A nadir-pointing box of five materials. */
static void test_box(void **state)
{
  (void)state;
  static const char *const groups[] = {"+x", "-x", "+y", "-y", "+z", "-z", NULL};
  static const struct um_geometry_skin skins[] = {{"+x", "mli", NULL},   {"-x", "mli", NULL},
                                                  {"+y", "side", NULL},  {"-y", "cfrp", NULL},
                                                  {"+z", "white", NULL}, {"-z", "cell", NULL}};
  struct set set = {.name = "b",
                    .tle =
                        "1 99901U 00000A   19204.50000000  .00000000  00000-0  00000-0 0  9999\n"
                        "2 99901  97.7900 130.0000 0012000  90.0000   0.0000 14.90000000    13\n",
                    .latitude = 47.067,
                    .longitude = 15.493,
                    .height = 495.0,
                    .ut1_utc = -0.17,
                    .xp = 0.21,
                    .yp = 0.4,
                    .part = {.name = "box",
                             .shape = UM_SHAPE_BOX,
                             .size = {0.9, 0.8, 0.7},
                             .rotation = {1.0, 0.0, 0.0, 0.0},
                             .skins = skins,
                             .nskin = 6},
                    .face = groups,
                    .group = groups};
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "mli", 0.62, 0.0, 0.0, 0.76);
  fixture_material(&f, "side", 0.8, 0.0, 0.0, 0.9);
  fixture_material(&f, "white", 0.8, 0.0, 0.0, 0.9);
  fixture_material(&f, "cfrp", 0.07, 0.03, 0.326, 0.83);
  fixture_material(&f, "cell", 0.06, 0.04, 0.265, 0.85);
  run_set(&f, &set);
}

/* A solar array at rest in inertial space that comes out of the shadow. */
static void test_plate(void **state)
{
  (void)state;
  static const char *const faces[] = {"front", "back", NULL};
  static const struct um_geometry_skin skin = {NULL, "cell", "black"};
  struct set set = {.name = "d",
                    .tle =
                        "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
                        "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n",
                    .latitude = 48.749,
                    .longitude = 9.103,
                    .height = 533.0,
                    .ut1_utc = -0.267794024,
                    .xp = 0.23662075,
                    .yp = 0.35128994,
                    .body_to_gcrs = {0.4172552333, 0.1977130683, -0.8015843504, -0.3798290959},
                    .part = {.name = "array",
                             .shape = UM_SHAPE_PLATE,
                             .size = {14.0, 4.6, 0.0},
                             .rotation = {1.0, 0.0, 0.0, 0.0},
                             .skins = &skin,
                             .nskin = 1},
                    .face = faces,
                    .group = faces};
  struct fixture f;
  fixture_create(&f);
  fixture_material(&f, "cell", 0.06, 0.04, 0.265, 0.85);
  fixture_material(&f, "black", 0.06, 0.0, 0.0, 0.9);
  run_set(&f, &set);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_box),
      cmocka_unit_test(test_plate),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
