/* Private to study/: pieces of its pictures. */
#ifndef UMBRA_STUDY_PLOT_IMPL_H
#define UMBRA_STUDY_PLOT_IMPL_H

#include "base/page/writer.h"
#include "base/plot/plot.h"
#include "study/plot.h"

/* Okabe & Ito 2008, told apart by colour-blind readers; of parameter i, in turn. */
const char *um_study_colour(size_t i);
bool um_study_is_curve(const struct um_study_result *result,
                       const struct um_study_quantity *quantity);

/* "power_W of bus [W]" of a parameter, as a horizontal label with few enough numbers. width [pixel]
 * of the panel. */
void um_study_plot_xaxis(struct um_plot *plot, const struct um_study_result *result,
                         size_t parameter, int width);
void um_study_axis_words(const struct um_study_result *result, size_t parameter, char *out,
                         size_t size);
/* Its least and largest value among the points. */
void um_study_extent(const struct um_study_result *result, size_t parameter, double *least,
                     double *largest);
/* "[10^-11 W/m^2]", in which `power` is drawn; "": a number without unit. */
double um_study_axis_unit(const struct um_study_quantity *quantity, double largest, char out[100]);

/* Curves with their indices below, up to four quantities a picture. */
void um_study_plot_curves(struct um_plot *plot, const struct um_study_result *result,
                          const struct um_study_statistics *statistics);

/* Probabilities over time from limits.csv; nothing without limits. */
void um_study_plot_limits(struct um_plot *plot, const struct um_study_result *result);

/* Writes surface.csv, and pictures of it. */
enum um_status um_study_plot_surfaces(struct um_context *context, struct um_plot *plot,
                                      const struct um_study_result *result,
                                      const struct um_study_statistics *statistics,
                                      struct um_core_folder *folder);

/* The same on a page, of a surrogate. */
enum um_status um_study_page_surfaces(struct um_page_writer *w,
                                      const struct um_study_result *result,
                                      const struct um_study_statistics *statistics);

/* Writes scatter.csv, and pictures of it; weight NULL: none. */
enum um_status um_study_plot_scatter(struct um_context *context, struct um_plot *plot,
                                     const struct um_study_result *result, const double *weight,
                                     struct um_core_folder *folder);
/* Writes posterior.csv, and the picture of it. */
enum um_status um_study_plot_posterior(struct um_context *context, struct um_plot *plot,
                                       const struct um_study_result *result, const double *weight,
                                       struct um_core_folder *folder);

#endif
