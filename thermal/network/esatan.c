/* A network of ESATAN, one file .d:
 *
 *   C_i dT_i/dt = Q_i + sum GL_ij (T_j - T_i) + STEFAN sum GR_ij (T_j^4 - T_i^4)
 *
 * with T in degrees, TABS above 0 K. Nodes D store heat, A and D without C balance at every
 * instant, B are held, X are left out with their conductors. Q: QI, QA, QE, QR, QS. Assignments in
 * $INITIAL and $EXECUTION are done once, CALL STATST too; what $VARIABLES1, $VARIABLES2 and
 * $SUBROUTINES do over time is not read, and said. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sort.h"
#include "base/core/text.h"
#include "thermal/network/esatan_impl.h"
#include "thermal/network/network_group.h"

#define STEFAN_DEFAULT 5.6686e-8 /* of ESATAN [W/m^2/K^4] */

typedef struct um_thermal_esatan_statement statement;

static const char *skip(const char *text) { return text + strspn(text, " \t\r"); }

static enum um_status refuse(const struct um_thermal_esatan *e, const statement *s,
                             const char *accepted)
{
  return um_core_fail(e->context, UM_ERR_INPUT, "%s:%d: '%.80s'; accepted: %s", e->path, s->line,
                      s->text, accepted);
}

/* The next field of a statement, cut at its comma, and what follows; NULL: there is none. */
static char *next_field(char **rest)
{
  char *begin = *rest, *c = begin;
  int depth = 0;
  bool quoted = false;
  if (begin == NULL) return NULL;
  for (; *c != '\0' && (*c != ',' || quoted || depth > 0); c++) {
    if (*c == '\'') quoted = !quoted;
    if (quoted) continue;
    depth += (*c == '(') - (*c == ')');
  }
  *rest = *c == ',' ? c + 1 : NULL;
  *c = '\0';
  return begin + strspn(begin, " \t\r");
}

/* --- constants ------------------------------------------------------------------------------- */

static enum um_status read_value(struct um_thermal_esatan *e, const statement *s)
{
  size_t n = um_thermal_esatan_word(s->text);
  const char *equals = skip(s->text + n);
  if (n == 0 || *equals != '=') return refuse(e, s, "NAME = expression;");
  UM_TRY(um_thermal_network_grow(e->context, &e->values, e->nvalue, &e->value_room,
                                 sizeof *e->values));
  e->values[e->nvalue++] =
      (struct um_thermal_esatan_value){.name = s->text, .text = skip(equals + 1), .line = s->line};
  return UM_OK;
}

/* --- nodes ----------------------------------------------------------------------------------- */

static void take_label(struct um_thermal_esatan_node *node, const char *text)
{
  size_t n = strcspn(++text, "'");
  while (n > 0 && text[n - 1] == ' ') n--;
  if (n < sizeof node->label) memcpy(node->label, text, n);
}

/* KEY = expression; keys of what no network needs (places, sizes) are left alone. */
static enum um_status node_field(struct um_thermal_esatan *e, const statement *s, const char *field,
                                 struct um_thermal_esatan_node *node)
{
  static const char *const keys[UM_ESATAN_ENTITIES] = {"T",  "C",  "A",  "ALP", "EPS",
                                                       "QI", "QA", "QE", "QR",  "QS"};
  size_t n = um_thermal_esatan_word(field);
  const char *value = skip(field + n);
  if (*field == '\'') {
    take_label(node, field);
    return UM_OK;
  }
  if (n == 0 || *value != '=') return refuse(e, s, "D10 = 'label', T = 20.0, C = 100.0;");
  for (int k = 0; k < UM_ESATAN_ENTITIES; k++)
    if (um_thermal_esatan_same(field, n, keys[k]))
      return um_thermal_esatan_evaluate(e, skip(value + 1), s->line, &node->value[k]);
  return UM_OK;
}

static enum um_status read_node(struct um_thermal_esatan *e, const statement *s)
{
  char *copy = NULL, *rest, *end;
  UM_TRY(um_core_strdup(e->context, s->text, &copy));
  enum um_status status = UM_OK;
  struct um_thermal_esatan_node node = {.kind = (char)toupper((unsigned char)copy[0]),
                                        .line = s->line};
  rest = copy;
  char *field = next_field(&rest);
  node.number = isdigit((unsigned char)field[field[0] != '\0']) ? strtol(field + 1, &end, 10) : -1;
  if (node.number < 0 || node.number > 999999999 || strchr("DABX", node.kind) == NULL)
    status = refuse(e, s, "a node D, A, B or X with its number, as in D10 = 'label', T = 20.0;");
  else if (*(field = end + strspn(end, " \t\r")) == '=')
    field = field + 1 + strspn(field + 1, " \t\r");
  else if (*field != '\0')
    status = refuse(e, s, "D10 = 'label', T = 20.0, C = 100.0;");
  for (; status == UM_OK && field != NULL; field = next_field(&rest))
    if (*field != '\0') status = node_field(e, s, field, &node);
  um_core_free(e->context, copy);
  UM_TRY(status);
  UM_TRY(um_thermal_network_grow(e->context, &e->node, e->nnode, &e->node_room, sizeof *e->node));
  e->node[e->nnode++] = node;
  return UM_OK;
}

struct numbered {
  long number;
  uint32_t at;
};
static int numbered_compare(const void *a, const void *b)
{
  const struct numbered *x = a, *y = b;
  return (x->number > y->number) - (x->number < y->number);
}

/* So that conductors find their ends fast. */
static enum um_status order_nodes(struct um_thermal_esatan *e)
{
  enum um_status status;
  struct numbered *list = NULL;
  uint32_t *order = NULL;
  UM_CHECK(um_core_allocate(e->context, e->nnode, sizeof *list, &list));
  UM_CHECK(um_core_allocate(e->context, e->nnode, sizeof *order, &order));
  for (size_t i = 0; i < e->nnode; i++) list[i] = (struct numbered){e->node[i].number, (uint32_t)i};
  UM_CHECK(um_core_sort(e->context, list, e->nnode, sizeof *list, numbered_compare));
  for (size_t i = 0; i < e->nnode; i++) {
    order[i] = list[i].at;
    if (i > 0 && list[i].number == list[i - 1].number) {
      status = um_core_fail(e->context, UM_ERR_INPUT,
                            "%s:%d: node %ld stands at line %d, too; accepted: numbers used once",
                            e->path, e->node[list[i].at].line, list[i].number,
                            e->node[list[i - 1].at].line);
      goto done;
    }
  }
  e->order = order;
  order = NULL;
done:
  UM_FREE(e->context, list, order);
  return status;
}

/* --- what is done once ----------------------------------------------------------------------- */

/* CALL STATST('N10', 'B') changes what a node is. */
static bool do_statst(struct um_thermal_esatan *e, const char *text)
{
  const char *open = strchr(text, '\'');
  if (strstr(text, "STATST") == NULL || open == NULL || toupper((unsigned char)open[1]) != 'N')
    return false;
  char *end;
  struct um_thermal_esatan_node *node = um_thermal_esatan_node(e, strtol(open + 2, &end, 10));
  const char *kind = *end == '\'' ? strchr(end + 1, '\'') : NULL;
  if (node == NULL || kind == NULL || kind[1] == '\0' || strchr("DABX", kind[1]) == NULL)
    return false;
  node->kind = kind[1];
  return true;
}

/* An assignment, or the call above. *done false: it is neither. */
static enum um_status do_once(struct um_thermal_esatan *e, const statement *s, bool *done)
{
  size_t n = um_thermal_esatan_word(s->text);
  const char *equals = skip(s->text + n);
  *done = true;
  if (um_thermal_esatan_same(s->text, n, "CALL")) {
    *done = do_statst(e, s->text);
    return UM_OK;
  }
  double *to = um_thermal_esatan_entity(e, s->text, n);
  struct um_thermal_esatan_value *constant = um_thermal_esatan_find(e, s->text, n);
  if (um_thermal_esatan_same(s->text, n, "STEFAN")) to = &e->stefan;
  if (um_thermal_esatan_same(s->text, n, "TABS")) to = &e->offset;
  if (constant != NULL) to = &constant->value;
  *done = to != NULL && *equals == '=';
  if (!*done) return UM_OK;
  UM_TRY(um_thermal_esatan_evaluate(e, equals + 1, s->line, to));
  if (constant != NULL) constant->known = true;
  return UM_OK;
}

static bool branches(const char *text)
{
  size_t n = um_thermal_esatan_word(text);
  return um_thermal_esatan_same(text, n, "IF") || um_thermal_esatan_same(text, n, "DO");
}

/* Statements that a solver runs and we do not: of $EXECUTION only what says something of a node,
 * since how ESATAN solves is no matter here. */
static bool is_lost(const struct um_thermal_esatan *e, const statement *s)
{
  size_t n = um_thermal_esatan_word(s->text);
  if (s->block == UM_ESATAN_OVER_TIME) return true;
  return um_thermal_esatan_entity(e, s->text, n) != NULL || strstr(s->text, "STATST") != NULL;
}

static enum um_status read_procedures(struct um_thermal_esatan *e, const statement *s, size_t n)
{
  const statement *lost = NULL;
  size_t nlost = 0;
  bool straight = true;
  for (size_t i = 0; i < n; i++) {
    bool done = false;
    if (s[i].block < UM_ESATAN_ONCE) continue;
    straight = straight && !(s[i].block == UM_ESATAN_ONCE && branches(s[i].text));
    if (s[i].block == UM_ESATAN_ONCE && straight) UM_TRY(do_once(e, &s[i], &done));
    if (done || !is_lost(e, &s[i])) continue;
    if (nlost++ == 0) lost = &s[i];
  }
  if (lost != NULL)
    um_core_log(e->context, UM_LOG_WARNING,
                "%s:%d: '%.60s' is not followed, nor are %zu other statements; what they do to "
                "nodes and conductors is missing",
                e->path, lost->line, lost->text, nlost - 1);
  return UM_OK;
}

/* --- the network ----------------------------------------------------------------------------- */

/* A label that no other node has, and that names a place; else the number. */
static void name_of(const struct um_thermal_esatan *e, const struct um_thermal_esatan_node *node,
                    char *out, size_t size)
{
  size_t same = 0;
  bool plain = node->label[0] != '\0' && um_core_name_is_safe_behind(node->label) &&
               strpbrk(node->label, "/:,;'\\") == NULL && strcmp(node->label, "space") != 0;
  for (size_t i = 0; plain && i < e->nnode && same < 2; i++)
    same += strcmp(e->node[i].label, node->label) == 0;
  if (plain && same == 1)
    snprintf(out, size, "%s", node->label);
  else
    snprintf(out, size, "%ld", node->number);
}

static enum um_status add_node(const struct um_thermal_esatan *e,
                               struct um_thermal_esatan_node *node,
                               struct um_thermal_network *network)
{
  char name[80];
  enum um_thermal_node_kind kind = UM_NODE_DIFFUSIVE;
  double power = 0.0, capacity = node->kind == 'D' ? node->value[UM_ESATAN_C] : 0.0;
  double temperature = node->value[UM_ESATAN_T] + e->offset;
  if (node->kind == 'A' || (node->kind == 'D' && capacity == 0.0)) kind = UM_NODE_ARITHMETIC;
  if (node->kind == 'B') kind = UM_NODE_BOUNDARY;
  if (node->kind == 'X') return UM_OK;
  for (int k = UM_ESATAN_QI; k <= UM_ESATAN_QS; k++) power += node->value[k];
  if (!(capacity >= 0.0) || !(temperature >= 0.0))
    return um_core_fail(e->context, UM_ERR_INPUT,
                        "%s:%d: node %ld has C %g J/K and T %g K; accepted: 0 or more", e->path,
                        node->line, node->number, capacity, temperature);
  name_of(e, node, name, sizeof name);
  return um_thermal_network_node_add(network, name, kind, capacity, temperature,
                                     kind == UM_NODE_BOUNDARY ? 0.0 : power, &node->index);
}

/* GL(10,20) = expression, GR(10,20) = expression. */
static enum um_status add_conductor(struct um_thermal_esatan *e, const statement *s,
                                    struct um_thermal_network *network)
{
  static const char accepted[] = "GL(10,20) = W/K; or GR(10,20) = m2; between nodes by number";
  size_t n = um_thermal_esatan_word(s->text);
  const char *at = skip(s->text + n);
  bool linear = um_thermal_esatan_same(s->text, n, "GL");
  struct um_thermal_esatan_node *end[2];
  double value = 0.0;
  if (!linear && !um_thermal_esatan_same(s->text, n, "GR")) return refuse(e, s, accepted);
  for (int k = 0; k < 2; k++) {
    char *rest;
    if (*at++ != (k == 0 ? '(' : ',')) return refuse(e, s, accepted);
    if (!isdigit((unsigned char)*(at = skip(at)))) return refuse(e, s, accepted);
    end[k] = um_thermal_esatan_node(e, strtol(at, &rest, 10));
    if (end[k] == NULL)
      return um_core_fail(e->context, UM_ERR_INPUT, "%s:%d: '%.60s': no node %.*s", e->path,
                          s->line, s->text, (int)(rest - at < 20 ? rest - at : 20), at);
    at = skip(rest);
  }
  if (*at++ != ')' || *(at = skip(at)) != '=') return refuse(e, s, accepted);
  UM_TRY(um_thermal_esatan_evaluate(e, at + 1, s->line, &value));
  /* finite elements have conductances below 0, too */
  if ((!linear && !(value >= 0.0)) || end[0] == end[1])
    return refuse(e, s, "two nodes that differ, and GR 0 or more");
  if (end[0]->kind == 'X' || end[1]->kind == 'X') return UM_OK;
  if (linear) return um_thermal_network_conductor_add(network, end[0]->index, end[1]->index, value);
  return um_thermal_network_radiator_add(network, end[0]->index, end[1]->index,
                                         value * e->stefan / UM_STEFAN_BOLTZMANN);
}

static enum um_status control(struct um_thermal_esatan *e, const char *name, double *out)
{
  struct um_thermal_esatan_value *value = um_thermal_esatan_find(e, name, strlen(name));
  return value == NULL ? UM_OK : um_thermal_esatan_evaluate(e, name, value->line, out);
}

static enum um_status read_all(struct um_thermal_esatan *e, const statement *s, size_t n,
                               struct um_thermal_network *network)
{
  for (size_t i = 0; i < n; i++)
    if (s[i].block == UM_ESATAN_VALUES) UM_TRY(read_value(e, &s[i]));
  UM_TRY(control(e, "STEFAN", &e->stefan));
  UM_TRY(control(e, "TABS", &e->offset));
  for (size_t i = 0; i < n; i++)
    if (s[i].block == UM_ESATAN_NODES) UM_TRY(read_node(e, &s[i]));
  if (e->nnode == 0)
    return um_core_fail(e->context, UM_ERR_INPUT, "%s: no node in $NODES; accepted: one or more",
                        e->path);
  UM_TRY(order_nodes(e));
  UM_TRY(read_procedures(e, s, n));
  for (size_t i = 0; i < e->nnode; i++) UM_TRY(add_node(e, &e->node[i], network));
  for (size_t i = 0; i < n; i++)
    if (s[i].block == UM_ESATAN_CONDUCTORS) UM_TRY(add_conductor(e, &s[i], network));
  return UM_OK;
}

bool um_thermal_esatan_is(const char *text)
{
  while (*text == '#' || isspace((unsigned char)*text))
    text += *text == '#' ? strcspn(text, "\n") : 1;
  return *text == '$' &&
         um_thermal_esatan_same(text + 1, um_thermal_esatan_word(text + 1), "MODEL");
}

enum um_status um_thermal_esatan_read(struct um_context *context, const char *path, char *text,
                                      struct um_thermal_network **out)
{
  enum um_status status;
  struct um_thermal_esatan e = {
      .context = context, .path = path, .stefan = STEFAN_DEFAULT, .offset = 273.15};
  statement *s = NULL;
  size_t n = 0;
  struct um_thermal_network *network = NULL;
  *out = NULL;
  UM_CHECK(um_thermal_esatan_split(context, path, text, &s, &n));
  UM_CHECK(um_thermal_network_create(context, &network));
  UM_CHECK(read_all(&e, s, n, network));
  *out = network;
  network = NULL;
done:
  um_thermal_network_destroy(&network);
  UM_FREE(context, s, e.values, e.node, e.order);
  return status;
}
