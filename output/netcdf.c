/* Dimensions and variables of run.nc, with units and meaning; netCDF-4 (HDF5) in memory. */
#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdlib.h>
#include <string.h>

#include "output/bodies_impl.h"
#include "output/netcdf_impl.h"
#include "output/netcdf_text.h"

#define FIRST_SIZE 65536 /* of the image in memory, which grows [bytes] */
#define AXES_MAX   4

static const char *const dimension_names[UM_NC_COUNT] = {[UM_NC_TIME] = "time",
                                                         [UM_NC_FACET] = "facet",
                                                         [UM_NC_VERTEX] = "vertex",
                                                         [UM_NC_NODE] = "node",
                                                         [UM_NC_PLACE] = "part",
                                                         [UM_NC_MATERIAL] = "material",
                                                         [UM_NC_BAND] = "band",
                                                         [UM_NC_SENSOR] = "sensor",
                                                         [UM_NC_WAVELENGTH] = "wavelength",
                                                         [UM_NC_MECHANISM] = "mechanism",
                                                         [UM_NC_XYZ] = "xyz",
                                                         [UM_NC_CORNER] = "corner",
                                                         [UM_NC_QUATERNION] = "quaternion",
                                                         [UM_NC_SOLID_VERTEX] = "solid_vertex",
                                                         [UM_NC_TETRAHEDRON] = "tetrahedron",
                                                         [UM_NC_TETRAHEDRON_CORNER] =
                                                             "tetrahedron_corner"};

static enum um_status check(const struct um_output_netcdf *w, int code)
{
  UM_TRY(um_core_stop_check(w->context, "run.nc was written"));
  if (code == NC_NOERR) return UM_OK;
  return um_core_fail(w->context, UM_ERR_IO, "run.nc: netCDF: %s", nc_strerror(code));
}

/* packed: compressed, where there is more than one axis. */
static enum um_status define(const struct um_output_netcdf *w, const char *name, nc_type type,
                             bool packed, const enum um_output_dimension *axes, int naxis,
                             const char *units, const char *long_name, int *id)
{
  int dimension[AXES_MAX];
  for (int i = 0; i < naxis; i++) dimension[i] = w->dimension[axes[i]];
  UM_TRY(check(w, nc_def_var(w->file, name, type, naxis, dimension, id)));
  UM_TRY(check(w, um_output_netcdf_text(w->file, *id, "units", units)));
  UM_TRY(check(w, um_output_netcdf_text(w->file, *id, "long_name", long_name)));
  if (packed && naxis > 1) UM_TRY(check(w, nc_def_var_deflate(w->file, *id, 1, 1, 4)));
  return UM_OK;
}

static enum um_status numbers(const struct um_output_netcdf *w, const char *name, nc_type type,
                              bool packed, const enum um_output_dimension *axes, int naxis,
                              const char *units, const char *long_name, const double *values)
{
  int id;
  UM_TRY(define(w, name, type, packed, axes, naxis, units, long_name, &id));
  return check(w, nc_put_var_double(w->file, id, values));
}

enum um_status um_output_netcdf_double(const struct um_output_netcdf *w, const char *name,
                                       const enum um_output_dimension *axes, int naxis,
                                       const char *units, const char *long_name,
                                       const double *values)
{
  return numbers(w, name, NC_DOUBLE, true, axes, naxis, units, long_name, values);
}

enum um_status um_output_netcdf_float(const struct um_output_netcdf *w, const char *name,
                                      const enum um_output_dimension *axes, int naxis,
                                      const char *units, const char *long_name,
                                      const double *values)
{
  return numbers(w, name, NC_FLOAT, false, axes, naxis, units, long_name, values);
}

enum um_status um_output_netcdf_int(const struct um_output_netcdf *w, const char *name,
                                    const enum um_output_dimension *axes, int naxis,
                                    const char *long_name, const int *values)
{
  int id;
  UM_TRY(define(w, name, NC_INT, true, axes, naxis, "1", long_name, &id));
  return check(w, nc_put_var_int(w->file, id, values));
}

enum um_status um_output_netcdf_note(const struct um_output_netcdf *w, const char *variable,
                                     const char *name, const char *text)
{
  int id = NC_GLOBAL;
  if (variable != NULL) UM_TRY(check(w, nc_inq_varid(w->file, variable, &id)));
  return check(w, um_output_netcdf_text(w->file, id, name, text));
}

enum um_status um_output_netcdf_names(const struct um_output_netcdf *w,
                                      enum um_output_dimension axis, const char *long_name,
                                      const char *const *names)
{
  int id;
  UM_TRY(define(w, dimension_names[axis], NC_STRING, false, &axis, 1, "1", long_name, &id));
  const char **borrowed = NULL; /* the library does not write through them */
  UM_TRY(um_core_allocate(w->context, w->length[axis], sizeof *borrowed, &borrowed));
  memcpy(borrowed, names, w->length[axis] * sizeof *borrowed);
  enum um_status status = check(w, nc_put_var_string(w->file, id, borrowed));
  um_core_free(w->context, borrowed);
  return status;
}

static enum um_status define_dimensions(struct um_output_netcdf *w)
{
  const struct um_model *model = w->run->model;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  const struct um_model_result *r = w->run->result;
  const size_t length[UM_NC_COUNT] = {
      [UM_NC_TIME] = r->nobs,
      [UM_NC_FACET] = mesh->nfacet,
      [UM_NC_VERTEX] = mesh->nvertex,
      [UM_NC_NODE] = r->nnode,
      [UM_NC_PLACE] = r->nplace,
      [UM_NC_MATERIAL] = um_geometry_material_count(model->geometry),
      [UM_NC_BAND] = r->nband,
      [UM_NC_SENSOR] = r->nsensor,
      [UM_NC_WAVELENGTH] = r->nbin,
      [UM_NC_MECHANISM] = r->nband > 0 ? UM_MECHANISM_COUNT : 0,
      [UM_NC_XYZ] = 3,
      [UM_NC_CORNER] = 3,
      [UM_NC_QUATERNION] = 4,
      [UM_NC_SOLID_VERTEX] = um_output_solid_vertices(model->body),
      [UM_NC_TETRAHEDRON] = model->body->ntetrahedron,
      [UM_NC_TETRAHEDRON_CORNER] = model->body->ntetrahedron > 0 ? 4 : 0};
  memcpy(w->length, length, sizeof length);
  for (int i = 0; i < UM_NC_COUNT; i++)
    if (length[i] > 0)
      UM_TRY(check(w, nc_def_dim(w->file, dimension_names[i], length[i], &w->dimension[i])));
  return UM_OK;
}

enum um_status um_output_netcdf_open(struct um_output_netcdf *w)
{
  UM_TRY(check(w, nc_create_mem("run.nc", NC_NETCDF4, FIRST_SIZE, &w->file)));
  enum um_status status = define_dimensions(w);
  if (status != UM_OK) (void)um_output_netcdf_close(w, NULL);
  return status;
}

enum um_status um_output_netcdf_close(const struct um_output_netcdf *w, FILE *file)
{
  NC_memio image = {0};
  enum um_status status = check(w, nc_close_memio(w->file, &image));
  if (file != NULL && status == UM_OK) (void)fwrite(image.memory, 1, image.size, file);
  free(image.memory);
  return status;
}
