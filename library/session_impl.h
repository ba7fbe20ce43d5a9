/* The session behind the public header. Private to library/. */
#ifndef UMBRA_LIBRARY_SESSION_IMPL_H
#define UMBRA_LIBRARY_SESSION_IMPL_H

#include <stdatomic.h>

#include "base/core/arena.h"
#include "base/core/context.h"
#include "effects/effects.h"
#include "library/umbra.h"

#define UM_LIBRARY_NAMES (UMBRA_MECHANISMS + 1) /* kinds */

struct umbra {
  struct um_context *context;
  struct umbra_settings settings; /* its texts belong to the context */
  struct um_core_arena memory;    /* of the catalogue */
  struct um_effects_registry *registry;
  const char **effect_file; /* [neffect_file] absolute, of effects beside the built-in ones */
  size_t neffect_file;
  struct umbra_effect *effect; /* [neffect] */
  size_t neffect;
  struct umbra_key *key; /* [nkey] */
  size_t nkey;
  struct {
    const char **name; /* [count]; NULL: not asked for */
    size_t count;
  } data[UM_LIBRARY_NAMES];
  atomic_int users;       /* the caller's handle, and objects that were made with it */
  atomic_int interrupted; /* not 0: the call under way is to end */
};

/* One user more; gone with the last. Accepts NULL. */
struct umbra *um_library_session_share(struct umbra *umbra);
void um_library_session_drop(struct umbra **umbra);

/* The context for a new call, its message and its log cleared. */
struct um_context *um_library_begin(struct umbra *umbra);
enum umbra_status um_library_status(enum um_status status);
/* Fill the lists of effects and keys. UM_ERR_MEMORY. */
enum um_status um_library_catalogue(struct umbra *umbra);
/* Does a structure of the caller's begin with a size that this version knows? UM_ERR_INPUT. */
enum um_status um_library_check_size(struct um_context *context, const char *name, size_t size,
                                     size_t known);

#endif
