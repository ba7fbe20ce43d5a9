/* What of geometry tables hangs on the body alone, whatever the times, the orbit, the
 * attitude and the spin. */
#ifndef UMBRA_MODEL_BODY_TABLES_H
#define UMBRA_MODEL_BODY_TABLES_H

#include <stdatomic.h>

#include "geometry/view_factor_table.h"
#include "thermal/loads/sky.h"

struct um_model;

/* Shared by geometry tables of models for which um_model_body_is_compatible; the last one frees
 * them. */
struct um_model_body_tables {
  atomic_size_t users;
  struct um_irradiation_sky *sky;                     /* NULL: um_irradiation_wants_sky says no */
  struct um_geometry_view_factor_table *view_factors; /* NULL: heat is not followed */
};

/* One user, a sky, and no view factors yet. Errors of um_irradiation_sky_create. */
enum um_status um_model_body_tables_create(struct um_context *context, const struct um_model *model,
                                           struct um_model_body_tables **out);
/* One user more; NULL: NULL. */
struct um_model_body_tables *um_model_body_tables_share(struct um_model_body_tables *tables);
/* One user less. *tables NULL afterwards. */
void um_model_body_tables_release(struct um_context *context, struct um_model_body_tables **tables);

#endif
