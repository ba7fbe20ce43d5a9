/* What a sceptic asks of the effect that explains most. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_SCEPTIC_IMPL_H
#define UMBRA_DIAGNOSIS_SCEPTIC_IMPL_H

#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* The state without the effect, as linear statistics have it. */
struct um_diagnosis_doubt {
  const struct um_diagnosis_work *work;
  const struct um_diagnosis_state *state; /* with it */
  size_t b;                               /* its block */
  struct um_diagnosis_state without;
  struct um_diagnosis_directions d; /* of the candidates, beside `without` */
  double *residual;                 /* [n] of `without`, whitened */
  double *column;                   /* [ncolumn][n] its own, whitened */
  size_t n, ncolumn;
};

/* Columns [ncolumn][n] with the rows that are not kept set to 0: they count for nothing. */
void um_diagnosis_keep_rows(const double *column, size_t ncolumn, size_t n, const bool *kept,
                            double *out);

/* What its values from one half of the time explain in the other [sigma] (frozen.c). */
enum um_status um_diagnosis_frozen(struct um_context *context, const struct um_diagnosis_doubt *s,
                                   double *out);
/* Variations and flips of out (influence.c). */
enum um_status um_diagnosis_influence(struct um_context *context,
                                      const struct um_diagnosis_doubt *s,
                                      const struct um_diagnosis_step *step,
                                      struct um_diagnosis_sceptic *out);

#endif
