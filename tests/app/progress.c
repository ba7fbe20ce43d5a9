/* What is said of long work in a pipe and on a terminal, by a clock of the test's. */
#include "app/progress.h"

#include <string.h>

#include "tests/support/cmocka_all.h"

static const char points[] = "computing points", heat[] = "heat";

/* Steps of 3 s: a line with the first step, then every 10 s at least and never oftener, with the
 * time left as it goes on. */
static void test_lines(void **state)
{
  (void)state;
  struct um_app_progress p = {0};
  char line[UM_APP_PROGRESS_LINE] = "";
  double last = 93.0; /* the first comes as early as a step allows */
  int lines = 0;
  for (size_t done = 0; done < 40; done++) {
    double t = 100.0 + 3.0 * (double)done;
    if (!um_app_progress_line(&p, t, points, done, 40, line)) {
      assert_true(t - last < 10.0);
      continue;
    }
    assert_true(t - last >= 10.0 && t - last < 13.0);
    last = t;
    lines++;
  }
  assert_int_equal(lines, 10);
  assert_string_equal(line, "computing points: 37 of 40, 9 s left");
  assert_false(um_app_progress_line(&p, 400.0, points, 40, 40, line)); /* it ends: what is next? */
}

/* Tasks that are each shorter than that do not keep it silent; the time left is the task's own. */
static void test_short_tasks(void **state)
{
  (void)state;
  struct um_app_progress p = {0};
  char line[UM_APP_PROGRESS_LINE] = "";
  int lines = 0;
  for (int i = 0; i < 30; i++) {
    const char *task = i % 2 == 0 ? points : heat;
    double t = 1000.0 + 6.0 * i;
    lines += um_app_progress_line(&p, t, task, 0, 4, line) ? 1 : 0;
    lines += um_app_progress_line(&p, t + 3.0, task, 1, 4, line) ? 1 : 0;
  }
  assert_int_equal(lines, 15); /* after 3 s, then every 12 s of 177 */
  p = (struct um_app_progress){0};
  assert_false(um_app_progress_line(&p, 0.5, points, 0, 4, line));
  assert_false(um_app_progress_line(&p, 1.4, points, 1, 4, line));
  assert_true(um_app_progress_line(&p, 1.6, points, 1, 4, line)); /* the first second */
  assert_false(um_app_progress_line(&p, 8.0, heat, 0, 4, line));
  assert_true(um_app_progress_line(&p, 11.7, heat, 0, 4, line)); /* nothing is done yet */
  assert_string_equal(line, "heat: 0 of 4, 4 s so far");
  p.told = 0.0; /* the time left is from its beginning, not from when it last stood at 0 */
  assert_true(um_app_progress_line(&p, 16.0, heat, 1, 4, line));
  assert_string_equal(line, "heat: 1 of 4, 24 s left");
}

/* Of work whose end nobody knows no time is left, and a name as long as one may be fits. */
static void test_unknown_end(void **state)
{
  (void)state;
  struct um_app_progress p = {0};
  char line[UM_APP_PROGRESS_LINE], name[400];
  assert_false(um_app_progress_line(&p, 1.0, heat, 0, 0, line));
  assert_true(um_app_progress_line(&p, 12.0, heat, 3, 0, line)); /* 11 s */
  assert_string_equal(line, "heat: 3, 11 s so far");
  memset(name, 'x', sizeof name - 1);
  name[sizeof name - 1] = '\0';
  assert_true(um_app_progress_line(&p, 30.0, name, (size_t)1 << 49, (size_t)-1, line));
  assert_true(strlen(line) < sizeof line);
  assert_true(um_app_progress_bar(&p, 40.0, name, (size_t)1 << 50, (size_t)1 << 51, line));
  assert_true(strlen(line) < sizeof line);
  assert_true(um_app_progress_line(&p, 60.0, name, (size_t)-2, (size_t)-1, line));
  assert_true(strlen(line) < sizeof line);
}

static void test_bar(void **state)
{
  (void)state;
  struct um_app_progress p = {0};
  char line[UM_APP_PROGRESS_LINE];
  assert_false(um_app_progress_bar(&p, 10.0, points, 0, 4, line));
  assert_false(um_app_progress_bar(&p, 10.2, points, 1, 4, line)); /* a blink */
  assert_true(um_app_progress_bar(&p, 11.0, points, 1, 4, line));
  assert_string_equal(line, "computing points [#######---------------------]  25 %, 3 s left");
  assert_false(um_app_progress_bar(&p, 11.05, points, 2, 4, line));
  assert_true(um_app_progress_bar(&p, 11.2, points, 2, 0, line));
  assert_string_equal(line, "computing points: 2");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_lines), cmocka_unit_test(test_short_tasks),
      cmocka_unit_test(test_unknown_end), cmocka_unit_test(test_bar)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
