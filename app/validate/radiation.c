/* Radiating nodes: cooling, blankets, panels, balances with Sun and Earth. Expected values: closed
 * forms with sigma = 5.670374419e-8, printed digits. */
#include <math.h>

#include "app/validate/cases_impl.h"
#include "app/validate/thermal_case_impl.h"
#include "base/core/constants.h"
#include "environment/environment.h"
#include "thermal/network/body.h"

#define CLOSED "closed form"
#define STIFF  1e11 /* conductance [W/K] that holds a node at a temperature to 1e-8 */

/* C dT/dt = -eps sigma (T^4 - T_s^4). To 0 K T = (T_0^-3 + 3 eps sigma t / C)^(-1/3); to a sink
 * t(T) is elementary. Printed to 1e-5 K. 25 um: half of 77.39 J/m^2/K. */
static enum um_status cooling(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name[2];
    double capacity, emittance, start, t, expected[2]; /* [J/m^2/K], [1], [K], [s], [K] */
  } row[] = {{{"MLI 50 um cools to 0 K, 60 s", "MLI 50 um cools to 180 K, 60 s"},
              77.39,
              0.78,
              300.0,
              60.0,
              {192.62775, 211.67977}},
             {{"MLI 25 um cools to 0 K, 60 s", "MLI 25 um cools to 180 K, 60 s"},
              38.695,
              0.64,
              300.0,
              60.0,
              {169.36178, 197.00400}},
             {{"Solar panel cools to 0 K, 1800 s", "Solar panel cools to 180 K, 1800 s"},
              3240.0,
              1.65,
              320.0,
              1800.0,
              {175.04255, 200.43154}},
             {{"Aluminium 2 mm cools to 0 K, 1800 s", "Aluminium 2 mm cools to 180 K, 1800 s"},
              4860.0,
              0.8,
              300.0,
              1800.0,
              {225.30077, 236.42169}}};
  static const double sink[2] = {0.0, 180.0};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    for (int k = 0; k < 2; k++) {
      struct um_thermal_network *network = NULL;
      struct um_thermal_history *history = NULL;
      struct um_thermal_solve_options options = um_validate_tight(sink[k]);
      uint32_t node;
      enum um_status status;
      UM_CHECK(um_thermal_network_create(context, &network));
      UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, row[i].capacity,
                                           row[i].start, 0.0, &node));
      UM_CHECK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE, row[i].emittance));
      UM_CHECK(
          um_thermal_solve(context, network, NULL, &options, NULL, 0.0, &row[i].t, 1, &history));
      um_validate_report_add(report, row[i].name[k], "K", row[i].expected[k],
                             history->temperature[0], 1e-5, CLOSED);
    done:
      um_thermal_history_destroy(context, &history);
      um_thermal_network_destroy(&network);
      UM_TRY(status);
    }
  return UM_OK;
}

/* A box wrapped in MLI, alpha 0.38, eps 0.78; what it wraps is kept at 293 K. */
struct blanket {
  struct um_geometry *geometry;
  struct um_thermal_body *body;
  double *temperature; /* [nnode] */
};

static enum um_status blanket_create(struct um_context *context, double effective_emittance,
                                     struct blanket *out)
{
  static const struct um_geometry_skin skin = {NULL, "mli", NULL};
  static const struct um_geometry_part_spec shape = {.name = "bus",
                                                     .shape = UM_SHAPE_BOX,
                                                     .size = {1.0, 1.0, 1.0},
                                                     .rotation = {1.0, 0.0, 0.0, 0.0},
                                                     .skins = &skin,
                                                     .nskin = 1};
  const struct um_thermal_mli mli = {.effective_emittance = effective_emittance,
                                     .areal_heat_capacity = 60.0,
                                     .wraps_interior = true};
  struct um_thermal_group_spec group[6];
  struct um_thermal_interior_spec inside = {.name = "interior", .capacity = 1e5};
  const struct um_thermal_part_spec part = {.kind = UM_THERMAL_LUMPED,
                                            .shell = {.areal_heat_capacity = 4860.0},
                                            .interior = &inside,
                                            .ninterior = 1,
                                            .start_temperature = 293.0,
                                            .groups = group,
                                            .ngroup = 6};
  for (uint32_t g = 0; g < 6; g++)
    group[g] = (struct um_thermal_group_spec){
        .group = g, .mli = &mli, .absorptance_front = 0.38, .emittance_front = 0.78};
  UM_TRY(um_geometry_create(context, &shape, 1, &out->geometry));
  UM_TRY(um_thermal_body_create(context, out->geometry, &part, 1, NULL, 0, &out->body));
  struct um_thermal_network *network = out->body->network;
  uint32_t wall;
  size_t interior = um_thermal_body_place_find(out->body, "bus.interior");
  UM_TRY(um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, 293.0, 0.0, &wall));
  UM_TRY(
      um_thermal_network_conductor_add(network, out->body->place[interior].node[0], wall, STIFF));
  return um_core_allocate(context, um_thermal_network_nodes(network), sizeof *out->temperature,
                          &out->temperature);
}

static void blanket_destroy(struct um_context *context, struct blanket *blanket)
{
  um_core_free(context, blanket->temperature);
  um_thermal_body_destroy(context, &blanket->body);
  um_geometry_destroy(&blanket->geometry);
}

/* Steady skin under normal sunlight and diffuse infrared [W/m^2] on every face; *skin [K]. */
static enum um_status blanket_skin(struct um_context *context, struct blanket *blanket, double sun,
                                   double planet, double *skin)
{
  enum { SURFACES = 12 };
  double share[SURFACES], infrared[SURFACES];
  for (int i = 0; i < SURFACES; i++) {
    share[i] = 1.0;
    infrared[i] = planet;
  }
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  enum um_status status;
  UM_CHECK(um_validate_loads(context, SURFACES, sun, share, infrared, &loads));
  UM_CHECK(um_thermal_solve_steady(context, blanket->body->network, loads, 0, &options, NULL,
                                   blanket->temperature));
  const struct um_thermal_place *place =
      &blanket->body->place[um_thermal_body_place_find(blanket->body, "bus.+x")];
  *skin = blanket->temperature[place->node[0]];
done:
  um_irradiation_loads_destroy(context, &loads);
  return status;
}

/* Printed to 1e-4 K and 1e-4 W/m^2. */
static enum um_status blankets(struct um_context *context, struct um_validate_report *report)
{
#define ROW(e)                                                                                     \
  {                                                                                                \
    "MLI e* " #e ", skin in sunlight", "MLI e* " #e ", leak inward in sunlight",                   \
        "MLI e* " #e ", skin in the dark", "MLI e* " #e ", leak outward in the dark",              \
        "MLI e* " #e ", skin over the Earth's infrared"                                            \
  }
  static const struct {
    double e, expected[5]; /* [1], [K], [W/m^2], [K], [W/m^2], [K] */
    const char *name[5];
  } row[] = {{0.005, {328.6456, 1.2179, 82.7738, 2.0762, 240.7044}, ROW(0.005)},
             {0.01, {328.4540, 2.4204, 98.2790, 4.1262, 241.1584}, ROW(0.01)},
             {0.03, {327.7079, 7.0819, 128.5366, 12.0729, 242.8947}, ROW(0.03)},
             {0.05, {326.9929, 11.5187, 145.1579, 19.6367, 244.5134}, ROW(0.05)}};
#undef ROW
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct blanket blanket = {0};
    double lit, dark, nadir, leak = row[i].e * UM_STEFAN_BOLTZMANN;
    enum um_status status;
    UM_CHECK(blanket_create(context, row[i].e, &blanket));
    UM_CHECK(blanket_skin(context, &blanket, 1361.0, 0.0, &lit));
    UM_CHECK(blanket_skin(context, &blanket, 0.0, 0.0, &dark));
    UM_CHECK(blanket_skin(context, &blanket, 0.0, 237.0 * 0.797, &nadir));
    const double value[5] = {lit, leak * (pow(lit, 4.0) - pow(293.0, 4.0)), dark,
                             leak * (pow(293.0, 4.0) - pow(dark, 4.0)), nadir};
    for (int k = 0; k < 5; k++)
      um_validate_report_add(report, row[i].name[k], k % 2 ? "W/m^2" : "K", row[i].expected[k],
                             value[k], 1e-4, CLOSED);
  done:
    blanket_destroy(context, &blanket);
    UM_TRY(status);
  }
  return UM_OK;
}

/* Panel facing the Sun, no Earth, eps 0.85 on both sides, alpha 0.92, U through it [W/m^2/K]. */
static enum um_status panel(struct um_context *context, double u, double extraction, double out[2])
{
  static const double sun[2] = {1.0, 0.0};
  struct um_thermal_network *network = NULL;
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  struct um_thermal_surface front = {.node = {0, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                     .weight = {1.0, 0.0, 0.0},
                                     .area = 1.0,
                                     .absorptance = 0.92,
                                     .emittance = 0.85,
                                     .extraction = extraction};
  double temperature[2];
  uint32_t node[2] = {0, 0};
  enum um_status status;
  UM_CHECK(um_thermal_network_create(context, &network));
  for (int k = 0; k < (isfinite(u) ? 2 : 1); k++)
    UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, 1620.0, 300.0, 0.0,
                                         &node[k]));
  if (isfinite(u)) UM_CHECK(um_thermal_network_conductor_add(network, 0, 1, u));
  UM_CHECK(um_thermal_network_surface_attach(network, 0, &front));
  UM_CHECK(um_validate_surface(network, 1, isfinite(u) ? node[1] : 0, 1.0, 0.85, 0.85));
  UM_CHECK(um_validate_loads(context, 2, 1361.0, sun, NULL, &loads));
  UM_CHECK(um_thermal_solve_steady(context, network, loads, 0, &options, NULL, temperature));
  out[0] = temperature[0];
  out[1] = temperature[isfinite(u) ? 1 : 0];
done:
  um_irradiation_loads_destroy(context, &loads);
  um_thermal_network_destroy(&network);
  return status;
}

static enum um_status panels(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name[2];
    double u, extraction, expected[2];
  } row[] = {
      {{"Solar array, isothermal", NULL}, INFINITY, 0.18, {319.7108, 319.7108}},
      {{"Solar array, U 100, front", "Solar array, U 100, back"},
       100.0,
       0.18,
       {322.1238, 317.2419}},
      {{"Solar array, U 30, front", "Solar array, U 30, back"}, 30.0, 0.18, {327.0368, 311.8434}},
      {{"Solar array, dead, isothermal", NULL}, INFINITY, 0.0, {337.5952, 337.5952}}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double t[2];
    UM_TRY(panel(context, row[i].u, row[i].extraction, t));
    for (int k = 0; k < 2 && row[i].name[k] != NULL; k++)
      um_validate_report_add(report, row[i].name[k], "K", row[i].expected[k], t[k], 1e-4, CLOSED);
  }
  return UM_OK;
}

/* Steady temperature of 1 m^2 that absorbs alpha `sun` + eps `planet` [W/m^2]. */
static enum um_status balance(struct um_context *context, double alpha, double emittance,
                              double sun, double planet, double *temperature)
{
  const double share = 1.0;
  struct um_thermal_network *network = NULL;
  struct um_irradiation_loads *loads = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  uint32_t node;
  enum um_status status;
  UM_CHECK(um_thermal_network_create(context, &network));
  UM_CHECK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, 1.0, 300.0, 0.0, &node));
  UM_CHECK(um_validate_surface(network, 0, node, 1.0, alpha, emittance));
  UM_CHECK(um_validate_loads(context, 1, sun, &share, &planet, &loads));
  UM_CHECK(um_thermal_solve_steady(context, network, loads, 0, &options, NULL, temperature));
done:
  um_irradiation_loads_destroy(context, &loads);
  um_thermal_network_destroy(&network);
  return status;
}

/* Loads pass as float, 6e-8 of them: 4 uK. Printed to 1 mK. */
static enum um_status balances(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double alpha, emittance, share, expected; /* share: sunlight over emitting area */
  } lone[] = {{"No Earth, grey sphere", 0.7, 0.7, 0.25, 278.321},
              {"No Earth, black plate, insulated back", 1.0, 1.0, 1.0, 393.606},
              {"No Earth, black plate, two-sided", 1.0, 1.0, 0.5, 330.982},
              {"No Earth, Kapton 0.38/0.78, insulated back", 0.38, 0.78, 1.0, 328.839}};
  for (size_t i = 0; i < sizeof lone / sizeof lone[0]; i++) {
    double t;
    UM_TRY(balance(context, lone[i].alpha, lone[i].emittance, 1361.0 * lone[i].share, 0.0, &t));
    um_validate_report_add(report, lone[i].name, "K", lone[i].expected, t, 5e-4, CLOSED);
  }
  static const struct {
    const char *name[3];
    double altitude, expected[3];
  } sphere[] = {{{"Sphere at 400 km, sub-solar", "Sphere at 400 km, no albedo",
                  "Sphere at 400 km, steady eclipse"},
                 400e3,
                 {259.374, 245.503, 192.827}},
                {{"Sphere at 600 km, sub-solar", "Sphere at 600 km, no albedo",
                  "Sphere at 600 km, steady eclipse"},
                 600e3,
                 {255.995, 243.094, 187.730}},
                {{"Sphere at 765 km, sub-solar", "Sphere at 765 km, no albedo",
                  "Sphere at 765 km, steady eclipse"},
                 765e3,
                 {253.679, 241.457, 184.106}}};
  for (size_t i = 0; i < sizeof sphere / sizeof sphere[0]; i++) {
    double f = um_environment_sphere_view_factor(1.0 + sphere[i].altitude / UM_EARTH_RADIUS);
    const double sun[3] = {1361.0 * (0.25 + 0.3 * f), 1361.0 * 0.25, 0.0};
    for (int k = 0; k < 3; k++) {
      double t;
      UM_TRY(balance(context, 0.3, 0.8, sun[k], 237.0 * f, &t));
      um_validate_report_add(report, sphere[i].name[k], "K", sphere[i].expected[k], t, 5e-4,
                             CLOSED);
    }
  }
  return UM_OK;
}

enum um_status um_validate_radiation(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(cooling(context, report));
  UM_TRY(blankets(context, report));
  UM_TRY(panels(context, report));
  return balances(context, report);
}
