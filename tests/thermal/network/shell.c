/* Thin walls by linear triangles: patch test, fin, two-sided panel, capacity. */
#include "tests/thermal/body_help.h"
#include "thermal/network/builder_impl.h"

/* Patch test: nine vertices of a unit square, the inner one moved off the centre, eight triangles.
 *
 *   6---7---8    T = 300 + 3 x - 7 y. At the inner vertex K T = 0; the dissipation T.K.T =
 *   |\  |  /|    kt |grad T|^2 A exactly. Linear elements hold both to rounding (Irons 1966):
 *   3---4---5    1e-12 of the largest flow.
 *   |/  |  \|
 *   0---1---2 */
static void test_patch(void **state)
{
  (void)state;
  struct um_vec3 v[9];
  for (int i = 0; i < 9; i++) v[i] = um_vec3(0.5 * (i % 3), 0.5 * (i / 3), 0.0);
  v[4] = um_vec3(0.61, 0.37, 0.0);
  static const int tri[8][3] = {{0, 4, 3}, {0, 1, 4}, {1, 2, 4}, {2, 5, 4},
                                {4, 5, 8}, {4, 8, 7}, {6, 4, 7}, {3, 4, 6}};
  double flow[9] = {0}, dissipation = 0.0, kt = 0.334, largest = 0.0;
  for (int t = 0; t < 8; t++) {
    struct um_vec3 corner[3];
    double k[3];
    for (int c = 0; c < 3; c++) corner[c] = v[tri[t][c]];
    um_thermal_shell_element(corner, kt, k);
    for (int e = 0; e < 3; e++) {
      int i = tri[t][(e + 1) % 3], j = tri[t][(e + 2) % 3];
      double d = (3 * v[j].x - 7 * v[j].y) - (3 * v[i].x - 7 * v[i].y);
      flow[i] += k[e] * d;
      flow[j] -= k[e] * d;
      dissipation += k[e] * d * d;
    }
  }
  for (int i = 0; i < 9; i++) largest = fmax(largest, fabs(flow[i]));
  NEAR("inner vertex", flow[4], 0.0, 1e-12 * largest);
  NEAR("dissipation", dissipation, kt * 58.0, 1e-12 * kt * 58.0);
}

/* The same through a body: a plate whose ends are held at 300 and 310 K does not radiate; the mean
 * of a linear field is 305 K, the heat k t (W / L) dT = 1.67 W; nothing stays on an inner node. */
static void test_linear_field(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  size_t p = help_part(&s, "panel", UM_SHAPE_PLATE, "paint");
  s.shape[p].size[0] = 2.0;
  s.shape[p].facet_size = 0.3;
  s.spec[p].shell.through_conductance = INFINITY;
  s.group[p].emittance_front = s.group[p].emittance_back = 0.0;
  help_build(&s, NULL, 0);
  help_hold_at_x(&s, -1.0, 300.0);
  help_hold_at_x(&s, 1.0, 310.0);
  double *t = help_steady(&s, NULL, 0.0);
  NEAR("mean of a linear field", help_mean(&s, "panel", t), 305.0, 1e-7);
  struct um_thermal_heat *heat = calloc(um_thermal_network_nodes(s.body->network), sizeof *heat);
  assert_non_null(heat);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, s.body->network, NULL, &options, 0.0, t, heat));
  const struct um_thermal_place *place = help_place(&s, "panel");
  double largest = 0.0, in = 0.0;
  for (size_t i = 0; i < place->nnode; i++) {
    uint32_t node = place->node[i];
    if (um_thermal_network_kind(s.body->network, node) != UM_NODE_BOUNDARY)
      largest = fmax(largest, fabs(heat[node].conducted));
    else
      in += fabs(heat[node].conducted);
  }
  /* the steady solver's own rest on 1.67 W */
  NEAR("nothing stays on any node", largest, 0.0, 1e-9);
  NEAR("heat in and out", in, 2.0 * 1.67, 1e-8);
  free(heat);
  free(t);
  help_end(&s);
}

/* Radiating plate fin: 400 K root, L 0.1 m, 1 mm, k 167, eps 0.85 on both sides, 0 K sink. Tip
 * 351.69619 K (boundary value problem k t T'' = 2 eps sigma T^4 by shooting, sigma CODATA). The
 * strip is four cells wide whatever the cell: a corner has one or two of the six thirds of facets
 * that an inner node has, a source error of order h^2 in one point, whose field has a logarithm
 * of the width in cells. Order 2; Richardson extrapolation leaves the fourth-order rest, 5e-5 K. */
static double fin_tip(double cell)
{
  struct help_satellite s = {0};
  size_t p = help_part(&s, "fin", UM_SHAPE_PLATE, "paint");
  s.shape[p].size[0] = 0.1;
  s.shape[p].size[1] = 4.0 * cell;
  s.shape[p].facet_size = sqrt(2.0) * cell; /* squares cut in two */
  s.spec[p].shell =
      (struct um_thermal_shell){2430.0, 0.5, .conductance = 0.167, .through_conductance = INFINITY};
  s.group[p].emittance_front = s.group[p].emittance_back = 0.85;
  help_build(&s, NULL, 0);
  help_hold_at_x(&s, -0.05, 400.0);
  double *t = help_steady(&s, NULL, 0.0);
  uint32_t node[512];
  size_t n = help_nodes_at_x(&s, 0.05, node, 512);
  double sum = 0.0;
  for (size_t i = 0; i < n; i++) sum += t[node[i]] / (double)n;
  free(t);
  help_end(&s);
  return sum;
}

static void test_fin(void **state)
{
  (void)state;
  double cell[3] = {0.01, 0.005, 0.0025}, error[3];
  for (int i = 0; i < 3; i++) {
    error[i] = fin_tip(cell[i]) - 351.69619;
    print_message("fin tip, cells of %g m: error %.5f K\n", cell[i], error[i]);
  }
  double order = log2(fabs(error[0] - error[1]) / fabs(error[1] - error[2]));
  print_message("fin observed order %.3f\n", order);
  NEAR("observed order", order, 2.0, 0.15);
  NEAR("extrapolated tip error", error[2] + (error[2] - error[1]) / 3.0, 0.0, 5e-5);
}

/* Solar array normal to the Sun, no Earth, eps 0.85 on both sides, alpha 0.92, extraction 0.18
 * (docs/physics/internal-heat.md). sigma there is CODATA; 2e-4 K covers its printed digits. */
static void solar_array(double u, double extraction, double front, double back)
{
  struct help_satellite s = {0};
  size_t p = help_part(&s, "array", UM_SHAPE_PLATE, "paint");
  s.shape[p].facet_size = 0.5;
  s.spec[p].shell.through_conductance = u;
  s.group[p].absorptance_front = 0.92;
  s.group[p].extraction_front = extraction;
  s.group[p].emittance_front = s.group[p].emittance_back = 0.85;
  help_build(&s, NULL, 0);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s.geometry);
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, 1, mesh->nsurface, 0, &loads));
  loads->sunlit[0] = 1.0;
  loads->irradiance[0] = 1361.0;
  for (size_t i = 0; i < mesh->nsurface; i++) loads->sun[i] = mesh->surface[i].back ? 0.0f : 1.0f;
  double *t = help_steady(&s, loads, 0.0);
  NEAR("array front", help_mean(&s, "array.front", t), front, 2e-4);
  NEAR("array back", help_mean(&s, "array.back", t), back, 2e-4);
  print_message("array U %g extraction %g: front %.4f (%.4f), back %.4f (%.4f) K\n", u, extraction,
                help_mean(&s, "array.front", t), front, help_mean(&s, "array.back", t), back);
  free(t);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

static void test_solar_array(void **state)
{
  (void)state;
  solar_array(INFINITY, 0.18, 319.7108, 319.7108);
  solar_array(100.0, 0.18, 322.1238, 317.2419);
  solar_array(30.0, 0.18, 327.0368, 311.8434);
  solar_array(INFINITY, 0.0, 337.5952, 337.5952);
}

/* Capacities sum to area times areal capacity, split by the share; areas of the attached surfaces
 * to the geometry's. Rounding only. */
static void test_totals(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  size_t p = help_part(&s, "panel", UM_SHAPE_PLATE, "paint");
  s.shape[p].size[0] = 3.0;
  s.shape[p].facet_size = 0.25;
  s.spec[p].shell.front_share = 0.3;
  s.spec[p].shell.through_conductance = 50.0;
  p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.shape[p].facet_size = 0.4;
  s.shape[p].position = um_vec3(0, 0, -2);
  help_build(&s, NULL, 0);
  const char *name[3] = {"panel.front", "panel.back", "bus"};
  double expected[3] = {0.3 * 3 * 4860, 0.7 * 3 * 4860, 6 * 4860}, area = 0.0;
  for (int i = 0; i < 3; i++) {
    const struct um_thermal_place *place = help_place(&s, name[i]);
    double c = 0.0, w = 0.0;
    for (size_t k = 0; k < place->nnode; k++) {
      c += um_thermal_network_capacity(s.body->network, place->node[k]);
      w += place->weight[k];
    }
    NEAR(name[i], c, expected[i], 1e-9 * expected[i]);
    NEAR("weights", w, 1.0, 1e-12);
  }
  for (uint32_t i = 0; i < um_thermal_network_surfaces(s.body->network); i++)
    area += um_thermal_network_surface(s.body->network, i)->area;
  NEAR("area of all surfaces", area, 12.0, 1e-9);
  /* every vertex of the closed bus is one node, of the panel two */
  assert_true(help_place(&s, "panel.front")->nnode == help_place(&s, "panel.back")->nnode);
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_patch), cmocka_unit_test(test_linear_field), cmocka_unit_test(test_fin),
      cmocka_unit_test(test_solar_array), cmocka_unit_test(test_totals)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
