/* The verdict in words. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_SUMMARY_IMPL_H
#define UMBRA_DIAGNOSIS_SUMMARY_IMPL_H

#include "evidence/diagnosis/diagnosis.h"

enum um_status um_diagnosis_summary_write(struct um_context *context, const struct um_diagnosis *d,
                                          char **out);

#endif
