/* Sunlit, penumbra, umbra from the sunlit fraction by the limits of base/core/constants.h; rising
 * and setting from the sign of the elevation's central difference. */
#include "evidence/comparison/segments.h"

#include "base/core/constants.h"

#define HALF_STEP 0.5 /* of the difference [s] */
#define LIGHT     1.0 /* longest light time that is allowed for where an orbit ends [s] */

static const char *const names[UM_SEGMENT_COUNT] = {[UM_SEGMENT_SUNLIT] = "sunlit",
                                                    [UM_SEGMENT_PENUMBRA] = "penumbra",
                                                    [UM_SEGMENT_UMBRA] = "umbra",
                                                    [UM_SEGMENT_RISING] = "rising",
                                                    [UM_SEGMENT_SETTING] = "setting"};

const char *um_compare_segment_name(enum um_compare_segment segment)
{
  return (unsigned)segment < UM_SEGMENT_COUNT ? names[segment] : "";
}

static enum um_compare_segment light_of(const struct um_model_tables *tables, size_t k)
{
  size_t full = 0, none = 0;
  for (size_t i = k * tables->nsub; i < (k + 1) * tables->nsub; i++) {
    if (tables->sample[i].sunlit_fraction >= UM_SUNLIGHT_LEAST) full++;
    if (tables->sample[i].sunlit_fraction <= UM_UMBRA_MOST) none++;
  }
  if (full == tables->nsub) return UM_SEGMENT_SUNLIT;
  return none == tables->nsub ? UM_SEGMENT_UMBRA : UM_SEGMENT_PENUMBRA;
}

/* The difference is one-sided where the orbit ends. */
static enum um_status motion_of(struct um_context *context, const struct um_model *model,
                                size_t station, double t, enum um_compare_segment *out)
{
  double first, last;
  struct um_orbit_look before, after;
  um_orbit_trajectory_span(model->trajectory, &first, &last);
  double from = t - HALF_STEP - LIGHT < first ? t : t - HALF_STEP;
  double to = t + HALF_STEP > last ? t : t + HALF_STEP;
  const struct um_orbit_observer *observer = &model->station[station];
  UM_TRY(um_orbit_observer_look(context, observer, model->trajectory, from, &before));
  UM_TRY(um_orbit_observer_look(context, observer, model->trajectory, to, &after));
  *out = after.elevation > before.elevation ? UM_SEGMENT_RISING : UM_SEGMENT_SETTING;
  return UM_OK;
}

enum um_status um_compare_segments_find(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        enum um_compare_segment *light,
                                        enum um_compare_segment *motion)
{
  bool station =
      !model->points && model->has_observer && model->observer.kind == UM_OBSERVER_STATION;
  for (size_t k = 0; k < tables->nobs; k++) {
    light[k] = light_of(tables, k);
    motion[k] = UM_SEGMENT_COUNT;
    if (station)
      UM_TRY(motion_of(context, model, um_model_tables_station(tables, k), tables->t_obs[k],
                       &motion[k]));
  }
  return UM_OK;
}
