/* What mean-elements messages are written in: key = value, XML as such lines, JSON as catalogues
 * send it, one object or a list of them, and CSV, a row a message. Keywords that no orbit needs are
 * left alone. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/document/schema.h"
#include "orbit/message_impl.h"
#include "orbit/omm_impl.h"

#define VALUE 80 /* bytes of a value, with its end */

/* --- key = value and XML ---------------------------------------------------------------------- */

struct reader {
  struct um_context *context;
  const char *name;
  struct um_orbit_elements *out;
  struct um_orbit_omm omm;
  char value[UM_ORBIT_OMM_KEYWORDS][VALUE];
};

/* A value without its unit, "98.2 [deg]". */
static char *without_unit(char *value)
{
  char *unit = strchr(value, '[');
  while (unit != NULL && unit > value && strchr(" \t", unit[-1]) != NULL) unit--;
  if (unit != NULL) *unit = '\0';
  return value;
}

static enum um_status put(struct reader *r, int line, size_t which, const char *value)
{
  size_t n = strlen(value);
  if (n >= VALUE)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: %s is longer than %d bytes; accepted: no more", r->name, line,
                        um_orbit_omm_keyword(which), VALUE - 1);
  UM_TRY(um_orbit_omm_put(r->context, r->name, &r->omm, which, r->value[which], line));
  memcpy(r->value[which], value, n + 1);
  return UM_OK;
}

static enum um_status take_line(void *self, int line, char *text)
{
  struct reader *r = self;
  char *begin = text + strspn(text, " \t\r"), *key, *value;
  if (begin[0] == '\0' || (strncmp(begin, "COMMENT", 7) == 0 && strchr(" \t\r", begin[7]) != NULL))
    return UM_OK;
  if (!um_orbit_message_pair(begin, &key, &value))
    return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: '%.40s'; accepted: KEYWORD = value",
                        r->name, line, begin);
  value = without_unit(value);
  if (strcmp(key, "CCSDS_OMM_VERS") == 0) {
    if (r->omm.begin > 0) UM_TRY(um_orbit_omm_add(r->context, r->name, &r->omm, r->out));
    r->omm = (struct um_orbit_omm){.begin = line};
    return UM_OK;
  }
  size_t which = um_orbit_omm_find(key);
  return which < UM_ORBIT_OMM_KEYWORDS ? put(r, line, which, value) : UM_OK;
}

enum um_status um_orbit_omm_kvn(struct um_context *context, const char *name, char *text,
                                struct um_orbit_elements *out)
{
  struct reader r = {.context = context, .name = name, .out = out};
  int line = 0;
  for (char *at = text, *next; at != NULL; at = next) {
    char *end = at + strcspn(at, "\n");
    next = *end != '\0' ? end + 1 : NULL;
    *end = '\0';
    UM_TRY(take_line(&r, ++line, at));
  }
  return um_orbit_omm_add(context, name, &r.omm, out);
}

enum um_status um_orbit_omm_xml(struct um_context *context, const char *name, const char *bytes,
                                size_t length, struct um_orbit_elements *out)
{
  static const struct um_orbit_ndm_form form = {.message = "omm"};
  struct reader r = {.context = context, .name = name, .out = out};
  UM_TRY(um_orbit_ndm_read(context, name, bytes, length, &form, take_line, &r));
  return um_orbit_omm_add(context, name, &r.omm, out);
}

/* --- JSON ------------------------------------------------------------------------------------ */

struct message {
  struct um_mark at;
};
struct file {
  struct um_mark at;
  struct um_schema_list messages; /* struct message */
};
static const struct um_schema_object message_object = {
    .name = "mean-elements message",
    .help = "",
    .size = sizeof(struct message),
    .others = true,
};
static const struct um_schema_field file_fields[] = {
    UM_FIELD(struct file, messages, "messages", UM_SCHEMA_LIST, .object = &message_object),
};
static const struct um_schema_object file_object = {
    .name = "elements",
    .help = "",
    .size = sizeof(struct file),
    .fields = file_fields,
    .nfield = 1,
};

/* The text, one message or a list of them, as the value of the key of file_object. Lines stay. */
static enum um_status wrap(struct um_context *context, const char *text, char **out)
{
  bool list = text[strspn(text, " \t\r\n")] == '[';
  return um_core_asprintf(context, out, "{\"messages\": %s%s%s}", list ? "" : "[", text,
                          list ? "" : "]");
}

static enum um_status json_message(struct um_context *context, const char *name,
                                   struct um_document *document, const struct message *message,
                                   size_t which, struct um_orbit_elements *out)
{
  struct um_orbit_omm omm = {.begin = message->at.line};
  for (size_t k = 0; k < UM_ORBIT_OMM_KEYWORDS; k++) {
    struct um_document_value value;
    char path[80];
    snprintf(path, sizeof path, "messages.%zu.%s", which, um_orbit_omm_keyword(k));
    UM_TRY(um_document_value(document, path, &value));
    if (value.kind != UM_DOCUMENT_NUMBER && value.kind != UM_DOCUMENT_TEXT) continue;
    omm.text[k] = value.text;
    omm.line[k] = um_document_mark_key(&message->at, um_orbit_omm_keyword(k))->line;
  }
  return um_orbit_omm_add(context, name, &omm, out);
}

enum um_status um_orbit_omm_json(struct um_context *context, const char *name, const char *text,
                                 struct um_orbit_elements *out)
{
  enum um_status status;
  struct um_document *document = NULL;
  struct file *file = NULL;
  char *wrapped = NULL;
  UM_CHECK(wrap(context, text, &wrapped));
  UM_CHECK(
      um_document_parse(context, name, wrapped, &file_object, NULL, 0, &document, (void **)&file));
  for (size_t i = 0; i < file->messages.count; i++)
    UM_CHECK(json_message(context, name, document, (const struct message *)file->messages.items + i,
                          i, out));
done:
  um_document_destroy(&document);
  um_core_free(context, wrapped);
  return status;
}

/* --- CSV ------------------------------------------------------------------------------------- */

enum um_status um_orbit_omm_csv(struct um_context *context, const char *name, const char *text,
                                size_t length, struct um_orbit_elements *out)
{
  struct um_core_csv *csv = NULL;
  UM_TRY(um_core_csv_parse(context, name, text, length, &csv));
  enum um_status status = UM_OK;
  for (size_t row = 0; row < um_core_csv_rows(csv) && status == UM_OK; row++) {
    struct um_orbit_omm omm = {.begin = um_core_csv_line(csv, row)};
    for (size_t k = 0; k < UM_ORBIT_OMM_KEYWORDS; k++) {
      size_t column = um_core_csv_find(csv, um_orbit_omm_keyword(k));
      if (column == SIZE_MAX || um_core_csv_text(csv, row, column)[0] == '\0') continue;
      omm.text[k] = um_core_csv_text(csv, row, column);
      omm.line[k] = omm.begin;
    }
    status = um_orbit_omm_add(context, name, &omm, out);
  }
  um_core_csv_destroy(&csv);
  return status;
}
