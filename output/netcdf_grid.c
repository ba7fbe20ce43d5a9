/* Arrays over named axes in a netCDF-4 file. */
#include "output/netcdf_grid.h"

#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdlib.h>

#include "base/core/file.h"
#include "orbit/time.h"
#include "output/netcdf_text.h"

#define FIRST_SIZE 65536 /* of the image in memory, which grows [bytes] */

static enum um_status check(const struct um_output_grid *g, int code)
{
  UM_TRY(um_core_stop_check(g->context, "a netCDF file was written"));
  if (code == NC_NOERR) return UM_OK;
  return um_core_fail(g->context, UM_ERR_IO, "%s: netCDF: %s", g->name, nc_strerror(code));
}

static enum um_status note(const struct um_output_grid *g, int id, const char *name,
                           const char *text)
{
  return check(g, um_output_netcdf_text(g->file, id, name, text));
}

enum um_status um_output_grid_begin(struct um_context *context, const char *name,
                                    struct um_output_grid *g)
{
  *g = (struct um_output_grid){.context = context, .name = name};
  return check(g, nc_create_mem(name, NC_NETCDF4, FIRST_SIZE, &g->file));
}

enum um_status um_output_grid_end(struct um_output_grid *g, enum um_status status, FILE *file)
{
  NC_memio image = {0};
  int code = nc_close_memio(g->file, &image);
  if (status == UM_OK) status = check(g, code);
  if (status == UM_OK)
    status = um_core_file_write(g->context, g->name, image.memory, image.size, file);
  free(image.memory);
  return status;
}

enum um_status um_output_grid_axis(struct um_output_grid *g, int which, const char *name,
                                   size_t length)
{
  return length == 0 ? UM_OK : check(g, nc_def_dim(g->file, name, length, &g->axis[which]));
}

enum um_status um_output_grid_note(const struct um_output_grid *g, const char *name,
                                   const char *text)
{
  return note(g, NC_GLOBAL, name, text);
}

static enum um_status define(const struct um_output_grid *g, const char *name, nc_type type,
                             const int *axes, int naxis, const char *units, const char *long_name,
                             int *id)
{
  int dimension[UM_OUTPUT_GRID_AXES];
  for (int i = 0; i < naxis; i++) dimension[i] = g->axis[axes[i]];
  UM_TRY(check(g, nc_def_var(g->file, name, type, naxis, dimension, id)));
  if (units != NULL) UM_TRY(note(g, *id, "units", units));
  UM_TRY(note(g, *id, "long_name", long_name));
  if (naxis > 1 && type != NC_STRING) UM_TRY(check(g, nc_def_var_deflate(g->file, *id, 1, 1, 4)));
  return UM_OK;
}

enum um_status um_output_grid_texts(const struct um_output_grid *g, const char *name, int axis,
                                    const char *long_name, const char **text)
{
  int id;
  UM_TRY(define(g, name, NC_STRING, &axis, 1, NULL, long_name, &id));
  return check(g, nc_put_var_string(g->file, id, text));
}

enum um_status um_output_grid_counts(const struct um_output_grid *g, const char *name, int axis,
                                     const char *long_name, const int *value)
{
  int id;
  UM_TRY(define(g, name, NC_INT, &axis, 1, NULL, long_name, &id));
  return check(g, nc_put_var_int(g->file, id, value));
}

enum um_status um_output_grid_numbers(const struct um_output_grid *g, const char *name,
                                      const int *axes, int naxis, const char *units,
                                      const char *long_name, const double *value)
{
  int id;
  UM_TRY(define(g, name, NC_DOUBLE, axes, naxis, units, long_name, &id));
  return check(g, nc_put_var_double(g->file, id, value));
}

enum um_status um_output_grid_times(const struct um_output_grid *g, int axis, const double *t_tai,
                                    size_t count)
{
  enum um_status status;
  double *clock = NULL, day, mjd, seconds;
  char units[64], first[32];
  int id;
  UM_CHECK(um_core_allocate(g->context, count, sizeof *clock, &clock));
  um_orbit_time_utc_clock(t_tai[0], &day, &seconds);
  um_orbit_time_format(um_orbit_time_from_utc_jd(2400000.5, day + 0.5), first);
  for (size_t k = 0; k < count; k++) {
    um_orbit_time_utc_clock(t_tai[k], &mjd, &seconds);
    clock[k] = (mjd - day) * 86400.0 + seconds;
  }
  snprintf(units, sizeof units, "seconds since %.10s 00:00:00", first);
  UM_CHECK(define(g, "time", NC_DOUBLE, &axis, 1, units,
                  "UTC of mid-exposure at the observer, light received", &id));
  UM_CHECK(note(g, id, "standard_name", "time"));
  UM_CHECK(note(g, id, "calendar", "standard"));
  UM_CHECK(check(g, nc_put_var_double(g->file, id, clock)));
  UM_CHECK(um_output_grid_numbers(g, "time_tai", &axis, 1, "s",
                                  "TAI of mid-exposure since 2000-01-01T12:00:00 TAI", t_tai));
done:
  um_core_free(g->context, clock);
  return status;
}
