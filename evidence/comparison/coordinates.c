/* Coordinates of observations. */
#include "evidence/comparison/coordinates.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "orbit/sun.h"

#define CAPACITY 32 /* before the materials */

static enum um_status add(struct um_context *context, struct um_compare_coordinates *c,
                          const char *before, const char *name, const char *behind, double **out)
{
  struct um_compare_coordinate *to = &c->coordinate[c->count];
  c->count++;
  UM_TRY(um_core_asprintf(context, &to->name, "%s%s%s", before, name, behind));
  UM_TRY(um_core_allocate(context, c->nobs, sizeof *to->value, &to->value));
  *out = to->value;
  return UM_OK;
}

/* The instant nearest mid-exposure. */
static size_t middle(const struct um_model_tables *tables, size_t k)
{
  return k * tables->nsub + tables->nsub / 2;
}

/* --- observer -------------------------------------------------------------------------------- */

static double moon_separation(const struct um_environment_sample *s)
{
  struct um_vec3 place = um_vec3_add(s->r, um_vec3_scale(s->to_observer, s->range));
  struct um_vec3 moon = um_vec3_sub(um_orbit_moon_position(s->t_tai), place);
  return um_vec3_angle(moon, um_vec3_scale(s->to_observer, -1.0));
}

static enum um_status add_sky(struct um_context *context, const struct um_model *model,
                              const struct um_model_tables *tables,
                              struct um_compare_coordinates *c)
{
  double *phase, *range, *moon, *azimuth, *elevation, *airmass, *sun;
  bool station = model->observer.kind == UM_OBSERVER_STATION;
  UM_TRY(add(context, c, "", "phase_angle_deg", "", &phase));
  for (size_t k = 0; k < tables->nobs; k++) {
    const struct um_environment_sample *s = &tables->sample[middle(tables, k)];
    phase[k] = um_vec3_angle(s->sun, s->to_observer) / UM_DEG;
  }
  if (model->observer.kind == UM_OBSERVER_DIRECTION) return UM_OK;
  UM_TRY(add(context, c, "", "range_km", "", &range));
  UM_TRY(add(context, c, "", "moon_separation_deg", "", &moon));
  for (size_t k = 0; k < tables->nobs; k++) {
    const struct um_environment_sample *s = &tables->sample[middle(tables, k)];
    range[k] = 1e-3 * s->range;
    moon[k] = moon_separation(s) / UM_DEG;
  }
  if (!station) return UM_OK;
  UM_TRY(add(context, c, "", "azimuth_deg", "", &azimuth));
  UM_TRY(add(context, c, "", "elevation_deg", "", &elevation));
  UM_TRY(add(context, c, "", "airmass", "", &airmass));
  UM_TRY(add(context, c, "", "sun_elevation_deg", "", &sun));
  for (size_t k = 0; k < tables->nobs; k++) {
    const struct um_orbit_look *look = &tables->look[middle(tables, k)];
    azimuth[k] = look->azimuth / UM_DEG;
    elevation[k] = look->elevation / UM_DEG;
    airmass[k] = um_environment_airmass_toward(look->elevation);
    sun[k] = look->sun_elevation / UM_DEG;
  }
  return UM_OK;
}

/* --- light ----------------------------------------------------------------------------------- */

/* Since the last event of a kind. */
static double since(const struct um_model_tables *tables, double t,
                    enum um_environment_event_kind kind)
{
  double last = NAN;
  for (size_t i = 0; i < tables->nevent && tables->event[i].t_tai <= t; i++)
    if (tables->event[i].kind == kind) last = tables->event[i].t_tai;
  return t - last;
}

static enum um_status add_light(struct um_context *context, const struct um_model_tables *tables,
                                struct um_compare_coordinates *c)
{
  double *sunlit, *entry, *leave;
  UM_TRY(add(context, c, "", "sunlit_fraction", "", &sunlit));
  UM_TRY(add(context, c, "", "since_shadow_entry_s", "", &entry));
  UM_TRY(add(context, c, "", "since_shadow_exit_s", "", &leave));
  for (size_t k = 0; k < tables->nobs; k++) {
    double t = tables->sample[middle(tables, k)].t_tai;
    sunlit[k] = tables->sunlit[k];
    entry[k] = since(tables, t, UM_EVENT_HALF_ENTRY);
    leave[k] = since(tables, t, UM_EVENT_HALF_EXIT);
  }
  return UM_OK;
}

/* --- attitude -------------------------------------------------------------------------------- */

/* frac((t - at) / period + phase / 360 deg) of the law that holds at t; NaN when it is no spin. */
static double spin_phase(const struct um_scenario *scenario, double t)
{
  const struct um_scenario_attitude *laws = scenario->attitude.items;
  struct um_scenario_turn turn = {.at = NAN};
  bool turns_now = false;
  for (size_t i = 0; i < scenario->attitude.count; i++)
    if (i == 0 || t >= laws[i].from) turns_now = um_scenario_turn(&laws[i], &turn);
  if (!turns_now) return NAN;
  double at = isnan(turn.at) ? scenario->time->start : turn.at;
  double turns = (t - at) / turn.period_s + turn.phase_deg / 360.0;
  turns -= floor(turns);
  return turns < 1.0 ? turns : 0.0;
}

static enum um_status add_spin(struct um_context *context, const struct um_model *model,
                               const struct um_model_tables *tables,
                               struct um_compare_coordinates *c)
{
  const struct um_scenario_attitude *laws = model->scenario->attitude.items;
  struct um_scenario_turn turn;
  bool spins = false;
  double *phase;
  for (size_t i = 0; i < model->scenario->attitude.count; i++)
    spins = spins || um_scenario_turn(&laws[i], &turn);
  if (!spins) return UM_OK;
  UM_TRY(add(context, c, "", "spin_phase", "", &phase));
  c->coordinate[c->count - 1].circular = true;
  for (size_t k = 0; k < tables->nobs; k++)
    phase[k] = spin_phase(model->scenario, tables->sample[middle(tables, k)].t_tai);
  return UM_OK;
}

/* --- loads ----------------------------------------------------------------------------------- */

/* Area-weighted mean of a load over the surfaces of a material, or of all with UINT32_MAX. */
static double mean_load(const struct um_geometry_mesh *mesh, uint32_t material, const float *load)
{
  double sum = 0.0, area = 0.0;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    if (material != UINT32_MAX && mesh->surface[s].material != material) continue;
    double a = mesh->area[mesh->surface[s].facet];
    sum += a * (double)load[s];
    area += a;
  }
  return sum / area;
}

static enum um_status add_loads(struct um_context *context, const struct um_model *model,
                                const struct um_model_tables *tables,
                                struct um_compare_coordinates *c)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  const struct um_irradiation_loads *loads = tables->seen;
  double *albedo, *view, *sun;
  UM_TRY(add(context, c, "", "albedo_W_m2", "", &albedo));
  UM_TRY(add(context, c, "", "earth_view", "", &view));
  for (size_t k = 0; k < tables->nobs; k++) {
    size_t at = tables->load_row[middle(tables, k)] * loads->nsurface;
    albedo[k] = mean_load(mesh, UINT32_MAX, loads->albedo + at);
    view[k] = mean_load(mesh, UINT32_MAX, loads->view_factor + at);
  }
  for (uint32_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    UM_TRY(
        add(context, c, "sun_on.", um_geometry_material_name(model->geometry, m), "_W_m2", &sun));
    for (size_t k = 0; k < tables->nobs; k++) {
      size_t row = tables->load_row[middle(tables, k)];
      sun[k] = loads->sunlit[row] * loads->irradiance[row] *
               mean_load(mesh, m, loads->sun + row * loads->nsurface);
    }
  }
  return UM_OK;
}

enum um_status um_compare_coordinates_create(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             struct um_compare_coordinates **out)
{
  struct um_compare_coordinates *c = NULL;
  enum um_status status;
  double *time;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *c, &c));
  c->nobs = tables->nobs;
  UM_CHECK(um_core_allocate(context, CAPACITY + um_geometry_material_count(model->geometry),
                            sizeof *c->coordinate, &c->coordinate));
  UM_CHECK(add(context, c, "", "time_s", "", &time));
  for (size_t k = 0; k < tables->nobs; k++) time[k] = tables->t_obs[k] - tables->t_obs[0];
  if (model->has_observer) UM_CHECK(add_sky(context, model, tables, c));
  UM_CHECK(add_light(context, tables, c));
  UM_CHECK(add_spin(context, model, tables, c));
  UM_CHECK(add_loads(context, model, tables, c));
  *out = c;
  c = NULL;
done:
  um_compare_coordinates_destroy(context, &c);
  return status;
}

void um_compare_coordinates_destroy(struct um_context *context,
                                    struct um_compare_coordinates **coordinates)
{
  if (coordinates == NULL || *coordinates == NULL) return;
  struct um_compare_coordinates *c = *coordinates;
  for (size_t i = 0; i < c->count; i++) {
    UM_FREE(context, c->coordinate[i].name, c->coordinate[i].value);
  }
  UM_FREE(context, c->coordinate, c);
  *coordinates = NULL;
}
