/* The same inputs give the same bytes, for any number of threads; an effect that is switched
 * changes what it stands for and nothing else. */
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

static const char *const tables[] = {"lightcurve.csv", "materials.csv", "temperatures.csv",
                                     "heat.csv", "temperatures.cic"};

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  command_copy_data("two_parts.yaml");
  return 0;
}

static bool same_file(const char *a, const char *b, const char *name)
{
  char path[64];
  size_t na, nb;
  snprintf(path, sizeof path, "%s/%s", a, name);
  char *ta = command_read_bytes(path, &na);
  snprintf(path, sizeof path, "%s/%s", b, name);
  char *tb = command_read_bytes(path, &nb);
  bool same = na == nb && memcmp(ta, tb, na) == 0;
  free(ta);
  free(tb);
  return same;
}

#define NC(call) assert_int_equal(call, NC_NOERR)

/* The texts behind pointers, each with its zero; frees the pointers. */
static char *texts_of(char *pointers, size_t *length)
{
  size_t n = *length / sizeof(char *);
  char **text = (char **)(void *)pointers;
  *length = 0;
  for (size_t i = 0; i < n; i++) *length += strlen(text[i]) + 1;
  char *all = calloc(*length + 1, 1), *to = all;
  assert_non_null(all);
  for (size_t i = 0; i < n; i++) {
    strcpy(to, text[i]);
    to += strlen(text[i]) + 1;
  }
  NC(nc_free_string(n, text));
  free(pointers);
  return all;
}

/* All bytes of a variable; the caller frees. */
static char *variable_bytes(int file, int v, size_t *length)
{
  nc_type type;
  int ndim, dimension[NC_MAX_VAR_DIMS];
  NC(nc_inq_var(file, v, NULL, &type, &ndim, dimension, NULL));
  NC(nc_inq_type(file, type, NULL, length));
  for (int i = 0; i < ndim; i++) {
    size_t n;
    NC(nc_inq_dimlen(file, dimension[i], &n));
    *length *= n;
  }
  char *bytes = calloc(*length + 1, 1);
  assert_non_null(bytes);
  NC(nc_get_var(file, v, bytes));
  return type == NC_STRING ? texts_of(bytes, length) : bytes;
}

static void expect_same_variables(const char *a, const char *b)
{
  int fa, fb, na, nb;
  char path[64], name[NC_MAX_NAME + 1];
  snprintf(path, sizeof path, "%s/run.nc", a);
  NC(nc_open(path, NC_NOWRITE, &fa));
  snprintf(path, sizeof path, "%s/run.nc", b);
  NC(nc_open(path, NC_NOWRITE, &fb));
  NC(nc_inq_nvars(fa, &na));
  NC(nc_inq_nvars(fb, &nb));
  assert_int_equal(na, nb);
  for (int v = 0; v < na; v++) {
    int w;
    size_t la, lb;
    NC(nc_inq_varname(fa, v, name));
    NC(nc_inq_varid(fb, name, &w));
    char *ba = variable_bytes(fa, v, &la), *bb = variable_bytes(fb, w, &lb);
    if (la != lb || memcmp(ba, bb, la) != 0) fail_msg("%s differs in %s and %s", name, a, b);
    free(ba);
    free(bb);
  }
  NC(nc_close(fa));
  NC(nc_close(fb));
}

static void expect_same(const char *a, const char *b)
{
  for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++)
    if (!same_file(a, b, tables[i])) fail_msg("%s differs in %s and %s", tables[i], a, b);
  expect_same_variables(a, b);
}

#define RUN(scenario, out, ...)                                                                    \
  command_expect(0, "run", scenario, "--no-plots", "--out", out, __VA_ARGS__, NULL)

static void same_for_threads(const char *scenario)
{
  RUN(scenario, "one", "--threads", "1");
  RUN(scenario, "two", "--threads", "2");
  RUN(scenario, "three", "--threads", "3");
  RUN(scenario, "again", "--threads", "2");
  expect_same("one", "two");
  expect_same("one", "three");
  expect_same("two", "again");
}

static void test_threads_box(void **state)
{
  (void)state;
  same_for_threads("box.yaml");
}

/* Shadows of the parts on each other and light between them are sampled by rays. */
static void test_threads_two_parts(void **state)
{
  (void)state;
  same_for_threads("two_parts.yaml");
}

/* A periodic start iterates; it must do so alike. */
static void test_threads_periodic(void **state)
{
  (void)state;
  char *text = command_edit(command_data("two_parts.yaml"), "start: isothermal", "start: periodic");
  text = command_edit(text, "step_s: 10", "step_s: 60");
  command_write("two_parts.yaml", text);
  free(text);
  RUN("two_parts.yaml", "one", "--threads", "1");
  RUN("two_parts.yaml", "two", "--threads", "2");
  expect_same("one", "two");
}

static void test_picture(void **state)
{
  (void)state;
#define RENDER                                                                                     \
  "render", "two_parts.yaml", "--time", "2016-09-06T18:10:30Z", "--width", "24", "--band"
  size_t n[2];
  command_expect(0, RENDER, "vis", "-o", "a.exr", "--threads", "1", NULL);
  command_expect(0, RENDER, "vis", "-o", "b.exr", "--threads", "2", NULL);
  char *a = command_read_bytes("a.exr", &n[0]), *b = command_read_bytes("b.exr", &n[1]);
  assert_int_equal(n[0], n[1]);
  assert_memory_equal(a, b, n[0]);
  free(a);
  free(b);
}

/* Switching on what is on by default, or listing it in the scenario, changes no byte. */
static void test_effect_on_is_default(void **state)
{
  (void)state;
  static const char *const names[] = {"albedo",   "earth_ir",  "earthshine", "reflected_earth_ir",
                                      "penumbra", "oblateness"};
  RUN("box.yaml", "default", "--threads", "2");
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    RUN("box.yaml", "with", "--with", names[i]);
    expect_same("default", "with");
  }
  char *text =
      command_edit(command_data("box.yaml"),
                   "bands:", "effects: [{effect: albedo}, {effect: penumbra, off: false}]\nbands:");
  command_write("listed.yaml", text);
  free(text);
  RUN("listed.yaml", "listed", "--threads", "2");
  expect_same("default", "listed");
  /* off in the scenario and off on the command line are the same; the command line wins */
  text = command_edit(command_data("box.yaml"),
                      "bands:", "effects: [{effect: albedo, off: true}]\nbands:");
  command_write("off.yaml", text);
  free(text);
  RUN("off.yaml", "off", "--threads", "2");
  RUN("box.yaml", "without", "--without", "albedo");
  expect_same("off", "without");
  RUN("off.yaml", "on_again", "--with", "albedo");
  expect_same("default", "on_again");
}

/* Columns of lightcurve.csv that differ, as "a b "; the caller frees. */
static char *columns_that_differ(const char *a, const char *b)
{
  char path[64], *list = calloc(4096, 1);
  assert_non_null(list);
  snprintf(path, sizeof path, "%s/lightcurve.csv", a);
  struct table ta = table_read(path);
  snprintf(path, sizeof path, "%s/lightcurve.csv", b);
  struct table tb = table_read(path);
  assert_string_equal(ta.header, tb.header);
  assert_int_equal(ta.nrow, tb.nrow);
  for (size_t c = 0; c < ta.ncolumn; c++) {
    bool same = true;
    for (size_t k = 0; k < ta.nrow; k++)
      same = same && strcmp(table_text(&ta, k, ta.field[c]), table_text(&tb, k, ta.field[c])) == 0;
    if (same) continue;
    strcat(list, ta.field[c]);
    strcat(list, " ");
  }
  table_release(&ta);
  table_release(&tb);
  return list;
}

/* Every column that differs is one of these of a band; `band`'s Earth term does differ. */
static void expect_earth_alone(const char *a, const char *b, const char *band)
{
  static const char *const endings[] = {"_intensity_W_sr", "_earth_W_sr", "_irradiance_W_m2",
                                        "_mag_ab",         "_mag_vega",   "_mag_ab_1000km"};
  char *columns = columns_that_differ(a, b), wanted[64];
  snprintf(wanted, sizeof wanted, "%s_earth_W_sr ", band);
  if (strstr(columns, wanted) == NULL) fail_msg("the same: %s", wanted);
  for (char *c = strtok(columns, " "); c != NULL; c = strtok(NULL, " ")) {
    bool allowed = false;
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
      const char *at = strstr(c, endings[i]);
      allowed = allowed || (at != NULL && strcmp(at, endings[i]) == 0);
    }
    if (!allowed) fail_msg("differs: %s", c);
  }
  free(columns);
}

#define DAYLIGHT                                                                                   \
  "--set", "time.start_utc=2016-09-06T18:30:00Z", "--set", "time.stop_utc=2016-09-06T18:32:00Z"

/* Above an Earth in sunlight the albedo moves temperatures and what they emit, and nothing else:
 * the light of the Earth is another effect. */
static void test_albedo_heats(void **state)
{
  (void)state;
  RUN("box.yaml", "with", DAYLIGHT);
  RUN("box.yaml", "without", DAYLIGHT, "--without", "albedo");
  assert_false(same_file("with", "without", "temperatures.csv"));
  struct table with = table_read("with/heat.csv"), without = table_read("without/heat.csv");
  for (size_t i = 0; i < with.nrow; i++) {
    /* a face that looks away from the Earth takes none of it, the whole does */
    bool whole = strchr(table_text(&with, i, "node"), '.') == NULL;
    assert_true(table_number(&with, i, "albedo") > (whole ? 1.0 : -1e-9));
    assert_true(table_number(&without, i, "albedo") == 0.0);
    assert_string_equal(table_text(&with, i, "solar"), table_text(&without, i, "solar"));
  }
  table_release(&with);
  table_release(&without);
  char *columns = columns_that_differ("with", "without");
  assert_null(strstr(columns, "_sun_"));
  assert_null(strstr(columns, "_earth_"));
  assert_non_null(strstr(columns, "lwir_emitted_W_sr"));
  free(columns);
}

/* Earthshine is light, not heat: no temperature moves, and of the light only the term of the Earth.
 * In the thermal band it is the sunlight beyond 8 um, which is small but there. */
static void test_earthshine_is_seen(void **state)
{
  (void)state;
  RUN("box.yaml", "with", DAYLIGHT);
  RUN("box.yaml", "without", DAYLIGHT, "--without", "earthshine");
  assert_true(same_file("with", "without", "temperatures.csv"));
  assert_true(same_file("with", "without", "heat.csv"));
  expect_earth_alone("with", "without", "vis");
  struct table with = table_read("with/lightcurve.csv"),
               without = table_read("without/lightcurve.csv");
  for (size_t k = 0; k < with.nrow; k++) {
    double a = table_number(&with, k, "vis_earth_W_sr"),
           b = table_number(&without, k, "vis_earth_W_sr");
    /* Planck at 0.78 um and 270 K is e^-68 of its peak: reflected Earth IR is no VIS */
    assert_true(a > 1e-3 && b < 1e-18);
    a = table_number(&with, k, "lwir_earth_W_sr");
    b = table_number(&without, k, "lwir_earth_W_sr");
    assert_true(b <= a && a - b < 0.01 * a);
  }
  table_release(&with);
  table_release(&without);
}

/* The same in the thermal band. */
static void test_reflected_earth_is_seen(void **state)
{
  (void)state;
  RUN("box.yaml", "with", DAYLIGHT);
  RUN("box.yaml", "without", DAYLIGHT, "--without", "reflected_earth_ir");
  assert_true(same_file("with", "without", "temperatures.csv"));
  assert_true(same_file("with", "without", "heat.csv"));
  expect_earth_alone("with", "without", "lwir");
}

static double half_light(const char *without)
{
  static const char say[] = "half of the Sun is back";
  struct command c = without == NULL ? command_run("passes", "edge.yaml", NULL)
                                     : command_run("passes", "edge.yaml", "--set", without, NULL);
  assert_int_equal(c.code, 0);
  char *at = strstr(c.out, say); /* of the first pass that has one: 2016-09-06T18:10:... */
  assert_non_null(at);
  while (at > c.out && at[-1] != '\n') at--;
  int minute;
  double second;
  if (sscanf(at, " 2016-09-06T18:%d:%lfZ", &minute, &second) != 2) fail_msg("what is '%.60s'", at);
  command_release(&c);
  return 60.0 * minute + second;
}

/* Sunlit fractions of one run a second, 18:10:00 to 18:10:25; option: --with, --without or NULL. */
static void fractions(const char *option, const char *effect, double out[26])
{
  if (option == NULL)
    RUN("edge.yaml", "edge", "--threads", "2");
  else
    RUN("edge.yaml", "edge", option, effect);
  struct table t = table_read("edge/lightcurve.csv");
  assert_int_equal(t.nrow, 26);
  for (size_t k = 0; k < 26; k++) {
    out[k] = table_number(&t, k, "sunlit_fraction");
    assert_true(out[k] >= 0.0 && out[k] <= 1.0);
    if (k > 0) assert_true(out[k] >= out[k - 1]);
  }
  table_release(&t);
}

/* The sum of the fractions at 1 s is the time of light in the window, so that its loss is a delay
 * of the edge; the penumbra lasts from 18:10:04.9 to 18:10:18.3 (umbra forecast --times), which
 * holds 14 whole seconds. A sphere of the equatorial radius hides the Sun longer than the
 * ellipsoid, by seconds. All of it for the bare Earth; its air lets some light in all the time, red
 * and bent, and keeps half of the disc's away for some 10 s longer (12, 9 and 7 s at 0.45, 0.55 and
 * 0.65 um). */
static void test_edge(void **state)
{
  (void)state;
  double disc[26], point[26], sphere[26], air[26], sum[4] = {0, 0, 0, 0};
  int between[4] = {0, 0, 0, 0};
  char *text = command_edit(command_data("box.yaml"), "18:07:00Z", "18:10:00Z");
  text = command_edit(text, "18:11:00Z, step_s: 60", "18:10:25Z, step_s: 1");
  text = command_edit(text, "bands:", "effects: [{effect: shadow_refraction, off: true}]\nbands:");
  command_write("edge.yaml", text);
  free(text);
  fractions(NULL, NULL, disc);
  fractions("--without", "penumbra", point);
  fractions("--without", "oblateness", sphere);
  fractions("--with", "shadow_refraction", air);
  const double *f[4] = {disc, point, sphere, air};
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 26; k++) {
      sum[i] += f[i][k];
      between[i] += f[i][k] > 0.0 && f[i][k] < 1.0;
    }
  assert_int_equal(between[0], 14);
  assert_int_equal(between[1], 0);
  assert_int_equal(between[3], 26);
  print_message("light in the window: %.2f s, with air %.2f s\n", sum[0], sum[3]);
  assert_true(air[8] > 0.0 && disc[25] == 1.0 && air[25] < 0.9);
  assert_true(sum[0] - sum[3] > 4.0 && sum[0] - sum[3] < 12.0);
  assert_close(sum[1], sum[0], 1.0); /* the edge of a point is that of the disc's middle */
  assert_true(sum[0] - sum[2] > 0.5);
  assert_close(half_light("environment.shadow=sphere") - half_light(NULL), sum[0] - sum[2], 0.5);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_threads_box, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_threads_two_parts, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_threads_periodic, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_picture, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_effect_on_is_default, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_albedo_heats, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_earthshine_is_seen, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_reflected_earth_is_seen, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_edge, enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
