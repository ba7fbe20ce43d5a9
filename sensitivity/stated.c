/* What a scenario states, read from its model: environment, records of materials, the heat network,
 * the scenario's own numbers. A change x of a parameter makes the whole
 *
 *   w + x - x_0,   w x / x_0,   w (1 + x) / (1 + x_0),
 *
 * as the effect adds, scales or stretches, x_0 being its value in the scenario. */
#include "sensitivity/stated.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"

#define VISIBLE 0.55e-6 /* wavelength that reflectances are said at [m] */
#define CELLS   0.5     /* solar absorptance below which a side is no solar cell */
#define SAMPLES 16      /* wavelengths of a band */

/* Who is asked about what. */
struct question {
  const struct um_sensitivity_forward *forward;
  const struct um_model *model;
  const struct um_effect *effect;
  const char *target;
};

static void say(struct um_sensitivity_stated *out, const char *what, const char *unit, double value)
{
  out->what = what;
  out->unit = unit;
  out->value = value;
}

/* ---- materials ---- */

static double band_emissivity(const struct um_model *model, size_t m)
{
  for (size_t b = 0; b < model->nband; b++) {
    double from = model->band[b].from, step = (model->band[b].to - from) / SAMPLES, sum = 0.0;
    if (from < UM_INFRARED_FROM) continue;
    for (int i = 0; i < SAMPLES; i++)
      sum += 1.0 - um_materials_hemispherical_reflectance(model->material[m], &model->adjustment[m],
                                                          from + (i + 0.5) * step);
    return sum / SAMPLES;
  }
  return NAN;
}

static void of_material(const struct question *q, enum um_effect_stated which,
                        struct um_sensitivity_stated *out)
{
  size_t m = 0, n = um_geometry_material_count(q->model->geometry);
  if (q->target == NULL) return;
  while (m < n && strcmp(um_geometry_material_name(q->model->geometry, m), q->target) != 0) m++;
  if (m == n) return;
  const struct um_materials_record *record = q->model->material[m];
  const struct um_materials_adjustment *adjustment = &q->model->adjustment[m];
  out->minimum = 0.0;
  out->maximum = 1.0;
  if (which == UM_STATED_ABSORPTANCE)
    say(out, "solar absorptance", "1", um_materials_solar_absorptance(record, adjustment));
  if (which == UM_STATED_EMITTANCE)
    say(out, "emittance", "1",
        um_materials_emittance(record, adjustment, UM_REFERENCE_TEMPERATURE));
  if (which == UM_STATED_BAND_EMISSIVITY)
    say(out, "emissivity in the infrared band", "1", band_emissivity(q->model, m));
  if (which == UM_STATED_DIFFUSE_REFLECTANCE)
    say(out, "diffuse reflectance at 0.55 um", "1",
        um_materials_diffuse_reflectance(record, adjustment, VISIBLE));
  if (which == UM_STATED_SPECULAR_REFLECTANCE && um_materials_has_lobe(record))
    say(out, "specular reflectance at 0.55 um", "1",
        um_materials_specular_reflectance(record, adjustment, VISIBLE, 1.0));
  if (which != UM_STATED_ROUGHNESS || !um_materials_has_lobe(record)) return;
  out->maximum = INFINITY;
  say(out, "alpha of the lobe", "1", um_materials_roughness(record, adjustment));
}

/* ---- parts ---- */

/* Is the facet of what the target names: a part, its front, one of its groups? */
static bool is_of(const struct question *q, size_t facet)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(q->model->geometry);
  const struct um_effect_use use = {.effect = q->effect, .target = q->target};
  const char *part = um_geometry_part_name(q->model->geometry, mesh->facet_part[facet]);
  const char *group = um_geometry_group(q->model->geometry, mesh->facet_group[facet])->name;
  return um_effect_acts_on_group(&use, part, group) || um_effect_acts_on_group(&use, part, "front");
}

/* Fronts of a target: least and most of what they extract, most of what they absorb; false: none.
 */
static bool fronts(const struct question *q, double *least, double *most, double *absorbed)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(q->model->geometry);
  *least = INFINITY;
  *most = *absorbed = 0.0;
  for (size_t f = 0; f < mesh->nfacet; f++) {
    const struct um_thermal_surface *surface;
    if (mesh->surface_of_front[f] == UM_GEOMETRY_NONE || !is_of(q, f)) continue;
    surface = um_thermal_network_surface(q->model->body->network, mesh->surface_of_front[f]);
    if (surface == NULL) continue;
    *least = fmin(*least, surface->extraction);
    *most = fmax(*most, surface->extraction);
    *absorbed = fmax(*absorbed, surface->absorptance);
  }
  return isfinite(*least);
}

static void of_extraction(const struct question *q, struct um_sensitivity_stated *out)
{
  double least, most, absorbed;
  if (q->model->body == NULL || !fronts(q, &least, &most, &absorbed)) return;
  say(out, "electrical extraction", "1", most);
  out->minimum = most - least; /* the side that gives least gives nothing then */
  out->maximum = absorbed;
}

/* The part of a target "part", "part.group" or "part.NAME" of an interior; *group: of the
 * scenario's own groups, or NULL. */
static const struct um_scenario_part *part_named(const struct question *q,
                                                 const struct um_scenario_group **group)
{
  const struct um_scenario_part *part = q->model->scenario->parts.items;
  *group = NULL;
  for (size_t i = 0; q->target != NULL && i < q->model->scenario->parts.count; i++) {
    size_t n = strlen(part[i].name);
    const struct um_scenario_group *own = part[i].groups.items;
    if (strncmp(part[i].name, q->target, n) != 0) continue;
    if (q->target[n] == '\0') return &part[i];
    if (q->target[n] != '.') continue;
    for (size_t k = 0; k < part[i].groups.count; k++)
      if (strcmp(own[k].name, q->target + n + 1) == 0) *group = &own[k];
    return &part[i];
  }
  return NULL;
}

/* Walls and blankets as the scenario states them, times the factor that its effects list. */
static void of_wall(const struct question *q, enum um_effect_stated which,
                    struct um_sensitivity_stated *out)
{
  const struct um_scenario_group *group;
  const struct um_scenario_part *part = part_named(q, &group);
  if (part == NULL) return;
  const struct um_scenario_shell *wall =
      group != NULL && group->shell != NULL ? group->shell : part->shell;
  const struct um_scenario_mli *mli = group != NULL && group->mli != NULL ? group->mli : part->mli;
  if (group != NULL && group->mli == NULL && group->bare) mli = NULL;
  out->minimum = 0.0;
  if (which == UM_STATED_MLI_EMITTANCE && mli != NULL) {
    say(out, "effective emittance of the MLI", "1", mli->effective_emittance * out->null_value);
    out->maximum = 1.0;
  }
  if (which == UM_STATED_HEAT_CAPACITY && wall != NULL)
    say(out, "heat capacity of the wall", "J/m^2/K",
        wall->areal_heat_capacity_J_m2_K * out->null_value);
  if (which == UM_STATED_THROUGH_CONDUCTANCE && wall != NULL)
    say(out, "conductance through the wall", "W/m^2/K",
        wall->through_conductance_W_m2_K * out->null_value);
}

/* The most creased group of a target leads: a flatter one has no less than none. */
static void of_creases(const struct question *q, struct um_sensitivity_stated *out)
{
  const struct um_geometry *g = q->model->geometry;
  const struct um_effect_use use = {.effect = q->effect, .target = q->target};
  double most = 0.0;
  for (size_t k = 0; k < um_geometry_group_count(g); k++) {
    const struct um_geometry_group *group = um_geometry_group(g, (uint32_t)k);
    if (um_effect_acts_on_group(&use, um_geometry_part_name(g, group->part), group->name))
      most = fmax(most, q->model->creasing[k].tilt_square);
  }
  say(out, "mean square of the creases' tilt", "deg^2", most / (UM_DEG * UM_DEG));
  out->minimum = 0.0;
}

/* Where there is one contact: what it conducts. */
static void of_contact(const struct question *q, struct um_sensitivity_stated *out)
{
  const struct um_scenario_contact *contact = q->model->scenario->contacts.items;
  if (q->model->scenario->contacts.count != 1 || isnan(contact[0].conductance_W_K)) return;
  say(out, "conductance of the contact", "W/K", contact[0].conductance_W_K * out->null_value);
}

/* `interior` by the part's name, others by their own. */
static const struct um_scenario_interior *interior_named(const struct question *q,
                                                         const struct um_scenario_part *part)
{
  const struct um_scenario_interior *interior = part->interiors.items;
  const char *name = q->target + strlen(part->name);
  if (*name == '\0') return part->interior;
  for (size_t i = 0; i < part->interiors.count; i++)
    if (strcmp(interior[i].name, name + 1) == 0) return &interior[i];
  return NULL;
}

static void of_interior(const struct question *q, enum um_effect_stated which, double present,
                        struct um_sensitivity_stated *out)
{
  const struct um_scenario_group *group;
  const struct um_scenario_part *part = part_named(q, &group);
  const struct um_scenario_interior *interior = part == NULL ? NULL : interior_named(q, part);
  if (interior == NULL) return;
  if (which == UM_STATED_INTERIOR_POWER) {
    say(out, "power inside", "W", interior->power_W + present);
    /* what is inside does not cool; how far a history lets it go down, the effect says */
    if (interior->power_file == NULL) out->minimum = fmin(0.0, out->value);
  }
  if (which != UM_STATED_INTERIOR_CAPACITY) return;
  say(out, "heat capacity inside", "J/K", interior->capacity_J_K + present);
  out->minimum = 0.0;
}

static void of_area(const struct question *q, struct um_sensitivity_stated *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(q->model->geometry);
  double area = 0.0;
  for (size_t f = 0; q->target != NULL && f < mesh->nfacet; f++)
    if (strcmp(um_geometry_part_name(q->model->geometry, mesh->facet_part[f]), q->target) == 0)
      area += mesh->area[f];
  if (area > 0.0) say(out, "area of facets", "m^2", area);
}

/* ---- times and the world ---- */

/* The longest exposure leads: a shorter one has no less than none. */
static void of_exposure(const struct question *q, double present, struct um_sensitivity_stated *out)
{
  double longest = 0.0;
  for (size_t i = 0; i < q->forward->plan->ntime; i++)
    longest = fmax(longest, q->forward->plan->exposure[i]);
  say(out, "square of the longest exposure", "s^2", longest * longest + present);
  out->minimum = 0.0;
}

static void of_spin(const struct question *q, struct um_sensitivity_stated *out)
{
  const struct um_scenario_attitude *law = q->model->scenario->attitude.items;
  struct um_scenario_turn turn;
  for (size_t i = 0; i < q->model->scenario->attitude.count; i++)
    if (um_scenario_turn(&law[i], &turn)) {
      say(out, "spin period", "s", turn.period_s * (1.0 + out->null_value));
      return;
    }
}

/* What an Earth that differs from place to place is scaled by; false: not of the Earth. */
static bool of_map(const struct um_environment *e, enum um_effect_stated which,
                   struct um_sensitivity_stated *out)
{
  if (which == UM_STATED_ALBEDO)
    say(out, "factor of the map's albedo", "1", e->albedo_factor);
  else if (which == UM_STATED_EARTHSHINE)
    say(out, "factor of the map's albedo as light", "1", e->albedo_factor * e->earthshine_factor);
  else if (which == UM_STATED_LONGWAVE)
    say(out, "factor of the map's outgoing longwave radiation", "1", e->longwave_factor);
  else if (which == UM_STATED_EARTH_BRIGHTNESS)
    say(out, "shift of the map's brightness temperature", "K", e->brightness_shift);
  else
    return false;
  if (which == UM_STATED_EARTH_BRIGHTNESS) out->minimum = -INFINITY;
  return true;
}

static void of_environment(const struct um_environment *e, enum um_effect_stated which,
                           struct um_sensitivity_stated *out)
{
  out->minimum = 0.0;
  if (e->earth != UM_EARTH_UNIFORM && of_map(e, which, out)) return;
  if (which == UM_STATED_SOLAR_IRRADIANCE)
    say(out, "solar irradiance", "W/m^2", e->solar_irradiance);
  if (which == UM_STATED_LONGWAVE)
    say(out, "outgoing longwave radiation", "W/m^2", e->outgoing_longwave);
  if (which == UM_STATED_EARTH_BRIGHTNESS)
    say(out, "brightness temperature of the Earth", "K", e->brightness_temperature);
  if (which == UM_STATED_SHADOW_RADIUS && e->shadow != UM_SHADOW_NONE)
    say(out, "radius of the shadow", "km", 1e-3 * e->shadow_radius);
  if (which == UM_STATED_EARTHSHINE)
    say(out, "albedo as light", "1", e->albedo * e->earthshine_factor);
  if (which != UM_STATED_ALBEDO) return;
  say(out, "albedo", "1", e->albedo);
  out->maximum = 1.0;
}

/* ---- the whole ---- */

static void answer(const struct question *q, enum um_effect_stated which, double present,
                   struct um_sensitivity_stated *out)
{
  switch (which) {
  case UM_STATED_NOTHING:
    return;
  case UM_STATED_SOLAR_IRRADIANCE:
  case UM_STATED_ALBEDO:
  case UM_STATED_EARTHSHINE:
  case UM_STATED_LONGWAVE:
  case UM_STATED_EARTH_BRIGHTNESS:
  case UM_STATED_SHADOW_RADIUS:
    of_environment(&q->model->environment, which, out);
    return;
  case UM_STATED_ABSORPTANCE:
  case UM_STATED_EMITTANCE:
  case UM_STATED_BAND_EMISSIVITY:
  case UM_STATED_DIFFUSE_REFLECTANCE:
  case UM_STATED_SPECULAR_REFLECTANCE:
  case UM_STATED_ROUGHNESS:
    of_material(q, which, out);
    return;
  case UM_STATED_EXTRACTION:
    of_extraction(q, out);
    return;
  case UM_STATED_INTERIOR_POWER:
  case UM_STATED_INTERIOR_CAPACITY:
    of_interior(q, which, present, out);
    return;
  case UM_STATED_AREA:
    of_area(q, out);
    return;
  case UM_STATED_MLI_EMITTANCE:
  case UM_STATED_HEAT_CAPACITY:
  case UM_STATED_THROUGH_CONDUCTANCE:
    of_wall(q, which, out);
    return;
  case UM_STATED_CREASE_SQUARE:
    of_creases(q, out);
    return;
  case UM_STATED_CONTACT_CONDUCTANCE:
    of_contact(q, out);
    return;
  case UM_STATED_EXPOSURE_SQUARE:
    of_exposure(q, present, out);
    return;
  case UM_STATED_SPIN_PERIOD:
    of_spin(q, out);
    return;
  }
}

bool um_sensitivity_stated_find(const struct um_sensitivity_forward *forward,
                                const struct um_effect *effect, const char *target, size_t p,
                                double null_value, struct um_sensitivity_stated *out)
{
  const struct question q = {forward, forward->model, effect, target};
  const struct um_effect_parameter *of = &effect->parameters[p];
  *out = (struct um_sensitivity_stated){.value = NAN,
                                        .minimum = -INFINITY,
                                        .maximum = INFINITY,
                                        .change = of->change,
                                        .null_value = null_value};
  answer(&q, of->stated, null_value - of->null_value, out);
  return isfinite(out->value);
}

double um_sensitivity_stated_whole(const struct um_sensitivity_stated *stated, double value)
{
  double whole = stated->value;
  if (stated->change == UM_CHANGE_ADDS) whole += value - stated->null_value;
  if (stated->change == UM_CHANGE_SCALES) whole *= value / stated->null_value;
  if (stated->change == UM_CHANGE_STRETCHES) whole *= (1.0 + value) / (1.0 + stated->null_value);
  return fmin(fmax(whole, stated->minimum), stated->maximum);
}

/* Records keep an absorptance or emissivity within 0 to 1 at each wavelength by themselves: a bound
 * on the mean would come too early. */
static bool is_clamped(enum um_effect_stated which)
{
  return which >= UM_STATED_ABSORPTANCE && which <= UM_STATED_ROUGHNESS;
}

void um_sensitivity_stated_range(const struct um_sensitivity_forward *forward,
                                 const struct um_effect *effect, const char *target, size_t p,
                                 double null_value, double *minimum, double *maximum)
{
  struct um_sensitivity_stated stated;
  const struct um_effect_parameter *of = &effect->parameters[p];
  *minimum = of->minimum;
  *maximum = of->maximum;
  if (is_clamped(of->stated) ||
      !um_sensitivity_stated_find(forward, effect, target, p, null_value, &stated))
    return;
  if (stated.change == UM_CHANGE_ADDS) {
    *minimum = fmax(*minimum, null_value - (stated.value - stated.minimum));
    *maximum = fmin(*maximum, null_value + (stated.maximum - stated.value));
  }
  if (stated.change == UM_CHANGE_SCALES && stated.value > 0.0 && null_value > 0.0)
    *maximum = fmin(*maximum, null_value * stated.maximum / stated.value);
  *minimum = fmin(*minimum, null_value);
  *maximum = fmax(*maximum, null_value);
}

const char *um_sensitivity_stated_refusal(const struct um_sensitivity_forward *forward,
                                          const struct um_effect *effect, const char *target)
{
  const struct question q = {forward, forward->model, effect, target};
  double least, most, absorbed;
  for (size_t p = 0; p < effect->nparameter; p++) {
    if (effect->parameters[p].stated != UM_STATED_EXTRACTION || forward->model->body == NULL)
      continue;
    if (!fronts(&q, &least, &most, &absorbed)) return "no side of it can hold solar cells";
    if (!(most > 0.0) && absorbed < CELLS)
      return "no side of it extracts or is dark enough for solar cells";
  }
  return NULL;
}
