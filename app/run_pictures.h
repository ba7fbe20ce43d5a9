/* Pictures of a run. */
#ifndef UMBRA_APP_RUN_PICTURES_H
#define UMBRA_APP_RUN_PICTURES_H

#include "app/app.h"
#include "output/output.h"

/* satellite.png, .svg and .pdf. Needs an observer. */
enum um_status um_app_run_panels(struct um_context *context, const struct um_output_run *run,
                                 const char *folder);
/* Before anything is computed from the geometry: UM_ERR_INPUT where --picture asks for an instant
 * outside the run, or there is no observer. */
enum um_status um_app_run_views_check(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables,
                                      const struct um_app_options *options);
/* What --picture asks for. */
enum um_status um_app_run_views(struct um_context *context, const struct um_output_run *run,
                                const struct um_app_options *options, const char *folder);

#endif
