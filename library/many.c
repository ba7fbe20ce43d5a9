/* Many variants of a model as one result. */
#include "variant/many.h"

#include <math.h>
#include <string.h>

#include "library/run_impl.h"
#include "library/variants_impl.h"

static const char *const usual[] = {"irradiance"};

struct many {
  struct umbra_variants *variants; /* shared */
  char **refusal;                  /* [nset] owned; NULL: computed */
  size_t nset;
};

static void many_release(struct um_context *context, void *work)
{
  struct many *many = work;
  for (size_t i = 0; many->refusal != NULL && i < many->nset; i++)
    um_core_free(context, many->refusal[i]);
  um_core_free(context, many->refusal);
  um_library_variants_drop(&many->variants);
  um_core_free(context, many);
}

static enum um_status many_write(struct um_context *context, const struct umbra_result *result,
                                 const struct umbra_write *write, struct um_core_folder *folder)
{
  (void)result, (void)write, (void)folder;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "variants are not written; accepted: runs of the scenario with their changes");
}

static const struct um_model *many_model(const void *work)
{
  return ((const struct many *)work)->variants->model->model;
}

static const struct um_library_kind kind = {many_write, many_release, many_model};

const char *umbra_result_refusal(const struct umbra_result *result, size_t set)
{
  if (result->kind != &kind) return NULL;
  const struct many *many = result->work;
  return set < many->nset ? many->refusal[set] : NULL;
}

/* --- arrays of a variant --------------------------------------------------------------------- */

struct job {
  struct umbra_many how;
  struct umbra_result *result; /* its arrays, once a set is computed, are those asked for */
  struct many *many;
  double *value; /* [numbers] of the first set that is computed */
  size_t from;   /* set of task 0 */
  bool wrong;    /* what was asked for does not exist */
};

/* Numbers of one set. */
static size_t count_of(const struct umbra_array *array)
{
  size_t n = 1;
  for (size_t i = 1; i < array->dimensions; i++) n *= array->shape[i];
  return n;
}

static void shown_release(struct um_context *context, struct umbra_result *shown)
{
  for (size_t i = 0; i < shown->nowned; i++) um_core_free(context, shown->owned[i]);
  um_core_free(context, shown->owned);
  um_core_free(context, shown->array);
}

/* An array of the result like one of a run, behind the sets. */
static enum um_status make_like(struct um_context *context, const struct job *job,
                                const struct umbra_array *of)
{
  double *data;
  struct umbra_array a = {.shape = {job->many->nset}, .axis = {"set"}};
  for (size_t i = 0; i < of->dimensions; i++) {
    a.shape[i + 1] = of->shape[i];
    a.axis[i + 1] = of->axis[i];
  }
  UM_TRY(um_library_result_make(context, job->result, a, of->name, of->unit, &data));
  size_t n = job->many->nset * count_of(&job->result->array[job->result->narray - 1]);
  for (size_t i = 0; i < n; i++) data[i] = NAN;
  return UM_OK;
}

static enum um_status make_arrays(struct um_context *context, struct job *job,
                                  const struct umbra_result *shown)
{
  job->wrong = true;
  for (size_t i = 0; i < job->how.narray; i++) {
    const struct umbra_array *of = umbra_result_array(shown, job->how.array[i]);
    if (of == NULL || of->dimensions > 3)
      return um_core_fail(context, UM_ERR_INPUT,
                          "array '%.80s'; accepted: of three dimensions at most, that the run has",
                          job->how.array[i]);
    UM_TRY(make_like(context, job, of));
  }
  job->wrong = false;
  return UM_OK;
}

/* Numbers of a variant, array after array. */
static enum um_status copy(struct um_context *context, const struct job *job,
                           const struct umbra_result *shown, double *value)
{
  for (size_t i = 0; i < job->result->narray; i++) {
    const struct umbra_array *a = &job->result->array[i];
    const struct umbra_array *of = umbra_result_array(shown, a->name);
    bool same = of != NULL && of->dimensions + 1 == a->dimensions;
    for (size_t k = 0; same && k < of->dimensions; k++) same = of->shape[k] == a->shape[k + 1];
    if (!same)
      return um_core_fail(context, UM_ERR_REFUSED,
                          "its array '%s' is not as large as that of the sets before", a->name);
    memcpy(value, of->data, count_of(a) * sizeof *value);
    value += count_of(a);
  }
  return UM_OK;
}

static size_t numbers(const struct umbra_result *result)
{
  size_t n = 0;
  for (size_t i = 0; i < result->narray; i++) n += count_of(&result->array[i]);
  return n;
}

/* In a worker. */
static enum um_status take(struct um_context *context, void *user, size_t which,
                           const struct um_variant *variant, const struct um_model_result *run,
                           double *value)
{
  (void)which;
  struct umbra_result shown = {.narray = 0};
  enum um_status status =
      um_library_run_arrays(context, variant->model, variant->tables, run, &shown);
  if (status == UM_OK) status = copy(context, user, &shown, value);
  shown_release(context, &shown);
  return status;
}

/* The same in this process, of the set that says how large arrays are. */
static enum um_status take_first(struct um_context *context, void *user, size_t which,
                                 const struct um_variant *variant,
                                 const struct um_model_result *run, double *value)
{
  (void)which, (void)value;
  enum um_status status;
  struct job *job = user;
  struct umbra_result shown = {.narray = 0};
  UM_CHECK(um_library_run_arrays(context, variant->model, variant->tables, run, &shown));
  UM_CHECK(make_arrays(context, job, &shown));
  UM_CHECK(um_core_allocate(context, numbers(job->result), sizeof *job->value, &job->value));
  UM_CHECK(copy(context, job, &shown, job->value));
done:
  shown_release(context, &shown);
  return status;
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  const struct job *job = user;
  size_t set = job->from + which;
  bool refused = status == UM_ERR_REFUSED || status == UM_ERR_INPUT || status == UM_ERR_NUMERIC;
  if (refused && !job->wrong) {
    UM_TRY(um_core_strdup(context, um_core_message(context), &job->many->refusal[set]));
    um_core_message_clear(context);
    return UM_OK;
  }
  UM_TRY(status);
  for (size_t i = 0; i < job->result->narray; i++) {
    size_t n = count_of(&job->result->array[i]);
    memcpy(job->result->owned[i] + set * n, value, n * sizeof *value);
    value += n;
  }
  return UM_OK;
}

static enum um_status done_first(struct um_context *context, void *user, size_t which,
                                 enum um_status status, const double *value)
{
  (void)value;
  const struct job *job = user;
  return done(context, user, which, status, job->value);
}

/* The first set that is computed, here, then the others. */
static enum um_status evaluate(struct um_context *context, struct umbra_variants *variants,
                               const struct um_model_changes *changes, struct job *job)
{
  size_t n = job->many->nset;
  struct um_variant_each each = {
      .n = 1, .heat = &variants->heat, .take = take_first, .done = done_first, .user = job};
  for (; job->from < n && job->value == NULL; job->from++) {
    each.changes = &changes[job->from];
    UM_TRY(um_variant_each(context, variants->evaluator, &each));
  }
  if (job->value == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "no set is computed; the last: %.400s",
                        n > 0 ? job->many->refusal[n - 1] : "there is none");
  each.n = n - job->from;
  each.changes = changes + job->from;
  each.nvalue = numbers(job->result);
  each.take = take;
  each.done = done;
  each.workers = job->how.workers > 0 ? job->how.workers : um_core_context_threads(context);
  return um_variant_each(context, variants->evaluator, &each);
}

static enum um_status take_sets(struct um_context *context, const struct um_model *model,
                                const struct umbra_changes *set, size_t nset,
                                struct um_library_changes *taken, struct um_model_changes *changes)
{
  for (size_t i = 0; i < nset; i++) {
    enum um_status status =
        um_library_changes_take(context, model, set[i].change, set[i].nchange, &taken[i]);
    if (status != UM_OK) um_core_message_prefix(context, "set %zu", i + 1);
    UM_TRY(status);
    changes[i] = taken[i].all;
  }
  return UM_OK;
}

static enum um_status begin(struct um_context *context, struct umbra *umbra,
                            struct umbra_variants *variants, size_t nset,
                            const struct umbra_many *how, struct job *job)
{
  struct many *many = NULL;
  enum um_status status;
  job->how = (struct umbra_many)UMBRA_MANY;
  if (how != NULL) {
    UM_TRY(um_library_check_size(context, "struct umbra_many", how->size, sizeof *how));
    job->how = *how;
  }
  if (job->how.narray == 0) job->how.narray = 1, job->how.array = usual;
  UM_CHECK(um_core_allocate(context, 1, sizeof *many, &many));
  many->variants = um_library_variants_share(variants);
  many->nset = nset;
  UM_CHECK(um_core_allocate(context, nset, sizeof *many->refusal, &many->refusal));
  UM_CHECK(um_library_result_create(context, umbra, &kind, many, &job->result));
  job->many = many;
  many = NULL;
done:
  if (many != NULL) many_release(context, many);
  return status;
}

enum umbra_status umbra_evaluate_many(struct umbra *umbra, struct umbra_variants *variants,
                                      const struct umbra_changes *set, size_t nset,
                                      const struct umbra_many *many, struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_library_changes *taken = NULL;
  struct um_model_changes *changes = NULL;
  struct job job = {.from = 0};
  enum um_status status;
  *out = NULL;
  UM_CHECK(begin(context, umbra, variants, nset, many, &job));
  UM_CHECK(um_core_allocate(context, nset, sizeof *taken, &taken));
  UM_CHECK(um_core_allocate(context, nset, sizeof *changes, &changes));
  UM_CHECK(take_sets(context, variants->model->model, set, nset, taken, changes));
  um_core_progress_begin(context, "computing variants", nset);
  status = evaluate(context, variants, changes, &job);
  um_core_progress_end(context);
  UM_CHECK(status);
  *out = job.result;
done:
  for (size_t i = 0; taken != NULL && i < nset; i++) um_library_changes_clear(context, &taken[i]);
  um_core_free(context, taken);
  um_core_free(context, changes);
  um_core_free(context, job.value);
  if (status != UM_OK) umbra_result_close(&job.result);
  return um_library_status(status);
}
