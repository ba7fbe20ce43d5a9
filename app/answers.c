/* The JSON Schema of what commands print with --json, from answers.def. */
#include "app/answers.h"

#include <string.h>

#include "base/core/json.h"

enum kind {
  ANSWER, /* begins a block; no key */
  TEXT,
  TEXT_OR_NULL,
  NUMBER,
  NUMBER_OR_NULL,
  COUNT,
  TRUTH,
  GROUP_OR_NULL,
  SCHEMA,
  ANY
};

struct row {
  const char *path; /* of an ANSWER the command */
  enum kind kind;
  const char *what; /* of an ANSWER when it is the answer */
};

static const struct row rows[] = {
#define ANSWER(command, when) {command, ANSWER, when},
#define KEY(path, kind, what) {path, kind, what},
#include "app/answers.def"
#undef ANSWER
#undef KEY
};
#define ROWS (sizeof rows / sizeof rows[0])

/* The keys of an answer. */
struct keys {
  const struct row *row;
  size_t n;
};

/* A value within an answer: all keys whose paths begin with the n characters of `path`. */
struct place {
  const struct keys *of;
  const char *path;
  size_t n;
};

/* What stands behind the place in a key's path, NULL where it is no key of it. */
static const char *behind(const struct place *place, const struct row *row)
{
  if (strncmp(row->path, place->path, place->n) != 0) return NULL;
  const char *rest = row->path + place->n;
  return place->n == 0 || strchr(".[", *rest) != NULL ? rest : NULL;
}

/* A name's length with its "?". */
static size_t name_length(const char *rest) { return strcspn(rest, ".["); }

static const char *name_of(const char *rest) { return *rest == '.' ? rest + 1 : rest; }

/* Is this the first key that has this name at the place? */
static bool is_first(const struct place *place, size_t i)
{
  const char *name = name_of(behind(place, &place->of->row[i]));
  for (size_t k = 0; k < i; k++) {
    const char *rest = behind(place, &place->of->row[k]);
    if (rest == NULL || *rest == '\0') continue;
    const char *other = name_of(rest);
    if (name_length(other) == name_length(name) && strncmp(other, name, name_length(name)) == 0)
      return false;
  }
  return true;
}

static void put_value(FILE *file, const struct place *place, const char *title);

/* The next name at the place from key *i on, *i being behind it then; NULL: no more. */
static const char *next_name(const struct place *place, size_t *i)
{
  while (*i < place->of->n) {
    const char *rest = behind(place, &place->of->row[*i]);
    bool taken = rest != NULL && *rest != '\0' && is_first(place, *i);
    (*i)++;
    if (taken) return name_of(rest);
  }
  return NULL;
}

static void put_object(FILE *file, const struct place *place)
{
  const char *name, *between = "";
  bool open = false;
  fputs(", \"properties\": {", file);
  for (size_t i = 0; (name = next_name(place, &i)) != NULL;) {
    const char *path = place->of->row[i - 1].path;
    size_t n = name_length(name);
    const struct place inside = {place->of, path, (size_t)(name - path) + n};
    open = *name == '*';
    if (open) {
      fputs("}, \"additionalProperties\": ", file);
    } else {
      bool optional = name[n - 1] == '?';
      fprintf(file, "%s\"%.*s\": ", between, (int)(optional ? n - 1 : n), name);
      between = ", ";
    }
    put_value(file, &inside, "");
  }
  if (open) return;
  fputs("}, \"required\": [", file);
  between = "";
  for (size_t i = 0; (name = next_name(place, &i)) != NULL;) {
    size_t n = name_length(name);
    if (name[n - 1] == '?') continue;
    fprintf(file, "%s\"%.*s\"", between, (int)n, name);
    between = ", ";
  }
  fputs("], \"additionalProperties\": false", file);
}

static const char *type_name(enum kind kind)
{
  switch (kind) {
  case TEXT:
    return "\"string\"";
  case TEXT_OR_NULL:
    return "[\"string\", \"null\"]";
  case NUMBER:
    return "\"number\"";
  case NUMBER_OR_NULL:
    return "[\"number\", \"null\"]";
  case COUNT:
    return "\"integer\", \"minimum\": 0";
  case TRUTH:
    return "\"boolean\"";
  case SCHEMA:
    return "\"object\"";
  case ANY:
    return "[\"object\", \"array\"]";
  case ANSWER:
  case GROUP_OR_NULL:
    break;
  }
  return "";
}

static void put_value(FILE *file, const struct place *place, const char *title)
{
  const struct row *own = NULL; /* the key that is the place itself */
  const char *inside = NULL;    /* what stands behind it in the others */
  const char *path = NULL;
  for (size_t i = 0; i < place->of->n; i++) {
    const char *rest = behind(place, &place->of->row[i]);
    if (rest == NULL) continue;
    if (*rest == '\0') own = &place->of->row[i];
    if (*rest == '\0' || inside != NULL) continue;
    inside = rest;
    path = place->of->row[i].path;
  }
  bool list = inside != NULL && *inside == '[';
  fputc('{', file);
  if (title[0] != '\0') um_core_json_text(file, "", "title", title);
  fputs(title[0] != '\0' ? ", \"type\": " : "\"type\": ", file);
  if (inside == NULL)
    fputs(own != NULL ? type_name(own->kind) : "\"object\"", file);
  else
    fprintf(file, own != NULL ? "[\"%s\", \"null\"]" : "\"%s\"", list ? "array" : "object");
  if (own != NULL && own->what[0] != '\0') um_core_json_text(file, ", ", "description", own->what);
  if (list) {
    const struct place item = {place->of, path, place->n + strlen("[]")};
    fputs(", \"items\": ", file);
    put_value(file, &item, "");
  } else if (inside != NULL) {
    put_object(file, place);
  }
  fputc('}', file);
}

/* The next block of a command from row *i on, *i being behind it then; NULL: no more. */
static const struct row *next_answer(const char *command, size_t *i, struct keys *out)
{
  while (*i < ROWS) {
    const struct row *row = &rows[(*i)++];
    if (row->kind != ANSWER || strcmp(row->path, command) != 0) continue;
    for (*out = (struct keys){row + 1, 0}; *i < ROWS && rows[*i].kind != ANSWER; (*i)++) out->n++;
    return row;
  }
  return NULL;
}

void um_app_answer_schema(FILE *file, const char *command)
{
  const struct row *row;
  struct keys keys;
  const char *between = "";
  fputs("{\"$schema\": \"https://json-schema.org/draft/2020-12/schema\", \"title\": \"umbra ",
        file);
  fprintf(file, "%s --json\", \"anyOf\": [", command);
  for (size_t i = 0; (row = next_answer(command, &i, &keys)) != NULL; between = ",") {
    const struct place whole = {&keys, "", 0};
    fprintf(file, "%s\n  ", between);
    put_value(file, &whole, row->what);
  }
  fputs("]}", file);
}
