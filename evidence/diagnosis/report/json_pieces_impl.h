/* Members that diagnosis.json is made of. Private to evidence/diagnosis/report/. */
#ifndef UMBRA_DIAGNOSIS_REPORT_JSON_PIECES_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_JSON_PIECES_IMPL_H

#include <stdio.h>

#include "evidence/diagnosis/diagnosis.h"

/* before, "key": value; null where the time is not finite. */
void um_diagnosis_report_json_time(FILE *file, const char *before, const char *key, double t_tai);
/* "effect": ..., "target": ... */
void um_diagnosis_report_json_use(FILE *file, const struct um_effect *effect, const char *target);
/* An object of one value that is left open. */
void um_diagnosis_report_json_parameter(FILE *file, const struct um_effect_parameter *parameter,
                                        double value, double sigma);
/* , "parameters": [...], each with the whole that the scenario states, where it states something.
 */
void um_diagnosis_report_json_parameters(FILE *file, const struct um_diagnosis *d,
                                         const struct um_effect *effect, const char *target,
                                         const double *value, const double *sigma);

#endif
