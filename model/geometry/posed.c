/* Loads and lines of sight of instants that stand alone. */
#include "model/geometry/posed.h"

#include <math.h>
#include <string.h>

#include "model/geometry/body_tables.h"
#include "model/geometry/precompute_group.h"
#include "optics/paths/photon_maps.h"
#include "thermal/loads/loads.h"

enum um_status um_model_precompute_instants(struct um_context *context,
                                            const struct um_environment_sample *samples, size_t n,
                                            struct um_model_tables **out)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *tables, &tables));
  *tables = (struct um_model_tables){.nobs = n, .nsub = 1, .points = true, .period = NAN};
  UM_CHECK(um_core_allocate(context, n, sizeof *tables->sample, &tables->sample));
  memcpy(tables->sample, samples, n * sizeof *samples);
  *out = tables;
  tables = NULL;
done:
  um_model_tables_destroy(context, &tables);
  return status;
}

/* One row for each instant; rows want times that ascend, which instants need not. */
static enum um_status trace_loads(struct um_context *context, const struct um_model *model,
                                  bool light_alone, struct um_model_tables *tables)
{
  size_t n = tables->nobs * tables->nsub;
  struct um_environment environment = model->environment;
  struct um_environment_sample *numbered = NULL;
  struct um_irradiation_loads_options options = {.nsample = model->scenario->thermal->samples,
                                                 .earth_alone = light_alone};
  enum um_status status;
  environment.absorptance_by_angle = false; /* heat is not followed */
  if (tables->body == NULL) UM_TRY(um_model_body_tables_create(context, model, &tables->body));
  options.sky = tables->body->sky;
  UM_CHECK(um_core_allocate(context, n, sizeof *numbered, &numbered));
  for (size_t i = 0; i < n; i++) {
    numbered[i] = tables->sample[i];
    numbered[i].t_tai = tables->sample[0].t_tai + (double)i;
  }
  UM_CHECK(um_irradiation_loads_make(context, model->geometry, &environment, numbered, n, NULL, 0,
                                     &options, &tables->loads));
  tables->seen = tables->loads;
done:
  um_core_free(context, numbered);
  return status;
}

static void clear(struct um_context *context, struct um_model_tables *tables)
{
  if (tables->seen != tables->loads) um_irradiation_loads_destroy(context, &tables->seen);
  um_irradiation_loads_destroy(context, &tables->loads);
  um_optics_photon_maps_destroy(context, &tables->photons);
  um_optics_view_destroy(context, &tables->view);
  tables->seen = NULL;
}

enum um_status um_model_precompute_posed(struct um_context *context, const struct um_model *model,
                                         struct um_model_sampling sampling, bool light_alone,
                                         struct um_model_tables *tables)
{
  size_t n = tables->nobs * tables->nsub;
  clear(context, tables);
  if (tables->load_row == NULL) {
    UM_TRY(um_core_allocate(context, n, sizeof *tables->load_row, &tables->load_row));
    for (size_t i = 0; i < n; i++) tables->load_row[i] = i;
  }
  UM_TRY(trace_loads(context, model, light_alone, tables));
  return um_model_precompute_view(context, model, sampling, tables);
}
