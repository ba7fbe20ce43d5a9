/* As many points and paths as a relative error wants. */
#ifndef UMBRA_OPTICS_ADAPT_H
#define UMBRA_OPTICS_ADAPT_H

#include "optics/radiance/optics.h"

struct um_optics_adaptation {
  double largest; /* relative error stated of any instant and band afterwards [1] */
  size_t missed;  /* instants that ask for more than UM_OPTICS_SAMPLES_MAX points or 64 times the
                     paths of the scene */
  int most;       /* points per facet of any instant */
  double points;  /* per facet, mean over instants [1] */
  double paths;   /* over those of the scene, mean over instants [1] */
};

/* Trace instants of a view again, with more points, and set the paths of instants, until the
 * standard error is at most relative_error of the intensity in every band; an instant keeps the
 * points and paths that it has where they suffice. What is asked for is met within 20 % in the mean
 * over draws of the points, where more than view's own points are needed (test: stat_optics_adapt).
 * scene: its view is `view`. Errors of um_optics_lightcurve_compute and of um_optics_view_retrace.
 * Same bytes for any number of threads. */
enum um_status um_optics_adapt(struct um_context *context, const struct um_optics_scene *scene,
                               const struct um_optics_band *bands, size_t nband,
                               double relative_error, struct um_optics_view *view,
                               struct um_optics_adaptation *out);

#endif
