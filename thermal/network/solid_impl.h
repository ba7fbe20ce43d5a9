/* Private to thermal/network/: parts filled with tetrahedra. */
#ifndef UMBRA_THERMAL_SOLID_IMPL_H
#define UMBRA_THERMAL_SOLID_IMPL_H

#include "thermal/network/builder_impl.h"

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

#endif
