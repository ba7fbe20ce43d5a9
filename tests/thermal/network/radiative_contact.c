/* Contacts that radiate: sigma E (T_a^4 - T_b^4) between two places, E = A / (1/e_a + 1/e_b - 1) of
 * plates close together (Siegel and Howell): without a shield, with one, with ten; between walls of
 * many nodes; with an interior; refusals. */
#include "tests/thermal/body_help.h"

static double exchanged_into(const struct help_satellite *s, const char *name,
                             const double *temperature)
{
  size_t n = um_thermal_network_nodes(s->body->network);
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  const struct um_thermal_place *p = help_place(s, name);
  double sum = 0.0;
  assert_non_null(heat);
  OK(um_thermal_heat_of_nodes(help_context, s->body->network, NULL, &options, 0.0, temperature,
                              heat));
  for (size_t i = 0; i < p->nnode; i++) sum += heat[p->node[i]].exchanged;
  free(heat);
  return sum;
}

static double grey(double a, double b) { return 1.0 / (1.0 / a + 1.0 / b - 1.0); }

/* 400 and 300 K, emittances 0.8 and 0.3; shields of 0.05 on both sides. The plates radiate nowhere
 * else; a shield is a plate of one layer. Digits as printed. */
static void shields(void **state)
{
  (void)state;
  static const struct {
    int shields;
    double heat, tolerance; /* [W/m^2] */
  } row[] = {{0, 276.92526, 1e-5}, {1, 23.30291, 1e-5}, {10, 2.521234, 1e-6}};
  static const char *const name[12] = {"hot", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"};
  for (int k = 0; k < 3; k++) {
    struct help_satellite s = {0};
    struct um_thermal_contact contact[11];
    int n = row[k].shields;
    const char *at[12];
    for (int i = 0; i < n + 2; i++) {
      at[i] = i == n + 1 ? "cold" : name[i];
      size_t p = help_part(&s, at[i], UM_SHAPE_PLATE, "paint");
      s.spec[p].kind = UM_THERMAL_LUMPED;
      s.spec[p].shell.through_conductance = INFINITY;
      s.shape[p].position = um_vec3(0, 0, 0.01 * i);
      s.group[p] = (struct um_thermal_group_spec){.absorptance_front = 1.0};
    }
    for (int i = 0; i <= n; i++) {
      double a = i == 0 ? 0.8 : 0.05, b = i == n ? 0.3 : 0.05;
      contact[i] = (struct um_thermal_contact){
          .a = at[i], .b = at[i + 1], .exchange_area = 1.0 * grey(a, b)};
    }
    help_build(&s, contact, (size_t)n + 1);
    /* walls of 1e9 W/K hold the plates; a steady state wants a node that is free */
    for (int end = 0; end < 2; end++) {
      double held = end ? 300.0 : 400.0;
      uint32_t wall = help_boundary(s.body->network, held);
      OK(um_thermal_network_conductor_add(s.body->network, wall,
                                          help_place(&s, end ? "cold" : "hot")->node[0], 1e9));
    }
    double *t = help_steady(&s, NULL, 0.0);
    double heat = exchanged_into(&s, "cold", t);
    print_message("%d shields: %.6f W/m2\n", n, heat);
    NEAR("heat", heat, row[k].heat, row[k].tolerance);
    free(t);
    help_end(&s);
  }
}

/* Fields of nodes: all of both places takes part, by area, though they are far apart and turned;
 * the whole is E, and between equal plates each point meets the one before it. */
static void fields(void **state)
{
  (void)state;
  for (int apart = 0; apart < 2; apart++) {
    struct help_satellite s = {0};
    for (int i = 0; i < 2; i++) {
      size_t p = help_part(&s, i ? "above" : "below", UM_SHAPE_PLATE, "paint");
      s.shape[p].facet_size = 0.3;
      s.shape[p].position = um_vec3(0, 0, i * (apart ? 5.0 : 0.1));
      if (i && apart) s.shape[p].rotation = um_quat_from_axis(um_vec3(1, 0, 0), 1.0);
      s.spec[p].shell.through_conductance = INFINITY;
    }
    const struct um_thermal_contact contact = {.a = "below", .b = "above", .exchange_area = 0.7};
    help_build(&s, &contact, 1);
    size_t n = um_thermal_network_nodes(s.body->network);
    double *t = calloc(n, sizeof *t), *heat = calloc(n, sizeof *heat);
    assert_non_null(t);
    assert_non_null(heat);
    const struct um_thermal_place *below = help_place(&s, "below"),
                                  *above = help_place(&s, "above");
    for (size_t i = 0; i < below->nnode; i++) t[below->node[i]] = 400.0;
    for (size_t i = 0; i < above->nnode; i++) t[above->node[i]] = 300.0;
    double expected = 0.7 * UM_STEFAN_BOLTZMANN * (pow(400, 4) - pow(300, 4));
    NEAR("all", exchanged_into(&s, "above", t), expected, 1e-9 * expected);
    NEAR("none", exchanged_into(&s, "below", t) + exchanged_into(&s, "above", t), 0.0, 1e-9);
    /* every node takes part */
    struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
    struct um_thermal_heat *flow = calloc(n, sizeof *flow);
    assert_non_null(flow);
    OK(um_thermal_heat_of_nodes(help_context, s.body->network, NULL, &options, 0.0, t, flow));
    for (size_t i = 0; i < below->nnode; i++) {
      double share = flow[below->node[i]].exchanged / (-expected);
      assert_true(share > 0.0);
      if (!apart) NEAR("share", share, below->weight[i], 1e-9);
    }
    free(flow);
    free(heat);
    free(t);
    help_end(&s);
  }
}

/* An interior of 60 W that has no way out but by radiation to the walls. */
static void interior(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.shape[p].facet_size = 0.6;
  help_interior(&s, p, "interior", 1e4, 0.0)->power = 60.0;
  s.spec[p].shell.through_conductance = INFINITY;
  const struct um_thermal_contact contact = {.a = "bus.interior", .b = "bus", .exchange_area = 0.4};
  help_build(&s, &contact, 1);
  double *t = help_steady(&s, NULL, 0.0);
  double wall = pow(60.0 / (UM_STEFAN_BOLTZMANN * 6.0), 0.25);
  double inner = pow(pow(wall, 4) + 60.0 / (UM_STEFAN_BOLTZMANN * 0.4), 0.25);
  NEAR("interior", t[help_place(&s, "bus.interior")->node[0]], inner, 1e-6);
  NEAR("walls", help_mean(&s, "bus", t), wall, 1e-6);
  free(t);
  /* and on the way there, from 300 K: the walls cool by s T^4 / (4860 J/m2/K), the interior warms
   * by 60 W, and what this difference sends grows with time */
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  struct um_thermal_history *h = NULL;
  const double time[2] = {0.0, 1.0};
  OK(um_thermal_solve(help_context, s.body->network, NULL, &options, NULL, 0.0, time, 2, &h));
  uint32_t node = help_place(&s, "bus.interior")->node[0];
  double apart = UM_STEFAN_BOLTZMANN * pow(300, 4) / 4860.0 + 60.0 / 1e4;    /* [K/s] */
  double sent = 0.4 * UM_STEFAN_BOLTZMANN * 4.0 * pow(300, 3) * apart / 2.0; /* [W], mean */
  NEAR("warmer", h->temperature[h->nnode + node] - h->temperature[node], (60.0 - sent) / 1e4, 2e-8);
  assert_true(h->audit_error < 1e-6);
  um_thermal_history_destroy(help_context, &h);
  help_end(&s);
}

static void refused(const struct um_thermal_contact *contact, const char *message)
{
  struct help_satellite s = {0};
  help_part(&s, "a", UM_SHAPE_PLATE, "paint");
  help_part(&s, "b", UM_SHAPE_PLATE, "paint");
  s.shape[1].position = um_vec3(0, 0, 1);
  help_geometry(&s);
  assert_int_equal(
      um_thermal_body_create(help_context, s.geometry, s.spec, s.npart, contact, 1, &s.body),
      UM_ERR_INPUT);
  assert_string_equal(um_core_message(help_context), message);
  um_core_message_clear(help_context);
  help_end(&s);
}

static void refusals(void **state)
{
  (void)state;
  refused(&(struct um_thermal_contact){.a = "a", .b = "b", .exchange_area = -1.0},
          "contact a - b: exchange area -1 m2; accepted: finite, not negative");
  refused(&(struct um_thermal_contact){.a = "a", .b = "b", .exchange_area = NAN},
          "contact a - b: exchange area nan m2; accepted: finite, not negative");
  refused(&(struct um_thermal_contact){.a = "a", .b = "b", .conductance = 2.0, .exchange_area = 1},
          "contact a - b: conducts 2 W/K and radiates over 1 m2; accepted: one of the two");
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(shields), cmocka_unit_test(fields),
                                     cmocka_unit_test(interior), cmocka_unit_test(refusals)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
