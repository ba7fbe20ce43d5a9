/* Messages with file, line and key, and what a name may be. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_FAIL_GROUP_H
#define UMBRA_MODEL_FAIL_GROUP_H

#include "base/core/context.h"
#include "base/document/schema.h"

/* Put "file:line: path.key: " before the recorded message, with the line of the key where the
 * mapping has it; key NULL: the mapping itself. Returns status. */
enum um_status um_model_blame(struct um_context *context, const struct um_mark *at, const char *key,
                              enum um_status status);
/* Record "file:line: path.key: message" and return UM_ERR_INPUT. */
enum um_status um_model_fail(struct um_context *context, const struct um_mark *at, const char *key,
                             const char *format, ...) UM_PRINTF(4, 5);
/* True for a name that can stand in a CSV header, in a key path and in a netCDF name: not empty, no
 * control characters, none of . / : , ; ' " and backslash. */
bool um_model_name_is_plain(const char *name);

#endif
