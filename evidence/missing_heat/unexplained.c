/* Looks for heat that explains a residual. Every place is tried with every course (look.c).
 * Bonferroni's correction counts every place and course as an independent test, which they are not:
 * "found" is said too rarely rather than too often. Significant heat that leaves more than a
 * twentieth of the excess in chi-square is not the explanation. */
#include "evidence/missing_heat/unexplained.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/distributions.h"
#include "evidence/missing_heat/look_impl.h"
#include "evidence/missing_heat/policy.h"
#include "evidence/missing_heat/residual.h"

/* --- the coordinate of the residual ---------------------------------------------------------- */

static enum um_status find_coordinate(struct um_context *context,
                                      const struct um_missing_heat_base *base, double fitted,
                                      struct um_missing_heat_unexplained *out)
{
  const struct um_compare_run run = {base->variant.model, base->forward->plan, base->variant.tables,
                                     base->result};
  struct um_missing_heat_residual residual;
  UM_TRY(um_missing_heat_residual_describe(context, base->forward, &run, fitted, &residual));
  out->channel = residual.channel;
  out->coordinate = residual.coordinate;
  out->p = residual.p;
  return UM_OK;
}

/* --- missing heat ---------------------------------------------------------------------------- */

/* Project the nuisances out of the residual; its chi-square after that. */
static enum um_status project(struct um_context *context, struct um_missing_heat_look *s,
                              const double *value, const double *nuisance, size_t nnuisance,
                              double *chi2)
{
  enum um_status status;
  const struct um_sensitivity_forward *f = s->base.forward;
  double *whole = NULL, *width = NULL;
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *whole, &whole));
  UM_CHECK(um_core_allocate(context, nnuisance, sizeof *width, &width));
  for (size_t j = 0; j < nnuisance; j++) width[j] = INFINITY;
  for (size_t j = 0; j < f->observations.count; j++)
    whole[j] = (f->observations.measured[j] - value[j]) / f->observations.sigma[j];
  struct um_inference_nuisance n = {nnuisance, nuisance, width};
  UM_CHECK(um_inference_projection_create(context, f->observations.count, &n, &s->projection));
  UM_CHECK(um_core_allocate(context, s->projection.nleft, sizeof *s->residual, &s->residual));
  um_inference_projection_apply(&s->projection, whole, s->residual);
  *chi2 = um_inference_dot(s->projection.nleft, s->residual, s->residual);
done:
  UM_FREE(context, whole, width);
  return status;
}

/* What an explanation is worth, with what its numbers cost. */
static double worth(const struct um_missing_heat *heat, double n)
{
  return heat->chi2_explained - (double)heat->nparameter * log(n);
}

/* By BIC, the best first. */
static void sort(struct um_missing_heat_unexplained *u, double n, size_t *origin)
{
  for (size_t i = 1; i < u->nheat; i++)
    for (size_t k = i; k > 0 && worth(&u->heat[k], n) > worth(&u->heat[k - 1], n); k--) {
      struct um_missing_heat heat = u->heat[k];
      size_t place = origin[k];
      u->heat[k] = u->heat[k - 1];
      origin[k] = origin[k - 1];
      u->heat[k - 1] = heat;
      origin[k - 1] = place;
    }
}

static enum um_status find_heat(struct um_context *context, struct um_missing_heat_look *s,
                                struct um_missing_heat_unexplained *out)
{
  enum um_status status = UM_OK;
  double n = (double)s->base.forward->observations.count;
  UM_TRY(um_missing_heat_look_begin(context, s));
  UM_TRY(um_core_allocate(context, s->nplace, sizeof *out->heat, &out->heat));
  UM_TRY(um_missing_heat_look_everywhere(context, s, out->heat, &out->nheat));
  sort(out, n, s->origin);
  um_core_quiet_begin(context);
  for (size_t i = 0; i < out->nheat && i < UM_MISSING_HEAT_REFINED && status == UM_OK; i++)
    if (out->heat[i].chi2_explained > UM_MISSING_HEAT_WORTHY * out->heat[0].chi2_explained)
      status = um_missing_heat_look_again(context, s, s->origin[i], &out->heat[i]);
  um_core_quiet_end(context);
  sort(out, n, s->origin);
  return status;
}

/* Whether the best heat is an explanation: significant, and little is left but noise. */
static bool is_found(const struct um_missing_heat_unexplained *u, double tried, double dof)
{
  if (u->nheat == 0) return false;
  double p = um_inference_chi2_q(u->heat[0].chi2_explained, 1.0);
  double left = fmax(UM_MISSING_HEAT_LEFT * (u->chi2_before - dof),
                     UM_MISSING_HEAT_SCATTER * sqrt(2.0 * dof));
  return p * tried < UM_MISSING_HEAT_LEVEL && u->chi2_after - dof < left;
}

enum um_status um_missing_heat_unexplained_create(struct um_context *context,
                                                  struct um_sensitivity_forward *forward,
                                                  const struct um_model_addition *addition,
                                                  size_t naddition, const double *value,
                                                  const double *nuisance, size_t nnuisance,
                                                  struct um_missing_heat_unexplained **out)
{
  enum um_status status;
  double begin = omp_get_wtime();
  struct um_missing_heat_unexplained *u = NULL;
  struct um_missing_heat_look s = {0};
  double tried = 0.0;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *u, &u));
  um_core_quiet_begin(context);
  status = um_missing_heat_base_create(context, forward, addition, naddition, &s.base);
  um_core_quiet_end(context);
  if (status != UM_OK) goto done;
  UM_CHECK(find_coordinate(context, &s.base, (double)nnuisance, u));
  UM_CHECK(project(context, &s, value, nuisance, nnuisance, &u->chi2_before));
  if (!s.base.variant.tables->points && s.base.variant.tables->nobs > 1)
    UM_CHECK(find_heat(context, &s, u));
  u->chi2_after = u->chi2_before - (u->nheat > 0 ? u->heat[0].chi2_explained : 0.0);
  for (size_t p = 0; p < u->nheat; p++) tried += (double)s.choice[p].tried;
  u->found = is_found(u, tried, (double)forward->observations.count - (double)nnuisance);
  *out = u;
  u = NULL;
done:
  forward->seconds += omp_get_wtime() - begin;
  um_missing_heat_look_release(context, &s);
  um_missing_heat_unexplained_destroy(context, &u);
  return status;
}

void um_missing_heat_unexplained_destroy(struct um_context *context,
                                         struct um_missing_heat_unexplained **unexplained)
{
  if (unexplained == NULL || *unexplained == NULL) return;
  struct um_missing_heat_unexplained *u = *unexplained;
  for (size_t i = 0; i < u->nheat; i++) {
    UM_FREE(context, u->heat[i].place, u->heat[i].t, u->heat[i].heat, u->heat[i].sigma,
            u->heat[i].low, u->heat[i].high);
  }
  UM_FREE(context, u->heat, u->coordinate, u->channel, u);
  *unexplained = NULL;
}
