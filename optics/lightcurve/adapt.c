/* As many points, and paths between surfaces, as a relative error wants.
 *
 * The variance of an instant is C q(n) + P/m with q(n) what n points do where edges are straight
 * (um_geometry_scatter) and m the paths. Paths come first: P/m is to be at most half of what is
 * asked, so that after a look with m, whose variance is r^2 times that, m' = m r^2. Points get what
 * is left: n' is the smallest number with q(n') <= q(n)/r^2, r the ratio of what is to what is
 * left. C and P are better known then: looks are repeated until no instant is more than SLACK above
 * what is asked. Numbers depend on the instant alone, not on threads. */
#include "optics/lightcurve/adapt.h"

#include <math.h>

#include "geometry/scatter.h"
#include "optics/radiance/coarse_group.h"

#define SLACK 1.05 /* of what is asked: no further look */
#define LOOKS 8
#define STEP  1.03 /* between numbers that are tried */
#define MOST  64   /* times the paths of the scene */

/* Light between surfaces of an instant and band, [ntime * nband]. */
struct between {
  double *light;    /* intensity [W/sr] */
  double *variance; /* by paths [W^2/sr^2] */
};

/* All light of an instant and band, and what of it came by way of two surfaces or more. */
static double intensity(const struct um_optics_lightcurve *curve, size_t at, double *between)
{
  const double *of = curve->intensity + at * curve->nmaterial * UM_MECHANISM_COUNT;
  double sum = 0.0;
  *between = 0.0;
  for (size_t m = 0; m < curve->nmaterial; m++, of += UM_MECHANISM_COUNT) {
    for (int k = 0; k < UM_MECHANISM_COUNT; k++) sum += of[k];
    *between += of[UM_MECHANISM_INTERREFLECTED];
  }
  return sum;
}

/* Largest error of a time over its intensity, of all bands [1], and over what paths leave of the
 * asked one; 0 where there is no error. curve: without light between surfaces. */
static double relative(const struct um_optics_lightcurve *curve, const struct between *between,
                       size_t time, double asked, double *over)
{
  double largest = 0.0;
  *over = 0.0;
  for (size_t at = time * curve->nband; at < (time + 1) * curve->nband; at++) {
    double unused, error = curve->stderr_[at], variance = between->variance[at];
    double light = intensity(curve, at, &unused) + between->light[at], wanted = asked * light;
    if (!(error > 0.0 || variance > 0.0)) continue;
    largest = fmax(largest, light > 0.0 ? sqrt(error * error + variance) / light : INFINITY);
    double left = fmax(wanted * wanted - variance, 0.5 * wanted * wanted);
    *over = fmax(*over, error > 0.0 ? error / sqrt(left) : 0.0);
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
static size_t next_numbers(const struct um_optics_lightcurve *curve, const struct between *between,
                           const struct um_optics_view *view, double asked, int *number,
                           struct um_optics_adaptation *out)
{
  size_t changed = 0;
  *out = (struct um_optics_adaptation){0};
  for (size_t t = 0; t < view->ntime; t++) {
    int n = view->nsample[t];
    double r, is = relative(curve, between, t, asked, &r);
    out->largest = fmax(out->largest, is);
    out->paths += (double)view->path_factor[t] / (double)view->ntime;
    out->points += (double)n / (double)view->ntime;
    out->most = n > out->most ? n : out->most;
    number[t] = r > SLACK ? number_for(n, r) : n;
    if (number[t] > n) changed++;
    if (number[t] == n && is > SLACK * asked) out->missed++;
  }
  return changed;
}

/* Factors for the next look at paths; how many instants change. */
static size_t next_factors(const struct um_optics_lightcurve *curve, double asked,
                           struct um_optics_view *view, struct between *between)
{
  size_t changed = 0;
  for (size_t t = 0; t < view->ntime; t++) {
    double over = 0.0;
    for (size_t at = t * curve->nband; at < (t + 1) * curve->nband; at++) {
      double error = curve->between_stderr[at];
      double wanted = asked * intensity(curve, at, &between->light[at]);
      between->variance[at] = error * error;
      if (error > 0.0) over = fmax(over, wanted > 0.0 ? error / (sqrt(0.5) * wanted) : INFINITY);
    }
    int factor = (int)fmin(ceil(view->path_factor[t] * over * over), MOST);
    if (!(over > SLACK) || factor <= view->path_factor[t]) continue;
    view->path_factor[t] = factor;
    changed++;
  }
  return changed;
}

/* Paths of every instant, and what they bring. */
static enum um_status adapt_paths(struct um_context *context, const struct um_optics_scene *scene,
                                  const struct um_optics_band *bands, size_t nband,
                                  double relative_error, struct um_optics_view *view,
                                  struct between *between)
{
  struct um_optics_scene all = *scene;
  all.view = view;
  for (int look = 0;; look++) {
    struct um_optics_lightcurve *curve = NULL;
    UM_TRY(um_optics_lightcurve_compute(context, &all, bands, nband, &curve));
    size_t changed = next_factors(curve, relative_error, view, between);
    um_optics_lightcurve_destroy(context, &curve);
    if (changed == 0 || look == LOOKS) return UM_OK;
  }
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
  struct between between = {NULL, NULL};
  direct.view = view;
  direct.interreflection_samples = 0;
  UM_CHECK(um_core_allocate(context, nband, sizeof *coarse, &coarse));
  UM_CHECK(um_core_allocate(context, nband * UM_OPTICS_COARSE_BINS, sizeof *transmission,
                            &transmission));
  UM_CHECK(um_core_allocate(context, view->ntime, sizeof *number, &number));
  UM_CHECK(um_core_allocate(context, view->ntime * nband, sizeof *between.light, &between.light));
  UM_CHECK(
      um_core_allocate(context, view->ntime * nband, sizeof *between.variance, &between.variance));
  um_optics_coarse_bands(bands, nband, coarse, transmission);
  UM_CHECK(adapt_paths(context, scene, coarse, nband, relative_error, view, &between));
  for (int look = 0;; look++) {
    UM_CHECK(um_optics_lightcurve_compute(context, &direct, coarse, nband, &curve));
    size_t changed = next_numbers(curve, &between, view, relative_error, number, out);
    um_optics_lightcurve_destroy(context, &curve);
    if (changed == 0 || look == LOOKS) break;
    UM_CHECK(um_optics_view_retrace(context, scene->geometry, scene->samples, number, view));
  }
done:
  um_optics_lightcurve_destroy(context, &curve);
  UM_FREE(context, coarse, transmission, number, between.light, between.variance);
  return status;
}
