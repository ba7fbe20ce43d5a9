/* One instant of the scene: orbit, attitude, Sun and shadow together. */
#include "model/build/timeline.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/moonlight.h"
#include "environment/umbra_scatter.h"
#include "model/build/effects_group.h"
#include "orbit/sun.h"

/* Sun from the satellite's place; a frozen one keeps its geocentric place. Aberration is that of
 * the Earth's motion alone: the satellite's own would turn the Sun by up to 5 arcsec but not the
 * Earth's limb, and so move the edges of the shadow. */
static void sun_of(const struct um_model *model, double t_tai, struct um_vec3 r,
                   struct um_vec3 *direction, double *distance)
{
  if (model->sun_frozen) {
    struct um_vec3 to = um_vec3_sub(model->frozen_sun_position, r);
    *distance = um_vec3_norm(to);
    *direction = um_vec3_scale(to, 1.0 / *distance);
  } else {
    um_orbit_sun_apparent(model->ephemeris, t_tai, r, um_vec3(0, 0, 0), direction, distance);
  }
  if (!isnan(model->scenario->environment->sun_distance_au))
    *distance = model->scenario->environment->sun_distance_au * UM_AU;
}

/* Prime meridian turned about the pole since the start; precession and nutation since then, and the
 * error of UT1, move it by less than 0.02 deg in a year. */
static struct um_vec3 greenwich_at(const struct um_model *model, double t_tai)
{
  double angle = UM_EARTH_ROTATION * (t_tai - model->scenario->time->start);
  struct um_vec3 east = um_vec3_cross(model->pole, model->greenwich);
  return um_vec3_axpy(um_vec3_scale(model->greenwich, cos(angle)), sin(angle), east);
}

/* Fill everything but the attitude and who looks; r, v, t_tai are set. */
static void light_of(const struct um_model *model, struct um_environment_sample *s)
{
  sun_of(model, s->t_tai, s->r, &s->sun, &s->sun_distance);
  s->pole = model->pole;
  s->greenwich = greenwich_at(model, s->t_tai);
  s->sunlit_fraction =
      um_environment_sunlit_fraction(&model->environment, s->r, s->sun, s->sun_distance, s->pole);
  struct um_environment_scattered scattered;
  um_environment_umbra_scattered(&model->environment, s->r, s->sun, s->sun_distance, s->pole,
                                 s->sunlit_fraction, &scattered);
  s->scattered = um_environment_scattered_at(&scattered, UM_UMBRA_SCATTER_ASKED);
}

static struct um_orbit_attitude_input input_of(const struct um_model *model,
                                               const struct um_environment_sample *s)
{
  return (struct um_orbit_attitude_input){s->t_tai, s->r,           s->v,
                                          s->sun,   s->to_observer, model->ephemeris};
}

static enum um_status attitude_of(struct um_context *context, const struct um_model *model,
                                  struct um_environment_sample *s)
{
  struct um_orbit_attitude_input in = input_of(model, s);
  struct um_effect_use use;
  UM_TRY(um_orbit_attitude_at(context, model->attitude, &in, &s->q));
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.attitude != NULL) s->q = use.effect->hooks.attitude(&use, s->t_tai, s->q);
  return UM_OK;
}

/* Everything but the attitude; who looks only where a law looks at the observer. */
static enum um_status unturned(struct um_context *context, const struct um_model *model,
                               double t_tai, struct um_environment_sample *out)
{
  *out = (struct um_environment_sample){.t_tai = t_tai, .range = NAN};
  UM_TRY(um_orbit_trajectory_state(context, model->trajectory, t_tai, &out->r, &out->v));
  light_of(model, out);
  if (model->has_observer && model->points_at_observer) {
    struct um_orbit_look look;
    struct um_orbit_observer instant = model->observer;
    instant.light_time = 0;
    UM_TRY(um_orbit_observer_look(context, &instant, model->trajectory, t_tai, &look));
    out->to_observer = look.to_observer;
  }
  return UM_OK;
}

enum um_status um_model_attitude_input(struct um_context *context, const struct um_model *model,
                                       double t_tai, struct um_orbit_attitude_input *out)
{
  struct um_environment_sample s;
  UM_TRY(unturned(context, model, t_tai, &s));
  *out = input_of(model, &s);
  return UM_OK;
}

enum um_status um_model_sample_at(struct um_context *context, const struct um_model *model,
                                  double t_tai, struct um_environment_sample *out)
{
  UM_TRY(unturned(context, model, t_tai, out));
  UM_TRY(attitude_of(context, model, out));
  out->to_observer = um_vec3(0, 0, 0);
  return UM_OK;
}

enum um_status um_model_sample_turned(struct um_context *context, const struct um_model *model,
                                      const struct um_environment_sample *sample, double before,
                                      struct um_quat *q)
{
  struct um_environment_sample turned = *sample;
  turned.t_tai -= before;
  UM_TRY(attitude_of(context, model, &turned));
  *q = turned.q;
  return UM_OK;
}

/* The scene at a look of the observer. */
static enum um_status sample_of_look(struct um_context *context, const struct um_model *model,
                                     const struct um_orbit_look *look,
                                     struct um_environment_sample *out)
{
  *out = (struct um_environment_sample){.t_tai = look->t_satellite,
                                        .r = look->r_gcrs,
                                        .v = look->v_gcrs,
                                        .to_observer = look->to_observer,
                                        .range = look->range};
  light_of(model, out);
  um_environment_moon_place(&model->environment, um_orbit_moon_position(out->t_tai), out);
  return attitude_of(context, model, out);
}

enum um_status um_model_sample_from(struct um_context *context, const struct um_model *model,
                                    size_t station, double t_observer,
                                    struct um_environment_sample *out, struct um_orbit_look *look)
{
  if (!model->has_observer)
    return um_core_fail(context, UM_ERR_INPUT, "%s: the scenario has no observer",
                        model->scenario->at.file);
  UM_TRY(um_orbit_observer_look(context, &model->station[station], model->trajectory, t_observer,
                                look));
  return sample_of_look(context, model, look, out);
}

enum um_status um_model_sample_seen(struct um_context *context, const struct um_model *model,
                                    double t_observer, struct um_environment_sample *out,
                                    struct um_orbit_look *look)
{
  return um_model_sample_from(context, model, 0, t_observer, out, look);
}

enum um_status um_model_sample_point(struct um_context *context, const struct um_model *model,
                                     const struct um_model_point *point,
                                     struct um_environment_sample *out, struct um_orbit_look *look)
{
  if (!model->points)
    return um_core_fail(context, UM_ERR_INPUT, "%s: the scenario has an orbit, not points",
                        model->scenario->at.file);
  UM_TRY(um_orbit_observer_locate(context, &model->station[point->station], point->t,
                                  point->azimuth, point->elevation, point->height, look));
  return sample_of_look(context, model, look, out);
}

struct event_source {
  struct um_context *context;
  const struct um_model *model;
};

static enum um_status event_geometry(void *self, double t_tai, struct um_vec3 *r,
                                     struct um_vec3 *sun, double *distance, struct um_vec3 *pole)
{
  const struct event_source *source = self;
  UM_TRY(um_orbit_trajectory_state(source->context, source->model->trajectory, t_tai, r, NULL));
  sun_of(source->model, t_tai, *r, sun, distance);
  *pole = source->model->pole;
  return UM_OK;
}

enum um_status um_model_events(struct um_context *context, const struct um_model *model,
                               double from, double to, struct um_environment_event **out,
                               size_t *count)
{
  struct event_source source = {context, model};
  *out = NULL;
  *count = 0;
  if (model->environment.shadow == UM_SHADOW_NONE) return UM_OK;
  return um_environment_events_find(context, &model->environment, event_geometry, &source, from, to,
                                    30.0, out, count);
}
