/* Files of a reflectivity map. Formats are described in docs/files.md. */
#ifndef UMBRA_OUTPUT_MAP_H
#define UMBRA_OUTPUT_MAP_H

#include "base/core/file.h"
#include "model/products/map_error.h"
#include "model/products/reflectivity_pass.h"

/* What is written and drawn; everything borrowed. */
struct um_output_map {
  const struct um_model *model;
  const struct um_model_map *map;
  const struct um_model_map_error *error;
  const struct um_model_map_pass *pass; /* NULL: none */
  bool measured; /* measured.csv lies in the folder (evidence/inversion/on_map.h) */
};

/* refined.csv: every node that was added to the grid, in its plane. error.csv: how far looking up
 * is off. */
enum um_status um_output_write_map_refined(struct um_context *context,
                                           const struct um_output_map *of, FILE *file);
enum um_status um_output_write_map_error(struct um_context *context, const struct um_output_map *of,
                                         FILE *file);
/* map.csv: every node of the grid with the mean over its planes. */
enum um_status um_output_write_map(struct um_context *context, const struct um_output_map *of,
                                   FILE *file);
/* pass.csv: the pass on the map, looked up and computed. */
enum um_status um_output_write_map_pass(struct um_context *context, const struct um_output_map *of,
                                        FILE *file);
/* map.exr: north on top, longitude -180 at the left; per band and phase angle the mean over the
 * planes and the spread [m^2/sr]; R, G, B show the first of them, scaled to its largest. */
enum um_status um_output_write_map_exr(struct um_context *context, const struct um_output_map *of,
                                       const char *path);
/* Columns of measured.csv before the bands, and of each band. */
#define UM_OUTPUT_MEASURED_FIRST 8
#define UM_OUTPUT_MEASURED_BAND  3
/* Pictures of a finished folder, from its tables. map.png, .svg and .pdf: a row per band, a column
 * for up to three of the phase angles; on each the instants of the pass, and the measurements in
 * the colours of the map, whose phase angle is nearest to it. pass.png: the light curve, looked up
 * and computed. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_plot_map(struct um_context *context, const struct um_output_map *of,
                                  const char *folder);

#endif
