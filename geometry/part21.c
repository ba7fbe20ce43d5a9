/* Exchange files of ISO 10303-21:2002, clear text encoding. One pass: values go to one list in the
 * order of the file, lists within lists by a stack of fixed depth. */
#include "geometry/part21_impl.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/core/number.h"
#include "base/core/sort.h"

#define NUMBER_LONGEST 64
#define OFTEN          4096 /* instances between two looks whether to stop */

struct reader {
  struct um_context *context;
  const char *path;
  const char *at, *stop;
  int line;
  struct um_geometry_part21 *file;
  um_geometry_part21_wanted wanted;
};

/* "file:line: found; accepted: ..." at the place that is read. */
static enum um_status fail(const struct reader *r, const char *expected)
{
  char found[24] = "the end of the file";
  if (r->at < r->stop) {
    size_t n = 0, left = (size_t)(r->stop - r->at);
    while (n < 12 && n < left && r->at[n] > ' ' && r->at[n] < 0x7f) n++;
    snprintf(found, sizeof found, "'%.*s'", (int)n, r->at);
  }
  return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: %s in a STEP file; accepted: %s", r->path,
                      r->line, found, expected);
}

/* To the next sign that is neither blank nor comment. */
static enum um_status skip(struct reader *r)
{
  for (bool comment = false; r->at < r->stop; r->at++) {
    bool pair = r->at + 1 < r->stop;
    if (*r->at == '\n') r->line++;
    if (comment) {
      if (!(pair && r->at[0] == '*' && r->at[1] == '/')) {
        if (!pair) break;
        continue;
      }
      comment = false;
      r->at++;
    } else if (pair && r->at[0] == '/' && r->at[1] == '*') {
      comment = true;
      r->at++;
    } else if (strchr(" \t\r\n\f\v", *r->at) == NULL || *r->at == '\0') {
      return UM_OK;
    }
    if (comment && r->at + 1 >= r->stop) break;
  }
  if (r->at < r->stop) {
    r->at = r->stop;
    return fail(r, "*/ behind a comment");
  }
  return UM_OK;
}

static bool is_next(const struct reader *r, char c) { return r->at < r->stop && *r->at == c; }

static enum um_status take(struct reader *r, char c, const char *expected)
{
  UM_TRY(skip(r));
  if (!is_next(r, c)) return fail(r, expected);
  r->at++;
  return UM_OK;
}

/* Letters, digits, '_' and, in the words of sections, '-'. */
static struct um_geometry_part21_text take_word(struct reader *r)
{
  const char *begin = r->at;
  while (r->at < r->stop && (isalnum((unsigned char)*r->at) || *r->at == '_' || *r->at == '-' ||
                             (*r->at == '!' && r->at == begin)))
    r->at++;
  return (struct um_geometry_part21_text){begin, (size_t)(r->at - begin)};
}

static enum um_status take_section(struct reader *r, const char *word)
{
  UM_TRY(skip(r));
  const char *begin = r->at;
  if (!um_geometry_part21_is(take_word(r), word)) {
    r->at = begin;
    return fail(r, word);
  }
  return take(r, ';', "';'");
}

/* Digits behind '#'. */
static enum um_status take_id(struct reader *r, uint64_t *id)
{
  const char *begin = r->at + 1;
  *id = 0;
  if (is_next(r, '#'))
    for (r->at++; r->at < r->stop && isdigit((unsigned char)*r->at) && *id < UINT64_MAX / 16;
         r->at++)
      *id = 10 * *id + (uint64_t)(*r->at - '0');
  if (r->at <= begin || (r->at < r->stop && isdigit((unsigned char)*r->at)))
    return fail(r, "a number of an instance, #12");
  return UM_OK;
}

static enum um_status push(struct reader *r, struct um_geometry_part21_value value)
{
  struct um_geometry_part21 *file = r->file;
  if (file->nvalue == UM_PART21_VALUES) return fail(r, "a smaller file");
  if (file->nvalue == file->value_capacity) {
    size_t capacity = 2 * file->value_capacity + 1024;
    UM_TRY(um_core_reallocate(r->context, capacity, sizeof *file->value, &file->value));
    file->value_capacity = capacity;
  }
  value.end = (uint32_t)file->nvalue + 1;
  file->value[file->nvalue++] = value;
  return UM_OK;
}

static enum um_status push_number(struct reader *r)
{
  char text[NUMBER_LONGEST];
  size_t n = 0;
  const char *begin = r->at;
  struct um_geometry_part21_value value = {.kind = UM_PART21_NUMBER};
  while (r->at < r->stop && n + 1 < sizeof text && *r->at != '\0' &&
         strchr("+-.0123456789eE", *r->at) != NULL)
    text[n++] = *r->at++;
  text[n] = '\0';
  if (!um_core_number_parse(text, &value.number)) {
    r->at = begin;
    return fail(r, "a finite number");
  }
  return push(r, value);
}

/* Up to the quote that is not doubled; a string may run over lines. */
static enum um_status push_quoted(struct reader *r, char quote)
{
  struct um_geometry_part21_value value = {
      .kind = quote == '\'' ? UM_PART21_STRING : UM_PART21_BINARY, .text = {++r->at, 0}};
  for (;; r->at++) {
    if (r->at >= r->stop) return fail(r, "a quote behind a text");
    if (*r->at == '\n') r->line++;
    if (*r->at != quote) continue;
    if (!(r->at + 1 < r->stop && r->at[1] == quote)) break;
    r->at++;
  }
  value.text.length = (size_t)(r->at++ - value.text.at);
  return push(r, value);
}

/* .X. */
static enum um_status push_enum(struct reader *r)
{
  r->at++;
  struct um_geometry_part21_value value = {.kind = UM_PART21_ENUM, .text = take_word(r)};
  if (!is_next(r, '.')) return fail(r, "'.' behind a word, .WORD.");
  r->at++;
  return push(r, value);
}

/* One value but a list; *opens: it is NAME( and a list begins. */
static enum um_status push_value(struct reader *r, bool *opens)
{
  struct um_geometry_part21_value value = {.kind = UM_PART21_UNSET};
  const char c = r->at < r->stop ? *r->at : '\0', then = r->at + 1 < r->stop ? r->at[1] : '\0';
  *opens = false;
  if (c == '\'' || c == '"') return push_quoted(r, c);
  if (c == '.' && (isalpha((unsigned char)then) || then == '_')) return push_enum(r);
  if (isdigit((unsigned char)c) || c == '+' || c == '-' || c == '.') return push_number(r);
  if (c == '#') {
    value.kind = UM_PART21_REFERENCE;
    UM_TRY(take_id(r, &value.id));
  } else if (c == '$' || c == '*') {
    value.kind = c == '$' ? UM_PART21_UNSET : UM_PART21_DERIVED;
    r->at++;
  } else if (isalpha((unsigned char)c) || c == '_' || c == '!') {
    value.kind = UM_PART21_TYPED;
    value.text = take_word(r);
    UM_TRY(take(r, '(', "'(' behind a name"));
    *opens = true;
  } else {
    return fail(r, "a value: a number, 'text', .WORD., #12, $, * or a list in ( )");
  }
  return push(r, value);
}

/* A list in parentheses with all that is in it. */
static enum um_status read_list(struct reader *r)
{
  uint32_t open[UM_PART21_DEEPEST];
  enum { FIRST, NEXT, BEHIND } state = NEXT; /* behind '(', behind ',', behind a value */
  size_t depth = 0;
  do {
    UM_TRY(skip(r));
    bool opens = is_next(r, '(') && state != BEHIND;
    if (is_next(r, ')') && state != NEXT) {
      r->file->value[open[--depth]].end = (uint32_t)r->file->nvalue;
      r->at++;
      state = BEHIND;
    } else if (state == BEHIND) {
      UM_TRY(take(r, ',', "',' or ')'"));
      state = NEXT;
    } else if (opens) {
      r->at++;
      UM_TRY(push(r, (struct um_geometry_part21_value){.kind = UM_PART21_LIST}));
    } else {
      UM_TRY(push_value(r, &opens));
      state = BEHIND;
    }
    if (!opens) continue;
    if (depth == UM_PART21_DEEPEST) return fail(r, "at most 32 lists within lists");
    open[depth++] = (uint32_t)r->file->nvalue - 1;
    state = FIRST;
  } while (depth > 0);
  return UM_OK;
}

/* A list where one has to begin. */
static enum um_status take_list(struct reader *r)
{
  UM_TRY(skip(r));
  return is_next(r, '(') ? read_list(r) : fail(r, "'('");
}

static enum um_status keep_instance(struct reader *r,
                                    const struct um_geometry_part21_instance *instance)
{
  struct um_geometry_part21 *file = r->file;
  if (file->ninstance == UM_PART21_INSTANCES) return fail(r, "a smaller file");
  if (file->ninstance == file->instance_capacity) {
    size_t capacity = 2 * file->instance_capacity + 256;
    UM_TRY(um_core_reallocate(r->context, capacity, sizeof *file->instance, &file->instance));
    file->instance_capacity = capacity;
  }
  file->instance[file->ninstance++] = *instance;
  return UM_OK;
}

static enum um_status read_instance(struct reader *r)
{
  struct um_geometry_part21_instance instance = {.line = r->line,
                                                 .list = (uint32_t)r->file->nvalue};
  UM_TRY(take_id(r, &instance.id));
  UM_TRY(take(r, '=', "'='"));
  UM_TRY(skip(r));
  if (!(r->at < r->stop && isalpha((unsigned char)*r->at)))
    return fail(r, "an instance of one name, #12=NAME(...);");
  instance.name = take_word(r);
  UM_TRY(take_list(r));
  UM_TRY(take(r, ';', "';'"));
  if (r->wanted(instance.name)) return keep_instance(r, &instance);
  r->file->nvalue = instance.list;
  return UM_OK;
}

static enum um_status read_data(struct reader *r)
{
  for (size_t i = 1;; i++) {
    UM_TRY(skip(r));
    if (!is_next(r, '#')) return take_section(r, "ENDSEC");
    UM_TRY(read_instance(r));
    if (i % OFTEN == 0) UM_TRY(um_core_stop_check(r->context, "a STEP file was read"));
  }
}

static enum um_status read_file(struct reader *r)
{
  UM_TRY(take_section(r, "ISO-10303-21"));
  UM_TRY(take_section(r, "HEADER"));
  for (;;) {
    UM_TRY(skip(r));
    const char *begin = r->at;
    if (um_geometry_part21_is(take_word(r), "ENDSEC")) break;
    if (r->at == begin) return fail(r, "ENDSEC");
    UM_TRY(take_list(r));
    UM_TRY(take(r, ';', "';'"));
    r->file->nvalue = 0;
  }
  UM_TRY(take(r, ';', "';'"));
  for (;;) {
    UM_TRY(skip(r));
    const char *begin = r->at;
    if (!um_geometry_part21_is(take_word(r), "DATA")) {
      r->at = begin;
      return take_section(r, "END-ISO-10303-21");
    }
    UM_TRY(skip(r));
    size_t nvalue = r->file->nvalue;
    if (is_next(r, '(')) UM_TRY(read_list(r));
    r->file->nvalue = nvalue;
    UM_TRY(take(r, ';', "';'"));
    UM_TRY(read_data(r));
  }
}

static int by_id(const void *a, const void *b)
{
  uint64_t x = ((const struct um_geometry_part21_instance *)a)->id;
  uint64_t y = ((const struct um_geometry_part21_instance *)b)->id;
  return x < y ? -1 : x > y;
}

enum um_status um_geometry_part21_read(struct um_context *context, const char *path,
                                       const char *bytes, size_t length,
                                       um_geometry_part21_wanted wanted,
                                       struct um_geometry_part21 *out)
{
  struct reader r = {context, path, bytes, bytes + length, 1, out, wanted};
  *out = (struct um_geometry_part21){0};
  UM_TRY(read_file(&r));
  UM_TRY(um_core_sort(context, out->instance, out->ninstance, sizeof *out->instance, by_id));
  for (size_t i = 1; i < out->ninstance; i++)
    if (out->instance[i].id == out->instance[i - 1].id)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s:%d: #%llu is given a second time, after line %d; accepted: one "
                          "instance of each number",
                          path, out->instance[i].line, (unsigned long long)out->instance[i].id,
                          out->instance[i - 1].line);
  return UM_OK;
}

void um_geometry_part21_clear(struct um_context *context, struct um_geometry_part21 *file)
{
  UM_FREE(context, file->value, file->instance);
  *file = (struct um_geometry_part21){0};
}

const struct um_geometry_part21_instance *
um_geometry_part21_find(const struct um_geometry_part21 *file, uint64_t id)
{
  size_t low = 0, high = file->ninstance;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (file->instance[middle].id < id)
      low = middle + 1;
    else
      high = middle;
  }
  return low < file->ninstance && file->instance[low].id == id ? &file->instance[low] : NULL;
}

const struct um_geometry_part21_value *
um_geometry_part21_attribute(const struct um_geometry_part21 *file,
                             const struct um_geometry_part21_instance *instance, int index)
{
  uint32_t at = instance->list + 1, end = file->value[instance->list].end;
  for (; index > 0 && at < end; index--) at = file->value[at].end;
  return at < end ? &file->value[at] : NULL;
}

bool um_geometry_part21_is(struct um_geometry_part21_text text, const char *word)
{
  return strlen(word) == text.length && memcmp(text.at, word, text.length) == 0;
}
