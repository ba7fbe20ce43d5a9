/* YAML text to a tree of nodes by libfyaml; its errors become one line of ours. Duplicate keys are
 * found here, by a hash: the library compares every key of a mapping with every other. */
#include <libfyaml.h>
#include <stdint.h>
#include <string.h>

#include "base/core/digest.h"
#include "base/document/document_impl.h"

struct loader {
  struct um_document *document;
  struct um_context *context;
  const char *name;
  bool from_file;
};

static void discard_output(struct fy_diag *diag, void *user, const char *text, size_t length)
{
  (void)diag;
  (void)user;
  (void)text;
  (void)length;
}

static struct fy_diag *quiet_diag(void)
{
  struct fy_diag_cfg cfg;
  fy_diag_cfg_default(&cfg);
  cfg.fp = NULL;
  cfg.output_fn = discard_output;
  cfg.colorize = false;
  struct fy_diag *diag = fy_diag_create(&cfg);
  if (diag != NULL) fy_diag_set_collect_errors(diag, true);
  return diag;
}

static enum um_status fail_at(const struct loader *l, int line, const char *problem)
{
  if (l->from_file && line > 0)
    return um_core_fail(l->context, UM_ERR_INPUT, "%s:%d: %s", l->name, line, problem);
  return um_core_fail(l->context, UM_ERR_INPUT, "%s: %s", l->name, problem);
}

/* The first error that libfyaml collected. */
static enum um_status fail_collected(const struct loader *l, struct fy_diag *diag)
{
  void *at = NULL;
  const struct fy_diag_error *error = fy_diag_errors_iterate(diag, &at);
  char text[256];
  if (error == NULL || error->msg == NULL) return fail_at(l, 0, "not YAML");
  snprintf(text, sizeof text, "not YAML: %s", error->msg);
  return fail_at(l, error->line, text);
}

static struct um_node_place place_of(struct fy_token *token)
{
  struct um_node_place place = {0, 0, 0};
  const struct fy_mark *start = fy_token_start_mark(token), *end = fy_token_end_mark(token);
  if (start == NULL || end == NULL) return place;
  place.from = start->input_pos;
  place.to = end->input_pos;
  place.column = (size_t)start->column;
  return place;
}

/* Line of the first scalar inside a node, 1-based; 0 when it has none. */
static int first_line(struct fy_node *from, int depth)
{
  if (from == NULL || depth > UM_NODE_DEPTH_MAX) return 0;
  void *at = NULL;
  if (fy_node_is_sequence(from)) return first_line(fy_node_sequence_iterate(from, &at), depth + 1);
  if (fy_node_is_mapping(from)) {
    struct fy_node_pair *pair = fy_node_mapping_iterate(from, &at);
    return pair == NULL ? 0 : first_line(fy_node_pair_key(pair), depth + 1);
  }
  const struct fy_mark *mark = fy_token_start_mark(fy_node_get_scalar_token(from));
  return mark == NULL ? 0 : mark->line + 1;
}

static enum um_status refuse_extras(const struct loader *l, struct fy_node *from, int line)
{
  size_t length;
  if (fy_node_is_alias(from))
    return fail_at(l, line, "an alias ('*name') is not accepted; write the value out");
  if (fy_node_get_anchor(from) != NULL)
    return fail_at(l, line, "an anchor ('&name') is not accepted; write the value out");
  if (fy_node_get_tag(from, &length) != NULL)
    return fail_at(l, line, "a tag ('!name') is not accepted");
  return UM_OK;
}

static bool is_null_text(const char *text)
{
  return text[0] == '\0' || strcmp(text, "~") == 0 || strcmp(text, "null") == 0 ||
         strcmp(text, "Null") == 0 || strcmp(text, "NULL") == 0;
}

static enum um_status load_scalar(const struct loader *l, struct fy_node *from, int line,
                                  struct um_node *node)
{
  size_t length = 0;
  const char *text = fy_node_get_scalar(from, &length);
  if (text == NULL) length = 0;
  if (length > 0 && memchr(text, '\0', length) != NULL)
    return fail_at(l, line, "a text holds a zero byte");
  UM_TRY(um_document_copy_text(l->document, text, length, &node->text));
  struct fy_token *token = fy_node_get_scalar_token(from);
  node->kind = UM_NODE_SCALAR;
  node->plain = fy_node_get_style(from) == FYNS_PLAIN;
  if (token != NULL) node->place = place_of(token);
  if (node->plain && is_null_text(node->text)) node->kind = UM_NODE_NULL;
  return UM_OK;
}

static enum um_status load_key(const struct loader *l, struct fy_node *key, struct um_node *node,
                               int parent_line)
{
  if (key == NULL || !fy_node_is_scalar(key))
    return fail_at(l, parent_line, "a key that is not a word; accepted: key: value");
  int line = first_line(key, 0);
  UM_TRY(refuse_extras(l, key, line));
  size_t length = 0;
  const char *text = fy_node_get_scalar(key, &length);
  if (text == NULL || length == 0 || memchr(text, '\0', length) != NULL)
    return fail_at(l, line, "an empty key; accepted: key: value");
  UM_TRY(um_document_copy_text(l->document, text, length, &node->key));
  node->key_line = line;
  node->key_place = place_of(fy_node_get_scalar_token(key));
  return UM_OK;
}

static enum um_status load_node(const struct loader *l, struct fy_node *from, int parent_line,
                                int depth, struct um_node *node);

/* The keys of one mapping so far, by open addressing. */
struct key_set {
  const char **key; /* [mask + 1], NULL: free */
  size_t mask, count;
};

static size_t key_slot(const struct key_set *set, const char *key)
{
  uint64_t h = um_core_digest(UM_CORE_DIGEST_BEGIN, key, strlen(key));
  size_t slot = (size_t)(h ^ (h >> 29)) & set->mask;
  while (set->key[slot] != NULL && strcmp(set->key[slot], key) != 0) slot = (slot + 1) & set->mask;
  return slot;
}

static enum um_status key_set_grow(const struct loader *l, struct key_set *set)
{
  struct key_set grown = {.mask = set->key == NULL ? 15 : 2 * set->mask + 1, .count = set->count};
  UM_TRY(um_core_allocate(l->context, grown.mask + 1, sizeof *grown.key, (void *)&grown.key));
  for (size_t i = 0; set->key != NULL && i <= set->mask; i++)
    if (set->key[i] != NULL) grown.key[key_slot(&grown, set->key[i])] = set->key[i];
  um_core_free(l->context, (void *)set->key);
  *set = grown;
  return UM_OK;
}

static enum um_status key_set_add(const struct loader *l, struct key_set *set, const char *key,
                                  int line)
{
  char text[160];
  if (set->key == NULL || 2 * set->count > set->mask) UM_TRY(key_set_grow(l, set));
  size_t slot = key_slot(set, key);
  if (set->key[slot] != NULL) {
    snprintf(text, sizeof text, "duplicate key '%.80s'; accepted: each key once", key);
    return fail_at(l, line, text);
  }
  set->key[slot] = key;
  set->count++;
  return UM_OK;
}

/* Append one child; keys NULL in a list. */
static enum um_status load_child(const struct loader *l, struct um_node *parent,
                                 struct key_set *keys, struct fy_node *key, struct fy_node *value,
                                 int depth)
{
  struct um_node *child;
  UM_TRY(um_document_allocate(l->context, l->document, 1, sizeof *child, &child));
  int line = parent->at.line;
  if (keys != NULL) {
    UM_TRY(load_key(l, key, child, line));
    line = child->key_line;
    UM_TRY(key_set_add(l, keys, child->key, line));
  } else {
    UM_TRY(um_core_stop_check(l->context, "a file was read"));
  }
  UM_TRY(load_node(l, value, line, depth + 1, child));
  if (parent->last == NULL)
    parent->first = child;
  else
    parent->last->next = child;
  parent->last = child;
  parent->count++;
  return UM_OK;
}

static enum um_status load_node(const struct loader *l, struct fy_node *from, int parent_line,
                                int depth, struct um_node *node)
{
  int line = node->key_line;
  enum fy_node_style style = from == NULL ? FYNS_PLAIN : fy_node_get_style(from);
  bool block = style == FYNS_LITERAL || style == FYNS_FOLDED; /* begins below its key */
  if (from == NULL || (fy_node_is_scalar(from) && !block) || line == 0) {
    int own = first_line(from, 0);
    if (own != 0) line = own;
  }
  if (line == 0) line = parent_line;
  node->at.file = l->from_file ? l->name : "--set";
  node->at.line = l->from_file ? line : 0;
  node->set = !l->from_file;
  if (depth > UM_NODE_DEPTH_MAX) return fail_at(l, line, "nested too deep");
  if (from == NULL) {
    node->kind = UM_NODE_NULL;
    node->plain = true;
    node->text = "";
    return UM_OK;
  }
  UM_TRY(refuse_extras(l, from, line));
  if (fy_node_is_scalar(from)) return load_scalar(l, from, line, node);
  node->flow = fy_node_get_style(from) == FYNS_FLOW;
  void *at = NULL;
  if (fy_node_is_sequence(from)) {
    node->kind = UM_NODE_LIST;
    struct fy_node *item;
    while ((item = fy_node_sequence_iterate(from, &at)) != NULL)
      UM_TRY(load_child(l, node, NULL, NULL, item, depth));
    return UM_OK;
  }
  node->kind = UM_NODE_MAP;
  struct key_set keys = {0};
  enum um_status status = UM_OK;
  struct fy_node_pair *pair;
  while (status == UM_OK && (pair = fy_node_mapping_iterate(from, &at)) != NULL)
    status = load_child(l, node, &keys, fy_node_pair_key(pair), fy_node_pair_value(pair), depth);
  um_core_free(l->context, (void *)keys.key);
  return status;
}

/* Exactly one document is accepted. */
static enum um_status load_first(const struct loader *l, struct fy_parser *parser,
                                 struct fy_diag *diag, struct um_node **out)
{
  struct fy_document *first = fy_parse_load_document(parser);
  if (first == NULL) {
    if (fy_diag_got_error(diag) || fy_parser_get_stream_error(parser))
      return fail_collected(l, diag);
    return fail_at(l, 0, "empty; accepted: YAML");
  }
  enum um_status status;
  struct um_node *node = NULL;
  struct fy_document *second = NULL;
  UM_CHECK(um_document_allocate(l->context, l->document, 1, sizeof *node, &node));
  UM_CHECK(load_node(l, fy_document_root(first), l->from_file ? 1 : 0, 0, node));
  second = fy_parse_load_document(parser);
  if (second != NULL)
    UM_CHECK(fail_at(l, first_line(fy_document_root(second), 0),
                     "a second document begins; accepted: one"));
  if (fy_diag_got_error(diag) || fy_parser_get_stream_error(parser))
    UM_CHECK(fail_collected(l, diag));
  *out = node;
done:
  if (second != NULL) fy_parse_document_destroy(parser, second);
  fy_parse_document_destroy(parser, first);
  return status;
}

enum um_status um_document_yaml_load(struct um_document *document, const char *name, bool from_file,
                                     const char *text, size_t length, struct um_node **out)
{
  struct loader l = {document, document->context, name, from_file};
  enum um_status status;
  struct fy_diag *diag = quiet_diag();
  struct fy_parse_cfg cfg = {NULL,
                             FYPCF_QUIET | FYPCF_COLLECT_DIAG | FYPCF_JSON_NONE |
                                 FYPCF_DEFAULT_VERSION_1_2 | FYPCF_ALLOW_DUPLICATE_KEYS,
                             NULL, diag};
  struct fy_parser *parser = diag == NULL ? NULL : fy_parser_create(&cfg);
  *out = NULL;
  if (parser == NULL || fy_parser_set_string(parser, text, length) != 0) {
    status = um_core_fail(l.context, UM_ERR_LIBRARY, "%s: libfyaml could not be started", name);
    goto done;
  }
  status = load_first(&l, parser, diag, out);
done:
  if (parser != NULL) fy_parser_destroy(parser);
  if (diag != NULL) fy_diag_destroy(diag);
  return status;
}
