/* What stands in diagnosis.json beside steps and ranking. Private to evidence/diagnosis/report/. */
#ifndef UMBRA_DIAGNOSIS_REPORT_JSON_REST_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_JSON_REST_IMPL_H

#include <stdio.h>

#include "evidence/diagnosis/diagnosis.h"

/* Members of the whole object, each with its comma before. */
void um_diagnosis_report_json_missed(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_superseded(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_residual(FILE *file, const struct um_missing_heat_residual *r);
void um_diagnosis_report_json_next(FILE *file, const struct um_diagnosis *d);
void um_diagnosis_report_json_unexplained(FILE *file, const struct um_missing_heat_unexplained *u);
void um_diagnosis_report_json_cost(FILE *file, const struct um_diagnosis *d);

#endif
