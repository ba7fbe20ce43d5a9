/* Running the umbra command from a test: in a fresh folder, with everything it says kept. */
#ifndef UMBRA_TESTS_APP_COMMAND_H
#define UMBRA_TESTS_APP_COMMAND_H

#include <stdbool.h>

#include "tests/support/cmocka_all.h"

/* What a command did; texts end in NUL. */
struct command {
  int code; /* exit status; 128 + signal when it was killed */
  char *out, *err;
  long peak_kB; /* largest memory in use */
  /* from the signal of command_run_for to the end, wall clock, and processor time of the command
   * and of the children that it waited for in it [s] */
  double seconds, worked;
};

/* CMocka setup and teardown: a new empty folder becomes the working folder; it is removed. */
int command_enter(void **state);
int command_leave(void **state);

/* Run `umbra` with the arguments up to NULL; command_release frees the texts. */
struct command command_run(const char *first, ...) __attribute__((sentinel));
struct command command_run_list(const char *const *arguments);
/* The same, sending `signal` as soon as a name that begins with `prefix` stands in the working
 * folder. */
struct command command_run_until(const char *prefix, int signal, const char *const *arguments);
/* The same, sending `signal` after so many seconds. */
struct command command_run_for(double seconds, int signal, const char *const *arguments);
void command_release(struct command *command);
/* From now on, until command_enter, commands can write no file longer than this [bytes]: a full
 * disk as seen from inside; 0: no limit. */
void command_limit_files(long bytes);
/* Run and insist on the exit status; a message shows what was said. Nothing is returned. */
void command_expect(int code, const char *first, ...) __attribute__((sentinel));

/* Whole file; the caller frees. The test fails when it cannot be read. */
char *command_read_bytes(const char *path, size_t *length);
char *command_read(const char *path);
/* Files up to NULL hold the same bytes, more than 1000 of them, in folders a and b. */
void command_expect_same(const char *a, const char *b, const char *const *files);
void command_write(const char *path, const char *text);
void command_write_bytes(const char *path, const void *bytes, size_t length);
bool command_exists(const char *path);
/* Processes, this one aside, whose working folder is `path` or lies below it. */
size_t command_processes_below(const char *path);
/* Names and contents below a folder, folders ending in '/', as one text; the caller frees. Equal
 * texts mean that nothing was added, removed or changed. */
char *command_snapshot(const char *folder);

/* A file of tests/app/data; the caller frees. */
char *command_data(const char *name);
/* Copy of `text` with its first `find` replaced; the test fails when there is none. Frees `text`.
 */
char *command_edit(char *text, const char *find, const char *replace);
/* Write data file `name` under the same name into the working folder. */
void command_copy_data(const char *name);
/* Line on which `text` begins in `whole`, 1-based. */
int command_line_of(const char *whole, const char *text);
size_t command_count_lines(const char *text);

#endif
