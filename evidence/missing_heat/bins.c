/* What a course of heat explains. With d_b the change of the observations per watt in bin b, after
 * the nuisances, and w_b the mean of the course there at 1 W, a power P changes them by P D,
 * D = sum w_b d_b, and explains
 *
 *   chi2 = (D'r)^2 / D'D   at   P = D'r / D'D +- 1 / sqrt(D'D). */
#include "evidence/missing_heat/bins_impl.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"

static void multiply(size_t n, size_t length, const double *column, double *out)
{
  for (size_t a = 0; a < n; a++)
    for (size_t b = a; b < n; b++)
      out[a * n + b] = out[b * n + a] =
          um_inference_dot(length, column + a * length, column + b * length);
}

enum um_status um_missing_heat_bins_create(struct um_context *context,
                                           struct um_inference_projection *projection,
                                           const double *residual, size_t nbin, const double *edge,
                                           const double *column, struct um_missing_heat_bins *out)
{
  size_t n = nbin, nleft = projection->nleft;
  *out = (struct um_missing_heat_bins){.nbin = n, .nleft = nleft, .nobservation = projection->nrow};
  UM_TRY(um_core_allocate(context, n + 1, sizeof *out->edge, &out->edge));
  UM_TRY(um_core_allocate(context, n * nleft, sizeof *out->column, &out->column));
  UM_TRY(um_core_allocate(context, n * n, sizeof *out->gram, &out->gram));
  UM_TRY(um_core_allocate(context, n * n, sizeof *out->whole, &out->whole));
  UM_TRY(um_core_allocate(context, n, sizeof *out->with, &out->with));
  UM_TRY(um_core_allocate(context, n, sizeof *out->weight, &out->weight));
  memcpy(out->edge, edge, (n + 1) * sizeof *edge);
  for (size_t b = 0; b < n; b++)
    um_inference_projection_apply(projection, column + b * projection->nrow,
                                  out->column + b * nleft);
  multiply(n, nleft, out->column, out->gram);
  multiply(n, projection->nrow, column, out->whole);
  um_missing_heat_bins_meet(out, residual);
  return UM_OK;
}

void um_missing_heat_bins_release(struct um_context *context, struct um_missing_heat_bins *bins)
{
  UM_FREE(context, bins->edge, bins->column, bins->gram, bins->whole, bins->with, bins->weight);
  *bins = (struct um_missing_heat_bins){0};
}

void um_missing_heat_bins_meet(struct um_missing_heat_bins *bins, const double *residual)
{
  bins->square = um_inference_dot(bins->nleft, residual, residual);
  for (size_t b = 0; b < bins->nbin; b++)
    bins->with[b] = um_inference_dot(bins->nleft, bins->column + b * bins->nleft, residual);
}

/* w'Aw over the bins from `first` on. */
static double square(const struct um_missing_heat_bins *bins, const double *a, size_t first)
{
  size_t n = bins->nbin;
  double sum = 0.0;
  for (size_t i = first; i < n; i++)
    if (bins->weight[i] != 0.0)
      sum += bins->weight[i] * um_inference_dot(n - first, a + i * n + first, bins->weight + first);
  return sum;
}

/* Weights of the bins; the first that has any. */
static size_t weights(const struct um_missing_heat_bins *bins,
                      const struct um_thermal_course *course)
{
  size_t first = bins->nbin;
  double before = um_thermal_course_energy(course, bins->edge[0]);
  for (size_t b = 0; b < bins->nbin; b++) {
    double energy = um_thermal_course_energy(course, bins->edge[b + 1]);
    bins->weight[b] = (energy - before) / (bins->edge[b + 1] - bins->edge[b]);
    if (first == bins->nbin && bins->weight[b] != 0.0) first = b;
    before = energy;
  }
  return first;
}

struct um_missing_heat_weighed um_missing_heat_bins_weigh(const struct um_missing_heat_bins *bins,
                                                          const struct um_thermal_course *course)
{
  struct um_missing_heat_weighed out = {.sigma = INFINITY};
  size_t first = weights(bins, course);
  double left = square(bins, bins->gram, first);
  out.length = um_thermal_course_energy(course, bins->edge[bins->nbin]);
  if (!(left > UM_INFERENCE_KEPT * UM_INFERENCE_KEPT * square(bins, bins->whole, first)))
    return out;
  double with = um_inference_dot(bins->nbin - first, bins->weight + first, bins->with + first);
  out.power = with / left;
  out.chi2 = with * out.power;
  out.sigma = 1.0 / sqrt(left);
  return out;
}

void um_missing_heat_bins_respond(const struct um_missing_heat_bins *bins,
                                  const struct um_thermal_course *course, double power, double *out)
{
  memset(out, 0, bins->nleft * sizeof *out);
  for (size_t b = weights(bins, course); b < bins->nbin; b++)
    for (size_t j = 0; j < bins->nleft; j++)
      out[j] += power * bins->weight[b] * bins->column[b * bins->nleft + j];
}
