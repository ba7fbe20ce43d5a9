/* The outside of a satellite as Wavefront OBJ. */
#ifndef UMBRA_OUTPUT_MESH_OBJ_H
#define UMBRA_OUTPUT_MESH_OBJ_H

#include <stdio.h>

#include "model/build/model.h"

/* All facets as the model has them at the scenario's start, joints as they stand then; body axes
 * [m]. Each part is an `o`, each of its groups a `g` PART.GROUP with `usemtl` of the front's
 * material, so that the reader of OBJ makes groups of the same names. Coordinates read back as the
 * same doubles. UM_ERR_MEMORY, errors of the orbit; of writing, the stream's. */
enum um_status um_output_write_obj(struct um_context *context, const struct um_model *model,
                                   FILE *file);

#endif
