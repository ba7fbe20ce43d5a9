/* The statistics of a study, its tables and sentences, against a pass in closed form. */
#include "study/statistics.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/uncertainty/statistics.h"
#include "orbit/time.h"
#include "study/per_point.h"
#include "study/report.h"
#include "study/rule.h"
#include "tests/study/pass_test.h"
#include "tests/support/temporary.h"

/* Surrogate, Saltelli, Morris and plain points agree on who rules. */
static void test_designs(void **state)
{
  (void)state;
  double *u;
  struct um_study_statistics *l[4];
  struct um_study_result *r[4];
  r[0] = pass_sobol(256, true);
  assert_int_equal(um_uncertainty_saltelli(context, 3, 512, 1, &u), UM_OK);
  r[1] = pass_result(UM_STUDY_SALTELLI, 512, 512 * 5, u, false);
  assert_int_equal(um_uncertainty_morris_trajectories(context, 3, 64, 8, 1, &u), UM_OK);
  r[2] = pass_result(UM_STUDY_MORRIS, 64, 64 * 4, u, false);
  r[3] = pass_sobol(512, false);
  const enum um_study_indices expected[4] = {UM_STUDY_INDICES_SURROGATE, UM_STUDY_INDICES_SAMPLED,
                                             UM_STUDY_INDICES_MORRIS, UM_STUDY_INDICES_RANKS};
  for (size_t i = 0; i < 4; i++) {
    assert_int_equal(um_study_statistics_create(context, r[i], NULL, &l[i]), UM_OK);
    assert_int_equal(l[i]->indices, expected[i]);
    assert_int_equal(l[i]->ndone, r[i]->npoint);
    /* visible light hangs on the cells alone; nothing in the umbra; nothing is seen at first */
    assert_close(l[i]->over_curve[0], 1.0, i == 1 ? 0.05 : 1e-2);
    assert_close(l[i]->over_curve[1 * 4 + 0], 0.0, 0.02);
    assert_true(isnan(l[i]->first[0]));
    assert_close(l[i]->deviation[PASS_NTIME - 1], 0.0, 0.0);
    /* in the sun the cells, at the end the heat */
    size_t early = PASS_NTIME + 20, late = 2 * PASS_NTIME - 1;
    assert_true(l[i]->first[early] > 0.5);
    assert_true(l[i]->first[PASS_NVALUE + late] > l[i]->first[late]);
  }
  for (size_t k = PASS_NTIME + 1; k < 3 * PASS_NTIME; k++)
    for (size_t p = 0; p < 3; p++)
      assert_close(l[0]->first[p * PASS_NVALUE + k], l[1]->first[p * PASS_NVALUE + k],
                   0.05 + 4.0 * l[1]->first_error[p * PASS_NVALUE + k]);
  for (size_t i = 0; i < 4; i++) {
    um_study_statistics_destroy(context, &l[i]);
    um_study_result_destroy(context, &r[i]);
  }
}

/* What it leaves unexplained of each value's standard deviation, at the result's own points. */
static void find_unexplained(struct um_study_result *r)
{
  double *place = pass_doubles(r->npoint * 3), *value = pass_doubles(r->npoint * PASS_NVALUE),
         *deviation = pass_doubles(PASS_NVALUE);
  if (r->unexplained == NULL) r->unexplained = pass_doubles(PASS_NVALUE);
  for (size_t i = 0; i < r->npoint * 3; i++)
    place[i] = um_uncertainty_distribution_place(&r->distribution[i % 3], r->parameter[i]);
  assert_int_equal(um_uncertainty_surrogate_at(context, r->surrogate, place, r->npoint, value),
                   UM_OK);
  um_uncertainty_mean(r->npoint, PASS_NVALUE, value, NULL, NULL, deviation);
  for (size_t k = 0; k < PASS_NVALUE; k++) {
    double sum = 0.0;
    for (size_t i = 0; i < r->npoint; i++)
      sum += pow(value[i * PASS_NVALUE + k] - r->value[i * PASS_NVALUE + k], 2.0);
    r->unexplained[k] = sqrt(sum / (double)r->npoint) / deviation[k];
  }
  UM_FREE(context, place, value, deviation);
}

/* Indices of a surrogate that leaves something unexplained are off by no more than they say, those
 * of which it leaves too much are withheld, and a sentence says so. */
static void test_unexplained(void **state)
{
  (void)state;
  struct um_study_result *r = pass_sobol(1024, true);
  struct um_study_statistics *tight, *l;
  char *sentence;
  size_t said = 0, withheld = 0;
  double most = 0.0;
  assert_int_equal(um_study_statistics_create(context, r, NULL, &tight), UM_OK);
  assert_null(tight->first_error);
  for (size_t evaluations = 9; evaluations <= 18; evaluations++) {
    pass_surrogate(r, 2, evaluations);
    find_unexplained(r);
    assert_int_equal(um_study_statistics_create(context, r, NULL, &l), UM_OK);
    for (size_t i = 0; i < 3 * PASS_NVALUE; i++) {
      double lambda = r->unexplained[i % PASS_NVALUE], of = l->first_error[i];
      if (isnan(tight->first[i])) continue;
      assert_true(isfinite(l->first[i]) == (lambda <= UM_STUDY_BORNE));
      assert_true(isfinite(of) == isfinite(l->first[i]));
      withheld += isnan(of) ? 1 : 0;
      said += isnan(of) ? 0 : 1;
      if (isnan(of)) continue;
      assert_close(l->first[i], tight->first[i], of + 0.005);
      most = fmax(most, fabs(l->first[i] - tight->first[i]));
    }
    if (evaluations < 18) um_study_statistics_destroy(context, &l);
  }
  print_message("%zu indices, off by %.3g at most; %zu withheld\n", said, most, withheld);
  assert_true(said > 1000 && withheld > 300 && most > 0.01);
  um_study_statistics_destroy(context, &l);
  for (size_t k = PASS_NTIME; k < PASS_NTIME + 40; k++) r->unexplained[k] = 1.01 * UM_STUDY_BORNE;
  r->quantity[2].withheld = true;
  assert_int_equal(um_study_statistics_create(context, r, NULL, &l), UM_OK);
  assert_true(isnan(l->first[PASS_NTIME + 39]) && isfinite(l->first[PASS_NTIME + 40]));
  assert_int_equal(um_study_sentence(context, r, l, &r->quantity[1], &sentence), UM_OK);
  assert_non_null(strstr(sentence, "shares of parameters are withheld in 3.9 of 12 minutes"));
  um_core_free(context, sentence);
  assert_int_equal(um_study_sentence(context, r, l, &r->quantity[2], &sentence), UM_OK);
  assert_non_null(strstr(sentence, "shares of parameters are withheld at every instant"));
  um_core_free(context, sentence);
  um_study_statistics_destroy(context, &l);
  um_study_statistics_destroy(context, &tight);
  um_study_result_destroy(context, &r);
}

/* The median of a value that is monotonic in one uniform parameter is that at its middle. */
static void test_spread(void **state)
{
  (void)state;
  struct um_study_result *r = pass_sobol(1024, false);
  struct um_study_statistics *l;
  struct um_study_summary spread;
  const size_t k = 40;
  assert_int_equal(um_study_statistics_create(context, r, NULL, &l), UM_OK);
  for (size_t p = 0; p < UM_STUDY_QUANTILES; p++) {
    double at[3] = {0.9 - 0.2 * um_study_quantile[p], 300.0, 1.0}, v[PASS_NVALUE];
    pass_values(at, v); /* the more emittance, the less light */
    assert_close(l->quantile[p * PASS_NVALUE + k], v[k], 1e-3 * v[k]);
  }
  assert_int_equal(um_study_summarise(context, r, &r->quantity[0], UM_STUDY_LARGEST, NULL, &spread),
                   UM_OK);
  double largest = 0.0;
  for (size_t i = 1; i < PASS_NTIME; i++) largest = fmax(largest, r->nominal[i]);
  assert_close(spread.nominal, largest, 0.0);
  assert_close(spread.quantile[2], largest, 2e-3 * largest);
  assert_string_equal(um_study_statistic_word(&r->quantity[0], UM_STUDY_LARGEST), "largest");
  assert_string_equal(um_study_statistic_word(&r->quantity[3], UM_STUDY_MEAN), "value");
  um_study_statistics_destroy(context, &l);
  um_study_result_destroy(context, &r);
}

/* Stretches cover the pass without gaps; the heat's is the last, its first instant behind the
 * shadow's edge; the sentence says so. */
static void test_sentence(void **state)
{
  (void)state;
  struct um_study_result *r = pass_sobol(256, true);
  struct um_study_statistics *l;
  struct um_study_stretch *s;
  char *sentence;
  size_t n;
  assert_int_equal(um_study_statistics_create(context, r, NULL, &l), UM_OK);
  assert_int_equal(um_study_stretches(context, r, l, &r->quantity[1], &s, &n), UM_OK);
  assert_true(n >= 2 && n <= 4);
  assert_close(s[0].from, r->time[0], 0.0);
  assert_close(s[n - 1].to, r->time[PASS_NTIME - 1], 0.0);
  for (size_t i = 1; i < n; i++) {
    assert_close(s[i].from, s[i - 1].to, 0.0);
    assert_true(s[i].parameter != s[i - 1].parameter);
  }
  assert_int_equal(s[n - 1].parameter, 1);
  assert_true(s[n - 1].from > r->time[0] + PASS_EDGE * 720.0);
  um_core_free(context, s);
  for (size_t q = 0; q < 4; q++) {
    assert_int_equal(um_study_sentence(context, r, l, &r->quantity[q], &sentence), UM_OK);
    print_message("%s\n", sentence);
    if (q == 0) {
      assert_non_null(strstr(sentence, "irradiance:vis: cell_silicon emittance causes "));
      assert_non_null(strstr(sentence, " of the variance in 6."));
      assert_non_null(strstr(sentence, "nothing varies it in 5."));
      assert_null(strstr(sentence, "power_W"));
    }
    if (q == 1) assert_non_null(strstr(sentence, "parts.bus.interior.power_W causes "));
    um_core_free(context, sentence);
  }
  um_study_statistics_destroy(context, &l);
  um_study_result_destroy(context, &r);
}

/* Of the limit there is, at the brightest instant and at any. */
static void limit_read(const struct um_study_result *r, double probability[2], double *error)
{
  char line[400], middle[32];
  FILE *file = tmpfile();
  assert_non_null(file);
  assert_int_equal(um_study_limits_write(context, r, file, stdout), UM_OK);
  um_orbit_time_format(r->time[54], middle);
  rewind(file);
  probability[0] = probability[1] = *error = -1.0;
  while (fgets(line, sizeof line, file) != NULL) {
    double limit, p, e;
    const char *rest = strchr(line, ',');
    if (rest == NULL || sscanf(rest, ",irradiance:vis,%lf,%lf,%lf", &limit, &p, &e) != 3) continue;
    assert_close(limit, r->limit[0].value, 1e-5 * fabs(r->limit[0].value));
    if (strncmp(line, middle, strlen(middle)) == 0) {
      probability[0] = p;
      *error = e;
    }
    if (line[0] == ',') probability[1] = p;
  }
  fclose(file);
}

/* Visible light at the middle is above that of emittance 0.7 + 0.2 p in a share p of the points,
 * and so it is in magnitudes, of which the smaller is brighter. */
static void test_limits(void **state)
{
  (void)state;
  struct um_study_result *r = pass_sobol(1024, false);
  const double at[3] = {0.85, 300.0, 1.0};
  double v[PASS_NVALUE], probability[2], error;
  pass_values(at, v);
  assert_int_equal(um_core_allocate(context, 1, sizeof *r->limit, &r->limit), UM_OK);
  r->nlimit = 1;
  r->limit[0] = (struct um_study_limit){.quantity = 0, .value = v[54]}; /* the brightest */
  for (int magnitude = 0; magnitude < 2; magnitude++) {
    struct um_study_quantity *q = &r->quantity[0];
    if (magnitude) {
      um_core_free(context, q->unit);
      assert_int_equal(um_core_strdup(context, "mag", &q->unit), UM_OK);
      r->limit[0].value = -2.5 * log10(v[54]);
      for (size_t i = 0; i < r->npoint; i++)
        for (size_t k = 0; k < q->count; k++)
          r->value[i * PASS_NVALUE + k] = -2.5 * log10(r->value[i * PASS_NVALUE + k]);
    }
    limit_read(r, probability, &error);
    assert_close(probability[0], 0.75, 0.002);
    assert_close(probability[1], 0.75, 0.002);
    assert_close(error, sqrt(0.75 * 0.25 / 1024.0), 1e-4);
    /* the brightest of a pass is its 54th instant, whatever the point */
    assert_close(um_study_statistic_of(q, r->value, UM_STUDY_LARGEST), r->value[54], 0.0);
  }
  um_study_result_destroy(context, &r);
}

static size_t lines_of(const char *path, char *second, size_t size)
{
  FILE *file = fopen(path, "rb");
  size_t n = 0;
  char line[4000];
  assert_non_null(file);
  while (fgets(line, sizeof line, file) != NULL)
    if (++n == 2) snprintf(second, size, "%s", line);
  fclose(file);
  return n;
}

static void test_tables(void **state)
{
  (void)state;
  static const char *const name[4] = {"summary.csv", "curves.csv", "indices.csv", "table.md"};
  struct um_study_result *r = pass_sobol(256, true);
  struct um_study_statistics *l;
  struct um_core_folder *folder;
  char base[UM_TEST_PATH], path[UM_TEST_PATH + 40], line[4000];
  assert_int_equal(um_core_strdup(context, "bad | point", &r->reason[7]), UM_OK);
  for (size_t k = 0; k < PASS_NVALUE; k++) r->value[7 * PASS_NVALUE + k] = NAN;
  assert_int_equal(um_test_folder_create(base), 0);
  snprintf(path, sizeof path, "%s/out", base);
  assert_int_equal(um_study_statistics_create(context, r, NULL, &l), UM_OK);
  assert_int_equal(l->ndone, 255);
  assert_int_equal(um_core_folder_begin(context, path, false, &folder), UM_OK);
  assert_int_equal(um_study_report_write(context, r, l, folder), UM_OK);
  assert_int_equal(um_core_folder_commit(context, &folder), UM_OK);
  const size_t rows[4] = {1 + 3 * 2 + 1, 1 + 3 * PASS_NTIME, 1 + 3 * PASS_NTIME, 2 + 4 + 2 + 3 * 2};
  for (size_t i = 0; i < 4; i++) {
    char file[UM_TEST_PATH + 60];
    snprintf(file, sizeof file, "%s/%s", path, name[i]);
    assert_int_equal(lines_of(file, line, sizeof line), rows[i]);
    if (i == 0) assert_non_null(strstr(line, "irradiance:vis,mean,W/m2,255,"));
    if (i == 1) assert_non_null(strstr(line, "Z,irradiance:vis,W/m2,,,,,,,,\n"));
    if (getenv("UMBRA_TEST_KEEP") == NULL) unlink(file);
  }
  FILE *out = tmpfile();
  assert_non_null(out);
  assert_int_equal(um_study_report_print(context, r, l, out), UM_OK);
  rewind(out);
  while (fgets(line, sizeof line, out) != NULL) print_message("%s", line);
  fclose(out);
  um_study_statistics_destroy(context, &l);
  um_study_result_destroy(context, &r);
  snprintf(line, sizeof line, "%.250s/.umbra", path);
  if (getenv("UMBRA_TEST_KEEP") != NULL) {
    print_message("kept in %s\n", path);
    return;
  }
  unlink(line);
  rmdir(path);
  um_test_folder_remove(base);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_designs), cmocka_unit_test(test_unexplained),
      cmocka_unit_test(test_spread),  cmocka_unit_test(test_sentence),
      cmocka_unit_test(test_tables),  cmocka_unit_test(test_limits)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
