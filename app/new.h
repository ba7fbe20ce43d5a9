/* A new scenario folder: its text in the making, and what goes into it. */
#ifndef UMBRA_APP_NEW_H
#define UMBRA_APP_NEW_H

#include <stdbool.h>

#include "app/station.h"
#include "base/core/file.h"
#include "geometry/obj_look.h"
#include "orbit/tle.h"

/* The text of a scenario is made of blocks with an empty line between them: lines of comment, then
 * a key of the highest level with its value. Put `value` (whole lines) in place of the value of
 * block `key`, and `comment` (whole lines; NULL: as it was) in place of its comment. *text is owned
 * by the caller and replaced. UM_ERR_INPUT where there is no such block, UM_ERR_MEMORY. */
enum um_status um_app_new_put(struct um_context *context, char **text, const char *key,
                              const char *comment, const char *value);

/* Records that were written beside the scenario. */
struct um_app_new_materials {
  char **name;           /* [n] of the records */
  char **file, **stands; /* [n]; what the mesh calls them */
  size_t n;
  bool metres; /* the mesh is of a format that has units */
};
/* Records of the optical properties that a mesh of STEP-TAS at `path` states, grey, of those that
 * are none of record[nrecord]; `from`: what the records say they are from. None of other meshes.
 * The caller clears. */
enum um_status um_app_new_materials(struct um_context *context, struct um_core_folder *folder,
                                    const char *path, const char *from, char *const *record,
                                    size_t nrecord, struct um_app_new_materials *out);
void um_app_new_materials_clear(struct um_context *context, struct um_app_new_materials *materials);

/* Blocks parts, contacts and thermal from the groups of an OBJ that stands beside the scenario
 * under `name`: a part for the groups that share edges, a material for each of them, the one that
 * its usemtl names where there is such a record, of the library's record[nrecord] or of `own`.
 * *scale [m per unit of the file] says what was made of it. UM_ERR_INPUT: a group of closed and
 * open pieces. */
enum um_status um_app_new_parts(struct um_context *context, char **text, const char *name,
                                const struct um_geometry_obj_look *look, char *const *record,
                                size_t nrecord, const struct um_app_new_materials *own,
                                double *scale);

/* The time of a scenario, taken from the passes of its station in the three days from `from` on
 * [t_tai, s], NaN for half a day before its own time: one that crosses the edge of the shadow in a
 * dark sky, high above the horizon, where there is one, else the next best, else ten minutes from
 * `from` on. */
struct um_app_new_window {
  double start, stop;    /* t_tai [s], whole seconds */
  bool seen, edge, dark; /* is there a pass; does it cross the shadow's edge; is the sky dark? */
  double highest;        /* [rad] above the horizon */
};
enum um_status um_app_new_window_find(struct um_context *context, const char *scenario, double from,
                                      struct um_app_new_window *out);
/* Block time of it. */
enum um_status um_app_new_window_put(struct um_context *context, char **text,
                                     const struct um_app_new_window *window);

#endif
