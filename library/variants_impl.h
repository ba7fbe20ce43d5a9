/* Variants behind the public header. Private to library/. */
#ifndef UMBRA_LIBRARY_VARIANTS_IMPL_H
#define UMBRA_LIBRARY_VARIANTS_IMPL_H

#include "library/model_impl.h"
#include "variant/evaluator.h"

struct umbra_variants {
  struct umbra *session;
  struct umbra_model *model; /* shared */
  atomic_int users;          /* the caller's handle, and results of it */
  struct um_variant_evaluator *evaluator;
  struct um_variant_heat heat;
};

struct umbra_variants *um_library_variants_share(struct umbra_variants *variants);
/* Gone with the last user. Accepts NULL, sets NULL. */
void um_library_variants_drop(struct umbra_variants **variants);

/* Changes as the evaluator takes them; keys and targets are the caller's. Begin with {0}. */
struct um_library_changes {
  struct um_document_change *key;
  struct um_model_addition *addition;
  char **off; /* [nwithout of all] owned "effect:target" */
  struct um_model_changes all;
};
/* change: [n]. UM_ERR_INPUT, UM_ERR_MEMORY; cleared by the caller, after a failure too. */
enum um_status um_library_changes_take(struct um_context *context, const struct um_model *model,
                                       const struct umbra_change *change, size_t n,
                                       struct um_library_changes *to);
void um_library_changes_clear(struct um_context *context, struct um_library_changes *changes);

#endif
