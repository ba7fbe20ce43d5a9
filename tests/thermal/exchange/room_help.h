/* A unit cube of six plates that look inward, or other plates, each a node of its own whose other
 * side is not attached. */
#ifndef UMBRA_TESTS_THERMAL_ROOM_HELP_H
#define UMBRA_TESTS_THERMAL_ROOM_HELP_H

#include "thermal/exchange/exchange.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"
#include "thermal/solver/solve.h"

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s", um_core_message(context));                                 \
  } while (0)

static const struct um_geometry_skin two_sided = {NULL, "in", "out"};

struct room {
  struct um_geometry *geometry;
  struct um_geometry_view_factor_table *table;
  struct um_thermal_network *network;
  struct um_thermal_exchange *exchange;
  struct um_thermal_solve_options options;
};

static inline struct um_geometry_part_spec plate(const char *name, double x, double y, double facet,
                                                 struct um_vec3 position, struct um_quat rotation)
{
  return (struct um_geometry_part_spec){.name = name,
                                        .shape = UM_SHAPE_PLATE,
                                        .size = {x, y, 0},
                                        .position = position,
                                        .rotation = rotation,
                                        .skins = &two_sided,
                                        .nskin = 1,
                                        .facet_size = facet};
}

static inline void cube(struct um_geometry_part_spec part[6], double facet)
{
  static const char *const name[6] = {"x0", "x1", "y0", "y1", "z0", "z1"};
  for (int k = 0; k < 6; k++) {
    double side = k % 2 == 0 ? -0.5 : 0.5, turn = side < 0.0 ? 0.5 * UM_PI : -0.5 * UM_PI;
    struct um_vec3 at =
        um_vec3(k / 2 == 0 ? side : 0, k / 2 == 1 ? side : 0, k / 2 == 2 ? side : 0);
    struct um_quat q = {1, 0, 0, 0};
    if (k / 2 == 0) q = um_quat_from_axis(um_vec3(0, 1, 0), turn);
    if (k / 2 == 1) q = um_quat_from_axis(um_vec3(1, 0, 0), -turn);
    if (k == 5) q = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI);
    part[k] = plate(name[k], 1, 1, facet, at, q);
  }
}

static inline void room_open(struct room *r, const struct um_geometry_part_spec *part, size_t npart,
                             size_t limit, size_t rays)
{
  struct um_geometry_view_factor_options options;
  *r = (struct room){0};
  um_geometry_view_factor_defaults(&options);
  options.rays = rays;
  OK(um_geometry_create(context, part, npart, &r->geometry));
  OK(um_geometry_view_factor_table_create(context, r->geometry, NULL, 1, limit, &options,
                                          &r->table));
  OK(um_thermal_network_create(context, &r->network));
  um_thermal_solve_defaults(&r->options);
}

/* A node for the front of part `part`. capacity 0: arithmetic; NaN: boundary. */
static inline uint32_t room_node(struct room *r, uint32_t part, double emittance,
                                 double absorptance, double temperature, double capacity)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(r->geometry);
  enum um_thermal_node_kind kind = isnan(capacity)   ? UM_NODE_BOUNDARY
                                   : capacity == 0.0 ? UM_NODE_ARITHMETIC
                                                     : UM_NODE_DIFFUSIVE;
  uint32_t node;
  OK(um_thermal_network_node_add(r->network, um_geometry_part_name(r->geometry, part), kind,
                                 isnan(capacity) ? 0.0 : capacity, temperature, 0.0, &node));
  for (uint32_t s = 0; s < mesh->nsurface; s++) {
    if (mesh->surface[s].part != part || mesh->surface[s].back) continue;
    struct um_thermal_surface at = {.node = {node, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                    .weight = {1.0, 0.0, 0.0},
                                    .area = mesh->area[mesh->surface[s].facet],
                                    .emittance = emittance,
                                    .absorptance = absorptance};
    OK(um_thermal_network_surface_attach(r->network, s, &at));
  }
  return node;
}

static inline void room_exchange(struct room *r)
{
  struct um_thermal_exchange_options options = {.infrared = true};
  um_thermal_exchange_destroy(context, &r->exchange);
  OK(um_thermal_exchange_create(context, r->network, NULL, r->table, &options, &r->exchange));
  assert_non_null(r->exchange);
  r->options.exchange = r->exchange;
}

static inline void room_close(struct room *r)
{
  um_thermal_exchange_destroy(context, &r->exchange);
  um_thermal_network_destroy(&r->network);
  um_geometry_view_factor_table_destroy(context, &r->table);
  um_geometry_destroy(&r->geometry);
}

/* Net loss of every node, to others and to space [W]. */
static inline void losses(const struct room *r, const double *temperature, double *loss)
{
  size_t n = um_thermal_network_nodes(r->network);
  struct um_thermal_heat heat[16];
  OK(um_thermal_heat_of_nodes(context, r->network, NULL, &r->options, 0.0, temperature, heat));
  for (size_t i = 0; i < n; i++) loss[i] = -(heat[i].exchanged + heat[i].radiated);
}

#endif
