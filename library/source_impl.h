/* A scenario as a caller has it: text and changes. Private to library/. */
#ifndef UMBRA_LIBRARY_SOURCE_IMPL_H
#define UMBRA_LIBRARY_SOURCE_IMPL_H

#include "library/session_impl.h"
#include "model/build/model.h"

/* All zero is empty. Texts are owned. */
struct um_library_source {
  char *path, *text;              /* text: the YAML */
  struct um_document_change *set; /* [nset] keys; their texts are owned */
  size_t nset;
  struct um_model_change *change; /* [nchange] */
  size_t nchange;
};

/* Takes copies of its texts. */
enum um_status um_library_source_add_set(struct um_context *context,
                                         struct um_library_source *source,
                                         const struct um_document_change *set);
/* Takes copies of everything that the change borrows. */
enum um_status um_library_source_add_change(struct um_context *context,
                                            struct um_library_source *source,
                                            const struct um_model_change *change);
/* Take the last one off. */
void um_library_source_drop_set(struct um_context *context, struct um_library_source *source);
void um_library_source_drop_change(struct um_context *context, struct um_library_source *source);
/* out: released by the caller, also after a failure. */
enum um_status um_library_source_copy(struct um_context *context,
                                      const struct um_library_source *source,
                                      struct um_library_source *out);
void um_library_source_release(struct um_context *context, struct um_library_source *source);
/* What a model of the session is built with; borrowed from both. */
struct um_model_options um_library_source_options(const struct um_library_source *source,
                                                  const struct umbra *umbra);

#endif
