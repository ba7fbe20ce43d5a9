/* The list of what points on record were made of, beside an identity that is not that of the input
 * but by chance: whatever it holds, the points are refused with one line, or taken. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file_snapshot.h"
#include "model/build/build.h"
#include "study/identity.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/wing.h"

/* One for all inputs, until the program ends. */
static const struct um_study_identity *identity_of_all(void)
{
  static struct um_context *own;
  static struct um_study_identity *identity;
  static struct um_model *model;
  const struct um_model_options options = {0};
  if (identity != NULL) return identity;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  if (um_core_context_create(NULL, &own) != UM_OK || um_core_snapshot_begin(own) != UM_OK ||
      um_model_create(own, um_fuzz_file(0, wing, sizeof wing - 1), &options, &model) != UM_OK ||
      um_study_identity_create(own, "0", model, &options, &identity) != UM_OK)
    um_fuzz_finding("no identity: %s", own == NULL ? "" : um_core_message(own));
  return identity;
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  const struct um_study_identity *identity = identity_of_all();
  char folder[1024], path[1100];
  snprintf(folder, sizeof folder, "%s", um_fuzz_out());
  *strrchr(folder, '/') = '\0';
  snprintf(path, sizeof path, "%s/made-of.txt", folder);
  FILE *file = fopen(path, "wb");
  if (file == NULL || fwrite(data, 1, size, file) != size || fclose(file) != 0)
    um_fuzz_finding("%s cannot be written", path);
  um_fuzz_good(context, um_study_identity_check(context, identity, folder));
  remove(path);
}
