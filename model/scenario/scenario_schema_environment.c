/* Keys of scenario.yaml: the Sun, the Earth and its shadow. */
#include "model/scenario/scenario_schema_group.h"

static const char *const spectrum_choices[] = {"e490", "black_body", NULL};
static const char *const shadow_choices[] = {"none", "cylinder", "sphere", "oblate", NULL};
static const char *const disc_choices[] = {"point", "uniform", "limb_darkened", NULL};
static const char *const sun_choices[] = {"ephemeris", "frozen", NULL};
static const char *const earth_choices[] = {"uniform", "knocke", "map", NULL};
#define OF struct um_scenario_region
static const struct um_schema_field region_fields[] = {
    F(latitude_deg, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-90, 90),
      HELP("of its centre; without a place all of the Earth")),
    F(longitude_deg, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-180, 360), HELP("of its centre, east")),
    F(radius_km, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(10, 20100), HELP("along the ground")),
    F(edge_km, UM_SCHEMA_NUMBER, DEFAULT(500.0), BETWEEN(0, 10000),
      HELP("over which it goes over into the rest, half way at the radius")),
    F_AS(from, "from_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
         HELP("acts from here on; default: the start, or always where a place is given")),
    F_AS(to, "to_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC, HELP("until here; default: for good")),
    F(ramp_s, UM_SCHEMA_NUMBER, DEFAULT(60.0), BETWEEN(0, 1e6),
      HELP("over which it comes and goes, half way at from_utc and to_utc")),
    F(albedo_factor, UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0, 10),
      HELP("of what the Earth has there")),
    F(albedo_offset, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1, 1),
      HELP("added behind the factor")),
    F(olr_factor, UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0, 10),
      HELP("of its outgoing longwave radiation")),
    F(olr_offset_W_m2, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1000, 1000),
      HELP("added behind the factor")),
    F(brightness_shift_K, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-200, 200),
      HELP("added to its brightness temperature")),
};
#undef OF
OBJECT(region_object, struct um_scenario_region, "local",
       "A part of the Earth, or of the time, with a level of its own; local_albedo and "
       "local_earth_ir act on it too.",
       FIELDS(region_fields));
#define OF struct um_scenario_earth
static const struct um_schema_field earth_fields[] = {
    F(model, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = earth_choices,
      HELP("uniform: albedo, olr_W_m2 and brightness_temperature_K of the environment; knocke: by "
           "latitude and season; map: monthly grids of the file. Of the latter two the infrared "
           "goes by wavelength and angle (effect earth_spectrum), what is reflected by angle "
           "(effect "
           "earth_anisotropy)")),
    F(file, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV or netCDF of model map; what it lacks is that of its latitude")),
    F(local, UM_SCHEMA_MAP, .object = &region_object),
};
#undef OF
OBJECT(earth_object, struct um_scenario_earth, "earth",
       "What the Earth reflects and emits from place to place.", FIELDS(earth_fields),
       .scalar_key = "model");
#define OF struct um_scenario_shadow_air
static const struct um_schema_field shadow_air_fields[] = {
    F(ozone_DU, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1000),
      HELP("vertical column of ozone, Dobson units; default: annual mean of the latitude")),
    F(haze, UM_SCHEMA_NUMBER, DEFAULT(0.1), BETWEEN(0, 10),
      HELP("vertical optical depth of tropospheric aerosol at 0.55 um")),
    F(stratospheric_aerosol, UM_SCHEMA_NUMBER, DEFAULT(0.010), BETWEEN(0, 1),
      HELP("the same of the stratosphere; some 0.1 in the year after a large eruption")),
    F(cloud_top_km, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-50, 30),
      HELP("height at which clouds hide half of the rays that pass; -50: no clouds; default: mean "
           "of the latitude")),
};
#undef OF
OBJECT(shadow_air_object, struct um_scenario_shadow_air, "shadow_air",
       "What sunlight passes through at the edge of the shadow (effect shadow_refraction).",
       FIELDS(shadow_air_fields));
#define OF struct um_scenario_environment
static const struct um_schema_field environment_fields[] = {
    F(solar_irradiance_W_m2, UM_SCHEMA_NUMBER, DEFAULT(1361.0), BETWEEN(0, 1e5), HELP("at 1 au")),
    F(solar_spectrum, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = spectrum_choices,
      HELP("ASTM E490 or a black body, scaled to the irradiance")),
    F(solar_temperature_K, UM_SCHEMA_NUMBER, DEFAULT(5772.0), BETWEEN(1000, 50000),
      HELP("of the black body")),
    F(earth, UM_SCHEMA_MAP, .object = &earth_object),
    F(albedo, UM_SCHEMA_NUMBER, DEFAULT(0.30), BETWEEN(0, 1), HELP("Lambert, of a uniform Earth")),
    F(olr_W_m2, UM_SCHEMA_NUMBER, DEFAULT(237.0), BETWEEN(0, 1000),
      HELP("outgoing longwave radiation of a uniform Earth")),
    F(brightness_temperature_K, UM_SCHEMA_NUMBER, DEFAULT(270.0), BETWEEN(0, 400),
      HELP("of a uniform Earth in the thermal bands, as reflected by the satellite")),
    F(earth_radius_km, UM_SCHEMA_NUMBER, DEFAULT(6378.137), BETWEEN(6000, 7000),
      HELP("of the sphere that heats and is reflected")),
    F(shadow, UM_SCHEMA_CHOICE, DEFAULT(3), .choices = shadow_choices,
      HELP("body that hides the Sun; oblate is the WGS-84 ellipsoid")),
    F(shadow_radius_km, UM_SCHEMA_NUMBER, DEFAULT(6378.137), BETWEEN(6000, 7000),
      HELP("equatorial radius of the shadow body")),
    F(disc, UM_SCHEMA_CHOICE, DEFAULT(2), .choices = disc_choices, HELP("the solar disc")),
    F(limb_darkening, UM_SCHEMA_NUMBER, DEFAULT(0.6), BETWEEN(0, 1), HELP("u in 1 - u (1 - mu)")),
    F(shadow_air, UM_SCHEMA_MAP, .object = &shadow_air_object),
    F(sun, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = sun_choices,
      HELP("frozen: direction and distance of the start hold throughout")),
    F(sun_distance_au, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0.1, 10),
      HELP("instead of the true distance")),
};
#undef OF
SHARED_OBJECT(um_model_environment_schema, struct um_scenario_environment, "environment",
              "The Sun, the Earth and its shadow.", FIELDS(environment_fields));
