/* The signatures of all candidates. Private to evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_SIGNATURES_IMPL_H
#define UMBRA_SENSITIVITY_SIGNATURES_IMPL_H

#include "evidence/sensitivity/difference_impl.h"

/* Signature, steps, insensitive and why of candidates [count], of which the rest is set; by as many
 * processes as the context has threads. Progress is reported. */
enum um_status um_sensitivity_signatures_create(struct um_context *context,
                                                const struct um_sensitivity_point *point,
                                                struct um_sensitivity_candidate *candidate,
                                                size_t count);

#endif
