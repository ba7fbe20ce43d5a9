/* The measurements that a command line names. */
#ifndef UMBRA_APP_MEASURED_H
#define UMBRA_APP_MEASURED_H

#include "app/app.h"
#include "evidence/measurements/join.h"

/* Those of MEASURED..., behind SCENARIO: one file, or several as sets; without any those of
 * measurements.sets. Errors of um_compare_measurements_read_all and um_compare_measurements_listed;
 * the caller destroys. */
enum um_status um_app_measured_read(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_compare_measurements **out);

#endif
