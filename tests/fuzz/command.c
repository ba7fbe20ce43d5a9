/* replay.json of somebody else: what is read has texts where texts belong, and bounded numbers of
 * them. */
#include <string.h>

#include "app/replay_read.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_document *document = NULL;
  struct um_app_replay_record *record = NULL;
  const char *path = um_fuzz_file(0, data, size);
  size_t bytes = 0;
  if (um_fuzz_good(context, um_app_replay_read(context, path, &document, &record))) {
    const char *const *argument = record->arguments.items;
    const struct um_app_replay_input *input = record->inputs.items;
    for (size_t i = 0; i < record->arguments.count; i++) bytes += strlen(argument[i]);
    for (size_t i = 0; i < record->inputs.count; i++) {
      bytes += strlen(input[i].path) + strlen(input[i].digest);
      um_fuzz_finite(input[i].bytes, "a size");
    }
    bytes += strlen(record->version) + strlen(record->folder) + strlen(record->written_utc);
    if (bytes > size) um_fuzz_finding("%zu bytes of texts in %zu", bytes, size);
  }
  um_document_destroy(&document);
}
