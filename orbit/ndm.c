/* Navigation messages of CCSDS in XML (NDM/XML, 505.0-B), by expat, as lines of their other form.
 */
#include "orbit/ndm.h"

#include <ctype.h>
#include <expat.h>
#include <stdio.h>
#include <string.h>

#define BYTES ((size_t)256 << 20)
#define DEPTH 32   /* elements in one another: what each costs expat has a bound */
#define VALUE 128  /* bytes of a value, with its end */
#define LINE  1100 /* bytes of a line: a row of seven values */

struct reader {
  struct um_context *context;
  const char *name;
  const struct um_orbit_ndm_form *form;
  um_orbit_ndm_take *take;
  void *self;
  XML_Parser parser;
  int depth;
  size_t messages, lines;
  bool message, described, meta, data, row;             /* inside; a segment's metadata were seen */
  int begin;                                            /* line where the row begins */
  char epoch[VALUE], field[UM_ORBIT_NDM_FIELDS][VALUE]; /* of the row; "": none */
  bool leaf;                                            /* no element stands in this one */
  char text[VALUE], units[VALUE];                       /* of the innermost element */
  size_t length;                                        /* of its text, VALUE: too long */
  enum um_status status;
};

static int line_of(const struct reader *r) { return (int)XML_GetCurrentLineNumber(r->parser); }

static void stop(struct reader *r, enum um_status status)
{
  if (status == UM_OK) return;
  r->status = status;
  (void)XML_StopParser(r->parser, XML_FALSE);
}

static const char *without_prefix(const char *name)
{
  const char *colon = strchr(name, ':');
  return colon != NULL ? colon + 1 : name;
}

static enum um_status refuse(const struct reader *r, const char *keyword, const char *value,
                             const char *accepted)
{
  return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: %.40s: '%.40s'; accepted: %s", r->name,
                      line_of(r), keyword, value, accepted);
}

static enum um_status put(struct reader *r, int line, const char *text)
{
  char copy[LINE];
  if (r->status != UM_OK) return r->status;
  if (++r->lines % 4096 == 0) UM_TRY(um_core_stop_check(r->context, "a message was read"));
  snprintf(copy, sizeof copy, "%s", text);
  return r->take(r->self, line, copy);
}

static enum um_status put_pair(struct reader *r, const char *keyword, const char *value)
{
  char line[LINE];
  snprintf(line, sizeof line, "%s = %s", keyword, value);
  return put(r, line_of(r), line);
}

/* --- rows ------------------------------------------------------------------------------------- */

static size_t fields_of(const struct um_orbit_ndm_form *form)
{
  size_t n = 0;
  while (n < UM_ORBIT_NDM_FIELDS && form->fields[n].keyword != NULL) n++;
  return n;
}

static enum um_status begin_row(struct reader *r)
{
  r->row = true;
  r->begin = line_of(r);
  r->epoch[0] = '\0';
  for (size_t k = 0; k < UM_ORBIT_NDM_FIELDS; k++) r->field[k][0] = '\0';
  return UM_OK;
}

static enum um_status keep(const struct reader *r, const char *keyword, char *to)
{
  if (to[0] != '\0')
    return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: %s stands twice in a %s", r->name,
                        line_of(r), keyword, r->form->row);
  memcpy(to, r->text, VALUE);
  return UM_OK;
}

/* A value in a row. What begins a line may be no keyword. */
static enum um_status take_field(struct reader *r, const char *keyword)
{
  const struct um_orbit_ndm_form *form = r->form;
  size_t n = fields_of(form), k = 0;
  char value[2 * VALUE];
  if (strcmp(keyword, "EPOCH") == 0) {
    if (!isdigit((unsigned char)r->text[0]))
      return refuse(r, keyword, r->text, "a time like 2016-09-21T20:33:00");
    return keep(r, keyword, r->epoch);
  }
  if (n == 0) {
    if (r->epoch[0] == '\0') return refuse(r, keyword, r->text, "EPOCH before it");
    snprintf(value, sizeof value, "%s %s", r->epoch, r->text);
    return put_pair(r, keyword, value);
  }
  while (k < n && strcmp(keyword, form->fields[k].keyword) != 0) k++;
  if (k == n) return UM_OK;
  const char *unit = form->fields[k].unit;
  if (unit != NULL && r->units[0] != '\0' && strcmp(r->units, unit) != 0)
    return refuse(r, keyword, r->units, unit);
  return keep(r, keyword, r->field[k]);
}

static enum um_status end_row(struct reader *r)
{
  char line[LINE];
  size_t n = fields_of(r->form), used;
  const char *missing = r->epoch[0] == '\0' ? "EPOCH" : NULL;
  r->row = false;
  for (size_t k = 0; k < n && missing == NULL; k++)
    if (r->field[k][0] == '\0') missing = r->form->fields[k].keyword;
  if (missing != NULL)
    return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: the %s that begins here has no %s",
                        r->name, r->begin, r->form->row, missing);
  if (n == 0) return UM_OK;
  used = (size_t)snprintf(line, sizeof line, "%s", r->epoch);
  for (size_t k = 0; k < n; k++)
    used += (size_t)snprintf(line + used, sizeof line - used, " %s", r->field[k]);
  return put(r, r->begin, line);
}

/* --- elements --------------------------------------------------------------------------------- */

static enum um_status begin_message(struct reader *r, const char *version)
{
  char keyword[32] = "CCSDS_";
  size_t n = strlen(keyword);
  for (const char *c = r->form->message; *c != '\0'; c++) keyword[n++] = (char)toupper(*c);
  snprintf(keyword + n, sizeof keyword - n, "_VERS");
  r->message = true;
  r->messages++;
  return put_pair(r, keyword, version);
}

static enum um_status begin_data(struct reader *r)
{
  r->data = true;
  if (r->described) return put(r, line_of(r), "DATA_START");
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s:%d: a segment without metadata; accepted: metadata before data", r->name,
                      line_of(r));
}

/* The value of an attribute, NULL: it is not there. */
static const char *attribute_of(const XML_Char **attribute, const char *name)
{
  for (; attribute[0] != NULL; attribute += 2)
    if (strcmp(attribute[0], name) == 0) return attribute[1];
  return NULL;
}

static enum um_status enter(struct reader *r, const char *name, const char *version)
{
  if (strcmp(name, r->form->message) == 0 && !r->message) return begin_message(r, version);
  if (!r->message || r->form->row == NULL) return UM_OK;
  if (strcmp(name, "segment") == 0) r->described = false;
  if (strcmp(name, "metadata") == 0) {
    r->meta = r->described = true;
    return put(r, line_of(r), "META_START");
  }
  if (strcmp(name, "data") == 0) return begin_data(r);
  return r->data && strcmp(name, r->form->row) == 0 ? begin_row(r) : UM_OK;
}

static void XMLCALL begin(void *self, const XML_Char *name, const XML_Char **attribute)
{
  struct reader *r = self;
  const char *units = attribute_of(attribute, "units");
  const char *version = attribute_of(attribute, "version");
  char digits[16];
  if (r->status != UM_OK) return;
  r->leaf = true;
  r->length = 0;
  snprintf(r->units, sizeof r->units, "%s", units != NULL ? units : "");
  snprintf(digits, sizeof digits, "%s", version != NULL ? version : "");
  if (++r->depth > DEPTH)
    stop(r, um_core_fail(r->context, UM_ERR_INPUT,
                         "%s:%d: more than %d elements in one another; accepted: no more", r->name,
                         line_of(r), DEPTH));
  else
    stop(r, enter(r, without_prefix(name), digits));
}

static void XMLCALL text(void *self, const XML_Char *part, int length)
{
  struct reader *r = self;
  size_t n = (size_t)length;
  if (r->status != UM_OK || !r->message) return;
  if (r->length + n >= VALUE) {
    r->length = VALUE;
    return;
  }
  memcpy(r->text + r->length, part, n);
  r->length += n;
}

/* The text of the innermost element without the blanks around it. */
static void trim(struct reader *r)
{
  char *first = r->text;
  size_t n = r->length;
  while (n > 0 && strchr(" \t\r\n", r->text[n - 1]) != NULL) n--;
  r->text[n] = '\0';
  first += strspn(first, " \t\r\n");
  memmove(r->text, first, strlen(first) + 1);
}

static enum um_status take_leaf(struct reader *r, const char *keyword)
{
  bool wanted = r->row || r->meta || r->form->row == NULL;
  if (!wanted || strcmp(keyword, "COMMENT") == 0) return UM_OK;
  if (r->length >= VALUE)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: %.40s is longer than %d bytes; accepted: no more", r->name,
                        line_of(r), keyword, VALUE - 1);
  trim(r);
  if (r->text[0] == '\0') return UM_OK;
  return r->row ? take_field(r, keyword) : put_pair(r, keyword, r->text);
}

static enum um_status leave(struct reader *r, const char *name)
{
  bool rows = r->message && r->form->row != NULL;
  if (strcmp(name, r->form->message) == 0) r->message = false;
  if (r->row && strcmp(name, r->form->row) == 0) return end_row(r);
  if (rows && strcmp(name, "metadata") == 0) {
    r->meta = false;
    if (r->form->end_of_meta != NULL) UM_TRY(put(r, line_of(r), r->form->end_of_meta));
    return put(r, line_of(r), "META_STOP");
  }
  if (!rows || strcmp(name, "data") != 0) return UM_OK;
  r->data = false;
  return put(r, line_of(r), "DATA_STOP");
}

static void XMLCALL end(void *self, const XML_Char *name)
{
  struct reader *r = self;
  if (r->status != UM_OK) return;
  if (r->message && r->leaf) stop(r, take_leaf(r, without_prefix(name)));
  r->leaf = false;
  r->depth--;
  if (r->status == UM_OK) stop(r, leave(r, without_prefix(name)));
}

static void XMLCALL doctype(void *self, const XML_Char *name, const XML_Char *system,
                            const XML_Char *public_id, int internal)
{
  struct reader *r = self;
  (void)name, (void)system, (void)public_id, (void)internal;
  stop(r, um_core_fail(r->context, UM_ERR_INPUT,
                       "%s:%d: a document type; accepted: navigation messages without", r->name,
                       line_of(r)));
}

/* --- files ------------------------------------------------------------------------------------ */

bool um_orbit_ndm_is(const char *text, const char *message)
{
  if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) text += 3;
  for (;;) {
    text += strspn(text, " \t\r\n");
    if (text[0] != '<') return false;
    if (text[1] != '?' && text[1] != '!') break;
    const char *closing = strncmp(text, "<!--", 4) == 0 ? "-->" : ">";
    text = strstr(text, closing);
    if (text == NULL) return false;
    text += strlen(closing);
  }
  size_t n = strcspn(++text, " \t\r\n/>"), prefix = strcspn(text, ":");
  if (prefix < n) text += prefix + 1, n -= prefix + 1;
  return (n == 3 && strncmp(text, "ndm", 3) == 0) ||
         (n == strlen(message) && strncmp(text, message, n) == 0);
}

static enum um_status parse(struct reader *r, const char *bytes, size_t length)
{
  XML_SetUserData(r->parser, r);
  XML_SetElementHandler(r->parser, begin, end);
  XML_SetCharacterDataHandler(r->parser, text);
  XML_SetStartDoctypeDeclHandler(r->parser, doctype);
  enum XML_Status parsed = XML_Parse(r->parser, bytes, (int)length, XML_TRUE);
  UM_TRY(r->status);
  if (parsed != XML_STATUS_OK)
    return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: not XML as it should be: %s", r->name,
                        line_of(r), XML_ErrorString(XML_GetErrorCode(r->parser)));
  if (r->messages > 0) return UM_OK;
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s: no element %s; accepted: navigation messages (NDM/XML) with one",
                      r->name, r->form->message);
}

enum um_status um_orbit_ndm_read(struct um_context *context, const char *name, const char *bytes,
                                 size_t length, const struct um_orbit_ndm_form *form,
                                 um_orbit_ndm_take *take, void *self)
{
  struct reader r = {.context = context, .name = name, .form = form, .take = take, .self = self};
  if (length > BYTES)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu bytes of XML; accepted: at most %zu", name,
                        length, BYTES);
  r.parser = XML_ParserCreate(NULL);
  if (r.parser == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  enum um_status status = parse(&r, bytes, length);
  XML_ParserFree(r.parser);
  return status;
}
