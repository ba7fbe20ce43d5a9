/* The record of a command and of what it read. Everything happens in a fresh folder. */
#include "base/core/replay.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

static struct um_context *context;
static char base[UM_TEST_PATH];
static char *command[] = {(char *)"run", (char *)"a\"b"};

static int set_up(void **state)
{
  (void)state;
  if (um_test_folder_create(base) != 0 || chdir(base) != 0) return -1;
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int tear_down(void **state)
{
  (void)state;
  um_core_replay_end(context);
  um_core_context_destroy(&context);
  return chdir("..") == 0 ? um_test_folder_remove(base) : -1;
}

static void write_file(const char *path, const char *text)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
}

static void read_file(const char *path)
{
  char *text;
  size_t length;
  assert_int_equal(um_core_file_read(context, path, 100, &text, &length), UM_OK);
  um_core_free(context, text);
}

/* The record as text; the caller frees. */
static char *record(void)
{
  char *text = NULL;
  size_t size = 0;
  FILE *file = open_memstream(&text, &size);
  assert_non_null(file);
  um_core_replay_write(context, file);
  assert_int_equal(fclose(file), 0);
  return text;
}

static void expect_inputs(const char *inputs)
{
  char *text = record();
  const char *at = strstr(text, "\"inputs\"");
  assert_non_null(at);
  assert_string_equal(at, inputs);
  free(text);
}

/* Digests of "", "a" and "foobar": the table of the authors of FNV (FNV-1a, 64 bits). */
static void test_inputs(void **state)
{
  (void)state;
  write_file("none", "");
  write_file("a", "a");
  write_file("foobar", "foobar");
  read_file("a"); /* before the command */
  assert_int_equal(um_core_replay_begin(context, "1.2.3", "umbra run", command, 2), UM_OK);
  expect_inputs("\"inputs\": []}\n");
  read_file("foobar");
  read_file("none");
  assert_int_equal(um_core_file_check(context, "a"), UM_OK); /* what a library opens */
  const char *all = "\"inputs\": [\n"
                    "  {\"path\": \"foobar\", \"bytes\": 6, \"fnv1a64\": \"85944171f73967e8\"},\n"
                    "  {\"path\": \"none\", \"bytes\": 0, \"fnv1a64\": \"cbf29ce484222325\"},\n"
                    "  {\"path\": \"a\", \"bytes\": 1, \"fnv1a64\": \"af63dc4c8601ec8c\"}\n ]}\n";
  expect_inputs(all);
  /* as it was when it was read first */
  write_file("a", "changed since");
  read_file("a");
  expect_inputs(all);
  /* what is no input of the user's */
  um_core_snapshot_forget(context, "foobar");
  um_core_snapshot_forget(context, "a");
  um_core_snapshot_forget(context, "never read");
  expect_inputs("\"inputs\": [\n"
                "  {\"path\": \"none\", \"bytes\": 0, \"fnv1a64\": \"cbf29ce484222325\"}\n ]}\n");
  /* a command of its own */
  assert_int_equal(um_core_replay_begin(context, "1.2.3", "umbra run", command, 2), UM_OK);
  expect_inputs("\"inputs\": []}\n");
  remove("none");
  remove("a");
  remove("foobar");
}

/* A file that is not there is no input; what comes with the program is none, its neighbours are. */
static void test_left_out(void **state)
{
  (void)state;
  FILE *file;
  assert_int_equal(mkdir("lib", 0777), 0);
  write_file("lib/x", "x");
  write_file("library", "x");
  assert_int_equal(um_core_replay_begin(context, "1", "umbra run", command, 1), UM_OK);
  assert_int_equal(um_core_replay_leave_out(context, "lib"), UM_OK);
  assert_int_equal(um_core_replay_leave_out(context, "lib"), UM_OK);
  assert_int_equal(um_core_file_open(context, "missing", &file), UM_ERR_IO);
  um_core_message_clear(context);
  read_file("lib/x");
  expect_inputs("\"inputs\": []}\n");
  read_file("library");
  char *text = record();
  assert_non_null(strstr(text, "\"path\": \"library\""));
  free(text);
  remove("lib/x");
  remove("library");
  assert_int_equal(rmdir("lib"), 0);
}

static void make_folder(void)
{
  struct um_core_folder *folder;
  assert_int_equal(um_core_folder_begin(context, "out", false, &folder), UM_OK);
  assert_int_equal(um_core_folder_commit(context, &folder), UM_OK);
}

/* A folder of results holds it where a command is known, and only there. */
static void test_folder(void **state)
{
  (void)state;
  um_core_replay_end(context);
  make_folder();
  assert_int_not_equal(access("out/replay.json", F_OK), 0);
  assert_int_equal(um_core_replay_begin(context, "1.2.3", "umbra run", command, 2), UM_OK);
  make_folder();
  um_core_replay_end(context);
  char *text;
  size_t length;
  assert_int_equal(um_core_file_read(context, "out/replay.json", 4096, &text, &length), UM_OK);
  const char *begin = "{\"umbra_replay\": 1,\n \"version\": \"1.2.3\",\n"
                      " \"arguments\": [\"run\", \"a\\\"b\"],\n \"folder\": \"/";
  assert_int_equal(strncmp(text, begin, strlen(begin)), 0);
  um_core_free(context, text);
  make_folder();
  assert_int_not_equal(access("out/replay.json", F_OK), 0);
  remove("out/.umbra");
  assert_int_equal(rmdir("out"), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_inputs),
      cmocka_unit_test(test_left_out),
      cmocka_unit_test(test_folder),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
