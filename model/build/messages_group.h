/* What the steps of building share: paths, messages with file and line of a part or table,
 * directions. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_MESSAGES_GROUP_H
#define UMBRA_MODEL_MESSAGES_GROUP_H

#include "model/build/model.h"
#include "model/scenario/fail_group.h"

/* Path relative to the file of a mark; owned by the document. */
enum um_status um_model_resolve(struct um_context *context, struct um_model *model,
                                const struct um_mark *at, const char *relative, const char **out);
/* Put file and line of the part before a message that begins with "part NAME", "part 'NAME'" or the
 * path of its mesh, as those of geometry and heat network do; else the file. Returns status. */
enum um_status um_model_blame_part(struct um_context *context, struct um_model *model,
                                   enum um_status status);
/* Put file and line of its key before a message that begins with the path of a table of orbit,
 * attitude or observer, as those of tables that do not reach an instant do. Returns status. */
enum um_status um_model_blame_table(struct um_context *context, const struct um_model *model,
                                    enum um_status status);

/* Unit vector of three numbers; UM_ERR_INPUT naming `key` when it is zero. */
enum um_status um_model_unit(struct um_context *context, const struct um_mark *at, const char *key,
                             const double v[3], struct um_vec3 *out);

#endif
