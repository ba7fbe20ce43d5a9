/* Passes to come, and how well each tells two explanations apart.
 *
 * Heat is followed from the first measurement on, so that what was stored then has drifted away as
 * far as it will have. Chi-square of a pass is that of one value per cadence of what was measured,
 * in the band that tells most, against noise alone; the stretch that is worth
 * UM_INFERENCE_SEPARABLE (5 sigma) first is found among stretches that begin at a step of the pass.
 */
#include "evidence/diagnosis/coming_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/sort.h"
#include "evidence/diagnosis/apart_impl.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/measurements/time_text.h"

#define DAY          86400.0 /* [s] */
#define BEYOND       7200.0  /* passes are looked for this far outside a day, to be whole [s] */
#define BEYOND_TABLE 1.0     /* and this far inside what the orbit covers, for light time [s] */

enum um_status um_diagnosis_coming_check(struct um_context *context,
                                         const struct um_sensitivity_forward *forward)
{
  const struct um_model *model = forward->model;
  const char *file = model->scenario->at.file;
  if (!model->has_observer || model->observer.kind != UM_OBSERVER_STATION)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--passes: %s has no station; accepted: a scenario "
                        "with observer.station",
                        file);
  if (model->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--passes: %s has orbit.points; accepted: a scenario with an orbit", file);
  return UM_OK;
}

static int compare_rises(const void *a, const void *b)
{
  double x = ((const struct um_diagnosis_pass *)a)->rise;
  double y = ((const struct um_diagnosis_pass *)b)->rise;
  return (x > y) - (x < y);
}

static const char *station_name(const struct um_model *model, size_t station)
{
  const struct um_scenario_observer *from = model->scenario->observer;
  const struct um_scenario_station *other = from->stations.items;
  const char *name = station == 0 ? from->station->name : other[station - 1].name;
  return name != NULL ? name : "";
}

/* The next `wanted` passes over a station, day by day; one is of the day it culminates in. */
static enum um_status find_over(struct um_context *context, const struct um_model *model,
                                size_t station, double from, size_t wanted,
                                struct um_diagnosis_coming *c)
{
  double least = model->scenario->observer->minimum_elevation_deg * UM_DEG;
  double first, last;
  size_t found = 0;
  um_orbit_trajectory_span(model->trajectory, &first, &last);
  for (int day = 0; day < UM_DIAGNOSIS_DAYS && found < wanted; day++) {
    double begin = from + day * DAY, end = begin + DAY;
    struct um_orbit_pass *pass = NULL;
    size_t n = 0;
    if (!(begin < last)) break;
    UM_TRY(um_orbit_passes_find(context, &model->station[station], model->trajectory,
                                fmax(begin - BEYOND, first + BEYOND_TABLE),
                                fmin(end + BEYOND, last - BEYOND_TABLE), least, &pass, &n));
    enum um_status status =
        um_core_reallocate(context, c->npass + n, sizeof *c->pass, (void **)&c->pass);
    for (size_t i = 0; status == UM_OK && i < n && found < wanted; i++) {
      const struct um_orbit_pass *p = &pass[i];
      if (!(p->rise > from && p->culmination >= begin && p->culmination < end)) continue;
      if (!(p->set - p->rise >= 1.0)) continue;
      c->pass[c->npass++] = (struct um_diagnosis_pass){.station = station_name(model, station),
                                                       .which = station,
                                                       .rise = p->rise,
                                                       .culmination = p->culmination,
                                                       .set = p->set,
                                                       .elevation = p->culmination_elevation};
      found++;
    }
    um_core_free(context, pass);
    UM_TRY(status);
  }
  return UM_OK;
}

struct instant {
  double t;
  size_t station, pass; /* pass SIZE_MAX: the first measurement */
};

static int compare_instants(const void *a, const void *b)
{
  const struct instant *x = a, *y = b;
  return x->t != y->t ? (x->t > y->t) - (x->t < y->t)
                      : (x->station > y->station) - (x->station < y->station);
}

static enum um_status lay(struct um_context *context, const struct um_compare_plan *plan,
                          struct um_diagnosis_coming *c)
{
  enum um_status status;
  size_t n = 1 + c->npass * UM_DIAGNOSIS_PASS_STEPS;
  struct instant *at = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *at, &at));
  UM_CHECK(um_core_allocate(context, n, sizeof *c->time, &c->time));
  UM_CHECK(um_core_allocate(context, n, sizeof *c->exposure, &c->exposure));
  UM_CHECK(um_core_allocate(context, n, sizeof *c->station, &c->station));
  UM_CHECK(um_core_allocate(context, n, sizeof *c->of, &c->of));
  at[0] = (struct instant){plan->time[0], plan->station[0], SIZE_MAX};
  for (size_t i = 0; i + 1 < n; i++) {
    const struct um_diagnosis_pass *pass = &c->pass[i / UM_DIAGNOSIS_PASS_STEPS];
    double u = ((double)(i % UM_DIAGNOSIS_PASS_STEPS) + 0.5) / UM_DIAGNOSIS_PASS_STEPS;
    at[i + 1] = (struct instant){pass->rise + u * (pass->set - pass->rise), pass->which,
                                 i / UM_DIAGNOSIS_PASS_STEPS};
  }
  UM_CHECK(um_core_sort(context, at, n, sizeof *at, compare_instants));
  for (size_t i = 0; i < n; i++) {
    c->time[i] = at[i].t;
    c->station[i] = at[i].station;
    c->of[i] = at[i].pass;
  }
  c->instants = (struct um_model_instants){
      .time = c->time, .exposure = c->exposure, .station = c->station, .count = n};
done:
  um_core_free(context, at);
  return status;
}

enum um_status um_diagnosis_coming_create(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          size_t wanted, struct um_diagnosis_coming *out)
{
  const struct um_model *model = forward->model;
  const struct um_compare_plan *plan = forward->plan;
  double from = plan->time[plan->ntime - 1];
  *out = (struct um_diagnosis_coming){.npass = 0};
  for (size_t s = 0; s < model->nstation; s++)
    UM_TRY(find_over(context, model, s, from, wanted, out));
  if (out->npass == 0) {
    char text[40];
    um_compare_time_text(from, text);
    um_core_log(context, UM_LOG_WARNING, "no pass within %d days behind %s", UM_DIAGNOSIS_DAYS,
                text);
    return UM_OK;
  }
  UM_TRY(um_core_sort(context, out->pass, out->npass, sizeof *out->pass, compare_rises));
  return lay(context, plan, out);
}

void um_diagnosis_coming_release(struct um_context *context, struct um_diagnosis_coming *coming)
{
  UM_FREE(context, coming->pass, coming->time, coming->exposure, coming->station, coming->of);
  *coming = (struct um_diagnosis_coming){.npass = 0};
}

/* The shortest stretch of steps, each worth chi2[i], that is worth `wanted`: how many steps it has,
 * the last in part; INFINITY: all are worth less. *begin: its first step. */
static double shortest(const double *chi2, size_t n, double wanted, size_t *begin)
{
  double best = INFINITY;
  for (size_t i = 0; i < n; i++) {
    double sum = 0.0;
    for (size_t j = i; j < n; j++) {
      if (sum + chi2[j] < wanted) {
        sum += chi2[j];
        continue;
      }
      double steps = (double)(j - i) + (wanted - sum) / chi2[j];
      if (steps < best) *begin = i;
      best = fmin(best, steps);
      break;
    }
  }
  return best;
}

/* A band of a pass, where it tells more than what is kept. */
static void offer(const struct um_diagnosis_coming *c, const struct um_diagnosis_band_noise *noise,
                  const struct um_sensitivity_forward_run run[2], size_t band, const char *name,
                  double cadence, size_t which, struct um_diagnosis_pass *pass)
{
  double chi2[UM_DIAGNOSIS_PASS_STEPS], sum = 0.0, unused;
  double step = (pass->set - pass->rise) / UM_DIAGNOSIS_PASS_STEPS;
  size_t n = 0, begin = 0;
  for (size_t k = 0; k < c->instants.count; k++) {
    if (c->of[k] != which) continue;
    double one = um_diagnosis_apart(noise, run[0].result, run[1].result, band, k, &unused);
    chi2[n] = isfinite(one) ? one * step / cadence : 0.0;
    sum += chi2[n++];
  }
  if (!(sqrt(sum) > pass->sigmas)) return;
  double steps = shortest(chi2, n, UM_INFERENCE_SEPARABLE, &begin);
  pass->of = name;
  pass->sigmas = sqrt(sum);
  pass->seconds = isfinite(steps) ? fmax(steps * step, cadence) : NAN;
  pass->from = isfinite(steps) ? pass->rise + (double)begin * step : NAN;
}

enum um_status um_diagnosis_coming_tell(struct um_context *context,
                                        const struct um_sensitivity_forward *forward,
                                        const struct um_diagnosis_coming *coming,
                                        const struct um_sensitivity_forward_run run[2],
                                        struct um_diagnosis_next *next)
{
  const struct um_model *model = forward->model;
  const struct um_model_tables *tables = run[0].variant.tables;
  UM_TRY(um_core_allocate(context, coming->npass, sizeof *next->pass, &next->pass));
  next->npass = coming->npass;
  for (size_t p = 0; p < next->npass; p++) {
    next->pass[p] = coming->pass[p];
    next->pass[p].seconds = next->pass[p].from = NAN;
  }
  for (size_t k = 0; k < coming->instants.count; k++) { /* ascending */
    struct um_diagnosis_pass *pass =
        coming->of[k] < next->npass ? &next->pass[coming->of[k]] : NULL;
    if (pass != NULL && coming->time[k] <= pass->culmination)
      pass->sun_elevation = tables->look[k * tables->nsub].sun_elevation;
  }
  for (size_t band = 0; band < model->nband; band++) {
    double cadence;
    const char *name = model->band[band].name;
    const struct um_diagnosis_band_noise noise =
        um_diagnosis_noise_of_band(forward, run[0].result, band, name);
    UM_TRY(um_diagnosis_cadence_of(context, forward, false, name, &cadence));
    for (size_t p = 0; p < next->npass; p++)
      offer(coming, &noise, run, band, name, cadence, p, &next->pass[p]);
  }
  return UM_OK;
}
