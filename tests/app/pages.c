/* Pages of results say what the tables beside them say, and hold the figures of their story. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tests/app/command.h"
#include "tests/app/json.h"
#include "tests/app/table.h"

#define BOX "box.yaml"

/* The document of a page, which is valid JSON; the caller frees. */
static char *document(const char *path)
{
  static const char mark[] = "id=\"umbra-document\">";
  char *page = command_read(path), *at = strstr(page, mark);
  assert_non_null(at);
  char *end = strstr(at, "</script>");
  assert_non_null(end);
  char *json = strndup(at + sizeof mark - 1, (size_t)(end - at) - (sizeof mark - 1));
  const char *where;
  assert_non_null(json);
  if (!json_is_valid(json, &where)) fail_msg("%s: no JSON at %.60s", path, where);
  free(page);
  return json;
}

static void expect(const char *json, const char *const *want, size_t n)
{
  const char *at = json;
  for (size_t i = 0; i < n; i++) {
    const char *next = strstr(at, want[i]);
    if (next == NULL) fail_msg("no %s behind %.80s", want[i], at);
    at = next;
  }
}
#define EXPECT(json, ...)                                                                          \
  expect(json, (const char *const[]){__VA_ARGS__},                                                 \
         sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *))

/* The number behind a key of a JSON file. */
static double number(const char *path, const char *key)
{
  char *text = command_read(path), *at = strstr(text, key);
  assert_non_null(at);
  double value = strtod(at + strlen(key), NULL);
  free(text);
  return value;
}

static void test_compare(void **state)
{
  (void)state;
  command_expect(0, "synth", BOX, "--noise", "0.02,0.001", "--seed", "3", "-o", "m.csv", "--with",
                 "emittance:grey_white,factor=0.7", NULL);
  command_expect(0, "compare", BOX, "m.csv", "--out", "compared", "--no-plots", NULL);
  char *json = document("compared/report.html"), text[80];
  snprintf(text, sizeof text, "chi-square %.5g at %.5g degrees of freedom",
           number("compared/compare.json", "\"chi2\": "),
           number("compared/compare.json", "\"dof\": "));
  EXPECT(json, "\"kind\": \"comparison\"", text, "\"id\": \"channel-1\"", "\"measured\"",
         "\"id\": \"channel-2\"", "\"id\": \"metrics\"", "\"id\": \"worst\"", "\"id\": \"against-");
  free(json);
}

/* Magnitudes are shown in the system that the band states. */
static void test_run(void **state)
{
  (void)state;
  static const char ab[] = "\"name\": \"AB\", \"role\": \"model\", \"column\": \"vis_mag_ab\", "
                           "\"mark\": \"line\", \"hidden\": true";
  command_expect(0, "run", BOX, "--out", "ran", "--no-plots", NULL);
  char *json = document("ran/report.html");
  EXPECT(json, "\"id\": \"light\"", "\"id\": \"satellite\"", "\"id\": \"temperatures\"",
         "\"id\": \"heat\"", "Mesh: finer facets would move temperatures of places by about ",
         "\"id\": \"errors\"");
  assert_null(strstr(json, ab));
  free(json);
  command_expect(0, "run", BOX, "--out", "vega", "--no-plots", "--set",
                 "bands.vis.vega_magnitude=0.03", NULL);
  json = document("vega/report.html");
  assert_non_null(strstr(json, ab));
  free(json);
}

static void test_sensitivity(void **state)
{
  (void)state;
  command_expect(0, "sensitivity", BOX, "--only", "emittance:grey_white", "--out", "moved",
                 "--no-plots", NULL);
  char *json = document("moved/report.html");
  EXPECT(json, "\"kind\": \"sliders\"", "\"emittance:grey_white.factor\"", "\"null\": 1",
         "\"curves\"", "\"id\": \"leaders-", "\"id\": \"parameters\"");
  free(json);
}

/* Ranges of a page are those of limits.csv, with the margin in words. */
static void test_cases(void **state)
{
  (void)state;
  command_expect(4, "cases", BOX, "--out", "cases", "--no-plots", "--set",
                 "limits=[{of: bus, minimum_K: 250, maximum_K: 300, uncertainty_K: 5}]", NULL);
  struct table t = table_read("cases/limits.csv");
  assert_string_equal(table_text(&t, 0, "place"), "bus");
  char *json = document("cases/report.html"), range[200], lead[120];
  double margin = table_number(&t, 0, "margin_low_K");
  snprintf(range, sizeof range,
           "\"low\": %s, \"high\": %s, \"error\": 5, \"minimum\": 250, \"maximum\": 300, "
           "\"text\": \"exceeded by %.2f K\", \"exceeded\": true",
           table_text(&t, 0, "lowest_K"), table_text(&t, 0, "highest_K"), -margin);
  snprintf(lead, sizeof lead, "1 of 1 limits are exceeded, most by %.2f K: bus", -margin);
  EXPECT(json, "\"kind\": \"cases\"", lead, "\"level\": \"bad\"", "\"kind\": \"ranges\"", range,
         "\"id\": \"temperatures\"");
  free(json);
  table_release(&t);
  command_expect(0, "cases", BOX, "--out", "free", "--no-plots", NULL);
  json = document("free/report.html");
  EXPECT(json, "states no limits", "\"name\": \"bus\"");
  assert_non_null(strstr(json, "\"umbra cases box.yaml --out free --no-plots\""));
  assert_null(strstr(json, "\"minimum\":")); /* no stroke where there is no limit */
  free(json);
}

/* Measurements of the scenario itself, with more noise than its sampling has: a diagnosis adds
 * nothing, and its page has one model, without a before and an after. */
static void test_diagnosis(void **state)
{
  (void)state;
  command_expect(0, "synth", BOX, "--noise", "0.2", "--seed", "3", "-o", "own.csv", NULL);
  command_expect(0, "diagnose", BOX, "own.csv", "--only", "zero_point", "--out", "own",
                 "--no-plots", NULL);
  char *json = document("own/report.html");
  EXPECT(json, "How far off was the model, and where?", "Before: chi-square", "\"model\"",
         "What remains?");
  assert_null(strstr(json, "\"before\""));
  assert_null(strstr(json, "\"after\""));
  free(json);
}

static double unix_of(const char *utc)
{
  struct tm tm = {0};
  assert_non_null(strptime(utc, "%Y-%m-%dT%H:%M:%S", &tm));
  return (double)mktime(&tm); /* TZ is UTC */
}

/* What the first figure with shades behind `from` is shaded by at a time; "day": by nothing. */
static const char *shade_at(const char *from, double t)
{
  static char name[40];
  const char *at = strstr(from, "\"shade\": ["), *end;
  assert_non_null(at);
  end = strchr(at, ']');
  for (at = strstr(at, "\"from\": "); at != NULL && at < end; at = strstr(at, "\"from\": ")) {
    char *next;
    double low = strtod(at + strlen("\"from\": "), &next);
    double high = strtod(next + strlen(", \"to\": "), &next);
    next += strlen(", \"name\": \"");
    snprintf(name, sizeof name, "%.*s", (int)strcspn(next, "\""), next);
    if (t >= low && t <= high) return name;
    at = next;
  }
  return "day";
}

/* Every pass has its row and its curves; the sky that passes.csv states is the one that is shaded.
 */
static void test_forecast(void **state)
{
  (void)state;
  size_t nights = 0, days = 0;
  command_expect(0, "forecast", BOX, "--days", "1", "--out", "passes", "--no-plots", "--set",
                 "time.step_s=20", NULL);
  struct table t = table_read("passes/passes.csv");
  char *json = document("passes/report.html");
  EXPECT(json, "\"kind\": \"forecast\"", "\"id\": \"passes\"", "\"id\": \"overview-1\"",
         "\"name\": \"vis, magnitude (AB)\"", "\"name\": \"lwir, irradiance\"",
         "\"id\": \"pass-1\"", "\"kind\": \"sky\"");
  for (size_t i = 0; i < t.nrow; i++) {
    const char *top = table_text(&t, i, "culmination_utc"), *sky = table_text(&t, i, "sky");
    char when[32], title[80];
    snprintf(when, sizeof when, "%.10s %.8s", top, top + 11);
    assert_non_null(strstr(json, when));
    snprintf(title, sizeof title, "\"title\": \"%s, %.0f\xc2\xb0 high, ", when,
             table_number(&t, i, "culmination_elevation_deg"));
    assert_non_null(strstr(json, title));
    bool whole = strcmp(sky, "day") == 0 || strcmp(sky, "night") == 0;
    assert_string_equal(shade_at(strstr(json, "\"id\": \"overview-1\""), unix_of(top)),
                        whole ? sky : "twilight");
    nights += strcmp(sky, "night") == 0;
    days += strcmp(sky, "day") == 0;
  }
  assert_true(nights > 0 && days > 0);
  free(json);
  table_release(&t);
}

/* A scenario before it is solved; results beside each other, of which no page of another kind is
 * one. */
static void test_view_and_report(void **state)
{
  (void)state;
  command_expect(0, "check", BOX, "--view", "--out", "view", NULL);
  char *json = document("view/report.html");
  EXPECT(json, "\"kind\": \"scene\"", "\"id\": \"parts\"", "\"id\": \"materials\"", "\"scene\"");
  free(json);
  command_expect(0, "report", "view", "view/report.html", "-o", "both.html", NULL);
  char *both = command_read("both.html");
  assert_non_null(strstr(both, "id=\"umbra-document-1\""));
  assert_non_null(strstr(both, "[\"view\", \"view/report.html\"]"));
  free(both);
  command_write("other.html", "<html></html>");
  struct command c = command_run("report", "view", "other.html", "-o", "none.html", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "other.html: no page of Umbra"));
  assert_false(command_exists("none.html"));
  command_release(&c);
}

static int enter(void **state)
{
  if (command_enter(state) != 0 || setenv("TZ", "UTC0", 1) != 0) return -1;
  command_copy_data(BOX);
  return 0;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_run),
                                     cmocka_unit_test(test_compare),
                                     cmocka_unit_test(test_diagnosis),
                                     cmocka_unit_test(test_sensitivity),
                                     cmocka_unit_test(test_cases),
                                     cmocka_unit_test(test_forecast),
                                     cmocka_unit_test(test_view_and_report)};
  return cmocka_run_group_tests(tests, enter, command_leave);
}
