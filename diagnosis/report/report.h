/* Files and pictures of a diagnosis. */
#ifndef UMBRA_DIAGNOSIS_REPORT_REPORT_H
#define UMBRA_DIAGNOSIS_REPORT_REPORT_H

#include <stdio.h>

#include "core/file.h"
#include "diagnosis/diagnose.h"

/* diagnosis.json, ranking.csv, fit.csv (observations: time_utc, quantity, of, measured, sigma,
 * before, after), improved/scenario.yaml (runs in place: the user's scenario with its paths made to
 * fit and the effects added), heat.csv where heat was reconstructed, into a folder in the making.
 */
enum um_status um_diagnosis_report_write(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, const char *command,
                                         const char *version, struct um_core_folder *folder);
/* diagnosis.json to a stream; the caller looks for its errors. UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_write_json(struct um_context *context,
                                              const struct um_diagnosis *diagnosis,
                                              const char *command, const char *version, FILE *file);
/* Pictures by gnuplot: per channel data with model before and after and residuals of both below;
 * the ranking, fits beside straight lines; heat where reconstructed. */
enum um_status um_diagnosis_report_plot(struct um_context *context,
                                        const struct um_diagnosis *diagnosis, const char *folder);

#endif
