/* umbra list keys: the reference of scenario.yaml, from the table that checks it; whole, or of one
 * key.
 */
#include "app/app.h"
#include "model/scenario/scenario_schema.h"

static enum um_status write_one(struct um_context *context, const char *path, bool json)
{
  const struct um_schema_object *object;
  const struct um_schema_field *field;
  UM_TRY(um_document_schema_find_path(context, &um_model_scenario_schema, path, &object, &field));
  return json ? um_document_schema_write_json_field(stdout, field)
              : um_document_schema_write_field(stdout, object, field, path);
}

int um_app_schema(struct um_context *context, const struct um_app_options *options)
{
  const struct um_schema_object *schema = &um_model_scenario_schema;
  if (options->npositional == 1)
    return write_one(context, options->positional[0], options->json) == UM_OK
               ? UM_APP_DONE
               : um_app_fail(context);
  enum um_status status = options->json ? um_document_schema_write_json(stdout, schema)
                                        : um_document_schema_write_markdown(stdout, schema);
  return status == UM_OK ? UM_APP_DONE : UM_APP_FAILED;
}
