/* Attitude laws of a scenario, and the slews between them. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"
#include "model/build/timeline.h"
#include "orbit/attitude.h"

/* A NUMBERS value that must have exactly n elements. */
static enum um_status exact_numbers(struct um_context *context, const struct um_mark *at,
                                    const char *key, const struct um_schema_list *list, size_t n)
{
  if (list->count == n) return UM_OK;
  return um_model_fail(context, at, key, "has %zu numbers; accepted: %zu", list->count, n);
}

static enum um_status quaternion_of(struct um_context *context, const struct um_mark *at,
                                    const double v[4], struct um_quat *out)
{
  double norm = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
  if (!(fabs(norm - 1.0) < 1e-3))
    return um_model_fail(context, at, "q_gcrs", "has the norm %.6g; accepted: 1 within 0.001",
                         norm);
  *out = um_quat_normalize((struct um_quat){v[0], v[1], v[2], v[3]});
  return UM_OK;
}

static enum um_status law_of_spin(struct um_context *context, const struct um_model *model,
                                  const struct um_scenario_spin *spin,
                                  struct um_orbit_attitude_law *law)
{
  law->kind = UM_ATTITUDE_SPIN;
  law->period = spin->period_s;
  law->phase = spin->phase_deg * UM_DEG;
  law->at_tai = isnan(spin->at_utc) ? model->scenario->time->start : spin->at_utc;
  law->nutation[0] = spin->nutation_deg * UM_DEG * cos(spin->nutation_phase_deg * UM_DEG);
  law->nutation[1] = spin->nutation_deg * UM_DEG * sin(spin->nutation_phase_deg * UM_DEG);
  law->inertia_ratio = spin->inertia_ratio;
  UM_TRY(um_model_unit(context, &spin->at, "axis_body", spin->axis_body, &law->axis_body));
  if (spin->q_gcrs.count > 0) {
    UM_TRY(exact_numbers(context, &spin->at, "q_gcrs", &spin->q_gcrs, 4));
    law->axis_frame = UM_AXIS_BODY;
    law->axis = law->axis_body;
    return quaternion_of(context, &spin->at, spin->q_gcrs.items, &law->q);
  }
  bool lvlh = spin->axis_lvlh.count > 0;
  const struct um_schema_list *axis = lvlh ? &spin->axis_lvlh : &spin->axis_gcrs;
  const char *key = lvlh ? "axis_lvlh" : "axis_gcrs";
  law->axis_frame = lvlh ? UM_AXIS_LVLH : UM_AXIS_GCRS;
  UM_TRY(exact_numbers(context, &spin->at, key, axis, 3));
  return um_model_unit(context, &spin->at, key, axis->items, &law->axis);
}

static enum um_status law_of_magnet(struct um_context *context, const struct um_model *model,
                                    const struct um_scenario_magnetic *magnet,
                                    struct um_orbit_attitude_law *law)
{
  struct um_vec3 other;
  law->kind = UM_ATTITUDE_MAGNETIC;
  law->period = magnet->period_s;
  law->phase = magnet->phase_deg * UM_DEG;
  law->at_tai = isnan(magnet->at_utc) ? model->scenario->time->start : magnet->at_utc;
  UM_TRY(um_model_unit(context, &magnet->at, "axis_body", magnet->axis_body, &law->axis_body));
  um_core_vec3_frame(law->axis_body, &law->clock_body, &other);
  if (magnet->clock_body.count == 0) return UM_OK;
  UM_TRY(exact_numbers(context, &magnet->at, "clock_body", &magnet->clock_body, 3));
  return um_model_unit(context, &magnet->at, "clock_body", magnet->clock_body.items,
                       &law->clock_body);
}

static enum um_status law_of_tumble(struct um_context *context, const struct um_model *model,
                                    const struct um_scenario_tumble *tumble,
                                    struct um_orbit_attitude_law *law)
{
  const struct um_schema_list *inertia = &tumble->inertia;
  const double *of = inertia->items, *rate = tumble->rates_deg_s;
  law->kind = UM_ATTITUDE_TUMBLE;
  law->at_tai = isnan(tumble->at_utc) ? model->scenario->time->start : tumble->at_utc;
  law->rate = um_vec3(rate[0] * UM_DEG, rate[1] * UM_DEG, rate[2] * UM_DEG);
  if (inertia->count != 3 && inertia->count != 6)
    return um_model_fail(context, &tumble->at, "inertia_kg_m2", "has %zu numbers; accepted: 3 or 6",
                         inertia->count);
  for (size_t k = 0; k < inertia->count; k++) law->inertia[k] = of[k];
  return quaternion_of(context, &tumble->at, tumble->q_gcrs, &law->q);
}

static enum um_status slew_of(struct um_context *context, const struct um_scenario_slew *slew,
                              bool first, struct um_orbit_attitude_law *law)
{
  bool bound = !isnan(slew->rate_deg_s) && !isnan(slew->acceleration_deg_s2);
  bool half = !isnan(slew->rate_deg_s) || !isnan(slew->acceleration_deg_s2);
  if (first)
    return um_model_fail(context, &slew->at, NULL,
                         "the first law has none before it; accepted: a slew to a later law");
  if (isnan(slew->duration_s) ? !bound : half)
    return um_model_fail(context, &slew->at, NULL,
                         "accepted: either duration_s, or rate_deg_s and acceleration_deg_s2");
  law->slew_duration = slew->duration_s;
  law->slew_rate = slew->rate_deg_s * UM_DEG;
  law->slew_acceleration = slew->acceleration_deg_s2 * UM_DEG;
  return UM_OK;
}

static enum um_status law_of(struct um_context *context, struct um_model *model,
                             const struct um_scenario_attitude *from,
                             struct um_orbit_attitude_law *law)
{
  law->from_tai = isnan(from->from) ? -INFINITY : from->from;
  if (from->fixed != NULL) {
    law->kind = UM_ATTITUDE_FIXED;
    return quaternion_of(context, &from->fixed->at, from->fixed->q_gcrs, &law->q);
  }
  if (from->lvlh != NULL) {
    law->kind = UM_ATTITUDE_LVLH;
    law->roll = from->lvlh->roll_deg * UM_DEG;
    law->pitch = from->lvlh->pitch_deg * UM_DEG;
    law->yaw = from->lvlh->yaw_deg * UM_DEG;
    return UM_OK;
  }
  const struct um_scenario_pointing *pointing = from->sun;
  law->kind = UM_ATTITUDE_SUN;
  if (from->target != NULL) {
    pointing = from->target;
    law->kind = UM_ATTITUDE_TARGET;
  } else if (from->yaw_steering != NULL) {
    pointing = from->yaw_steering;
    law->kind = UM_ATTITUDE_YAW_STEERING;
  }
  if (pointing != NULL) {
    const struct um_mark *at = &pointing->at;
    UM_TRY(um_model_unit(context, at, "axis_body", pointing->axis_body, &law->axis_body));
    return um_model_unit(context, at, "clock_body", pointing->clock_body, &law->clock_body);
  }
  if (from->spin != NULL) return law_of_spin(context, model, from->spin, law);
  if (from->magnetic != NULL) return law_of_magnet(context, model, from->magnetic, law);
  if (from->tumble != NULL) return law_of_tumble(context, model, from->tumble, law);
  law->kind = UM_ATTITUDE_TABLE;
  law->max_gap = from->table->max_gap_s;
  law->orientation = &model->orientation;
  return um_model_resolve(context, model, &from->table->at, from->table->file, &law->table_path);
}

/* The law is that whose table the message begins with, or the only one; else the first. */
static enum um_status blame_law(struct um_context *context, const struct um_scenario_attitude *from,
                                const struct um_orbit_attitude_law *laws, size_t n,
                                enum um_status status)
{
  for (size_t i = 0; i < n; i++) {
    const char *path = laws[i].table_path;
    if (laws[i].kind == UM_ATTITUDE_TABLE &&
        strncmp(um_core_message(context), path, strlen(path)) == 0)
      return um_model_blame(context, &from[i].table->at, NULL, status);
  }
  return um_model_blame(context, &from[0].at, NULL, status);
}

enum um_status um_model_build_attitude(struct um_context *context, struct um_model *model)
{
  const struct um_schema_list *list = &model->scenario->attitude;
  const struct um_scenario_attitude *from = list->items;
  enum um_status status = UM_OK;
  struct um_orbit_attitude_law *laws = NULL;
  struct um_effect_use use;
  if (list->count == 0)
    return um_model_fail(context, &model->scenario->at, "attitude",
                         "is empty; accepted: one law or more");
  UM_TRY(um_core_allocate(context, list->count, sizeof *laws, &laws));
  for (size_t i = 0; i < list->count; i++) {
    UM_CHECK(law_of(context, model, &from[i], &laws[i]));
    if (from[i].slew != NULL) UM_CHECK(slew_of(context, from[i].slew, i == 0, &laws[i]));
    for (size_t k = 0; um_model_effect_next(model, &k, &use);)
      if (use.effect->hooks.law != NULL) UM_CHECK(use.effect->hooks.law(context, &use, &laws[i]));
    model->nutates = model->nutates || laws[i].nutation[0] != 0.0 || laws[i].nutation[1] != 0.0;
    model->points_at_observer = model->points_at_observer || from[i].target != NULL;
    if (i > 0 && !(laws[i].from_tai > laws[i - 1].from_tai)) {
      status = um_model_fail(context, &from[i].at, "from_utc",
                             "accepted: a time later than that of the law before it");
      goto done;
    }
  }
  status = um_orbit_attitude_create(context, laws, list->count, &model->attitude);
  if (status != UM_OK) status = blame_law(context, from, laws, list->count, status);
done:
  um_core_free(context, laws);
  return status;
}

enum um_status um_model_build_slews(struct um_context *context, struct um_model *model)
{
  const struct um_schema_list *list = &model->scenario->attitude;
  const struct um_scenario_attitude *from = list->items;
  for (size_t i = 1; i < list->count; i++) {
    struct um_orbit_attitude_input in;
    if (from[i].slew == NULL) continue;
    UM_TRY(um_model_blame(context, &from[i].slew->at, NULL,
                          um_model_attitude_input(context, model, from[i].from, &in)));
    UM_TRY(um_model_blame(context, &from[i].slew->at, NULL,
                          um_orbit_attitude_slew(context, model->attitude, i, &in)));
  }
  return UM_OK;
}
