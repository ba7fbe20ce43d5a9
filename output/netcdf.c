/* run.nc: everything of a run with units and axes, netCDF-4 (HDF5). Body-frame geometry is that of
 * the first observation; `quaternion` turns it. */
#include <math.h>
#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdlib.h>
#include <string.h>

#include "output/output.h"

#define FIRST_SIZE 65536 /* of the image in memory, which grows [bytes] */

enum dimension {
  TIME,
  FACET,
  VERTEX,
  NODE,
  PLACE,
  MATERIAL,
  BAND,
  WAVELENGTH,
  MECHANISM,
  XYZ,
  CORNER,
  QUATERNION,
  NAME,
  NDIM
};
static const char *const dimension_names[NDIM] = {
    [TIME] = "time",           [FACET] = "facet",
    [VERTEX] = "vertex",       [NODE] = "node",
    [PLACE] = "part",          [MATERIAL] = "material",
    [BAND] = "band",           [WAVELENGTH] = "wavelength",
    [MECHANISM] = "mechanism", [XYZ] = "xyz",
    [CORNER] = "corner",       [QUATERNION] = "quaternion",
    [NAME] = "name_length"};

struct writer {
  struct um_context *context;
  int file, dimension[NDIM];
  size_t length[NDIM];
};

static enum um_status check(const struct writer *w, int code)
{
  if (code == NC_NOERR) return UM_OK;
  return um_core_fail(w->context, UM_ERR_IO, "run.nc: netCDF: %s", nc_strerror(code));
}

/* Define a variable with its axes, unit and meaning. */
static enum um_status define(const struct writer *w, const char *name, nc_type type,
                             const enum dimension *axes, int naxis, const char *units,
                             const char *long_name, int *id)
{
  int dimension[4];
  for (int i = 0; i < naxis; i++) dimension[i] = w->dimension[axes[i]];
  UM_TRY(check(w, nc_def_var(w->file, name, type, naxis, dimension, id)));
  UM_TRY(check(w, nc_put_att_text(w->file, *id, "units", strlen(units), units)));
  UM_TRY(check(w, nc_put_att_text(w->file, *id, "long_name", strlen(long_name), long_name)));
  if (naxis > 1 && type != NC_CHAR) UM_TRY(check(w, nc_def_var_deflate(w->file, *id, 1, 1, 4)));
  return UM_OK;
}

static enum um_status put_double(const struct writer *w, const char *name,
                                 const enum dimension *axes, int naxis, const char *units,
                                 const char *long_name, const double *values)
{
  int id;
  UM_TRY(define(w, name, NC_DOUBLE, axes, naxis, units, long_name, &id));
  return check(w, nc_put_var_double(w->file, id, values));
}

static enum um_status put_index(const struct writer *w, const char *name,
                                const enum dimension *axes, int naxis, const char *long_name,
                                const uint32_t *values)
{
  int id;
  UM_TRY(define(w, name, NC_UINT, axes, naxis, "1", long_name, &id));
  return check(w, nc_put_var_uint(w->file, id, values));
}

typedef const char *(*name_of)(const struct um_output_run *run, size_t i);

static enum um_status put_names(const struct writer *w, const struct um_output_run *run,
                                const char *name, enum dimension axis, const char *long_name,
                                name_of get)
{
  int id;
  const enum dimension axes[2] = {axis, NAME};
  UM_TRY(define(w, name, NC_CHAR, axes, 2, "1", long_name, &id));
  char *text = NULL; /* all names, filled up with zeros */
  size_t width = w->length[NAME];
  UM_TRY(um_core_allocate(w->context, w->length[axis], width, &text));
  for (size_t i = 0; i < w->length[axis]; i++)
    memcpy(text + i * width, get(run, i), strlen(get(run, i)));
  enum um_status status = check(w, nc_put_var_text(w->file, id, text));
  um_core_free(w->context, text);
  return status;
}

static const char *place_name(const struct um_output_run *run, size_t i)
{
  return run->result->place[i].name;
}
static const char *material_name(const struct um_output_run *run, size_t i)
{
  return um_geometry_material_name(run->model->geometry, i);
}
static const char *band_name(const struct um_output_run *run, size_t i)
{
  return run->model->band[i].name;
}
static const char *mechanism_name(const struct um_output_run *run, size_t i)
{
  static const char *const names[] = {"sun", "earth", "emitted", "interreflected", "other"};
  (void)run;
  return names[i];
}

/* Longest of the names. */
static size_t longest(const struct um_output_run *run, size_t n, name_of get, size_t least)
{
  for (size_t i = 0; i < n; i++)
    if (strlen(get(run, i)) > least) least = strlen(get(run, i));
  return least;
}

/* Width of the name variables: the longest name and the zero behind it. */
static size_t name_length(const struct um_output_run *run)
{
  const struct um_model_result *r = run->result;
  size_t n = longest(run, UM_MECHANISM_COUNT, mechanism_name, 0);
  n = longest(run, r->nplace, place_name, n);
  n = longest(run, r->nmaterial, material_name, n);
  return longest(run, r->nband, band_name, n) + 1;
}

static enum um_status define_dimensions(struct writer *w, const struct um_output_run *run)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_model_result *r = run->result;
  const size_t length[NDIM] = {[TIME] = r->nobs,
                               [FACET] = mesh->nfacet,
                               [VERTEX] = mesh->nvertex,
                               [NODE] = r->nnode,
                               [PLACE] = r->nplace,
                               [MATERIAL] = r->nmaterial,
                               [BAND] = r->nband,
                               [WAVELENGTH] = r->nbin,
                               [MECHANISM] = UM_MECHANISM_COUNT,
                               [XYZ] = 3,
                               [CORNER] = 3,
                               [QUATERNION] = 4,
                               [NAME] = name_length(run)};
  memcpy(w->length, length, sizeof length);
  for (int i = 0; i < NDIM; i++)
    if (length[i] > 0)
      UM_TRY(check(w, nc_def_dim(w->file, dimension_names[i], length[i], &w->dimension[i])));
  return UM_OK;
}

static enum um_status put_attributes(const struct writer *w, const struct um_output_run *run)
{
  char *scenario = NULL;
  UM_TRY(um_core_document_text(w->context, run->model->document, &scenario));
  const char *text[][2] = {{"Conventions", "CF-1.8"}, {"title", run->model->scenario->name},
                           {"source", "umbra"},       {"version", run->version},
                           {"command", run->command}, {"scenario", scenario}};
  enum um_status status = UM_OK;
  for (size_t i = 0; status == UM_OK && i < sizeof text / sizeof text[0]; i++)
    status =
        check(w, nc_put_att_text(w->file, NC_GLOBAL, text[i][0], strlen(text[i][1]), text[i][1]));
  um_core_free(w->context, scenario);
  return status;
}

static enum um_status put_times(const struct writer *w, const struct um_output_run *run)
{
  enum um_status status;
  const struct um_model_trace *trace = run->trace;
  size_t n = trace->nobs;
  double *v = NULL;
  const enum dimension t = TIME, tq[2] = {TIME, QUATERNION}, tx[2] = {TIME, XYZ};
  UM_TRY(um_core_allocate(w->context, 4 * n, sizeof *v, &v));
  UM_CHECK(put_double(w, "time", &t, 1, "seconds since 2000-01-01 12:00:00",
                      "mid-exposure at the observer, light received, both counted in TAI",
                      trace->t_obs));
  UM_CHECK(put_double(w, "sunlit_fraction", &t, 1, "1", "sunlit fraction of the solar disc",
                      trace->sunlit));
  for (size_t k = 0; k < n; k++) {
    struct um_quat q = trace->sample[k * trace->nsub + trace->nsub / 2].q;
    const double c[4] = {q.w, q.x, q.y, q.z};
    memcpy(v + 4 * k, c, sizeof c);
  }
  UM_CHECK(
      put_double(w, "attitude", tq, 2, "1", "quaternion GCRS to body, scalar first, passive", v));
  for (int which = 0; which < 3; which++) {
    static const char *const names[3][3] = {
        {"position", "m", "satellite, GCRS"},
        {"sun_direction", "1", "satellite to Sun, GCRS, apparent"},
        {"observer_direction", "1", "satellite to observer, GCRS"}};
    for (size_t k = 0; k < n; k++) {
      const struct um_environment_sample *s = &trace->sample[k * trace->nsub + trace->nsub / 2];
      struct um_vec3 x = which == 0 ? s->r : which == 1 ? s->sun : s->to_observer;
      v[3 * k] = x.x;
      v[3 * k + 1] = x.y;
      v[3 * k + 2] = x.z;
    }
    UM_CHECK(put_double(w, names[which][0], tx, 2, names[which][1], names[which][2], v));
  }
  for (size_t k = 0; k < n; k++) v[k] = trace->sample[k * trace->nsub + trace->nsub / 2].range;
  UM_CHECK(put_double(w, "range", &t, 1, "m", "satellite to observer", v));
done:
  um_core_free(w->context, v);
  return status;
}

/* Surface of one side of a facet, UM_GEOMETRY_NONE where that side does not radiate. */
static uint32_t side_surface(const struct um_geometry_mesh *mesh, size_t facet, int back)
{
  return back ? mesh->surface_of_back[facet] : mesh->surface_of_front[facet];
}

/* Materials and temperatures of the two sides of every facet; -1 and NaN where a side is none. */
static enum um_status put_sides(const struct writer *w, const struct um_output_run *run)
{
  static const char *const names[2][4] = {{"front_material", "material of the front, -1 for none",
                                           "front_temperature", "temperature of the front"},
                                          {"back_material", "material of the back, -1 for none",
                                           "back_temperature", "temperature of the back"}};
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_model_result *r = run->result;
  const enum dimension axes[2] = {TIME, FACET};
  enum um_status status;
  int *material = NULL, id;
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
    UM_CHECK(define(w, names[back][0], NC_INT, axes + 1, 1, "1", names[back][1], &id));
    UM_CHECK(check(w, nc_put_var_int(w->file, id, material)));
    UM_CHECK(put_double(w, names[back][2], axes, 2, "K", names[back][3], t));
  }
done:
  um_core_free(w->context, material);
  um_core_free(w->context, t);
  return status;
}

static enum um_status put_geometry(const struct writer *w, const struct um_output_run *run)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  size_t njoint = um_geometry_joint_count(run->model->geometry);
  struct um_geometry_pose *pose = NULL;
  double *angles = NULL, *xyz = NULL;
  const enum dimension vx[2] = {VERTEX, XYZ}, fc[2] = {FACET, CORNER}, f = FACET;
  const struct um_environment_sample *first = &run->trace->sample[run->trace->nsub / 2];
  UM_CHECK(um_core_allocate(w->context, njoint, sizeof *angles, &angles));
  um_geometry_joint_angles(run->model->geometry, um_quat_apply(first->q, first->sun), angles);
  UM_CHECK(um_geometry_pose_create(w->context, run->model->geometry, angles, &pose));
  UM_CHECK(um_core_allocate(w->context, 3 * mesh->nvertex, sizeof *xyz, &xyz));
  for (size_t i = 0; i < mesh->nvertex; i++) {
    xyz[3 * i] = pose->vertex[i].x;
    xyz[3 * i + 1] = pose->vertex[i].y;
    xyz[3 * i + 2] = pose->vertex[i].z;
  }
  UM_CHECK(
      put_double(w, "vertex_position", vx, 2, "m", "body frame, at the first observation", xyz));
  UM_CHECK(put_index(w, "facet_vertex", fc, 2, "corners of each facet", mesh->corner[0]));
  UM_CHECK(put_double(w, "facet_area", &f, 1, "m2", "area of one side", mesh->area));
  UM_CHECK(put_index(w, "facet_part", &f, 1, "index of the part of each facet", mesh->facet_part));
  UM_CHECK(put_sides(w, run));
done:
  um_core_free(w->context, angles);
  um_core_free(w->context, xyz);
  um_geometry_pose_destroy(w->context, &pose);
  return status;
}

static enum um_status put_temperatures(const struct writer *w, const struct um_output_run *run)
{
  const struct um_model_result *r = run->result;
  enum um_status status;
  double *v = NULL;
  const enum dimension tn[2] = {TIME, NODE}, tp[2] = {TIME, PLACE};
  UM_TRY(put_names(w, run, "part_name", PLACE, "parts, sides, groups, interiors and materials",
                   place_name));
  UM_TRY(put_double(w, "node_temperature", tn, 2, "K", "temperature of each heat node",
                    r->node_temperature));
  UM_TRY(um_core_allocate(w->context, r->nobs * r->nplace, sizeof *v, &v));
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t p = 0; p < r->nplace; p++) v[k * r->nplace + p] = r->place[p].mean[k];
  status = put_double(w, "part_temperature", tp, 2, "K", "mean temperature", v);
  um_core_free(w->context, v);
  return status;
}

static enum um_status put_light(const struct writer *w, const struct um_output_run *run)
{
  const struct um_model_result *r = run->result;
  const enum dimension b = BAND, wl = WAVELENGTH, m = MATERIAL, k = MECHANISM;
  const enum dimension tb[2] = {TIME, BAND}, twk[3] = {TIME, WAVELENGTH, MECHANISM};
  const enum dimension tbmk[4] = {TIME, BAND, MATERIAL, MECHANISM};
  if (r->nband == 0) return UM_OK;
  UM_TRY(put_names(w, run, "band_name", b, "spectral bands", band_name));
  UM_TRY(put_names(w, run, "material_name", m, "materials", material_name));
  UM_TRY(put_names(w, run, "mechanism_name", k, "how the light comes about", mechanism_name));
  UM_TRY(put_double(w, "wavelength", &wl, 1, "m", "centre of each bin", r->wavelength));
  UM_TRY(put_double(w, "wavelength_width", &wl, 1, "m", "width of each bin", r->bin_width));
  UM_TRY(put_index(w, "wavelength_band", &wl, 1, "band of each bin", r->bin_band));
  UM_TRY(put_double(w, "irradiance", tb, 2, "W m-2", "at the aperture", r->irradiance));
  UM_TRY(put_double(w, "magnitude_ab", tb, 2, "mag", "AB magnitude", r->magnitude_ab));
  UM_TRY(put_double(w, "standard_error", tb, 2, "W sr-1", "Monte-Carlo error of the intensity",
                    r->standard_error));
  UM_TRY(put_double(w, "intensity", tbmk, 4, "W sr-1", "radiant intensity toward the observer",
                    r->intensity));
  return put_double(w, "spectral_intensity", twk, 3, "W sr-1 m-1",
                    "spectral radiant intensity toward the observer", r->spectral);
}

enum um_status um_output_write_netcdf(struct um_context *context, const struct um_output_run *run,
                                      FILE *file)
{
  struct writer w = {.context = context};
  NC_memio image = {0};
  enum um_status status;
  UM_TRY(check(&w, nc_create_mem("run.nc", NC_NETCDF4, FIRST_SIZE, &w.file)));
  UM_CHECK(define_dimensions(&w, run));
  UM_CHECK(put_attributes(&w, run));
  UM_CHECK(put_times(&w, run));
  UM_CHECK(put_geometry(&w, run));
  UM_CHECK(put_temperatures(&w, run));
  UM_CHECK(put_light(&w, run));
done:;
  enum um_status closed = check(&w, nc_close_memio(w.file, &image));
  if (status == UM_OK && closed == UM_OK) (void)fwrite(image.memory, 1, image.size, file);
  free(image.memory);
  return status != UM_OK ? status : closed;
}
