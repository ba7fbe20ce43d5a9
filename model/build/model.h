/* What is built from a scenario: orbit, attitude, environment, geometry, materials, heat network,
 * bands and sensors. What is traced of it is in model/geometry/tables.h, a run of it in
 * model/run/run.h. */
#ifndef UMBRA_MODEL_MODEL_H
#define UMBRA_MODEL_MODEL_H

#include "base/core/arena.h"
#include "effects/effect.h"
#include "environment/timeline.h"
#include "geometry/visibility.h"
#include "materials/materials.h"
#include "model/scenario/scenario.h"
#include "optics/instrument/sensor.h"
#include "optics/radiance/creases.h"
#include "optics/radiance/optics.h"
#include "orbit/attitude.h"
#include "orbit/observer.h"
#include "orbit/trajectory.h"
#include "thermal/network/body.h"

struct um_effects_registry;

/* A sensor of the scenario, ready to count the bins of its band. */
struct um_model_sensor {
  const char *name;
  size_t band;
  double *efficiency; /* [bins of the band] filter, optics and detector together [1] */
  double exposure;    /* length of an exposure [s]; 0: not known */
  struct um_instrument_sensor optics;
};

/* An effect turned on with values, or off; everything borrowed. */
struct um_model_change {
  const char *effect, *target; /* target NULL: global; of one that is off: all of its uses */
  bool off;
  const char *const *parameter; /* [nparameter] names; the others stay as they are */
  const double *value;          /* [nparameter] in the parameters' units */
  size_t nparameter;
};

/* Changes to a scenario from the command line or a caller; texts as the user typed them, borrowed.
 */
struct um_model_options {
  const char *text; /* the scenario's YAML, in place of what stands at its path, from which relative
                       names of files lead all the same; NULL: read */
  const char *const *overrides; /* "key.path=value" */
  size_t noverride;
  const struct um_document_change *set; /* [nset] behind those, of a scenario good without */
  size_t nset;
  const char *const *with; /* "effect[:target]" */
  size_t nwith;
  const char *const *without;
  size_t nwithout;
  const struct um_model_change *change; /* [nchange] in order, after those; outlives the model */
  size_t nchange;
  const char *const *effect_files; /* shared objects beside those of the scenario */
  size_t neffect_file;
  bool allow_effects; /* load what the scenario's effect_files name though effect_files does not */
};

/* One effect as it is used: from the scenario, --with, or a switch that is on by default. */
struct um_model_effect {
  const struct um_effect *effect;
  const char *target; /* NULL: everything it can act on; owned by document or model */
  /* The target without "@SET", NULL: everything; the set, NULL: all (um_effects_set_of). */
  const char *place, *set;
  double value[UM_EFFECT_PARAMETERS_MAX];
  bool off;
  bool off_by_keys;          /* a core switch that keys of `environment` hold off */
  const struct um_mark *at;  /* entry of the scenario; NULL: of the command line, or by default */
  const char *option, *text; /* "--with" and what was typed; NULL otherwise */
};

/* An effect beside those of a scenario, with values: an effect that the scenario has already on
 * this target takes these values; a core switch has none and is turned on. */
struct um_model_addition {
  const struct um_effect *effect;
  const char *target;                     /* NULL: global; borrowed */
  double value[UM_EFFECT_PARAMETERS_MAX]; /* in the parameters' units */
  bool off;                               /* of what is on by default: withheld, without values */
};

/* What makes a variant of a scenario. Borrowed while it is built. */
struct um_model_changes {
  const struct um_document_change *key; /* [nkey] of the scenario */
  size_t nkey;
  const char *const *with, *const
                               *without; /* "effect[:target][,name=value]" as a user typed them */
  size_t nwith, nwithout;
  const struct um_model_addition *addition; /* [naddition] behind them */
  size_t naddition;
  const struct um_geometry_halvings *halvings; /* [parts] in place of thermal.facets; NULL: none */
  const struct um_thermal_source *source; /* [nsource] of heat in nodes, beside the scenario's */
  size_t nsource;
};

/* Everything built from a scenario; read it, do not change it. */
struct um_model {
  const struct um_model *origin;   /* of a variant, which borrows what it has the same; else NULL */
  struct um_model_options options; /* with, without and change alone, for variants */
  struct um_core_arena memory;     /* of what building keeps */
  struct um_document *document;
  const struct um_scenario *scenario;
  struct um_effects_registry *registry; /* effects that it may use */
  struct um_model_effect *effect;       /* [neffect] those it uses */
  size_t neffect;
  struct um_environment environment;
  struct um_orbit_ephemeris *ephemeris; /* pole and Earth; of the origin likewise */
  struct um_orbit_earth_orientation orientation;
  struct um_orbit_trajectory *trajectory, *observer_trajectory;
  double orbit_age, orbit_error,
      orbit_delay; /* of two-line elements at time.start_utc: age [s],
   standard deviation along the track [m] and in time [s]; NaN: unknown */
  struct um_orbit_attitude *attitude;
  bool nutates;            /* a law spins about an axis that is not the momentum's */
  bool points_at_observer; /* a law looks at the observer, outside observations too */
  bool has_observer;
  struct um_orbit_observer observer;
  struct um_orbit_observer *station; /* [nstation] the observer, then the others that measurements
                                        may name; NULL without an observer */
  size_t nstation;
  bool points; /* orbit.points: observations stand alone, the trajectory has no state */
  struct um_environment_map *earth_map;       /* of environment.earth.file; NULL: none. A variant
                                                 borrows that of its origin */
  struct um_environment_sky_table *sky_table; /* of observer.air.file, likewise */
  struct um_environment_limb *limb; /* the Earth's air before the Sun; of the origin likewise */
  struct um_environment_umbra_scatter *umbra_scatter; /* what that air scatters into the shadow;
                                                         NULL: none, of the origin likewise */
  struct um_environment_daylight **daylight;  /* what the Earth reflects by angle: one for all
                                                 scenarios, made by the first variant that reads it;
                                                 of the origin likewise; NULL at it: not made */
  struct um_environment_sky_light *sky_light; /* what the air above the station scatters; of the
                                                 origin likewise; NULL: none (sky_light.h) */
  struct um_vec3 pole;      /* of the Earth, GCRS, at the start: it moves by 0.1 arcsec a day */
  struct um_vec3 greenwich; /* prime meridian at the equator, GCRS, at the start */
  bool sun_frozen;
  struct um_vec3 frozen_sun_position;          /* geocentric, GCRS [m], when sun_frozen */
  struct um_materials_library *library;        /* a variant may borrow that of its origin */
  const struct um_geometry_halvings *halvings; /* [parts] of thermal.facets; NULL: there are none,
                                                  or changes had them */
  struct um_geometry *geometry;
  const struct um_materials_record **material; /* [material of the geometry] */
  struct um_materials_adjustment
      *adjustment; /* [material of the geometry] by effects, at time.start_utc */
  struct um_materials_record **thickened; /* [material of the geometry] what `material` points to
                                             where effects change its layers; NULL: the library's */
  struct um_geometry_creasing *creasing;  /* [group of the geometry] */
  struct um_optics_creases *creases;      /* NULL: every surface is flat */
  const struct um_thermal_surface_law *
      *surface_law;                           /* [material of the geometry]; NULL: constant */
  const struct um_thermal_ratio **bulk_ratio; /* [2 per record of the library] made so far, or NULL
                                                 (bulk_law.c); NULL: none */
  struct um_thermal_body *body;
  /* Shares of the half space that the satellite fills, of surfaces of the outside, NaN of others;
   * NULL: surfaces exchange. A variant's may be its origin's. */
  double *blocked; /* [nblocked] */
  size_t nblocked;
  double *start_offset;           /* [node] added to what a run begins with [K]; NULL: nothing */
  struct um_optics_band *band;    /* [nband]; these four are the origin's in a variant */
  double *vega_ab;                /* [nband] AB magnitude of magnitude_vega 0 */
  struct um_model_sensor *sensor; /* [nsensor] */
  size_t nband, nsensor;
};

#endif
