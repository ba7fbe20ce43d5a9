/* All points of a study: each one solved, or by a surrogate. */
#include <string.h>

#include "base/batch/batch.h"
#include "base/core/digest.h"
#include "base/core/sort.h"
#include "model/geometry/precompute.h"
#include "study/study_impl.h"

/* --- identity -------------------------------------------------------------------------------- */

/* What of a study decides a point's values, beside the scenario: which number means what, what is
 * kept, and tolerances. How many points there are and where they lie does not: more of them may be
 * added to those on record. */
static enum um_status identify(struct um_context *context, struct um_study *study)
{
  uint64_t bindings = UM_CORE_DIGEST_BEGIN, outputs = UM_CORE_DIGEST_BEGIN;
  const double tolerance[] = {study->accuracy.tolerance.factor, study->accuracy.tolerance.periodic};
  for (size_t i = 0; i < study->nbinding; i++) {
    const struct um_study_binding *w = &study->binding[i];
    const char *const is[] = {w->file->key != NULL ? w->file->key : w->effect->name,
                              w->target != NULL ? w->target : ""};
    bindings = um_core_digest_texts(bindings, is, 2);
    bindings = um_core_digest(bindings, &w->which, sizeof w->which);
    bindings = um_core_digest(bindings, &w->of_record, sizeof w->of_record);
  }
  for (size_t q = 0; q < study->noutput; q++) {
    outputs = um_core_digest(outputs, &study->output[q].kind, sizeof study->output[q].kind);
    outputs = um_core_digest_texts(outputs, &study->output[q].of, 1);
  }
  UM_TRY(um_study_identity_add(context, study->identity, "the study's parameters", bindings));
  UM_TRY(um_study_identity_add(context, study->identity, "the study's outputs", outputs));
  return um_study_identity_add(context, study->identity,
                               "the tolerances of points (error of the study)",
                               um_core_digest(UM_CORE_DIGEST_BEGIN, tolerance, sizeof tolerance));
}

/* --- points by geometry ---------------------------------------------------------------------- */

struct place {
  const double *key; /* [nkey] values of the parameters that move the geometry */
  size_t nkey, point;
};

static int compare_places(const void *a, const void *b)
{
  const struct place *x = a, *y = b;
  for (size_t i = 0; i < x->nkey; i++)
    if (x->key[i] != y->key[i]) return x->key[i] < y->key[i] ? -1 : 1;
  return (x->point > y->point) - (x->point < y->point);
}

enum um_status um_study_solve(struct um_context *context, const struct um_study *study,
                              struct um_batch *batch, const double *parameter, size_t n,
                              double *value, char **reason)
{
  enum um_status status;
  size_t d = study->nbinding, nkey = 0;
  struct place *place = NULL;
  double *key = NULL, *sorted = NULL, *answer = NULL;
  char **why = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *place, &place));
  UM_CHECK(um_core_allocate(context, n * d, sizeof *key, &key));
  UM_CHECK(um_core_allocate(context, n * d, sizeof *sorted, &sorted));
  UM_CHECK(um_core_allocate(context, n * study->nvalue, sizeof *answer, &answer));
  UM_CHECK(um_core_allocate(context, n, sizeof *why, &why));
  for (size_t i = 0; i < n; i++) {
    nkey = 0;
    for (size_t j = 0; j < d; j++)
      if (study->moves_geometry[j]) key[i * d + nkey++] = parameter[i * d + j];
    place[i] = (struct place){key + i * d, nkey, i};
  }
  UM_CHECK(um_core_sort(context, place, n, sizeof *place, compare_places));
  for (size_t i = 0; i < n; i++)
    memcpy(sorted + i * d, parameter + place[i].point * d, d * sizeof *sorted);
  UM_CHECK(um_batch_run(context, batch, sorted, n, answer, why));
  for (size_t i = 0; i < n; i++) {
    memcpy(value + place[i].point * study->nvalue, answer + i * study->nvalue,
           study->nvalue * sizeof *value);
    reason[place[i].point] = why[i];
  }
done:
  UM_FREE(context, place, key, sorted, answer, (void *)why);
  return status;
}

/* --- the result ------------------------------------------------------------------------------ */

static enum um_status describe_quantities(struct um_context *context, const struct um_study *study,
                                          struct um_study_result *r)
{
  static const char *const kind[] = {"irradiance", "magnitude", "temperature"};
  static const char *const unit[] = {"W/m2", "mag", "K"};
  r->nquantity = study->noutput;
  UM_TRY(um_core_allocate(context, r->nquantity, sizeof *r->quantity, &r->quantity));
  UM_TRY(um_core_allocate(context, r->nquantity, sizeof(double), &r->error));
  for (size_t q = 0; q < r->nquantity; q++) {
    struct um_study_quantity *to = &r->quantity[q];
    const struct um_study_output *from = &study->output[q];
    UM_TRY(um_core_asprintf(context, &to->name, "%s:%s", kind[from->kind], from->of));
    UM_TRY(um_core_strdup(context, unit[from->kind], &to->unit));
    UM_TRY(um_core_strdup(context, from->of, &to->of));
    to->first = q * study->ntime;
    to->count = study->ntime;
    to->light = from->kind != UM_STUDY_TEMPERATURE;
    to->asked = study->curve[q].asked;
    r->error[q] = study->accuracy.error != NULL ? study->accuracy.error[q] : 0.0;
  }
  return UM_OK;
}

static enum um_status copy_distribution(struct um_context *context,
                                        const struct um_uncertainty_distribution *from,
                                        struct um_uncertainty_distribution *to)
{
  double *value = NULL;
  UM_TRY(um_core_allocate(context, from->nvalue, sizeof *value, &value));
  if (from->nvalue > 0) memcpy(value, from->value, from->nvalue * sizeof *value);
  *to = *from;
  to->value = value;
  return UM_OK;
}

static enum um_status describe(struct um_context *context, const struct um_study *study,
                               struct um_study_result *r)
{
  size_t n = study->nbinding;
  r->design = (enum um_study_design)study->file->design->kind;
  r->base = um_study_base(study);
  r->nparameter = n;
  r->nvalue = study->nvalue;
  UM_TRY(um_core_strdup(context, study->file->name, &r->name));
  UM_TRY(um_core_strdup(context, study->model->scenario->name, &r->scenario));
  UM_TRY(um_core_allocate(context, n, sizeof *r->parameter_name, &r->parameter_name));
  UM_TRY(um_core_allocate(context, n, sizeof *r->parameter_unit, &r->parameter_unit));
  UM_TRY(um_core_allocate(context, n, sizeof *r->distribution, &r->distribution));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &r->at_nominal));
  for (size_t i = 0; i < n; i++) {
    UM_TRY(um_core_strdup(context, study->binding[i].name, &r->parameter_name[i]));
    UM_TRY(um_core_strdup(context, study->binding[i].unit, &r->parameter_unit[i]));
    UM_TRY(copy_distribution(context, &study->binding[i].distribution, &r->distribution[i]));
    r->at_nominal[i] = study->binding[i].nominal;
  }
  UM_TRY(um_model_scenario_times(context, study->model, &r->time, &r->ntime));
  UM_TRY(um_core_allocate(context, r->ntime, sizeof(double), &r->sunlit));
  memcpy(r->sunlit, study->base.tables->sunlit, r->ntime * sizeof(double));
  UM_TRY(um_core_allocate(context, r->nvalue, sizeof(double), &r->nominal));
  memcpy(r->nominal, study->nominal, r->nvalue * sizeof(double));
  UM_TRY(describe_quantities(context, study, r));
  UM_TRY(um_study_limits_make(context, study, r));
  UM_TRY(um_study_points(context, study, &r->coordinate, &r->parameter, &r->npoint));
  r->wanted = r->npoint;
  UM_TRY(um_core_allocate(context, r->npoint, sizeof *r->reason, &r->reason));
  return um_core_allocate(context, r->npoint * r->nvalue, sizeof(double), &r->value);
}

static enum um_status lead(struct um_context *context, const struct um_study *study,
                           struct um_batch *batch, struct um_study_result *r)
{
  if (study->file->mode == UM_STUDY_SURROGATE) return um_study_stand_in(context, study, batch, r);
  r->exact = r->nsolved = r->npoint;
  return um_study_solve(context, study, batch, r->parameter, r->npoint, r->value, r->reason);
}

enum um_status um_study_run(struct um_context *context, struct um_study *study,
                            struct um_study_result **out)
{
  enum um_status status;
  struct um_study_result *result = NULL;
  struct um_batch *batch = NULL;
  struct um_batch_task task = study->options.batch;
  task.work.ncoordinate = study->nbinding;
  task.work.nvalue = study->nvalue;
  task.work.compute = um_study_point;
  task.accepts = um_study_accepts;
  task.work.user = study;
  *out = NULL;
  UM_CHECK(um_study_tolerance(context, study));
  UM_CHECK(identify(context, study));
  UM_CHECK(um_study_identity_open(context, study->identity, &task, &batch));
  if (!um_batch_leads(batch)) {
    status = um_batch_serve(context, batch);
    goto done;
  }
  UM_CHECK(um_core_allocate(context, 1, sizeof *result, &result));
  UM_CHECK(describe(context, study, result));
  UM_CHECK(lead(context, study, batch, result));
  study->lost = um_batch_lost(batch);
  um_batch_tell_lost(context, batch, result->parameter, result->npoint, "points.csv: point", 0);
  if (task.nshare <= 1) {
    *out = result;
    result = NULL;
  }
done:
  um_batch_close(context, &batch);
  um_study_result_destroy(context, &result);
  return status;
}

size_t um_study_lost(const struct um_study *study) { return study->lost; }
