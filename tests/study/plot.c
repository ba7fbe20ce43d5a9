/* Pictures of a study: those that should be are drawn, names of parameters that gnuplot or a shell
 * would take for more than a name among them. UMBRA_TEST_KEEP=1 leaves them to be looked at. */
#include "study/plot.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/uncertainty/statistics.h"
#include "study/report.h"
#include "tests/study/pass_test.h"
#include "tests/support/temporary.h"

/* A picture is there and no bare frame: more than `least` bytes. */
static void drawn(const char *folder, const char *name, long least)
{
  char path[UM_TEST_PATH + 100];
  struct stat about;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  if (stat(path, &about) != 0) fail_msg("%s is not there", path);
  if (about.st_size < least) fail_msg("%s has %ld bytes", path, (long)about.st_size);
}

static void clear(const char *folder)
{
  DIR *all = opendir(folder);
  const struct dirent *one;
  assert_non_null(all);
  while ((one = readdir(all)) != NULL) {
    char path[UM_TEST_PATH + 300];
    snprintf(path, sizeof path, "%s/%s", folder, one->d_name);
    unlink(path);
  }
  closedir(all);
  rmdir(folder);
}

/* Pictures of r, in a folder that is left to the caller. */
static void draw(struct um_study_result *r, const double *weight, char base[UM_TEST_PATH],
                 char *path, size_t size)
{
  struct um_study_statistics *l;
  struct um_core_folder *folder;
  assert_int_equal(um_test_folder_create(base), 0);
  snprintf(path, size, "%s/out", base);
  assert_int_equal(um_study_statistics_create(context, r, weight, &l), UM_OK);
  assert_int_equal(um_core_folder_begin(context, path, false, &folder), UM_OK);
  assert_int_equal(um_study_report_write(context, r, l, folder), UM_OK);
  assert_int_equal(um_study_plot(context, r, l, weight, folder), UM_OK);
  assert_int_equal(um_core_folder_commit(context, &folder), UM_OK);
  um_study_statistics_destroy(context, &l);
}

static void done(const char *base, const char *path)
{
  if (getenv("UMBRA_TEST_KEEP") != NULL) {
    print_message("kept in %s\n", path);
    return;
  }
  clear(path);
  um_test_folder_remove(base);
}

static void test_surrogate(void **state)
{
  (void)state;
  char base[UM_TEST_PATH], path[UM_TEST_PATH + 10];
  struct um_study_result *r = pass_sobol(400, true);
  double *weight, *l, effective;
  assert_int_equal(um_core_allocate(context, 400, sizeof *weight, &weight), UM_OK);
  assert_int_equal(um_core_allocate(context, 400, sizeof *l, &l), UM_OK);
  for (size_t i = 0; i < 400; i++)
    l[i] = -0.5 * pow(r->value[i * PASS_NVALUE + 3 * PASS_NTIME] / 20.0, 2.0);
  assert_int_equal(um_uncertainty_weights(context, 400, l, weight, &effective), UM_OK);
  assert_int_equal(um_core_allocate(context, 2, sizeof *r->limit, &r->limit), UM_OK);
  r->nlimit = 2;
  r->limit[0] = (struct um_study_limit){.quantity = 0, .value = 1.4e-11};
  r->limit[1] = (struct um_study_limit){.quantity = 1, .value = 2.1e-10};
  draw(r, weight, base, path, sizeof path);
  static const char *const name[] = {"bands.png",
                                     "temperatures.png",
                                     "surface_irradiance_vis.png",
                                     "surface_irradiance_lwir.png",
                                     "scatter_rms_lwir.png",
                                     "posterior.png",
                                     "limits.png",
                                     "bands.svg",
                                     "bands.pdf"};
  for (size_t i = 0; i < sizeof name / sizeof *name; i++) drawn(path, name[i], 5000);
  done(base, path);
  um_core_free(context, weight);
  um_core_free(context, l);
  um_study_result_destroy(context, &r);
}

/* Where no shares are said the picture says so, and shows none that several have at once. */
static void test_withheld(void **state)
{
  (void)state;
  char base[UM_TEST_PATH], path[UM_TEST_PATH + 10], name[UM_TEST_PATH + 20], line[2000];
  struct um_study_result *r = pass_sobol(200, true);
  r->quantity[0].withheld = true;
  draw(r, NULL, base, path, sizeof path);
  snprintf(name, sizeof name, "%s/plots.gp", path);
  FILE *file = fopen(name, "r");
  size_t said = 0, moves = 0;
  assert_non_null(file);
  while (fgets(line, sizeof line, file) != NULL) {
    said += strncmp(line, "set label 1 'withheld'", 22) == 0;
    moves += strstr(line, "strcol(4) ne '' && column(3)") != NULL;
  }
  fclose(file);
  assert_int_equal(said, 1);
  assert_int_equal(moves, 3);
  drawn(path, "bands.png", 5000);
  done(base, path);
  um_study_result_destroy(context, &r);
}

static void test_points(void **state)
{
  (void)state;
  char base[UM_TEST_PATH], path[UM_TEST_PATH + 10];
  struct um_study_result *r = pass_sobol(200, false);
  um_core_free(context, r->parameter_name[1]);
  assert_int_equal(um_core_strdup(context, "`touch x` '; | {/=50 _a^b} %s", &r->parameter_name[1]),
                   UM_OK);
  r->nquantity = 3;
  um_core_free(context, r->quantity[3].name);
  um_core_free(context, r->quantity[3].unit);
  um_core_free(context, r->quantity[3].of);
  for (size_t k = 0; k < PASS_NVALUE; k++) r->value[5 * PASS_NVALUE + k] = NAN;
  assert_int_equal(um_core_strdup(context, "a thermostat", &r->reason[5]), UM_OK);
  draw(r, NULL, base, path, sizeof path);
  static const char *const name[] = {"bands.png", "temperatures.png", "surface_irradiance_lwir.png",
                                     "scatter_irradiance_lwir.png"};
  for (size_t i = 0; i < sizeof name / sizeof *name; i++) drawn(path, name[i], 5000);
  char touched[UM_TEST_PATH + 20];
  snprintf(touched, sizeof touched, "%s/x", path);
  assert_int_not_equal(access(touched, F_OK), 0);
  done(base, path);
  um_study_result_destroy(context, &r);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_surrogate),
                                     cmocka_unit_test(test_withheld),
                                     cmocka_unit_test(test_points)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
