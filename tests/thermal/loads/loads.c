/* Orbital loads against exact answers: plates before the Earth, plates before each other, a sphere
 * in the Sun, panels that follow it. */
#include "thermal/loads/loads.h"
#include "tests/thermal/body_help.h"

static struct um_environment environment;

static int setup(void **state)
{
  um_environment_defaults(&environment);
  environment.outgoing_longwave = 237.0;
  environment.earth_radius = 6378137.0;
  return help_setup(state);
}

/* Satellite at `r` [m] from the geocentre, body axes along GCRS, Sun toward `sun`. */
static struct um_environment_sample sample_at(double t, struct um_vec3 r, struct um_vec3 sun)
{
  return (struct um_environment_sample){.t_tai = t,
                                        .r = r,
                                        .sun = um_vec3_unit(sun),
                                        .sun_distance = UM_AU,
                                        .pole = {0.0, 0.0, 1.0},
                                        .sunlit_fraction = 1.0,
                                        .q = {1.0, 0.0, 0.0, 0.0}};
}

static struct um_irradiation_loads *trace(const struct help_satellite *s,
                                          const struct um_environment_sample *samples, size_t n)
{
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_trace(help_context, s->geometry, &environment, samples, n, NULL, 0, 64,
                                &loads));
  return loads;
}

/* Area-weighted mean over the surfaces of a part and side. */
static double mean_of(const struct help_satellite *s, const float *value, uint32_t part, int back)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s->geometry);
  double sum = 0.0, area = 0.0;
  for (size_t i = 0; i < mesh->nsurface; i++) {
    if (mesh->surface[i].part != part || mesh->surface[i].back != back) continue;
    sum += value[i] * mesh->area[mesh->surface[i].facet];
    area += mesh->area[mesh->surface[i].facet];
  }
  return sum / area;
}

/* A plate whose front is tilted from nadir, h 400 to 35786 km (docs/physics/loads.md). Planet load
 * = F * OLR; six printed digits of F. Back: tilt pi - tilt. */
static void test_plate(void **state)
{
  (void)state;
  static const double f[3][5] = {{400e3, 0.885456, 0.660629, 0.288727, 0.034517},
                                 {765e3, 0.797278, 0.578861, 0.223367, 0.015101},
                                 {35786e3, 0.022882, 0.016180, 0.000740, 0.0}};
  for (int h = 0; h < 3; h++)
    for (int tilt = 0; tilt < 4; tilt++) {
      struct help_satellite s = {0};
      help_part(&s, "plate", UM_SHAPE_PLATE, "paint");
      help_geometry(&s);
      double lambda = tilt * 45.0 * UM_DEG; /* front normal is +z; nadir at lambda from it */
      struct um_vec3 r = um_vec3_scale(um_vec3(sin(lambda), 0, cos(lambda)),
                                       -(environment.earth_radius + f[h][0]));
      struct um_environment_sample sample = sample_at(0.0, r, um_vec3(0, 0, 1));
      struct um_irradiation_loads *loads = trace(&s, &sample, 1);
      double front = f[h][tilt + 1], back = tilt == 0 ? 0.0 : f[h][5 - tilt];
      if (tilt == 0) back = 0.0;
      NEAR("view factor", mean_of(&s, loads->view_factor, 0, 0), front, 1e-6);
      NEAR("planet load", mean_of(&s, loads->planet, 0, 0), 237.0 * front, 237e-6);
      if (tilt != 0 && tilt != 1) /* 135 and 90 deg have their mirror in the table */
        NEAR("back", mean_of(&s, loads->planet, 0, 1), 237.0 * back, 237e-6);
      um_irradiation_loads_destroy(help_context, &loads);
      help_end(&s);
    }
}

/* Albedo of a nadir plate at 765 km: E / (a S) = 0.788743, 0.394371, 0.030685 at solar zenith 0,
 * 60, 90 deg (docs/physics/loads.md; 1.3 M point quadrature); the environment's own accuracy is
 * 1e-4. */
static void test_albedo(void **state)
{
  (void)state;
  static const double expected[3][2] = {{0.0, 0.788743}, {60.0, 0.394371}, {90.0, 0.030685}};
  struct help_satellite s = {0};
  help_part(&s, "plate", UM_SHAPE_PLATE, "paint");
  help_geometry(&s);
  double full = environment.albedo * environment.solar_irradiance;
  for (int i = 0; i < 3; i++) {
    double z = expected[i][0] * UM_DEG;
    struct um_environment_sample sample = sample_at(
        0.0, um_vec3(0, 0, -environment.earth_radius - 765e3), um_vec3(sin(z), 0, -cos(z)));
    struct um_irradiation_loads *loads = trace(&s, &sample, 1);
    NEAR("albedo", mean_of(&s, loads->albedo, 0, 0) / full, expected[i][1], 1e-4);
    um_irradiation_loads_destroy(help_context, &loads);
  }
  help_end(&s);
}

/* Two unit plates, one above the other, half shifted; the Sun straight above: the lower one is half
 * in shadow. Facets end at the shadow's edge, so the sums are exact. A slanted Sun at 45 deg moves
 * the shadow by the height.
 *
 *        =====      z = 0.5
 *     =====         z = 0      */
static void test_shadow(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  for (int p = 0; p < 2; p++) {
    help_part(&s, p ? "upper" : "lower", UM_SHAPE_PLATE, "paint");
    s.shape[p].facet_size = 0.1 * sqrt(2.0);
    s.shape[p].position = p ? um_vec3(0.5, 0, 0.5) : um_vec3(0, 0, 0);
  }
  help_geometry(&s);
  struct um_vec3 r = um_vec3(0, 0, -7e6);
  struct um_environment_sample sample[3] = {sample_at(0, r, um_vec3(0, 0, 1)),
                                            sample_at(1, r, um_vec3(1, 0, 1)),
                                            sample_at(2, r, um_vec3(-1, 0, 1))};
  struct um_irradiation_loads *loads = trace(&s, sample, 3);
  size_t n = loads->nsurface;
  NEAR("Sun above", mean_of(&s, loads->sun, 0, 0), 0.5, 1e-6);
  NEAR("Sun above, upper", mean_of(&s, loads->sun + 0 * n, 1, 0), 1.0, 1e-6);
  NEAR("back is dark", mean_of(&s, loads->sun, 0, 1), 0.0, 0.0);
  NEAR("slanted, full shadow", mean_of(&s, loads->sun + n, 0, 0), 0.0, 1e-6);
  NEAR("slanted, no shadow", mean_of(&s, loads->sun + 2 * n, 0, 0), sqrt(0.5), 1e-6);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

/* Just above the ground the Earth fills the hemisphere; a unit plate at distance 1 in between takes
 * 0.199825 of it (Howell C-11): 0.800175 are left, less what the dip of the horizon by 1 deg takes,
 * 3e-4. Sky and cap have cells of 0.22 rad: the rim of the shade, 5 rad long, is some 24 pieces
 * each misplaced by up to half of half a cell (four looks per cell), rms 0.22 / sqrt(12) / 2 rad;
 * that is 0.22 * 0.032 * cos(45 deg) / pi * sqrt(24) = 0.008, twice that is accepted. Where a joint
 * moves, rays toward the same cap do the same. */
static void test_covered(void **state)
{
  (void)state;
  for (int moving = 0; moving < 2; moving++) {
    struct help_satellite s = {0};
    for (int p = 0; p < 2; p++) {
      help_part(&s, p ? "upper" : "lower", UM_SHAPE_PLATE, "paint");
      s.shape[p].facet_size = 0.25;
      s.shape[p].position = um_vec3(0, 0, p);
    }
    if (moving) {
      size_t p = help_part(&s, "wheel", UM_SHAPE_DISC, "paint");
      s.shape[p].radius = 0.01;
      s.shape[p].position = um_vec3(0, 0, 50);
      s.shape[p].joint = UM_JOINT_SUN;
      s.shape[p].joint_axis = um_vec3(1, 0, 0);
      s.shape[p].joint_normal = um_vec3(0, 0, 1);
    }
    help_geometry(&s);
    assert_int_equal(um_geometry_joint_moves(s.geometry), moving);
    struct um_environment_sample sample =
        sample_at(0, um_vec3(0, 0, -environment.earth_radius - 1e3), um_vec3(0.3, 0.2, -1));
    struct um_irradiation_loads *loads = trace(&s, &sample, 1);
    double lower = mean_of(&s, loads->view_factor, 0, 0);
    print_message("covered plate, %s: view factor %.4f (0.8002)\n", moving ? "rays" : "sky", lower);
    NEAR("lower plate", lower, 0.800175, 0.016);
    NEAR("lower plate, planet", mean_of(&s, loads->planet, 0, 0), 237.0 * lower, 1e-3);
    /* nearly uniform sunlight on the ground below: the same share of the albedo */
    double upper = mean_of(&s, loads->albedo, 1, 0);
    NEAR("lower plate, albedo", mean_of(&s, loads->albedo, 0, 0) / upper, lower, 0.016);
    um_irradiation_loads_destroy(help_context, &loads);
    help_end(&s);
  }
}

/* A sphere of area 4 pi r^2 catches pi r^2 of sunlight; the polyhedron's projected area averages
 * exactly that (Cauchy) and varies by less than 1 % at this fineness. */
static void test_sphere(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  help_part(&s, "ball", UM_SHAPE_SPHERE, NULL);
  s.shape[0].radius = 1.5;
  s.shape[0].facet_size = 0.4;
  help_geometry(&s);
  static const struct um_vec3 sun[3] = {{1, 0, 0}, {0.3, -0.5, 0.8}, {-1, 2, 3}};
  struct um_environment_sample sample[3];
  for (int i = 0; i < 3; i++) sample[i] = sample_at(i, um_vec3(0, 0, -7.143e6), sun[i]);
  struct um_irradiation_loads *loads = trace(&s, sample, 3);
  double area = 4.0 * UM_PI * 1.5 * 1.5;
  for (int i = 0; i < 3; i++)
    NEAR("projected area", mean_of(&s, loads->sun + (size_t)i * loads->nsurface, 0, 0) * area,
         0.25 * area, 0.0025 * area);
  double sphere = um_environment_sphere_view_factor(7.143e6 / environment.earth_radius);
  NEAR("Earth on a sphere", mean_of(&s, loads->view_factor, 0, 0), sphere, 0.005);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

/* A panel on a joint turns its front to the Sun at any direction: cosine of the rest, the angle
 * between the Sun and the plane of the joint. In deep eclipse the factor is left 0, within 120 s of
 * sunlight it is kept. */
static void test_joint_and_eclipse(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  help_part(&s, "array", UM_SHAPE_PLATE, "paint");
  s.shape[0].joint = UM_JOINT_SUN;
  s.shape[0].joint_axis = um_vec3(0, 1, 0);
  s.shape[0].joint_normal = um_vec3(0, 0, 1);
  help_geometry(&s);
  struct um_environment_sample sample[40];
  for (int i = 0; i < 40; i++) {
    double a = i * 9.0 * UM_DEG;
    sample[i] = sample_at(50.0 * i, um_vec3(0, 0, -7e6), um_vec3(sin(a), 0.5, cos(a)));
    sample[i].sunlit_fraction = i >= 10 && i < 20 ? 0.0 : 1.0;
  }
  struct um_irradiation_loads *loads = trace(&s, sample, 40);
  for (int i = 0; i < 40; i++) {
    bool deep = i >= 12 && i < 18; /* last light at 450 s, next at 1000 s */
    double sun = mean_of(&s, loads->sun + (size_t)i * loads->nsurface, 0, 0);
    NEAR("panel toward the Sun", sun, deep ? 0.0 : 1.0 / sqrt(1.25), 1e-6);
  }
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

/* The same bytes with 1 and 3 threads. */
static void test_threads(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  help_part(&s, "array", UM_SHAPE_PLATE, "paint");
  s.shape[0].facet_size = s.shape[1].facet_size = 0.4;
  s.shape[1].position = um_vec3(1.5, 0, 0);
  s.shape[1].joint = UM_JOINT_SUN;
  s.shape[1].joint_axis = um_vec3(1, 0, 0);
  s.shape[1].joint_normal = um_vec3(0, 0, 1);
  help_geometry(&s);
  struct um_environment_sample sample[50];
  for (int i = 0; i < 50; i++) {
    double a = i * 0.13;
    sample[i] = sample_at(10.0 * i, um_vec3(7e6 * cos(a), 7e6 * sin(a), 0), um_vec3(1, 0.4, 0.7));
  }
  struct um_irradiation_loads *loads[2];
  int threads = um_core_context_threads(help_context);
  for (int k = 0; k < 2; k++) {
    um_core_context_set_threads(help_context, 1 + 2 * k);
    loads[k] = trace(&s, sample, 50);
  }
  um_core_context_set_threads(help_context, threads);
  size_t bytes = 50 * loads[0]->nsurface * sizeof(float);
  assert_memory_equal(loads[0]->sun, loads[1]->sun, bytes);
  assert_memory_equal(loads[0]->albedo, loads[1]->albedo, bytes);
  assert_memory_equal(loads[0]->planet, loads[1]->planet, bytes);
  assert_memory_equal(loads[0]->view_factor, loads[1]->view_factor, bytes);
  for (int k = 0; k < 2; k++) um_irradiation_loads_destroy(help_context, &loads[k]);
  help_end(&s);
}

static void test_refused(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  help_part(&s, "plate", UM_SHAPE_PLATE, "paint");
  help_geometry(&s);
  struct um_irradiation_loads *loads = NULL;
  struct um_environment_sample sample[2] = {sample_at(0, um_vec3(7e6, 0, 0), um_vec3(1, 0, 0)),
                                            sample_at(0, um_vec3(7e6, 0, 0), um_vec3(1, 0, 0))};
  assert_int_equal(um_irradiation_loads_trace(help_context, s.geometry, &environment, sample, 2,
                                              NULL, 0, 64, &loads),
                   UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "is not after"));
  um_core_message_clear(help_context);
  sample[0].r.y = NAN;
  assert_int_equal(um_irradiation_loads_trace(help_context, s.geometry, &environment, sample, 1,
                                              NULL, 0, 64, &loads),
                   UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "sample 0"));
  assert_null(loads);
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_plate),   cmocka_unit_test(test_albedo),
      cmocka_unit_test(test_shadow),  cmocka_unit_test(test_covered),
      cmocka_unit_test(test_sphere),  cmocka_unit_test(test_joint_and_eclipse),
      cmocka_unit_test(test_threads), cmocka_unit_test(test_refused)};
  return cmocka_run_group_tests(tests, setup, help_teardown);
}
