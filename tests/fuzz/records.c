/* Records of points of a batch, as this process's own file and as that of another share; as they
 * are, and with every checksum made right, which a change of a byte seldom leaves so. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/batch/batch.h"
#include "tests/fuzz/fuzz.h"

enum { COORDINATES = 2, VALUES = 3, POINTS = 3, HEADER = 48, HEAD = 8, LONGEST = 4096 };

static size_t computed;

static enum um_status compute(struct um_context *context, void *user, const double *coordinate,
                              double *value)
{
  (void)user;
  computed++;
  for (int i = 0; i < VALUES; i++) value[i] = coordinate[0] + i * coordinate[1];
  if (coordinate[0] < 2.0) return UM_OK;
  return um_core_fail(context, UM_ERR_REFUSED, "%g is too large", coordinate[0]);
}

/* CRC-32 of IEEE 802.3, as the file has it. */
static void checksum(uint8_t *data, size_t n, uint8_t out[4])
{
  uint32_t crc = 0xffffffffu;
  for (size_t i = 0; i < n; i++) {
    crc ^= data[i];
    for (int k = 0; k < 8; k++) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  crc = ~crc;
  memcpy(out, &crc, 4);
}

/* Checksums of the header and of each record that has its length. */
static void seal(uint8_t *data, size_t size)
{
  if (size < HEADER) return;
  checksum(data, HEADER - 8, data + HEADER - 8);
  for (size_t at = HEADER; size - at >= HEAD;) {
    uint32_t reason;
    memcpy(&reason, data + at + 4, 4);
    if (reason > LONGEST) return;
    size_t n =
        HEAD + COORDINATES * sizeof(double) + (reason > 0 ? reason : VALUES * sizeof(double));
    if (size - at < n + 4) return;
    checksum(data + at, n, data + at + n);
    at += n + 4;
  }
}

/* Open, run, close; the points on record before and after. */
static bool once(struct um_context *context, const struct um_batch_task *task, size_t count[2])
{
  static const double coordinate[POINTS][COORDINATES] = {{0, 0}, {1, -0.5}, {2, 7}};
  double value[POINTS][VALUES];
  char *reason[POINTS] = {NULL};
  struct um_batch *batch = NULL;
  if (!um_fuzz_good(context, um_batch_open(context, task, &batch))) {
    if (batch != NULL) um_fuzz_finding("records in spite of the failure");
    return false;
  }
  count[0] = um_batch_recorded(batch);
  computed = 0;
  bool good =
      um_fuzz_good(context, um_batch_run(context, batch, coordinate[0], POINTS, value[0], reason));
  count[1] = um_batch_recorded(batch);
  if (good && count[1] != count[0] + computed)
    um_fuzz_finding("%zu points on record, %zu computed, then %zu", count[0], computed, count[1]);
  for (int i = 0; i < POINTS; i++) um_core_free(context, reason[i]);
  um_batch_close(context, &batch);
  return good;
}

static void one(struct um_context *context, const char *name, size_t nshare, const uint8_t *data,
                size_t size)
{
  static const char *const names[] = {"points.records", "points-1-of-3.records",
                                      "points-2-of-3.records"};
  const struct um_batch_task task = {.identity = 42,
                                     .work.ncoordinate = COORDINATES,
                                     .work.nvalue = VALUES,
                                     .work.compute = compute,
                                     .folder = um_fuzz_out(),
                                     .resume = true,
                                     .nshare = nshare};
  char path[400];
  size_t first[2], again[2];
  (void)mkdir(task.folder, 0777);
  snprintf(path, sizeof path, "%s/%s", task.folder, name);
  FILE *file = fopen(path, "wb");
  if (file == NULL || fwrite(data, 1, size, file) != size || fclose(file) != 0)
    um_fuzz_finding("no file to write");
  if (once(context, &task, first) && once(context, &task, again) && again[0] != first[1])
    um_fuzz_finding("%zu points were on record, %zu are read back", first[1], again[0]);
  for (int i = 0; i < 3; i++) {
    snprintf(path, sizeof path, "%s/%s", task.folder, names[i]);
    (void)unlink(path);
  }
  (void)rmdir(task.folder);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  uint8_t *sealed = malloc(size + 1);
  if (sealed == NULL) abort();
  if (size > 0) memcpy(sealed, data, size);
  seal(sealed, size);
  one(context, "points.records", 0, data, size);
  one(context, "points.records", 0, sealed, size);
  one(context, "points-2-of-3.records", 3, sealed, size);
  free(sealed);
}
