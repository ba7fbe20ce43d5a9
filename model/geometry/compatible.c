/* For which models geometry tables are valid: all that they were traced of is compared, so
 * that nobody has to know which key or effect changes what. */
#include "model/geometry/compatible.h"

#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "environment/map.h"
#include "environment/shadow_light.h"
#include "model/geometry/mirrors.h"
#include "model/geometry/points_impl.h"
#include "model/geometry/precompute.h"
#include "model/geometry/precompute_exchange_impl.h"
#include "model/geometry/precompute_group.h"
#include "model/geometry/precompute_loads_impl.h"
#include "model/geometry/thermal_equal_group.h"

static bool same(const void *a, const void *b, size_t count, size_t size)
{
  return count == 0 || memcmp(a, b, count * size) == 0;
}

static bool same_number(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

/* --- light ----------------------------------------------------------------------------------- */

static bool same_region(const struct um_environment_region *a,
                        const struct um_environment_region *b)
{
  return a->everywhere == b->everywhere && a->latitude == b->latitude &&
         a->longitude == b->longitude && a->radius == b->radius && a->edge == b->edge &&
         a->from_tai == b->from_tai && a->to_tai == b->to_tai && a->ramp == b->ramp &&
         a->albedo_factor == b->albedo_factor && a->albedo_offset == b->albedo_offset &&
         a->longwave_factor == b->longwave_factor && a->longwave_offset == b->longwave_offset &&
         a->brightness_shift == b->brightness_shift;
}

/* The same ground. A brightness temperature is of the light alone while it is one for all of the
 * Earth, unless nothing else of it shines, so that it decides whether the Earth is traced; where
 * places differ the geometry tables have it. */
static bool same_earth(const struct um_environment *a, const struct um_environment *b)
{
  if (um_irradiation_earth_shines(a) != um_irradiation_earth_shines(b)) return false;
  if (!um_environment_earth_varies(a) && !um_environment_earth_varies(b)) return true;
  return a->earth == b->earth &&
         um_environment_earth_is_spectral(a) == um_environment_earth_is_spectral(b) &&
         um_environment_earth_is_anisotropic(a) == um_environment_earth_is_anisotropic(b) &&
         um_environment_map_equal(a->map, b->map) && a->albedo_factor == b->albedo_factor &&
         a->longwave_factor == b->longwave_factor && a->brightness_shift == b->brightness_shift &&
         a->brightness_temperature == b->brightness_temperature &&
         same_region(&a->region, &b->region);
}

/* The same air over the limb. */
static bool same_limb(const struct um_environment_limb *a, const struct um_environment_limb *b)
{
  if (a == NULL || b == NULL || a == b) return a == b;
  return memcmp(a, b, sizeof *a) == 0; /* NOLINT: doubles alone */
}

/* The same air at the edge of the shadow. */
static bool same_air(const struct um_environment *a, const struct um_environment *b)
{
  if (a->shadow_refraction_on != b->shadow_refraction_on ||
      a->umbra_scatter_on != b->umbra_scatter_on)
    return false;
  if (!a->shadow_refraction_on && !a->umbra_scatter_on) return true;
  return a->air_factor == b->air_factor && same_number(a->ozone_dobson, b->ozone_dobson) &&
         a->ozone_factor == b->ozone_factor && a->haze == b->haze && a->aerosol == b->aerosol &&
         same_number(a->cloud_top, b->cloud_top) && a->cloud_shift == b->cloud_shift &&
         same_limb(a->limb, b->limb);
}

/* The same light but for its levels. Members of the environment that are neither here nor levels
 * act behind the geometry tables: each has its line in tests/model/geometry/compatible.c, which
 * does not compile where one has none. */
static bool same_but_levels(const struct um_model *made, const struct um_model *model)
{
  const struct um_environment *a = &made->environment, *b = &model->environment;
  return a->earth_radius == b->earth_radius && a->shadow == b->shadow &&
         a->shadow_radius == b->shadow_radius && a->disc == b->disc &&
         a->limb_darkening == b->limb_darkening && a->moonlight_on == b->moonlight_on &&
         a->gas_density_factor == b->gas_density_factor && same_air(a, b) && same_earth(a, b) &&
         (a->specular_exchange_on || !b->specular_exchange_on) && /* paths by mirrors are there */
         (um_model_loads_by_angle(made) || !um_model_loads_by_angle(model)); /* moments are */
}

bool um_model_light_is_compatible(const struct um_model *made, const struct um_model *model)
{
  const struct um_environment *a = &made->environment, *b = &model->environment;
  return a->solar_irradiance == b->solar_irradiance && a->albedo == b->albedo &&
         a->outgoing_longwave == b->outgoing_longwave && same_but_levels(made, model);
}

/* By how much the light of two models differs, if by nothing else. Of an Earth that differs from
 * place to place, by the Sun alone. */
static bool levels_find(const struct um_model *made, const struct um_model *model,
                        struct um_irradiation_levels *out)
{
  const struct um_environment *a = &made->environment, *b = &model->environment;
  bool same_places = a->albedo == b->albedo && a->outgoing_longwave == b->outgoing_longwave;
  bool varies = um_environment_earth_varies(a) || um_environment_earth_varies(b);
  if (!same_but_levels(made, model) || (varies && !same_places) || !(a->solar_irradiance > 0.0) ||
      !(a->albedo > 0.0) || !(a->outgoing_longwave > 0.0))
    return false;
  out->irradiance = b->solar_irradiance / a->solar_irradiance;
  out->albedo = out->irradiance * (b->albedo / a->albedo);
  out->planet = b->outgoing_longwave / a->outgoing_longwave;
  return true;
}

/* --- times and places ------------------------------------------------------------------------ */

static bool events_equal(const struct um_model_tables *a, const struct um_model_tables *b)
{
  if (a->nevent != b->nevent) return false;
  for (size_t i = 0; i < a->nevent; i++)
    if (a->event[i].t_tai != b->event[i].t_tai || a->event[i].kind != b->event[i].kind)
      return false;
  return true;
}

static bool sets_equal(const struct um_model_tables *a, const struct um_model_tables *b)
{
  if (a->set == NULL || b->set == NULL) return a->set == b->set;
  for (size_t k = 0; k < a->nobs; k++)
    if (!um_core_words_same(a->set[k], b->set[k])) return false;
  return true;
}

static bool stations_equal(const struct um_model_tables *a, const struct um_model_tables *b)
{
  for (size_t k = 0; k < a->nobs; k++)
    if (um_model_tables_station(a, k) != um_model_tables_station(b, k)) return false;
  return true;
}

/* The same observations. */
static bool observations_equal(const struct um_model_tables *a, const struct um_model_tables *b)
{
  size_t n = a->nobs * a->nsub;
  return a->nobs == b->nobs && a->nsub == b->nsub && a->t_first == b->t_first &&
         a->t_start == b->t_start && same(a->t_obs, b->t_obs, a->nobs, sizeof *a->t_obs) &&
         sets_equal(a, b) && stations_equal(a, b) && same(a->look, b->look, n, sizeof *a->look) &&
         same(a->sample, b->sample, n, sizeof *a->sample) &&
         same(a->hidden, b->hidden, a->nobs, sizeof *a->hidden);
}

/* The span of the heat and its grid, too. */
static bool plan_equal(const struct um_model_tables *a, const struct um_model_precompute_plan *p)
{
  const struct um_model_tables *b = p->tables;
  return observations_equal(a, b) && a->loads->ntime == p->ngrid &&
         same_number(a->period, b->period) && a->t_periodic_end == b->t_periodic_end &&
         a->spin_period == b->spin_period && a->sparse == b->sparse && events_equal(a, b) &&
         same(a->loads->t, p->grid, p->ngrid, sizeof *p->grid) && a->loads->nedge == b->nevent &&
         same(a->loads->edge, p->edge, b->nevent, sizeof *p->edge);
}

static enum um_status same_points(struct um_context *context, const struct um_model_tables *tables,
                                  const struct um_model_instants *instants,
                                  const struct um_model *model, bool *out)
{
  struct um_model_tables *plan = NULL;
  um_core_quiet_begin(context);
  enum um_status status = um_model_points_plan(context, model, instants, &plan);
  um_core_quiet_end(context);
  if (status == UM_OK) *out = observations_equal(tables, plan);
  um_model_tables_destroy(context, &plan);
  return status;
}

static enum um_status same_times(struct um_context *context, const struct um_model_tables *tables,
                                 const struct um_model_instants *instants,
                                 const struct um_model *model, bool *out)
{
  enum um_status status;
  struct um_model_precompute_plan plan = {0};
  um_core_quiet_begin(context);
  UM_CHECK(um_model_precompute_plan(context, model, instants, &plan));
  *out = plan_equal(tables, &plan);
done:
  um_core_quiet_end(context);
  um_model_precompute_plan_clear(context, &plan);
  return status;
}

/* The scene at the rows of the loads. */
static enum um_status same_scene(struct um_context *context, const struct um_model_tables *tables,
                                 const struct um_model *model, bool *out)
{
  const struct um_irradiation_loads *loads = tables->loads;
  struct um_environment_sample *sample = NULL;
  um_core_quiet_begin(context);
  enum um_status status = um_model_load_samples(context, model, loads->t, loads->ntime, &sample);
  um_core_quiet_end(context);
  if (status == UM_OK) *out = same(tables->load_sample, sample, loads->ntime, sizeof *sample);
  um_core_free(context, sample);
  return status;
}

/* --- rays ------------------------------------------------------------------------------------ */

/* Numbers of rays, seeds and files of what is traced. */
static bool options_equal(const struct um_model *a, const struct um_model *b)
{
  return a->scenario->optics->seed == b->scenario->optics->seed &&
         a->scenario->thermal->samples == b->scenario->thermal->samples &&
         um_model_exchange_options_equal(a, b);
}

/* Looked at as finely as the model would be over the instants. */
static bool sampling_is_compatible(const struct um_model_tables *tables,
                                   const struct um_model_instants *instants,
                                   const struct um_model *model)
{
  const struct um_scenario_optics *optics = model->scenario->optics;
  struct um_model_sampling asked = {0, 0};
  if (instants != NULL) asked = instants->sampling;
  if (asked.samples == 0) asked.samples = optics->samples;
  if (optics->interreflection_samples <= 0) asked.paths = 0;
  return tables->sampling.samples == asked.samples && tables->sampling.paths == asked.paths;
}

/* A sky for both, or for neither. */
static bool skies_equal(const struct um_model *a, const struct um_model *b)
{
  return um_irradiation_wants_sky(a->geometry, &a->environment) ==
         um_irradiation_wants_sky(b->geometry, &b->environment);
}

enum um_status um_model_body_is_compatible(struct um_context *context, const struct um_model *made,
                                           const struct um_model *model, bool *out)
{
  *out = um_geometry_equal(made->geometry, model->geometry) && made->points == model->points &&
         !um_geometry_joint_moves(model->geometry) && skies_equal(made, model) &&
         um_model_exchange_options_equal(made, model);
  return *out ? um_model_mirror_classes_are_compatible(context, made, model, out) : UM_OK;
}

/* The same body, times and places. */
static enum um_status same_but_light(struct um_context *context, const struct um_model *made,
                                     const struct um_model_tables *tables,
                                     const struct um_model_instants *instants,
                                     const struct um_model *model, bool *out)
{
  *out = made->points == model->points && made->has_observer == model->has_observer &&
         um_geometry_equal(made->geometry, model->geometry) && options_equal(made, model);
  if (*out && model->points) return same_points(context, tables, instants, model, out);
  if (*out) UM_TRY(um_model_mirror_classes_are_compatible(context, made, model, out));
  if (*out) UM_TRY(same_times(context, tables, instants, model, out));
  if (*out) UM_TRY(same_scene(context, tables, model, out));
  return UM_OK;
}

enum um_status um_model_tables_are_compatible(struct um_context *context,
                                              const struct um_model *made,
                                              const struct um_model_tables *tables,
                                              const struct um_model_instants *instants,
                                              const struct um_model *model, bool *out)
{
  *out =
      sampling_is_compatible(tables, instants, model) && um_model_light_is_compatible(made, model);
  return *out ? same_but_light(context, made, tables, instants, model, out) : UM_OK;
}

enum um_status um_model_loads_are_proportional(struct um_context *context,
                                               const struct um_model *made,
                                               const struct um_model_tables *tables,
                                               const struct um_model_instants *instants,
                                               const struct um_model *model,
                                               struct um_irradiation_levels *levels, bool *out)
{
  *out = !model->points && levels_find(made, model, levels);
  return *out ? same_but_light(context, made, tables, instants, model, out) : UM_OK;
}
