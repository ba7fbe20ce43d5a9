/* Sensitivities to the power of pulses: closed forms where the network is linear, differences of
 * full runs where it is not, and errors that fall with the tolerance.
 *
 *   C dS/dt = -G S + 1 (on)      S = (1 - exp(-t/tau)) / G on, exp(-t/tau) after, tau = C/G
 */
#include "thermal/tangent/sensitivity.h"
#include <stdlib.h>

#include "tests/thermal/network_help.h"

#define START 6.0e8 /* [s] as late as t_tai is */

/* Everything handed over: [ntime][nsource][nnode]. */
struct kept {
  double *response, *temperature;
  size_t nsource, nnode, calls;
};
static enum um_status keep(void *user, size_t k, const double *temperature, const double *response)
{
  struct kept *kept = user;
  size_t n = kept->nsource * kept->nnode;
  memcpy(kept->response + k * n, response, n * sizeof *response);
  memcpy(kept->temperature + k * kept->nnode, temperature, kept->nnode * sizeof *temperature);
  assert_int_equal(k, kept->calls++);
  return UM_OK;
}
static struct kept kept_create(size_t ntime, size_t nsource, size_t nnode)
{
  struct kept kept = {.nsource = nsource, .nnode = nnode};
  kept.response = calloc(ntime * nsource * nnode, sizeof(double));
  kept.temperature = calloc(ntime * nnode, sizeof(double));
  assert_true(kept.response != NULL && kept.temperature != NULL);
  return kept;
}
static void kept_free(struct kept *kept)
{
  free(kept->response);
  free(kept->temperature);
}
static double at(const struct kept *kept, size_t time, size_t source, size_t node)
{
  return kept->response[(time * kept->nsource + source) * kept->nnode + node];
}

/* Linear, tau = 100 s: on from 50 to 250 s; the same listed later but beginning earlier; from a
 * state of 2 K/W. */
static void test_single_node(void **state)
{
  (void)state;
  const double capacity = 400.0, conductance = 4.0, tau = capacity / conductance;
  struct um_thermal_network *network = help_network();
  uint32_t boundary = help_boundary(network, 250.0), node = help_node(network, capacity, 300.0);
  OK(um_thermal_network_conductor_add(network, boundary, node, conductance));
  const double one = 1.0, two = 2.0;
  const struct um_thermal_pulse pulses[3] = {{&node, &one, 1, START + 50, START + 250},
                                             {&node, &two, 1, START - 70, START + 10},
                                             {&node, &one, 1, START + 400, START + 500}};
  const struct um_thermal_forcings forcings = {.pulse = pulses, .npulse = 3};
  const double times[] = {START, START + 50, START + 150, START + 250, START + 400};
  const double begin[6] = {0, 0, 0, 0, 0, 2.0};
  struct um_thermal_solve_options options = help_options(1e-8, 1e-6, 0.0);
  const struct um_thermal_sensitivity_options how = {1e-6, begin};
  struct kept kept = kept_create(5, 3, 2);
  OK(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, START, times, 5, &forcings,
                            &how, keep, &kept));
  double on = -expm1(-200.0 / tau) / conductance;
  const double expected[5] = {0.0, 0.0, -expm1(-100.0 / tau) / conductance, on,
                              on * exp(-150.0 / tau)};
  for (size_t k = 0; k < 5; k++) {
    double t = times[k] - START;
    /* the pulse that began before the run is cut at its start */
    double pulse = t > 0.0 ? 2.0 * -expm1(-10.0 / tau) / conductance * exp(-(t - 10.0) / tau) : 0.0;
    /* asked for 1e-6 of the largest a step */
    NEAR("on from 50 to 250 s", at(&kept, k, 0, node), expected[k], 5e-5 * on);
    NEAR("cut pulse", at(&kept, k, 1, node), pulse, 5e-5 * pulse);
    NEAR("from a state", at(&kept, k, 2, node), 2.0 * exp(-t / tau), 5e-5 * 2.0);
    NEAR("boundary", at(&kept, k, 0, boundary), 0.0, 0.0);
    NEAR("base", kept.temperature[2 * k + node], 250.0 + 50.0 * exp(-t / tau), 1e-4);
  }
  kept_free(&kept);
  um_thermal_network_destroy(&network);
}

/* Wanted times inside steps: a wall that warms, and a skin that has long settled. */
static void test_inside(void **state)
{
  (void)state;
  enum { TIMES = 41 };
  const double tau[2] = {100.0, 4.0}, one = 1.0;
  struct um_thermal_network *network = help_network();
  uint32_t node[2], boundary = help_boundary(network, 250.0);
  struct um_thermal_pulse pulses[2];
  const struct um_thermal_forcings forcings = {.pulse = pulses, .npulse = 2};
  for (int i = 0; i < 2; i++) {
    node[i] = help_node(network, tau[i], 250.0);
    OK(um_thermal_network_conductor_add(network, boundary, node[i], 1.0));
    pulses[i] = (struct um_thermal_pulse){&node[i], &one, 1, 0.0, 400.0};
  }
  double times[TIMES];
  for (int k = 0; k < TIMES; k++) times[k] = 9.7 * k;
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
  const struct um_thermal_sensitivity_options how = {1e-5, NULL};
  struct kept kept = kept_create(TIMES, 2, 3);
  OK(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, times, TIMES,
                            &forcings, &how, keep, &kept));
  assert_int_equal(kept.calls, TIMES);
  double worst = 0.0, settled = 0.0;
  for (size_t k = 0; k < TIMES; k++) {
    worst = fmax(worst, fabs(at(&kept, k, 0, node[0]) + expm1(-times[k] / tau[0])));
    if (times[k] > 150.0) settled = fmax(settled, fabs(at(&kept, k, 1, node[1]) - 1.0));
  }
  print_message("inside: wall %.1e, settled skin %.1e\n", worst, settled);
  NEAR("inside a step", worst, 0.0, 5e-5);
  NEAR("settled", settled, 0.0, 2e-3);
  kept_free(&kept);
  um_thermal_network_destroy(&network);
}

/* Order 3, and an estimate that falls with the third power of the step: errors go with the
 * tolerance. */
static void test_tolerance(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, 100.0, 300.0);
  OK(um_thermal_network_conductor_add(network, help_boundary(network, 300.0), node, 1.0));
  const double one = 1.0, t = 200.0;
  const struct um_thermal_pulse pulse = {&node, &one, 1, 0.0, 200.0};
  const struct um_thermal_forcings forcings = {.pulse = &pulse, .npulse = 1};
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
  double error[3];
  for (int k = 0; k < 3; k++) {
    const struct um_thermal_sensitivity_options how = {1e-4 * pow(0.01, k), NULL};
    struct kept kept = kept_create(1, 1, 2);
    OK(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &forcings,
                              &how, keep, &kept));
    error[k] = fabs(at(&kept, 0, 0, node) + expm1(-2.0));
    kept_free(&kept);
  }
  double power = log(error[0] / error[2]) / log(1e4);
  print_message("errors %.1e %.1e %.1e, as tolerance^%.2f\n", error[0], error[1], error[2], power);
  assert_true(power > 0.8 && power < 1.2);
  um_thermal_network_destroy(&network);
}

/* A box of walls under the Sun and the shadow's edge, MLI skins of 12 s, a massless fitting, an
 * interior. Node order: 6 walls, 6 skins, interior, fitting, boundary. */
enum { WALLS = 6, INTERIOR = 12, FITTING, ROOM, NODES };
static struct um_thermal_network *box(struct um_irradiation_loads **loads)
{
  struct um_thermal_network *network = help_network();
  uint32_t index;
  for (int w = 0; w < WALLS; w++) help_node(network, 1500.0 + 300.0 * w, 270.0 + 5.0 * w);
  for (int w = 0; w < WALLS; w++) help_node(network, 40.0, 260.0 - 4.0 * w);
  index = help_node(network, 30000.0, 290.0);
  assert_int_equal(index, INTERIOR);
  help_arithmetic(network, 280.0);
  help_boundary(network, 280.0);
  for (uint32_t w = 0; w < WALLS; w++) {
    OK(um_thermal_network_radiator_add(network, w, w + WALLS, 0.03));
    OK(um_thermal_network_conductor_add(network, w, INTERIOR, 0.5));
    OK(um_thermal_network_conductor_add(network, w, (w + 1) % WALLS, 0.3));
    help_surface(network, w, w + WALLS, 0.6, 0.4, 0.75);
  }
  OK(um_thermal_network_conductor_add(network, 0, FITTING, 2.0));
  OK(um_thermal_network_conductor_add(network, FITTING, 2, 1.0));
  OK(um_thermal_network_radiator_add(network, FITTING, UM_THERMAL_SPACE, 0.01));
  OK(um_thermal_network_radiator_add(network, FITTING, ROOM, 0.005));
  OK(um_irradiation_loads_create(help_context, 6, WALLS, 1, loads));
  const double t[6] = {0, 400, 400, 500, 900, 1500}, lit[6] = {1, 1, 0, 0, 0, 0};
  (*loads)->edge[0] = START + 400.0;
  for (size_t k = 0; k < 6; k++) {
    (*loads)->t[k] = START + t[k];
    (*loads)->sunlit[k] = lit[k];
    (*loads)->irradiance[k] = 1361.0;
    for (size_t s = 0; s < WALLS; s++) {
      (*loads)->sun[k * WALLS + s] = s < 3 ? 0.3f * (float)s : 0.0f;
      (*loads)->planet[k * WALLS + s] = 30.0f * (float)(s + 1);
    }
  }
  return network;
}

/* Against runs with 1 W more and 1 W less (central: the third order of 1 W is 1e-6 of the answer),
 * for a wall, an interior, the massless fitting, a group, and a skin alone. */
static void test_against_runs(void **state)
{
  (void)state;
  static const struct {
    uint32_t node[2];
    double weight[2], from, to;
  } pulses[] = {{{1, 1}, {1.0, 0.0}, 100, 160},       {{INTERIOR, 0}, {1.0, 0.0}, 300, 700},
                {{FITTING, 0}, {1.0, 0.0}, 390, 450}, {{3, FITTING}, {0.6, 0.4}, 0, 1000},
                {{8, 8}, {0.5, 0.5}, 420, 480},       {{4, 0}, {1.0, 0.0}, 700, 730}};
  enum { PULSES = sizeof pulses / sizeof pulses[0], TIMES = 101 };
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_network *network = box(&loads);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 2.7);
  struct um_thermal_pulse source[PULSES];
  const struct um_thermal_forcings forcings = {.pulse = source, .npulse = PULSES};
  double times[TIMES];
  for (size_t k = 0; k < TIMES; k++) times[k] = START + 10.0 * (double)k;
  for (size_t p = 0; p < PULSES; p++)
    source[p] = (struct um_thermal_pulse){pulses[p].node, pulses[p].weight, 2,
                                          START + pulses[p].from, START + pulses[p].to};
  struct kept kept = kept_create(TIMES, PULSES, NODES);
  const struct um_thermal_sensitivity_options how = {1e-5, NULL};
  OK(um_thermal_sensitivity(help_context, network, loads, &options, NULL, START, times, TIMES,
                            &forcings, &how, keep, &kept));
  for (size_t p = 0; p < PULSES; p++) {
    struct um_thermal_history *history[2] = {NULL, NULL};
    for (int side = 0; side < 2; side++) {
      struct um_irradiation_loads *own = NULL;
      struct um_thermal_network *heated = box(&own);
      const double t[2] = {source[p].t_from, source[p].t_to};
      const double power[2] = {side == 0 ? -1.0 : 1.0, side == 0 ? -1.0 : 1.0};
      const struct um_thermal_source timed = {
          source[p].node, source[p].weight, 2, t, power, 2, true};
      OK(um_thermal_network_source_add(heated, &timed));
      OK(um_thermal_solve(help_context, heated, own, &options, NULL, START, times, TIMES,
                          &history[side]));
      um_thermal_network_destroy(&heated);
      um_irradiation_loads_destroy(help_context, &own);
    }
    double largest = 0.0, worst = 0.0;
    for (size_t k = 0; k < TIMES; k++)
      for (size_t i = 0; i < NODES; i++) {
        double expected =
            0.5 * (history[1]->temperature[k * NODES + i] - history[0]->temperature[k * NODES + i]);
        largest = fmax(largest, fabs(expected));
        worst = fmax(worst, fabs(at(&kept, k, p, i) - expected));
      }
    print_message("pulse %zu: at most %.3e K/W, off by %.1e of it\n", p, largest, worst / largest);
    NEAR("response to a pulse", worst / largest, 0.0, 1e-4);
    um_thermal_history_destroy(help_context, &history[0]);
    um_thermal_history_destroy(help_context, &history[1]);
  }
  kept_free(&kept);
  um_thermal_network_destroy(&network);
  um_irradiation_loads_destroy(help_context, &loads);
}

/* Power inside, moved by a watt, and the watt of a pulse all along, in one run: the same forcing.
 * The pulse is listed after one that begins later. */
static void test_beside_variants(void **state)
{
  (void)state;
  struct um_irradiation_loads *loads = NULL, *own = NULL;
  struct um_thermal_network *network = box(&loads), *moved = box(&own);
  const uint32_t interior = INTERIOR;
  const double one = 1.0, times[3] = {START, START + 500.0, START + 1000.0};
  um_thermal_network_power_set(moved, INTERIOR, 1.0);
  const struct um_thermal_variant variant = {moved, own, NULL, 1.0, NULL};
  const struct um_thermal_pulse pulses[2] = {{&interior, &one, 1, START + 600.0, START + 700.0},
                                             {&interior, &one, 1, START - 1.0, START + 2000.0}};
  const struct um_thermal_forcings forcings = {&variant, 1, pulses, 2};
  struct um_thermal_solve_options options = help_options(1e-8, 1e-6, 2.7);
  struct kept kept = kept_create(3, 3, NODES);
  OK(um_thermal_sensitivity(help_context, network, loads, &options, NULL, START, times, 3,
                            &forcings, NULL, keep, &kept));
  for (size_t i = 0; i < NODES; i++) {
    double largest = at(&kept, 2, 0, INTERIOR);
    for (size_t k = 0; k < 3; k++)
      NEAR("the same watt", at(&kept, k, 2, i), at(&kept, k, 0, i), 1e-9 * largest);
    NEAR("not begun", at(&kept, 1, 1, i), 0.0, 0.0);
  }
  assert_true(at(&kept, 2, 1, INTERIOR) > 0.09 * at(&kept, 2, 0, INTERIOR));
  kept_free(&kept);
  um_thermal_network_destroy(&network);
  um_thermal_network_destroy(&moved);
  um_irradiation_loads_destroy(help_context, &loads);
  um_irradiation_loads_destroy(help_context, &own);
}

static enum um_status stop(void *user, size_t k, const double *temperature, const double *response)
{
  (void)user, (void)k, (void)temperature, (void)response;
  return UM_ERR_CANCELLED;
}
static enum um_status ignore(void *user, size_t k, const double *temperature,
                             const double *response)
{
  (void)user, (void)k, (void)temperature, (void)response;
  return UM_OK;
}

static void test_refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, 100.0, 300.0), none = 4;
  const double one = 1.0, times[2] = {10.0, 5.0};
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
  static const char *const words[] = {"node 4 with weight 1; accepted: below 1", "from 5 s to 1 s",
                                      "time 1 is 5.000000 s", "no times wanted"};
  const struct um_thermal_pulse pulses[4] = {{&none, &one, 1, 0.0, 1.0},
                                             {&node, &one, 1, 5.0, 1.0},
                                             {&node, &one, 1, 0.0, 1.0},
                                             {&node, &one, 1, 0.0, 1.0}};
  for (size_t k = 0; k < 4; k++) {
    const struct um_thermal_forcings forcings = {.pulse = &pulses[k], .npulse = 1};
    um_core_message_clear(help_context);
    assert_int_equal(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, times,
                                            k < 2    ? 1
                                            : k == 2 ? 2
                                                     : 0,
                                            &forcings, NULL, ignore, NULL),
                     UM_ERR_INPUT);
    if (strstr(um_core_message(help_context), words[k]) == NULL)
      fail_msg("'%s' lacks '%s'", um_core_message(help_context), words[k]);
  }
  const struct um_thermal_forcings forcings = {.pulse = &pulses[2], .npulse = 1};
  assert_int_equal(um_thermal_sensitivity(help_context, network, NULL, &options, NULL, 0.0, times,
                                          1, &forcings, NULL, stop, NULL),
                   UM_ERR_CANCELLED);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_single_node), cmocka_unit_test(test_inside),
      cmocka_unit_test(test_tolerance),   cmocka_unit_test(test_against_runs),
      cmocka_unit_test(test_refused),     cmocka_unit_test(test_beside_variants),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
