/* run.nc: the inside of solids, one after the other: vertices of their tetrahedra with temperatures
 * over time. */
#include "output/bodies_impl.h"
#include "output/netcdf_impl.h"

enum um_status um_output_netcdf_solids(const struct um_output_netcdf *w)
{
  const struct um_model_result *r = w->run->result;
  const struct um_thermal_body *body = w->run->model->body;
  const enum um_output_dimension tv[2] = {UM_NC_TIME, UM_NC_SOLID_VERTEX},
                                 vx[2] = {UM_NC_SOLID_VERTEX, UM_NC_XYZ},
                                 tc[2] = {UM_NC_TETRAHEDRON, UM_NC_TETRAHEDRON_CORNER};
  size_t n = w->length[UM_NC_SOLID_VERTEX];
  double *xyz = NULL, *t = NULL;
  int *node = NULL, *corner = NULL;
  enum um_status status = UM_OK;
  if (n == 0) return UM_OK;
  UM_CHECK(um_core_allocate(w->context, 3 * n, sizeof *xyz, &xyz));
  UM_CHECK(um_core_allocate(w->context, n, sizeof *node, &node));
  UM_CHECK(um_core_allocate(w->context, r->nobs * n, sizeof *t, &t));
  UM_CHECK(um_core_allocate(w->context, 4 * body->ntetrahedron, sizeof *corner, &corner));
  um_output_solids(body, xyz, node, corner);
  UM_CHECK(um_output_netcdf_double(w, "solid_vertex_position", vx, 2, "m",
                                   "body frame; parts on joints that follow the Sun at angle 0",
                                   xyz));
  UM_CHECK(
      um_output_netcdf_int(w, "solid_vertex_node", vx, 1, "index into node of each vertex", node));
  UM_CHECK(um_output_netcdf_int(w, "tetrahedron_vertex", tc, 2,
                                "index into solid_vertex of the corners of each tetrahedron",
                                corner));
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t v = 0; v < n; v++)
      t[k * n + v] = r->node_temperature[k * r->nnode + (size_t)node[v]];
  UM_CHECK(um_output_netcdf_double(w, "solid_vertex_temperature", tv, 2, "K",
                                   "temperature inside solids", t));
done:
  UM_FREE(w->context, xyz, t, node, corner);
  return status;
}
