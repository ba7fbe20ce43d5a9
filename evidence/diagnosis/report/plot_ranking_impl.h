/* The ranking and the missing heat in pictures. Private to evidence/diagnosis/report/. */
#ifndef UMBRA_DIAGNOSIS_REPORT_PLOT_RANKING_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_PLOT_RANKING_IMPL_H

#include "base/plot/plot.h"
#include "evidence/diagnosis/diagnosis.h"

/* ranking.png: chi-square that the best candidates explain of the baseline, by a fit or by a
 * linear model; there is a ranking. */
enum um_status um_diagnosis_report_plot_ranking(struct um_context *context,
                                                const struct um_diagnosis *diagnosis,
                                                struct um_plot *plot);
/* heat.png: history of the missing heat at the best place; there is one. */
enum um_status um_diagnosis_report_plot_heat(struct um_context *context,
                                             const struct um_diagnosis *diagnosis,
                                             struct um_plot *plot);

#endif
