/* The model behind the public header. Private to library/. */
#ifndef UMBRA_LIBRARY_MODEL_IMPL_H
#define UMBRA_LIBRARY_MODEL_IMPL_H

#include "library/session_impl.h"
#include "library/source_impl.h"

struct umbra_model {
  struct umbra *session;
  atomic_int users; /* the caller's handle, and results of it */
  struct um_library_source source;
  struct um_model_options options;
  struct um_model *model;
  char *log;                           /* what was said while it was built */
  const char **name[UM_LIBRARY_NAMES]; /* [count] owned lists */
  char **material_place;               /* [materials] owned texts among them */
  size_t count[UM_LIBRARY_NAMES];
};

struct umbra_model *um_library_model_share(struct umbra_model *model);
/* Gone with the last user. Accepts NULL, sets NULL. */
void um_library_model_drop(struct umbra_model **model);

#endif
