/* Groups of run.nc. Private to output/. */
#ifndef UMBRA_OUTPUT_NETCDF_IMPL_H
#define UMBRA_OUTPUT_NETCDF_IMPL_H

#include "output/output.h"

enum um_output_dimension {
  UM_NC_TIME,
  UM_NC_FACET,
  UM_NC_VERTEX,
  UM_NC_NODE,
  UM_NC_PLACE, /* "part": places, of which a part is one */
  UM_NC_MATERIAL,
  UM_NC_BAND,
  UM_NC_SENSOR,
  UM_NC_WAVELENGTH,
  UM_NC_MECHANISM,
  UM_NC_XYZ,
  UM_NC_CORNER,
  UM_NC_QUATERNION,
  UM_NC_SOLID_VERTEX, /* vertices and tetrahedra of all solids, one solid after the other */
  UM_NC_TETRAHEDRON,
  UM_NC_TETRAHEDRON_CORNER,
  UM_NC_COUNT
};

struct um_output_netcdf {
  struct um_context *context;
  const struct um_output_run *run;
  int file, dimension[UM_NC_COUNT];
  size_t length[UM_NC_COUNT]; /* 0: not in the file */
};

/* Begin run.nc in memory with the dimensions of w->run. The caller closes it where this succeeds.
 */
enum um_status um_output_netcdf_open(struct um_output_netcdf *w);
/* Write it to `file`; NULL: let it go. Errors of writing are the stream's. */
enum um_status um_output_netcdf_close(const struct um_output_netcdf *w, FILE *file);

/* Define a variable with its axes, unit and meaning, and write it whole. */
enum um_status um_output_netcdf_double(const struct um_output_netcdf *w, const char *name,
                                       const enum um_output_dimension *axes, int naxis,
                                       const char *units, const char *long_name,
                                       const double *values);
/* The same in single precision and as it stands, for what there may be a hundred million numbers
 * of: half of a spectrum's digits are noise, which takes seconds to compress to more bytes than
 * these.
 */
enum um_status um_output_netcdf_float(const struct um_output_netcdf *w, const char *name,
                                      const enum um_output_dimension *axes, int naxis,
                                      const char *units, const char *long_name,
                                      const double *values);
enum um_status um_output_netcdf_int(const struct um_output_netcdf *w, const char *name,
                                    const enum um_output_dimension *axes, int naxis,
                                    const char *long_name, const int *values);
/* An attribute of text on a variable; NULL: on the file. */
enum um_status um_output_netcdf_note(const struct um_output_netcdf *w, const char *variable,
                                     const char *name, const char *text);
/* A coordinate of names, called like its dimension, so that a reader can select by them. */
enum um_status um_output_netcdf_names(const struct um_output_netcdf *w,
                                      enum um_output_dimension axis, const char *long_name,
                                      const char *const *names);

enum um_status um_output_netcdf_times(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_geometry(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_heat(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_solids(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_light(const struct um_output_netcdf *w);

#endif
