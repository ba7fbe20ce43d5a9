/* Keys of scenario.yaml: orbit, attitude and observer. */
#include "model/scenario/scenario_schema_group.h"

/* --- orbit ---------------------------------------------------------------------------------- */
#define OF struct um_scenario_kepler
static const struct um_schema_field kepler_fields[] = {
    F_AS(epoch, "epoch_utc", UM_SCHEMA_PARSED, REQUIRED, UTC, HELP("time of the elements")),
    F(a_km, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(6400, 1e6), HELP("semi-major axis")),
    F(e, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 0.99), HELP("eccentricity")),
    F(i_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(0, 180), HELP("inclination")),
    F(raan_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-360, 360),
      HELP("right ascension of the ascending node, GCRS")),
    F(argp_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-360, 360), HELP("argument of perigee")),
    F(mean_anomaly_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-360, 360),
      HELP("mean anomaly at the epoch")),
};
#undef OF
OBJECT(kepler_object, struct um_scenario_kepler, "kepler", "Two-body elements in GCRS.",
       FIELDS(kepler_fields));

#define OF struct um_scenario_circular
static const struct um_schema_field circular_fields[] = {
    F_AS(epoch, "epoch_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
         HELP("when the satellite is nearest the sub-solar point; default: the start")),
    F(altitude_km, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(1, 1e6),
      HELP("above environment.earth_radius_km")),
    F(beta_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-90, 90),
      HELP("angle of the Sun to the orbital plane at the epoch")),
    F(period_s, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e7),
      HELP("of one revolution; 0: Kepler's")),
};
#undef OF
OBJECT(circular_object, struct um_scenario_circular, "circular",
       "Circular orbit by altitude and solar beta angle.", FIELDS(circular_fields));

#define OF struct um_scenario_fixed_point
static const struct um_schema_field fixed_point_fields[] = {
    F(position_gcrs_km, UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("a point that does not move")),
};
#undef OF
OBJECT(fixed_point_object, struct um_scenario_fixed_point, "fixed", "A point fixed in GCRS.",
       FIELDS(fixed_point_fields));

#define OF struct um_scenario_orientation
static const struct um_schema_field orientation_fields[] = {
    F(ut1_utc_s, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1, 1), HELP("UT1-UTC")),
    F(xp_arcsec, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-2, 2), HELP("pole, x")),
    F(yp_arcsec, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-2, 2), HELP("pole, y")),
    F(finals, UM_SCHEMA_TEXT, NAMES_FILE, HELP("IERS finals2000A file instead of the numbers")),
};
#undef OF
OBJECT(orientation_object, struct um_scenario_orientation, "earth_orientation",
       "Earth orientation parameters; zero when not given, and the log states what that costs.",
       FIELDS(orientation_fields));

#define OF struct um_scenario_station
static const struct um_schema_field station_fields[] = {
    F(name, UM_SCHEMA_TEXT, NAME, HELP("for the log")),
    F(latitude_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-90, 90),
      HELP("geodetic, WGS-84, north positive")),
    F(longitude_deg, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-180, 360), HELP("east positive")),
    F(height_m, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-500, 1e5), HELP("above the ellipsoid")),
};
#undef OF
OBJECT(station_object, struct um_scenario_station, "station", "A telescope on the ground.",
       FIELDS(station_fields));

OBJECT(points_object, struct um_scenario_points, "points",
       "No track: every row of the measurements says where the satellite is, by "
       "satellite_height_km above the WGS-84 ellipsoid, azimuth_deg and elevation_deg; heat is not "
       "followed.",
       .nfield = 0);

#define OF struct um_scenario_elements
static const struct um_schema_field elements_fields[] = {
    F(file, UM_SCHEMA_TEXT, REQUIRED, NAMES_FILE,
      HELP("two-line elements, or mean-elements messages (OMM) as key = value, XML, JSON or CSV; "
           "of several sets the nearest in time serves")),
    F(object, UM_SCHEMA_INTEGER, DEFAULT(0), BETWEEN(0, 999999999),
      HELP("catalogue number; 0: the only one of the file")),
};
#undef OF
OBJECT(elements_object, struct um_scenario_elements, "elements", "Element sets for SGP4.",
       FIELDS(elements_fields), .scalar_key = "file");

#define OF struct um_scenario_orbit
static const struct um_schema_field orbit_fields[] = {
    F(tle, UM_SCHEMA_TEXT, .alternative = 1, HELP("two-line elements, for SGP4")),
    F(tle_file, UM_SCHEMA_TEXT, NAMES_FILE, .alternative = 1,
      HELP("the same as elements with its file alone")),
    F(elements, UM_SCHEMA_MAP, .object = &elements_object, .alternative = 1),
    F(kepler, UM_SCHEMA_MAP, .object = &kepler_object, .alternative = 1),
    F(circular, UM_SCHEMA_MAP, .object = &circular_object, .alternative = 1),
    F(table, UM_SCHEMA_TEXT, NAMES_FILE, .alternative = 1,
      HELP("CSV time_utc,x_km,y_km,z_km[,vx_km_s,vy_km_s,vz_km_s] in GCRS, or an ephemeris "
           "message (OEM) or a file of STK, which say their frame")),
    F(fixed, UM_SCHEMA_MAP, .object = &fixed_point_object, .alternative = 1),
    F(points, UM_SCHEMA_MAP, .object = &points_object, .alternative = 1),
    F(earth_orientation, UM_SCHEMA_MAP, .object = &orientation_object),
};
#undef OF
static const int one[] = {1, 0};
SHARED_OBJECT(um_model_orbit_schema, struct um_scenario_orbit, "orbit", "Where the satellite is.",
              FIELDS(orbit_fields), .exactly_one = one);

/* --- attitude ------------------------------------------------------------------------------- */
#define OF struct um_scenario_fixed_attitude
static const struct um_schema_field fixed_attitude_fields[] = {
    F(q_gcrs, UM_SCHEMA_VECTOR, REQUIRED, .length = 4,
      HELP("quaternion GCRS to body, scalar first, passive")),
};
#undef OF
OBJECT(fixed_attitude_object, struct um_scenario_fixed_attitude, "fixed attitude",
       "Constant in GCRS.", FIELDS(fixed_attitude_fields));

#define OF struct um_scenario_lvlh
static const struct um_schema_field lvlh_fields[] = {
    F(roll_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("about x")),
    F(pitch_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("about y")),
    F(yaw_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("about z")),
};
#undef OF
OBJECT(lvlh_object, struct um_scenario_lvlh, "lvlh",
       "Orbital frame: z to the geocentre, y against the orbit normal; then yaw, pitch, roll.",
       FIELDS(lvlh_fields));

#define OF struct um_scenario_pointing
static const struct um_schema_field pointing_fields[] = {
    F(axis_body, UM_SCHEMA_VECTOR, REQUIRED, .length = 3, HELP("body axis that points")),
    F(clock_body, UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis kept as near the orbit normal as possible")),
};
#undef OF
OBJECT(pointing_object, struct um_scenario_pointing, "pointing", "A body axis follows a direction.",
       FIELDS(pointing_fields));

#define OF struct um_scenario_pointing
static const struct um_schema_field yaw_steering_fields[] = {
    F(axis_body, UM_SCHEMA_VECTOR, REQUIRED, .length = 3, HELP("body axis toward the geocentre")),
    F(clock_body, UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis kept as near the Sun as possible")),
};
#undef OF
OBJECT(yaw_steering_object, struct um_scenario_pointing, "yaw steering",
       "A body axis looks at the geocentre, another stays in the plane of nadir and Sun.",
       FIELDS(yaw_steering_fields));

#define OF struct um_scenario_spin
static const struct um_schema_field spin_fields[] = {
    F(axis_gcrs, UM_SCHEMA_NUMBERS, .alternative = 1, HELP("spin axis, inertial")),
    F(axis_lvlh, UM_SCHEMA_NUMBERS, .alternative = 1,
      HELP("spin axis that turns with the orbital frame")),
    F(q_gcrs, UM_SCHEMA_NUMBERS, .alternative = 1,
      HELP("attitude at at_utc; the axis is then axis_body as it stands there, inertial")),
    F(axis_body, UM_SCHEMA_VECTOR, REQUIRED, .length = 3, HELP("the same axis in the body")),
    F(period_s, UM_SCHEMA_NUMBER, REQUIRED, BETWEEN(-1e7, 1e7),
      HELP("of one turn; positive is right-handed about the axis")),
    F(phase_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("turn at at_utc")),
    F(at_utc, UM_SCHEMA_PARSED, NO_DEFAULT, UTC, HELP("when the phase holds; default: the start")),
    F(nutation_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 89.9),
      HELP("angle of axis_body from the angular momentum, which lies along the spin axis")),
    F(nutation_phase_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360),
      HELP("about which axis across axis_body it is tipped at at_utc")),
    F(inertia_ratio, UM_SCHEMA_NUMBER, DEFAULT(1.0), BETWEEN(0.01, 2),
      HELP("about axis_body over across it; below 1: a long body about its length")),
};
#undef OF
OBJECT(spin_object, struct um_scenario_spin, "spin", "Steady rotation about one axis.",
       FIELDS(spin_fields), .exactly_one = one);

#define OF struct um_scenario_magnetic
static const struct um_schema_field magnetic_fields[] = {
    F(axis_body, UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("body axis along the field, which points north over the equator and down in the north")),
    F(clock_body, UM_SCHEMA_NUMBERS,
      HELP("body axis kept as near the orbit normal as possible at phase 0; default: some axis "
           "across axis_body")),
    F(period_s, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-1e7, 1e7),
      HELP("of one turn about the axis, right-handed; 0: it does not turn")),
    F(phase_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-360, 360), HELP("turn at at_utc")),
    F(at_utc, UM_SCHEMA_PARSED, NO_DEFAULT, UTC, HELP("when the phase holds; default: the start")),
};
#undef OF
OBJECT(magnetic_object, struct um_scenario_magnetic, "magnetic",
       "A passive magnet: a body axis lies along the Earth's magnetic field (IGRF-14).",
       FIELDS(magnetic_fields));

#define OF struct um_scenario_tumble
static const struct um_schema_field tumble_fields[] = {
    F(q_gcrs, UM_SCHEMA_VECTOR, REQUIRED, .length = 4,
      HELP("attitude at at_utc: quaternion GCRS to body, scalar first, passive")),
    F(rates_deg_s, UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("at at_utc, about the axes of the body")),
    F_AS(inertia, "inertia_kg_m2", UM_SCHEMA_NUMBERS, REQUIRED,
         HELP("xx, yy, zz, or with xy, xz, yz too, elements of the tensor (xy: minus the integral "
              "of x "
              "y); only ratios matter")),
    F(at_utc, UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
      HELP("when attitude and rates hold; default: the start")),
};
#undef OF
OBJECT(tumble_object, struct um_scenario_tumble, "tumble",
       "Free motion of a rigid body with three moments of inertia.", FIELDS(tumble_fields));

#define OF struct um_scenario_slew
static const struct um_schema_field slew_fields[] = {
    F(duration_s, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e6),
      HELP("half of it speeding up, half slowing down")),
    F(rate_deg_s, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(360),
      HELP("in place of a duration: the most")),
    F(acceleration_deg_s2, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(360),
      HELP("with rate_deg_s: the most")),
};
#undef OF
OBJECT(slew_object, struct um_scenario_slew, "slew",
       "A turn about one axis, the shorter way, relative to the law that it goes to.",
       FIELDS(slew_fields));

#define OF struct um_scenario_attitude_table
static const struct um_schema_field attitude_table_fields[] = {
    F(file, UM_SCHEMA_TEXT, REQUIRED, NAMES_FILE,
      HELP("CSV time_utc,q0,q1,q2,q3 GCRS to body, or an attitude message (AEM) or a "
           "file of STK")),
    F(max_gap_s, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e7),
      HELP("longest step that is interpolated; 0: ten times the median")),
};
#undef OF
OBJECT(attitude_table_object, struct um_scenario_attitude_table, "attitude table",
       "Quaternions from a file.", FIELDS(attitude_table_fields), .scalar_key = "file");

#define OF struct um_scenario_attitude
static const struct um_schema_field attitude_fields[] = {
    F_AS(from, "from_utc", UM_SCHEMA_PARSED, NO_DEFAULT, UTC,
         HELP("the law holds from here on; the first one holds from the beginning")),
    F(fixed, UM_SCHEMA_MAP, .object = &fixed_attitude_object, .alternative = 1),
    F(lvlh, UM_SCHEMA_MAP, .object = &lvlh_object, .alternative = 1),
    F(sun, UM_SCHEMA_MAP, .object = &pointing_object, .alternative = 1),
    F(target, UM_SCHEMA_MAP, .object = &pointing_object, .alternative = 1,
      HELP("like sun, toward the observer")),
    F(yaw_steering, UM_SCHEMA_MAP, .object = &yaw_steering_object, .alternative = 1),
    F(spin, UM_SCHEMA_MAP, .object = &spin_object, .alternative = 1),
    F(magnetic, UM_SCHEMA_MAP, .object = &magnetic_object, .alternative = 1),
    F(tumble, UM_SCHEMA_MAP, .object = &tumble_object, .alternative = 1),
    F(table, UM_SCHEMA_MAP, .object = &attitude_table_object, .alternative = 1),
    F(slew, UM_SCHEMA_MAP, .object = &slew_object,
      HELP("from the law before to this one, from from_utc on; default: at once")),
};
#undef OF
SHARED_OBJECT(um_model_attitude_schema, struct um_scenario_attitude, "attitude law",
              "How the satellite is turned.", FIELDS(attitude_fields), .exactly_one = one);

/* --- observer ------------------------------------------------------------------------------- */
#define OF struct um_scenario_direction
static const struct um_schema_field direction_fields[] = {
    F(unit_gcrs, UM_SCHEMA_VECTOR, REQUIRED, .length = 3,
      HELP("from the satellite toward the observer")),
    F(range_km, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e9), HELP("to the observer")),
};
#undef OF
OBJECT(direction_object, struct um_scenario_direction, "direction",
       "An observer in a fixed direction.", FIELDS(direction_fields));

#define OF struct um_scenario_moving_observer
static const struct um_schema_field moving_observer_fields[] = {
    F(tle, UM_SCHEMA_TEXT, .alternative = 1, HELP("two-line elements of the observer")),
    F(table, UM_SCHEMA_TEXT, NAMES_FILE, .alternative = 1, HELP("CSV as for orbit.table")),
};
#undef OF
OBJECT(moving_observer_object, struct um_scenario_moving_observer, "trajectory",
       "An observer in orbit.", FIELDS(moving_observer_fields), .exactly_one = one);

static const char *const air_choices[] = {"us_standard", "mid_latitude_summer",
                                          "mid_latitude_winter", NULL};
#define OF struct um_scenario_air
static const struct um_schema_field air_fields[] = {
    F(profile, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = air_choices,
      HELP("temperature, water and ozone where no other key states them")),
    F(temperature_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(180, 330), HELP("near the ground")),
    F(water_mm, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 80),
      HELP("precipitable, above the station")),
    F(ozone_DU, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 700), HELP("Dobson units")),
    F(aerosol, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 3),
      HELP("optical depth in the zenith at 0.55 um")),
    F(angstrom_exponent, UM_SCHEMA_NUMBER, DEFAULT(1.3), BETWEEN(-1, 4),
      HELP("of the aerosol: depth goes like wavelength to minus this")),
    F(cirrus, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 3),
      HELP("optical depth of thin ice cloud in the zenith at 0.55 um")),
    F(cirrus_temperature_K, UM_SCHEMA_NUMBER, DEFAULT(225.0), BETWEEN(180, 260),
      HELP("of that cloud")),
    F(file, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV with zenith_deg, wavelength_um, transmission and radiance_W_m2_sr_um, of another "
           "program, in place of all these")),
};
#undef OF
OBJECT(air_object, struct um_scenario_air, "air",
       "Clear air above the station (effect atmosphere).", FIELDS(air_fields));
#define OF struct um_scenario_observer
static const struct um_schema_field observer_fields[] = {
    F(station, UM_SCHEMA_MAP, .object = &station_object, .alternative = 1),
    F(direction, UM_SCHEMA_MAP, .object = &direction_object, .alternative = 1),
    F(trajectory, UM_SCHEMA_MAP, .object = &moving_observer_object, .alternative = 1),
    F(stations, UM_SCHEMA_LIST, MOST(10000), .object = &station_object,
      HELP("that measurements may name beside `station`; each with a name")),
    F(air, UM_SCHEMA_MAP, .object = &air_object,
      HELP("default: irradiance and counts are those without air")),
    F(minimum_elevation_deg, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-5, 90),
      HELP("for `umbra forecast`, airless: refraction shows from -0.55 on")),
};
#undef OF
SHARED_OBJECT(um_model_observer_schema, struct um_scenario_observer, "observer", "Who looks.",
              FIELDS(observer_fields), .exactly_one = one);
