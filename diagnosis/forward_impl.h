/* What a forward keeps between evaluations, and the models it builds. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_FORWARD_IMPL_H
#define UMBRA_DIAGNOSIS_FORWARD_IMPL_H

#include "diagnosis/forward.h"

/* Traces kept beside the scenario's own: one iteration of a fit moves several parameters that each
 * want another. */
#define UM_DIAGNOSIS_TRACES 3

/* One trace with heat on it, and the model they were made from. */
struct um_diagnosis_traced {
  char *key;              /* texts of the additions that it stands for; "" for the scenario */
  struct um_model *model; /* owned, but the scenario's own */
  struct um_model_trace *trace;
  struct um_model_heat *heat; /* NULL: that of the scenario serves */
  size_t used;                /* number of the evaluation that used it last */
};

struct um_diagnosis_forward_cache {
  struct um_model_options options; /* the user's; texts borrowed */
  double loosened;
  struct um_diagnosis_traced own; /* of the scenario as it stands */
  struct um_diagnosis_traced kept[UM_DIAGNOSIS_TRACES];
  double *predicted; /* [rows of the set] in the unit of the quantity */
  double *base;      /* [nrow] of the scenario as it stands, linear unit */
  double noise;      /* um_diagnosis_forward_noise; NaN: not yet known */
  bool fresh_heat;   /* the last evaluation integrated heat of its own */
};

/* The scenario with the additions. UM_ERR_INPUT where an effect refuses. */
enum um_status um_diagnosis_variant_create(struct um_context *context,
                                           const struct um_diagnosis_forward *forward,
                                           const struct um_diagnosis_addition *addition,
                                           size_t naddition, struct um_model **out);
/* Texts of the additions that the scenario's own trace does not serve, "" when it serves; the
 * caller frees. */
enum um_status um_diagnosis_variant_key(struct um_context *context,
                                        const struct um_diagnosis_forward *forward,
                                        const struct um_model *variant,
                                        const struct um_diagnosis_addition *addition,
                                        size_t naddition, char **out);
/* Largest change of a row [sigma] when the scenario's own heat is integrated anew from where it
 * ended: how well heat that is integrated repeats. Computed once. */
enum um_status um_diagnosis_forward_noise(struct um_context *context,
                                          struct um_diagnosis_forward *forward, double *out);
/* Rows in use with their sigma, from the scenario's own values in cache->predicted. */
enum um_status um_diagnosis_rows_create(struct um_context *context,
                                        struct um_diagnosis_forward *forward);

#endif
