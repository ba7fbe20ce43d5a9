/* Sunlight that mirrors of the satellite send on to its other surfaces, and how bright the Earth
 * stands in every direction, for what surfaces see of it in mirrors: geometry alone, whatever the
 * mirrors reflect (geometry/mirrors.h). Linear between times, like the loads beside it. */
#ifndef UMBRA_IRRADIATION_MIRRORED_H
#define UMBRA_IRRADIATION_MIRRORED_H

#include "geometry/mirror_paths.h"
#include "thermal/loads/loads.h"

/* Of the sunlight that falls on patch `from`, a mirror, the share whose mirrored ray comes upon
 * patch `to`, directly or behind the further mirrors of a set. */
struct um_irradiation_mirrored_sun {
  uint32_t from, to, sets;
  float share; /* [1] */
};

struct um_irradiation_mirrored {
  size_t ntime;
  struct um_geometry_mirror_sets sets;
  size_t *begin;                           /* [ntime + 1] */
  struct um_irradiation_mirrored_sun *sun; /* by time, from, to, set */
  float *albedo; /* [ntime][UM_GEOMETRY_SKY_CELLS] radiance reflected by the Earth, mean over the
                    cell of the body's cube [W/m^2/sr] */
  float *planet; /* the same of what it emits */
};

/* What is asked for beside a table of loads: its own geometry, samples [loads->ntime], attitudes of
 * a turn (NULL: those of the samples). */
struct um_irradiation_mirrored_options {
  const struct um_irradiation_spin *spin;
  size_t points; /* on each patch that mirrors, spread by area */
};

/* patches and mirrors of the geometry. The Earth of each cell is that of the nearest direction of
 * the cap (um_environment_earth_cap), times the share of the cell that it fills by nine of its
 * directions: rms 0.04 of the cell, 1/6 at most. Progress is reported; the same bits for any number
 * of threads. UM_ERR_INPUT: no points; errors of um_irradiation_loads_trace. The caller destroys.
 * Test: thermal/loads/mirrored. */
enum um_status um_irradiation_mirrored_trace(
    struct um_context *context, const struct um_geometry *geometry,
    const struct um_environment *environment, const struct um_environment_sample *samples,
    const struct um_irradiation_loads *loads, const struct um_geometry_patches *patches,
    const struct um_geometry_mirrors *mirrors,
    const struct um_irradiation_mirrored_options *options, struct um_irradiation_mirrored **out);
/* The same with an Earth of other levels, as um_irradiation_loads_scaled. UM_ERR_MEMORY. The caller
 * destroys. */
enum um_status um_irradiation_mirrored_scaled(struct um_context *context,
                                              const struct um_irradiation_mirrored *mirrored,
                                              const struct um_irradiation_levels *by,
                                              struct um_irradiation_mirrored **out);
void um_irradiation_mirrored_destroy(struct um_context *context,
                                     struct um_irradiation_mirrored **mirrored);

#endif
