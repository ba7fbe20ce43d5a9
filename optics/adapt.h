/* As many points as a relative error wants. */
#ifndef UMBRA_OPTICS_ADAPT_H
#define UMBRA_OPTICS_ADAPT_H

#include "optics/optics.h"

struct um_optics_adaptation {
  double largest; /* relative error stated of any instant and band afterwards [1] */
  size_t missed;  /* instants that ask for more than UM_OPTICS_SAMPLES_MAX points */
  int most;       /* points per facet of any instant */
  double points;  /* per facet, mean over instants */
};

/* Trace instants of a view again, with more points, until the standard error of lines of sight is
 * at most relative_error of the intensity in every band; an instant keeps the points that it has
 * where they suffice. What is asked for is met within 20 % in the mean over draws of the points,
 * where more than view's own points are needed (test: stat_optics_adapt). scene: its view is
 * `view`; light between surfaces is left out of both error and intensity. Errors of
 * um_optics_lightcurve_compute and of um_optics_view_retrace. Same bytes for any number of threads.
 */
enum um_status um_optics_adapt(struct um_context *context, const struct um_optics_scene *scene,
                               const struct um_optics_band *bands, size_t nband,
                               double relative_error, struct um_optics_view *view,
                               struct um_optics_adaptation *out);

#endif
