/* Surfaces that heat each other against an independent simulator, every switch alone
 * (tests/reference/exchange.csv): temperatures to 0.1 K, irradiances to 0.5 %.
 *
 * The panel shades a strip of the wall beside it, and what of the wall is lit reflects. A facet
 * reflects evenly, so that facets of 0.3 m (legs) give the panel 2.6 % too much, 0.3 K: light that
 * is reflected is compared with facets of 0.1 m. */
#include <stdlib.h>

#include "base/core/constants.h"
#include "orbit/time.h"
#include "tests/scenarios/support.h"
#include "tests/support/reference.h"

#define NO_INFRARED "effects.+={effect: mutual_radiation, off: true}"
#define NO_SOLAR    "effects.+={effect: solar_multiple_reflection, off: true}"

static size_t row_of(const struct support_run *run, const char *utc)
{
  double t = NAN;
  if (um_orbit_time_parse(run->context, utc, &t) != UM_OK)
    fail_msg("%s", um_core_message(run->context));
  for (size_t k = 0; k < run->result->nobs; k++)
    if (fabs(run->tables->t_obs[k] - t) < 1e-3) return k;
  fail_msg("no observation at %s", utc);
  return 0;
}

static void compare(const char *column, const char *const *overrides, size_t noverride,
                    size_t nexpected)
{
  struct support_run run;
  size_t compared = 0;
  double worst[2] = {0.0, 0.0};
  support_compute(UMBRA_SOURCE_DIR "/tests/scenarios/data/elbow", overrides, noverride, &run);
  assert_true(run.result->audit_error < 1e-6);
  struct um_core_csv *csv = reference_open(run.context, "exchange");
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    const char *of = reference_text(run.context, csv, i, "of");
    if (reference_text(run.context, csv, i, column)[0] == '\0') continue;
    double expected = reference_number(run.context, csv, i, column);
    size_t k = row_of(&run, reference_text(run.context, csv, i, "time_utc"));
    compared++;
    if (strcmp(reference_text(run.context, csv, i, "quantity"), "temperature") == 0) {
      double d = support_temperature(&run, of)[k] - expected;
      worst[0] = fmax(worst[0], fabs(d));
      support_close(of, d, 0.0, 0.1);
    } else {
      size_t band = strcmp(of, "vis") == 0 ? 0 : 1;
      double ratio = run.result->irradiance[k * run.result->nband + band] / expected;
      worst[1] = fmax(worst[1], fabs(ratio - 1.0));
      support_close(of, ratio, 1.0, 0.005);
    }
  }
  print_message("%s: %zu figures, temperatures within %.3f K, irradiances within %.2f %%\n", column,
                compared, worst[0], 100.0 * worst[1]);
  assert_int_equal(compared, nexpected);
  um_core_csv_destroy(&csv);
  support_release(&run);
}

static void off(void **state)
{
  (void)state;
  static const char *const set[] = {NO_INFRARED, NO_SOLAR};
  compare("off", set, 2, 91);
}

static void infrared(void **state)
{
  (void)state;
  static const char *const set[] = {NO_SOLAR};
  compare("infrared", set, 1, 28);
}

static void solar(void **state)
{
  (void)state;
  static const char *const set[] = {NO_INFRARED, "parts.bus.facet_size_m=0.15",
                                    "parts.array.facet_size_m=0.15",
                                    "thermal.exchange_patches=1024", "optics.samples=64"};
  compare("solar", set, 5, 91);
}

/* Whichever surfaces are gathered into few patches, the mean hardly moves. */
static void few_patches(void **state)
{
  (void)state;
  static const char *const few[] = {"thermal.exchange_patches=12", "optics.samples=16"};
  static const char *const all[] = {"optics.samples=16"};
  struct support_run a, b;
  support_compute(UMBRA_SOURCE_DIR "/tests/scenarios/data/elbow", all, 1, &a);
  support_compute(UMBRA_SOURCE_DIR "/tests/scenarios/data/elbow", few, 2, &b);
  assert_int_equal(a.tables->view_factors->patches->npatch, 112);
  assert_int_equal(b.tables->view_factors->patches->npatch, 12);
  static const char *const place[] = {"bus.+y", "bus.interior", "array.front", "array.back"};
  for (int p = 0; p < 4; p++)
    for (size_t k = 0; k < a.result->nobs; k++)
      assert_close(support_temperature(&a, place[p])[k], support_temperature(&b, place[p])[k], 0.4);
  support_release(&a);
  support_release(&b);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(off), cmocka_unit_test(infrared),
                                     cmocka_unit_test(solar), cmocka_unit_test(few_patches)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
