/* See command.h. Standard output and error go into files, so that no pipe can fill up. */
#define _GNU_SOURCE /* wait4 */
#include "tests/app/command.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define ARGUMENTS_MAX 32

static char home[4096];   /* working folder of the test program */
static char folder[4096]; /* the one that commands run in */
static long file_limit;   /* [bytes], 0: none */

static int remove_entry(const char *path, const struct stat *st, int kind, struct FTW *ftw)
{
  (void)st;
  (void)kind;
  (void)ftw;
  return remove(path);
}

int command_enter(void **state)
{
  (void)state;
  file_limit = 0;
  if (home[0] == '\0' && getcwd(home, sizeof home) == NULL) return -1;
  snprintf(folder, sizeof folder, "%.4000s/cli-XXXXXX", home);
  return mkdtemp(folder) == NULL ? -1 : chdir(folder);
}

int command_leave(void **state)
{
  (void)state;
  return chdir(home) == 0 ? nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS) : -1;
}

void command_limit_files(long bytes) { file_limit = bytes; }

static _Noreturn void become(const char *const *arguments, const char *out, const char *err)
{
  char *list[ARGUMENTS_MAX + 2] = {(char *)"umbra"};
  size_t n = 1;
  while (*arguments != NULL && n <= ARGUMENTS_MAX) list[n++] = (char *)*arguments++;
  int o = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  int e = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0666), i = open("/dev/null", O_RDONLY);
  /* a shell that starts the tests in the background has switched it off */
  signal(SIGINT, SIG_DFL);
  if (o < 0 || e < 0 || i < 0 || dup2(i, 0) < 0 || dup2(o, 1) < 0 || dup2(e, 2) < 0) _exit(126);
  if (file_limit > 0) {
    struct rlimit limit = {(rlim_t)file_limit, (rlim_t)file_limit};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(125);
  }
  execv(UMBRA_PROGRAM, list);
  _exit(127);
}

struct running {
  pid_t child;
  char out[4200], err[4200];
};

static struct running start(const char *const *arguments)
{
  struct running r;
  /* beside the folder, so that they are not among the files that a test looks at */
  snprintf(r.out, sizeof r.out, "%s.out", folder);
  snprintf(r.err, sizeof r.err, "%s.err", folder);
  fflush(NULL);
  r.child = fork();
  if (r.child == 0) become(arguments, r.out, r.err);
  assert_true(r.child > 0);
  return r;
}

static struct command finish(const struct running *r)
{
  struct command command = {0};
  int state = 0;
  struct rusage used;
  while (wait4(r->child, &state, 0, &used) < 0) assert_int_equal(errno, EINTR);
  command.peak_kB = used.ru_maxrss;
  command.code = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  command.out = command_read(r->out);
  command.err = command_read(r->err);
  remove(r->out);
  remove(r->err);
  return command;
}

struct command command_run_list(const char *const *arguments)
{
  struct running r = start(arguments);
  return finish(&r);
}

static bool appeared(const char *prefix)
{
  bool found = false;
  DIR *directory = opendir(".");
  assert_non_null(directory);
  for (struct dirent *e; !found && (e = readdir(directory)) != NULL;)
    found = strncmp(e->d_name, prefix, strlen(prefix)) == 0;
  closedir(directory);
  return found;
}

struct command command_run_until(const char *prefix, int signal_number,
                                 const char *const *arguments)
{
  const struct timespec pause = {0, 20000000}; /* 20 ms */
  struct running r = start(arguments);
  for (int i = 0; i < 1000 && !appeared(prefix); i++) nanosleep(&pause, NULL);
  kill(r.child, signal_number);
  return finish(&r);
}

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void nap(double seconds)
{
  struct timespec t = {(time_t)seconds, (long)(1e9 * (seconds - (double)(time_t)seconds))};
  while (nanosleep(&t, &t) != 0) assert_int_equal(errno, EINTR);
}

/* Processor time of a process and of the children that it has waited for [s]: fields 14 to 17 of
 * /proc/PID/stat (proc(5)), counted behind the name, which may hold blanks. */
static double worked(pid_t child)
{
  char path[64], text[1024];
  unsigned long ticks[4] = {0};
  snprintf(path, sizeof path, "/proc/%ld/stat", (long)child);
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  text[fread(text, 1, sizeof text - 1, file)] = '\0';
  fclose(file);
  const char *at = strrchr(text, ')');
  assert_non_null(at);
  assert_int_equal(sscanf(at + 1, " %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu %lu %lu",
                          &ticks[0], &ticks[1], &ticks[2], &ticks[3]),
                   4);
  return (double)(ticks[0] + ticks[1] + ticks[2] + ticks[3]) / (double)sysconf(_SC_CLK_TCK);
}

struct command command_run_for(double seconds, int signal_number, const char *const *arguments)
{
  struct running r = start(arguments);
  nap(seconds);
  double begin = now(), before = worked(r.child);
  siginfo_t info;
  kill(r.child, signal_number);
  while (waitid(P_PID, (id_t)r.child, &info, WEXITED | WNOWAIT) != 0)
    assert_int_equal(errno, EINTR);
  double end = now(), after = worked(r.child); /* it is dead, and not yet waited for */
  struct command command = finish(&r);
  command.seconds = end - begin;
  command.worked = after - before;
  return command;
}

static void collect(const char **list, const char *first, va_list rest)
{
  size_t n = 0;
  for (const char *a = first; a != NULL && n < ARGUMENTS_MAX; a = va_arg(rest, const char *))
    list[n++] = a;
  list[n] = NULL;
}

struct command command_run(const char *first, ...)
{
  const char *list[ARGUMENTS_MAX + 1];
  va_list rest;
  va_start(rest, first);
  collect(list, first, rest);
  va_end(rest);
  return command_run_list(list);
}

void command_expect(int code, const char *first, ...)
{
  const char *list[ARGUMENTS_MAX + 1];
  va_list rest;
  va_start(rest, first);
  collect(list, first, rest);
  va_end(rest);
  struct command command = command_run_list(list);
  if (command.code != code)
    fail_msg("umbra %s: exit %d, expected %d; it said:\n%s%s", first, command.code, code,
             command.out, command.err);
  command_release(&command);
}

void command_release(struct command *command)
{
  free(command->out);
  free(command->err);
  command->out = command->err = NULL;
}

char *command_read_bytes(const char *path, size_t *length)
{
  FILE *file = fopen(path, "rb");
  if (file == NULL) fail_msg("%s cannot be read: %s", path, strerror(errno));
  assert_int_equal(fseek(file, 0, SEEK_END), 0);
  long size = ftell(file);
  assert_true(size >= 0);
  rewind(file);
  char *text = calloc((size_t)size + 1, 1);
  assert_non_null(text);
  assert_int_equal(fread(text, 1, (size_t)size, file), size);
  fclose(file);
  *length = (size_t)size;
  return text;
}

char *command_read(const char *path)
{
  size_t length;
  return command_read_bytes(path, &length);
}

void command_write_bytes(const char *path, const void *bytes, size_t length)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, length, file), length);
  assert_int_equal(fclose(file), 0);
}

void command_expect_same(const char *a, const char *b, const char *const *files)
{
  for (; *files != NULL; files++) {
    char path[256];
    size_t na, nb;
    snprintf(path, sizeof path, "%s/%s", a, *files);
    char *of_a = command_read_bytes(path, &na);
    snprintf(path, sizeof path, "%s/%s", b, *files);
    char *of_b = command_read_bytes(path, &nb);
    assert_true(na > 1000);
    assert_int_equal(na, nb);
    assert_memory_equal(of_a, of_b, na);
    free(of_a);
    free(of_b);
  }
}

void command_write(const char *path, const char *text)
{
  command_write_bytes(path, text, strlen(text));
}

size_t command_processes_below(const char *path)
{
  size_t count = 0, length = strlen(path);
  DIR *all = opendir("/proc");
  assert_non_null(all);
  for (struct dirent *entry; (entry = readdir(all)) != NULL;) {
    char link[300], at[4200];
    long pid = strtol(entry->d_name, NULL, 10);
    if (pid <= 0 || pid == (long)getpid()) continue;
    snprintf(link, sizeof link, "/proc/%ld/cwd", pid);
    ssize_t n = readlink(link, at, sizeof at - 1);
    if (n <= 0) continue;
    at[n] = '\0';
    count += strncmp(at, path, length) == 0 && (at[length] == '\0' || at[length] == '/');
  }
  closedir(all);
  return count;
}

bool command_exists(const char *path)
{
  struct stat st;
  return lstat(path, &st) == 0;
}

/* FNV-1a, enough to see that a file is the same. */
static unsigned long hash_of(const char *path)
{
  size_t length;
  unsigned long hash = 2166136261u;
  char *bytes = command_read_bytes(path, &length);
  for (size_t i = 0; i < length; i++)
    hash = ((hash ^ (unsigned char)bytes[i]) * 16777619u) & 0xffffffffu;
  free(bytes);
  return hash;
}

static char **entries; /* of the snapshot in the making */
static size_t nentry;

static int take_entry(const char *path, const struct stat *st, int kind, struct FTW *ftw)
{
  char text[4400];
  (void)ftw;
  if (kind == FTW_F)
    snprintf(text, sizeof text, "%.4200s %ld bytes %08lx\n", path, (long)st->st_size,
             hash_of(path));
  else
    snprintf(text, sizeof text, "%.4200s/\n", path);
  char **grown = realloc(entries, (nentry + 1) * sizeof *entries);
  assert_non_null(grown);
  entries = grown;
  entries[nentry] = strdup(text);
  assert_non_null(entries[nentry++]);
  return 0;
}

static int by_text(const void *a, const void *b)
{
  return strcmp(*(char *const *)a, *(char *const *)b);
}

char *command_snapshot(const char *path)
{
  size_t length = 1;
  nentry = 0;
  assert_int_equal(nftw(path, take_entry, 16, FTW_PHYS), 0);
  qsort(entries, nentry, sizeof *entries, by_text);
  for (size_t i = 0; i < nentry; i++) length += strlen(entries[i]);
  char *text = calloc(length, 1);
  assert_non_null(text);
  for (size_t i = 0; i < nentry; i++) {
    strcat(text, entries[i]);
    free(entries[i]);
  }
  free(entries);
  entries = NULL;
  return text;
}

char *command_data(const char *name)
{
  char path[4096];
  snprintf(path, sizeof path, "%s/tests/app/data/%s", UMBRA_SOURCE_DIR, name);
  return command_read(path);
}

char *command_edit(char *text, const char *find, const char *replace)
{
  char *at = strstr(text, find);
  if (at == NULL) fail_msg("nothing to edit: '%s'", find);
  size_t n = strlen(text) + strlen(replace) + 1;
  char *edited = calloc(n, 1);
  assert_non_null(edited);
  snprintf(edited, n, "%.*s%s%s", (int)(at - text), text, replace, at + strlen(find));
  free(text);
  return edited;
}

void command_copy_data(const char *name)
{
  char *text = command_data(name);
  command_write(name, text);
  free(text);
}

int command_line_of(const char *whole, const char *text)
{
  const char *at = strstr(whole, text);
  if (at == NULL) fail_msg("no line holds '%s'", text);
  int line = 1;
  for (const char *c = whole; c < at; c++) line += *c == '\n';
  return line;
}

size_t command_count_lines(const char *text)
{
  size_t n = 0;
  for (; *text != '\0'; text++) n += *text == '\n';
  return n;
}
