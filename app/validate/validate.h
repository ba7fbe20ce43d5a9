/* The cases of umbra validate: expected and computed, with tolerance and source. */
#ifndef UMBRA_VALIDATE_VALIDATE_H
#define UMBRA_VALIDATE_VALIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

struct um_validate_report;

/* One row. tolerance is absolute, in `unit`; source is who says the expected value. */
void um_validate_report_add(struct um_validate_report *report, const char *name, const char *unit,
                            double expected, double computed, double tolerance, const char *source);

/* Cases of one group, added to a report. */
typedef enum um_status um_validate_cases(struct um_context *context,
                                         struct um_validate_report *report);

/* An empty report; the caller destroys. UM_ERR_MEMORY. */
enum um_status um_validate_report_create(struct um_context *context,
                                         struct um_validate_report **out);
void um_validate_report_destroy(struct um_context *context, struct um_validate_report **report);
/* Add the cases of a group; `group` is a literal. UM_ERR_MEMORY, or what the cases fail with. */
enum um_status um_validate_report_fill(struct um_validate_report *report, const char *group,
                                       um_validate_cases *fill);
/* Print all rows on stdout as a table or JSON; returns how many missed their tolerance. */
size_t um_validate_report_print(const struct um_validate_report *report, bool json);

/* Fill the report; each case is computed by the library at the time of the call. */
um_validate_cases um_validate_orbit, um_validate_environment, um_validate_thermal,
    um_validate_optics;

#endif
