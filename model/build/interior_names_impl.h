/* Interiors of a part by number and name. Private to model/build/. */
#ifndef UMBRA_MODEL_INTERIOR_NAMES_IMPL_H
#define UMBRA_MODEL_INTERIOR_NAMES_IMPL_H

#include "base/core/context.h"
#include "model/scenario/scenario.h"

#define UM_MODEL_NO_INTERIOR ((size_t)-1)

/* Interiors of a part are counted as in its thermal spec: `interior` where it has one, then
 * `interiors` in the order of the scenario. */
size_t um_model_interior_count(const struct um_scenario_part *part);
const struct um_scenario_interior *um_model_interior_at(const struct um_scenario_part *part,
                                                        size_t index);
/* Does one of them fill the part with tetrahedra? */
bool um_model_interior_is_solid(const struct um_scenario_part *part);
/* "interior" or the scenario's own name. */
const char *um_model_interior_name(const struct um_scenario_interior *interior);
/* UM_MODEL_NO_INTERIOR when there is none of that name. */
size_t um_model_interior_find(const struct um_scenario_part *part, const char *name);
/* "no interior 'NAME'; accepted: ..." at a key; other: one more word that is accepted, or NULL. */
enum um_status um_model_refuse_interior(struct um_context *context,
                                        const struct um_scenario_part *part,
                                        const struct um_mark *at, const char *key, const char *name,
                                        const char *other);

#endif
