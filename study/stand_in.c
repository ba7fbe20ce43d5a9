/* The surrogate of a study, and points that are solved where it does not do.
 *
 * Some points of the design itself, in the order of um_study_order, state the surrogate's error
 * (base/uncertainty/stated.h): they are a sample of all that it is asked. Where it falls short they
 * also say what it is worth. Let f be a quantity, s the surrogate's and lambda = |f - s| / sigma_f
 * in the norm of the points (root of the mean square): no standard deviation, mean or root of a
 * partial variance is off by more than lambda sigma_f, since each is a projection of f. A quantity
 * with lambda above UM_STUDY_BORNE is withheld from the surrogate: what the study says of it then
 * rests on its solved points alone. */
#include <math.h>
#include <string.h>

#include "base/uncertainty/stated.h"
#include "base/uncertainty/statistics.h"
#include "base/uncertainty/surrogate.h"
#include "study/stand_in_impl.h"

#define SURE 0.05 /* probability that lambda is more than is said */

/* Values of the surrogate at all points. */
static enum um_status look_up(struct um_context *context, const struct um_study *study,
                              struct um_study_result *r)
{
  enum um_status status;
  size_t d = study->nbinding;
  double *place = NULL;
  UM_CHECK(um_core_allocate(context, r->npoint * d, sizeof *place, &place));
  for (size_t i = 0; i < r->npoint * d; i++)
    place[i] =
        um_uncertainty_distribution_place(&study->binding[i % d].distribution, r->parameter[i]);
  UM_CHECK(um_uncertainty_surrogate_at(context, r->surrogate, place, r->npoint, r->value));
  for (size_t i = 0; i < r->npoint * r->nvalue; i++)
    if (isnan(study->nominal[i % r->nvalue])) r->value[i] = NAN;
done:
  um_core_free(context, place);
  return status;
}

/* --- what it is worth ------------------------------------------------------------------------ */

/* lambda of each value and quantity, by the last n of the solved points, own [taken][nvalue]. */
static enum um_status find_unexplained(struct um_context *context, const struct stand_in *s,
                                       const double *own, size_t n)
{
  enum um_status status;
  struct um_study_result *r = s->r;
  double *deviation = NULL, factor = um_uncertainty_rms_factor(n, SURE);
  UM_CHECK(um_core_allocate(context, r->nvalue, sizeof(double), &r->unexplained));
  UM_CHECK(um_core_allocate(context, r->nvalue, sizeof *deviation, &deviation));
  um_uncertainty_mean(r->npoint, r->nvalue, r->value, NULL, NULL, deviation);
  for (size_t q = 0; q < r->nquantity; q++) {
    double all_left = 0.0, all = 0.0;
    for (size_t k = r->quantity[q].first; k < r->quantity[q].first + r->quantity[q].count; k++) {
      double left = 0.0;
      for (size_t i = s->taken - n; i < s->taken; i++)
        left += pow(own[i * r->nvalue + k] - r->value[s->order[i] * r->nvalue + k], 2.0);
      left = factor * sqrt(left / (double)n);
      r->unexplained[k] = left > 0.0 ? left / deviation[k] : left; /* NaN stays */
      if (isnan(left)) continue;
      all_left += left * left;
      all += deviation[k] * deviation[k];
    }
    r->quantity[q].unexplained = all_left > 0.0 ? sqrt(all_left / all) : 0.0;
  }
done:
  um_core_free(context, deviation);
  return status;
}

/* Only the solved points stay. */
static void keep_solved(struct um_context *context, const bool *solved, struct um_study_result *r)
{
  size_t d = r->nparameter, n = 0;
  for (size_t i = 0; i < r->npoint; i++) {
    if (!solved[i]) continue;
    memmove(r->coordinate + n * d, r->coordinate + i * d, d * sizeof(double));
    memmove(r->parameter + n * d, r->parameter + i * d, d * sizeof(double));
    memmove(r->value + n * r->nvalue, r->value + i * r->nvalue, r->nvalue * sizeof(double));
    r->reason[n++] = r->reason[i];
  }
  r->npoint = n;
  r->base = 0; /* its indices want the whole design */
  um_uncertainty_surrogate_destroy(context, &r->surrogate);
}

/* Quantities that the surrogate does not bear stay with the solved points alone; true: all. */
static bool withhold(struct um_study_result *r, const bool *solved)
{
  bool all = true;
  for (size_t q = 0; q < r->nquantity; q++) {
    struct um_study_quantity *of = &r->quantity[q];
    of->withheld = !(of->unexplained <= UM_STUDY_BORNE);
    all = all && of->withheld;
    for (size_t i = 0; i < r->npoint && of->withheld; i++)
      for (size_t k = of->first; k < of->first + of->count && !solved[i]; k++)
        r->value[i * r->nvalue + k] = NAN;
  }
  return all;
}

/* The first n points of the order are solved, n above those that are already: these are taken from
 * the records. own [n][nvalue]. */
static enum um_status solve_first(struct um_context *context, const struct stand_in *s, size_t n,
                                  double *own, bool *solved)
{
  struct um_study_result *r = s->r;
  char **reason = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *reason, &reason));
  enum um_status status = um_study_solve(context, s->study, s->batch, s->parameter, n, own, reason);
  for (size_t i = 0; i < n && status == UM_OK; i++) {
    r->reason[s->order[i]] = reason[i];
    solved[s->order[i]] = true;
  }
  um_core_free(context, (void *)reason);
  return status;
}

static void put_own(const struct stand_in *s, const double *own, size_t n)
{
  size_t nvalue = s->r->nvalue;
  for (size_t i = 0; i < n; i++)
    memcpy(s->r->value + s->order[i] * nvalue, own + i * nvalue, nvalue * sizeof *own);
  s->r->nsolved = n;
}

/* --- the result ------------------------------------------------------------------------------ */

/* By the surrogate as far as it goes. */
static enum um_status finish(struct um_context *context, struct stand_in *s, double *own,
                             bool *solved)
{
  struct um_study_result *r = s->r;
  const char *why = um_uncertainty_surrogate_short(r->surrogate);
  const struct um_uncertainty_surrogate_error *error =
      um_uncertainty_surrogate_errors(r->surrogate);
  size_t n = um_uncertainty_surrogate_stating(r->surrogate);
  bool all = false;
  UM_TRY(look_up(context, s->study, r));
  UM_TRY(solve_first(context, s, s->taken, own, solved));
  UM_TRY(find_unexplained(context, s, own, n < s->taken ? n : s->taken));
  put_own(s, own, s->taken);
  if (why != NULL) {
    UM_TRY(um_core_strdup(context, why, &r->falls_short));
    all = withhold(r, solved);
  }
  for (size_t q = 0; q < r->nquantity; q++)
    if (!r->quantity[q].withheld) r->error[q] += error[q].stated * um_study_left(r, q);
  if (all) keep_solved(context, solved, r);
  return UM_OK;
}

/* There is no surrogate, since one of its points failed: the message says so. As many points of the
 * design as are still allowed, or a share of all that are. */
static enum um_status without(struct um_context *context, struct stand_in *s, double *own,
                              bool *solved)
{
  struct um_study_result *r = s->r;
  size_t allowed = (size_t)s->study->file->evaluations;
  size_t n = s->taken + (allowed > s->solved ? allowed - s->solved : 0);
  size_t least = (size_t)ceil(UM_UNCERTAINTY_STATED_RESERVE * (double)allowed);
  UM_TRY(um_core_strdup(context, um_core_message(context), &r->falls_short));
  um_core_message_clear(context);
  if (n < least) n = least;
  if (n > r->npoint) n = r->npoint;
  if (n > s->taken) s->solved += n - s->taken;
  UM_TRY(solve_first(context, s, n, own, solved));
  put_own(s, own, n);
  keep_solved(context, solved, r);
  return UM_OK;
}

static enum um_status prepare(struct um_context *context, struct stand_in *s)
{
  const struct um_study_result *r = s->r;
  size_t d = s->study->nbinding;
  UM_TRY(um_core_allocate(context, r->npoint, sizeof *s->order, &s->order));
  UM_TRY(um_core_allocate(context, r->npoint * d, sizeof *s->parameter, &s->parameter));
  UM_TRY(um_core_allocate(context, r->npoint * d, sizeof *s->place, &s->place));
  UM_TRY(um_study_order(context, s->study, r->npoint, s->order));
  for (size_t i = 0; i < r->npoint * d; i++) {
    s->parameter[i] = r->parameter[s->order[i / d] * d + i % d];
    s->place[i] =
        um_uncertainty_distribution_place(&s->study->binding[i % d].distribution, s->parameter[i]);
  }
  return UM_OK;
}

enum um_status um_study_stand_in(struct um_context *context, const struct um_study *study,
                                 struct um_batch *batch, struct um_study_result *result)
{
  enum um_status status;
  struct stand_in s = {.study = study, .batch = batch, .r = result};
  bool *solved = NULL, share = study->options.batch.nshare > 1;
  double *own = NULL;
  size_t most = (size_t)study->file->evaluations;
  if (result->npoint < most) most = result->npoint;
  UM_CHECK(prepare(context, &s));
  UM_CHECK(um_core_allocate(context, result->npoint, sizeof *solved, &solved));
  UM_CHECK(um_core_allocate(context, most, study->nvalue * sizeof *own, &own));
  status = um_study_grow(context, &s);
  if (status == UM_ERR_REFUSED && !share)
    status = without(context, &s, own, solved);
  else if (status == UM_OK)
    status = finish(context, &s, own, solved);
  result->exact = s.solved;
done:
  UM_FREE(context, s.order, s.parameter, s.place, solved, own);
  return status;
}
