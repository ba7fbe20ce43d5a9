/* The blind sets beside their baselines: an independent simulator (Python, no common code) wrote
 * baseline.csv, which the scenarios must reproduce as if it were measured, and measurement.csv,
 * which may come from another world; of that only what any world must give is asserted.
 *
 * Sigmas of a baseline are what issue and README accept: 0.5 % of an irradiance with a floor of
 * 0.05 % of the band's peak (a tenth of the VIS noise; crescents and penumbra edges of the two
 * codes differ by the reference's sampling there, see tests/model/run/blind.c), 0.1 K of a
 * temperature. No row may be off by one of them; the mean square of the rows is then far below 1.
 */
#include "tests/evidence/model_test.h"

#include "base/core/csv.h"
#include "evidence/comparison/comparison.h"
#include "evidence/comparison/metrics.h"
#include "evidence/measurements/set.h"
#include "model/build/build.h"

#define ACCEPTED_SQUARE 0.05 /* mean square of residual over sigma, all channels */

/* The rows of a baseline with what is accepted for sigma, as m.csv. */
static void write_baseline(const char *path)
{
  struct um_core_csv *csv;
  double peak[2] = {0.0, 0.0};
  FILE *file = fopen("m.csv", "wb");
  assert_non_null(file);
  assert_ok(um_core_csv_read(context, path, &csv));
  fputs(HEAD, file);
  for (int pass = 0; pass < 2; pass++)
    for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
      double value, sigma = 0.1;
      const char *quantity = um_core_csv_text(csv, i, 1), *of = um_core_csv_text(csv, i, 2);
      size_t band = strcmp(of, "vis") == 0 ? 0 : 1;
      assert_ok(um_core_csv_number(context, csv, i, 3, &value));
      if (strcmp(quantity, "temperature") != 0) {
        if (pass == 0) peak[band] = fmax(peak[band], value);
        sigma = hypot(0.005 * value, 5e-4 * peak[band]);
      }
      if (pass == 1)
        fprintf(file, "%s,%s,%s,%s,%.9g\n", um_core_csv_text(csv, i, 0), quantity, of,
                um_core_csv_text(csv, i, 3), sigma);
    }
  um_core_csv_destroy(&csv);
  assert_int_equal(fclose(file), 0);
}

static void check_baseline(const char *name, const struct um_compare_comparison *c)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  print_message("%s baseline: chi2/dof %.4f;", name, c->chi2_reduced);
  for (size_t i = 0; i < c->nchannel; i++)
    print_message(" %s %.4f", m->channel[c->channel[i].channel].of, c->channel[i].all.chi2_reduced);
  print_message("\n");
  for (size_t i = 0; i < m->count; i++) {
    double z = (c->residual[i].measured - c->residual[i].model) / c->residual[i].sigma;
    if (!(fabs(z) <= 1.0))
      fail_msg("%s: line %d of m.csv: %s %g, model %g, %.2f of what is accepted", name,
               m->row[i].line, m->channel[m->row[i].channel].of, m->row[i].value, c->model[i], z);
  }
  assert_true(c->chi2_reduced <= ACCEPTED_SQUARE);
}

static void check_measurement(const char *name, const struct um_compare_comparison *c)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  print_message("%s measurement: chi2/dof %.3f;", name, c->chi2_reduced);
  for (size_t i = 0; i < c->nchannel; i++) {
    const struct um_compare_channel_comparison *channel = &c->channel[i];
    const struct um_compare_metrics *all = &channel->all;
    print_message(" %s %.3f", m->channel[channel->channel].of, all->chi2_reduced);
    assert_true(isfinite(all->bias) && isfinite(all->rms) && isfinite(all->chi2_reduced));
    assert_true(all->white_p >= 0.0 && all->white_p <= 1.0);
    size_t light = 0, motion = 0;
    for (int s = 0; s < UM_SEGMENT_RISING; s++) light += channel->segment[s].count;
    for (int s = UM_SEGMENT_RISING; s < UM_SEGMENT_COUNT; s++) motion += channel->segment[s].count;
    assert_int_equal(light, all->count);
    assert_int_equal(motion, all->count);
    assert_true(channel->nworst > 0 && channel->worst[0].chi2 >= channel->worst[1].chi2);
  }
  print_message("\n");
}

static void run_set(const char *name)
{
  char scenario[1024], path[sizeof scenario + 16];
  struct um_model *model;
  snprintf(scenario, sizeof scenario, "%s/scenarios/blind/%s", UMBRA_SOURCE_DIR, name);
  snprintf(path, sizeof path, "%s/baseline.csv", scenario);
  assert_ok(um_model_create(context, scenario, NULL, &model));
  write_baseline(path);
  struct pair p = pair_of(model, "m.csv", 0.0);
  check_baseline(name, p.comparison);
  pair_end(&p);
  snprintf(path, sizeof path, "%s/measured.csv", scenario);
  p = pair_of(model, path, 0.0);
  check_measurement(name, p.comparison);
  pair_end(&p);
  um_model_destroy(context, &model);
}

static void test_set(void **state) { run_set(*state); }

int main(void)
{
  static char name[8][2] = {"a", "b", "c", "d", "e", "f", "g", "h"};
  struct CMUnitTest tests[8];
  for (size_t i = 0; i < 8; i++)
    tests[i] = (struct CMUnitTest){name[i], test_set, NULL, NULL, name[i]};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
