/* umbra schema: the reference of scenario.yaml, from the table that checks it. */
#include "app/app.h"
#include "model/scenario.h"

int um_app_schema(struct um_context *context, const struct um_app_options *options)
{
  (void)context;
  enum um_status status = options->json
                              ? um_core_schema_write_json(stdout, &um_model_scenario_schema)
                              : um_core_schema_write_markdown(stdout, &um_model_scenario_schema);
  return status == UM_OK ? UM_APP_DONE : UM_APP_FAILED;
}
