/* Parts of the script that draws a diagnosis. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_PLOT_IMPL_H
#define UMBRA_DIAGNOSIS_PLOT_IMPL_H

#include <stdio.h>

#include "compare/gnuplot.h"
#include "diagnosis/report_impl.h"

/* The Earth's shadow behind what is drawn from here on (plot.c). */
enum um_status um_diagnosis_plot_shade(struct um_context *context,
                                       const struct um_diagnosis *diagnosis,
                                       const struct um_compare_gnuplot_axis *axis, FILE *file);
/* ranking.png: chi-square that the best candidates explain of the baseline; there is a ranking. */
enum um_status um_diagnosis_plot_ranking(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, FILE *file);
/* heat.png: history of the missing heat at the best place; there is one. */
enum um_status um_diagnosis_plot_heat(struct um_context *context,
                                      const struct um_diagnosis *diagnosis, FILE *file);

#endif
