/* Building and reading networks; the 5-node transient; what is refused. */
#include <stdlib.h>

#include "tests/thermal/network_help.h"
#include "thermal/network/network_group.h"

/* C = 1,2,3,4,1000 J/K, T0 = 20,30,40,50,0 degC, G01 10, G12 1, G13 5, G34 2 W/K, 5 W into node 0.
 * Exact at 10 s by the matrix exponential, printed to 1e-6 K. (The ESATAN-TMS run of the same case
 * is within its own step error of it.) */
static void test_simple_transient(void **state)
{
  (void)state;
  const double capacity[5] = {1, 2, 3, 4, 1000}, start[5] = {20, 30, 40, 50, 0};
  const double exact[5] = {11.493608, 10.893738, 15.826465, 8.313891, 0.335984};
  const double zero = 273.15;
  struct um_thermal_network *network = help_network();
  for (int k = 0; k < 5; k++) help_node(network, capacity[k], zero + start[k]);
  OK(um_thermal_network_conductor_add(network, 0, 1, 10.0));
  OK(um_thermal_network_conductor_add(network, 1, 2, 1.0));
  OK(um_thermal_network_conductor_add(network, 1, 3, 5.0));
  OK(um_thermal_network_conductor_add(network, 3, 4, 2.0));
  um_thermal_network_power_set(network, 0, 5.0);
  struct um_thermal_solve_options options = help_options(1e-11, 1e-9, 0.0);
  const double times[2] = {0.0, 10.0};
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, times, 2, &history));
  for (size_t k = 0; k < 5; k++) {
    NEAR("at 0 s", history->temperature[k], zero + start[k], 0.0);
    NEAR("at 10 s", history->temperature[5 + k] - zero, exact[k], 1e-6);
  }
  NEAR("internal heat", history->audit.internal, 50.0, 1e-6);
  if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

/* The same network written down in another order, links split in parts: the same answer. */
static void test_merging(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t a = help_node(network, 100.0, 300.0), b = help_node(network, 100.0, 200.0);
  for (int k = 0; k < 10; k++) {
    OK(um_thermal_network_conductor_add(network, k % 2 ? a : b, k % 2 ? b : a, 0.3));
    OK(um_thermal_network_conductor_add(network, a, b, -0.1));
  }
  /* 10 (0.3 - 0.1) = 2 W/K: difference decays with 2 K/C = 0.04 /s */
  NEAR("merged", help_temperature_at(network, 0.0, a, 20.0), 250.0 + 50.0 * exp(-0.8), 1e-6);
  um_thermal_network_destroy(&network);
}

/* T_s = (sum w T^4)^(1/4); exactly the node's where there is one; gaps are NaN. */
static void test_surface_temperatures(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  for (int k = 0; k < 3; k++) help_node(network, 1.0, 300.0);
  struct um_thermal_surface surface = {
      .node = {0, 1, 2}, .weight = {0.25, 0.25, 0.5}, .area = 2.0, .emittance = 0.5};
  OK(um_thermal_network_surface_attach(network, 2, &surface));
  help_surface(network, 0, 1, 1.0, 0.5, 0.5);
  assert_int_equal(um_thermal_network_surfaces(network), 3);
  assert_null(um_thermal_network_surface(network, 1));
  const double node[3] = {200.0, 271.3, 300.0};
  double shown[3];
  um_thermal_surface_temperatures(network, node, shown);
  assert_true(shown[0] == 271.3);
  assert_true(isnan(shown[1]));
  double mean4 = 0.25 * pow(200.0, 4) + 0.25 * pow(271.3, 4) + 0.5 * pow(300.0, 4);
  NEAR("fourth-power mean", shown[2], pow(mean4, 0.25), 1e-10);
  um_thermal_network_destroy(&network);
}

#define REFUSED(call, words)                                                                       \
  do {                                                                                             \
    um_core_message_clear(help_context);                                                           \
    assert_int_equal((call), UM_ERR_INPUT);                                                        \
    if (strstr(um_core_message(help_context), words) == NULL)                                      \
      fail_msg("'%s' does not say '%s'", um_core_message(help_context), words);                    \
    um_core_message_clear(help_context);                                                           \
  } while (0)

static void test_refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t i;
  REFUSED(um_thermal_network_node_add(network, "a", UM_NODE_DIFFUSIVE, -1.0, 300, 0, &i), "'a'");
  REFUSED(um_thermal_network_node_add(network, "a", UM_NODE_DIFFUSIVE, 1.0, NAN, 0, &i), "K;");
  REFUSED(um_thermal_network_node_add(network, "a", UM_NODE_DIFFUSIVE, 1.0, 1, INFINITY, &i), "W;");
  REFUSED(um_thermal_network_node_add(network, "a", UM_NODE_ARITHMETIC, 1.0, 300, 0, &i), "arith");
  uint32_t a = help_node(network, 1.0, 300.0), b = help_node(network, 1.0, 300.0);
  REFUSED(um_thermal_network_conductor_add(network, a, 7, 1.0), "node 7");
  REFUSED(um_thermal_network_conductor_add(network, a, a, 1.0), "itself");
  REFUSED(um_thermal_network_conductor_add(network, a, b, NAN), "W/K");
  REFUSED(um_thermal_network_conductor_add(network, a, UM_THERMAL_SPACE, 1.0), "space");
  REFUSED(um_thermal_network_radiator_add(network, a, b, -1.0), "m2");
  struct um_thermal_surface s = {.node = {a, b, UM_THERMAL_SPACE},
                                 .weight = {0.5, 0.4, 0.0},
                                 .area = 1.0,
                                 .absorptance = 0.5,
                                 .emittance = 0.5};
  REFUSED(um_thermal_network_surface_attach(network, 0, &s), "weights");
  s.weight[1] = 0.5;
  s.emittance = 1.5;
  REFUSED(um_thermal_network_surface_attach(network, 0, &s), "emittance 1.5");
  s.emittance = 0.5;
  OK(um_thermal_network_surface_attach(network, 0, &s));
  REFUSED(um_thermal_network_surface_attach(network, 0, &s), "twice");
  /* a diffusive node left without capacity, and an arithmetic one that floats */
  help_node(network, 0.0, 300.0);
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
  struct um_thermal_history *history = NULL;
  double t = 1.0;
  REFUSED(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history),
          "node 2");
  network->node[2].capacity = 1.0;
  help_arithmetic(network, 300.0);
  REFUSED(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history),
          "node 3");
  options.relative_tolerance = NAN;
  REFUSED(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history),
          "relative tolerance");
  um_thermal_network_destroy(&network);
}

static const char *const node_table = "# SimpleTransient\n"
                                      "name,kind,capacity_J_K,T0_K,power_W\n"
                                      "n0,diffusive,1,293.15,5\n"
                                      "n1,diffusive,2,303.15,0\n"
                                      "n2,diffusive,3,313.15,\n"
                                      "n3,diffusive,4,323.15,0\n"
                                      "n4,diffusive,1000,273.15,0\n"
                                      "skin,arithmetic,,250,0\n"
                                      "sink,boundary,0,4,0\n";
static const char *const link_table = "kind,a,b,value\n"
                                      "GL,n0,n1,10\n"
                                      "GL,n1,n2,1\n"
                                      "GL,n1,n3,5\n"
                                      "GL,n3,n4,2\n"
                                      "GR,skin,sink,0.5\n"
                                      "GR,space,skin,0.5\n";

/* Write a text into a file of the working folder, read both tables, remove them. */
static enum um_status read_tables(const char *nodes, const char *links,
                                  struct um_thermal_network **out)
{
  const char *const path[2] = {"thermal_network_nodes.csv", "thermal_network_conductors.csv"};
  const char *const text[2] = {nodes, links};
  for (int k = 0; k < 2; k++) {
    FILE *file = fopen(path[k], "wb");
    assert_non_null(file);
    fputs(text[k], file);
    fclose(file);
  }
  enum um_status status = um_thermal_network_read(help_context, path[0], path[1], out);
  for (int k = 0; k < 2; k++) remove(path[k]);
  return status;
}

static void test_read(void **state)
{
  (void)state;
  struct um_thermal_network *network = NULL;
  OK(read_tables(node_table, link_table, &network));
  assert_int_equal(um_thermal_network_nodes(network), 7);
  assert_int_equal(um_thermal_network_find(network, "n3"), 3);
  assert_true(um_thermal_network_find(network, "n9") == (size_t)-1);
  assert_int_equal(um_thermal_network_kind(network, 5), UM_NODE_ARITHMETIC);
  assert_int_equal(um_thermal_network_kind(network, 6), UM_NODE_BOUNDARY);
  struct um_thermal_solve_options options = help_options(1e-11, 1e-9, 4.0);
  double t = 10.0;
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history));
  NEAR("n0", history->temperature[0] - 273.15, 11.493608, 1e-6);
  NEAR("skin between 4 K and 4 K", history->temperature[5], 4.0, 1e-6);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

static void test_read_refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = NULL;
  const char *head = "name,kind,capacity_J_K,T0_K,power_W\n";
  static const struct {
    const char *row, *words;
  } rows[] = {{"a,lumped,1,300,0\n", "lumped"},
              {"a,diffusive,0,300,0\n", "capacity_J_K"},
              {"a,diffusive,1,nan,0\n", "T0_K"},
              {"a,diffusive,1,-3,0\n", "T0_K"},
              {"space,diffusive,1,3,0\n", "space"},
              {"a,arithmetic,2,3,0\n", "arithmetic"},
              {"b,boundary,0,3,0\nb,boundary,0,3,0\n", "twice"}};
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    char text[256];
    snprintf(text, sizeof text, "%s%s", head, rows[k].row);
    REFUSED(read_tables(text, link_table, &network), rows[k].words);
    assert_null(network);
  }
  static const struct {
    const char *text, *words;
  } links[] = {
      {"kind,a,b,value\nGX,n0,n1,1\n", "GX"},  {"kind,a,b,value\nGL,n0,n8,1\n", "'n8'"},
      {"kind,a,b,value\nGL,n0,n0,1\n", ":2:"}, {"kind,a,b,value\nGL,n0,space,1\n", "GL to space"},
      {"kind,a,b,value\nGR,n0,n1,-1\n", "m2"}, {"kind,a,b\nGR,n0,n1\n", "value"}};
  for (size_t k = 0; k < sizeof links / sizeof links[0]; k++) {
    REFUSED(read_tables(node_table, links[k].text, &network), links[k].words);
    assert_null(network);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_simple_transient),
                                     cmocka_unit_test(test_merging),
                                     cmocka_unit_test(test_surface_temperatures),
                                     cmocka_unit_test(test_refused),
                                     cmocka_unit_test(test_read),
                                     cmocka_unit_test(test_read_refused)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
