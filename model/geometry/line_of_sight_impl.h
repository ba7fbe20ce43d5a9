/* What the observer cannot see. Private to model/geometry/. */
#ifndef UMBRA_MODEL_LINE_OF_SIGHT_IMPL_H
#define UMBRA_MODEL_LINE_OF_SIGHT_IMPL_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

/* hidden: rows that the observer cannot see, said in the log; UM_ERR_INPUT for an observer inside
 * the satellite. After the observations are placed. */
enum um_status um_model_tables_hide(struct um_context *context, const struct um_model *model,
                                    struct um_model_tables *tables);

#endif
