/* What finer facets would change of a run. */
#ifndef UMBRA_MODEL_MESH_ERROR_H
#define UMBRA_MODEL_MESH_ERROR_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "model/run/thermal_solution.h"

#define UM_MODEL_MESH_SIDE     160 /* room for a name */
#define UM_MODEL_MESH_SENTENCE 480

/* An estimate by the run's own temperatures (thermal/solver/mesh_error.h), at 48 instants of the
 * observations at most, evenly taken. *out is freed with the result. UM_ERR_MEMORY,
 * UM_ERR_CANCELLED. */
enum um_status um_model_mesh_error(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   const struct um_model_result *result,
                                   struct um_model_mesh_error *out);

/* "part.group" or "part.group.back", the side of a group of the geometry, cut to fit into text;
 * returns it. */
const char *um_model_mesh_side(const struct um_model *model, size_t group, bool back,
                               char text[UM_MODEL_MESH_SIDE]);
/* "finer facets would move temperatures of places by about +1.2 K at most (bus.+x), ...": the last
 * infrared band's light with it, without a full stop; returns text. */
const char *um_model_mesh_sentence(const struct um_model *model,
                                   const struct um_model_mesh_error *mesh,
                                   char text[UM_MODEL_MESH_SENTENCE]);

#endif
