/* Many variants of one evaluator at once, by worker processes. */
#ifndef UMBRA_VARIANT_MANY_H
#define UMBRA_VARIANT_MANY_H

#include "base/batch/each.h"
#include "variant/evaluator.h"

/* um_batch_each of tasks that open variants of the evaluator, whose base is computed: its pages
 * are shared by the workers, and what may be kept beside it is divided among them. A variant has
 * the same bits in any worker, so that the result does not depend on their number. records: where
 * answers are kept; NULL: nowhere. */
enum um_status um_variant_tasks(struct um_context *context, struct um_variant_evaluator *evaluator,
                                struct um_batch *records, const struct um_workers_each *tasks);

/* Variants to be looked at. Everything is borrowed for the call. */
struct um_variant_each {
  size_t n;
  const struct um_model_changes *changes; /* [n] */
  const struct um_variant_heat *heat;
  size_t nvalue; /* numbers of each */
  /* What is wanted of a variant, into value [nvalue]; in the worker that computed it. */
  enum um_status (*take)(struct um_context *context, void *user, size_t which,
                         const struct um_variant *variant, const struct um_model_result *result,
                         double *value);
  /* As of um_workers_each; what the model refuses of the changes is UM_ERR_REFUSED. */
  enum um_status (*done)(struct um_context *context, void *user, size_t which,
                         enum um_status status, const double *value);
  void *user;
  int workers; /* <= 1: this process alone, by its threads */
};
/* Light and temperatures of every variant. What all share of the scenario as it stands is computed
 * first, by all threads. Errors of um_variant_base and um_workers_each. */
enum um_status um_variant_each(struct um_context *context, struct um_variant_evaluator *evaluator,
                               const struct um_variant_each *each);

#endif
