/* Shares of the Earth that a satellite covers of itself. The Earth's heat is the same everywhere,
 * its reflected light is not, so the two shares differ; a view factor is that of the heat:
 *
 *   planet = M F share_planet,  view factor = F share_planet,  albedo = E share_albedo
 *
 *            plate              The plate looks at nadir; the Sun stands low over +x, and the lit
 * part screen |  -----   | or here  of the Earth is there. |    |     | nadir       --> x, Sun */
#include "tests/thermal/body_help.h"
#include "thermal/loads/loads.h"

#define OLR    237.0
#define RADIUS 6378137.0

static struct um_environment environment;

/* The plate is 1 m square, in facets of a size [m]; a screen of 4 m square hangs down from its
 * level at x = side [m]. The Sun stands 100 deg from the zenith toward +x. */
static struct um_irradiation_loads *trace(double side, bool moves, double facet,
                                          struct help_satellite *s)
{
  help_part(s, "plate", UM_SHAPE_PLATE, "paint");
  s->shape[0].facet_size = facet;
  help_part(s, "screen", UM_SHAPE_PLATE, "paint");
  s->shape[1].size[0] = s->shape[1].size[1] = 4.0;
  s->shape[1].rotation = (struct um_quat){sqrt(0.5), 0.0, sqrt(0.5), 0.0};
  s->shape[1].position = um_vec3(side, 0, 2.0);
  if (moves) { /* rays instead of the sky */
    size_t p = help_part(s, "wheel", UM_SHAPE_DISC, "paint");
    s->shape[p].radius = 0.01;
    s->shape[p].position = um_vec3(0, 0, -50);
    s->shape[p].joint = UM_JOINT_SUN;
    s->shape[p].joint_axis = um_vec3(1, 0, 0);
    s->shape[p].joint_normal = um_vec3(0, 0, 1);
  }
  help_geometry(s);
  double zenith = 100.0 * UM_DEG;
  struct um_environment_sample sample = {.r = um_vec3(0, 0, -RADIUS - 800e3),
                                         .sun = um_vec3(sin(zenith), 0, -cos(zenith)),
                                         .sun_distance = UM_AU,
                                         .pole = {0.0, 0.0, 1.0},
                                         .sunlit_fraction = 1.0,
                                         .q = {1.0, 0.0, 0.0, 0.0}};
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_trace(help_context, s->geometry, &environment, &sample, 1, NULL, 0, 64,
                                &loads));
  return loads;
}

/* Mean over the plate's front. */
static double of_plate(const struct help_satellite *s, const float *value)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s->geometry);
  double sum = 0.0, area = 0.0;
  for (size_t i = 0; i < mesh->nsurface; i++) {
    if (mesh->surface[i].part != 0 || mesh->surface[i].back) continue;
    sum += value[i] * mesh->area[mesh->surface[i].facet];
    area += mesh->area[mesh->surface[i].facet];
  }
  return sum / area;
}

static void view_factor_is_that_of_the_heat(void **state)
{
  (void)state;
  for (int moves = 0; moves < 2; moves++) {
    struct help_satellite s[2];
    memset(s, 0, sizeof s);
    struct um_irradiation_loads *dark = trace(-1.0, moves == 1, 0.0, &s[0]);
    struct um_irradiation_loads *lit = trace(1.0, moves == 1, 0.0, &s[1]);
    struct um_irradiation_loads *both[2] = {dark, lit};
    for (int k = 0; k < 2; k++)
      for (size_t i = 0; i < both[k]->nsurface; i++)
        NEAR("view factor", both[k]->view_factor[i], both[k]->planet[i] / OLR, 2e-7);
    /* the screen takes the same heat from either side, but the light from the lit one alone */
    double heat[2] = {of_plate(&s[0], dark->planet), of_plate(&s[1], lit->planet)};
    double light[2] = {of_plate(&s[0], dark->albedo), of_plate(&s[1], lit->albedo)};
    print_message("heat %.4g and %.4g, light %.4g and %.4g W/m2, screen away from and at the Sun\n",
                  heat[0], heat[1], light[0], light[1]);
    NEAR("heat", heat[1] / heat[0], 1.0, 0.02);
    assert_true(heat[0] < 0.95 * OLR * 0.7893);
    assert_true(light[1] < 0.7 * light[0]);
    for (int k = 0; k < 2; k++) {
      um_irradiation_loads_destroy(help_context, &both[k]);
      help_end(&s[k]);
    }
  }
}

/* Facets of one normal are looked at side by side, and each takes what is its own: the nearer to
 * the screen, the less. */
static void facets_side_by_side(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  struct um_irradiation_loads *loads = trace(0.6, false, 0.35, &s);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s.geometry);
  struct um_geometry_pose *pose = NULL;
  double x[256], heat[256];
  size_t n = 0;
  OK(um_geometry_pose_create(help_context, s.geometry, NULL, &pose));
  for (size_t i = 0; i < mesh->nsurface && n < 256; i++) {
    if (mesh->surface[i].part != 0 || mesh->surface[i].back) continue;
    const uint32_t *c = mesh->corner[mesh->surface[i].facet];
    x[n] = (pose->vertex[c[0]].x + pose->vertex[c[1]].x + pose->vertex[c[2]].x) / 3.0;
    heat[n++] = (double)loads->planet[i];
  }
  assert_true(n > 16);
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j < n; j++) assert_true(x[j] < x[i] + 0.15 || heat[j] < heat[i]);
  um_geometry_pose_destroy(help_context, &pose);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

/* A plate stands nearly upright before the Earth, which it sees half of, along no axis, under a
 * roof that hides none of it: it takes what it takes alone, though of the directions around one
 * beside its own plane not all are before it.
 *
 *   ---------------  roof
 *       / plate                     nadir down  */
static void a_roof_hides_no_earth(void **state)
{
  (void)state;
  const struct um_environment same = environment;
  for (int varies = 0; varies < 2; varies++) {
    struct um_irradiation_loads *loads[2];
    struct help_satellite s[2];
    memset(s, 0, sizeof s);
    if (varies) environment.earth = UM_EARTH_KNOCKE;
    for (int roof = 0; roof < 2; roof++) {
      help_part(&s[roof], "plate", UM_SHAPE_PLATE, "paint");
      s[roof].shape[0].rotation = um_quat_then(um_quat_from_axis(um_vec3(0, 1, 0), 85.0 * UM_DEG),
                                               um_quat_from_axis(um_vec3(0, 0, 1), 37.0 * UM_DEG));
      if (roof) {
        help_part(&s[1], "roof", UM_SHAPE_PLATE, "paint");
        s[1].shape[1].size[0] = s[1].shape[1].size[1] = 4.0;
        s[1].shape[1].position = um_vec3(0, 0, -1.0);
      }
      help_geometry(&s[roof]);
      struct um_environment_sample sample = {.r = um_vec3(0, 0, -RADIUS - 800e3),
                                             .sun = um_vec3_unit(um_vec3(0.6, 0.2, -1.0)),
                                             .sun_distance = UM_AU,
                                             .pole = {0.0, 1.0, 0.0},
                                             .greenwich = {1.0, 0.0, 0.0},
                                             .sunlit_fraction = 1.0,
                                             .q = {1.0, 0.0, 0.0, 0.0}};
      OK(um_irradiation_loads_trace(help_context, s[roof].geometry, &environment, &sample, 1, NULL,
                                    0, 64, &loads[roof]));
    }
    assert_true(loads[0]->nsurface < loads[1]->nsurface && loads[0]->planet[0] > 30.0f);
    for (size_t i = 0; i < loads[0]->nsurface; i++) {
      NEAR("heat", loads[1]->planet[i], loads[0]->planet[i], 1e-4);
      NEAR("light", loads[1]->albedo[i], loads[0]->albedo[i], 1e-4);
      NEAR("view factor", loads[1]->view_factor[i], loads[0]->view_factor[i], 1e-6);
    }
    for (int k = 0; k < 2; k++) {
      um_irradiation_loads_destroy(help_context, &loads[k]);
      help_end(&s[k]);
    }
  }
  environment = same;
}

/* An Earth that neither reflects nor radiates brings nothing, and the Sun what it did. */
static void dark_earth(void **state)
{
  (void)state;
  struct help_satellite s = {0}, dark = {0};
  struct um_environment shining = environment;
  struct um_irradiation_loads *lit = trace(0.6, false, 0.0, &s);
  environment.albedo = environment.outgoing_longwave = environment.brightness_temperature = 0.0;
  struct um_irradiation_loads *unlit = trace(0.6, false, 0.0, &dark);
  environment = shining;
  for (size_t i = 0; i < lit->nsurface; i++) {
    assert_true(unlit->sun[i] == lit->sun[i] && unlit->incidence[i] == lit->incidence[i]);
    assert_true(unlit->albedo[i] == 0.0f && unlit->planet[i] == 0.0f);
  }
  assert_true(of_plate(&s, lit->planet) > 100.0);
  um_irradiation_loads_destroy(help_context, &lit);
  um_irradiation_loads_destroy(help_context, &unlit);
  help_end(&s);
  help_end(&dark);
}

static int setup(void **state)
{
  um_environment_defaults(&environment);
  environment.outgoing_longwave = OLR;
  environment.earth_radius = RADIUS;
  return help_setup(state);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(view_factor_is_that_of_the_heat), cmocka_unit_test(facets_side_by_side),
      cmocka_unit_test(a_roof_hides_no_earth), cmocka_unit_test(dark_earth)};
  return cmocka_run_group_tests(tests, setup, help_teardown);
}
