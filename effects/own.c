/* Effects of a user's own: shared objects by dlopen. An object is closed with its registry; the
 * system counts how often one is open, so that many models share it. */
#include <dlfcn.h>
#include <errno.h>
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "base/core/suggestions.h"
#include "effects/effects.h"

struct um_effects_registry {
  void **object; /* [nobject] of dlopen */
  size_t nobject;
  const struct um_effect **own; /* [nown] borrowed from the objects */
  size_t nown;
};

enum um_status um_effects_registry_create(struct um_context *context,
                                          struct um_effects_registry **out)
{
  return um_core_allocate(context, 1, sizeof **out, out);
}

void um_effects_registry_destroy(struct um_context *context, struct um_effects_registry **registry)
{
  if (registry == NULL || *registry == NULL) return;
  struct um_effects_registry *r = *registry;
  for (size_t i = r->nobject; i-- > 0;) dlclose(r->object[i]);
  UM_FREE(context, r->object, r->own, r);
  *registry = NULL;
}

static enum um_status take(struct um_context *context, struct um_effects_registry *r,
                           const struct um_effect *effect)
{
  UM_TRY(um_effects_check(context, effect));
  if (um_effects_registry_find(r, effect->name) != NULL)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s': there is %s effect of that name; accepted: another name",
                        effect->name,
                        um_effects_find(effect->name) != NULL ? "a built-in" : "already an");
  UM_TRY(um_core_reallocate(context, r->nown + 1, sizeof(const struct um_effect *), &r->own));
  r->own[r->nown++] = effect;
  return UM_OK;
}

static enum um_status take_all(struct um_context *context, struct um_effects_registry *r,
                               void *object)
{
  const struct um_effect *one = dlsym(object, "um_effect");
  const struct um_effect *const *list = dlsym(object, "um_effect_list");
  if (one == NULL && (list == NULL || *list == NULL))
    return um_core_fail(context, UM_ERR_INPUT,
                        "no effect in it; accepted: a symbol um_effect, a const struct um_effect, "
                        "or um_effect_list, pointers to some with NULL behind them");
  if (one != NULL) UM_TRY(take(context, r, one));
  for (; list != NULL && *list != NULL; list++)
    if (*list != one) UM_TRY(take(context, r, *list));
  return UM_OK;
}

/* Without the path, which the caller puts before it. */
static enum um_status fail_open(struct um_context *context, const char *path)
{
  const char *why = dlerror();
  size_t n = strlen(path);
  if (why == NULL) why = "not understood";
  if (strncmp(why, path, n) == 0 && why[n] == ':') why += n + 1 + strspn(why + n + 1, " ");
  return um_core_fail(context, UM_ERR_IO,
                      "%s; accepted: a shared object, as of cc -shared -fPIC -o FILE.so FILE.c",
                      why);
}

/* Does the file hold all that its program headers map? The system maps what is missing all the
 * same, and a touch of it ends the program. What is no such file is left to dlopen. */
static bool is_whole(FILE *file)
{
  ElfW(Ehdr) head;
  ElfW(Phdr) part;
  if (fread(&head, sizeof head, 1, file) != 1 || memcmp(head.e_ident, ELFMAG, SELFMAG) != 0)
    return true;
  if (head.e_phentsize != sizeof part || fseek(file, 0, SEEK_END) != 0) return true;
  long size = ftell(file);
  for (unsigned i = 0; i < head.e_phnum; i++) {
    long at = (long)(head.e_phoff + i * sizeof part);
    if (fseek(file, at, SEEK_SET) != 0 || fread(&part, sizeof part, 1, file) != 1) return false;
    if (part.p_type == PT_LOAD &&
        (part.p_filesz > (ElfW(Xword))size || part.p_offset > (ElfW(Xword))size - part.p_filesz))
      return false;
  }
  return true;
}

/* absolute: without a slash the system would search its own folders. */
static enum um_status load(struct um_context *context, struct um_effects_registry *r,
                           const char *absolute)
{
  size_t nown = r->nown;
  void *object = dlopen(absolute, RTLD_NOW | RTLD_LOCAL);
  if (object == NULL) return fail_open(context, absolute);
  enum um_status status =
      um_core_reallocate(context, r->nobject + 1, sizeof *r->object, &r->object);
  if (status == UM_OK)
    for (size_t i = 0; i < r->nobject; i++)
      if (r->object[i] == object) { /* loaded already */
        dlclose(object);
        return UM_OK;
      }
  if (status == UM_OK) status = take_all(context, r, object);
  if (status == UM_OK) {
    r->object[r->nobject++] = object;
    return UM_OK;
  }
  r->nown = nown;
  dlclose(object);
  return status;
}

static enum um_status check_whole(struct um_context *context, const char *path)
{
  FILE *file;
  UM_TRY(um_core_file_open(context, path, &file));
  bool whole = is_whole(file);
  fclose(file);
  if (whole) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cut short; accepted: a whole shared object", path);
}

enum um_status um_effects_registry_load(struct um_context *context,
                                        struct um_effects_registry *registry, const char *path)
{
  UM_TRY(check_whole(context, path));
  char *absolute = realpath(path, NULL);
  if (absolute == NULL && errno == ENOMEM)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  if (absolute == NULL) return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
  enum um_status status = um_core_snapshot_note(context, absolute);
  if (status == UM_OK) {
    status = load(context, registry, absolute);
    if (status != UM_OK && status != UM_ERR_MEMORY) um_core_message_prefix(context, "%s", path);
  }
  free(absolute);
  return status;
}

size_t um_effects_registry_count(const struct um_effects_registry *registry)
{
  return um_effects_count() + (registry != NULL ? registry->nown : 0);
}

const struct um_effect *um_effects_registry_at(const struct um_effects_registry *registry,
                                               size_t index)
{
  size_t n = um_effects_count();
  return index < n ? um_effects_at(index) : registry->own[index - n];
}

const struct um_effect *um_effects_registry_find(const struct um_effects_registry *registry,
                                                 const char *name)
{
  for (size_t i = 0; i < um_effects_registry_count(registry); i++)
    if (strcmp(um_effects_registry_at(registry, i)->name, name) == 0)
      return um_effects_registry_at(registry, i);
  return NULL;
}

void um_effects_registry_names(const struct um_effects_registry *registry, char *out, size_t size)
{
  if (size > 0) out[0] = '\0';
  for (size_t i = 0; i < um_effects_registry_count(registry); i++)
    um_core_words_append(out, size, um_effects_registry_at(registry, i)->name);
}
