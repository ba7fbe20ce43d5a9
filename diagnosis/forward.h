/* One scenario before one set of measurements, computed again and again with effects added. What
 * an addition cannot change is not computed again: the trace where no hook reaches it, the heat
 * where the network is the same. */
#ifndef UMBRA_DIAGNOSIS_FORWARD_H
#define UMBRA_DIAGNOSIS_FORWARD_H

#include "compare/predict.h"
#include "model/model.h"

/* An effect beside those of the scenario. One that the scenario has already on this target is
 * replaced; a core switch has no values and is turned on. */
struct um_diagnosis_addition {
  const struct um_effect *effect;
  const char *target; /* NULL: global; borrowed */
  double value[UM_EFFECT_PARAMETERS_MAX];
};

struct um_diagnosis_forward {
  const char *path;                                   /* of the scenario; borrowed */
  const struct um_compare_measurements *measurements; /* borrowed */
  struct um_model *model;                             /* the scenario as it stands */
  struct um_compare_plan *plan;
  /* rows in use (flag 0), in file order */
  size_t nrow;
  size_t *row;          /* [nrow] of the set */
  size_t *channel;      /* [nrow] of the set's channels */
  double *t;            /* [nrow] t_tai [s] */
  double *measured;     /* [nrow] linear unit: magnitudes as flux relative to magnitude 0 */
  double *sigma;        /* [nrow] linear unit; every row has one */
  size_t evaluations;   /* how often a model was computed */
  double seconds_first; /* wall time of the first evaluation, trace and run [s] */
  double seconds;       /* of all [s] */
  struct um_diagnosis_forward_cache *cache; /* private */
};

/* What `loosened` may well be: on the ENVISAT pass rows of 1 % move by 0.007 sigma at most, an
 * evaluation repeats to 0.004 sigma, and heat costs a third. */
#define UM_DIAGNOSIS_LOOSENED 30.0
/* options: the user's --set, --with, --without; borrowed. loosened: factor on the tolerances of the
 * heat integration for every evaluation (1: as the scenario has them; derivatives by differences
 * want the same for all). UM_ERR_INPUT naming file and line: what um_compare_plan_create refuses,
 * and a row in use without sigma that the scenario's noise model does not fill. The caller
 * destroys. */
enum um_status um_diagnosis_forward_create(struct um_context *context, const char *path,
                                           const struct um_model_options *options,
                                           const struct um_compare_measurements *measurements,
                                           double loosened, struct um_diagnosis_forward **out);
void um_diagnosis_forward_destroy(struct um_context *context,
                                  struct um_diagnosis_forward **forward);

/* Model values of the rows in use with the additions, in the linear unit; value: shape [nrow].
 * UM_ERR_INPUT where an effect refuses what it is asked (no such node, out of range): the caller
 * takes that as "not a candidate". */
enum um_status um_diagnosis_forward_evaluate(struct um_context *context,
                                             struct um_diagnosis_forward *forward,
                                             const struct um_diagnosis_addition *addition,
                                             size_t naddition, double *value);

/* The same with everything kept: model, trace and result of the variant, for a comparison or for
 * bands and places that were not measured. grid: false: times of the measurements; true: of the
 * scenario's own window (with orbit.points, which has none, those of the measurements). Owned by
 * the caller, released by _release. Tolerances are the scenario's times loosened. */
struct um_diagnosis_forward_run {
  struct um_model *model;
  struct um_model_trace *trace;
  struct um_model_result *result;
};
enum um_status um_diagnosis_forward_run(struct um_context *context,
                                        const struct um_diagnosis_forward *forward,
                                        const struct um_diagnosis_addition *addition,
                                        size_t naddition, bool grid,
                                        struct um_diagnosis_forward_run *out);
void um_diagnosis_forward_run_release(struct um_context *context,
                                      struct um_diagnosis_forward_run *run);

/* "effect:target,name=value,..." as --with takes it, values with all digits; the caller frees. */
enum um_status um_diagnosis_addition_text(struct um_context *context,
                                          const struct um_diagnosis_addition *addition, char **out);
/* Values of effect:target as the scenario has it now, its null values where it has it not or off.
 */
void um_diagnosis_forward_null(const struct um_diagnosis_forward *forward,
                               const struct um_effect *effect, const char *target, double *value);

#endif
