/* Walls, solids and blankets that go with temperature: what a body makes of its specs, against the
 * totals and formulas. Sums of some thousand doubles: 1e-12. */
#include "tests/thermal/body_help.h"
#include "tests/thermal/law_help.h"

static struct um_thermal_ratio heat, conduction;

/* Every joule of capacity follows the law, times its slope, and every link but those through the
 * wall: a two-sided plate of 1 m2 and 4860 J/m2/K, a solid cube of 1 m3. */
static void materials_are_followed(void **state)
{
  (void)state;
  heat = law_line(1.3e-3);
  conduction = law_line(-4e-4);
  const struct um_thermal_bulk_law law = {&heat, &conduction, 5e-4};
  for (int kind = 0; kind < 3; kind++) {
    struct help_satellite s = {0};
    bool solid = kind == UM_THERMAL_SOLID;
    size_t p = help_part(&s, "part", solid ? UM_SHAPE_BOX : UM_SHAPE_PLATE, solid ? NULL : "paint");
    s.shape[p].facet_size = 0.5;
    s.shape[p].solid = solid;
    s.spec[p].kind = (enum um_thermal_part_kind)kind;
    s.spec[p].shell.through_conductance = 30.0;
    s.spec[p].shell.front_share = 0.3;
    s.spec[p].shell.law = s.spec[p].law = law;
    if (solid) s.spec[p].shell.law = (struct um_thermal_bulk_law){NULL, NULL, 0.0};
    help_build(&s, NULL, 0);
    const struct um_thermal_network *network = s.body->network;
    double total = 0.0, of_nodes = 0.0, through = 0.0;
    assert_int_equal(network->ncapacity_law, 1);
    for (size_t k = 0; k < network->nstore; k++) total += network->store[k].capacity;
    for (size_t i = 0; i < network->nnode; i++) of_nodes += network->node[i].capacity;
    NEAR("capacity", of_nodes / (solid ? 2700.0 * 900.0 : 4860.0), 1.0, 1e-12);
    NEAR("of a law", total / of_nodes, 1.0, 1e-12);
    /* the table's rows are 2 K apart: 200 and 400 K are two of them */
    for (size_t k = 100; k <= 200; k += 100) {
      double d = (double)k * UM_THERMAL_LAW_STEP - 300.0;
      NEAR("ratio", network->capacity_law[0]->at[k], (1.0 + 1.3e-3 * d) * (1.0 + 5e-4 * d), 1e-12);
    }
    for (size_t k = 0; k < network->nconductor; k++)
      if (network->conductor[k].law == UM_THERMAL_NO_LAW)
        through += network->conductor[k].value;
      else
        NEAR("conduction", network->link_law[network->conductor[k].law].table->at[200],
             1.0 - 4e-4 * 100.0, 1e-12);
    NEAR("through the wall", through, solid ? 0.0 : 30.0, 1e-12 * 30.0);
    help_end(&s);
  }
}

/* e* printed: docs/physics/mli.md; Lockheed as in temperature_law.c; seams beside either, shell and
 * lump. Of a cube of 1 m2 faces with skins at 250 K and walls at 290 K. */
static void blankets_are_followed(void **state)
{
  (void)state;
  const double hot = 290.0, cold = 250.0, mean = 270.0, seam = 0.07;
  const double fourth = UM_STEFAN_BOLTZMANN * (pow(hot, 4) - pow(cold, 4));
  const double doenecke =
      (0.000136 / (4.0 * UM_STEFAN_BOLTZMANN * mean * mean) + 0.000121 * pow(mean, 0.667)) * fourth;
  const double lockheed = 8.95e-8 * pow(15.0, 2.56) * mean / 21.0 * (hot - cold) +
                          5.39e-10 * 0.031 / 20.0 * (pow(hot, 4.67) - pow(cold, 4.67));
  const double expected[3] = {0.02 * fourth, doenecke, lockheed};
  const struct um_thermal_mli_slope slope[3] = {
      {0.02, 0.0}, um_thermal_mli_doenecke(1.0), um_thermal_mli_lockheed(20.0, 1500.0, 0.031)};
  for (int which = 0; which < 3; which++)
    for (int lumped = 0; lumped < 2; lumped++)
      for (int n = -1; n <= 1; n++) {
        const struct um_thermal_mli mli = {.effective_emittance = slope[which].effective_emittance,
                                           .conducted = slope[which].conducted,
                                           .law = (enum um_thermal_mli_law)which,
                                           .areal_heat_capacity = 60.0,
                                           .exponent = n,
                                           .seam_conductance = seam};
        struct help_satellite s = {0};
        size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
        s.spec[p].kind = lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
        s.group[p].mli = &mli;
        help_build(&s, NULL, 0);
        const struct um_thermal_network *network = s.body->network;
        double *t = calloc(network->nnode, sizeof *t), leak = 0.0;
        struct um_thermal_heat *flow = calloc(network->nnode, sizeof *flow);
        assert_true(t != NULL && flow != NULL);
        for (size_t i = 0; i < network->nnode; i++) t[i] = hot;
        const struct um_thermal_place *skin = help_place(&s, "bus");
        for (size_t i = 0; i < skin->nnode; i++) t[skin->node[i]] = cold;
        struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
        OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, 0.0, t, flow));
        for (size_t i = 0; i < skin->nnode; i++)
          leak += flow[skin->node[i]].conducted + flow[skin->node[i]].exchanged;
        double by_law = expected[which] * pow(mean / 300.0, n);
        NEAR("leak", leak / (6.0 * (by_law + seam * (hot - cold))), 1.0, 1e-12);
        free(t);
        free(flow);
        help_end(&s);
      }
}

/* Pipes of 12 W/K in a plate of two layers without any other way, sides at 320 and 280 K: half of
 * it on each, the vapour is at 300 K and carries 6 x 20 W. The same for finite elements, whose
 * corners share it by area, and for lumps. */
static void pipes_carry(void **state)
{
  (void)state;
  for (int lumped = 0; lumped < 2; lumped++) {
    struct help_satellite s = {0};
    size_t p = help_part(&s, "panel", UM_SHAPE_PLATE, "paint");
    s.shape[p].facet_size = 0.3;
    s.spec[p].kind = lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
    s.spec[p].shell.through_conductance = 0.0;
    s.spec[p].shell.conductance = 0.0;
    s.group[p].emittance_front = s.group[p].emittance_back = 0.0;
    s.group[p].heat_pipe_conductance = 12.0;
    s.group[p].heat_pipe_capacity = 50.0;
    help_build(&s, NULL, 0);
    help_hold(&s, "panel.front", 320.0);
    help_hold(&s, "panel.back", 280.0);
    const struct um_thermal_network *network = s.body->network;
    char name[64];
    snprintf(name, sizeof name, "panel.%s.heat_pipe", um_geometry_group(s.geometry, 0)->name);
    size_t vapour = um_thermal_network_find(network, name);
    assert_true(vapour != (size_t)-1);
    double *t = help_steady(&s, NULL, 0.0), carried = 0.0, total = 0.0;
    for (size_t k = 0; k < network->nconductor; k++) {
      const struct um_thermal_link *link = &network->conductor[k];
      if (link->a != vapour && link->b != vapour) continue;
      double of_wall = t[link->a == vapour ? link->b : link->a];
      total += link->value;
      carried += link->value * fmax(0.0, of_wall - t[vapour]);
    }
    NEAR("conductance", total, 12.0, 1e-12 * 12.0);
    NEAR("vapour", t[vapour], 300.0, 1e-9);
    NEAR("carried", carried, 120.0, 1e-8);
    free(t);
    help_end(&s);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(materials_are_followed),
                                     cmocka_unit_test(blankets_are_followed),
                                     cmocka_unit_test(pipes_carry)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
