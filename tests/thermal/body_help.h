/* Small satellites for the tests of thermal/: one geometry, one spec per part. */
#ifndef UMBRA_TESTS_THERMAL_BODY_HELP_H
#define UMBRA_TESTS_THERMAL_BODY_HELP_H

#include <stdlib.h>

#include "tests/thermal/network_help.h"
#include "thermal/network/body.h"
#include "thermal/network/network_group.h"

#define HELP_PARTS     12
#define HELP_INTERIORS 3

/* A satellite being described: fill shape[] and spec[], then help_build. */
struct help_satellite {
  struct um_geometry_part_spec shape[HELP_PARTS];
  struct um_geometry_skin skin[HELP_PARTS];
  struct um_thermal_part_spec spec[HELP_PARTS];
  struct um_thermal_group_spec group[HELP_PARTS]; /* of every group of the part */
  struct um_thermal_interior_spec interior[HELP_PARTS][HELP_INTERIORS];
  double conductance[HELP_PARTS][HELP_INTERIORS]; /* [W/K] of every group of the part */
  size_t npart;
  struct um_geometry *geometry;
  struct um_thermal_body *body;
  struct um_thermal_group_spec all[64];
};

/* Next part of a shape; back: NULL for a closed one. Wall 4860 J/m2/K, black, 300 K. */
static inline size_t help_part(struct help_satellite *s, const char *name,
                               enum um_geometry_shape shape, const char *back)
{
  size_t p = s->npart++;
  s->skin[p] = (struct um_geometry_skin){.front = "paint", .back = back};
  s->shape[p] = (struct um_geometry_part_spec){.name = name,
                                               .shape = shape,
                                               .size = {1.0, 1.0, 1.0},
                                               .rotation = {1.0, 0.0, 0.0, 0.0},
                                               .joint_axis = {0.0, 0.0, 1.0},
                                               .skins = &s->skin[p],
                                               .nskin = 1};
  s->spec[p] = (struct um_thermal_part_spec){
      .part = (uint32_t)p,
      .shell = {.areal_heat_capacity = 4860.0, .front_share = 0.5, .conductance = 0.334},
      .density = 2700.0,
      .specific_heat = 900.0,
      .conductivity = 167.0,
      .start_temperature = 300.0};
  s->group[p] = (struct um_thermal_group_spec){.absorptance_front = 1.0,
                                               .emittance_front = 1.0,
                                               .absorptance_back = 1.0,
                                               .emittance_back = 1.0};
  return p;
}

/* Another node inside a part, held by every group of it with a conductance [W/K]. */
static inline struct um_thermal_interior_spec *
help_interior(struct help_satellite *s, size_t p, const char *name, double capacity, double held)
{
  size_t i = s->spec[p].ninterior++;
  s->spec[p].interior = s->interior[p];
  s->interior[p][i] = (struct um_thermal_interior_spec){.name = name, .capacity = capacity};
  s->conductance[p][i] = held;
  s->group[p].interior_conductance = s->conductance[p];
  return &s->interior[p][i];
}

static inline void help_geometry(struct help_satellite *s)
{
  OK(um_geometry_create(help_context, s->shape, s->npart, &s->geometry));
  size_t n = 0;
  for (size_t p = 0; p < s->npart; p++) {
    s->spec[p].groups = &s->all[n];
    for (uint32_t g = 0; g < um_geometry_group_count(s->geometry); g++) {
      if (um_geometry_group(s->geometry, g)->part != p) continue;
      s->all[n] = s->group[p];
      s->all[n++].group = g;
      s->spec[p].ngroup++;
    }
  }
}

static inline void help_build(struct help_satellite *s, const struct um_thermal_contact *contacts,
                              size_t ncontact)
{
  if (s->geometry == NULL) help_geometry(s);
  OK(um_thermal_body_create(help_context, s->geometry, s->spec, s->npart, contacts, ncontact,
                            &s->body));
}

static inline void help_end(struct help_satellite *s)
{
  um_thermal_body_destroy(help_context, &s->body);
  um_geometry_destroy(&s->geometry);
}

static inline const struct um_thermal_place *help_place(const struct help_satellite *s,
                                                        const char *name)
{
  size_t p = um_thermal_body_place_find(s->body, name);
  if (p == (size_t)-1) fail_msg("no place %s", name);
  return &s->body->place[p];
}

/* Area-weighted mean over a place [K]. */
static inline double help_mean(const struct help_satellite *s, const char *name,
                               const double *temperature)
{
  const struct um_thermal_place *p = help_place(s, name);
  double mean = 0.0;
  for (size_t i = 0; i < p->nnode; i++) mean += p->weight[i] * temperature[p->node[i]];
  return mean;
}

/* Give a node its temperature [K] for good. */
static inline void help_hold_node(struct help_satellite *s, uint32_t node, double temperature)
{
  s->body->network->node[node].kind = UM_NODE_BOUNDARY;
  s->body->network->node[node].temperature = temperature;
}

static inline void help_hold(struct help_satellite *s, const char *name, double temperature)
{
  const struct um_thermal_place *p = help_place(s, name);
  for (size_t i = 0; i < p->nnode; i++) help_hold_node(s, p->node[i], temperature);
}

/* Call with every surface corner whose vertex lies at x [m]: the nodes of a field have no position
 * of their own, so they are found through the surfaces. Returns the number of corners. */
static inline size_t help_nodes_at_x(struct help_satellite *s, double x, uint32_t *node,
                                     size_t room)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(s->geometry);
  struct um_geometry_pose *pose = NULL;
  size_t n = 0;
  OK(um_geometry_pose_create(help_context, s->geometry, NULL, &pose));
  for (uint32_t i = 0; i < mesh->nsurface; i++)
    for (int c = 0; c < 3; c++)
      if (fabs(pose->vertex[mesh->corner[mesh->surface[i].facet][c]].x - x) < 1e-9 && n < room)
        node[n++] = um_thermal_network_surface(s->body->network, i)->node[c];
  um_geometry_pose_destroy(help_context, &pose);
  return n;
}

static inline void help_hold_at_x(struct help_satellite *s, double x, double temperature)
{
  uint32_t node[4096];
  size_t n = help_nodes_at_x(s, x, node, 4096);
  for (size_t i = 0; i < n; i++) help_hold_node(s, node[i], temperature);
}

/* Steady state; the caller frees. */
static inline double *help_steady(struct help_satellite *s,
                                  const struct um_irradiation_loads *loads, double space)
{
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, space);
  double *temperature = calloc(um_thermal_network_nodes(s->body->network), sizeof *temperature);
  assert_non_null(temperature);
  OK(um_thermal_solve_steady(help_context, s->body->network, loads, 0, &options, NULL,
                             temperature));
  return temperature;
}

#endif
