/* The attitude of scenarios/funcube-1 before what opposite panels say of it.
 *
 * D = (T(+X) - T(-X)) + i (T(+Y) - T(-Y)) holds nothing of the panels' mean. It goes round at the
 * rate of the Sun about body z, with an amplitude that follows the sunlight across z. Of a turn of
 * period P sampled every dt, d_k = D_k - (D_(k-1) + D_(k+1))/2 is (1 - cos(2 pi dt/P)) D_k, and
 * what changes slowly drops out; the argument of the sum of conj(d_k) d_(k+1) is 2 pi dt/P. Both
 * are taken over windows of 6 min since sunrise, all orbits together.
 *
 * Accepted: a ratio of amplitudes, measured/model, that varies by a factor of 1.15 between windows
 * and is 1 within 0.06 in the mean (0.96 to 1.05, 1.02 in the mean, are measured: panels absorb as
 * much for their capacity as they should; over the whole outside, without rails, 0.87 in the mean),
 * and periods within 6 s, where they change by 15 s on the way. The field along -z, or an axis that
 * stands still, must miss by more than twice that. */
#include <complex.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "tests/scenarios/support.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/funcube-1"

#define WINDOWS 7
#define SUNRISE (5017.0 - 5838.0) /* of the orbit that the telemetry begins in [s since 0 h] */
#define ORBIT   5838.0            /* from sunrise to sunrise, by the TLE, 5 s off at most [s] */
#define STEP    60.0              /* of frames and of the scenario [s] */
#define FIRST   480.0             /* window k begins at FIRST + k EVERY after sunrise [s] */
#define EVERY   480.0             /* [s] */
#define LENGTH  360.0             /* [s] */
#define MOST    1024

struct series {
  size_t n;
  double t[MOST]; /* [s] since 0 h */
  double complex d[MOST];
};

struct turning {
  double amplitude[WINDOWS]; /* [K], times 1 - cos(2 pi dt/P) */
  double period[WINDOWS];    /* [s] */
};

static double number(struct um_context *context, const struct um_core_csv *csv, size_t row,
                     const char *name)
{
  size_t column = 0;
  double value = NAN;
  assert_int_equal(um_core_csv_require(context, csv, name, &column), UM_OK);
  assert_int_equal(um_core_csv_number(context, csv, row, column, &value), UM_OK);
  return value;
}

static void telemetry_read(struct series *out)
{
  struct um_context *context = NULL;
  struct um_core_csv *csv = NULL;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  assert_int_equal(um_core_csv_read(context, SCENARIO "/telemetry.csv", &csv), UM_OK);
  out->n = um_core_csv_rows(csv);
  assert_true(out->n <= MOST);
  for (size_t i = 0; i < out->n; i++) {
    int hour = 0, minute = 0, second = 0;
    assert_int_equal(
        sscanf(um_core_csv_text(csv, i, 0), "2016-02-04T%2d:%2d:%2dZ", &hour, &minute, &second), 3);
    out->t[i] = 3600.0 * hour + 60.0 * minute + second;
    out->d[i] = number(context, csv, i, "panel_x_plus_C") -
                number(context, csv, i, "panel_x_minus_C") +
                I * (number(context, csv, i, "panel_y_plus_C") -
                     number(context, csv, i, "panel_y_minus_C"));
  }
  um_core_csv_destroy(&csv);
  um_core_context_destroy(&context);
}

static void model_compute(const char *scenario, const char *override, struct series *out)
{
  const char *const overrides[] = {override};
  struct support_run run;
  support_compute(scenario, overrides, override == NULL ? 0 : 1, &run);
  const double *x = support_temperature(&run, "body.+x"), *y = support_temperature(&run, "body.+y");
  const double *u = support_temperature(&run, "body.-x"), *v = support_temperature(&run, "body.-y");
  for (out->n = 0; out->n < MOST && support_time(&run, out->n) < 50400.0; out->n++) {
    size_t k = out->n;
    out->t[k] = support_time(&run, k);
    out->d[k] = x[k] - u[k] + I * (y[k] - v[k]);
  }
  support_release(&run);
}

/* Window of frame k, or WINDOWS. */
static size_t window_of(double t)
{
  double since = fmod(t - SUNRISE, ORBIT) - FIRST;
  double window = floor(since / EVERY);
  if (!(window >= 0.0 && window < WINDOWS && since - window * EVERY < LENGTH)) return WINDOWS;
  return (size_t)window;
}

static struct turning turning_of(const struct series *s)
{
  double sum[WINDOWS] = {0};
  double complex turn[WINDOWS] = {0};
  size_t count[WINDOWS] = {0};
  struct turning out;
  for (size_t k = 1; k + 2 < s->n; k++) {
    size_t w = window_of(s->t[k]);
    if (w == WINDOWS || s->t[k + 2] - s->t[k - 1] > 3.5 * STEP) continue; /* a frame is missing */
    double complex here = s->d[k] - 0.5 * (s->d[k - 1] + s->d[k + 1]);
    double complex next = s->d[k + 1] - 0.5 * (s->d[k] + s->d[k + 2]);
    sum[w] += cabs(here);
    turn[w] += conj(here) * next;
    count[w]++;
  }
  for (size_t w = 0; w < WINDOWS; w++) {
    assert_true(count[w] >= 20);
    out.amplitude[w] = sum[w] / (double)count[w];
    out.period[w] = 2.0 * UM_PI * STEP / carg(turn[w]);
  }
  return out;
}

/* How far the model misses: amplitudes, largest ratio over smallest, and mean ratio; periods [s],
 * largest. */
static void miss(const struct turning *measured, const char *scenario, const char *override,
                 double *ratio, double *period, double *mean)
{
  static struct series series;
  double least = INFINITY, most = 0.0;
  *period = 0.0;
  *mean = 0.0;
  model_compute(scenario, override, &series);
  struct turning model = turning_of(&series);
  for (size_t w = 0; w < WINDOWS; w++) {
    double r = measured->amplitude[w] / model.amplitude[w];
    print_message("%2.0f min: ratio %.3f, period %.1f and %.1f s\n",
                  (FIRST + (double)w * EVERY) / 60.0, r, measured->period[w], model.period[w]);
    least = fmin(least, r);
    most = fmax(most, r);
    *mean += r / WINDOWS;
    *period = fmax(*period, fabs(measured->period[w] - model.period[w]));
  }
  *ratio = most / least;
}

static void opposite_panels_turn_as_the_field_says(void **state)
{
  (void)state;
  static struct series telemetry;
  double ratio, period, mean;
  telemetry_read(&telemetry);
  struct turning measured = turning_of(&telemetry);
  miss(&measured, SCENARIO, NULL, &ratio, &period, &mean);
  if (!(ratio <= 1.15)) fail_msg("amplitudes' ratio varies by a factor %.3f, accepted 1.15", ratio);
  if (!(period <= 6.0)) fail_msg("periods differ by %.1f s, accepted 6 s", period);
  if (!(fabs(mean - 1.0) <= 0.06)) fail_msg("amplitudes' mean ratio is %.3f", mean);
  miss(&measured, SCENARIO, "attitude=[{magnetic: {axis_body: [0, 0, -1], period_s: 195}}]", &ratio,
       &period, &mean);
  if (!(period >= 12.0)) fail_msg("field along -z: periods within %.1f s", period);
  miss(&measured, SCENARIO,
       "attitude=[{spin: {axis_gcrs: [0.5295, -0.4936, 0.69], axis_body: [0, 0, 1], period_s: "
       "-195}}]",
       &ratio, &period, &mean);
  if (!(ratio >= 1.4)) fail_msg("an axis that stands still: ratio within %.3f", ratio);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(opposite_panels_turn_as_the_field_says)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
