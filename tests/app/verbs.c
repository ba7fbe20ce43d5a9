/* The verbs beside run: what they print, and that their JSON is JSON. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/json.h"

/* The checker itself: what it must refuse and accept. */
static void test_json_checker(void **state)
{
  (void)state;
  static const char *const good[] = {"0", " [1, -2.5e+3, \"a\\u00e9\\n\"] ", "{}",
                                     "{\"a\": {\"b\": [null, true, false]}}"};
  static const char *const bad[] = {"",        "nan",       "[1,]",     "{\"a\":1,}", "{a:1}",
                                    "01",      "1.",        "\"\t\"",   "[1] 2",      "\"a",
                                    "-",       "[1 2]",     "{\"a\"1}", "Infinity",   "'a'",
                                    "\"\\x\"", "\"\\u12\"", "[",        "+1",         ".5"};
  const char *where;
  for (size_t i = 0; i < sizeof good / sizeof good[0]; i++)
    if (!json_is_valid(good[i], &where)) fail_msg("refuses %s", good[i]);
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
    if (json_is_valid(bad[i], &where)) fail_msg("accepts %s", bad[i]);
}

static void expect_json(const char *const *arguments, const char *holds)
{
  const char *where = "";
  struct command c = command_run_list(arguments);
  if (c.code != 0) fail_msg("%s: exit %d: %s", arguments[0], c.code, c.err);
  assert_string_equal(c.err, "");
  if (!json_is_valid(c.out, &where))
    fail_msg("%s: not JSON from here on: %.60s", arguments[0], where);
  if (strstr(c.out, holds) == NULL) fail_msg("%s: no %s in %s", arguments[0], holds, c.out);
  command_release(&c);
}

static void test_json(void **state)
{
  (void)state;
  static const struct {
    const char *argument[12], *holds;
  } cases[] = {
      {{"check", "box.yaml", "--json"}, "\"area_m2\": 6,"},
      {{"forecast", "box.yaml", "--times", "--json"}, "\"culmination_utc\": \"2016-09-06T18:14:3"},
      {{"list", "materials", "--json"}, "\"name\": \"grey_white\""},
      {{"list", "materials", "grey_white", "--json"}, "\"solar_absorptance\": 0.2,"},
      {{"material", "--from-reflectance", "ratio.csv", "--json"}, "\"above_one\": 1,"},
      {{"list", "effects", "--json"}, "\"name\": \"albedo\", \"on_by_default\": true"},
      {{"list", "effects", "albedo", "--json"}, "\"parameters\": ["},
      {{"list", "sensors", "--json"}, "\"name\": \"ufo\", \"summary\": "},
      {{"list", "sensors", "ufo", "--json"}, "\"assumed\": "},
      {{"list", "filters", "--json"}, "\"name\": \"johnson_v\", \"from_um\": "},
      {{"list", "filters", "johnson_v", "--json"}, "\"vega_ab\": "},
      {{"list", "scenarios", "--json"}, "\"name\": \"hidden-effect/dawn\", \"summary\": "},
      {{"list", "scenarios", "cube", "--json"}, "\"folder\": "},
      {{"list", "keys", "--json"}, "\"start_utc\""},
      {{"list", "keys", "parts.shell", "--json"}, "\"front_share\": {\"type\": \"number\""},
      {{"list", "keys", "time.step_s", "--json"}, "{\"type\": \"number\", \"exclusiveMinimum\": 0"},
      {{"run", "box.yaml", "--out", "out", "--no-plots", "--json"}, "\"folder\": \"out\""},
      {{"run", "box.yaml", "--out", "out", "--no-plots", "--json"},
       "\"magnitude_system\": \"AB\", \"brightest_mag\": "},
      {{"map", "box.yaml", "--no-plots", "--step", "30", "--json"},
       "\"phase_angles_deg\": [0], \"nodes\": "},
      {{"cases", "box.yaml", "--no-plots", "--json"}, "\"analysis\": \"transient\", \"places\": ["},
      {{"export", "box.yaml", "--as", "mesh", "-o", "box.obj", "--json"}, "\"facets\": 12,"},
      {{"export", "box.yaml", "--as", "facets", "-o", "facets.csv", "--json"},
       "\"reached\": true, \"rounds\": [{\"facets\": 12, \"error_K\": "},
      {{"export", "box.yaml", "--as", "trajectory", "-o", "t", "--json"}, "\"step_s\": 5"},
      {{"new", "mine", "--from", "box.obj", "--json"},
       "\"folder\": \"mine\", \"name\": \"mine\", \"parts\": 1, \"start_utc\": \"2026-"},
      {{"import", "lc.csv", "--time", "t", "--magnitude", "V", "-o", "lc-measured.csv", "--json"},
       "\"quantity\": \"magnitude_vega\", \"of\": \"V\", \"channels\": 1, \"times\": \"UTC\", "
       "\"put_in_order\": true, \"without_value\": 1, \"rows_of_zeros\": 0, "
       "\"rows_held\": 0, \"rows_doubled\": 0}"},
      {{"export", "box.yaml", "--as", "exchange", "-o", "factors", "--set",
        "parts.bus.inside_emittance=0.8", "--json"},
       "\"patches_outside\": 0, \"patches_inside\": 6, \"rooms\": 1, \"poses\": 1"},
  };
  command_copy_data("box.yaml");
  command_write("ratio.csv", "wavelength_um,ratio\n0.5,0.5\n1.1,1.2\n");
  command_write("lc.csv", "t,V\n2016-09-06T18:10:00Z,7\n2016-09-06T18:09:00Z,8\n"
                          "2016-09-06T18:11:00Z,\n");
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    expect_json(cases[i].argument, cases[i].holds);
}

/* What --from-reflectance prints is a record: the program reads it and sees what was measured, half
 * of gold at 0.55 um (Olmon et al. 2012, between two nodes). */
static void test_laboratory(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_write("ratio.csv", "wavelength_um,ratio\n0.5,0.5\n0.6,0.5\n1.1,0.5\n");
  struct command c = command_run("material", "mine", "--from-reflectance", "ratio.csv", NULL);
  assert_int_equal(c.code, 0);
  command_write("mine.yaml", c.out);
  command_release(&c);
  command_expect(0, "check", "box.yaml", "--set", "material_files=[mine.yaml]", "--set",
                 "parts.bus.outside=mine", NULL);
  c = command_run("material", "a b", "--from-reflectance", "ratio.csv", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "'a b' is no name of a record"));
  command_release(&c);
  c = command_run("material", "--from-reflectance", "ratio.csv", "--reference", "golf", NULL);
  assert_non_null(strstr(c.err, "did you mean gold?"));
  command_release(&c);
  c = command_run("material", "--from-reflectance", "ratio.csv", "--angle", "90", NULL);
  assert_non_null(strstr(c.err, "--angle: '90'; accepted: 0 to below 90"));
  command_release(&c);
}

/* Names with quotes and backslashes must not break it. */
static void test_json_escapes(void **state)
{
  (void)state;
  /* a name cannot hold such characters, a folder can */
  static const char *const arguments[] = {"run",   "box.yaml", "--no-plots", "--json",
                                          "--out", "a\"b\\c",  NULL};
  command_copy_data("box.yaml");
  expect_json(arguments, "\"folder\": \"a\\\"b\\\\c\"");
}

static void expect_lines(const char *const *arguments, const char *const *holds)
{
  struct command c = command_run_list(arguments);
  assert_int_equal(c.code, 0);
  assert_string_equal(c.err, "");
  for (; *holds != NULL; holds++)
    if (strstr(c.out, *holds) == NULL) fail_msg("%s: no '%s' in\n%s", arguments[0], *holds, c.out);
  command_release(&c);
}

/* A cube of 1 m has 6 m2 and 1 m3; the pass is that of 18:14 over Graz. */
static void test_text(void **state)
{
  (void)state;
  static const struct {
    const char *argument[4], *holds[5];
  } cases[] = {
      {{"check", "box.yaml"}, {"box: 2016-09-06T18:07:00.000Z to", "6.0000      1.0000  closed"}},
      {{"forecast", "box.yaml", "--times"},
       {"7 passes above 0 deg over Graz from 2016-09-06T06:09:00.000Z to 2016-09-07T06:09",
        "culminates", "azimuth", "leaves the umbra"}},
      {{"list", "materials"}, {"grey_white", "aluminium_bare", "solar abs."}},
      {{"list", "materials", "grey_white"}, {"solar absorptance 0.2000", "hemispherical 0.8800"}},
      {{"list", "effects"}, {"albedo", "penumbra", "oblateness"}},
      {{"list", "effects", "albedo"}, {"on by default", "reference: "}},
      {{"list", "filters"}, {"johnson_v", "lsst_y", "pivot um", "Vega AB"}},
      {{"list", "filters", "johnson_v"}, {"johnson_v", "Vega AB", "curve: ", "johnson_v.csv"}},
      {{"list", "sensors"}, {"ufo", "minislr"}},
      {{"list", "sensors", "ufo"}, {"summary: ", "aperture_m: "}},
      {{"list", "scenarios"}, {"cube ", "as ESATAN-TMS", "hidden-effect/dusk ", "They lie in "}},
      {{"list", "scenarios", "cube"}, {"cube: Black 1 m cube", "umbra run ", "scenarios/cube\n"}},
      {{"list", "keys"}, {"start_utc", "areal_heat_capacity_J_m2_K"}},
      {{"list", "keys", "parts.shell"},
       {"# shell\n", "Stands at `parts.shell`", "| `front_share` |"}},
      {{"list", "keys", "parts.bus.shell"}, {"# shell\n", "| `front_share` |"}},
      {{"list", "keys", "orbit"}, {"# orbit\n", "`tle`", "Sections of it: ", "`orbit.circular`"}},
      {{"list", "keys", "orbit.circular.altitude_km"},
       {"| `altitude_km` | a finite number, at least 1, at most 1000000"}},
  };
  command_copy_data("box.yaml");
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    expect_lines(cases[i].argument, cases[i].holds);
}

#define RENDER "render", "box.yaml", "--width", "16", "--samples", "1"
#define MOMENT "--time", "2016-09-06T18:10:30Z"

static void test_failures(void **state)
{
  (void)state;
  static const struct failure cases[] = {
      {{"list", "materials", "grey_whit"}, "did you mean"},
      {{"list", "scenarios", "cub"}, "did you mean 'cube'?; accepted: blind/a, "},
      {{"list", "filters", "johnson_w"}, "did you mean 'johnson_"},
      {{"list", "keys", "parts.shel"},
       "part has no key 'shel'; did you mean 'shell'?; accepted: name, "},
      {{"list", "keys", "orbits.tle"},
       "scenario has no key 'orbits'; did you mean 'orbit'?; accepted: "},
      {{"list", "keys", "time.step_s.x"}, "'step_s' holds no keys"},
      {{"list", "keys", ""}, "scenario has no key ''; accepted: schema"},
      {{"list", "effects", "albeda"}, "did you mean 'albedo'?; accepted: albedo"},
      {{"check", "nowhere.yaml"}, "nowhere.yaml: No such file"},
      {{"forecast", "space.yaml", "--times"}, "observer.station"},
      {{RENDER, MOMENT, "--band", "vos", "-o", "a.exr"}, "did you mean 'vis'?; accepted: vis"},
      {{RENDER, "--time", "noon", "--band", "vis", "-o", "a.exr"}, "'noon'"},
      {{RENDER, MOMENT, "--band", "vis", "-o", "box.yaml"}, "box.yaml: exists"},
      {{RENDER, MOMENT, "--band", "vis", "-o", "nowhere/a.exr"}, "no such folder"},
      {{RENDER, MOMENT, "--band", "vis", "-o", "folder"}, "is not a file"},
      {{RENDER, MOMENT, "--band", "vis", "--force", "-o", "folder"}, "is not a file"},
      {{RENDER, MOMENT, "--band", "vis", "--force", "-o", "/dev/null"}, "is not a file"},
  };
  char *text = command_edit(
      command_data("box.yaml"),
      "station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}",
      "direction: {unit_gcrs: [1, 0, 0], range_km: 1000}");
  command_write("space.yaml", text);
  free(text);
  command_copy_data("box.yaml");
  assert_int_equal(mkdir("folder", 0777), 0);
  failures_expect(cases, sizeof cases / sizeof cases[0]);
}

/* The files of a map, and an attitude sought in light that was made with it. The box is lit on
 * three sides and more during its pass, so that a reduced chi-square near 1 is met; the attitude of
 * a box with six equal sides is anybody's. */
static void test_map_and_attitude(void **state)
{
  (void)state;
  static const char *const files[] = {"m/map.csv",  "m/map.exr",     "m/map.png",
                                      "m/pass.csv", "m/pass.png",    "m/measured.csv",
                                      "m/map.gp",   "a/attitude.csv"};
  command_copy_data("box.yaml");
  char *text = command_edit(command_data("box.yaml"), "- lvlh: {}",
                            "- spin: {axis_gcrs: [0, 0, 1], axis_body: [1, 0, 0], period_s: 400}");
  command_write("spin.yaml", text);
  free(text);
  command_expect(0, "synth", "spin.yaml", "--set", "time.step_s=20", "--without", "earthshine",
                 "--noise", "0.02", "--seed", "1", "-o", "m.csv", NULL);
  command_expect(0, "map", "spin.yaml", "m.csv", "--step", "30", "--phase-angles", "0,90", "--out",
                 "m", NULL);
  command_expect(0, "attitude", "spin.yaml", "m.csv", "--set", "bands.vis.bins=2", "--step", "15",
                 "--axis-step", "30", "--period", "395,405", "--solutions", "2", "--out", "a",
                 NULL);
  for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
    if (access(files[i], R_OK) != 0) fail_msg("%s is missing", files[i]);
  /* A grey box reflects the same to all sides at 0 deg (squares of three cosines add to one) and
   * more than a fifth of that at 90: no decades of colour. What lies on the map is said. */
  char *script = command_read("m/map.gp");
  assert_non_null(strstr(script, "\nunset logscale cb\n"));
  assert_non_null(strstr(script, "\nlow = 0\n"));
  assert_null(strstr(script, "\nset logscale cb\n"));
  assert_non_null(strstr(script, "'light blue: the pass; discs in white: measured"));
  free(script);
  command_expect(1, "attitude", "box.yaml", "m.csv", "--out", "b", NULL);
}

/* Standard output on a full device is a failure, not a silence. */
static void test_full_standard_output(void **state)
{
  (void)state;
  if (access("/dev/full", W_OK) != 0) {
    print_message("skipped: this system has no /dev/full\n");
    skip();
  }
  int code = system(UMBRA_PROGRAM " list materials > /dev/full 2> said");
  assert_int_equal(code, 1 << 8);
  char *said = command_read("said");
  assert_non_null(strstr(said, "umbra: standard output: "));
  assert_int_equal(command_count_lines(said), 1);
  free(said);
}

/* Cases: exit status 4 says that a limit is exceeded, 1 that there is no answer; the table stands
 * in limits.csv. */
static void test_cases(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_expect(0, "cases", "box.yaml", "--out", "good", "--set",
                 "limits.+={of: bus, minimum_K: 10, maximum_K: 900}", NULL);
  assert_true(command_exists("good/limits.csv") && command_exists("good/limits.png"));
  char *table = command_read("good/limits.csv");
  assert_non_null(strstr(table, "\nnominal,transient,bus,"));
  free(table);
  struct command c = command_run("cases", "box.yaml", "--no-plots", "--set",
                                 "limits.+={of: bus, maximum_K: 20}", NULL);
  assert_int_equal(c.code, 4);
  assert_string_equal(c.err, "");
  assert_non_null(strstr(c.out, "EXCEEDED"));
  assert_non_null(strstr(c.out, "1 of 1 limits are exceeded"));
  command_release(&c);
  command_expect(4, "cases", "box.yaml", "--no-plots", "--json", "--out", "as-json", "--set",
                 "limits.+={of: bus, minimum_K: 900}", NULL);
  command_expect(1, "cases", "box.yaml", "--no-plots", "--out", "as-json/limits.csv", NULL);
  int code = system(UMBRA_PROGRAM " cases box.yaml --no-plots --out full --set "
                                  "'limits.+={of: bus, minimum_K: 900}' > /dev/full 2> said");
  assert_int_equal(code, 1 << 8);
}

/* Does a text that begins with `from` say that a limit is exceeded? Frees it. */
static bool says_exceeded(char *text, const char *from, const char *word)
{
  const char *at = strstr(text, from);
  if (at == NULL) fail_msg("no %s in\n%s", from, text);
  bool said = strstr(at, word) != NULL;
  free(text);
  return said;
}

/* Table, JSON, picture and exit status agree whether a limit is exceeded: a place 3 K inside its
 * bound is so with an uncertainty of 4 K, which the picture shows, and not with 2 K or none. Names
 * stand in the picture as they are written. */
static void test_uncertain_limits(void **state)
{
  (void)state;
  static const struct {
    const char *uncertainty;
    double value;
    bool exceeded;
  } cases[] = {
      {"", 0.0, false}, {", uncertainty_K: 2", 2.0, false}, {", uncertainty_K: 4", 4.0, true}};
  command_copy_data("box.yaml");
  command_expect(0, "cases", "box.yaml", "--no-plots", "--out", "first", NULL);
  char *csv = command_read("first/limits.csv");
  const char *row = strstr(csv, "\nnominal,transient,bus,");
  double mean, lowest, highest;
  assert_int_equal(
      sscanf(row, "\nnominal,transient,bus,%lf,%lf,%lf,,,,,", &mean, &lowest, &highest), 3);
  /* no limit, no uncertainty of one */
  char *end = strchr(row + 1, '\n');
  *end = '\0';
  assert_string_equal(end - 5, ",,,,,");
  free(csv);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char set[160], bar[200];
    snprintf(set, sizeof set, "limits.+={of: bus, minimum_K: 10, maximum_K: %.9g%s}", highest + 3.0,
             cases[i].uncertainty);
    const char *const plain[] = {"cases", "box.yaml", "--out",
                                 "out",   "--force",  "--set",
                                 set,     "--set",    "cases={hot_case: {}}",
                                 NULL};
    const char *const json[] = {
        "cases", "box.yaml", "--json", "--no-plots",           "--out", "out", "--force",
        "--set", set,        "--set",  "cases={hot_case: {}}", NULL};
    struct command c = command_run_list(json);
    assert_int_equal(c.code, cases[i].exceeded ? 4 : 0);
    snprintf(bar, sizeof bar, "\"uncertainty_K\": %g, ", cases[i].value);
    assert_non_null(strstr(c.out, bar));
    assert_true(says_exceeded(strdup(c.out), "\"name\": \"bus\"", "\"exceeded\": true") ==
                cases[i].exceeded);
    command_release(&c);
    c = command_run_list(plain);
    assert_int_equal(c.code, cases[i].exceeded ? 4 : 0);
    assert_true(says_exceeded(strdup(c.out), "\nbus ", "EXCEEDED\n") == cases[i].exceeded);
    command_release(&c);
    char *script = command_read("out/limits.gp"), *bars = strstr(script, "\n$bars << EOD\n");
    double drawn[7];
    assert_non_null(bars);
    assert_int_equal(sscanf(bars, "\n$bars << EOD\n%lf,%lf,%lf,%lf,%lf,%lf,%lf\n", &drawn[0],
                            &drawn[1], &drawn[2], &drawn[3], &drawn[4], &drawn[5], &drawn[6]),
                     7);
    assert_true(fabs(drawn[5] - highest - 3.0) < 1e-3 && fabs(drawn[3] - highest) < 2.0);
    assert_true(fabs(drawn[6] - cases[i].value) < 1e-4);
    snprintf(bar, sizeof bar, "set label '%.2f K%s' at graph 1.01,", 3.0 - cases[i].value,
             cases[i].exceeded ? " EXCEEDED" : "");
    assert_non_null(strstr(script, bar));
    assert_non_null(strstr(script, "($3-$7):($4+$7)"));
    assert_non_null(strstr(script, "\nset key noenhanced\n"));
    free(script);
  }
}

/* Exchange: what is written is taken in again, and refused by another satellite. */
static void test_exchange(void **state)
{
  (void)state;
  static const char *const inside = "parts.bus.inside_emittance=0.8";
  static const char *const taken = "thermal.view_factors=factors";
  command_copy_data("box.yaml");
  command_expect(0, "export", "box.yaml", "--as", "exchange", "--out", "factors", "--set", inside,
                 NULL);
  assert_true(command_exists("factors/outside.csv") && command_exists("factors/inside-bus.csv"));
  char *table = command_read("factors/couplings.csv");
  assert_non_null(strstr(table, "\n0,0,1,"));
  assert_non_null(strstr(table, ",bus.+x.inside,bus.-x.inside\n"));
  free(table);
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "rays", "--set", inside, NULL);
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "file", "--set", inside, "--set",
                 taken, NULL);
  char *rays = command_read("rays/temperatures.csv"), *file = command_read("file/temperatures.csv");
  assert_string_equal(rays, file);
  free(file);
  /* kept by a first run, taken by a second */
  assert_int_equal(setenv("UMBRA_CACHE", "cache", 1), 0);
  for (int k = 0; k < 2; k++) {
    command_expect(0, "run", "box.yaml", "--no-plots", "--out", "kept", "--set", inside, NULL);
    file = command_read("kept/temperatures.csv");
    assert_string_equal(rays, file);
    free(file);
  }
  assert_int_equal(unsetenv("UMBRA_CACHE"), 0);
  assert_true(command_exists("cache"));
  free(rays);
  struct command c = command_run("run", "box.yaml", "--no-plots", "--set", inside, "--set", taken,
                                 "--set", "parts.bus.box.size_m=[1, 1, 1.5]", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "thermal.view_factors: "));
  assert_non_null(strstr(c.err, "made of another satellite: shapes or places differ"));
  command_release(&c);
}

/* A satellite that counts something twice: said with names and areas by what reads it, in the log
 * of its run too; two boxes that touch say nothing. */
static void test_counted_twice(void **state)
{
  (void)state;
  static const char twin[] = "parts:\n  - name: twin\n    box: {size_m: [1, 1, 1]}\n"
                             "    outside: black\n    lumped: true\n"
                             "    shell: {areal_heat_capacity_J_m2_K: 3000}\n"
                             "    pose: {position_m: [AT, 0, 0]}\n";
  static const char *const at[] = {"0", "0.5", "1"};
  static const char *const says[] = {
      "parts twin and bus have 6 m2 of surfaces in one place that look the same way",
      "parts twin and bus have 2 m2 of surfaces in one place that look the same way", NULL};
  for (int i = 0; i < 3; i++) {
    char *text = command_edit(command_data("box.yaml"), "parts:\n", twin);
    text = command_edit(text, "AT", at[i]);
    command_write("twin.yaml", text);
    free(text);
    struct command c = command_run("check", "twin.yaml", NULL);
    assert_int_equal(c.code, 0);
    assert_true(says[i] == NULL ? strstr(c.err, "in one place") == NULL
                                : strstr(c.err, says[i]) != NULL);
    command_release(&c);
    if (i > 0) continue;
    command_expect(0, "run", "twin.yaml", "--no-plots", "--out", "twin", NULL);
    char *log = command_read("twin/log.txt");
    assert_non_null(strstr(log, says[0]));
    free(log);
  }
  /* four boxes in one place are six pairs, of which five are named */
  static const char *const name[] = {"twin", "third", "fourth"};
  char *four = command_data("box.yaml");
  for (int i = 0; i < 3; i++) {
    four = command_edit(four, "parts:\n", twin);
    four = command_edit(command_edit(four, "AT", "0"), "name: twin", "name: NEXT");
    four = command_edit(four, "NEXT", name[i]);
  }
  command_write("four.yaml", four);
  free(four);
  struct command of_four = command_run("check", "four.yaml", NULL);
  assert_int_equal(of_four.code, 0);
  assert_non_null(strstr(of_four.err, "so have 1 more pairs of parts, 6 m2 together"));
  command_release(&of_four);
  /* two tetrahedra in one mesh, legs of 1 m and 2 m: (3 + sqrt 3)/2 m2 and four times that */
  command_write("two.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 7 0 0\nv 5 2 0\nv 5 0 2\n"
                "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
                "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
  char *text = command_edit(command_data("box.yaml"), "box: {size_m: [1, 1, 1]}",
                            "mesh: {file: two.obj}\n    interior: {capacity_J_K: 900, "
                            "power_W: 1, conductance_W_K: 1}");
  command_write("two.yaml", text);
  free(text);
  struct command c = command_run("check", "two.yaml", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.err, "part bus: its mesh holds 2 bodies that do not touch, of 2.366, "
                                "9.464 m2: they share its interior"));
  command_release(&c);
}

/* An old name does what the new one does, with the same words on standard output, and says the new
 * one on a line of its own; the help has the new one alone, on the page of either. */
static void test_old_names(void **state)
{
  (void)state;
  static const struct {
    const char *old[8], *now[8], *says;
  } cases[] = {
      {{"materials"}, {"list", "materials"}, "umbra materials is now umbra list materials;"},
      {{"materials", "grey_white", "--json"},
       {"list", "materials", "grey_white", "--json"},
       "umbra materials is now umbra list materials;"},
      {{"materials", "mine", "--from-reflectance", "ratio.csv"},
       {"material", "mine", "--from-reflectance", "ratio.csv"},
       "umbra materials is now umbra material;"},
      {{"filters", "--json"}, {"list", "filters", "--json"}, "umbra filters is now umbra list "},
      {{"sensors", "ufo"}, {"list", "sensors", "ufo"}, "umbra sensors is now umbra list sensors;"},
      {{"effects", "albedo"}, {"list", "effects", "albedo"}, "umbra effects is now umbra list "},
      {{"schema", "time"}, {"list", "keys", "time"}, "umbra schema is now umbra list keys;"},
      {{"passes", "box.yaml", "--json"},
       {"forecast", "box.yaml", "--times", "--json"},
       "umbra passes is now umbra forecast --times;"},
      {{"frame", "--help"}, {"render", "--help"}, "umbra frame is now umbra render;"},
      {{"expand", "--help"}, {"render", "--help"}, "umbra expand is now umbra render;"},
      {{"help", "effects"}, {"help", "list"}, NULL},
      {{"effects", "--help"}, {"list", "--help"}, "umbra effects is now umbra list effects;"},
  };
  command_copy_data("box.yaml");
  command_write("ratio.csv", "wavelength_um,ratio\n0.5,0.5\n0.6,0.5\n1.1,0.5\n");
  struct command help = command_run("--help", NULL);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct command a = command_run_list(cases[i].old), b = command_run_list(cases[i].now);
    char listed[64];
    assert_int_equal(a.code, 0);
    assert_int_equal(b.code, 0);
    assert_string_equal(a.out, b.out);
    assert_string_equal(b.err, "");
    if (cases[i].says != NULL) {
      assert_int_equal(command_count_lines(a.err), 1);
      if (strstr(a.err, cases[i].says) == NULL ||
          strstr(a.err, "; the old name works until version 0.6\n") == NULL)
        fail_msg("no '%s' in\n%s", cases[i].says, a.err);
      snprintf(listed, sizeof listed, "  umbra %s ", cases[i].old[0]);
      assert_null(strstr(help.out, listed));
    }
    command_release(&a);
    command_release(&b);
  }
  command_release(&help);
}

/* Verbs stand in groups by what a user does, behind the usual way. */
static void test_groups(void **state)
{
  (void)state;
  static const char *const order[] = {"\nThe usual way:\n",   "  umbra new NAME ",
                                      "  umbra run NAME ",    "  umbra compare SCENARIO MEASURED ",
                                      "\nSimulate:\n",        "\n  umbra run  ",
                                      "\n  umbra check  ",    "\nObserve:\n",
                                      "\n  umbra forecast  ", "\n  umbra render  ",
                                      "\nCompare:\n",         "\n  umbra compare  ",
                                      "\n  umbra diagnose  ", "\nExplore:\n",
                                      "\n  umbra study  ",    "\n  umbra sensitivity  ",
                                      "\nLook up:\n",         "\n  umbra list  ",
                                      "\n  umbra help  "};
  struct command c = command_run("--help", NULL);
  const char *at = c.out;
  for (size_t i = 0; i < sizeof order / sizeof order[0]; i++) {
    const char *next = strstr(at, order[i]);
    if (next == NULL) fail_msg("no '%s' behind\n%s", order[i], at);
    at = next;
  }
  for (const char *line = c.out; *line != '\0'; line += strcspn(line, "\n") + 1)
    assert_true(strcspn(line, "\n") <= 80);
  command_release(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_old_names, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_groups, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_exchange, command_enter, command_leave),
      cmocka_unit_test(test_json_checker),
      cmocka_unit_test_setup_teardown(test_json, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_json_escapes, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_laboratory, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_text, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_failures, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_cases, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_counted_twice, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_uncertain_limits, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_map_and_attitude, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_full_standard_output, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
