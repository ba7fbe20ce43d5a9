/* Names of a measurement file, each kept once: tag and text -> index in order of first appearance.
 * Private to evidence/measurements/. */
#ifndef UMBRA_COMPARE_NAMES_IMPL_H
#define UMBRA_COMPARE_NAMES_IMPL_H

#include <stddef.h>

#include "base/core/context.h"

/* All zero is empty. */
struct um_compare_names {
  char **text; /* [count] */
  size_t *tag; /* [count], a second key beside the text */
  size_t count, capacity;
  size_t *slot; /* [slots] index + 1, 0: free; open addressing */
  size_t slots; /* a power of two */
};

/* Index of (tag, text), added where it is new. UM_ERR_MEMORY. */
enum um_status um_compare_names_intern(struct um_context *context, struct um_compare_names *names,
                                       size_t tag, const char *text, size_t *index);
void um_compare_names_free(struct um_context *context, struct um_compare_names *names);
/* Hand the texts over: the caller frees each and the array; `names` is empty after. */
char **um_compare_names_take(struct um_context *context, struct um_compare_names *names);

#endif
