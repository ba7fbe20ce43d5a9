/* From heights to alpha (docs/physics/roughness-and-lobes.md).
 *
 *   Rq^2 = <h^2>,  C(s) = <h(r) h(r + s)>/Rq^2,  tau: the shortest s with C = 0.2
 *   alpha = sqrt(2) Rq/tau                    reproduces Table 1 of the Flying Laptop paper
 *   alpha = 2 sqrt(ln 5) Rq/tau               Beckmann's, if C = exp(-(s/T)^2): sqrt(<slope^2>) =
 *                                             2 Rq/T and tau = T sqrt(ln 5)
 * after the mean plane is taken off. What is shorter than the step of the measurement is not in
 * either. */
#include "materials/profile.h"

#include <math.h>

#include "base/core/csv.h"
#include "materials/bsdf.h"

#define EVEN  1e-3 /* of a step */
#define FALLS 0.2
#define NONE  ((size_t)-1)

/* How many rows have the first y. */
static enum um_status count_columns(struct um_context *context, const struct um_core_csv *csv,
                                    size_t column, size_t *nx)
{
  double first, y;
  size_t n = um_core_csv_rows(csv);
  *nx = n;
  if (column == NONE) return UM_OK;
  UM_TRY(um_core_csv_number(context, csv, 0, column, &first));
  for (*nx = 1; *nx < n; (*nx)++) {
    UM_TRY(um_core_csv_number(context, csv, *nx, column, &y));
    if (y != first) break;
  }
  if (n % *nx != 0)
    return um_core_csv_fail(context, csv, n - 1, column,
                            "%zu rows, %zu of them with the first y; accepted: as many with each",
                            n, *nx);
  return UM_OK;
}

/* A coordinate stands where even steps have it. */
static enum um_status check_even(struct um_context *context, const struct um_core_csv *csv,
                                 size_t row, size_t column, double first, double step, size_t k)
{
  double value, expected = first + (double)k * step;
  UM_TRY(um_core_csv_number(context, csv, row, column, &value));
  if (fabs(value - expected) <= EVEN * step) return UM_OK;
  return um_core_csv_fail(context, csv, row, column,
                          "%g where even steps have %g; accepted: ascending by y, then x, without "
                          "a gap",
                          value, expected);
}

static enum um_status step_of(struct um_context *context, const struct um_core_csv *csv, size_t row,
                              size_t column, double *first, double *step)
{
  double next;
  UM_TRY(um_core_csv_number(context, csv, 0, column, first));
  UM_TRY(um_core_csv_number(context, csv, row, column, &next));
  *step = next - *first;
  if (*step > 0.0) return UM_OK;
  return um_core_csv_fail(context, csv, row, column, "%g follows %g; accepted: ascending", next,
                          *first);
}

/* The least-squares plane off; on an even grid its slopes are independent. */
static void level(struct um_materials_heights *h)
{
  double mean = 0.0, sx = 0.0, sy = 0.0, xx = 0.0, yy = 0.0;
  double mx = 0.5 * (double)(h->nx - 1), my = 0.5 * (double)(h->ny - 1);
  for (size_t j = 0; j < h->ny; j++)
    for (size_t i = 0; i < h->nx; i++) {
      double x = (double)i - mx, y = (double)j - my, z = h->height[j * h->nx + i];
      mean += z;
      sx += x * z;
      sy += y * z;
      xx += x * x;
      yy += y * y;
    }
  mean /= (double)(h->nx * h->ny);
  sx /= xx;
  sy = yy > 0.0 ? sy / yy : 0.0;
  for (size_t j = 0; j < h->ny; j++)
    for (size_t i = 0; i < h->nx; i++)
      h->height[j * h->nx + i] -= mean + sx * ((double)i - mx) + sy * ((double)j - my);
}

static enum um_status fill(struct um_context *context, const struct um_core_csv *csv,
                           struct um_materials_heights *h)
{
  size_t x, y = um_core_csv_find(csv, "y_um"), z, n = um_core_csv_rows(csv);
  double x0, y0 = 0.0, dx, dy = 0.0;
  UM_TRY(um_core_csv_require(context, csv, "x_um", &x));
  UM_TRY(um_core_csv_require(context, csv, "height_um", &z));
  if (n < 16)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows; accepted: 16 or more",
                        um_core_csv_name(csv), n);
  UM_TRY(count_columns(context, csv, y, &h->nx));
  h->ny = n / h->nx;
  if (h->nx < 4 || (y != NONE && h->ny < 4))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %zu heights along x, %zu along y; accepted: 4 or more",
                        um_core_csv_name(csv), h->nx, h->ny);
  UM_TRY(step_of(context, csv, 1, x, &x0, &dx));
  if (y != NONE) UM_TRY(step_of(context, csv, h->nx, y, &y0, &dy));
  h->dx = dx * 1e-6;
  h->dy = dy * 1e-6;
  UM_TRY(um_core_allocate(context, n, sizeof *h->height, &h->height));
  for (size_t k = 0; k < n; k++) {
    UM_TRY(check_even(context, csv, k, x, x0, dx, k % h->nx));
    if (y != NONE) UM_TRY(check_even(context, csv, k, y, y0, dy, k / h->nx));
    UM_TRY(um_core_csv_number(context, csv, k, z, &h->height[k]));
    h->height[k] *= 1e-6;
  }
  level(h);
  return UM_OK;
}

enum um_status um_materials_heights_read(struct um_context *context, const char *path,
                                         struct um_materials_heights *out)
{
  struct um_core_csv *csv = NULL;
  *out = (struct um_materials_heights){0};
  UM_TRY(um_core_csv_read(context, path, &csv));
  enum um_status status = fill(context, csv, out);
  um_core_csv_destroy(&csv);
  if (status != UM_OK) um_materials_heights_free(context, out);
  return status;
}

void um_materials_heights_free(struct um_context *context, struct um_materials_heights *heights)
{
  um_core_free(context, heights->height);
  *heights = (struct um_materials_heights){0};
}

/* <h(r) h(r + s)> where both were measured, s = (i, j) steps, i >= 0 [m^2] */
static double product(const struct um_materials_heights *h, size_t i, long j)
{
  size_t up = j > 0 ? (size_t)j : 0, down = j < 0 ? (size_t)-j : 0;
  double sum = 0.0;
  for (size_t b = down; b + up < h->ny; b++) {
    const double *row = h->height + b * h->nx, *other = h->height + (b + up - down) * h->nx + i;
    for (size_t a = 0; a + i < h->nx; a++) sum += row[a] * other[a];
  }
  return sum / ((double)(h->nx - i) * (double)(h->ny - up - down));
}

/* The shift at which C falls to 0.2 along multiples of (i, j); INFINITY where it does not. */
static double along(const struct um_materials_heights *h, double rq2, size_t i, long j,
                    double *steps)
{
  size_t tall = j < 0 ? (size_t)-j : (size_t)j;
  double length = hypot((double)i * h->dx, (double)j * h->dy), before = 1.0;
  for (size_t k = 1; 2 * k * i < h->nx && (tall == 0 || 2 * k * tall < h->ny); k++) {
    double c = product(h, k * i, (long)k * j) / rq2;
    if (c <= FALLS) {
      *steps = (double)(k - 1) + (before - FALLS) / (before - c);
      return *steps * length;
    }
    before = c;
  }
  return INFINITY;
}

enum um_status um_materials_heights_roughness(struct um_context *context,
                                              const struct um_materials_heights *heights,
                                              struct um_materials_slope *out)
{
  static const struct {
    size_t i;
    long j;
  } ways[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {1, 2}, {2, -1}, {1, -2}};
  size_t nway = heights->ny > 1 ? sizeof ways / sizeof ways[0] : 1;
  double rq2 = product(heights, 0, 0), steps = 0.0;
  *out = (struct um_materials_slope){.rq = sqrt(rq2), .tau = INFINITY};
  if (!(rq2 > 0.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "the heights are flat; accepted: heights that differ");
  for (size_t k = 0; k < nway; k++) {
    double tau = along(heights, rq2, ways[k].i, ways[k].j, &steps);
    if (!(tau < out->tau)) continue;
    out->tau = tau;
    out->samples = steps;
  }
  if (!isfinite(out->tau))
    return um_core_fail(context, UM_ERR_INPUT,
                        "the autocorrelation of the heights stays above %g within half of what was "
                        "measured; accepted: a longer stretch",
                        FALLS);
  out->alpha = um_materials_roughness_alpha(out->rq, out->tau);
  out->alpha_gaussian = 2.0 * sqrt(log(5.0)) * out->rq / out->tau;
  return UM_OK;
}
