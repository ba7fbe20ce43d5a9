/* Pieces of gnuplot scripts that pictures of measurements over time share. They read tables whose
 * first columns are time_utc, quantity, of. Errors of writing are the stream's. */
#ifndef UMBRA_COMPARE_GNUPLOT_H
#define UMBRA_COMPARE_GNUPLOT_H

#include <stdio.h>

#include "compare/measurements.h"
#include "compare/segments.h"

/* A name inside a double-quoted string of gnuplot that is shown: its marks of style are taken as
 * they are. */
void um_compare_gnuplot_name(FILE *file, const char *name);

/* The axis of time: minutes, hours or days since the first instant, by how long it is. */
struct um_compare_gnuplot_axis {
  double first, last; /* t_tai [s] */
  double unit;        /* [s] */
  const char *word;   /* "minutes" */
};
struct um_compare_gnuplot_axis um_compare_gnuplot_axis(double first, double last);
/* Place of a time on it. */
double um_compare_gnuplot_at(const struct um_compare_gnuplot_axis *axis, double t_tai);

/* Terminal of that height [pixels], ranges and functions: x(i) a column of times on the axis, y(i)
 * a column, s(i) a column in which empty is 0; x and y only of the channel that
 * um_compare_gnuplot_channel has named last. */
void um_compare_gnuplot_head(FILE *file, const struct um_compare_gnuplot_axis *axis, int height);
/* Runs of umbra as dark, of penumbra as light boxes behind the curves, halfway to the neighbours.
 * time, light: [count], times rising; light from UM_SEGMENT_SUNLIT to UM_SEGMENT_UMBRA. */
void um_compare_gnuplot_shade(FILE *file, const struct um_compare_gnuplot_axis *axis, size_t count,
                              const double *time, const enum um_compare_segment *light);
/* Output file `name`.png, the channel's rows chosen, y reversed for magnitudes. */
void um_compare_gnuplot_channel(FILE *file, const char *name,
                                const struct um_compare_channel *channel);
/* Label of the axis of time. */
void um_compare_gnuplot_xlabel(FILE *file, const struct um_compare_gnuplot_axis *axis);

#endif
