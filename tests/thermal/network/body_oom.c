/* Every allocation of a body and of its loads fails once: the answer is "out of memory", nothing is
 * left behind, and the next try works. */
#include "tests/support/allocator.h"
#include "tests/thermal/body_help.h"
#include "thermal/loads/loads.h"

static void describe(struct help_satellite *s, struct um_thermal_mli *mli)
{
  *mli = (struct um_thermal_mli){.effective_emittance = 0.01, .areal_heat_capacity = 60.0};
  help_part(s, "bus", UM_SHAPE_BOX, NULL);
  s->spec[0].inside = true;
  s->spec[0].shell.through_conductance = 20.0;
  s->group[0].inside_emittance = 0.8;
  help_interior(s, 0, "interior", 1e4, 2.0);
  struct um_thermal_interior_spec *frame = help_interior(s, 0, "frame", 1e3, 1.0);
  frame->lag = 100.0;
  frame->lag_share = 0.5;
  s->group[0].mli = mli;
  help_part(s, "array", UM_SHAPE_PLATE, "paint");
  s->shape[1].position = um_vec3(1.2, 0, 0);
  s->shape[1].joint = UM_JOINT_SUN;
  s->shape[1].joint_axis = um_vec3(1, 0, 0);
  s->shape[1].joint_normal = um_vec3(0, 0, 1);
  s->spec[1].kind = UM_THERMAL_LUMPED;
  help_part(s, "tank", UM_SHAPE_BOX, NULL);
  s->shape[2].position = um_vec3(-2, 0, 0);
  s->shape[2].solid = true;
  s->spec[2].kind = UM_THERMAL_SOLID;
}

/* A plate of a node each side and one inside. */
static void describe_nodes(struct help_satellite *s)
{
  static const char *const name[] = {"front", "back", "hub"};
  struct um_thermal_network *network = help_network();
  uint32_t node[3];
  for (int i = 0; i < 3; i++)
    OK(um_thermal_network_node_add(network, name[i], UM_NODE_DIFFUSIVE, 100.0, 300.0, 0.0,
                                   &node[i]));
  OK(um_thermal_network_conductor_add(network, node[0], node[1], 3.0));
  OK(um_thermal_network_radiator_add(network, node[2], UM_THERMAL_SPACE, 0.1));
  size_t p = help_part(s, "fin", UM_SHAPE_PLATE, "paint");
  s->shape[p].position = um_vec3(0, 3, 0);
  s->spec[p].kind = UM_THERMAL_NODES;
  s->spec[p].network = network;
  help_interior(s, p, "hub", 100.0, 0.0);
}

static void test_body(void **state)
{
  (void)state;
  struct help_satellite s = {0};
  struct um_thermal_mli mli;
  struct um_context *saved = help_context;
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  OK(um_core_context_create(&allocator, &help_context));
  describe(&s, &mli);
  describe_nodes(&s);
  help_geometry(&s);
  const struct um_thermal_contact contact[3] = {
      {.a = "bus", .b = "array", .conductance = 2.0},
      {.a = "bus.interior", .b = "tank", .conductance = 1.0},
      {.a = "bus.interior", .b = "bus.inside", .exchange_area = 0.5}};
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(help_context);
    status = um_thermal_body_create(help_context, s.geometry, s.spec, s.npart, contact, 3, &s.body);
    if (status == UM_OK) break;
    assert_int_equal(status, UM_ERR_MEMORY);
    assert_null(s.body);
    assert_int_equal(memory.alive, live);
  }
  print_message("body: %ld allocations failed one by one\n", tries - 1);
  assert_true(tries > 30);
  help_end(&s);
  um_thermal_network_destroy(&s.spec[3].network);
  um_core_context_destroy(&help_context);
  assert_int_equal(memory.alive, 0);
  help_context = saved;
}

static void test_loads(void **state)
{
  (void)state;
  for (int moving = 0; moving < 2; moving++) {
    struct help_satellite s = {0};
    struct um_thermal_mli mli;
    struct um_context *saved = help_context;
    struct um_test_memory memory = {0};
    struct um_core_allocator allocator = um_test_memory_allocator(&memory);
    OK(um_core_context_create(&allocator, &help_context));
    um_core_context_set_threads(help_context, 1);
    describe(&s, &mli);
    if (!moving) s.shape[1].joint = UM_JOINT_NONE;
    help_geometry(&s);
    struct um_environment environment;
    um_environment_defaults(&environment);
    struct um_environment_sample sample = {.r = {7e6, 0, 0},
                                           .sun = {1, 0, 0},
                                           .sun_distance = UM_AU,
                                           .pole = {0, 0, 1},
                                           .sunlit_fraction = 1.0,
                                           .q = {1, 0, 0, 0}};
    long live = memory.alive, tries = 0;
    enum um_status status = UM_ERR_MEMORY;
    struct um_irradiation_loads *loads = NULL;
    while (status != UM_OK) {
      memory.calls = 0;
      memory.fail_call = ++tries;
      um_core_message_clear(help_context);
      status = um_irradiation_loads_trace(help_context, s.geometry, &environment, &sample, 1, NULL,
                                          0, 4, &loads);
      if (status == UM_OK) break;
      assert_int_equal(status, UM_ERR_MEMORY);
      assert_null(loads);
      assert_int_equal(memory.alive, live);
    }
    print_message("loads: %ld allocations failed one by one\n", tries - 1);
    assert_true(tries > 15);
    um_irradiation_loads_destroy(help_context, &loads);
    help_end(&s);
    um_core_context_destroy(&help_context);
    assert_int_equal(memory.alive, 0);
    help_context = saved;
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_body), cmocka_unit_test(test_loads)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
