/* How far temperatures lie off because facets have a size. */
#ifndef UMBRA_THERMAL_MESH_ERROR_H
#define UMBRA_THERMAL_MESH_ERROR_H

#include "geometry/geometry.h"
#include "thermal/loads/loads.h"
#include "thermal/network/network.h"
#include "thermal/network/solve_options.h"

/* Of every surface that loads are for [noutside]; equations in mesh_error.c. */
struct um_thermal_mesh_error {
  double *shift;  /* [noutside] its temperature over that of ever finer facets, estimated [K] */
  double *spread; /* [noutside] variance of temperature within the facet [K^2] */
  bool *lone;     /* [noutside] it has a node of its own: finer facets keep what it emits */
};
/* At given temperatures [nnode] and time of the loads. mesh: what the network was made of; pose:
 * of any angles of its joints;
 * beside: its facets beside each other (geometry/neighbours.h).
 * Surfaces of solids have no shift: their curvature goes inward, too. The caller frees by
 * um_thermal_mesh_error_release, after a failure too. UM_ERR_MEMORY, errors of
 * um_thermal_heat_of_nodes. */
enum um_status
um_thermal_mesh_error_at(struct um_context *context, const struct um_thermal_network *network,
                         const struct um_geometry_mesh *mesh, const uint32_t (*beside)[3],
                         const struct um_geometry_pose *pose,
                         const struct um_irradiation_loads *loads,
                         const struct um_thermal_solve_options *options, double t,
                         const double *temperature, struct um_thermal_mesh_error *out);
void um_thermal_mesh_error_release(struct um_context *context, struct um_thermal_mesh_error *error);

#endif
