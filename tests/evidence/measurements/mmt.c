/* Survey tracks. The texts have the shape that the survey's site writes; the numbers are made up.
 */
#include "evidence/measurements/mmt.h"
#include "base/core/constants.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "orbit/time.h"
#include "tests/evidence/compare_test.h"

static const char track[] = "# satellite: 12345 SOME BODY / XX\n"
                            "# catalogue: 1 NORAD\n"
                            "# track: 678\n"
                            "# variability: 2 Periodic\n"
                            "# variability_period: 12.5\n"
                            "# npoints: 3\n"
                            "#\n"
                            "# Date Time StdMag Mag Filter Penumbra Distance Phase Channel\n"
                            "2014-08-23 19:40:10.123456 6.5 5.25 Clear 0 812.5 60.0 3\n"
                            "2014-08-23 19:40:10.123456 6.5 5.5 Clear 0 812.5 60.0 4\n"
                            "2014-08-23 19:40:11 6.75 5.75 Clear 1 815 61.5 3\n";

static void test_track(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  struct um_compare_mmt_point *p;
  double t;
  put("t.txt", track);
  assert_ok(um_compare_mmt_read(context, "t.txt", &m, &p));
  assert_int_equal(m->count, 3);
  assert_int_equal(m->nchannel, 1);
  assert_int_equal(m->channel[0].quantity, UM_QUANTITY_MAGNITUDE_VEGA);
  assert_string_equal(m->channel[0].of, "Clear");
  assert_int_equal(m->channel[0].count, 3);
  assert_int_equal(m->ntrack, 2); /* one a camera: both saw the same instant */
  assert_string_equal(m->track[0], "678/3");
  assert_string_equal(m->track[1], "678/4");
  assert_ok(um_orbit_time_parse(context, "2014-08-23T19:40:10.123456Z", &t));
  assert_true(m->row[0].t_tai == t);
  assert_true(m->row[0].value == 5.25 && isnan(m->row[0].sigma) && isnan(m->row[0].exposure));
  assert_int_equal(m->row[2].line, 11);
  assert_int_equal(m->row[2].flag, 0);
  assert_false(m->independent);
  assert_true(p[0].standard_magnitude == 6.5 && p[0].distance == 812500.0);
  assert_close(p[2].phase, 61.5 * UM_PI / 180.0, 1e-15);
  assert_true(!p[0].penumbra && p[2].penumbra);
  /* written in the program's own format it reads back */
  assert_ok(um_compare_measurements_write(context, m, "w.csv"));
  struct um_compare_measurements *b;
  assert_ok(um_compare_measurements_read(context, "w.csv", &b));
  assert_int_equal(b->count, 3);
  assert_close(b->row[0].t_tai, t, 2e-7);
  um_compare_measurements_destroy(context, &b);
  um_compare_measurements_destroy(context, &m);
  um_core_free(context, p);
}

/* The file of a satellite has a column of tracks; the fewest columns are four; CRLF. */
static void test_columns(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  put("t.txt", "# Date Time StdMag Mag Filter Penumbra Distance Phase Channel Track\n"
               "2014-08-23 19:40:11 6.75 5.75 B 1 815 61.5 3 70\n"
               "2014-08-23 19:40:10 6.75 5.75 V 1 815 61.5 3 71\n");
  assert_ok(um_compare_mmt_read(context, "t.txt", &m, NULL));
  assert_int_equal(m->nchannel, 2);
  assert_string_equal(m->track[1], "71/3");
  um_compare_measurements_destroy(context, &m);
  put("t.txt", "#Date Time Mag Filter\r\n\r\n2014-08-23 19:40:11 -1.5 R\r\n");
  struct um_compare_mmt_point *p;
  assert_ok(um_compare_mmt_read(context, "t.txt", &m, &p));
  assert_string_equal(m->track[0], "");
  assert_string_equal(m->channel[0].of, "R");
  assert_true(m->row[0].value == -1.5 && isnan(p[0].distance) && !p[0].penumbra);
  um_compare_measurements_destroy(context, &m);
  um_core_free(context, p);
}

#define HEAD "# Date Time StdMag Mag Filter Penumbra Distance Phase Channel\n"
#define D    "2014-08-23 19:40:10 "

static const struct {
  const char *text, *message;
} refusals[] = {
    {"", "t.txt: no measurements; accepted: at least one row below the header"},
    {D "6 5 V 0 800 60 1\n",
     "t.txt:1: a row before the line of column names; accepted: '# Date Time StdMag Mag Filter "
     "Penumbra Distance Phase Channel Track' above the rows"},
    {"# Date Time Mag Filter Colour\n",
     "t.txt:1: column 'Colour' is unknown; accepted: Date, Time, Mag, Filter, StdMag, Penumbra, "
     "Distance, Phase, Channel, Track, Satellite, each once"},
    {"# Date Time Mag Filter Mag\n",
     "t.txt:1: column 'Mag' is there twice; accepted: Date, Time, Mag, Filter, StdMag, Penumbra, "
     "Distance, Phase, Channel, Track, Satellite, each once"},
    {"# Date Time StdMag Filter\n",
     "t.txt:1: column 'Mag' is missing; needed: Date, Time, Mag, Filter"},
    {HEAD D "6 5 V 0 800 60\n",
     "t.txt:2: 8 fields; accepted: 9, as many as there are column names"},
    {HEAD D "6 5 V 0 800 60 1 2 3 4 5 6\n",
     "t.txt:2: more than 11 fields; accepted: 9, as many as there are column names"},
    {HEAD "2014-08-23 25:40:10 6 5 V 0 800 60 1\n",
     "t.txt:2: column 'Time': '2014-08-23T25:40:10': the hour is 00 to 23"},
    {HEAD D "6 None V 0 800 60 1\n", "t.txt:2: column 'Mag': 'None'; accepted: -40 to 40 mag"},
    {HEAD D "6 99 V 0 800 60 1\n", "t.txt:2: column 'Mag': '99'; accepted: -40 to 40 mag"},
    {HEAD D "6 5 V 2 800 60 1\n", "t.txt:2: column 'Penumbra': '2'; accepted: 0 or 1"},
    {HEAD D "6 5 V 0.5 800 60 1\n", "t.txt:2: column 'Penumbra': '0.5'; accepted: 0 or 1"},
    {HEAD D "6 5 V 0 -8 60 1\n", "t.txt:2: column 'Distance': '-8'; accepted: 1 to 1e6 km"},
    {HEAD D "6 5 V 0 800 190 1\n", "t.txt:2: column 'Phase': '190'; accepted: 0 to 180 deg"},
    {HEAD D "6 5 V 0 800 60 1\n2014-08-23 19:40:09.9 6 5 V 0 800 60 1\n",
     "t.txt:3: column 'Time': 2014-08-23T19:40:09.900Z is before 2014-08-23T19:40:10.000Z of line "
     "2 in track '/1'; accepted: rows in time order within a track"},
    {HEAD D "6 5 V 0 800 60 1\n" D "6 5 V 0 800 60 1\n",
     "t.txt:3: column 'Time': second row of magnitude_vega 'V' at 2014-08-23T19:40:10.000Z in "
     "track '/1', the first is line 2; accepted: one"},
    {"# Date Time Mag Filter Satellite\n" D "5 V 100\n" D "5 B 200\n",
     "t.txt:3: satellite 200, the rows before are of 100; accepted: one satellite"}};

static void test_refusals(void **state)
{
  (void)state;
  struct um_compare_measurements *m;
  struct um_compare_mmt_point *p;
  for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
    put("t.txt", refusals[i].text);
    assert_refused(um_compare_mmt_read(context, "t.txt", &m, &p), UM_ERR_INPUT,
                   refusals[i].message);
    assert_true(m == NULL && p == NULL);
  }
  assert_refused(um_compare_mmt_read(context, "none.txt", &m, NULL), UM_ERR_IO,
                 "none.txt: No such file or directory");
}

/* One byte changed, at every byte in turn: read or refused, never a crash. */
static void test_damage(void **state)
{
  (void)state;
  char text[sizeof track];
  for (size_t i = 0; i + 1 < sizeof track; i++) {
    struct um_compare_measurements *m = NULL;
    memcpy(text, track, sizeof track);
    text[i] = (char)(1 + um_core_hash(9, i) % 127);
    put("t.txt", text);
    um_core_message_clear(context);
    enum um_status status = um_compare_mmt_read(context, "t.txt", &m, NULL);
    assert_true(status == UM_OK || status == UM_ERR_INPUT);
    um_compare_measurements_destroy(context, &m);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_track), cmocka_unit_test(test_columns),
                                     cmocka_unit_test(test_refusals),
                                     cmocka_unit_test(test_damage)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
