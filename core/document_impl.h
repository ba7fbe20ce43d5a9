/* The tree behind a document: what YAML text says, with the place of every value. */
#ifndef UMBRA_CORE_DOCUMENT_IMPL_H
#define UMBRA_CORE_DOCUMENT_IMPL_H

#include "core/schema.h"

#define UM_NODE_DEPTH_MAX 48

enum um_node_kind { UM_NODE_NULL, UM_NODE_SCALAR, UM_NODE_LIST, UM_NODE_MAP };

/* Position in the source text. */
struct um_node_place {
  size_t from, to; /* bytes [from, to) */
  size_t column;   /* bytes from the start of the line */
};

struct um_node {
  enum um_node_kind kind;
  struct um_mark at;
  const char *text;           /* of a scalar */
  bool plain;                 /* a scalar without quotes that is not a block */
  bool flow;                  /* a collection in brackets */
  bool set;                   /* came from an override */
  struct um_node_place place; /* of a scalar from the file */
  const char *key;            /* when the parent is a mapping; else NULL */
  int key_line;               /* 1-based; 0 = none */
  struct um_node_place key_place;
  struct um_node *first, *last, *next; /* children in order; next sibling */
  size_t count;                        /* of children */
};

struct um_document {
  struct um_context *context;
  struct arena_block *blocks;
  const char *path;
  const char *source; /* text as read */
  size_t source_length;
  struct um_node *root;
  size_t set_count; /* overrides applied */
};

/* yaml.c: the only file that knows libfyaml. Text to tree; memory is the document's. `name` is what
 * messages call it; from_file: marks carry the name and lines, otherwise "--set" and no line.
 * UM_ERR_INPUT: not YAML, empty, more than one document, alias, anchor, tag, duplicate key, key
 * that is no scalar. */
enum um_status um_core_yaml_load(struct um_document *document, const char *name, bool from_file,
                                 const char *text, size_t length, struct um_node **out);

/* document.c */
/* Valid UTF-8 without control characters, or UM_ERR_INPUT with the line. */
enum um_status um_core_document_check_text(struct um_context *context, const char *name,
                                           const char *text, size_t length);
enum um_status um_core_document_copy_text(struct um_document *document, const char *text,
                                          size_t length, const char **out);
/* "name", or "effect", or "effect:target" of a mapping that stands in a list; NULL when it has
 * none. The document owns the text. */
enum um_status um_core_node_label(struct um_document *document, const struct um_node *node,
                                  const char **out);
const struct um_node *um_core_node_child(const struct um_node *map, const char *key);
bool um_core_node_equal(const struct um_node *a, const struct um_node *b);
/* override.c: apply one "key.path=yaml value" to the tree. */
enum um_status um_core_document_set(struct um_document *document, const char *override);

/* schema_bind.c: check the tree against the schema and bind it. */
enum um_status um_core_document_bind(struct um_document *document,
                                     const struct um_schema_object *schema, void **root);

#endif
