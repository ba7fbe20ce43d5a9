/* Sensitivities of surfaces that radiate to each other, against central differences of tight runs
 * (tolerances of 1e-10, steps of 1e-2 of the parameter: 1e-4 of curvature): a box whose walls heat
 * each other inside, with inner layers that have mass and such that have none. Asked: 1e-3 of the
 * largest answer of a parameter, as in sensitivity.c. */
#include "thermal/tangent/sensitivity.h"

#include <math.h>

#include "geometry/inside.h"
#include "tests/thermal/body_help.h"
#include "thermal/exchange/exchange.h"

#define PARAMETERS 7
#define ASKED      1e-3

static const char *const name[PARAMETERS] = {
    "heat capacity", "power", "conductance through", "emittance outside", "emittance inside",
    "contact",       "start"};

/* The box with parameter `which` times `factor`, and the exchange that it makes. */
struct box {
  struct help_satellite s;
  struct um_thermal_exchange *exchange;
  struct um_thermal_solve_options options;
};

static void box_open(struct box *x, int which, double factor, bool massless,
                     struct um_geometry_view_factor_table **table)
{
  static const double inside[6] = {0.8, 0.6, 0.3, 0.3, 0.05, 0.9};
  const struct um_thermal_exchange_options infrared = {.infrared = true};
  *x = (struct box){0};
  double by[PARAMETERS];
  for (int k = 0; k < PARAMETERS; k++) by[k] = k == which ? factor : 1.0;
  size_t p = help_part(&x->s, "bus", UM_SHAPE_BOX, NULL);
  x->s.spec[p].kind = UM_THERMAL_LUMPED;
  x->s.spec[p].inside = true;
  x->s.spec[p].shell = (struct um_thermal_shell){.areal_heat_capacity = 2000.0 * by[0],
                                                 .front_share = massless ? 1.0 : 0.4,
                                                 .through_conductance = 8.0 * by[2]};
  x->s.spec[p].start_temperature = 300.0 * by[6];
  x->s.group[p].emittance_front = 0.5 * by[3];
  help_geometry(&x->s);
  for (int g = 0; g < 6; g++) x->s.all[g].inside_emittance = inside[g] * by[4];
  x->s.all[0].power = 150.0 * by[1];
  const struct um_thermal_contact contact = {
      .a = "bus.+z", .b = "bus.-x", .conductance = 2.0 * by[5]};
  help_build(&x->s, &contact, 1);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(x->s.geometry);
  if (*table == NULL) {
    struct um_geometry_view_factor_options factors;
    um_geometry_view_factor_defaults(&factors);
    OK(um_geometry_view_factor_table_create(help_context, x->s.geometry, NULL, 1, 64, &factors,
                                            table));
    OK(um_geometry_inside_add(help_context, x->s.geometry, 0, 0, &factors, *table));
  }
  for (size_t f = 0; f < mesh->nfacet; f++)
    OK(um_thermal_network_surface_block(x->s.body->network, um_geometry_inner_surface(mesh, f), 0));
  OK(um_thermal_exchange_create(help_context, x->s.body->network, NULL, *table, &infrared,
                                &x->exchange));
  um_thermal_solve_defaults(&x->options);
  x->options.exchange = x->exchange;
}

static void box_close(struct box *x)
{
  um_thermal_exchange_destroy(help_context, &x->exchange);
  help_end(&x->s);
}

#define NODES 12
#define TIMES 3

struct kept {
  double s[TIMES][PARAMETERS][NODES];
};
static enum um_status keep(void *user, size_t k, const double *temperature, const double *s)
{
  struct kept *kept = user;
  (void)temperature;
  memcpy(kept->s[k], s, sizeof kept->s[k]);
  return UM_OK;
}

static void box_of(bool massless)
{
  static const double times[TIMES] = {200.0, 1500.0, 9000.0};
  static struct kept kept;
  struct um_geometry_view_factor_table *table = NULL;
  struct box base, moved[PARAMETERS];
  struct um_thermal_variant variant[PARAMETERS];
  box_open(&base, -1, 1.0, massless, &table);
  assert_int_equal(um_thermal_network_nodes(base.s.body->network), NODES);
  for (int k = 0; k < PARAMETERS; k++) {
    box_open(&moved[k], k, 1.00001, massless, &table);
    variant[k] =
        (struct um_thermal_variant){moved[k].s.body->network, NULL, &moved[k].options, 1e-5, NULL};
  }
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = PARAMETERS};
  OK(um_thermal_sensitivity(help_context, base.s.body->network, NULL, &base.options, NULL, 0.0,
                            times, TIMES, &forcings, NULL, keep, &kept));
  for (int k = 0; k < PARAMETERS; k++) {
    struct um_thermal_history *h[2];
    double largest = 0.0, worst = 0.0;
    box_close(&moved[k]);
    for (int side = 0; side < 2; side++) {
      struct box x;
      box_open(&x, k, side ? 0.99 : 1.01, massless, &table);
      x.options.relative_tolerance = 1e-10;
      x.options.absolute_tolerance = 1e-8;
      OK(um_thermal_solve(help_context, x.s.body->network, NULL, &x.options, NULL, 0.0, times,
                          TIMES, &h[side]));
      box_close(&x);
    }
    for (int t = 0; t < TIMES; t++)
      for (int i = 0; i < NODES; i++) {
        size_t at = (size_t)t * NODES + (size_t)i;
        double slope = (h[0]->temperature[at] - h[1]->temperature[at]) / 0.02;
        largest = fmax(largest, fabs(slope));
        worst = fmax(worst, fabs(kept.s[t][k][i] - slope));
      }
    print_message("%-20s at most %8.3f K, off by %.1e of it\n", name[k], largest, worst / largest);
    assert_true(largest > 0.1);
    NEAR(name[k], worst / largest, 0.0, ASKED);
    um_thermal_history_destroy(help_context, &h[0]);
    um_thermal_history_destroy(help_context, &h[1]);
  }
  box_close(&base);
  um_geometry_view_factor_table_destroy(help_context, &table);
}

static void with_mass(void **state)
{
  (void)state;
  box_of(false);
}
static void without_mass(void **state)
{
  (void)state;
  box_of(true);
}

/* A power that swings with the orbit; the periodic state's answers. */
static void periodic(void **state)
{
  (void)state;
  enum { ROWS = 61 };
  const double period = 3000.0;
  struct um_geometry_view_factor_table *table = NULL;
  struct box base, moved[PARAMETERS - 1];
  struct um_thermal_variant variant[PARAMETERS - 1];
  double start[NODES], answer[2][NODES], drift, s[PARAMETERS - 1][NODES];
  struct um_irradiation_loads *loads = NULL;
  box_open(&base, -1, 1.0, false, &table);
  size_t nsurface = um_geometry_mesh(base.s.geometry)->nsurface;
  OK(um_irradiation_loads_create(help_context, ROWS, nsurface, 0, &loads));
  for (size_t k = 0; k < ROWS; k++) {
    loads->t[k] = period * (double)k / (ROWS - 1);
    loads->sunlit[k] = 1.0;
    loads->irradiance[k] = 1361.0;
    for (size_t i = 0; i < nsurface / 6; i++)
      loads->sun[k * nsurface + i] = (float)(0.5 - 0.5 * cos(2.0 * UM_PI * loads->t[k] / period));
  }
  OK(um_thermal_solve_periodic(help_context, base.s.body->network, loads, &base.options, NULL, 0.0,
                               period, 1e-5, start, &drift));
  for (int k = 0; k < PARAMETERS - 1; k++) {
    box_open(&moved[k], k, 1.00001, false, &table);
    variant[k] =
        (struct um_thermal_variant){moved[k].s.body->network, loads, &moved[k].options, 1e-5, NULL};
  }
  OK(um_thermal_sensitivity_periodic(help_context, base.s.body->network, loads, &base.options,
                                     start, 0.0, period, variant, PARAMETERS - 1, NULL, s[0]));
  for (int k = 0; k < PARAMETERS - 1; k++) {
    double largest = 0.0, worst = 0.0;
    box_close(&moved[k]);
    for (int side = 0; side < 2; side++) {
      struct box x;
      box_open(&x, k, side ? 0.99 : 1.01, false, &table);
      x.options.relative_tolerance = 1e-9;
      x.options.absolute_tolerance = 1e-7;
      OK(um_thermal_solve_periodic(help_context, x.s.body->network, loads, &x.options, NULL, 0.0,
                                   period, 1e-5, answer[side], &drift));
      box_close(&x);
    }
    for (int i = 0; i < NODES; i++) {
      double slope = (answer[0][i] - answer[1][i]) / 0.02;
      largest = fmax(largest, fabs(slope));
      worst = fmax(worst, fabs(s[k][i] - slope));
    }
    print_message("%-20s at most %8.3f K, off by %.1e of it\n", name[k], largest, worst / largest);
    /* differences of states known to 1e-5 K are good to 1e-3 K */
    NEAR(name[k], worst, 0.0, ASKED * largest + 1e-3);
  }
  um_irradiation_loads_destroy(help_context, &loads);
  box_close(&base);
  um_geometry_view_factor_table_destroy(help_context, &table);
}

/* Other optics with the base's exchange would leave out what they exchange. */
static void refusals(void **state)
{
  (void)state;
  const double time = 100.0;
  static struct kept kept;
  struct um_geometry_view_factor_table *table = NULL;
  struct box base, moved;
  box_open(&base, -1, 1.0, false, &table);
  box_open(&moved, 4, 1.00001, false, &table);
  struct um_thermal_variant variant = {moved.s.body->network, NULL, NULL, 1e-5, NULL};
  const struct um_thermal_forcings forcings = {.variant = &variant, .nvariant = 1};
  assert_int_equal(um_thermal_sensitivity(help_context, base.s.body->network, NULL, &base.options,
                                          NULL, 0.0, &time, 1, &forcings, NULL, keep, &kept),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(help_context),
                      "heat sensitivity 0: the variant has other optics and the base's exchange "
                      "between surfaces; accepted: options with an exchange of its own");
  um_core_message_clear(help_context);
  moved.options.exchange = NULL;
  variant.options = &moved.options;
  assert_int_equal(um_thermal_sensitivity(help_context, base.s.body->network, NULL, &base.options,
                                          NULL, 0.0, &time, 1, &forcings, NULL, keep, &kept),
                   UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "in the base and not in the variant"));
  um_core_message_clear(help_context);
  box_close(&moved);
  box_close(&base);
  um_geometry_view_factor_table_destroy(help_context, &table);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(with_mass), cmocka_unit_test(without_mass),
                                     cmocka_unit_test(periodic), cmocka_unit_test(refusals)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
