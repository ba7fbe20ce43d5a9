/* A YAML document: text, tree, overrides, memory. */
#include <stdint.h>
#include <string.h>

#include "core/document_impl.h"
#include "core/file.h"

#define DOCUMENT_BYTES_MAX ((size_t)8 << 20)
#define ARENA_BLOCK        ((size_t)16 << 10) /* [bytes] */

struct arena_block {
  struct arena_block *next;
  size_t used, size; /* [bytes] behind the header */
  max_align_t data[];
};

enum um_status um_core_document_allocate(struct um_context *context, struct um_document *document,
                                         size_t count, size_t size, void *out)
{
  char *at = NULL;
  memcpy(out, &at, sizeof at);
  if (size != 0 && count > SIZE_MAX / 4 / size)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu objects of %zu bytes", count,
                        size);
  size_t unit = sizeof(max_align_t), bytes = (count * size + unit) / unit * unit;
  struct arena_block *block = document->blocks;
  if (block == NULL || block->size - block->used < bytes) {
    size_t room = bytes > ARENA_BLOCK ? bytes : ARENA_BLOCK;
    UM_TRY(um_core_allocate(context, 1, sizeof *block + room, &block));
    block->size = room;
    block->next = document->blocks;
    document->blocks = block;
  }
  at = (char *)block->data + block->used;
  block->used += bytes;
  memcpy(out, &at, sizeof at);
  return UM_OK;
}

enum um_status um_core_document_copy_text(struct um_document *document, const char *text,
                                          size_t length, const char **out)
{
  char *copy;
  *out = NULL;
  UM_TRY(um_core_document_allocate(document->context, document, length + 1, 1, &copy));
  if (length > 0) memcpy(copy, text, length);
  *out = copy;
  return UM_OK;
}

const struct um_node *um_core_node_child(const struct um_node *map, const char *key)
{
  for (const struct um_node *n = map->first; n != NULL; n = n->next)
    if (n->key != NULL && strcmp(n->key, key) == 0) return n;
  return NULL;
}

bool um_core_node_equal(const struct um_node *a, const struct um_node *b)
{
  if (a->kind != b->kind || a->count != b->count) return false;
  if ((a->key == NULL) != (b->key == NULL)) return false;
  if (a->key != NULL && strcmp(a->key, b->key) != 0) return false;
  if (a->kind == UM_NODE_SCALAR && (a->plain != b->plain || strcmp(a->text, b->text) != 0))
    return false;
  const struct um_node *p = a->first, *q = b->first;
  for (; p != NULL && q != NULL; p = p->next, q = q->next)
    if (!um_core_node_equal(p, q)) return false;
  return p == NULL && q == NULL;
}

static const char *scalar_text(const struct um_node *map, const char *key)
{
  const struct um_node *n = um_core_node_child(map, key);
  return n != NULL && n->kind == UM_NODE_SCALAR ? n->text : NULL;
}

enum um_status um_core_node_label(struct um_document *document, const struct um_node *node,
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
  UM_TRY(um_core_document_allocate(document->context, document, n + m + 2, 1, &label));
  memcpy(label, effect, n);
  label[n] = ':';
  memcpy(label + n + 1, target, m + 1);
  *out = label;
  return UM_OK;
}

/* Give every node the path by which --set reaches it, and its mark the node. */
static enum um_status set_paths(struct um_document *document, struct um_node *node,
                                const char *path)
{
  node->at.path = path;
  node->at.node = node;
  size_t index = 0, n = strlen(path);
  for (struct um_node *child = node->first; child != NULL; child = child->next, index++) {
    const char *label = child->key;
    char number[24];
    if (label == NULL) UM_TRY(um_core_node_label(document, child, &label));
    if (label == NULL) {
      snprintf(number, sizeof number, "%zu", index);
      label = number;
    }
    char *text;
    size_t m = strlen(label), dot = n > 0;
    UM_TRY(um_core_document_allocate(document->context, document, n + m + 2, 1, &text));
    memcpy(text, path, n);
    if (dot) text[n] = '.';
    memcpy(text + n + dot, label, m + 1);
    UM_TRY(set_paths(document, child, text));
  }
  return UM_OK;
}

enum um_status um_core_document_check_text(struct um_context *context, const char *name,
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

static enum um_status parse_into(struct um_document *document, const char *path, const char *text,
                                 size_t length, const struct um_schema_object *schema,
                                 const char *const *overrides, size_t noverride, void **root)
{
  struct um_context *context = document->context;
  UM_TRY(um_core_document_copy_text(document, path, strlen(path), &document->path));
  UM_TRY(um_core_document_check_text(context, path, text, length));
  if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
    text += 3;
    length -= 3;
  }
  UM_TRY(um_core_document_copy_text(document, text, length, &document->source));
  document->source_length = length;
  UM_TRY(
      um_core_yaml_load(document, document->path, true, document->source, length, &document->root));
  for (size_t i = 0; i < noverride; i++) UM_TRY(um_core_document_set(document, overrides[i]));
  document->set_count = noverride;
  UM_TRY(set_paths(document, document->root, ""));
  return um_core_document_bind(document, schema, root);
}

static enum um_status parse_bytes(struct um_context *context, const char *path, const char *text,
                                  size_t length, const struct um_schema_object *schema,
                                  const char *const *overrides, size_t noverride,
                                  struct um_document **out, void **root)
{
  struct um_document *document;
  *out = NULL;
  *root = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *document, &document));
  document->context = context;
  enum um_status status =
      parse_into(document, path, text, length, schema, overrides, noverride, root);
  if (status == UM_OK) {
    *out = document;
  } else {
    *root = NULL;
    um_core_document_destroy(&document);
  }
  return status;
}

enum um_status um_core_document_parse(struct um_context *context, const char *path,
                                      const char *text, const struct um_schema_object *schema,
                                      const char *const *overrides, size_t noverride,
                                      struct um_document **out, void **root)
{
  return parse_bytes(context, path, text, strlen(text), schema, overrides, noverride, out, root);
}

enum um_status um_core_document_read(struct um_context *context, const char *path,
                                     const struct um_schema_object *schema,
                                     const char *const *overrides, size_t noverride,
                                     struct um_document **out, void **root)
{
  char *text;
  size_t length;
  *out = NULL;
  *root = NULL;
  UM_TRY(um_core_file_read(context, path, DOCUMENT_BYTES_MAX, &text, &length));
  enum um_status status =
      parse_bytes(context, path, text, length, schema, overrides, noverride, out, root);
  um_core_free(context, text);
  return status;
}

void um_core_document_destroy(struct um_document **document)
{
  if (document == NULL || *document == NULL) return;
  struct um_context *context = (*document)->context;
  struct arena_block *block = (*document)->blocks;
  while (block != NULL) {
    struct arena_block *next = block->next;
    um_core_free(context, block);
    block = next;
  }
  um_core_free(context, *document);
  *document = NULL;
}

const struct um_mark *um_core_mark_key(const struct um_mark *parent, const char *key)
{
  if (parent->node == NULL || parent->node->kind != UM_NODE_MAP || key == NULL) return parent;
  const struct um_node *child = um_core_node_child(parent->node, key);
  return child == NULL ? parent : &child->at;
}

enum um_status um_core_mark_fail(struct um_context *context, const struct um_mark *at,
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
