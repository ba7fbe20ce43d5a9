/* Heat effects on parts, each against the balance that its equation says. The satellite is steady
 * (heat_help.h), so every node's balance is exact; loads are floats, 6e-8 of each. */
#include "effects/effects.h"
#include "heat_help.h"

#define BALANCE 1e-6 /* relative: float loads and the solver's 1e-9 of temperatures of 300 K */

/* Whatever is released inside is radiated in the end: emission rises by the power. */
static void internal_power_is_radiated(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("internal_power:bus,power_W=30"), NONE);
  struct heat_budget before = heat_budget(&a, NULL, false), after = heat_budget(&b, NULL, false);
  heat_close("emission without", before.emitted, before.absorbed + 20.0, BALANCE);
  heat_close("emission with", after.emitted, before.absorbed + 50.0, BALANCE);
  assert_true(heat_temperature(&b, "bus.interior", 0) > heat_temperature(&a, "bus.interior", 0));
  assert_true(heat_same_reflected(&a, &b, "vis"));
  heat_release(&a);
  heat_release(&b);
}

/* Downward it ends where nothing is dissipated: 20 W are stated, in two parts too that round. A
 * scenario that carries heat away inside does so all the same. */
static void internal_power_ends_at_nothing(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(LIST("parts.bus.interior.power_W=0"), NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("internal_power:bus,power_W=-20"), NONE);
  struct heat_run c = heat_compute(LIST("parts.bus.interior.power_W=0.3"),
                                   LIST("internal_power:bus,power_W=-0.30000000000000004"), NONE);
  assert_true(heat_same_temperatures(&a, &b) && heat_same_temperatures(&a, &c));
  struct heat_run cold = heat_compute(LIST("parts.bus.interior.power_W=-5"),
                                      LIST("internal_power:bus,power_W=0"), NONE);
  struct heat_run same = heat_compute(LIST("parts.bus.interior.power_W=-5"), NONE, NONE);
  assert_true(heat_same_temperatures(&cold, &same));
  struct heat_run *all[] = {&a, &b, &c, &cold, &same};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) heat_release(all[i]);
}

/* The run begins with the interior dT off its steady state. It then shares that with the walls, C_w
 * in all, by G, two masses that are alone but for the blankets:
 *
 *   dT(t) = dT (C + C_w exp(-k t)) / (C + C_w),   k = G (1/C + 1/C_w).
 *
 * In 60 s the walls warm by 0.12 K, of which the blankets' 0.7 W/K take 1e-4 K: 2e-6 K of the
 * interior. */
static void stored_heat_dies_away(void **state)
{
  (void)state;
  const char *const *alone = LIST("contacts=[]");
  struct heat_run a = heat_compute(alone, NONE, NONE);
  struct heat_run b = heat_compute(alone, LIST("stored_heat:bus,shift_K=10"), NONE);
  double c = 20000.0, wall = 6.0 * 5000.0, k = 6.0 * (1.0 / c + 1.0 / wall); /* [J/K], [1/s] */
  double first = heat_temperature(&b, "bus.interior", 0) - heat_temperature(&a, "bus.interior", 0);
  double later = heat_temperature(&b, "bus.interior", 1) - heat_temperature(&a, "bus.interior", 1);
  double expected = 10.0 * (c + wall * exp(-k * 60.0)) / (c + wall);
  print_message("  10 K, after 60 s %.6f K, expected %.6f K\n", later, expected);
  assert_true(fabs(first - 10.0) <= 1e-9);
  assert_true(fabs(later - expected) <= 1e-5);
  /* the panel hangs on nothing: only the steps of the integrator are others */
  heat_close("panel", heat_temperature(&b, "panel.front", 1),
             heat_temperature(&a, "panel.front", 1), 1e-7);
  assert_true(heat_same_reflected(&a, &b, "vis"));
  heat_release(&a);
  heat_release(&b);
}

/* What the blankets radiate more than they absorb comes through them: sum f e* sigma A (T_wall^4 -
 * T_skin^4). The difference of near numbers keeps 1e-5. */
static void mli_emittance_scales_the_leak(void **state)
{
  (void)state;
  static const char *const groups[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  static const struct {
    const char *text, *group; /* the factor acts on this group, NULL: on all */
    double factor;
  } cases[] = {{"mli_emittance:bus,factor=1", NULL, 1.0},
               {"mli_emittance:bus,factor=3", NULL, 3.0},
               {"mli_emittance:bus.-x,factor=5", "-x", 5.0}};
  double interior[3];
  for (size_t i = 0; i < 3; i++) {
    struct heat_run run = heat_compute(NONE, LIST(cases[i].text), NONE);
    struct heat_budget skin = heat_budget(&run, "bus", false);
    double leak = 0.0;
    for (size_t g = 0; g < 6; g++) {
      char outer[32], wall[32];
      snprintf(outer, sizeof outer, "bus.%s", groups[g]);
      snprintf(wall, sizeof wall, "bus.%s.wall", groups[g]);
      bool acts = cases[i].group == NULL || strcmp(cases[i].group, groups[g]) == 0;
      leak +=
          (acts ? cases[i].factor : 1.0) * 0.02 * UM_STEFAN_BOLTZMANN *
          (pow(heat_temperature(&run, wall, 0), 4.0) - pow(heat_temperature(&run, outer, 0), 4.0));
    }
    heat_close(cases[i].text, leak, skin.emitted - skin.absorbed, 1e-5);
    interior[i] = heat_temperature(&run, "bus.interior", 0);
    heat_release(&run);
  }
  assert_true(interior[1] < interior[2] && interior[2] < interior[0]);
}

/* The same leak where e* goes with the mean temperature, (T_m / 300 K)^n, and with seams u: sum of
 * e* sigma A (T_wall^4 - T_skin^4) (T_m/300)^n + u A (T_wall - T_skin) over faces of 1 m2. */
static void blankets_have_laws_and_seams(void **state)
{
  (void)state;
  static const char *const groups[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  static const double exponent[] = {-2.0, 0.0, 1.0}, seams[] = {0.0, 0.2, 0.1};
  for (size_t i = 0; i < 3; i++) {
    char law[64], leaky[64];
    snprintf(law, sizeof law, "mli_temperature_law:bus,exponent=%g", exponent[i]);
    snprintf(leaky, sizeof leaky, "mli_seams:bus,conductance_W_m2_K=%g", seams[i]);
    struct heat_run run = heat_compute(NONE, LIST(law, leaky), NONE);
    struct heat_budget skin = heat_budget(&run, "bus", false);
    double leak = 0.0;
    for (size_t g = 0; g < 6; g++) {
      char outer[32], wall[32];
      snprintf(outer, sizeof outer, "bus.%s", groups[g]);
      snprintf(wall, sizeof wall, "bus.%s.wall", groups[g]);
      double w = heat_temperature(&run, wall, 0), s = heat_temperature(&run, outer, 0);
      leak += 0.02 * pow(0.5 * (w + s) / 300.0, exponent[i]) * UM_STEFAN_BOLTZMANN *
                  (pow(w, 4.0) - pow(s, 4.0)) +
              seams[i] * (w - s);
    }
    heat_close(law, leak, skin.emitted - skin.absorbed, 1e-5);
    heat_release(&run);
  }
}

/* Conducted and exchanged heat [W] of the places that add up to the satellite. */
static double within(const struct heat_run *run, size_t k, double *most)
{
  static const char *const places[] = {"panel", "bus", "bus.wall", "bus.sheets", "bus.interior"};
  const struct um_model_result *r = run->result;
  double sum = 0.0;
  *most = 0.0;
  for (size_t i = 0; i < sizeof places / sizeof places[0]; i++)
    for (size_t p = 0; p < r->nplace; p++) {
      if (strcmp(r->place[p].name, places[i]) != 0) continue;
      const struct um_thermal_heat *h = &r->heat[k * r->nplace + p];
      sum += h->conducted + h->exchanged;
      *most = fmax(*most, fabs(h->conducted + h->exchanged));
    }
  return sum;
}

/* In the dark. Sheets of an effect are those of the keys, and add to them; what flows within the
 * satellite comes from somewhere in it, sheets included; the skin is warmer for them, first hardly.
 */
static void sheets_give_back(void **state)
{
  (void)state;
#define MLI "parts.bus.mli={effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 60"
#define DARK                                                                                       \
  "orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}", "thermal.start=isothermal",                  \
      "thermal.orbits_before=0", "time.step_s=5", "time.stop_utc=2020-03-20T12:02:00Z"
  struct heat_run none = heat_compute(LIST(DARK), NONE, NONE);
  struct heat_run keys = heat_compute(
      LIST(DARK, MLI ", sheets: 3, sheets_areal_heat_capacity_J_m2_K: 60}"), NONE, NONE);
  struct heat_run effect =
      heat_compute(LIST(DARK), LIST("mli_sheets:bus,areal_heat_capacity_J_m2_K=60,sheets=3"), NONE);
  struct heat_run both =
      heat_compute(LIST(DARK, MLI ", sheets: 3, sheets_areal_heat_capacity_J_m2_K: 40}"),
                   LIST("mli_sheets:bus,areal_heat_capacity_J_m2_K=20"), NONE);
  assert_true(heat_same_temperatures(&keys, &effect));
  assert_true(heat_same_temperatures(&keys, &both));
  double most, first = 0.0, last = 0.0;
  for (size_t k = 0; k < keys.result->nobs; k++) {
    double sum = within(&keys, k, &most);
    if (!(fabs(sum) <= 1e-9 * fmax(most, 1.0))) fail_msg("row %zu: %g W of %g", k, sum, most);
    last = heat_temperature(&keys, "bus.-x", k) - heat_temperature(&none, "bus.-x", k);
    if (k == 1) first = last;
  }
  print_message("  skin warmer by %.3f K after 5 s, %.3f K after 120 s\n", first, last);
  assert_true(first > 0.0 && last > 5.0 * first);
  heat_release(&none);
  heat_release(&keys);
  heat_release(&effect);
  heat_release(&both);
  char message[512];
  heat_refused(LIST("parts.bus.mli.sheets=3"), NONE, message, sizeof message);
  if (strstr(message, "mli.sheets: stands alone") == NULL) fail_msg("'%s'", message);
  heat_refused(LIST("parts.bus.mli.sheets_areal_heat_capacity_J_m2_K=3"), NONE, message,
               sizeof message);
  if (strstr(message, "mli.sheets_areal_heat_capacity_J_m2_K: stands alone") == NULL)
    fail_msg("'%s'", message);
}

/* A body that exchanges with nothing else obeys f C dT/dt = q(T): with f = 2 it is at 120 s where
 * it was at 60 s with f = 1. To the integrator's 1e-9 per step. */
static void heat_capacity_stretches_time(void **state)
{
  (void)state;
  const char *const *cooling = LIST(
      "orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}", "contacts=[]", "thermal.start=isothermal",
      "thermal.orbits_before=0", "time.stop_utc=2020-03-20T12:02:00Z");
  struct heat_run a = heat_compute(cooling, NONE, NONE);
  struct heat_run b = heat_compute(cooling, LIST("heat_capacity:panel,factor=2"), NONE);
  static const char *const sides[] = {"panel.front", "panel.back"};
  for (size_t i = 0; i < 2; i++) {
    double t = heat_temperature(&a, sides[i], 1);
    assert_true(280.0 - t > 1.0);
    heat_close(sides[i], heat_temperature(&b, sides[i], 2), t, 1e-7);
  }
  /* the bus is another body: only the steps of the integrator are others */
  heat_close("bus", heat_temperature(&b, "bus.-x", 2), heat_temperature(&a, "bus.-x", 2), 1e-7);
  heat_release(&a);
  heat_release(&b);
}

static double capacity(const struct heat_run *run, const char *node)
{
  size_t i = um_thermal_network_find(run->model->body->network, node);
  if (i == (size_t)-1) fail_msg("no node is called '%s'", node);
  return um_thermal_network_capacity(run->model->body->network, (uint32_t)i);
}

/* Walls and skins, of the group or part that is named; never the interior. Doubling is exact. */
static void heat_capacity_acts_on_its_target(void **state)
{
  (void)state;
  static const struct {
    const char *node;
    double of_part, of_group;
  } nodes[] = {{"bus.+x", 2.0, 2.0},     {"bus.+x.mli", 2.0, 2.0},   {"bus.-y", 2.0, 1.0},
               {"bus.-y.mli", 2.0, 1.0}, {"bus.interior", 1.0, 1.0}, {"panel.back", 1.0, 1.0}};
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run part = heat_compute(NONE, LIST("heat_capacity:bus,factor=2"), NONE);
  struct heat_run group = heat_compute(NONE, LIST("heat_capacity:bus.+x,factor=2"), NONE);
  for (size_t i = 0; i < sizeof nodes / sizeof nodes[0]; i++) {
    assert_true(capacity(&part, nodes[i].node) == nodes[i].of_part * capacity(&a, nodes[i].node));
    assert_true(capacity(&group, nodes[i].node) == nodes[i].of_group * capacity(&a, nodes[i].node));
  }
  heat_close("steady state", heat_temperature(&part, "bus.interior", 0),
             heat_temperature(&a, "bus.interior", 0), 1e-8);
  heat_release(&a);
  heat_release(&part);
  heat_release(&group);
}

/* An interior that exchanges with nothing warms by P t / (C + dC): 20 W, 20000 J/K and what is
 * added or taken. Walls keep theirs; a steady state feels nothing. To the integrator's 1e-9 per
 * step. */
static void interior_capacity_slows_the_interior(void **state)
{
  (void)state;
  const char *const *alone =
      LIST("parts.bus.interior.conductance_W_K=1e-9", "contacts=[]", "thermal.start=isothermal",
           "thermal.orbits_before=0", "time.stop_utc=2020-03-20T12:02:00Z");
  static const double added[] = {0.0, 300.0, 20000.0, -8000.0};
  for (size_t i = 0; i < 4; i++) {
    char text[64];
    snprintf(text, sizeof text, "interior_capacity:bus,capacity_J_K=%g", added[i]);
    struct heat_run run = heat_compute(alone, LIST(text), NONE);
    assert_true(capacity(&run, "bus.interior") == 20000.0 + added[i]);
    assert_true(capacity(&run, "bus.+x") == 5000.0);
    heat_close(text, heat_temperature(&run, "bus.interior", 2),
               280.0 + 20.0 * 120.0 / (20000.0 + added[i]), 1e-8);
    heat_release(&run);
  }
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("interior_capacity:bus"), NONE);
  heat_close("steady state", heat_temperature(&b, "bus.interior", 0),
             heat_temperature(&a, "bus.interior", 0), 1e-8);
  heat_release(&a);
  heat_release(&b);
}

/* A solid has its capacity in the volume. */
static void heat_capacity_acts_on_solids(void **state)
{
  (void)state;
  const struct um_effect *effect = um_effects_find("heat_capacity");
  const double value[] = {1.5};
  const struct um_effect_use use = {.effect = effect, .target = "tank", .value = value};
  struct um_thermal_part_spec spec = {
      .kind = UM_THERMAL_SOLID, .density = 2700.0, .specific_heat = 900.0, .conductivity = 167.0};
  assert_int_equal(effect->hooks.part(NULL, &use, "other", &spec), UM_OK);
  assert_true(spec.specific_heat == 900.0);
  assert_int_equal(effect->hooks.part(NULL, &use, "tank", &spec), UM_OK);
  assert_true(spec.specific_heat == 1350.0 && spec.density == 2700.0 && spec.conductivity == 167.0);
}

/* The share of direct sunlight is missing from what is radiated, be it more than stated or less;
 * all of what is stated can go, and light does not know. */
static void panel_extraction_takes_direct_sunlight(void **state)
{
  (void)state;
  static const double change[] = {0.2, -0.1, -0.18};
  const char *const *stated = LIST("parts.panel.electrical_extraction=0.18");
  struct heat_run a = heat_compute(stated, NONE, NONE), none = heat_compute(NONE, NONE, NONE);
  struct heat_budget before = heat_budget(&a, NULL, false);
  struct heat_budget front = heat_budget(&a, "panel", false);
  assert_true(front.sun > 0.99 * 2.0 * UM_SOLAR_IRRADIANCE);
  for (size_t i = 0; i < 3; i++) {
    char text[64];
    snprintf(text, sizeof text, "panel_extraction:panel,efficiency=%g", change[i]);
    struct heat_run b = heat_compute(stated, LIST(text), NONE);
    heat_close(text, heat_budget(&b, NULL, false).emitted, before.emitted - change[i] * front.sun,
               BALANCE);
    assert_true(heat_same_reflected(&a, &b, "vis"));
    assert_false(heat_same_band(&a, &b, "lwir"));
    assert_true(heat_same_temperatures(&b, &none) == (i == 2));
    heat_release(&b);
  }
  heat_release(&a);
  heat_release(&none);
}

/* Without contacts the back gets through the panel what it radiates more than it absorbs: f U A
 * (T_front - T_back). */
static void through_conductance_carries_to_the_back(void **state)
{
  (void)state;
  double gradient[2];
  const double factor[] = {1.0, 4.0};
  for (size_t i = 0; i < 2; i++) {
    char text[64];
    snprintf(text, sizeof text, "through_conductance:panel,factor=%g", factor[i]);
    struct heat_run run = heat_compute(LIST("contacts=[]"), LIST(text), NONE);
    struct heat_budget back = heat_budget(&run, "panel", true);
    gradient[i] =
        heat_temperature(&run, "panel.front", 0) - heat_temperature(&run, "panel.back", 0);
    heat_close(text, factor[i] * 50.0 * 2.0 * gradient[i], back.emitted - back.absorbed, BALANCE);
    heat_release(&run);
  }
  assert_true(gradient[1] < 0.3 * gradient[0]);
}

/* What reaches the back and is not radiated there goes on through the contact: f G (T_back -
 * T_wall). */
static void contact_conductance_carries_to_the_bus(void **state)
{
  (void)state;
  static const struct {
    const char *text;
    double factor;
  } cases[] = {{"contact_conductance,factor=1", 1.0},
               {"contact_conductance,factor=5", 5.0},
               {"contact_conductance:bus.+x,factor=5", 5.0},
               {"contact_conductance:panel,factor=5", 5.0},
               {"contact_conductance:bus.-x,factor=5", 1.0}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct heat_run run = heat_compute(NONE, LIST(cases[i].text), NONE);
    struct heat_budget back = heat_budget(&run, "panel", true);
    double at_back = heat_temperature(&run, "panel.back", 0);
    double through = 50.0 * 2.0 * (heat_temperature(&run, "panel.front", 0) - at_back);
    double contact = through - (back.emitted - back.absorbed); /* [W] of 650 W */
    heat_close(cases[i].text,
               cases[i].factor * 2.0 * (at_back - heat_temperature(&run, "bus.+x.wall", 0)),
               contact, 1e-5);
    heat_release(&run);
  }
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("effects_heat_parts.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(internal_power_is_radiated),
      cmocka_unit_test(internal_power_ends_at_nothing),
      cmocka_unit_test(stored_heat_dies_away),
      cmocka_unit_test(mli_emittance_scales_the_leak),
      cmocka_unit_test(blankets_have_laws_and_seams),
      cmocka_unit_test(sheets_give_back),
      cmocka_unit_test(heat_capacity_stretches_time),
      cmocka_unit_test(heat_capacity_acts_on_its_target),
      cmocka_unit_test(interior_capacity_slows_the_interior),
      cmocka_unit_test(heat_capacity_acts_on_solids),
      cmocka_unit_test(panel_extraction_takes_direct_sunlight),
      cmocka_unit_test(through_conductance_carries_to_the_back),
      cmocka_unit_test(contact_conductance_carries_to_the_bus),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
