/* A page of the documentation as it stands: PAGE, by its path in the repository, is read, its
 * commands are run, and what it says that they print must come.
 *
 *   ```console             "$ command" lines are run, one after the other, in what looks like a
 * clone: folders of the repository, of which scenarios and examples are copies. Every other line
 * must be in what the command printed, in that order.
 *   ```yaml title="file"   is written to that file.
 *   <!-- status 4 -->      commands of the next block end with that exit status, in place of 0.
 *   <!-- picture A B -->   A is a picture that the commands made, B the same beside the page. With
 *                          UMBRA_WRITE_DOCS set it is made anew of A.
 *
 * Words are compared as they are, numbers to two units of the last digit that the page prints: what
 * another compiler may move in a fit of four digits. A page may leave lines out, never a part of
 * one. A figure that is no longer true fails here and is to be corrected on the page. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define LINE   4096
#define OUTPUT 262144

static const char *page_name;
static char folder[UM_TEST_PATH];
static char where[LINE];    /* below the folder: what `cd` led to */
static char output[OUTPUT]; /* of the last command */
static const char *at;      /* what of it has not been matched yet */
static int wanted;          /* exit status of commands of this block */

/* Run a command of the page, with the program built here as `umbra`. */
static void run(const char *command, int number)
{
  static char line[3 * LINE];
  snprintf(line, sizeof line, "cd '%s/%s' && PATH='%s':\"$PATH\" && { %s\n} 2>&1", folder, where,
           UMBRA_PROGRAM_FOLDER, command);
  FILE *pipe = popen(line, "r");
  assert_non_null(pipe);
  size_t n = fread(output, 1, sizeof output - 1, pipe);
  output[n] = '\0';
  at = output;
  assert_true(n < sizeof output - 1);
  int status = pclose(pipe);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != wanted)
    fail_msg("%s:%d: %s\nexit status %d, expected %d\n%s", page_name, number, command,
             WIFEXITED(status) ? WEXITSTATUS(status) : -1, wanted, output);
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
  static char a[LINE], b[LINE];
  snprintf(a, sizeof a, "%.*s", (int)npage, page);
  snprintf(b, sizeof b, "%.*s", (int)nsaid, said);
  char *a_end, *b_end;
  double x = strtod(a, &a_end), y = strtod(b, &b_end);
  /* "influence" begins with a number, too */
  if (a_end == a || b_end == b || !isfinite(x) || !isfinite(y)) return strcmp(a, b) == 0;
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
  fail_msg("%s:%d: not in what the command printed:\n%s---\n%s", page_name, number, page, output);
}

/* The file of a block ```KIND title="NAME", open for writing, or NULL: another block. */
static FILE *titled(const char *fence)
{
  static char path[2 * LINE], command[3 * LINE];
  const char *name = strstr(fence, "title=\"");
  if (name == NULL) return NULL;
  name += strlen("title=\"");
  int length = (int)strcspn(name, "\"\n");
  assert_true(name[length] == '"' && name[0] != '/' && strstr(fence, "..") == NULL);
  snprintf(path, sizeof path, "%s/%s/%.*s", folder, where, length, name);
  snprintf(command, sizeof command, "mkdir -p \"$(dirname '%s')\"", path);
  assert_int_equal(system(command), 0);
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  return file;
}

struct block {
  bool console, other;
  FILE *file;
  char command[2 * LINE];
  bool goes_on; /* the next line belongs to the command */
  int commands, lines;
};

static void console_line(struct block *block, char *line, int number)
{
  if (!block->goes_on && strncmp(line, "$ ", 2) != 0) {
    if (strspn(line, " \n") == strlen(line)) return;
    assert_true(block->commands > 0);
    expect_line(line, number);
    block->lines++;
    return;
  }
  size_t n = strlen(line) - 1;
  line[n] = '\0';
  const bool more = n > 0 && line[n - 1] == '\\';
  if (more) line[n - 1] = '\0';
  size_t used = block->goes_on ? strlen(block->command) : 0;
  int length = snprintf(block->command + used, sizeof block->command - used, "%s",
                        block->goes_on ? line : line + 2);
  assert_true(length >= 0 && used + (size_t)length < sizeof block->command);
  block->goes_on = more;
  if (more) return;
  block->commands++;
  if (strncmp(block->command, "cd ", 3) == 0)
    snprintf(where, sizeof where, "%.*s", LINE - 1, block->command + 3);
  else
    run(block->command, number);
}

static void fence(struct block *block, const char *line)
{
  if (block->console || block->other || block->file != NULL) {
    if (block->console) wanted = 0;
    if (block->file != NULL) assert_int_equal(fclose(block->file), 0);
    block->console = block->other = false;
    block->file = NULL;
    return;
  }
  block->console = strcmp(line, "```console\n") == 0;
  block->file = block->console ? NULL : titled(line);
  block->other = !block->console && block->file == NULL;
}

/* A picture of the page: its commands made it, and it is there. */
static void picture(const char *line, int number)
{
  static char command[4 * LINE];
  char from[256], to[256];
  if (sscanf(line, "<!-- picture %255s %255s -->", from, to) != 2) return;
  const char *slash = strrchr(page_name, '/');
  int length = slash == NULL ? 0 : (int)(slash - page_name + 1);
  int n = snprintf(command, sizeof command, "test -s '%s/%s/%s' && ", folder, where, from);
  if (getenv("UMBRA_WRITE_DOCS") != NULL)
    n += snprintf(command + n, sizeof command - (size_t)n, "cp '%s/%s/%s' ", folder, where, from);
  else
    n += snprintf(command + n, sizeof command - (size_t)n, "test -s ");
  snprintf(command + n, sizeof command - (size_t)n, "'%s/%.*s%s'", UMBRA_SOURCE_DIR, length,
           page_name, to);
  if (system(command) != 0)
    fail_msg("%s:%d: no picture %s, or none beside the page", page_name, number, from);
}

static void page_is_true(void **state)
{
  (void)state;
  static char path[LINE], line[LINE];
  static struct block block;
  int number = 0;
  snprintf(path, sizeof path, UMBRA_SOURCE_DIR "/%s", page_name);
  FILE *page = fopen(path, "rb");
  assert_non_null(page);
  while (fgets(line, sizeof line, page) != NULL) {
    number++;
    assert_non_null(strchr(line, '\n'));
    if (strncmp(line, "```", 3) == 0)
      fence(&block, line);
    else if (block.file != NULL)
      assert_true(fputs(line, block.file) >= 0);
    else if (block.console)
      console_line(&block, line, number);
    else if (sscanf(line, "<!-- status %d -->", &wanted) != 1)
      picture(line, number);
  }
  fclose(page);
  assert_false(block.console || block.other || block.goes_on);
  print_message("%s: %d commands, %d lines of output\n", page_name, block.commands, block.lines);
  assert_true(block.commands > 0 && block.lines > 0);
}

/* What looks like a clone. */
static int set_up(void **state)
{
  (void)state;
  static char command[4 * LINE];
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(
      command, sizeof command,
      "cp -R '%s/scenarios' '%s/examples' '%s/' && for entry in '%s'/*; do case \"$entry\" in "
      "*/scenarios|*/examples|*/build*|*/out) ;; *) ln -s \"$entry\" '%s/' || exit 1 ;; esac; done",
      UMBRA_SOURCE_DIR, UMBRA_SOURCE_DIR, folder, UMBRA_SOURCE_DIR, folder);
  return system(command);
}

static int tear_down(void **state)
{
  (void)state;
  static char command[UM_TEST_PATH + 64];
  snprintf(command, sizeof command, "find '%s' -mindepth 1 -delete", folder);
  return system(command) == 0 ? um_test_folder_remove(folder) : -1;
}

int main(int argc, char **argv)
{
  if (argc != 2) {
    fprintf(stderr, "usage: test_page PAGE, from the top of the repository\n");
    return 2;
  }
  page_name = argv[1];
  const struct CMUnitTest tests[] = {cmocka_unit_test(page_is_true)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
