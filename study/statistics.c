/* Statistics of a study, from its points and, where there is one, its surrogate. */
#include "study/statistics.h"

#include <math.h>

#include "base/uncertainty/indices.h"
#include "base/uncertainty/statistics.h"
#include "base/uncertainty/surrogate.h"

const double um_study_quantile[UM_STUDY_QUANTILES] = {0.05, 0.25, 0.5, 0.75, 0.95};

/* Below this many points ranks say nothing. */
#define RANKS_LEAST 8

#define QUIET    1e-3
#define ROUNDING 1e-6

static enum um_status reserve(struct um_context *context, const struct um_study_result *r,
                              double **out)
{
  return um_core_allocate(context, r->nparameter * r->nvalue, sizeof **out, out);
}

/* By how much an index of a surrogate may be off where it leaves lambda of its own standard
 * deviation unexplained: of roots of partial variances, over the root of the variance, one is off
 * by at most l (1 + root), l of the function's (study/stand_in.c). */
static double index_error(double index, double lambda)
{
  double root = sqrt(fmax(index, 0.0)), off = lambda / (1.0 - lambda) * (1.0 + root);
  return fmin(off * (2.0 * root + off), 1.0);
}

/* Whether a surrogate's indices of value k, of quantity q, are said. */
static bool is_borne(const struct um_study_result *r, size_t q, size_t k)
{
  if (k >= um_uncertainty_surrogate_values(r->surrogate) || r->quantity[q].withheld) return false;
  if (r->error != NULL && isnan(r->error[q])) return false;
  return r->unexplained == NULL || r->unexplained[k] <= UM_STUDY_BORNE;
}

/* The surrogate's values are the first of the result's; metrics that came later have no indices,
 * nor has what the surrogate does not bear. */
static enum um_status from_surrogate(struct um_context *context, const struct um_study_result *r,
                                     struct um_study_statistics *l)
{
  enum um_status status;
  double *index = NULL;
  size_t n = um_uncertainty_surrogate_values(r->surrogate);
  l->indices = UM_STUDY_INDICES_SURROGATE;
  UM_CHECK(reserve(context, r, &l->first));
  UM_CHECK(reserve(context, r, &l->total));
  if (r->unexplained != NULL) UM_CHECK(reserve(context, r, &l->first_error));
  UM_CHECK(um_core_allocate(context, r->nparameter, 2 * n * sizeof *index, &index));
  UM_CHECK(um_uncertainty_surrogate_moments(context, r->surrogate, r->distribution, NULL, NULL,
                                            index, index + r->nparameter * n));
  for (size_t q = 0; q < r->nquantity; q++)
    for (size_t k = r->quantity[q].first; k < r->quantity[q].first + r->quantity[q].count; k++)
      for (size_t i = 0; i < r->nparameter; i++) {
        size_t at = i * r->nvalue + k;
        bool has = is_borne(r, q, k);
        l->first[at] = has ? index[i * n + k] : NAN;
        l->total[at] = has ? index[(r->nparameter + i) * n + k] : NAN;
        if (l->first_error != NULL)
          l->first_error[at] = has ? index_error(l->first[at], r->unexplained[k]) : NAN;
      }
done:
  um_core_free(context, index);
  return status;
}

static enum um_status from_saltelli(struct um_context *context, const struct um_study_result *r,
                                    struct um_study_statistics *l)
{
  l->indices = UM_STUDY_INDICES_SAMPLED;
  UM_TRY(reserve(context, r, &l->first));
  UM_TRY(reserve(context, r, &l->first_error));
  UM_TRY(reserve(context, r, &l->total));
  struct um_uncertainty_sobol out = {
      .first = l->first, .first_error = l->first_error, .total = l->total};
  return um_uncertainty_sobol_indices(context, r->nparameter, r->base, r->nvalue, r->value, &out);
}

/* Squares as shares of their sum over the parameters. */
static void shares(const struct um_study_result *r, const double *from, double *out)
{
  for (size_t k = 0; k < r->nvalue; k++) {
    double sum = 0.0;
    for (size_t i = 0; i < r->nparameter; i++) {
      double x = from[i * r->nvalue + k];
      if (isfinite(x)) sum += x * x;
    }
    for (size_t i = 0; i < r->nparameter; i++) {
      double x = from[i * r->nvalue + k];
      out[i * r->nvalue + k] = sum > 0.0 ? (isfinite(x) ? x * x / sum : 0.0) : NAN;
    }
  }
}

static enum um_status from_morris(struct um_context *context, const struct um_study_result *r,
                                  struct um_study_statistics *l)
{
  l->indices = UM_STUDY_INDICES_MORRIS;
  UM_TRY(reserve(context, r, &l->first));
  UM_TRY(reserve(context, r, &l->effect));
  UM_TRY(reserve(context, r, &l->effect_sigma));
  struct um_uncertainty_morris out = {.mu_star = l->effect, .sigma = l->effect_sigma};
  UM_TRY(um_uncertainty_morris_effects(context, r->nparameter, r->base, r->nvalue, r->coordinate,
                                       r->value, &out));
  shares(r, l->effect, l->first);
  return UM_OK;
}

static enum um_status from_ranks(struct um_context *context, const struct um_study_result *r,
                                 struct um_study_statistics *l)
{
  l->indices = l->ndone < RANKS_LEAST ? UM_STUDY_INDICES_NONE : UM_STUDY_INDICES_RANKS;
  if (l->indices == UM_STUDY_INDICES_NONE) return UM_OK;
  UM_TRY(reserve(context, r, &l->first));
  for (size_t i = 0; i < r->nparameter * r->nvalue; i++)
    l->first[i] = l->correlation[i] * l->correlation[i];
  return UM_OK;
}

static void over_curves(const struct um_study_result *r, struct um_study_statistics *l)
{
  for (size_t i = 0; i < r->nparameter; i++)
    for (size_t q = 0; q < r->nquantity; q++) {
      const struct um_study_quantity *of = &r->quantity[q];
      double own = 0.0, all = 0.0;
      for (size_t k = of->first; k < of->first + of->count; k++) {
        double share = l->first[i * r->nvalue + k], v = l->deviation[k] * l->deviation[k];
        if (!isfinite(share) || !isfinite(v)) continue;
        own += share * v;
        all += v;
      }
      l->over_curve[i * r->nquantity + q] = all > 0.0 ? own / all : NAN;
    }
}

static enum um_status fill(struct um_context *context, const struct um_study_result *r,
                           const double *weight, struct um_study_statistics *l)
{
  for (size_t i = 0; i < r->npoint; i++) l->ndone += r->reason[i] == NULL;
  if (l->ndone < 2)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%zu of %zu points of the study succeeded: nothing is learnt from them",
                        l->ndone, r->npoint);
  UM_TRY(um_core_allocate(context, r->nvalue, UM_STUDY_QUANTILES * sizeof(double), &l->quantile));
  UM_TRY(um_core_allocate(context, r->nvalue, sizeof(double), &l->mean));
  UM_TRY(um_core_allocate(context, r->nvalue, sizeof(double), &l->deviation));
  UM_TRY(reserve(context, r, &l->correlation));
  UM_TRY(um_uncertainty_quantiles(context, r->npoint, r->nvalue, r->value, weight,
                                  UM_STUDY_QUANTILES, um_study_quantile, l->quantile));
  um_uncertainty_mean(r->npoint, r->nvalue, r->value, weight, l->mean, l->deviation);
  UM_TRY(um_uncertainty_rank_correlation(context, r->npoint, r->nparameter, r->parameter, r->nvalue,
                                         r->value, l->correlation));
  if (r->surrogate != NULL && r->distribution != NULL)
    UM_TRY(from_surrogate(context, r, l));
  else if (r->design == UM_STUDY_SALTELLI && r->base >= 2 * UM_UNCERTAINTY_BATCHES)
    UM_TRY(from_saltelli(context, r, l));
  else if (r->design == UM_STUDY_MORRIS && r->base >= 2)
    UM_TRY(from_morris(context, r, l));
  else
    UM_TRY(from_ranks(context, r, l));
  if (l->first == NULL) return UM_OK;
  UM_TRY(um_core_allocate(context, r->nparameter, r->nquantity * sizeof(double), &l->over_curve));
  over_curves(r, l);
  return UM_OK;
}

enum um_status um_study_statistics_create(struct um_context *context,
                                          const struct um_study_result *result,
                                          const double *weight, struct um_study_statistics **out)
{
  struct um_study_statistics *statistics = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *statistics, &statistics));
  enum um_status status = fill(context, result, weight, statistics);
  if (status == UM_OK)
    *out = statistics;
  else
    um_study_statistics_destroy(context, &statistics);
  return status;
}

void um_study_statistics_destroy(struct um_context *context,
                                 struct um_study_statistics **statistics)
{
  if (statistics == NULL || *statistics == NULL) return;
  struct um_study_statistics *l = *statistics;
  double *all[] = {l->quantile, l->mean,        l->deviation, l->first,        l->first_error,
                   l->total,    l->correlation, l->effect,    l->effect_sigma, l->over_curve};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) um_core_free(context, all[i]);
  um_core_free(context, l);
  *statistics = NULL;
}

double um_study_quiet(const struct um_study_statistics *statistics,
                      const struct um_study_quantity *quantity)
{
  double deviation = 0.0, value = 0.0;
  for (size_t k = quantity->first; k < quantity->first + quantity->count; k++) {
    deviation = fmax(deviation, statistics->deviation[k]); /* the number where one is NaN */
    value = fmax(value, fabs(statistics->mean[k]));
  }
  return fmax(QUIET * deviation, ROUNDING * value);
}

const char *um_study_indices_words(enum um_study_indices indices)
{
  switch (indices) {
  case UM_STUDY_INDICES_SURROGATE:
    return "from Sobol indices of first order, in closed form of the surrogate";
  case UM_STUDY_INDICES_SAMPLED:
    return "from sampled Sobol indices of first order";
  case UM_STUDY_INDICES_MORRIS:
    return "from squared elementary effects, as shares of their sum";
  case UM_STUDY_INDICES_RANKS:
    return "from squared rank correlations";
  case UM_STUDY_INDICES_NONE:
    break;
  }
  return "too few points to tell parameters apart";
}
