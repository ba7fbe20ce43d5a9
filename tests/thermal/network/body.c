/* Bodies out of parts: lumps, blankets, interiors, contacts, places, refusals. */
#include "tests/thermal/body_help.h"

/* Heat conducted into a place when every place of the body is held [W]. */
static double conducted_into(struct help_satellite *s, const char *name, const double *temperature)
{
  struct um_thermal_heat *heat = calloc(um_thermal_network_nodes(s->body->network), sizeof *heat);
  assert_non_null(heat);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, s->body->network, NULL, &options, 0.0, temperature,
                              heat));
  const struct um_thermal_place *p = help_place(s, name);
  double sum = 0.0;
  for (size_t i = 0; i < p->nnode; i++) sum += heat[p->node[i]].conducted;
  free(heat);
  return sum;
}

/* Start temperatures with one place set. */
static void set_place(struct help_satellite *s, const char *name, double *t, double value)
{
  const struct um_thermal_place *p = help_place(s, name);
  for (size_t i = 0; i < p->nnode; i++) t[p->node[i]] = value;
}

static double *temperatures(const struct help_satellite *s, double value)
{
  size_t n = um_thermal_network_nodes(s->body->network);
  double *t = calloc(n, sizeof *t);
  assert_non_null(t);
  for (size_t i = 0; i < n; i++) t[i] = value;
  return t;
}

/* MLI skin, alpha 0.38, eps 0.78, what it wraps at 293 K, 1361 W/m2 or dark, space 0 K
 * (docs/physics/mli.md): the same for finite elements, lumps and solids, over a wall or an
 * interior. Printed digits.
 */
static void mli_case(enum um_thermal_part_kind kind, bool interior, double e, double sunlit,
                     double leak_in, double dark, double leak_out)
{
  struct um_thermal_mli mli = {
      .effective_emittance = e, .areal_heat_capacity = 60.0, .wraps_interior = interior};
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.shape[p].facet_size = 0.8;
  s.shape[p].solid = kind == UM_THERMAL_SOLID;
  s.spec[p].kind = kind;
  if (interior) help_interior(&s, p, "interior", 1e5, 0.0);
  s.group[p].absorptance_front = 0.38;
  s.group[p].emittance_front = 0.78;
  s.group[p].mli = &mli;
  help_build(&s, NULL, 0);
  help_hold(&s, interior ? "bus.interior" : "bus.wall", 293.0);
  size_t nsurface = um_geometry_mesh(s.geometry)->nsurface;
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, 1, nsurface, 0, &loads));
  loads->irradiance[0] = 1361.0;
  for (size_t i = 0; i < nsurface; i++) loads->sun[i] = 1.0f;
  for (int lit = 0; lit < 2; lit++) {
    loads->sunlit[0] = lit;
    double *t = help_steady(&s, loads, 0.0), skin = help_mean(&s, "bus", t);
    double leak = e * UM_STEFAN_BOLTZMANN * (pow(skin, 4) - pow(293.0, 4));
    NEAR("MLI skin", skin, lit ? sunlit : dark, 1e-4);
    NEAR("MLI leak", leak, lit ? leak_in : -leak_out, 1e-4);
    free(t);
  }
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

static void test_mli(void **state)
{
  (void)state;
  static const double row[4][5] = {{0.005, 328.6456, 1.2179, 82.7738, 2.0762},
                                   {0.01, 328.4540, 2.4204, 98.2790, 4.1262},
                                   {0.03, 327.7079, 7.0819, 128.5366, 12.0729},
                                   {0.05, 326.9929, 11.5187, 145.1579, 19.6367}};
  for (int i = 0; i < 4; i++) {
    const double *r = row[i];
    mli_case(UM_THERMAL_SHELL, true, r[0], r[1], r[2], r[3], r[4]);
    mli_case(UM_THERMAL_SHELL, false, r[0], r[1], r[2], r[3], r[4]);
    mli_case(UM_THERMAL_LUMPED, true, r[0], r[1], r[2], r[3], r[4]);
    mli_case(UM_THERMAL_LUMPED, false, r[0], r[1], r[2], r[3], r[4]);
    mli_case(UM_THERMAL_SOLID, false, r[0], r[1], r[2], r[3], r[4]);
  }
}

/* Names, capacities and weights of lumped parts. */
static void test_lumped(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.spec[p].kind = UM_THERMAL_LUMPED;
  s.shape[p].size[2] = 2.0;
  p = help_part(&s, "array", UM_SHAPE_PLATE, "paint");
  s.spec[p].kind = UM_THERMAL_LUMPED;
  s.spec[p].shell.front_share = 0.25;
  s.spec[p].shell.through_conductance = 40.0;
  s.shape[p].size[0] = 3.0;
  p = help_part(&s, "ball", UM_SHAPE_SPHERE, NULL);
  s.spec[p].kind = UM_THERMAL_LUMPED;
  s.shape[p].radius = 0.5;
  p = help_part(&s, "foil", UM_SHAPE_PLATE, "paint");
  s.spec[p].kind = UM_THERMAL_LUMPED;
  s.spec[p].shell.through_conductance = INFINITY;
  help_build(&s, NULL, 0);
  struct um_thermal_network *n = s.body->network;
  assert_int_equal(um_thermal_network_nodes(n), 6 + 2 + 1 + 1);
  struct {
    const char *name;
    double capacity;
  } expected[] = {{"bus.+x", 9720},      {"bus.+z", 4860},       {"array.front", 3645},
                  {"array.back", 10935}, {"ball", UM_PI * 4860}, {"foil", 4860}};
  for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
    size_t node = um_thermal_network_find(n, expected[i].name);
    if (node == (size_t)-1) fail_msg("no node %s", expected[i].name);
    NEAR(expected[i].name, um_thermal_network_capacity(n, (uint32_t)node), expected[i].capacity,
         1e-9 * expected[i].capacity);
    assert_int_equal(help_place(&s, expected[i].name)->node[0], node);
  }
  /* 40 W/m2/K through 3 m2, 10 K */
  double *t = temperatures(&s, 300.0);
  set_place(&s, "array.back", t, 310.0);
  NEAR("through the panel", conducted_into(&s, "array.front", t), 1200.0, 1e-9);
  free(t);
  /* weights of "bus" are by area: 2, 2, 2, 2, 1, 1 of 10 */
  const struct um_thermal_place *bus = help_place(&s, "bus");
  assert_int_equal(bus->nnode, 6);
  for (size_t i = 0; i < 6; i++)
    NEAR("weight", bus->weight[i], um_thermal_network_capacity(n, bus->node[i]) / 48600.0, 1e-12);
  assert_true(um_thermal_body_place_find(s.body, "bus.back") == (size_t)-1);
  help_end(&s);
}

/* Conductance of every group to the interior: 6 x 5 W/K, 10 K, on elements and lumps. */
static void test_interior(void **state)
{
  (void)state;
  for (int lumped = 0; lumped < 2; lumped++) {
    struct help_satellite s = {0};
    size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
    s.shape[p].facet_size = 0.5;
    s.spec[p].kind = lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
    help_interior(&s, p, "interior", 1e5, 5.0)->power = 12.0;
    help_build(&s, NULL, 0);
    double *t = temperatures(&s, 300.0);
    set_place(&s, "bus.interior", t, 310.0);
    NEAR("into the walls", conducted_into(&s, "bus", t), 300.0, 1e-9);
    NEAR("out of the interior", conducted_into(&s, "bus.interior", t), -300.0, 1e-9);
    free(t);
    help_end(&s);
  }
}

/* Contact of two plates lying on each other with different meshes: G = 7 W/K, 10 K: 70 W whole,
 * shared by area: each node of a takes between 0.3 and 3 of its share. */
static void test_contact_faces(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  size_t a = help_part(&s, "a", UM_SHAPE_PLATE, "paint");
  size_t b = help_part(&s, "b", UM_SHAPE_PLATE, "paint");
  s.shape[a].facet_size = 0.3;
  s.shape[b].facet_size = 0.17;
  s.shape[b].position = um_vec3(0, 0, 0.01);
  s.spec[a].shell.through_conductance = s.spec[b].shell.through_conductance = 0.0;
  s.spec[a].shell.conductance = s.spec[b].shell.conductance = 0.0;
  struct um_thermal_contact contact = {"a.front", "b.back", 7.0, 0.0};
  help_build(&s, &contact, 1);
  double *t = temperatures(&s, 300.0);
  set_place(&s, "b.back", t, 310.0);
  NEAR("into a", conducted_into(&s, "a.front", t), 70.0, 1e-9);
  NEAR("out of b", conducted_into(&s, "b.back", t), -70.0, 1e-9);
  NEAR("other side of a", conducted_into(&s, "a.back", t), 0.0, 0.0);
  struct um_thermal_heat *heat = calloc(um_thermal_network_nodes(s.body->network), sizeof *heat);
  assert_non_null(heat);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, s.body->network, NULL, &options, 0.0, t, heat));
  const struct um_thermal_place *place = help_place(&s, "a.front");
  for (size_t i = 0; i < place->nnode; i++) {
    double share = heat[place->node[i]].conducted / (70.0 * place->weight[i]);
    if (!(share > 0.3 && share < 3.0)) fail_msg("node %zu takes %g of its share", i, share);
  }
  free(heat);
  free(t);
  help_end(&s);
}

/* A panel of 4 m whose near edge is 0.1 m from the bus: the contact acts on that edge only. */
static void test_contact_hinge(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  size_t p = help_part(&s, "array", UM_SHAPE_PLATE, "paint");
  s.shape[0].facet_size = s.shape[p].facet_size = 0.3;
  s.shape[p].size[0] = 4.0;
  s.shape[p].position = um_vec3(2.6, 0, 0);
  s.spec[p].shell.through_conductance = 30.0;
  s.spec[p].shell.conductance = s.spec[0].shell.conductance = 0.0;
  struct um_thermal_contact contact = {"bus", "array", 2.0, 0.0};
  help_build(&s, &contact, 1);
  double *t = temperatures(&s, 300.0);
  set_place(&s, "bus", t, 310.0);
  NEAR("into the array", conducted_into(&s, "array", t), 20.0, 1e-9);
  NEAR("half on each layer", conducted_into(&s, "array.back", t), 10.0, 1e-9);
  NEAR("out of the bus, +x only", conducted_into(&s, "bus.+x", t), -20.0, 1e-9);
  /* cut the near edge off: nothing else takes part */
  uint32_t node[1024];
  size_t n = help_nodes_at_x(&s, 0.6, node, 1024);
  assert_true(n > 0 && n < 1024);
  for (size_t i = 0; i < n; i++) t[node[i]] = 310.0;
  NEAR("beyond the edge", conducted_into(&s, "bus", t), 0.0, 0.0);
  free(t);
  help_end(&s);
}

/* Where MLI wraps the interior, a contact reaches the interior; over a wall, the wall. */
static void test_contact_blanket(void **state)
{
  (void)state;
  struct um_thermal_mli mli = {
      .effective_emittance = 0.01, .areal_heat_capacity = 60.0, .wraps_interior = true};
  for (int wall = 0; wall < 2; wall++) {
    struct help_satellite s = {0};
    size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
    help_part(&s, "array", UM_SHAPE_PLATE, "paint");
    s.shape[1].position = um_vec3(1.1, 0, 0);
    help_interior(&s, p, "interior", 1e5, 0.0);
    mli.wraps_interior = !wall;
    s.group[p].mli = &mli;
    struct um_thermal_contact contact[2] = {{"array", "bus", 3.0, 0.0},
                                            {"bus.interior", "array", 1.0, 0.0}};
    help_build(&s, contact, wall ? 1 : 2);
    double *t = temperatures(&s, 300.0);
    set_place(&s, "array", t, 310.0);
    NEAR("into the structure", conducted_into(&s, wall ? "bus.wall" : "bus.interior", t),
         wall ? 30.0 : 40.0, 1e-9);
    NEAR("into the blanket", conducted_into(&s, "bus", t), 0.0, 0.0);
    free(t);
    help_end(&s);
  }
}

/* A failing body: the message says which part and what. */
static void refused(struct help_satellite *s, const struct um_thermal_contact *contact,
                    const char *words)
{
  um_core_message_clear(help_context);
  if (s->geometry == NULL) help_geometry(s);
  assert_int_equal(um_thermal_body_create(help_context, s->geometry, s->spec, s->npart, contact,
                                          contact != NULL, &s->body),
                   UM_ERR_INPUT);
  assert_null(s->body);
  print_message("  %s\n", um_core_message(help_context));
  if (strstr(um_core_message(help_context), words) == NULL)
    fail_msg("'%s' is not in '%s'", words, um_core_message(help_context));
}

static void test_refused(void **state)
{
  (void)state;
  struct um_thermal_mli mli = {
      .effective_emittance = 0.01, .areal_heat_capacity = 60.0, .wraps_interior = true};
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  help_geometry(&s);
  s.spec[p].start_temperature = NAN;
  refused(&s, NULL, "part bus: start temperature nan K");
  s.spec[p].start_temperature = 300.0;
  s.spec[p].shell.areal_heat_capacity = -1.0;
  refused(&s, NULL, "part bus: areal heat capacity -1 J/m2/K");
  s.spec[p].shell.areal_heat_capacity = 4860.0;
  s.all[3].emittance_front = 1.2;
  refused(&s, NULL, "emittance of the front 1.2");
  s.all[3].emittance_front = 0.8;
  s.all[2].mli = &mli;
  refused(&s, NULL, "the part has no such interior");
  s.all[2].mli = NULL;
  s.all[2].interior_conductance = (double[]){3.0};
  refused(&s, NULL, "the part has no interior");
  s.all[2].interior_conductance = NULL;
  s.spec[p].ngroup = 5;
  refused(&s, NULL, "no thermal spec");
  s.spec[p].ngroup = 6;
  s.npart = 0;
  refused(&s, NULL, "part bus: no thermal spec");
  s.npart = 1;
  refused(&s, &(struct um_thermal_contact){"bus", "wing", 1.0, 0.0}, "there is no place 'wing'");
  refused(&s, &(struct um_thermal_contact){"bus", "bus.interior", 1.0, 0.0},
          "no place 'bus.interior'");
  refused(&s, &(struct um_thermal_contact){"bus.+x", "bus.-x", -1.0, 0.0}, "conductance -1 W/K");
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_mli),           cmocka_unit_test(test_lumped),
      cmocka_unit_test(test_interior),      cmocka_unit_test(test_contact_faces),
      cmocka_unit_test(test_contact_hinge), cmocka_unit_test(test_contact_blanket),
      cmocka_unit_test(test_refused)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
