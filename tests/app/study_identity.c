/* Points on record are of one program, one set of files, one set of questions: with other bytes in
 * any of them neither a study nor a forecast goes on, and says which; with the same it does. And
 * what a record holds is looked at, though its checksum is right. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/command.h"

static const char scenario[] =
    "schema: 1\n"
    "name: two\n"
    "time: {start_utc: 2016-09-06T18:10:00Z, stop_utc: 2016-09-06T18:12:00Z, step_s: 60}\n"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude:\n"
    "  - table: {file: turns.csv, max_gap_s: 200000}\n"
    "observer: {station: {name: Graz, latitude_deg: 47, longitude_deg: 15, height_m: 495}}\n"
    "material_files: [paint.yaml]\n"
    "effect_files: [pileup.so]\n"
    "parts:\n"
    "  - {name: a, mesh: a.obj, outside: paint, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: b, mesh: b.obj, outside: grey_white, lumped: true, pose: {position_m: [3, 0, 0]},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "thermal: {start: isothermal, orbits_before: 0.05, step_s: 30}\n"
    "bands:\n"
    "  vis: {filter_file: vis.csv, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

static const char study[] = "schema: 1\n"
                            "name: st\n"
                            "scenario: two.yaml\n"
                            "parameters:\n"
                            "  - {effect: pileup, target: vis, from: -1e9, to: -1e8}\n"
                            "outputs: {bands: [vis, lwir], places: [a]}\n"
                            "design: {kind: sobol, points: 4}\n";

static const char corner[] = "v 0 0 0\nv %s 0 0\nv 0 1 0\nv 0 0 1\n"
                             "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

static void copy(const char *from, const char *to, const char *more)
{
  size_t n, m = strlen(more);
  char *bytes = command_read_bytes(from, &n), *longer = realloc(bytes, n + m + 1);
  assert_non_null(longer);
  memcpy(longer + n, more, m + 1);
  command_write_bytes(to, longer, n + m);
  free(longer);
}

static int enter(void **state)
{
  char text[200];
  if (command_enter(state) != 0) return -1;
  command_write("two.yaml", scenario);
  command_write("st.yaml", study);
  for (int i = 0; i < 2; i++) {
    snprintf(text, sizeof text, corner, i == 0 ? "1" : "2");
    command_write(i == 0 ? "a.obj" : "b.obj", text);
  }
  command_write("vis.csv", "wavelength_um,transmission\n0.4,1\n0.7,1\n");
  command_write("turns.csv", "time_utc,q0,q1,q2,q3\n2016-09-06T16:00:00Z,1,0,0,0\n"
                             "2016-09-08T00:00:00Z,1,0,0,0\n");
  copy(UMBRA_SOURCE_DIR "/materials/library/grey_white.yaml", "paint.yaml", "");
  char *paint = command_edit(command_read("paint.yaml"), "name: grey_white", "name: paint");
  command_write("paint.yaml", paint);
  free(paint);
  copy(PILEUP, "pileup.so", "");
  return 0;
}

#define STUDY "study", "st.yaml", "--threads", "1", "--allow-effects", "-o", "o"
#define FORECAST                                                                                   \
  "forecast", "two.yaml", "--days", "0.3", "--threads", "1", "--set", "time.step_s=60",            \
      "--allow-effects", "-o", "o", "--no-plots"

static const char *const verb[2][16] = {{STUDY, "--share", "1/2", NULL},
                                        {FORECAST, "--share", "1/2", NULL}};
static const char *const resume[2][16] = {{STUDY, "--resume", NULL}, {FORECAST, "--resume", NULL}};

/* Nothing is lost, nothing is added, and the message says what and how to go on. */
static void expect_refused(const char *const *arguments, const char *folder, const char *says)
{
  char *before = command_snapshot(folder);
  struct command c = command_run_list(arguments);
  assert_int_equal(c.code, 1);
  if (strstr(c.err, says) == NULL) fail_msg("'%s' is not in: %s", says, c.err);
  if (strncmp(c.err, "umbra: o.", 9) != 0) fail_msg("%s", c.err);
  assert_non_null(strstr(c.err, "; accepted: that as it was, or another -o, or this folder"));
  assert_int_equal(command_count_lines(c.err), 1);
  command_release(&c);
  char *after = command_snapshot(folder);
  assert_string_equal(before, after);
  free(before);
  free(after);
}

static void run_and_release(const char *const *arguments)
{
  struct command c = command_run_list(arguments);
  if (c.code != 0) fail_msg("it said: %s", c.err);
  command_release(&c);
}

/* Every file of the model, one after another with another last byte or two; of a forecast two. */
static void test_files(void **state)
{
  (void)state;
  static const struct {
    const char *path, *more;
  } files[] = {{"pileup.so", "\n"}, {"a.obj", "\n"},     {"paint.yaml", "# x\n"},
               {"vis.csv", "\n"},   {"turns.csv", "\n"}, {"two.yaml", "# x\n"}};
  for (int v = 0; v < 2; v++) {
    const char *folder = v == 0 ? "o.points" : "o.records";
    run_and_release(verb[v]);
    for (size_t i = 0; i < (v == 0 ? sizeof files / sizeof *files : 2); i++) {
      char says[80];
      copy(files[i].path, "kept", "");
      assert_int_equal(unlink(files[i].path), 0);
      copy("kept", files[i].path, files[i].more);
      snprintf(says, sizeof says, "/%s has other bytes than when this was computed", files[i].path);
      expect_refused(resume[v], folder, says);
      assert_int_equal(rename("kept", files[i].path), 0);
    }
    /* the bytes of two files are in each other's place: their sum is what it was */
    assert_int_equal(rename("a.obj", "kept"), 0);
    assert_int_equal(rename("b.obj", "a.obj"), 0);
    assert_int_equal(rename("kept", "b.obj"), 0);
    expect_refused(resume[v], folder, ".obj has other bytes");
    assert_int_equal(rename("a.obj", "kept"), 0);
    assert_int_equal(rename("b.obj", "a.obj"), 0);
    assert_int_equal(rename("kept", "b.obj"), 0);
    run_and_release(resume[v]); /* all as it was */
    assert_true(command_exists("o/.umbra"));
    assert_false(command_exists(folder));
    assert_int_equal(system("rm -r o"), 0);
  }
}

/* What is asked counts as well; more points of the same do not make them others. */
static void test_asked(void **state)
{
  (void)state;
  run_and_release(verb[0]);
  const char *const set[] = {STUDY, "--resume", "--set", "parts.b.pose.position_m=[4, 0, 0]", NULL};
  expect_refused(set, "o.points", "the changes by --set are others");
  const char *const without[] = {STUDY, "--resume", "--without", "albedo", NULL};
  expect_refused(without, "o.points", "the effects of --with and --without are others");
  char *text = command_read("st.yaml");
  command_write("st.yaml", text = command_edit(text, "places: [a]", "places: [b]"));
  expect_refused(resume[0], "o.points", "the study's outputs are others");
  text = command_edit(text, "places: [b]", "places: [a]");
  command_write("st.yaml", text = command_edit(text, "points: 4", "points: 5"));
  free(text);
  run_and_release(resume[0]);
  text = command_read("o/points.csv");
  assert_int_equal(command_count_lines(text), 6);
  free(text);
}

/* A rebuilt program is another one, though its version is the same; the same program with the same
 * files in other folders, as another machine has them, is not. */
static void test_program(void **state)
{
  (void)state;
  static const char command[] = "UMBRA_DATA=data ./other study moved/st.yaml --allow-effects "
                                "-o o --resume >said 2>&1";
  copy(UMBRA_PROGRAM, "other", "");
  assert_int_equal(chmod("other", 0755), 0);
  assert_int_equal(mkdir("data", 0755), 0);
  assert_int_equal(symlink(UMBRA_SOURCE_DIR "/materials/library", "data/materials"), 0);
  run_and_release(verb[0]);
  assert_int_equal(system("mkdir moved && mv *.yaml *.obj *.csv *.so moved"), 0);
  copy("other", "others", "\n");
  assert_int_equal(chmod("others", 0755), 0);
  char *rebuilt = command_edit(strdup(command), "./other", "./others"), *said;
  for (int share = 0; share < 2; share++) { /* another share of the same points is refused, too */
    char *before = command_snapshot("o.points"), *after;
    assert_int_not_equal(system(rebuilt), 0);
    said = command_read("said");
    assert_non_null(strstr(said, "o.points: the program has other bytes than when this was"));
    free(said);
    after = command_snapshot("o.points");
    assert_string_equal(before, after);
    free(before);
    free(after);
    if (share == 0) rebuilt = command_edit(rebuilt, "--resume", "--share 2/2");
  }
  free(rebuilt);
  int code = system(command);
  said = command_read("said");
  if (code != 0) fail_msg("it said: %s", said);
  free(said);
  assert_true(command_exists("o/points.csv"));
}

/* CRC-32 of ISO 3309, bit by bit. */
static uint32_t checksum(const unsigned char *byte, size_t n)
{
  uint32_t crc = 0xffffffffu;
  for (size_t i = 0; i < n; i++) {
    crc ^= byte[i];
    for (int k = 0; k < 8; k++) crc = crc & 1u ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  return ~crc;
}

/* In the i-th record of a file one value is another, and the checksum that of the new bytes. */
struct forgery {
  size_t at;
  double value;
};
static void forge(const char *path, const struct forgery *f, size_t n)
{
  size_t length;
  char *bytes = command_read_bytes(path, &length);
  uint64_t count[2]; /* coordinates, values: behind magic, order and identity */
  memcpy(count, bytes + 24, sizeof count);
  size_t begin = 48, size = 8 + 8 * (size_t)(count[0] + count[1]) + 4;
  assert_true(length >= begin + n * size);
  for (size_t i = 0; i < n; i++) {
    char *record = bytes + begin + i * size;
    uint32_t crc = checksum((unsigned char *)record, size - 4), kept;
    memcpy(&kept, record + size - 4, 4);
    assert_int_equal(crc, kept);
    assert_true(f[i].at < count[1]);
    memcpy(record + 8 + 8 * (count[0] + f[i].at), &f[i].value, 8);
    crc = checksum((unsigned char *)record, size - 4);
    memcpy(record + size - 4, &crc, 4);
  }
  command_write_bytes(path, bytes, length);
  free(bytes);
}

static void expect_made_anew(const char *const *arguments, const char *says)
{
  struct command c = command_run_list(arguments);
  assert_int_equal(c.code, 0);
  if (strstr(c.err, says) == NULL) fail_msg("'%s' is not in: %s", says, c.err);
  command_release(&c);
}

static void test_forged_study(void **state)
{
  (void)state;
  /* three instants of light in two bands, then of a temperature */
  static const struct forgery bad[] = {{6, (double)NAN}, {7, -5.0},
                                       {8, 0.0},         {6, (double)INFINITY},
                                       {0, (double)NAN}, {2, (double)INFINITY},
                                       {3, -1e-12},      {4, (double)-INFINITY}};
  static const char *const files[] = {"study.nc", "points.csv", NULL};
  command_write("st.yaml",
                "schema: 1\nname: st\nscenario: two.yaml\nparameters:\n"
                "  - {key: parts.a.shell.areal_heat_capacity_J_m2_K, from: 2000, to: 4000}\n"
                "outputs: {bands: [vis, lwir], places: [a]}\ndesign: {kind: sobol, points: 16}\n");
  const char *const whole[] = {"study", "st.yaml", "--allow-effects", "-o", "whole", NULL};
  run_and_release(whole);
  run_and_release(verb[0]);
  forge("o.points/points-1-of-2.records", bad, 8);
  expect_made_anew(resume[0], "o.points: 8 points on record hold values that no computation gives");
  command_expect_same("whole", "o", files);
}

static void test_forged_forecast(void **state)
{
  (void)state;
  /* the delay, two bands of eight numbers, two places of three, then curves of sixty: times,
   * magnitude, irradiance */
  static const struct forgery bad[] = {{1 + 16 + 3, -5.0}, {1 + 16 + 6 + 2 * 60 + 59, -1e-9}};
  static const char *const files[] = {"passes.csv", "curves.csv", NULL};
  const char *const whole[] = {FORECAST, "-o", "whole", NULL};
  run_and_release(whole);
  run_and_release(verb[1]);
  forge("o.records/points-1-of-2.records", bad, 2);
  expect_made_anew(resume[1],
                   "o.records: 2 points on record hold values that no computation gives");
  command_expect_same("whole", "o", files);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, command_leave)
  const struct CMUnitTest tests[] = {TEST(test_files), TEST(test_asked), TEST(test_program),
                                     TEST(test_forged_study), TEST(test_forged_forecast)};
  return cmocka_run_group_tests_name("study_identity", tests, NULL, NULL);
}
