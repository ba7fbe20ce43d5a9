/* The registry of physical effects: one const descriptor per file of this folder, one list; and the
 * effects of a user's own shared objects beside them. */
#ifndef UMBRA_EFFECTS_EFFECTS_H
#define UMBRA_EFFECTS_EFFECTS_H

#include <stdio.h>

#include "core/effect.h"

/* All built-in effects, in the order of the list; borrowed. */
size_t um_effects_count(void);
const struct um_effect *um_effects_at(size_t index);
/* NULL when there is none of that name. */
const struct um_effect *um_effects_find(const char *name);
/* Names of all effects, comma separated, for messages; cut to size. */
void um_effects_names(char *out, size_t size);

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

/* A descriptor that the program can work with: ABI, texts, targets, parameters within their bounds,
 * something that acts. UM_ERR_INPUT with "effect 'NAME': what is wrong; accepted: ...". */
enum um_status um_effects_check(struct um_context *context, const struct um_effect *effect);

/* The manual's page of one effect, built-in or a user's own, as Markdown; and the whole manual,
 * docs/effects.md. Errors of writing are the stream's. */
void um_effects_write_markdown(FILE *file, const struct um_effect *effect);
void um_effects_write_manual(FILE *file);

#endif
