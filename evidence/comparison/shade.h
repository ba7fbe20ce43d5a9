/* The Earth's shadow behind measurements. */
#ifndef UMBRA_COMPARE_SHADE_H
#define UMBRA_COMPARE_SHADE_H

#include "base/page/writer.h"
#include "base/plot/plot.h"
#include "model/build/model.h"

/* Umbra and penumbra of the model's orbit along the axis, whether or not anything was measured
 * there, edges to a millisecond; shadows of less than a minute between two sunlit instants may be
 * missed. Nothing where observations stand alone (orbit.points), nor on an axis of more than three
 * days. Errors of um_model_sample_at; times that the orbit does not cover count as sunlit. */
enum um_status um_compare_plot_shade(struct um_context *context, const struct um_model *model,
                                     const struct um_plot_time *time, struct um_plot *plot);

/* The same as the shades of a page, from t_tai `first` to `last`. */
enum um_status um_compare_page_shade(struct um_page_writer *w, const struct um_model *model,
                                     double first, double last);

#endif
