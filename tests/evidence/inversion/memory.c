/* Memory that runs out: every allocation fails once, at each place in turn. Each time the call
 * returns UM_ERR_MEMORY, hands nothing out and leaves nothing behind. */
#include "evidence/comparison/metrics.h"
#include "evidence/comparison/series.h"
#include "evidence/inversion/fold.h"
#include "evidence/inversion/period.h"
#include "evidence/measurements/import.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/mmt.h"
#include "evidence/measurements/write.h"
#include "tests/evidence/compare_test.h"
#include "tests/support/memory_sweep.h"

/* Everything that allocates, once. */
static enum um_status everything(struct um_context *c)
{
  struct um_compare_measurements *m = NULL, *survey = NULL;
  struct um_compare_mmt_point *points = NULL;
  struct um_compare_series *series = NULL;
  struct um_compare_period *period = NULL;
  struct um_compare_fold_bin bin[4];
  struct um_compare_residual residual;
  struct um_compare_metrics all;
  enum um_status status;
  UM_CHECK(um_compare_measurements_read(c, "m.csv", &m));
  UM_CHECK(um_compare_measurements_write(c, m, "w.csv"));
  UM_CHECK(um_compare_mmt_read(c, "t.txt", &survey, &points));
  UM_CHECK(um_compare_series_create(c, m, 0, SIZE_MAX, &series));
  UM_CHECK(um_compare_period_search(c, series, NULL, &period));
  UM_CHECK(um_compare_fold(c, series, period, 4, bin));
  residual = (struct um_compare_residual){series->value[0], series->value[0], NAN, 0.0};
  UM_CHECK(um_compare_metrics_compute(c, UM_QUANTITY_COUNT_RATE, 1, &residual, NULL, 0, 0.0, NULL,
                                      &all));
done:
  if (status != UM_OK && m == NULL) assert_null(survey);
  um_compare_measurements_destroy(c, &m);
  um_compare_measurements_destroy(c, &survey);
  um_compare_series_destroy(c, &series);
  um_compare_period_destroy(c, &period);
  um_core_free(c, points);
  return status;
}

static void test_every_allocation(void **state)
{
  (void)state;
  FILE *file = fopen("m.csv", "wb"), *survey = fopen("t.txt", "wb");
  assert_true(file != NULL && survey != NULL);
  fputs("time_utc,quantity,of,value,sigma,track,station\n", file);
  fputs("# Date Time Mag Filter Channel Track\n", survey);
  for (int i = 0; i < 59; i++) { /* enough for every table to grow */
    fprintf(file, "2016-09-21T20:36:%02dZ,count_rate,ufo,%d,,t%d,s%d\n", i, i * i % 7,
            i < 30 ? 0 : i, i % 3); /* one track that has a period, many names */
    fprintf(survey, "2016-09-21 20:36:%02d %d V 1 %d\n", i, i % 5, i);
    fprintf(survey, "2016-09-21 20:36:%02d %d B 2 %d\n", i, i % 5, i);
  }
  fclose(file);
  fclose(survey);
  memory_sweep(everything, 100);
}

/* A table of any header: read, written with its columns, which are read back, and proposed. */
static enum um_status import(struct um_context *c)
{
  static const struct um_compare_columns columns = {.time = "t+clock", .magnitude = "Vmag"};
  struct um_compare_measurements *m = NULL;
  struct um_compare_imported found;
  struct um_compare_columns back;
  char *map = NULL, *text = NULL, *command = NULL;
  enum um_status status;
  UM_CHECK(um_compare_import(c, "t.txt", &columns, &found, &m));
  UM_CHECK(um_compare_columns_text(c, &found.columns, &map));
  UM_CHECK(um_compare_measurements_write_noted(c, m, UM_COMPARE_IMPORT_MARK "time=t", "w.csv"));
  UM_CHECK(um_compare_columns_read(c, "w.csv", &back, &text));
  UM_CHECK(um_compare_import_suggest(c, "t.txt", &command));
done:
  um_compare_measurements_destroy(c, &m);
  um_core_free(c, map);
  um_core_free(c, text);
  um_core_free(c, command);
  return status;
}

static void test_import(void **state)
{
  (void)state;
  FILE *file = fopen("t.txt", "wb");
  assert_non_null(file);
  fputs("# t clock Vmag\n", file);
  for (int i = 0; i < 300; i++)
    fprintf(file, "2016-09-21 20:%02d:%02d %d\n", i / 60, i % 60, i % 5);
  fclose(file);
  memory_sweep(import, 20);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_allocation),
                                     cmocka_unit_test(test_import)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
