/* Cases of heat. Each is a model of its own: what a case changes may be anything of a scenario. */
#include "model/cases.h"

#include <math.h>
#include <string.h>

#include "model/balance.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run_places_impl.h"
#include "model/thermal_solution.h"
#include "model/words_impl.h"

const char *um_model_analysis_name(enum um_model_analysis analysis)
{
  static const char *const names[] = {"transient", "orbit_mean", "steady"};
  return names[analysis];
}

/* Texts of the command line, then those of the case. */
static enum um_status join(struct um_context *context, const char *const *first, size_t nfirst,
                           const struct um_schema_list *own, const char *const **out, size_t *count)
{
  const char **texts = NULL;
  const char *const *own_texts = own->items;
  UM_TRY(um_core_allocate(context, nfirst + own->count + 1, sizeof *texts, &texts));
  for (size_t i = 0; i < nfirst; i++) texts[i] = first[i];
  for (size_t i = 0; i < own->count; i++) texts[nfirst + i] = own_texts[i];
  *out = texts;
  *count = nfirst + own->count;
  return UM_OK;
}

static enum um_status options_of(struct um_context *context, const struct um_model_options *given,
                                 const struct um_scenario_case *which, struct um_model_options *out)
{
  static const struct um_schema_list none = {NULL, 0};
  *out = *given;
  out->overrides = out->with = out->without = NULL;
  UM_TRY(join(context, given->overrides, given->noverride, which ? &which->set : &none,
              &out->overrides, &out->noverride));
  UM_TRY(join(context, given->with, given->nwith, which ? &which->with : &none, &out->with,
              &out->nwith));
  return join(context, given->without, given->nwithout, which ? &which->without : &none,
              &out->without, &out->nwithout);
}

static void options_clear(struct um_context *context, struct um_model_options *options)
{
  um_core_free(context, (void *)options->overrides);
  um_core_free(context, (void *)options->with);
  um_core_free(context, (void *)options->without);
}

static void limit_place(const struct um_model *model, struct um_model_case_place *place)
{
  const struct um_scenario_limit *limit = model->scenario->limits.items;
  place->minimum = place->maximum = place->uncertainty = NAN;
  place->margin_low = place->margin_high = NAN;
  for (size_t i = 0; i < model->scenario->limits.count; i++) {
    if (strcmp(limit[i].of, place->name) != 0) continue;
    place->minimum = limit[i].minimum_K;
    place->maximum = limit[i].maximum_K;
    place->uncertainty = limit[i].uncertainty_K;
    place->margin_low = place->lowest - place->uncertainty - place->minimum;
    place->margin_high = place->maximum - place->uncertainty - place->highest;
  }
}

static enum um_status places_begin(struct um_context *context, const struct um_model *model,
                                   struct um_model_case *c)
{
  const struct um_thermal_body *body = model->body;
  UM_TRY(um_core_allocate(context, body->nplace, sizeof *c->place, &c->place));
  for (c->nplace = 0; c->nplace < body->nplace; c->nplace++)
    UM_TRY(um_core_asprintf(context, &c->place[c->nplace].name, "%s", body->place[c->nplace].name));
  return UM_OK;
}

/* One set of node temperatures. */
static void take_balance(const struct um_model *model, const double *temperature,
                         struct um_model_case *c)
{
  for (size_t p = 0; p < c->nplace; p++) {
    const struct um_thermal_place *from = &model->body->place[p];
    struct um_model_case_place *to = &c->place[p];
    to->lowest = INFINITY;
    to->highest = -INFINITY;
    for (size_t j = 0; j < from->nnode; j++) {
      double t = temperature[from->node[j]];
      to->mean += from->weight[j] * t;
      to->lowest = fmin(to->lowest, t);
      to->highest = fmax(to->highest, t);
    }
  }
}

static enum um_status balance(struct um_context *context, const struct um_model *model,
                              const struct um_model_precomputed *precomputed,
                              struct um_model_case *c)
{
  double *temperature = NULL;
  UM_TRY(um_core_allocate(context, um_thermal_network_nodes(model->body->network),
                          sizeof *temperature, &temperature));
  enum um_status status = c->analysis == UM_ANALYSIS_STEADY
                              ? um_model_balance_steady(context, model, precomputed, temperature)
                              : um_model_balance_orbit(context, model, precomputed, temperature);
  if (status == UM_OK) take_balance(model, temperature, c);
  um_core_free(context, temperature);
  return status;
}

static enum um_status follow(struct um_context *context, const struct um_model *model,
                             const struct um_model_precomputed *precomputed,
                             struct um_model_case *c)
{
  enum um_status status;
  struct um_model_thermal_solution *heat = NULL;
  struct um_model_result *result = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *result, &result));
  result->nobs = precomputed->nobs;
  UM_CHECK(um_model_thermal_solution_create(context, model, precomputed, NULL, 1.0, &heat));
  UM_CHECK(um_model_run_histories(context, model, precomputed, heat, result));
  for (size_t p = 0; p < c->nplace; p++) {
    const struct um_model_place_history *from = &result->place[p];
    struct um_model_case_place *to = &c->place[p];
    to->lowest = INFINITY;
    to->highest = -INFINITY;
    for (size_t k = 0; k < result->nobs; k++) {
      to->mean += from->mean[k] / (double)result->nobs;
      to->lowest = fmin(to->lowest, from->minimum[k]);
      to->highest = fmax(to->highest, from->maximum[k]);
    }
  }
done:
  um_model_thermal_solution_destroy(context, &heat);
  um_model_result_destroy(context, &result);
  return status;
}

/* which: NULL for the scenario as it is. */
static enum um_status case_make(struct um_context *context, const char *path,
                                const struct um_model_options *given,
                                const struct um_scenario_case *which, struct um_model_case *out)
{
  enum um_status status;
  struct um_model_options options = {0};
  struct um_model *model = NULL;
  struct um_model_precomputed *precomputed = NULL;
  UM_CHECK(um_core_asprintf(context, &out->name, "%s", which ? which->name : "nominal"));
  out->analysis = which ? (enum um_model_analysis)which->analysis : UM_ANALYSIS_TRANSIENT;
  UM_CHECK(options_of(context, given, which, &options));
  UM_CHECK(um_model_create(context, path, &options, &model));
  UM_CHECK(um_model_precompute(context, model, &precomputed));
  UM_CHECK(places_begin(context, model, out));
  if (out->analysis == UM_ANALYSIS_TRANSIENT)
    UM_CHECK(follow(context, model, precomputed, out));
  else
    UM_CHECK(balance(context, model, precomputed, out));
  for (size_t p = 0; p < out->nplace; p++) limit_place(model, &out->place[p]);
done:
  um_model_precomputed_destroy(context, &precomputed);
  um_model_destroy(context, &model);
  options_clear(context, &options);
  if (status != UM_OK && which != NULL) return um_model_blame(context, &which->at, NULL, status);
  return status;
}

enum um_status um_model_cases_create(struct um_context *context, const char *path,
                                     const struct um_model_options *options,
                                     struct um_model_cases **out)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_cases *cases = NULL;
  *out = NULL;
  UM_CHECK(um_model_create(context, path, options, &model));
  const struct um_scenario_case *which = model->scenario->cases.items;
  size_t n = model->scenario->cases.count;
  UM_CHECK(um_core_allocate(context, 1, sizeof *cases, &cases));
  cases->count = n > 0 ? n : 1;
  UM_CHECK(um_core_asprintf(context, &cases->scenario, "%s", model->scenario->name));
  UM_CHECK(um_core_allocate(context, cases->count, sizeof *cases->item, &cases->item));
  for (size_t i = 0; i < cases->count; i++) {
    um_core_log(context, UM_LOG_INFO, "case %zu of %zu: %s", i + 1, cases->count,
                n > 0 ? which[i].name : "nominal");
    UM_CHECK(case_make(context, path, options, n > 0 ? &which[i] : NULL, &cases->item[i]));
  }
  *out = cases;
  cases = NULL;
done:
  um_model_destroy(context, &model);
  um_model_cases_destroy(context, &cases);
  return status;
}

void um_model_cases_destroy(struct um_context *context, struct um_model_cases **cases)
{
  if (cases == NULL || *cases == NULL) return;
  for (size_t i = 0; (*cases)->item != NULL && i < (*cases)->count; i++) {
    struct um_model_case *c = &(*cases)->item[i];
    for (size_t p = 0; c->place != NULL && p < c->nplace; p++)
      um_core_free(context, c->place[p].name);
    um_core_free(context, c->place);
    um_core_free(context, c->name);
  }
  um_core_free(context, (*cases)->item);
  um_core_free(context, (*cases)->scenario);
  um_core_free(context, *cases);
  *cases = NULL;
}
