/* A physical effect: one const descriptor in one file of effects/, or in a user's shared object.
 * The manual, `umbra effects`, scenario validation, ablation and diagnosis are made from it. */
#ifndef UMBRA_CORE_EFFECT_H
#define UMBRA_CORE_EFFECT_H

#include <stddef.h>
#include <stdint.h>

#include "core/context.h"
#include "core/vec.h"

#define UM_EFFECT_ABI_VERSION 1

enum um_effect_target {
  UM_TARGET_GLOBAL = 1,
  UM_TARGET_PART = 2,
  UM_TARGET_PART_SIDE = 4,
  UM_TARGET_MATERIAL = 8,
  UM_TARGET_BAND = 16,
  UM_TARGET_SENSOR = 32
};

struct um_effect_parameter {
  const char *name; /* with unit: "power_W" */
  const char *unit; /* "W", "1" */
  const char *help;
  double null_value; /* the effect vanishes here */
  double fallback;   /* when the scenario does not say */
  double minimum, maximum;
  double prior_sigma; /* width of a weak prior about null_value; INFINITY: none */
};

/* The values of one use of an effect in a scenario. */
struct um_effect_use {
  const struct um_effect *effect;
  const char *target;  /* NULL for global */
  const double *value; /* [nparameter] */
};

/* Modules above core whose objects hooks change; opaque here. */
struct um_environment;
struct um_materials_adjustment;
struct um_thermal_part_spec;
struct um_thermal_group_spec;
struct um_thermal_network;
struct um_geometry_part_spec;

/* One observation while it is transformed. */
struct um_effect_observation {
  double t_tai;     /* [s] mid-exposure */
  double elevation; /* [rad], NaN without a station */
  double airmass;   /* [1], NaN */
  const char *band;
  double value; /* band irradiance [W/m^2]; the hook changes it */
};

/* Each hook may be NULL. They add to what is there, never set it, and do nothing at null values. */
struct um_effect_hooks {
  enum um_status (*environment)(struct um_context *, const struct um_effect_use *,
                                struct um_environment *);
  enum um_status (*material)(struct um_context *, const struct um_effect_use *,
                             const char *material, struct um_materials_adjustment *);
  enum um_status (*geometry)(struct um_context *, const struct um_effect_use *,
                             struct um_geometry_part_spec *);
  enum um_status (*part)(struct um_context *, const struct um_effect_use *, const char *part,
                         struct um_thermal_part_spec *);
  enum um_status (*group)(struct um_context *, const struct um_effect_use *, const char *part,
                          const char *group, struct um_thermal_group_spec *);
  enum um_status (*network)(struct um_context *, const struct um_effect_use *,
                            struct um_thermal_network *);
  /* time: from the time tag to the true time; attitude: body correction after the law. */
  double (*time)(const struct um_effect_use *, double t_tai);
  double (*orbit_time)(const struct um_effect_use *, double t_tai);
  struct um_quat (*attitude)(const struct um_effect_use *, double t_tai, struct um_quat q);
  enum um_status (*observation)(struct um_context *, const struct um_effect_use *,
                                struct um_effect_observation *);
};

struct um_effect {
  uint32_t abi_version; /* UM_EFFECT_ABI_VERSION */
  uint32_t struct_size; /* sizeof(struct um_effect) */
  const char *name;
  const char *summary;
  const char *reference;
  const char *validity;
  uint32_t targets;  /* or-ed um_effect_target */
  int on_by_default; /* a core switch: present unless a scenario turns it off */
  const struct um_effect_parameter *parameters;
  size_t nparameter;
  struct um_effect_hooks hooks;
  /* For a core switch: called when the scenario turns it off. */
  enum um_status (*switch_off)(struct um_context *, struct um_environment *);
};

#endif
