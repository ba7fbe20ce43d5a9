/* Loads along a timeline: at every time of the grid, or, of a body that turns faster than its walls
 * follow, means over its turns. What is observed then has loads at its own instants for the light,
 * and at each how temperatures of that instant vary about those of the means. */
#include "model/geometry/precompute_loads_impl.h"

#include <math.h>

#include "environment/atmosphere.h"
#include "model/build/effects_group.h"
#include "model/build/timeline.h"
#include "model/geometry/body_tables.h"
#include "model/geometry/precompute_exchange_impl.h"
#include "model/scenario/fail_group.h"
#include "thermal/solver/spin_variation.h"

#define GAS_THAT_SHOWS 0.5 /* heat of the atmosphere [W/m^2]: 0.1 K of a black plate at 300 K */
#define MIRROR_POINTS  16  /* on each patch that sends sunlight on; a row in time has points anew */
#define TURN_SAMPLES   64  /* attitudes of a turn; an error below 3e-4 of the largest load */

/* Heat of the atmosphere that a scenario leaves out though it would show. */
static void warn_of_gas(struct um_context *context, const struct um_model *model,
                        const struct um_environment_sample *samples, size_t n)
{
  double most = 0.0;
  struct um_vec3 from;
  for (size_t i = 0; i < n && model->environment.gas_density_factor == 0.0; i++)
    most = fmax(most, um_environment_atmosphere_flow(&samples[i], &from));
  if (most > GAS_THAT_SHOWS)
    um_core_log(context, UM_LOG_INFO,
                "the air before the satellite brings up to %.2g W/m2 at mean solar activity, which "
                "is left out; accepted: the effect free_molecular_heating",
                most);
}

/* The one law of the attitude, if it turns; NULL, with why not. */
static const struct um_scenario_attitude *
turning_law(const struct um_model *model, struct um_scenario_turn *turn, const char **why)
{
  const struct um_schema_list *laws = &model->scenario->attitude;
  const struct um_scenario_attitude *law = laws->items;
  *why = NULL;
  if (laws->count != 1 || !um_scenario_turn(&law[0], turn))
    *why = "the attitude is not one law that turns";
  else if (model->nutates)
    *why = "the body nutates";
  else if (um_geometry_joint_moves(model->geometry))
    *why = "a joint moves";
  return *why == NULL ? law : NULL;
}

enum um_status um_model_spin_period(struct um_context *context, const struct um_model *model,
                                    const struct um_model_tables *tables, double *period)
{
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  struct um_scenario_turn turn;
  struct um_thermal_spin_variation variation;
  const char *why;
  bool wanted = thermal->spin_loads == UM_SPIN_AVERAGED;
  *period = 0.0;
  if (thermal->spin_loads == UM_SPIN_RESOLVED || (!wanted && !isnan(thermal->step_s))) return UM_OK;
  if (turning_law(model, &turn, &why) == NULL)
    return wanted ? um_model_fail(context, &thermal->at, "spin_loads",
                                  "averaged, but %s; accepted: resolved, automatic", why)
                  : UM_OK;
  double p = fabs(turn.period_s);
  if (!wanted && !(p <= UM_MODEL_LOADS_LONGEST_STEP)) return UM_OK;
  const struct um_environment *e = &model->environment;
  double sun = um_environment_solar_irradiance(e, tables->sample[0].sun_distance);
  UM_TRY(um_thermal_spin_variation_bound(context, model->body->network, p, sun, e->albedo,
                                         e->outgoing_longwave, &variation));
  if (!wanted && !(variation.error <= thermal->accuracy_K)) return UM_OK;
  *period = p;
  um_core_log(context, UM_LOG_INFO,
              "heat loads are means over the turn of %g s: temperatures swing by at most %.2g K "
              "within it, which is added; that leaves at most %.2g K",
              p, variation.amplitude, variation.error);
  return UM_OK;
}

/* Attitudes of a turn ahead of a sample. */
struct turner {
  struct um_context *context;
  const struct um_model *model;
  const struct um_environment_sample *samples;
};

static enum um_status turned(void *self, size_t row, double before, struct um_quat *q)
{
  const struct turner *t = self;
  return um_model_sample_turned(t->context, t->model, &t->samples[row], before, q);
}

enum um_status um_model_load_samples(struct um_context *context, const struct um_model *model,
                                     const double *times, size_t n,
                                     struct um_environment_sample **out)
{
  UM_TRY(um_core_allocate(context, n, sizeof **out, out));
  um_core_progress_begin(context, "following orbit and attitude for the heat loads", n);
  for (size_t i = 0; i < n; i++) {
    UM_TRY(um_model_sample_at(context, model, times[i], &(*out)[i]));
    UM_TRY(um_core_progress_step(context, 1));
  }
  um_core_progress_end(context);
  return UM_OK;
}

bool um_model_loads_by_angle(const struct um_model *model)
{
  for (size_t m = 0; m < um_geometry_material_count(model->geometry); m++)
    if (model->surface_law[m] != NULL && model->surface_law[m]->by_angle) return true;
  return false;
}

/* The model's, without angular moments where no absorptance depends on the angle. */
static struct um_environment environment_for(const struct um_model *model)
{
  struct um_environment environment = model->environment;
  environment.absorptance_by_angle = um_model_loads_by_angle(model);
  return environment;
}

/* A table at samples of the sky; turn [s], 0: of the attitudes as they are. */
static enum um_status table_make(struct um_context *context, const struct um_model *model,
                                 const struct um_irradiation_sky *sky,
                                 const struct um_environment_sample *samples, size_t n,
                                 const double *edge, size_t nedge, double turn, bool variation,
                                 struct um_irradiation_loads **out)
{
  struct turner turner = {context, model, samples};
  struct um_environment environment = environment_for(model);
  const struct um_irradiation_spin over = {.n = TURN_SAMPLES,
                                           .period = turn,
                                           .variation = variation,
                                           .attitude = turned,
                                           .self = &turner};
  const struct um_irradiation_loads_options options = {
      .nsample = model->scenario->thermal->samples, .sky = sky, .spin = turn > 0.0 ? &over : NULL};
  return um_irradiation_loads_make(context, model->geometry, &environment, samples, n, edge, nedge,
                                   &options, out);
}

/* Tables at the observed instants, beside that of the means; the start is their first row. */
static enum um_status trace_seen(struct um_context *context, const struct um_model *model,
                                 const double *edge, struct um_model_tables *tables)
{
  enum um_status status;
  size_t ninstant = tables->nobs * tables->nsub, n = 0;
  struct um_environment_sample *samples = NULL;
  double *times = NULL;
  UM_CHECK(um_core_allocate(context, ninstant + 1, sizeof *times, &times));
  if (tables->t_start < tables->sample[0].t_tai) times[n++] = tables->t_start;
  for (size_t i = 0; i < ninstant; i++)
    if (n == 0 || tables->sample[i].t_tai > times[n - 1]) times[n++] = tables->sample[i].t_tai;
  UM_CHECK(um_model_load_samples(context, model, times, n, &samples));
  UM_CHECK(table_make(context, model, tables->body->sky, samples, n, edge, tables->nevent, 0.0,
                      false, &tables->seen));
  UM_CHECK(table_make(context, model, tables->body->sky, samples, n, edge, tables->nevent,
                      tables->spin_period, true, &tables->spin_variation));
done:
  um_core_free(context, times);
  um_core_free(context, samples);
  return status;
}

/* The observed instants of sparse loads, between their rows. */
static enum um_status find_seen(struct um_context *context, struct um_model_tables *tables)
{
  size_t n = tables->nobs * tables->nsub;
  double *times = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *times, &times));
  for (size_t i = 0; i < n; i++) times[i] = tables->sample[i].t_tai;
  enum um_status status =
      um_irradiation_loads_between(context, tables->loads, times, n, &tables->seen);
  um_core_free(context, times);
  return status;
}

/* Loads by way of mirrors, at the rows of the loads. */
static enum um_status trace_mirrored(struct um_context *context, const struct um_model *model,
                                     const struct um_environment_sample *samples,
                                     struct um_model_tables *tables)
{
  const struct um_geometry_view_factor_table *table = tables->view_factors;
  struct turner turner = {context, model, samples};
  const struct um_irradiation_spin spin = {
      .n = TURN_SAMPLES, .period = tables->spin_period, .attitude = turned, .self = &turner};
  const struct um_irradiation_mirrored_options options = {
      .spin = tables->spin_period > 0.0 ? &spin : NULL, .points = MIRROR_POINTS};
  if (table == NULL || table->mirrors == NULL) return UM_OK;
  return um_irradiation_mirrored_trace(context, model->geometry, &model->environment, samples,
                                       tables->loads, table->patches, table->mirrors, &options,
                                       &tables->mirrored);
}

/* Row of what is seen at every observed instant. */
static enum um_status trace_rows(struct um_context *context, struct um_model_tables *tables)
{
  const struct um_irradiation_loads *seen = tables->seen;
  size_t ninstant = tables->nobs * tables->nsub, row = 0;
  UM_TRY(um_core_allocate(context, ninstant, sizeof *tables->load_row, &tables->load_row));
  for (size_t i = 0; i < ninstant; i++) {
    while (row + 1 < seen->ntime && seen->t[row] < tables->sample[i].t_tai) row++;
    tables->load_row[i] = row;
  }
  return UM_OK;
}

enum um_status um_model_precompute_loads(struct um_context *context, const struct um_model *model,
                                         const double *times, size_t ntime, const double *edge,
                                         struct um_model_tables *tables)
{
  enum um_status status;
  struct um_environment_sample *samples = NULL;
  UM_CHECK(um_model_load_samples(context, model, times, ntime, &samples));
  warn_of_gas(context, model, samples, ntime);
  if (tables->body == NULL) UM_CHECK(um_model_body_tables_create(context, model, &tables->body));
  UM_CHECK(table_make(context, model, tables->body->sky, samples, ntime, edge, tables->nevent,
                      tables->spin_period, false, &tables->loads));
  if (tables->spin_period > 0.0)
    UM_CHECK(trace_seen(context, model, edge, tables));
  else if (tables->sparse)
    UM_CHECK(find_seen(context, tables));
  else
    tables->seen = tables->loads;
  UM_CHECK(um_model_precompute_view_factors(context, model, samples, ntime, tables));
  UM_CHECK(trace_mirrored(context, model, samples, tables));
  UM_CHECK(trace_rows(context, tables));
  tables->load_sample = samples;
  samples = NULL;
done:
  um_core_free(context, samples);
  return status;
}
