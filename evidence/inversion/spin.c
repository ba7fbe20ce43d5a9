/* From rows on a map to a list of spins. */
#include "evidence/inversion/spin.h"

#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "evidence/inversion/spin_impl.h"
#include "evidence/measurements/time_text.h"

#define ROWS_LEAST 5 /* one more than parameters */
#define LAWS_MAX   1e9
#define REACH      100.0 /* times the best's chi-square without light between surfaces */

double um_compare_spin_distance(const struct um_compare_spin_data *data,
                                const struct um_compare_spin_law *a,
                                const struct um_compare_spin_law *b)
{
  double largest = 0.0;
  for (size_t i = 0; i < data->count; i++) {
    double t = data->row[i].t;
    struct um_quat p = um_compare_spin_attitude(data, a, t);
    struct um_quat d = um_quat_then(um_quat_conjugate(p), um_compare_spin_attitude(data, b, t));
    double sine = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    largest = fmax(largest, 2.0 * atan2(sine, fabs(d.w)));
  }
  return largest;
}

/* ---- what is sought, and in what ---- */

static bool is_used(const struct um_model *model, const struct um_compare_map_row *row)
{
  return model->band[row->band].to <= UM_INFRARED_FROM;
}

static size_t used_count(const struct um_model *model, const struct um_compare_on_map *on_map)
{
  size_t n = 0;
  for (size_t i = 0; i < on_map->count; i++) n += is_used(model, &on_map->row[i]);
  return n;
}

enum um_status um_compare_spins_check(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_on_map *on_map,
                                      const struct um_compare_spin_search *s)
{
  const struct um_schema_list *list = &model->scenario->attitude;
  const struct um_scenario_attitude *law = list->items;
  const struct um_scenario_spin *spin = list->count > 0 ? law->spin : NULL;
  if (list->count != 1 || spin == NULL || spin->q_gcrs.count > 0 || model->nutates)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: attitude: accepted: one law, a spin with axis_gcrs or axis_lvlh "
                        "and without nutation",
                        law != NULL ? law->at.file : model->scenario->at.file,
                        law != NULL ? law->at.line : model->scenario->at.line);
  size_t used = used_count(model, on_map);
  if (used < ROWS_LEAST)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %zu rows of light in sunlight, in bands that end by %g um; accepted: "
                        "%d or more",
                        on_map->measurements->path, used, 1e6 * UM_INFRARED_FROM, ROWS_LEAST);
  for (size_t i = 0; i < on_map->count; i++)
    if (is_used(model, &on_map->row[i]) && !(on_map->row[i].sigma > 0.0))
      return um_core_fail(
          context, UM_ERR_INPUT, "%s:%d: column 'sigma' is empty; accepted: a sigma in every row",
          on_map->measurements->path, on_map->measurements->row[on_map->row[i].row].line);
  if (!(s->axis_step > 0.0 && s->turn_step > 0.0 && s->turn_step <= 0.5 * UM_PI && s->keep > 0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "steps of %g deg for axes, %g deg for turns; accepted: above 0, to 90 deg",
                        s->axis_step / UM_DEG, s->turn_step / UM_DEG);
  if (s->period_least > 0.0 && s->period_most >= s->period_least && s->period_most < INFINITY)
    return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "periods from %g to %g s; accepted: above 0, rising",
                      s->period_least, s->period_most);
}

static enum um_status size_check(struct um_context *context, const struct um_compare_spin_data *d)
{
  const struct um_compare_spin_search *s = d->search;
  double rates = 2.0 * UM_PI * (1.0 / s->period_least - 1.0 / s->period_most) * d->span /
                     (2.0 * s->turn_step) +
                 1.0;
  double laws =
      4.0 * UM_PI / (s->axis_step * s->axis_step) * 2.0 * rates * 2.0 * UM_PI / s->turn_step;
  if (laws <= LAWS_MAX) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%.3g laws of spin, %g periods between %g and %g s for observations over %g "
                      "s; accepted: up to %g, by a narrower range or wider steps",
                      laws, floor(rates), s->period_least, s->period_most, d->span, LAWS_MAX);
}

/* Rows that are used, in the frame of the axis. */
static enum um_status fill_rows(struct um_context *context, struct um_compare_spin_data *d)
{
  enum um_status status;
  const struct um_compare_on_map *on_map = d->on_map;
  struct um_quat *frame = NULL;
  UM_CHECK(um_core_allocate(context, on_map->plan->ntime, sizeof *frame, &frame));
  UM_CHECK(um_compare_spin_frames(context, d->lvlh, on_map->sample, on_map->plan->ntime, frame));
  for (size_t i = 0; i < on_map->count; i++) {
    const struct um_compare_map_row *from = &on_map->row[i];
    const struct um_environment_sample *s = &on_map->sample[from->observation];
    if (!is_used(d->model, from)) continue;
    d->row[d->count++] = (struct um_compare_spin_row){
        .t = s->t_tai - d->at_tai,
        .sun = um_quat_apply(frame[from->observation], s->sun),
        .observer = um_quat_apply(frame[from->observation], s->to_observer),
        .band = from->band,
        .value = from->value,
        .sigma = from->sigma,
        .on_map = i};
  }
done:
  um_core_free(context, frame);
  return status;
}

static enum um_status data_make(struct um_context *context, struct um_compare_spins *spins,
                                struct um_compare_spin_data *d)
{
  const struct um_compare_on_map *on_map = d->on_map;
  const struct um_scenario_attitude *law = d->model->scenario->attitude.items;
  double first = INFINITY, last = -INFINITY;
  for (size_t i = 0; i < on_map->count; i++) {
    if (!is_used(d->model, &on_map->row[i])) continue;
    double t = on_map->sample[on_map->row[i].observation].t_tai;
    first = fmin(first, t);
    last = fmax(last, t);
  }
  const double *a = law->spin->axis_body;
  d->axis_body = spins->axis_body = um_vec3_unit(um_vec3(a[0], a[1], a[2]));
  d->span = last - first;
  spins->at_tai = 1e-3 * round(1e3 * 0.5 * (first + last)); /* as texts have it */
  spins->lvlh = law->spin->axis_lvlh.count > 0;
  UM_TRY(um_core_allocate(context, on_map->count, sizeof *d->row, &d->row));
  d->at_tai = spins->at_tai;
  d->lvlh = spins->lvlh;
  UM_TRY(fill_rows(context, d));
  spins->nobservation = d->count;
  return UM_OK;
}

/* ---- the list ---- */

static int compare_spins(const void *a, const void *b)
{
  double x = ((const struct um_compare_spin *)a)->chi2,
         y = ((const struct um_compare_spin *)b)->chi2;
  return (x > y) - (x < y);
}

static struct um_compare_spin_law law_of(const struct um_compare_spin *s)
{
  return (struct um_compare_spin_law){s->axis, 2.0 * UM_PI / s->period, s->phase, s->misfit};
}

/* The best first; what came to the same attitude, to a fifth of a step of the grid, once. */
static void sort_out(const struct um_compare_spin_data *d, struct um_compare_spins *spins)
{
  size_t n = 0;
  double near = 0.2 * fmin(d->search->axis_step, d->search->turn_step);
  qsort(spins->spin, spins->count, sizeof *spins->spin, compare_spins);
  for (size_t i = 0; i < spins->count; i++) {
    struct um_compare_spin_law own = law_of(&spins->spin[i]);
    bool known = false;
    for (size_t k = 0; k < n && !known; k++) {
      struct um_compare_spin_law other = law_of(&spins->spin[k]);
      known = um_compare_spin_distance(d, &own, &other) < near;
    }
    if (!known) spins->spin[n++] = spins->spin[i];
  }
  spins->count = n;
  double best = spins->spin[0].chi2, dof = (double)d->count - 4.0;
  double scale = fmax(1.0, best / dof);
  for (size_t i = 0; i < n; i++) spins->spin[i].apart = sqrt((spins->spin[i].chi2 - best) / scale);
}

/* Fit every law without light between surfaces, then those that are in reach of the best with it:
 * it costs as much as all else together many times, and no other can become the best. */
static enum um_status fit_all(struct um_context *context, const struct um_compare_spin_data *d,
                              const struct um_compare_spin_law *laws,
                              struct um_compare_spins *spins)
{
  enum um_status status = UM_OK;
  size_t n = spins->count;
  bool has_between = um_compare_spin_has_between(d->model);
  double best = INFINITY;
  um_core_progress_begin(context, "fitting attitudes", has_between ? 2 * n : n);
  for (size_t i = 0; i < (has_between ? 2 * n : n) && status == UM_OK; i++) {
    struct um_compare_spin *own = &spins->spin[i % n];
    bool between = i >= n;
    struct um_compare_spin_law law = between ? law_of(own) : laws[i];
    um_core_quiet_begin(context);
    if (!between || own->chi2 <= REACH * best)
      status = um_compare_spin_refine(context, d, &law, between, own);
    um_core_quiet_end(context);
    if (!between) best = fmin(best, own->chi2);
    if (status == UM_OK) status = um_core_progress_step(context, 1);
    if (status == UM_OK) status = um_core_stop_check(context, "attitudes were fitted");
  }
  um_core_progress_end(context);
  return status;
}

enum um_status um_compare_spins_find(struct um_context *context, const struct um_model *model,
                                     const struct um_compare_on_map *on_map,
                                     const struct um_model_map *map,
                                     const struct um_compare_spin_search *search,
                                     struct um_compare_spins **out)
{
  enum um_status status;
  struct um_compare_spins *spins = NULL;
  struct um_compare_spin_data d = {.model = model, .on_map = on_map, .map = map, .search = search};
  struct um_compare_spin_law *laws = NULL;
  size_t n = 0;
  *out = NULL;
  UM_TRY(um_compare_spins_check(context, model, on_map, search));
  UM_CHECK(um_core_allocate(context, 1, sizeof *spins, &spins));
  UM_CHECK(data_make(context, spins, &d));
  UM_CHECK(size_check(context, &d));
  UM_CHECK(um_compare_spin_light_create(context, &d, &d.light));
  UM_CHECK(um_compare_spin_earth(context, &d));
  UM_CHECK(um_compare_spin_grid(context, &d, &laws, &n, &spins->nlaw));
  UM_CHECK(um_core_allocate(context, n, sizeof *spins->spin, &spins->spin));
  spins->count = n;
  UM_CHECK(fit_all(context, &d, laws, spins));
  sort_out(&d, spins);
  *out = spins;
  spins = NULL;
done:
  UM_FREE(context, d.row, laws);
  um_compare_spin_light_destroy(context, &d.light);
  um_model_map_destroy(context, &d.earth);
  um_compare_spins_destroy(context, &spins);
  return status;
}

void um_compare_spins_destroy(struct um_context *context, struct um_compare_spins **spins)
{
  if (spins == NULL || *spins == NULL) return;
  UM_FREE(context, (*spins)->spin, *spins);
  *spins = NULL;
}

void um_compare_spins_write(const struct um_compare_spins *spins, FILE *file)
{
  char at[40];
  um_compare_time_text(spins->at_tai, at);
  fprintf(file,
          "axis_%s_x,axis_%s_y,axis_%s_z,period_s,phase_deg,at_utc,chi2,apart_sigma,"
          "axis_sigma_deg,period_sigma_s,phase_sigma_deg\n",
          spins->lvlh ? "lvlh" : "gcrs", spins->lvlh ? "lvlh" : "gcrs",
          spins->lvlh ? "lvlh" : "gcrs");
  for (size_t i = 0; i < spins->count; i++) {
    const struct um_compare_spin *s = &spins->spin[i];
    const double sigma[] = {s->axis_sigma / UM_DEG, s->period_sigma, s->phase_sigma / UM_DEG};
    fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%s,%.9g,%.9g", s->axis.x, s->axis.y, s->axis.z,
            s->period, s->phase / UM_DEG, at, s->chi2, s->apart);
    for (int k = 0; k < 3; k++) um_core_csv_put_number(file, sigma[k]);
    fputc('\n', file);
  }
}
