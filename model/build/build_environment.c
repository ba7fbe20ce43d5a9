/* From the scenario's environment and effects to the configuration of Sun and Earth. */
#include "model/build/steps_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/daylight.h"
#include "environment/map.h"
#include "environment/shadow_light.h"
#include "environment/sky_table.h"
#include "environment/umbra_scatter.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"

/* Kilometres along the ground as an angle at the geocentre. */
static double ground_angle(const struct um_model *model, double km)
{
  return km * 1e3 / model->environment.earth_radius;
}

/* The part of the Earth that has a level of its own; without a statement it has none, and begins at
 * the start for the effects that give it one. */
static enum um_status build_region(struct um_context *context, struct um_model *model)
{
  const struct um_scenario_earth *earth = model->scenario->environment->earth;
  const struct um_scenario_region *from = earth != NULL ? earth->local : NULL;
  struct um_environment_region *to = &model->environment.region;
  double start = model->scenario->time->start;
  *to = (struct um_environment_region){.everywhere = true,
                                       .from_tai = start,
                                       .to_tai = INFINITY,
                                       .ramp = 60.0,
                                       .albedo_factor = 1.0,
                                       .longwave_factor = 1.0};
  if (from == NULL) return UM_OK;
  int stated = !isnan(from->latitude_deg) + !isnan(from->longitude_deg) + !isnan(from->radius_km);
  if (stated != 0 && stated != 3)
    return um_model_fail(
        context, &from->at, NULL,
        "has %d of latitude_deg, longitude_deg and radius_km; accepted: all three, "
        "or none for all of the Earth",
        stated);
  if (!isnan(from->from) && !isnan(from->to) && !(from->to > from->from))
    return um_model_fail(context, &from->at, "to_utc", "accepted: a time later than from_utc");
  to->everywhere = stated == 0;
  if (stated == 3) {
    to->latitude = from->latitude_deg * UM_DEG;
    to->longitude = from->longitude_deg * UM_DEG;
    to->radius = ground_angle(model, from->radius_km);
    to->edge = ground_angle(model, from->edge_km);
    to->from_tai = -INFINITY;
  }
  if (!isnan(from->from)) to->from_tai = from->from;
  if (!isnan(from->to)) to->to_tai = from->to;
  to->ramp = from->ramp_s;
  to->albedo_factor = from->albedo_factor;
  to->albedo_offset = from->albedo_offset;
  to->longwave_factor = from->olr_factor;
  to->longwave_offset = from->olr_offset_W_m2;
  to->brightness_shift = from->brightness_shift_K;
  return UM_OK;
}

/* The ground: which model, and its file, which a variant has from its origin. */
static enum um_status build_earth(struct um_context *context, struct um_model *model)
{
  static const char *const said[] = {"environment.earth", "time.start_utc", NULL};
  const struct um_scenario_earth *from = model->scenario->environment->earth;
  const char *path = NULL;
  UM_TRY(build_region(context, model));
  if (from == NULL) return UM_OK;
  if (from->file == NULL && model->environment.earth == UM_EARTH_MAP)
    return um_model_fail(context, &from->at, "model",
                         "map wants a file; accepted: file, a CSV or netCDF of monthly grids");
  if (um_model_origin_says(model, said)) {
    model->earth_map = model->origin->earth_map;
  } else if (from->file != NULL) {
    UM_TRY(um_model_resolve(context, model, &from->at, from->file, &path));
    UM_TRY(um_model_blame(
        context, &from->at, "file",
        um_environment_map_read(context, path, model->scenario->time->start, &model->earth_map)));
  }
  model->environment.map = model->earth_map;
  return UM_OK;
}

static double or_else(double value, double other) { return isnan(value) ? other : value; }

/* The air above the station; that of a file a variant has from its origin. */
static enum um_status build_sky(struct um_context *context, struct um_model *model)
{
  static const char *const said[] = {"observer.air", NULL};
  const struct um_scenario_observer *observer = model->scenario->observer;
  const struct um_scenario_air *from = observer != NULL ? observer->air : NULL;
  struct um_environment_clear_sky *to = &model->environment.sky;
  const char *path;
  if (from == NULL) return UM_OK;
  if (observer->station == NULL)
    return um_model_fail(context, &from->at, NULL,
                         "there is no air before an observer in space; accepted: a station");
  *to = um_environment_clear_sky_of((enum um_environment_sky_profile)from->profile,
                                    observer->station->height_m);
  to->on = true;
  to->temperature = or_else(from->temperature_K, to->temperature);
  to->water = or_else(from->water_mm, to->water);
  to->ozone_dobson = or_else(from->ozone_DU, to->ozone_dobson);
  to->aerosol = from->aerosol;
  to->angstrom = from->angstrom_exponent;
  to->cirrus = from->cirrus;
  to->cirrus_temperature = from->cirrus_temperature_K;
  if (um_model_origin_says(model, said)) {
    model->sky_table = model->origin->sky_table;
  } else if (from->file != NULL) {
    UM_TRY(um_model_resolve(context, model, &from->at, from->file, &path));
    UM_TRY(um_model_blame(context, &from->at, "file",
                          um_environment_sky_table_read(context, path, &model->sky_table)));
  }
  to->table = model->sky_table;
  return UM_OK;
}

/* The air of the Earth's limb, of the scenario's environment alone; an effect may want it that the
 * scenario withholds. */
static enum um_status build_limb(struct um_context *context, struct um_model *model)
{
  static const char *const said[] = {"environment", NULL};
  if (um_model_origin_says(model, said)) {
    model->limb = model->origin->limb;
  } else {
    UM_TRY(um_core_allocate(context, 1, sizeof *model->limb, &model->limb));
    um_environment_limb_make(&model->environment, model->limb);
  }
  model->environment.limb = model->limb;
  return UM_OK;
}

/* What the limb's air scatters into the shadow; a variant of the same air has it of its origin. */
static enum um_status build_umbra_scatter(struct um_context *context, struct um_model *model)
{
  struct um_environment *e = &model->environment;
  const struct um_model *of = model->origin;
  bool round = e->shadow == UM_SHADOW_SPHERE || e->shadow == UM_SHADOW_OBLATE;
  if (!e->shadow_refraction_on || !e->umbra_scatter_on || !round) return UM_OK;
  if (of != NULL && of->umbra_scatter != NULL && of->limb == model->limb &&
      um_environment_umbra_scatter_is_of(of->umbra_scatter, e))
    model->umbra_scatter = of->umbra_scatter;
  else
    UM_TRY(um_environment_umbra_scatter_make(context, e, &model->umbra_scatter));
  e->umbra_scatter = model->umbra_scatter;
  return UM_OK;
}

/* What the sunlit Earth reflects by angle, in a slot that a scenario shares with its variants. */
static enum um_status build_daylight(struct um_context *context, struct um_model *model)
{
  enum um_status status = UM_OK;
  const struct um_environment *e = &model->environment;
  if (e->earth == UM_EARTH_UNIFORM || !e->earth_anisotropy_on) return UM_OK;
  if (*model->daylight == NULL) status = um_environment_daylight_make(context, model->daylight);
  model->environment.daylight = *model->daylight;
  return status;
}

enum um_status um_model_build_environment(struct um_context *context, struct um_model *model)
{
  struct um_effect_use use;
  um_model_scenario_environment(model->scenario, &model->environment);
  UM_TRY(build_earth(context, model));
  UM_TRY(build_limb(context, model));
  UM_TRY(build_sky(context, model));
  model->sun_frozen = model->scenario->environment->sun == UM_SUN_FROZEN;
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    enum um_status (*turn)(struct um_context *, struct um_environment *) =
        e->off ? e->effect->switch_off : e->effect->switch_on;
    if (turn != NULL) UM_TRY(turn(context, &model->environment));
  }
  for (size_t i = 0; um_model_effect_next(model, &i, &use);) {
    if (use.effect->hooks.environment != NULL)
      UM_TRY(use.effect->hooks.environment(context, &use, &model->environment));
    if (use.effect->hooks.sky != NULL)
      UM_TRY(use.effect->hooks.sky(context, &use, &model->environment.sky));
  }
  UM_TRY(build_umbra_scatter(context, model));
  return build_daylight(context, model);
}
