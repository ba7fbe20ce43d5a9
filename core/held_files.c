/* While files are held, every one is read once and served from memory again, so that what is built
 * many times is built from the same bytes though somebody edits them meanwhile. */
#include "core/digest.h"
#include "core/held_files_impl.h"

#include <stdint.h>
#include <string.h>

struct held {
  char *path, *text; /* text with a NUL behind it */
  size_t length;
};

struct um_core_held_files {
  size_t holders, count;
  struct held *file; /* [count] */
};

static enum um_status copy(struct um_context *context, const char *text, size_t length, char **out)
{
  UM_TRY(um_core_allocate(context, length + 1, 1, out));
  if (length > 0) memcpy(*out, text, length);
  return UM_OK;
}

enum um_status um_core_files_hold(struct um_context *context)
{
  struct um_core_held_files **held = um_core_context_held_files(context);
  if (*held == NULL) UM_TRY(um_core_allocate(context, 1, sizeof **held, held));
  (*held)->holders++;
  return UM_OK;
}

void um_core_files_let_go(struct um_context *context)
{
  struct um_core_held_files **held = um_core_context_held_files(context), *h = *held;
  if (h == NULL || --h->holders > 0) return;
  for (size_t i = 0; i < h->count; i++) {
    um_core_free(context, h->file[i].path);
    um_core_free(context, h->file[i].text);
  }
  um_core_free(context, h->file);
  um_core_free(context, h);
  *held = NULL;
}

uint64_t um_core_files_digest(struct um_context *context)
{
  const struct um_core_held_files *h = *um_core_context_held_files(context);
  uint64_t sum = 0;
  for (size_t i = 0; h != NULL && i < h->count; i++) {
    /* its NUL too: an empty file counts */
    sum += um_core_digest(UM_CORE_DIGEST_BEGIN, h->file[i].text, h->file[i].length + 1);
  }
  return sum;
}

void um_core_file_forget(struct um_context *context, const char *path)
{
  struct um_core_held_files *h = *um_core_context_held_files(context);
  for (size_t i = 0; h != NULL && i < h->count; i++) {
    if (strcmp(h->file[i].path, path) != 0) continue;
    um_core_free(context, h->file[i].path);
    um_core_free(context, h->file[i].text);
    h->file[i] = h->file[--h->count];
    return;
  }
}

enum um_status um_core_held_files_find(struct um_context *context, const char *path, char **out,
                                       size_t *length, bool *found)
{
  const struct um_core_held_files *h = *um_core_context_held_files(context);
  *found = false;
  for (size_t i = 0; h != NULL && i < h->count; i++) {
    if (strcmp(h->file[i].path, path) != 0) continue;
    UM_TRY(copy(context, h->file[i].text, h->file[i].length, out));
    *length = h->file[i].length;
    *found = true;
  }
  return UM_OK;
}

enum um_status um_core_held_files_add(struct um_context *context, const char *path,
                                      const char *text, size_t length)
{
  enum um_status status;
  struct um_core_held_files *h = *um_core_context_held_files(context);
  struct held file = {.length = length};
  if (h == NULL) return UM_OK;
  UM_CHECK(um_core_strdup(context, path, &file.path));
  UM_CHECK(copy(context, text, length, &file.text));
  UM_CHECK(um_core_reallocate(context, h->count + 1, sizeof *h->file, &h->file));
  h->file[h->count++] = file;
  return UM_OK;
done:
  um_core_free(context, file.path);
  um_core_free(context, file.text);
  return status;
}
