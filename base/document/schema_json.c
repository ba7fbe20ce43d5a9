/* The JSON Schema (draft 2020-12) of a schema. Mappings are written where they stand. */
#include <math.h>
#include <string.h>

#include "base/core/json.h"
#include "base/document/schema.h"

#define DEPTH_MAX 24

static bool write_object(FILE *file, const struct um_schema_object *object, const char *help,
                         int depth);

/* {"type": "number", "minimum": ..., "maximum": ...} without the closing brace */
static void open_number(FILE *file, const struct um_schema_field *field, const char *type)
{
  fprintf(file, "{\"type\": \"%s\"", type);
  double minimum = field->minimum, maximum = field->maximum;
  if (minimum == maximum) return;
  if (field->type == UM_SCHEMA_INTEGER) {
    maximum = floor(maximum);
    minimum = field->open_minimum ? floor(minimum) : ceil(minimum);
  }
  if (isfinite(minimum))
    fprintf(file, ", \"%s\": %.17g", field->open_minimum ? "exclusiveMinimum" : "minimum", minimum);
  if (isfinite(maximum)) fprintf(file, ", \"maximum\": %.17g", maximum);
}

static void write_default(FILE *file, const struct um_schema_field *field)
{
  double value = field->default_value;
  if (field->required || field->alternative != 0 || isnan(value)) return;
  if (field->type == UM_SCHEMA_NUMBER || field->type == UM_SCHEMA_INTEGER)
    fprintf(file, ", \"default\": %.17g", value);
  else if (field->type == UM_SCHEMA_BOOL)
    fprintf(file, ", \"default\": %s", value != 0.0 ? "true" : "false");
  else if (field->type == UM_SCHEMA_CHOICE)
    um_core_json_text(file, ", ", "default", field->choices[(int)value]);
}

/* YAML reads an unquoted text like 12 as a number; a text accepts it. */
#define TEXT_TYPES "{\"type\": [\"string\", \"number\", \"boolean\"]"

/* What um_core_name_is_safe passes. */
#define NAME_FORBIDS                                                                               \
  "\\u0000-\\u001f\\u007f-\\u009f\\u200b-\\u200f\\u2028-\\u202e\\u2060-\\u206f\\ufeff`\"\\\\$"
#define NAME_PATTERN "^([^=+@\\-" NAME_FORBIDS "][^" NAME_FORBIDS "]*)?$"

static void write_most(FILE *file, const struct um_schema_field *field, const char *member)
{
  if (field->most > 0) fprintf(file, ", \"%s\": %zu", member, field->most);
}

/* The scalar that may stand for a mapping. */
static bool write_either(FILE *file, const struct um_schema_object *object, const char *help,
                         int depth);

static bool write_field(FILE *file, const struct um_schema_field *field, int depth)
{
  bool good = true;
  switch (field->type) {
  case UM_SCHEMA_NUMBER:
  case UM_SCHEMA_REST:
    open_number(file, field, "number");
    break;
  case UM_SCHEMA_INTEGER:
    open_number(file, field, "integer");
    break;
  case UM_SCHEMA_BOOL:
    fputs("{\"type\": \"boolean\"", file);
    break;
  case UM_SCHEMA_TEXT:
  case UM_SCHEMA_PARSED:
    fputs(TEXT_TYPES, file);
    if (field->name) um_core_json_text(file, ", ", "pattern", NAME_PATTERN);
    break;
  case UM_SCHEMA_CHOICE:
    fputs("{\"enum\": [", file);
    for (size_t i = 0; field->choices[i] != NULL; i++) {
      if (i > 0) fputs(", ", file);
      um_core_json_string(file, field->choices[i]);
    }
    fputs("]", file);
    break;
  case UM_SCHEMA_VECTOR:
  case UM_SCHEMA_NUMBERS:
    fputs("{\"type\": \"array\"", file);
    if (field->type == UM_SCHEMA_VECTOR)
      fprintf(file, ", \"minItems\": %zu, \"maxItems\": %zu", field->length, field->length);
    else
      write_most(file, field, "maxItems");
    fputs(", \"items\": ", file);
    open_number(file, field, "number");
    fputs("}", file);
    break;
  case UM_SCHEMA_TEXTS:
    fputs("{\"type\": \"array\", \"items\": " TEXT_TYPES, file);
    if (field->name) um_core_json_text(file, ", ", "pattern", NAME_PATTERN);
    fputs("}", file);
    write_most(file, field, "maxItems");
    break;
  case UM_SCHEMA_MAP:
    return write_either(file, field->object, field->help, depth);
  case UM_SCHEMA_LIST:
    fputs("{\"type\": \"array\", \"items\": ", file);
    good = write_either(file, field->object, field->object->help, depth);
    write_most(file, field, "maxItems");
    break;
  case UM_SCHEMA_DICT:
    fputs("{\"type\": \"object\", \"additionalProperties\": ", file);
    good = write_either(file, field->object, field->object->help, depth);
    write_most(file, field, "maxProperties");
    break;
  }
  write_default(file, field);
  if (field->help != NULL) um_core_json_text(file, ", ", "description", field->help);
  fputs("}", file);
  return good;
}

static bool write_either(FILE *file, const struct um_schema_object *object, const char *help,
                         int depth)
{
  const struct um_schema_field *scalar = NULL;
  for (size_t i = 0; object->scalar_key != NULL && i < object->nfield; i++)
    if (strcmp(object->fields[i].key, object->scalar_key) == 0) scalar = &object->fields[i];
  if (scalar == NULL) return write_object(file, object, help, depth + 1);
  fputs("{\"anyOf\": [", file);
  if (!write_field(file, scalar, depth + 1)) return false;
  fputs(", ", file);
  if (!write_object(file, object, help, depth + 1)) return false;
  fputs("]}", file);
  return true;
}

/* Groups of keys of which one, or at most one, may be present. */
static void write_group(FILE *file, const struct um_schema_object *object, int group, bool one)
{
  bool first = true;
  fputs(one ? "{\"oneOf\": [" : "{\"not\": {\"anyOf\": [", file);
  for (size_t i = 0; i < object->nfield; i++) {
    if (object->fields[i].alternative != group) continue;
    if (one) {
      fprintf(file, "%s{\"required\": [\"%s\"]}", first ? "" : ", ", object->fields[i].key);
      first = false;
    }
    for (size_t j = i + 1; !one && j < object->nfield; j++) {
      if (object->fields[j].alternative != group) continue;
      fprintf(file, "%s{\"required\": [\"%s\", \"%s\"]}", first ? "" : ", ", object->fields[i].key,
              object->fields[j].key);
      first = false;
    }
  }
  fputs(one ? "]}" : "]}}", file);
}

/* Members of a group; counted once, at the first. */
static size_t group_size(const struct um_schema_object *object, size_t index)
{
  size_t count = 0;
  int group = object->fields[index].alternative;
  if (group == 0) return 0;
  for (size_t i = 0; i < object->nfield; i++) {
    if (object->fields[i].alternative != group) continue;
    if (i < index) return 0;
    count++;
  }
  return count;
}

static void write_groups(FILE *file, const struct um_schema_object *object)
{
  bool any = false;
  for (size_t i = 0; i < object->nfield; i++) {
    bool one = false;
    size_t size = group_size(object, i);
    for (const int *g = object->exactly_one; g != NULL && *g != 0; g++)
      one = one || *g == object->fields[i].alternative;
    if (size == 0 || (size == 1 && !one)) continue;
    fputs(any ? ", " : ", \"allOf\": [", file);
    write_group(file, object, object->fields[i].alternative, one);
    any = true;
  }
  if (any) fputs("]", file);
}

/* The members of an object schema behind its opening brace, and the closing brace. */
static bool write_members(FILE *file, const struct um_schema_object *object, const char *help,
                          int depth)
{
  if (depth > DEPTH_MAX) return false;
  fputs("\"type\": \"object\"", file);
  um_core_json_text(file, ", ", "title", object->name);
  if (help == NULL) help = object->help;
  if (help != NULL) um_core_json_text(file, ", ", "description", help);
  fputs(", \"properties\": {", file);
  const struct um_schema_field *rest = NULL;
  bool first = true;
  for (size_t i = 0; i < object->nfield; i++) {
    if (object->fields[i].type == UM_SCHEMA_REST) {
      rest = &object->fields[i];
      continue;
    }
    fprintf(file, "%s\n%*s", first ? "" : ",", 2 * depth, "");
    um_core_json_string(file, object->fields[i].key);
    fputs(": ", file);
    if (!write_field(file, &object->fields[i], depth)) return false;
    first = false;
  }
  fputs("}, \"additionalProperties\": ", file);
  if (rest == NULL)
    fputs("false", file);
  else if (!write_field(file, rest, depth))
    return false;
  bool any = false;
  for (size_t i = 0; i < object->nfield; i++) {
    if (!object->fields[i].required) continue;
    fputs(any ? ", " : ", \"required\": [", file);
    um_core_json_string(file, object->fields[i].key);
    any = true;
  }
  if (any) fputs("]", file);
  write_groups(file, object);
  fputs("}", file);
  return true;
}

static bool write_object(FILE *file, const struct um_schema_object *object, const char *help,
                         int depth)
{
  fputs("{", file);
  return write_members(file, object, help, depth);
}

enum um_status um_document_schema_write_json(FILE *file, const struct um_schema_object *schema)
{
  fputs("{\"$schema\": \"https://json-schema.org/draft/2020-12/schema\", ", file);
  if (!write_members(file, schema, NULL, 1)) return UM_ERR_MEMORY;
  fputs("\n", file);
  return ferror(file) ? UM_ERR_IO : UM_OK;
}

enum um_status um_document_schema_write_json_field(FILE *file, const struct um_schema_field *field)
{
  if (!write_field(file, field, 1)) return UM_ERR_MEMORY;
  fputs("\n", file);
  return ferror(file) ? UM_ERR_IO : UM_OK;
}
