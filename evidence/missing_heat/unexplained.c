/* Looks for heat that explains a residual. Every place is tried with every pulse between two edges
 * of at most UM_MISSING_HEAT_BINS_MAX bins. Where observations are denser, the best places are
 * tried again with all times near the edges found. Bonferroni's correction counts every place and
 * pair of edges as an independent test, which they are not: "found" is said too rarely rather than
 * too often. A significant pulse that leaves more than a twentieth of the excess in chi-square is
 * not the explanation. */
#include "evidence/missing_heat/unexplained.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/distributions.h"
#include "evidence/missing_heat/change_impl.h"
#include "evidence/missing_heat/history_impl.h"
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

struct search {
  struct um_missing_heat_base base;
  struct um_missing_heat_place *place;
  size_t nplace;
  struct um_inference_projection projection;
  double *residual; /* [nleft] */
  double *column;   /* [UM_MISSING_HEAT_TOGETHER][nbin][nobservation] */
  size_t nobs;
  double *t;                           /* [nobs] at the satellite */
  size_t *edge;                        /* [nbin + 1] of the observations */
  size_t nbin;                         /* of the first search */
  double *time;                        /* [nobs] scratch of edges */
  bool *wanted;                        /* [nobs] scratch */
  size_t *origin;                      /* [heat] place of each result */
  struct um_missing_heat_pulse *pulse; /* [heat] of the first look */
};

static void search_release(struct um_context *context, struct search *s)
{
  um_missing_heat_base_release(context, &s->base);
  um_missing_heat_places_destroy(context, &s->place, s->nplace);
  um_inference_projection_destroy(context, &s->projection);
  UM_FREE(context, s->residual, s->column, s->t, s->edge, s->time, s->wanted, s->origin, s->pulse);
}

/* Project the nuisances out of the residual; its chi-square after that. */
static enum um_status project(struct um_context *context, struct search *s, const double *value,
                              const double *nuisance, size_t nnuisance, double *chi2)
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

/* Times of the observations at the satellite, and the edges of the first search. */
static enum um_status find_edges(struct um_context *context, struct search *s)
{
  const struct um_model_tables *tables = s->base.variant.tables;
  size_t n = s->nobs = tables->nobs;
  s->nbin = n - 1 < UM_MISSING_HEAT_BINS_MAX ? n - 1 : UM_MISSING_HEAT_BINS_MAX;
  UM_TRY(um_core_allocate(context, n, sizeof *s->t, &s->t));
  UM_TRY(um_core_allocate(context, n, sizeof *s->time, &s->time));
  UM_TRY(um_core_allocate(context, n, sizeof *s->wanted, &s->wanted));
  UM_TRY(um_core_allocate(context, s->nbin + 1, sizeof *s->edge, &s->edge));
  UM_TRY(um_core_allocate(context, s->nplace, sizeof *s->origin, &s->origin));
  UM_TRY(um_core_allocate(context, s->nplace, sizeof *s->pulse, &s->pulse));
  for (size_t k = 0; k < n; k++)
    s->t[k] = tables->sample[k * tables->nsub + tables->nsub / 2].t_tai;
  for (size_t b = 0; b <= s->nbin; b++) s->edge[b] = (b * (n - 1) + s->nbin / 2) / s->nbin;
  return UM_OK;
}

/* Columns of `count` places from `first` on. */
static enum um_status columns_make(struct um_context *context, struct search *s, size_t first,
                                   size_t count, size_t nbin, const double *edge)
{
  UM_TRY(um_core_reallocate(context, count * nbin * s->base.forward->observations.count,
                            sizeof *s->column, &s->column));
  return um_missing_heat_columns(context, &s->base, &s->place[first], count, nbin, edge, s->column);
}

/* Bins of place number `at` of those. */
static enum um_status bins_make(struct um_context *context, struct search *s, size_t at,
                                size_t nbin, const double *edge, struct um_missing_heat_bins *out)
{
  const double *column = s->column + at * nbin * s->base.forward->observations.count;
  return um_missing_heat_bins_create(context, &s->projection, s->residual, nbin, edge, column, out);
}

static void take_pulse(const struct um_missing_heat_bins *bins,
                       const struct um_missing_heat_pulse *pulse, struct um_missing_heat *heat)
{
  heat->chi2_explained = pulse->chi2;
  heat->start = bins->edge[pulse->from];
  heat->stop = bins->edge[pulse->to];
  heat->power = pulse->power;
  heat->energy = pulse->power * (heat->stop - heat->start);
  heat->start_sigma = pulse->start_sigma;
  heat->energy_sigma = pulse->energy_sigma;
}

/* Best pulse and history of a place, on the bins of the first search, whose columns are made. */
static enum um_status look(struct um_context *context, struct search *s, size_t place,
                           struct um_missing_heat *heat)
{
  enum um_status status;
  struct um_missing_heat_bins bins = {0};
  s->origin[place] = place;
  UM_CHECK(um_core_strdup(context, s->place[place].name, &heat->place));
  UM_CHECK(bins_make(context, s, place % UM_MISSING_HEAT_TOGETHER, s->nbin, s->time, &bins));
  um_missing_heat_pulse_find(&bins, &s->pulse[place]);
  take_pulse(&bins, &s->pulse[place], heat);
  heat->nbin = s->nbin;
  UM_CHECK(um_core_allocate(context, s->nbin + 1, sizeof *heat->t, &heat->t));
  UM_CHECK(um_core_allocate(context, s->nbin, sizeof *heat->heat, &heat->heat));
  UM_CHECK(um_core_allocate(context, s->nbin, sizeof *heat->sigma, &heat->sigma));
  memcpy(heat->t, s->time, (s->nbin + 1) * sizeof *heat->t);
  UM_CHECK(um_missing_heat_history(context, &bins, s->residual, heat->heat, heat->sigma));
done:
  um_missing_heat_bins_release(context, &bins);
  return status;
}

/* Mark the observations near an edge of the first search. */
static void want(struct search *s, size_t edge)
{
  size_t from = s->edge[edge > UM_MISSING_HEAT_ABOUT ? edge - UM_MISSING_HEAT_ABOUT : 0];
  size_t to =
      s->edge[edge + UM_MISSING_HEAT_ABOUT < s->nbin ? edge + UM_MISSING_HEAT_ABOUT : s->nbin];
  for (size_t k = from; k <= to; k++) s->wanted[k] = true;
}

/* Search the same place with all times near the edges of its best pulse. The sigmas of the first
 * search stay where they are larger. */
static enum um_status look_again(struct um_context *context, struct search *s,
                                 struct um_missing_heat_pulse *first, size_t place,
                                 struct um_missing_heat *heat)
{
  enum um_status status;
  struct um_missing_heat_bins bins = {0};
  struct um_missing_heat_pulse pulse;
  size_t n = 0;
  memset(s->wanted, 0, s->nobs * sizeof *s->wanted);
  s->wanted[0] = s->wanted[s->nobs - 1] = true;
  want(s, first->from);
  want(s, first->to);
  for (size_t k = 0; k < s->nobs; k++)
    if (s->wanted[k]) s->time[n++] = s->t[k];
  UM_CHECK(columns_make(context, s, place, 1, n - 1, s->time));
  UM_CHECK(bins_make(context, s, 0, n - 1, s->time, &bins));
  um_missing_heat_pulse_find(&bins, &pulse);
  double width = heat->t[1] - heat->t[0];
  pulse.start_sigma =
      fmax(pulse.start_sigma,
           sqrt(fmax(0.0, first->start_sigma * first->start_sigma - width * width / 12.0)));
  pulse.energy_sigma = fmax(pulse.energy_sigma, first->energy_sigma);
  take_pulse(&bins, &pulse, heat);
done:
  um_missing_heat_bins_release(context, &bins);
  return status;
}

/* Power of the pulse by the model itself. Sigma scales with it, and the error of the linear
 * response is added, since the edges were found with that. A place where the model refuses a source
 * keeps the result of the linear response. */
static enum um_status check(struct um_context *context, struct search *s, size_t place,
                            struct um_missing_heat *heat)
{
  double power = heat->power, chi2 = heat->chi2_explained;
  enum um_status status =
      um_missing_heat_change(context, &s->base, &s->projection, s->residual, &s->place[place],
                             heat->start, heat->stop, &power, &chi2);
  if (status == UM_ERR_REFUSED || status == UM_ERR_NUMERIC) {
    um_core_message_clear(context);
    return UM_OK;
  }
  UM_TRY(status);
  double bent = power / heat->power;
  heat->chi2_explained = chi2;
  heat->energy_sigma = hypot(bent * heat->energy_sigma, (bent - 1.0) * heat->energy);
  heat->energy *= bent;
  heat->power = power;
  return UM_OK;
}

static void sort(struct um_missing_heat_unexplained *u, size_t *origin)
{
  for (size_t i = 1; i < u->nheat; i++)
    for (size_t k = i; k > 0 && u->heat[k].chi2_explained > u->heat[k - 1].chi2_explained; k--) {
      struct um_missing_heat heat = u->heat[k];
      size_t place = origin[k];
      u->heat[k] = u->heat[k - 1];
      origin[k] = origin[k - 1];
      u->heat[k - 1] = heat;
      origin[k - 1] = place;
    }
}

static enum um_status look_everywhere(struct um_context *context, struct search *s,
                                      struct um_missing_heat_unexplained *out)
{
  enum um_status status = UM_OK;
  um_core_progress_begin(context, "looking for missing heat", s->nplace);
  for (size_t b = 0; b <= s->nbin; b++) s->time[b] = s->t[s->edge[b]];
  for (size_t p = 0; p < s->nplace && status == UM_OK; p++) {
    size_t left = s->nplace - p;
    um_core_quiet_begin(context);
    if (p % UM_MISSING_HEAT_TOGETHER == 0)
      status = columns_make(context, s, p,
                            left < UM_MISSING_HEAT_TOGETHER ? left : UM_MISSING_HEAT_TOGETHER,
                            s->nbin, s->time);
    out->nheat = p + 1;
    if (status == UM_OK) status = look(context, s, p, &out->heat[p]);
    um_core_quiet_end(context);
    if (status == UM_OK) status = um_core_progress_step(context, 1);
  }
  um_core_progress_end(context);
  return status;
}

static enum um_status find_heat(struct um_context *context, struct search *s,
                                struct um_missing_heat_unexplained *out)
{
  enum um_status status = UM_OK;
  UM_TRY(um_missing_heat_places_create(context, s->base.variant.model, &s->place, &s->nplace));
  UM_TRY(find_edges(context, s));
  UM_TRY(um_core_allocate(context, s->nplace, sizeof *out->heat, &out->heat));
  UM_TRY(look_everywhere(context, s, out));
  sort(out, s->origin);
  um_core_quiet_begin(context);
  for (size_t i = 0; i < out->nheat && i < UM_MISSING_HEAT_REFINED && status == UM_OK; i++) {
    size_t place = s->origin[i];
    if (!(out->heat[i].chi2_explained > UM_MISSING_HEAT_WORTHY * out->heat[0].chi2_explained))
      continue;
    if (s->nbin < s->nobs - 1)
      status = look_again(context, s, &s->pulse[place], place, &out->heat[i]);
    if (status == UM_OK) status = check(context, s, place, &out->heat[i]);
  }
  um_core_quiet_end(context);
  sort(out, s->origin);
  return status;
}

/* Whether the best pulse is an explanation: significant, and little is left but noise. */
static bool is_found(const struct um_missing_heat_unexplained *u, size_t nbin, double dof)
{
  if (u->nheat == 0) return false;
  double tests = (double)u->nheat * 0.5 * (double)nbin * (double)(nbin + 1);
  double p = um_inference_chi2_q(u->heat[0].chi2_explained, 1.0);
  double left = fmax(UM_MISSING_HEAT_LEFT * (u->chi2_before - dof),
                     UM_MISSING_HEAT_SCATTER * sqrt(2.0 * dof));
  return p * tests < UM_MISSING_HEAT_LEVEL && u->chi2_after - dof < left;
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
  struct search s = {0};
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
  u->found = is_found(u, s.nbin, (double)forward->observations.count - (double)nnuisance);
  *out = u;
  u = NULL;
done:
  forward->seconds += omp_get_wtime() - begin;
  search_release(context, &s);
  um_missing_heat_unexplained_destroy(context, &u);
  return status;
}

void um_missing_heat_unexplained_destroy(struct um_context *context,
                                         struct um_missing_heat_unexplained **unexplained)
{
  if (unexplained == NULL || *unexplained == NULL) return;
  struct um_missing_heat_unexplained *u = *unexplained;
  for (size_t i = 0; i < u->nheat; i++) {
    UM_FREE(context, u->heat[i].place, u->heat[i].t, u->heat[i].heat, u->heat[i].sigma);
  }
  UM_FREE(context, u->heat, u->coordinate, u->channel, u);
  *unexplained = NULL;
}
