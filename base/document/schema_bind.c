/* Check the tree of a document against a schema and bind it into C structs. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "base/document/document_impl.h"

struct binder {
  struct um_document *document;
  struct um_context *context;
};

static enum um_status bind_object(struct binder *b, const struct um_schema_object *object,
                                  const struct um_node *node, char *target);

static const char *kind_text(const struct um_node *node)
{
  static const char *const texts[] = {"no value", "a single value", "a list", "a mapping"};
  return texts[node->kind];
}

/* "got X; accepted: Y" */
static enum um_status fail_type(struct binder *b, const struct um_schema_field *field,
                                const struct um_node *node)
{
  char accepted[512];
  um_document_schema_accepted(field, accepted, sizeof accepted);
  if (node->kind == UM_NODE_SCALAR)
    return um_document_mark_fail(b->context, &node->at, "'%.100s'%s is not accepted; accepted: %s",
                                 node->text, node->plain ? "" : " (in quotes)", accepted);
  return um_document_mark_fail(b->context, &node->at, "%s is not accepted; accepted: %s",
                               kind_text(node), accepted);
}

static bool in_range(const struct um_schema_field *field, double value)
{
  if (field->minimum == field->maximum) return true;
  bool above = field->open_minimum ? value > field->minimum : value >= field->minimum;
  return above && value <= field->maximum;
}

/* No more elements than the field takes: what they cost stands in proportion to a real scenario. */
static enum um_status check_count(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *node)
{
  if (field->most == 0 || node->count <= field->most) return UM_OK;
  return um_document_mark_fail(b->context, &node->at, "%zu elements; accepted: at most %zu",
                               node->count, field->most);
}

static enum um_status bind_number(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *node, double *out)
{
  if (node->kind == UM_NODE_SCALAR && node->typed && isfinite(node->number))
    *out = node->number;
  else if (node->kind != UM_NODE_SCALAR || !node->plain || node->typed ||
           !um_core_number_parse(node->text, out))
    return fail_type(b, field, node);
  if (in_range(field, *out)) return UM_OK;
  char accepted[512];
  um_document_schema_accepted(field, accepted, sizeof accepted);
  return um_document_mark_fail(b->context, &node->at, "%s is out of range; accepted: %s",
                               node->text, accepted);
}

static enum um_status bind_integer(struct binder *b, const struct um_schema_field *field,
                                   const struct um_node *node, int *out)
{
  double value;
  if (node->kind == UM_NODE_SCALAR &&
      (node->typed ? node->number != trunc(node->number) : strpbrk(node->text, ".eE") != NULL))
    return fail_type(b, field, node);
  UM_TRY(bind_number(b, field, node, &value));
  if (!(fabs(value) <= INT_MAX)) return fail_type(b, field, node);
  *out = (int)value;
  return UM_OK;
}

static enum um_status bind_bool(struct binder *b, const struct um_schema_field *field,
                                const struct um_node *node, bool *out)
{
  if (node->kind == UM_NODE_SCALAR && node->plain) {
    *out = strcmp(node->text, "true") == 0;
    if (*out || strcmp(node->text, "false") == 0) return UM_OK;
  }
  return fail_type(b, field, node);
}

static enum um_status bind_text(struct binder *b, const struct um_schema_field *field,
                                const struct um_node *node, const char **out)
{
  if (node->kind != UM_NODE_SCALAR || (field->name && !um_core_name_is_safe(node->text)))
    return fail_type(b, field, node);
  if (!um_core_text_is_plain(node->text))
    return um_document_mark_fail(b->context, &node->at,
                                 "'%.100s' holds a control character; accepted: a text without",
                                 node->text);
  *out = node->text;
  return UM_OK;
}

static enum um_status bind_choice(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *node, int *out)
{
  if (node->kind != UM_NODE_SCALAR) return fail_type(b, field, node);
  for (int i = 0; field->choices[i] != NULL; i++)
    if (strcmp(node->text, field->choices[i]) == 0) {
      *out = i;
      return UM_OK;
    }
  return fail_type(b, field, node);
}

static enum um_status bind_vector(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *node, double *out)
{
  if (node->kind != UM_NODE_LIST || node->count != field->length) return fail_type(b, field, node);
  struct um_schema_field element = *field;
  element.type = UM_SCHEMA_NUMBER;
  size_t i = 0;
  for (const struct um_node *n = node->first; n != NULL; n = n->next)
    UM_TRY(bind_number(b, &element, n, &out[i++]));
  return UM_OK;
}

static enum um_status bind_values(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *node, struct um_schema_list *out)
{
  if (node->kind != UM_NODE_LIST) return fail_type(b, field, node);
  UM_TRY(check_count(b, field, node));
  bool numbers = field->type == UM_SCHEMA_NUMBERS;
  double *value;
  const char **text;
  size_t size = numbers ? sizeof *value : sizeof *text;
  UM_TRY(um_document_allocate(b->context, b->document, node->count, size, &out->items));
  value = out->items;
  text = out->items;
  struct um_schema_field element = *field;
  element.type = numbers ? UM_SCHEMA_NUMBER : UM_SCHEMA_TEXT;
  for (const struct um_node *n = node->first; n != NULL; n = n->next, out->count++) {
    if (numbers)
      UM_TRY(bind_number(b, &element, n, &value[out->count]));
    else
      UM_TRY(bind_text(b, &element, n, &text[out->count]));
  }
  return UM_OK;
}

static enum um_status bind_parsed(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *node, void *out)
{
  if (node->kind != UM_NODE_SCALAR) return fail_type(b, field, node);
  char why[256] = "";
  if (node->typed && !node->as_written && field->length == sizeof node->number) {
    memcpy(out, &node->number, sizeof node->number);
    return UM_OK;
  }
  if (field->parse(node->text, out, why, sizeof why)) return UM_OK;
  return um_document_mark_fail(b->context, &node->at, "'%.100s' is not accepted; accepted: %s",
                               node->text, why);
}

/* A mapping, or a single value when the object has a key for one. */
static enum um_status bind_element(struct binder *b, const struct um_schema_field *field,
                                   const struct um_node *node, char *target)
{
  bool scalar = node->kind == UM_NODE_SCALAR && field->object->scalar_key != NULL;
  if (node->kind != UM_NODE_MAP && !scalar) return fail_type(b, field, node);
  return bind_object(b, field->object, node, target);
}

static enum um_status bind_list(struct binder *b, const struct um_schema_field *field,
                                const struct um_node *node, struct um_schema_list *out)
{
  bool dict = field->type == UM_SCHEMA_DICT;
  if (node->kind != (dict ? UM_NODE_MAP : UM_NODE_LIST)) return fail_type(b, field, node);
  UM_TRY(check_count(b, field, node));
  size_t size = field->object->size;
  char *items;
  UM_TRY(um_document_allocate(b->context, b->document, node->count, size, &items));
  out->items = items;
  struct um_schema_field element = *field;
  element.type = UM_SCHEMA_MAP;
  for (const struct um_node *n = node->first; n != NULL; n = n->next, out->count++) {
    char *item = items + out->count * size;
    if (dict && !(field->behind ? um_core_name_is_safe_behind : um_core_name_is_safe)(n->key))
      return um_document_mark_fail(
          b->context, &n->at, "'%.100s' is not accepted; accepted: %s", n->key,
          field->behind ? UM_CORE_NAME_ACCEPTED_BEHIND : UM_CORE_NAME_ACCEPTED);
    UM_TRY(bind_element(b, &element, n, item));
    if (dict) memcpy(item + sizeof(struct um_mark), &n->key, sizeof n->key);
  }
  return UM_OK;
}

static enum um_status bind_map(struct binder *b, const struct um_schema_field *field,
                               const struct um_node *node, char *target)
{
  char *item;
  UM_TRY(um_document_allocate(b->context, b->document, 1, field->object->size, &item));
  UM_TRY(bind_element(b, field, node, item));
  memcpy(target, &item, sizeof item);
  return UM_OK;
}

/* Every key that no field names, as a number. */
static enum um_status bind_rest(struct binder *b, const struct um_schema_object *object,
                                const struct um_schema_field *field, const struct um_node *node,
                                struct um_schema_list *out)
{
  struct um_schema_number *item;
  struct um_schema_field number = *field;
  number.type = UM_SCHEMA_NUMBER;
  if (node->kind != UM_NODE_MAP) return UM_OK;
  UM_TRY(um_document_allocate(b->context, b->document, node->count, sizeof *item, &item));
  out->items = item;
  for (const struct um_node *n = node->first; n != NULL; n = n->next) {
    if (um_document_schema_find(object, n->key) != NULL) continue;
    item[out->count].at = n->at;
    item[out->count].name = n->key;
    UM_TRY(bind_number(b, &number, n, &item[out->count].value));
    out->count++;
  }
  return UM_OK;
}

static enum um_status bind_field(struct binder *b, const struct um_schema_field *field,
                                 const struct um_node *node, char *target)
{
  void *at = target + field->offset;
  switch (field->type) {
  case UM_SCHEMA_NUMBER:
    return bind_number(b, field, node, at);
  case UM_SCHEMA_INTEGER:
    return bind_integer(b, field, node, at);
  case UM_SCHEMA_BOOL:
    return bind_bool(b, field, node, at);
  case UM_SCHEMA_TEXT:
    return bind_text(b, field, node, at);
  case UM_SCHEMA_CHOICE:
    return bind_choice(b, field, node, at);
  case UM_SCHEMA_VECTOR:
    return bind_vector(b, field, node, at);
  case UM_SCHEMA_NUMBERS:
  case UM_SCHEMA_TEXTS:
    return bind_values(b, field, node, at);
  case UM_SCHEMA_MAP:
    return bind_map(b, field, node, at);
  case UM_SCHEMA_LIST:
  case UM_SCHEMA_DICT:
    return bind_list(b, field, node, at);
  case UM_SCHEMA_PARSED:
    return bind_parsed(b, field, node, at);
  case UM_SCHEMA_REST:
    break; /* by bind_rest, with the whole mapping */
  }
  return UM_OK;
}

/* What an absent key leaves; the target is zeroed before. */
static void set_default(const struct um_schema_field *field, char *target)
{
  double value = field->default_value;
  bool none = isnan(value);
  char *at = target + field->offset;
  if (field->type == UM_SCHEMA_NUMBER ||
      (field->type == UM_SCHEMA_PARSED && field->length == sizeof value && value != 0.0)) {
    memcpy(at, &value, sizeof value);
  } else if (field->type == UM_SCHEMA_VECTOR) {
    for (size_t i = 0; i < field->length; i++) memcpy(at + i * sizeof value, &value, sizeof value);
  } else if (field->type == UM_SCHEMA_INTEGER || field->type == UM_SCHEMA_CHOICE) {
    int number = !none ? (int)value : field->type == UM_SCHEMA_CHOICE ? -1 : INT_MIN;
    memcpy(at, &number, sizeof number);
  } else if (field->type == UM_SCHEMA_BOOL) {
    bool flag = !none && value != 0.0;
    memcpy(at, &flag, sizeof flag);
  }
}

static enum um_status fail_missing(struct binder *b, const struct um_schema_object *object,
                                   const struct um_schema_field *field, const struct um_node *node)
{
  char accepted[512];
  um_document_schema_accepted(field, accepted, sizeof accepted);
  return um_document_mark_fail(b->context, &node->at, "key '%s' of the %s is missing; accepted: %s",
                               field->key, object->name, accepted);
}

/* A mapping that is not written, read as an empty one: it stands where its parent does. */
static enum um_status bind_absent(struct binder *b, const struct um_schema_field *field,
                                  const struct um_node *parent, char *target)
{
  struct um_node empty = {.kind = UM_NODE_MAP, .at = parent->at};
  empty.at.node = NULL;
  return bind_field(b, field, &empty, target);
}

static enum um_status bind_object(struct binder *b, const struct um_schema_object *object,
                                  const struct um_node *node, char *target)
{
  memcpy(target, &node->at, sizeof node->at);
  bool scalar = node->kind == UM_NODE_SCALAR;
  if (!scalar) UM_TRY(um_document_schema_check_keys(b->context, object, node));
  for (size_t i = 0; i < object->nfield; i++) {
    const struct um_schema_field *field = &object->fields[i];
    const struct um_node *child = NULL;
    if (field->type == UM_SCHEMA_REST) {
      UM_TRY(bind_rest(b, object, field, node, (void *)(target + field->offset)));
      continue;
    }
    if (!scalar)
      child = um_document_node_child(node, field->key);
    else if (strcmp(field->key, object->scalar_key) == 0)
      child = node;
    if (child != NULL)
      UM_TRY(bind_field(b, field, child, target));
    else if (field->required && !scalar)
      return fail_missing(b, object, field, node);
    else if (field->always)
      UM_TRY(bind_absent(b, field, node, target));
    else
      set_default(field, target);
  }
  return UM_OK;
}

enum um_status um_document_bind(struct um_document *document, const struct um_schema_object *schema,
                                void **root)
{
  struct binder b = {document, document->context};
  const struct um_schema_field whole = {
      .key = schema->name, .type = UM_SCHEMA_MAP, .object = schema};
  char *target = NULL;
  UM_TRY(bind_map(&b, &whole, document->root, (char *)&target));
  *root = target;
  return UM_OK;
}
