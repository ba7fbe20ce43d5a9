/* Where a command may write: names of files, said before the computing begins. */
#ifndef UMBRA_APP_TARGET_H
#define UMBRA_APP_TARGET_H

#include "app/app.h"

/* Endings of what is written. A name without an ending takes what the command writes. */
#define UM_APP_PICTURES ".exr, .nc"
#define UM_APP_EXR      ".exr"
#define UM_APP_FRAMES   ".fits, .fit, .fts"
#define UM_APP_RECORDS  ".json"

/* From the last dot of a file's name on; "" where it has none. Borrowed. */
const char *um_app_ending(const char *path);
/* Refuse an existing file without --force. UM_ERR_IO. */
enum um_status um_app_check_target(struct um_context *context, const char *out, bool force);
/* The same for a table, which is CSV: not under the ending of a picture. UM_ERR_IO, UM_ERR_INPUT.
 */
enum um_status um_app_check_table(struct um_context *context, const struct um_app_options *options);
/* The same for a file that is renamed into place: a device and a folder that does not exist are
 * refused, too, and an ending that is not among `endings`. UM_ERR_IO, UM_ERR_INPUT. */
enum um_status um_app_check_whole(struct um_context *context, const char *out, bool force,
                                  const char *endings);
/* The same of what -o says. */
enum um_status um_app_check_picture(struct um_context *context,
                                    const struct um_app_options *options, const char *endings);
/* Has the path one of these endings? endings: ".exr, .nc"; capitals do not matter. */
bool um_app_ends_in(const char *path, const char *endings);
/* A name in .nc asks for a factored picture. */
bool um_app_is_cube(const char *path);

#endif
