/* A scenario without a track (orbit.points). What asks for a velocity or for heat that is followed
 * along an orbit is refused; the light of one instant, with Sun, shadow, attitude and the Earth
 * below, is all that such a scenario has. */
#include "model/build/steps_impl.h"

#include "model/scenario/fail_group.h"

#define ACCEPTED_LAWS                                                                              \
  "fixed, sun, target, yaw_steering, table, magnetic, spin with axis_gcrs or q_gcrs"

static enum um_status check_attitude(struct um_context *context, const struct um_schema_list *laws)
{
  const struct um_scenario_attitude *law = laws->items;
  for (size_t i = 0; i < laws->count; i++) {
    if (law[i].lvlh != NULL)
      return um_model_fail(context, &law[i].at, "lvlh",
                           "wants a velocity, which orbit.points does not know; "
                           "accepted: " ACCEPTED_LAWS);
    if (law[i].spin != NULL && law[i].spin->axis_lvlh.count > 0)
      return um_model_fail(context, &law[i].spin->at, "axis_lvlh",
                           "wants a velocity, which orbit.points does not know; "
                           "accepted: " ACCEPTED_LAWS);
  }
  return UM_OK;
}

enum um_status um_model_build_points(struct um_context *context, struct um_model *model)
{
  const struct um_scenario *scenario = model->scenario;
  const struct um_scenario_points *points = scenario->orbit->points;
  if (points == NULL) return UM_OK;
  model->points = true;
  if (!model->has_observer || model->observer.kind != UM_OBSERVER_STATION)
    return um_model_fail(context, &scenario->orbit->at, "points",
                         "wants the station that azimuths and elevations are of; accepted: "
                         "observer.station");
  if (scenario->thermal->start != UM_START_ISOTHERMAL)
    return um_model_fail(context, &scenario->thermal->at, "start",
                         "periodic wants an orbit, orbit.points has none; accepted: isothermal "
                         "(temperatures stay at start_temperature_K)");
  UM_TRY(check_attitude(context, &scenario->attitude));
  um_core_log(context, UM_LOG_INFO,
              "orbit: observations stand alone; heat is not followed, temperatures stay at "
              "thermal.start_temperature_K, %g K",
              scenario->thermal->start_temperature_K);
  return UM_OK;
}
