/* The registry of physical effects: one const descriptor per file of this folder, one list; and the
 * effects of a user's own shared objects beside them. */
#ifndef UMBRA_EFFECTS_EFFECTS_H
#define UMBRA_EFFECTS_EFFECTS_H

#include "effects/effect.h"

/* All built-in effects, in the order of the list; borrowed. */
size_t um_effects_count(void);
const struct um_effect *um_effects_at(size_t index);
/* NULL when there is none of that name. */
const struct um_effect *um_effects_find(const char *name);

/* The built-in effects and those of shared objects that were loaded into it: of one model, or of
 * one command. */
struct um_effects_registry;
/* Out: the caller destroys, after everything that still uses its effects. UM_ERR_MEMORY. */
enum um_status um_effects_registry_create(struct um_context *context,
                                          struct um_effects_registry **out);
/* Closes its objects. Accepts NULL, sets NULL. */
void um_effects_registry_destroy(struct um_context *context, struct um_effects_registry **registry);
/* Load a shared object and take its effects: the symbol `um_effect` is a const struct um_effect, or
 * the symbol `um_effect_list` an array of const struct um_effect * that ends with NULL. Loading
 * runs what the object does when it is loaded. A file that is already loaded is left as it is.
 * UM_ERR_IO: not there, not a shared object. UM_ERR_INPUT, all beginning with the path: neither
 * symbol, another abi_version or struct_size, what um_effects_check refuses, a name that is taken.
 * UM_ERR_MEMORY. The registry stays as it was when it fails. */
enum um_status um_effects_registry_load(struct um_context *context,
                                        struct um_effects_registry *registry, const char *path);
/* The built-in ones, then the loaded, in order of loading; a registry NULL has only built-in ones.
 */
size_t um_effects_registry_count(const struct um_effects_registry *registry);
const struct um_effect *um_effects_registry_at(const struct um_effects_registry *registry,
                                               size_t index);
const struct um_effect *um_effects_registry_find(const struct um_effects_registry *registry,
                                                 const char *name);
void um_effects_registry_names(const struct um_effects_registry *registry, char *out, size_t size);
/* UM_ERR_INPUT for a name that no effect has: the nearest one and what is accepted. */
enum um_status um_effects_registry_refuse(struct um_context *context,
                                          const struct um_effects_registry *registry,
                                          const char *name);

/* Which parameter of the effect is called so, now or before (`formerly`); nparameter: none is. For
 * names that were accepted before; the program compares names nowhere else. Does not fail. */
size_t um_effects_parameter_find(const struct um_effect *effect, const char *name);
/* The names by which one use has said its parameters; all NULL before the first. Borrowed. */
struct um_effects_said {
  const char *name[UM_EFFECT_PARAMETERS_MAX];
};
/* The same for a name that a user writes. One from before is a warning in the log, once a use.
 * said: of the use, takes the name. UM_ERR_INPUT: no parameter is called so, with the nearest one
 * and what is accepted; the use has it by its other name already. */
enum um_status um_effects_parameter_read(struct um_context *context, const struct um_effect *effect,
                                         const char *name, struct um_effects_said *said,
                                         size_t *out);

/* A descriptor that the program can work with: ABI, texts, targets, parameters within their bounds,
 * something that acts. UM_ERR_INPUT with "effect 'NAME': what is wrong; accepted: ...". */
enum um_status um_effects_check(struct um_context *context, const struct um_effect *effect);

/* What hangs on an effect's values, and so has to be computed again when they change; anything that
 * is not reached is the same to the last bit. */
enum um_effects_reach {
  UM_REACH_GEOMETRY = 1,    /* shapes, places, times: the geometry tables */
  UM_REACH_LIGHT = 2,       /* Sun, Earth, shadow: the geometry tables where their numbers differ */
  UM_REACH_THERMAL = 4,     /* heat network: the thermal solution where its numbers differ */
  UM_REACH_OPTICS = 8,      /* how surfaces return and emit light; temperature reaches it too */
  UM_REACH_OBSERVATION = 16 /* what is done to the light behind the satellite */
};
/* Or-ed um_effects_reach of its hooks. Does not fail. */
uint32_t um_effects_reach(const struct um_effect *effect);
/* Do all of its hooks act on light that has left the satellite: on the air before the observer, on
 * what is measured? Does not fail. */
bool um_effects_act_behind(const struct um_effect *effect);
/* Does it act on single observations alone, on their time, exposure or reading, and is no switch?
 * Then it may be that of one set of measurements: its target ends with "@" and the set's name,
 * "vis@night1", of all that it acts on "all@night1". Does not fail. */
bool um_effects_may_be_of_a_set(const struct um_effect *effect);
#define UM_EFFECTS_ALL "all"
/* Name of the set in such a target, behind its last "@"; NULL: there is none, or it may not be of a
 * set. Borrowed from target. Does not fail. */
const char *um_effects_set_of(const struct um_effect *effect, const char *target);
/* How many characters of target say on what it acts: those before that "@"; 0: everything. Does not
 * fail. */
size_t um_effects_place_of(const struct um_effect *effect, const char *target);
/* Does a satellite of the same temperatures send the same light with it? */
bool um_effects_light_alike(const struct um_effect *effect);

#endif
