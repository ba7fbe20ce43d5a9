/* The tree behind a document: what YAML text says, with the place of every value. */
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
  size_t set_count; /* overrides applied */
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

#endif
