/* scenario.yaml as text, against its schema. */
#include <stdlib.h>

#include "tests/fuzz/documents.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  char *text = um_fuzz_text(data, size);
  documents_try(context, text, NULL, 0);
  free(text);
}
