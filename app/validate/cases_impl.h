/* Groups of cases, one per file. Private to app/validate/. */
#ifndef UMBRA_VALIDATE_CASES_IMPL_H
#define UMBRA_VALIDATE_CASES_IMPL_H

#include "app/validate/validate.h"

/* The thermal half. */
enum um_status um_validate_conduction(struct um_context *context,
                                      struct um_validate_report *report);
enum um_status um_validate_radiation(struct um_context *context, struct um_validate_report *report);
enum um_status um_validate_networks(struct um_context *context, struct um_validate_report *report);
enum um_status um_validate_inside(struct um_context *context, struct um_validate_report *report);
enum um_status um_validate_orbiting(struct um_context *context, struct um_validate_report *report);
enum um_status um_validate_view_factors(struct um_context *context,
                                        struct um_validate_report *report);

/* The optical half. */
enum um_status um_validate_radiometry(struct um_context *context,
                                      struct um_validate_report *report);
enum um_status um_validate_surfaces(struct um_context *context, struct um_validate_report *report);
enum um_status um_validate_bodies(struct um_context *context, struct um_validate_report *report);

#endif
