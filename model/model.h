/* The coupled model: scenario -> orbit, attitude, environment, geometry, materials, heat network;
 * one geometry precomputation of the geometry; one run in both bands. */
#ifndef UMBRA_MODEL_MODEL_H
#define UMBRA_MODEL_MODEL_H

#include "core/arena.h"
#include "effects/effect.h"
#include "environment/timeline.h"
#include "geometry/visibility.h"
#include "materials/materials.h"
#include "model/scenario.h"
#include "optics/optics.h"
#include "orbit/attitude.h"
#include "orbit/observer.h"
#include "orbit/trajectory.h"
#include "thermal/body.h"
#include "thermal/response.h"

struct um_effects_registry;

/* Changes to a scenario from the command line; texts as the user typed them, borrowed. */
struct um_model_options {
  const char *const *overrides; /* "key.path=value" */
  size_t noverride;
  const char *const *with; /* "effect[:target]" */
  size_t nwith;
  const char *const *without;
  size_t nwithout;
  const char *const *effect_files; /* shared objects beside those of the scenario */
  size_t neffect_file;
  bool allow_effects; /* load what the scenario's effect_files name though effect_files does not */
};

/* One effect as it is used: from the scenario, --with, or a switch that is on by default. */
struct um_model_effect {
  const struct um_effect *effect;
  const char *target; /* NULL: everything it can act on; owned by the document */
  double value[UM_EFFECT_PARAMETERS_MAX];
  bool off;
  const struct um_mark *at;  /* entry of the scenario; NULL: of the command line, or by default */
  const char *option, *text; /* "--with" and what was typed; NULL otherwise */
};

/* An effect beside those of a scenario, with values: an effect that the scenario has already on
 * this target takes these values; a core switch has none and is turned on. */
struct um_model_addition {
  const struct um_effect *effect;
  const char *target;                     /* NULL: global; borrowed while the variant lives */
  double value[UM_EFFECT_PARAMETERS_MAX]; /* in the parameters' units */
};

/* Everything built from a scenario; read it, do not change it. */
struct um_model {
  const struct um_model *origin; /* of a variant: owns document, scenario and registry; else NULL */
  struct um_core_arena memory;   /* of what building keeps */
  struct um_document *document;
  struct um_scenario *scenario;
  struct um_effects_registry *registry; /* effects that it may use */
  struct um_model_effect *effect;       /* [neffect] those it uses */
  size_t neffect;
  struct um_environment environment;
  struct um_orbit_earth_orientation orientation;
  struct um_orbit_trajectory *trajectory, *observer_trajectory;
  double orbit_age, orbit_error,
      orbit_delay; /* of two-line elements at time.start_utc: age [s],
   standard deviation along the track [m] and in time [s]; NaN: unknown */
  struct um_orbit_attitude *attitude;
  bool points_at_observer; /* a law looks at the observer, outside observations too */
  bool has_observer;
  struct um_orbit_observer observer;
  bool points; /* orbit.points: observations stand alone, the trajectory has no state */
  struct um_orbit_observer *station; /* [nstation] of points: the observer's, then the others */
  size_t nstation;
  struct um_vec3 pole; /* of the Earth, GCRS, at the start: it moves by 0.1 arcsec a day */
  bool sun_frozen;
  struct um_vec3 frozen_sun_position; /* geocentric, GCRS [m], when sun_frozen */
  struct um_materials_library *library;
  struct um_geometry *geometry;
  const struct um_materials_record **material; /* [material of the geometry] */
  struct um_materials_adjustment
      *adjustment; /* [material of the geometry] by effects, at time.start_utc */
  const struct um_thermal_surface_law *
      *surface_law; /* [material of the geometry]; NULL: constant */
  struct um_thermal_body *body;
  double *start_offset; /* [node] added to what a run begins with [K]; NULL: nothing */
  struct um_optics_band *band;
  size_t nband;
};

/* Build from a scenario folder or file. UM_ERR_INPUT with file, line, key. The caller destroys. */
enum um_status um_model_create(struct um_context *context, const char *path,
                               const struct um_model_options *options, struct um_model **out);
/* The same scenario with additions: built from the parsed scenario of `origin`, which outlives it,
 * without a look at its YAML; files that it names are read again unless they are held
 * (um_core_files_hold). What the origin was built from was good, so that what is refused is refused
 * because of the additions: UM_ERR_REFUSED. The caller destroys. */
enum um_status um_model_variant_create(struct um_context *context, const struct um_model *origin,
                                       const struct um_model_addition *addition, size_t naddition,
                                       struct um_model **out);
/* Only what orbits need (for `umbra passes`): no parts, no materials. */
enum um_status um_model_create_orbit(struct um_context *context, const char *path,
                                     const struct um_model_options *options, struct um_model **out);
void um_model_destroy(struct um_context *context, struct um_model **model);

/* May the effect be used on this target (NULL: none) of this model? UM_ERR_INPUT saying what is
 * accepted. */
enum um_status um_model_check_target(struct um_context *context, const struct um_model *model,
                                     const struct um_effect *effect, const char *target);

/* Effects that the model may use: the built-in ones, then those of its effect files in order;
 * borrowed, they live as long as the model. find: NULL when there is none of that name. */
size_t um_model_effects_count(const struct um_model *model);
const struct um_effect *um_model_effects_at(const struct um_model *model, size_t index);
const struct um_effect *um_model_effects_find(const struct um_model *model, const char *name);

/* The scene at a satellite time. to_observer is zero and range NaN. */
enum um_status um_model_sample_at(struct um_context *context, const struct um_model *model,
                                  double t_tai, struct um_environment_sample *out);
/* The scene as seen at an observer time (light received), with light time where the scenario has
 * it. UM_ERR_INPUT without an observer. */
enum um_status um_model_sample_seen(struct um_context *context, const struct um_model *model,
                                    double t_observer, struct um_environment_sample *out,
                                    struct um_orbit_look *look);
/* Eclipse events between two satellite times; the caller frees *out. */
enum um_status um_model_events(struct um_context *context, const struct um_model *model,
                               double from, double to, struct um_environment_event **out,
                               size_t *count);

/* An observation that stands alone (orbit.points): where the satellite was seen. */
struct um_model_point {
  double t;                  /* t_tai [s], light received */
  double height;             /* of the satellite above the WGS-84 ellipsoid [m] */
  double azimuth, elevation; /* [rad], airless, north over east */
  size_t station;            /* of the model's stations */
};
/* Index of a station of points by name; 0, the observer's own, for "". UM_ERR_INPUT names those
 * there are. */
enum um_status um_model_station_find(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *out);
/* The scene at a point, at the time of emission where the scenario has light time; the place, and
 * with it the range, is that of emission. v is 0. UM_ERR_INPUT for a scenario with an orbit, or
 * errors of um_orbit_observer_locate. */
enum um_status um_model_sample_point(struct um_context *context, const struct um_model *model,
                                     const struct um_model_point *point,
                                     struct um_environment_sample *out, struct um_orbit_look *look);

/* Everything geometric about one timeline, traced once; physics runs on it many times. */
struct um_model_precomputed {
  size_t nobs;                          /* observations */
  size_t nsub;                          /* instants per observation (exposure) */
  double *t_obs;                        /* [nobs] t_tai, mid-exposure, at the observer */
  struct um_orbit_look *look;           /* [nobs * nsub] */
  struct um_environment_sample *sample; /* [nobs * nsub], at the satellite's time */
  double *sunlit;                       /* [nobs] mean over the exposure */
  bool *hidden;   /* [nobs] below the station's horizon, or behind the Earth, during the exposure */
  double period;  /* of the orbit [s]; NaN for a fixed point */
  double t_first; /* middle of the first observation, at the satellite [s] */
  double t_start; /* thermal start, t_tai [s] */
  double t_periodic_end;              /* end of the orbit that is made periodic; t_start if none */
  struct um_irradiation_loads *loads; /* over [t_start, last observation] */
  size_t *load_row;                   /* [nobs * nsub] row of loads at each instant */
  struct um_optics_view *view;        /* [nobs * nsub]; NULL without an observer */
  struct um_environment_event *event; /* [nevent], eclipse edges from t_start to the end */
  size_t nevent;
  bool points; /* observations stand alone: one instant and one row of loads each, in their order;
                  the rows are numbered, their t is t_start plus the number [s]; no events; heat is
                  not followed */
};
enum um_status um_model_precompute(struct um_context *context, const struct um_model *model,
                                   struct um_model_precomputed **out);
/* The same at given observation times [ntime], t_tai, strictly ascending, in place of the
 * scenario's start, stop and step (measurements have times of their own). UM_ERR_INPUT for none or
 * out of order. exposures: NULL, or [ntime] [s] in place of the scenario's. */
enum um_status um_model_precompute_at(struct um_context *context, const struct um_model *model,
                                      const double *times, const double *exposures, size_t ntime,
                                      struct um_model_precomputed **out);
/* Of a scenario with orbit.points, at points [npoint] in order of time (times may be equal). The
 * satellite's motion is not known, so an exposure is its middle. UM_ERR_INPUT: no points, out of
 * order, or a scenario with an orbit; the two above refuse orbit.points. */
enum um_status um_model_precompute_points(struct um_context *context, const struct um_model *model,
                                          const struct um_model_point *points, size_t npoint,
                                          struct um_model_precomputed **out);
/* Look again: lines of sight of the geometry precomputation with another number of points per
 * facet, everything else of it as it was. The model's own optics.samples is set, and
 * optics.interreflection_samples where it is not 0, so that what is built from the model later
 * agrees. UM_ERR_INPUT: no observer, or a number out of range (then nothing is changed);
 * UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED.
 */
enum um_status um_model_precomputed_resample(struct um_context *context, struct um_model *model,
                                             struct um_model_precomputed *precomputed, int samples,
                                             int interreflection_samples);
void um_model_precomputed_destroy(struct um_context *context,
                                  struct um_model_precomputed **precomputed);

/* Temperatures of one named place (part, side, group, interior, or "material:NAME") [K]. */
struct um_model_place_history {
  char *name;
  double *mean, *minimum, *maximum; /* [nobs] area-weighted (capacity-weighted inside) */
  double drift; /* change of the mean over the last orbit before the window [K] */
};

struct um_model_result {
  size_t nobs, nband, nmaterial, nsurface, nnode, nplace;
  double *irradiance;   /* [nobs][nband] at the aperture, after effects [W/m^2]; NaN where hidden */
  double *magnitude_ab; /* [nobs][nband] after effects other than the atmosphere's; INFINITY where
                           the irradiance is 0, NaN where it is negative and where hidden */
  double
      *measured_intensity; /* [nobs][nband] what is concluded from a measurement, E R^2 without an
                              atmosphere, after effects other than its [W/sr]; where hidden, too */
  double *intensity;       /* [nobs][nband][nmaterial][UM_MECHANISM_COUNT] [W/sr] */
  double *standard_error;  /* [nobs][nband] of the total [W/sr] */
  /* [nobs][nband] that error through range, exposure and effects: of irradiance [W/m^2], and of the
   * flux 10^(-0.4 magnitude_ab) [1]; both NaN where nothing arrives */
  double *irradiance_error, *magnitude_error;
  double *spectral; /* [nobs][nbin][UM_MECHANISM_COUNT] [W/sr/m] */
  size_t nbin;
  double *wavelength, *bin_width;       /* [nbin] [m] */
  uint32_t *bin_band;                   /* [nbin] */
  double *surface_temperature;          /* [nobs][nsurface] [K] */
  double *node_temperature;             /* [nobs][nnode] [K] */
  struct um_model_place_history *place; /* [nplace] */
  struct um_thermal_heat *heat; /* [nobs][nplace] [W]; of thermal places, zero for materials */
  struct um_thermal_heat audit; /* [J] over the whole thermal run */
  double audit_error;           /* [1] */
  double periodic_drift;        /* what the periodic start left [K]; NaN when isothermal */
  size_t steps, rhs_evaluations, jacobians;
};
/* Run on a geometry precomputation made from the same model. */
enum um_status um_model_run(struct um_context *context, const struct um_model *model,
                            const struct um_model_precomputed *precomputed,
                            struct um_model_result **out);

/* The heat half of a run, kept: models that differ in what heat does not feel (calibration,
 * roughness, emissivity in a band) share it. Model and geometry precomputation outlive it. */
struct um_model_thermal_solution;
/* warm: NULL, or heat of a model with the same nodes: a periodic state is looked for from there,
 * which takes an orbit or two in place of many; the state found differs within the tolerance of
 * the search (0.01 K). It does not touch an isothermal start. tolerance_factor: factor >= 1 on the
 * tolerances of the integration; above 1 the run goes on from the end of the periodic orbit where
 * it can, without drift of the places and with an audit of the observations alone. Errors of the
 * thermal solvers. The caller destroys. */
enum um_status um_model_thermal_solution_create(struct um_context *context,
                                                const struct um_model *model,
                                                const struct um_model_precomputed *precomputed,
                                                const struct um_model_thermal_solution *warm,
                                                double tolerance_factor,
                                                struct um_model_thermal_solution **out);
void um_model_thermal_solution_destroy(struct um_context *context,
                                       struct um_model_thermal_solution **heat);
/* *out: true when the model has the same temperatures on this geometry precomputation: network,
 * loads, times, settings and what ages are equal, number for number. What an effect refuses. */
enum um_status um_model_thermal_solution_matches(struct um_context *context,
                                                 const struct um_model_thermal_solution *heat,
                                                 const struct um_model *model,
                                                 const struct um_model_precomputed *precomputed,
                                                 bool *out);
/* Run with heat that matches. um_model_run is this with heat of its own, not loosened. */
enum um_status um_model_run_with(struct um_context *context, const struct um_model *model,
                                 const struct um_model_precomputed *precomputed,
                                 const struct um_model_thermal_solution *heat,
                                 struct um_model_result **out);
/* The same with the light of every surface made at its temperature plus offset[nsurface] [K], for
 * derivatives. Nodes and their places stay as they are, means of materials move along. */
enum um_status um_model_run_warmer(struct um_context *context, const struct um_model *model,
                                   const struct um_model_precomputed *precomputed,
                                   const struct um_model_thermal_solution *heat,
                                   const double *offset, struct um_model_result **out);
/* How node temperatures answer to small heat from the first instant of the geometry precomputation
 * on, along this history: um_thermal_response at the geometry precomputation's instants [nobs *
 * nsub]. UM_ERR_INPUT for points. */
enum um_status um_model_thermal_solution_response(struct um_context *context,
                                                  const struct um_model_thermal_solution *heat,
                                                  const struct um_thermal_response_source *source,
                                                  size_t nsource,
                                                  const struct um_thermal_response_options *how,
                                                  um_thermal_response_take *take, void *user);
/* Radiant intensity of one observation and band, all materials together [W/sr]; mechanism < 0: all.
 */
double um_model_result_intensity(const struct um_model_result *result, size_t k, size_t band,
                                 int mechanism);

/* Picture of observation k in a band, up being away from the Earth; see um_optics_image_render.
 * UM_ERR_INPUT without an observer. */
enum um_status um_model_picture(struct um_context *context, const struct um_model *model,
                                const struct um_model_precomputed *precomputed,
                                const struct um_model_result *result, size_t k, size_t band,
                                int width, int samples_per_pixel, struct um_optics_image **out);
/* Index of a band by name, (size_t)-1 when there is none. */
size_t um_model_band_find(const struct um_model *model, const char *name);
/* The same; UM_ERR_INPUT with the nearest one and what is accepted when there is none. */
enum um_status um_model_band_require(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *out);
void um_model_result_destroy(struct um_context *context, struct um_model_result **result);

#endif
