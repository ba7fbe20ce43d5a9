/* What a field of a schema accepts, in words. */
#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "base/document/schema.h"

static void append(char *buffer, size_t size, const char *text)
{
  size_t used = strlen(buffer);
  if (used + 1 < size) snprintf(buffer + used, size - used, "%s", text);
}

/* ", more than 0, at most 1"; the bounds of a whole number are the whole numbers inside them */
static void append_range(const struct um_schema_field *field, char *buffer, size_t size)
{
  char text[96];
  bool whole = field->type == UM_SCHEMA_INTEGER;
  double minimum = field->minimum, maximum = field->maximum;
  if (minimum == maximum) return;
  if (whole) maximum = floor(maximum);
  if (whole) minimum = field->open_minimum ? floor(minimum) : ceil(minimum);
  if (isfinite(minimum)) {
    snprintf(text, sizeof text, ", %s %.10g", field->open_minimum ? "more than" : "at least",
             minimum);
    append(buffer, size, text);
  }
  if (isfinite(maximum)) {
    snprintf(text, sizeof text, ", at most %.10g", maximum);
    append(buffer, size, text);
  }
}

static void append_most(const struct um_schema_field *field, char *buffer, size_t size)
{
  char text[48];
  if (field->most == 0) return;
  snprintf(text, sizeof text, ", at most %zu of them,", field->most);
  append(buffer, size, text);
}

/* The keys of a mapping, or the single value that may stand for it. */
static void append_keys(const struct um_schema_object *object, char *buffer, size_t size)
{
  char keys[384] = "";
  for (size_t i = 0; i < object->nfield; i++)
    if (object->fields[i].type != UM_SCHEMA_REST)
      um_core_words_append(keys, sizeof keys, object->fields[i].key);
  append(buffer, size, " with the keys ");
  append(buffer, size, keys);
  for (size_t i = 0; object->scalar_key != NULL && i < object->nfield; i++) {
    if (strcmp(object->fields[i].key, object->scalar_key) != 0) continue;
    char value[256];
    um_document_schema_accepted(&object->fields[i], value, sizeof value);
    append(buffer, size, ", or ");
    append(buffer, size, value);
  }
}

void um_document_schema_accepted(const struct um_schema_field *field, char *buffer, size_t size)
{
  buffer[0] = '\0';
  switch (field->type) {
  case UM_SCHEMA_NUMBER:
    append(buffer, size, "a finite number");
    append_range(field, buffer, size);
    break;
  case UM_SCHEMA_INTEGER:
    append(buffer, size, "a whole number");
    append_range(field, buffer, size);
    break;
  case UM_SCHEMA_BOOL:
    append(buffer, size, "true or false");
    break;
  case UM_SCHEMA_TEXT:
    append(buffer, size, field->name ? UM_CORE_NAME_ACCEPTED : "a text");
    break;
  case UM_SCHEMA_CHOICE:
    for (size_t i = 0; field->choices[i] != NULL; i++)
      um_core_words_append(buffer, size, field->choices[i]);
    break;
  case UM_SCHEMA_VECTOR:
    snprintf(buffer, size, "a list of %zu finite numbers", field->length);
    append_range(field, buffer, size);
    break;
  case UM_SCHEMA_NUMBERS:
    append(buffer, size, "a list of finite numbers");
    append_most(field, buffer, size);
    append_range(field, buffer, size);
    break;
  case UM_SCHEMA_TEXTS:
    append(buffer, size, "a list of texts");
    append_most(field, buffer, size);
    break;
  case UM_SCHEMA_MAP:
    append(buffer, size, "a mapping");
    append_keys(field->object, buffer, size);
    break;
  case UM_SCHEMA_LIST:
    append(buffer, size, "a list of mappings");
    append_most(field, buffer, size);
    append_keys(field->object, buffer, size);
    break;
  case UM_SCHEMA_DICT:
    append(buffer, size, "names, each a mapping");
    append_most(field, buffer, size);
    append_keys(field->object, buffer, size);
    break;
  case UM_SCHEMA_PARSED:
    append(buffer, size, "a single value");
    break;
  case UM_SCHEMA_REST:
    append(buffer, size, "finite numbers by name");
    break;
  }
}
