/* Every allocation of ours in a run, a periodic orbit, a steady state and a reading of tables fails
 * once: the answer is "out of memory", nothing is left behind, and the next try works. */
#include "tests/support/allocator.h"
#include "tests/thermal/box_help.h"
#include "thermal/tangent/sensitivity.h"

struct subject {
  struct um_context *context;
  const struct um_thermal_network *network;
  const struct um_irradiation_loads *loads;
  const char *nodes, *links; /* paths */
};
typedef enum um_status (*deed)(const struct subject *s);

static enum um_status run(const struct subject *s)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  struct um_thermal_history *history = NULL;
  double t = 300.0;
  enum um_status status =
      um_thermal_solve(s->context, s->network, s->loads, &options, NULL, 0.0, &t, 1, &history);
  um_thermal_history_destroy(s->context, &history);
  return status;
}
static enum um_status periodic(const struct subject *s)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  double temperature[64], drift;
  return um_thermal_solve_periodic(s->context, s->network, s->loads, &options, NULL, 0.0, 6000.0,
                                   1.0, temperature, &drift);
}
static enum um_status steady(const struct subject *s)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  double temperature[64];
  return um_thermal_solve_steady(s->context, s->network, s->loads, 0, &options, NULL, temperature);
}
static enum um_status read(const struct subject *s)
{
  struct um_thermal_network *network = NULL;
  enum um_status status = um_thermal_network_read(s->context, s->nodes, s->links, &network);
  um_thermal_network_destroy(&network);
  return status;
}

static enum um_status take(void *user, size_t k, const double *temperature, const double *response)
{
  (void)user, (void)k, (void)temperature, (void)response;
  return UM_OK;
}
static enum um_status sensitive(const struct subject *s)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  const uint32_t node = 0;
  const double t[2] = {300.0, 600.0}, weight = 1.0;
  const struct um_thermal_variant variant = {s->network, s->loads, NULL, 1.0, NULL};
  const struct um_thermal_pulse pulse = {&node, &weight, 1, 100.0, 500.0};
  const struct um_thermal_forcings forcings = {&variant, 1, &pulse, 1};
  return um_thermal_sensitivity(s->context, s->network, s->loads, &options, NULL, 0.0, t, 2,
                                &forcings, NULL, take, NULL);
}
static enum um_status sensitive_orbit(const struct subject *s)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  double out[64];
  const struct um_thermal_variant variant = {s->network, s->loads, NULL, 1.0, NULL};
  return um_thermal_sensitivity_periodic(s->context, s->network, s->loads, &options, NULL, 0.0,
                                         6000.0, &variant, 1, NULL, out);
}

/* A power history and a thermostat on `node`. */
static enum um_status warm(struct um_thermal_network *network, uint32_t node)
{
  const double weight = 1.0, t[2] = {50.0, 150.0}, power[2] = {10.0, 20.0};
  const struct um_thermal_source source = {&node, &weight, 1, t, power, 2, false};
  const struct um_thermal_thermostat thermostat = {
      .node = &node, .weight = &weight, .nnode = 1, .power = 30.0, .on = 280.0, .off = 282.0};
  UM_TRY(um_thermal_network_source_add(network, &source));
  return um_thermal_network_thermostat_add(network, &thermostat);
}
static enum um_status build(const struct subject *s)
{
  uint32_t node;
  struct um_thermal_network *network = NULL;
  UM_TRY(um_thermal_network_create(s->context, &network));
  enum um_status status =
      um_thermal_network_node_add(network, "box", UM_NODE_DIFFUSIVE, 1.0, 300.0, 0.0, &node);
  if (status == UM_OK) status = warm(network, node);
  um_thermal_network_destroy(&network);
  return status;
}

static void fail_everywhere(deed act, struct subject s)
{
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  assert_int_equal(um_core_context_create(&allocator, &s.context), UM_OK);
  long live = memory.alive;
  memory.calls = 0;
  assert_int_equal(act(&s), UM_OK);
  long made = memory.calls;
  assert_int_equal(memory.alive, live);
  assert_true(made > 5);
  for (long k = 1; k <= made; k++) {
    um_core_message_clear(s.context);
    memory.calls = 0;
    memory.fail_call = k;
    assert_int_equal(act(&s), UM_ERR_MEMORY);
    assert_int_equal(memory.alive, live);
  }
  memory.fail_call = 0;
  assert_int_equal(act(&s), UM_OK);
  um_core_context_destroy(&s.context);
}

static void test_every_allocation(void **state)
{
  (void)state;
  const char *const path[2] = {"thermal_oom_nodes.csv", "thermal_oom_conductors.csv"};
  const char *const text[2] = {"name,kind,capacity_J_K,T0_K,power_W\na,diffusive,1,300,0\n"
                               "b,boundary,0,200,0\n",
                               "kind,a,b,value\nGL,a,b,1\nGR,a,space,1\n"};
  for (int k = 0; k < 2; k++) {
    FILE *file = fopen(path[k], "wb");
    assert_non_null(file);
    fputs(text[k], file);
    fclose(file);
  }
  uint32_t interior;
  struct um_thermal_network *network = box_network(1, 0.0, &interior); /* massless skins */
  struct um_irradiation_loads *loads = box_loads(1, 61, 6000.0, 1.0);
  struct subject s = {NULL, network, loads, path[0], path[1]};
  fail_everywhere(run, s);
  fail_everywhere(periodic, s);
  fail_everywhere(steady, s);
  fail_everywhere(read, s);
  fail_everywhere(sensitive, s);
  fail_everywhere(sensitive_orbit, s);
  fail_everywhere(build, s);
  OK(warm(network, interior));
  fail_everywhere(run, s);
  fail_everywhere(periodic, s);
  fail_everywhere(steady, s);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
  for (int k = 0; k < 2; k++) remove(path[k]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_allocation)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
