/* Sensors that come with the program, optics/instrument/sensors. */
#ifndef UMBRA_MODEL_SENSOR_PRESET_H
#define UMBRA_MODEL_SENSOR_PRESET_H

#include "model/build/model.h"

/* Their names in order; um_core_listing_free frees. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_sensor_presets(struct um_context *context, char ***names, size_t *count);

/* File of the preset of that name; the caller frees. UM_ERR_INPUT "no sensor 'x'; accepted: ...",
 * UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_sensor_preset_path(struct um_context *context, const char *name,
                                           char **out);

/* One that is read; *document owns it, um_document_destroy frees. UM_ERR_INPUT with file, line and
 * key, UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_sensor_preset_read(struct um_context *context, const char *path,
                                           struct um_document **document,
                                           struct um_scenario_preset **out);

/* A sensor with what its preset says of keys that it does not state; without a preset a copy. Texts
 * are the model's. Errors as above, with the scenario's line. */
enum um_status um_model_sensor_preset(struct um_context *context, struct um_model *model,
                                      const struct um_scenario_sensor *stated,
                                      struct um_scenario_sensor *out);

#endif
