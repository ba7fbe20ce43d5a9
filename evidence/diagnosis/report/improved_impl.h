/* The scenario with what was found. Private to evidence/diagnosis/report/. */
#ifndef UMBRA_DIAGNOSIS_REPORT_IMPROVED_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_IMPROVED_IMPL_H

#include "evidence/diagnosis/diagnosis.h"

/* improved/scenario.yaml into the folder at `path`. */
enum um_status um_diagnosis_report_improved_write(struct um_context *context,
                                                  const struct um_diagnosis *diagnosis,
                                                  const char *command, const char *version,
                                                  const char *path);

#endif
