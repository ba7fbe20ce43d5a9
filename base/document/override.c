/* "--set key.path=value", or a change, applied to the tree of a document.
 *
 * A path is walked from the root. In a mapping the longest key that fits is taken, in a list the
 * longest label (name, effect:target, effect) that fits, or a position counted from 0; so names
 * with dots in them are still reached. Missing mappings are made; a list grows by one element at a
 * path that ends in "+". */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "base/document/document_impl.h"

#define NEXT "+" /* the element behind the last one of a list */

struct walk {
  struct um_document *document;
  const char *key; /* whole path, for messages */
  const char *rest;
  bool look; /* nothing is made: a node that is not there is NULL */
};

/* Does `word` stand at the start of `rest`, followed by a dot or the end? */
static bool fits(const char *rest, const char *word)
{
  size_t n = strlen(word);
  return n > 0 && strncmp(rest, word, n) == 0 && (rest[n] == '\0' || rest[n] == '.');
}

static const char *behind(const char *rest, size_t length)
{
  return rest[length] == '.' ? rest + length + 1 : rest + length;
}

static enum um_status fail_walk(const struct walk *w, const char *problem, const char *accepted)
{
  return um_core_fail(w->document->context, UM_ERR_INPUT, "--set: %s: %s%s%s", w->key, problem,
                      accepted[0] != '\0' ? "; accepted: " : "", accepted);
}

/* A new last child; key NULL in a list. */
static enum um_status add_child(struct walk *w, struct um_node *parent, const char *key,
                                struct um_node **out)
{
  struct um_node *made;
  UM_TRY(um_document_allocate(w->document->context, w->document, 1, sizeof *made, &made));
  made->key = key;
  made->kind = UM_NODE_NULL;
  made->at.file = "--set";
  made->set = true;
  made->text = "";
  if (parent->last == NULL)
    parent->first = made;
  else
    parent->last->next = made;
  parent->last = made;
  parent->count++;
  *out = made;
  return UM_OK;
}

/* The child of a mapping, made when missing. */
static enum um_status step_map(struct walk *w, struct um_node *map, struct um_node **out)
{
  struct um_node *best = NULL;
  for (struct um_node *n = map->first; n != NULL; n = n->next)
    if (fits(w->rest, n->key) && (best == NULL || strlen(n->key) > strlen(best->key))) best = n;
  if (best != NULL) {
    w->rest = behind(w->rest, strlen(best->key));
    *out = best;
    return UM_OK;
  }
  *out = NULL;
  if (w->look) return UM_OK;
  size_t length = strcspn(w->rest, ".");
  if (length == 0) return fail_walk(w, "an empty part between dots", "names joined by single dots");
  const char *key;
  UM_TRY(um_document_copy_text(w->document, w->rest, length, &key));
  w->rest = behind(w->rest, length);
  return add_child(w, map, key, out);
}

/* Longest label that fits; counts how many elements share it. */
static enum um_status find_label(struct walk *w, struct um_node *list, bool effect_only,
                                 struct um_node **out, size_t *length, size_t *matches)
{
  *out = NULL;
  *length = *matches = 0;
  for (struct um_node *n = list->first; n != NULL; n = n->next) {
    const char *label = NULL;
    if (effect_only) {
      const struct um_node *effect = um_document_node_child(n, "effect");
      if (effect != NULL && effect->kind == UM_NODE_SCALAR) label = effect->text;
    } else {
      UM_TRY(um_document_node_label(w->document, n, &label));
    }
    if (label == NULL || !fits(w->rest, label) || strlen(label) < *length) continue;
    *matches = strlen(label) == *length ? *matches + 1 : 1;
    *length = strlen(label);
    *out = n;
  }
  return UM_OK;
}

static enum um_status fail_element(const struct walk *w, const struct um_node *list, size_t matches)
{
  char have[512] = "", problem[256];
  size_t index = 0;
  for (const struct um_node *n = list->first; n != NULL; n = n->next, index++) {
    const char *label;
    char number[24];
    UM_TRY(um_document_node_label(w->document, n, &label));
    snprintf(number, sizeof number, "%zu", index);
    um_core_words_append(have, sizeof have, label != NULL && matches == 0 ? label : number);
  }
  int length = (int)strcspn(w->rest, ".");
  if (matches > 1)
    snprintf(problem, sizeof problem, "'%.*s' fits %zu list elements, use the position", length,
             w->rest, matches);
  else
    snprintf(problem, sizeof problem, "no list element '%.*s'", length, w->rest);
  return fail_walk(w, problem, have[0] != '\0' ? have : "none, the list is empty");
}

static enum um_status step_list(struct walk *w, struct um_node *list, struct um_node **out)
{
  size_t length, matches;
  if (strcmp(w->rest, NEXT) == 0) {
    *out = NULL;
    if (w->look) return UM_OK;
    w->rest = behind(w->rest, strlen(NEXT));
    return add_child(w, list, NULL, out);
  }
  UM_TRY(find_label(w, list, false, out, &length, &matches));
  if (matches == 0) UM_TRY(find_label(w, list, true, out, &length, &matches));
  if (matches > 1) return fail_element(w, list, matches);
  if (matches == 1) {
    w->rest = behind(w->rest, length);
    return UM_OK;
  }
  length = strcspn(w->rest, ".");
  if (length == 0 || length > 9 || strspn(w->rest, "0123456789") != length)
    return fail_element(w, list, 0);
  size_t index = (size_t)strtoul(w->rest, NULL, 10);
  struct um_node *n = list->first;
  while (n != NULL && index > 0) {
    n = n->next;
    index--;
  }
  if (n == NULL) return fail_element(w, list, 0);
  w->rest = behind(w->rest, length);
  *out = n;
  return UM_OK;
}

/* The node that the path addresses. */
static enum um_status find_target(struct walk *w, struct um_node **out)
{
  struct um_node *node = w->document->root;
  size_t n = strlen(w->key);
  if (n > 0 && w->key[n - 1] == '.')
    return fail_walk(w, "an empty part behind the last dot", "names joined by single dots");
  for (int depth = 0; w->rest[0] != '\0'; depth++) {
    if (depth == UM_NODE_DEPTH_MAX) return fail_walk(w, "nested too deep", "");
    if (node == NULL || (w->look && node->kind == UM_NODE_NULL)) break;
    if (node->kind == UM_NODE_NULL) {
      node->kind = strcmp(w->rest, NEXT) == 0 ? UM_NODE_LIST : UM_NODE_MAP;
      node->flow = true;
    }
    if (node->kind == UM_NODE_MAP)
      UM_TRY(step_map(w, node, &node));
    else if (node->kind == UM_NODE_LIST)
      UM_TRY(step_list(w, node, &node));
    else
      return fail_walk(w, "leads into a single value, which has no parts", "");
  }
  *out = node;
  return UM_OK;
}

/* The target keeps its place among its siblings and takes over the value's content. */
static void replace(struct um_node *target, const struct um_node *value)
{
  struct um_node old = *target;
  *target = *value;
  target->key = old.key;
  target->key_line = old.key_line;
  target->key_place = old.key_place;
  target->place = old.place;
  target->next = old.next;
}

/* YAML text at a key; both are the document's own. libfyaml reads from them while the tree is made.
 */
static enum um_status set_text(struct um_document *document, const char *key, const char *value)
{
  struct um_context *context = document->context;
  struct um_node *node = NULL, *target = document->root;
  char *name;
  UM_TRY(um_document_check_text(context, "--set", key, strlen(key)));
  UM_TRY(um_document_allocate(context, document, strlen(key) + 8, 1, &name));
  snprintf(name, strlen(key) + 8, "--set: %s", key);
  UM_TRY(um_document_check_text(context, name, value, strlen(value)));
  UM_TRY(um_document_yaml_load(document, name, false, value, strlen(value), &node));
  struct walk w = {document, key, key, false};
  UM_TRY(find_target(&w, &target));
  replace(target, node);
  return UM_OK;
}

enum um_status um_document_set(struct um_document *document, const char *override)
{
  struct um_context *context = document->context;
  const char *equals = strchr(override, '='), *key, *value;
  if (equals == NULL || equals == override)
    return um_core_fail(context, UM_ERR_INPUT, "--set: '%s'; accepted: KEY=VALUE", override);
  UM_TRY(um_document_copy_text(document, override, (size_t)(equals - override), &key));
  UM_TRY(um_document_copy_text(document, equals + 1, strlen(equals + 1), &value));
  return set_text(document, key, value);
}

/* Digits that give the number back, to the sign of -0. */
static void write_number(double number, char out[32])
{
  if (isfinite(number) && number != 0.0)
    um_core_number_text(number, out);
  else
    snprintf(out, 32, "%g", number);
}

enum um_status um_document_set_change(struct um_document *document,
                                      const struct um_document_change *change)
{
  char digits[32];
  const char *key, *text = change->text;
  struct um_node *target = document->root;
  UM_TRY(um_document_copy_text(document, change->key, strlen(change->key), &key));
  write_number(change->number, digits);
  if (text == NULL) text = digits;
  UM_TRY(um_document_copy_text(document, text, strlen(text), &text));
  if (isnan(change->number)) return set_text(document, key, text);
  struct walk w = {document, key, key, false};
  UM_TRY(find_target(&w, &target));
  const struct um_node value = {.kind = UM_NODE_SCALAR,
                                .at.file = "--set",
                                .text = text,
                                .typed = true,
                                .as_written = change->as_written,
                                .number = change->number,
                                .plain = true,
                                .set = true};
  replace(target, &value);
  return UM_OK;
}

/* Position of a child, as text. */
static void append_position(const struct um_node *list, const struct um_node *child, char *out,
                            size_t size)
{
  size_t index = 0, used = strlen(out);
  for (const struct um_node *n = list->first; n != child && n != NULL; n = n->next) index++;
  snprintf(out + used, size - used, ".%zu", index);
}

/* One step of a walk that makes nothing, and the name of it that has one spelling. */
static enum um_status name_step(struct walk *w, struct um_node **node, char *out, size_t size)
{
  struct um_node *from = *node;
  if (from->kind == UM_NODE_MAP) {
    UM_TRY(step_map(w, from, node));
    size_t used = strlen(out);
    if (*node != NULL) snprintf(out + used, size - used, ".%s", (*node)->key);
    return UM_OK;
  }
  UM_TRY(step_list(w, from, node));
  if (*node != NULL) append_position(from, *node, out, size);
  return UM_OK;
}

void um_document_place(struct um_document *document, const char *key, char *out, size_t size)
{
  struct walk w = {document, key, key, true};
  struct um_node *node = document->root;
  out[0] = '\0';
  while (node != NULL && w.rest[0] != '\0' &&
         (node->kind == UM_NODE_MAP || node->kind == UM_NODE_LIST)) {
    if (name_step(&w, &node, out, size) == UM_OK) continue;
    um_core_message_clear(document->context); /* what is wrong with it is said where it is set */
    node = NULL;
  }
  size_t used = strlen(out);
  if (w.rest[0] != '\0') snprintf(out + used, size - used, ".%s", w.rest);
}

/* NaN: it is none. */
static double number_of(const struct um_node *node)
{
  char *end;
  if (!node->plain) return NAN;
  if (node->typed) return node->number;
  double value = strtod(node->text, &end);
  return end == node->text || *end != '\0' ? (double)NAN : value;
}

static enum um_status names_of(struct um_document *document, const struct um_node *node,
                               const char *const **out)
{
  const char **name;
  size_t n = 0;
  UM_TRY(um_document_allocate(document->context, document, node->count + 1, sizeof *name, &name));
  for (const struct um_node *child = node->first; child != NULL; child = child->next)
    name[n++] = child->key;
  *out = name;
  return UM_OK;
}

enum um_status um_document_value(struct um_document *document, const char *key,
                                 struct um_document_value *out)
{
  struct walk w = {document, key, key, true};
  struct um_node *node = NULL;
  *out = (struct um_document_value){.kind = UM_DOCUMENT_NOTHING, .number = NAN};
  UM_TRY(find_target(&w, &node));
  if (node == NULL || node->kind == UM_NODE_NULL || w.rest[0] != '\0') return UM_OK;
  if (node->kind == UM_NODE_SCALAR) {
    out->number = number_of(node);
    out->kind = isnan(out->number) ? UM_DOCUMENT_TEXT : UM_DOCUMENT_NUMBER;
    out->text = node->text;
    out->quoted = !node->plain;
    return UM_OK;
  }
  out->kind = node->kind == UM_NODE_LIST ? UM_DOCUMENT_LIST : UM_DOCUMENT_GROUP;
  out->count = node->count;
  return node->kind == UM_NODE_MAP ? names_of(document, node, &out->name) : UM_OK;
}

double um_document_number(struct um_document *document, const char *key)
{
  struct um_document_value value;
  if (um_document_value(document, key, &value) != UM_OK) um_core_message_clear(document->context);
  return value.number;
}
