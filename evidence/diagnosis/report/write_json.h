/* diagnosis.json. */
#ifndef UMBRA_DIAGNOSIS_REPORT_WRITE_JSON_H
#define UMBRA_DIAGNOSIS_REPORT_WRITE_JSON_H

#include <stdio.h>

#include "evidence/diagnosis/diagnosis.h"

/* diagnosis.json to a stream; the caller looks for its errors. UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_write_json(struct um_context *context,
                                              const struct um_diagnosis *diagnosis,
                                              const char *command, const char *version, FILE *file);

#endif
