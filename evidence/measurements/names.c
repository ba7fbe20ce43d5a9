/* Interned names by a hash table with linear probing, at most half full (Knuth 1998, The Art of
 * Computer Programming 3, 6.4), so that a survey with a track per row is read in linear time. */
#include "evidence/measurements/names_impl.h"

#include <stdint.h>
#include <string.h>

#include "base/core/sampling.h"

static uint64_t hash(size_t tag, const char *text)
{
  uint64_t h = tag;
  for (; *text != '\0'; text++) h = um_core_hash(h, (unsigned char)*text);
  return h;
}

/* Where (tag, text) stands, or the free slot where it would. */
static size_t probe(const struct um_compare_names *names, size_t tag, const char *text)
{
  size_t mask = names->slots - 1, s = (size_t)hash(tag, text) & mask;
  while (names->slot[s] != 0) {
    size_t i = names->slot[s] - 1;
    if (names->tag[i] == tag && strcmp(names->text[i], text) == 0) break;
    s = (s + 1) & mask;
  }
  return s;
}

static enum um_status grow(struct um_context *context, struct um_compare_names *names)
{
  size_t capacity = names->capacity == 0 ? 16 : 2 * names->capacity, *slot;
  UM_TRY(um_core_reallocate(context, capacity, sizeof *names->text, &names->text));
  UM_TRY(um_core_reallocate(context, capacity, sizeof *names->tag, &names->tag));
  UM_TRY(um_core_allocate(context, 2 * capacity, sizeof *slot, &slot));
  um_core_free(context, names->slot);
  names->slot = slot;
  names->slots = 2 * capacity;
  names->capacity = capacity;
  for (size_t i = 0; i < names->count; i++)
    names->slot[probe(names, names->tag[i], names->text[i])] = i + 1;
  return UM_OK;
}

enum um_status um_compare_names_intern(struct um_context *context, struct um_compare_names *names,
                                       size_t tag, const char *text, size_t *index)
{
  if (names->count == names->capacity) UM_TRY(grow(context, names));
  size_t s = probe(names, tag, text);
  if (names->slot[s] == 0) {
    UM_TRY(um_core_strdup(context, text, &names->text[names->count]));
    names->tag[names->count] = tag;
    names->slot[s] = ++names->count;
  }
  *index = names->slot[s] - 1;
  return UM_OK;
}

void um_compare_names_free(struct um_context *context, struct um_compare_names *names)
{
  for (size_t i = 0; i < names->count; i++) um_core_free(context, names->text[i]);
  um_core_free(context, um_compare_names_take(context, names));
}

char **um_compare_names_take(struct um_context *context, struct um_compare_names *names)
{
  char **text = names->text;
  UM_FREE(context, names->tag, names->slot);
  *names = (struct um_compare_names){0};
  return text;
}
