/* The reference page (Markdown) of a schema: one section per kind of mapping, in order of first
 * mention. */
#include <math.h>
#include <string.h>

#include "base/document/schema.h"

#define OBJECTS_MAX 256
#define PATH_SIZE   160

/* Mappings found so far and the key path of their first mention. */
struct queue {
  const struct um_schema_object *objects[OBJECTS_MAX];
  char paths[OBJECTS_MAX][PATH_SIZE];
  size_t count;
};

static bool enqueue(struct queue *q, const struct um_schema_object *object, const char *parent,
                    const struct um_schema_field *field)
{
  for (size_t i = 0; i < q->count; i++)
    if (q->objects[i] == object) return true;
  if (q->count == OBJECTS_MAX) return false;
  q->objects[q->count] = object;
  if (field != NULL) {
    const char *tail = field->type == UM_SCHEMA_LIST ? "[]" : "";
    if (field->type == UM_SCHEMA_DICT) tail = ".NAME";
    snprintf(q->paths[q->count], PATH_SIZE, "%.100s%s%.40s%s", parent, parent[0] != '\0' ? "." : "",
             field->key, tail);
  }
  q->count++;
  return true;
}

static void write_text(FILE *file, const char *text)
{
  for (const char *p = text == NULL ? "" : text; *p != '\0'; p++) {
    if (*p == '|') fputc('\\', file);
    fputc(*p, file);
  }
}

static void write_default(FILE *file, const struct um_schema_object *object,
                          const struct um_schema_field *field)
{
  double value = field->default_value;
  bool one_of = false;
  for (const int *g = object->exactly_one; g != NULL && *g != 0; g++)
    one_of = one_of || *g == field->alternative;
  if (field->required)
    fputs("required", file);
  else if (one_of)
    fprintf(file, "one of group %d", field->alternative);
  else if (isnan(value))
    fputs("none", file);
  else if (field->type == UM_SCHEMA_NUMBER || field->type == UM_SCHEMA_INTEGER)
    fprintf(file, "%.10g", value);
  else if (field->type == UM_SCHEMA_BOOL)
    fputs(value != 0.0 ? "true" : "false", file);
  else if (field->type == UM_SCHEMA_CHOICE)
    fputs(field->choices[(int)value], file);
  else if (field->type == UM_SCHEMA_VECTOR)
    fprintf(file, "all %.10g", value);
  else
    fputs("none", file);
}

static void write_accepted(FILE *file, const struct um_schema_field *field)
{
  char text[512];
  switch (field->type) {
  case UM_SCHEMA_MAP:
    fprintf(file, "%s", field->object->name);
    break;
  case UM_SCHEMA_LIST:
    fprintf(file, "list of %s", field->object->name);
    break;
  case UM_SCHEMA_DICT:
    fprintf(file, "names, each a %s", field->object->name);
    break;
  default:
    um_document_schema_accepted(field, text, sizeof text);
    write_text(file, text);
  }
}

static void write_row(FILE *file, const struct um_schema_object *object,
                      const struct um_schema_field *field)
{
  fprintf(file, "| `%s` | ", field->key);
  write_accepted(file, field);
  fputs(" | ", file);
  write_default(file, object, field);
  fputs(" | ", file);
  write_text(file, field->help);
  if (field->alternative != 0) fprintf(file, " (group %d)", field->alternative);
  fputs(" |\n", file);
}

#define TABLE_HEAD "| key | accepted | default | meaning |\n|---|---|---|---|\n"

/* A heading, the path, and the table of an object's keys. */
static void write_object(FILE *file, const char *marks, const struct um_schema_object *object,
                         const char *path)
{
  fprintf(file, "%s %s\n\n", marks, object->name);
  if (path[0] != '\0') fprintf(file, "Stands at `%s`.", path);
  if (path[0] != '\0' && object->help != NULL) fputc(' ', file);
  write_text(file, object->help);
  if (object->scalar_key != NULL)
    fprintf(file, " A plain value stands for `{%s: value}`.", object->scalar_key);
  fputs("\n\n" TABLE_HEAD, file);
  bool groups = false;
  for (size_t i = 0; i < object->nfield; i++) {
    write_row(file, object, &object->fields[i]);
    groups = groups || object->fields[i].alternative != 0;
  }
  fputs(groups ? "\nKeys of one group exclude each other.\n\n" : "\n", file);
}

static bool write_section(FILE *file, struct queue *q, size_t index)
{
  const struct um_schema_object *object = q->objects[index];
  write_object(file, index == 0 ? "#" : "##", object, q->paths[index]);
  for (size_t i = 0; i < object->nfield; i++)
    if (object->fields[i].object != NULL &&
        !enqueue(q, object->fields[i].object, q->paths[index], &object->fields[i]))
      return false;
  return true;
}

enum um_status um_document_schema_write_field(FILE *file, const struct um_schema_object *object,
                                              const struct um_schema_field *field, const char *path)
{
  const struct um_schema_object *section = field->object;
  if (section == NULL) {
    fprintf(file, "# %s\n\n" TABLE_HEAD, path);
    write_row(file, object, field);
    return ferror(file) ? UM_ERR_IO : UM_OK;
  }
  write_object(file, "#", section, path);
  bool first = true;
  for (size_t i = 0; i < section->nfield; i++) {
    if (section->fields[i].object == NULL) continue;
    fprintf(file, "%s`%s.%s`", first ? "Sections of it: " : ", ", path, section->fields[i].key);
    first = false;
  }
  if (!first) fputs(".\n", file);
  return ferror(file) ? UM_ERR_IO : UM_OK;
}

enum um_status um_document_schema_write_markdown(FILE *file, const struct um_schema_object *schema)
{
  struct queue q = {.count = 0};
  (void)enqueue(&q, schema, "", NULL);
  for (size_t i = 0; i < q.count; i++)
    if (!write_section(file, &q, i)) return UM_ERR_MEMORY;
  return ferror(file) ? UM_ERR_IO : UM_OK;
}
