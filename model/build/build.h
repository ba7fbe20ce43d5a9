/* A model from a scenario. */
#ifndef UMBRA_MODEL_BUILD_H
#define UMBRA_MODEL_BUILD_H

#include "model/build/model.h"

/* Build from a scenario folder or file. UM_ERR_INPUT with file, line, key. The caller destroys. */
enum um_status um_model_create(struct um_context *context, const char *path,
                               const struct um_model_options *options, struct um_model **out);
/* The same scenario with changes: built from the parsed scenario of `origin`, which outlives it,
 * without a look at its YAML; files that it names are read again unless they are held
 * (um_core_snapshot_begin). It has the bits of a model of its own from a file that says the same.
 * What the origin was built from was good, so that what is refused is refused because of the
 * changes: UM_ERR_REFUSED. Effects of shared objects stay those of the origin. The caller destroys.
 */
enum um_status um_model_variant_create(struct um_context *context, const struct um_model *origin,
                                       const struct um_model_changes *changes,
                                       struct um_model **out);
/* Only what orbits need (for `umbra forecast --times`): no parts, no materials. */
enum um_status um_model_create_orbit(struct um_context *context, const char *path,
                                     const struct um_model_options *options, struct um_model **out);
void um_model_destroy(struct um_context *context, struct um_model **model);

#endif
