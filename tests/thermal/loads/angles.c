/* What surfaces absorb of the Earth by the angles at which it arrives, held against sums over the
 * cap that are made here: int alpha(theta) L cos theta dOmega, ray by ray.
 *
 *            plate              A screen hangs down beside the plate, which looks at nadir, and
 *             ----- |           hides of the Earth what stands low on that side.
 *                   | screen            --> x, Sun above          tests/thermal/loads/covered.c
 *                   |
 */
#include "environment/angular_moments.h"
#include "materials/materials.h"
#include "tests/thermal/body_help.h"
#include "tests/thermal/loads/region_help.h"
#include "thermal/loads/loads.h"

#define UM_TEST_LIBRARY UMBRA_SOURCE_DIR "/materials/library"
#define NODES           97
#define RADIUS          6378137.0
#define EARTH           254.0 /* black body that radiates what the Earth does [K] */

static struct um_environment environment;
static struct um_materials_library *library;

/* Absorptance of both bands at NODES of sqrt(cos), and their moments a_0 to a_5. */
struct law {
  double value[2][NODES], a[2][UM_ANGULAR_MOMENTS + 1];
};

static void law_of(const struct um_materials_record *record, struct law *law)
{
  for (int i = 0; i < NODES; i++) {
    double u = i / (NODES - 1.0);
    law->value[0][i] = um_materials_solar_absorptance_toward(record, NULL, u * u);
  }
  um_materials_emittance_by_angle(record, NULL, EARTH, NODES, law->value[1]);
  law->a[0][0] = um_materials_solar_absorptance_diffuse(record, NULL);
  law->a[1][0] = um_materials_emittance(record, NULL, EARTH);
  for (int b = 0; b < 2; b++) um_environment_angular_project(law->value[b], NODES, law->a[b] + 1);
}

static double absorptance(const double value[NODES], double cosine)
{
  double x = sqrt(cosine) * (NODES - 1);
  int i = x < NODES - 2 ? (int)x : NODES - 2;
  return value[i] + (x - i) * (value[i + 1] - value[i]);
}

static double by_moments(const double a[UM_ANGULAR_MOMENTS + 1], float load, const float *moment)
{
  double sum = a[0] * (double)load;
  for (int k = 0; k < UM_ANGULAR_MOMENTS; k++) sum += a[k + 1] * (double)moment[k];
  return sum;
}

/* Does the 4 m square at x = side, y within 2 m, 0 to 4 m below the plate, stand in the way? */
static bool hidden(double side, struct um_vec3 from, struct um_vec3 d)
{
  double t = (side - from.x) / d.x;
  return t > 0.0 && fabs(from.y + t * d.y) < 2.0 && from.z + t * d.z > 0.0 &&
         from.z + t * d.z < 4.0;
}

/* What a place reflects and emits: where nothing sets a region, the same everywhere. */
static void ground(struct um_vec3 place, double *albedo, double *longwave)
{
  const struct um_environment_region *r = &environment.region;
  double w =
      r->everywhere ? 0.0 : region_weight(r, um_vec3(0.0, 0.0, 1.0), um_vec3(1.0, 0.0, 0.0), place);
  *albedo = environment.albedo * (1.0 + w * (r->albedo_factor - 1.0));
  *longwave = environment.outgoing_longwave * (1.0 + w * (r->longwave_factor - 1.0));
}

/* Absorbed of albedo and of the Earth's radiation by areas of the cap [W/m^2]: plate in the plane
 * z = 0 with a given normal, nadir +z, Sun at `zenith` from -z toward x; side: of the screen,
 * infinite: none. points: across the plate of 1 m. */
static void by_areas(const struct law *law, double h, double zenith, struct um_vec3 normal,
                     double side, int n, int points, double out[2])
{
  double irradiance = um_environment_solar_irradiance(&environment, UM_AU), cap = acos(1.0 / h);
  struct um_vec3 sun = {sin(zenith), 0.0, -cos(zenith)};
  out[0] = out[1] = 0.0;
  for (int i = 0; i < n; i++) {
    double u = (i + 0.5) / n, psi = cap * u * u * (3.0 - 2.0 * u), s = sin(psi);
    double dpsi = cap * 6.0 * u * (1.0 - u) / n, dphi = UM_PI / n;
    for (int j = 0; j < 2 * n; j++) {
      double phi = dphi * (j + 0.5);
      struct um_vec3 at = {s * cos(phi), s * sin(phi), -cos(psi)};
      struct um_vec3 way = um_vec3_axpy(at, h, um_vec3(0, 0, 1)), d = um_vec3_unit(way);
      double d2 = um_vec3_dot(way, way), cosine = um_vec3_dot(d, normal);
      if (cosine <= 0.0) continue;
      double element = -um_vec3_dot(d, at) * cosine / d2 * s * dpsi * dphi / UM_PI;
      int seen = points > 0 ? 0 : 1;
      for (int p = 0; p < points * points; p++) {
        int row = p / points;
        struct um_vec3 from = {(p % points + 0.5) / points - 0.5, (row + 0.5) / points - 0.5, 0.0};
        seen += !hidden(side, from, d);
      }
      double free = points > 0 ? (double)seen / (points * points) : 1.0, albedo, longwave;
      ground(at, &albedo, &longwave);
      out[0] += free * element * absorptance(law->value[0], cosine) * albedo * irradiance *
                fmax(0.0, um_vec3_dot(at, sun));
      out[1] += free * element * absorptance(law->value[1], cosine) * longwave;
    }
  }
}

static struct um_irradiation_loads *trace(struct help_satellite *s, double altitude, double zenith,
                                          double tilt, double turn, double side, bool moves)
{
  size_t p = help_part(s, "plate", UM_SHAPE_PLATE, "paint");
  s->shape[p].rotation = um_quat_then(um_quat_from_axis(um_vec3(0, 1, 0), tilt),
                                      um_quat_from_axis(um_vec3(0, 0, 1), turn));
  if (isfinite(side)) {
    p = help_part(s, "screen", UM_SHAPE_PLATE, "paint");
    s->shape[p].size[0] = s->shape[p].size[1] = 4.0;
    s->shape[p].rotation = (struct um_quat){sqrt(0.5), 0.0, sqrt(0.5), 0.0};
    s->shape[p].position = um_vec3(side, 0, 2.0);
  }
  if (moves) { /* rays instead of the sky */
    p = help_part(s, "wheel", UM_SHAPE_DISC, "paint");
    s->shape[p].radius = 0.01;
    s->shape[p].position = um_vec3(0, 0, -50);
    s->shape[p].joint = UM_JOINT_SUN;
    s->shape[p].joint_axis = um_vec3(1, 0, 0);
    s->shape[p].joint_normal = um_vec3(0, 0, 1);
  }
  help_geometry(s);
  struct um_environment_sample sample = {.r = um_vec3(0, 0, -RADIUS - altitude),
                                         .sun = um_vec3(sin(zenith), 0, -cos(zenith)),
                                         .sun_distance = UM_AU,
                                         .pole = {0.0, 0.0, 1.0},
                                         .greenwich = {1.0, 0.0, 0.0},
                                         .sunlit_fraction = 1.0,
                                         .q = {1.0, 0.0, 0.0, 0.0}};
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_trace(help_context, s->geometry, &environment, &sample, 1, NULL, 0, 64,
                                &loads));
  return loads;
}

/* Every record of the library, any plate, against what a plate that faces the Earth and absorbs all
 * takes of it with the Sun overhead. */
static void plates_absorb_by_angle(void **state)
{
  (void)state;
  static const double altitude[] = {400e3, 765e3, 2000e3};
  double worst = 0.0, moved = 0.0;
  for (int a = 0; a < 3; a++)
    for (int z = 0; z <= 90; z += 45)
      for (int tilt = 0; tilt <= 150; tilt += 25) {
        struct help_satellite s = {0};
        double h = 1.0 + altitude[a] / RADIUS, zenith = z * UM_DEG, turn = 50.0 * UM_DEG;
        struct um_irradiation_loads *loads =
            trace(&s, altitude[a], zenith, tilt * UM_DEG, turn, INFINITY, false);
        struct um_geometry_pose *pose = NULL;
        OK(um_geometry_pose_create(help_context, s.geometry, NULL, &pose));
        struct um_vec3 normal = um_geometry_surface_normal(um_geometry_mesh(s.geometry), pose, 0);
        um_geometry_pose_destroy(help_context, &pose);
        NEAR("tilt", normal.z, cos(tilt * UM_DEG), 1e-12);
        double full[2], facing = um_environment_plate_view_factor(h, 0.0);
        full[0] =
            facing * environment.albedo * um_environment_solar_irradiance(&environment, UM_AU);
        full[1] = facing * environment.outgoing_longwave;
        for (size_t m = 0; m < um_materials_library_count(library); m++) {
          const struct um_materials_record *record = um_materials_library_at(library, m);
          struct law law;
          double expected[2];
          if (um_materials_is_grey(record)) continue;
          law_of(record, &law);
          by_areas(&law, h, zenith, normal, INFINITY, 200, 0, expected);
          double value[2] = {by_moments(law.a[0], loads->albedo[0], loads->albedo_moments),
                             by_moments(law.a[1], loads->planet[0], loads->planet_moments)};
          for (int b = 0; b < 2; b++) {
            NEAR(um_materials_name(record), value[b] / full[b], expected[b] / full[b], 1e-4);
            worst = fmax(worst, fabs(value[b] - expected[b]) / full[b]);
            double even = law.a[b][0] * (double)(b == 0 ? loads->albedo[0] : loads->planet[0]);
            moved = fmax(moved, fabs(value[b] - even) / full[b]);
          }
        }
        um_irradiation_loads_destroy(help_context, &loads);
        help_end(&s);
      }
  print_message("absorbed by angle: %.2g off at most, the angle moves up to %.2g\n", worst, moved);
  assert_true(moved > 0.02);
}

/* Absorbed by the plate's front [W/m^2], by angle and as if from all angles alike. */
static void plate_absorbs(const struct help_satellite *s, const struct um_irradiation_loads *loads,
                          const struct law *law, double out[2][2])
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s->geometry);
  double area = 0.0;
  memset(out, 0, 4 * sizeof out[0][0]);
  for (size_t i = 0; i < mesh->nsurface; i++) {
    if (mesh->surface[i].part != 0 || mesh->surface[i].back) continue;
    double of = mesh->area[mesh->surface[i].facet];
    const float load[2] = {loads->albedo[i], loads->planet[i]};
    const float *moment[2] = {loads->albedo_moments + i * UM_ANGULAR_MOMENTS,
                              loads->planet_moments + i * UM_ANGULAR_MOMENTS};
    for (int b = 0; b < 2; b++) {
      out[b][0] += of * by_moments(law->a[b], load[b], moment[b]);
      out[b][1] += of * law->a[b][0] * (double)load[b];
    }
    area += of;
  }
  for (int b = 0; b < 2; b++)
    for (int k = 0; k < 2; k++) out[b][k] /= area;
}

/* The plate's front is hidden from grazing light on one side: an eighth of its heat. The free share
 * of a direction is known to the cells of a sky, so absorbed heat is to 0.006 of that of a plate
 * with nothing before it; what the angle moves of it is known better. */
static void a_screen_hides_what_grazes(void **state)
{
  (void)state;
  const struct um_materials_record *record = um_materials_library_find(library, "osr");
  struct law law;
  assert_non_null(record);
  law_of(record, &law);
  struct law even = law;
  for (int b = 0; b < 2; b++)
    for (int i = 0; i < NODES; i++) even.value[b][i] = law.a[b][0];
  for (int moves = 0; moves < 2; moves++)
    for (int z = 0; z <= 60; z += 60) {
      struct help_satellite s = {0};
      double h = 1.0 + 800e3 / RADIUS, zenith = z * UM_DEG, expected[2], flat[2], sum[2][2];
      struct um_irradiation_loads *loads = trace(&s, 800e3, zenith, 0.0, 0.0, 0.6, moves == 1);
      plate_absorbs(&s, loads, &law, sum);
      by_areas(&law, h, zenith, um_vec3(0, 0, 1), 0.6, 150, 12, expected);
      by_areas(&even, h, zenith, um_vec3(0, 0, 1), 0.6, 150, 12, flat);
      for (int b = 0; b < 2; b++) {
        double moved = sum[b][0] - sum[b][1], want = expected[b] - flat[b];
        print_message("band %d: absorbed %.5g, want %.5g; of the angle %.4g, want %.4g W/m2\n", b,
                      sum[b][0], expected[b], moved, want);
        NEAR("absorbed", sum[b][0] / expected[b], 1.0, 0.01);
        NEAR("moved", moved / expected[b], want / expected[b], 1e-3);
      }
      um_irradiation_loads_destroy(help_context, &loads);
      help_end(&s);
    }
}

/* Half of the Earth, that behind the screen or the other, is dark and emits nothing. What a plate
 * absorbs that takes cos of what comes from an angle is told apart from what falls on it. */
static void a_varying_earth_behind_a_screen(void **state)
{
  (void)state;
  const struct um_environment same = environment;
  struct law law, even;
  for (int b = 0; b < 2; b++) {
    for (int i = 0; i < NODES; i++) law.value[b][i] = pow(i / (NODES - 1.0), 2.0);
    law.a[b][0] = 2.0 / 3.0; /* over the hemisphere */
    um_environment_angular_project(law.value[b], NODES, law.a[b] + 1);
  }
  even = law;
  for (int b = 0; b < 2; b++)
    for (int i = 0; i < NODES; i++) even.value[b][i] = law.a[b][0];
  for (int k = 0; k < 4; k++) {
    struct help_satellite s = {0};
    double h = 1.0 + 800e3 / RADIUS, zenith = 0.3, expected[2], flat[2], sum[2][2];
    environment.region = (struct um_environment_region){.latitude = -63.0 * UM_DEG,
                                                        .longitude = k & 1 ? UM_PI : 0.0,
                                                        .radius = 27.0 * UM_DEG,
                                                        .edge = 16.0 * UM_DEG,
                                                        .from_tai = -INFINITY,
                                                        .to_tai = INFINITY};
    struct um_irradiation_loads *loads = trace(&s, 800e3, zenith, 0.0, 0.0, 0.6, k > 1);
    plate_absorbs(&s, loads, &law, sum);
    by_areas(&law, h, zenith, um_vec3(0, 0, 1), 0.6, 60, 8, expected);
    by_areas(&even, h, zenith, um_vec3(0, 0, 1), 0.6, 60, 8, flat);
    for (int b = 0; b < 2; b++) {
      double full =
          um_environment_plate_view_factor(h, 0.0) *
          (b == 0 ? environment.albedo * um_environment_solar_irradiance(&environment, UM_AU)
                  : environment.outgoing_longwave);
      print_message("%s side, %s: absorbed %.4g, want %.4g; from all angles alike %.4g, %.4g\n",
                    k & 1 ? "open" : "hidden", b == 0 ? "light" : "heat", sum[b][0], expected[b],
                    sum[b][1], flat[b]);
      /* the cells of a sky, as above: half of the Earth has half of the error */
      NEAR("absorbed", sum[b][0] / full, expected[b] / full, 0.003);
      NEAR("from all angles alike", sum[b][1] / full, flat[b] / full, 0.003);
      NEAR("of the angle", (sum[b][0] - sum[b][1]) / full, (expected[b] - flat[b]) / full, 0.002);
    }
    um_irradiation_loads_destroy(help_context, &loads);
    help_end(&s);
  }
  environment = same;
}

/* Nobody asks for angles: nothing of them is kept, and the loads are what they are. */
static void nobody_asks(void **state)
{
  (void)state;
  struct help_satellite s[2];
  memset(s, 0, sizeof s);
  struct um_irradiation_loads *with = trace(&s[0], 8e5, 0.5, 0.4, 0.3, 0.8, false);
  environment.absorptance_by_angle = false;
  struct um_irradiation_loads *without = trace(&s[1], 8e5, 0.5, 0.4, 0.3, 0.8, false);
  environment.absorptance_by_angle = true;
  assert_true(without->albedo_moments == NULL && without->planet_moments == NULL);
  for (size_t i = 0; i < with->nsurface; i++)
    assert_true(with->albedo[i] == without->albedo[i] && with->planet[i] == without->planet[i] &&
                with->view_factor[i] == without->view_factor[i]);
  for (int k = 0; k < 2; k++) help_end(&s[k]);
  um_irradiation_loads_destroy(help_context, &with);
  um_irradiation_loads_destroy(help_context, &without);
}

static int setup(void **state)
{
  static struct um_materials_sun sun;
  um_environment_defaults(&environment);
  environment.earth_radius = RADIUS;
  um_environment_sun_shares(&environment, &sun);
  if (help_setup(state) != 0 || um_materials_library_create(help_context, &sun, &library) != UM_OK)
    return 1;
  return um_materials_library_read_folder(help_context, library, UM_TEST_LIBRARY) != UM_OK;
}

static int teardown(void **state)
{
  um_materials_library_destroy(&library);
  return help_teardown(state);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(plates_absorb_by_angle), cmocka_unit_test(a_screen_hides_what_grazes),
      cmocka_unit_test(a_varying_earth_behind_a_screen), cmocka_unit_test(nobody_asks)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
