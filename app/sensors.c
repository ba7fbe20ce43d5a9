/* umbra list sensors: telescopes with detectors that come with the program. */
#include <string.h>

#include "app/app.h"
#include "base/core/file.h"
#include "base/core/listing.h"
#include "base/document/schema.h"
#include "model/build/sensor_preset.h"
#include "model/scenario/scenario.h"

#define LONGEST 65536 /* of a preset's file [bytes] */

/* The file itself: keys, where they are from, what is assumed. */
static enum um_status print_one(struct um_context *context, const char *name)
{
  char *path = NULL, *text = NULL;
  size_t length;
  enum um_status status;
  UM_CHECK(um_model_sensor_preset_path(context, name, &path));
  UM_CHECK(um_core_file_read(context, path, LONGEST, &text, &length));
  fputs(text, stdout);
done:
  UM_FREE(context, text, path);
  return status;
}

static enum um_status print_row(struct um_context *context, const char *name, bool json, bool last)
{
  char *path = NULL;
  struct um_document *document = NULL;
  struct um_scenario_preset *preset;
  enum um_status status;
  UM_CHECK(um_model_sensor_preset_path(context, name, &path));
  UM_CHECK(um_model_sensor_preset_read(context, path, &document, &preset));
  if (!json) {
    printf("%-14s%s\n", name, preset->summary);
    goto done;
  }
  const char *const keys[] = {"name", "summary", "source", "assumed"};
  const char *const texts[] = {name, preset->summary, preset->source, preset->assumed};
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    printf("%s\"%s\": ", i == 0 ? "  {" : ", ", keys[i]);
    um_core_json_string(stdout, texts[i]);
  }
  printf("}%s\n", last ? "" : ",");
done:
  um_document_destroy(&document);
  um_core_free(context, path);
  return status;
}

int um_app_sensors(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status = UM_OK;
  char **names = NULL;
  size_t count = 0;
  if (options->npositional == 1) {
    status = options->json ? print_row(context, options->positional[0], true, true)
                           : print_one(context, options->positional[0]);
    return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
  }
  UM_CHECK(um_model_sensor_presets(context, &names, &count));
  if (options->json) puts("[");
  for (size_t i = 0; i < count; i++)
    UM_CHECK(print_row(context, names[i], options->json, i + 1 == count));
  if (options->json) puts("]");
done:
  um_core_listing_free(context, names, count);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
