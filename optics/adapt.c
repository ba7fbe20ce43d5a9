/* As many points as a relative error wants.
 *
 * The variance of an instant is C q(n) with q(n) what n points do where edges are straight
 * (um_geometry_scatter), so that after a look with n points, whose error is r times what
 * is asked, n' is the smallest number with q(n') <= q(n)/r^2. C itself is better known then: looks
 * are repeated until no instant is more than SLACK above what is asked. Numbers depend on the
 * instant alone, not on threads. */
#include "optics/adapt.h"

#include <math.h>

#include "geometry/scatter.h"
#include "optics/coarse_impl.h"

#define SLACK 1.05 /* of what is asked: no further look */
#define LOOKS 8
#define STEP  1.03 /* between numbers that are tried */

/* Largest error of a time over its intensity, of all bands [1]; 0 where there is no light. */
static double relative(const struct um_optics_lightcurve *curve, size_t time)
{
  size_t n = curve->nmaterial * UM_MECHANISM_COUNT;
  double largest = 0.0;
  for (size_t k = 0; k < curve->nband; k++) {
    double sum = 0.0, error = curve->stderr_[time * curve->nband + k];
    for (size_t i = 0; i < n; i++) sum += curve->intensity[(time * curve->nband + k) * n + i];
    if (error > 0.0) largest = fmax(largest, sum > 0.0 ? error / sum : INFINITY);
  }
  return largest;
}

/* Number of points whose variance is 1/r^2 of that of n. */
static int number_for(int n, double r)
{
  double wanted = um_geometry_scatter(n) / (r * r), next = n;
  while (n < UM_OPTICS_SAMPLES_MAX && um_geometry_scatter(n) > wanted) {
    next = fmax(next + 1.0, next * STEP);
    n = (int)fmin(next, UM_OPTICS_SAMPLES_MAX);
  }
  return n;
}

/* Numbers for the next look; how many instants change. */
static size_t next_numbers(const struct um_optics_lightcurve *curve,
                           const struct um_optics_view *view, double asked, int *number,
                           struct um_optics_adaptation *out)
{
  size_t changed = 0;
  *out = (struct um_optics_adaptation){0};
  for (size_t t = 0; t < view->ntime; t++) {
    int n = view->nsample[t];
    double is = relative(curve, t), r = is / asked;
    out->largest = fmax(out->largest, is);
    out->points += (double)n / (double)view->ntime;
    out->most = n > out->most ? n : out->most;
    number[t] = r > SLACK ? number_for(n, r) : n;
    if (number[t] > n) changed++;
    if (r > SLACK && number[t] == n) out->missed++;
  }
  return changed;
}

enum um_status um_optics_adapt(struct um_context *context, const struct um_optics_scene *scene,
                               const struct um_optics_band *bands, size_t nband,
                               double relative_error, struct um_optics_view *view,
                               struct um_optics_adaptation *out)
{
  enum um_status status;
  struct um_optics_scene direct = *scene;
  struct um_optics_lightcurve *curve = NULL;
  struct um_optics_band *coarse = NULL;
  double *transmission = NULL;
  int *number = NULL;
  direct.view = view;
  direct.interreflection_samples = 0;
  UM_CHECK(um_core_allocate(context, nband, sizeof *coarse, &coarse));
  UM_CHECK(um_core_allocate(context, nband * UM_OPTICS_COARSE_BINS, sizeof *transmission,
                            &transmission));
  UM_CHECK(um_core_allocate(context, view->ntime, sizeof *number, &number));
  um_optics_coarse_bands(bands, nband, coarse, transmission);
  for (int look = 0;; look++) {
    UM_CHECK(um_optics_lightcurve_compute(context, &direct, coarse, nband, &curve));
    size_t changed = next_numbers(curve, view, relative_error, number, out);
    um_optics_lightcurve_destroy(context, &curve);
    if (changed == 0 || look == LOOKS) break;
    UM_CHECK(um_optics_view_retrace(context, scene->geometry, scene->samples, number, view));
  }
done:
  um_optics_lightcurve_destroy(context, &curve);
  um_core_free(context, coarse);
  um_core_free(context, transmission);
  um_core_free(context, number);
  return status;
}
