/* While a snapshot of files lasts, every one is read once and served from memory again, so that
 * what is built many times is built from the same bytes though somebody edits them meanwhile. What
 * others read, a library or the loader, is not in memory: it must stay what it was. */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/digest.h"
#include "base/core/file_snapshot.h"
#include "base/core/file_snapshot_impl.h"
#include "base/core/plain_file.h"
#include "base/core/replay.h"

struct held {
  char *path, *text; /* text with a NUL behind it; NULL: what others read */
  size_t length;
  uint64_t digest;
  struct stat state; /* of what others read */
  size_t use; /* the how many-th file that was used since the last um_core_snapshot_begin; 0: not
                 yet */
};

struct um_core_snapshot {
  size_t holders, count, used;
  struct held *file; /* [count] */
};

static void note_use(struct um_core_snapshot *h, struct held *file)
{
  if (file->use == 0) file->use = ++h->used;
}

static struct held *find(struct um_core_snapshot *h, const char *path)
{
  for (size_t i = 0; h != NULL && i < h->count; i++)
    if (strcmp(h->file[i].path, path) == 0) return &h->file[i];
  return NULL;
}

static enum um_status fail_changed(struct um_context *context, const char *path)
{
  return um_core_fail(context, UM_ERR_IO,
                      "%s: has changed since it was read first; accepted: a file that stays as it "
                      "is while it is in use",
                      path);
}

static enum um_status copy(struct um_context *context, const char *text, size_t length, char **out)
{
  UM_TRY(um_core_allocate(context, length + 1, 1, out));
  if (length > 0) memcpy(*out, text, length);
  return UM_OK;
}

enum um_status um_core_snapshot_begin(struct um_context *context)
{
  struct um_core_snapshot **held = um_core_context_snapshot(context);
  if (*held == NULL) UM_TRY(um_core_allocate(context, 1, sizeof **held, held));
  (*held)->holders++;
  for (size_t i = 0; i < (*held)->count; i++) (*held)->file[i].use = 0;
  (*held)->used = 0;
  return UM_OK;
}

void um_core_snapshot_end(struct um_context *context)
{
  struct um_core_snapshot **held = um_core_context_snapshot(context), *h = *held;
  if (h == NULL || --h->holders > 0) return;
  for (size_t i = 0; i < h->count; i++) {
    UM_FREE(context, h->file[i].path, h->file[i].text);
  }
  UM_FREE(context, h->file, h);
  *held = NULL;
}

void um_core_snapshot_each(struct um_context *context,
                           void (*each)(void *self, const char *path, uint64_t digest), void *self)
{
  const struct um_core_snapshot *h = *um_core_context_snapshot(context);
  for (size_t use = 1; h != NULL && use <= h->used; use++)
    for (size_t i = 0; i < h->count; i++)
      if (h->file[i].use == use) each(self, h->file[i].path, h->file[i].digest);
}

void um_core_snapshot_forget(struct um_context *context, const char *path)
{
  struct um_core_snapshot *h = *um_core_context_snapshot(context);
  struct held *file = find(h, path);
  um_core_replay_forget(context, path);
  if (file == NULL) return;
  UM_FREE(context, file->path, file->text);
  *file = h->file[--h->count];
}

/* --- what others read ------------------------------------------------------------------------ */

enum um_status um_core_file_digest(struct um_context *context, const char *path, uint64_t *out)
{
  int descriptor;
  UM_TRY(um_core_descriptor_open(context, path, O_RDONLY, &descriptor));
  enum um_status status = um_core_descriptor_digest(context, path, descriptor, out);
  close(descriptor);
  return status;
}

/* Is it the file that it was? Times tell, so that it need not be read again. */
static bool same_state(const struct stat *a, const struct stat *b)
{
  return a->st_dev == b->st_dev && a->st_ino == b->st_ino && a->st_size == b->st_size &&
         a->st_mtim.tv_sec == b->st_mtim.tv_sec && a->st_mtim.tv_nsec == b->st_mtim.tv_nsec;
}

static enum um_status append(struct um_context *context, const char *path, struct held file)
{
  struct um_core_snapshot *h = *um_core_context_snapshot(context);
  enum um_status status;
  UM_CHECK(um_core_strdup(context, path, &file.path));
  UM_CHECK(um_core_reallocate(context, h->count + 1, sizeof *h->file, &h->file));
  h->file[h->count++] = file;
  note_use(h, &h->file[h->count - 1]);
  return UM_OK;
done:
  UM_FREE(context, file.path, file.text);
  return status;
}

enum um_status um_core_snapshot_note(struct um_context *context, const char *path)
{
  struct um_core_snapshot *h = *um_core_context_snapshot(context);
  struct held file = {.length = 0};
  if (h == NULL) return UM_OK;
  if (stat(path, &file.state) != 0)
    return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
  struct held *before = find(h, path);
  if (before != NULL) {
    note_use(h, before);
    if (before->text == NULL && same_state(&before->state, &file.state)) return UM_OK;
    return fail_changed(context, path); /* of another kind, where it was read here before */
  }
  UM_TRY(um_core_file_digest(context, path, &file.digest));
  return append(context, path, file);
}

/* --- what is read here ----------------------------------------------------------------------- */

enum um_status um_core_snapshot_find(struct um_context *context, const char *path, char **out,
                                     size_t *length, bool *found)
{
  struct um_core_snapshot *h = *um_core_context_snapshot(context);
  struct held *file = find(h, path);
  *found = file != NULL;
  if (file == NULL) return UM_OK;
  if (file->text == NULL) return fail_changed(context, path); /* of another kind: noted before */
  UM_TRY(copy(context, file->text, file->length, out));
  note_use(h, file);
  *length = file->length;
  return UM_OK;
}

enum um_status um_core_snapshot_add(struct um_context *context, const char *path, const char *text,
                                    size_t length)
{
  struct held file = {.length = length, .digest = UM_CORE_DIGEST_BEGIN};
  if (*um_core_context_snapshot(context) == NULL) return UM_OK;
  file.digest = um_core_digest(file.digest, text, length);
  UM_TRY(copy(context, text, length, &file.text));
  return append(context, path, file);
}
