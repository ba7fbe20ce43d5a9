/* A YAML document as it is kept: its memory, its nodes, marks of what stands where. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/document/document_impl.h"

enum um_status um_document_allocate(struct um_context *context, struct um_document *document,
                                    size_t count, size_t size, void *out)
{
  return um_core_arena_allocate(context, &document->memory, count, size, out);
}

enum um_status um_document_copy_text(struct um_document *document, const char *text, size_t length,
                                     const char **out)
{
  char *copy;
  *out = NULL;
  UM_TRY(um_document_allocate(document->context, document, length + 1, 1, &copy));
  if (length > 0) memcpy(copy, text, length);
  *out = copy;
  return UM_OK;
}

const struct um_node *um_document_node_child(const struct um_node *map, const char *key)
{
  for (const struct um_node *n = map->first; n != NULL; n = n->next)
    if (n->key != NULL && strcmp(n->key, key) == 0) return n;
  return NULL;
}

/* The sign of 0 counts: it turns directions about. */
static bool same_number(double a, double b) { return a == b && !signbit(a) == !signbit(b); }

bool um_document_node_equal(const struct um_node *a, const struct um_node *b)
{
  if (a->kind != b->kind || a->count != b->count) return false;
  if ((a->key == NULL) != (b->key == NULL)) return false;
  if (a->key != NULL && strcmp(a->key, b->key) != 0) return false;
  if (a->kind == UM_NODE_SCALAR && (a->plain != b->plain || a->typed != b->typed)) return false;
  if (a->kind == UM_NODE_SCALAR &&
      (a->typed ? !same_number(a->number, b->number) : strcmp(a->text, b->text) != 0))
    return false;
  const struct um_node *p = a->first, *q = b->first;
  for (; p != NULL && q != NULL; p = p->next, q = q->next)
    if (!um_document_node_equal(p, q)) return false;
  return p == NULL && q == NULL;
}

bool um_document_same(const struct um_document *a, const struct um_document *b, const char *path)
{
  const struct um_node *p = a->root, *q = b->root;
  if (a == b) return true;
  while (path[0] != '\0' && p != NULL && q != NULL) {
    char key[64];
    size_t length = strcspn(path, ".");
    snprintf(key, sizeof key, "%.*s", (int)length, path);
    p = p->kind == UM_NODE_MAP ? um_document_node_child(p, key) : NULL;
    q = q->kind == UM_NODE_MAP ? um_document_node_child(q, key) : NULL;
    path += path[length] == '.' ? length + 1 : length;
  }
  return p == NULL || q == NULL ? p == q : um_document_node_equal(p, q);
}

static const char *scalar_text(const struct um_node *map, const char *key)
{
  const struct um_node *n = um_document_node_child(map, key);
  return n != NULL && n->kind == UM_NODE_SCALAR ? n->text : NULL;
}

enum um_status um_document_node_label(struct um_document *document, const struct um_node *node,
                                      const char **out)
{
  *out = NULL;
  if (node->kind != UM_NODE_MAP) return UM_OK;
  *out = scalar_text(node, "name");
  if (*out != NULL) return UM_OK;
  const char *effect = scalar_text(node, "effect"), *target = scalar_text(node, "target");
  *out = effect;
  if (effect == NULL || target == NULL) return UM_OK;
  size_t n = strlen(effect), m = strlen(target);
  char *label;
  UM_TRY(um_document_allocate(document->context, document, n + m + 2, 1, &label));
  memcpy(label, effect, n);
  label[n] = ':';
  memcpy(label + n + 1, target, m + 1);
  *out = label;
  return UM_OK;
}

enum um_status um_document_check_text(struct um_context *context, const char *name,
                                      const char *text, size_t length)
{
  int line = 1;
  for (size_t i = 0; i < length;) {
    unsigned char c = (unsigned char)text[i];
    size_t n = c < 0x80 ? 1 : c >= 0xc2 && c < 0xe0 ? 2 : c >= 0xe0 && c < 0xf0 ? 3 : 0;
    if (c >= 0xf0 && c < 0xf5) n = 4;
    bool good =
        n > 0 && n <= length - i && c != 0x7f && (c >= 0x20 || c == '\t' || c == '\n' || c == '\r');
    for (size_t k = 1; good && k < n; k++) good = ((unsigned char)text[i + k] & 0xc0) == 0x80;
    if (good && n == 3) {
      unsigned char d = (unsigned char)text[i + 1];
      good = !(c == 0xe0 && d < 0xa0) && !(c == 0xed && d >= 0xa0);
    }
    if (good && n == 4) {
      unsigned char d = (unsigned char)text[i + 1];
      good = !(c == 0xf0 && d < 0x90) && !(c == 0xf4 && d >= 0x90);
    }
    if (!good)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s:%d: not text (byte 0x%02x); accepted: YAML in UTF-8", name, line, c);
    if (c == '\n') line++;
    i += n;
  }
  return UM_OK;
}

void um_document_keep_origin(struct um_document *document, struct um_document **origin)
{
  document->origin = *origin;
  *origin = NULL;
}

void um_document_destroy(struct um_document **document)
{
  if (document == NULL || *document == NULL) return;
  struct um_context *context = (*document)->context;
  um_document_destroy(&(*document)->origin);
  um_core_arena_release(context, &(*document)->memory);
  um_core_free(context, *document);
  *document = NULL;
}

const struct um_mark *um_document_mark_key(const struct um_mark *parent, const char *key)
{
  if (parent->node == NULL || parent->node->kind != UM_NODE_MAP || key == NULL) return parent;
  const struct um_node *child = um_document_node_child(parent->node, key);
  return child == NULL ? parent : &child->at;
}

enum um_status um_document_mark_fail(struct um_context *context, const struct um_mark *at,
                                     const char *format, ...)
{
  char text[896];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  const char *path = at->path != NULL ? at->path : "", *colon = path[0] != '\0' ? ": " : "";
  const char *file = at->file != NULL ? at->file : "";
  if (at->line > 0)
    return um_core_fail(context, UM_ERR_INPUT, "%s:%d: %s%s%s", file, at->line, path, colon, text);
  return um_core_fail(context, UM_ERR_INPUT, "%s: %s%s%s", file, path, colon, text);
}
