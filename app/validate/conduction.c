/* Conduction against exact solutions of the heat equation: chains of nodes, tetrahedra.
 *
 *   x=0                         x=L      cells of h = L/N; end nodes hold half a cell;
 *    o---o---o---o---o---o---o---o       conductors k A / h, capacities rho c A h
 *
 * Second order in h: where the answer is not linear in x, two meshes are extrapolated to h = 0.
 * Sources: Carslaw & Jaeger 1959; NAFEMS T2 and T3 (Cameron, Casey & Simpson 1986). */
#include <math.h>

#include "app/validate/cases_impl.h"
#include "app/validate/thermal_case_impl.h"
#include "base/core/constants.h"
#include "thermal/network/body.h"

#define SERIES "Carslaw & Jaeger 1959"
#define STIFF  1e9 /* conductance [W/K] that holds a node at a temperature to 1e-7 */

/* Tie a node to a temperature [K]. */
static enum um_status hold(struct um_thermal_network *network, uint32_t node, double temperature,
                           double conductance)
{
  uint32_t wall;
  UM_TRY(
      um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, temperature, 0.0, &wall));
  return um_thermal_network_conductor_add(network, node, wall, conductance);
}

/* Chain of n + 1 nodes 0..n over `length` [m] and 1 m^2; network is made. */
static enum um_status chain(struct um_context *context, size_t n, double length,
                            double conductivity, double volume_capacity, double temperature,
                            struct um_thermal_network **out)
{
  double h = length / (double)n;
  UM_TRY(um_thermal_network_create(context, out));
  for (size_t k = 0; k <= n; k++) {
    double share = k == 0 || k == n ? 0.5 : 1.0;
    uint32_t node;
    UM_TRY(um_thermal_network_node_add(*out, NULL, UM_NODE_DIFFUSIVE, volume_capacity * h * share,
                                       temperature, 0.0, &node));
    if (k > 0) UM_TRY(um_thermal_network_conductor_add(*out, node - 1, node, conductivity / h));
  }
  return UM_OK;
}

/* 0.1 m, 1000 K at A, radiates to 300 K at B, eps 0.98. The field is linear: any mesh is exact, to
 * the three printed decimals. 927.0 is published. */
static enum um_status nafems_t2_chain(struct um_context *context, double conductivity,
                                      double *temperature)
{
  struct um_thermal_network *network = NULL;
  struct um_thermal_solve_options options = um_validate_tight(300.0);
  double field[16];
  enum um_status status;
  UM_CHECK(chain(context, 10, 0.1, conductivity, 7850.0 * 460.0, 1000.0, &network));
  UM_CHECK(hold(network, 0, 1000.0, STIFF));
  UM_CHECK(um_thermal_network_radiator_add(network, 10, UM_THERMAL_SPACE, 0.98));
  UM_CHECK(um_thermal_solve_steady(context, network, NULL, 0, &options, NULL, field));
  *temperature = field[10];
done:
  um_thermal_network_destroy(&network);
  return status;
}

#ifdef UMBRA_TETGEN
struct bar {
  struct um_geometry *geometry;
  struct um_thermal_body *body;
  double *temperature; /* [nnode] */
};

static void bar_destroy(struct um_context *context, struct bar *bar)
{
  um_core_free(context, bar->temperature);
  um_thermal_body_destroy(context, &bar->body);
  um_geometry_destroy(&bar->geometry);
}

/* Tie all of a place to a temperature [K]. */
static enum um_status bar_hold(struct bar *bar, const char *name, double temperature)
{
  size_t at = um_thermal_body_place_find(bar->body, name);
  const struct um_thermal_place *place = &bar->body->place[at];
  for (size_t i = 0; i < place->nnode; i++)
    UM_TRY(hold(bar->body->network, place->node[i], temperature, STIFF));
  return UM_OK;
}

/* Mean over a place [K]. */
static double bar_mean(const struct bar *bar, const char *name)
{
  const struct um_thermal_place *place =
      &bar->body->place[um_thermal_body_place_find(bar->body, name)];
  double mean = 0.0;
  for (size_t i = 0; i < place->nnode; i++)
    mean += place->weight[i] * bar->temperature[place->node[i]];
  return mean;
}

/* The same on tetrahedra: a bar of 0.1 x 0.02 x 0.02 m, insulated but for its end +x. */
static enum um_status nafems_t2_solid(struct um_context *context, double conductivity,
                                      double *temperature)
{
  const struct um_geometry_skin skin = {NULL, "steel", NULL};
  const struct um_geometry_part_spec shape = {.name = "bar",
                                              .shape = UM_SHAPE_BOX,
                                              .size = {0.1, 0.02, 0.02},
                                              .rotation = {1.0, 0.0, 0.0, 0.0},
                                              .skins = &skin,
                                              .nskin = 1,
                                              .facet_size = 0.01,
                                              .solid = true};
  struct um_thermal_group_spec group[6] = {{0}}; /* +x -x +y -y +z -z */
  const struct um_thermal_part_spec part = {.kind = UM_THERMAL_SOLID,
                                            .density = 7850.0,
                                            .specific_heat = 460.0,
                                            .conductivity = conductivity,
                                            .start_temperature = 1000.0,
                                            .groups = group,
                                            .ngroup = 6};
  struct um_thermal_solve_options options = um_validate_tight(300.0);
  struct bar bar = {0};
  enum um_status status;
  for (uint32_t g = 0; g < 6; g++) group[g].group = g;
  group[0].emittance_front = 0.98;
  UM_CHECK(um_geometry_create(context, &shape, 1, &bar.geometry));
  UM_CHECK(um_thermal_body_create(context, bar.geometry, &part, 1, NULL, 0, &bar.body));
  UM_CHECK(bar_hold(&bar, "bar.-x", 1000.0));
  UM_CHECK(um_core_allocate(context, um_thermal_network_nodes(bar.body->network),
                            sizeof *bar.temperature, &bar.temperature));
  UM_CHECK(um_thermal_solve_steady(context, bar.body->network, NULL, 0, &options, NULL,
                                   bar.temperature));
  *temperature = bar_mean(&bar, "bar.+x");
done:
  bar_destroy(context, &bar);
  return status;
}
#endif

/* Sigma of CODATA; with 5.67e-8 the program of the reference gives 927.008 and 926.971 K. */
static enum um_status nafems_t2(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    double conductivity, expected; /* [W/m/K], [K] */
    const char *chain, *solid;
  } row[] = {{55.6, 927.004, "NAFEMS T2, k 55.6, chain", "NAFEMS T2, k 55.6, tetrahedra"},
             {55.563, 926.967, "NAFEMS T2, k 55.563, chain", "NAFEMS T2, k 55.563, tetrahedra"}};
  for (int i = 0; i < 2; i++) {
    double t = NAN;
    UM_TRY(nafems_t2_chain(context, row[i].conductivity, &t));
    um_validate_report_add(report, row[i].chain, "K", row[i].expected, t, 5e-4, "NAFEMS T2");
#ifdef UMBRA_TETGEN
    UM_TRY(nafems_t2_solid(context, row[i].conductivity, &t));
    um_validate_report_add(report, row[i].solid, "K", row[i].expected, t, 5e-4, "NAFEMS T2");
#endif
  }
  return UM_OK;
}

/* T(0) = 0, T(0.1 m) = 100 sin(pi t / 40) degC; T(0.08 m, 32 s). The driven end is tied by STIFF
 * to 0 degC and heated by STIFF T(t), so that it follows; rows of 0.02 s miss the sine by 3e-5 K.
 */
static enum um_status nafems_t3_chain(struct um_context *context, size_t n, double *temperature)
{
  const double origin = 1000.0; /* [K]; nothing radiates */
  const size_t ntime = 1601;
  struct um_thermal_network *network = NULL;
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_history *history = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  const double at = 32.0;
  enum um_status status;
  options.relative_tolerance = 1e-9;
  options.absolute_tolerance = 1e-7;
  UM_CHECK(chain(context, n, 0.1, 35.0, 7200.0 * 440.5, origin, &network));
  UM_CHECK(hold(network, 0, origin, STIFF));
  UM_CHECK(hold(network, (uint32_t)n, origin, STIFF));
  UM_CHECK(um_validate_surface(network, 0, (uint32_t)n, 1.0, 1.0, 0.0));
  UM_CHECK(um_irradiation_loads_create(context, ntime, 1, 0, &loads));
  for (size_t k = 0; k < ntime; k++) {
    loads->t[k] = 0.02 * (double)k;
    loads->irradiance[k] = STIFF * 100.0 * sin(UM_PI * loads->t[k] / 40.0);
    loads->sunlit[k] = 1.0;
    loads->sun[k] = 1.0F;
  }
  UM_CHECK(um_thermal_solve(context, network, loads, &options, NULL, 0.0, &at, 1, &history));
  *temperature = history->temperature[n * 8 / 10] - origin;
done:
  um_thermal_history_destroy(context, &history);
  um_irradiation_loads_destroy(context, &loads);
  um_thermal_network_destroy(&network);
  return status;
}

/* Exact series: 36.6031 degC. Tolerance: the driven end lags by k dT/dx / STIFF = 7e-5 K, and the
 * extrapolated remainder of fourth order, which the change from 20-40 to 40-80 cells shows to be
 * below 3e-3 K. */
static enum um_status nafems_t3(struct um_context *context, struct um_validate_report *report)
{
  double coarse, fine;
  UM_TRY(nafems_t3_chain(context, 40, &coarse));
  UM_TRY(nafems_t3_chain(context, 80, &fine));
  um_validate_report_add(report, "NAFEMS T3, 0.08 m at 32 s", "degC", 36.6031,
                         fine + (fine - coarse) / 3.0, 3e-3, "NAFEMS T3");
  return UM_OK;
}

static const double fourier[4] = {0.1, 0.2, 0.5, 1.0};

/* Slab of 1 m, k = rho c = 1: out[0] front, out[1] back, out[2] mean, at the Fourier numbers.
 * step: x = 0 falls from 300 to 200 K, theta = (T - Ts)/(T0 - Ts); else 100 W/m^2 enter there,
 * (T - T0) k / (q L). */
static enum um_status slab(struct um_context *context, bool step, size_t n, double out[3][4])
{
  struct um_thermal_network *network = NULL;
  struct um_thermal_history *history = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  const double origin = step ? 200.0 : 300.0;
  enum um_status status;
  options.absolute_tolerance = 1e-8;
  UM_CHECK(chain(context, n, 1.0, 1.0, 1.0, 300.0, &network));
  if (step)
    UM_CHECK(hold(network, 0, origin, STIFF));
  else
    um_thermal_network_power_set(network, 0, 100.0);
  UM_CHECK(um_thermal_solve(context, network, NULL, &options, NULL, 0.0, fourier, 4, &history));
  for (size_t f = 0; f < 4; f++) {
    const double *t = history->temperature + f * history->nnode;
    double mean = 0.0;
    for (size_t k = 0; k < n; k++) mean += 0.5 * (t[k] + t[k + 1]) / (double)n;
    const double place[3] = {t[0], t[n], mean};
    for (int i = 0; i < 3; i++) out[i][f] = (place[i] - origin) / 100.0;
  }
done:
  um_thermal_history_destroy(context, &history);
  um_thermal_network_destroy(&network);
  return status;
}

/* 2e-6: half of the last printed digit and the fourth-order rest of the extrapolation. */
static enum um_status slabs(struct um_context *context, struct um_validate_report *report)
{
#define FOUR(what) what ", Fo 0.1", what ", Fo 0.2", what ", Fo 0.5", what ", Fo 1"
  static const struct {
    int step, place;
    double expected[4];
    const char *name[4];
  } row[] = {{1, 1, {0.949305, 0.772312, 0.370777, 0.107977}, {FOUR("Slab step, back")}},
             {1, 2, {0.643177, 0.495912, 0.236050, 0.068740}, {FOUR("Slab step, mean")}},
             {0, 0, {0.356826, 0.505165, 0.831876, 1.333323}, {FOUR("Slab flux, front")}},
             {0, 1, {0.007885, 0.061464, 0.334791, 0.833344}, {FOUR("Slab flux, back")}}};
#undef FOUR
  double coarse[2][3][4], fine[2][3][4];
  for (int step = 0; step < 2; step++) {
    UM_TRY(slab(context, step == 1, 40, coarse[step]));
    UM_TRY(slab(context, step == 1, 80, fine[step]));
  }
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    for (int f = 0; f < 4; f++) {
      double a = coarse[row[i].step][row[i].place][f], b = fine[row[i].step][row[i].place][f];
      um_validate_report_add(report, row[i].name[f], "1", row[i].expected[f], b + (b - a) / 3.0,
                             2e-6, SERIES);
    }
  return UM_OK;
}

/* 0.2 m are 10 diffusion lengths: erfc(10) is nothing. */
static enum um_status semi_infinite(struct um_context *context, size_t n, double out[2])
{
  struct um_thermal_network *network = NULL;
  struct um_thermal_history *history = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  const double at = 100.0;
  enum um_status status;
  UM_CHECK(chain(context, n, 0.2, 1.0, 1e6, 300.0, &network));
  um_thermal_network_power_set(network, 0, 1000.0);
  UM_CHECK(um_thermal_solve(context, network, NULL, &options, NULL, 0.0, &at, 1, &history));
  out[0] = history->temperature[0] - 300.0;
  out[1] = history->temperature[n / 20] - 300.0;
done:
  um_thermal_history_destroy(context, &history);
  um_thermal_network_destroy(&network);
  return status;
}

/* Plate fin of 0.1 m, 1 mm, k 167, eps 0.85 on both sides, root 400 K, sink 0 K: out tip [K] and
 * heat into the root [W/m]. */
static enum um_status fin(struct um_context *context, size_t n, double out[2])
{
  struct um_thermal_network *network = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  double temperature[512], h = 0.1 / (double)n;
  enum um_status status;
  UM_CHECK(chain(context, n, 0.1, 167.0 * 1e-3, 2430.0, 400.0, &network));
  UM_CHECK(hold(network, 0, 400.0, STIFF));
  for (uint32_t k = 0; k <= n; k++)
    UM_CHECK(um_thermal_network_radiator_add(network, k, UM_THERMAL_SPACE,
                                             1.7 * h * (k == 0 || k == n ? 0.5 : 1.0)));
  UM_CHECK(um_thermal_solve_steady(context, network, NULL, 0, &options, NULL, temperature));
  out[0] = temperature[n];
  out[1] = 167.0 * 1e-3 / h * (temperature[0] - temperature[1]) +
           UM_STEFAN_BOLTZMANN * 0.5 * 1.7 * h * pow(temperature[0], 4.0);
done:
  um_thermal_network_destroy(&network);
  return status;
}

enum um_status um_validate_conduction(struct um_context *context, struct um_validate_report *report)
{
  double coarse[2], fine[2];
  UM_TRY(nafems_t2(context, report));
  UM_TRY(nafems_t3(context, report));
  UM_TRY(slabs(context, report));
  /* printed to 1e-5 K; the extrapolation leaves as much again */
  UM_TRY(semi_infinite(context, 400, coarse));
  UM_TRY(semi_infinite(context, 800, fine));
  um_validate_report_add(report, "Half-space under 1000 W/m^2, 100 s, front", "K", 11.28379,
                         fine[0] + (fine[0] - coarse[0]) / 3.0, 2e-5, SERIES);
  um_validate_report_add(report, "Half-space under 1000 W/m^2, 100 s, 0.01 m", "K", 3.99282,
                         fine[1] + (fine[1] - coarse[1]) / 3.0, 2e-5, SERIES);
  UM_TRY(fin(context, 200, coarse));
  UM_TRY(fin(context, 400, fine));
  double tip = fine[0] + (fine[0] - coarse[0]) / 3.0, heat = fine[1] + (fine[1] - coarse[1]) / 3.0;
  um_validate_report_add(report, "Radiating fin, tip", "K", 351.69619, tip, 1e-5, "shooting");
  um_validate_report_add(report, "Radiating fin, heat into the root", "W/m", 176.89097, heat, 1e-5,
                         "shooting");
  um_validate_report_add(report, "Radiating fin, efficiency", "1", 0.716812,
                         heat / (0.17 * UM_STEFAN_BOLTZMANN * pow(400.0, 4.0)), 1e-6, "shooting");
  return UM_OK;
}
