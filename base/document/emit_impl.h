/* Text that grows, and YAML put into it. Private to base/document/. */
#ifndef UMBRA_DOCUMENT_EMIT_IMPL_H
#define UMBRA_DOCUMENT_EMIT_IMPL_H

#include "base/document/document_impl.h"

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

#endif
