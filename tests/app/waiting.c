/* Nothing waits for ever, and no point is lost in silence: pipes in place of files, too little
 * memory, worker processes that are killed again and again. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tests/app/command.h"
#include "tests/app/small.h"

/* That a command may work before it refuses [s], and wait beside others ten times as long. */
#define LONGEST 2.0

static const char study[] = "schema: 1\n"
                            "name: killed\n"
                            "scenario: box.yaml\n"
                            "parameters:\n"
                            "  - {material: grey_white, property: emittance, from: 0.7, to: 0.9}\n"
                            "design: {kind: latin_hypercube, points: 12, seed: 1}\n"
                            "outputs: {bands: [lwir]}\n";

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Processor time of all commands so far [s]. */
static double worked(void)
{
  struct rusage used;
  assert_int_equal(getrusage(RUSAGE_CHILDREN, &used), 0);
  return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

/* What reads a pipe says so, in one line, and makes nothing. A pipe whose other end nobody opens
 * would keep the command until CTest ends it. */
static void test_pipes(void **state)
{
  (void)state;
  static const struct {
    const char *find, *replace; /* in box.yaml, NULL: nothing */
    const char *arguments[8];
  } cases[] = {
      {NULL, NULL, {"run", "pipe"}},
      {NULL, NULL, {"check", "folder"}},
      {NULL, NULL, {"study", "pipe"}},
      {NULL, NULL, {"period", "pipe"}},
      {NULL, NULL, {"compare", "box.yaml", "pipe"}},
      {NULL, NULL, {"compare", "box.yaml", "folder/link"}},
      {NULL, NULL, {"photometry", "pipe", "--aperture", "3,5,7", "-o", "x.csv"}},
      {NULL, NULL, {"render", "folder/pipe.nc", "-o", "x.exr"}},
      {NULL, NULL, {"import", "pipe", "-o", "x.csv"}},
      {NULL, NULL, {"check", "box.yaml", "--effect-file", "pipe"}},
      {NULL, NULL, {"material", "--from-profile", "pipe"}},
      {NULL, NULL, {"material", "--from-brdf", "pipe", "--half-angle", "10"}},
      {NULL, NULL, {"study", "study.yaml", "-o", "out"}},
      {"box: {size_m: [1, 1, 1]}", "mesh: pipe", {"check", "box.yaml"}},
      {"bands:", "material_files: [pipe]\nbands:", {"check", "box.yaml"}},
      {"- lvlh: {}", "- table: pipe", {"check", "box.yaml"}},
      {"attitude:", "  earth_orientation: {finals: pipe}\nattitude:", {"check", "box.yaml"}},
      {"bands:",
       "environment: {earth: {model: map, file: pipe}}\nbands:",
       {"run", "box.yaml", "--out", "new"}},
      {"vis: {from_um: 0.38, to_um: 0.78, bins: 4}",
       "vis: {filter_file: pipe, bins: 4}",
       {"check", "box.yaml"}}};
  assert_int_equal(mkfifo("pipe", 0666), 0);
  assert_int_equal(mkdir("folder", 0777), 0);
  assert_int_equal(mkfifo("folder/scenario.yaml", 0666), 0);
  assert_int_equal(symlink("../pipe", "folder/link"), 0);
  assert_int_equal(symlink("../pipe", "folder/pipe.nc"), 0);
  assert_int_equal(mkdir("out.points", 0777), 0);
  assert_int_equal(mkfifo("out.points/points.records", 0666), 0);
  command_write("study.yaml", study);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char *scenario = command_data("box.yaml");
    if (cases[i].find != NULL) scenario = command_edit(scenario, cases[i].find, cases[i].replace);
    command_write("box.yaml", scenario);
    struct command c = command_run_list(cases[i].arguments);
    if (c.code != 1 || command_count_lines(c.err) != 1 ||
        strstr(c.err, ": is not a plain file but a pipe\n") == NULL)
      fail_msg("%s %s: exit %d: %s%s", cases[i].arguments[0], cases[i].arguments[1], c.code, c.out,
               c.err);
    command_release(&c);
    free(scenario);
  }
  assert_false(command_exists("x.csv") || command_exists("x.exr") || command_exists("new") ||
               command_exists("out"));
  /* standard input, which is /dev/null here */
  struct command c = command_run("compare", "box.yaml", "/dev/stdin", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "/dev/stdin: is not a plain file but a device"));
  command_release(&c);
  /* to write to one that nobody reads */
  command_copy_data("box.yaml");
  c = command_run("synth", "box.yaml", "-o", "pipe", "--noise", "0.01", "--seed", "1", "--force",
                  NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "pipe: nobody reads this pipe"));
  command_release(&c);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/* Libraries of threads wait for threads that wait for memory. */
static void test_little_memory(void **state)
{
  (void)state;
  static const char *const commands[][8] = {
      {"study", "study.yaml", "--workers", "2", "--threads", "1"},
      {"run", "solid.yaml", "--threads", "1", "--no-plots"},
      {"run", "box.yaml", "--no-plots"}};
  struct rlimit before;
  command_copy_data("box.yaml");
  command_write("study.yaml", study);
  command_write("solid.yaml",
                SMALL_HEAD "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n    outside: "
                           "grey_white\n    shell: {areal_heat_capacity_J_m2_K: 3000}\n");
  assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
  for (rlim_t megabyte = 140; megabyte <= 200; megabyte += 30)
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
      struct rlimit little = {megabyte << 20, before.rlim_max};
      double begin = now(), before_it = worked();
      assert_int_equal(setrlimit(RLIMIT_AS, &little), 0);
      struct command c = command_run_list(commands[i]);
      double took = now() - begin, work = worked() - before_it;
      assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
      if (c.code == 0 || c.err[0] == '\0')
        fail_msg("%s in %d MiB: exit %d: %s", commands[i][0], (int)megabyte, c.code, c.err);
      if (!(work < LONGEST && took < 10.0 * LONGEST))
        fail_msg("%s in %d MiB: %.1f s of work in %.1f s", commands[i][0], (int)megabyte, work,
                 took);
      command_release(&c);
    }
}
#endif

/* Children of a process into out[most]; how many. A dead one that nobody has waited for counts. */
static size_t children_of(long pid, long *out, size_t most)
{
  char path[64];
  size_t n = 0;
  snprintf(path, sizeof path, "/proc/%ld/task/%ld/children", pid, pid);
  FILE *file = fopen(path, "r");
  if (file == NULL) return 0;
  while (n < most && fscanf(file, "%ld", &out[n]) == 1) n++;
  fclose(file);
  return n;
}

/* In a child of the test: kills workers, the grandchildren of the test, as soon as they are forked,
 * until `kills` are dead. The latest is remembered, so that none counts twice. */
static _Noreturn void kill_workers(long test, int kills)
{
  long command[4], worker[8], latest = 0;
  alarm(60);
  while (kills > 0) {
    size_t n = children_of(test, command, 4);
    for (size_t i = 0; i < n; i++) {
      size_t m = command[i] == (long)getpid() ? 0 : children_of(command[i], worker, 8);
      for (size_t k = 0; k < m && kills > 0; k++) {
        if (worker[k] <= latest || kill((pid_t)worker[k], SIGKILL) != 0) continue;
        latest = worker[k];
        kills--;
      }
    }
  }
  _exit(0);
}

/* Workers die over the first points, whichever they are: the others are computed, the exit status
 * says that some are missing, which ones is said, and --resume computes them. Points are so many
 * that the last kill comes before the last point on a machine that has other work. */
#define LOST_OF 96
static void test_lost_points(void **state)
{
  (void)state;
  char list[64] = "";
  command_copy_data("box.yaml");
  char *text = command_edit(strdup(study), "points: 12", "points: 96");
  command_write("study.yaml", text);
  free(text);
  long test = (long)getpid();
  pid_t killer = fork();
  if (killer == 0) kill_workers(test, 8);
  struct command c = command_run("study", "study.yaml", "-o", "out", "--workers", "2", NULL);
  assert_int_equal(waitpid(killer, NULL, 0), killer);
  if (c.code != 3) fail_msg("exit %d: %s%s", c.code, c.out, c.err);
  const char *named = strstr(c.err, "points.csv: point ");
  if (named == NULL || sscanf(named, "points.csv: point %63[^:]", list) != 1 ||
      strstr(c.err, "not on record: the process that computed it died, twice (signal 9") == NULL ||
      strstr(c.err, "missing; the others stay on record in out.points") == NULL)
    fail_msg("what is lost is not said: %s", c.err);
  assert_non_null(strstr(c.out, "could not be computed"));
  command_release(&c);
  assert_true(command_exists("out.points/points.records"));
  /* those that are named have a reason, and no others */
  char *points = command_read("out/points.csv");
  size_t reasons = 0, commas = 1;
  for (const char *at = points; (at = strstr(at, "died, twice")) != NULL; at++) reasons++;
  for (const char *at = list; *at != '\0'; at++) commas += *at == ',';
  assert_int_equal(reasons, commas);
  assert_true(reasons < LOST_OF);
  free(points);
  command_expect(0, "study", "study.yaml", "-o", "out", "--workers", "2", "--resume", NULL);
  points = command_read("out/points.csv");
  assert_null(strstr(points, "died"));
  assert_int_equal(command_count_lines(points), 1 + LOST_OF);
  free(points);
  assert_false(command_exists("out.points"));
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, command_enter, command_leave)
  static const struct CMUnitTest tests[] = {
    TEST(test_pipes),
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    TEST(test_little_memory),
#endif
    TEST(test_lost_points),
  };
  return cmocka_run_group_tests_name("waiting", tests, NULL, NULL);
}
