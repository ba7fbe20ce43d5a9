/* Keys of scenario.yaml: what is known of measurements. */
#include "model/scenario/scenario_schema_group.h"

static const char *const quantity_choices[] = {"band_irradiance",
                                               "radiant_intensity",
                                               "magnitude_ab",
                                               "magnitude_vega",
                                               "count_rate",
                                               "temperature",
                                               "characteristic_temperature",
                                               "infrared_cross_section",
                                               NULL};
#define OF struct um_scenario_noise
static const struct um_schema_field noise_fields[] = {
    F(quantity, UM_SCHEMA_CHOICE, REQUIRED, .choices = quantity_choices,
      HELP("of the rows that it is for")),
    F(of, UM_SCHEMA_TEXT, NAME,
      HELP("band or place as in the rows; default: all that no other entry names")),
    F(relative, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 10),
      HELP("of the model's value; of magnitudes, of the flux")),
    F(floor, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e30),
      HELP("in the unit of the quantity; sigma^2 = (relative value)^2 + floor^2")),
};
#undef OF
OBJECT(noise_object, struct um_scenario_noise, "noise", "Sigma of the rows that state none.",
       FIELDS(noise_fields));
#define OF struct um_scenario_nuisance
static const struct um_schema_field nuisance_fields[] = {
    F(effect, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("name, see `umbra list effects`")),
    F(target, UM_SCHEMA_TEXT, NAME,
      HELP("part, part.side, material or band it acts on; default: each that there is")),
    F(sigma, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e30),
      HELP("how far its parameters may be from the scenario's, in their unit, as a fraction for "
           "positive factors; default: the width of their prior")),
    F(free, UM_SCHEMA_BOOL, DEFAULT(0), HELP("true: no such width, instead of sigma")),
    F(per, UM_SCHEMA_TEXT,
      HELP("of several sets of measurements: set, a value in each, the default of what acts on "
           "measurements; all, one value")),
};
#undef OF
OBJECT(nuisance_object, struct um_scenario_nuisance, "nuisance",
       "An effect that is uncertain anyway: a diagnosis fits it along and never names it.",
       FIELDS(nuisance_fields));
#define OF struct um_scenario_set
static const struct um_schema_field set_fields[] = {
    F(name, UM_SCHEMA_TEXT, NAME, REQUIRED,
      HELP("what the set is called, as in zero_point:vis@NAME")),
    F(file, UM_SCHEMA_TEXT, NAMES_FILE, REQUIRED, HELP("measurements, see docs/files.md")),
    F(station, UM_SCHEMA_TEXT, NAME,
      HELP("of observer.station or observer.stations that looked; rows may name another; default: "
           "observer.station")),
    F_AS(from, "from_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
         HELP("rows before are left out; default: none are")),
    F_AS(to, "to_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
         HELP("rows behind are left out; default: none are")),
    F(nuisance, UM_SCHEMA_LIST, MOST(1000), .object = &nuisance_object),
};
#undef OF
OBJECT(set_object, struct um_scenario_set, "set",
       "A file of measurements: a night, a telescope, a telemetry.", FIELDS(set_fields));
#define OF struct um_scenario_measurements
static const struct um_schema_field measurements_fields[] = {
    F(sets, UM_SCHEMA_LIST, MOST(1000), .object = &set_object),
    F(noise, UM_SCHEMA_LIST, MOST(1000), .object = &noise_object),
    F(nuisance, UM_SCHEMA_LIST, MOST(1000), .object = &nuisance_object),
    F(exclude, UM_SCHEMA_TEXTS, MOST(1000), NAME,
      HELP("effects, EFFECT or EFFECT:TARGET, that a diagnosis does not try")),
};
#undef OF
SHARED_OBJECT(um_model_measurements_schema, struct um_scenario_measurements, "measurements",
              "What is known of measurements beside their file.", FIELDS(measurements_fields));
