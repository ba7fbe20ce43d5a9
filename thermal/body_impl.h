/* Private to thermal: what the files that assemble a body share while they build it. */
#ifndef UMBRA_THERMAL_BODY_IMPL_H
#define UMBRA_THERMAL_BODY_IMPL_H

#include "thermal/body.h"

struct um_thermal_builder {
  struct um_context *context;
  const struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;
  struct um_thermal_network *network;
  const struct um_thermal_part_spec **part;   /* [npart] by geometry part */
  const struct um_thermal_group_spec **group; /* [ngroup] by geometry group */
  double *group_area;                         /* [ngroup] one side [m^2] */
  uint32_t *group_front, *group_back;         /* [ngroup] nodes of LUMPED groups */
  /* Structural node under each corner of each facet, outer and inner layer (the same where there
   * is one layer); UM_THERMAL_SPACE where the wall is left out. [nfacet] */
  uint32_t (*front)[3], (*back)[3];
  uint32_t *skin;     /* [nfacet] MLI node over the front; UM_THERMAL_SPACE none */
  uint32_t *interior; /* [npart]; UM_THERMAL_SPACE none */
  /* Scratch per mesh vertex (vertices belong to one part): node and capacity of the layers. */
  uint32_t *vertex_node[2]; /* [nvertex] */
  double *vertex_capacity[2];
  size_t npart, ngroup, ntetrahedron;
};

/* Where a name points inside a part: what follows the part's name, "", ".group", ".group.back",
 * ".front", ".back" or ".interior". A wall of one layer is both front and back. */
struct um_thermal_where {
  uint32_t part, group; /* group UM_GEOMETRY_NONE: all */
  bool front, back, interior;
};
/* false: there is no such place in where->part. */
bool um_thermal_where_find(const struct um_thermal_builder *b, const char *suffix,
                           struct um_thermal_where *where);

/* Linear triangle: conductances [W/K] between the corners, out[e] opposite corner e, for in-plane
 * conductance kt [W/K]: kt cot(angle e) / 2. */
void um_thermal_shell_element(const struct um_vec3 corner[3], double kt, double out[3]);
/* Linear tetrahedron: conductances [W/K] of the edges 01 02 03 12 13 23 for conductivity k
 * [W/m/K], -k V grad(N_i) . grad(N_j); returns the volume V [m^3]. */
double um_thermal_solid_element(const struct um_vec3 corner[4], double k, double out[6]);

/* A diffusive node, or an arithmetic one where the capacity [J/K] is 0. */
enum um_status um_thermal_builder_node(struct um_thermal_builder *b, const char *name,
                                       double capacity, double temperature, double power,
                                       uint32_t *index);
/* The shell that applies to a group. */
const struct um_thermal_shell *um_thermal_builder_shell(const struct um_thermal_builder *b,
                                                        uint32_t group);
/* A facet has two layers: a back surface and a finite conductance through the wall. */
bool um_thermal_builder_two_layers(const struct um_thermal_builder *b, size_t facet);
bool um_thermal_builder_wall_left_out(const struct um_thermal_builder *b, uint32_t group);
const char *um_thermal_builder_part_name(const struct um_thermal_builder *b, size_t part);

/* Nodes, capacities and conduction of one part. */
enum um_status um_thermal_shell_assemble(struct um_thermal_builder *b, size_t part);
enum um_status um_thermal_solid_assemble(struct um_thermal_builder *b, size_t part);
enum um_status um_thermal_lump_assemble(struct um_thermal_builder *b, size_t part);
/* Skins over the fronts of one part and what they wrap. */
enum um_status um_thermal_mli_assemble(struct um_thermal_builder *b, size_t part);
/* Powers, power histories and heaters of one part. */
enum um_status um_thermal_heat_assemble(struct um_thermal_builder *b, size_t part);
enum um_status um_thermal_contact_assemble(struct um_thermal_builder *b,
                                           const struct um_thermal_contact *contact);
enum um_status um_thermal_places_build(struct um_thermal_builder *b, struct um_thermal_body *body);
/* Specs against geometry and ranges. */
enum um_status um_thermal_body_check(struct um_thermal_builder *b,
                                     const struct um_thermal_part_spec *parts, size_t npart);

#endif
