/* A Lambert term and a lobe fitted to measured BRDFs.
 *
 *   f = rho/pi + F f_lobe(alpha),  sum (ln f_measured - ln f)^2 least,
 * which weighs a grazing tail and a peak alike. For each alpha, ln rho and ln F by Levenberg and
 * Marquardt, steps of a factor e at most; alpha by golden section about the best of a logarithmic
 * grid. F is one number: a single wavelength in a plane does not tell its angle from masking.
 *
 * Why not base/inference/fit.h: it is for models that cost seconds, differences its Jacobian and
 * ends where their noise does, at 1e-9 of the squares. The derivatives are exact here, and the
 * search over alpha needs them: with it F moved in the sixth digit and one of 24 fits of a Starlink
 * did not end. */
#include "materials/brdf_fit.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/golden.h"

#define GRAZING   (85.0 * UM_DEG) /* beyond, a detector sees past the sample */
#define ROUNDING  1e-9            /* [rad] */
#define ROWS_MIN  6
#define GRID      81
#define SMOOTHEST 0.003
#define ROUGHEST  1.4
#define STEPS     500

struct task {
  const struct um_materials_brdf *brdf;
  size_t surface;
  double from;
  struct um_materials_lobe lobe;
  size_t n;
  double *measured, *unit; /* [n] BRDF, and the lobe of F = 1 [1/sr] */
};

/* The plane of incidence is y = 0, light comes from x < 0. */
static struct um_materials_pair pair_of(const struct um_materials_brdf_row *row)
{
  double s = sin(row->scattering);
  return um_materials_pair(
      um_vec3(-sin(row->incidence), 0.0, cos(row->incidence)),
      um_vec3(s * cos(row->azimuth), s * sin(row->azimuth), cos(row->scattering)));
}

static bool is_fitted(const struct task *task, const struct um_materials_brdf_row *row)
{
  if (row->surface != task->surface || row->incidence > GRAZING + ROUNDING) return false;
  if (fabs(row->scattering) > GRAZING + ROUNDING) return false;
  return acos(fmin(1.0, pair_of(row).cos_h)) >= task->from - ROUNDING;
}

static void set_lobes(struct task *task, double alpha)
{
  size_t n = 0;
  task->lobe.alpha = task->lobe.alpha_across = alpha;
  for (size_t r = 0; r < task->brdf->nrow; r++) {
    const struct um_materials_brdf_row *row = &task->brdf->row[r];
    if (!is_fitted(task, row)) continue;
    struct um_materials_pair pair = pair_of(row);
    task->measured[n] = row->brdf;
    task->unit[n++] = task->lobe.kind->evaluate(&task->lobe, &pair);
  }
}

/* Squares of ln f at x = (ln rho, ln F), and the normal equations of the Gauss-Newton step. */
static double squares_at(const struct task *task, const double x[2], double a[3], double b[2])
{
  double squares = 0.0;
  a[0] = a[1] = a[2] = b[0] = b[1] = 0.0;
  for (size_t k = 0; k < task->n; k++) {
    double even = exp(x[0]) / UM_PI, lobe = exp(x[1]) * task->unit[k], model = even + lobe;
    double r = log(task->measured[k] / model), s0 = even / model, s1 = lobe / model;
    squares += r * r;
    a[0] += s0 * s0;
    a[1] += s0 * s1;
    a[2] += s1 * s1;
    b[0] += s0 * r;
    b[1] += s1 * r;
  }
  return squares;
}

/* Best levels at the lobes that are set; false where it does not converge. */
static bool fit_levels(const struct task *task, double x[2], double *squares)
{
  double a[3], b[2], damping = 1e-3;
  x[0] = log(0.03);
  x[1] = log(0.05);
  *squares = squares_at(task, x, a, b);
  for (int step = 0; step < STEPS; step++) {
    double m0 = a[0] + damping, m1 = a[2] + damping, det = m0 * m1 - a[1] * a[1];
    double d[2] = {(b[0] * m1 - b[1] * a[1]) / det, (m0 * b[1] - a[1] * b[0]) / det};
    double most = fmax(fabs(d[0]), fabs(d[1])), factor = most > 1.0 ? 1.0 / most : 1.0;
    double tried[2] = {x[0] + factor * d[0], x[1] + factor * d[1]}, ta[3], tb[2];
    double after = squares_at(task, tried, ta, tb);
    if (!(after <= *squares)) {
      damping *= 10.0;
      if (damping > 1e12) return isfinite(*squares); /* no step helps any more */
      continue;
    }
    bool done = *squares - after <= 1e-12 * *squares;
    for (int k = 0; k < 2; k++) {
      x[k] = tried[k];
      b[k] = tb[k];
    }
    for (int k = 0; k < 3; k++) a[k] = ta[k];
    *squares = after;
    damping *= 0.1;
    if (done || x[0] < -50.0 || x[1] < -50.0) return true; /* a term that is not there */
  }
  return false;
}

static double cost(struct task *task, double log_alpha, bool *converged)
{
  double x[2], squares;
  set_lobes(task, exp(log_alpha));
  bool good = fit_levels(task, x, &squares);
  *converged = *converged || good;
  return good ? squares : INFINITY;
}

static double best_alpha(struct task *task, bool *converged)
{
  const double low = log(SMOOTHEST), step = (log(ROUGHEST) - low) / (GRID - 1);
  double least = INFINITY;
  int best = 0;
  *converged = false;
  for (int k = 0; k < GRID; k++) {
    double value = cost(task, low + k * step, converged);
    if (value < least) {
      least = value;
      best = k;
    }
  }
  double from = low + (best > 0 ? best - 1 : 0) * step,
         to = low + (best < GRID - 1 ? best + 1 : GRID - 1) * step;
  struct um_core_golden g = um_core_golden(from, to);
  double f[2] = {cost(task, g.x[0], converged), cost(task, g.x[1], converged)};
  while (g.to - g.from > 1e-6) {
    int k = um_core_golden_narrow(&g, f[0] < f[1]);
    f[1 - k] = f[k];
    f[k] = cost(task, g.x[k], converged);
  }
  return exp(0.5 * (g.from + g.to));
}

static enum um_status fit(struct um_context *context, struct task *task,
                          struct um_materials_brdf_fit *out)
{
  double x[2], squares;
  bool converged;
  set_lobes(task, best_alpha(task, &converged));
  if (!converged || !fit_levels(task, x, &squares))
    return um_core_fail(context, UM_ERR_NUMERIC, "surface '%s': the fit of %s did not converge",
                        task->brdf->surface[task->surface], task->lobe.kind->name);
  *out = (struct um_materials_brdf_fit){.lobe = task->lobe,
                                        .diffuse = exp(x[0]),
                                        .specular = exp(x[1]),
                                        .rms = sqrt(squares / (double)task->n),
                                        .nrow = task->n};
  for (size_t k = 0; k < task->n; k++) {
    double model = out->diffuse / UM_PI + out->specular * task->unit[k];
    out->largest = fmax(out->largest, fabs(log(task->measured[k] / model)));
  }
  for (double zenith = 0.0; zenith <= 80.0; zenith += 10.0) {
    double e = um_materials_lobe_albedo(&out->lobe, cos(zenith * UM_DEG));
    out->albedo = fmax(out->albedo, out->diffuse + out->specular * e);
  }
  return UM_OK;
}

enum um_status um_materials_brdf_fit(struct um_context *context,
                                     const struct um_materials_brdf *brdf, size_t surface,
                                     double from, struct um_materials_lobe lobe,
                                     struct um_materials_brdf_fit *out)
{
  enum um_status status = UM_OK;
  struct task task = {.brdf = brdf, .surface = surface, .from = from, .lobe = lobe};
  if (!lobe.kind->rough)
    return um_core_fail(context, UM_ERR_INPUT,
                        "a lobe of kind %s has no roughness to fit; accepted: one that has",
                        lobe.kind->name);
  for (size_t r = 0; r < brdf->nrow; r++) task.n += is_fitted(&task, &brdf->row[r]);
  if (task.n < ROWS_MIN)
    return um_core_fail(context, UM_ERR_INPUT,
                        "surface '%s' has %zu rows at half angles from %g deg and zenith angles to "
                        "85 deg; accepted: %d or more",
                        brdf->surface[surface], task.n, from / UM_DEG, ROWS_MIN);
  UM_CHECK(um_core_allocate(context, task.n, sizeof *task.measured, &task.measured));
  UM_CHECK(um_core_allocate(context, task.n, sizeof *task.unit, &task.unit));
  status = fit(context, &task, out);
done:
  UM_FREE(context, task.measured, task.unit);
  return status;
}
