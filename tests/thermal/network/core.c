/* Walls with nodes in their thickness: a slab heated on one side, and what holds its nodes.
 *
 *   q --> front |--| 1 |--| 2 |-- ... --| back |    nothing radiates
 */
#include "tests/thermal/body_help.h"

#define THICK    0.02                            /* [m] */
#define K        0.5                             /* [W/m/K] */
#define RHO_C    1.5e6                           /* [J/m^3/K] */
#define FLUX     400.0                           /* [W/m^2] */
#define MOST     40                              /* cells */
#define AFTER(x) ((x)*THICK * THICK * RHO_C / K) /* time of alpha t / L^2 = x [s] */

/* Of `cells` of one kind: a node between has twice what the faces have. */
static struct um_thermal_core slab(size_t cells, double *capacity, double *resistance)
{
  for (size_t k = 0; k < cells; k++) capacity[k] = resistance[k] = 1.0 / (double)cells;
  return (struct um_thermal_core){cells - 1, capacity, resistance};
}

static void plate(struct help_satellite *s, bool lumped, const struct um_thermal_core *core)
{
  *s = (struct help_satellite){0};
  size_t p = help_part(s, "panel", UM_SHAPE_PLATE, "paint");
  s->shape[p].facet_size = 0.6;
  s->spec[p].kind = lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
  s->spec[p].shell.areal_heat_capacity = RHO_C * THICK;
  s->spec[p].shell.through_conductance = K / THICK;
  s->spec[p].shell.front_share = 0.5 / (double)(core->n + 1);
  s->spec[p].shell.core = core;
  s->group[p].emittance_front = s->group[p].emittance_back = 0.0;
}

/* A slab without losses that takes q on its front (Carslaw and Jaeger 1959, 3.8), x = alpha t/L^2:
 *
 *   T(front) = T_0 + (q L/k) (x + 1/3 - 2/pi^2 sum_n  n^-2 exp(-n^2 pi^2 x)),
 *   T(back)  = T_0 + (q L/k) (x - 1/6 - 2/pi^2 sum_n (-1)^n n^-2 exp(-n^2 pi^2 x)). */
static void heated_slab(double x, double out[2])
{
  out[0] = x + 1.0 / 3.0;
  out[1] = x - 1.0 / 6.0;
  for (int n = 1; n < 200; n++) {
    double term = 2.0 / (UM_PI * UM_PI * n * n) * exp(-(double)n * n * UM_PI * UM_PI * x);
    out[0] -= term;
    out[1] -= n % 2 == 0 ? term : -term;
  }
  for (int k = 0; k < 2; k++) out[k] *= FLUX * THICK / K;
}

/* Largest error of both faces at four times [K]. */
static double error_of(size_t cells, bool lumped)
{
  static const double x[4] = {0.02, 0.1, 0.3, 1.0};
  double capacity[MOST], resistance[MOST], t[4], worst = 0.0;
  const struct um_thermal_core core = slab(cells, capacity, resistance);
  struct help_satellite s;
  plate(&s, lumped, &core);
  help_build(&s, NULL, 0);
  const struct um_thermal_place *front = help_place(&s, "panel.front");
  for (size_t j = 0; j < front->nnode; j++)
    um_thermal_network_power_set(s.body->network, front->node[j], front->weight[j] * FLUX);
  for (int i = 0; i < 4; i++) t[i] = AFTER(x[i]);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
  struct um_thermal_history *h = NULL;
  OK(um_thermal_solve(help_context, s.body->network, NULL, &options, NULL, 0.0, t, 4, &h));
  for (int i = 0; i < 4; i++) {
    double exact[2];
    heated_slab(x[i], exact);
    worst = fmax(worst, fabs(help_mean(&s, "panel.front", h->temperature + (size_t)i * h->nnode) -
                             300.0 - exact[0]));
    worst = fmax(worst, fabs(help_mean(&s, "panel.back", h->temperature + (size_t)i * h->nnode) -
                             300.0 - exact[1]));
  }
  if (!(h->audit_error <= 1e-6)) fail_msg("audit %g", h->audit_error);
  um_thermal_history_destroy(help_context, &h);
  help_end(&s);
  return worst;
}

/* The error goes down with the square of the cells, alike in finite elements and lumps. Of the 16 K
 * that q L/k is 40 cells leave 5.0 mK. */
static void slab_is_met_to_second_order(void **state)
{
  (void)state;
  for (int lumped = 0; lumped < 2; lumped++) {
    double coarse = error_of(10, lumped), fine = error_of(20, lumped),
           finest = error_of(40, lumped);
    print_message("cells 10, 20, 40: %.4f, %.4f, %.4f K, order %.2f\n", coarse, fine, finest,
                  log2(fine / finest));
    assert_true(finest < 6e-3);
    if (!(log2(coarse / fine) > 1.8 && log2(fine / finest) > 1.9)) fail_msg("order");
  }
}

/* Held at 310 and 290 K, with half of the resistance in the first of four gaps: the nodes stand at
 * 300, 297 and 293.  0.3 of capacity each in three nodes, 0.05 on each face. */
static void resistances_are_shares(void **state)
{
  (void)state;
  double capacity[3] = {0.3, 0.3, 0.3}, resistance[4] = {0.5, 0.15, 0.2, 0.15};
  const struct um_thermal_core core = {3, capacity, resistance};
  for (int lumped = 0; lumped < 2; lumped++) {
    struct help_satellite s;
    plate(&s, lumped, &core);
    s.spec[0].shell.front_share = 0.05;
    help_build(&s, NULL, 0);
    help_hold(&s, "panel.front", 310.0);
    help_hold(&s, "panel.back", 290.0);
    double *t = help_steady(&s, NULL, 0.0), all = 0.0, mean = help_mean(&s, "panel.core", t);
    NEAR("mean of the core", mean, (300.0 + 297.0 + 293.0) / 3.0, 1e-8);
    const struct um_thermal_place *place = help_place(&s, "panel.core");
    NEAR("outermost", t[place->node[0]], 300.0, 1e-8);
    for (size_t i = 0; i < um_thermal_network_nodes(s.body->network); i++)
      all += um_thermal_network_capacity(s.body->network, (uint32_t)i);
    NEAR("capacity", all, RHO_C * THICK, 1e-9 * all);
    NEAR("area", place->area, 1.0, 1e-12);
    free(t);
    help_end(&s);
  }
}

/* A wall of one layer has no two ends. */
static void one_layer_is_refused(void **state)
{
  (void)state;
  double capacity[3], resistance[3];
  const struct um_thermal_core core = slab(3, capacity, resistance);
  for (int lumped = 0; lumped < 2; lumped++) {
    struct help_satellite s = {0};
    size_t p = help_part(&s, "bus", UM_SHAPE_BOX, NULL);
    s.spec[p].kind = lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
    s.spec[p].shell.core = &core;
    s.spec[p].shell.front_share = 1.0 / 6.0;
    help_geometry(&s);
    assert_int_equal(
        um_thermal_body_create(help_context, s.geometry, s.spec, s.npart, NULL, 0, &s.body),
        UM_ERR_INPUT);
    if (strstr(um_core_message(help_context), "whose back meets nothing") == NULL)
      fail_msg("'%s'", um_core_message(help_context));
    um_core_message_clear(help_context);
    help_end(&s);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(slab_is_met_to_second_order),
      cmocka_unit_test(resistances_are_shares),
      cmocka_unit_test(one_layer_is_refused),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
