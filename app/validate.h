/* The cases of umbra validate: expected and computed, with tolerance and source. */
#ifndef UMBRA_APP_VALIDATE_H
#define UMBRA_APP_VALIDATE_H

#include "core/context.h"

struct um_app_report;

/* One row. tolerance is absolute, in `unit`; source is who says the expected value. */
void um_app_report_add(struct um_app_report *report, const char *name, const char *unit,
                       double expected, double computed, double tolerance, const char *source);

/* Fill the report; each case is computed by the library at the time of the call. */
enum um_status um_app_validate_orbit(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_environment(struct um_context *context,
                                           struct um_app_report *report);
enum um_status um_app_validate_thermal(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_optics(struct um_context *context, struct um_app_report *report);

#endif
