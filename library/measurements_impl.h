/* The measurements behind the public header. Private to library/. */
#ifndef UMBRA_LIBRARY_MEASUREMENTS_IMPL_H
#define UMBRA_LIBRARY_MEASUREMENTS_IMPL_H

#include "evidence/measurements/set.h"
#include "library/session_impl.h"

struct umbra_measurements {
  struct umbra *session;
  atomic_int users; /* the caller's handle, and results that are of them */
  struct um_compare_measurements *set;
  struct umbra_columns said; /* of umbra_measurements_columns; size 0: not asked for */
  double *number;            /* what its columns of numbers point into */
  const char **text;         /* and those of texts */
  int *flag;
};

/* A set as an object of the caller's, who is its user; *set is taken over when it succeeds. */
enum um_status um_library_measurements_take(struct um_context *context, struct umbra *umbra,
                                            struct um_compare_measurements **set,
                                            struct umbra_measurements **out);

struct umbra_measurements *um_library_measurements_share(struct umbra_measurements *measurements);
/* Gone with the last user. Accepts NULL, sets NULL. */
void um_library_measurements_drop(struct umbra_measurements **measurements);

#endif
