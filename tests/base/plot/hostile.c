/* Names that are commands, drawn at every place where a text is drawn: no command runs, gnuplot has
 * nothing to say, and all pictures are there. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/plot/plot.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define CANARY "canary"

static char folder[UM_TEST_PATH], home[4096];
static struct um_context *context;

/* The working folder is the pictures', so that a canary would lie there or in it. */
static int enter(void **state)
{
  (void)state;
  if (getcwd(home, sizeof home) == NULL || um_test_folder_create(folder) != 0) return -1;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  return chdir(folder);
}

static int leave(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  DIR *directory = opendir(".");
  for (struct dirent *e; directory != NULL && (e = readdir(directory)) != NULL;)
    if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0) remove(e->d_name);
  if (directory != NULL) closedir(directory);
  return chdir(home) == 0 ? um_test_folder_remove(folder) : -1;
}

static bool exists(const char *path) { return access(path, F_OK) == 0; }

static bool have_gnuplot(void)
{
  const char *path = getenv("PATH");
  char *list = strdup(path == NULL ? "" : path), *save = NULL;
  bool found = false;
  for (char *one = strtok_r(list, ":", &save); one != NULL; one = strtok_r(NULL, ":", &save)) {
    char file[4096];
    snprintf(file, sizeof file, "%s/gnuplot", one);
    found = found || access(file, X_OK) == 0;
  }
  free(list);
  return found;
}

static bool begins(const char *path, const char *magic)
{
  char bytes[16] = {0};
  FILE *file = fopen(path, "rb");
  if (file == NULL) return false;
  size_t n = fread(bytes, 1, strlen(magic), file);
  fclose(file);
  return n == strlen(magic) && memcmp(bytes, magic, n) == 0;
}

static const char *const hostile[] = {
    "b `touch " CANARY "` b",
    "x\"; system(\"touch " CANARY "\"); o = \"y",
    "x'; system('touch " CANARY "'); o = 'y",
    "'.system('touch " CANARY "').'",
    "''.system(\"touch " CANARY "\").''",
    "\\'; system('touch " CANARY "') #",
    "\\\"; system(\"touch " CANARY "\") #",
    "$(touch " CANARY ")",
    "x\nsystem(\"touch " CANARY "\")\n",
    "EOD\nsystem(\"touch " CANARY "\")\n$x << EOD\n",
    "x\r!touch " CANARY "\r",
    "| touch " CANARY,
    "< touch " CANARY,
    "@GPVAL_PWD \\",
    "'",
    "\"",
    "`",
    "\\",
    "%s %d %n %g",
    "{/:Bold x^{y_{z}} &{q} ~a{.8b}",
    "}; system('touch " CANARY "'); {",
    "#",
    "<script>alert(1)</script> & \xff",
    "\xe2\x80\xae \xc0\xa7; system(\xc0\xa7touch " CANARY "\xc0\xa7)",
};

static void draw_all(const char *name)
{
  struct um_plot *plot = NULL;
  struct um_plot_time time = um_plot_time(0.0, 600.0, "2020-01-01T00:00:00.000Z");
  static const double t[] = {0.0, 300.0, 600.0}, sunlit[] = {1.0, 0.5, 0.0};
  assert_int_equal(um_plot_create(context, ".", "plots.gp", &plot), UM_OK);
  um_plot_picture(plot, "first", 400, 300);
  um_plot_title(plot, name, name);
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, 3, t, sunlit);
  um_plot_time_label(plot, &time);
  um_plot_ylabel(plot, name, "[W/m^2]");
  um_plot_panel(plot, 80, 60, 380, 150);
  um_plot_add(plot, "$data << EOD\n");
  for (size_t i = 0; i < 3; i++) um_plot_add(plot, "%g,%g\n", t[i] / 60.0, sunlit[i]);
  um_plot_add(plot, "EOD\nset label 1 %s at graph 0.1,0.9 noenhanced\n", name);
  um_plot_add(plot, "plot $data using 1:2 with lines title %s noenhanced\n", name);
  um_plot_panel(plot, 80, 170, 380, 250);
  um_plot_add(plot, "plot $data using 1:2 with lines title %s\n", name); /* marked-up text */
  um_plot_picture(plot, name, 200, 200);
  um_plot_add(plot, "plot x notitle\n");
  assert_int_equal(um_plot_draw(context, &plot), UM_OK);
}

static void test_hostile(void **state)
{
  (void)state;
  static const char *const kind[] = {"png", "svg", "pdf"};
  static const char *const magic[] = {"\x89PNG", "<?xml", "%PDF"};
  bool gnuplot = have_gnuplot();
  for (size_t i = 0; i < sizeof hostile / sizeof hostile[0]; i++) {
    draw_all(hostile[i]);
    if (exists(CANARY)) fail_msg("a command ran: %s", hostile[i]);
    if (!gnuplot) continue;
    if (exists("gnuplot.log")) fail_msg("gnuplot stopped at: %s", hostile[i]);
    for (size_t k = 0; k < 3; k++) {
      char path[32];
      snprintf(path, sizeof path, "first.%s", kind[k]);
      if (!begins(path, magic[k])) fail_msg("no %s of %s", path, hostile[i]);
      remove(path);
    }
  }
  if (!gnuplot) print_message("gnuplot is not installed: pictures not looked at\n");
}

/* What gnuplot complains of stands in its log, and is a warning. */
static void test_failure(void **state)
{
  (void)state;
  struct um_plot *plot = NULL;
  assert_int_equal(um_plot_create(context, ".", "plots.gp", &plot), UM_OK);
  um_plot_add(plot, "no such command\n");
  assert_int_equal(um_plot_draw(context, &plot), UM_OK);
  assert_null(plot);
  if (have_gnuplot()) assert_true(exists("gnuplot.log"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_hostile, enter, leave),
      cmocka_unit_test_setup_teardown(test_failure, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
