/* Emittances that go with temperature in radiation between surfaces: plates whose emittance has one
 * value below a wavelength and another above, for which the balance of each band is closed; rooms
 * of one temperature. */
#include "base/core/planck.h"
#include "tests/support/allocator.h"
#include "tests/thermal/exchange/room_help.h"
#include "thermal/exchange/exchange_group.h"
#include "thermal/network/network_group.h"

#define EDGE 14e-6 /* [m] where the emittances step */

/* Emittances below and above the edge; the law of the total over that at 300 K. */
struct step {
  double low, high;
  struct um_thermal_surface_law law;
};

static double step_emittance(const struct step *step, double temperature)
{
  double below = um_core_planck_fraction(EDGE * temperature);
  return step->low * below + step->high * (1.0 - below);
}

static void step_fill(struct step *step)
{
  const double width = UM_THERMAL_LAW_HOTTEST / (UM_THERMAL_LAW_TEMPERATURES - 1);
  for (int i = 0; i < UM_THERMAL_LAW_ANGLES; i++) step->law.absorptance[i] = 1.0;
  step->law.albedo = 1.0;
  for (int i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++)
    step->law.emittance[i] =
        step_emittance(step, fmax(1.0, i * width)) / step_emittance(step, 300.0);
  step->law.planet = step_emittance(step, 255.0) / step_emittance(step, 300.0);
}

/* Every surface of part k follows step k % 2. */
static void follow(struct room *r, const struct step step[2])
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(r->geometry);
  for (size_t s = 0; s < r->network->nsurface; s++)
    if (r->network->attached[s]) r->network->surface[s].law = &step[mesh->surface[s].part % 2].law;
}

static void renew(struct room *r, const double *temperature)
{
  double change = 1.0;
  for (int round = 0; change > 0.0; round++) {
    assert_true(round < 40);
    OK(um_thermal_exchange_renew(context, r->network, r->table, NULL, temperature, 1e-13,
                                 r->exchange, &change));
    if (change < 1e-13) break;
  }
}

/* What two plates that see each other by f lose, with emissions e and absorptances a [W/m2]. */
static void two_plates(double f, const double e[2], const double a[2], double loss[2])
{
  double again = 1.0 - (1.0 - a[0]) * (1.0 - a[1]) * f * f;
  for (int k = 0; k < 2; k++) {
    double leaves = (e[1 - k] + (1.0 - a[1 - k]) * f * e[k]) / again;
    loss[k] = e[k] - a[k] * f * leaves;
  }
}

/* Temperature of what arrives at two plates with absorptances a. */
static void arrives(double f, const double a[2], const double t[2], double in[2])
{
  for (int k = 0; k < 2; k++) {
    double own = a[k] * (1.0 - a[1 - k]) * f, other = a[1 - k];
    in[k] = pow((own * pow(t[k], 4) + other * pow(t[1 - k], 4)) / (own + other), 0.25);
  }
}

static void facing(struct um_geometry_part_spec part[2])
{
  part[0] = plate("below", 1, 1, 1.5, um_vec3(0, 0, 0), (struct um_quat){1, 0, 0, 0});
  part[1] =
      plate("above", 1, 1, 1.5, um_vec3(0, 0, 0.01), um_quat_from_axis(um_vec3(1, 0, 0), UM_PI));
}

/* Losses of plates 1 cm apart that follow steps, as renewed, and as at first. *f: view factor. */
static void plates_lose(struct step step[2], const double t[2], double loss[2], double first[2],
                        double *f)
{
  struct um_geometry_part_spec part[2];
  struct room r;
  facing(part);
  for (int k = 0; k < 2; k++) step_fill(&step[k]);
  room_open(&r, part, 2, 2, 16384);
  for (uint32_t k = 0; k < 2; k++) room_node(&r, k, step_emittance(&step[k], 300), 0.5, t[k], NAN);
  follow(&r, step);
  room_exchange(&r);
  losses(&r, t, first);
  renew(&r, t);
  losses(&r, t, loss);
  *f = um_geometry_view_factors_area(r.table->pose[0], 0, 1) / r.table->patches->area[0];
  room_close(&r);
}

/* Emittance as the heat balance has it: between rows of the law. */
static double by_law(const struct step *step, double temperature)
{
  double slope;
  return step_emittance(step, 300.0) *
         um_thermal_surface_law_emittance(&step->law, temperature, &slope);
}

/* The grey formula with what is absorbed at the temperature of what arrives, itself found here. */
static void selective_plates(void **state)
{
  (void)state;
  static const double temperature[3][2] = {{300, 200}, {260, 180}, {220, 260}};
  struct step step[2] = {{.low = 0.9, .high = 0.5}, {.low = 0.3, .high = 0.8}};
  const double space4 = pow(UM_SPACE_TEMPERATURE, 4);
  for (int c = 0; c < 3; c++) {
    const double *t = temperature[c];
    double loss[2], first[2], expected[2], f, e[2], a[2] = {0.5, 0.5}, in[2];
    plates_lose(step, t, loss, first, &f);
    for (int round = 0; round < 60; round++) {
      arrives(f, a, t, in);
      for (int k = 0; k < 2; k++) a[k] = by_law(&step[k], in[k]);
    }
    for (int k = 0; k < 2; k++)
      e[k] = by_law(&step[k], t[k]) * UM_STEFAN_BOLTZMANN * (pow(t[k], 4) - space4);
    two_plates(f, e, a, expected);
    for (int k = 0; k < 2; k++) assert_close(loss[k], expected[k], 1e-9 * fabs(expected[k]));
  }
}

/* Before a black plate the balance of a selective one is exact: all that arrives has the black
 * one's spectrum. Each band alone gives the same; emittances of 300 K, as at first, do not. */
static void black_partner(void **state)
{
  (void)state;
  static const double temperature[2][2] = {{300, 200}, {200, 260}};
  struct step step[2] = {{.low = 0.9, .high = 0.4}, {.low = 1.0, .high = 1.0}};
  for (int c = 0; c < 2; c++) {
    const double *t = temperature[c];
    double loss[2], first[2], exact[2] = {0.0, 0.0}, f;
    plates_lose(step, t, loss, first, &f);
    for (int band = 0; band < 2; band++) {
      double e[2], a[2], of_band[2];
      for (int k = 0; k < 2; k++) {
        double below = um_core_planck_fraction(EDGE * t[k]);
        a[k] = band == 0 ? step[k].low : step[k].high;
        e[k] = a[k] * (band == 0 ? below : 1.0 - below) * UM_STEFAN_BOLTZMANN * pow(t[k], 4);
      }
      two_plates(f, e, a, of_band);
      for (int k = 0; k < 2; k++) exact[k] += of_band[k];
    }
    for (int k = 0; k < 2; k++) {
      print_message("%.0f K before %.0f K: loses %.4f W, exact %.4f, with that of 300 K %.4f\n",
                    t[k], t[1 - k], loss[k], exact[k], first[k]);
      assert_close(loss[k], exact[k], 2e-4 * fabs(exact[k])); /* rows of the law are 2 K apart */
      assert_true(fabs(first[k] - exact[k]) > 0.02 * fabs(exact[k]));
    }
  }
}

/* A room of one temperature, not that of the stated emittances, whose walls follow two laws: out of
 * balance by watts with emittances of 300 K, in balance once they are renewed. The balance of the
 * integration agrees with that of heat flows: nothing warms or cools. */
static void isothermal_room(void **state)
{
  (void)state;
  static const double same[6] = {220, 220, 220, 220, 220, 220};
  struct step step[2] = {{.low = 0.9, .high = 0.5}, {.low = 0.1, .high = 0.6}};
  for (int k = 0; k < 2; k++) step_fill(&step[k]);
  for (size_t limit = 6; limit <= 400; limit *= 8) {
    struct room r;
    struct um_geometry_part_spec part[6];
    struct um_thermal_history *h = NULL;
    double loss[6], first = 0.0, end = 5000.0;
    cube(part, 0.4);
    room_open(&r, part, 6, limit, 4096);
    for (uint32_t k = 0; k < 6; k++)
      room_node(&r, k, step_emittance(&step[k % 2], 300), 0.5, 220, 500.0);
    follow(&r, step);
    room_exchange(&r);
    losses(&r, same, loss);
    for (int k = 0; k < 6; k++) first = fmax(first, fabs(loss[k]));
    assert_true(first > 1.0);
    renew(&r, same);
    losses(&r, same, loss);
    for (int k = 0; k < 6; k++) assert_close(loss[k], 0.0, 1e-9);
    OK(um_thermal_solve(context, r.network, NULL, &r.options, NULL, 0.0, &end, 1, &h));
    for (int k = 0; k < 6; k++) assert_close(h->temperature[k], 220.0, 1e-9);
    um_thermal_history_destroy(context, &h);
    /* an exchange made like this one has its temperatures from the beginning */
    struct um_thermal_exchange_options like = {.infrared = true, .like = r.exchange};
    struct um_thermal_exchange *x = NULL;
    OK(um_thermal_exchange_create(context, r.network, NULL, r.table, &like, &x));
    r.options.exchange = x;
    losses(&r, same, loss);
    for (int k = 0; k < 6; k++) assert_close(loss[k], 0.0, 1e-9);
    um_thermal_exchange_destroy(context, &x);
    room_close(&r);
  }
}

/* Of the Earth's infrared that falls on the floor of a cube without lid, walls by laws absorb what
 * does not leave: reflected and absorbed with the same numbers, whatever the temperatures. */
static void earth_infrared(void **state)
{
  (void)state;
  struct step step[2] = {{.low = 0.9, .high = 0.5}, {.low = 0.1, .high = 0.6}};
  struct um_geometry_part_spec part[6];
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_exchange_options options = {.infrared = true};
  struct um_thermal_heat heat[5];
  struct room r;
  double cold[5] = {200, 210, 220, 230, 240};
  for (int k = 0; k < 2; k++) step_fill(&step[k]);
  cube(part, 0.6);
  room_open(&r, part, 5, 5, 16384);
  for (uint32_t k = 0; k < 5; k++)
    room_node(&r, k, step_emittance(&step[k % 2], 300), 0.5, cold[k], NAN);
  follow(&r, step);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(r.geometry);
  OK(um_irradiation_loads_create(context, 1, mesh->nsurface, 0, &loads));
  for (uint32_t s = 0; s < mesh->nsurface; s++)
    if (mesh->surface[s].part == 4 && !mesh->surface[s].back) loads->planet[s] = 200.0f;
  OK(um_thermal_exchange_create(context, r.network, loads, r.table, &options, &r.exchange));
  r.options.exchange = r.exchange;
  for (int renewed = 0; renewed < 2; renewed++) {
    double in = 0.0, out = 0.0;
    OK(um_thermal_heat_of_nodes(context, r.network, loads, &r.options, 0.0, cold, heat));
    for (uint32_t k = 0; k < 5; k++) {
      double own = step_emittance(&step[k % 2], 255.0), space = r.table->pose[0]->space[k];
      in += heat[k].planet;
      out += (1.0 - own) * heat[k].planet / own * space / r.table->patches->area[k];
    }
    assert_close(in + out, 200.0, 1e-6);
    if (renewed == 0) renew(&r, cold);
  }
  um_irradiation_loads_destroy(context, &loads);
  room_close(&r);
}

/* A renewal that finds no memory is an error and leaves something to destroy; none is made where
 * nothing moves. */
static void renewal(void **state)
{
  (void)state;
  static const double cold[2] = {200, 180};
  struct step step[2] = {{.low = 0.9, .high = 0.4}, {.low = 0.2, .high = 0.6}};
  struct um_geometry_part_spec part[2];
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *small = NULL;
  struct um_thermal_exchange_options infrared = {.infrared = true};
  struct room r;
  double change;
  facing(part);
  for (int k = 0; k < 2; k++) step_fill(&step[k]);
  room_open(&r, part, 2, 2, 1024);
  for (uint32_t k = 0; k < 2; k++) room_node(&r, k, step_emittance(&step[k], 300), 0.5, 300, NAN);
  follow(&r, step);
  assert_int_equal(um_core_context_create(&allocator, &small), UM_OK);
  um_core_context_set_threads(small, 1);
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    struct um_thermal_exchange *x = NULL;
    memory.fail_call = 0;
    assert_int_equal(um_thermal_exchange_create(small, r.network, NULL, r.table, &infrared, &x),
                     UM_OK);
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(small);
    status = um_thermal_exchange_renew(small, r.network, r.table, NULL, cold, 0.0, x, &change);
    assert_true(status == UM_OK || status == UM_ERR_MEMORY);
    um_thermal_exchange_destroy(small, &x);
    assert_int_equal(memory.alive, live);
  }
  assert_true(tries > 10);
  um_core_context_destroy(&small);
  room_exchange(&r);
  double before = um_thermal_exchange_area(r.exchange, 0, 0, 1);
  OK(um_thermal_exchange_renew(context, r.network, r.table, NULL, cold, 1.0, r.exchange, &change));
  assert_true(change > 0.01 && change < 1.0);
  assert_true(um_thermal_exchange_area(r.exchange, 0, 0, 1) == before);
  OK(um_thermal_exchange_renew(context, r.network, r.table, NULL, cold, 0.0, r.exchange, &change));
  assert_true(um_thermal_exchange_area(r.exchange, 0, 0, 1) != before);
  OK(um_thermal_exchange_renew(context, r.network, r.table, NULL, cold, 0.0, NULL, &change));
  assert_true(change == 0.0);
  room_close(&r);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(selective_plates), cmocka_unit_test(black_partner),
      cmocka_unit_test(isothermal_room),  cmocka_unit_test(earth_infrared),
      cmocka_unit_test(renewal),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
