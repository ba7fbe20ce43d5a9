/* Closed parts that radiate inside: the unit cube and concentric spheres of radiosity, one
 * temperature all around, cooling that the inside has no part in, and what is refused. Two orbits
 * of a box against an independent network: tests/scenarios/inside.c. */
#include "geometry/inside.h"

#include "tests/support/temporary.h"
#include "tests/thermal/body_help.h"
#include "thermal/exchange/exchange.h"

/* A satellite whose closed parts radiate inside, with the exchange of its rooms. */
struct inside {
  struct help_satellite s;
  struct um_geometry_view_factor_table *table;
  struct um_thermal_exchange *exchange;
  struct um_thermal_solve_options options;
};

static void inside_open(struct inside *x, size_t limit)
{
  struct um_geometry_view_factor_options factors;
  struct um_thermal_exchange_options infrared = {.infrared = true};
  um_geometry_view_factor_defaults(&factors);
  help_build(&x->s, NULL, 0);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(x->s.geometry);
  OK(um_geometry_view_factor_table_create(help_context, x->s.geometry, NULL, 1, 64, &factors,
                                          &x->table));
  for (uint32_t p = 0; p < x->s.npart; p++)
    if (x->s.spec[p].inside)
      OK(um_geometry_inside_add(help_context, x->s.geometry, p, limit, &factors, x->table));
  for (size_t f = 0; f < mesh->nfacet; f++) {
    uint32_t inner = um_geometry_inner_surface(mesh, f);
    if (um_thermal_network_surface(x->s.body->network, inner) == NULL) continue;
    assert_close(um_thermal_network_surface(x->s.body->network, inner)->blocked, 1.0, 0.0);
    OK(um_thermal_network_surface_block(x->s.body->network, inner, 0.0));
  }
  OK(um_thermal_exchange_create(help_context, x->s.body->network, NULL, x->table, &infrared,
                                &x->exchange));
  x->options = help_options(1e-8, 1e-7, 0.0);
  x->options.exchange = x->exchange;
}

static void inside_close(struct inside *x)
{
  um_thermal_exchange_destroy(help_context, &x->exchange);
  um_geometry_view_factor_table_destroy(help_context, &x->table);
  help_end(&x->s);
}

/* What the nodes of a place lose to the others inside [W]. */
static double loss_of(const struct inside *x, const char *name, const double *temperature)
{
  const struct um_thermal_place *p = help_place(&x->s, name);
  size_t n = um_thermal_network_nodes(x->s.body->network);
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  double sum = 0.0;
  assert_non_null(heat);
  OK(um_thermal_heat_of_nodes(help_context, x->s.body->network, NULL, &x->options, 0.0, temperature,
                              heat));
  for (size_t i = 0; i < p->nnode; i++) sum -= heat[p->node[i]].exchanged;
  free(heat);
  return sum;
}

static const double wall_emittance[6] = {0.8, 0.8, 0.3, 0.3, 0.05, 0.9};

/* A unit cube; lumped, or facets of 0.6 m. Grey outside 0.5. */
static void cube(struct inside *x, bool lumped)
{
  *x = (struct inside){0};
  size_t p = help_part(&x->s, "bus", UM_SHAPE_BOX, NULL);
  x->s.spec[p].kind = lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
  x->s.spec[p].inside = true;
  x->s.shape[p].facet_size = 0.6;
  x->s.spec[p].shell.through_conductance = INFINITY;
  x->s.group[p].emittance_front = 0.5;
  help_geometry(&x->s);
  for (int g = 0; g < 6; g++) x->s.all[g].inside_emittance = wall_emittance[g];
}

static const char *const face[6] = {"bus.+x", "bus.-x", "bus.+y", "bus.-y", "bus.+z", "bus.-z"};

/* Net losses of radiosity and of Gebhart's factors alike, faces opposite each other in pairs; view
 * factors to 5e-4 (tests/geometry/inside.c). */
static void unit_cube(void **state)
{
  (void)state;
  static const double temperature[6] = {300, 320, 280, 310, 250, 400};
  static const double expected[6] = {-295.67961, -170.81837, -136.12687,
                                     -80.82225,  -28.13338,  711.58047};
  struct inside x;
  double t[6], sum = 0.0;
  cube(&x, true);
  inside_open(&x, 0);
  assert_int_equal(um_thermal_network_nodes(x.s.body->network), 6);
  for (int k = 0; k < 6; k++) t[help_place(&x.s, face[k])->node[0]] = temperature[k];
  for (int k = 0; k < 6; k++) {
    double loss = loss_of(&x, face[k], t);
    print_message("%s: %.4f W, expected %.4f\n", face[k], loss, expected[k]);
    assert_close(loss, expected[k], 5e-4 * 711.58);
    sum += loss;
  }
  assert_close(sum, 0.0, 1e-9);
  assert_close(um_thermal_exchange_area(x.exchange, 0, 0, 5), 0.8 * 0.340632, 5e-4);
  inside_close(&x);
}

/* At one temperature nobody loses anything, whatever the emittances, patches, layers. */
static void one_temperature(void **state)
{
  (void)state;
  for (int k = 0; k < 6; k++) {
    struct inside x;
    cube(&x, k < 2);
    if (k % 2 == 1) {
      x.s.spec[0].shell.through_conductance = 30.0;
      for (int g = 0; g < 6; g++) x.s.all[g].inside_emittance = 1.0;
    }
    inside_open(&x, k < 2 ? 0 : k < 4 ? 20 : 400);
    size_t n = um_thermal_network_nodes(x.s.body->network);
    double *t = calloc(n, sizeof *t);
    assert_non_null(t);
    for (size_t i = 0; i < n; i++) t[i] = 350.0;
    if (k == 0) assert_int_equal(n, 6);
    if (k == 1) assert_int_equal(n, 12);
    struct um_thermal_heat *heat = calloc(n, sizeof *heat);
    assert_non_null(heat);
    OK(um_thermal_heat_of_nodes(help_context, x.s.body->network, NULL, &x.options, 0.0, t, heat));
    for (size_t i = 0; i < n; i++) assert_close(heat[i].exchanged, 0.0, 1e-9);
    free(heat);
    free(t);
    inside_close(&x);
  }
}

/* A sphere of area 4 pi r^2 as facets of an octahedron cut in four `cut` times; turned: its front
 * looks to the middle. */
static void sphere_write(FILE *file, const char *group, double r, int cut, bool turned, int *vertex)
{
  static const int corner[8][3] = {{1, 1, 1},  {-1, 1, 1},  {-1, -1, 1},  {1, -1, 1},
                                   {1, 1, -1}, {-1, 1, -1}, {-1, -1, -1}, {1, -1, -1}};
  int n = 1 << cut;
  double area = 0.0;
  for (int write = 0; write < 2; write++) {
    double scale = write ? r * sqrt(4.0 * UM_PI / area) : 1.0;
    if (write) fprintf(file, "g %s\n", group);
    for (int o = 0; o < 8; o++)
      for (int i = 0; i < n; i++)
        for (int j = 0; j < n - i; j++)
          for (int up = 0; up < (j < n - i - 1 ? 2 : 1); up++) {
            int at[3][2] = {{i + up, j + up}, {i + 1, j}, {i, j + 1}};
            struct um_vec3 v[3];
            for (int c = 0; c < 3; c++) {
              double a = at[c][0], b = at[c][1], d = n - a - b;
              v[c] = um_vec3(a * corner[o][0], b * corner[o][1], d * corner[o][2]);
              v[c] = um_vec3_scale(v[c], scale / um_vec3_norm(v[c]));
            }
            struct um_vec3 cross = um_vec3_cross(um_vec3_sub(v[1], v[0]), um_vec3_sub(v[2], v[0]));
            if (!write) {
              area += 0.5 * um_vec3_norm(cross);
              continue;
            }
            bool out = (um_vec3_dot(cross, v[0]) > 0.0) != turned;
            for (int c = 0; c < 3; c++) {
              struct um_vec3 w = v[out ? c : 2 - c];
              fprintf(file, "v %.15g %.15g %.15g\n", w.x, w.y, w.z);
            }
            fprintf(file, "f %d %d %d\n", *vertex + 1, *vertex + 2, *vertex + 3);
            *vertex += 3;
          }
  }
}

/* The room of a hollow ball is what its wall encloses, between the spheres: q = s A1 (T1^4 - T2^4)
 * / (1/e1 + A1/A2 (1/e2 - 1)), 1700.42790 W for radii 0.5 and 1, emittances 0.8 and 0.3, 400 and
 * 300 K (digits as printed). Exact with two patches: the inner sphere sees the outer one alone. */
static void concentric_spheres(void **state)
{
  (void)state;
  char folder[UM_TEST_PATH], path[UM_TEST_PATH + 16];
  int vertex = 0;
  assert_int_equal(um_test_folder_create(folder), 0);
  snprintf(path, sizeof path, "%s/shell.obj", folder);
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  sphere_write(file, "outer", 1.0, 3, false, &vertex);
  sphere_write(file, "inner", 0.5, 3, true, &vertex);
  assert_int_equal(fclose(file), 0);
  struct inside x = {0};
  size_t p = help_part(&x.s, "ball", UM_SHAPE_MESH, NULL);
  x.s.shape[p].mesh_path = path;
  x.s.spec[p].kind = UM_THERMAL_LUMPED;
  x.s.spec[p].inside = true;
  x.s.spec[p].shell.through_conductance = INFINITY;
  help_geometry(&x.s);
  for (size_t g = 0; g < x.s.spec[p].ngroup; g++) {
    const char *name = um_geometry_group(x.s.geometry, x.s.all[g].group)->name;
    x.s.all[g].inside_emittance = strcmp(name, "inner") == 0 ? 0.8 : 0.3;
    x.s.all[g].emittance_front = 0.0; /* nothing to the outside */
  }
  inside_open(&x, 0);
  double t[2];
  t[help_place(&x.s, "ball.inner")->node[0]] = 400.0;
  t[help_place(&x.s, "ball.outer")->node[0]] = 300.0;
  NEAR("inner", loss_of(&x, "ball.inner", t), 1700.42790, 1e-5);
  NEAR("outer", loss_of(&x, "ball.outer", t), -1700.42790, 1e-5);
  inside_close(&x);
  assert_int_equal(remove(path), 0);
  assert_int_equal(um_test_folder_remove(folder), 0);
}

/* Inside a sphere every surface sees all of it alike, so that of one emittance e all receive the
 * mean of s T^4, whatever is reflected, and a node of area A gains A e s (mean T^4 - T^4). Facets
 * are not the sphere: one sees nothing of itself, 1/320 of all, and 1 % of its own patch too
 * little. */
static void sphere_field(void **state)
{
  (void)state;
  struct inside x = {0};
  size_t p = help_part(&x.s, "ball", UM_SHAPE_SPHERE, NULL);
  x.s.shape[p].radius = 0.5;
  x.s.shape[p].facet_size = 0.2;
  x.s.spec[p].inside = true;
  x.s.spec[p].shell.through_conductance = INFINITY;
  x.s.group[p].inside_emittance = 0.4;
  inside_open(&x, 400);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(x.s.geometry);
  const struct um_thermal_place *ball = help_place(&x.s, "ball");
  size_t n = um_thermal_network_nodes(x.s.body->network);
  double *t = calloc(n, sizeof *t), mean = 0.0, all = 0.0, worst = 0.0, largest = 0.0;
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  struct um_geometry_pose *pose = NULL;
  assert_non_null(t);
  assert_non_null(heat);
  OK(um_geometry_pose_create(help_context, x.s.geometry, NULL, &pose));
  for (uint32_t s = 0; s < mesh->nsurface; s++) {
    all += mesh->area[s];
    for (int c = 0; c < 3; c++) {
      uint32_t node = um_thermal_network_surface(x.s.body->network, s)->node[c];
      t[node] = 300.0 + 100.0 * pose->vertex[mesh->corner[s][c]].z;
    }
  }
  um_geometry_pose_destroy(help_context, &pose);
  for (size_t i = 0; i < ball->nnode; i++) mean += ball->weight[i] * pow(t[ball->node[i]], 4);
  OK(um_thermal_heat_of_nodes(help_context, x.s.body->network, NULL, &x.options, 0.0, t, heat));
  for (size_t i = 0; i < ball->nnode; i++) {
    uint32_t node = ball->node[i];
    double area = ball->weight[i] * all;
    double expected = 0.4 * UM_STEFAN_BOLTZMANN * (mean - pow(t[node], 4));
    worst = fmax(worst, fabs(heat[node].exchanged / area - expected));
    largest = fmax(largest, fabs(expected));
  }
  print_message("sphere of %zu facets, %zu nodes: %.2f W/m2 off of %.0f\n", mesh->nfacet, n, worst,
                largest);
  assert_true(mesh->nfacet >= 300 && worst < 0.01 * largest);
  free(heat);
  free(t);
  inside_close(&x);
}

/* Walls that cool alike give each other what they get, whatever they do outside: the box cools as
 * one that does not radiate inside. Its outer emittance goes with the temperature, the inner one
 * does not. */
static void alike_walls(void **state)
{
  (void)state;
  struct um_thermal_surface_law law = {.albedo = 1.0, .planet = 1.0};
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) law.absorptance[i] = 1.0;
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++)
    law.emittance[i] = 0.2 + 0.8 * (double)i / UM_THERMAL_LAW_TEMPERATURES;
  static const double time[3] = {100.0, 1000.0, 8000.0};
  double end[2][3];
  for (int radiates = 0; radiates < 2; radiates++) {
    struct inside x;
    struct um_thermal_history *h = NULL;
    cube(&x, false);
    x.s.spec[0].inside = radiates == 1;
    for (int g = 0; g < 6; g++) x.s.all[g].law_front = &law;
    if (radiates)
      inside_open(&x, 400);
    else {
      help_build(&x.s, NULL, 0);
      x.options = help_options(1e-8, 1e-7, 0.0);
    }
    OK(um_thermal_solve(help_context, x.s.body->network, NULL, &x.options, NULL, 0.0, time, 3, &h));
    for (int k = 0; k < 3; k++) {
      end[radiates][k] = h->temperature[(size_t)k * h->nnode];
      for (size_t i = 1; i < h->nnode; i++)
        assert_close(h->temperature[(size_t)k * h->nnode + i], end[radiates][k], 1e-4);
    }
    assert_true(h->audit_error < 1e-6);
    um_thermal_history_destroy(help_context, &h);
    inside_close(&x);
  }
  for (int k = 0; k < 3; k++) {
    print_message("after %g s: %.6f K, without inside %.6f\n", time[k], end[1][k], end[0][k]);
    assert_close(end[1][k], end[0][k], 1e-4);
  }
  assert_true(end[0][2] < 250.0);
}

/* 200 W into one face, which has to leave by the others: the steady state is where a long transient
 * ends; without the inside the face alone holds sigma A e T^4 = 200 W. */
static void heated_face(void **state)
{
  (void)state;
  struct inside x;
  struct um_thermal_history *h = NULL;
  static const double time[1] = {1e6};
  cube(&x, true);
  x.s.spec[0].shell.through_conductance = 50.0;
  x.s.all[0].power = 200.0;
  inside_open(&x, 0);
  double steady[12], sum = 0.0;
  assert_int_equal(um_thermal_network_nodes(x.s.body->network), 12);
  OK(um_thermal_solve_steady(help_context, x.s.body->network, NULL, 0, &x.options, NULL, steady));
  OK(um_thermal_solve(help_context, x.s.body->network, NULL, &x.options, NULL, 0.0, time, 1, &h));
  for (int i = 0; i < 12; i++) assert_close(h->temperature[i], steady[i], 1e-3);
  for (int k = 0; k < 6; k++)
    sum += UM_STEFAN_BOLTZMANN * 0.5 * pow(steady[help_place(&x.s, face[k])->node[0]], 4);
  assert_close(sum, 200.0, 1e-5);
  /* the inner layer of the heated face is colder by what leaves inside over 50 W/K, and sends out
   * what half of 200 W heats it with */
  uint32_t outer = help_place(&x.s, "bus.+x")->node[0];
  uint32_t inner = help_place(&x.s, "bus.+x.inside")->node[0];
  double through = 50.0 * (steady[outer] - steady[inner]);
  double radiated = UM_STEFAN_BOLTZMANN * 0.5 * pow(steady[outer], 4);
  print_message("heated face: %.3f K, inside %.3f K, %.2f W radiated outside\n", steady[outer],
                steady[inner], radiated);
  assert_close(through, 100.0 - radiated, 1e-5);
  assert_close(loss_of(&x, "bus.+x.inside", steady), 200.0 - radiated, 1e-5);
  assert_true(steady[outer] < pow(200.0 / (0.5 * UM_STEFAN_BOLTZMANN), 0.25) - 30.0);
  um_thermal_history_destroy(help_context, &h);
  inside_close(&x);
}

static void refused(struct help_satellite *s, const char *message)
{
  if (s->geometry == NULL) help_geometry(s);
  assert_int_equal(
      um_thermal_body_create(help_context, s->geometry, s->spec, s->npart, NULL, 0, &s->body),
      UM_ERR_INPUT);
  assert_string_equal(um_core_message(help_context), message);
  um_core_message_clear(help_context);
  help_end(s);
}

static void refusals(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  size_t p = help_part(&s, "wing", UM_SHAPE_PLATE, "paint");
  s.spec[p].inside = true;
  refused(&s, "part wing: is to radiate inside, but its walls are not closed");
  s = (struct help_satellite){0};
  p = help_part(&s, "tank", UM_SHAPE_BOX, NULL);
  s.spec[p].inside = s.shape[p].solid = true;
  s.spec[p].kind = UM_THERMAL_SOLID;
  refused(&s, "part tank: is to radiate inside, but it is solid");
  s = (struct help_satellite){0};
  p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.spec[p].inside = true;
  s.group[p].inside_emittance = 1.5;
  refused(&s, "part bus, group +x: emittance inside 1.5; accepted: 0 to 1");
  s = (struct help_satellite){0};
  struct um_thermal_mli mli = {
      .effective_emittance = 0.02, .areal_heat_capacity = 60.0, .wraps_interior = true};
  p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.spec[p].inside = true;
  help_interior(&s, p, "interior", 1e4, 0.0);
  help_geometry(&s);
  s.all[3].mli = &mli;
  refused(&s,
          "part bus, group -y: MLI is to wrap the interior, but the part radiates inside, which "
          "needs walls all around");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(unit_cube),          cmocka_unit_test(one_temperature),
      cmocka_unit_test(concentric_spheres), cmocka_unit_test(alike_walls),
      cmocka_unit_test(sphere_field),       cmocka_unit_test(heated_face),
      cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
