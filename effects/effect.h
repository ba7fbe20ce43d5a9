/* A physical effect: one const descriptor in one file of effects/, or in a user's shared object.
 * The manual, `umbra list effects`, scenario validation, ablation and diagnosis are made from it.
 */
#ifndef UMBRA_EFFECTS_EFFECT_H
#define UMBRA_EFFECTS_EFFECT_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "base/core/context.h"
#include "base/core/vec.h"
#include "effects/view.h"
#include "environment/environment.h"
#include "geometry/creases.h"
#include "geometry/geometry.h"
#include "materials/materials.h"
#include "optics/instrument/sensor.h"
#include "orbit/attitude.h"
#include "thermal/network/body.h"

#define UM_EFFECT_ABI_VERSION 7

/* The version of the program that no longer accepts `formerly` of a parameter. */
#define UM_EFFECT_FORMERLY_UNTIL "0.6"

enum um_effect_target {
  UM_TARGET_GLOBAL = 1,
  UM_TARGET_PART = 2,
  UM_TARGET_PART_SIDE = 4,
  UM_TARGET_MATERIAL = 8,
  UM_TARGET_BAND = 16,
  UM_TARGET_SENSOR = 32,
  /* beside PART: "part.NAME", what the scenario lists under `interiors`; beside PART_SIDE, where
   * the part's name is that of its walls, also "part.interior" */
  UM_TARGET_INTERIOR = 64
};

enum um_effect_change { UM_CHANGE_ADDS, UM_CHANGE_SCALES, UM_CHANGE_STRETCHES /* by 1 + value */ };

struct um_effect_nominal;
/* The number of a scenario that a parameter changes: the whole that it is added to or scales. */
struct um_effect_stated {
  const char *what, *unit; /* "outgoing longwave radiation", "W/m^2" */
  double value;            /* with the effects that the scenario lists; NaN: not one number */
  double minimum, maximum; /* of the whole, that are physical */
  bool is_clamped; /* kept within them at each wavelength: a bound on the mean comes too early */
  enum um_effect_change change; /* these two of the parameter; set before its callback */
  double null_value;            /* its value in the scenario, where the whole is `value` */
};

/* How parameters are called, so that the same kind has the same name in every effect:
 * - `factor`: a number without unit that multiplies what the effect is about;
 * - `shift_UNIT`, `shift` where there is no unit: a difference that is added to it;
 * - an amount goes by its quantity and unit: `power_W`, `capacity_J_K`, `depth`, `share`,
 *   `angle_deg`. So does what changes another number than the one that the effect is about:
 *   `inertia_shift` of `nutation`. */
struct um_effect_parameter {
  const char *name; /* with unit: "power_W" */
  const char *unit; /* "W", "1" */
  const char *help;
  double null_value;    /* the effect vanishes here */
  double default_value; /* when the scenario does not say */
  double minimum, maximum;
  /* Width of a weak prior about null_value; INFINITY: none. Of a logarithmic parameter (a positive
   * factor that may be off either way): of ln(value / null_value). */
  double prior_sigma;
  bool logarithmic;
  /* A temperature of the target [K] that matters only while another parameter is off its null
   * value: a diagnosis starts from one that the target has. */
  bool is_temperature;
  /* How fast that goes on which other parameters begin; it matters only while one of them is off
   * its null value, and observations follow it smoothly: a diagnosis looks at all its range by what
   * small turns of the body do (evidence/sensitivity/scan_rates.c). Of effects on the attitude law.
   */
  bool is_rate;
  /* Said by the user, never fitted, and no column of any signature: what only numbers one of many
   * equal possibilities, or steps. Behind all others. */
  bool chosen;
  /* Where in its cycle something is when the run begins, 0 to 1; at its null value it is not
   * stated. Nobody knows it, so a diagnosis frees it where that is worth its ln n in BIC. One that
   * is chosen, too. */
  bool is_phase;
  const char *prior; /* where the width comes from, a few words; NULL: not said */
  /* Says by um_effect_state which number of the scenario the parameter changes; a diagnosis reports
   * the whole and keeps it physical. NULL, or nothing said: there is none. */
  void (*stated)(const struct um_effect_nominal *, struct um_effect_stated *);
  enum um_effect_change change; /* how it changes what is stated */
  /* Its name before this version, which users' files may still have; NULL: none. It is accepted
   * with a warning until UM_EFFECT_FORMERLY_UNTIL. */
  const char *formerly;
};

/* Parameters are fitted, and their priors stand, in the unit of their prior: the logarithm of a
 * logarithmic one, else the value itself. */
static inline double um_effect_transformed(const struct um_effect_parameter *parameter,
                                           double value)
{
  return parameter->logarithmic ? log(value) : value;
}
static inline double um_effect_physical(const struct um_effect_parameter *parameter,
                                        double transformed)
{
  return parameter->logarithmic ? exp(transformed) : transformed;
}
/* d(value) / d(transformed) */
static inline double um_effect_transformed_slope(const struct um_effect_parameter *parameter,
                                                 double value)
{
  return parameter->logarithmic ? value : 1.0;
}

/* The values of one use of an effect in a scenario. */
struct um_effect_use {
  const struct um_effect *effect;
  const char *target;  /* NULL: everything it can act on */
  const double *value; /* [nparameter] */
  double epoch;        /* t_tai at which the scenario's time starts [s], for what grows */
};

/* True when the use acts on the thing of that name: a part, a material, a band. */
static inline bool um_effect_acts_on(const struct um_effect_use *use, const char *name)
{
  return use->target == NULL || strcmp(use->target, name) == 0;
}
/* True when the use acts on a group of a part: target "part", "part.group" or none. */
static inline bool um_effect_acts_on_group(const struct um_effect_use *use, const char *part,
                                           const char *group)
{
  size_t n = strlen(part);
  if (use->target == NULL || strcmp(use->target, part) == 0) return true;
  return strncmp(use->target, part, n) == 0 && use->target[n] == '.' &&
         strcmp(use->target + n + 1, group) == 0;
}

/* What a scenario states of the target of an effect. Numbers are NaN and pointers NULL where it
 * states nothing. Everything borrowed. */
struct um_effect_nominal {
  struct um_effect_use use; /* effect and target; no values */
  const struct um_environment *environment;
  const struct um_materials_record *material; /* that the target names, with its adjustment */
  const struct um_materials_adjustment *adjustment;
  double infrared_from, infrared_to; /* first band beyond 2.5 um [m] */
  const struct um_geometry *geometry;
  const struct um_geometry_creasing *creasing; /* [group of the geometry] */
  const struct um_thermal_network *network;
  /* Of the part or group: wall [J/m^2/K], [W/m^2/K], effective emittance of its MLI [1]. */
  double wall_capacity, wall_conductance, mli_emittance;
  double interior_power, interior_capacity; /* of the interior [W], [J/K] */
  bool has_power_history;                   /* beside interior_power */
  double contact_conductance;               /* of the only contact [W/K] */
  double longest_exposure, spin_period;     /* of an observation, of the first law that turns [s] */
  double inertia_ratio;                     /* of the first law of the kind spin [1] */
};

static inline void um_effect_state(struct um_effect_stated *out, const char *what, const char *unit,
                                   double value, double minimum, double maximum)
{
  out->what = what;
  out->unit = unit;
  out->value = value;
  out->minimum = minimum;
  out->maximum = maximum;
}

/* One observation while it is transformed: once as it comes to the aperture, and once as it would
 * be without an atmosphere, which magnitudes are made of. A hook that stands for the atmosphere
 * leaves the latter alone; one that stands for the instrument or its reduction does the same to
 * both. */
struct um_effect_observation {
  double t_tai;     /* [s] mid-exposure, as tagged */
  double elevation; /* [rad], NaN without a station */
  double airmass;   /* [1], NaN without a station or below the horizon */
  const char *band;
  double value;         /* band irradiance [W/m^2]; the hook changes it */
  bool exo_atmospheric; /* value is the one without an atmosphere */
  double zero; /* band irradiance of AB magnitude 0, the same at every wavelength [W/m^2] */
  double sky;  /* light that the air scatters toward the observer, through the filter [W/m^2/sr]; 0
                  where it is not known */
  /* What a sensor counts, as the irradiance that it would count so; sensor NULL: no counts. */
  const struct um_instrument_sensor *sensor;
  double electrons;  /* of the whole image in an exposure, per irradiance [e per W/m^2]; NAN */
  double background; /* of a pixel in it [e]; NAN: no pixels are known */
  /* Sun, observer and Earth from the satellite, and which material the light comes from; NULL: of a
   * star */
  const struct um_effect_view *view;
};

/* Each hook may be NULL. A hook adds to or scales what is there, never sets it, and does nothing at
 * null values. Those that may be called for things the use does not act on test the target first.
 */
struct um_effect_hooks {
  enum um_status (*environment)(struct um_context *, const struct um_effect_use *,
                                struct um_environment *);
  /* The optics of a material as they are at a time [s]: at every row of the heat loads and at every
   * observed instant, so that a surface may age. Linear between those rows. */
  enum um_status (*material)(struct um_context *, const struct um_effect_use *,
                             const char *material, double t_tai, struct um_materials_adjustment *);
  enum um_status (*geometry)(struct um_context *, const struct um_effect_use *,
                             struct um_geometry_part_spec *);
  enum um_status (*part)(struct um_context *, const struct um_effect_use *, const char *part,
                         struct um_thermal_part_spec *);
  /* wall and mli: of this group, to be changed; NULL where there is none. */
  enum um_status (*group)(struct um_context *, const struct um_effect_use *, const char *part,
                          const char *group, struct um_thermal_group_spec *,
                          struct um_thermal_shell *wall, struct um_thermal_mli *mli);
  enum um_status (*contact)(struct um_context *, const struct um_effect_use *,
                            struct um_thermal_contact *);
  /* How the surfaces of a group of a part are tilted: of one of sheet, which wears MLI or states
   * creases, and of any other. */
  enum um_status (*creases)(struct um_context *, const struct um_effect_use *, const char *part,
                            const char *group, struct um_geometry_creasing *);
  enum um_status (*flatness)(struct um_context *, const struct um_effect_use *, const char *part,
                             const char *group, struct um_geometry_creasing *);
  /* From the time tag of an observation to its true time [s]. */
  double (*time)(const struct um_effect_use *, double t_tai);
  /* The exposure as it is, from what scenario or measurement say [s], not negative. */
  double (*exposure)(const struct um_effect_use *, double exposure);
  /* The satellite is where the orbit has it this much later [s]. */
  double (*along_track)(const struct um_effect_use *);
  /* One attitude law of the scenario, before it is used. */
  enum um_status (*law)(struct um_context *, const struct um_effect_use *,
                        struct um_orbit_attitude_law *);
  /* Attitude as it is, from what the law says; GCRS to body. */
  struct um_quat (*attitude)(const struct um_effect_use *, double t_tai, struct um_quat q);
  enum um_status (*observation)(struct um_context *, const struct um_effect_use *,
                                struct um_effect_observation *);
  /* The air above the station, where the scenario states it. */
  enum um_status (*sky)(struct um_context *, const struct um_effect_use *,
                        struct um_environment_clear_sky *);
};

/* Sizes of everything that hooks read and change, mixed (Fowler-Noll-Vo): an object that was
 * compiled against other ones is refused. Fields that change places without a change of size need
 * another UM_EFFECT_ABI_VERSION. */
#define UM_EFFECT_MIX(hash, type) (((hash) ^ (uint64_t)sizeof(type)) * 1099511628211ULL)
#define UM_EFFECT_MIX4(hash, a, b, c, d)                                                           \
  UM_EFFECT_MIX(UM_EFFECT_MIX(UM_EFFECT_MIX(UM_EFFECT_MIX(hash, a), b), c), d)
#define UM_EFFECT_MIX8(hash, a, b, c, d, e, f, g, h)                                               \
  UM_EFFECT_MIX4(UM_EFFECT_MIX4(hash, a, b, c, d), e, f, g, h)
#define UM_EFFECT_LAYOUT                                                                           \
  UM_EFFECT_MIX(                                                                                   \
      UM_EFFECT_MIX(UM_EFFECT_MIX8(                                                                \
                        UM_EFFECT_MIX8(14695981039346656037ULL, struct um_effect_hooks,            \
                                       struct um_effect_use, struct um_effect_parameter,           \
                                       struct um_effect_observation, struct um_environment,        \
                                       struct um_materials_adjustment,                             \
                                       struct um_geometry_part_spec, struct um_thermal_part_spec), \
                        struct um_thermal_group_spec, struct um_thermal_shell,                     \
                        struct um_thermal_mli, struct um_thermal_contact,                          \
                        struct um_orbit_attitude_law, struct um_quat,                              \
                        struct um_thermal_interior_spec, struct um_geometry_creasing),             \
                    struct um_effect_nominal),                                                     \
      struct um_effect_view)
/* The first members of every descriptor. */
#define UM_EFFECT_ABI                                                                              \
  .abi_version = UM_EFFECT_ABI_VERSION, .struct_size = sizeof(struct um_effect),                   \
  .layout = UM_EFFECT_LAYOUT

/* The members that say its parameters, of an array. */
#define UM_EFFECT_PARAMETERS(array)                                                                \
  .parameters = (array), .nparameter = sizeof(array) / sizeof((array)[0])

/* Most parameters one effect may have. */
#define UM_EFFECT_PARAMETERS_MAX 8

struct um_effect {
  uint32_t abi_version; /* UM_EFFECT_ABI_VERSION */
  uint32_t struct_size; /* sizeof(struct um_effect) */
  uint64_t layout;      /* UM_EFFECT_LAYOUT */
  const char *name;
  const char *summary;
  const char *reference;
  const char *validity;
  /* Reads behind "told apart from": its alternatives, a colon, the measurement that does it; NULL:
   * not said. */
  const char *separated_by;
  uint32_t targets;  /* or-ed um_effect_target */
  int on_by_default; /* a core switch: present unless a scenario turns it off */
  const struct um_effect_parameter *parameters;
  size_t nparameter;
  struct um_effect_hooks hooks;
  /* For a core switch: called when the scenario turns it off. NULL: it acts by its hooks, which are
   * not called then. */
  enum um_status (*switch_off)(struct um_context *, struct um_environment *);
  /* For a core switch that keys of `environment` may hold off (shadow: sphere): whether they do,
   * and what turns it on all the same; it does nothing where it is on. NULL: only `effects` and
   * the command line turn it off. */
  bool (*is_off)(const struct um_environment *);
  enum um_status (*switch_on)(struct um_context *, struct um_environment *);
  /* Why it has nothing to do on a target, whatever its values: a few words; NULL: it may have.
   * NULL: it always may. */
  const char *(*refusal)(const struct um_effect_nominal *);
};

/* Parameters that may be fitted: all before those that are chosen. */
static inline size_t um_effect_fitted(const struct um_effect *effect)
{
  size_t n = effect->nparameter;
  while (n > 0 && effect->parameters[n - 1].chosen) n--;
  return n;
}

#endif
