/* View factors over the angles of joints: poses on a lattice of angles, interpolated between. */
#ifndef UMBRA_GEOMETRY_VIEW_FACTOR_TABLE_H
#define UMBRA_GEOMETRY_VIEW_FACTOR_TABLE_H

#include <stdio.h>

#include "geometry/mirror_paths.h"

/* The inside of a closed part, the same in every pose. */
struct um_geometry_room {
  uint32_t part;
  size_t first; /* of its patches in the table */
  struct um_geometry_view_factor_key key;
  struct um_geometry_view_factors *factors; /* which count them from 0 */
};

struct um_geometry_view_factor_table {
  struct um_geometry_patches *patches; /* of the outside, then of the rooms */
  size_t nsurface;                     /* of the outside */
  size_t noutside;                     /* patches of the outside: those of the poses */
  struct um_geometry_room *room;       /* [nroom], see geometry/inside.h */
  size_t nroom;
  size_t npose;
  struct um_geometry_view_factors **pose; /* [npose] */
  size_t ntime, ncorner;
  uint32_t *corner; /* [ntime][ncorner] pose */
  double *weight;   /* [ntime][ncorner] of it, sum 1; 0 where a corner is not used [1] */
  double step;      /* between poses [rad]; 0: nothing moves */
  struct um_geometry_mirrors *mirrors;        /* of the options, a copy; NULL: none, or none that
                                                 another patch sees */
  struct um_geometry_mirror_paths **mirrored; /* [npose] NULL where a pose has none; NULL: none */
  struct um_geometry_view_factor_key key;
  double interpolation; /* estimate of the largest error of a view factor between poses [1] */
};

/* Of the outside. angles: [ntime][njoint] [rad], the joints' angles at times that are asked for;
 * NULL with ntime 1 where there is no joint. Poses stand 15 deg apart, or so much farther that
 * there are at most 64; those that some time needs are traced. Between them exchange areas are
 * linear in the angle of each joint (in a simplex of the lattice where several move), so that they
 * stay closed and reciprocal; the error is judged by second differences. Where the options name
 * mirrors, their paths are traced in every pose. limit: of patches, see
 * um_geometry_patches_create. Progress is reported. The caller destroys. Test:
 * geometry/view_factor_table. */
enum um_status
um_geometry_view_factor_table_create(struct um_context *context, const struct um_geometry *geometry,
                                     const double *angles, size_t ntime, size_t limit,
                                     const struct um_geometry_view_factor_options *options,
                                     struct um_geometry_view_factor_table **out);
/* Those of the outside as a file (view_factor_file.h); errors of writing are the stream's. */
void um_geometry_view_factor_table_write(const struct um_geometry *geometry,
                                         const struct um_geometry_view_factor_table *table,
                                         FILE *file);
void um_geometry_view_factor_table_destroy(struct um_context *context,
                                           struct um_geometry_view_factor_table **table);

#endif
