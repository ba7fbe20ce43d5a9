/* Cases of heat: variants of the scenario, each with the heat of a run of its own. */
#include "variant/cases.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "model/build/build.h"
#include "model/build/effects.h"
#include "model/run/balance.h"
#include "model/run/run.h"
#include "variant/evaluator.h"

const char *um_variant_analysis_name(enum um_variant_analysis analysis)
{
  static const char *const names[] = {"transient", "orbit_mean", "steady"};
  return names[analysis];
}

/* Changes of a case: "KEY=VALUE" as its file says, and effects. */
struct changes {
  struct um_document_change *key; /* [nkey of all], keys owned */
  struct um_model_changes all;
};

static void changes_clear(struct um_context *context, struct changes *c)
{
  for (size_t i = 0; i < c->all.nkey; i++) um_core_free(context, (void *)(uintptr_t)c->key[i].key);
  um_core_free(context, c->key);
}

/* which: NULL for the scenario as it is. */
static enum um_status changes_of(struct um_context *context, const struct um_scenario_case *which,
                                 struct changes *out)
{
  *out = (struct changes){.key = NULL};
  if (which == NULL) return UM_OK;
  const char *const *set = which->set.items;
  UM_TRY(um_core_allocate(context, which->set.count, sizeof *out->key, &out->key));
  for (size_t i = 0; i < which->set.count; i++) {
    const char *equals = strchr(set[i], '=');
    char *key = NULL;
    if (equals == NULL || equals == set[i])
      return um_core_fail(context, UM_ERR_INPUT, "--set: '%s'; accepted: KEY=VALUE", set[i]);
    UM_TRY(um_core_asprintf(context, &key, "%.*s", (int)(equals - set[i]), set[i]));
    out->key[out->all.nkey++] =
        (struct um_document_change){.key = key, .number = NAN, .text = equals + 1};
  }
  out->all.key = out->key;
  out->all.with = which->with.items;
  out->all.nwith = which->with.count;
  out->all.without = which->without.items;
  out->all.nwithout = which->without.count;
  return UM_OK;
}

static void limit_place(const struct um_model *model, struct um_variant_case_place *place)
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
                                   struct um_variant_case *c)
{
  const struct um_thermal_body *body = model->body;
  UM_TRY(um_core_allocate(context, body->nplace, sizeof *c->place, &c->place));
  for (c->nplace = 0; c->nplace < body->nplace; c->nplace++)
    UM_TRY(um_core_asprintf(context, &c->place[c->nplace].name, "%s", body->place[c->nplace].name));
  return UM_OK;
}

/* One set of node temperatures. */
static void take_balance(const struct um_model *model, const double *temperature,
                         struct um_variant_case *c)
{
  for (size_t p = 0; p < c->nplace; p++) {
    const struct um_thermal_place *from = &model->body->place[p];
    struct um_variant_case_place *to = &c->place[p];
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
                              const struct um_model_tables *tables, struct um_variant_case *c)
{
  double *temperature = NULL;
  UM_TRY(um_core_allocate(context, um_thermal_network_nodes(model->body->network),
                          sizeof *temperature, &temperature));
  enum um_status status = c->analysis == UM_ANALYSIS_STEADY
                              ? um_model_balance_steady(context, model, tables, temperature)
                              : um_model_balance_orbit(context, model, tables, temperature);
  if (status == UM_OK) take_balance(model, temperature, c);
  um_core_free(context, temperature);
  return status;
}

static enum um_status follow(struct um_context *context, const struct um_variant *v,
                             struct um_variant_case *c)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_model_run_places(context, v->model, v->tables, v->heat, &result));
  for (size_t p = 0; p < c->nplace; p++) {
    const struct um_model_place_history *from = &result->place[p];
    struct um_variant_case_place *to = &c->place[p];
    to->lowest = INFINITY;
    to->highest = -INFINITY;
    for (size_t k = 0; k < result->nobs; k++) {
      to->mean += from->mean[k] / (double)result->nobs;
      to->lowest = fmin(to->lowest, from->minimum[k]);
      to->highest = fmax(to->highest, from->maximum[k]);
    }
  }
  um_model_result_destroy(context, &result);
  return UM_OK;
}

/* which: NULL for the scenario as it is. */
static enum um_status case_make(struct um_context *context, const struct um_model *model,
                                struct um_variant_evaluator *evaluator,
                                const struct um_scenario_case *which, struct um_variant_case *out)
{
  enum um_status status;
  const struct um_variant_heat cold = {.start = UM_VARIANT_COLD};
  struct changes changes;
  struct um_variant v = {0};
  out->analysis = which ? (enum um_variant_analysis)which->analysis : UM_ANALYSIS_TRANSIENT;
  bool transient = out->analysis == UM_ANALYSIS_TRANSIENT;
  UM_CHECK(changes_of(context, which, &changes));
  for (size_t i = 0; i < changes.all.nwith; i++)
    UM_CHECK(um_model_check_with(context, model, changes.all.with[i]));
  UM_CHECK(um_core_asprintf(context, &out->name, "%s", which ? which->name : "nominal"));
  UM_CHECK(um_variant_open(context, evaluator, &changes.all, transient ? &cold : NULL, &v));
  UM_CHECK(places_begin(context, v.model, out));
  if (transient)
    UM_CHECK(follow(context, &v, out));
  else
    UM_CHECK(balance(context, v.model, v.tables, out));
  for (size_t p = 0; p < out->nplace; p++) limit_place(v.model, &out->place[p]);
done:
  um_variant_close(context, &v);
  changes_clear(context, &changes);
  if (status == UM_ERR_REFUSED) status = UM_ERR_INPUT;
  if (status == UM_OK || status == UM_ERR_MEMORY || status == UM_ERR_CANCELLED || which == NULL)
    return status;
  um_core_message_prefix(context, "%s:%d: %s", which->at.file, which->at.line, which->at.path);
  return status;
}

enum um_status um_variant_cases_create(struct um_context *context, const char *path,
                                       const struct um_model_options *options,
                                       struct um_variant_cases **out)
{
  enum um_status status;
  const struct um_variant_settings settings = {.instants = NULL};
  struct um_model *model = NULL;
  struct um_variant_evaluator *evaluator = NULL;
  struct um_variant_cases *cases = NULL;
  *out = NULL;
  UM_CHECK(um_model_create(context, path, options, &model));
  UM_CHECK(um_variant_evaluator_create(context, model, &settings, &evaluator));
  const struct um_scenario_case *which = model->scenario->cases.items;
  size_t n = model->scenario->cases.count;
  UM_CHECK(um_core_allocate(context, 1, sizeof *cases, &cases));
  cases->count = n > 0 ? n : 1;
  UM_CHECK(um_core_asprintf(context, &cases->scenario, "%s", model->scenario->name));
  UM_CHECK(um_core_allocate(context, cases->count, sizeof *cases->item, &cases->item));
  for (size_t i = 0; i < cases->count; i++) {
    um_core_log(context, UM_LOG_INFO, "case %zu of %zu: %s", i + 1, cases->count,
                n > 0 ? which[i].name : "nominal");
    UM_CHECK(case_make(context, model, evaluator, n > 0 ? &which[i] : NULL, &cases->item[i]));
  }
  *out = cases;
  cases = NULL;
done:
  um_variant_evaluator_destroy(context, &evaluator);
  um_model_destroy(context, &model);
  um_variant_cases_destroy(context, &cases);
  return status;
}

void um_variant_cases_destroy(struct um_context *context, struct um_variant_cases **cases)
{
  if (cases == NULL || *cases == NULL) return;
  for (size_t i = 0; (*cases)->item != NULL && i < (*cases)->count; i++) {
    struct um_variant_case *c = &(*cases)->item[i];
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
