/* umbra forecast: the passes that --times tells, with what umbra run gives of each alone; the same
 * bytes for any number of processes, after a stop, and from shares. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

/* Row of a table of a run nearest below or at a time, both "2016-09-06T18:07:00.000Z". */
static size_t row_of(const struct table *t, const char *utc)
{
  for (size_t i = 0; i < t->nrow; i++)
    if (strcmp(table_text(t, i, "time_utc"), utc) == 0) return i;
  fail_msg("no row at %s", utc);
  return 0;
}

/* "KEY=2016-..." with the second after or before a time of milliseconds. */
static void second_of(char out[80], const char *key, const char *utc, int up)
{
  char head[32];
  snprintf(head, sizeof head, "%.17s", utc);
  int seconds = (int)strtol(utc + 17, NULL, 10), rest = (int)strtol(utc + 20, NULL, 10);
  if (up && rest > 0) seconds++;
  assert_in_range(seconds, 0, 59); /* of the passes of this test */
  snprintf(out, 80, "%s=%s%02d.000Z", key, head, seconds);
}

/* A band whose magnitudes are relative to Vega, in which that has 0.03. */
#define V "bands.V={filter: johnson_v, vega_magnitude: 0.03, bins: 4}"

/* Every number of the table is that of a run over the pass alone; times and sky are those of
 * --times.
 */
static void test_alone(void **state)
{
  (void)state;
  command_expect(0, "forecast", "box.yaml", "--days", "0.2", "-o", "f", "--no-plots", "--workers",
                 "2", "--set", "time.step_s=20", "--set", V, NULL);
  struct table f = table_read("f/passes.csv");
  struct command passes = command_run("forecast", "box.yaml", "--times", NULL);
  assert_true(f.nrow >= 2);
  for (size_t i = 0; i < f.nrow; i++) {
    char start[80], stop[80];
    const char *rise = table_text(&f, i, "rise_utc"), *set = table_text(&f, i, "set_utc");
    assert_non_null(strstr(passes.out, rise));
    assert_non_null(strstr(passes.out, table_text(&f, i, "culmination_utc")));
    assert_non_null(strstr(passes.out, set));
    if (table_text(&f, i, "shadow_exit_utc")[0] != '\0')
      assert_non_null(strstr(passes.out, table_text(&f, i, "shadow_exit_utc")));
    if (i > 1) continue; /* two runs tell */
    second_of(start, "time.start_utc", rise, 1);
    second_of(stop, "time.stop_utc", set, 0);
    command_expect(0, "run", "box.yaml", "-o", "alone", "--no-plots", "--set", "time.step_s=20",
                   "--set", V, "--set", start, "--set", stop, NULL);
    struct table light = table_read("alone/lightcurve.csv");
    struct table heat = table_read("alone/temperatures.csv");
    size_t k = row_of(&light, table_text(&f, i, "vis_brightest_utc"));
    double least = table_number(&light, k, "vis_mag_ab"), mean = 0.0;
    assert_close(table_number(&f, i, "vis_brightest_mag_ab"), least, 1e-8 * 10.0);
    for (size_t r = 0; r < light.nrow; r++) {
      const char *text = table_text(&light, r, "vis_mag_ab");
      if (text[0] != '\0') assert_true(strtod(text, NULL) >= least);
      mean += table_number(&heat, r, "bus.mean_K") / (double)light.nrow;
    }
    /* a band of Johnson's system has the magnitudes of that, and says so */
    k = row_of(&light, table_text(&f, i, "V_brightest_utc"));
    double v = table_number(&light, k, "V_mag_vega");
    assert_close(table_number(&f, i, "V_brightest_mag_vega"), v, 1e-8 * 10.0);
    assert_true(fabs(v - table_number(&light, k, "V_mag_ab")) > 0.01);
    k = row_of(&light, table_text(&f, i, "lwir_largest_utc"));
    double e = table_number(&light, k, "lwir_irradiance_W_m2");
    assert_close(table_number(&f, i, "lwir_largest_W_m2"), e, 1e-8 * e);
    assert_close(table_number(&f, i, "bus.mean_K"), mean, 1e-6);
    table_release(&light);
    table_release(&heat);
  }
  command_release(&passes);
  table_release(&f);
}

/* The Sun's elevation at a station by the Astronomical Almanac's low-precision formulas [deg], good
 * to 0.01 deg; days since J2000.0 (UT1 is UTC here). */
static double sun_elevation(double days, double latitude, double longitude)
{
  double g = (357.528 + 0.9856003 * days) * M_PI / 180.0;
  double l = 280.460 + 0.9856474 * days + 1.915 * sin(g) + 0.020 * sin(2.0 * g);
  double lambda = l * M_PI / 180.0, tilt = (23.439 - 4e-7 * days) * M_PI / 180.0;
  double right = atan2(cos(tilt) * sin(lambda), cos(lambda));
  double up = asin(sin(tilt) * sin(lambda));
  double local = (280.46062 + 360.98564737 * days + longitude) * M_PI / 180.0 - right;
  double phi = latitude * M_PI / 180.0;
  return asin(sin(phi) * sin(up) + cos(phi) * cos(up) * cos(local)) * 180.0 / M_PI;
}

/* Every pass says what sky the station has, by the Sun's elevation when it culminates, and has the
 * edges of the shadow that lie in it alone. */
static void test_times(void **state)
{
  (void)state;
  struct command c = command_run("forecast", "box.yaml", "--times", "--days", "2", "--from",
                                 "2016-09-06T00:00:00Z", "--station", "Graz,47.067,15.493,495",
                                 "--station", "Suva,-18.1,178.4,10", "--json", NULL);
  size_t nights = 0, days = 0, twilights = 0, edges = 0;
  assert_int_equal(c.code, 0);
  for (const char *at = c.out; (at = strstr(at, "{\"station\": ")) != NULL; at++) {
    int day, hour, minute;
    double second, seen;
    char rise[32], set[32], sky[16];
    bool graz = strncmp(at + 12, "\"Graz\"", 6) == 0;
    assert_int_equal(sscanf(strstr(at, "culmination_utc"),
                            "culmination_utc\": \"2016-09-%dT%d:%d:%lf", &day, &hour, &minute,
                            &second),
                     4);
    assert_int_equal(sscanf(strstr(at, "rise_utc"), "rise_utc\": \"%30[^\"]", rise), 1);
    assert_int_equal(sscanf(strstr(at, "set_utc"), "set_utc\": \"%30[^\"]", set), 1);
    assert_int_equal(sscanf(strstr(at, "sun_elevation_deg"), "sun_elevation_deg\": %lf", &seen), 1);
    assert_int_equal(sscanf(strstr(at, "\"sky\""), "\"sky\": \"%15[^\"]", sky), 1);
    /* 2016-09-06 0h is 6092.5 days from J2000.0 */
    double t = 6092.5 + (day - 6) + (hour + minute / 60.0 + second / 3600.0) / 24.0;
    double wanted = sun_elevation(t, graz ? 47.067 : -18.1, graz ? 15.493 : 178.4);
    assert_close(seen, wanted, 0.02);
    const char *word = wanted > -0.833  ? "day"
                       : wanted > -6.0  ? "civil"
                       : wanted > -12.0 ? "nautical"
                       : wanted > -18.0 ? "astronomical"
                                        : "night";
    assert_string_equal(sky, word);
    days += word[0] == 'd';
    nights += word[1] == 'i' && word[0] == 'n';
    twilights += word[0] == 'c' || word[0] == 'a' || word[1] == 'a';
    const char *end = strstr(at, "]}");
    for (const char *e = strstr(at, "{\"utc\""); e != NULL && e < end;
         e = strstr(e + 1, "{\"utc\"")) {
      char utc[32];
      assert_int_equal(sscanf(e, "{\"utc\": \"%30[^\"]", utc), 1);
      assert_true(strcmp(utc, rise) >= 0 && strcmp(utc, set) <= 0);
      edges++;
    }
  }
  print_message("%zu days, %zu twilights, %zu nights, %zu edges\n", days, twilights, nights, edges);
  assert_true(days > 0 && nights > 0 && twilights > 0 && edges > 0);
  command_release(&c);
}

/* Days of more seconds than a run may have observations: what is computed is the passes, and one
 * has the numbers that it has in a forecast of its day. */
static void test_long(void **state)
{
  (void)state;
#define ASKED "forecast", "box.yaml", "--no-plots", "--minimum-elevation", "86", "--set",
  command_expect(0, ASKED "time.step_s=1", "--days", "12", "-o", "long", NULL);
  command_expect(0, ASKED "time.step_s=1", "--days", "1", "--from", "2016-09-15T12:00:00Z", "-o",
                 "day", NULL);
#undef ASKED
  char *all = command_read("long/passes.csv"), *one = command_read("day/passes.csv");
  assert_int_equal(command_count_lines(one), 2);
  assert_non_null(strstr(one, "2016-09-15T19:20:"));
  /* rise and set are roots, found to microseconds; what is computed at whole seconds is the same */
  assert_non_null(strstr(one, ",night,"));
  assert_string_equal(strstr(all, ",night,"), strstr(one, ",night,"));
  free(all);
  free(one);
}

/* The picture's axis is the clock of UTC: every pass begins where its first second stands. A night
 * is named by its dates in UTC, by one where it lies in one. */
static void test_picture(void **state)
{
  (void)state;
  struct command c =
      command_run("forecast", "box.yaml", "--days", "0.8", "-o", "f", "--set", V, "--station",
                  "Suva,-18.1,178.4,10", "--station", "Graz,47.067,15.493,495", "--json", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "\"magnitudes\": {\"vis\": \"AB\", \"lwir\": \"AB\", "
                                "\"V\": \"Vega\"}}"));
  command_release(&c);
  char *picture = command_read("f/passes.gp");
  struct table f = table_read("f/passes.csv"), curves = table_read("f/curves.csv");
  assert_true(f.nrow >= 5);
  for (size_t i = 0, row = 0; i < f.nrow; i++) {
    char begin[40];
    snprintf(begin, sizeof begin, "\n$pass%zu << EOD\n", i);
    const char *at = strstr(picture, begin);
    assert_non_null(at);
    while ((size_t)table_number(&curves, row, "pass") != i + 1) row++;
    const char *clock = table_text(&curves, row, "time_utc") + 11;
    double hours =
        strtod(clock, NULL) + strtod(clock + 3, NULL) / 60.0 + strtod(clock + 6, NULL) / 3600.0;
    assert_close(fmod(strtod(at + strlen(begin), NULL), 24.0), hours, 2e-5);
  }
  assert_non_null(strstr(picture, "'22:00' 22.0000, '00:00' 24.0000"));
  assert_non_null(strstr(picture, "set xlabel 'UTC'"));
  assert_non_null(strstr(picture, "title '2016-09-06/07'"));
  assert_non_null(strstr(picture, "title '2016-09-07'"));
  assert_non_null(strstr(picture, "'magnitude (Vega)'"));
  table_release(&curves);
  table_release(&f);
  free(picture);
}

static void expect_same(const char *a, const char *b)
{
  static const char *const files[] = {"passes.csv", "curves.csv", "passes.ics", NULL};
  command_expect_same(a, b, files);
}

/* One process, two, two shares and a gathering, a stop and a resume: the same files. */
static void test_same(void **state)
{
  (void)state;
#define ASKED "forecast", "box.yaml", "--days", "0.3", "--no-plots", "--set", "time.step_s=60"
  command_expect(0, ASKED, "-o", "one", "--workers", "1", NULL);
  command_expect(0, ASKED, "-o", "two", "--workers", "2", NULL);
  expect_same("one", "two");
  assert_false(command_exists("one.records"));
  command_expect(0, ASKED, "-o", "shared", "--share", "1/2", NULL);
  assert_false(command_exists("shared"));
  command_expect(0, ASKED, "-o", "shared", "--share", "2/2", NULL);
  command_expect(0, ASKED, "-o", "shared", "--resume", NULL);
  expect_same("one", "shared");
  const char *const stopped[] = {ASKED, "-o", "stopped", "--workers", "2", NULL};
  struct command c = command_run_for(0.25, SIGTERM, stopped);
  if (c.code != 0) {
    assert_int_equal(c.code, 128 + SIGTERM);
    assert_true(c.seconds < 2.0);
    assert_false(command_exists("stopped"));
    command_expect(0, ASKED, "-o", "stopped", "--resume", NULL);
  }
  command_release(&c);
  expect_same("one", "stopped");
#undef ASKED
}

/* Records of another forecast are not taken, and not thrown away. */
static void test_other(void **state)
{
  (void)state;
  command_expect(0, "forecast", "box.yaml", "--days", "0.1", "-o", "f", "--share", "1/1", NULL);
  struct command c = command_run("forecast", "box.yaml", "--days", "0.1", "-o", "f", "--resume",
                                 "--set", "time.step_s=9", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "f.records: the changes by --set are others than when this was"));
  command_release(&c);
  c = command_run("forecast", "box.yaml", "--days", "0.1", "-o", "f", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "points are on record there"));
  command_release(&c);
  command_expect(0, "forecast", "box.yaml", "--days", "0.1", "-o", "f", "--resume", "--no-plots",
                 NULL);
}

/* Lines end in CRLF, hold at most 75 bytes, and unfold to what was meant. */
static void test_calendar(void **state)
{
  (void)state;
  command_expect(0, "forecast", "box.yaml", "--days", "0.3", "-o", "f", "--no-plots", "--station",
                 "Göttingen; Sternwarte, Süd,51.53,9.94,150", NULL);
  char *text = command_read("f/passes.ics"), *to = text;
  size_t column = 0, events = 0;
  for (const char *at = text; *at != '\0'; at++) {
    if (*at == '\n') fail_msg("a line feed alone");
    if (*at != '\r') {
      assert_true(++column <= 75);
      *to++ = *at;
      continue;
    }
    assert_int_equal(*++at, '\n');
    assert_false(column == 0);
    column = 0;
    if (at[1] == ' ') {
      at++;
      column = 1;
    } else {
      *to++ = '\n';
    }
    assert_int_not_equal((unsigned char)at[1] & 0xc0, 0x80); /* no character is broken */
  }
  *to = '\0';
  for (const char *at = text; (at = strstr(at, "BEGIN:VEVENT\nUID:")) != NULL; at++) events++;
  assert_true(events >= 2);
  assert_non_null(
      strstr(text, "\nLOCATION:Göttingen\\; Sternwarte\\, Süd\nGEO:51.530000;9.940000"));
  assert_true(strncmp(text, "BEGIN:VCALENDAR\nVERSION:2.0\nPRODID:", 35) == 0);
  assert_non_null(strstr(text, "\nEND:VEVENT\nEND:VCALENDAR\n"));
  free(text);
}

static void test_refused(void **state)
{
  (void)state;
  static const struct {
    const char *option, *value, *says;
  } cases[] = {
      {"--days", "0", "--days '0': accepted: a number from 0.001 to 400"},
      {"--days", "nan", "--days 'nan': accepted"},
      {"--days", "2d", "--days '2d': accepted"},
      {"--minimum-elevation", "90", "accepted: a number from 0 to 89"},
      {"--station", "Graz", "accepted: NAME,LATITUDE,LONGITUDE,HEIGHT"},
      {"--station", "Graz,97,15,495", "accepted: NAME,LATITUDE,LONGITUDE,HEIGHT"},
      {"--station", ",47,15,495", "accepted: NAME,LATITUDE,LONGITUDE,HEIGHT"},
      {"--station", "a`b,47,15,495", "accepted: NAME,LATITUDE,LONGITUDE,HEIGHT"},
      {"--share", "3/2", "--share '3/2': accepted: K/N with K from 1 to N"},
      {"--share", "1", "accepted: K/N"},
      {"--from", "yesterday", "yesterday"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct command c =
        command_run("forecast", "box.yaml", "-o", "f", cases[i].option, cases[i].value, NULL);
    assert_int_equal(c.code, 1);
    if (strstr(c.err, cases[i].says) == NULL) fail_msg("%s", c.err);
    assert_int_equal(command_count_lines(c.err), 1);
    command_release(&c);
    assert_false(command_exists("f"));
    assert_false(command_exists("f.records"));
  }
}

/* A pass that cannot be computed has its reason in the table, and the others are there. */
static void test_reason(void **state)
{
  (void)state;
  char *text = command_read("box.yaml");
  text = command_edit(text, "  - lvlh: {}\n", "  - table: {file: turns.csv}\n");
  command_write("box.yaml", text);
  free(text);
  /* an attitude that is known during the first pass alone, an orbit before it included */
  command_write("turns.csv", "time_utc,q0,q1,q2,q3\n2016-09-06T16:00:00Z,1,0,0,0\n"
                             "2016-09-06T17:00:00Z,1,0,0,0\n2016-09-06T18:00:00Z,1,0,0,0\n"
                             "2016-09-06T19:00:00Z,1,0,0,0\n");
  command_expect(0, "forecast", "box.yaml", "--days", "0.2", "-o", "f", "--set",
                 "attitude.0.table.max_gap_s=4000", NULL);
  char *table = command_read("f/passes.csv");
  assert_non_null(strstr(table, "turns.csv"));
  assert_non_null(strstr(table, "is wanted at"));
  char *calendar = command_read("f/passes.ics");
  size_t events = 0;
  for (const char *at = calendar; (at = strstr(at, "BEGIN:VEVENT")) != NULL; at++) events++;
  assert_int_equal(events, 1);
  free(table);
  free(calendar);
}

/* An orbit that begins at the scenario's start begins there for every pass, not at the pass's: the
 * satellite is where the pass says, and is seen. */
static void test_pinned(void **state)
{
  (void)state;
  char *text = command_read("box.yaml");
  char *orbit = strstr(text, "orbit:"), *attitude = strstr(text, "attitude:");
  char head[1024], whole[4096];
  snprintf(head, sizeof head, "%.*s", (int)(orbit - text), text);
  snprintf(whole, sizeof whole,
           "%sorbit: {circular: {altitude_km: 765, beta_deg: 30}}\nattitude:\n  - spin: "
           "{axis_gcrs: [0, 0, 1], axis_body: [0, 0, 1], period_s: 100}\n%s",
           head, strstr(attitude, "observer:"));
  command_write("box.yaml", whole);
  free(text);
  command_expect(0, "forecast", "box.yaml", "--days", "0.3", "-o", "f", "--no-plots", "--station",
                 "Equator,0,15,0", NULL);
  struct table f = table_read("f/passes.csv");
  assert_true(f.nrow >= 1);
  for (size_t i = 0; i < f.nrow; i++) {
    char turn[80], epoch[80], start[80], stop[80];
    assert_true(table_number(&f, i, "lwir_culmination_W_m2") > 1e-13);
    if (i > 0) continue;
    snprintf(epoch, sizeof epoch, "orbit.circular.epoch_utc=2016-09-06T18:07:00Z");
    snprintf(turn, sizeof turn, "attitude.0.spin.at_utc=2016-09-06T18:07:00Z");
    second_of(start, "time.start_utc", table_text(&f, i, "rise_utc"), 1);
    second_of(stop, "time.stop_utc", table_text(&f, i, "set_utc"), 0);
    command_expect(0, "run", "box.yaml", "-o", "alone", "--no-plots", "--set", epoch, "--set", turn,
                   "--set", start, "--set", stop, "--set", "observer.station.latitude_deg=0",
                   "--set", "observer.station.longitude_deg=15", "--set",
                   "observer.station.height_m=0", NULL);
    struct table light = table_read("alone/lightcurve.csv");
    size_t k = row_of(&light, table_text(&f, i, "lwir_largest_utc"));
    double e = table_number(&light, k, "lwir_irradiance_W_m2");
    assert_close(table_number(&f, i, "lwir_largest_W_m2"), e, 1e-8 * e);
    table_release(&light);
  }
  table_release(&f);
}

#define UNCERTAIN                                                                                  \
  "--uncertain", "emittance:grey_white=0.05", "--uncertain",                                       \
      "parts.bus.shell.areal_heat_capacity_J_m2_K=150"

/* Error bars stand beside what is predicted without: the table without their columns has the same
 * fields. They are drawn, and told with who gives most of them; processes do not matter. */
static void test_uncertain(void **state)
{
  (void)state;
#define ASKED "forecast", "box.yaml", "--days", "0.2"
  command_expect(0, ASKED, "-o", "plain", NULL);
  struct command c = command_run(ASKED, "-o", "bars", "--workers", "2", UNCERTAIN, NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "+- is 1 sigma by 2 uncertain parameters, to first order; most of "
                                "the variance of lwir by parts.bus.shell."));
  assert_non_null(strstr(c.out, "5.95+-0.00"));
  command_release(&c);
  command_expect(0, ASKED, "-o", "one", "--workers", "1", UNCERTAIN, NULL);
  static const char *const files[] = {"passes.csv", "curves.csv", NULL};
  command_expect_same("bars", "one", files);
  char *two = command_read("bars/contributions.csv"), *one = command_read("one/contributions.csv");
  assert_string_equal(two, one);
  free(two);
  free(one);
  static const char *const both[] = {"passes.csv", "curves.csv"};
  for (size_t i = 0; i < 2; i++) {
    char name[40];
    size_t bars = 0;
    snprintf(name, sizeof name, "plain/%s", both[i]);
    struct table plain = table_read(name);
    snprintf(name, sizeof name, "bars/%s", both[i]);
    struct table with = table_read(name);
    assert_int_equal(with.nrow, plain.nrow);
    for (size_t k = 0; k < plain.ncolumn; k++) {
      assert_null(strstr(plain.field[k], "sigma"));
      for (size_t r = 0; r < plain.nrow; r++)
        assert_string_equal(table_text(&plain, r, plain.field[k]),
                            table_text(&with, r, plain.field[k]));
    }
    for (size_t k = 0; k < with.ncolumn; k++) bars += strstr(with.field[k], "_sigma_") != NULL;
    assert_int_equal(with.ncolumn, plain.ncolumn + bars);
    assert_int_equal(bars, i == 0 ? 11 : 4); /* of two bands and a part */
    table_release(&with);
    table_release(&plain);
  }
  assert_false(command_exists("plain/contributions.csv"));
  struct table f = table_read("bars/passes.csv"), of = table_read("bars/contributions.csv");
  assert_int_equal(of.nrow, 2 * f.nrow);
  double a = table_number(&of, 0, "bus.mean_K"), b = table_number(&of, 1, "bus.mean_K");
  assert_true(a < -0.5 && b > 0.5);
  assert_close(table_number(&f, 0, "bus.mean_sigma_K"), sqrt(a * a + b * b), 1e-9);
  assert_close(table_number(&f, 0, "vis_brightest_sigma_mag"), 0.0, 0.0);
  double largest = table_number(&f, 0, "lwir_largest_W_m2");
  assert_true(table_number(&f, 0, "lwir_largest_sigma_W_m2") > 1e-3 * largest);
  assert_true(table_number(&f, 0, "lwir_largest_sigma_W_m2") < 0.1 * largest);
  table_release(&of);
  table_release(&f);
  char *plain = command_read("plain/passes.gp"), *bars = command_read("bars/passes.gp");
  assert_null(strstr(plain, "filledcurves"));
  assert_non_null(strstr(bars,
                         "((column(5) - column(9)) / 1e-11):((column(5) + column(9)) / 1e-11) "
                         "with filledcurves"));
  free(plain);
  free(bars);
#undef ASKED
}

/* Records are of what is uncertain, too. */
static void test_uncertain_records(void **state)
{
  (void)state;
#define ASKED "forecast", "box.yaml", "--days", "0.1", "-o", "f", "--no-plots"
  static const char *const other[] = {"emittance:grey_white=0.06", "heat_capacity:bus=0.05"};
  command_expect(0, ASKED, "--share", "1/1", "--uncertain", "emittance:grey_white=0.05", NULL);
  for (size_t i = 0; i < 3; i++) {
    struct command c = i < 2 ? command_run(ASKED, "--resume", "--uncertain", other[i], NULL)
                             : command_run(ASKED, "--resume", NULL);
    assert_int_equal(c.code, 1);
    assert_non_null(strstr(c.err, "the uncertain parameters are others than when this was"));
    command_release(&c);
  }
  command_expect(0, ASKED, "--resume", "--uncertain", "emittance:grey_white=0.05", NULL);
#undef ASKED
}

/* What is far from a line is said, and what moves nothing. */
static void test_uncertain_told(void **state)
{
  (void)state;
  struct command c =
      command_run("forecast", "box.yaml", "--days", "0.1", "-o", "f", "--no-plots", "--json",
                  "--uncertain", "emittance:grey_white=0.4", "--uncertain",
                  "thermal.orbits_before=0.001", "--uncertain", "background:vis=1e-30", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.err, "emittance:grey_white.factor: first order is not enough: "
                                "at 1 sigma lwir is off the line by up to "));
  assert_non_null(strstr(c.out, "\"uncertain\": 3, \"most_of_the_variance\": {"));
  assert_non_null(strstr(c.out, "\"lwir\": {\"parameter\": \"emittance:grey_white.factor\""));
  assert_non_null(strstr(c.err, "background:vis.irradiance_W_m2 changes nothing of these passes"));
  command_release(&c);
}

static void test_uncertain_refused(void **state)
{
  (void)state;
  static const struct {
    const char *text, *says;
  } cases[] = {
      {"emittance:grey_white=0", "sigma '0'; accepted: a number above 0"},
      {"emittance:grey_white=-0.1", "sigma '-0.1'; accepted: a number above 0"},
      {"emittance:grey_white=nan", "sigma 'nan'; accepted: a number above 0"},
      {"emittance:grey_white=inf", "sigma 'inf'; accepted: a number above 0"},
      {"emittance:grey_white=5 %", "sigma '5 %'; accepted: a number above 0"},
      {"emittance:grey_white", "accepted: EFFECT[:TARGET],NAME=SIGMA, or"},
      {"emittance:grey_white,0.1", "accepted: EFFECT[:TARGET],NAME=SIGMA, or"},
      {"", "accepted: EFFECT[:TARGET],NAME=SIGMA, or"},
      {"parts.bus", "accepted: EFFECT[:TARGET],NAME=SIGMA, or"},
      {"emitance:grey_white=0.1", "no effect is called 'emitance'; did you mean 'emittance'?"},
      {"emittance:grey=0.1", "nothing that 'emittance' acts on is called 'grey'"},
      {"emittance=0.1", "effect 'emittance' needs a target"},
      {"emittance:grey_white,level=0.1", "effect 'emittance' has no parameter 'level'"},
      {"attitude_offset=1", "'attitude_offset' has 3 parameters"},
      {"albedo=0.1", "'albedo' is on or off and has no number to move"},
      {"parts.bus.shell.areal=3", "the scenario has no number there"},
      {"orbit.tle=3", "the scenario has no number there"},
      {"time.step_s=1", "every pass has its own"},
      {"heat_capacity:bus,factor=0.1,capacity_factor=0.2",
       "moves what 'heat_capacity:bus.factor' moves"},
      {"heat_capacity:bus,factor=0.1,factor=0.2", "moves what 'heat_capacity:bus.factor' moves"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct command c =
        command_run("forecast", "box.yaml", "-o", "f", "--uncertain", cases[i].text, NULL);
    assert_int_equal(c.code, 1);
    if (strstr(c.err, cases[i].says) == NULL) fail_msg("%s", c.err);
    assert_non_null(strstr(c.err, "--uncertain "));
    bool former = strstr(cases[i].text, "capacity_factor") != NULL; /* said before it is refused */
    assert_int_equal(strstr(c.err, "capacity_factor is now called factor") != NULL, former);
    assert_int_equal(command_count_lines(c.err), former ? 2 : 1);
    command_release(&c);
    assert_false(command_exists("f"));
    assert_false(command_exists("f.records"));
  }
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, command_leave)
  static const struct CMUnitTest tests[] = {
      TEST(test_times),          TEST(test_alone),
      TEST(test_long),           TEST(test_picture),
      TEST(test_same),           TEST(test_other),
      TEST(test_calendar),       TEST(test_refused),
      TEST(test_pinned),         TEST(test_reason),
      TEST(test_uncertain),      TEST(test_uncertain_records),
      TEST(test_uncertain_told), TEST(test_uncertain_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
