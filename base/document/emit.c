/* A tree of nodes as YAML text. */
#include <string.h>

#include "base/document/document_impl.h"

enum um_status um_document_emit_bytes(struct um_emitter *b, const char *text, size_t length)
{
  if (b->length + length + 1 > b->capacity) {
    size_t capacity = 2 * b->capacity + length + 256;
    UM_TRY(um_core_reallocate(b->context, capacity, 1, &b->text));
    b->capacity = capacity;
  }
  if (length > 0) memcpy(b->text + b->length, text, length);
  b->length += length;
  b->text[b->length] = '\0';
  return UM_OK;
}

enum um_status um_document_emit(struct um_emitter *b, const char *text)
{
  return um_document_emit_bytes(b, text, strlen(text));
}

enum um_status um_document_emit_indent(struct um_emitter *b, size_t columns)
{
  for (size_t i = 0; i < columns; i++) UM_TRY(um_document_emit(b, " "));
  return UM_OK;
}

/* C1 controls with NEL, the separators of lines and paragraphs, and the mark of byte order: YAML
 * takes some of them for the end of a line. UTF-8 has been checked. */
static bool breaks_line(const char *text, int *extra, char escape[8])
{
  const unsigned char *c = (const unsigned char *)text;
  if (c[0] == 0xc2 && c[1] >= 0x80 && c[1] < 0xa0) {
    snprintf(escape, 8, "\\x%02x", c[1]);
    *extra = 1;
  } else if (c[0] == 0xe2 && c[1] == 0x80 && (c[2] == 0xa8 || c[2] == 0xa9)) {
    snprintf(escape, 8, "\\u20%02x", c[2] - 0x80);
    *extra = 2;
  } else if (c[0] == 0xef && c[1] == 0xbb && c[2] == 0xbf) {
    snprintf(escape, 8, "\\ufeff");
    *extra = 2;
  }
  return *extra > 0;
}

/* A text that its own letters cannot tell without quotes. */
static bool needs_quotes(const char *text)
{
  for (const char *p = text; *p != '\0'; p++) {
    char escape[8];
    int extra = 0;
    if ((unsigned char)*p < 0x20 || *p == 0x7f || breaks_line(p, &extra, escape)) return true;
  }
  return false;
}

/* Double-quoted YAML. */
static enum um_status put_quoted(struct um_emitter *b, const char *text)
{
  UM_TRY(um_document_emit(b, "\""));
  for (const char *p = text; *p != '\0'; p++) {
    char escape[8];
    unsigned char c = (unsigned char)*p;
    int extra = 0; /* bytes beyond the first of what is escaped */
    if (c == '"' || c == '\\')
      snprintf(escape, sizeof escape, "\\%c", c);
    else if (c == '\n')
      snprintf(escape, sizeof escape, "\\n");
    else if (c < 0x20 || c == 0x7f)
      snprintf(escape, sizeof escape, "\\x%02x", c);
    else if (breaks_line(p, &extra, escape))
      p += extra;
    else
      snprintf(escape, sizeof escape, "%c", c);
    UM_TRY(um_document_emit(b, escape));
  }
  return um_document_emit(b, "\"");
}

/* A plain scalar keeps its text; in brackets some characters would end it. */
static enum um_status put_scalar(struct um_emitter *b, const struct um_node *node, bool flow)
{
  if (node->kind == UM_NODE_NULL) return um_document_emit(b, "null");
  if (node->plain && !(flow && strpbrk(node->text, ",[]{}") != NULL) && !needs_quotes(node->text))
    return um_document_emit(b, node->text);
  return put_quoted(b, node->text);
}

enum um_status um_document_emit_key(struct um_emitter *b, const char *key)
{
  static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./";
  if (strspn(key, plain) == strlen(key)) return um_document_emit(b, key);
  return put_quoted(b, key);
}

/* A whole subtree on one line. */
enum um_status um_document_emit_flow(struct um_emitter *b, const struct um_node *node, bool inside)
{
  if (node->kind == UM_NODE_SCALAR || node->kind == UM_NODE_NULL)
    return put_scalar(b, node, inside);
  bool map = node->kind == UM_NODE_MAP;
  UM_TRY(um_document_emit(b, map ? "{" : "["));
  for (const struct um_node *n = node->first; n != NULL; n = n->next) {
    if (n != node->first) UM_TRY(um_document_emit(b, ", "));
    if (map) {
      UM_TRY(um_document_emit_key(b, n->key));
      UM_TRY(um_document_emit(b, ": "));
    }
    UM_TRY(um_document_emit_flow(b, n, true));
  }
  return um_document_emit(b, map ? "}" : "]");
}

/* Can the text stand as a literal block ("|")? */
static bool is_block_text(const struct um_node *node)
{
  if (node->kind != UM_NODE_SCALAR || node->plain) return false;
  const char *text = node->text;
  size_t n = strlen(text);
  if (n < 2 || text[n - 1] != '\n' || text[n - 2] == '\n' || text[0] == '\n' || text[0] == ' ' ||
      text[0] == '\t')
    return false;
  for (const char *p = text; *p != '\0'; p++)
    if (((unsigned char)*p < 0x20 && *p != '\n') || *p == 0x7f) return false;
  return true;
}

static enum um_status put_block_text(struct um_emitter *b, const char *text, size_t indent)
{
  UM_TRY(um_document_emit(b, "|\n"));
  while (*text != '\0') {
    size_t n = strcspn(text, "\n");
    if (n > 0) UM_TRY(um_document_emit_indent(b, indent));
    UM_TRY(um_document_emit_bytes(b, text, n + 1));
    text += n + 1;
  }
  return UM_OK;
}

/* A subtree in block layout; the writer stands at column `indent`. Ends with a newline. */
static enum um_status put_block(struct um_emitter *b, const struct um_node *node, size_t indent)
{
  bool map = node->kind == UM_NODE_MAP;
  for (const struct um_node *n = node->first; n != NULL; n = n->next) {
    if (n != node->first) UM_TRY(um_document_emit_indent(b, indent));
    if (map)
      UM_TRY(um_document_emit_key(b, n->key));
    else
      UM_TRY(um_document_emit(b, "-"));
    if (map) UM_TRY(um_document_emit(b, ":"));
    bool block = n->count > 0 && !n->flow;
    if (block && map) {
      UM_TRY(um_document_emit(b, "\n"));
      UM_TRY(um_document_emit_indent(b, indent + 2));
      UM_TRY(put_block(b, n, indent + 2));
    } else if (block) {
      UM_TRY(um_document_emit(b, " "));
      UM_TRY(put_block(b, n, indent + 2));
    } else if (is_block_text(n)) {
      UM_TRY(um_document_emit(b, " "));
      UM_TRY(put_block_text(b, n->text, indent + 2));
    } else {
      UM_TRY(um_document_emit(b, " "));
      UM_TRY(um_document_emit_flow(b, n, false));
      UM_TRY(um_document_emit(b, "\n"));
    }
  }
  return UM_OK;
}

enum um_status um_document_emit_document(struct um_emitter *b, const struct um_node *root)
{
  if (root->count > 0 && !root->flow) return put_block(b, root, 0);
  UM_TRY(um_document_emit_flow(b, root, false));
  return um_document_emit(b, "\n");
}
