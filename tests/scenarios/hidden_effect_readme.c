/* scenarios/hidden-effect/README.md as it stands: its console blocks are run, and every line of
 * output printed there must come, in that order.
 *
 * Words are compared as they are, numbers to two units of the last digit that the page prints: what
 * another compiler may move in a fit of four digits. The page leaves lines out, never in between a
 * line. A figure that is no longer true fails here and is to be corrected on the page. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define HOUSE  UMBRA_SOURCE_DIR "/scenarios/hidden-effect"
#define LINE   512
#define OUTPUT 65536

static char folder[UM_TEST_PATH];
static char output[OUTPUT]; /* of the last command */
static const char *at;      /* what of it has not been matched yet */

/* Run a command of the page below the folder, with the program built here as `umbra`. */
static void run(const char *where, const char *command)
{
  char line[4 * LINE + 3 * UM_TEST_PATH];
  snprintf(line, sizeof line, "cd '%s/%s' && PATH='%s':\"$PATH\" && { %s ; } 2>&1", folder, where,
           UMBRA_PROGRAM_FOLDER, command);
  FILE *pipe = popen(line, "r");
  assert_non_null(pipe);
  size_t n = fread(output, 1, sizeof output - 1, pipe);
  output[n] = '\0';
  at = output;
  assert_true(n < sizeof output - 1);
  int status = pclose(pipe);
  if (!(WIFEXITED(status) && WEXITSTATUS(status) == 0)) fail_msg("%s\n%s", command, output);
}

/* Unit of the last digit of a printed number, as of 1.23e-4: 1e-6. */
static double last_digit(const char *text, const char *end)
{
  const char *exponent = memchr(text, 'e', (size_t)(end - text));
  const char *stop = exponent == NULL ? end : exponent;
  const char *point = memchr(text, '.', (size_t)(stop - text));
  double unit = point == NULL ? 1.0 : pow(10.0, -(double)(stop - point - 1));
  return exponent == NULL ? unit : unit * pow(10.0, strtod(exponent + 1, NULL));
}

/* Do two words agree, numbers within two units of the last digit of `page`? */
static bool same_word(const char *page, size_t npage, const char *said, size_t nsaid)
{
  char a[LINE], b[LINE];
  snprintf(a, sizeof a, "%.*s", (int)npage, page);
  snprintf(b, sizeof b, "%.*s", (int)nsaid, said);
  char *a_end, *b_end;
  double x = strtod(a, &a_end), y = strtod(b, &b_end);
  if (a_end == a || b_end == b) return strcmp(a, b) == 0;
  return strcmp(a_end, b_end) == 0 && fabs(x - y) <= 2.0000001 * last_digit(a, a_end);
}

static bool same_line(const char *page, const char *said, size_t length)
{
  const char *end = said + length;
  for (;;) {
    page += strspn(page, " ");
    while (said < end && *said == ' ') said++;
    size_t npage = strcspn(page, " \n"), nsaid = 0;
    while (said + nsaid < end && said[nsaid] != ' ') nsaid++;
    if (npage == 0 || nsaid == 0) return npage == nsaid;
    if (!same_word(page, npage, said, nsaid)) return false;
    page += npage;
    said += nsaid;
  }
}

/* A line of the page must stand in what is left of the output. */
static void expect_line(const char *page, int number)
{
  for (const char *line = at; line != NULL && *line != '\0';) {
    size_t length = strcspn(line, "\n");
    const char *next = line[length] == '\n' ? line + length + 1 : line + length;
    if (same_line(page, line, length)) {
      at = next;
      return;
    }
    line = next;
  }
  fail_msg("README.md:%d: not in what the command printed:\n%s---\n%s", number, page, output);
}

static void page_is_true(void **state)
{
  (void)state;
  char line[LINE], command[2 * LINE] = "", where[2 * LINE] = "";
  bool inside = false, goes_on = false;
  int commands = 0, lines = 0, number = 0;
  FILE *page = fopen(HOUSE "/README.md", "rb");
  assert_non_null(page);
  while (fgets(line, sizeof line, page) != NULL) {
    number++;
    assert_non_null(strchr(line, '\n'));
    if (strncmp(line, "```", 3) == 0) {
      inside = !inside && strcmp(line, "```console\n") == 0;
    } else if (inside && (goes_on || strncmp(line, "$ ", 2) == 0)) {
      size_t n = strlen(line) - 1;
      line[n] = '\0';
      const bool more = n > 0 && line[n - 1] == '\\';
      if (more) line[n - 1] = '\0';
      const char *text = goes_on ? line : line + 2;
      size_t used = goes_on ? strlen(command) : 0;
      snprintf(command + used, sizeof command - used, "%s", text);
      goes_on = more;
      if (more) continue;
      commands++;
      if (strncmp(command, "cd ", 3) == 0)
        snprintf(where, sizeof where, "%s", command + 3);
      else
        run(where, command);
    } else if (inside && strspn(line, " \n") < strlen(line)) {
      expect_line(line, number);
      lines++;
    }
  }
  fclose(page);
  print_message("%d commands, %d lines of output\n", commands, lines);
  assert_true(commands == 5 && lines >= 20);
}

static int set_up(void **state)
{
  (void)state;
  char command[3 * UM_TEST_PATH + 1024];
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(command, sizeof command, "mkdir '%s/scenarios' && cp -R '%s' '%s/scenarios/'", folder,
           HOUSE, folder);
  return system(command);
}

static int tear_down(void **state)
{
  (void)state;
  char command[UM_TEST_PATH + 32];
  snprintf(command, sizeof command, "rm -rf '%s/scenarios'", folder);
  return system(command) == 0 ? um_test_folder_remove(folder) : -1;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(page_is_true)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
