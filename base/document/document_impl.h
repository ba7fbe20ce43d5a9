/* Documents: tree, reading, emission, overrides. Private to base/document/. */
#ifndef UMBRA_DOCUMENT_DOCUMENT_IMPL_H
#define UMBRA_DOCUMENT_DOCUMENT_IMPL_H

#include "base/core/arena.h"
#include "base/document/schema.h"

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
  const char *text; /* of a scalar */
  bool typed;       /* a scalar whose value is `number`, and `text` how it is written */
  bool as_written;  /* of a typed one: a parsed field reads the text */
  double number;
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
  struct um_core_arena memory;
  const char *path;
  const char *source; /* text as read */
  size_t source_length;
  struct um_node *root;
  size_t set_count;           /* overrides applied */
  struct um_document *origin; /* owned, of a changed one; NULL: none */
};

/* Valid UTF-8 without control characters, or UM_ERR_INPUT with the line. */
enum um_status um_document_check_text(struct um_context *context, const char *name,
                                      const char *text, size_t length);
enum um_status um_document_copy_text(struct um_document *document, const char *text, size_t length,
                                     const char **out);
/* "name", or "effect", or "effect:target" of a mapping that stands in a list; NULL when it has
 * none. The document owns the text. */
enum um_status um_document_node_label(struct um_document *document, const struct um_node *node,
                                      const char **out);
const struct um_node *um_document_node_child(const struct um_node *map, const char *key);
bool um_document_node_equal(const struct um_node *a, const struct um_node *b);

/* yaml.c is the only file that knows libfyaml. Text to tree; memory is the document's. `name` is
 * what messages call it; from_file: marks carry the name and lines, otherwise "--set" and no line.
 * UM_ERR_INPUT: not YAML, empty, more than one document, alias, anchor, tag, duplicate key, key
 * that is no scalar. */
enum um_status um_document_yaml_load(struct um_document *document, const char *name, bool from_file,
                                     const char *text, size_t length, struct um_node **out);

struct um_emitter {
  struct um_context *context;
  char *text; /* NUL behind it; NULL while empty; the owner frees */
  size_t length, capacity;
};

/* All: UM_ERR_MEMORY. */
enum um_status um_document_emit_bytes(struct um_emitter *b, const char *text, size_t length);
enum um_status um_document_emit(struct um_emitter *b, const char *text);
enum um_status um_document_emit_indent(struct um_emitter *b, size_t columns);
/* A key, in quotes where it needs them. */
enum um_status um_document_emit_key(struct um_emitter *b, const char *key);
/* A subtree on one line; inside: it stands in brackets. */
enum um_status um_document_emit_flow(struct um_emitter *b, const struct um_node *node, bool inside);
/* A whole document in block layout. */
enum um_status um_document_emit_document(struct um_emitter *b, const struct um_node *root);

/* Apply one "key.path=yaml value" to the tree. */
enum um_status um_document_set(struct um_document *document, const char *override);
/* Apply one change to the tree: a number arrives with all its bits. */
enum um_status um_document_set_change(struct um_document *document,
                                      const struct um_document_change *change);

/* Check the tree against the schema and bind it. */
enum um_status um_document_bind(struct um_document *document, const struct um_schema_object *schema,
                                void **root);

/* The field that a key names, NULL when there is none; the rest field has no name. */
const struct um_schema_field *um_document_schema_find(const struct um_schema_object *object,
                                                      const char *key);

/* UM_ERR_INPUT for an unknown key (the nearest known one is named), for two keys of one group, and
 * for none of a group of which one is required. */
enum um_status um_document_schema_check_keys(struct um_context *context,
                                             const struct um_schema_object *object,
                                             const struct um_node *node);

#endif
