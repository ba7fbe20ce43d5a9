/* The record of a command and of the files that it read. A file is digested when it is opened, not
 * when results are written: what stands there hours later may be another. */
#include "base/core/replay.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/core/context_impl.h"
#include "base/core/digest.h"
#include "base/core/json.h"

#define PIECE ((size_t)1 << 20) /* read between two looks at the stop [bytes] */

struct input {
  char *path; /* as opened */
  struct stat state;
  uint64_t digest;
};

struct um_core_replay {
  const char *version, *command;
  char *const *argument; /* [nargument] */
  size_t nargument;
  char *folder;
  struct input *input; /* [ninput] in the order of the first time */
  size_t ninput;
  char **shipped; /* [nshipped] folders of what comes with the program */
  size_t nshipped;
};

static enum um_status fail_errno(struct um_context *context, const char *path)
{
  return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
}

/* "." where it is not there any more, or cannot be named. */
static enum um_status working_folder(struct um_context *context, char **out)
{
  char *here = getcwd(NULL, 0);
  enum um_status status = um_core_strdup(context, here != NULL ? here : ".", out);
  free(here);
  return status;
}

enum um_status um_core_replay_begin(struct um_context *context, const char *version,
                                    const char *command, char *const *argument, size_t nargument)
{
  struct um_core_replay **record = um_core_context_replay(context);
  um_core_replay_end(context);
  UM_TRY(um_core_allocate(context, 1, sizeof **record, record));
  (*record)->version = version;
  (*record)->command = command;
  (*record)->argument = argument;
  (*record)->nargument = nargument;
  enum um_status status = working_folder(context, &(*record)->folder);
  if (status != UM_OK) um_core_replay_end(context);
  return status;
}

void um_core_replay_end(struct um_context *context)
{
  struct um_core_replay **record = um_core_context_replay(context), *r = *record;
  if (r == NULL) return;
  for (size_t i = 0; i < r->ninput; i++) um_core_free(context, r->input[i].path);
  um_core_free_blocks(context, r->nshipped, (void *const *)r->shipped);
  UM_FREE(context, r->input, (void *)r->shipped, r->folder, r);
  *record = NULL;
}

const char *um_core_replay_command(struct um_context *context)
{
  const struct um_core_replay *r = *um_core_context_replay(context);
  return r != NULL ? r->command : NULL;
}

enum um_status um_core_descriptor_digest(struct um_context *context, const char *path,
                                         int descriptor, uint64_t *out)
{
  enum um_status status;
  char *piece;
  off_t at = 0;
  ssize_t got;
  *out = UM_CORE_DIGEST_BEGIN;
  UM_TRY(um_core_allocate(context, PIECE, 1, &piece));
  do {
    got = pread(descriptor, piece, PIECE, at);
    if (got < 0) UM_CHECK(fail_errno(context, path));
    *out = um_core_digest(*out, piece, (size_t)got);
    at += got;
    UM_CHECK(um_core_stop_check(context, "a file was read"));
  } while (got > 0);
done:
  um_core_free(context, piece);
  return status;
}

static struct input *find(struct um_core_replay *r, const char *path)
{
  for (size_t i = 0; r != NULL && i < r->ninput; i++)
    if (strcmp(r->input[i].path, path) == 0) return &r->input[i];
  return NULL;
}

static bool is_shipped(const struct um_core_replay *r, const char *path)
{
  for (size_t i = 0; i < r->nshipped; i++) {
    size_t n = strlen(r->shipped[i]);
    if (strncmp(path, r->shipped[i], n) == 0 && (path[n] == '/' || path[n] == '\0')) return true;
  }
  return false;
}

enum um_status um_core_replay_leave_out(struct um_context *context, const char *folder)
{
  struct um_core_replay *r = *um_core_context_replay(context);
  if (r == NULL || is_shipped(r, folder)) return UM_OK;
  UM_TRY(um_core_reallocate(context, r->nshipped + 1, sizeof *r->shipped, &r->shipped));
  UM_TRY(um_core_strdup(context, folder, &r->shipped[r->nshipped]));
  r->nshipped++;
  return UM_OK;
}

enum um_status um_core_replay_note(struct um_context *context, const char *path, int descriptor)
{
  struct um_core_replay *r = *um_core_context_replay(context);
  struct input input = {.path = NULL};
  enum um_status status;
  if (r == NULL || is_shipped(r, path) || find(r, path) != NULL) return UM_OK;
  if (fstat(descriptor, &input.state) != 0) return fail_errno(context, path);
  UM_TRY(um_core_descriptor_digest(context, path, descriptor, &input.digest));
  UM_CHECK(um_core_strdup(context, path, &input.path));
  UM_CHECK(um_core_reallocate(context, r->ninput + 1, sizeof *r->input, &r->input));
  r->input[r->ninput++] = input;
  return UM_OK;
done:
  um_core_free(context, input.path);
  return status;
}

void um_core_replay_forget(struct um_context *context, const char *path)
{
  struct um_core_replay *r = *um_core_context_replay(context);
  struct input *input = find(r, path);
  if (input == NULL) return;
  um_core_free(context, input->path);
  size_t behind = (size_t)(r->input + r->ninput - input) - 1;
  memmove(input, input + 1, behind * sizeof *input);
  r->ninput--;
}

void um_core_replay_digest_text(uint64_t digest, char out[UM_CORE_REPLAY_DIGEST])
{
  snprintf(out, UM_CORE_REPLAY_DIGEST, "%016" PRIx64, digest);
}

static void write_inputs(FILE *file, const struct um_core_replay *r)
{
  char digest[UM_CORE_REPLAY_DIGEST];
  fputs(",\n \"inputs\": [", file);
  for (size_t i = 0; i < r->ninput; i++) {
    const struct input *input = &r->input[i];
    um_core_json_text(file, i > 0 ? ",\n  {" : "\n  {", "path", input->path);
    um_core_replay_digest_text(input->digest, digest);
    fprintf(file, ", \"bytes\": %jd, \"fnv1a64\": \"%s\"}", (intmax_t)input->state.st_size, digest);
  }
  fputs(r->ninput > 0 ? "\n ]}\n" : "]}\n", file);
}

void um_core_replay_write(struct um_context *context, FILE *file)
{
  const struct um_core_replay *r = *um_core_context_replay(context);
  time_t now = time(NULL);
  struct tm utc;
  char text[32] = "";
  if (r == NULL) return;
  if (gmtime_r(&now, &utc) != NULL) strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  fprintf(file, "{\"umbra_replay\": %d", UM_CORE_REPLAY_FORMAT);
  um_core_json_text(file, ",\n ", "version", r->version);
  fputs(",\n \"arguments\": [", file);
  for (size_t i = 0; i < r->nargument; i++) {
    if (i > 0) fputs(", ", file);
    um_core_json_string(file, r->argument[i]);
  }
  fputc(']', file);
  um_core_json_text(file, ",\n ", "folder", r->folder);
  um_core_json_text(file, ",\n ", "written_utc", text);
  write_inputs(file, r);
}
