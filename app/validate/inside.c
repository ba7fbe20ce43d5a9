/* Closed parts that radiate inside, and contacts that radiate, from geometry to heat flows.
 *
 * The unit cube of radiosity and Gebhart's factors (as the network in networks.c), here with view
 * factors by rays: 5e-4 of what its hottest face loses. */
#include "geometry/inside.h"

#include "app/validate/cases_impl.h"
#include "app/validate/thermal_case_impl.h"
#include "thermal/exchange/exchange.h"
#include "thermal/network/body.h"

#define RAYS_ERROR 0.36 /* [W] */

struct box {
  struct um_geometry *geometry;
  struct um_thermal_body *body;
  struct um_geometry_view_factor_table *table;
  struct um_thermal_exchange *exchange;
  struct um_thermal_solve_options options;
};

/* Six walls of one node each, emittances e inside, nothing outside. */
static enum um_status box_create(struct um_context *context, const double e[6], struct box *box)
{
  static const struct um_geometry_skin skin = {NULL, "paint", NULL};
  const struct um_geometry_part_spec shape = {.name = "box",
                                              .shape = UM_SHAPE_BOX,
                                              .size = {1.0, 1.0, 1.0},
                                              .rotation = {1.0, 0.0, 0.0, 0.0},
                                              .skins = &skin,
                                              .nskin = 1};
  struct um_thermal_group_spec group[6] = {{0}};
  struct um_thermal_part_spec part = {
      .kind = UM_THERMAL_LUMPED,
      .inside = true,
      .shell = {.areal_heat_capacity = 1000.0, .through_conductance = INFINITY},
      .start_temperature = 300.0,
      .groups = group,
      .ngroup = 6};
  struct um_geometry_view_factor_options factors;
  const struct um_thermal_exchange_options infrared = {.infrared = true};
  um_geometry_view_factor_defaults(&factors);
  for (uint32_t g = 0; g < 6; g++)
    group[g] = (struct um_thermal_group_spec){.group = g, .inside_emittance = e[g]};
  UM_TRY(um_geometry_create(context, &shape, 1, &box->geometry));
  UM_TRY(um_thermal_body_create(context, box->geometry, &part, 1, NULL, 0, &box->body));
  UM_TRY(um_geometry_view_factor_table_create(context, box->geometry, NULL, 1, 64, &factors,
                                              &box->table));
  UM_TRY(um_geometry_inside_add(context, box->geometry, 0, 0, &factors, box->table));
  const struct um_geometry_mesh *mesh = um_geometry_mesh(box->geometry);
  for (size_t f = 0; f < mesh->nfacet; f++)
    UM_TRY(um_thermal_network_surface_block(box->body->network, um_geometry_inner_surface(mesh, f),
                                            0.0));
  UM_TRY(um_thermal_exchange_create(context, box->body->network, NULL, box->table, &infrared,
                                    &box->exchange));
  box->options = um_validate_tight(0.0);
  box->options.exchange = box->exchange;
  return UM_OK;
}

static void box_destroy(struct um_context *context, struct box *box)
{
  um_thermal_exchange_destroy(context, &box->exchange);
  um_geometry_view_factor_table_destroy(context, &box->table);
  um_thermal_body_destroy(context, &box->body);
  um_geometry_destroy(&box->geometry);
}

static enum um_status cube(struct um_context *context, struct um_validate_report *report)
{
  static const char *const name[6] = {
      "Cube inside a closed part, loss of face 0", "Cube inside a closed part, loss of face 1",
      "Cube inside a closed part, loss of face 2", "Cube inside a closed part, loss of face 3",
      "Cube inside a closed part, loss of face 4", "Cube inside a closed part, loss of face 5"};
  static const double e[6] = {0.8, 0.8, 0.3, 0.3, 0.05, 0.9};
  static const double t[6] = {300.0, 320.0, 280.0, 310.0, 250.0, 400.0};
  static const double same[6] = {350.0, 350.0, 350.0, 350.0, 350.0, 350.0};
  static const double loss[6] = {-295.67961, -170.81837, -136.12687,
                                 -80.82225,  -28.13338,  711.58047};
  struct box box = {0};
  struct um_thermal_heat heat[6];
  double worst = 0.0;
  enum um_status status;
  UM_CHECK(box_create(context, e, &box));
  UM_CHECK(um_thermal_heat_of_nodes(context, box.body->network, NULL, &box.options, 0.0, t, heat));
  for (int i = 0; i < 6; i++)
    um_validate_report_add(report, name[i], "W", loss[i], -heat[i].exchanged, RAYS_ERROR,
                           "Gebhart; radiosity");
  UM_CHECK(
      um_thermal_heat_of_nodes(context, box.body->network, NULL, &box.options, 0.0, same, heat));
  for (int i = 0; i < 6; i++) worst = fmax(worst, fabs(heat[i].exchanged));
  um_validate_report_add(report, "Closed part of one temperature, worst heat of a face", "W", 0.0,
                         worst, 1e-9, "second law");
done:
  box_destroy(context, &box);
  return status;
}

/* Two plates of 1 m^2 at 400 and 300 K, a sheet between them, joined by contacts of exchange factor
 * 1 / (1/e_a + 1/e_b - 1); stiff conductors hold the plates. */
static enum um_status shield(struct um_context *context, struct um_validate_report *report)
{
  static const struct um_geometry_skin skin = {NULL, "paint", "paint"};
  static const char *const name[3] = {"hot", "sheet", "cold"};
  struct um_geometry_part_spec shape[3];
  struct um_thermal_group_spec group[3] = {{0}};
  struct um_thermal_part_spec part[3];
  const struct um_thermal_contact contact[2] = {
      {.a = "hot", .b = "sheet", .exchange_area = 1.0 / (1.0 / 0.8 + 19.0)},
      {.a = "sheet", .b = "cold", .exchange_area = 1.0 / (20.0 + 1.0 / 0.3 - 1.0)}};
  struct um_geometry *geometry = NULL;
  struct um_thermal_body *body = NULL;
  struct um_thermal_solve_options options = um_validate_tight(0.0);
  struct um_thermal_heat heat[5];
  double temperature[5];
  enum um_status status;
  for (uint32_t p = 0; p < 3; p++) {
    shape[p] = (struct um_geometry_part_spec){.name = name[p],
                                              .shape = UM_SHAPE_PLATE,
                                              .size = {1.0, 1.0, 0.0},
                                              .position = {0.0, 0.0, 0.01 * p},
                                              .rotation = {1.0, 0.0, 0.0, 0.0},
                                              .skins = &skin,
                                              .nskin = 1};
    group[p].group = p;
    part[p] = (struct um_thermal_part_spec){
        .part = p,
        .kind = UM_THERMAL_LUMPED,
        .shell = {.areal_heat_capacity = 1000.0, .through_conductance = INFINITY},
        .start_temperature = 350.0,
        .groups = &group[p],
        .ngroup = 1};
  }
  UM_CHECK(um_geometry_create(context, shape, 3, &geometry));
  UM_CHECK(um_thermal_body_create(context, geometry, part, 3, contact, 2, &body));
  for (uint32_t end = 0; end < 2; end++) {
    uint32_t wall;
    UM_CHECK(um_thermal_network_node_add(body->network, NULL, UM_NODE_BOUNDARY, 0.0,
                                         end == 0 ? 400.0 : 300.0, 0.0, &wall));
    UM_CHECK(um_thermal_network_conductor_add(body->network, wall, 2 * end, 1e9));
  }
  UM_CHECK(um_thermal_solve_steady(context, body->network, NULL, 0, &options, NULL, temperature));
  UM_CHECK(
      um_thermal_heat_of_nodes(context, body->network, NULL, &options, 0.0, temperature, heat));
  um_validate_report_add(report, "Radiative contacts, plates 400/300 K and one shield", "W/m^2",
                         23.30291, heat[2].exchanged, 1e-5, "closed form");
done:
  um_thermal_body_destroy(context, &body);
  um_geometry_destroy(&geometry);
  return status;
}

enum um_status um_validate_inside(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(cube(context, report));
  return shield(context, report);
}
