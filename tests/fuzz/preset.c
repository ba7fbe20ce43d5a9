/* A sensor of the program's own folder. */
#include "model/build/sensor_preset.h"

#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_document *document = NULL;
  struct um_scenario_preset *preset = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_model_sensor_preset_read(context, path, &document, &preset))) {
    if (preset == NULL || preset->sensor == NULL) um_fuzz_finding("a preset of nothing");
    if (preset->sensor->aperture_m <= 0.0) um_fuzz_finding("an aperture of nothing");
  } else if (document != NULL || preset != NULL) {
    um_fuzz_finding("a preset in spite of the failure");
  }
  um_document_destroy(&document);
}
