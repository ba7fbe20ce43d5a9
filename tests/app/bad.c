/* See bad.h. Each case: exit 1, nothing on standard output, one line on standard error that names
 * what is expected, and a folder that is as it was before. */
#include "tests/app/bad.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "tests/app/command.h"

#define SCENARIO "box.yaml"

static char *edited(char *text, const struct bad_edit *edit)
{
  if (edit->find != NULL) text = command_edit(text, edit->find, edit->replace);
  if (edit->keep > 0) {
    assert_true(edit->keep < strlen(text));
    text[edit->keep] = '\0';
  }
  return text;
}

static void put(const char *path, enum bad_kind kind, const char *text)
{
  unsigned char bytes[512];
  for (size_t i = 0; i < sizeof bytes; i++) bytes[i] = (unsigned char)(i * 37);
  if (kind == BAD_TEXT)
    command_write(path, text);
  else if (kind == BAD_FOLDER)
    assert_int_equal(mkdir(path, 0777), 0);
  else if (kind == BAD_EMPTY)
    command_write(path, "");
  else if (kind == BAD_BINARY)
    command_write_bytes(path, bytes, sizeof bytes);
}

static void check_message(const struct bad_case *c, const char *scenario, const char *err)
{
  char place[256];
  if (command_count_lines(err) != 1 || strncmp(err, "umbra: ", 7) != 0)
    fail_msg("not one line:\n%s", err);
  if (c->line_of != NULL) {
    snprintf(place, sizeof place,
             "umbra: " SCENARIO ":%d: ", command_line_of(scenario, c->line_of));
    if (strncmp(err, place, strlen(place)) != 0)
      fail_msg("does not begin with '%s':\n%s", place, err);
  }
  for (size_t i = 0; i < sizeof c->says / sizeof c->says[0] && c->says[i] != NULL; i++)
    if (strstr(err, c->says[i]) == NULL) fail_msg("does not say '%s':\n%s", c->says[i], err);
}

static void check_case(void **state)
{
  const struct bad_case *c = *state;
  char *scenario = edited(command_data(SCENARIO), &c->scenario);
  put(SCENARIO, c->file == NULL ? c->kind : BAD_TEXT, scenario);
  if (c->file != NULL) {
    char *text = strdup(c->base == NULL ? "" : c->base);
    assert_non_null(text);
    text = edited(text, &c->edit);
    put(c->file, c->kind, text);
    free(text);
  }
  char *before = command_snapshot(".");
  const char *arguments[12] = {"run", SCENARIO, "--out", "out/deep", "--no-plots"};
  for (size_t i = 0; i < 3 && c->option[i] != NULL; i++) arguments[5 + i] = c->option[i];
  struct command command = command_run_list(arguments);
  char *after = command_snapshot(".");
  if (command.code != 1)
    fail_msg("exit %d, expected 1; it said:\n%s%s", command.code, command.out, command.err);
  assert_string_equal(command.out, "");
  check_message(c, scenario, command.err);
  assert_string_equal(after, before);
  command_release(&command);
  free(before);
  free(after);
  free(scenario);
}

static int enter(void **state)
{
  void *unused = NULL;
  (void)state;
  return command_enter(&unused);
}

int bad_run(const char *group, const struct bad_case *cases, size_t n)
{
  struct CMUnitTest *tests = calloc(n, sizeof *tests);
  if (tests == NULL) return 1;
  for (size_t i = 0; i < n; i++)
    tests[i] = (struct CMUnitTest){cases[i].name, check_case, enter, command_leave,
                                   (void *)(size_t)&cases[i]};
  int failed = _cmocka_run_group_tests(group, tests, n, NULL, NULL);
  free(tests);
  return failed;
}
