/* Result files of a run. Formats are described in docs/files.md. */
#ifndef UMBRA_OUTPUT_OUTPUT_H
#define UMBRA_OUTPUT_OUTPUT_H

#include "base/core/file.h"
#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "optics/image/image.h"

/* A finished run and what is said about it; everything borrowed. */
struct um_output_run {
  const struct um_model *model;
  const struct um_model_tables *tables;
  const struct um_model_result *result;
  const char *command; /* as typed, for the record */
  const char *version;
  const struct um_model_options *options; /* of the command line, for scenario.yaml; NULL: none */
  const char *log;            /* lines of log.txt before those that the context has; NULL: none */
  struct um_context *context; /* asked for a stop while files are written; NULL: none */
};

/* Write every file of a run into a folder in the making: lightcurve.csv, materials.csv,
 * temperatures.csv, heat.csv, temperatures.cic, run.nc, run.xdmf, scenario.yaml (as it was run, and
 * can be again where it stands), report.html, log.txt; with `pictures` those of um_output_plot_run.
 * Light-curve files only with an observer, counts.csv only with sensors. UM_ERR_IO and errors of
 * um_output_write_page. */
enum um_status um_output_write_run(struct um_context *context, const struct um_output_run *run,
                                   bool pictures, struct um_core_folder *folder);

/* Single files, to an open stream; used by um_output_write_run and by tests. */
enum um_status um_output_write_lightcurve(const struct um_output_run *run, FILE *file);
enum um_status um_output_write_counts(const struct um_output_run *run, FILE *file);
enum um_status um_output_write_materials(const struct um_output_run *run, FILE *file);
enum um_status um_output_write_temperatures(const struct um_output_run *run, FILE *file);
enum um_status um_output_write_heat(const struct um_output_run *run, FILE *file);
/* Mean temperature per material, generic data in the manner of CIC (integer MJD, seconds of day,
 * UTC; one line per instant). */
enum um_status um_output_write_cic(const struct um_output_run *run, FILE *file);

/* run.nc (netCDF-4) and run.xdmf beside it. run.nc is made in memory: HDF5 crashes at the end of
 * the process when the disk is full. The caller looks for errors of the stream, as with all of
 * these. */
enum um_status um_output_write_netcdf(struct um_context *context, const struct um_output_run *run,
                                      FILE *file);
enum um_status um_output_write_xdmf(const struct um_output_run *run, FILE *file);

/* Pictures of a finished folder as PNG, SVG and PDF, read from its CSV files by gnuplot: lightcurve
 * (every band with the Monte-Carlo error, magnitudes of those below 2.5 µm, shadow shaded) and
 * temperatures. A missing gnuplot is a logged warning, not an error. */
enum um_status um_output_plot_run(struct um_context *context, const char *folder,
                                  const struct um_output_run *run);

/* The satellite as seen in every band at several observations: satellite.png, .svg and .pdf in
 * `folder`, a row per band, a column per instant, all on one scale of length, each row on one of
 * band radiance [W/m^2/sr]; logarithmic over four decades where one picture outshines another
 * thirtyfold. Arrows show where Sun, celestial north and nadir lie, as long as they are across the
 * line of sight. panels[rows * columns]. UM_ERR_IO, UM_ERR_MEMORY. */
struct um_output_panel {
  const struct um_optics_image *image;
  const struct um_environment_sample *sample; /* its instant */
  const struct um_optics_band *band;
  size_t index; /* of the band in the picture */
  const char *caption;
};
enum um_status um_output_plot_panels(struct um_context *context,
                                     const struct um_output_panel *panels, size_t rows,
                                     size_t columns, const char *folder);

#endif
