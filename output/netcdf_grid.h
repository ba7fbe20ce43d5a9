/* netCDF-4 files of arrays over named axes with a coordinate for each, as xarray and others want
 * them; made in memory, so that a full disk is an error of the stream. */
#ifndef UMBRA_OUTPUT_NETCDF_GRID_H
#define UMBRA_OUTPUT_NETCDF_GRID_H

#include <stdio.h>

#include "base/core/context.h"

#define UM_OUTPUT_GRID_AXES 8

struct um_output_grid {
  struct um_context *context;
  const char *name;              /* of the file, for messages; borrowed */
  int file;                      /* of the library */
  int axis[UM_OUTPUT_GRID_AXES]; /* dimensions, by the caller's numbers */
};

/* Begin a file; it is ended by _end where this succeeds. UM_ERR_IO. */
enum um_status um_output_grid_begin(struct um_context *context, const char *name,
                                    struct um_output_grid *out);
/* Write it to `file` where status is UM_OK, else let it go. Returns status, or what fails here. */
enum um_status um_output_grid_end(struct um_output_grid *grid, enum um_status status, FILE *file);

/* Axis number `which` of that name; nothing where its length is 0. */
enum um_status um_output_grid_axis(struct um_output_grid *grid, int which, const char *name,
                                   size_t length);
/* Text on the file. */
enum um_status um_output_grid_note(const struct um_output_grid *grid, const char *name,
                                   const char *text);
/* Variables, defined and written whole; the last axis moves first. units NULL: none. */
enum um_status um_output_grid_texts(const struct um_output_grid *grid, const char *name, int axis,
                                    const char *long_name, const char **text);
enum um_status um_output_grid_counts(const struct um_output_grid *grid, const char *name, int axis,
                                     const char *long_name, const int *value);
enum um_status um_output_grid_numbers(const struct um_output_grid *grid, const char *name,
                                      const int *axes, int naxis, const char *units,
                                      const char *long_name, const double *value);
/* The coordinate `time` of instants t_tai [s], as a UTC clock shows them (output/netcdf_times.c),
 * and `time_tai`. */
enum um_status um_output_grid_times(const struct um_output_grid *grid, int axis,
                                    const double *t_tai, size_t count);

#endif
