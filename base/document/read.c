/* From YAML text, or from a document that is at hand, to a bound one: check the text, parse,
 * override, name the paths, bind. */
#include <string.h>

#include "base/core/file.h"
#include "base/document/document_impl.h"

#define DOCUMENT_BYTES_MAX ((size_t)2 << 20) /* the library takes 250 times as much */
#define LABEL_LONGEST      256               /* in a path [bytes] */

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
    if (label == NULL) UM_TRY(um_document_node_label(document, child, &label));
    if (label == NULL) {
      snprintf(number, sizeof number, "%zu", index);
      label = number;
    }
    char *text;
    size_t m = strlen(label), dot = n > 0;
    if (m > LABEL_LONGEST) m = LABEL_LONGEST; /* every child repeats it */
    UM_TRY(um_document_allocate(document->context, document, n + m + 2, 1, &text));
    memcpy(text, path, n);
    if (dot) text[n] = '.';
    memcpy(text + n + dot, label, m);
    UM_TRY(set_paths(document, child, text));
  }
  return UM_OK;
}

static enum um_status parse_into(struct um_document *document, const char *path, const char *text,
                                 size_t length, const struct um_schema_object *schema,
                                 const char *const *overrides, size_t noverride, void **root)
{
  struct um_context *context = document->context;
  UM_TRY(um_document_copy_text(document, path, strlen(path), &document->path));
  UM_TRY(um_document_check_text(context, path, text, length));
  if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
    text += 3;
    length -= 3;
  }
  UM_TRY(um_document_copy_text(document, text, length, &document->source));
  document->source_length = length;
  UM_TRY(um_document_yaml_load(document, document->path, true, document->source, length,
                               &document->root));
  for (size_t i = 0; i < noverride; i++) UM_TRY(um_document_set(document, overrides[i]));
  document->set_count = noverride;
  UM_TRY(set_paths(document, document->root, ""));
  return um_document_bind(document, schema, root);
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
    um_document_destroy(&document);
  }
  return status;
}

enum um_status um_document_parse(struct um_context *context, const char *path, const char *text,
                                 const struct um_schema_object *schema,
                                 const char *const *overrides, size_t noverride,
                                 struct um_document **out, void **root)
{
  return parse_bytes(context, path, text, strlen(text), schema, overrides, noverride, out, root);
}

enum um_status um_document_read(struct um_context *context, const char *path,
                                const struct um_schema_object *schema, const char *const *overrides,
                                size_t noverride, struct um_document **out, void **root)
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

/* A tree of its own in the document's memory; texts stay those of the origin. */
static enum um_status copy_tree(struct um_document *document, const struct um_node *from,
                                struct um_node **out)
{
  struct um_node *copy, **link;
  UM_TRY(um_document_allocate(document->context, document, 1, sizeof *copy, &copy));
  *copy = *from;
  copy->first = copy->last = copy->next = NULL;
  link = &copy->first;
  for (const struct um_node *child = from->first; child != NULL; child = child->next) {
    UM_TRY(copy_tree(document, child, link));
    copy->last = *link;
    link = &(*link)->next;
  }
  *out = copy;
  return UM_OK;
}

static enum um_status change_into(struct um_document *document, const struct um_document *origin,
                                  const struct um_schema_object *schema,
                                  const struct um_document_change *change, size_t nchange,
                                  void **root)
{
  document->path = origin->path;
  document->source = origin->source;
  document->source_length = origin->source_length;
  document->set_count = origin->set_count + nchange;
  UM_TRY(copy_tree(document, origin->root, &document->root));
  for (size_t i = 0; i < nchange; i++) UM_TRY(um_document_set_change(document, &change[i]));
  UM_TRY(set_paths(document, document->root, ""));
  return um_document_bind(document, schema, root);
}

enum um_status um_document_change(struct um_context *context, const struct um_document *origin,
                                  const struct um_schema_object *schema,
                                  const struct um_document_change *change, size_t nchange,
                                  struct um_document **out, void **root)
{
  struct um_document *document;
  *out = NULL;
  *root = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *document, &document));
  document->context = context;
  enum um_status status = change_into(document, origin, schema, change, nchange, root);
  if (status != UM_OK) {
    *root = NULL;
    um_document_destroy(&document);
  }
  *out = document;
  return status;
}
