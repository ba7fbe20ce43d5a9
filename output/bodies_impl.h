/* Private to output/: where the satellite's vertices stand, and the tetrahedra of its solids, as
 * run.nc and grids have them. */
#ifndef UMBRA_OUTPUT_BODIES_IMPL_H
#define UMBRA_OUTPUT_BODIES_IMPL_H

#include "output/output.h"
#include "thermal/network/body.h"

/* Vertices of all facets at the middle of observation k, joints turned, in body axes:
 * xyz[3 nvertex] [m]. UM_ERR_MEMORY. */
enum um_status um_output_vertices(struct um_context *context, const struct um_output_run *run,
                                  size_t k, double *xyz);

/* Vertices of the tetrahedra of all solids of a body. */
size_t um_output_solid_vertices(const struct um_thermal_body *body);
/* Where they stand, joints that follow the Sun at angle 0, xyz[3 n] [m]; the heat node of each,
 * node[n]; and the vertices of the tetrahedra, which count through all solids,
 * corner[4 ntetrahedron]. */
void um_output_solids(const struct um_thermal_body *body, double *xyz, int *node, int *corner);

#endif
