/* Results behind the public header, of whatever kind. Private to library/. */
#ifndef UMBRA_LIBRARY_RESULT_IMPL_H
#define UMBRA_LIBRARY_RESULT_IMPL_H

#include "base/core/file.h"
#include "library/session_impl.h"
#include "model/build/model.h"

/* What differs between results of runs, comparisons and diagnoses. */
struct um_library_kind {
  enum um_status (*write)(struct um_context *context, const struct umbra_result *result,
                          const struct umbra_write *write, struct um_core_folder *folder);
  void (*release)(struct um_context *context, void *work);
  /* The model that it is of; borrowed. NULL: it keeps none, and is not cited. */
  const struct um_model *(*model)(const void *work);
};

struct umbra_result {
  struct umbra *session;
  const struct um_library_kind *kind;
  void *work;                /* of its kind */
  struct umbra_array *array; /* [narray] */
  size_t narray;
  double **owned; /* [nowned] what arrays show that nobody else has */
  size_t nowned;
  struct umbra_citation citation; /* owned texts; NULL: not asked for */
};

/* A result without arrays; takes `work` over when it succeeds. */
enum um_status um_library_result_create(struct um_context *context, struct umbra *session,
                                        const struct um_library_kind *kind, void *work,
                                        struct umbra_result **out);
/* Add an array; the data outlives the result. Nothing where data is NULL. */
enum um_status um_library_result_show(struct um_context *context, struct umbra_result *result,
                                      const struct umbra_array *array);
/* The same, of that name and unit, of new data [count], which the result owns and the caller
 * fills. */
enum um_status um_library_result_make(struct um_context *context, struct umbra_result *result,
                                      struct umbra_array array, const char *name, const char *unit,
                                      double **data);

#endif
