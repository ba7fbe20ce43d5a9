/* A diagnosis in files. */
#ifndef UMBRA_DIAGNOSIS_REPORT_WRITE_H
#define UMBRA_DIAGNOSIS_REPORT_WRITE_H

#include "base/core/file.h"
#include "evidence/diagnosis/diagnosis.h"

/* diagnosis.json, diagnosis.txt (text.h), ranking.csv, fit.csv (observations: time_utc, quantity,
 * of, measured, sigma, before, after), improved/scenario.yaml (runs in place: the user's scenario
 * with its paths made to fit and the effects added), heat.csv where heat was reconstructed,
 * report.html, and with `pictures` those of um_diagnosis_report_plot, into a folder in the making.
 * UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_write(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, const char *command,
                                         const char *version, bool pictures,
                                         struct um_core_folder *folder);

#endif
