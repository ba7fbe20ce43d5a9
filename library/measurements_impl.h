/* The measurements behind the public header. Private to library/. */
#ifndef UMBRA_LIBRARY_MEASUREMENTS_IMPL_H
#define UMBRA_LIBRARY_MEASUREMENTS_IMPL_H

#include "evidence/measurements/set.h"
#include "library/session_impl.h"

struct umbra_measurements {
  struct umbra *session;
  atomic_int users; /* the caller's handle, and results that are of them */
  struct um_compare_measurements *set;
};

struct umbra_measurements *um_library_measurements_share(struct umbra_measurements *measurements);
/* Gone with the last user. Accepts NULL, sets NULL. */
void um_library_measurements_drop(struct umbra_measurements **measurements);

#endif
