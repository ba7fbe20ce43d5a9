/* Places by the names that users give them. Private to the rooms of evidence/. */
#ifndef UMBRA_COMPARE_PLACES_GROUP_H
#define UMBRA_COMPARE_PLACES_GROUP_H

#include "model/build/model.h"

/* Index as in um_model_result.place of "bus.+x", "material:cfrp", or of what stands behind the
 * part's name ("+x", "interior") where only one place has it. UM_ERR_INPUT, a message without
 * origin, to be prefixed. */
enum um_status um_compare_place_find(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *place);

#endif
