/* Several nodes inside a part, joined into a network, against closed forms.
 *
 *   wall (C, radiates or not) -- G1 -- boards (C = 0) -- G2 -- base (its temperature is given)
 */
#include "tests/thermal/body_help.h"
#include "thermal/tangent/sensitivity.h"

#define G1    4.0     /* [W/K] all six walls to the boards */
#define G2    1.5     /* [W/K] boards to the base */
#define BASE  320.0   /* [K] */
#define WALL  29160.0 /* 6 m2 of 4860 J/m2/K [J/K] */
#define BEGIN 300.0   /* [K] of the wall */

/* The chain inside a cube of 1 m; emittance 0 leaves it linear. */
static void chain(struct help_satellite *s, double emittance, double conductance, double power)
{
  size_t p = help_part(s, "bus", UM_SHAPE_BOX, NULL);
  s->spec[p].kind = UM_THERMAL_LUMPED;
  s->group[p].emittance_front = emittance;
  s->group[p].absorptance_front = 0.0;
  help_interior(s, p, "boards", 0.0, conductance / 6.0)->power = power;
  help_interior(s, p, "base", 500.0, 0.0)->held = BASE;
  help_build(s, &(struct um_thermal_contact){"bus.boards", "bus.base", G2, 0.0}, 1);
}

static uint32_t node_of(const struct help_satellite *s, const char *place)
{
  return help_place(s, place)->node[0];
}

/* Steady: the walls radiate what the boards release and the base hands on. Their temperature is
 * chosen, the power that it takes follows:
 *
 *   eps s A T_w^4 = G1 (T_a - T_w) = P + G2 (T_b - T_a). */
static void chain_balances(void **state)
{
  (void)state;
  const double wall = 250.0, out = 0.8 * UM_STEFAN_BOLTZMANN * 6.0 * pow(wall, 4);
  const double boards = wall + out / G1, power = out - G2 * (BASE - boards);
  struct help_satellite s = {0};
  chain(&s, 0.8, G1, power);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  double *t = calloc(um_thermal_network_nodes(s.body->network), sizeof *t);
  assert_non_null(t);
  /* KINSOL's residual of 1e-9 K, over conductances of a few W/K */
  OK(um_thermal_solve_steady(help_context, s.body->network, NULL, 0, &options, NULL, t));
  NEAR("walls", help_mean(&s, "bus", t), wall, 1e-7);
  NEAR("boards", help_mean(&s, "bus.boards", t), boards, 1e-7);
  NEAR("base", help_mean(&s, "bus.base", t), BASE, 0.0);
  /* walls against space are slow: 29160 / 65 = 446 s; after 100 of these the same */
  NEAR("walls in time", help_temperature_at(s.body->network, 0.0, node_of(&s, "bus.+x"), 44600.0),
       wall, 1e-6);
  /* the orbit that repeats without loads is that state */
  double drift;
  OK(um_thermal_solve_periodic(help_context, s.body->network, NULL, &options, NULL, 0.0, 6000.0,
                               1e-7, t, &drift));
  NEAR("walls, periodic", help_mean(&s, "bus", t), wall, 1e-6);
  NEAR("boards, periodic", help_mean(&s, "bus.boards", t), boards, 1e-6);
  NEAR("base, periodic", help_mean(&s, "bus.base", t), BASE, 0.0);
  free(t);
  help_end(&s);
}

static double series(void) { return G1 * G2 / (G1 + G2); } /* [W/K] */

/* Without radiation the wall relaxes to T_b + P / G2 with C / G, G the two in series. */
static void chain_relaxes(void **state)
{
  (void)state;
  const double power = 3.0, end = BASE + power / G2, tau = WALL / series();
  struct help_satellite s = {0};
  chain(&s, 0.0, G1, power);
  for (int k = 1; k <= 3; k++) {
    double t = 0.7 * k * tau, wall = end + (BEGIN - end) * exp(-t / tau);
    double boards = (G1 * wall + G2 * BASE + power) / (G1 + G2);
    /* relative tolerance 1e-10 of a step at 300 K, a few hundred steps */
    NEAR("wall", help_temperature_at(s.body->network, 0.0, node_of(&s, "bus.+x"), t), wall, 3e-6);
    NEAR("boards", help_temperature_at(s.body->network, 0.0, node_of(&s, "bus.boards"), t), boards,
         3e-6);
  }
  help_end(&s);
}

/* A pulse of power in the boards, P for the first h of every period L:
 *
 *   x_0 = P/G2 (1 - e^(-h/tau)) e^(-(L - h)/tau) / (1 - e^(-L/tau)),   x = T_w - T_b. */
static void pulse_repeats(void **state)
{
  (void)state;
  const double power = 12.0, length = 6000.0, h = 2500.0, tau = WALL / series();
  const double expected =
      power / G2 * -expm1(-h / tau) * exp(-(length - h) / tau) / -expm1(-length / tau);
  struct help_satellite s = {0};
  chain(&s, 0.0, G1, 0.0);
  uint32_t boards = node_of(&s, "bus.boards");
  const double t[2] = {0.0, h}, steps[2] = {power, 0.0}, weight = 1.0;
  OK(um_thermal_network_source_add(
      s.body->network, &(struct um_thermal_source){&boards, &weight, 1, t, steps, 2, true}));
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  double *found = calloc(um_thermal_network_nodes(s.body->network), sizeof *found), drift;
  assert_non_null(found);
  OK(um_thermal_solve_periodic(help_context, s.body->network, NULL, &options, NULL, 0.0, length,
                               1e-6, found, &drift));
  NEAR("wall over the base", help_mean(&s, "bus", found) - BASE, expected, 2e-6);
  NEAR("base", help_mean(&s, "bus.base", found), BASE, 0.0);
  free(found);
  help_end(&s);
}

struct kept {
  double value[8]; /* of the wall, the boards and the base, [K per unit] */
  const uint32_t *node;
  size_t nnode, total, ncolumn;
};

static enum um_status keep(void *user, size_t k, const double *temperature, const double *column)
{
  (void)k, (void)temperature;
  struct kept *kept = user;
  for (size_t c = 0; c < kept->ncolumn; c++)
    for (size_t i = 0; i < kept->nnode; i++)
      kept->value[c * kept->nnode + i] = column[c * kept->total + kept->node[i]];
  return UM_OK;
}

/* One watt in the boards: the wall answers with (1 - e^(-t/tau)) / G2, the boards with that times
 * G1 / (G1 + G2) and 1 / (G1 + G2) at once, the base with nothing. One watt in the base is lost. */
static void heat_in_boards_answers(void **state)
{
  (void)state;
  const double tau = WALL / series(), t = 0.9 * tau;
  struct help_satellite s = {0};
  chain(&s, 0.0, G1, 3.0);
  const uint32_t node[3] = {node_of(&s, "bus.+x"), node_of(&s, "bus.boards"),
                            node_of(&s, "bus.base")};
  const double weight = 1.0;
  const struct um_thermal_pulse pulse[2] = {{&node[1], &weight, 1, 0.0, 2.0 * tau},
                                            {&node[2], &weight, 1, 0.0, 2.0 * tau}};
  const struct um_thermal_forcings forcings = {.pulse = pulse, .npulse = 2};
  const struct um_thermal_sensitivity_options how = {.tolerance = 1e-8};
  struct kept kept = {
      .node = node, .nnode = 3, .total = um_thermal_network_nodes(s.body->network), .ncolumn = 2};
  struct um_thermal_solve_options options = help_options(1e-8, 1e-7, 0.0);
  OK(um_thermal_sensitivity(help_context, s.body->network, NULL, &options, NULL, 0.0, &t, 1,
                            &forcings, &how, keep, &kept));
  double wall = -expm1(-t / tau) / G2;
  /* asked for 1e-8 a step */
  NEAR("wall", kept.value[0], wall, 1e-6);
  NEAR("boards", kept.value[1], (G1 * wall + 1.0) / (G1 + G2), 1e-6);
  NEAR("base", kept.value[2], 0.0, 0.0);
  for (int i = 0; i < 3; i++) NEAR("of heat in the base", kept.value[3 + i], 0.0, 0.0);
  help_end(&s);
}

/* The wall by the base's temperature, 1 - e^(-t/tau), and by G1, with d(1/G) = -dG1 / G1^2:
 * dT/dG1 = -(T_0 - T_end) t e^(-t/tau) / C (G2 / (G1 + G2))^2. */
static void sensitivities_agree(void **state)
{
  (void)state;
  const double tau = WALL / series(), t = 0.8 * tau, step = 1e-4;
  struct help_satellite s[3] = {{.npart = 0}};
  chain(&s[0], 0.0, G1, 0.0);
  chain(&s[1], 0.0, G1, 0.0);
  chain(&s[2], 0.0, G1 + step, 0.0);
  help_hold(&s[1], "bus.base", BASE + step);
  const uint32_t node = node_of(&s[0], "bus.+x");
  const struct um_thermal_variant variant[2] = {{s[1].body->network, NULL, NULL, step, NULL},
                                                {s[2].body->network, NULL, NULL, step, NULL}};
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = 2};
  const struct um_thermal_sensitivity_options how = {.tolerance = 1e-6};
  struct kept kept = {.node = &node,
                      .nnode = 1,
                      .total = um_thermal_network_nodes(s[0].body->network),
                      .ncolumn = 2};
  struct um_thermal_solve_options options = help_options(1e-8, 1e-7, 0.0);
  OK(um_thermal_sensitivity(help_context, s[0].body->network, NULL, &options, NULL, 0.0, &t, 1,
                            &forcings, &how, keep, &kept));
  /* asked for 1e-6 a step; G1 is moved by 2.5e-5 of itself */
  NEAR("by the base", kept.value[0], -expm1(-t / tau), 3e-5);
  double share = G2 / (G1 + G2);
  double by_g1 = -(BEGIN - BASE) * t * exp(-t / tau) / WALL * share * share;
  NEAR("by a conductance", kept.value[1], by_g1, 1e-4 * fabs(by_g1));
  for (int i = 0; i < 3; i++) help_end(&s[i]);
}

/* Frame and boards behind perfect insulation: their difference dies away with
 * G (1/C_1 + 1/C_2), their heat stays. The wall is held by neither. */
static void two_masses_share(void **state)
{
  (void)state;
  const double c[2] = {154.0, 110.0}, g = 0.7, rate = g * (1.0 / c[0] + 1.0 / c[1]);
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  help_interior(&s, p, "frame", c[0], 0.0);
  help_interior(&s, p, "boards", c[1], 0.0);
  help_build(&s, &(struct um_thermal_contact){"bus.frame", "bus.boards", g, 0.0}, 1);
  const uint32_t node[2] = {node_of(&s, "bus.frame"), node_of(&s, "bus.boards")};
  s.body->network->node[node[0]].temperature = 280.0;
  s.body->network->node[node[1]].temperature = 310.0;
  double mean = (c[0] * 280.0 + c[1] * 310.0) / (c[0] + c[1]);
  for (int k = 1; k <= 2; k++) {
    double t = 0.6 * k / rate, apart = 30.0 * exp(-rate * t);
    NEAR("frame", help_temperature_at(s.body->network, 0.0, node[0], t),
         mean - apart * c[1] / (c[0] + c[1]), 3e-6);
    NEAR("boards", help_temperature_at(s.body->network, 0.0, node[1], t),
         mean + apart * c[0] / (c[0] + c[1]), 3e-6);
  }
  help_end(&s);
}

/* A share s that lags by l, alone with the rest: their difference dies away with
 * (s C / l) (1/(s C) + 1/((1 - s) C)) = 1 / (l (1 - s)). Power, which both get by capacity, keeps
 * them not apart. The place is their mean. */
static void share_lags(void **state)
{
  (void)state;
  const double c = 300.0, share = 0.4, lag = 250.0, power = 2.0;
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  struct um_thermal_interior_spec *boards = help_interior(&s, p, "boards", c, 0.0);
  boards->power = power;
  boards->lag = lag;
  boards->lag_share = share;
  help_build(&s, NULL, 0);
  const struct um_thermal_place *place = help_place(&s, "bus.boards");
  assert_int_equal(place->nnode, 2);
  NEAR("weight of what lags", place->weight[1], share, 1e-15);
  uint32_t front = place->node[0], behind = place->node[1];
  s.body->network->node[front].temperature = 300.0;
  s.body->network->node[behind].temperature = 280.0;
  for (int k = 1; k <= 2; k++) {
    double t = 150.0 * k, mean = 300.0 - share * 20.0 + power * t / c;
    double apart = 20.0 * exp(-t / (lag * (1.0 - share)));
    NEAR("front", help_temperature_at(s.body->network, 0.0, front, t), mean + share * apart, 3e-6);
    NEAR("behind", help_temperature_at(s.body->network, 0.0, behind, t),
         mean - (1.0 - share) * apart, 3e-6);
  }
  help_end(&s);
}

/* 6.5 kW in the battery, by the frame to a radiator of 50, 100, 150 m2, eps 0.8, 0 K around: its
 * temperature is printed (docs/physics/internal-heat.md), each step inside is P / G. */
static void battery_frame_radiator(void **state)
{
  (void)state;
  static const double area[3] = {50.0, 100.0, 150.0}, printed[3] = {231.37, 194.56, 175.80};
  for (int i = 0; i < 3; i++) {
    struct help_satellite s = {0};
    size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
    double edge = sqrt(area[i] / 6.0), *t;
    s.shape[p].size[0] = s.shape[p].size[1] = s.shape[p].size[2] = edge;
    s.spec[p].kind = UM_THERMAL_LUMPED;
    s.group[p].emittance_front = 0.8;
    help_interior(&s, p, "frame", 4e5, 1300.0 / 6.0);
    help_interior(&s, p, "battery", 2e5, 0.0)->power = 6500.0;
    help_build(&s, &(struct um_thermal_contact){"bus.frame", "bus.battery", 325.0, 0.0}, 1);
    struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
    t = calloc(um_thermal_network_nodes(s.body->network), sizeof *t);
    assert_non_null(t);
    OK(um_thermal_solve_steady(help_context, s.body->network, NULL, 0, &options, NULL, t));
    NEAR("radiator", help_mean(&s, "bus", t), printed[i], 0.006); /* two digits */
    NEAR("frame over it", help_mean(&s, "bus.frame", t) - help_mean(&s, "bus", t), 5.0, 1e-7);
    NEAR("battery over that", help_mean(&s, "bus.battery", t) - help_mean(&s, "bus.frame", t), 20.0,
         1e-7);
    free(t);
    help_end(&s);
  }
}

/* MLI around the second of two interiors (docs/physics/mli.md, e* 0.03, dark: the skin at 128.5366
 * K leaks 12.0729 W/m2 out of 293 K). */
static void blanket_wraps_the_second(void **state)
{
  (void)state;
  struct um_thermal_mli mli = {.effective_emittance = 0.03,
                               .areal_heat_capacity = 60.0,
                               .wraps_interior = true,
                               .interior = 1};
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.spec[p].kind = UM_THERMAL_LUMPED;
  s.group[p].absorptance_front = 0.38;
  s.group[p].emittance_front = 0.78;
  s.group[p].mli = &mli;
  help_interior(&s, p, "frame", 1e3, 0.0);
  help_interior(&s, p, "tank", 0.0, 0.0)->held = 293.0;
  help_build(&s, &(struct um_thermal_contact){"bus.frame", "bus", 2.0, 0.0}, 1);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  size_t n = um_thermal_network_nodes(s.body->network);
  double *t = calloc(n, sizeof *t);
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  assert_true(t != NULL && heat != NULL);
  OK(um_thermal_solve_steady(help_context, s.body->network, NULL, 0, &options, NULL, t));
  NEAR("skin", help_mean(&s, "bus", t), 128.5366, 1e-4);
  /* the contact with the part meets what the blanket wraps: so the frame is as warm as the tank */
  NEAR("frame", help_mean(&s, "bus.frame", t), 293.0, 1e-7);
  OK(um_thermal_heat_of_nodes(help_context, s.body->network, NULL, &options, 0.0, t, heat));
  NEAR("leak", -heat[node_of(&s, "bus.tank")].exchanged, 6.0 * 12.0729, 6.0 * 1e-4);
  free(heat);
  free(t);
  help_end(&s);
}

static void refused(struct help_satellite *s, const char *words)
{
  um_core_message_clear(help_context);
  assert_int_equal(
      um_thermal_body_create(help_context, s->geometry, s->spec, s->npart, NULL, 0, &s->body),
      UM_ERR_INPUT);
  if (strstr(um_core_message(help_context), words) == NULL)
    fail_msg("'%s' is not in '%s'", words, um_core_message(help_context));
}

static void bad_interiors_are_refused(void **state)
{
  (void)state;
  static const struct {
    const char *name, *says;
  } names[] = {{"", "has no name"},
               {NULL, "has no name"},
               {"+x", "'+x' has the name of a group"},
               {"wall", "'wall' has the name of a side"},
               {"frame", "'frame' has the name of another"},
               {"a.b", "has a dot"}};
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  help_interior(&s, p, "frame", 10.0, 1.0);
  struct um_thermal_interior_spec *second = help_interior(&s, p, "boards", 10.0, 1.0);
  help_geometry(&s);
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    second->name = names[i].name;
    refused(&s, names[i].says);
  }
  second->name = "boards";
  second->capacity = -1.0;
  refused(&s, "part bus, boards: heat capacity -1 J/K; accepted: finite, 0 or more");
  second->capacity = 10.0;
  second->power = NAN;
  refused(&s, "part bus, boards: power nan W");
  second->power = 0.0;
  second->held = -3.0;
  refused(&s, "part bus, boards: held at -3 K");
  second->held = 0.0;
  second->lag = 10.0;
  refused(&s, "part bus, boards: 0 of it lag by 10 s; accepted: a share above 0 and below 1");
  second->lag = 0.0;
  s.conductance[p][1] = -2.0;
  refused(&s, "conductance to the inside -2 W/K");
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(chain_balances),
                                     cmocka_unit_test(chain_relaxes),
                                     cmocka_unit_test(pulse_repeats),
                                     cmocka_unit_test(heat_in_boards_answers),
                                     cmocka_unit_test(sensitivities_agree),
                                     cmocka_unit_test(two_masses_share),
                                     cmocka_unit_test(share_lags),
                                     cmocka_unit_test(battery_frame_radiator),
                                     cmocka_unit_test(blanket_wraps_the_second),
                                     cmocka_unit_test(bad_interiors_are_refused)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
