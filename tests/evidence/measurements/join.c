/* Files of measurements joined: rows behind each other, and everything that names are of kept apart
 * by file. Expected values are read off the texts. */
#include "evidence/measurements/join.h"
#include "evidence/measurements/measurements.h"
#include "tests/evidence/compare_test.h"

#define HEAD "time_utc,quantity,of,value,sigma,track\n"

static void put_files(void)
{
  put("m.csv", HEAD "2026-03-20T10:00:00Z,band_irradiance,lwir,1e-12,1e-14,t\n"
                    "2026-03-20T10:00:05Z,band_irradiance,vis,2e-12,1e-14,t\n");
  put("w.csv", "mjd_utc,quantity,of,value,sigma\n"
               "61117.0,band_irradiance,lwir,3e-12,1e-14\n"); /* two days before */
}

static void test_apart(void **state)
{
  (void)state;
  static const char *const path[] = {"m.csv", "w.csv"};
  struct um_compare_measurements *m;
  put_files();
  assert_ok(um_compare_measurements_read_all(context, path, 2, &m));
  assert_string_equal(m->path, "m.csv, w.csv");
  assert_int_equal(m->count, 3);
  assert_int_equal(m->nfile, 2);
  assert_string_equal(m->file[0].name, "m");
  assert_string_equal(m->file[1].name, "w");
  assert_int_equal(um_compare_set_find(m, "w"), 1);
  assert_int_equal(um_compare_set_find(m, "v"), UM_COMPARE_NOWHERE);
  assert_int_equal(m->nchannel, 3); /* lwir of either is a channel of its own */
  assert_string_equal(m->channel[0].label, "lwir@m");
  assert_string_equal(m->channel[2].label, "lwir@w");
  assert_string_equal(m->channel[2].of, "lwir");
  assert_int_equal(m->channel[2].set, 1);
  assert_int_equal(m->channel[2].count, 1);
  assert_true(m->row[2].value == 3e-12);
  assert_int_equal(m->row[2].set, 1);
  assert_int_equal(m->row[2].channel, 2);
  assert_int_equal(m->ntrack, 2);
  assert_string_equal(m->track[m->row[1].track], "t");
  assert_string_equal(m->track[m->row[2].track], "");
  assert_string_equal(um_compare_row_path(m, 1), "m.csv");
  assert_string_equal(um_compare_row_path(m, 2), "w.csv");
  assert_string_equal(um_compare_row_time_column(m, 2), "mjd_utc");
  um_compare_measurements_destroy(context, &m);
  assert_ok(um_compare_measurements_read_all(context, path, 1, &m));
  assert_int_equal(m->nfile, 1);
  assert_string_equal(m->channel[0].label, "lwir"); /* one file is as it ever was */
  um_compare_measurements_destroy(context, &m);
}

static void test_names(void **state)
{
  (void)state;
  static const char *const path[] = {"m.csv", "./m.csv"};
  static const char *const name[] = {"dawn", "dusk"}, *const twice[] = {"dawn", "dawn"};
  struct um_compare_measurements *m, *part[2];
  put_files();
  assert_ok(um_compare_measurements_read_all(context, path, 2, &m));
  assert_string_equal(m->file[0].name, "m");
  assert_string_equal(m->file[1].name, "m-2");
  assert_string_equal(m->channel[2].label, "lwir@m-2");
  um_compare_measurements_destroy(context, &m);
  for (size_t i = 0; i < 2; i++)
    assert_ok(um_compare_measurements_read(context, path[i], &part[i]));
  assert_ok(um_compare_measurements_join(context, part, name, 2, &m));
  assert_string_equal(m->channel[3].label, "vis@dusk");
  um_compare_measurements_destroy(context, &m);
  um_core_message_clear(context);
  assert_int_equal(um_compare_measurements_join(context, part, twice, 2, &m), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "two sets are called 'dawn'"));
  assert_null(m);
  part[1]->independent = true;
  um_core_message_clear(context);
  assert_int_equal(um_compare_measurements_join(context, part, NULL, 2, &m), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "m.csv has none; accepted: all files"));
  for (size_t i = 0; i < 2; i++) um_compare_measurements_destroy(context, &part[i]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_apart), cmocka_unit_test(test_names)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
