/* The network of a body in the making: builder, its parts, what ties them. Private to
 * thermal/network/. */
#ifndef UMBRA_THERMAL_NETWORK_BUILDER_IMPL_H
#define UMBRA_THERMAL_NETWORK_BUILDER_IMPL_H

#include "thermal/network/body.h"
#include "thermal/network/shell_element_group.h"

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
  uint32_t *sheet;        /* [nfacet] the outer one of the sheets under it, the others next to it;
                             UM_THERMAL_SPACE none */
  uint32_t *core;         /* [nfacet] first node of what lies between its layers, the others next to
                             it; UM_THERMAL_SPACE none */
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
/* What lies between the layers of a group's wall: number of nodes in a row, share of its capacity.
 */
size_t um_thermal_core_nodes(const struct um_thermal_builder *b, uint32_t group);
double um_thermal_core_share(const struct um_thermal_builder *b, uint32_t group);
/* Join front and back of `area` [m^2] of a wall of two layers, `through` [W/K] in all, by what lies
 * between. name: of the wall, or NULL. first, where not NULL: the first node, or UM_THERMAL_SPACE.
 */
enum um_status um_thermal_core_join(struct um_thermal_builder *b, uint32_t group, const char *name,
                                    uint32_t front, uint32_t back, double area, double through,
                                    uint32_t *first);
/* A wall in a row of nodes needs two layers. */
enum um_status um_thermal_core_check(const struct um_thermal_builder *b, size_t facet);
bool um_thermal_builder_wall_left_out(const struct um_thermal_builder *b, uint32_t group);
/* Nodes of the interiors of a part, in the order of its spec. */
const uint32_t *um_thermal_builder_interiors(const struct um_thermal_builder *b, size_t part);
/* Node of the interior that the MLI of a group wraps; UM_THERMAL_SPACE where it wraps none. */
uint32_t um_thermal_builder_wrapped(const struct um_thermal_builder *b, uint32_t group);
const char *um_thermal_builder_part_name(const struct um_thermal_builder *b, size_t part);

/* Specs against geometry and ranges. */
enum um_status um_thermal_body_check(struct um_thermal_builder *b,
                                     const struct um_thermal_part_spec *parts, size_t npart);

/* What the layer of a facet's wall on that side conducts in plane, kt at 300 K [W/K]; 0: the part
 * is no shell, or the wall is left out. */
double um_thermal_shell_in_plane(const struct um_thermal_builder *b, size_t facet, bool back);
/* Nodes, capacities and conduction of the walls of one part. */
enum um_status um_thermal_shell_assemble(struct um_thermal_builder *b, size_t part);

/* Linear tetrahedron: conductances [W/K] of the edges 01 02 03 12 13 23 for conductivity k
 * [W/m/K], -k V grad(N_i) . grad(N_j); returns the volume V [m^3]. */
double um_thermal_solid_element(const struct um_vec3 corner[4], double k, double out[6]);

/* What fills a part. */
struct um_thermal_solid_matter {
  double capacity;         /* of all of it [J/K]; NaN: by its density */
  double capacity_density; /* rho c [J/m^3/K] */
  double conductivity;     /* [W/m/K] */
  double tetrahedron_size; /* longest edge wanted [m]; 0: that of the facets */
  double power;            /* volume source [W] */
  const struct um_thermal_power_history *history; /* added to it; NULL: none */
  const struct um_thermal_bulk_law *law;          /* by temperature; NULL: constant */
};
/* Fill a part's closed surface: nodes, capacities, conduction, heat made in its volume. The nodes
 * at the corners of the part's facets into corner [nfacet]; the tetrahedra join b->solid. */
enum um_status um_thermal_solid_fill(struct um_thermal_builder *b, size_t part,
                                     const struct um_thermal_solid_matter *matter,
                                     uint32_t (*corner)[3]);

/* Fill a part with its interior; *first: the node that stands for it. */
enum um_status um_thermal_solid_interior(struct um_thermal_builder *b, size_t part,
                                         const struct um_thermal_interior_spec *spec,
                                         uint32_t *first);
/* The interior that `node` stands for, where that is a solid; NULL: it is not. */
const struct um_thermal_filled *um_thermal_filled_find(const struct um_thermal_builder *b,
                                                       uint32_t node);
/* Where something at corner c of a facet meets the interior `node`: that node, or its node there.
 */
uint32_t um_thermal_interior_met(const struct um_thermal_builder *b, uint32_t node, size_t facet,
                                 int c);
/* Nodes of an interior, by volume: out[i] += share of node i, sum 1; out[nodes of the network]. */
void um_thermal_interior_shares(const struct um_thermal_builder *b, uint32_t node, double *out);

/* One part that is solid: its facets' corners are nodes of it. */
enum um_status um_thermal_solid_assemble(struct um_thermal_builder *b, size_t part);

/* Nodes, capacities and conduction of one part of lumped walls. */
enum um_status um_thermal_lump_assemble(struct um_thermal_builder *b, size_t part);

/* Where a name points inside a part: what follows the part's name, "", ".group", ".group.back",
 * ".front", ".back" or that of an interior, ".NAME"; ".inside" is ".back" of a part that radiates
 * inside. A wall of one layer is both front and back. */
struct um_thermal_where {
  uint32_t part, group; /* group UM_GEOMETRY_NONE: all */
  bool front, back;
  uint32_t interior; /* node, or UM_THERMAL_SPACE: a place of the surface */
};
/* false: there is no such place in where->part. */
bool um_thermal_where_find(const struct um_thermal_builder *b, const char *suffix,
                           struct um_thermal_where *where);

/* Every place that has temperatures of its own. */
enum um_status um_thermal_places_build(struct um_thermal_builder *b, struct um_thermal_body *body);

/* The network's laws for `law`, UM_THERMAL_NO_LAW where it is constant. */
enum um_status um_thermal_bulk_laws(struct um_thermal_builder *b,
                                    const struct um_thermal_bulk_law *law,
                                    struct um_thermal_bulk_index *out);
enum um_status um_thermal_bulk_conductor(struct um_thermal_builder *b,
                                         const struct um_thermal_bulk_index *law, uint32_t one,
                                         uint32_t other, double conductance);
/* `capacity` [J/K] of the node follows. */
enum um_status um_thermal_bulk_capacity(struct um_thermal_builder *b,
                                        const struct um_thermal_bulk_index *law, uint32_t node,
                                        double capacity);

/* Names and ranges of the interiors of a part. */
enum um_status um_thermal_interiors_check(const struct um_thermal_builder *b,
                                          const struct um_thermal_part_spec *spec);
/* Room for the nodes of all parts; specs are checked. */
enum um_status um_thermal_interiors_allocate(struct um_thermal_builder *b);
/* Nodes of the interiors of a part. */
enum um_status um_thermal_interiors_add(struct um_thermal_builder *b, size_t part);
/* The nodes of interior i of a part with their shares of its capacity; returns how many, 1 or 2. */
size_t um_thermal_interior_nodes(const struct um_thermal_builder *b, size_t part, size_t i,
                                 uint32_t node[2], double share[2]);
/* Conductors to the walls, which stand. */
enum um_status um_thermal_interiors_couple(struct um_thermal_builder *b, size_t part);

/* Conduction between two places. */
enum um_status um_thermal_contact_assemble(struct um_thermal_builder *b,
                                           const struct um_thermal_contact *contact);

/* Skins over the fronts of one part and what they wrap. */
enum um_status um_thermal_mli_assemble(struct um_thermal_builder *b, size_t part);

/* Powers, power histories and heaters of one part. */
enum um_status um_thermal_heat_assemble(struct um_thermal_builder *b, size_t part);

/* After the walls of the part. */
enum um_status um_thermal_heat_pipes_assemble(struct um_thermal_builder *b, size_t part);

/* Nodes of the groups of a part of kind NODES. */
enum um_status um_thermal_node_model_assemble(struct um_thermal_builder *b, size_t part);
/* Its conductors and radiators, once its interiors stand; nothing for other kinds. */
enum um_status um_thermal_node_model_links(struct um_thermal_builder *b, size_t part);

#endif
