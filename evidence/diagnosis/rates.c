/* Effects with a rate, which does nothing while what goes on at it has not begun. Where it was
 * looked for (evidence/sensitivity/scan_rates.c), chi-square is smooth about the rate that was
 * found, and the fit begins where the linear model has the others there. */
#include <math.h>

#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

enum um_status um_diagnosis_start_along(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *before,
                                        struct um_diagnosis_state *state, size_t b)
{
  enum um_status status;
  struct um_diagnosis_block *block = &state->block[b];
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[block->candidate];
  size_t n = work->forward->observations.count;
  struct um_diagnosis_directions d = {0};
  struct um_inference_score score;
  double *residual = NULL;
  UM_CHECK(um_diagnosis_directions_make(context, work, before, &d));
  UM_CHECK(um_core_allocate(context, n, sizeof *residual, &residual));
  um_diagnosis_residual_at_means(work, before, n, residual);
  UM_CHECK(um_inference_score_test(context, n, residual, &d.nuisance, 1,
                                   &d.direction[block->candidate], &score));
  for (size_t k = 0; k < c->ncolumn; k++) {
    const struct um_effect_parameter *of = &c->effect->parameters[c->parameter[k]];
    double x = um_effect_transformed(of, c->null_value[c->parameter[k]]);
    if (isfinite(score.estimate[k])) x += score.estimate[k] * um_diagnosis_unit(c, k);
    block->addition.value[c->parameter[k]] =
        fmin(fmax(um_effect_physical(of, x), block->minimum[k]), block->maximum[k]);
  }
done:
  um_core_free(context, residual);
  um_diagnosis_directions_release(context, &d);
  return status;
}
