/* Elementary effects: E_i = (f(u + step e_i) - f(u)) / step for each trajectory. */
#include <math.h>

#include "base/uncertainty/indices.h"

/* The axis that moves between two points, and by how much; d: none or several. */
static size_t moved(size_t d, const double *u, double *step)
{
  size_t axis = d, count = 0;
  for (size_t k = 0; k < d; k++) {
    if (u[k] == u[d + k]) continue;
    axis = k;
    count++;
    *step = u[d + k] - u[k];
  }
  return count == 1 ? axis : d;
}

static void put(double *out, size_t at, double value)
{
  if (out != NULL) out[at] = value;
}

/* Axis i of value k; step_at [n][d]: the point of each trajectory at which an axis moves. */
static void effects(size_t d, size_t n, size_t nvalue, const double *u, const double *value,
                    const size_t *step_at, size_t i, size_t k, struct um_uncertainty_morris *out)
{
  double count = 0.0, sum = 0.0, size = 0.0, square = 0.0;
  size_t at = i * nvalue + k;
  for (size_t t = 0; t < n; t++) {
    size_t p = step_at[t * d + i];
    double effect =
        (value[(p + 1) * nvalue + k] - value[p * nvalue + k]) / (u[(p + 1) * d + i] - u[p * d + i]);
    if (!isfinite(effect)) continue;
    count += 1.0;
    sum += effect;
    size += fabs(effect);
    square += effect * effect;
  }
  bool enough = count >= 2.0;
  double mean = sum / count, star = size / count;
  put(out->mu, at, enough ? mean : NAN);
  put(out->mu_star, at, enough ? star : NAN);
  put(out->sigma, at, enough ? sqrt(fmax(square - count * mean * mean, 0.0) / (count - 1.0)) : NAN);
  put(out->mu_error, at,
      enough ? sqrt(fmax(square - count * star * star, 0.0) / (count - 1.0) / count) : NAN);
}

enum um_status um_uncertainty_morris_effects(struct um_context *context, size_t d, size_t n,
                                             size_t nvalue, const double *u, const double *value,
                                             struct um_uncertainty_morris *out)
{
  enum um_status status;
  size_t *step_at = NULL;
  if (d == 0 || n < 2)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "elementary effects of %zu parameters from %zu trajectories, at least 1 and 2", d, n);
  UM_TRY(um_core_allocate(context, n, d * sizeof *step_at, &step_at));
  for (size_t i = 0; i < n * d; i++) step_at[i] = (size_t)-1;
  for (size_t t = 0; t < n; t++)
    for (size_t j = 0; j < d; j++) {
      size_t p = t * (d + 1) + j;
      double step = 0.0;
      size_t axis = moved(d, u + p * d, &step);
      if (axis < d && step_at[t * d + axis] == (size_t)-1) {
        step_at[t * d + axis] = p;
        continue;
      }
      UM_CHECK(um_core_fail(context, UM_ERR_INPUT,
                            "trajectory %zu does not move each parameter once, one at a time", t));
    }
  for (size_t i = 0; i < d; i++)
    for (size_t k = 0; k < nvalue; k++) effects(d, n, nvalue, u, value, step_at, i, k, out);
  status = UM_OK;
done:
  um_core_free(context, step_at);
  return status;
}
