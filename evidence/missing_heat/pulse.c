/* The best pulse of heat. With d_b the change of the observations per watt in bin b, after the
 * nuisances, a pulse of power P over the bins i .. j-1 changes them by P D, D = sum d_b, and
 * explains
 *
 *   chi2 = (D'r)^2 / D'D   at   P = D'r / D'D +- 1 / sqrt(D'D).
 *
 * Sums of products over rectangles of bins come from sums over corners, so that all pairs of edges
 * are tried. Start and energy scatter with the likelihood exp(chi2 / 2) over the pairs, each energy
 * with its own sigma. */
#include "evidence/missing_heat/pulse_impl.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"

static double rectangle(const double *sum, size_t n, size_t i, size_t j)
{
  return sum[j * n + j] - 2.0 * sum[i * n + j] + sum[i * n + i];
}

/* Sums over corners of the products of n columns. */
static void sum_products(size_t nbin, size_t nobservation, const double *column, double *out)
{
  size_t n = nbin + 1;
  for (size_t a = 0; a < nbin; a++)
    for (size_t b = 0; b < nbin; b++) {
      double product = b < a ? out[(b + 1) * n + a + 1] - out[b * n + a + 1] -
                                   out[(b + 1) * n + a] + out[b * n + a]
                             : um_inference_dot(nobservation, column + a * nobservation,
                                                column + b * nobservation);
      out[(a + 1) * n + b + 1] =
          product + out[a * n + b + 1] + out[(a + 1) * n + b] - out[a * n + b];
    }
}

enum um_status um_missing_heat_bins_create(struct um_context *context,
                                           struct um_inference_projection *projection,
                                           const double *residual, size_t nbin, const double *edge,
                                           const double *column, struct um_missing_heat_bins *out)
{
  size_t n = nbin + 1, nleft = projection->nleft;
  *out = (struct um_missing_heat_bins){.nbin = nbin, .nleft = nleft};
  UM_TRY(um_core_allocate(context, n, sizeof *out->edge, &out->edge));
  UM_TRY(um_core_allocate(context, nbin * nleft, sizeof *out->column, &out->column));
  UM_TRY(um_core_allocate(context, n * n, sizeof *out->product, &out->product));
  UM_TRY(um_core_allocate(context, n * n, sizeof *out->whole, &out->whole));
  UM_TRY(um_core_allocate(context, n, sizeof *out->with, &out->with));
  memcpy(out->edge, edge, n * sizeof *edge);
  for (size_t b = 0; b < nbin; b++) {
    double *left = out->column + b * nleft;
    um_inference_projection_apply(projection, column + b * projection->nrow, left);
    out->with[b + 1] = out->with[b] + um_inference_dot(nleft, left, residual);
  }
  sum_products(nbin, nleft, out->column, out->product);
  sum_products(nbin, projection->nrow, column, out->whole);
  return UM_OK;
}

void um_missing_heat_bins_release(struct um_context *context, struct um_missing_heat_bins *bins)
{
  UM_FREE(context, bins->edge, bins->column, bins->product, bins->whole, bins->with);
  *bins = (struct um_missing_heat_bins){0};
}

/* D'D of a pulse; 0 where the observations cannot see it or the nuisances absorb it. */
static double length2(const struct um_missing_heat_bins *bins, size_t i, size_t j)
{
  double left = rectangle(bins->product, bins->nbin + 1, i, j);
  double whole = rectangle(bins->whole, bins->nbin + 1, i, j);
  return left > UM_INFERENCE_KEPT * UM_INFERENCE_KEPT * whole ? left : 0.0;
}

static double explained(const struct um_missing_heat_bins *bins, size_t i, size_t j, double *power)
{
  double square = length2(bins, i, j), with = bins->with[j] - bins->with[i];
  *power = square > 0.0 ? with / square : 0.0;
  return with * *power;
}

/* Sigmas of start and energy: the scatter of all pulses about the best. */
static void scatter(const struct um_missing_heat_bins *bins, struct um_missing_heat_pulse *best)
{
  double sum = 0.0, start2 = 0.0, energy2 = 0.0;
  const double *t = bins->edge;
  double energy = best->power * (t[best->to] - t[best->from]);
  for (size_t i = 0; i < bins->nbin; i++)
    for (size_t j = i + 1; j <= bins->nbin; j++) {
      double power, chi2 = explained(bins, i, j, &power), length = t[j] - t[i];
      if (!(chi2 > 0.0)) continue;
      double weight = exp(0.5 * (chi2 - best->chi2)), off = power * length - energy;
      sum += weight;
      start2 += weight * (t[i] - t[best->from]) * (t[i] - t[best->from]);
      energy2 += weight * (off * off + length * length / length2(bins, i, j));
    }
  /* the start may lie anywhere within half a bin of the edge */
  double width = best->from > 0 ? t[best->from] - t[best->from - 1] : t[1] - t[0];
  best->start_sigma = sqrt(start2 / sum + width * width / 12.0);
  best->energy_sigma = sqrt(energy2 / sum);
}

void um_missing_heat_pulse_find(const struct um_missing_heat_bins *bins,
                                struct um_missing_heat_pulse *out)
{
  *out = (struct um_missing_heat_pulse){.to = bins->nbin};
  out->start_sigma = out->energy_sigma = NAN;
  for (size_t i = 0; i < bins->nbin; i++)
    for (size_t j = i + 1; j <= bins->nbin; j++) {
      double power, chi2 = explained(bins, i, j, &power);
      if (!(chi2 > out->chi2)) continue;
      *out = (struct um_missing_heat_pulse){.from = i, .to = j, .chi2 = chi2, .power = power};
    }
  if (out->chi2 > 0.0) scatter(bins, out);
}
