/* The schema of scenario.yaml: every key with its type, bounds, default and meaning, once. The
 * checker, the reference page and the JSON Schema are all made from this table. */
#include "model/scenario/scenario_schema.h"

#include "model/scenario/scenario_schema_group.h"

/* --- time ----------------------------------------------------------------------------------- */
#define OF struct um_scenario_time
static const struct um_schema_field time_fields[] = {
    F_AS(start, "start_utc", UM_SCHEMA_PARSED, REQUIRED, UTC,
         HELP("first observation, light received")),
    F_AS(stop, "stop_utc", UM_SCHEMA_PARSED, REQUIRED, UTC, HELP("last observation at the latest")),
    F(step_s, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e7), HELP("between observations")),
    F(exposure_s, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e5),
      HELP("integration time; 0 is an instant")),
    F(exposure_samples, UM_SCHEMA_INTEGER, DEFAULT(5), BETWEEN(1, 1000),
      HELP("instants averaged over an exposure")),
    F(light_time, UM_SCHEMA_BOOL, DEFAULT(1),
      HELP("false: the satellite is seen where it is when the light arrives")),
};
#undef OF
OBJECT(time_object, struct um_scenario_time, "time", "When the satellite is observed.",
       FIELDS(time_fields));

/* --- thermal, bands, optics, effects -------------------------------------------------------- */
static const char *const start_choices[] = {"periodic", "isothermal", NULL};
static const char *const spin_choices[] = {"automatic", "resolved", "averaged", NULL};
static const char *const range_choices[] = {"warning", "error", NULL};
static const char *const temperature_choices[] = {"facet", "material_mean", NULL};
#define OF struct um_scenario_thermal
static const struct um_schema_field thermal_fields[] = {
    F(orbits_before, UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0, 10000),
      HELP("orbits computed before the first observation")),
    F(start, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = start_choices,
      HELP("periodic: the state that repeats after one orbit; isothermal: start_temperature_K")),
    F(start_temperature_K, UM_SCHEMA_NUMBER, DEFAULT(280.0), POSITIVE(5000),
      HELP("everywhere, or first guess of periodic")),
    F(facet_size_m, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("longest facet edge; default: as coarse as the shapes allow")),
    F(facets, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV of umbra export --as facets: facets that are cut further, each as often as its "
           "temperature asks for; '': none")),
    F(facet_error_K, UM_SCHEMA_NUMBER, DEFAULT(0.5), BETWEEN(1e-3, 100),
      HELP("umbra export --as facets: what the mean temperature of a group's side may be off by")),
    F(step_s, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("grid of the loads; default: 4.6 deg of turn, at most 10 s")),
    F(spin_loads, UM_SCHEMA_CHOICE, DEFAULT(UM_SPIN_AUTOMATIC), .choices = spin_choices,
      HELP("of a body that turns. averaged: means over each turn, and the swing of temperatures "
           "within it added; resolved: every 4.6 deg of turn; automatic: averaged where that "
           "leaves less than accuracy_K, a turn takes 10 s or less and step_s is not stated")),
    F(accuracy_K, UM_SCHEMA_NUMBER, DEFAULT(0.1), BETWEEN(1e-6, 10),
      HELP("what integration in time may leave in the temperature of a facet over an orbit or two, "
           "after many up to twice that; makes both tolerances")),
    F(relative_tolerance, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(1e-12, 1e-2),
      HELP("of the integrator; default: 1e-4 of accuracy_K")),
    F(absolute_tolerance_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(1e-9, 1),
      HELP("of the integrator; default: 1e-2 of accuracy_K")),
    F(error_estimate, UM_SCHEMA_BOOL, DEFAULT(0),
      HELP("umbra run: compute once more with facets and tetrahedra of half the size, and say what "
           "that changes")),
    F(samples, UM_SCHEMA_INTEGER, DEFAULT(4), BETWEEN(1, 4096),
      HELP("points per facet for the shadow of the satellite on itself")),
    F(exchange_patches, UM_SCHEMA_INTEGER, DEFAULT(512), BETWEEN(1, 4096),
      HELP("between which surfaces exchange radiation; more surfaces are gathered into these")),
    F(view_factor_rays, UM_SCHEMA_INTEGER, DEFAULT(4096), BETWEEN(16, 1048576),
      HELP("from each patch, for view factors")),
    F(view_factors, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP(
          "folder that umbra exchange has written, to be taken in place of rays; refused where the "
          "satellite or its joints are others")),
    F(space_temperature_K, UM_SCHEMA_NUMBER, DEFAULT(2.7), BETWEEN(0, 100), HELP("of deep space")),
    F(temperature_in_optics, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = temperature_choices,
      HELP("what the renderer emits with")),
    F(outside_range, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = range_choices,
      HELP("what a surface does that leaves the temperatures for which its material's record "
           "holds")),
};
#undef OF
OBJECT(thermal_object, struct um_scenario_thermal, "thermal", "How temperatures are computed.",
       FIELDS(thermal_fields));
#define OF struct um_scenario_optics
static const struct um_schema_field optics_fields[] = {
    F(samples, UM_SCHEMA_INTEGER, DEFAULT(16), BETWEEN(1, 65536),
      HELP("points per facet that look at observer and Sun")),
    F(interreflection_samples, UM_SCHEMA_INTEGER, DEFAULT(UM_SCENARIO_PATHS), BETWEEN(0, 4096),
      HELP("paths of light between surfaces, from each surface that another stands before and at "
           "each instant, in the mean, or 1024 of the body if that is more; 0: none, and effect "
           "inter_reflection is off")),
    F(relative_error, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1),
      HELP("standard error of every instant and band over its intensity that is asked of `run`: "
           "more points per facet than `samples` where they are needed; nothing asked without it")),
    F(seed, UM_SCHEMA_INTEGER, DEFAULT(0), BETWEEN(0, 1000000000),
      HELP("another one takes other points, whose errors are independent")),
};
#undef OF
OBJECT(optics_object, struct um_scenario_optics, "optics", "How light curves are computed.",
       FIELDS(optics_fields));
#define OF struct um_scenario_effect
static const struct um_schema_field effect_fields[] = {
    F(effect, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("name, see `umbra list effects`")),
    F(target, UM_SCHEMA_TEXT, NAME, HELP("part, part.side, material or band it acts on")),
    F(off, UM_SCHEMA_BOOL, DEFAULT(0), HELP("true: switched off")),
    F_AS(parameters, "PARAMETER", UM_SCHEMA_REST,
         HELP("of the effect, see `umbra list effects NAME`")),
};
#undef OF
OBJECT(effect_object, struct um_scenario_effect, "effect", "One physical effect.",
       FIELDS(effect_fields));

/* --- the whole ------------------------------------------------------------------------------ */
#define OF struct um_scenario
static const struct um_schema_field scenario_fields[] = {
    F(schema, UM_SCHEMA_INTEGER, REQUIRED, BETWEEN(1, 1.5), HELP("version of this format: 1")),
    F(name, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("names the output folder")),
    F(summary, UM_SCHEMA_TEXT, HELP("one sentence")),
    F(time, UM_SCHEMA_MAP, REQUIRED, .object = &time_object),
    F(orbit, UM_SCHEMA_MAP, REQUIRED, .object = &um_model_orbit_schema),
    F(attitude, UM_SCHEMA_LIST, MOST(10000), REQUIRED, .object = &um_model_attitude_schema,
      HELP("laws in order of time")),
    F(observer, UM_SCHEMA_MAP, .object = &um_model_observer_schema),
    F(environment, UM_SCHEMA_MAP, .always = true, .object = &um_model_environment_schema),
    F(material_files, UM_SCHEMA_TEXTS, MOST(1000), NAMES_FILE,
      HELP("files of material records that add to the library or replace its names")),
    F(parts, UM_SCHEMA_LIST, MOST(5000), REQUIRED, .object = &um_model_part_schema),
    F(contacts, UM_SCHEMA_LIST, MOST(50000), .object = &um_model_contact_schema),
    F(thermal, UM_SCHEMA_MAP, .always = true, .object = &thermal_object),
    F(bands, UM_SCHEMA_DICT, MOST(500), .object = &um_model_band_schema,
      HELP("default: vis 0.38-0.78 um in 80 bins, lwir 8-12 um in 40")),
    F(sensors, UM_SCHEMA_DICT, MOST(100), .object = &um_model_sensor_schema,
      HELP("telescopes with detectors; default: none")),
    F(optics, UM_SCHEMA_MAP, .always = true, .object = &optics_object),
    F(effect_files, UM_SCHEMA_TEXTS, MOST(100), NAMES_FILE,
      HELP(
          "shared objects with effects of your own, which run inside the program; loaded only with "
          "--allow-effects, or where --effect-file names them too")),
    F(effects, UM_SCHEMA_LIST, MOST(1000), .object = &effect_object),
    F(measurements, UM_SCHEMA_MAP, .object = &um_model_measurements_schema),
    F(limits, UM_SCHEMA_LIST, MOST(10000), .object = &um_model_limit_schema),
    F(cases, UM_SCHEMA_DICT, MOST(1000), .object = &um_model_case_schema,
      HELP("of `umbra cases`; default: nominal, the scenario as it is")),
};
#undef OF
const struct um_schema_object um_model_scenario_schema = {
    .name = "scenario",
    .help = "What is observed, from where, when, and what it is made of.",
    .size = sizeof(struct um_scenario),
    FIELDS(scenario_fields)};
