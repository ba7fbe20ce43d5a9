/* Measurements out of messages and logs that become a table first: tracking data messages, data
 * messages of CNES, logs of visual observers. */
#include "tests/evidence/import_test.h"

static const struct um_compare_columns tracks = {
    .time = "time_utc", .magnitude = "MAG", .track = "track", .band = "V"};

/* Three magnitudes of two tracks, 0, 60.5 and 120 s after the first. */
static void expect_tracks(const char *text)
{
  struct um_compare_imported found;
  struct um_compare_measurements *m = import(text, &tracks, &found);
  assert_int_equal(m->count, 3);
  assert_int_equal(m->ntrack, 2);
  assert_close(m->row[0].value, 7.25, 0.0);
  assert_close(m->row[1].value, -0.5, 0.0);
  assert_close(m->row[1].t_tai - m->row[0].t_tai, 60.5, 1e-6);
  assert_close(m->row[2].t_tai - m->row[0].t_tai, 120.0, 1e-6);
  um_compare_measurements_destroy(context, &m);
}

/* Magnitudes of a tracking data message; TAI was 36 s ahead of UTC in 2016. */
static void test_tracking_message(void **state)
{
  (void)state;
#define TDM                                                                                        \
  "CCSDS_TDM_VERS = 2.0\n COMMENT x = y\nCREATION_DATE = 2016-265T00:00:00\nORIGINATOR = X\n\n"
#define META(scale) "META_START\nTIME_SYSTEM = " scale "\nPARTICIPANT_1 = GRAZ\nMETA_STOP\n"
  static const char text[] =
      TDM META("UTC") "DATA_START\nANGLE_1 = 2016-09-21T20:33:00 12.5\n"
                      "MAG = 2016-09-21T20:33:00 7.25\nMAG=2016-265T20:34:00.5   -0.5\r\n"
                      "DATA_STOP\n" META("TAI") "DATA_START\n"
                                                "MAG = 2016-09-21T20:35:36.000 7\nDATA_STOP\n";
  expect_tracks(text);
  static const struct fault faults[] = {
      {TDM META("UTC") "DATA_START\nRANGE = 2016-09-21T20:33:00 900\nDATA_STOP\n",
       "t.txt: this TDM has no magnitudes; accepted: MAG rows, of which measurements are made"},
      {TDM META("UTC") "DATA_START\nMAG = 2016-09-21T20:33:00 7\n",
       "t.txt:11: DATA_STOP is missing: the file may be cut short"},
      {TDM META("UTC") "DATA_START\nMAG = 2016-09-21T20:33:00 bright\n",
       "t.txt:11: 'bright'; accepted: a magnitude"},
      {TDM META("UTC") "DATA_START\nMAG = 7\n", "t.txt:11: '7'; accepted: a time and a magnitude"},
      {TDM META("TDB"), "t.txt:7: 'TDB'; accepted: UTC, TAI, TT, GPS"},
      {TDM "META_START\nMETA_STOP\n",
       "t.txt:7: 'META_STOP'; accepted: TIME_SYSTEM before it, one of UTC, TAI, TT, GPS"},
      {TDM "DATA_START\n", "t.txt:6: 'DATA_START'; accepted: META_START before it"},
      {TDM "rubbish\n", "t.txt:6: 'rubbish'; accepted: KEYWORD = value"},
  };
  expect_refused(faults, sizeof faults / sizeof *faults, &tracks);
}

/* The same in XML: lines of messages are the file's, and a file without line ends has its rows. */
static void test_tracking_xml(void **state)
{
  (void)state;
#define XML(scale)                                                                                 \
  "<segment><metadata><TIME_SYSTEM>" scale "</TIME_SYSTEM><PARTICIPANT_1>GRAZ</PARTICIPANT_1>"     \
  "</metadata><data>"
#define SEEN(time, what) "<observation><EPOCH>" time "</EPOCH>" what "</observation>"
  static const char text[] =
      "<?xml version=\"1.0\"?><ndm><tdm id=\"CCSDS_TDM_VERS\" version=\"2.0\"><header/><body>" XML(
          "UTC") SEEN("2016-09-21T20:33:00", "<ANGLE_1>12.5</ANGLE_1>")
          SEEN("2016-09-21T20:33:00", "<MAG>7.25</MAG>")
              SEEN("2016-265T20:34:00.5", "<MAG> -0.5 </MAG>") "</data></segment>" XML("TAI") SEEN(
                  "2016-09-21T20:35:36.000", "<MAG>7</MAG>") "</data></segment></body></tdm></ndm>";
  expect_tracks(text);
  static const struct fault faults[] = {
      {"<tdm>\n" XML("UTC") "\n\n" SEEN("2016-09-21T20:33:00", "<MAG>bright</MAG>"),
       "t.txt:4: 'bright'; accepted: a magnitude"},
      {"<tdm>\n" XML("TDB"), "t.txt:2: 'TDB'; accepted: UTC, TAI, TT, GPS"},
      {"<tdm>\n<segment><metadata/>",
       "t.txt:2: 'META_STOP'; accepted: TIME_SYSTEM before it, one of UTC, TAI, TT, GPS"},
      {"<tdm>\n" XML("UTC") "<observation><MAG>7</MAG>",
       "t.txt:2: MAG: '7'; accepted: EPOCH before it"},
      {"<tdm>" XML("UTC") SEEN("2016-09-21T20:33:00", "<RANGE>7</RANGE>") "</data></segment></tdm>",
       "t.txt: this TDM has no magnitudes; accepted: MAG rows, of which measurements are made"},
      {"<ndm/>", "t.txt: no element tdm; accepted: navigation messages (NDM/XML) with one"},
      {"<tdm>" XML("UTC"), "t.txt:1: not XML as it should be: no element found"},
  };
  expect_refused(faults, sizeof faults / sizeof *faults, &tracks);
}

/* Data messages of CNES: a value a row in two segments behind the mark of UTF-8, then three, one of
 * them a text. The keys that may lack are left out of the first, as CNES's own script for such
 * files does. */
static void test_data_message(void **state)
{
  (void)state;
#define MEM "CIC_MEM_VERS = 1.0\nCREATION_DATE  = 2016-09-22T08:00:00\nORIGINATOR     = X\n\n"
#define OF(content, scale)                                                                         \
  "META_START\n\nOBJECT_NAME = SAT\nOBJECT_ID = SAT\n\nUSER_DEFINED_PROTOCOL = CIC\n"              \
  "USER_DEFINED_CONTENT = " content "\nTIME_SYSTEM = " scale "\n\nMETA_STOP\n\n"
#define ROWS "57652 73980.000000 12.5\n57652 73990.5 -3\r\n"
  struct um_compare_columns columns = {
      .time = "time_utc", .temperature = "PANEL", .of = "panel", .unit = "C"};
  struct um_compare_imported found;
  struct um_compare_measurements *m =
      import("\xef\xbb\xbf" MEM OF("PANEL", "UTC") ROWS OF("PANEL", "UTC") "57653 0.0 1\n",
             &columns, &found);
  assert_int_equal(m->count, 3);
  assert_close(m->row[0].value, 285.65, 1e-12);
  assert_close(m->row[1].t_tai - m->row[0].t_tai, 10.5, 1e-6);
  assert_close(m->row[2].t_tai - m->row[0].t_tai, 86400.0 - 73980.0, 1e-6);
  um_compare_measurements_destroy(context, &m);
  static const char three[] =
      MEM "META_START\nUSER_DEFINED_CONTENT = T\nUSER_DEFINED_SIZE = 3\n"
          "USER_DEFINED_UNIT = [degC]\nTIME_SYSTEM = TAI\nCOMMENT x\nMETA_STOP\n"
          "57652 74016.0 20 \"a b\" 21\n";
  columns = (struct um_compare_columns){.time = "time_utc",
                                        .temperature = "T_1 (degC)=bus,T_3 (degC)=panel"};
  struct um_compare_measurements *again = import(three, &columns, &found);
  assert_int_equal(again->count, 2);
  assert_close(again->row[1].value, 294.15, 1e-12);
  um_compare_measurements_destroy(context, &again);
  static const struct fault faults[] = {
      {MEM OF("PANEL", "UTC"), "t.txt:15: no rows behind META_STOP: the file may be cut short"},
      {MEM OF("PANEL", "TDB"), "t.txt:12: 'TDB'; accepted: UTC, TAI, TT, GPS"},
      {MEM OF("PANEL", "UTC") ROWS OF("BUS", "UTC") ROWS,
       "t.txt:24: USER_DEFINED_CONTENT: 'PANEL' in one segment, 'BUS' in another; accepted: files "
       "of one quantity"},
      {MEM OF("PANEL", "UTC") "57652 73980 1\n57652 73990 1 2\n",
       "t.txt:17: 2 values; accepted: 1, as USER_DEFINED_SIZE or the first row has"},
      {MEM OF("PANEL", "UTC") "2016-09-21T20:33:00 1\n",
       "t.txt:16: '2016-09-21T20:33:00'; accepted: a modified Julian day and seconds of it, 57652 "
       "73862.0"},
      {MEM "57652 73980 1\n", "t.txt:5: '57652 73980 1'; accepted: META_START before rows"},
      {MEM "META_START\nUSER_DEFINED_SIZE = 0\n",
       "t.txt:6: '0'; accepted: values of a row, 1 to 256, the same in each segment"},
      {MEM "META_START\nMETA_STOP\n",
       "t.txt:6: 'META_STOP'; accepted: USER_DEFINED_CONTENT and TIME_SYSTEM before it"},
  };
  expect_refused(faults, sizeof faults / sizeof *faults, &columns);
#undef MEM
#undef OF
#undef ROWS
}

/* Observations of visual observers, in a letter: of five lines three have a magnitude, one its
 * uncertainty; what the format's description has as examples ("+070" 7.0, "10" 1.0). */
static void test_visual_observers(void **state)
{
  (void)state;
#define OBJECT "27386 02 009A   2007 G "
#define ANGLES " 56 25 1122334+112233 28 "
  static const char text[] =
      "Clear and calm.\n" OBJECT "20160921203300500" ANGLES "R+053 05\n" OBJECT
      "201609212033105  " ANGLES "S+06\r\n" OBJECT "20160921203320000" ANGLES "S\n"
      "                2007 C 20160922\n" OBJECT "201609212034     " ANGLES "B-005    12350\n";
  struct um_compare_columns columns = {
      .time = "time_utc", .magnitude = "MAG", .band = "V", .system = "vega"};
  struct um_compare_imported found;
  struct um_compare_measurements *m = import(text, &columns, &found);
  assert_int_equal(m->count, 3);
  static const double magnitude[] = {5.3, 6.0, -0.5}, after[] = {0.0, 10.0, 59.5};
  for (size_t i = 0; i < 3; i++) {
    assert_close(m->row[i].value, magnitude[i], 1e-12);
    assert_close(m->row[i].t_tai - m->row[0].t_tai, after[i], 1e-3);
  }
  um_compare_measurements_destroy(context, &m);
  static const struct fault faults[] = {
      {OBJECT "20160921203320000" ANGLES "S\n",
       "t.txt: no line has a magnitude; accepted: lines of the IOD format with a sign in column 67 "
       "and MMm behind it"},
      {OBJECT "20160921203320000" ANGLES "S+0\n",
       "t.txt:1: '0'; accepted: a magnitude MMm in columns 68 to 70, '070' for 7.0"},
      {OBJECT "20160921203320000" ANGLES "S+070 x\n",
       "t.txt:1: 'x'; accepted: an uncertainty Mm in columns 72 and 73"},
      {OBJECT "20160932203320000" ANGLES "S+070\n",
       "t.txt:1: '2016-09-32T20:33:20.000'; accepted: a UTC time like 2016-09-21T20:33:00Z (that "
       "month does not have this day)"},
      {OBJECT "2016092120       " ANGLES "S+070\n",
       "t.txt:1: '20'; accepted: HHMMSSsss in columns 32 to 40, HHMM at least"},
      {OBJECT "20160921203320000" ANGLES "S+070\n"
              "27387 02 009A   2007 G 20160921203320000" ANGLES "S+070\n",
       "t.txt:2: object '27387' after '27386'; accepted: observations of one object"},
  };
  expect_refused(faults, sizeof faults / sizeof *faults, &columns);
#undef OBJECT
#undef ANGLES
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_tracking_message), cmocka_unit_test(test_tracking_xml),
      cmocka_unit_test(test_data_message), cmocka_unit_test(test_visual_observers)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
