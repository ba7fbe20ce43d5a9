/* run.nc: the mesh in body axes at the first observation, and materials and temperatures of the
 * two sides of every facet; `attitude` turns it. */
#include <math.h>
#include <string.h>

#include "output/bodies_impl.h"
#include "output/netcdf_impl.h"

/* Surface of one side of a facet, UM_GEOMETRY_NONE where that side does not radiate. */
static uint32_t side_surface(const struct um_geometry_mesh *mesh, size_t facet, int back)
{
  return back ? mesh->surface_of_back[facet] : mesh->surface_of_front[facet];
}

/* Materials and temperatures of the two sides of every facet; -1 and NaN where a side is none. */
static enum um_status put_sides(const struct um_output_netcdf *w)
{
  static const char *const names[2][4] = {
      {"front_material", "index into material of the front, -1 for none", "front_temperature",
       "temperature of the front"},
      {"back_material", "index into material of the back, -1 for none", "back_temperature",
       "temperature of the back"}};
  const struct um_geometry_mesh *mesh = um_geometry_mesh(w->run->model->geometry);
  const struct um_model_result *r = w->run->result;
  const enum um_output_dimension axes[2] = {UM_NC_TIME, UM_NC_FACET};
  enum um_status status;
  int *material = NULL;
  double *t = NULL;
  UM_TRY(um_core_allocate(w->context, mesh->nfacet, sizeof *material, &material));
  UM_CHECK(um_core_allocate(w->context, r->nobs * mesh->nfacet, sizeof *t, &t));
  for (int back = 0; back < 2; back++) {
    for (size_t f = 0; f < mesh->nfacet; f++) {
      uint32_t s = side_surface(mesh, f, back);
      material[f] = s == UM_GEOMETRY_NONE ? -1 : (int)mesh->surface[s].material;
      for (size_t k = 0; k < r->nobs; k++)
        t[k * mesh->nfacet + f] =
            s == UM_GEOMETRY_NONE ? (double)NAN : r->surface_temperature[k * r->nsurface + s];
    }
    UM_CHECK(um_output_netcdf_int(w, names[back][0], axes + 1, 1, names[back][1], material));
    UM_CHECK(um_output_netcdf_double(w, names[back][2], axes, 2, "K", names[back][3], t));
  }
done:
  UM_FREE(w->context, material, t);
  return status;
}

static enum um_status put_corners(const struct um_output_netcdf *w)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(w->run->model->geometry);
  const enum um_output_dimension fc[2] = {UM_NC_FACET, UM_NC_CORNER};
  int *corner = NULL;
  UM_TRY(um_core_allocate(w->context, 3 * mesh->nfacet, sizeof *corner, &corner));
  for (size_t i = 0; i < 3 * mesh->nfacet; i++) corner[i] = (int)mesh->corner[i / 3][i % 3];
  enum um_status status = um_output_netcdf_int(
      w, "facet_vertex", fc, 2, "index into vertex of the corners of each facet", corner);
  um_core_free(w->context, corner);
  return status;
}

/* Parts are numbered as places are, among which a part stands under its own name. */
static enum um_status put_parts(const struct um_output_netcdf *w)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(w->run->model->geometry);
  const enum um_output_dimension axis = UM_NC_FACET;
  size_t npart = um_geometry_part_count(w->run->model->geometry);
  int *facet = NULL, *place = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(w->context, mesh->nfacet, sizeof *facet, &facet));
  UM_CHECK(um_core_allocate(w->context, npart, sizeof *place, &place));
  for (size_t p = 0; p < npart; p++)
    place[p] = (int)um_thermal_body_place_find(w->run->model->body,
                                               um_geometry_part_name(w->run->model->geometry, p));
  for (size_t f = 0; f < mesh->nfacet; f++) facet[f] = place[mesh->facet_part[f]];
  UM_CHECK(um_output_netcdf_int(w, "facet_part", &axis, 1, "index into part of each facet", facet));
done:
  UM_FREE(w->context, facet, place);
  return status;
}

enum um_status um_output_netcdf_geometry(const struct um_output_netcdf *w)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(w->run->model->geometry);
  double *xyz = NULL;
  const enum um_output_dimension vx[2] = {UM_NC_VERTEX, UM_NC_XYZ}, f = UM_NC_FACET;
  UM_CHECK(um_core_allocate(w->context, 3 * mesh->nvertex, sizeof *xyz, &xyz));
  UM_CHECK(um_output_vertices(w->context, w->run, 0, xyz));
  UM_CHECK(um_output_netcdf_double(w, "vertex_position", vx, 2, "m",
                                   "body frame, at the first observation", xyz));
  UM_CHECK(put_corners(w));
  UM_CHECK(um_output_netcdf_double(w, "facet_area", &f, 1, "m2", "area of one side", mesh->area));
  UM_CHECK(put_parts(w));
  UM_CHECK(put_sides(w));
done:
  um_core_free(w->context, xyz);
  return status;
}
