/* Radiation between the surfaces of rooms and grooves: radiosity's closed forms (Siegel and
 * Howell), the isothermal enclosure, energy, the second law, and that steady states, transients and
 * responses agree on it.
 *
 * The room is a unit cube of six plates that look inward, each a node; its outside is not attached.
 *
 *         +-----+          x0 x1 | y0 y1 | z0 z1 opposite each other
 *        /     /|
 *       +-----+ |
 *       |     | +
 *       |     |/
 *       +-----+
 */
#include "thermal/exchange/exchange.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/allocator.h"
#include "tests/thermal/exchange/room_help.h"
#include "thermal/tangent/sensitivity.h"

static const double wall_emittance[6] = {0.8, 0.8, 0.3, 0.3, 0.05, 0.9};
static const double wall_temperature[6] = {300, 320, 280, 310, 250, 400};

static void cube_of_walls(struct room *r, size_t limit, double capacity)
{
  struct um_geometry_part_spec part[6];
  cube(part, 0.4);
  room_open(r, part, 6, limit, 16384);
  for (uint32_t k = 0; k < 6; k++)
    room_node(r, k, wall_emittance[k], 0.5, wall_temperature[k], capacity);
  room_exchange(r);
}

/* Net losses of radiosity with evenly lit walls (six patches), as by Gebhart's factors. */
static void unit_cube(void **state)
{
  (void)state;
  static const double expected[6] = {-295.67961, -170.81837, -136.12687,
                                     -80.82225,  -28.13338,  711.58047};
  struct room r;
  double loss[6], sum = 0.0;
  cube_of_walls(&r, 6, NAN);
  losses(&r, wall_temperature, loss);
  for (int k = 0; k < 6; k++) {
    print_message("wall %d: %.4f W, expected %.4f\n", k, loss[k], expected[k]);
    assert_close(loss[k], expected[k], 5e-4 * 711.58); /* view factors to 5e-4 */
    sum += loss[k];
  }
  assert_close(sum, 0.0, 1e-9);
  assert_close(um_thermal_exchange_area(r.exchange, 0, 0, 5), 0.8 * 0.340632, 5e-4);
  room_close(&r);
}

/* Every wall at one temperature loses nothing, whatever the optics and the patches, though they
 * send hundreds of watts. */
static void isothermal_enclosure(void **state)
{
  (void)state;
  static const double same[6] = {350, 350, 350, 350, 350, 350};
  for (size_t limit = 6; limit <= 400; limit *= 8) {
    struct room r;
    double loss[6];
    cube_of_walls(&r, limit, NAN);
    losses(&r, same, loss);
    for (int k = 0; k < 6; k++) assert_close(loss[k], 0.0, 1e-9);
    room_close(&r);
  }
}

/* A ball in a room of one temperature: q = s A1 (T1^4 - T2^4) / (1/e1 + A1/A2 (1/e2 - 1)), as for
 * concentric spheres; radii 0.5 and 1, 0.8 and 0.3, 400 and 300 K would give 1700.4279 W. */
static void ball_in_a_room(void **state)
{
  (void)state;
  static const struct um_geometry_skin skin = {NULL, "in", NULL};
  struct um_geometry_part_spec part[7];
  cube(part, 0.4);
  part[6] = (struct um_geometry_part_spec){.name = "ball",
                                           .shape = UM_SHAPE_SPHERE,
                                           .radius = 0.25,
                                           .rotation = {1, 0, 0, 0},
                                           .skins = &skin,
                                           .nskin = 1,
                                           .facet_size = 0.1};
  struct room r;
  double temperature[7] = {300, 300, 300, 300, 300, 300, 400}, loss[7];
  room_open(&r, part, 7, 7, 65536);
  for (uint32_t k = 0; k < 7; k++) room_node(&r, k, k < 6 ? 0.3 : 0.8, 0.5, temperature[k], NAN);
  room_exchange(&r);
  losses(&r, temperature, loss);
  double area = r.table->patches->area[6], difference = pow(400, 4) - pow(300, 4);
  double expected =
      UM_STEFAN_BOLTZMANN * area * difference / (1 / 0.8 + area / 6.0 * (1 / 0.3 - 1));
  print_message("ball of %.4f m2: %.5f W, expected %.5f\n", area, loss[6], expected);
  assert_close(loss[6], expected, 1e-4 * expected);
  /* the formula itself at the published case */
  double inner = UM_PI, outer = 4 * UM_PI;
  assert_close(UM_STEFAN_BOLTZMANN * inner * difference / (1 / 0.8 + inner / outer * (1 / 0.3 - 1)),
               1700.42790, 1e-5);
  room_close(&r);
}

/* A groove of 90 deg looks blacker than its walls: e (1 - F) / (1 - (1 - e) F) of twice its walls;
 * 0.069276, 0.377370, 0.849779 of the aperture for e = 0.05, 0.3, 0.8 where it is endless. */
static void v_groove(void **state)
{
  (void)state;
  static const double emittance[3] = {0.05, 0.3, 0.8}, endless[3] = {0.069276, 0.377370, 0.849779};
  struct um_geometry_part_spec part[2] = {
      plate("floor", 1, 20, 1.5, um_vec3(-0.5, 0, 0), (struct um_quat){1, 0, 0, 0}),
      plate("wall", 1, 20, 1.5, um_vec3(0, 0, 0.5),
            um_quat_from_axis(um_vec3(0, 1, 0), -0.5 * UM_PI))};
  for (int k = 0; k < 3; k++) {
    struct room r;
    double temperature[2] = {300, 300}, loss[2], e = emittance[k], f = 1 - sqrt(0.5);
    assert_close(sqrt(2.0) * e * (1 - f) / (1 - (1 - e) * f), endless[k], 1e-6);
    room_open(&r, part, 2, 2, 65536);
    for (uint32_t p = 0; p < 2; p++) room_node(&r, p, e, 0.5, 300, NAN);
    room_exchange(&r);
    f = um_geometry_view_factors_area(r.table->pose[0], 0, 1) / r.table->patches->area[0];
    losses(&r, temperature, loss);
    double black = UM_STEFAN_BOLTZMANN * (pow(300, 4) - pow(UM_SPACE_TEMPERATURE, 4)) * 40.0;
    assert_close((loss[0] + loss[1]) / black, e * (1 - f) / (1 - (1 - e) * f), 1e-9);
    room_close(&r);
  }
}

/* Without loads and power nothing becomes warmer than the warmest was, nothing colder than space,
 * and the audit closes; a steady state is where a long transient ends. */
static void energy_and_second_law(void **state)
{
  (void)state;
  struct room r;
  double time[41], steady[6];
  struct um_thermal_history *h = NULL;
  cube_of_walls(&r, 200, 500.0);
  for (int k = 0; k <= 40; k++) time[k] = 50.0 * k;
  OK(um_thermal_solve(context, r.network, NULL, &r.options, NULL, 0.0, time, 41, &h));
  for (int k = 1; k <= 40; k++) {
    double low = INFINITY, high = 0.0, low0 = INFINITY, high0 = 0.0;
    for (int i = 0; i < 6; i++) {
      low = fmin(low, h->temperature[k * 6 + i]);
      high = fmax(high, h->temperature[k * 6 + i]);
      low0 = fmin(low0, h->temperature[(k - 1) * 6 + i]);
      high0 = fmax(high0, h->temperature[(k - 1) * 6 + i]);
    }
    assert_true(low >= low0 - 1e-4 && high <= high0 + 1e-4);
  }
  print_message("cube after 2000 s: %.3f to %.3f K, audit %.1e\n", h->temperature[40 * 6 + 4],
                h->temperature[40 * 6 + 5], h->audit_error);
  /* a closed room keeps its heat; the audit compares with a millionth of its content, which is a
   * millionth of what its walls exchange */
  assert_true(h->audit_error < 1e-3);
  um_thermal_history_destroy(context, &h);
  /* 100 W into a wall, another held */
  um_thermal_network_power_set(r.network, 0, 100.0);
  OK(um_thermal_network_conductor_add(r.network, 1, 2, 1.0));
  uint32_t held;
  OK(um_thermal_network_node_add(r.network, "held", UM_NODE_BOUNDARY, 0.0, 280.0, 0.0, &held));
  OK(um_thermal_network_conductor_add(r.network, 5, held, 3.0));
  double settled[7];
  time[0] = 2e5;
  OK(um_thermal_solve_steady(context, r.network, NULL, 0, &r.options, NULL, settled));
  OK(um_thermal_solve(context, r.network, NULL, &r.options, NULL, 0.0, time, 1, &h));
  for (int i = 0; i < 6; i++) {
    steady[i] = h->temperature[i];
    assert_close(settled[i], steady[i], 1e-3);
  }
  assert_close(3.0 * (settled[5] - 280.0), 100.0, 1e-6); /* all of it leaves there */
  assert_true(h->audit_error < 1e-6);
  um_thermal_history_destroy(context, &h);
  room_close(&r);
}

/* A wall without mass is one of little mass. */
static void massless_walls(void **state)
{
  (void)state;
  double time[2] = {300.0, 900.0}, end[2][6];
  for (int light = 0; light < 2; light++) {
    struct room r;
    struct um_thermal_history *h = NULL;
    struct um_geometry_part_spec part[6];
    cube(part, 0.6);
    room_open(&r, part, 6, 100, 2048);
    for (uint32_t k = 0; k < 6; k++) {
      bool thin = k == 1 || k == 4;
      room_node(&r, k, wall_emittance[k], 0.5, wall_temperature[k],
                !thin   ? 500.0
                : light ? 1e-3
                        : 0.0);
    }
    OK(um_thermal_network_conductor_add(r.network, 1, 2, 0.5));
    OK(um_thermal_network_radiator_add(r.network, 1, UM_THERMAL_SPACE, 0.1));
    room_exchange(&r);
    OK(um_thermal_solve(context, r.network, NULL, &r.options, NULL, 0.0, time, 2, &h));
    for (int i = 0; i < 6; i++) end[light][i] = h->temperature[6 + i];
    print_message("massless walls: audit %.1e\n", h->audit_error);
    assert_true(h->audit_error < 1e-6);
    um_thermal_history_destroy(context, &h);
    room_close(&r);
  }
  for (int i = 0; i < 6; i++) assert_close(end[0][i], end[1][i], 1e-3);
}

struct taken {
  double response[6];
};

static enum um_status take(void *user, size_t k, const double *temperature, const double *response)
{
  struct taken *taken = user;
  (void)temperature;
  if (k == 1) memcpy(taken->response, response, sizeof taken->response);
  return UM_OK;
}

/* Answer to a watt into one wall, at all walls, against central differences. */
static void responses(void **state)
{
  (void)state;
  struct room r;
  double time[2] = {0.0, 400.0}, end[2][6];
  struct taken taken;
  cube_of_walls(&r, 60, 300.0);
  static const uint32_t node[1] = {0};
  static const double one[1] = {1.0};
  const struct um_thermal_pulse pulse = {node, one, 1, 0.0, 400.0};
  const struct um_thermal_forcings forcings = {.pulse = &pulse, .npulse = 1};
  OK(um_thermal_sensitivity(context, r.network, NULL, &r.options, NULL, 0.0, time, 2, &forcings,
                            NULL, take, &taken));
  for (int side = 0; side < 2; side++) {
    struct um_thermal_history *h = NULL;
    um_thermal_network_power_set(r.network, 0, side ? 5.0 : -5.0);
    OK(um_thermal_solve(context, r.network, NULL, &r.options, NULL, 0.0, time, 2, &h));
    for (int i = 0; i < 6; i++) end[side][i] = h->temperature[6 + i];
    um_thermal_history_destroy(context, &h);
  }
  for (int i = 0; i < 6; i++) {
    double slope = (end[1][i] - end[0][i]) / 10.0;
    print_message("wall %d: %.6f K/W, by differences %.6f\n", i, taken.response[i], slope);
    assert_close(taken.response[i], slope, 1e-3 * taken.response[0]);
    assert_true(slope > 0.0);
  }
  room_close(&r);
}

/* Nothing on, nothing made; sizes that do not agree; walls that absorb nothing. */
static void refusals(void **state)
{
  (void)state;
  struct room r;
  struct um_geometry_part_spec part[6];
  struct um_thermal_exchange *x = NULL;
  struct um_thermal_exchange_options infrared = {.infrared = true}, none = {0};
  cube(part, 0.6);
  room_open(&r, part, 6, 100, 256);
  for (uint32_t k = 0; k < 6; k++) room_node(&r, k, 0.0, 0.5, 300, NAN);
  /* walls that absorb nothing: reflectance is held just below 1, nothing is exchanged */
  OK(um_thermal_exchange_create(context, r.network, NULL, r.table, &infrared, &x));
  assert_close(um_thermal_exchange_area(x, 0, 0, 1), 0.0, 0.0);
  um_thermal_exchange_destroy(context, &x);
  OK(um_thermal_exchange_create(context, r.network, NULL, r.table, &none, &x));
  assert_null(x);
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(context, 2, 3, 0, &loads));
  assert_int_equal(um_thermal_exchange_create(context, r.network, loads, r.table, &infrared, &x),
                   UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "loads of 3; accepted: as many"));
  um_core_message_clear(context);
  um_irradiation_loads_destroy(context, &loads);
  room_close(&r);
}

/* Solar heat of the five walls of a cube without lid of which the floor alone is lit with 1000
 * W/m2, absorptance 0.2; of `limit` patches. */
static void cavity(size_t limit, size_t rays, double solar[5], double *to_lid)
{
  struct room r;
  struct um_geometry_part_spec part[6];
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_exchange_options options = {.infrared = false, .solar = true};
  double temperature[5] = {300, 300, 300, 300, 300};
  struct um_thermal_heat heat[5];
  cube(part, 0.3);
  room_open(&r, part, 5, limit, rays); /* z1, the lid, is left out */
  for (uint32_t k = 0; k < 5; k++) room_node(&r, k, 0.9, 0.2, 300, NAN);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(r.geometry);
  OK(um_irradiation_loads_create(context, 1, mesh->nsurface, 0, &loads));
  loads->sunlit[0] = 1.0;
  loads->irradiance[0] = 1000.0;
  for (uint32_t s = 0; s < mesh->nsurface; s++)
    if (mesh->surface[s].part == 4 && !mesh->surface[s].back) loads->sun[s] = 1.0f;
  OK(um_thermal_exchange_create(context, r.network, loads, r.table, &options, &r.exchange));
  r.options.exchange = r.exchange;
  OK(um_thermal_heat_of_nodes(context, r.network, loads, &r.options, 0.0, temperature, heat));
  for (int k = 0; k < 5; k++) solar[k] = heat[k].solar;
  for (int k = 0; k < 5 && limit == 5; k++)
    to_lid[k] = r.table->pose[0]->space[k] / r.table->patches->area[k];
  um_irradiation_loads_destroy(context, &loads);
  room_close(&r);
}

/* What the walls do not absorb leaves through the lid; walls lit near the floor keep more of it. */
static void reflected_sunlight(void **state)
{
  (void)state;
  double even[5], fine[5], to_lid[5], in = 0.0, out = 0.0, more = 0.0;
  cavity(5, 65536, even, to_lid);
  for (int k = 0; k < 5; k++) {
    in += even[k];
    out += 0.8 * even[k] / 0.2 * to_lid[k];
  }
  print_message("cavity: %.6f W absorbed, %.6f W leave\n", in, out);
  assert_close(in + out, 1000.0, 1e-6);
  assert_close(to_lid[4], 0.199825, 5e-4);
  /* the floor alone, once: 800 W of which 0.200044 go to a wall; all orders bring more */
  assert_true(even[0] > 0.2 * 800.0 * 0.200044 && even[4] > 200.0);
  cavity(400, 4096, fine, NULL);
  for (int k = 0; k < 5; k++) more += fine[k];
  assert_true(more > in + 10.0 && more < in + 80.0);
  assert_close(fine[0], fine[3], 0.5);
}

static void out_of_memory(void **state)
{
  (void)state;
  struct room r;
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *small = NULL;
  struct um_thermal_exchange *x = NULL;
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_exchange_options options = {.infrared = true, .solar = true};
  cube_of_walls(&r, 6, 500.0);
  OK(um_irradiation_loads_create(context, 3, um_geometry_mesh(r.geometry)->nsurface, 0, &loads));
  assert_int_equal(um_core_context_create(&allocator, &small), UM_OK);
  um_core_context_set_threads(small, 1);
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(small);
    status = um_thermal_exchange_create(small, r.network, loads, r.table, &options, &x);
    if (status == UM_OK) break;
    assert_int_equal(status, UM_ERR_MEMORY);
    assert_null(x);
    assert_int_equal(memory.alive, live);
  }
  assert_true(tries > 20);
  um_thermal_exchange_destroy(small, &x);
  assert_int_equal(memory.alive, live);
  um_core_context_destroy(&small);
  um_irradiation_loads_destroy(context, &loads);
  room_close(&r);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(unit_cube),
      cmocka_unit_test(isothermal_enclosure),
      cmocka_unit_test(ball_in_a_room),
      cmocka_unit_test(v_groove),
      cmocka_unit_test(energy_and_second_law),
      cmocka_unit_test(massless_walls),
      cmocka_unit_test(responses),
      cmocka_unit_test(refusals),
      cmocka_unit_test(reflected_sunlight),
      cmocka_unit_test(out_of_memory),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
