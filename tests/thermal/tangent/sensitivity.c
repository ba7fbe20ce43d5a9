/* Sensitivities: closed forms of one node, differences of tight runs of the spinning box over all
 * kinds of parameters, instants of switching, the periodic state.
 *
 *   C dT/dt = P - G (T - T_b), T(0) = T_0, tau = C/G, e = exp(-t/tau), T_e = T_b + P/G
 *   dT/dP = (1 - e) / G        dT/dT_0 = e           dT/dT_b = 1 - e
 *   dT/dC = (T_0 - T_e) t/(tau C) e
 *   dT/dG = -P/G^2 (1 - e) - (T_0 - T_e) t/C e
 *
 * Asked: 1e-3 of the largest answer of a parameter, what steps held to 1e-4 give. Central
 * differences: runs with tolerances of 1e-10, steps of 1e-2 of the parameter: 1e-4 of curvature,
 * and up to 1e-5 K of integration. */
#include <stdlib.h>

#include "tests/support/whole.h"
#include "tests/thermal/law_help.h"
#include "thermal/network/network_group.h"
#include "thermal/tangent/sensitivity.h"

#define ASKED 1e-3

struct kept {
  double *s; /* [ntime][nvariant][nnode] */
  size_t nvariant, nnode, calls;
};
static enum um_status keep(void *user, size_t k, const double *temperature, const double *s)
{
  struct kept *kept = user;
  size_t n = kept->nvariant * kept->nnode;
  (void)temperature;
  memcpy(kept->s + k * n, s, n * sizeof *s);
  assert_int_equal(k, kept->calls++);
  return UM_OK;
}

/* --- closed forms --------------------------------------------------------------------------- */

/* Capacity 400 J/K, conductance 4 W/K, power 20 W, start 300 K, boundary 250 K; one moved. */
static struct um_thermal_network *node_network(int which, double by)
{
  double value[5] = {20.0, 300.0, 250.0, 400.0, 4.0};
  if (which >= 0) value[which] += by;
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, value[3], value[1]), wall = help_boundary(network, value[2]);
  um_thermal_network_power_set(network, node, value[0]);
  OK(um_thermal_network_conductor_add(network, node, wall, value[4]));
  return network;
}

static void test_closed_forms(void **state)
{
  (void)state;
  static const double times[5] = {0.0, 40.0, 100.0, 250.0, 900.0};
  static const double step[5] = {0.1, 0.1, 0.1, 0.01, 1e-4};
  struct um_thermal_network *network = node_network(-1, 0.0);
  struct um_thermal_variant variant[5];
  struct um_thermal_solve_options options = help_options(1e-8, 1e-6, 0.0);
  double s[5 * 5 * 2];
  struct kept kept = {s, 5, 2, 0};
  for (int k = 0; k < 5; k++)
    variant[k] = (struct um_thermal_variant){node_network(k, step[k]), NULL, NULL, step[k], NULL};
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = 5};
  OK(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, times, 5, &forcings,
                            NULL, keep, &kept));
  assert_int_equal(kept.calls, 5);
  for (size_t i = 0; i < 5; i++) {
    double t = times[i], e = exp(-t / 100.0), beyond = 300.0 - 255.0;
    const double exact[5] = {(1.0 - e) / 4.0, e, 1.0 - e, beyond * t / (100.0 * 400.0) * e,
                             -20.0 / 16.0 * (1.0 - e) - beyond * t / 400.0 * e};
    const double largest[5] = {0.25, 1.0, 1.0, 45.0 * 0.3679 / 400.0, 4.9};
    for (size_t k = 0; k < 5; k++) {
      NEAR("node", s[(i * 5 + k) * 2] / largest[k], exact[k] / largest[k], 3e-4);
      NEAR("boundary", s[(i * 5 + k) * 2 + 1], k == 2 ? 1.0 : 0.0, 1e-9);
    }
  }
  for (int k = 0; k < 5; k++)
    um_thermal_network_destroy((struct um_thermal_network **)&variant[k].network);
  um_thermal_network_destroy(&network);
}

/* --- the spinning box ----------------------------------------------------------------------- */

#define CELLS      2
#define PARAMETERS 13
#define PERIOD     6000.0
static const char *const parameter_name[PARAMETERS] = {
    "capacity of walls",    "capacity of the interior", "MLI effective emittance",
    "wall to interior",     "in-plane conductance",     "emittance of skins",
    "absorptance of skins", "extraction of the panel",  "power of the interior",
    "emittance of panels",  "start of the interior",    "slopes of capacities",
    "exponents of blankets"};
#define OF_LAWS 11 /* the first of what acts where there are laws */

static void surfaces_move(struct um_thermal_network *network, size_t first, size_t last, int what,
                          double factor)
{
  for (size_t k = first; k < last; k++) {
    struct um_thermal_surface *s = &network->surface[k];
    if (what == 0) s->emittance *= factor;
    if (what == 1) s->absorptance *= factor;
    if (what == 2) s->extraction += 0.2 * (factor - 1.0);
  }
}

static bool by_temperature; /* capacities and links go with it */

/* A part of the sweep differences every third parameter, others in each test, and those of laws. */
static bool is_tried(int which, int shift)
{
  return um_test_whole() || which % 3 == shift || which >= OF_LAWS;
}

/* Parameter `which` times `factor`. */
static struct um_thermal_network *box(int which, double factor, double skin)
{
  uint32_t interior;
  struct um_thermal_network *network = box_network(CELLS, skin, &interior);
  size_t nskin = 6 * CELLS * CELLS, nsurface = 10 * CELLS * CELLS;
  if (by_temperature) law_give(network);
  for (size_t i = 1; i < network->nnode && which == 0; i++) network->node[i].capacity *= factor;
  for (size_t k = 0; k < network->nstore && which == 0; k++) network->store[k].capacity *= factor;
  if (which == 1) network->node[interior].capacity *= factor;
  for (size_t k = 0; k < network->nradiator && which == 2; k++)
    network->radiator[k].value *= factor;
  for (size_t k = 0; k < network->nconductor; k++) {
    struct um_thermal_link *link = &network->conductor[k];
    bool inside = link->a == interior || link->b == interior;
    if (which == 3 && inside) link->value *= factor;
    if (which == 4 && !inside) link->value *= factor;
  }
  if (which == 5) surfaces_move(network, 0, nskin, 0, factor);
  if (which == 6) surfaces_move(network, 0, nskin, 1, factor);
  if (which == 7) surfaces_move(network, nskin, nsurface, 2, factor);
  if (which == 8) network->node[interior].power *= factor;
  if (which == 9) surfaces_move(network, nskin, nsurface, 0, factor);
  if (which == 10) network->node[interior].temperature *= factor;
  for (size_t l = 0; l < network->ncapacity_law && which == 11; l++)
    for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++)
      network->capacity_law[l]->at[k] = 1.0 + factor * (network->capacity_law[l]->at[k] - 1.0);
  for (size_t l = 0; l < network->nlink_law && which == 12; l++)
    network->link_law[l].exponent[0] += factor - 1.0;
  return network;
}

static double relative(const double *s, const double *up, const double *down, double width,
                       size_t n, double *largest)
{
  double worst = 0.0;
  *largest = 0.0;
  for (size_t i = 0; i < n; i++) *largest = fmax(*largest, fabs(up[i] - down[i]) / width);
  for (size_t i = 0; i < n; i++)
    worst = fmax(worst, fabs(s[i] - (up[i] - down[i]) / width) / *largest);
  return worst;
}

static void against_differences(double skin, int shift)
{
  const int count = by_temperature ? PARAMETERS : OF_LAWS;
  const struct um_thermal_sensitivity_options how = {by_temperature ? 5e-5 : 0.0, NULL};
  static const double times[4] = {700.0, 2099.0, 4000.0, 6000.0};
  struct um_thermal_solve_options options, tight = help_options(1e-10, 1e-8, 3.0);
  um_thermal_solve_defaults(&options);
  options.space_temperature = 3.0;
  struct um_thermal_network *network = box(-1, 1.0, skin);
  struct um_irradiation_loads *loads = box_loads(CELLS, 121, PERIOD, 3.0);
  struct um_thermal_variant variant[PARAMETERS];
  size_t n = network->nnode;
  struct kept kept = {calloc(4 * PARAMETERS * n, sizeof(double)), (size_t)count, n, 0};
  assert_non_null(kept.s);
  for (int p = 0; p < count; p++)
    variant[p] = (struct um_thermal_variant){box(p, 1.00001, skin), loads, NULL, 1e-5, NULL};
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = (size_t)count};
  OK(um_thermal_sensitivity(help_context, network, loads, &options, NULL, 0.0, times, 4, &forcings,
                            &how, keep, &kept));
  for (int p = 0; p < count; p++) {
    struct um_thermal_history *h[2];
    double worst = 0.0, largest, most = 0.0;
    if (!is_tried(p, shift)) {
      um_thermal_network_destroy((struct um_thermal_network **)&variant[p].network);
      continue;
    }
    for (int side = 0; side < 2; side++) {
      struct um_thermal_network *moved = box(p, side == 0 ? 1.01 : 0.99, skin);
      OK(um_thermal_solve(help_context, moved, loads, &tight, NULL, 0.0, times, 4, &h[side]));
      um_thermal_network_destroy(&moved);
    }
    for (size_t k = 0; k < 4; k++) {
      size_t row = k * n;
      double off = relative(kept.s + (k * (size_t)count + (size_t)p) * n, h[0]->temperature + row,
                            h[1]->temperature + row, 2e-2, n, &largest);
      worst = fmax(worst, off * largest);
      most = fmax(most, largest);
    }
    print_message("%-26s at most %8.3f K, off by %.1e of it\n", parameter_name[p], most,
                  worst / most);
    NEAR(parameter_name[p], worst / most, 0.0, ASKED);
    um_thermal_history_destroy(help_context, &h[0]);
    um_thermal_history_destroy(help_context, &h[1]);
    um_thermal_network_destroy((struct um_thermal_network **)&variant[p].network);
  }
  free(kept.s);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

static void test_box(void **state)
{
  (void)state;
  against_differences(77.4, 0);
}
static void test_box_massless(void **state)
{
  (void)state;
  against_differences(0.0, 1);
}
/* Where capacities, walls and blankets go with temperature, and for what their laws say; steps held
 * to half of the default, whose own error is 1.04e-3 for the capacity of walls. */
static void test_box_by_temperature(void **state)
{
  (void)state;
  by_temperature = true;
  against_differences(77.4, 0);
  by_temperature = false;
}

/* The periodic state's answers against periodic states of moved networks, 2e-6 K from periodic
 * each: 2e-4 K of the difference of two over 2e-2. They are integrated to 1e-10: the interior,
 * which an orbit moves by a fiftieth of its distance, shows fifty times what an orbit's errors are.
 */
static void periodic_against_differences(int shift)
{
  struct um_thermal_solve_options tight = help_options(1e-10, 1e-8, 3.0), options;
  um_thermal_solve_defaults(&options);
  options.space_temperature = 3.0;
  struct um_thermal_network *network = box(-1, 1.0, 77.4);
  struct um_irradiation_loads *loads = box_loads(CELLS, 121, PERIOD, 3.0);
  struct um_thermal_variant variant[PARAMETERS];
  const int which[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12};
  const size_t count = by_temperature ? 12 : 10; /* what a start is does not last */
  size_t n = network->nnode;
  double *s = calloc((PARAMETERS + 2) * n, sizeof *s), *up = s + (PARAMETERS - 1) * n, drift;
  double *down = up + n, *base = down + n;
  assert_non_null(s);
  OK(um_thermal_solve_periodic(help_context, network, loads, &tight, NULL, 0.0, PERIOD, 2e-6, base,
                               &drift));
  for (size_t p = 0; p < count; p++)
    variant[p] = (struct um_thermal_variant){box(which[p], 1.00001, 77.4), loads, NULL, 1e-5, NULL};
  OK(um_thermal_sensitivity_periodic(help_context, network, loads, &options, base, 0.0, PERIOD,
                                     variant, count, NULL, s));
  for (size_t p = 0; p < count; p++) {
    if (!is_tried(which[p], shift)) {
      um_thermal_network_destroy((struct um_thermal_network **)&variant[p].network);
      continue;
    }
    for (int side = 0; side < 2; side++) {
      struct um_thermal_network *moved = box(which[p], side == 0 ? 1.01 : 0.99, 77.4);
      OK(um_thermal_solve_periodic(help_context, moved, loads, &tight, base, 0.0, PERIOD, 2e-6,
                                   side == 0 ? up : down, &drift));
      um_thermal_network_destroy(&moved);
    }
    double largest, worst = relative(s + p * n, up, down, 2e-2, n, &largest);
    print_message("%-26s at most %8.3f K, off by %.1e of it\n", parameter_name[which[p]], largest,
                  worst);
    NEAR(parameter_name[which[p]], worst * largest, 0.0, ASKED * largest + 2e-4);
    um_thermal_network_destroy((struct um_thermal_network **)&variant[p].network);
  }
  free(s);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

static void test_periodic(void **state)
{
  (void)state;
  periodic_against_differences(2);
}
static void test_periodic_by_temperature(void **state)
{
  (void)state;
  by_temperature = true;
  periodic_against_differences(0);
  by_temperature = false;
}

/* --- thermostats ---------------------------------------------------------------------------- */

/* A plate that a heater of 30 W holds between two thresholds, sensed by a tag on it. */
static struct um_thermal_network *heated(int which, double factor)
{
  double value[5] = {1.0, 1.0, 1.0, 1.0, 1.0};
  if (which >= 0) value[which] = factor;
  struct um_thermal_network *network = help_network();
  uint32_t plate = help_node(network, 900.0 * value[0], 292.0),
           tag = help_node(network, 60.0, 292.0);
  const double one = 1.0;
  const struct um_thermal_thermostat thermostat = {.node = &plate,
                                                   .weight = &one,
                                                   .nnode = 1,
                                                   .sensor = &tag,
                                                   .sensor_weight = &one,
                                                   .nsensor = 1,
                                                   .power = 30.0 * value[1],
                                                   .on = 288.0 * value[2],
                                                   .off = 291.0 * value[3]};
  OK(um_thermal_network_radiator_add(network, plate, UM_THERMAL_SPACE, 0.04 * value[4]));
  OK(um_thermal_network_conductor_add(network, plate, tag, 2.0));
  OK(um_thermal_network_thermostat_add(network, &thermostat));
  return network;
}

static void test_thermostat(void **state)
{
  (void)state;
  static const char *const name[5] = {"capacity", "heater power", "threshold on", "threshold off",
                                      "radiator"};
  const double times[3] = {900.0, 1700.0, 2500.0};
  struct um_thermal_solve_options tight = help_options(1e-11, 1e-9, 3.0),
                                  options = help_options(1e-8, 1e-6, 3.0);
  struct um_thermal_network *network = heated(-1, 1.0);
  struct um_thermal_variant variant[5];
  double s[3 * 5 * 2];
  struct kept kept = {s, 5, 2, 0};
  for (int p = 0; p < 5; p++)
    variant[p] = (struct um_thermal_variant){heated(p, 1.00001), NULL, NULL, 1e-5, NULL};
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = 5};
  OK(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, times, 3, &forcings,
                            NULL, keep, &kept));
  for (int p = 0; p < 5; p++) {
    struct um_thermal_history *h[2];
    double worst = 0.0, most = 0.0, largest;
    for (int side = 0; side < 2; side++) {
      struct um_thermal_network *moved = heated(p, side == 0 ? 1.00001 : 0.99999);
      OK(um_thermal_solve(help_context, moved, NULL, &tight, NULL, 0.0, times, 3, &h[side]));
      um_thermal_network_destroy(&moved);
    }
    for (size_t k = 0; k < 3; k++) {
      double off = relative(s + (k * 5 + (size_t)p) * 2, h[0]->temperature + 2 * k,
                            h[1]->temperature + 2 * k, 2e-5, 2, &largest);
      worst = fmax(worst, off * largest);
      most = fmax(most, largest);
    }
    print_message("%-26s at most %8.3f K, off by %.1e of it\n", name[p], most, worst / most);
    NEAR(name[p], worst / most, 0.0, ASKED);
    um_thermal_history_destroy(help_context, &h[0]);
    um_thermal_history_destroy(help_context, &h[1]);
    um_thermal_network_destroy((struct um_thermal_network **)&variant[p].network);
  }
  um_thermal_network_destroy(&network);
}

/* --- refused -------------------------------------------------------------------------------- */

static enum um_status ignore(void *user, size_t k, const double *temperature, const double *s)
{
  (void)user, (void)k, (void)temperature, (void)s;
  return UM_OK;
}

static void test_refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = node_network(-1, 0.0), *other = heated(-1, 1.0);
  struct um_irradiation_loads *loads = box_loads(1, 11, 100.0, 1.0);
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
  const struct um_thermal_variant variant[3] = {{network, NULL, NULL, 0.0, NULL},
                                                {other, NULL, NULL, 1.0, NULL},
                                                {network, loads, NULL, 1.0, NULL}};
  static const char *const words[3] = {"step 0; accepted", "other nodes, thermostats",
                                       "other times or edges"};
  const double t = 10.0;
  for (int k = 0; k < 3; k++) {
    const struct um_thermal_forcings forcings = {.variant = &variant[k], .nvariant = 1};
    um_core_message_clear(help_context);
    assert_int_equal(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, &t, 1,
                                            &forcings, NULL, ignore, NULL),
                     UM_ERR_INPUT);
    if (strstr(um_core_message(help_context), words[k]) == NULL)
      fail_msg("'%s' lacks '%s'", um_core_message(help_context), words[k]);
  }
  um_core_message_clear(help_context);
  um_thermal_network_destroy(&network);
  um_thermal_network_destroy(&other);
  um_irradiation_loads_destroy(help_context, &loads);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_closed_forms),       cmocka_unit_test(test_box),
      cmocka_unit_test(test_box_massless),       cmocka_unit_test(test_periodic),
      cmocka_unit_test(test_box_by_temperature), cmocka_unit_test(test_periodic_by_temperature),
      cmocka_unit_test(test_thermostat),         cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
