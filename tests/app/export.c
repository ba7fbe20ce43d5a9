/* umbra export: what is written is taken in again, and refused without a trace. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/table.h"

static void expect_in(const char *text, const char *holds)
{
  if (strstr(text, holds) == NULL) fail_msg("no '%s' in:\n%s", holds, text);
}

/* The template's mesh, through umbra new, has its parts, groups, areas, volume and materials of
 * fronts; the panels' backs are the front's, as a mesh names one material. */
static void test_mesh(void **state)
{
  (void)state;
  command_expect(0, "new", "mine", NULL);
  struct command c = command_run("export", "mine", "--as", "mesh", "-o", "mine.obj", NULL);
  assert_int_equal(c.code, 0);
  assert_string_equal(c.out, "mine.obj: 396 triangles of 3 parts\n");
  command_release(&c);
  char *text = command_read("mine.obj");
  expect_in(text,
            "\no panel_left\ng panel_left.plate\nusemtl cell_triple_junction\n# back: cfrp\n");
  expect_in(text, "\ng body.+z\nusemtl white_paint\n");
  free(text);
  command_expect(0, "new", "again", "--from", "mine.obj", NULL);
  text = command_read("again/scenario.yaml");
  expect_in(text, "- name: \"body\"\n    mesh: {file: \"mine.obj\", scale: 1, groups: [\"body.");
  expect_in(text, "\"body.-z\": cell_triple_junction\n");
  expect_in(text, "\"panel_right.plate\": {front: cell_triple_junction,");
  free(text);
  c = command_run("check", "again", NULL);
  expect_in(c.out, "0.1562      0.0034  closed\npanel_left ");
  expect_in(c.out, "0.0288           -  open\n");
  expect_in(c.out, "white_paint                     0.0340 ");
  expect_in(c.out, "aluminium_anodised              0.0881 ");
  command_release(&c);
}

/* A run with the tables in place of elements and law has the same geometry in its table to the
 * digits that are printed, and heat that agrees to its tolerance. */
static void test_trajectory(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_expect(0, "export", "box.yaml", "--as", "trajectory", "-o", "t", NULL);
  char *text = command_data("box.yaml");
  char *orbit = strstr(text, "orbit:\n"), *observer = strstr(text, "observer:\n");
  assert_true(orbit != NULL && observer != NULL && orbit < observer);
  char *made = calloc(strlen(text) + 200, 1);
  assert_non_null(made);
  memcpy(made, text, (size_t)(orbit - text));
  strcat(made, "orbit: {table: t/orbit.csv}\nattitude: [{table: t/attitude.csv}]\n");
  strcat(made, observer);
  command_write("flown.yaml", made);
  free(made);
  free(text);
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "a", NULL);
  command_expect(0, "run", "flown.yaml", "--no-plots", "--out", "b", NULL);
  struct table a = table_read("a/lightcurve.csv"), b = table_read("b/lightcurve.csv");
  assert_int_equal(a.nrow, b.nrow);
  for (size_t i = 0; i < a.nrow; i++) {
    /* 1 cm of SGP4 between the rows, of 800 km */
    assert_true(fabs(table_number(&a, i, "range_km") - table_number(&b, i, "range_km")) < 2e-5);
    assert_true(fabs(table_number(&a, i, "phase_angle_deg") -
                     table_number(&b, i, "phase_angle_deg")) < 2e-6);
  }
  table_release(&a);
  table_release(&b);
  a = table_read("a/temperatures.csv");
  b = table_read("b/temperatures.csv");
  for (size_t i = 0; i < a.nrow; i++)
    assert_true(fabs(table_number(&a, i, "bus.mean_K") - table_number(&b, i, "bus.mean_K")) < 0.02);
  table_release(&a);
  table_release(&b);
}

/* Magnitudes go out and come in again, band by band a track of its own; lightcurve.csv, which they
 * are held against, has nine digits. */
static void test_tracking_message(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "run", NULL);
  command_expect(0, "export", "box.yaml", "--as", "tdm", "-o", "box.tdm", NULL);
  command_expect(0, "import", "box.tdm", "--time", "time_utc", "--magnitude", "MAG", "--track",
                 "track", "--band", "vis", "--system", "vega", "-o", "m.csv", NULL);
  char *text = command_read("m.csv"); /* its first line is a comment */
  command_write("rows.csv", strchr(text, '\n') + 1);
  free(text);
  struct table light = table_read("run/lightcurve.csv"), m = table_read("rows.csv");
  size_t seen = 0;
  for (size_t i = 0; i < light.nrow; i++) {
    if (table_text(&light, i, "vis_mag_vega")[0] == '\0') continue;
    assert_string_equal(table_text(&m, 2 * seen, "time_utc"), table_text(&light, i, "time_utc"));
    assert_true(
        fabs(table_number(&m, 2 * seen, "value") - table_number(&light, i, "vis_mag_vega")) < 6e-8);
    seen++;
  }
  assert_true(seen > 1 && m.nrow == 2 * seen);
  table_release(&light);
  table_release(&m);
}

/* The old name writes the same files and says on one line what it is called now. */
static void test_old_name(void **state)
{
  (void)state;
  static const char *const inside = "parts.bus.inside_emittance=0.8";
  command_copy_data("box.yaml");
  command_expect(0, "export", "box.yaml", "--as", "exchange", "-o", "new", "--set", inside, NULL);
  struct command c = command_run("exchange", "box.yaml", "--out", "old", "--set", inside, NULL);
  assert_int_equal(c.code, 0);
  assert_string_equal(c.err, "umbra exchange is now umbra export --as=exchange; the old name works "
                             "until version 0.6\n");
  command_release(&c);
  /* which say when they were written, and of what */
  assert_int_equal(remove("new/replay.json"), 0);
  assert_int_equal(remove("old/replay.json"), 0);
  char *a = command_snapshot("new"), *b = command_snapshot("old");
  for (char *at; (at = strstr(b, "old/")) != NULL;) memcpy(at, "new/", 4);
  assert_string_equal(a, b);
  free(a);
  free(b);
}

static void test_refusals(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_write("there.obj", "mine\n");
  static const struct failure failures[] = {
      {{"export", "box.yaml", "--as", "meshes", "-o", "x"},
       "--as meshes: unknown; did you mean 'mesh'?; accepted: exchange, facets, mesh, network, "
       "sky, tdm, temperatures, trajectory, vtu"},
      {{"export", "box.yaml", "--as", "mesh", "-o", "there.obj"},
       "there.obj: exists; accepted: a new name, or --force"},
      {{"export", "box.yaml", "--as", "mesh", "-o", "x.stl"},
       "x.stl: no '.stl' is written here; accepted: a name in .obj"},
      {{"export", "none.yaml", "--as", "mesh", "-o", "x.obj"}, "none.yaml: No such file"},
      {{"export", "box.yaml", "--as", "trajectory", "-o", "there.obj"},
       "there.obj: exists and is not a folder"},
      {{"export", "box.yaml", "--as", "trajectory", "-o", "x", "--set",
        "thermal.orbits_before=9999"},
       "rows every 5 s; accepted: at most 2e+06"},
  };
  failures_expect(failures, sizeof failures / sizeof failures[0]);
  command_expect(2, "export", "box.yaml", "--as", "mesh", NULL);
  command_expect(2, "export", "box.yaml", "-o", "x", NULL);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_mesh, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_tracking_message, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_trajectory, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_old_name, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refusals, command_enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
