/* Arithmetic of ESATAN's files: numbers with E or D, constants, entities of nodes.
 *
 *   sum = [+-] product {(+|-) product}, product = power {(*|/) power}, power = atom [** power] */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/number.h"
#include "thermal/network/esatan_impl.h"

#define DEEPEST 64 /* brackets, and constants of constants */

struct parser {
  struct um_thermal_esatan *e;
  const char *at, *whole;
  int line, depth;
};

static enum um_status sum(struct parser *p, double *out);

static enum um_status refuse(const struct parser *p)
{
  return um_core_fail(p->e->context, UM_ERR_INPUT,
                      "%s:%d: '%.80s' at '%.20s'; accepted: numbers, constants of $LOCALS and "
                      "$CONSTANTS, T, C, A, ALP, EPS of a node as in A10, + - * / ** ( )",
                      p->e->path, p->line, p->whole, p->at);
}

static void blanks(struct parser *p) { p->at += strspn(p->at, " \t\r"); }

struct um_thermal_esatan_value *um_thermal_esatan_find(const struct um_thermal_esatan *e,
                                                       const char *name, size_t length)
{
  for (size_t i = 0; i < e->nvalue; i++) {
    size_t n = um_thermal_esatan_word(e->values[i].name), k = 0;
    if (n != length) continue;
    while (k < n && toupper((unsigned char)name[k]) == toupper((unsigned char)e->values[i].name[k]))
      k++;
    if (k == n) return &e->values[i];
  }
  return NULL;
}

struct um_thermal_esatan_node *um_thermal_esatan_node(const struct um_thermal_esatan *e,
                                                      long number)
{
  if (e->order == NULL) {
    for (size_t i = 0; i < e->nnode; i++)
      if (e->node[i].number == number) return &e->node[i];
    return NULL;
  }
  size_t low = 0, high = e->nnode;
  while (low < high) {
    size_t middle = (low + high) / 2;
    struct um_thermal_esatan_node *node = &e->node[e->order[middle]];
    if (node->number == number) return node;
    if (node->number < number)
      low = middle + 1;
    else
      high = middle;
  }
  return NULL;
}

double *um_thermal_esatan_entity(const struct um_thermal_esatan *e, const char *word, size_t length)
{
  static const char *const names[UM_ESATAN_ENTITIES] = {
      [UM_ESATAN_T] = "T",     [UM_ESATAN_C] = "C",     [UM_ESATAN_A] = "A",
      [UM_ESATAN_ALP] = "ALP", [UM_ESATAN_EPS] = "EPS", [UM_ESATAN_QI] = "QI",
      [UM_ESATAN_QA] = "QA",   [UM_ESATAN_QE] = "QE",   [UM_ESATAN_QR] = "QR",
      [UM_ESATAN_QS] = "QS"};
  size_t letters = 0, digits;
  while (letters < length && isalpha((unsigned char)word[letters])) letters++;
  digits = letters + (letters < length && word[letters] == ':');
  if (digits == length || length - digits > 9) return NULL;
  for (size_t i = digits; i < length; i++)
    if (!isdigit((unsigned char)word[i])) return NULL;
  struct um_thermal_esatan_node *node = um_thermal_esatan_node(e, strtol(word + digits, NULL, 10));
  for (int k = 0; k < UM_ESATAN_ENTITIES && node != NULL; k++)
    if (um_thermal_esatan_same(word, letters, names[k])) return &node->value[k];
  return NULL;
}

static enum um_status constant(struct parser *p, struct um_thermal_esatan_value *value, double *out)
{
  if (!value->known) {
    struct parser inner = {p->e, value->text, value->text, value->line, p->depth + 1};
    if (value->busy || p->depth >= DEEPEST) return refuse(p);
    value->busy = true;
    enum um_status status = sum(&inner, &value->value);
    value->busy = false;
    UM_TRY(status);
    if (*inner.at != '\0') return refuse(&inner);
    value->known = true;
  }
  *out = value->value;
  return UM_OK;
}

static enum um_status name(struct parser *p, double *out)
{
  size_t n = um_thermal_esatan_word(p->at), length = n;
  struct um_thermal_esatan_value *value = um_thermal_esatan_find(p->e, p->at, n);
  if (value != NULL) {
    UM_TRY(constant(p, value, out));
    p->at += n;
    return UM_OK;
  }
  if (p->at[length] == ':') {
    length++;
    while (isdigit((unsigned char)p->at[length])) length++;
  }
  const double *entity = um_thermal_esatan_entity(p->e, p->at, length);
  if (n == 0 || entity == NULL) return refuse(p);
  *out = *entity;
  p->at += length;
  return UM_OK;
}

/* 12, 1.5, .5, 1., 1E-3, 1.0D+3 */
static enum um_status number(struct parser *p, double *out)
{
  char text[64];
  size_t n = 0, all;
  while (isdigit((unsigned char)p->at[n]) || p->at[n] == '.') n++;
  all = n;
  if (n > 0 && p->at[n] != '\0' && strchr("EeDd", p->at[n]) != NULL) {
    size_t sign = n + 1 + (p->at[n + 1] == '+' || p->at[n + 1] == '-');
    all = sign;
    while (isdigit((unsigned char)p->at[all])) all++;
    if (all == sign) all = n;
  }
  if (all == 0 || all >= sizeof text) return refuse(p);
  memcpy(text, p->at, all);
  text[all] = '\0';
  if (all > n) text[n] = 'e';
  if (!um_core_number_parse(text, out)) return refuse(p);
  p->at += all;
  return UM_OK;
}

static enum um_status atom(struct parser *p, double *out)
{
  blanks(p);
  if (*p->at != '(') return isalpha((unsigned char)*p->at) ? name(p, out) : number(p, out);
  if (++p->depth > DEEPEST) return refuse(p);
  p->at++;
  UM_TRY(sum(p, out));
  if (*p->at != ')') return refuse(p);
  p->at++;
  p->depth--;
  return UM_OK;
}

static enum um_status power(struct parser *p, double *out)
{
  double exponent = 1.0;
  UM_TRY(atom(p, out));
  blanks(p);
  if (strncmp(p->at, "**", 2) != 0) return UM_OK;
  if (++p->depth > DEEPEST) return refuse(p);
  p->at += 2;
  blanks(p);
  bool negative = *p->at == '-';
  p->at += negative;
  UM_TRY(power(p, &exponent));
  p->depth--;
  *out = pow(*out, negative ? -exponent : exponent);
  return UM_OK;
}

static enum um_status product(struct parser *p, double *out)
{
  UM_TRY(power(p, out));
  for (blanks(p); *p->at == '*' || *p->at == '/'; blanks(p)) {
    double factor = 1.0;
    bool over = *p->at++ == '/';
    UM_TRY(power(p, &factor));
    *out = over ? *out / factor : *out * factor;
  }
  return UM_OK;
}

static enum um_status sum(struct parser *p, double *out)
{
  blanks(p);
  bool negative = *p->at == '-';
  p->at += negative || *p->at == '+';
  UM_TRY(product(p, out));
  if (negative) *out = -*out;
  for (blanks(p); *p->at == '+' || *p->at == '-'; blanks(p)) {
    double term = 0.0;
    bool minus = *p->at++ == '-';
    UM_TRY(product(p, &term));
    *out += minus ? -term : term;
  }
  return UM_OK;
}

enum um_status um_thermal_esatan_evaluate(struct um_thermal_esatan *e, const char *text, int line,
                                          double *out)
{
  text += strspn(text, " \t\r");
  struct parser p = {e, text, text, line, 0};
  UM_TRY(sum(&p, out));
  if (*p.at != '\0') return refuse(&p);
  if (!isfinite(*out))
    return um_core_fail(e->context, UM_ERR_INPUT, "%s:%d: '%.80s' is not finite", e->path, line,
                        text);
  return UM_OK;
}
