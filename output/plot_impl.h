/* What the pictures of a run share. Private to output/. */
#ifndef UMBRA_OUTPUT_PLOT_IMPL_H
#define UMBRA_OUTPUT_PLOT_IMPL_H

#include "base/plot/plot.h"
#include "output/output.h"

#define UM_PLOT_LOG_FLOOR 1e-5 /* of the highest, where an axis is logarithmic */

/* Pixels. */
#define UM_PLOT_WIDTH 1000
#define UM_PLOT_LEFT  100
#define UM_PLOT_RIGHT 980
#define UM_PLOT_TOP   82
#define UM_PLOT_PANEL 240
#define UM_PLOT_KEY   46 /* above a panel: two lines of names */
#define UM_PLOT_BELOW 58

struct um_plot_time um_output_plot_time(const struct um_output_run *run);
/* The vertical axis of the next panels: a name, and what is drawn in which unit. Peaks of mirrors
 * outshine the rest by orders of magnitude; where the largest value is more than five times the
 * mean in sunlight the axis is logarithmic, five decades down. v(i) is then column i in the axis's
 * unit, up(v) at least the lower end of the axis. Returns the least that is seen on the axis, in
 * the unit of `largest`. */
double um_output_plot_ordinate(struct um_plot *plot, const char *name, const char *what,
                               const char *unit, double largest, double mean);

/* counts: what every sensor counts, and the band of its noise. */
void um_output_plot_counts(struct um_plot *plot, const struct um_output_run *run);

/* grey_body: temperature and cross-section of the thermal bands together, where there are three. */
void um_output_plot_grey_body(struct um_plot *plot, const struct um_output_run *run);

#endif
