/* Which paths meet something where they first turn, kept for many light curves. Private to the
 * rooms of optics/.
 *
 * Most paths leave the satellite at once and bring nothing. Whether one does hangs on geometry,
 * observer and the lobe of the surface where it begins; how much surfaces reflect only chooses
 * between lobe and cosine. Both ways are kept of every path, a bit each: light is the same to the
 * last digit with them and without. */
#ifndef UMBRA_OPTICS_FIRST_TURNS_GROUP_H
#define UMBRA_OPTICS_FIRST_TURNS_GROUP_H

#include "optics/paths/paths_impl.h"

/* Of one instant. */
struct um_optics_first_turns {
  const struct um_materials_lobe *lobe; /* [nskin] they were found with, borrowed */
  uint8_t *bits; /* two of each path: of surfaces toward the observer, one after the other */
};

/* Paths of a surface at this instant; 0: none, as of surfaces that turn away. */
size_t um_optics_first_turns_of(const struct um_optics_paths *paths, size_t surface);
/* Room for the paths of an instant, *bytes of it; nothing is traced. UM_ERR_MEMORY. */
enum um_status um_optics_first_turns_create(struct um_context *context,
                                            const struct um_optics_paths *paths, size_t *bytes,
                                            struct um_optics_first_turns *out);
void um_optics_first_turns_clear(struct um_context *context, struct um_optics_first_turns *turns);
/* All of them; turns->lobe is set. By one thread. */
void um_optics_first_turns_trace(const struct um_optics_paths *paths,
                                 struct um_optics_first_turns *turns);

#endif
