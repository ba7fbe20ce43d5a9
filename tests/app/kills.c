/* Twenty runs (eighty in the whole sweep) are ended at moments of all kinds, by SIGKILL, SIGTERM
 * and SIGINT in turn, while they replace the results of an earlier one. After each the results are
 * whole, the earlier or the new ones; no process of theirs lives on; and the next run that ends by
 * itself leaves nothing beside them. The runs have children: TetGen and a gnuplot that takes its
 * time. */
#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/core/sampling.h"
#include "tests/app/command.h"
#include "tests/app/small.h"
#include "tests/support/whole.h"

#ifdef UMBRA_TETGEN
#define SOLID                                                                                      \
  "    solid: {density_kg_m3: 2700, specific_heat_J_kg_K: 900, conductivity_W_m_K: 150, "          \
  "tetrahedron_size_m: 0.2}\n"
#else
#define SOLID "    shell: {areal_heat_capacity_J_m2_K: 3000}\n"
#endif

static const char scenario[] =
    SMALL_HEAD "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n    outside: grey_white\n" SOLID
               "thermal: {start: isothermal, orbits_before: 0.01, step_s: 30}\n";

static const char *const run_list[] = {"run", "s.yaml", "--out", "out", "--threads", "1", NULL};

static void prepare(char *here, size_t size)
{
  char path[8192];
  command_write("s.yaml", scenario);
  assert_non_null(getcwd(here, size));
  assert_int_equal(mkdir("bin", 0777), 0);
  command_write("bin/gnuplot", "#!/bin/sh\nsleep 0.05\necho drawn > lightcurve.png\n");
  assert_int_equal(chmod("bin/gnuplot", 0755), 0);
  snprintf(path, sizeof path, "%s/bin:%s", here, getenv("PATH"));
  assert_int_equal(setenv("PATH", path, 1), 0);
}

static void expect_no_process(const char *here, int kill)
{
  const struct timespec pause = {0, 20000000};
  for (int i = 0; i < 50 && command_processes_below(here) > 0; i++) nanosleep(&pause, NULL);
  if (command_processes_below(here) > 0) fail_msg("kill %d: a process lives on", kill);
}

/* Whole results: every file that the first run wrote, the numbers the same. */
static void expect_whole(const char *curve, int kill)
{
  static const char *const names[] = {".umbra",           "heat.csv",        "lightcurve.csv",
                                      "lightcurve.png",   "log.txt",         "materials.csv",
                                      "run.nc",           "run.xdmf",        "scenario.yaml",
                                      "temperatures.cic", "temperatures.csv"};
  char path[64];
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    snprintf(path, sizeof path, "out/%s", names[i]);
    if (!command_exists(path)) fail_msg("kill %d: %s is missing", kill, path);
  }
  char *now = command_read("out/lightcurve.csv");
  assert_string_equal(now, curve);
  free(now);
}

static size_t count_beside(void)
{
  size_t count = 0;
  DIR *all = opendir(".");
  assert_non_null(all);
  for (struct dirent *entry; (entry = readdir(all)) != NULL;)
    count += strncmp(entry->d_name, ".out.", 5) == 0;
  closedir(all);
  return count;
}

static void test_kills(void **state)
{
  static const int signals[] = {SIGKILL, SIGTERM, SIGINT};
  char here[4096];
  struct timespec begin, end;
  size_t left = 0;
  const int nkill = um_test_number(80, 20);
  (void)state;
  prepare(here, sizeof here);
  clock_gettime(CLOCK_MONOTONIC, &begin);
  command_expect(0, "run", "s.yaml", "--out", "out", "--threads", "1", NULL);
  clock_gettime(CLOCK_MONOTONIC, &end);
  double whole = (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
  char *curve = command_read("out/lightcurve.csv");
  int ended = 0;
  for (int i = 0; i < nkill; i++) {
    double after = 1.1 * whole * um_core_hash_uniform(um_core_hash(1, (uint64_t)i));
    struct command c = command_run_for(after, signals[i % 3], run_list);
    if (c.code != 0 && c.code != 128 + signals[i % 3])
      fail_msg("kill %d: exit %d, it said:\n%s%s", i, c.code, c.out, c.err);
    ended += c.code != 0;
    if (c.code == 0 && after < whole) whole = after; /* the first one was slower than they are */
    command_release(&c);
    expect_no_process(here, i);
    expect_whole(curve, i);
    left += count_beside();
  }
  printf("%d of %d runs of %.2f s were ended, %zu folders lay beside the results\n", ended, nkill,
         whole, left);
  assert_true(ended > nkill / 2);
  command_expect(0, "run", "s.yaml", "--out", "out", "--threads", "1", NULL);
  assert_int_equal(count_beside(), 0);
  free(curve);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_kills, command_enter, command_leave)};
  return cmocka_run_group_tests_name("kills", tests, NULL, NULL);
}
