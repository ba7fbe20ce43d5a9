/* Who looks from where: the observer, and the other stations that measurements may name. */
#include "model/build/steps_impl.h"

#include <string.h>

#include "base/core/constants.h"
#include "model/scenario/fail_group.h"

void um_model_station_place(const struct um_scenario_station *from, struct um_orbit_observer *to)
{
  to->kind = UM_OBSERVER_STATION;
  to->latitude = from->latitude_deg * UM_DEG;
  to->longitude = from->longitude_deg * UM_DEG;
  to->height = from->height_m;
}

static enum um_status check_name(struct um_context *context,
                                 const struct um_scenario_observer *observer,
                                 const struct um_scenario_station *station)
{
  const char *own = observer->station->name;
  const struct um_scenario_station *other = observer->stations.items;
  if (station->name == NULL)
    return um_model_fail(context, &station->at, NULL,
                         "has no name; accepted: the one that measurements use");
  bool taken = own != NULL && strcmp(station->name, own) == 0;
  for (; other != station; other++) taken = taken || strcmp(station->name, other->name) == 0;
  if (taken)
    return um_model_fail(context, &station->at, "name", "'%s' is taken; accepted: names used once",
                         station->name);
  return UM_OK;
}

enum um_status um_model_build_stations(struct um_context *context, struct um_model *model)
{
  const struct um_scenario_observer *observer = model->scenario->observer;
  if (!model->has_observer) return UM_OK;
  const struct um_scenario_station *station = observer->stations.items;
  size_t n = observer->stations.count;
  if (n > 0 && model->observer.kind != UM_OBSERVER_STATION)
    return um_model_fail(context, &observer->at, "stations",
                         "stands beside an observer that is no station; accepted: with "
                         "observer.station");
  UM_TRY(um_core_allocate(context, n + 1, sizeof *model->station, &model->station));
  model->station[model->nstation++] = model->observer;
  for (size_t i = 0; i < n; i++) {
    UM_TRY(check_name(context, observer, &station[i]));
    model->station[model->nstation] = model->observer;
    um_model_station_place(&station[i], &model->station[model->nstation++]);
  }
  return UM_OK;
}
