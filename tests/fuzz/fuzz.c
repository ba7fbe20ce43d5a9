/* See fuzz.h. */
#define _GNU_SOURCE /* memfd_create */
#include "tests/fuzz/fuzz.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/core/sampling.h"
#include "tests/support/allocator.h"

#define LARGEST_BLOCK                                                                              \
  ((size_t)1 << 30) /* [bytes] an input of a few KiB that asks for more errs                       \
                     */

static struct um_test_memory memory;
static struct um_core_allocator plain;

void um_fuzz_finding(const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  fputs("FINDING: ", stderr);
  vfprintf(stderr, format, arguments);
  fputc('\n', stderr);
  va_end(arguments);
  abort();
}

static void *bounded_allocate(void *self, size_t bytes)
{
  if (bytes > LARGEST_BLOCK) um_fuzz_finding("a block of %zu bytes is asked for", bytes);
  return plain.allocate(self, bytes);
}

static void *bounded_reallocate(void *self, void *block, size_t bytes)
{
  if (bytes > LARGEST_BLOCK) um_fuzz_finding("a block of %zu bytes is asked for", bytes);
  return plain.reallocate(self, block, bytes);
}

bool um_fuzz_memory_is_short(void) { return memory.fail_call != 0; }

bool um_fuzz_good(struct um_context *context, enum um_status status)
{
  if (status == UM_OK) return true;
  const char *message = um_core_message(context);
  if ((unsigned)status >= UM_STATUS_COUNT) um_fuzz_finding("status %d", (int)status);
  if (status == UM_ERR_MEMORY && !um_fuzz_memory_is_short())
    um_fuzz_finding("out of memory without need: %s", message);
  if (message[0] == '\0') um_fuzz_finding("a failure without a message, status %d", (int)status);
  for (const char *p = message; *p != '\0'; p++)
    if ((unsigned char)*p < 0x20 || *p == 0x7f)
      um_fuzz_finding("control character %02x in the message: %s", (unsigned)*p, message);
  if (getenv("FUZZ_TALK") != NULL) fprintf(stderr, "refused: %s\n", message);
  um_core_message_clear(context);
  return false;
}

void um_fuzz_finite(double value, const char *what)
{
  if (!isfinite(value)) um_fuzz_finding("%s is %g", what, value);
}

const char *um_fuzz_file(int which, const void *data, size_t size)
{
  static int descriptor[2] = {-1, -1};
  static char path[2][32];
  int *d = &descriptor[which];
  if (*d < 0) {
    *d = memfd_create("fuzz", 0);
    snprintf(path[which], sizeof path[which], "/proc/self/fd/%d", *d);
  }
  if (*d < 0 || ftruncate(*d, 0) != 0 || pwrite(*d, data, size, 0) != (ssize_t)size) {
    perror("fuzz: a file in memory");
    exit(EXIT_FAILURE);
  }
  return path[which];
}

static char folder[256], out[300];

static void folder_remove(void)
{
  (void)remove(out);
  if (rmdir(folder) != 0) perror(folder);
}

const char *um_fuzz_out(void)
{
  if (folder[0] != '\0') return out;
  const char *base = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/umbra-fuzz-XXXXXX", base != NULL ? base : P_tmpdir);
  if (mkdtemp(folder) == NULL) {
    perror(folder);
    exit(EXIT_FAILURE);
  }
  snprintf(out, sizeof out, "%s/out", folder);
  (void)atexit(folder_remove);
  return out;
}

const char *um_fuzz_out_file(const void *data, size_t size)
{
  FILE *file = fopen(um_fuzz_out(), "wb");
  if (file == NULL || fwrite(data, 1, size, file) != size || fclose(file) != 0) {
    perror(out);
    exit(EXIT_FAILURE);
  }
  return out;
}

char *um_fuzz_text(const uint8_t *data, size_t size)
{
  char *text = malloc(size + 1);
  if (text == NULL) abort();
  if (size > 0) memcpy(text, data, size);
  text[size] = '\0';
  return text;
}

static void run(const uint8_t *data, size_t size, long fail_call)
{
  struct um_context *context;
  memory = (struct um_test_memory){0};
  plain = um_test_memory_allocator(&memory);
  const struct um_core_allocator allocator = {&memory, bounded_allocate, bounded_reallocate,
                                              plain.release};
  if (um_core_context_create(&allocator, &context) != UM_OK) um_fuzz_finding("no context");
  um_core_context_set_threads(context, 1);
  memory.calls = 0;
  memory.fail_call = fail_call;
  um_fuzz_one(context, data, size);
  um_core_context_destroy(&context);
  if (memory.alive != 0)
    um_fuzz_finding("%ld blocks left behind (failing allocation: %ld)", memory.alive, fail_call);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  run(data, size, 0);
  uint64_t key = size;
  for (size_t i = 0; i < size; i++) key = um_core_hash(key, data[i]);
  if (memory.calls > 0) run(data, size, 1 + (long)(key % (uint64_t)memory.calls));
  return 0;
}
