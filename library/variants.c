/* A model, changed: the evaluator of variant/ behind the public header. */
#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "library/run_impl.h"
#include "library/scenario_impl.h"
#include "library/variants_impl.h"
#include "model/build/effect_files.h"

#define LIGHT       1e-3 /* asked error, unless it is said [1] */
#define TEMPERATURE 0.1  /* [K] */

struct umbra_variants *um_library_variants_share(struct umbra_variants *variants)
{
  atomic_fetch_add(&variants->users, 1);
  return variants;
}

void um_library_variants_drop(struct umbra_variants **variants)
{
  if (variants == NULL || *variants == NULL) return;
  struct umbra_variants *v = *variants;
  *variants = NULL;
  if (atomic_fetch_sub(&v->users, 1) != 1) return;
  struct umbra *session = v->session;
  um_variant_evaluator_destroy(session->context, &v->evaluator);
  um_library_model_drop(&v->model);
  um_core_free(session->context, v);
  um_library_session_drop(&session);
}

void umbra_variants_close(struct umbra_variants **variants) { um_library_variants_drop(variants); }

static enum um_status take_settings(struct um_context *context,
                                    const struct umbra_variants_settings *given,
                                    struct um_variant_settings *settings,
                                    struct um_variant_heat *heat)
{
  struct umbra_variants_settings s = UMBRA_VARIANTS_SETTINGS;
  if (given != NULL) {
    UM_TRY(um_library_check_size(context, "struct umbra_variants_settings", given->size, sizeof s));
    s = *given;
  }
  if (!(s.temperature_K >= 0.0 && s.temperature_K <= 10.0))
    return um_core_fail(context, UM_ERR_INPUT, "temperature_K %g; accepted: 0 to 10 K",
                        s.temperature_K);
  if (!(s.light >= 0.0 && s.light <= 1.0))
    return um_core_fail(context, UM_ERR_INPUT, "light %g; accepted: 0 to 1", s.light);
  double light = s.light > 0.0 ? s.light : LIGHT;
  const struct um_variant_error asked = {light, light,
                                         s.temperature_K > 0.0 ? s.temperature_K : TEMPERATURE};
  *settings =
      (struct um_variant_settings){.base = UM_VARIANT_TIGHT, .photons = true, .bytes = s.memory};
  heat->start = s.exact != 0 ? UM_VARIANT_COLD : UM_VARIANT_WARM;
  heat->tolerance = um_variant_tolerance_asked(&asked, NULL);
  return UM_OK;
}

enum umbra_status umbra_variants_open(struct umbra *umbra, struct umbra_model *model,
                                      const struct umbra_variants_settings *settings,
                                      struct umbra_variants **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_variant_settings taken;
  struct umbra_variants *v = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *v, &v));
  atomic_init(&v->users, 1);
  v->session = um_library_session_share(umbra);
  v->model = um_library_model_share(model);
  UM_CHECK(take_settings(context, settings, &taken, &v->heat));
  UM_CHECK(um_variant_evaluator_create(context, model->model, &taken, &v->evaluator));
  *out = v;
  v = NULL;
done:
  um_library_variants_drop(&v);
  return um_library_status(status);
}

/* --- changes --------------------------------------------------------------------------------- */

void um_library_changes_clear(struct um_context *context, struct um_library_changes *c)
{
  for (size_t i = 0; i < c->all.nwithout; i++) um_core_free(context, c->off[i]);
  UM_FREE(context, c->off, c->key, c->addition);
}

/* What the model has of the effect's parameters, or their defaults, then what is said. */
static void addition_of(const struct um_model *model, const char *target,
                        const struct um_library_effect_numbers *from, struct um_model_addition *to)
{
  to->effect = from->effect;
  to->target = target;
  for (size_t p = 0; p < to->effect->nparameter; p++)
    to->value[p] = to->effect->parameters[p].default_value;
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    if (e->effect == to->effect && um_core_words_same(e->target, to->target))
      memcpy(to->value, e->value, to->effect->nparameter * sizeof *to->value);
  }
  for (size_t p = 0; p < to->effect->nparameter; p++)
    if (from->said[p]) to->value[p] = from->value[p];
}

static enum um_status take_effect(struct um_context *context, const struct um_model *model,
                                  const struct umbra_effect_change *from,
                                  struct um_library_changes *to)
{
  struct um_library_effect_numbers numbers;
  UM_TRY(um_library_read_effect_change(context, model->registry, from, &numbers));
  if (from->off == 0) {
    addition_of(model, from->target, &numbers, &to->addition[to->all.naddition++]);
    return UM_OK;
  }
  UM_TRY(um_core_asprintf(context, &to->off[to->all.nwithout], "%s%s%s", from->effect,
                          from->target != NULL ? ":" : "",
                          from->target != NULL ? from->target : ""));
  to->all.nwithout++;
  return UM_OK;
}

enum um_status um_library_changes_take(struct um_context *context, const struct um_model *model,
                                       const struct umbra_change *change, size_t n,
                                       struct um_library_changes *to)
{
  UM_TRY(um_core_allocate(context, n, sizeof *to->key, &to->key));
  UM_TRY(um_core_allocate(context, n, sizeof *to->addition, &to->addition));
  UM_TRY(um_core_allocate(context, n, sizeof *to->off, &to->off));
  to->all.key = to->key;
  to->all.addition = to->addition;
  to->all.without = (const char *const *)to->off;
  for (size_t i = 0; i < n; i++) {
    const struct umbra_change *c = &change[i];
    UM_TRY(um_library_check_change(context, c, i));
    if (c->effect != NULL)
      UM_TRY(take_effect(context, model, c->effect, to));
    else
      UM_TRY(um_library_take_key(context, c->key, c->number, c->text, &to->key[to->all.nkey++]));
  }
  return UM_OK;
}

/* --- runs ------------------------------------------------------------------------------------ */

struct run {
  struct umbra_variants *variants; /* shared */
  struct um_variant variant;       /* open */
  struct um_model_result *result;
};

static void run_release(struct um_context *context, void *work)
{
  struct run *run = work;
  um_model_result_destroy(context, &run->result);
  um_variant_close(context, &run->variant);
  um_library_variants_drop(&run->variants);
  um_core_free(context, run);
}

static enum um_status run_write(struct um_context *context, const struct umbra_result *result,
                                const struct umbra_write *write, struct um_core_folder *folder)
{
  (void)result, (void)write, (void)folder;
  return um_core_fail(context, UM_ERR_INPUT,
                      "a variant is not written; accepted: a run of the scenario with its changes");
}

static const struct um_model *run_model(const void *work)
{
  return ((const struct run *)work)->variant.model;
}

static const struct um_library_kind kind = {run_write, run_release, run_model};

enum umbra_status umbra_variant_run(struct umbra *umbra, struct umbra_variants *variants,
                                    const struct umbra_change *change, size_t nchange,
                                    struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_result *result = NULL;
  struct run *run = NULL;
  struct um_library_changes changes = {0};
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *run, &run));
  run->variants = um_library_variants_share(variants);
  struct um_variant *v = &run->variant;
  UM_CHECK(um_library_changes_take(context, variants->model->model, change, nchange, &changes));
  UM_CHECK(um_variant_open(context, variants->evaluator, &changes.all, &variants->heat, v));
  UM_CHECK(um_variant_observe(context, variants->evaluator, v, &run->result));
  UM_CHECK(um_library_result_create(context, umbra, &kind, run, &result));
  const struct run *of = result->work;
  run = NULL;
  UM_CHECK(
      um_library_run_arrays(context, of->variant.model, of->variant.tables, of->result, result));
  *out = result;
done:
  um_library_changes_clear(context, &changes);
  if (run != NULL) run_release(context, run);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status == UM_ERR_REFUSED ? UM_ERR_INPUT : status);
}
