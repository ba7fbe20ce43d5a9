/* Looking up a pass: L = M(p, gamma, plane) E_sun, beside the same without the map. */
#include "model/products/reflectivity_pass.h"

#include <string.h>

#include "model/build/timeline.h"
#include "model/geometry/precompute.h"
#include "model/geometry/precompute_group.h"
#include "model/products/reflectivity.h"

static enum um_status allocate(struct um_context *context, size_t n, size_t nband,
                               struct um_model_map_pass *p)
{
  double **const numbers[] = {&p->light, &p->looked_up, &p->smallest, &p->direct, &p->error};
  p->n = n;
  p->nband = nband;
  UM_TRY(um_core_allocate(context, n, sizeof *p->t, &p->t));
  UM_TRY(um_core_allocate(context, n, sizeof *p->sample, &p->sample));
  UM_TRY(um_core_allocate(context, n, sizeof *p->sun, &p->sun));
  UM_TRY(um_core_allocate(context, n, sizeof *p->observer, &p->observer));
  UM_TRY(um_core_allocate(context, n, sizeof *p->at, &p->at));
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
    UM_TRY(um_core_allocate(context, n * nband, sizeof(double), numbers[i]));
  return UM_OK;
}

void um_model_map_pass_destroy(struct um_context *context, struct um_model_map_pass **pass)
{
  if (pass == NULL || *pass == NULL) return;
  struct um_model_map_pass *p = *pass;
  void *const blocks[] = {p->t,     p->sample,    p->sun,      p->observer, p->at,
                          p->light, p->looked_up, p->smallest, p->direct,   p->error};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
  um_core_free(context, p);
  *pass = NULL;
}

static enum um_status fill(struct um_context *context, const struct um_model *model,
                           const struct um_model_map *map, struct um_model_map_pass *p)
{
  double *scratch = NULL;
  int bins = 1;
  for (size_t b = 0; b < model->nband; b++)
    if (model->band[b].bins > bins) bins = model->band[b].bins;
  UM_TRY(um_core_allocate(context, (size_t)bins, sizeof *scratch, &scratch));
  for (size_t i = 0; i < p->n; i++) {
    struct um_environment_sample *s = &p->sample[i];
    p->sun[i] = um_quat_apply(s->q, s->sun);
    p->observer[i] = um_quat_apply(s->q, s->to_observer);
    p->at[i] = um_model_phase_vector(p->sun[i], p->observer[i]);
    for (size_t b = 0; b < p->nband; b++)
      p->light[i * p->nband + b] = um_model_sunlight_band(model, s, b, scratch);
    struct um_model_phase_vector at = p->at[i];
    um_model_map_look_up(map, &at, p->looked_up + i * p->nband);
    at.phase_angle = 0.0;
    um_model_map_look_up(map, &at, p->smallest + i * p->nband);
  }
  um_core_free(context, scratch);
  return um_model_reflectivity(context, model, "light along the pass", p->sun, p->observer, p->n,
                               p->direct, p->error);
}

enum um_status um_model_map_pass_of(struct um_context *context, const struct um_model *model,
                                    const struct um_model_map *map,
                                    const struct um_environment_sample *samples, const double *t,
                                    size_t n, struct um_model_map_pass **out)
{
  enum um_status status;
  struct um_model_map_pass *p = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *p, &p));
  UM_CHECK(allocate(context, n, model->nband, p));
  memcpy(p->sample, samples, n * sizeof *samples);
  memcpy(p->t, t, n * sizeof *t);
  UM_CHECK(fill(context, model, map, p));
  *out = p;
  p = NULL;
done:
  um_model_map_pass_destroy(context, &p);
  return status;
}

enum um_status um_model_map_pass_create(struct um_context *context, const struct um_model *model,
                                        const struct um_model_map *map,
                                        struct um_model_map_pass **out)
{
  enum um_status status;
  struct um_environment_sample *sample = NULL;
  double *t = NULL;
  size_t n = 0;
  *out = NULL;
  if (model->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: orbit.points has no pass of its own; accepted: a measurement file",
                        model->scenario->at.file);
  UM_CHECK(um_model_scenario_times(context, model, &t, &n));
  UM_CHECK(um_core_allocate(context, n, sizeof *sample, &sample));
  for (size_t i = 0; i < n; i++) {
    struct um_orbit_look look;
    double at = um_model_true_time(model, NULL, t[i]);
    UM_CHECK(um_model_sample_seen(context, model, at, &sample[i], &look));
  }
  UM_CHECK(um_model_map_pass_of(context, model, map, sample, t, n, out));
done:
  UM_FREE(context, sample, t);
  return status;
}

struct um_model_map_difference um_model_map_difference(const struct um_model_map_pass *pass,
                                                       size_t band)
{
  struct um_model_map_difference d = {0};
  for (size_t i = 0; i < pass->n; i++) {
    size_t at = i * pass->nband + band;
    double light = pass->light[at], direct = light * pass->direct[at];
    double all = light * pass->looked_up[at] - direct, zero = light * pass->smallest[at] - direct;
    if (!(light > 0.0) || isnan(pass->at[i].latitude)) continue;
    d.count++;
    d.mean += direct;
    d.bias += all;
    d.bias_0 += zero;
    d.rms += all * all;
    d.rms_0 += zero * zero;
  }
  double n = d.count > 0 ? (double)d.count : 1.0;
  d.mean /= n;
  d.bias /= n;
  d.bias_0 /= n;
  d.rms = sqrt(d.rms / n);
  d.rms_0 = sqrt(d.rms_0 / n);
  return d;
}
