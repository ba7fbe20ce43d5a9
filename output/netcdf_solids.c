/* run.nc: the inside of solids, one after the other: vertices of their tetrahedra with temperatures
 * over time. */
#include "output/netcdf_impl.h"
#include "output/solids_impl.h"
#include "thermal/network/tetgen.h"

size_t um_output_solid_vertices(const struct um_thermal_body *body)
{
  size_t n = 0;
  for (size_t i = 0; i < body->nsolid; i++) n += body->solid[i].mesh->nvertex;
  return n;
}

/* Positions, and the heat node of every vertex. */
static enum um_status put_vertices(const struct um_output_netcdf *w, double *xyz, int *node)
{
  const struct um_thermal_body *body = w->run->model->body;
  const enum um_output_dimension vx[2] = {UM_NC_SOLID_VERTEX, UM_NC_XYZ};
  size_t n = 0;
  for (size_t i = 0; i < body->nsolid; i++)
    for (size_t v = 0; v < body->solid[i].mesh->nvertex; v++, n++) {
      xyz[3 * n] = body->solid[i].mesh->vertex[v].x;
      xyz[3 * n + 1] = body->solid[i].mesh->vertex[v].y;
      xyz[3 * n + 2] = body->solid[i].mesh->vertex[v].z;
      node[n] = (int)body->solid[i].node[v];
    }
  UM_TRY(um_output_netcdf_double(w, "solid_vertex_position", vx, 2, "m",
                                 "body frame; parts on joints that follow the Sun at angle 0",
                                 xyz));
  return um_output_netcdf_int(w, "solid_vertex_node", vx, 1, "index into node of each vertex",
                              node);
}

/* Corners count through all solids. */
static enum um_status put_tetrahedra(const struct um_output_netcdf *w)
{
  const struct um_thermal_body *body = w->run->model->body;
  const enum um_output_dimension tc[2] = {UM_NC_TETRAHEDRON, UM_NC_TETRAHEDRON_CORNER};
  int *corner = NULL;
  size_t n = 0, first = 0;
  UM_TRY(um_core_allocate(w->context, 4 * body->ntetrahedron, sizeof *corner, &corner));
  for (size_t i = 0; i < body->nsolid; i++) {
    const struct um_thermal_tetrahedra *mesh = body->solid[i].mesh;
    for (size_t e = 0; e < mesh->ntetrahedron; e++)
      for (int c = 0; c < 4; c++) corner[n++] = (int)(first + mesh->corner[e][c]);
    first += mesh->nvertex;
  }
  enum um_status status =
      um_output_netcdf_int(w, "tetrahedron_vertex", tc, 2,
                           "index into solid_vertex of the corners of each tetrahedron", corner);
  um_core_free(w->context, corner);
  return status;
}

enum um_status um_output_netcdf_solids(const struct um_output_netcdf *w)
{
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension tv[2] = {UM_NC_TIME, UM_NC_SOLID_VERTEX};
  size_t n = w->length[UM_NC_SOLID_VERTEX];
  double *xyz = NULL, *t = NULL;
  int *node = NULL;
  enum um_status status = UM_OK;
  if (n == 0) return UM_OK;
  UM_CHECK(um_core_allocate(w->context, 3 * n, sizeof *xyz, &xyz));
  UM_CHECK(um_core_allocate(w->context, n, sizeof *node, &node));
  UM_CHECK(um_core_allocate(w->context, r->nobs * n, sizeof *t, &t));
  UM_CHECK(put_vertices(w, xyz, node));
  UM_CHECK(put_tetrahedra(w));
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t v = 0; v < n; v++)
      t[k * n + v] = r->node_temperature[k * r->nnode + (size_t)node[v]];
  UM_CHECK(um_output_netcdf_double(w, "solid_vertex_temperature", tv, 2, "K",
                                   "temperature inside solids", t));
done:
  UM_FREE(w->context, xyz, t, node);
  return status;
}
