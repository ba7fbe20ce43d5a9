/* Heat capacity and conductivity of records by temperature. Private to model/build/. */
#ifndef UMBRA_MODEL_BULK_LAW_IMPL_H
#define UMBRA_MODEL_BULK_LAW_IMPL_H

#include "model/build/model.h"

/* *out: ratios over 300 K, as long as the model lives; NULL where they are constant or the scenario
 * takes them so. */
enum um_status um_model_bulk_ratio(struct um_context *context, struct um_model *model,
                                   const struct um_materials_record *record,
                                   enum um_materials_bulk_property property,
                                   const struct um_thermal_ratio **out);

#endif
