/* YAML documents: binding, marks, overrides, text after overrides, and the message of every
 * refusal. Expected values are read off the sample text by hand. */
#include "base/document/schema.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/base/document/sample_schema.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

/* The sample with up to three overrides. */
static struct sample *parse(struct um_document **document, const char *a, const char *b,
                            const char *c)
{
  const char *set[] = {a, b, c};
  size_t count = a == NULL ? 0 : b == NULL ? 1 : c == NULL ? 2 : 3;
  void *root;
  um_core_message_clear(context);
  if (um_document_parse(context, "s.yaml", sample_text, &sample_schema, set, count, document,
                        &root) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return root;
}

static void refused(const char *text, const char *override, const char *message)
{
  struct um_document *document;
  void *root;
  um_core_message_clear(context);
  assert_int_equal(um_document_parse(context, "s.yaml", text, &sample_schema, &override,
                                     override != NULL ? 1 : 0, &document, &root),
                   UM_ERR_INPUT);
  assert_null(document);
  assert_null(root);
  assert_string_equal(um_core_message(context), message);
}

static void test_values(void **state)
{
  (void)state;
  struct um_document *document;
  struct sample *s = parse(&document, NULL, NULL, NULL);
  assert_string_equal(s->name, "demo");
  assert_null(s->tle);
  assert_true(s->altitude == 800.0);
  assert_true(s->time->start == 5.0);
  assert_true(s->time->step == 2.0);
  assert_int_equal(s->parts.count, 3);
  struct sample_part *part = s->parts.items;
  assert_string_equal(part[0].name, "bus");
  assert_true(part[0].size[2] == 3.0);
  assert_null(part[0].shell);
  assert_true(isnan(part[1].size[0]));
  assert_true(part[1].shell->thickness == 0.01);
  assert_int_equal(s->materials.count, 1);
  struct sample_material *material = s->materials.items;
  assert_string_equal(material[0].name, "mli");
  assert_true(material[0].emittance == 0.5);
  struct sample_effect *effect = s->effects.items;
  assert_true(effect[1].off);
  assert_false(effect[0].off);
  assert_true(effect[1].efficiency == 0.2);
  assert_int_equal(s->levels.count, 3);
  assert_true(((double *)s->levels.items)[2] == -0.3);
  assert_int_equal(s->tags.count, 3);
  assert_string_equal(((const char **)s->tags.items)[1], "b, c");
  assert_int_equal(s->atmosphere->model, SAMPLE_MODEL_CLEAR_SKY);
  assert_true(s->atmosphere->visibility == 23.0);
  assert_int_equal(s->orbits, 4);
  um_document_destroy(&document);
  assert_null(document);
  um_document_destroy(&document);
  um_document_destroy(NULL);
}

static void check_mark(const struct um_mark *at, const char *file, int line, const char *path)
{
  assert_string_equal(at->file, file);
  assert_int_equal(at->line, line);
  assert_string_equal(at->path, path);
}

static void test_marks(void **state)
{
  (void)state;
  struct um_document *document;
  struct sample *s = parse(&document, "parts.bus.shell.thickness_m=0.3", NULL, NULL);
  struct sample_part *part = s->parts.items;
  check_mark(&s->at, "s.yaml", 1, "");
  check_mark(&s->time->at, "s.yaml", 3, "time");
  check_mark(&part[0].at, "s.yaml", 6, "parts.bus");
  check_mark(&part[0].shell->at, "--set", 0, "parts.bus.shell");
  check_mark(&part[1].at, "s.yaml", 7, "parts.solar.array");
  check_mark(&part[1].shell->at, "s.yaml", 8, "parts.solar.array.shell");
  check_mark(&((struct sample_material *)s->materials.items)[0].at, "s.yaml", 12, "materials.mli");
  check_mark(&((struct sample_effect *)s->effects.items)[0].at, "s.yaml", 14, "effects.panel:bus");
  check_mark(&((struct sample_effect *)s->effects.items)[1].at, "s.yaml", 15, "effects.albedo");
  check_mark(um_document_mark_key(&s->at, "altitude_km"), "s.yaml", 2, "altitude_km");
  check_mark(um_document_mark_key(&s->time->at, "step_s"), "s.yaml", 3, "time.step_s");
  check_mark(um_document_mark_key(&part[1].at, "shell"), "s.yaml", 8, "parts.solar.array.shell");
  check_mark(um_document_mark_key(&part[0].shell->at, "thickness_m"), "--set", 0,
             "parts.bus.shell.thickness_m");
  /* no such key, no key, and a single value that stands for a mapping: the mark itself */
  assert_ptr_equal(um_document_mark_key(&s->time->at, "stop"), &s->time->at);
  assert_ptr_equal(um_document_mark_key(&s->at, NULL), &s->at);
  assert_ptr_equal(um_document_mark_key(&s->atmosphere->at, "model"), &s->atmosphere->at);
  um_core_message_clear(context);
  assert_int_equal(um_document_mark_fail(context, &part[1].at, "the mesh is %s", "open"),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), "s.yaml:7: parts.solar.array: the mesh is open");
  um_core_message_clear(context);
  assert_int_equal(um_document_mark_fail(context, &part[0].shell->at, "x"), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), "--set: parts.bus.shell: x");
  void *memory;
  assert_int_equal(um_document_allocate(context, document, 3, 8, &memory), UM_OK);
  for (int i = 0; i < 24; i++) assert_int_equal(((char *)memory)[i], 0);
  um_document_destroy(&document);
}

static void test_overrides(void **state)
{
  (void)state;
  struct um_document *document;
  struct sample *s = parse(&document, "altitude_km=700", "parts.bus.size_m=[4, 5, 6]",
                           "parts.1.shell={thickness_m: 2}");
  struct sample_part *part = s->parts.items;
  assert_true(s->altitude == 700.0);
  assert_true(part[0].size[1] == 5.0);
  assert_true(part[1].shell->thickness == 2.0);
  um_document_destroy(&document);
  /* 'solar' and 'solar.array' both exist: the longest name that fits is taken */
  s = parse(&document, "parts.solar.array.lumped=true", "parts.solar.lumped=false",
            "parts.bus.size_m.1=9");
  part = s->parts.items;
  assert_true(part[1].lumped);
  assert_false(part[2].lumped);
  assert_true(part[0].size[1] == 9.0);
  um_document_destroy(&document);
  s = parse(&document, "effects.panel:bus.efficiency=0.4", "effects.panel.target=solar",
            "effects.glint:solar.off=true");
  struct sample_effect *effect = s->effects.items;
  assert_true(effect[0].efficiency == 0.4);
  assert_string_equal(effect[0].target, "solar");
  assert_false(effect[2].off);
  assert_true(effect[3].off);
  um_document_destroy(&document);
  s = parse(&document, "materials.new.emittance=0.9", "atmosphere={model: none}", "name='a=b'");
  assert_int_equal(s->materials.count, 2);
  assert_string_equal(((struct sample_material *)s->materials.items)[1].name, "new");
  assert_int_equal(s->atmosphere->model, SAMPLE_MODEL_NONE);
  assert_string_equal(s->name, "a=b");
  um_document_destroy(&document);
}

/* Numbers by the same paths; looking makes nothing. */
static void test_numbers(void **state)
{
  (void)state;
  struct um_document *document;
  char *before, *after;
  static const char *const none[] = {"name",
                                     "parts.bus",
                                     "parts.bus.shell.thickness_m",
                                     "no.such",
                                     "parts.nobody.size_m",
                                     "altitude_km.of",
                                     "parts.+.name",
                                     ""};
  static const char *const place[][2] = {
      {"altitude_km", ".altitude_km"},
      {"parts.bus.size_m.1", ".parts.0.size_m.1"},
      {"parts.00.size_m.01", ".parts.0.size_m.1"},
      {"parts.1.shell.thickness_m", ".parts.1.shell.thickness_m"},
      {"materials.mli.no.such", ".materials.mli.no.such"},
      {"altitude_km.of", ".altitude_km.of"},
      {"parts.nobody.size_m", ".parts.nobody.size_m"}};
  parse(&document, "altitude_km=700", "parts.bus.size_m=[4, 5, 6]", NULL);
  assert_int_equal(um_document_text(context, document, &before), UM_OK);
  assert_true(um_document_number(document, "altitude_km") == 700.0);
  assert_true(um_document_number(document, "parts.bus.size_m.1") == 5.0);
  assert_true(um_document_number(document, "parts.1.shell.thickness_m") == 0.01);
  assert_true(um_document_number(document, "materials.mli.emittance") == 0.5);
  for (size_t i = 0; i < sizeof none / sizeof *none; i++)
    if (!isnan(um_document_number(document, none[i]))) fail_msg("'%s' is a number", none[i]);
  for (size_t i = 0; i < sizeof place / sizeof *place; i++) {
    char one[80];
    um_document_place(document, place[i][0], one, sizeof one);
    assert_string_equal(one, place[i][1]);
  }
  assert_string_equal(um_core_message(context), "");
  assert_int_equal(um_document_text(context, document, &after), UM_OK);
  assert_string_equal(before, after);
  um_core_free(context, before);
  um_core_free(context, after);
  um_document_destroy(&document);
}

static void test_override_refusals(void **state)
{
  (void)state;
  static const struct {
    const char *override, *message;
  } cases[] = {
      {"x", "--set: 'x'; accepted: KEY=VALUE"},
      {"=3", "--set: '=3'; accepted: KEY=VALUE"},
      {"name=", "--set: name: empty; accepted: YAML"},
      {"name=[", "--set: name: not YAML: flow sequence without a closing bracket"},
      {"name=*a", "--set: name: an alias ('*name') is not accepted; write the value out"},
      {"name=\xff", "--set: name:1: not text (byte 0xff); accepted: YAML in UTF-8"},
      {"parts.bus.groups.\xff=1", "--set:1: not text (byte 0xff); accepted: YAML in UTF-8"},
      {"parts.bux.lumped=true",
       "--set: parts.bux.lumped: no list element 'bux'; accepted: bus, solar.array, solar"},
      {"parts.bus2.lumped=true",
       "--set: parts.bus2.lumped: no list element 'bus2'; accepted: bus, solar.array, solar"},
      {"parts.3.lumped=true",
       "--set: parts.3.lumped: no list element '3'; accepted: bus, solar.array, solar"},
      {"effects.glint.off=true", "--set: effects.glint.off: 'glint' fits 2 list elements, use the "
                                 "position; accepted: 0, 1, 2, 3"},
      {"name.x=1", "--set: name.x: leads into a single value, which has no parts"},
      {"time..step_s=1",
       "--set: time..step_s: an empty part between dots; accepted: names joined by single dots"},
      {"time.=1", "--set: time.: an empty part behind the last dot; accepted: names joined by "
                  "single dots"},
      {"time.step_s=0",
       "--set: time.step_s: 0 is out of range; accepted: a finite number, more than 0"},
      {"time.stepp_s=1", "--set: time.stepp_s: unknown key 'stepp_s', did you mean 'step_s'?; "
                         "accepted: start, step_s"},
      {"parts.bus.shell=null", "--set: parts.bus.shell: no value is not accepted; accepted: a "
                               "mapping with the keys thickness_m"},
      {"tle=x", "--set: altitude_km: 'tle' and 'altitude_km' exclude each other; accepted: one of "
                "tle, altitude_km"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    /* the exclusion is reported at the later key, which stands in the file */
    const char *message = cases[i].message;
    if (strcmp(cases[i].override, "tle=x") == 0)
      message = "s.yaml:2: altitude_km: 'tle' and 'altitude_km' exclude each other; accepted: one "
                "of tle, altitude_km";
    refused(sample_text, cases[i].override, message);
  }
}

/* Scalars that are nearly right. */
static void test_value_refusals(void **state)
{
  (void)state;
  static const struct {
    const char *override, *message;
  } cases[] = {
      {"levels=[1, nan]", "--set: levels.1: 'nan' is not accepted; accepted: a finite number"},
      {"altitude_km=1,5", "--set: altitude_km: '1,5' is not accepted; accepted: a finite number"},
      {"altitude_km=1.5 m",
       "--set: altitude_km: '1.5 m' is not accepted; accepted: a finite number"},
      {"altitude_km=.inf", "--set: altitude_km: '.inf' is not accepted; accepted: a finite number"},
      {"altitude_km='5'",
       "--set: altitude_km: '5' (in quotes) is not accepted; accepted: a finite number"},
      {"altitude_km=[5]", "--set: altitude_km: a list is not accepted; accepted: a finite number"},
      {"orbits=1.0", "--set: orbits: '1.0' is not accepted; accepted: a whole number, at least 1, "
                     "at most 99"},
      {"orbits=0",
       "--set: orbits: 0 is out of range; accepted: a whole number, at least 1, at most 99"},
      {"orbits=99999999999",
       "--set: orbits: 99999999999 is out of range; accepted: a whole number, at least 1, at most "
       "99"},
      {"parts.bus.lumped=yes",
       "--set: parts.bus.lumped: 'yes' is not accepted; accepted: true or false"},
      {"parts.bus.size_m=[1, 2]", "--set: parts.bus.size_m: a list is not accepted; accepted: a "
                                  "list of 3 finite numbers, at least 0, at most 100"},
      {"parts.bus.size_m.0=-1", "--set: parts.bus.size_m.0: -1 is out of range; accepted: a finite "
                                "number, at least 0, at most 100"},
      {"name={a: 1}", "--set: name: a mapping is not accepted; accepted: a text"},
      {"tags=[[1]]", "--set: tags.0: a list is not accepted; accepted: a text"},
      {"atmosphere=foggy", "--set: atmosphere: 'foggy' is not accepted; accepted: none, clear_sky"},
      {"atmosphere=[]", "--set: atmosphere: a list is not accepted; accepted: a mapping with the "
                        "keys model, visibility_km, or none, clear_sky"},
      {"materials.mli=3",
       "--set: materials.mli: '3' is not accepted; accepted: a mapping with the keys emittance"},
      {"parts=3", "--set: parts: '3' is not accepted; accepted: a list of mappings with the keys "
                  "name, shell, size_m, lumped"},
      {"time.start=noon", "--set: time.start: 'noon' is not accepted; accepted: T0+seconds"},
      {"time={step_s: 1}",
       "--set: time: key 'start' of the time is missing; accepted: a single value"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    refused(sample_text, cases[i].override, cases[i].message);
}

static void test_text_refusals(void **state)
{
  (void)state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"", "s.yaml: empty; accepted: YAML"},
      {"# nothing\n", "s.yaml: empty; accepted: YAML"},
      {"name: a\nname: b\n", "s.yaml:2: duplicate key 'name'; accepted: each key once"},
      {"name: a\ntime: {step_s: 1,\n  step_s: 2}\n",
       "s.yaml:3: duplicate key 'step_s'; accepted: each key once"},
      {"name: &x a\n", "s.yaml:1: an anchor ('&name') is not accepted; write the value out"},
      {"name: !t a\n", "s.yaml:1: a tag ('!name') is not accepted"},
      {"[a]: b\n", "s.yaml:1: a key that is not a word; accepted: key: value"},
      {"name: \"\\0\"\n", "s.yaml:1: a text holds a zero byte"},
      {"name: a\n---\nname: b\n", "s.yaml:3: a second document begins; accepted: one"},
      {"name: [a\n", "s.yaml:2: not YAML: flow sequence without a closing bracket"},
      {"name: a\n\x01", "s.yaml:2: not text (byte 0x01); accepted: YAML in UTF-8"},
      {"name: \xc3(\n", "s.yaml:1: not text (byte 0xc3); accepted: YAML in UTF-8"},
      {"just words\n", "s.yaml:1: 'just words' is not accepted; accepted: a mapping with the keys "
                       "name, tle, altitude_km, time, parts, materials, effects, levels, tags, "
                       "atmosphere, orbits, verbose"},
      {"name: a\naltitude: 3\n",
       "s.yaml:2: altitude: unknown key 'altitude', did you mean 'altitude_km'?; accepted: name, "
       "tle, altitude_km, time, parts, materials, effects, levels, tags, atmosphere, orbits, "
       "verbose"},
      {"altitude_km: 1\ntime: {start: T0+1}\n",
       "s.yaml:1: key 'name' of the scenario is missing; accepted: a text"},
      {"name: a\ntime: {start: T0+1}\n",
       "s.yaml:1: one key is missing; accepted: one of tle, altitude_km"},
      {"name: a\ntle: |\n  1\n  2\naltitude_km: 7\n",
       "s.yaml:5: altitude_km: 'tle' and 'altitude_km' exclude each other; accepted: one of tle, "
       "altitude_km"},
      {"name: a\ntle: b\ntime:\n", "s.yaml:3: time: no value is not accepted; accepted: a mapping "
                                   "with the keys start, step_s"},
      {"name: a\ntle: b\ntime: {start: T0+1}\nparts:\n- name: x\n  shell: {}\n",
       "s.yaml:6: parts.x.shell: key 'thickness_m' of the shell is missing; accepted: a finite "
       "number"},
      {"name: a\ntle: b\ntime: {start: T0+1}\nparts:\n- name: x\n- size_m: [1, 2, 3]\n",
       "s.yaml:6: parts.1: key 'name' of the part is missing; accepted: a text"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    refused(cases[i].text, NULL, cases[i].message);
  char deep[400] = "name: ";
  for (int i = 0; i < 60; i++) strcat(deep, "[");
  for (int i = 0; i < 60; i++) strcat(deep, "]");
  refused(deep, NULL, "s.yaml:1: nested too deep");
}

static void test_files(void **state)
{
  (void)state;
  struct um_document *document;
  void *root;
  um_core_message_clear(context);
  assert_int_equal(
      um_document_read(context, "no-such.yaml", &sample_schema, NULL, 0, &document, &root),
      UM_ERR_IO);
  assert_string_equal(um_core_message(context), "no-such.yaml: No such file or directory");
  um_core_message_clear(context);
  assert_int_equal(um_document_read(context, ".", &sample_schema, NULL, 0, &document, &root),
                   UM_ERR_IO);
  assert_string_equal(um_core_message(context), ".: is not a plain file but a folder");
}

/* A block of text stands on the line of its key. */
static void test_mark_of_key(void **state)
{
  (void)state;
  static const char text[] = "name: a\ntle: |\n  1\n  2\ntime:\n  step_s: 2\n  start: T0+1\n";
  struct um_document *document;
  void *root;
  um_core_message_clear(context);
  if (um_document_parse(context, "w.yaml", text, &sample_schema, NULL, 0, &document, &root) !=
      UM_OK)
    fail_msg("%s", um_core_message(context));
  struct sample *s = root;
  check_mark(um_document_mark_key(&s->at, "tle"), "w.yaml", 2, "tle");
  check_mark(um_document_mark_key(&s->time->at, "start"), "w.yaml", 7, "time.start");
  um_document_destroy(&document);
}

/* A byte order mark and Windows line ends change nothing. */
static void test_other_editors(void **state)
{
  (void)state;
  static const char text[] =
      "\xef\xbb\xbfname: a\r\ntle: |\r\n  1\r\n  2\r\ntime:\r\n  start: T0+1\r\norbits: 7\r\n";
  struct um_document *document;
  void *root;
  um_core_message_clear(context);
  if (um_document_parse(context, "w.yaml", text, &sample_schema, NULL, 0, &document, &root) !=
      UM_OK)
    fail_msg("%s", um_core_message(context));
  struct sample *s = root;
  assert_string_equal(s->tle, "1\n2\n");
  assert_int_equal(s->orbits, 7);
  assert_int_equal(s->time->at.line, 5);
  um_document_destroy(&document);
}

static void check_text(const char *override, const char *old, const char *new)
{
  struct um_document *document;
  char *text, expected[2048];
  (void)parse(&document, override, NULL, NULL);
  assert_int_equal(um_document_text(context, document, &text), UM_OK);
  const char *at = strstr(sample_text, old);
  assert_non_null(at);
  snprintf(expected, sizeof expected, "%.*s%s%s", (int)(at - sample_text), sample_text, new,
           at + strlen(old));
  assert_string_equal(text, expected);
  um_core_free(context, text);
  um_document_destroy(&document);
}

/* The text after overrides: only what was set differs, comments and layout stay. */
static void test_text_edited(void **state)
{
  (void)state;
  struct um_document *document;
  char *text;
  (void)parse(&document, NULL, NULL, NULL);
  assert_int_equal(um_document_text(context, document, &text), UM_OK);
  assert_string_equal(text, sample_text);
  um_core_free(context, text);
  um_document_destroy(&document);
  check_text("altitude_km=7e2", "altitude_km: 800", "altitude_km: 7e2");
  check_text("name='x: #'", "name: demo #", "name: \"x: #\" #");
  check_text("parts.bus.size_m.1=9", "[1, 2, 3]", "[1, 9, 3]");
  check_text("parts.bus.lumped=true", "{name: bus, size_m", "{name: bus, lumped: true, size_m");
  check_text("parts.solar.lumped=true", "  - name: solar\nmat",
             "  - lumped: true\n    name: solar\nmat");
  check_text("orbits=9", "verbose", "orbits: 9\nverbose");
  check_text("atmosphere={model: none}", "atmosphere: clear_sky", "atmosphere: {model: none}");
}

/* A collection was replaced: the text is written anew and still means the same. */
static void test_text_rewritten(void **state)
{
  (void)state;
  struct um_document *document, *again;
  char *text;
  void *root;
  (void)parse(&document, "parts.solar.array={name: w, size_m: [1, 1, 1]}",
              "tags=[\"a\\tb\", '1', 'x\"y']", NULL);
  assert_int_equal(um_document_text(context, document, &text), UM_OK);
  um_document_destroy(&document);
  if (um_document_parse(context, "t.yaml", text, &sample_schema, NULL, 0, &again, &root) != UM_OK)
    fail_msg("%s in\n%s", um_core_message(context), text);
  struct sample *s = root;
  assert_int_equal(s->parts.count, 3);
  assert_string_equal(((struct sample_part *)s->parts.items)[1].name, "w");
  assert_true(((struct sample_part *)s->parts.items)[0].size[2] == 3.0);
  assert_string_equal(((const char **)s->tags.items)[0], "a\tb");
  assert_string_equal(((const char **)s->tags.items)[1], "1");
  assert_string_equal(((const char **)s->tags.items)[2], "x\"y");
  assert_int_equal(s->effects.count, 4);
  assert_true(((double *)s->levels.items)[2] == -0.3);
  um_core_free(context, text);
  um_document_destroy(&again);
}

/* A two-line element set survives both ways of writing. */
static void test_text_of_blocks(void **state)
{
  (void)state;
  static const char lines[] = "1 27386U 02009A\n2 27386  98.2\n";
  static const char source[] =
      "name: a\ntle: |\n  1 27386U 02009A\n  2 27386  98.2\ntime: {start: T0+1}\n";
  static const char *const sets[] = {"orbits=5", "time={start: T0+2, step_s: 3}", "time.step_s=3"};
  for (size_t i = 0; i < 3; i++) {
    struct um_document *document, *again;
    void *root;
    char *text;
    assert_int_equal(
        um_document_parse(context, "s.yaml", source, &sample_schema, &sets[i], 1, &document, &root),
        UM_OK);
    assert_int_equal(um_document_text(context, document, &text), UM_OK);
    assert_int_equal(
        um_document_parse(context, "t.yaml", text, &sample_schema, NULL, 0, &again, &root), UM_OK);
    assert_string_equal(((struct sample *)root)->tle, lines);
    um_core_free(context, text);
    um_document_destroy(&document);
    um_document_destroy(&again);
  }
}

/* Paths to sections: with the name of an element or without, and every path that is listed. */
static void test_paths(void **state)
{
  (void)state;
  static const struct {
    const char *path, *key; /* NULL: refused with the message */
    const char *message;
  } cases[] = {
      {"time", "time", NULL},
      {"parts.shell.thickness_m", "thickness_m", NULL},
      {"parts.bus.shell", "shell", NULL},
      {"parts[].shell", "shell", NULL},
      {"parts[2].shell", "shell", NULL},
      {"materials.mli.emittance", "emittance", NULL},
      {"materials.emittance", "emittance", NULL},
      {"parts.shel.shell", "shell", NULL}, /* a part may be called so */
      {"tim", NULL, "tim: scenario has no key 'tim'; did you mean 'time'?; accepted: "},
      {"time.stepp_s", NULL, "time.stepp_s: time has no key 'stepp_s'; did you mean 'step_s'?; "},
      {"materials.emitance", NULL, "no key 'emitance'; did you mean 'emittance'?; accepted: "},
      {"parts.bus.rear.shell", NULL, "part has no key 'rear'; accepted: "},
      {"name.x", NULL, "name.x: 'name' holds no keys"},
      {"", NULL, "scenario has no key ''"}};
  const struct um_schema_object *object;
  const struct um_schema_field *field;
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    um_core_message_clear(context);
    enum um_status status =
        um_document_schema_find_path(context, &sample_schema, cases[i].path, &object, &field);
    if (cases[i].key != NULL
            ? status != UM_OK || strcmp(field->key, cases[i].key) != 0
            : status != UM_ERR_INPUT || strstr(um_core_message(context), cases[i].message) == NULL)
      fail_msg("'%s': %s", cases[i].path, um_core_message(context));
  }
  char path[256];
  FILE *file = tmpfile();
  size_t count = 0;
  assert_non_null(file);
  um_document_schema_write_paths(file, &sample_schema);
  rewind(file);
  for (; fgets(path, sizeof path, file) != NULL; count++) {
    path[strcspn(path, "\n")] = '\0';
    if (um_document_schema_find_path(context, &sample_schema, path, &object, &field) != UM_OK)
      fail_msg("%s", um_core_message(context));
    assert_string_equal(field->key, strrchr(path, '.') != NULL ? strrchr(path, '.') + 1 : path);
  }
  fclose(file);
  assert_true(count > 12);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_paths),          cmocka_unit_test(test_values),
      cmocka_unit_test(test_marks),          cmocka_unit_test(test_overrides),
      cmocka_unit_test(test_numbers),        cmocka_unit_test(test_override_refusals),
      cmocka_unit_test(test_value_refusals), cmocka_unit_test(test_text_refusals),
      cmocka_unit_test(test_files),          cmocka_unit_test(test_other_editors),
      cmocka_unit_test(test_text_edited),    cmocka_unit_test(test_text_rewritten),
      cmocka_unit_test(test_text_of_blocks), cmocka_unit_test(test_mark_of_key),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
