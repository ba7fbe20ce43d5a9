/* In what a study falls short of what was asked of it, as text. */
#ifndef UMBRA_STUDY_SHORTFALL_H
#define UMBRA_STUDY_SHORTFALL_H

#include "study/result.h"

/* Points that have a quantity. */
size_t um_study_points_of(const struct um_study_result *result,
                          const struct um_study_quantity *quantity);

/* A line for each, behind its end a newline, but for the last: why the surrogate falls short; which
 * errors are larger than asked, and by how much; what is withheld from it and rests on which
 * points. NULL: nothing is. The caller frees. UM_ERR_MEMORY. */
enum um_status um_study_shortfall(struct um_context *context, const struct um_study_result *result,
                                  char **out);

#endif
