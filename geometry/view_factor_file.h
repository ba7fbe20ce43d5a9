/* View factors in files: a table that people and other programs read, taken in again where the
 * satellite is the one that they were made of.
 *
 *   record,pose,from,to,value,of
 *   surfaces,,,,4c2e...   hashes of what they were made of: facets and groups, positions, angles of
 *   ...                   joints, rays and gathering
 *   patch,,0,17,0.25,bus.+x     surface 17 of patch 0 and its area [m^2]; of a room, its facet
 *   exchange,0,0,3,0.0125,      exchange area of patches 0 and 3 [m^2] in pose 0, once for
 *                               both ways
 *   space,0,0,,0.2,             exchange area with space [m^2] */
#ifndef UMBRA_GEOMETRY_VIEW_FACTOR_FILE_H
#define UMBRA_GEOMETRY_VIEW_FACTOR_FILE_H

#include <stdio.h>

#include "geometry/view_factors.h"

/* View factors of all poses of a mesh. */
struct um_geometry_view_factor_set {
  const struct um_geometry *geometry;  /* for names */
  const struct um_geometry_mesh *mesh; /* of the satellite, or of the inside of a part */
  struct um_geometry_view_factor_key key;
  size_t npose;
  struct um_geometry_patches *patches;    /* NULL before they are read */
  struct um_geometry_view_factors **pose; /* [npose] */
  double interpolation;                   /* see view_factor_table.h [1] */
  bool closed;                            /* a room: nothing goes to space */
};

/* Key of a mesh and its poses: pose_add for every one, the first of them at rest. */
void um_geometry_view_factor_key_begin(const struct um_geometry_mesh *mesh,
                                       const struct um_geometry_pose *rest, size_t limit,
                                       const struct um_geometry_view_factor_options *options,
                                       struct um_geometry_view_factor_key *key);
void um_geometry_view_factor_key_pose(const struct um_geometry_mesh *mesh,
                                      const struct um_geometry_pose *pose,
                                      struct um_geometry_view_factor_key *key);

/* Errors of writing are the stream's. */
void um_geometry_view_factor_file_write(const struct um_geometry_view_factor_set *set, FILE *file);
/* Patches and poses of the set, which has none yet, as they were written, bit by bit. UM_ERR_INPUT
 * names what differs from what the set's key says, or what is wrong. own: rays and gathering must
 * be those of the key and rows must close; else rows that miss their sum by 5 % at most are closed.
 * What was read of a set that fails is destroyed. Tests: geometry/view_factor_file, fuzz. */
enum um_status um_geometry_view_factor_file_read(struct um_context *context, const char *path,
                                                 bool own, struct um_geometry_view_factor_set *set);
/* The same, as own ones, of a text that messages call `path`. */
enum um_status um_geometry_view_factor_file_parse(struct um_context *context, const char *path,
                                                  const char *text, size_t length,
                                                  struct um_geometry_view_factor_set *set);

/* The set from options->import/NAME.csv, which must be good, or from the cache; *found: it is
 * there. A file of the cache that is not good, by its checksum or by the laws of view factors, is
 * said in the log and made anew. */
enum um_status um_geometry_view_factor_find(struct um_context *context, const char *name,
                                            const struct um_geometry_view_factor_options *options,
                                            struct um_geometry_view_factor_set *set, bool *found);
/* Into the cache, where there is one; that it cannot be written is said in the log. */
enum um_status um_geometry_view_factor_keep(struct um_context *context, const char *name,
                                            const struct um_geometry_view_factor_options *options,
                                            const struct um_geometry_view_factor_set *set);

#endif
