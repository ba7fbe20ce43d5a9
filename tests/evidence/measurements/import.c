/* Measurements out of tables with any header: what is read, what is found out, what is refused, and
 * which command is proposed. */
#include "evidence/measurements/import.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "orbit/time.h"
#include "tests/evidence/import_test.h"

/* The same four rows with every separator, forms of time, and header: the same measurements. Row 3
 * has no value; row 2 comes before row 1. Times: 2016-09-21T20:33:00 UTC is JD 2457653.35625, MJD
 * 57652.85625, POSIX 1474489980 (docs/files.md). */
static void test_forms(void **state)
{
  (void)state;
  static const struct {
    const char *text, *time;
    enum um_orbit_time_form form;
  } tables[] = {
      {"# a comment\n\nUTC,V,Verr\n2016-09-21T20:34:26.4Z,7.5,0.05\n2016-09-21 20:33:00,7.25,\n"
       "2016-09-21T20:34:00Z,,0.1\n",
       "UTC", UM_ORBIT_TIME_ISO},
      {"UTC;V;Verr\r\n\"2457653.35725\";7.5;0.05\r\n2457653.35625;7.25;nan\r\n2457653.3567;--;"
       "1\r\n",
       "UTC", UM_ORBIT_TIME_JD},
      {"UTC\tV\tVerr\n57652.85725\t7.5\t0.05\n57652.85625\t7.25\t\n57652.8567\tNaN\t1\n", "UTC",
       UM_ORBIT_TIME_MJD},
      {"# telescope A\n# UTC V Verr\n 1474490066.4   7.5 0.05\n 1474489980 7.25 -\n"
       "1474490040 null 1\n",
       "UTC", UM_ORBIT_TIME_UNIX},
      {"# UTC V Verr filter\n1474490066.4 7.5 0.05 clear\n1474489980 7.25 - red\n1474490040 - 1 "
       "x\n",
       "UTC", UM_ORBIT_TIME_UNIX},
      {"# UTC V Verr\n1474490066.4,7.5,0.05\n1474489980,7.25,\n1474490040,,1\n", "UTC",
       UM_ORBIT_TIME_UNIX},
      {"\xef\xbb\xbfnight clock V Verr\n2016-09-21 20:34:26.4 7.5 0.05\n2016-09-21 20:33:00 7.25 "
       "-\n"
       "2016-09-21 20:34:00 - 1\n",
       "night+clock", UM_ORBIT_TIME_ISO},
  };
  double t;
  assert_ok(um_orbit_time_parse(context, "2016-09-21T20:33:00Z", &t));
  for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
    struct um_compare_columns columns = {.time = tables[i].time, .magnitude = "V", .sigma = "Verr"};
    struct um_compare_imported found;
    struct um_compare_measurements *m = import(tables[i].text, &columns, &found);
    assert_int_equal(m->count, 2);
    assert_int_equal(found.form, tables[i].form);
    assert_int_equal(found.empty, 1);
    assert_true(found.sorted);
    assert_string_equal(m->channel[0].of, "V");
    assert_int_equal(m->channel[0].quantity, UM_QUANTITY_MAGNITUDE_VEGA);
    assert_close(m->row[0].t_tai, t, 2e-6);
    assert_close(m->row[1].t_tai, t + 86.4, 2e-6);
    assert_true(m->row[0].value == 7.25 && isnan(m->row[0].sigma));
    assert_true(m->row[1].value == 7.5 && m->row[1].sigma == 0.05);
    um_compare_measurements_destroy(context, &m);
  }
}

/* What the columns are: kinds, units, systems by the names of bands, flags, exposures, tracks. */
static void test_kinds(void **state)
{
  (void)state;
  static const char text[] = "jd,T_C,F,n,g_mag,bad,t_exp,pass,e\n"
                             "2457653.35625,8.25,2e-12,1500,12.5,0,0.5,a,0.5\n"
                             "2457653.35626,9.25,3e-12,1600,12.6,2,,b,\n";
  static const struct {
    struct um_compare_columns columns;
    enum um_compare_quantity quantity;
    double value, sigma;
    const char *map;
  } kinds[] = {
      {{.temperature = "T_C", .of = "panel.front", .sigma = "e"},
       UM_QUANTITY_TEMPERATURE,
       281.4,
       0.5,
       "time=jd temperature=T_C of=panel.front unit=C sigma=e"},
      {{.temperature = "T_C", .of = "x", .unit = "K"},
       UM_QUANTITY_TEMPERATURE,
       8.25,
       NAN,
       "time=jd temperature=T_C of=x unit=K"},
      {{.flux = "F", .band = "lwir", .unit = "erg/s/cm2", .sigma = "e"},
       UM_QUANTITY_BAND_IRRADIANCE,
       2e-15,
       5e-4,
       "time=jd flux=F band=lwir unit=erg/s/cm2 sigma=e"},
      {{.flux = "F", .band = "lwir", .unit = "W/sr"},
       UM_QUANTITY_RADIANT_INTENSITY,
       2e-12,
       NAN,
       "time=jd flux=F band=lwir unit=W/sr"},
      {{.counts = "n", .of = "ufo"}, UM_QUANTITY_COUNT_RATE, 1500, NAN, "time=jd counts=n of=ufo"},
      {{.magnitude = "g_mag", .flag = "bad", .exposure = "t_exp", .track = "pass"},
       UM_QUANTITY_MAGNITUDE_AB,
       12.5,
       NAN,
       "time=jd magnitude=g_mag band=g system=ab flag=bad exposure=t_exp track=pass"},
      {{.magnitude = "g_mag", .band = "clear", .system = "vega"},
       UM_QUANTITY_MAGNITUDE_VEGA,
       12.5,
       NAN,
       "time=jd magnitude=g_mag band=clear system=vega"},
  };
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    struct um_compare_columns columns = kinds[i].columns;
    struct um_compare_imported found;
    char *map;
    columns.time = "jd";
    struct um_compare_measurements *m = import(text, &columns, &found);
    assert_int_equal(m->count, 2);
    assert_int_equal(m->channel[0].quantity, kinds[i].quantity);
    assert_close(m->row[0].value, kinds[i].value, 1e-12 * kinds[i].value);
    if (isnan(kinds[i].sigma))
      assert_true(isnan(m->row[0].sigma));
    else
      assert_close(m->row[0].sigma, kinds[i].sigma, 1e-15);
    assert_ok(um_compare_columns_text(context, &found.columns, &map));
    assert_string_equal(map, kinds[i].map);
    um_core_free(context, map);
    if (columns.flag != NULL) {
      assert_int_equal(m->row[1].flag, 2);
      assert_true(m->row[0].exposure == 0.5 && isnan(m->row[1].exposure));
      assert_string_equal(m->track[m->row[1].track], "b");
    }
    um_compare_measurements_destroy(context, &m);
  }
}

/* The map stands at the head of the file that is written, which reads as measurements, and is read
 * back from there; names may hold blanks and quotes. */
static void test_map(void **state)
{
  (void)state;
  struct um_compare_columns columns = {
      .time = "when, UTC", .magnitude = "R \"Johnson\"", .band = "vis", .system = "vega"};
  struct um_compare_columns back;
  struct um_compare_imported found;
  char *map, *text = NULL;
  static const char table[] = "\"when, UTC\",\"R \"\"Johnson\"\"\"\n2016-09-21T20:33:00Z,7.5\n";
  struct um_compare_measurements *m = import(table, &columns, &found), *again;
  assert_ok(um_compare_columns_text(context, &found.columns, &map));
  char note[200];
  snprintf(note, sizeof note, UM_COMPARE_IMPORT_MARK "%s", map);
  assert_ok(um_compare_measurements_write_noted(context, m, note, "w.csv"));
  assert_ok(um_compare_measurements_read(context, "w.csv", &again));
  assert_true(again->count == 1 && again->row[0].value == 7.5);
  um_compare_measurements_destroy(context, &again);
  assert_ok(um_compare_columns_read(context, "w.csv", &back, &text));
  for (size_t i = 0; um_compare_columns_word(i) != NULL; i++) {
    const char *a = *um_compare_columns_member(&found.columns, i);
    const char *b = *um_compare_columns_member(&back, i);
    assert_true((a == NULL) == (b == NULL));
    if (a != NULL) assert_string_equal(a, b);
  }
  um_core_free(context, text);
  um_core_free(context, map);
  um_compare_measurements_destroy(context, &m);
  put("t.txt", "# umbra import: time=UTC colour=red\n");
  assert_refused(um_compare_columns_read(context, "t.txt", &back, &text), UM_ERR_INPUT,
                 "t.txt: 'colour' in its line '# umbra import: ...' is not understood; accepted: "
                 "the line as umbra import wrote it");
  put("t.txt", "# other\ntime_utc,quantity\n");
  assert_refused(um_compare_columns_read(context, "t.txt", &back, &text), UM_ERR_INPUT,
                 "t.txt: no line '# umbra import: ...' at its head; accepted: a file that umbra "
                 "import wrote from a table");
}

#define HEAD "UTC,V,Verr\n"
#define ROW  "2016-09-21T20:33:00Z,7.5,0.1\n"

static void test_refusals(void **state)
{
  (void)state;
#define V .time = "UTC", .magnitude = "V"
  static const struct {
    const char *text;
    struct um_compare_columns columns;
    const char *says;
  } cases[] = {
      {HEAD ROW,
       {.time = "UTC", .magnitude = "Vmagn"},
       "t.txt: no column 'Vmagn'; the file has: "
       "UTC, V, Verr"},
      {HEAD ROW,
       {V, .sigma = "Ver"},
       "t.txt: no column 'Ver'; did you mean 'Verr'?; the file has: "
       "UTC, V, Verr"},
      {HEAD ROW,
       {.magnitude = "V"},
       "t.txt: which column is the time? accepted: --time COLUMN, or DATE+TIME"},
      {HEAD ROW,
       {.time = "UTC"},
       "t.txt: which column is the value? accepted: one of --magnitude, --flux, --counts, "
       "--temperature COLUMN"},
      {HEAD ROW,
       {V, .flux = "V"},
       "t.txt: more than one kind of value; accepted: one of --magnitude, --flux, --counts, "
       "--temperature COLUMN"},
      {HEAD ROW, {V, .band = "vis"}, NULL},
      {HEAD ROW,
       {.time = "UTC", .magnitude = "Verr"},
       "t.txt: column 'Verr': magnitudes of system AB or Vega? accepted: --system vega (as of "
       "Johnson, Cousins and Gaia filters), --system ab (SDSS, LSST)"},
      {HEAD ROW,
       {V, .of = "vis"},
       "--of vis: is for temperatures and counts; accepted: --band BAND"},
      {HEAD ROW,
       {.time = "UTC", .flux = "V", .band = "vis"},
       "t.txt: column 'V': unit not said; accepted: --unit W/m2, W/m^2, W/cm2, erg/s/cm2, W/sr"},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V", .of = "bus", .unit = "F"},
       "t.txt: column 'V': unit F; accepted: --unit K, C"},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V", .unit = "K"},
       "t.txt: column 'V': what is it of? accepted: --of PLACE, as temperatures.csv calls it"},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V=bus,Ver=panel", .unit = "K"},
       "t.txt: no column 'Ver'; did you mean 'Verr'?; the file has: UTC, V, Verr"},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V=bus,Verr", .unit = "K"},
       "--temperature: 'Verr'; accepted: COLUMN=PLACE,COLUMN=PLACE,..."},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V=bus,Verr=", .unit = "K"},
       "''; accepted: a name of at most 255 bytes without control characters and without ` \" \\ "
       "$"},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V=bus,Verr=panel"},
       "t.txt: column 'V': unit not said; accepted: --unit K, C"},
      {HEAD ROW,
       {.time = "UTC", .temperature = "V=bus,Verr=panel", .of = "x", .unit = "K"},
       "--of x: beside --temperature COLUMN=PLACE; accepted: one of the two"},
      {HEAD "20.9.2016 20:33,7.5,0.1\n",
       {V},
       "t.txt:2: column 'UTC': '20.9.2016 20:33' is no time that is known; accepted: UTC as "
       "2016-09-21T20:33:00.000Z, a Julian date, a modified one, POSIX seconds (not milliseconds)"},
      {HEAD "1474489980000,7.5,0.1\n",
       {V},
       "t.txt:2: column 'UTC': '1474489980000' is no time that is known; accepted: UTC as "
       "2016-09-21T20:33:00.000Z, a Julian date, a modified one, POSIX seconds (not milliseconds)"},
      {"# note\n" HEAD ROW "2016-09-21T20:33:01Z,bright,0.1\n",
       {V},
       "t.txt:4: column 'V': 'bright' is not a finite number"},
      {"UTC V Verr\n\n"
       "2016-09-21T20:33:01Z 99.5 0.1\n",
       {V},
       "t.txt:3: column 'V': magnitude 99.5 mag; accepted: -40 to 40 mag, or empty"},
      {HEAD "2016-09-21T20:33:01Z,7,0\n",
       {V, .sigma = "Verr"},
       "t.txt:2: column 'Verr': 0; accepted: above 0, or empty"},
      {HEAD ROW "2016-09-21T20:33:00Z,7.6,0.1\n",
       {V},
       "t.txt:3: column 'time': second row of magnitude_vega 'V' at 2016-09-21T20:33:00.000Z in "
       "track '', the first is line 2; accepted: one"},
      {"1474490066.4 7.5 0.05\n",
       {V},
       "t.txt:1: numbers where the names of the columns should stand; accepted: a first line of "
       "names, as '# time mag error'"},
      {"# nothing\n", {V}, "t.txt: empty; accepted: a table with a header"},
      {HEAD "2016-09-21T20:33:01Z,,\n",
       {V},
       "t.txt: no measurements; accepted: at least one row below the header"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct um_compare_imported found;
    struct um_compare_measurements *m;
    put("t.txt", cases[i].text);
    if (cases[i].says == NULL) {
      assert_ok(um_compare_import(context, "t.txt", &cases[i].columns, &found, &m));
      um_compare_measurements_destroy(context, &m);
      continue;
    }
    assert_refused(um_compare_import(context, "t.txt", &cases[i].columns, &found, &m), UM_ERR_INPUT,
                   cases[i].says);
    assert_null(m);
  }
}

/* A column a sensor, each with its unit. Rows of zeros are flagged where 0 is a temperature; a row
 * that repeats the one before is flagged where that is no chance; of two rows at one time the first
 * counts; a field that is empty is left out alone. */
static void test_sensors(void **state)
{
  (void)state;
  static const char table[] = "t,a_C,b_K,c\n"
                              "1474489980,1.5,280.25,1\n"
                              "1474490040,1.75,280.5,2\n"
                              "1474490100,1.75,280.5,3\n" /* held */
                              "1474490160,0,0.0,4\n"      /* zeros */
                              "1474490220,2.5,,5\n"
                              "1474490220,2.75,281,6\n" /* at the time of another */
                              "1474490280,3,281.5,7\n1474490340,3.25,281.75,8\n"
                              "1474490400,3.5,282,9\n1474490460,3.75,282.5,10\n";
  struct um_compare_columns columns = {.time = "t", .temperature = "a_C=bus,b_K=panel.+x"};
  struct um_compare_imported found;
  struct um_compare_measurements *m = import(table, &columns, &found);
  assert_int_equal(m->nchannel, 2);
  assert_string_equal(m->channel[1].of, "panel.+x");
  assert_int_equal(m->count, 2 * 7 + 1 + 1);
  assert_int_equal(found.zeros, 1);
  assert_int_equal(found.held, 1);
  assert_int_equal(found.doubled, 1);
  assert_int_equal(found.empty, 2); /* of b_K: what is not there, and 0 K */
  for (size_t i = 0; i < m->count; i++) {
    double after = m->row[i].t_tai - m->row[0].t_tai;
    bool bad = fabs(after - 120.0) < 1.0 || fabs(after - 180.0) < 1.0;
    assert_int_equal(m->row[i].flag, bad ? 1 : 0);
  }
  assert_close(m->row[0].value, 274.65, 1e-12);
  assert_close(m->row[1].value, 280.25, 1e-12);
  um_compare_measurements_destroy(context, &m);
  /* sensors of whole degrees repeat themselves by chance */
  m = import("t,a_C,b_C\n1474489980,1,5\n1474490040,1,5\n1474490100,1,6\n1474490160,2,6\n"
             "1474490220,2,7\n1474490280,2,7\n1474490340,3,7\n",
             &(struct um_compare_columns){.time = "t", .temperature = "a_C=bus,b_C=panel"}, &found);
  assert_int_equal(found.held, 0);
  for (size_t i = 0; i < m->count; i++) assert_int_equal(m->row[i].flag, 0);
  um_compare_measurements_destroy(context, &m);
}

/* The command that is proposed, by names and first rows; and that measurement readers propose it.
 */
static void test_suggestions(void **state)
{
  (void)state;
  static const struct {
    const char *text, *command;
  } cases[] = {
      {HEAD ROW, "--time UTC --magnitude V --sigma Verr"},
      {"station,epoch,az_deg,el_deg,Rmag,e_Rmag\nGraz,57652.85,10,20,7.5,0.1\n",
       "--time epoch --magnitude Rmag --sigma e_Rmag"},
      {"Date Time mag magerr\n2016-09-21 20:33:00 7.5 0.1\n",
       "--time Date+Time --magnitude mag --band BAND --system vega --sigma magerr"},
      {"t;panel temp;flag\n1474489980;8;0\n",
       "--time t --temperature 'panel temp' --of PLACE --unit K"},
      {"jd flux sigmaFlux\n2457653.3 1e-12 1e-13\n",
       "--time jd --flux flux --unit W/m2 --band BAND --sigma sigmaFlux"},
      {"jd counts\n2457653.3 800\n", "--time jd --counts counts --of SENSOR"},
      {"t,mV,Panel A (C),T_B_K,note\n1474489980,4500,8,281,x\n",
       "--time t --temperature 'Panel A (C)=PLACE,T_B_K=PLACE'"},
      {"t,A [degC],B \xC2\xB0"
       "C,degC\n1474489980,8,9,1\n",
       "--time t --temperature 'A [degC]=PLACE,B \xC2\xB0"
       "C=PLACE'"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    char *command, expected[300];
    struct um_compare_measurements *m;
    snprintf(expected, sizeof expected, "umbra import t.txt %s -o t-measured.csv",
             cases[i].command);
    put("t.txt", cases[i].text);
    assert_ok(um_compare_import_suggest(context, "t.txt", &command));
    assert_string_equal(command, expected);
    um_core_free(context, command);
    assert_int_equal(um_compare_measurements_read(context, "t.txt", &m), UM_ERR_INPUT);
    if (strstr(um_core_message(context), expected) == NULL)
      fail_msg("'%s' does not name '%s'", um_core_message(context), expected);
  }
  char *command;
  put("t.txt", "a,b\n1,2\n");
  assert_refused(um_compare_import_suggest(context, "t.txt", &command), UM_ERR_INPUT,
                 "t.txt: no column looks like a time; accepted: a table with a time (UTC, Julian "
                 "date, POSIX seconds) and a value in each row");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_forms),   cmocka_unit_test(test_kinds),
      cmocka_unit_test(test_map),     cmocka_unit_test(test_refusals),
      cmocka_unit_test(test_sensors), cmocka_unit_test(test_suggestions)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
