/* The Jacobian of a fit. Private to base/inference/. */
#ifndef UMBRA_INFERENCE_JACOBIAN_IMPL_H
#define UMBRA_INFERENCE_JACOBIAN_IMPL_H

#include "base/inference/descent_state_impl.h"

/* The model at x_trial. happened: false where it refuses (UM_ERR_REFUSED, UM_ERR_NUMERIC, a value
 * that is not finite); its message is then cleared. */
enum um_status um_inference_descent_try(struct um_context *context,
                                        struct um_inference_descent *descent, bool *happened);
/* Jacobian by differences at x. */
enum um_status um_inference_descent_differences(struct um_context *context,
                                                struct um_inference_descent *descent);
/* Broyden's update for the step from x to x_trial. */
void um_inference_descent_update(struct um_inference_descent *descent);
/* Whether the Jacobian as it was made still predicts the residuals at x. */
bool um_inference_descent_serves(struct um_inference_descent *descent);

#endif
