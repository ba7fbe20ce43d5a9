/* One scenario before one set of measurements, computed again and again with effects added, by the
 * evaluator of variant/. */
#ifndef UMBRA_SENSITIVITY_FORWARD_H
#define UMBRA_SENSITIVITY_FORWARD_H

#include "evidence/comparison/predict.h"
#include "evidence/sensitivity/observations.h"
#include "variant/evaluator.h"
#include "variant/many.h"

struct um_sensitivity_forward {
  bool holds_files; /* everything is built from what was read first */
  const struct um_compare_measurements *measurements; /* borrowed */
  struct um_model_options options;                    /* the user's; texts borrowed */
  struct um_variant_tolerance tolerance;              /* of heat, of every evaluation */
  struct um_model *model; /* the scenario as it stands; of the base, too */
  struct um_compare_plan *plan;
  struct um_model_instants instants;      /* of the plan; sampling: of every evaluation */
  struct um_variant_evaluator *evaluator; /* of the model at the plan's instants */
  struct um_variant base;                 /* the scenario as it stands: its geometry and heat */
  struct um_sensitivity_observations observations; /* measurements in use, with their sigma */
  int samples, samples_before; /* optics.samples of every evaluation, and those of the scenario */
  int paths, paths_before;     /* the same of optics.interreflection_samples */
  /* where answers are kept (base/batch/each.h); NULL: nowhere; borrowed */
  struct um_batch *records;
  size_t evaluations;   /* how often a model was computed */
  double seconds_first; /* wall time of the first evaluation, geometry tables and run, and
                           of the search for samples [s] */
  double seconds;       /* of all [s]; of those that went on at once, their sum */
  size_t heat_runs;     /* how often heat was integrated for a variant */
  size_t heat_sensitivities, heat_batches;    /* parameters whose heat came by forward sensitivities
                                                 in place of that, and runs that gave them */
  double heat_seconds;                        /* wall time of both [s] */
  struct um_sensitivity_forward_cache *cache; /* private */
};

/* Where the model's own sampling error is too large beside sigma, optics.samples is raised as umbra
 * compare does (um_compare_refine), for every variant (plan->sampling): all look at the body with
 * the same points, and differences between them are smooth. forward->samples says what was used.
 * options: the user's --set, --with, --without; borrowed. tolerance: of the heat of every
 * evaluation, UM_VARIANT_TIGHT for that of a run; derivatives by differences want the same for all.
 * UM_ERR_INPUT naming file and line: what um_compare_plan_create refuses, and an observation in use
 * without sigma that the scenario's noise model does not fill. The caller destroys. */
enum um_status um_sensitivity_forward_create(struct um_context *context, const char *path,
                                             const struct um_model_options *options,
                                             const struct um_compare_measurements *measurements,
                                             struct um_variant_tolerance tolerance,
                                             struct um_sensitivity_forward **out);
void um_sensitivity_forward_destroy(struct um_context *context,
                                    struct um_sensitivity_forward **forward);

/* Model values of the observations in use with the additions, in the linear unit; value: shape
 * [nobservation]. UM_ERR_REFUSED where an effect refuses what it is asked (no such node, out of
 * range): the caller takes that as "not a candidate". */
enum um_status um_sensitivity_forward_evaluate(struct um_context *context,
                                               struct um_sensitivity_forward *forward,
                                               const struct um_model_addition *addition,
                                               size_t naddition, double *value);

/* um_variant_tasks, on record where the forward has records: what a task took (evaluations, heat,
 * seconds) is counted by the forward, whichever process did it, or did it long ago. */
enum um_status um_sensitivity_forward_tasks(struct um_context *context,
                                            struct um_sensitivity_forward *forward,
                                            const struct um_workers_each *tasks);

/* Heat of a variant, from that of the scenario as it stands. */
struct um_variant_heat um_sensitivity_forward_heat(const struct um_sensitivity_forward *forward);
/* The same with everything kept: model, geometry tables and result of the variant, for a
 * comparison or for bands and places that were not measured. over: NULL: times of the measurements;
 * else others, without times the scenario's own window (with orbit.points, which has none, times of
 * the measurements), by as few paths between surfaces as the scenario has, whatever its sampling
 * says: few measurements may want hundreds, which a window of many instants has no use for. Owned
 * by the caller, released by _release. Tolerances are those of the forward. */
struct um_sensitivity_forward_run {
  struct um_variant variant;
  struct um_model_result *result;
};
enum um_status um_sensitivity_forward_run(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          const struct um_model_addition *addition,
                                          size_t naddition, const struct um_model_instants *over,
                                          struct um_sensitivity_forward_run *out);
void um_sensitivity_forward_run_release(struct um_context *context,
                                        struct um_sensitivity_forward_run *run);

/* Values of effect:target as the scenario has it now, its null values where it has it not or off.
 */
void um_sensitivity_forward_null(const struct um_sensitivity_forward *forward,
                                 const struct um_effect *effect, const char *target, double *value);

#endif
