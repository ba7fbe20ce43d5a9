/* The registry of physical effects: one const descriptor per file of this folder, one list. */
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
/* The manual's page of one effect, built-in or a user's own, as Markdown; and the whole manual,
 * docs/effects.md. Errors of writing are the stream's. */
void um_effects_write_markdown(FILE *file, const struct um_effect *effect);
void um_effects_write_manual(FILE *file);

#endif
