/* Solid parts by tetrahedra: patch test, volume, NAFEMS T2, slab with observed order. */
#include "tests/thermal/body_help.h"
#include "thermal/network/builder_impl.h"
#include "thermal/network/tetgen.h"

/* Patch test on one cube of five tetrahedra and a distorted inner vertex: a linear field leaves
 * nothing on the inner vertex, and dissipates k |grad T|^2 V. Twelve boundary triangles of a cube,
 * each with the inner vertex, make twelve tetrahedra. */
static void test_patch(void **state)
{
  (void)state;
  struct um_vec3 v[9];
  for (int i = 0; i < 8; i++) v[i] = um_vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  v[8] = um_vec3(0.6, 0.35, 0.45);
  static const int face[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  static const int edge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  double flow[9] = {0}, dissipation = 0.0, volume = 0.0, largest = 0.0, k[6];
  for (int f = 0; f < 12; f++) {
    int at[4] = {8, face[f][0], face[f][1], face[f][2]};
    struct um_vec3 corner[4];
    for (int c = 0; c < 4; c++) corner[c] = v[at[c]];
    volume += um_thermal_solid_element(corner, 55.6, k);
    for (int e = 0; e < 6; e++) {
      int i = at[edge[e][0]], j = at[edge[e][1]];
      struct um_vec3 g = um_vec3(3.0, -7.0, 11.0);
      double d = um_vec3_dot(g, um_vec3_sub(v[j], v[i]));
      flow[i] += k[e] * d;
      flow[j] -= k[e] * d;
      dissipation += k[e] * d * d;
    }
  }
  for (int i = 0; i < 9; i++) largest = fmax(largest, fabs(flow[i]));
  NEAR("volume", volume, 1.0, 1e-14);
  NEAR("inner vertex", flow[8], 0.0, 1e-12 * largest);
  NEAR("dissipation", dissipation, 55.6 * 179.0, 1e-12 * 55.6 * 179.0);
}

/* A bar of L 0.1 m along x, square cross-section of `width`, insulated but for what the test adds.
 */
static void bar(struct help_satellite *s, double width, double facet)
{
  size_t p = help_part(s, "bar", UM_SHAPE_BOX, NULL);
  s->shape[p].size[0] = 0.1;
  s->shape[p].size[1] = s->shape[p].size[2] = width;
  s->shape[p].facet_size = facet;
  s->shape[p].solid = true;
  s->spec[p].kind = UM_THERMAL_SOLID;
  s->group[p].emittance_front = s->group[p].absorptance_front = 0.0;
}

static void emittance_of(struct help_satellite *s, const char *group, double emittance)
{
  for (size_t g = 0; g < um_geometry_group_count(s->geometry); g++)
    if (strcmp(um_geometry_group(s->geometry, s->all[g].group)->name, group) == 0)
      s->all[g].emittance_front = emittance;
}

/* NAFEMS T2 on tetrahedra: 1000 K at -x, +x radiates to 300 K with eps 0.98, k 55.6. The field is
 * linear, so any mesh is exact: 927.004 K with sigma CODATA (927.008 with 5.67e-8;
 * docs/physics/conduction.md). 5e-4 K are the printed digits. Capacity = rho c V. */
static void test_nafems_t2(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  bar(&s, 0.02, 0.01);
  s.spec[0].conductivity = 55.6;
  help_geometry(&s);
  emittance_of(&s, "+x", 0.98);
  help_build(&s, NULL, 0);
  size_t nnode = um_thermal_network_nodes(s.body->network);
  double capacity = 0.0;
  for (uint32_t i = 0; i < nnode; i++) capacity += um_thermal_network_capacity(s.body->network, i);
  NEAR("capacity", capacity, 2700.0 * 900.0 * 4e-5, 1e-9 * 97.2);
  help_hold(&s, "bar.-x", 1000.0);
  double *t = help_steady(&s, NULL, 300.0);
  print_message("NAFEMS T2 on %zu tetrahedra: %.4f K (927.004)\n", s.body->ntetrahedron,
                help_mean(&s, "bar.+x", t));
  NEAR("NAFEMS T2", help_mean(&s, "bar.+x", t), 927.004, 5e-4);
  assert_true(s.body->ntetrahedron > 100);
  free(t);
  help_end(&s);
}

/* Slab, step at x = 0, insulated at L (Carslaw & Jaeger 1959 3.3): theta at the back face at Fo 0.2
 * is 0.772312 (docs/physics/conduction.md). */
static double slab_back(double facet)
{
  struct help_satellite s = {0};
  bar(&s, 0.025, facet);
  s.spec[0].conductivity = 1.0;
  s.spec[0].density = 1000.0;
  s.spec[0].specific_heat = 1000.0; /* kappa 1e-6 m2/s */
  s.spec[0].start_temperature = 310.0;
  help_build(&s, NULL, 0);
  help_hold(&s, "bar.-x", 300.0);
  struct um_thermal_solve_options options = help_options(1e-8, 1e-7, 0.0);
  struct um_thermal_history *history = NULL;
  double fo = 0.2, at = fo * 0.01 / 1e-6; /* [s] */
  OK(um_thermal_solve(help_context, s.body->network, NULL, &options, NULL, 0.0, &at, 1, &history));
  double theta = (help_mean(&s, "bar.+x", history->temperature) - 300.0) / 10.0;
  print_message("slab, facets of %g m, %zu tetrahedra, %zu nodes: theta %.6f (0.772312)\n", facet,
                s.body->ntetrahedron, history->nnode, theta);
  um_thermal_history_destroy(help_context, &history);
  help_end(&s);
  return theta;
}

/* Order 2 +- 0.4: the meshes are unstructured, so successive ones are not refinements of each
 * other and their error constants differ (a factor 1.3 in the constant is 0.4 in the order). */
static void test_slab(void **state)
{
  (void)state;
  double coarse = fabs(slab_back(0.0125) - 0.772312), fine = fabs(slab_back(0.00625) - 0.772312);
  double order = log2(coarse / fine);
  print_message("slab observed order %.3f\n", order);
  NEAR("observed order", order, 2.0, 0.4);
  NEAR("back face", fine, 0.0, 1.5e-3);
}

/* Tetrahedra of a body at hand serve a part of the same surface and size, and no other. The one at
 * hand is marked by a vertex that TetGen would not set. */
static void test_like(void **state)
{
  (void)state;
  static const struct {
    double width, size;
    bool serves;
  } other[] = {{0.025, 0.0, true}, {0.026, 0.0, false}, {0.025, 0.006, false}};
  struct help_satellite first = {0};
  bar(&first, 0.025, 0.0125);
  help_build(&first, NULL, 0);
  struct um_thermal_tetrahedra *mark = first.body->solid[0].mesh;
  assert_true(mark->nvertex > mark->nsurface);
  mark->vertex[mark->nsurface].x += 1e-6;
  for (size_t k = 0; k < sizeof other / sizeof other[0]; k++) {
    struct help_satellite s = {0};
    bar(&s, other[k].width, 0.0125);
    s.spec[0].tetrahedron_size = other[k].size;
    s.spec[0].like = first.body;
    help_build(&s, NULL, 0);
    const struct um_thermal_tetrahedra *t = s.body->solid[0].mesh;
    bool same = t->nvertex == mark->nvertex && t->ntetrahedron == mark->ntetrahedron;
    for (size_t v = 0; v < t->nvertex && same; v++)
      same = um_vec3_norm(um_vec3_sub(t->vertex[v], mark->vertex[v])) == 0.0;
    if (same != other[k].serves) fail_msg("case %zu", k);
    help_end(&s);
  }
  help_end(&first);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_patch), cmocka_unit_test(test_nafems_t2),
                                     cmocka_unit_test(test_slab), cmocka_unit_test(test_like)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
