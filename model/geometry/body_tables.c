/* Tables of a body, counted by their users. */
#include "model/geometry/body_tables.h"

#include "model/build/model.h"
#include "thermal/loads/loads.h"

enum um_status um_model_body_tables_create(struct um_context *context, const struct um_model *model,
                                           struct um_model_body_tables **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  atomic_init(&(*out)->users, 1);
  if (!um_irradiation_wants_sky(model->geometry, &model->environment)) return UM_OK;
  enum um_status status = um_irradiation_sky_create(context, model->geometry, &(*out)->sky);
  if (status != UM_OK) um_model_body_tables_release(context, out);
  return status;
}

struct um_model_body_tables *um_model_body_tables_share(struct um_model_body_tables *tables)
{
  if (tables != NULL) atomic_fetch_add(&tables->users, 1);
  return tables;
}

void um_model_body_tables_release(struct um_context *context, struct um_model_body_tables **tables)
{
  struct um_model_body_tables *t = *tables;
  *tables = NULL;
  if (t == NULL || atomic_fetch_sub(&t->users, 1) > 1) return;
  um_irradiation_sky_destroy(context, &t->sky);
  um_geometry_view_factor_table_destroy(context, &t->view_factors);
  um_core_free(context, t);
}
