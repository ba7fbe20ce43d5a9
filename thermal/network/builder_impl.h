/* Private to thermal/network/: a body while it is being built. */
#ifndef UMBRA_THERMAL_BUILDER_IMPL_H
#define UMBRA_THERMAL_BUILDER_IMPL_H

#include "thermal/network/body.h"

/* Laws of the network that a wall or solid follows, or UM_THERMAL_NO_LAW. */
struct um_thermal_bulk_index {
  uint32_t capacity, conduction;
};
/* An interior that is a solid. */
struct um_thermal_filled {
  uint32_t first;        /* its first node, which stands for it in `interior` */
  size_t solid;          /* index of it */
  uint32_t (*corner)[3]; /* [nfacet] its nodes at the corners of the part's facets */
};

struct um_thermal_builder {
  struct um_context *context;
  const struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;
  struct um_thermal_network *network;
  const struct um_thermal_part_spec **part;   /* [npart] by geometry part */
  const struct um_thermal_group_spec **group; /* [ngroup] by geometry group */
  double *group_area;                         /* [ngroup] one side [m^2] */
  struct um_thermal_bulk_index *group_law;    /* [ngroup] of their walls */
  uint32_t *group_front, *group_back;         /* [ngroup] nodes of LUMPED groups */
  /* Structural node under each corner of each facet, outer and inner layer (the same where there
   * is one layer); UM_THERMAL_SPACE where the wall is left out. [nfacet] */
  uint32_t (*front)[3], (*back)[3];
  uint32_t *skin;         /* [nfacet] MLI node over the front; UM_THERMAL_SPACE none */
  size_t *first_interior; /* [npart + 1] where a part's interiors begin */
  uint32_t *interior; /* [first_interior[npart]] their nodes, of solids the first; UM_THERMAL_SPACE:
                         not yet */
  uint32_t *behind;   /* as many: what lags behind them; UM_THERMAL_SPACE: nothing */
  /* Scratch per mesh vertex (vertices belong to one part): node and capacity of the layers. */
  uint32_t *vertex_node[2]; /* [nvertex] */
  double *vertex_capacity[2];
  struct um_thermal_solid *solid;   /* [nsolid] what the body takes over */
  struct um_thermal_filled *filled; /* [nfilled] */
  size_t npart, ngroup, nsolid, nfilled;
};

/* A diffusive node, or an arithmetic one where the capacity [J/K] is 0. */
enum um_status um_thermal_builder_node(struct um_thermal_builder *b, const char *name,
                                       double capacity, double temperature, double power,
                                       uint32_t *index);
/* The shell that applies to a group. */
const struct um_thermal_shell *um_thermal_builder_shell(const struct um_thermal_builder *b,
                                                        uint32_t group);
/* Its inner face is a surface: of a part that radiates inside. */
bool um_thermal_builder_radiates_inside(const struct um_thermal_builder *b, size_t facet);
/* A facet has two layers: a surface on both sides and a finite conductance through the wall. */
bool um_thermal_builder_two_layers(const struct um_thermal_builder *b, size_t facet);
bool um_thermal_builder_wall_left_out(const struct um_thermal_builder *b, uint32_t group);
/* Nodes of the interiors of a part, in the order of its spec. */
const uint32_t *um_thermal_builder_interiors(const struct um_thermal_builder *b, size_t part);
/* Node of the interior that the MLI of a group wraps; UM_THERMAL_SPACE where it wraps none. */
uint32_t um_thermal_builder_wrapped(const struct um_thermal_builder *b, uint32_t group);
const char *um_thermal_builder_part_name(const struct um_thermal_builder *b, size_t part);

#endif
