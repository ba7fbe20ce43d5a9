/* The iteration of a fit. Private to base/inference/. */
#ifndef UMBRA_INFERENCE_DESCENT_IMPL_H
#define UMBRA_INFERENCE_DESCENT_IMPL_H

#include "base/inference/descent_state_impl.h"

/* From the problem's start. Errors of evaluate there are passed on. The caller releases what was
 * begun (um_inference_descent_release), after an error too. */
enum um_status um_inference_descent_begin(struct um_context *context,
                                          const struct um_inference_fit_problem *problem,
                                          struct um_inference_descent *out);
/* To the minimum, or as far as iterations_max reach. */
enum um_status um_inference_descent_run(struct um_context *context,
                                        struct um_inference_descent *descent);

#endif
