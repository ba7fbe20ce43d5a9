/* The scenario behind the public header. Private to library/. */
#ifndef UMBRA_LIBRARY_SCENARIO_IMPL_H
#define UMBRA_LIBRARY_SCENARIO_IMPL_H

#include "library/session_impl.h"
#include "library/source_impl.h"

struct umbra_scenario {
  struct umbra *session;
  struct um_library_source source;
  struct um_document *document; /* the source as it was asked last; NULL: it was not, or changed */
  struct umbra_value value;     /* the answer */
};

/* Is it one change, the index-th from 0? UM_ERR_INPUT. */
enum um_status um_library_check_change(struct um_context *context,
                                       const struct umbra_change *change, size_t index);
/* A key with a number, text NULL, or with YAML text, which the change borrows. UM_ERR_INPUT. */
enum um_status um_library_take_key(struct um_context *context, const char *key, double number,
                                   const char *text, struct um_document_change *out);
/* What a caller's change says of its effect, by the effect's parameters. */
struct um_library_effect_numbers {
  const struct um_effect *effect;
  bool said[UM_EFFECT_PARAMETERS_MAX];
  double value[UM_EFFECT_PARAMETERS_MAX]; /* where said */
};
/* UM_ERR_INPUT: not a change that its effect can take. */
enum um_status um_library_read_effect_change(struct um_context *context,
                                             const struct um_effects_registry *registry,
                                             const struct umbra_effect_change *change,
                                             struct um_library_effect_numbers *out);
/* Check a caller's change against the effect, and add it. UM_ERR_INPUT. */
enum um_status um_library_take_change(struct um_context *context,
                                      const struct um_effects_registry *registry,
                                      const struct umbra_effect_change *change,
                                      struct um_library_source *source);

#endif
