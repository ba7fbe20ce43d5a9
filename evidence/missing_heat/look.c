/* Looks at places for heat. Each is tried with every course on a grid of at most
 * UM_MISSING_HEAT_BINS_MAX bins. Where observations are denser, the best places are tried again
 * with all times near the edges found. Then the model itself is run with the heat,
 *
 *   bend = what the model does - what the linear response says,
 *
 * and the courses are fitted to the residual less the bend, until they move no more. */
#include "evidence/missing_heat/look_impl.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "evidence/missing_heat/history_impl.h"
#include "evidence/missing_heat/policy.h"

void um_missing_heat_look_release(struct um_context *context, struct um_missing_heat_look *s)
{
  um_missing_heat_base_release(context, &s->base);
  um_missing_heat_places_destroy(context, &s->place, s->nplace);
  um_inference_projection_destroy(context, &s->projection);
  UM_FREE(context, s->residual, s->column, s->t, s->edge, s->time, s->wanted, s->origin, s->choice);
}

enum um_status um_missing_heat_look_begin(struct um_context *context,
                                          struct um_missing_heat_look *s)
{
  const struct um_model_tables *tables = s->base.variant.tables;
  size_t n = s->nobs = tables->nobs;
  UM_TRY(um_missing_heat_places_create(context, s->base.variant.model, &s->place, &s->nplace));
  s->nbin = n - 1 < UM_MISSING_HEAT_BINS_MAX ? n - 1 : UM_MISSING_HEAT_BINS_MAX;
  UM_TRY(um_core_allocate(context, n, sizeof *s->t, &s->t));
  UM_TRY(um_core_allocate(context, n, sizeof *s->time, &s->time));
  UM_TRY(um_core_allocate(context, n, sizeof *s->wanted, &s->wanted));
  UM_TRY(um_core_allocate(context, s->nbin + 1, sizeof *s->edge, &s->edge));
  UM_TRY(um_core_allocate(context, s->nplace, sizeof *s->origin, &s->origin));
  UM_TRY(um_core_allocate(context, s->nplace, sizeof *s->choice, &s->choice));
  for (size_t k = 0; k < n; k++)
    s->t[k] = tables->sample[k * tables->nsub + tables->nsub / 2].t_tai;
  for (size_t b = 0; b <= s->nbin; b++) s->edge[b] = (b * (n - 1) + s->nbin / 2) / s->nbin;
  return UM_OK;
}

/* Columns of `count` places from `first` on. */
static enum um_status columns_make(struct um_context *context, struct um_missing_heat_look *s,
                                   size_t first, size_t count, size_t nbin, const double *edge)
{
  UM_TRY(um_core_reallocate(context, count * nbin * s->base.forward->observations.count,
                            sizeof *s->column, &s->column));
  return um_missing_heat_columns(context, &s->base, &s->place[first], count, nbin, edge, s->column);
}

/* Bins of place number `at` of those. */
static enum um_status bins_make(struct um_context *context, struct um_missing_heat_look *s,
                                size_t at, size_t nbin, const double *edge,
                                struct um_missing_heat_bins *out)
{
  const double *column = s->column + at * nbin * s->base.forward->observations.count;
  return um_missing_heat_bins_create(context, &s->projection, s->residual, nbin, edge, column, out);
}

/* What was chosen, as a result. `residual` of the bins may lack a bend. */
static void take_choice(const struct um_missing_heat_look *s,
                        const struct um_missing_heat_bins *bins,
                        const struct um_missing_heat_choice *choice, struct um_missing_heat *heat)
{
  const struct um_missing_heat_fit *fit = &choice->of[choice->shape];
  double before = um_inference_dot(bins->nleft, s->residual, s->residual);
  heat->course = fit->course;
  heat->nparameter = um_thermal_course_parameters(choice->shape);
  heat->chi2_explained = before - bins->square + fit->chi2;
  heat->stop = fit->course.shape == UM_HEAT_PULSE ? fit->course.start + fit->course.last
                                                  : bins->edge[bins->nbin];
  heat->power = fit->power;
  heat->energy = fit->energy;
  heat->start_sigma = choice->start_sigma;
  heat->energy_sigma = choice->energy_sigma;
  heat->last_sigma = fit->last_sigma;
  heat->period_sigma = fit->period_sigma;
  for (int i = 0; i < UM_HEAT_SHAPES; i++) heat->behind[i] = choice->of[i].bic - fit->bic;
}

static enum um_status take_history(struct um_context *context,
                                   const struct um_missing_heat_bins *bins, double scale,
                                   struct um_missing_heat *heat)
{
  size_t n = bins->nbin;
  heat->nbin = n;
  UM_TRY(um_core_reallocate(context, n + 1, sizeof *heat->t, &heat->t));
  UM_TRY(um_core_reallocate(context, n, sizeof *heat->heat, &heat->heat));
  UM_TRY(um_core_reallocate(context, n, sizeof *heat->sigma, &heat->sigma));
  UM_TRY(um_core_reallocate(context, n, sizeof *heat->low, &heat->low));
  UM_TRY(um_core_reallocate(context, n, sizeof *heat->high, &heat->high));
  memcpy(heat->t, bins->edge, (n + 1) * sizeof *heat->t);
  const struct um_missing_heat_band band = {heat->heat, heat->sigma, heat->low, heat->high};
  return um_missing_heat_history(context, bins, scale, &band);
}

/* Best course and history of a place, on the bins of the first look, whose columns are made. */
static enum um_status look(struct um_context *context, struct um_missing_heat_look *s, size_t place,
                           struct um_missing_heat *heat)
{
  enum um_status status;
  struct um_missing_heat_bins bins = {0};
  struct um_missing_heat_choice *choice = &s->choice[place];
  s->origin[place] = place;
  UM_CHECK(um_core_strdup(context, s->place[place].name, &heat->place));
  UM_CHECK(bins_make(context, s, place % UM_MISSING_HEAT_TOGETHER, s->nbin, s->time, &bins));
  um_missing_heat_search(&bins, choice);
  um_missing_heat_improve(&bins, choice);
  take_choice(s, &bins, choice, heat);
  UM_CHECK(take_history(context, &bins, choice->scale, heat));
done:
  um_missing_heat_bins_release(context, &bins);
  return status;
}

enum um_status um_missing_heat_look_everywhere(struct um_context *context,
                                               struct um_missing_heat_look *s,
                                               struct um_missing_heat *heat, size_t *nheat)
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
    *nheat = p + 1;
    if (status == UM_OK) status = look(context, s, p, &heat[p]);
    um_core_quiet_end(context);
    if (status == UM_OK) status = um_core_progress_step(context, 1);
  }
  um_core_progress_end(context);
  return status;
}

/* --- the second look ---------------------------------------------------------------------------
 */

/* Mark the observations near a time. */
static void want(struct um_missing_heat_look *s, double t)
{
  size_t edge = 0;
  while (edge < s->nbin && s->t[s->edge[edge + 1]] <= t) edge++;
  size_t from = s->edge[edge > UM_MISSING_HEAT_ABOUT ? edge - UM_MISSING_HEAT_ABOUT : 0];
  size_t to = edge + 1 + UM_MISSING_HEAT_ABOUT < s->nbin ? s->edge[edge + 1 + UM_MISSING_HEAT_ABOUT]
                                                         : s->edge[s->nbin];
  for (size_t k = from; k <= to; k++) s->wanted[k] = true;
}

/* Edges of the first look, and all times near where the courses of a choice begin and end. */
static size_t edges_find(struct um_missing_heat_look *s,
                         const struct um_missing_heat_choice *choice)
{
  size_t n = 0;
  memset(s->wanted, 0, s->nobs * sizeof *s->wanted);
  for (size_t b = 0; b <= s->nbin; b++) s->wanted[s->edge[b]] = true;
  for (int i = 0; i < UM_HEAT_SHAPES; i++) {
    const struct um_thermal_course *c = &choice->of[i].course;
    if (choice->of[i].bic - choice->of[choice->shape].bic > UM_MISSING_HEAT_RIVAL) continue;
    want(s, c->start);
    if (c->shape == UM_HEAT_PULSE || c->shape == UM_HEAT_PERIODIC) want(s, c->start + c->last);
    if (c->shape == UM_HEAT_PERIODIC) want(s, c->start + c->period);
  }
  for (size_t k = 0; k < s->nobs; k++)
    if (s->wanted[k]) s->time[n++] = s->t[k];
  return n - 1;
}

/* Fit again with the bend of the model at what was chosen. bend, change: [nleft] */
static enum um_status correct(struct um_context *context, struct um_missing_heat_look *s,
                              size_t place, struct um_missing_heat_bins *bins,
                              struct um_missing_heat_choice *choice, double *change, double *bent)
{
  const struct um_missing_heat_fit *fit = &choice->of[choice->shape];
  UM_TRY(um_missing_heat_change(context, &s->base, &s->projection, &s->place[place], fit,
                                bins->edge[bins->nbin], change));
  um_missing_heat_bins_respond(bins, &fit->course, fit->power, bent);
  for (size_t j = 0; j < bins->nleft; j++) bent[j] += s->residual[j] - change[j];
  um_missing_heat_bins_meet(bins, bent);
  um_missing_heat_improve(bins, choice);
  return UM_OK;
}

/* Until start and energy stay. What they last moved by is added to their sigmas. A place where the
 * model refuses a source keeps the result of the linear response. */
static enum um_status correct_all(struct um_context *context, struct um_missing_heat_look *s,
                                  size_t place, struct um_missing_heat_bins *bins,
                                  struct um_missing_heat_choice *choice)
{
  enum um_status status = UM_OK;
  double *change = NULL, *bent = NULL;
  UM_CHECK(um_core_allocate(context, bins->nleft, sizeof *change, &change));
  UM_CHECK(um_core_allocate(context, bins->nleft, sizeof *bent, &bent));
  for (int k = 0; k < UM_MISSING_HEAT_STEPS; k++) {
    const struct um_missing_heat_fit was = choice->of[choice->shape];
    if (!(was.chi2 > 0.0)) break;
    status = correct(context, s, place, bins, choice, change, bent);
    if (status == UM_ERR_REFUSED || status == UM_ERR_NUMERIC) {
      um_core_message_clear(context);
      status = UM_OK;
      break;
    }
    if (status != UM_OK) break;
    const struct um_missing_heat_fit *is = &choice->of[choice->shape];
    double late = is->course.start - was.course.start, more = is->energy - was.energy;
    bool stays = fabs(late) < UM_MISSING_HEAT_SETTLED * choice->start_sigma &&
                 fabs(more) < UM_MISSING_HEAT_SETTLED * choice->energy_sigma;
    if (!stays && k + 1 < UM_MISSING_HEAT_STEPS) continue;
    choice->start_sigma = hypot(choice->start_sigma, late);
    choice->energy_sigma = hypot(choice->energy_sigma, more);
    break;
  }
done:
  UM_FREE(context, change, bent);
  return status;
}

enum um_status um_missing_heat_look_again(struct um_context *context,
                                          struct um_missing_heat_look *s, size_t place,
                                          struct um_missing_heat *heat)
{
  enum um_status status;
  struct um_missing_heat_bins bins = {0};
  struct um_missing_heat_choice choice = s->choice[place];
  size_t nbin = edges_find(s, &choice);
  UM_CHECK(columns_make(context, s, place, 1, nbin, s->time));
  UM_CHECK(bins_make(context, s, 0, nbin, s->time, &bins));
  if (nbin > s->nbin) um_missing_heat_improve(&bins, &choice);
  UM_CHECK(correct_all(context, s, place, &bins, &choice));
  take_choice(s, &bins, &choice, heat);
  UM_CHECK(take_history(context, &bins, choice.scale, heat));
done:
  um_missing_heat_bins_release(context, &bins);
  return status;
}
