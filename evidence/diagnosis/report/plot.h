/* A diagnosis in pictures. */
#ifndef UMBRA_DIAGNOSIS_REPORT_PLOT_H
#define UMBRA_DIAGNOSIS_REPORT_PLOT_H

#include "evidence/diagnosis/diagnosis.h"

/* Pictures by gnuplot: per channel data with model before and after and residuals of both below;
 * the ranking, fits beside linear models; heat where reconstructed. */
enum um_status um_diagnosis_report_plot(struct um_context *context,
                                        const struct um_diagnosis *diagnosis, const char *folder);

#endif
