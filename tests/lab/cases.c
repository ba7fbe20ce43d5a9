/* What is hidden: for each effect a target in each pass and values of plausible size
 * (docs/physics/residuals.md), one below and one above the scenario's, chosen so that the noise
 * does not hide it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "effects/effects.h"
#include "tests/lab/lab.h"

/* target: "" for global. below: NAN where the effect has one sign only. */
struct entry {
  const char *effect, *dusk, *dawn; /* targets; NULL: it does not act there */
  size_t parameter;
  double below, above;
};

static const struct entry entries[] = {
    {"internal_power", "bus", "bus", 0, -30.0, 40.0},
    {"stored_heat", "bus", "bus", 0, -20.0, 20.0},
    {"interior_gradient", NULL, "bus", 0, NAN, 2000.0},
    {"mli_emittance", "bus", "bus", 0, 0.25, 3.0},
    {"mli_temperature_law", "bus", "bus", 0, -2.0, 2.0},
    {"mli_seams", "bus", "bus", 0, NAN, 0.2},
    {"mli_sheets", "bus", "bus", 0, NAN, 150.0},
    {"heat_capacity", "array", "array", 0, 0.8, 1.3},
    {"specific_heat_law", "array", "array", 0, -0.002, 0.002},
    {"solar_absorptance", "white", "mli", 0, -0.06, 0.08},
    {"emittance", "cell", "cell", 0, 0.92, 1.08},
    {"panel_extraction", "array", "array", 0, NAN, 0.18},
    {"through_conductance", "array", "array", 0, 0.5, 2.5},
    {"contact_conductance", "", "", 0, 0.2, 4.0},
    {"albedo_level", "", "", 0, 0.5, 1.6},
    {"earth_ir_level", "", "", 0, 0.9, 1.1},
    {"earth_brightness", "", "", 0, -12.0, 12.0},
    {"local_albedo", "", NULL, 0, 0.4, 2.0},
    {"local_earth_ir", "", "", 0, 0.8, 1.2},
    {"solar_irradiance", "", "", 0, 0.97, 1.034},
    {"shadow_radius", "", "", 0, -4.0, 5.0},
    {"shadow_air", "", "", 1, -0.008, 0.07},
    {"band_emissivity", "cfrp", "mli", 0, 0.92, 1.08},
    {"directional_emissivity", "cfrp", "mli", 0, -0.6, 0.8},
    {"roughness", "cell", "cell", 0, 0.8, 1.25},
    {"anisotropy", "cell", "cell", 0, 0.7, 1.4},
    {"specular_level", "mli", "cell", 0, 0.8, 1.25},
    {"diffuse_level", "white", "mli", 0, 0.9, 1.1},
    {"area", "array", "bus", 0, 0.95, 1.05},
    {"array_angle", "array", "array", 0, -3.0, 4.0},
    {"attitude_offset", "", "", 1, -2.0, 2.0},
    {"spin_period", "", NULL, 0, -0.005, 0.005},
    {"time_tag", "", "", 0, -0.5, 0.5},
    {"along_track", "", "", 0, -1.5, 1.5},
    {"exposure", "", NULL, 0, NAN, 16.0},
    {"earthshine_level", "", NULL, 0, NAN, 4.0},
    {"earth_reflection_level", "", "", 0, 0.8, 1.25},
    {"extinction", "vis", "lwir", 0, -0.03, 0.04},
    {"zero_point", "vis", "lwir", 0, 0.95, 1.06},
    {"background", "lwir", "vis", 0, -1e-12, 1e-12},
    {"aperture_loss", "vis", "lwir", 0, NAN, 0.04},
    {"sky_background", "vis", NULL, 0, -1e-12, 1e-12},
    {"path_radiance", "lwir", "lwir", 0, -1e-12, 1e-12},
};

/* Shown in worlds of their own. */
static const struct {
  const char *dusk, *dawn;
  struct entry entry;
} specials[] = {
    {"dusk-hollow", "dawn-hollow", {"interior_capacity", "bus", "bus", 0, -2000.0, 3000.0}},
    {"dusk-cells", "dawn-cells", {"panel_extraction", "array", "array", 0, -0.08, 0.08}},
    {"dusk-low", NULL, {"free_molecular_heating", "", NULL, 0, NAN, 6.0}},
    {"dusk-air", "dawn-air", {"water_vapour", "", "", 0, 0.5, 2.0}},
    {"dusk-air", NULL, {"aerosol", "", NULL, 0, NAN, 0.2}},
    {"dusk-air", "dawn-air", {"cirrus", "", "", 0, NAN, 0.1}},
    {"dusk-air", NULL, {"twilight", "vis", NULL, 0, NAN, 4e5}},
    {"dusk-camera", NULL, {"nonlinearity", "vis", NULL, 0, -0.02, 0.03}},
    {"dusk-creases", "dawn-creases", {"mli_creases", "bus", "bus", 0, -16.0, 25.0}},
    {"dusk-panels", NULL, {"panel_flatness", "array", NULL, 0, -1.5, 4.0}},
    /* no face glints at dawn: flatter panels are lost in the noise */
    {NULL, "dawn-panels", {"panel_flatness", NULL, "array", 0, NAN, 4.0}},
    {"dusk-films", "dawn-films", {"thin_film", "mli_kapton", "mli_kapton", 0, 0.7, 1.4}},
    {"dusk-clouds", "dawn-clouds", {"cloud_in_mirror", "", "", 0, -0.5, 0.35}},
    {"dusk-nutation", NULL, {"nutation", "", NULL, 0, -3.0, 4.0}},
    {"days", NULL, {"contamination", "white", NULL, 0, -0.015, 0.02}},
    {"dusk-dense", "dawn-dense", {"heater", "bus.-x", "bus.-x", 0, NAN, 60.0}},
};

/* A thermostat switches somewhat above what its place has without it. */
static const struct {
  const char *world, *effect, *values;
} others[] = {{"dusk-dense", "heater", ",on_K=254,band_K=3"},
              {"dawn-dense", "heater", ",on_K=226,band_K=3"}};

static const struct {
  const char *name;
  bool dusk, dawn;
} switches[] = {{"albedo", true, true},
                {"earth_ir", true, true},
                {"earthshine", true, false},
                {"reflected_earth_ir", true, true},
                {"earthlight_lobe", true, true},
                {"penumbra", true, true},
                {"oblateness", true, true},
                {"shadow_refraction", true, true},
                {"atmosphere", true, true},
                {"saturation", true, false},
                {"absorptance_angle", true, false},
                {"emittance_temperature", true, false},
                {"bulk_temperature", true, false},
                {"earth_map", true, true},
                {"earth_spectrum", true, true},
                {"earth_anisotropy", true, true},
                {"mutual_radiation", true, true},
                {"solar_multiple_reflection", true, true},
                {"specular_exchange", false, true},
                {"multiple_scattering", true, false},
                {"inter_reflection", false, true},
                {"moonlight", true, false},
                {"umbra_scatter", true, false}};

/* Two at once: what each does to the light should not be the other's. */
static const struct {
  const char *world;
  struct lab_hidden hidden[LAB_HIDDEN];
} twos[] = {
    {"dusk", {{"panel_extraction", "array", 0, 0.18}, {"roughness", "cell", 0, 1.25}}},
    {"dusk", {{"spin_period", NULL, 0, 0.005}, {"extinction", "vis", 0, 0.1}}},
    {"dusk", {{"heat_capacity", "array", 0, 1.4}, {"zero_point", "vis", 0, 1.06}}},
    {"dusk", {{"solar_absorptance", "white", 0, 0.1}, {"earth_ir_level", NULL, 0, 1.1}}},
    {"dusk", {{"time_tag", NULL, 0, 0.5}, {"band_emissivity", "cfrp", 0, 0.92}}},
    {"dawn", {{"internal_power", "bus", 0, 40.0}, {"extinction", "lwir", 0, 0.1}}},
    {"dawn", {{"mli_emittance", "bus", 0, 2.5}, {"diffuse_level", "mli", 0, 0.9}}},
    {"dawn", {{"shadow_radius", NULL, 0, 5.0}, {"earth_brightness", NULL, 0, -12.0}}},
    {"dawn", {{"heat_capacity", "array", 0, 1.4}, {"background", "vis", 0, 1e-12}}},
    {"dawn", {{"along_track", NULL, 0, 1.5}, {"panel_extraction", "array", 0, 0.18}}},
};

/* The pairs that only a tie-breaker tells apart, and the worlds that lack it and have it: light for
 * absorptance, the whole range of airmass for extinction, a spin that follows the clock and not the
 * orbit for along-track errors, several glints of known level for roughness. */
static const struct pair {
  const char *without, *with;
  struct lab_hidden hidden[2];
} pairs[] = {
    {"power-mli without",
     "power-mli with",
     {{"mli_emittance", "bus", 0, 2.5}, {"internal_power", "bus", 0, 40.0}}},
    {"absorptance-extraction without",
     "dusk",
     {{"panel_extraction", "array", 0, 0.12}, {"solar_absorptance", "cell", 0, -0.08}}},
    {"cells without",
     "dusk-cells",
     {{"panel_extraction", "array", 0, -0.08}, {"solar_absorptance", "cell", 0, 0.05}}},
    {"emittance-capacity without",
     "emittance-capacity with",
     {{"heat_capacity", "array", 0, 1.2}, {"emittance", "cell", 0, 0.85}}},
    {"extinction-zero without",
     "dusk",
     {{"extinction", "lwir", 0, 0.05}, {"zero_point", "lwir", 0, 0.94}}},
    {"dawn", "dusk", {{"time_tag", NULL, 0, 0.7}, {"along_track", NULL, 0, 1.5}}},
    {"roughness-smear without",
     "roughness-smear with",
     {{"roughness", "cell", 0, 1.25}, {"exposure", NULL, 0, 0.88}}},
};

/* Heat that is in no catalogue: the radiator's wall, and everything inside. */
#define WALL   "bus.-x", "parts.bus.groups.-x.power_file"
#define INSIDE "bus.interior", "parts.bus.interior.power_file"
static const struct lab_pulse pulses[] = {
    {WALL, UM_HEAT_PULSE, 500.0, 240.0, 120.0, 0.0},
    {INSIDE, UM_HEAT_PULSE, 2000.0, 180.0, 150.0, 0.0},
    {WALL, UM_HEAT_STEP, 200.0, 260.0, 0.0, 0.0},
    {INSIDE, UM_HEAT_STEP, 900.0, 200.0, 0.0, 0.0},
    {WALL, UM_HEAT_DECAY, 700.0, 220.0, 90.0, 0.0},
    {INSIDE, UM_HEAT_DECAY, 2500.0, 170.0, 130.0, 0.0},
    {WALL, UM_HEAT_PERIODIC, 400.0, 130.0, 55.0, 130.0},
    {INSIDE, UM_HEAT_PERIODIC, 2000.0, 110.0, 70.0, 160.0},
};

/* Energy until the end of the pass [J], by small steps. */
static double energy_of(const struct lab_pulse *p)
{
  double sum = 0.0, step = 0.01;
  for (double t = p->from_s + 0.5 * step; t < LAB_PULSE_END; t += step) {
    double since = t - p->from_s;
    if (p->shape == UM_HEAT_DECAY)
      sum += step * exp(-since / p->last_s);
    else if (p->shape == UM_HEAT_STEP ||
             (p->shape == UM_HEAT_PERIODIC ? fmod(since, p->period_s) : since) < p->last_s)
      sum += step;
  }
  return p->power * sum;
}

struct list {
  const struct lab_options *options;
  struct lab_case *item;
  size_t count;
};

void lab_hidden_name(const struct lab_hidden *hidden, char *out, size_t size)
{
  snprintf(out, size, "%s%s%s", hidden->effect, hidden->target != NULL ? ":" : "",
           hidden->target != NULL ? hidden->target : "");
}

/* ",NAME=VALUE" of its parameters that neither are off nor stay as they fall back; "" for most. */
static const char *others_of(const struct lab_world *world, const struct lab_hidden *hidden)
{
  for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
    if (strcmp(others[i].world, world->name) == 0 && strcmp(others[i].effect, hidden->effect) == 0)
      return others[i].values;
  return "";
}

bool lab_hidden_with(const struct lab_world *world, const struct lab_hidden *hidden, char *out,
                     size_t size)
{
  char name[LAB_TEXT / 2];
  const struct um_effect *effect = um_effects_find(hidden->effect);
  if (effect == NULL || hidden->parameter >= effect->nparameter) return false;
  lab_hidden_name(hidden, name, sizeof name);
  snprintf(out, size, "%s,%s=%.9g%s", name, effect->parameters[hidden->parameter].name,
           hidden->value, others_of(world, hidden));
  return true;
}

void lab_case_hidden(const struct lab_case *c, char out[LAB_TEXT])
{
  out[0] = '\0';
  for (size_t i = 0; i < c->nhidden; i++) {
    char name[LAB_TEXT / 2];
    lab_hidden_name(&c->hidden[i], name, sizeof name);
    lab_append(out, LAB_TEXT, name);
  }
  if (c->pulse != NULL)
    snprintf(out, LAB_TEXT, "%s:%s", um_thermal_course_name(c->pulse->shape), c->pulse->place);
  if (out[0] == '\0' && strcmp(c->part, "switches") == 0)
    snprintf(out, LAB_TEXT, "%s", c->world->without);
  if (out[0] == '\0') snprintf(out, LAB_TEXT, "-");
}

void lab_case_value(const struct lab_case *c, char out[LAB_TEXT])
{
  out[0] = '\0';
  for (size_t i = 0; i < c->nhidden; i++) {
    char text[32];
    snprintf(text, sizeof text, "%.9g", c->hidden[i].value);
    lab_append(out, LAB_TEXT, text);
  }
  if (c->pulse != NULL) snprintf(out, LAB_TEXT, "%.9g+%.9g", energy_of(c->pulse), c->pulse->from_s);
  if (out[0] == '\0') snprintf(out, LAB_TEXT, "-");
}

static bool is_wanted(const struct lab_options *o, const struct lab_case *c)
{
  char hidden[LAB_TEXT];
  if (o->part != NULL && strcmp(o->part, c->part) != 0) return false;
  if (o->world != NULL && strcmp(o->world, c->world->name) != 0) return false;
  lab_case_hidden(c, hidden);
  return o->only == NULL || strstr(hidden, o->only) != NULL;
}

static void add(struct list *list, struct lab_case c)
{
  if (!is_wanted(list->options, &c)) return;
  struct lab_case *more = realloc(list->item, (list->count + 1) * sizeof *more);
  if (more == NULL) abort();
  list->item = more;
  list->item[list->count++] = c;
}

/* Odd seeds lie above, even ones below, so that both signs are hidden. */
static void add_effect(struct list *list, const struct entry *e, const char *target,
                       const char *world, uint64_t seeds)
{
  if (target == NULL) return;
  for (int above = 1; above >= 0; above--)
    for (uint64_t seed = 1; seed <= seeds; seed++) {
      bool is_above = seed % 2 == 1 || isnan(e->below);
      if (is_above != (above == 1)) continue;
      struct lab_hidden hidden = {e->effect, target[0] == '\0' ? NULL : target, e->parameter,
                                  is_above ? e->above : e->below};
      add(list, (struct lab_case){.part = "effects",
                                  .world = lab_world_find(world),
                                  .hidden = {hidden},
                                  .nhidden = 1,
                                  .seed = seed});
    }
}

static void add_effects(struct list *list, bool dawn, uint64_t seeds)
{
  for (size_t i = 0; i < sizeof entries / sizeof entries[0]; i++)
    add_effect(list, &entries[i], dawn ? entries[i].dawn : entries[i].dusk, dawn ? "dawn" : "dusk",
               seeds);
  for (size_t i = 0; i < sizeof specials / sizeof specials[0]; i++)
    add_effect(list, &specials[i].entry, dawn ? specials[i].entry.dawn : specials[i].entry.dusk,
               dawn ? specials[i].dawn : specials[i].dusk, seeds);
}

static void add_switches(struct list *list, uint64_t seeds)
{
  for (size_t i = 0; i < sizeof switches / sizeof switches[0]; i++)
    for (int dawn = 0; dawn < 2; dawn++) {
      char name[LAB_TEXT];
      snprintf(name, sizeof name, "%s-%s", dawn ? "dawn" : "dusk", switches[i].name);
      for (uint64_t seed = 1; seed <= seeds && (dawn ? switches[i].dawn : switches[i].dusk); seed++)
        add(list,
            (struct lab_case){.part = "switches", .world = lab_world_find(name), .seed = seed});
    }
}

static void add_two(struct list *list, uint64_t seeds)
{
  for (size_t i = 0; i < sizeof twos / sizeof twos[0]; i++)
    for (uint64_t seed = 1; seed <= seeds; seed++) {
      struct lab_case c = {.part = "two",
                           .world = lab_world_find(twos[i].world),
                           .nhidden = LAB_HIDDEN,
                           .seed = 1000 + seed};
      memcpy(c.hidden, twos[i].hidden, sizeof c.hidden);
      add(list, c);
    }
}

static void add_pair(struct list *list, const struct pair *pair, uint64_t seeds)
{
  for (int with = 0; with < 2; with++)
    for (size_t h = 0; h < 2; h++)
      for (uint64_t seed = 1; seed <= seeds; seed++)
        add(list, (struct lab_case){.part = "pairs",
                                    .world = lab_world_find(with ? pair->with : pair->without),
                                    .hidden = {pair->hidden[h]},
                                    .nhidden = 1,
                                    .tie_breaker = with == 1,
                                    .seed = 2000 + seed});
}

const char *lab_pair_partner(const struct lab_case *c)
{
  for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
    for (size_t h = 0; h < 2; h++)
      if (strcmp(pairs[i].hidden[h].effect, c->hidden[0].effect) == 0)
        return pairs[i].hidden[1 - h].effect;
  return NULL;
}

static void add_complete(struct list *list, uint64_t count)
{
  for (uint64_t i = 0; i < count; i++)
    add(list, (struct lab_case){.part = "complete",
                                .world = lab_world_find(i % 2 == 0 ? "dusk" : "dawn"),
                                .seed = 10000 + i});
}

/* A small part: three effects, complete models and a pair without its tie-breaker, in two worlds.
 */
static void make_quick(struct list *list)
{
  static const char *const some[] = {"heat_capacity", "zero_point", "directional_emissivity"};
  const struct lab_options *asked = list->options;
  struct lab_options one = *asked;
  one.world = "dusk";
  list->options = &one;
  for (size_t i = 0; i < sizeof some / sizeof some[0]; i++) {
    one.only = some[i];
    add_effects(list, false, 1);
  }
  one.only = NULL;
  add_complete(list, 40); /* every other one is of this world */
  one.world = pairs[1].without;
  add_pair(list, &pairs[1], 1);
  list->options = asked;
}

size_t lab_cases_make(const struct lab_options *options, struct lab_case **out)
{
  struct list list = {.options = options};
  const char *const passes[] = {"dusk", "dawn"};
  uint64_t few = options->seeds < 3 ? options->seeds : 3;
  if (options->quick) {
    make_quick(&list);
    *out = list.item;
    return list.count;
  }
  for (int dawn = 0; dawn < 2; dawn++) add_effects(&list, dawn, options->seeds);
  add_switches(&list, options->seeds);
  for (uint64_t i = 0; i < options->complete; i++)
    add(&list, (struct lab_case){
                   .part = "complete", .world = lab_world_find(passes[i % 2]), .seed = 10000 + i});
  add_two(&list, few);
  for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
    add_pair(&list, &pairs[i], few < 2 ? few : 2);
  for (size_t i = 0; i < sizeof pulses / sizeof pulses[0]; i++)
    for (uint64_t seed = 1; seed <= few; seed++)
      add(&list, (struct lab_case){.part = "pulse",
                                   .world = lab_world_find("pulse dawn"),
                                   .pulse = &pulses[i],
                                   .seed = 3000 + seed});
  *out = list.item;
  return list.count;
}
