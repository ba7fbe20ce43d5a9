/* The list of what points on record were made of, beside an identity that is not that of the input
 * but by chance: whatever it holds, the points are refused with one line, or taken. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/held_files.h"
#include "model/build.h"
#include "study/identity.h"
#include "tests/fuzz/fuzz.h"

static const char text[] =
    "schema: 1\n"
    "name: made of\n"
    "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:30:20Z, step_s: 10}\n"
    "orbit: {fixed: {position_gcrs_km: [42000, 0, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, front: grey, back: grey, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "thermal: {orbits_before: 0, start: isothermal}\n";

/* One for all inputs, until the program ends. */
static const struct um_study_identity *identity_of_all(void)
{
  static struct um_context *own;
  static struct um_study_identity *identity;
  static struct um_model *model;
  const struct um_model_options options = {0};
  if (identity != NULL) return identity;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  if (um_core_context_create(NULL, &own) != UM_OK || um_core_files_hold(own) != UM_OK ||
      um_model_create(own, um_fuzz_file(0, text, sizeof text - 1), &options, &model) != UM_OK ||
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
