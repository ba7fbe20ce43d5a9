/* Heat of the atmosphere: densities against the printed table, a plate at 200 km against rho v^3 /
 * 2 cos, what stands behind another plate, the temperature it holds. Loads are floats: 6e-8. */
#include "environment/atmosphere.h"
#include "tests/thermal/body_help.h"
#include "thermal/loads/loads.h"

#define EQUATOR 6378137.0
#define RATE    7.292115e-5 /* of the Earth [rad/s] */

static struct um_environment environment;

/* Vallado 2013, table 8-4, at its own heights to its digits; between them with the scale height it
 * gives, example at 747.2119 km: 2.1219854e-14 kg/m3, printed in the text beside the table. */
static void densities_are_those_printed(void **state)
{
  (void)state;
  static const double row[][2] = {{0, 1.225},        {100, 5.297e-7},          {200, 2.789e-10},
                                  {400, 3.725e-12},  {600, 1.454e-13},         {700, 3.614e-14},
                                  {1000, 3.019e-15}, {747.2119, 2.1219854e-14}};
  for (size_t k = 0; k < sizeof row / sizeof row[0]; k++)
    NEAR("density", um_environment_atmosphere_density(row[k][0] * 1e3) / row[k][1], 1.0, 1e-7);
  NEAR("below the ground", um_environment_atmosphere_density(-5.0), 1.225, 0.0);
}

/* Two square plates, 1 m behind 2 m, facing +x; the satellite moves along it, turned by angle about
 * z. Flying east over the equator at 200 km, the air turns with the Earth. */
static struct um_irradiation_loads *trace(double angle, struct help_satellite *s)
{
  const double half = sqrt(0.5);
  help_part(s, "plate", UM_SHAPE_PLATE, "paint");
  help_part(s, "shield", UM_SHAPE_PLATE, "paint");
  for (int k = 0; k < 2; k++) s->shape[k].rotation = (struct um_quat){half, 0.0, half, 0.0};
  s->shape[1].size[0] = s->shape[1].size[1] = 2.0;
  s->shape[1].position = um_vec3(1.0, 0, 0);
  help_geometry(s);
  struct um_environment_sample sample = {.r = um_vec3(0, EQUATOR + 200e3, 0),
                                         .v = um_vec3(-7784.0, 0, 0),
                                         .sun = um_vec3(0, 0, 1),
                                         .sun_distance = UM_AU,
                                         .pole = {0.0, 0.0, 1.0},
                                         .q = {cos(0.5 * angle), 0.0, 0.0, sin(0.5 * angle)}};
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_trace(help_context, s->geometry, &environment, &sample, 1, NULL, 0, 16,
                                &loads));
  return loads;
}

static double of_side(const struct help_satellite *s, const float *gas, uint32_t part, int back)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s->geometry);
  double sum = 0.0, area = 0.0;
  for (size_t i = 0; i < mesh->nsurface; i++) {
    if (mesh->surface[i].part != part || mesh->surface[i].back != (back != 0)) continue;
    sum += (double)gas[i] * mesh->area[mesh->surface[i].facet];
    area += mesh->area[mesh->surface[i].facet];
  }
  return sum / area;
}

/* The motion is along -x of GCRS: at 180 deg the fronts face it and the shield is ahead, at 0 deg
 * the backs do and the small plate shades a quarter of the shield; at 240 deg 60 deg off, and the
 * shadow has passed by 1.73 m. Shares of the shadow: 4 x 4 points a facet, a tenth. */
static void plates_face_the_motion(void **state)
{
  (void)state;
  double v = 7784.0 - RATE * (EQUATOR + 200e3);
  double full = 0.9 * 0.5 * 2.789e-10 * v * v * v;
  environment.gas_density_factor = 0.9;
  for (int k = 0; k < 3; k++) {
    const double angle[3] = {UM_PI, 0.0, 4.0 * UM_PI / 3.0};
    struct help_satellite s = {0};
    struct um_irradiation_loads *loads = trace(angle[k], &s);
    assert_non_null(loads->gas);
    double plate[2], shield[2];
    for (int b = 0; b < 2; b++) {
      plate[b] = of_side(&s, loads->gas, 0, b) / full;
      shield[b] = of_side(&s, loads->gas, 1, b) / full;
    }
    print_message("plate %.4f %.4f, shield %.4f %.4f of %.3f W/m2\n", plate[0], plate[1], shield[0],
                  shield[1], full);
    NEAR("plate's front", plate[0], k == 2 ? 0.5 : 0.0, 2e-7);
    NEAR("plate's back", plate[1], k == 1 ? 1.0 : 0.0, 2e-7);
    NEAR("shield's front", shield[0], k == 0 ? 1.0 : k == 2 ? 0.5 : 0.0, 2e-7);
    NEAR("shield's back", shield[1], k == 1 ? 0.75 : 0.0, k == 1 ? 0.1 : 0.0);
    um_irradiation_loads_destroy(help_context, &loads);
    help_end(&s);
  }
}

/* Nothing else shines: the shield, black and one layer, holds 2 sigma T^4 = q whatever it absorbs
 * of sunlight; its heat is in the balance and counts with what the Earth sends, which is switched
 * off. */
static void plate_is_heated(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  environment.gas_density_factor = 0.9;
  struct um_irradiation_loads *loads = trace(UM_PI, &s);
  s.spec[1].shell.through_conductance = INFINITY;
  help_build(&s, NULL, 0);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
  options.planet_on = options.albedo_on = false;
  size_t n = um_thermal_network_nodes(s.body->network);
  double *t = calloc(n, sizeof *t);
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  assert_true(t != NULL && heat != NULL);
  OK(um_thermal_solve_steady(help_context, s.body->network, loads, 0, &options, NULL, t));
  double v = 7784.0 - RATE * (EQUATOR + 200e3);
  double flux = 0.9 * 0.5 * 2.789e-10 * v * v * v, sum = 0.0;
  NEAR("T", help_mean(&s, "shield", t), pow(flux / (2.0 * UM_STEFAN_BOLTZMANN), 0.25), 1e-5);
  OK(um_thermal_heat_of_nodes(help_context, s.body->network, loads, &options, loads->t[0], t,
                              heat));
  for (size_t i = 0; i < n; i++) sum += heat[i].planet;
  NEAR("heat", sum / (4.0 * flux), 1.0, 2e-7);
  free(t);
  free(heat);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

/* Where nobody asks there is no table, and a satellite at rest in a list of points meets no air. */
static void nothing_where_nothing_moves(void **state)
{
  (void)state;
  struct um_vec3 from;
  const struct um_environment_sample still = {.r = um_vec3(7e6, 0, 0), .pole = {0.0, 0.0, 1.0}};
  assert_true(um_environment_atmosphere_flow(&still, &from) == 0.0);
  struct help_satellite s = {0};
  environment.gas_density_factor = 0.0;
  struct um_irradiation_loads *loads = trace(0.0, &s);
  assert_null(loads->gas);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

static int setup(void **state)
{
  um_environment_defaults(&environment);
  return help_setup(state);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(densities_are_those_printed),
      cmocka_unit_test(plates_face_the_motion),
      cmocka_unit_test(plate_is_heated),
      cmocka_unit_test(nothing_where_nothing_moves),
  };
  return cmocka_run_group_tests(tests, setup, help_teardown);
}
