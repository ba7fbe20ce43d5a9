/* Lines for the target `model`, made from the scenario's schema and the list of effects: a key that
 * is added to either is tried without a word here. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/sampling.h"
#include "effects/effects.h"
#include "model/scenario/scenario_schema.h"
#include "tests/fuzz/fuzz.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed);

#define LINE 800 /* [bytes] longest line */

struct line {
  char text[LINE];
  size_t length;
  uint64_t key, drawn;
};

static uint64_t draw(struct line *l, uint64_t below)
{
  return (um_core_hash(l->key, l->drawn++) >> 11) % below;
}

static void put(struct line *l, const char *text)
{
  size_t n = strlen(text);
  if (l->length + n >= LINE) return;
  memcpy(l->text + l->length, text, n + 1);
  l->length += n;
}

static void put_number(struct line *l, double value)
{
  char text[40];
  snprintf(text, sizeof text, "%.7g", value);
  put(l, text);
}

/* Mostly within the bounds, often on them. */
static void put_value(struct line *l, double minimum, double maximum, double default_value)
{
  static const double special[] = {0, 1, -1, 0.5, 2, 10, 90, 300, 1e-9, 1e-30, 1e6, 1e30, 5e-324};
  bool bounded = minimum < maximum;
  double u = (double)draw(l, 1001) / 1000.0;
  switch (draw(l, 8)) {
  case 0:
    put_number(l, bounded ? minimum : -u);
    break;
  case 1:
    put_number(l, bounded ? maximum : u);
    break;
  case 2:
    put_number(l, bounded ? minimum + u * (maximum - minimum) : u * 100.0);
    break;
  case 3:
    put_number(l, special[draw(l, sizeof special / sizeof special[0])]);
    break;
  case 4:
    put_number(l, isfinite(default_value) ? default_value : u);
    break;
  default: /* by its order of magnitude */
    put_number(l, fmax(bounded ? minimum : 0.0, 0.0) +
                      pow(10.0, 8.0 * u - 6.0) * (bounded ? fmin(maximum, 100.0) : 10.0));
  }
}

static void put_text(struct line *l)
{
  static const char *const texts[] = {
      "grey", "black",  "coated",       "bus", "wing", "plate", "+x", "side",
      "vis",  "bus.+x", "bus.interior", "x",   "lwir", "top",   "~",  "wing.front"};
  put(l, texts[draw(l, sizeof texts / sizeof texts[0])]);
}

static void put_time(struct line *l)
{
  char text[40];
  snprintf(text, sizeof text, "2016-03-20T04:%02d:%02dZ", (int)draw(l, 60), (int)draw(l, 60));
  put(l, text);
}

static void put_object(struct line *l, const struct um_schema_object *object, int depth);

/* The name of an element of a list or dictionary. */
static void put_name(struct line *l)
{
  static const char *const names[] = {"bus",   "wing", "vis", "lwir", "\"+x\"",
                                      "plate", "side", "0",   "1"};
  put(l, names[draw(l, sizeof names / sizeof names[0])]);
}

/* The value of a field, written in one line. */
static void put_field(struct line *l, const struct um_schema_field *f, int depth)
{
  size_t n = f->type == UM_SCHEMA_VECTOR ? f->length : 3;
  switch (f->type) {
  case UM_SCHEMA_NUMBER:
    put_value(l, f->minimum, f->maximum, f->default_value);
    break;
  case UM_SCHEMA_INTEGER:
    put_number(l, (double)draw(l, draw(l, 8) == 0 ? 100000 : 8));
    break;
  case UM_SCHEMA_BOOL:
    put(l, draw(l, 2) == 0 ? "true" : "false");
    break;
  case UM_SCHEMA_CHOICE: {
    size_t count = 0;
    while (f->choices[count] != NULL) count++;
    put(l, f->choices[draw(l, count)]);
    break;
  }
  case UM_SCHEMA_VECTOR:
  case UM_SCHEMA_NUMBERS:
    put(l, "[");
    for (size_t i = 0; i < n; i++) {
      if (i > 0) put(l, ", ");
      put_value(l, f->minimum, f->maximum, 0.0);
    }
    put(l, "]");
    break;
  case UM_SCHEMA_MAP:
    put_object(l, f->object, depth + 1);
    break;
  case UM_SCHEMA_LIST:
    put(l, "[");
    put_object(l, f->object, depth + 1);
    put(l, "]");
    break;
  case UM_SCHEMA_DICT:
    put(l, "{");
    put_name(l);
    put(l, ": ");
    put_object(l, f->object, depth + 1);
    put(l, "}");
    break;
  case UM_SCHEMA_PARSED:
    put_time(l);
    break;
  case UM_SCHEMA_TEXTS:
    put(l, "[");
    put_text(l);
    put(l, "]");
    break;
  case UM_SCHEMA_TEXT:
  case UM_SCHEMA_REST:
    put_text(l);
    break;
  }
}

/* What is required, one of each set of alternatives, some of the rest. */
static void put_object(struct line *l, const struct um_schema_object *object, int depth)
{
  size_t candidates = 0, chosen = 0;
  bool first = true;
  for (size_t i = 0; i < object->nfield; i++) candidates += object->fields[i].alternative == 1;
  if (candidates > 0) chosen = draw(l, candidates);
  put(l, "{");
  for (size_t i = 0, k = 0; i < object->nfield; i++) {
    const struct um_schema_field *f = &object->fields[i];
    bool taken = f->alternative == 1 ? k++ == chosen : f->required || draw(l, 8) == 0;
    if (!taken || f->type == UM_SCHEMA_REST || (depth > 3 && !f->required)) continue;
    if (!first) put(l, ", ");
    first = false;
    put(l, f->key);
    put(l, ": ");
    if (strcmp(f->key, "outside") == 0 || strcmp(f->key, "front") == 0)
      put(l, "grey");
    else
      put_field(l, f, depth);
  }
  put(l, "}");
}

static void put_effect(struct line *l)
{
  const struct um_effect *effect = um_effects_at(draw(l, um_effects_count()));
  put(l, "effects.+={effect: ");
  put(l, effect->name);
  if (draw(l, 3) > 0) {
    put(l, ", target: ");
    put_text(l);
  }
  for (size_t i = 0; i < effect->nparameter; i++) {
    const struct um_effect_parameter *p = &effect->parameters[i];
    if (draw(l, 3) == 0) continue;
    put(l, ", ");
    put(l, p->name);
    put(l, ": ");
    put_value(l, p->minimum, p->maximum, p->default_value);
  }
  put(l, "}");
}

/* A path into the schema with a value behind it. */
static void put_override(struct line *l)
{
  const struct um_schema_object *object = &um_model_scenario_schema;
  if (draw(l, 5) == 0) {
    put_effect(l);
    return;
  }
  for (int depth = 0;; depth++) {
    const struct um_schema_field *f = &object->fields[draw(l, object->nfield)];
    bool inside = f->object != NULL && f->object->nfield > 0 && draw(l, 5) > 0;
    put(l, f->key);
    if (inside && (f->type == UM_SCHEMA_LIST || f->type == UM_SCHEMA_DICT)) {
      put(l, ".");
      if (f->type == UM_SCHEMA_LIST && draw(l, 3) == 0) {
        put(l, "+=");
        put_object(l, f->object, depth);
        return;
      }
      put_name(l);
    }
    if (!inside) {
      put(l, "=");
      put_field(l, f, depth);
      return;
    }
    put(l, ".");
    object = f->object;
  }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed)
{
  struct line l = {.key = seed};
  if (draw(&l, 4) == 0) return LLVMFuzzerMutate(data, size, max_size);
  size_t nline = 0, begin = 0, end;
  for (size_t i = 0; i < size; i++) nline += data[i] == '\n';
  size_t at = draw(&l, nline + 1), what = nline > 8 ? 0 : draw(&l, 4);
  for (size_t i = 0, k = 0; i < size && k < at; i++)
    if (data[i] == '\n' && ++k == at) begin = i + 1;
  for (end = begin; end < size && data[end] != '\n';) end++;
  if (end < size) end++;
  if (what > 1) end = begin; /* 0: drop a line, 1: replace it, 2 and 3: insert one */
  if (what > 0) {
    put_override(&l);
    put(&l, "\n");
  }
  size_t rest = size - end;
  if (begin + l.length + rest > max_size) return LLVMFuzzerMutate(data, size, max_size);
  memmove(data + begin + l.length, data + end, rest);
  memcpy(data + begin, l.text, l.length);
  return begin + l.length + rest;
}
