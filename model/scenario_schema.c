/* The schema of scenario.yaml: every key with its type, bounds, default and meaning, once. The
 * checker, the reference page and the JSON Schema are all made from this table. */
#include "model/scenario_schema.h"

#include <math.h>

#include "model/scenario.h"
#include "orbit/time.h"

#define REQUIRED           .required = true
#define POSITIVE(top)      .minimum = 0.0, .maximum = (top), .open_minimum = true
#define BETWEEN(low, high) .minimum = (low), .maximum = (high)
#define NO_DEFAULT         .default_value = NAN
#define DEFAULT(v)         .default_value = (v)
#define UTC                .length = sizeof(double), .parse = um_orbit_time_parse_hook
#define HELP(text)         .help = (text)
#define NAMES_FILE         .file = true
#define NAME               .name = true
#define MOST(n)            .most = (n)
#define FIELDS(array)      .fields = (array), .nfield = UM_FIELD_COUNT(array)
#define OBJECT(identifier, structure, name_, help_, ...)                                           \
  static const struct um_schema_object identifier = {                                              \
      .name = (name_), .help = (help_), .size = sizeof(structure), __VA_ARGS__}

/* --- time ----------------------------------------------------------------------------------- */
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_time, member, key, type, __VA_ARGS__)
static const struct um_schema_field time_fields[] = {
    F(start, "start_utc", UM_SCHEMA_PARSED, REQUIRED, UTC,
      HELP("first observation, light received")),
    F(stop, "stop_utc", UM_SCHEMA_PARSED, REQUIRED, UTC, HELP("last observation at the latest")),
    F(step_s, "step_s", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e7), HELP("between observations")),
    F(exposure_s, "exposure_s", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e5),
      HELP("integration time; 0 is an instant")),
    F(exposure_samples, "exposure_samples", UM_SCHEMA_INTEGER, DEFAULT(5), BETWEEN(1, 1000),
      HELP("instants averaged over an exposure")),
    F(light_time, "light_time", UM_SCHEMA_BOOL, DEFAULT(1),
      HELP("false: the satellite is seen where it is when the light arrives")),
};
#undef F
OBJECT(time_object, struct um_scenario_time, "time", "When the satellite is observed.",
       FIELDS(time_fields));

/* --- orbit ---------------------------------------------------------------------------------- */
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_kepler, member, key, type, __VA_ARGS__)
static const struct um_schema_field kepler_fields[] = {
    F(epoch, "epoch_utc", UM_SCHEMA_PARSED, REQUIRED, UTC, HELP("time of the elements")),
    F(a_km, "a_km", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(6400, 1e6), HELP("semi-major axis")),
    F(e, "e", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 0.99), HELP("eccentricity")),
    F(i_deg, "i_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 180), HELP("inclination")),
    F(raan_deg, "raan_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-360, 360),
      HELP("right ascension of the ascending node, GCRS")),
    F(argp_deg, "argp_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-360, 360),
      HELP("argument of perigee")),
    F(mean_anomaly_deg, "mean_anomaly_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-360, 360),
      HELP("mean anomaly at the epoch")),
};
#undef F
OBJECT(kepler_object, struct um_scenario_kepler, "kepler", "Two-body elements in GCRS.",
       FIELDS(kepler_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_circular, member, key, type, __VA_ARGS__)
static const struct um_schema_field circular_fields[] = {
    F(epoch, "epoch_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
      HELP("when the satellite is nearest the sub-solar point; default: the start")),
    F(altitude_km, "altitude_km", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(1, 1e6),
      HELP("above environment.earth_radius_km")),
    F(beta_deg, "beta_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-90, 90),
      HELP("angle of the Sun to the orbital plane at the epoch")),
    F(period_s, "period_s", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e7),
      HELP("of one revolution; 0: Kepler's")),
};
#undef F
OBJECT(circular_object, struct um_scenario_circular, "circular",
       "Circular orbit by altitude and solar beta angle.", FIELDS(circular_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_fixed_point, member, key, type, __VA_ARGS__)
static const struct um_schema_field fixed_point_fields[] = {
    F(position_gcrs_km, "position_gcrs_km", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("a point that does not move")),
};
#undef F
OBJECT(fixed_point_object, struct um_scenario_fixed_point, "fixed", "A point fixed in GCRS.",
       FIELDS(fixed_point_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_orientation, member, key, type, __VA_ARGS__)
static const struct um_schema_field orientation_fields[] = {
    F(ut1_utc_s, "ut1_utc_s", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1, 1), HELP("UT1-UTC")),
    F(xp_arcsec, "xp_arcsec", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-2, 2), HELP("pole, x")),
    F(yp_arcsec, "yp_arcsec", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-2, 2), HELP("pole, y")),
    F(finals, "finals", UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("IERS finals2000A file instead of the numbers")),
};
#undef F
OBJECT(orientation_object, struct um_scenario_orientation, "earth_orientation",
       "Earth orientation parameters; zero when not given, and the log states what that costs.",
       FIELDS(orientation_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_station, member, key, type, __VA_ARGS__)
static const struct um_schema_field station_fields[] = {
    F(name, "name", UM_SCHEMA_TEXT, NAME, HELP("for the log")),
    F(latitude_deg, "latitude_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-90, 90),
      HELP("geodetic, WGS-84, north positive")),
    F(longitude_deg, "longitude_deg", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-180, 360),
      HELP("east positive")),
    F(height_m, "height_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-500, 1e5),
      HELP("above the ellipsoid")),
};
#undef F
OBJECT(station_object, struct um_scenario_station, "station", "A telescope on the ground.",
       FIELDS(station_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_points, member, key, type, __VA_ARGS__)
static const struct um_schema_field points_fields[] = {
    F(stations, "stations", UM_SCHEMA_LIST, MOST(10000), .object = &station_object,
      HELP("that rows may name beside observer.station; each with a name")),
};
#undef F
OBJECT(points_object, struct um_scenario_points, "points",
       "No track: every row of the measurements says where the satellite is, by "
       "satellite_height_km above the WGS-84 ellipsoid, azimuth_deg and elevation_deg; heat is not "
       "followed.",
       FIELDS(points_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_orbit, member, key, type, __VA_ARGS__)
static const struct um_schema_field orbit_fields[] = {
    F(tle, "tle", UM_SCHEMA_TEXT, .alternative = 1, HELP("two-line elements, for SGP4")),
    F(tle_file, "tle_file", UM_SCHEMA_TEXT, NAMES_FILE, .alternative = 1,
      HELP("file whose first two-line set is used")),
    F(kepler, "kepler", UM_SCHEMA_MAP, .object = &kepler_object, .alternative = 1),
    F(circular, "circular", UM_SCHEMA_MAP, .object = &circular_object, .alternative = 1),
    F(table, "table", UM_SCHEMA_TEXT, NAMES_FILE, .alternative = 1,
      HELP("CSV time_utc,x_km,y_km,z_km[,vx_km_s,vy_km_s,vz_km_s] in GCRS")),
    F(fixed, "fixed", UM_SCHEMA_MAP, .object = &fixed_point_object, .alternative = 1),
    F(points, "points", UM_SCHEMA_MAP, .object = &points_object, .alternative = 1),
    F(earth_orientation, "earth_orientation", UM_SCHEMA_MAP, .object = &orientation_object),
};
#undef F
static const int one[] = {1, 0};
OBJECT(orbit_object, struct um_scenario_orbit, "orbit", "Where the satellite is.",
       FIELDS(orbit_fields), .exactly_one = one);

/* --- attitude ------------------------------------------------------------------------------- */
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_fixed_attitude, member, key, type, __VA_ARGS__)
static const struct um_schema_field fixed_attitude_fields[] = {
    F(q_gcrs, "q_gcrs", UM_SCHEMA_VECTOR, REQUIRED, .length = 4,
      HELP("quaternion GCRS to body, scalar first, passive")),
};
#undef F
OBJECT(fixed_attitude_object, struct um_scenario_fixed_attitude, "fixed attitude",
       "Constant in GCRS.", FIELDS(fixed_attitude_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_lvlh, member, key, type, __VA_ARGS__)
static const struct um_schema_field lvlh_fields[] = {
    F(roll_deg, "roll_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("about x")),
    F(pitch_deg, "pitch_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("about y")),
    F(yaw_deg, "yaw_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("about z")),
};
#undef F
OBJECT(lvlh_object, struct um_scenario_lvlh, "lvlh",
       "Orbital frame: z to the geocentre, y against the orbit normal; then yaw, pitch, roll.",
       FIELDS(lvlh_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_pointing, member, key, type, __VA_ARGS__)
static const struct um_schema_field pointing_fields[] = {
    F(axis_body, "axis_body", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis that points")),
    F(clock_body, "clock_body", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis kept as near the orbit normal as possible")),
};
#undef F
OBJECT(pointing_object, struct um_scenario_pointing, "pointing", "A body axis follows a direction.",
       FIELDS(pointing_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_pointing, member, key, type, __VA_ARGS__)
static const struct um_schema_field yaw_steering_fields[] = {
    F(axis_body, "axis_body", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis toward the geocentre")),
    F(clock_body, "clock_body", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis kept as near the Sun as possible")),
};
#undef F
OBJECT(yaw_steering_object, struct um_scenario_pointing, "yaw steering",
       "A body axis looks at the geocentre, another stays in the plane of nadir and Sun.",
       FIELDS(yaw_steering_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_spin, member, key, type, __VA_ARGS__)
static const struct um_schema_field spin_fields[] = {
    F(axis_gcrs, "axis_gcrs", UM_SCHEMA_NUMBERS, .alternative = 1, HELP("spin axis, inertial")),
    F(axis_lvlh, "axis_lvlh", UM_SCHEMA_NUMBERS, .alternative = 1,
      HELP("spin axis that turns with the orbital frame")),
    F(q_gcrs, "q_gcrs", UM_SCHEMA_NUMBERS, .alternative = 1,
      HELP("attitude at at_utc; the axis is then axis_body as it stands there, inertial")),
    F(axis_body, "axis_body", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("the same axis in the body")),
    F(period_s, "period_s", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-1e7, 1e7),
      HELP("of one turn; positive is right-handed about the axis")),
    F(phase_deg, "phase_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360),
      HELP("turn at at_utc")),
    F(at_utc, "at_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
      HELP("when the phase holds; default: the start")),
};
#undef F
OBJECT(spin_object, struct um_scenario_spin, "spin", "Steady rotation about one axis.",
       FIELDS(spin_fields), .exactly_one = one);

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_magnetic, member, key, type, __VA_ARGS__)
static const struct um_schema_field magnetic_fields[] = {
    F(axis_body, "axis_body", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis along the field, which points north over the equator and down in the north")),
    F(clock_body, "clock_body", UM_SCHEMA_NUMBERS,
      HELP("body axis kept as near the orbit normal as possible at phase 0; default: some axis "
           "across axis_body")),
    F(period_s, "period_s", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e7, 1e7),
      HELP("of one turn about the axis, right-handed; 0: it does not turn")),
    F(phase_deg, "phase_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360),
      HELP("turn at at_utc")),
    F(at_utc, "at_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
      HELP("when the phase holds; default: the start")),
};
#undef F
OBJECT(magnetic_object, struct um_scenario_magnetic, "magnetic",
       "A passive magnet: a body axis lies along the Earth's magnetic field (IGRF-14 to degree 4).",
       FIELDS(magnetic_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_attitude_table, member, key, type, __VA_ARGS__)
static const struct um_schema_field attitude_table_fields[] = {
    F(file, "file", UM_SCHEMA_TEXT, REQUIRED, NAMES_FILE,
      HELP("CSV time_utc,q0,q1,q2,q3 GCRS to body")),
    F(max_gap_s, "max_gap_s", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e7),
      HELP("longest step that is interpolated; 0: ten times the median")),
};
#undef F
OBJECT(attitude_table_object, struct um_scenario_attitude_table, "attitude table",
       "Quaternions from a file.", FIELDS(attitude_table_fields), .scalar_key = "file");

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_attitude, member, key, type, __VA_ARGS__)
static const struct um_schema_field attitude_fields[] = {
    F(from, "from_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
      HELP("the law holds from here on; the first one holds from the beginning")),
    F(fixed, "fixed", UM_SCHEMA_MAP, .object = &fixed_attitude_object, .alternative = 1),
    F(lvlh, "lvlh", UM_SCHEMA_MAP, .object = &lvlh_object, .alternative = 1),
    F(sun, "sun", UM_SCHEMA_MAP, .object = &pointing_object, .alternative = 1),
    F(target, "target", UM_SCHEMA_MAP, .object = &pointing_object, .alternative = 1,
      HELP("like sun, toward the observer")),
    F(yaw_steering, "yaw_steering", UM_SCHEMA_MAP, .object = &yaw_steering_object,
      .alternative = 1),
    F(spin, "spin", UM_SCHEMA_MAP, .object = &spin_object, .alternative = 1),
    F(magnetic, "magnetic", UM_SCHEMA_MAP, .object = &magnetic_object, .alternative = 1),
    F(table, "table", UM_SCHEMA_MAP, .object = &attitude_table_object, .alternative = 1),
};
#undef F
OBJECT(attitude_object, struct um_scenario_attitude, "attitude law", "How the satellite is turned.",
       FIELDS(attitude_fields), .exactly_one = one);

/* --- observer ------------------------------------------------------------------------------- */
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_direction, member, key, type, __VA_ARGS__)
static const struct um_schema_field direction_fields[] = {
    F(unit_gcrs, "unit_gcrs", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("from the satellite toward the observer")),
    F(range_km, "range_km", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e9), HELP("to the observer")),
};
#undef F
OBJECT(direction_object, struct um_scenario_direction, "direction",
       "An observer in a fixed direction.", FIELDS(direction_fields));

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_moving_observer, member, key, type, __VA_ARGS__)
static const struct um_schema_field moving_observer_fields[] = {
    F(tle, "tle", UM_SCHEMA_TEXT, .alternative = 1, HELP("two-line elements of the observer")),
    F(table, "table", UM_SCHEMA_TEXT, NAMES_FILE, .alternative = 1, HELP("CSV as for orbit.table")),
};
#undef F
OBJECT(moving_observer_object, struct um_scenario_moving_observer, "trajectory",
       "An observer in orbit.", FIELDS(moving_observer_fields), .exactly_one = one);

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_observer, member, key, type, __VA_ARGS__)
static const struct um_schema_field observer_fields[] = {
    F(station, "station", UM_SCHEMA_MAP, .object = &station_object, .alternative = 1),
    F(direction, "direction", UM_SCHEMA_MAP, .object = &direction_object, .alternative = 1),
    F(trajectory, "trajectory", UM_SCHEMA_MAP, .object = &moving_observer_object, .alternative = 1),
    F(minimum_elevation_deg, "minimum_elevation_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0),
      BETWEEN(-5, 90), HELP("for `umbra passes`")),
};
#undef F
OBJECT(observer_object, struct um_scenario_observer, "observer", "Who looks.",
       FIELDS(observer_fields), .exactly_one = one);

/* --- environment ---------------------------------------------------------------------------- */
static const char *const spectrum_choices[] = {"e490", "black_body", NULL};
static const char *const shadow_choices[] = {"none", "cylinder", "sphere", "oblate", NULL};
static const char *const disc_choices[] = {"point", "uniform", "limb_darkened", NULL};
static const char *const sun_choices[] = {"ephemeris", "frozen", NULL};
static const char *const earth_choices[] = {"uniform", "knocke", "map", NULL};
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_region, member, key, type, __VA_ARGS__)
static const struct um_schema_field region_fields[] = {
    F(latitude_deg, "latitude_deg", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-90, 90),
      HELP("of its centre; without a place all of the Earth")),
    F(longitude_deg, "longitude_deg", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-180, 360),
      HELP("of its centre, east")),
    F(radius_km, "radius_km", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(10, 20100),
      HELP("along the ground")),
    F(edge_km, "edge_km", UM_SCHEMA_NUMBER, DEFAULT(500.0), BETWEEN(0, 10000),
      HELP("over which it goes over into the rest, half way at the radius")),
    F(from, "from_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
      HELP("acts from here on; default: the start, or always where a place is given")),
    F(to, "to_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC, HELP("until here; default: for good")),
    F(ramp_s, "ramp_s", UM_SCHEMA_NUMBER, DEFAULT(60.0), BETWEEN(0, 1e6),
      HELP("over which it comes and goes, half way at from_utc and to_utc")),
    F(albedo_factor, "albedo_factor", UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0, 10),
      HELP("of what the Earth has there")),
    F(albedo_offset, "albedo_offset", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1, 1),
      HELP("added behind the factor")),
    F(olr_factor, "olr_factor", UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0, 10),
      HELP("of its outgoing longwave radiation")),
    F(olr_offset_W_m2, "olr_offset_W_m2", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1000, 1000),
      HELP("added behind the factor")),
    F(brightness_shift_K, "brightness_shift_K", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-200, 200),
      HELP("added to its brightness temperature")),
};
#undef F
OBJECT(region_object, struct um_scenario_region, "local",
       "A part of the Earth, or of the time, with a level of its own; local_albedo and "
       "local_earth_ir act on it too.",
       FIELDS(region_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_earth, member, key, type, __VA_ARGS__)
static const struct um_schema_field earth_fields[] = {
    F(model, "model", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = earth_choices,
      HELP("uniform: albedo, olr_W_m2 and brightness_temperature_K of the environment; knocke: by "
           "latitude and season; map: monthly grids of the file")),
    F(file, "file", UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV or netCDF of model map; what it lacks is knocke's")),
    F(local, "local", UM_SCHEMA_MAP, .object = &region_object),
};
#undef F
OBJECT(earth_object, struct um_scenario_earth, "earth",
       "What the Earth reflects and emits from place to place.", FIELDS(earth_fields),
       .scalar_key = "model");
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_environment, member, key, type, __VA_ARGS__)
static const struct um_schema_field environment_fields[] = {
    F(solar_irradiance_W_m2, "solar_irradiance_W_m2", UM_SCHEMA_NUMBER, DEFAULT(1361.0),
      BETWEEN(0, 1e5), HELP("at 1 au")),
    F(solar_spectrum, "solar_spectrum", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = spectrum_choices,
      HELP("ASTM E490 or a black body, scaled to the irradiance")),
    F(solar_temperature_K, "solar_temperature_K", UM_SCHEMA_NUMBER, DEFAULT(5772.0),
      BETWEEN(1000, 50000), HELP("of the black body")),
    F(earth, "earth", UM_SCHEMA_MAP, .object = &earth_object),
    F(albedo, "albedo", UM_SCHEMA_NUMBER, DEFAULT(0.30), BETWEEN(0, 1),
      HELP("Lambert, of a uniform Earth")),
    F(olr_W_m2, "olr_W_m2", UM_SCHEMA_NUMBER, DEFAULT(237.0), BETWEEN(0, 1000),
      HELP("outgoing longwave radiation of a uniform Earth")),
    F(brightness_temperature_K, "brightness_temperature_K", UM_SCHEMA_NUMBER, DEFAULT(270.0),
      BETWEEN(0, 400),
      HELP("of a uniform Earth in the thermal bands, as reflected by the satellite")),
    F(earth_radius_km, "earth_radius_km", UM_SCHEMA_NUMBER, DEFAULT(6378.137), BETWEEN(6000, 7000),
      HELP("of the sphere that heats and is reflected")),
    F(shadow, "shadow", UM_SCHEMA_CHOICE, DEFAULT(3), .choices = shadow_choices,
      HELP("body that hides the Sun; oblate is the WGS-84 ellipsoid")),
    F(shadow_radius_km, "shadow_radius_km", UM_SCHEMA_NUMBER, DEFAULT(6378.137),
      BETWEEN(6000, 7000), HELP("equatorial radius of the shadow body")),
    F(disc, "disc", UM_SCHEMA_CHOICE, DEFAULT(2), .choices = disc_choices, HELP("the solar disc")),
    F(limb_darkening, "limb_darkening", UM_SCHEMA_NUMBER, DEFAULT(0.6), BETWEEN(0, 1),
      HELP("u in 1 - u (1 - mu)")),
    F(sun, "sun", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = sun_choices,
      HELP("frozen: direction and distance of the start hold throughout")),
    F(sun_distance_au, "sun_distance_au", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0.1, 10),
      HELP("instead of the true distance")),
};
#undef F
OBJECT(environment_object, struct um_scenario_environment, "environment",
       "The Sun, the Earth and its shadow.", FIELDS(environment_fields));

/* --- parts ---------------------------------------------------------------------------------- */
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_box, member, key, type, __VA_ARGS__)
static const struct um_schema_field box_fields[] = {
    F(size_m, "size_m", UM_SCHEMA_VECTOR, REQUIRED, .length = 3, POSITIVE(1e4), HELP("x, y, z")),
};
#undef F
OBJECT(box_object, struct um_scenario_box, "box", "Closed; groups +x -x +y -y +z -z.",
       FIELDS(box_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_plate, member, key, type, __VA_ARGS__)
static const struct um_schema_field plate_fields[] = {
    F(size_m, "size_m", UM_SCHEMA_VECTOR, REQUIRED, .length = 2, POSITIVE(1e4),
      HELP("x, y; the front looks to +z")),
};
#undef F
OBJECT(plate_object, struct um_scenario_plate, "plate", "Open, two sides; group plate.",
       FIELDS(plate_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_round, member, key, type, __VA_ARGS__)
#define RADIUS                    F(radius_m, "radius_m", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("radius"))
#define HEIGHT                    F(height_m, "height_m", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e4), HELP("along z"))
static const struct um_schema_field radius_fields[] = {RADIUS};
static const struct um_schema_field cylinder_fields[] = {RADIUS, HEIGHT};
static const struct um_schema_field cone_fields[] = {
    RADIUS, HEIGHT,
    F(radius_top_m, "radius_top_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e4),
      HELP("at +z; 0 is a point"))};
static const struct um_schema_field paraboloid_fields[] = {
    RADIUS, F(focal_length_m, "focal_length_m", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e5),
              HELP("z = r^2/(4 f)"))};
#undef F
OBJECT(disc_object, struct um_scenario_round, "disc", "Open, front to +z; group disc.",
       FIELDS(radius_fields));
OBJECT(sphere_object, struct um_scenario_round, "sphere", "Closed; group sphere.",
       FIELDS(radius_fields));
OBJECT(cylinder_object, struct um_scenario_round, "cylinder", "Closed; groups side top bottom.",
       FIELDS(cylinder_fields));
OBJECT(cone_object, struct um_scenario_round, "cone", "Closed; groups side top bottom.",
       FIELDS(cone_fields));
OBJECT(paraboloid_object, struct um_scenario_round, "paraboloid",
       "Dish, open, concave front to +z; group dish.", FIELDS(paraboloid_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_mesh, member, key, type, __VA_ARGS__)
static const struct um_schema_field mesh_fields[] = {
    F(file, "file", UM_SCHEMA_TEXT, REQUIRED, NAMES_FILE,
      HELP("Wavefront OBJ; its groups are the groups")),
    F(scale, "scale", UM_SCHEMA_NUMBER, DEFAULT(1.0), POSITIVE(1e6), HELP("metres per unit")),
};
#undef F
OBJECT(mesh_object, struct um_scenario_mesh, "mesh", "A mesh from a file.", FIELDS(mesh_fields),
       .scalar_key = "file");
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_pose, member, key, type, __VA_ARGS__)
static const struct um_schema_field pose_fields[] = {
    F(position_m, "position_m", UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("of the part's origin in its parent")),
    F(rotation_deg, "rotation_deg", UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("the part is turned about the parent's z, then its new y, then its new x: [x, y, z]")),
};
#undef F
OBJECT(pose_object, struct um_scenario_pose, "pose", "Where a part sits in its parent.",
       FIELDS(pose_fields));
static const char *const track_choices[] = {"none", "sun", NULL};
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_joint, member, key, type, __VA_ARGS__)
static const struct um_schema_field joint_fields[] = {
    F(axis, "axis", UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("in the part, through its origin")),
    F(angle_deg, "angle_deg", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360),
      HELP("fixed turn, or offset when tracking")),
    F(track, "track", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = track_choices,
      HELP("what to follow")),
    F(normal, "normal", UM_SCHEMA_VECTOR, DEFAULT(0.0), .length = 3,
      HELP("direction of the part turned toward what is tracked")),
};
#undef F
OBJECT(joint_object, struct um_scenario_joint, "joint", "One-axis joint.", FIELDS(joint_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_skin, member, key, type, __VA_ARGS__)
static const struct um_schema_field skin_fields[] = {
    F(front, "front", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("material outside, or of the front")),
    F(back, "back", UM_SCHEMA_TEXT, NAME, HELP("material of the back of an open surface")),
};
#undef F
OBJECT(skin_object, struct um_scenario_skin, "materials of a group", "What a group is made of.",
       FIELDS(skin_fields), .scalar_key = "front");

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_shell, member, key, type, __VA_ARGS__)
static const struct um_schema_field shell_fields[] = {
    F(areal_heat_capacity_J_m2_K, "areal_heat_capacity_J_m2_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      POSITIVE(1e9), HELP("of the whole wall; or by material and thickness_mm")),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 1e6),
      HELP("in plane, k t; default 0, or by material and thickness_mm")),
    F(through_conductance_W_m2_K, "through_conductance_W_m2_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      BETWEEN(0, 1e9), HELP("between the two sides; default: both sides are one temperature")),
    F(front_share, "front_share", UM_SCHEMA_NUMBER, DEFAULT(0.5), BETWEEN(0.001, 0.999),
      HELP("share of capacity and conductance in the front layer")),
    F(material, "material", UM_SCHEMA_TEXT, NAME,
      HELP("record whose thermal properties fill the wall")),
    F(thickness_mm, "thickness_mm", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("of the wall, with material")),
};
#undef F
OBJECT(shell_object, struct um_scenario_shell, "shell", "The wall of a part as a thin sheet.",
       FIELDS(shell_fields));
static const char *const wraps_choices[] = {"wall", "interior", NULL};
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_mli, member, key, type, __VA_ARGS__)
static const struct um_schema_field mli_fields[] = {
    F(effective_emittance, "effective_emittance", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 1),
      HELP("e*, between the outer layer and what it wraps")),
    F(areal_heat_capacity_J_m2_K, "areal_heat_capacity_J_m2_K", UM_SCHEMA_NUMBER, REQUIRED,
      POSITIVE(1e6), HELP("of the outer layer")),
    F(wraps, "wraps", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = wraps_choices,
      HELP("the wall, or the interior directly (then there is no wall)")),
};
#undef F
OBJECT(mli_object, struct um_scenario_mli, "mli", "Multi-layer insulation on the outside.",
       FIELDS(mli_fields));
#define POWER_FILE                                                                                 \
  "CSV time_utc,power_W, added to power_W: linear between rows, a jump where two rows have one "   \
  "time, 0 before the first and after the last; satellite's own time"
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_interior, member, key, type, __VA_ARGS__)
static const struct um_schema_field interior_fields[] = {
    F(capacity_J_K, "capacity_J_K", UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e12),
      HELP("of everything inside")),
    F(power_W, "power_W", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated inside")),
    F(power_file, "power_file", UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e6),
      HELP("to the walls, shared by area among groups that state none")),
};
#undef F
OBJECT(interior_object, struct um_scenario_interior, "interior", "One node inside the part.",
       FIELDS(interior_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_solid, member, key, type, __VA_ARGS__)
static const struct um_schema_field solid_fields[] = {
    F(material, "material", UM_SCHEMA_TEXT, NAME,
      HELP("record with density, specific heat, conductivity")),
    F(density_kg_m3, "density_kg_m3", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("instead of the record's")),
    F(specific_heat_J_kg_K, "specific_heat_J_kg_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("instead of the record's")),
    F(conductivity_W_m_K, "conductivity_W_m_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("instead of the record's")),
    F(tetrahedron_size_m, "tetrahedron_size_m", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e3),
      HELP("longest edge wanted; 0: the facet size")),
};
#undef F
OBJECT(solid_object, struct um_scenario_solid, "solid",
       "The part is solid: tetrahedra, three-dimensional conduction.", FIELDS(solid_fields),
       .scalar_key = "material");
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_group, member, key, type, __VA_ARGS__)
static const struct um_schema_field group_fields[] = {
    F(shell, "shell", UM_SCHEMA_MAP, .object = &shell_object),
    F(mli, "mli", UM_SCHEMA_MAP, .object = &mli_object),
    F(bare, "bare", UM_SCHEMA_BOOL, DEFAULT(0), HELP("no MLI here although the part has one")),
    F(interior_conductance_W_K, "interior_conductance_W_K", UM_SCHEMA_NUMBER, NO_DEFAULT,
      BETWEEN(0, 1e6), HELP("of the whole group to the interior")),
    F(power_W, "power_W", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e6, 1e6),
      HELP("dissipated in the wall of the group, both layers")),
    F(power_file, "power_file", UM_SCHEMA_TEXT, NAMES_FILE, HELP(POWER_FILE)),
};
#undef F
OBJECT(group_object, struct um_scenario_group, "group", "What differs thermally on one group.",
       FIELDS(group_fields));

#define F(member, key, type, ...) UM_FIELD(struct um_scenario_part, member, key, type, __VA_ARGS__)
static const struct um_schema_field part_fields[] = {
    F(name, "name", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("unique; no dots, no slashes")),
    F(parent, "parent", UM_SCHEMA_TEXT, NAME,
      HELP("part that carries this one; default: the body frame")),
    F(box, "box", UM_SCHEMA_MAP, .object = &box_object, .alternative = 1),
    F(plate, "plate", UM_SCHEMA_MAP, .object = &plate_object, .alternative = 1),
    F(disc, "disc", UM_SCHEMA_MAP, .object = &disc_object, .alternative = 1),
    F(cylinder, "cylinder", UM_SCHEMA_MAP, .object = &cylinder_object, .alternative = 1),
    F(cone, "cone", UM_SCHEMA_MAP, .object = &cone_object, .alternative = 1),
    F(sphere, "sphere", UM_SCHEMA_MAP, .object = &sphere_object, .alternative = 1),
    F(paraboloid, "paraboloid", UM_SCHEMA_MAP, .object = &paraboloid_object, .alternative = 1),
    F(mesh, "mesh", UM_SCHEMA_MAP, .object = &mesh_object, .alternative = 1),
    F(pose, "pose", UM_SCHEMA_MAP, .object = &pose_object),
    F(joint, "joint", UM_SCHEMA_MAP, .object = &joint_object),
    F(outside, "outside", UM_SCHEMA_TEXT, NAME, HELP("material of a closed part")),
    F(front, "front", UM_SCHEMA_TEXT, NAME, HELP("material of the front of an open part")),
    F(back, "back", UM_SCHEMA_TEXT, NAME, HELP("material of the back of an open part")),
    F(materials, "materials", UM_SCHEMA_DICT, MOST(10000), .object = &skin_object,
      HELP("material by group, before outside/front/back")),
    F(groups, "groups", UM_SCHEMA_DICT, MOST(10000), .object = &group_object,
      HELP("thermal properties by group, before the part's own")),
    F(shell, "shell", UM_SCHEMA_MAP, .object = &shell_object),
    F(mli, "mli", UM_SCHEMA_MAP, .object = &mli_object),
    F(interior, "interior", UM_SCHEMA_MAP, .object = &interior_object),
    F(solid, "solid", UM_SCHEMA_MAP, .object = &solid_object),
    F(lumped, "lumped", UM_SCHEMA_BOOL, DEFAULT(0), HELP("one isothermal node per group and side")),
    F(facet_size_m, "facet_size_m", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("longest facet edge; default thermal.facet_size_m")),
    F(start_temperature_K, "start_temperature_K", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(5000),
      HELP("default thermal.start_temperature_K")),
    F(electrical_extraction, "electrical_extraction", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1),
      HELP("share of direct sunlight on the front that leaves as electricity")),
};
#undef F
OBJECT(part_object, struct um_scenario_part, "part", "One piece of the satellite.",
       FIELDS(part_fields), .exactly_one = one);

#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_contact, member, key, type, __VA_ARGS__)
static const struct um_schema_field contact_fields[] = {
    F(a, "a", UM_SCHEMA_TEXT, NAME, REQUIRED,
      HELP("part, part.group, part.front, part.back or part.interior")),
    F(b, "b", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("the other end")),
    F(conductance_W_K, "conductance_W_K", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 1e9),
      HELP("of the whole contact")),
};
#undef F
OBJECT(contact_object, struct um_scenario_contact, "contact", "Heat conducted between two places.",
       FIELDS(contact_fields));

/* --- thermal, bands, optics, effects -------------------------------------------------------- */
static const char *const start_choices[] = {"periodic", "isothermal", NULL};
static const char *const temperature_choices[] = {"facet", "material_mean", NULL};
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_thermal, member, key, type, __VA_ARGS__)
static const struct um_schema_field thermal_fields[] = {
    F(orbits_before, "orbits_before", UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0, 10000),
      HELP("orbits computed before the first observation")),
    F(start, "start", UM_SCHEMA_CHOICE, DEFAULT(0), .choices = start_choices,
      HELP("periodic: the state that repeats after one orbit; isothermal: start_temperature_K")),
    F(start_temperature_K, "start_temperature_K", UM_SCHEMA_NUMBER, DEFAULT(280.0), POSITIVE(5000),
      HELP("everywhere, or first guess of periodic")),
    F(facet_size_m, "facet_size_m", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e4),
      HELP("longest facet edge; default: as coarse as the shapes allow")),
    F(step_s, "step_s", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5),
      HELP("grid of the loads; default: 4.6 deg of turn, at most 10 s")),
    F(relative_tolerance, "relative_tolerance", UM_SCHEMA_NUMBER, DEFAULT(2e-7),
      BETWEEN(1e-12, 1e-2), HELP("of the integrator")),
    F(absolute_tolerance_K, "absolute_tolerance_K", UM_SCHEMA_NUMBER, DEFAULT(2e-5),
      BETWEEN(1e-9, 1), HELP("of the integrator")),
    F(samples, "samples", UM_SCHEMA_INTEGER, DEFAULT(4), BETWEEN(1, 4096),
      HELP("points per facet for the shadow of the satellite on itself")),
    F(exchange_patches, "exchange_patches", UM_SCHEMA_INTEGER, DEFAULT(512), BETWEEN(1, 4096),
      HELP("between which surfaces exchange radiation; more surfaces are gathered into these")),
    F(view_factor_rays, "view_factor_rays", UM_SCHEMA_INTEGER, DEFAULT(4096), BETWEEN(16, 1048576),
      HELP("from each patch, for view factors")),
    F(space_temperature_K, "space_temperature_K", UM_SCHEMA_NUMBER, DEFAULT(2.7), BETWEEN(0, 100),
      HELP("of deep space")),
    F(temperature_in_optics, "temperature_in_optics", UM_SCHEMA_CHOICE, DEFAULT(0),
      .choices = temperature_choices, HELP("what the renderer emits with")),
};
#undef F
OBJECT(thermal_object, struct um_scenario_thermal, "thermal", "How temperatures are computed.",
       FIELDS(thermal_fields));
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_band, member, key, type, __VA_ARGS__)
static const struct um_schema_field band_fields[] = {
    F(from_um, "from_um", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0.2, 100), HELP("lower edge")),
    F(to_um, "to_um", UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0.2, 100), HELP("upper edge")),
    F(bins, "bins", UM_SCHEMA_INTEGER, DEFAULT(40), BETWEEN(1, 2000), HELP("of equal width")),
};
#undef F
OBJECT(band_object, struct um_scenario_band, "band", "A spectral band.", FIELDS(band_fields));
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_optics, member, key, type, __VA_ARGS__)
static const struct um_schema_field optics_fields[] = {
    F(samples, "samples", UM_SCHEMA_INTEGER, DEFAULT(16), BETWEEN(1, 65536),
      HELP("points per facet that look at observer and Sun")),
    F(interreflection_samples, "interreflection_samples", UM_SCHEMA_INTEGER, DEFAULT(0),
      BETWEEN(0, 4096), HELP("rays per point for light between surfaces; 0: none")),
};
#undef F
OBJECT(optics_object, struct um_scenario_optics, "optics", "How light curves are computed.",
       FIELDS(optics_fields));
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_effect, member, key, type, __VA_ARGS__)
static const struct um_schema_field effect_fields[] = {
    F(effect, "effect", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("name, see `umbra effects`")),
    F(target, "target", UM_SCHEMA_TEXT, NAME, HELP("part, part.side, material or band it acts on")),
    F(off, "off", UM_SCHEMA_BOOL, DEFAULT(0), HELP("true: switched off")),
    F(parameters, "PARAMETER", UM_SCHEMA_REST, HELP("of the effect, see `umbra effects NAME`")),
};
#undef F
OBJECT(effect_object, struct um_scenario_effect, "effect", "One physical effect.",
       FIELDS(effect_fields));

/* --- measurements --------------------------------------------------------------------------- */
static const char *const quantity_choices[] = {"band_irradiance",
                                               "radiant_intensity",
                                               "magnitude_ab",
                                               "magnitude_vega",
                                               "count_rate",
                                               "temperature",
                                               NULL};
#define F(member, key, type, ...) UM_FIELD(struct um_scenario_noise, member, key, type, __VA_ARGS__)
static const struct um_schema_field noise_fields[] = {
    F(quantity, "quantity", UM_SCHEMA_CHOICE, REQUIRED, .choices = quantity_choices,
      HELP("of the rows that it is for")),
    F(of, "of", UM_SCHEMA_TEXT, NAME,
      HELP("band or place as in the rows; default: all that no other entry names")),
    F(relative, "relative", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 10),
      HELP("of the model's value; of magnitudes, of the flux")),
    F(floor, "floor", UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e30),
      HELP("in the unit of the quantity; sigma^2 = (relative value)^2 + floor^2")),
};
#undef F
OBJECT(noise_object, struct um_scenario_noise, "noise", "Sigma of the rows that state none.",
       FIELDS(noise_fields));
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_nuisance, member, key, type, __VA_ARGS__)
static const struct um_schema_field nuisance_fields[] = {
    F(effect, "effect", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("name, see `umbra effects`")),
    F(target, "target", UM_SCHEMA_TEXT, NAME, HELP("part, part.side, material or band it acts on")),
    F(sigma, "sigma", UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e30),
      HELP("how far its parameters may be from the scenario's, in their unit, as a fraction for "
           "positive factors; default: the width of their prior")),
    F(free, "free", UM_SCHEMA_BOOL, DEFAULT(0), HELP("true: no such width, instead of sigma")),
    F(per, "per", UM_SCHEMA_TEXT,
      HELP("set: one value for all measurements, the default; nothing else is accepted")),
};
#undef F
OBJECT(nuisance_object, struct um_scenario_nuisance, "nuisance",
       "An effect that is uncertain anyway: a diagnosis fits it along and never names it.",
       FIELDS(nuisance_fields));
#define F(member, key, type, ...)                                                                  \
  UM_FIELD(struct um_scenario_measurements, member, key, type, __VA_ARGS__)
static const struct um_schema_field measurements_fields[] = {
    F(noise, "noise", UM_SCHEMA_LIST, MOST(1000), .object = &noise_object),
    F(nuisance, "nuisance", UM_SCHEMA_LIST, MOST(1000), .object = &nuisance_object),
    F(exclude, "exclude", UM_SCHEMA_TEXTS, MOST(1000), NAME,
      HELP("effects, EFFECT or EFFECT:TARGET, that a diagnosis does not try")),
};
#undef F
OBJECT(measurements_object, struct um_scenario_measurements, "measurements",
       "What is known of measurements beside their file.", FIELDS(measurements_fields));

/* --- the whole ------------------------------------------------------------------------------ */
#define F(member, key, type, ...) UM_FIELD(struct um_scenario, member, key, type, __VA_ARGS__)
static const struct um_schema_field scenario_fields[] = {
    F(schema, "schema", UM_SCHEMA_INTEGER, REQUIRED, BETWEEN(1, 1.5),
      HELP("version of this format: 1")),
    F(name, "name", UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("names the output folder")),
    F(summary, "summary", UM_SCHEMA_TEXT, HELP("one sentence")),
    F(time, "time", UM_SCHEMA_MAP, REQUIRED, .object = &time_object),
    F(orbit, "orbit", UM_SCHEMA_MAP, REQUIRED, .object = &orbit_object),
    F(attitude, "attitude", UM_SCHEMA_LIST, MOST(10000), REQUIRED, .object = &attitude_object,
      HELP("laws in order of time")),
    F(observer, "observer", UM_SCHEMA_MAP, .object = &observer_object),
    F(environment, "environment", UM_SCHEMA_MAP, .always = true, .object = &environment_object),
    F(material_files, "material_files", UM_SCHEMA_TEXTS, MOST(1000), NAMES_FILE,
      HELP("files of material records that add to the library or replace its names")),
    F(parts, "parts", UM_SCHEMA_LIST, MOST(5000), REQUIRED, .object = &part_object),
    F(contacts, "contacts", UM_SCHEMA_LIST, MOST(50000), .object = &contact_object),
    F(thermal, "thermal", UM_SCHEMA_MAP, .always = true, .object = &thermal_object),
    F(bands, "bands", UM_SCHEMA_DICT, MOST(500), .object = &band_object,
      HELP("default: vis 0.38-0.78 um in 80 bins, lwir 8-12 um in 40")),
    F(optics, "optics", UM_SCHEMA_MAP, .always = true, .object = &optics_object),
    F(effect_files, "effect_files", UM_SCHEMA_TEXTS, MOST(100), NAMES_FILE,
      HELP(
          "shared objects with effects of your own, which run inside the program; loaded only with "
          "--allow-effects, or where --effect-file names them too")),
    F(effects, "effects", UM_SCHEMA_LIST, MOST(1000), .object = &effect_object),
    F(measurements, "measurements", UM_SCHEMA_MAP, .object = &measurements_object),
};
#undef F
const struct um_schema_object um_model_scenario_schema = {
    .name = "scenario",
    .help = "What is observed, from where, when, and what it is made of.",
    .size = sizeof(struct um_scenario),
    FIELDS(scenario_fields)};
