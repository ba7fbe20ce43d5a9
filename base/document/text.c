/* A document as YAML text after its overrides.
 *
 * The text as read is edited where the overrides changed it, so that comments and layout stay. When
 * an edit is not possible (a collection was replaced) or does not read back as the same tree, the
 * whole tree is written anew, without comments. Where a new element goes is guessed from the text
 * around its last neighbour: the reading back tells whether that was right. */
#include <stdint.h>
#include <string.h>

#include "base/document/document_impl.h"

struct edit {
  size_t from, to;   /* bytes of the source to be replaced */
  size_t at, length; /* the replacement, in the pool */
};

struct edits {
  const char *source;
  size_t length;              /* of the source */
  const struct um_node *root; /* of the tree as read */
  struct um_emitter pool;     /* replacements */
  struct edit *list;
  size_t count, capacity;
  bool possible;
};

static enum um_status add_edit(struct edits *e, size_t from, size_t to, size_t at)
{
  if (e->count == e->capacity) {
    size_t capacity = 2 * e->capacity + 16;
    UM_TRY(um_core_reallocate(e->pool.context, capacity, sizeof *e->list, &e->list));
    e->capacity = capacity;
  }
  /* kept in order of position; edits at one position stay in order of arrival */
  size_t i = e->count++;
  for (; i > 0 && e->list[i - 1].from > from; i--) e->list[i] = e->list[i - 1];
  e->list[i] = (struct edit){from, to, at, e->pool.length - at};
  return UM_OK;
}

/* A new key goes before the last key of its mapping: that one's column is the indentation. */
static enum um_status insert_key(struct edits *e, const struct um_node *last,
                                 const struct um_node *node, bool flow)
{
  size_t at = e->pool.length;
  UM_TRY(um_document_emit_key(&e->pool, node->key));
  UM_TRY(um_document_emit(&e->pool, ": "));
  UM_TRY(um_document_emit_flow(&e->pool, node, flow));
  UM_TRY(um_document_emit(&e->pool, flow ? ", " : "\n"));
  if (!flow) UM_TRY(um_document_emit_indent(&e->pool, last->key_place.column));
  return add_edit(e, last->key_place.from, last->key_place.from, at);
}

/* A list as a new last key of the whole document, an element a line. */
static enum um_status append_list(struct edits *e, const struct um_node *node)
{
  size_t at = e->pool.length;
  if (e->length > 0 && e->source[e->length - 1] != '\n') UM_TRY(um_document_emit(&e->pool, "\n"));
  UM_TRY(um_document_emit_key(&e->pool, node->key));
  UM_TRY(um_document_emit(&e->pool, ":"));
  for (const struct um_node *n = node->first; n != NULL; n = n->next) {
    UM_TRY(um_document_emit(&e->pool, "\n  - "));
    UM_TRY(um_document_emit_flow(&e->pool, n, false));
  }
  UM_TRY(um_document_emit(&e->pool, "\n"));
  return add_edit(e, e->length, e->length, at);
}

/* 1 where a scalar stands in quotes, which its place leaves out. */
static size_t quotes_of(const struct edits *e, const struct um_node *node)
{
  size_t from = node->place.from, to = node->place.to;
  return !node->plain && from > 0 && to < e->length && strchr("'\"", e->source[to]) != NULL &&
         e->source[from - 1] == e->source[to];
}

/* Behind the last character of a node that stands in the file; 0 when that cannot be told. */
static size_t end_of(const struct edits *e, const struct um_node *node)
{
  if (node->kind == UM_NODE_SCALAR) return node->place.to + quotes_of(e, node);
  if (node->last == NULL) return 0;
  size_t end = end_of(e, node->last);
  if (!node->flow || end == 0) return end;
  while (end < e->length && strchr(" ,\n", e->source[end]) != NULL) end++;
  return end < e->length && strchr("]}", e->source[end]) != NULL ? end + 1 : 0;
}

/* Column of the dash before a node of a list in block layout; SIZE_MAX when there is none. */
static size_t dash_column(const struct edits *e, const struct um_node *node)
{
  while (node->kind != UM_NODE_SCALAR && node->key == NULL && node->first != NULL &&
         node->first->key == NULL)
    node = node->first;
  size_t at = node->kind == UM_NODE_SCALAR || node->first == NULL ? node->place.from
                                                                  : node->first->key_place.from;
  while (at > 0 && strchr(" {[\"'", e->source[at - 1]) != NULL) at--;
  if (at == 0 || e->source[at - 1] != '-') return SIZE_MAX;
  size_t dash = at - 1, line = dash;
  while (line > 0 && e->source[line - 1] != '\n') line--;
  return dash - line;
}

/* New last elements of a list that has some. */
static enum um_status append_elements(struct edits *e, const struct um_node *list,
                                      const struct um_node *node, bool flow)
{
  size_t at = e->pool.length, end = end_of(e, list->last);
  size_t column = flow ? 0 : dash_column(e, list->last);
  e->possible = e->possible && end > 0 && column != SIZE_MAX;
  while (e->possible && !flow && end < e->length && e->source[end - 1] != '\n') end++;
  if (!flow && end > 0 && e->source[end - 1] != '\n') UM_TRY(um_document_emit(&e->pool, "\n"));
  for (; e->possible && node != NULL; node = node->next) {
    if (!flow) UM_TRY(um_document_emit_indent(&e->pool, column));
    UM_TRY(um_document_emit(&e->pool, flow ? ", " : "- "));
    UM_TRY(um_document_emit_flow(&e->pool, node, flow));
    if (!flow) UM_TRY(um_document_emit(&e->pool, "\n"));
  }
  return e->possible ? add_edit(e, end, end, at) : UM_OK;
}

/* Edits that turn the tree `old` (as read) into `node`. */
static enum um_status collect_edits(struct edits *e, const struct um_node *old,
                                    const struct um_node *node, bool flow)
{
  if (um_document_node_equal(old, node)) return UM_OK;
  if (old->kind == UM_NODE_SCALAR) {
    size_t at = e->pool.length, quotes = quotes_of(e, old);
    UM_TRY(um_document_emit_flow(&e->pool, node, flow));
    return add_edit(e, old->place.from - quotes, old->place.to + quotes, at);
  }
  flow = flow || old->flow;
  const struct um_node *p = old->first, *q = node->first;
  e->possible = e->possible && old->kind != UM_NODE_NULL && old->kind == node->kind && p != NULL;
  if (!e->possible) return UM_OK;
  const struct um_node *last = old->last;
  for (; p != NULL && q != NULL; p = p->next, q = q->next) {
    if (p->key != NULL && strcmp(p->key, q->key) != 0) break;
    UM_TRY(collect_edits(e, p, q, flow));
  }
  /* overrides put new keys and elements behind the old ones */
  e->possible = e->possible && p == NULL;
  if (e->possible && q != NULL && q->key == NULL) return append_elements(e, old, q, flow);
  for (; e->possible && q != NULL; q = q->next)
    if (old == e->root && !flow && q->kind == UM_NODE_LIST && q->count > 0)
      UM_TRY(append_list(e, q));
    else
      UM_TRY(insert_key(e, last, q, flow));
  return UM_OK;
}

static enum um_status apply_edits(struct um_emitter *out, const struct edits *e, const char *source,
                                  size_t length)
{
  size_t done = 0;
  for (size_t i = 0; i < e->count; i++) {
    UM_TRY(um_document_emit_bytes(out, source + done, e->list[i].from - done));
    UM_TRY(um_document_emit_bytes(out, e->pool.text + e->list[i].at, e->list[i].length));
    done = e->list[i].to;
  }
  return um_document_emit_bytes(out, source + done, length - done);
}

/* Same tree, whatever the order of keys and the quotes of texts that no type mistakes. */
static bool same_meaning(const struct um_node *a, const struct um_node *b)
{
  if (a->kind != b->kind || a->count != b->count) return false;
  if (a->kind == UM_NODE_SCALAR && strcmp(a->text, b->text) != 0) return false;
  const struct um_node *q = b->first;
  for (const struct um_node *p = a->first; p != NULL; p = p->next) {
    const struct um_node *match = p->key != NULL ? um_document_node_child(b, p->key) : q;
    if (match == NULL || !same_meaning(p, match)) return false;
    if (q != NULL) q = q->next;
  }
  return true;
}

/* Edit the source; *good tells whether the result reads back as the tree. */
static enum um_status edit_source(const struct um_document *document, struct um_emitter *out,
                                  bool *good)
{
  struct um_context *context = document->context;
  struct um_document *scratch;
  struct edits e = {.source = document->source,
                    .length = document->source_length,
                    .pool = {.context = context},
                    .possible = true};
  struct um_node *old, *again;
  *good = false;
  UM_TRY(um_core_allocate(context, 1, sizeof *scratch, &scratch));
  scratch->context = context;
  enum um_status status;
  UM_CHECK(um_document_yaml_load(scratch, document->path, true, document->source,
                                 document->source_length, &old));
  e.root = old;
  UM_CHECK(collect_edits(&e, old, document->root, false));
  for (size_t i = 0; e.possible && i < e.count; i++)
    e.possible = e.list[i].to <= document->source_length && e.list[i].from <= e.list[i].to &&
                 (i == 0 || e.list[i - 1].to <= e.list[i].from);
  if (!e.possible) goto done;
  UM_CHECK(apply_edits(out, &e, document->source, document->source_length));
  status = um_document_yaml_load(scratch, document->path, true, out->text, out->length, &again);
  *good = status == UM_OK && same_meaning(again, document->root);
  if (status == UM_ERR_INPUT) {
    um_core_message_clear(context);
    status = UM_OK;
  }
done:
  um_document_destroy(&scratch);
  UM_FREE(context, e.pool.text, e.list);
  return status;
}

/* Does the text read back as the tree? UM_ERR_INPUT is an answer, not an error. */
static enum um_status reads_back(const struct um_document *document, const struct um_emitter *text,
                                 bool *good)
{
  struct um_document *scratch;
  struct um_node *again;
  *good = false;
  UM_TRY(um_core_allocate(document->context, 1, sizeof *scratch, &scratch));
  scratch->context = document->context;
  enum um_status status =
      um_document_yaml_load(scratch, document->path, true, text->text, text->length, &again);
  *good = status == UM_OK && same_meaning(again, document->root);
  if (status == UM_ERR_INPUT) um_core_message_clear(document->context);
  um_document_destroy(&scratch);
  return status == UM_ERR_INPUT ? UM_OK : status;
}

enum um_status um_document_text(struct um_context *context, const struct um_document *document,
                                char **out)
{
  *out = NULL;
  if (document->set_count == 0) return um_core_strdup(context, document->source, out);
  struct um_emitter b = {.context = context};
  bool good;
  enum um_status status;
  UM_CHECK(edit_source(document, &b, &good));
  if (!good) {
    b.length = 0;
    UM_CHECK(um_document_emit_document(&b, document->root));
    UM_CHECK(reads_back(document, &b, &good));
    if (!good)
      UM_CHECK(um_core_fail(context, UM_ERR_INPUT,
                            "%s: with its --set values it cannot be written so that it reads back; "
                            "accepted: values without control characters",
                            document->path));
  }
  *out = b.text;
  b.text = NULL;
done:
  um_core_free(context, b.text);
  return status;
}
