/* The keys of what is inside a part: interiors by name, their conductances to groups, contacts
 * between them, effects on them. The satellite of tests/effects/heat_help.h. */
#include <stdlib.h>

#include "tests/effects/heat_help.h"
#include "thermal/network/body.h"

#define FILE_NAME "interiors-scenario.yaml"

/* A cube of six groups with what is inside as given. */
#define BUS(inside)                                                                                \
  "parts.bus={name: bus, box: {size_m: [1, 1, 1]}, pose: {position_m: [-2, 0, 0]}, outside: "      \
  "grey_mli, lumped: true, shell: {areal_heat_capacity_J_m2_K: 5000}, mli: {effective_emittance: " \
  "0.02, areal_heat_capacity_J_m2_K: 60}, " inside "}"

static const struct um_thermal_place *place(const struct heat_run *run, const char *name)
{
  size_t p = um_thermal_body_place_find(run->model->body, name);
  if (p == (size_t)-1) fail_msg("no place %s", name);
  return &run->model->body->place[p];
}

/* Heat conducted into a place of one node with another place 10 K above all others [W]. */
static double conducted(const struct heat_run *run, const char *warm, const char *into)
{
  const struct um_thermal_network *network = run->model->body->network;
  size_t n = um_thermal_network_nodes(network);
  double *t = calloc(n, sizeof *t);
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  struct um_thermal_solve_options options;
  assert_true(t != NULL && heat != NULL);
  um_thermal_solve_defaults(&options);
  for (size_t i = 0; i < n; i++) t[i] = 280.0;
  t[place(run, warm)->node[0]] = 290.0;
  if (um_thermal_heat_of_nodes(run->context, network, NULL, &options, 0.0, t, heat) != UM_OK)
    fail_msg("%s", um_core_message(run->context));
  double watt = heat[place(run, into)->node[0]].conducted;
  free(heat);
  free(t);
  return watt;
}

/* One under `interiors` is what `interior` is, by another name. */
static void one_of_a_name_is_the_interior(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(
      LIST(BUS("interior: {capacity_J_K: 2e4, power_W: 20, conductance_W_K: 6}")), NONE, NONE);
  struct heat_run b = heat_compute(LIST(BUS("interiors: {boards: {capacity_J_K: 2e4, power_W: 20, "
                                            "conductance_W_K: 6}}")),
                                   NONE, NONE);
  assert_true(heat_same_temperatures(&a, &b));
  assert_true(heat_temperature(&b, "bus.boards", 0) == heat_temperature(&a, "bus.interior", 0));
  heat_release(&a);
  heat_release(&b);
}

/* 6 W/K of the frame over the five sides that state none: 1.2 each, and 0.3, 0 where groups say so;
 * the boards hold the frame alone, and -z. */
static void conductances_reach_their_groups(void **state)
{
  (void)state;
  struct heat_run run = heat_compute(
      LIST(BUS("interior: {capacity_J_K: 100, conductance_W_K: 3}, interiors: {frame: "
               "{capacity_J_K: 154, conductance_W_K: 4.8}, boards: {capacity_J_K: 110, power_W: "
               "20}}, groups: {+x: {conductances_W_K: {frame: 0.3}}, -x: {conductances_W_K: "
               "{frame: 0}, interior_conductance_W_K: 0.5}, -z: {conductances_W_K: {boards: "
               "0.7}}}"),
           "contacts=[{a: bus.frame, b: bus.boards, conductance_W_K: 2.5}]"),
      NONE, NONE);
  static const struct {
    const char *warm, *into;
    double watt;
  } rows[] = {{"bus.frame", "bus.+x.wall", 3.0},    {"bus.frame", "bus.-x.wall", 0.0},
              {"bus.frame", "bus.+y.wall", 12.0},   {"bus.frame", "bus.-z.wall", 12.0},
              {"bus.boards", "bus.-z.wall", 7.0},   {"bus.boards", "bus.+y.wall", 0.0},
              {"bus.boards", "bus.frame", 25.0},    {"bus.interior", "bus.-x.wall", 5.0},
              {"bus.interior", "bus.+x.wall", 6.0}, {"bus.interior", "bus.frame", 0.0},
              {"bus.-z.wall", "bus.boards", 7.0}};
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
    if (!(fabs(conducted(&run, rows[i].warm, rows[i].into) - rows[i].watt) <= 1e-9))
      fail_msg("%s to %s: %.9g W, expected %g W", rows[i].warm, rows[i].into,
               conducted(&run, rows[i].warm, rows[i].into), rows[i].watt);
  /* what boards release leaves them, by 2.5 W/K to the frame and 0.7 to -z */
  double boards = heat_temperature(&run, "bus.boards", 0);
  double out = 2.5 * (boards - heat_temperature(&run, "bus.frame", 0)) +
               0.7 * (boards - heat_temperature(&run, "bus.-z.wall", 0));
  heat_close("power of the boards", out, 20.0, 1e-6);
  heat_release(&run);
}

/* A given temperature is kept; a node without capacity is where its balance has it; MLI wraps it.
 */
static void held_and_massless(void **state)
{
  (void)state;
  struct heat_run run = heat_compute(
      LIST(BUS("interiors: {room: {temperature_K: 293}, plate: {capacity_J_K: 0, power_W: 4, "
               "conductance_W_K: 1.5}}"),
           "contacts=[{a: bus.room, b: bus.plate, conductance_W_K: 0.5}]"),
      NONE, NONE);
  for (size_t k = 0; k < run.result->nobs; k++) {
    double walls = heat_temperature(&run, "bus.wall", k);
    assert_true(heat_temperature(&run, "bus.room", k) == 293.0);
    heat_close("plate", heat_temperature(&run, "bus.plate", k),
               (1.5 * walls + 0.5 * 293.0 + 4.0) / 2.0, 1e-9);
  }
  heat_release(&run);
  struct heat_run wrapped = heat_compute(LIST(BUS("interiors: {tank: {temperature_K: 293}}"),
                                              "parts.bus.mli.wraps=tank", "contacts=[]"),
                                         NONE, NONE);
  assert_true(um_thermal_body_place_find(wrapped.model->body, "bus.wall") == (size_t)-1);
  assert_true(heat_temperature(&wrapped, "bus.tank", 1) == 293.0);
  heat_release(&wrapped);
}

#define TWO                                                                                        \
  BUS("interiors: {frame: {capacity_J_K: 154, conductance_W_K: 6}, boards: {capacity_J_K: 110, "   \
      "power_W: 2, conductance_W_K: 1}}")

/* An effect on one of them is the scenario with that number. */
static void effects_reach_them_by_name(void **state)
{
  (void)state;
  static const struct {
    const char *with, *key;
  } rows[] = {{"internal_power:bus.boards,power_W=3", "parts.bus.interiors.boards.power_W=5"},
              {"interior_capacity:bus.frame,capacity_J_K=46",
               "parts.bus.interiors.frame.capacity_J_K=200"}};
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    struct heat_run a =
        heat_compute(LIST(TWO, "time.stop_utc=2020-03-20T12:02:00Z"), LIST(rows[i].with), NONE);
    struct heat_run b =
        heat_compute(LIST(TWO, "time.stop_utc=2020-03-20T12:02:00Z", rows[i].key), NONE, NONE);
    assert_true(heat_same_temperatures(&a, &b));
    heat_release(&a);
    heat_release(&b);
  }
  struct heat_run a = heat_compute(LIST(TWO), NONE, NONE);
  struct heat_run b = heat_compute(LIST(TWO), LIST("stored_heat:bus.boards,shift_K=10"), NONE);
  double off = heat_temperature(&b, "bus.boards", 0) - heat_temperature(&a, "bus.boards", 0);
  assert_true(fabs(off - 10.0) <= 1e-9);
  assert_true(heat_temperature(&b, "bus.frame", 0) == heat_temperature(&a, "bus.frame", 0));
  /* a heater holds the middle of its band, 10 to 12 K above where they are without */
  char heater[96];
  double without = heat_temperature(&a, "bus.boards", 0);
  snprintf(heater, sizeof heater, "heater:bus.boards,power_W=50,on_K=%.3f", without + 10.0);
  struct heat_run c = heat_compute(LIST(TWO), LIST(heater), NONE);
  assert_true(fabs(heat_temperature(&c, "bus.boards", 0) - without - 11.0) <= 0.5);
  heat_release(&a);
  heat_release(&b);
  heat_release(&c);
}

/* A gradient inside is two interiors and a contact of s C / l between them: the same walls, from a
 * state that is not steady, to the integrator's 1e-9 a step; without lag the same bits. */
static void gradient_is_two_interiors(void **state)
{
  (void)state;
  const char *const start[] = {"thermal.start=isothermal", "thermal.orbits_before=0",
                               "orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}",
                               "time.stop_utc=2020-03-20T12:30:00Z", "time.step_s=600"};
#define ONE BUS("interior: {capacity_J_K: 2e4, power_W: 20, conductance_W_K: 6}")
#define APART                                                                                      \
  BUS("interiors: {fore: {capacity_J_K: 1.4e4, power_W: 14, conductance_W_K: 6}, behind: "         \
      "{capacity_J_K: 6e3, power_W: 6}}")
  struct heat_run one = heat_compute(
      LIST(ONE, "contacts=[]", start[0], start[1], start[2], start[3], start[4]), NONE, NONE);
  struct heat_run null =
      heat_compute(LIST(ONE, "contacts=[]", start[0], start[1], start[2], start[3], start[4]),
                   LIST("interior_gradient:bus,lag_s=0,share=0.3"), NONE);
  struct heat_run lags =
      heat_compute(LIST(ONE, "contacts=[]", start[0], start[1], start[2], start[3], start[4]),
                   LIST("interior_gradient:bus,lag_s=800,share=0.3"), NONE);
  struct heat_run apart =
      heat_compute(LIST(APART, "contacts=[{a: bus.fore, b: bus.behind, conductance_W_K: 7.5}]",
                        start[0], start[1], start[2], start[3], start[4]),
                   NONE, NONE);
  assert_true(heat_same_temperatures(&one, &null));
  for (size_t k = 1; k < lags.result->nobs; k++) {
    heat_close("wall", heat_temperature(&lags, "bus.+x.wall", k),
               heat_temperature(&apart, "bus.+x.wall", k), 1e-7);
    heat_close("inside", heat_temperature(&lags, "bus.interior", k),
               0.7 * heat_temperature(&apart, "bus.fore", k) +
                   0.3 * heat_temperature(&apart, "bus.behind", k),
               1e-7);
  }
  size_t last = lags.result->nobs - 1;
  assert_true(fabs(heat_temperature(&lags, "bus.+x.wall", last) -
                   heat_temperature(&one, "bus.+x.wall", last)) > 0.01);
  struct heat_run *all[] = {&one, &null, &lags, &apart};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) heat_release(all[i]);
}

static void what_is_refused(void **state)
{
  (void)state;
  static const struct {
    const char *bus, *other, *with, *says[2];
  } rows[] = {
      {BUS("interiors: {+x: {capacity_J_K: 1}}"),
       NULL,
       NULL,
       {"parts.bus.interiors.+x: ", "'+x' is a name of a group of the part; accepted: another"}},
      {BUS("interiors: {interior: {capacity_J_K: 1}}"),
       NULL,
       NULL,
       {"parts.bus.interiors.interior: ", "is a name that a place of every part may have"}},
      {BUS("interiors: {\"a/b\": {capacity_J_K: 1}}"),
       NULL,
       NULL,
       {"that cannot stand in a header", "accepted: another one, without . / : , ;"}},
      {BUS("interiors: {frame: {power_W: 1}}"),
       NULL,
       NULL,
       {"parts.bus.interiors.frame: ", "'frame' has no capacity_J_K; accepted: capacity_J_K, 0"}},
      {BUS("interiors: {frame: {temperature_K: 290, power_W: 1}}"),
       NULL,
       NULL,
       {"parts.bus.interiors.frame.power_W: ", "held at 290 K and takes no power"}},
      {BUS("interiors: {frame: {capacity_J_K: -1}}"),
       NULL,
       NULL,
       {"parts.bus.interiors.frame.capacity_J_K: ", "accepted: "}},
      {BUS("interiors: {frame: {capacity_J_K: 0}}"),
       NULL,
       NULL,
       {"parts.bus.interiors.frame.capacity_J_K: ",
        "0, and nothing holds the temperature of bus.frame; accepted: conductance_W_K above 0"}},
      {BUS("interiors: {frame: {capacity_J_K: 9}, boards: {capacity_J_K: 9, power_W: 3}}"),
       "contacts=[{a: bus.frame, b: bus.boards, conductance_W_K: 1}]",
       NULL,
       {"parts.bus.interiors.boards.power_W: ", "3 W have no way out"}},
      {BUS("interiors: {frame: {capacity_J_K: 9}}, groups: {+x: {conductances_W_K: {fram: 1}}}"),
       NULL,
       NULL,
       {"parts.bus.groups.+x.conductances_W_K.fram: ",
        "the part 'bus' has no interior 'fram'; did you mean 'frame'?; accepted: frame"}},
      {BUS("interior: {capacity_J_K: 9}, groups: {+x: {conductances_W_K: {interior: 1}}}"),
       NULL,
       NULL,
       {"'interior' has a key of its own", "accepted: interior_conductance_W_K"}},
      {BUS("interiors: {frame: {capacity_J_K: 9}}"),
       "parts.bus.mli.wraps=fraem",
       NULL,
       {"parts.bus.mli.wraps: ", "accepted: wall, frame"}},
      {BUS("interiors: {frame: {capacity_J_K: 9}}"),
       "contacts=[{a: bus.boards, b: panel, conductance_W_K: 1}]",
       NULL,
       {"there is no place 'bus.boards'", "PART.INTERIOR"}},
      {TWO,
       NULL,
       "internal_power:bus,power_W=1",
       {"effect 'internal_power': the part 'bus' has no interior that could take the power",
        "accepted: PART.NAME of its interiors"}},
      {TWO,
       NULL,
       "internal_power:bus.board,power_W=1",
       {"nothing that 'internal_power' acts on is called 'bus.board'; did you mean 'bus.boards'?",
        "accepted: panel, bus, bus.frame, bus.boards"}},
      {BUS("interiors: {room: {temperature_K: 290}}"),
       NULL,
       "interior_capacity:bus.room",
       {"'bus.room' is held at 290 K and cannot store heat", "accepted: an interior without"}},
  };
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    char message[1024];
    heat_refused(LIST(rows[i].bus, rows[i].other), LIST(rows[i].with), message, sizeof message);
    for (int k = 0; k < 2; k++)
      if (strstr(message, rows[i].says[k]) == NULL)
        fail_msg("%zu: '%s' is not in '%s'", i, rows[i].says[k], message);
  }
}

static int setup(void **state)
{
  (void)state;
  return heat_setup(FILE_NAME);
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_of_a_name_is_the_interior),
                                     cmocka_unit_test(conductances_reach_their_groups),
                                     cmocka_unit_test(held_and_massless),
                                     cmocka_unit_test(effects_reach_them_by_name),
                                     cmocka_unit_test(gradient_is_two_interiors),
                                     cmocka_unit_test(what_is_refused)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
