/* The scenario as the user wrote it: one C struct per mapping of scenario.yaml, bound by the schema
 * table in scenario_schema.c. Values are in the units of the keys; model/build/build.c turns them
 * into SI. */
#ifndef UMBRA_MODEL_SCENARIO_H
#define UMBRA_MODEL_SCENARIO_H

#include <stdbool.h>

#include "base/document/schema.h"

struct um_scenario_time {
  struct um_mark at;
  double start, stop; /* t_tai [s] */
  double step_s, exposure_s;
  int exposure_samples;
  bool light_time;
};

struct um_scenario_kepler {
  struct um_mark at;
  double epoch; /* t_tai [s] */
  double a_km, e, i_deg, raan_deg, argp_deg, mean_anomaly_deg;
};
struct um_scenario_circular {
  struct um_mark at;
  double epoch; /* t_tai [s], NaN: start of the scenario */
  double altitude_km, beta_deg, period_s;
};
struct um_scenario_fixed_point {
  struct um_mark at;
  double position_gcrs_km[3];
};
struct um_scenario_orientation {
  struct um_mark at;
  double ut1_utc_s, xp_arcsec, yp_arcsec;
  const char *finals;
};
struct um_scenario_elements {
  struct um_mark at;
  const char *file;
  int object; /* catalogue number; 0: the only one */
};
struct um_scenario_points { /* every measurement says where the satellite is */
  struct um_mark at;
};
struct um_scenario_orbit {
  struct um_mark at;
  const char *tle, *tle_file, *table;
  struct um_scenario_elements *elements;
  struct um_scenario_kepler *kepler;
  struct um_scenario_circular *circular;
  struct um_scenario_fixed_point *fixed;
  struct um_scenario_points *points;
  struct um_scenario_orientation *earth_orientation;
};

struct um_scenario_fixed_attitude {
  struct um_mark at;
  double q_gcrs[4];
};
struct um_scenario_lvlh {
  struct um_mark at;
  double roll_deg, pitch_deg, yaw_deg;
};
struct um_scenario_pointing {
  struct um_mark at;
  double axis_body[3], clock_body[3];
};
struct um_scenario_spin {
  struct um_mark at;
  struct um_schema_list axis_gcrs, axis_lvlh; /* of double, 3 or 0 */
  double axis_body[3];
  struct um_schema_list q_gcrs; /* of double, 4 or 0 */
  double period_s, phase_deg, at_utc /* t_tai [s], NaN: start */;
  double nutation_deg, nutation_phase_deg, inertia_ratio;
};
struct um_scenario_magnetic {
  struct um_mark at;
  double axis_body[3];
  struct um_schema_list clock_body; /* of double, 3 or 0 */
  double period_s, phase_deg, at_utc /* t_tai [s], NaN: start */;
};
struct um_scenario_tumble {
  struct um_mark at;
  double q_gcrs[4], rates_deg_s[3];
  struct um_schema_list inertia; /* of double, 3 or 6 */
  double at_utc;                 /* t_tai [s], NaN: start */
};
struct um_scenario_slew {
  struct um_mark at;
  double duration_s, rate_deg_s, acceleration_deg_s2; /* NaN: not given */
};
struct um_scenario_attitude_table {
  struct um_mark at;
  const char *file;
  double max_gap_s;
};
struct um_scenario_attitude {
  struct um_mark at;
  double from; /* t_tai [s], NaN: from the beginning */
  struct um_scenario_fixed_attitude *fixed;
  struct um_scenario_lvlh *lvlh;
  struct um_scenario_pointing *sun, *target, *yaw_steering;
  struct um_scenario_spin *spin;
  struct um_scenario_magnetic *magnetic;
  struct um_scenario_tumble *tumble;
  struct um_scenario_attitude_table *table;
  struct um_scenario_slew *slew; /* NULL: it holds at once */
};

/* A law that turns about an axis of the body; false: it does not. Phase at `at` [deg], which is NaN
 * for the start. */
struct um_scenario_turn {
  const struct um_mark *mark;
  double period_s, phase_deg, at;
};
static inline bool um_scenario_turn(const struct um_scenario_attitude *law,
                                    struct um_scenario_turn *out)
{
  const struct um_scenario_spin *spin = law->spin;
  const struct um_scenario_magnetic *magnet = law->magnetic;
  if (spin != NULL)
    *out = (struct um_scenario_turn){&spin->at, spin->period_s, spin->phase_deg, spin->at_utc};
  else if (magnet != NULL)
    *out =
        (struct um_scenario_turn){&magnet->at, magnet->period_s, magnet->phase_deg, magnet->at_utc};
  return spin != NULL || (magnet != NULL && magnet->period_s != 0.0);
}

struct um_scenario_station {
  struct um_mark at;
  const char *name;
  double latitude_deg, longitude_deg, height_m;
};
struct um_scenario_direction {
  struct um_mark at;
  double unit_gcrs[3], range_km;
};
struct um_scenario_moving_observer {
  struct um_mark at;
  const char *tle, *table;
};
struct um_scenario_air { /* above the station; NaN: the profile's */
  struct um_mark at;
  int profile; /* enum um_environment_sky_profile */
  double temperature_K, water_mm, ozone_DU, aerosol, angstrom_exponent;
  double cirrus, cirrus_temperature_K;
  const char *file;
};
struct um_scenario_observer {
  struct um_mark at;
  struct um_scenario_station *station;
  struct um_scenario_direction *direction;
  struct um_scenario_moving_observer *trajectory;
  struct um_schema_list stations; /* of struct um_scenario_station, beside `station` */
  struct um_scenario_air *air;
  double minimum_elevation_deg;
};

struct um_scenario_region { /* of the Earth; NaN: not stated */
  struct um_mark at;
  double latitude_deg, longitude_deg, radius_km, edge_km;
  double from, to; /* t_tai [s] */
  double ramp_s;
  double albedo_factor, albedo_offset, olr_factor, olr_offset_W_m2, brightness_shift_K;
};
struct um_scenario_earth {
  struct um_mark at;
  int model; /* enum um_environment_earth */
  const char *file;
  struct um_scenario_region *local;
};
struct um_scenario_shadow_air {
  struct um_mark at;
  double ozone_DU, haze, stratospheric_aerosol, cloud_top_km;
};
struct um_scenario_environment {
  struct um_mark at;
  double solar_irradiance_W_m2;
  int solar_spectrum; /* enum um_environment_spectrum */
  double solar_temperature_K;
  struct um_scenario_earth *earth;
  double albedo, olr_W_m2, brightness_temperature_K, earth_radius_km;
  int shadow; /* enum um_environment_shadow */
  double shadow_radius_km;
  int disc; /* enum um_environment_disc */
  double limb_darkening;
  struct um_scenario_shadow_air *shadow_air; /* NULL: defaults */
  int sun;                                   /* enum um_scenario_sun */
  double sun_distance_au;                    /* NaN: by ephemeris */
};
enum um_scenario_sun { UM_SUN_EPHEMERIS, UM_SUN_FROZEN };

struct um_scenario_box {
  struct um_mark at;
  double size_m[3];
};
struct um_scenario_plate {
  struct um_mark at;
  double size_m[2];
};
struct um_scenario_round { /* disc, sphere, cylinder, cone, paraboloid */
  struct um_mark at;
  double radius_m, radius_top_m, height_m, focal_length_m;
};
struct um_scenario_mesh {
  struct um_mark at;
  const char *file;
  double scale;
  struct um_schema_list groups; /* of const char * */
};
struct um_scenario_pose {
  struct um_mark at;
  double position_m[3], rotation_deg[3];
};
struct um_scenario_joint {
  struct um_mark at;
  double axis[3], normal[3], angle_deg;
  int track;            /* 0 none, 1 sun */
  const char *schedule; /* a file, or NULL */
};
struct um_scenario_skin { /* group -> material, or {front, back} */
  struct um_mark at;
  const char *name;
  const char *front, *back;
};
struct um_scenario_honeycomb {
  struct um_mark at;
  const char *material, *core_material;
  double face_mm, core_mm, core_density_kg_m3;
};
struct um_scenario_layer {
  struct um_mark at;
  const char *material;
  double thickness_mm, density_kg_m3, specific_heat_J_kg_K,
      conductivity_W_m_K; /* NaN: not stated */
  int cells;
};
struct um_scenario_shell {
  struct um_mark at;
  double areal_heat_capacity_J_m2_K, conductance_W_K, through_conductance_W_m2_K, front_share;
  const char *material;
  double thickness_mm;
  struct um_scenario_honeycomb *honeycomb;
  struct um_schema_list layers; /* of struct um_scenario_layer */
};
struct um_scenario_mli {
  struct um_mark at;
  int law; /* enum um_thermal_mli_law */
  double effective_emittance, areal_heat_capacity_J_m2_K;
  const char *wraps; /* NULL or "wall": the wall; else an interior */
  double factor, layers, layers_per_cm, shield_emittance; /* of laws; NaN: not stated */
  double seam_length_m, seam_conductance_W_m_K;           /* NaN: no seams */
  int sheets;                                             /* under the outer layer */
  double sheets_areal_heat_capacity_J_m2_K;               /* of all of them; NaN: not stated */
};
struct um_scenario_interior {
  struct um_mark at;
  const char *name;                              /* NULL: `interior` */
  double capacity_J_K, power_W, conductance_W_K; /* capacity NaN: not stated */
  double temperature_K;                          /* of a boundary node; 0 or NaN: none */
  double conductivity_W_m_K, tetrahedron_size_m; /* above 0: a solid that fills the part */
  const char *power_file;
};
struct um_scenario_solid {
  struct um_mark at;
  const char *material;
  double density_kg_m3, specific_heat_J_kg_K, conductivity_W_m_K, tetrahedron_size_m, power_W;
  const char *power_file;
};
struct um_scenario_inner_conductance { /* of a group to an interior */
  struct um_mark at;
  const char *name;
  double conductance_W_K;
};
struct um_scenario_creases {
  struct um_mark at;
  double tilt_rms_deg, patch_m;
  int seed;
};
struct um_scenario_heat_pipe {
  struct um_mark at;
  double conductance_W_K, capacity_J_K;
};
struct um_scenario_group {
  struct um_mark at;
  const char *name;
  struct um_scenario_shell *shell;
  struct um_scenario_mli *mli;
  struct um_scenario_heat_pipe *heat_pipe;
  struct um_scenario_creases *creases, *flatness; /* NULL: the part's; at most one of both */
  bool bare;                                      /* no MLI here although the part has one */
  double interior_conductance_W_K, power_W;
  struct um_schema_list conductances; /* of struct um_scenario_inner_conductance */
  const char *power_file;
  double inside_emittance; /* NaN: the part's */
};
struct um_scenario_network { /* nodes and conductors in place of walls */
  struct um_mark at;
  const char *nodes, *conductors;
};
struct um_scenario_part {
  struct um_mark at;
  const char *name, *parent;
  struct um_scenario_box *box;
  struct um_scenario_plate *plate;
  struct um_scenario_round *disc, *cylinder, *cone, *sphere, *paraboloid;
  struct um_scenario_mesh *mesh;
  struct um_scenario_pose *pose;
  struct um_scenario_joint *joint;
  double grain[3]; /* direction; all 0: x */
  const char *outside, *front, *back;
  struct um_schema_list materials; /* of struct um_scenario_skin */
  struct um_schema_list groups;    /* of struct um_scenario_group */
  struct um_scenario_shell *shell;
  struct um_scenario_mli *mli;
  struct um_scenario_creases *creases, *flatness;
  struct um_scenario_interior *interior;
  struct um_schema_list interiors; /* of struct um_scenario_interior */
  struct um_scenario_solid *solid;
  struct um_scenario_network *network;
  bool lumped;
  double facet_size_m, start_temperature_K;
  double electrical_extraction; /* of direct sunlight on the front [1] */
  double inside_emittance;      /* of the inner faces [1]; 0: they do not radiate */
};

struct um_scenario_contact {
  struct um_mark at;
  const char *a, *b;
  double conductance_W_K;                            /* NaN: a radiative contact */
  double exchange_area_m2, area_m2, exchange_factor; /* NaN: not stated */
};
/* Of a contact that radiates [m^2]; NaN where it does not. */
static inline double um_scenario_exchange_area(const struct um_scenario_contact *contact)
{
  double stated = contact->exchange_area_m2;
  return stated == stated ? stated : contact->area_m2 * contact->exchange_factor;
}

enum um_scenario_outside_range { UM_RANGE_WARNING, UM_RANGE_ERROR };
enum um_scenario_spin_loads { UM_SPIN_AUTOMATIC, UM_SPIN_RESOLVED, UM_SPIN_AVERAGED };
enum um_scenario_start { UM_START_PERIODIC, UM_START_ISOTHERMAL };
struct um_scenario_thermal {
  struct um_mark at;
  double orbits_before;
  int start; /* enum um_scenario_start */
  double start_temperature_K, facet_size_m, facet_error_K, step_s, accuracy_K;
  const char *facets;
  int spin_loads;                                  /* enum um_scenario_spin_loads */
  double relative_tolerance, absolute_tolerance_K; /* NaN: by the accuracy */
  int samples;
  int exchange_patches, view_factor_rays;
  const char *view_factors; /* folder, or NULL */
  bool error_estimate;
  double space_temperature_K;
  int temperature_in_optics; /* 0 facet, 1 material_mean */
  int outside_range;         /* enum um_scenario_outside_range */
};

struct um_scenario_band {
  struct um_mark at;
  const char *name;
  double from_um, to_um; /* NAN: the filter's */
  const char *filter, *filter_file;
  int bins;
  double vega_magnitude;
};
struct um_scenario_sensor {
  struct um_mark at;
  const char *name;
  const char *band, *preset;
  double aperture_m, obstruction, throughput, quantum_efficiency;
  const char *quantum_efficiency_file;
  double gain_e, pixel_arcsec, fwhm_arcsec, radius_fwhm, annulus_pixels;
  double read_noise_e, dark_e_s, sky_mag_arcsec2, saturation_e, exposure_s;
  double noise_equivalent_irradiance_W_m2;
  double optics_emissivity, optics_temperature_K;
};
/* A file of optics/instrument/sensors. */
struct um_scenario_preset {
  struct um_mark at;
  const char *summary, *source, *assumed;
  struct um_scenario_sensor *sensor;
};
#define UM_SCENARIO_PATHS 4 /* interreflection_samples; of 0 where the effect is turned on, too */
struct um_scenario_optics {
  struct um_mark at;
  int samples, interreflection_samples, seed;
  double relative_error;
};
struct um_scenario_effect {
  struct um_mark at;
  const char *effect, *target;
  bool off;
  struct um_schema_list parameters; /* of struct um_schema_number */
};

/* The first of enum um_compare_quantity, which the model knows nothing else of. */
enum { UM_SCENARIO_BAND_IRRADIANCE, UM_SCENARIO_RADIANT_INTENSITY };
/* Sigma of measurements that state none. */
struct um_scenario_noise {
  struct um_mark at;
  int quantity;   /* enum um_compare_quantity */
  const char *of; /* NULL: everything of that quantity */
  double relative, floor;
};
/* An effect that is uncertain anyway. */
struct um_scenario_nuisance {
  struct um_mark at;
  const char *effect, *target;
  double sigma; /* NaN: of the effect's own prior */
  bool free;    /* no prior */
  const char *per;
};
/* A file of measurements and what is known of it alone. */
struct um_scenario_set {
  struct um_mark at;
  const char *name, *file;
  const char *station;            /* of rows that name none; NULL: the observer's */
  double from, to;                /* rows used, t_tai [s]; NaN: all */
  struct um_schema_list nuisance; /* of struct um_scenario_nuisance */
};
struct um_scenario_measurements {
  struct um_mark at;
  struct um_schema_list sets;     /* of struct um_scenario_set */
  struct um_schema_list noise;    /* of struct um_scenario_noise */
  struct um_schema_list nuisance; /* of struct um_scenario_nuisance */
  struct um_schema_list exclude;  /* of const char * */
};

/* What a place may be, for cases; NaN: no limit. */
struct um_scenario_limit {
  struct um_mark at;
  const char *of;
  double minimum_K, maximum_K, uncertainty_K;
};
/* A case of heat: the scenario with changes, and how its temperatures are found. */
struct um_scenario_case {
  struct um_mark at;
  const char *name;
  int analysis;                             /* enum um_variant_analysis */
  struct um_schema_list set, with, without; /* of const char *, as on the command line */
};

struct um_scenario {
  struct um_mark at;
  int schema;
  const char *name, *summary;
  struct um_scenario_time *time;
  struct um_scenario_orbit *orbit;
  struct um_schema_list attitude; /* of struct um_scenario_attitude */
  struct um_scenario_observer *observer;
  struct um_scenario_environment *environment;
  struct um_schema_list material_files; /* of const char * */
  struct um_schema_list parts;          /* of struct um_scenario_part */
  struct um_schema_list contacts;       /* of struct um_scenario_contact */
  struct um_scenario_thermal *thermal;
  struct um_schema_list bands;   /* of struct um_scenario_band */
  struct um_schema_list sensors; /* of struct um_scenario_sensor */
  struct um_scenario_optics *optics;
  struct um_schema_list effect_files; /* of const char * */
  struct um_schema_list effects;      /* of struct um_scenario_effect */
  struct um_scenario_measurements *measurements;
  struct um_schema_list limits; /* of struct um_scenario_limit */
  struct um_schema_list cases;  /* of struct um_scenario_case */
};

#endif
