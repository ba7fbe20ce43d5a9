/* Networks: shields, enclosures, linear transients, spinning skins. Expected values: closed forms
 * with sigma = 5.670374419e-8, printed digits. */
#include <math.h>

#include "app/validate/cases_impl.h"
#include "app/validate/thermal_case_impl.h"
#include "base/core/constants.h"

#define CLOSED "closed form"
#define STIFF  1e11 /* conductance [W/K] that holds a node at a temperature to 1e-8 */

/* Two surfaces at 400 and 300 K with `shields` massless sheets between; R between neighbours
 * [m^2]; net heat [W]. */
static enum um_status facing(struct um_context *context, int shields, double first, double between,
                             double last, double *heat)
{
  struct um_thermal_network *network = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  double temperature[16];
  struct um_thermal_heat flow[16];
  uint32_t wall, hot, cold, node;
  enum um_status status;
  UM_CHECK(um_thermal_network_create(context, &network));
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, 400.0, 0.0, &wall));
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, 1.0, 400.0, 0.0, &hot));
  UM_CHECK(um_thermal_network_conductor_add(network, wall, hot, STIFF));
  for (int k = 0; k < shields; k++) {
    UM_CHECK(
        um_thermal_network_node_add(network, NULL, UM_NODE_ARITHMETIC, 0.0, 350.0, 0.0, &node));
    UM_CHECK(um_thermal_network_radiator_add(network, node - 1, node, k == 0 ? first : between));
  }
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, 300.0, 0.0, &cold));
  UM_CHECK(um_thermal_network_radiator_add(network, cold - 1, cold, last));
  UM_CHECK(um_thermal_solve_steady(context, network, NULL, 0, &options, NULL, temperature));
  UM_CHECK(um_thermal_heat_of_nodes(context, network, NULL, &options, 0.0, temperature, flow));
  *heat = flow[cold].exchanged;
done:
  um_thermal_network_destroy(&network);
  return status;
}

/* R = A / (1/e1 + 1/e2 - 1); shields have e 0.05 on both sides. Printed digits. */
static enum um_status plates(struct um_context *context, struct um_validate_report *report)
{
  const double first = 1.0 / (1.0 / 0.8 + 19.0), last = 1.0 / (20.0 + 1.0 / 0.3 - 1.0);
  const double open = 1.0 / (1.0 / 0.8 + 1.0 / 0.3 - 1.0), between = 1.0 / 39.0;
  /* spheres of radius 0.5 and 1: R = A1 / (1/e1 + (A1/A2)(1/e2 - 1)) */
  const double spheres = UM_PI / (1.0 / 0.8 + 0.25 * (1.0 / 0.3 - 1.0));
  double q;
  UM_TRY(facing(context, 0, 0.0, 0.0, open, &q));
  um_validate_report_add(report, "Plates 400/300 K, no shield", "W/m^2", 276.92526, q, 1e-5,
                         CLOSED);
  UM_TRY(facing(context, 1, first, 0.0, last, &q));
  um_validate_report_add(report, "Plates 400/300 K, one shield", "W/m^2", 23.30291, q, 1e-5,
                         CLOSED);
  UM_TRY(facing(context, 10, first, between, last, &q));
  um_validate_report_add(report, "Plates 400/300 K, ten shields", "W/m^2", 2.521234, q, 1e-6,
                         CLOSED);
  UM_TRY(facing(context, 0, 0.0, 0.0, spheres, &q));
  um_validate_report_add(report, "Concentric spheres 400/300 K", "W", 1700.42790, q, 1e-5, CLOSED);
  return UM_OK;
}

/* Black-box cube with six emittances as Oppenheim's network: a massless node of radiosity J_i =
 * sigma T^4 before each face, R = eps A/(1 - eps) behind it, A F_ij between them. Net loss of the
 * faces by Gebhart's method and by radiosity alike; printed digits. */
static enum um_status enclosure(struct um_context *context, struct um_validate_report *report)
{
  static const char *const name[6] = {
      "Cube enclosure, loss of face 0", "Cube enclosure, loss of face 1",
      "Cube enclosure, loss of face 2", "Cube enclosure, loss of face 3",
      "Cube enclosure, loss of face 4", "Cube enclosure, loss of face 5"};
  static const double e[6] = {0.8, 0.8, 0.3, 0.3, 0.05, 0.9};
  static const double t[6] = {300.0, 320.0, 280.0, 310.0, 250.0, 400.0};
  static const double loss[6] = {-295.67961, -170.81837, -136.12687,
                                 -80.82225,  -28.13338,  711.58047};
  /* Howell C-11 for unit squares at distance 1 */
  const double opposite =
      2.0 / UM_PI * (0.5 * log(4.0 / 3.0) + 2.0 * sqrt(2.0) * atan(sqrt(0.5)) - 2.0 * atan(1.0));
  const double adjacent = 0.25 * (1.0 - opposite);
  struct um_thermal_network *network = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  double temperature[13];
  struct um_thermal_heat flow[13];
  uint32_t node;
  enum um_status status;
  UM_CHECK(um_thermal_network_create(context, &network));
  for (int i = 0; i < 6; i++)
    UM_CHECK(um_thermal_network_node_add(network, NULL,
                                         i == 0 ? UM_NODE_DIFFUSIVE : UM_NODE_BOUNDARY,
                                         i == 0 ? 1.0 : 0.0, t[i], 0.0, &node));
  for (uint32_t i = 0; i < 6; i++) {
    UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_ARITHMETIC, 0.0, t[i], 0.0, &node));
    UM_CHECK(um_thermal_network_radiator_add(network, i, node, e[i] / (1.0 - e[i])));
    for (uint32_t j = 0; j < i; j++)
      UM_CHECK(um_thermal_network_radiator_add(network, 6 + j, node,
                                               j + 1 == i && i % 2 == 1 ? opposite : adjacent));
  }
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, t[0], 0.0, &node));
  UM_CHECK(um_thermal_network_conductor_add(network, 0, node, STIFF)); /* one node stores heat */
  UM_CHECK(um_thermal_solve_steady(context, network, NULL, 0, &options, NULL, temperature));
  UM_CHECK(um_thermal_heat_of_nodes(context, network, NULL, &options, 0.0, temperature, flow));
  for (int i = 0; i < 6; i++)
    um_validate_report_add(report, name[i], "W", loss[i], -flow[i].exchanged, 1e-5,
                           "Gebhart; radiosity");
done:
  um_thermal_network_destroy(&network);
  return status;
}

/* SimpleTransient of ESATAN-TMS: five nodes, linear; exact by the matrix exponential, 1e-6 K. */
static enum um_status simple_transient(struct um_context *context,
                                       struct um_validate_report *report)
{
  static const char *const name[5] = {"SimpleTransient, node 0", "SimpleTransient, node 1",
                                      "SimpleTransient, node 2", "SimpleTransient, node 3",
                                      "SimpleTransient, node 4"};
  static const double capacity[5] = {1.0, 2.0, 3.0, 4.0, 1000.0};
  static const double start[5] = {20.0, 30.0, 40.0, 50.0, 0.0};
  static const double expected[5] = {11.493608, 10.893738, 15.826465, 8.313891, 0.335984};
  static const struct {
    uint32_t a, b;
    double conductance; /* [W/K] */
  } link[] = {{0, 1, 10.0}, {1, 2, 1.0}, {1, 3, 5.0}, {3, 4, 2.0}};
  const double ice = 273.15, at = 10.0;
  struct um_thermal_network *network = NULL;
  struct um_thermal_history *history = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  uint32_t node;
  enum um_status status;
  UM_CHECK(um_thermal_network_create(context, &network));
  for (int i = 0; i < 5; i++)
    UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, capacity[i],
                                         start[i] + ice, i == 0 ? 5.0 : 0.0, &node));
  for (int i = 0; i < 4; i++)
    UM_CHECK(um_thermal_network_conductor_add(network, link[i].a, link[i].b, link[i].conductance));
  UM_CHECK(um_thermal_solve(context, network, NULL, &options, NULL, 0.0, &at, 1, &history));
  for (int i = 0; i < 5; i++)
    um_validate_report_add(report, name[i], "degC", expected[i], history->temperature[i] - ice,
                           1e-6, "matrix exponential");
done:
  um_thermal_history_destroy(context, &history);
  um_thermal_network_destroy(&network);
  return status;
}

#define SPIN_PERIOD 215.0
enum { SPIN_ROWS = 2001, SPIN_TIMES = 720 };

/* A skin of time constant tau [s] (1 W/K to a wall) under 10 + 10 cos(2 pi t / P) W once periodic:
 * amplitude over the static 10 K, and lag [deg]. */
static enum um_status spin(struct um_context *context, double tau, double out[2])
{
  struct um_thermal_network *network = NULL;
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_history *history = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  double start[2], drift, times[SPIN_TIMES], re = 0.0, im = 0.0;
  uint32_t skin, wall;
  enum um_status status;
  UM_CHECK(um_thermal_network_create(context, &network));
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, tau, 310.0, 0.0, &skin));
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, 300.0, 0.0, &wall));
  UM_CHECK(um_thermal_network_conductor_add(network, skin, wall, 1.0));
  UM_CHECK(um_validate_surface(network, 0, skin, 1.0, 1.0, 0.0));
  UM_CHECK(um_irradiation_loads_create(context, SPIN_ROWS, 1, 0, &loads));
  for (size_t k = 0; k < SPIN_ROWS; k++) {
    loads->t[k] = SPIN_PERIOD * (double)k / (SPIN_ROWS - 1);
    loads->irradiance[k] = 10.0 + 10.0 * cos(2.0 * UM_PI * (double)k / (SPIN_ROWS - 1));
    loads->sunlit[k] = 1.0;
    loads->sun[k] = 1.0F;
  }
  UM_CHECK(um_thermal_solve_periodic(context, network, loads, &options, NULL, 0.0, SPIN_PERIOD,
                                     1e-7, start, &drift));
  for (size_t k = 0; k < SPIN_TIMES; k++) times[k] = SPIN_PERIOD * (double)k / SPIN_TIMES;
  UM_CHECK(
      um_thermal_solve(context, network, loads, &options, start, 0.0, times, SPIN_TIMES, &history));
  for (size_t k = 0; k < SPIN_TIMES; k++) {
    double phase = 2.0 * UM_PI * (double)k / SPIN_TIMES;
    re += history->temperature[k * history->nnode + skin] * cos(phase) * 2.0 / SPIN_TIMES;
    im += history->temperature[k * history->nnode + skin] * sin(phase) * 2.0 / SPIN_TIMES;
  }
  out[0] = hypot(re, im) / 10.0;
  out[1] = atan2(im, re) / UM_DEG;
done:
  um_thermal_history_destroy(context, &history);
  um_irradiation_loads_destroy(context, &loads);
  um_thermal_network_destroy(&network);
  return status;
}

/* 1/sqrt(1 + (2 pi tau/P)^2) and atan(2 pi tau/P), P 215 s, evaluated to six decimals;
 * linear rows of 1/2000 of a turn miss the cosine by 1.2e-6 of it. */
static enum um_status spins(struct um_context *context, struct um_validate_report *report)
{
#define SPIN(tau) "Spin of 215 s, tau " #tau " s, amplitude", "Spin of 215 s, tau " #tau " s, lag"
  static const struct {
    const char *name[2];
    double tau, amplitude, lag; /* [s], [1], [deg] */
  } row[] = {{{SPIN(16)}, 16.0, 0.905864, 25.060127},
             {{SPIN(28)}, 28.0, 0.773922, 39.292615},
             {{SPIN(264)}, 264.0, 0.128540, 82.614791},
             {{SPIN(345)}, 345.0, 0.098699, 84.335729},
             {{SPIN(1524)}, 1524.0, 0.022447, 88.713756}};
#undef SPIN
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double out[2];
    UM_TRY(spin(context, row[i].tau, out));
    um_validate_report_add(report, row[i].name[0], "1", row[i].amplitude, out[0], 2e-6, CLOSED);
    um_validate_report_add(report, row[i].name[1], "deg", row[i].lag, out[1], 1e-4, CLOSED);
  }
  return UM_OK;
}

enum um_status um_validate_networks(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(plates(context, report));
  UM_TRY(enclosure(context, report));
  UM_TRY(simple_transient(context, report));
  return spins(context, report);
}
