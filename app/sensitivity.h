/* What umbra sensitivity works with, and prints. */
#ifndef UMBRA_APP_SENSITIVITY_H
#define UMBRA_APP_SENSITIVITY_H

#include "app/app.h"
#include "evidence/sensitivity/report/write.h"

/* The tables for a person (sensitivity_print.c). */
void um_app_sensitivity_print(const struct um_sensitivity_report *report, const char *folder);

#endif
