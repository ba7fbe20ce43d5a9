/* Which keys a mapping has: unknown ones, and those that exclude each other. */
#include <string.h>

#include "base/core/suggestions.h"
#include "base/document/document_impl.h"

const struct um_schema_field *um_document_schema_find(const struct um_schema_object *object,
                                                      const char *key)
{
  for (size_t i = 0; i < object->nfield; i++)
    if (object->fields[i].type != UM_SCHEMA_REST && strcmp(object->fields[i].key, key) == 0)
      return &object->fields[i];
  return NULL;
}

static bool takes_rest(const struct um_schema_object *object)
{
  for (size_t i = 0; i < object->nfield; i++)
    if (object->fields[i].type == UM_SCHEMA_REST) return true;
  return false;
}

static enum um_status check_known(struct um_context *context, const struct um_schema_object *object,
                                  const struct um_node *node)
{
  for (const struct um_node *n = node->first; n != NULL; n = n->next) {
    if (um_document_schema_find(object, n->key) != NULL || takes_rest(object) || object->others)
      continue;
    char known[512] = "";
    struct um_core_words_guess guess = {.written = n->key};
    for (size_t i = 0; i < object->nfield; i++) {
      um_core_words_append(known, sizeof known, object->fields[i].key);
      um_core_words_consider(&guess, object->fields[i].key);
    }
    const char *nearest = guess.nearest;
    return um_document_mark_fail(context, &n->at, "unknown key '%.80s'%s%s%s; accepted: %s", n->key,
                                 nearest != NULL ? ", did you mean '" : "",
                                 nearest != NULL ? nearest : "", nearest != NULL ? "'?" : "",
                                 known);
  }
  return UM_OK;
}

static bool group_is_required(const struct um_schema_object *object, int group)
{
  for (const int *g = object->exactly_one; g != NULL && *g != 0; g++)
    if (*g == group) return true;
  return false;
}

/* One group of keys that exclude each other. */
static enum um_status check_group(struct um_context *context, const struct um_schema_object *object,
                                  const struct um_node *node, int group)
{
  char members[512] = "";
  const struct um_node *present[2] = {NULL, NULL};
  size_t count = 0;
  for (size_t i = 0; i < object->nfield; i++) {
    if (object->fields[i].alternative != group) continue;
    um_core_words_append(members, sizeof members, object->fields[i].key);
    const struct um_node *n = um_document_node_child(node, object->fields[i].key);
    if (n != NULL && count < 2) present[count++] = n;
  }
  if (count == 2)
    return um_document_mark_fail(context, &present[1]->at,
                                 "'%s' and '%s' exclude each other; accepted: one of %s",
                                 present[0]->key, present[1]->key, members);
  if (count == 0 && group_is_required(object, group))
    return um_document_mark_fail(context, &node->at, "one key is missing; accepted: one of %s",
                                 members);
  return UM_OK;
}

static enum um_status check_groups(struct um_context *context,
                                   const struct um_schema_object *object,
                                   const struct um_node *node)
{
  for (size_t i = 0; i < object->nfield; i++) {
    int group = object->fields[i].alternative;
    bool seen = group == 0;
    for (size_t j = 0; j < i && !seen; j++) seen = object->fields[j].alternative == group;
    if (!seen) UM_TRY(check_group(context, object, node, group));
  }
  return UM_OK;
}

enum um_status um_document_schema_check_keys(struct um_context *context,
                                             const struct um_schema_object *object,
                                             const struct um_node *node)
{
  UM_TRY(check_known(context, object, node));
  return check_groups(context, object, node);
}
