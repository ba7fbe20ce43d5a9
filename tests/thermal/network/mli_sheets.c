/* Sheets of MLI that store heat, in a row under the outer layer (thermal/network/mli.c).
 *
 *   space   skin | 1 | 2 | ... | n | what is wrapped, held
 *              n + 1 gaps of (n + 1) e*
 */
#include "tests/thermal/body_help.h"

/* A closed box under a blanket; wrapped: the wall, or an interior. */
static void box(struct help_satellite *s, enum um_thermal_part_kind kind, bool interior,
                const struct um_thermal_mli *mli, double emittance)
{
  *s = (struct help_satellite){0};
  size_t p = help_part(s, "bus", UM_SHAPE_BOX, NULL);
  s->shape[p].facet_size = 0.8;
  s->shape[p].solid = kind == UM_THERMAL_SOLID;
  s->spec[p].kind = kind;
  if (interior) help_interior(s, p, "interior", 1e5, 0.0);
  s->group[p].absorptance_front = 0.38;
  s->group[p].emittance_front = emittance;
  s->group[p].mli = mli;
  help_build(s, NULL, 0);
  help_hold(s, interior ? "bus.interior" : "bus.wall", 293.0);
}

/* In a steady state they are not there: skin of 0.78 in the dark of 0 K around 293 K with e* 0.03,
 * 128.5366 K as printed in docs/physics/mli.md, whatever the number of sheets. T^4 goes in even
 * steps from the skin to what is wrapped: its mean over n of them is the middle. */
static void steady_state_is_that_of_the_whole(void **state)
{
  (void)state;
  static const struct {
    enum um_thermal_part_kind kind;
    bool interior;
  } rows[] = {{UM_THERMAL_SHELL, false},
              {UM_THERMAL_SHELL, true},
              {UM_THERMAL_LUMPED, false},
              {UM_THERMAL_LUMPED, true},
              {UM_THERMAL_SOLID, false}};
  static const size_t sheets[] = {1, 3, 20};
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++)
    for (size_t i = 0; i < 3; i++) {
      const struct um_thermal_mli mli = {.effective_emittance = 0.03,
                                         .areal_heat_capacity = 60.0,
                                         .wraps_interior = rows[k].interior,
                                         .sheets = sheets[i],
                                         .sheet_heat_capacity = 100.0};
      struct help_satellite s;
      box(&s, rows[k].kind, rows[k].interior, &mli, 0.78);
      double *t = help_steady(&s, NULL, 0.0), skin = help_mean(&s, "bus", t), fourth = 0.0;
      const struct um_thermal_place *place = help_place(&s, "bus.sheets");
      for (size_t j = 0; j < place->nnode; j++)
        fourth += place->weight[j] * pow(t[place->node[j]], 4);
      NEAR("skin", skin, 128.5366, 1e-4);
      NEAR("sheets", fourth, 0.5 * (pow(skin, 4) + pow(293.0, 4)), 1e-8 * fourth);
      NEAR("area", place->area, 6.0, 1e-12);
      free(t);
      help_end(&s);
    }
}

/* What a law of e* lets through between 290 and 250 K where every gap follows it. Lockheed's is a
 * difference of one function of temperature, which adds up over the gaps to the same. Doenecke's is
 * none: four gaps let through 0.998068224253 of it, by bisection of the row outside of this
 * program.
 */
static void laws_hold_for_the_whole(void **state)
{
  (void)state;
  const double hot = 290.0, cold = 250.0, mean = 270.0;
  const double fourth = UM_STEFAN_BOLTZMANN * (pow(hot, 4) - pow(cold, 4));
  const double expected[2] = {
      (0.000136 / (4.0 * UM_STEFAN_BOLTZMANN * mean * mean) + 0.000121 * pow(mean, 0.667)) * fourth,
      8.95e-8 * pow(15.0, 2.56) * mean / 21.0 * (hot - cold) +
          5.39e-10 * 0.031 / 20.0 * (pow(hot, 4.67) - pow(cold, 4.67))};
  const struct um_thermal_mli_slope slope[2] = {um_thermal_mli_doenecke(1.0),
                                                um_thermal_mli_lockheed(20.0, 1500.0, 0.031)};
  for (int which = 0; which < 2; which++) {
    const struct um_thermal_mli mli = {.effective_emittance = slope[which].effective_emittance,
                                       .conducted = slope[which].conducted,
                                       .law = which == 0 ? UM_MLI_DOENECKE : UM_MLI_LOCKHEED,
                                       .areal_heat_capacity = 60.0,
                                       .sheets = 3,
                                       .sheet_heat_capacity = 100.0};
    struct help_satellite s;
    box(&s, UM_THERMAL_LUMPED, false, &mli, 0.0);
    help_hold(&s, "bus", cold);
    help_hold(&s, "bus.wall", hot);
    double *t = help_steady(&s, NULL, 0.0), leak = 0.0;
    struct um_thermal_heat *flow = calloc(s.body->network->nnode, sizeof *flow);
    assert_non_null(flow);
    struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
    OK(um_thermal_heat_of_nodes(help_context, s.body->network, NULL, &options, 0.0, t, flow));
    const struct um_thermal_place *skin = help_place(&s, "bus");
    for (size_t j = 0; j < skin->nnode; j++)
      leak += flow[skin->node[j]].conducted + flow[skin->node[j]].exchanged;
    print_message("law %d: %.6f of the law between the sides\n", which,
                  leak / (6.0 * expected[which]));
    NEAR("leak", leak / (6.0 * expected[which]), which == 0 ? 0.998068224253 : 1.0, 1e-8);
    free(t);
    free(flow);
    help_end(&s);
  }
}

/* Near 300 K a row of n + 1 equal layers (skin and n sheets, C each) behind gaps of K = 4 sigma T^3
 * (n + 1) e*, free outside and held inside, dies away in modes: of the layer j = 0 .. n
 *
 *   T_j - T = a cos(theta (j + 1/2)) e^(-lambda t),   theta = (2 m - 1) pi / (2 n + 3),
 *   lambda = 4 K/C sin^2(theta/2).
 *
 * a = 0.003 K, so that T^3 is constant to 3e-5. The slowest mode is how long a blanket remembers,
 * the fastest how soon its skin follows. */
static void modes_die_away(void **state)
{
  (void)state;
  enum { N = 4 };
  const double each = 12.0, e = 0.02, a = 0.003, at = 293.0;
  const double gap = 4.0 * UM_STEFAN_BOLTZMANN * pow(at, 3) * (N + 1) * e; /* [W/m^2/K] */
  for (int lumped = 0; lumped < 2; lumped++)
    for (int m = 1; m <= N + 1; m += N / 2) {
      const struct um_thermal_mli mli = {.effective_emittance = e,
                                         .areal_heat_capacity = each,
                                         .sheets = N,
                                         .sheet_heat_capacity = N * each};
      struct help_satellite s;
      box(&s, lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL, false, &mli, 0.0);
      double theta = (2.0 * m - 1.0) * UM_PI / (2.0 * N + 3.0);
      double lambda = 4.0 * gap / each * pow(sin(0.5 * theta), 2), left = 0.0;
      size_t n = um_thermal_network_nodes(s.body->network);
      double *start = calloc(n, sizeof *start);
      assert_non_null(start);
      for (size_t i = 0; i < n; i++) start[i] = at;
      const struct um_thermal_place *skin = help_place(&s, "bus"),
                                    *in = help_place(&s, "bus.sheets");
      for (size_t j = 0; j < skin->nnode; j++) {
        start[skin->node[j]] = at + a * cos(0.5 * theta);
        for (uint32_t k = 1; k <= N; k++) /* sheets stand behind their skin */
          start[skin->node[j] + k] = at + a * cos((k + 0.5) * theta);
      }
      for (size_t j = 0; j < in->nnode; j++) assert_true(start[in->node[j]] != at);
      struct um_thermal_solve_options options = help_options(1e-12, 1e-11, 0.0);
      struct um_thermal_history *h = NULL;
      const double t = 1.0 / lambda;
      OK(um_thermal_solve(help_context, s.body->network, NULL, &options, start, 0.0, &t, 1, &h));
      left = (help_mean(&s, "bus", h->temperature) - at) / (a * cos(0.5 * theta));
      print_message("mode %d: 1/lambda %.2f s, %.6f left of e^-1\n", m, t, left * exp(1.0));
      NEAR("left", left, exp(-1.0), 1e-4);
      um_thermal_history_destroy(help_context, &h);
      free(start);
      help_end(&s);
    }
}

/* Seams pass the sheets by: without radiation through it, skin at 250 K, wall at 293 K, what flows
 * is u A times that, none of it into the sheets. */
static void seams_pass_them_by(void **state)
{
  (void)state;
  const struct um_thermal_mli mli = {.areal_heat_capacity = 60.0,
                                     .seam_conductance = 0.2,
                                     .sheets = 2,
                                     .sheet_heat_capacity = 50.0};
  struct help_satellite s;
  box(&s, UM_THERMAL_SHELL, false, &mli, 0.0);
  size_t n = um_thermal_network_nodes(s.body->network);
  double *t = calloc(n, sizeof *t), in = 0.0, out = 0.0;
  struct um_thermal_heat *flow = calloc(n, sizeof *flow);
  assert_true(t != NULL && flow != NULL);
  for (size_t i = 0; i < n; i++) t[i] = 293.0;
  const struct um_thermal_place *skin = help_place(&s, "bus"),
                                *sheets = help_place(&s, "bus.sheets");
  for (size_t j = 0; j < skin->nnode; j++) t[skin->node[j]] = 250.0;
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, s.body->network, NULL, &options, 0.0, t, flow));
  for (size_t j = 0; j < skin->nnode; j++) out += flow[skin->node[j]].conducted;
  for (size_t j = 0; j < sheets->nnode; j++) in += fabs(flow[sheets->node[j]].conducted);
  NEAR("through seams", out, 0.2 * 6.0 * 43.0, 1e-9);
  assert_true(in == 0.0);
  free(t);
  free(flow);
  help_end(&s);
}

static void refused(void **state)
{
  (void)state;
  const struct um_thermal_mli mli = {.effective_emittance = 0.05,
                                     .areal_heat_capacity = 60.0,
                                     .sheets = 20,
                                     .sheet_heat_capacity = 50.0};
  struct help_satellite s = {0};
  size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
  s.group[p].mli = &mli;
  help_geometry(&s);
  assert_int_equal(
      um_thermal_body_create(help_context, s.geometry, s.spec, s.npart, NULL, 0, &s.body),
      UM_ERR_INPUT);
  if (strstr(um_core_message(help_context),
             "effective emittance of a gap of the MLI, that of the MLI times its gaps, 1.05; "
             "accepted: 0 to 1") == NULL)
    fail_msg("'%s'", um_core_message(help_context));
  um_core_message_clear(help_context);
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(steady_state_is_that_of_the_whole),
      cmocka_unit_test(laws_hold_for_the_whole),
      cmocka_unit_test(modes_die_away),
      cmocka_unit_test(seams_pass_them_by),
      cmocka_unit_test(refused),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
