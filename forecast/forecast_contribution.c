/* Which of the uncertain parameters a band answers to, and where a line is not enough. */
#include <math.h>
#include <stdint.h>

#include "base/core/csv.h"
#include "forecast/forecast_impl.h"
#include "forecast/forecast_write.h"

/* Squares of a parameter's parts in a band or place over all passes; of all parameters: SIZE_MAX.
 */
static double square(const struct um_forecast *f, size_t which, size_t told)
{
  double sum = 0.0;
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    if (pass->reason != NULL) continue;
    for (size_t p = 0; p < f->nuncertain; p++) {
      double part = pass->part[p * (f->nband + f->nplace) + told];
      if ((which == SIZE_MAX || which == p) && isfinite(part)) sum += part * part;
    }
  }
  return sum;
}

size_t um_forecast_leader(const struct um_forecast *f, size_t band, double *share)
{
  size_t first = SIZE_MAX;
  double most = 0.0;
  for (size_t p = 0; p < f->nuncertain; p++) {
    double of = square(f, p, band);
    if (!(of > most)) continue;
    most = of;
    first = p;
  }
  *share = first == SIZE_MAX ? (double)NAN : most / square(f, SIZE_MAX, band);
  return first;
}

/* The bar of a band or place, where it stands out of what a forecast is solved to: 0.1 K, 1e-3 of
 * light; else NaN. */
static double bar_of(const struct um_forecast *f, const struct um_forecast_pass *pass, size_t told)
{
  const double kelvin = 0.1, light = 1e-3;
  double bar, least = kelvin;
  if (told >= f->nband) {
    bar = pass->place_sigma[told - f->nband].mean;
  } else {
    bar = f->thermal[told] ? pass->band_sigma[told].largest : pass->band_sigma[told].brightest;
    least = f->thermal[told] ? light * pass->band[told].largest : light;
  }
  return bar >= least ? bar : (double)NAN;
}

/* How far a parameter bends at most, of the bar that it is in [1]; *told: there. */
static double bend_of(const struct um_forecast *f, size_t which, size_t *told)
{
  double most = 0.0;
  size_t n = f->nband + f->nplace;
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *pass = &f->pass[i];
    for (size_t k = 0; k < n && pass->reason == NULL; k++) {
      double share = pass->bend[which * n + k] / bar_of(f, pass, k);
      if (!isfinite(share) || !(share > most)) continue;
      most = share;
      *told = k;
    }
  }
  return most;
}

void um_forecast_tell_bends(struct um_context *context, const struct um_forecast *f)
{
  size_t n = f->nband + f->nplace, computed = 0;
  for (size_t i = 0; i < f->npass; i++) computed += f->pass[i].reason == NULL ? 1 : 0;
  for (size_t p = 0; p < f->nuncertain && computed > 0; p++) {
    const struct um_forecast_uncertain *u = &f->uncertain[p];
    size_t told = 0, k = 0;
    double most = bend_of(f, p, &told);
    while (k < n && !(square(f, p, k) > 0.0)) k++;
    if (k == n)
      um_core_log(context, UM_LOG_WARNING, "--uncertain %s changes nothing of these passes",
                  u->name);
    else if (most > UM_FORECAST_BEND)
      um_core_log(
          context, UM_LOG_WARNING,
          "%s: first order is not enough: at 1 sigma %s is off the line by up to %.0f %% of "
          "its error bar",
          u->name, told < f->nband ? f->band[told] : f->place[told - f->nband], 100.0 * most);
  }
}

void um_forecast_contributions(const struct um_forecast *f, FILE *file)
{
  size_t n = f->nband + f->nplace;
  fputs("pass,parameter,unit,value,sigma", file);
  for (size_t k = 0; k < n; k++) {
    const char *name = k < f->nband ? f->band[k] : f->place[k - f->nband];
    bool place = k >= f->nband, heat = !place && f->thermal[k];
    um_core_csv_put_text(file, name, place ? ".mean_K" : heat ? "_largest_W_m2" : "_brightest_mag");
    um_core_csv_put_text(file, name,
                         place  ? ".mean_bend_K"
                         : heat ? "_largest_bend_W_m2"
                                : "_brightest_bend_mag");
  }
  fputc('\n', file);
  for (size_t i = 0; i < f->npass; i++)
    for (size_t p = 0; p < f->nuncertain && f->pass[i].reason == NULL; p++) {
      const struct um_forecast_uncertain *u = &f->uncertain[p];
      fprintf(file, "%zu,", i + 1);
      um_core_csv_put(file, u->name, "");
      um_core_csv_put_text(file, u->unit, "");
      um_core_csv_put_exact(file, u->value);
      um_core_csv_put_exact(file, u->sigma);
      for (size_t k = 0; k < n; k++) {
        um_core_csv_put_exact(file, f->pass[i].part[p * n + k]);
        um_core_csv_put_exact(file, f->pass[i].bend[p * n + k]);
      }
      fputc('\n', file);
    }
}
