/* Paths of keys in a schema. */
#include <string.h>

#include "base/core/suggestions.h"
#include "base/document/document_impl.h"

#define DEPTH_MAX 12
#define PATH_SIZE 256

static enum um_status refuse_key(struct um_context *context, const struct um_schema_object *object,
                                 const char *path, const char *word)
{
  char known[512] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = word};
  for (size_t i = 0; i < object->nfield; i++) {
    um_core_words_append(known, sizeof known, object->fields[i].key);
    um_core_words_consider(&guess, object->fields[i].key);
  }
  return um_core_fail(context, UM_ERR_INPUT, "%.120s: %s has no key '%s'%s; accepted: %s", path,
                      object->name, word, um_core_words_hint(&guess, hint), known);
}

static bool is_near(const struct um_schema_object *object, const char *word)
{
  for (size_t i = 0; i < object->nfield; i++)
    if (um_core_words_are_near(word, object->fields[i].key)) return true;
  return false;
}

/* The rest field of a mapping takes any key. */
static const struct um_schema_field *find_key(const struct um_schema_object *object,
                                              const char *word)
{
  const struct um_schema_field *field = um_document_schema_find(object, word);
  for (size_t i = 0; field == NULL && i < object->nfield; i++)
    if (object->fields[i].type == UM_SCHEMA_REST && !is_near(object, word))
      field = &object->fields[i];
  return field;
}

/* The next word of a path without "[...]"; false at its end. */
static bool next_word(const char **path, char word[64])
{
  if (**path == '\0') return false;
  size_t n = strcspn(*path, ".[");
  snprintf(word, 64, "%.*s", (int)n, *path);
  *path += n;
  if (**path == '[') *path += strcspn(*path, ".");
  if (**path == '.') (*path)++;
  return true;
}

enum um_status um_document_schema_find_path(struct um_context *context,
                                            const struct um_schema_object *schema, const char *path,
                                            const struct um_schema_object **object,
                                            const struct um_schema_field **field)
{
  const char *rest = path;
  bool element = false; /* the name of one may stand here */
  char word[64];
  *object = schema;
  *field = NULL;
  while (next_word(&rest, word)) {
    const struct um_schema_object *inside = *field == NULL ? schema : (*field)->object;
    if (inside == NULL)
      return um_core_fail(context, UM_ERR_INPUT, "%.120s: '%s' holds no keys", path, (*field)->key);
    const struct um_schema_field *next =
        element ? um_document_schema_find(inside, word) : find_key(inside, word);
    /* a word that is no key is an element's name, unless it ends the path and looks like a key */
    if (next == NULL && element && word[0] != '\0' && (rest[0] != '\0' || !is_near(inside, word))) {
      element = false;
      continue;
    }
    if (next == NULL) return refuse_key(context, inside, path, word);
    *object = inside;
    *field = next;
    element = next->type == UM_SCHEMA_LIST || next->type == UM_SCHEMA_DICT;
  }
  return *field != NULL ? UM_OK : refuse_key(context, schema, path, "");
}

static enum um_status walk(const struct um_schema_object *object, const char *before, int depth,
                           um_document_schema_visitor visit, void *self)
{
  for (size_t i = 0; i < object->nfield; i++) {
    const struct um_schema_field *field = &object->fields[i];
    char path[PATH_SIZE];
    if (field->type == UM_SCHEMA_REST) continue;
    snprintf(path, sizeof path, "%.180s%s%.60s", before, before[0] != '\0' ? "." : "", field->key);
    UM_TRY(visit(self, path, field));
    if (field->object != NULL && field->object != object && depth < DEPTH_MAX)
      UM_TRY(walk(field->object, path, depth + 1, visit, self));
  }
  return UM_OK;
}

enum um_status um_document_schema_walk(const struct um_schema_object *schema,
                                       um_document_schema_visitor visit, void *self)
{
  return walk(schema, "", 0, visit, self);
}

static enum um_status write_path(void *self, const char *path, const struct um_schema_field *field)
{
  (void)field;
  fprintf(self, "%s\n", path);
  return UM_OK;
}

void um_document_schema_write_paths(FILE *file, const struct um_schema_object *schema)
{
  (void)um_document_schema_walk(schema, write_path, file);
}
