/* Folded curves against curves that are made: one hump a turn, F = level(t) + A exp(k (cos x - 1)),
 * over a level that moves five- to tenfold as over a pass. A bin's answer is the hump at its own
 * points and the mean level; 40 of them lie within their stated errors, chi-square 40 +- 9. */
#include "evidence/inversion/fold.h"

#include <stdint.h>

#include "evidence/measurements/measurements.h"
#include "tests/evidence/compare_test.h"

#define ROWS   860
#define SPAN   600.0 /* [s] */
#define PERIOD 37.0  /* [s] */
#define BINS   40
#define START  "2016-09-21T20:30:00Z"

enum noise { MAGNITUDES, PERCENT, COUNTED, CONSTANT };

static double hump(double t)
{
  return 8e-3 * exp(6.0 * (cos(2.0 * UM_PI * (t / PERIOD - 0.3)) - 1.0));
}

/* A track of its own from the middle on where there are two, 5 times as bright. */
static double level(double t, bool two)
{
  double u = 2.0 * t / SPAN - 1.0;
  if (two) return t < 0.5 * SPAN ? 1e-3 : 5e-3;
  return 1e-3 * (2.3 - 1.7 * u * u + 0.3 * u);
}

static void write_curve(enum noise noise, bool two)
{
  FILE *f = fopen("m.csv", "w");
  assert_non_null(f);
  fputs("time_utc,quantity,of,value,sigma,track\n", f);
  for (uint64_t i = 0; i < ROWS; i++) {
    double t = SPAN * ((double)i + 0.5) / ROWS, flux = level(t, two) + hump(t), z = gaussian(7, i);
    const char *track = two && t >= 0.5 * SPAN ? "b" : "a";
    double sigma = noise == PERCENT ? 0.05 * flux : noise == COUNTED ? 0.003 * sqrt(flux) : 1e-4;
    fprintf(f, "2016-09-21T20:%02d:%06.3fZ,", 30 + (int)(t / 60.0), fmod(t, 60.0));
    if (noise == MAGNITUDES)
      fprintf(f, "magnitude_ab,V,%.6f,0.05,%s\n", -2.5 * log10(flux) + 0.05 * z, track);
    else
      fprintf(f, "band_irradiance,V,%.9e,%.9e,%s\n", flux + sigma * z,
              noise == PERCENT   ? 0.05 * fabs(flux + sigma * z)
              : noise == COUNTED ? 0.003 * sqrt(fmax(flux + sigma * z, 1e-9))
                                 : sigma,
              track);
  }
  assert_int_equal(fclose(f), 0);
}

static void check_curve(enum noise noise, bool two)
{
  struct um_compare_measurements *m;
  struct um_compare_series *s;
  struct um_compare_period *p;
  struct um_compare_fold_bin bin[BINS];
  double wanted[BINS] = {0}, mean = 0.0, chi2 = 0.0, low = INFINITY, high = 0.0;
  write_curve(noise, two);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_ok(um_compare_series_create(context, m, 0, SIZE_MAX, &s));
  assert_ok(um_compare_period_search(context, s, NULL, &p));
  p->period = PERIOD; /* the search is another test's */
  assert_ok(um_compare_fold(context, s, p, BINS, bin));
  double begin = s->t[0] - 0.5 * SPAN / ROWS;
  for (size_t i = 0; i < s->count; i++) {
    size_t b = um_compare_fold_bin_of(s->t[i], p->period, p->epoch, BINS);
    wanted[b] += hump(s->t[i] - begin) / (double)bin[b].count;
    mean += level(s->t[i] - begin, two) / (double)s->count;
  }
  for (size_t b = 0; b < BINS; b++) {
    double off = (bin[b].mean - wanted[b] - mean) / bin[b].sigma;
    chi2 += off * off;
    low = fmin(low, bin[b].mean);
    high = fmax(high, bin[b].mean);
  }
  print_message("noise %d, tracks %d: chi-square %.3g of 40, from %.4g to %.4g\n", noise, 1 + two,
                chi2, low, high);
  assert_true(fabs(chi2 - 40.0) < 3.0 * 9.0);
  assert_true(fabs(low - mean) < 0.03 * 8e-3 && fabs(high - mean - 8e-3) < 0.05 * 8e-3);
  um_compare_period_destroy(context, &p);
  um_compare_series_destroy(context, &s);
  um_compare_measurements_destroy(context, &m);
}

static void test_hump(void **state)
{
  (void)state;
  for (enum noise noise = MAGNITUDES; noise <= CONSTANT; noise++)
    for (int two = 0; two < 2; two++) check_curve(noise, two == 1);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_hump)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
