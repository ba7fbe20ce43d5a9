/* Mean-elements messages in XML (CCSDS 505.0-B, NDM/XML), by expat: every element `omm` is a
 * message, and those inside it that are named as keywords are its values. A document type is
 * refused, so that no entity can be declared. */
#include <expat.h>
#include <string.h>

#include "orbit/omm_impl.h"

#define VALUE 80 /* bytes of a value */

struct reader {
  struct um_context *context;
  const char *name;
  XML_Parser parser;
  struct um_orbit_elements *out;
  bool inside; /* of a message */
  struct um_orbit_omm omm;
  char value[UM_ORBIT_OMM_KEYWORDS][VALUE];
  size_t which, length; /* keyword whose text comes, UM_ORBIT_OMM_KEYWORDS: none; of its text */
  enum um_status status;
};

static void stop(struct reader *r, enum um_status status)
{
  r->status = status;
  (void)XML_StopParser(r->parser, XML_FALSE);
}

static int line_of(const struct reader *r) { return (int)XML_GetCurrentLineNumber(r->parser); }

static const char *without_prefix(const char *name)
{
  const char *colon = strchr(name, ':');
  return colon != NULL ? colon + 1 : name;
}

static void XMLCALL begin(void *self, const XML_Char *name, const XML_Char **attribute)
{
  struct reader *r = self;
  (void)attribute;
  r->which = UM_ORBIT_OMM_KEYWORDS;
  r->length = 0;
  if (strcmp(without_prefix(name), "omm") == 0) {
    r->inside = true;
    r->omm = (struct um_orbit_omm){.begin = line_of(r)};
  } else if (r->inside) {
    r->which = um_orbit_omm_find(name);
  }
}

static void XMLCALL text(void *self, const XML_Char *part, int length)
{
  struct reader *r = self;
  size_t n = (size_t)length;
  if (r->status != UM_OK || r->which == UM_ORBIT_OMM_KEYWORDS) return;
  if (r->length + n >= VALUE) {
    stop(r, um_core_fail(r->context, UM_ERR_INPUT,
                         "%s:%d: %s is longer than %d bytes; accepted: no more", r->name,
                         line_of(r), um_orbit_omm_keyword(r->which), VALUE - 1));
    return;
  }
  memcpy(r->value[r->which] + r->length, part, n);
  r->length += n;
}

/* The value of the keyword is complete. */
static enum um_status take(struct reader *r)
{
  char *value = r->value[r->which], *first = value;
  size_t n = r->length;
  while (n > 0 && strchr(" \t\r\n", value[n - 1]) != NULL) n--;
  value[n] = '\0';
  first += strspn(value, " \t\r\n");
  memmove(value, first, strlen(first) + 1);
  if (value[0] == '\0') return UM_OK;
  return um_orbit_omm_put(r->context, r->name, &r->omm, r->which, value, line_of(r));
}

static void XMLCALL end(void *self, const XML_Char *name)
{
  struct reader *r = self;
  enum um_status status = UM_OK;
  if (r->status != UM_OK) return;
  if (r->which < UM_ORBIT_OMM_KEYWORDS) status = take(r);
  r->which = UM_ORBIT_OMM_KEYWORDS;
  if (status == UM_OK && strcmp(without_prefix(name), "omm") == 0) {
    r->inside = false;
    status = um_orbit_omm_add(r->context, r->name, &r->omm, r->out);
  }
  if (status != UM_OK) stop(r, status);
}

static void XMLCALL doctype(void *self, const XML_Char *name, const XML_Char *system,
                            const XML_Char *public_id, int internal)
{
  struct reader *r = self;
  (void)name, (void)system, (void)public_id, (void)internal;
  stop(r, um_core_fail(r->context, UM_ERR_INPUT,
                       "%s:%d: a document type; accepted: mean-elements messages without", r->name,
                       line_of(r)));
}

enum um_status um_orbit_omm_xml(struct um_context *context, const char *name, const char *bytes,
                                size_t length, struct um_orbit_elements *out)
{
  struct reader r = {.context = context,
                     .name = name,
                     .parser = XML_ParserCreate(NULL),
                     .out = out,
                     .which = UM_ORBIT_OMM_KEYWORDS};
  if (r.parser == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  XML_SetUserData(r.parser, &r);
  XML_SetElementHandler(r.parser, begin, end);
  XML_SetCharacterDataHandler(r.parser, text);
  XML_SetStartDoctypeDeclHandler(r.parser, doctype);
  enum XML_Status parsed = XML_Parse(r.parser, bytes, (int)length, XML_TRUE);
  enum um_status status = r.status;
  if (parsed != XML_STATUS_OK && status == UM_OK)
    status = um_core_fail(context, UM_ERR_INPUT, "%s:%d: not XML as it should be: %s", name,
                          line_of(&r), XML_ErrorString(XML_GetErrorCode(r.parser)));
  XML_ParserFree(r.parser);
  return status;
}
