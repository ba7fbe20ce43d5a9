/* Results of a parameter study in memory. */
#include "study/result.h"

#include <stdint.h>
#include <string.h>

#include "base/uncertainty/surrogate.h"

const struct um_study_quantity *um_study_result_quantity(const struct um_study_result *result,
                                                         const char *name)
{
  for (size_t q = 0; q < result->nquantity; q++)
    if (strcmp(result->quantity[q].name, name) == 0) return &result->quantity[q];
  return NULL;
}

const double *um_study_result_values(const struct um_study_result *result, size_t point,
                                     const struct um_study_quantity *quantity)
{
  return result->value + point * result->nvalue + quantity->first;
}

static void free_texts(struct um_context *context, char **text, size_t n)
{
  for (size_t i = 0; text != NULL && i < n; i++) um_core_free(context, text[i]);
  um_core_free(context, (void *)text);
}

void um_study_result_destroy(struct um_context *context, struct um_study_result **result)
{
  if (result == NULL || *result == NULL) return;
  struct um_study_result *r = *result;
  for (size_t q = 0; r->quantity != NULL && q < r->nquantity; q++) {
    UM_FREE(context, r->quantity[q].name, r->quantity[q].unit, r->quantity[q].of);
  }
  um_core_free(context, r->quantity);
  free_texts(context, r->parameter_name, r->nparameter);
  free_texts(context, r->parameter_unit, r->nparameter);
  free_texts(context, r->reason, r->npoint);
  UM_FREE(context, r->name, r->scenario);
  for (size_t i = 0; r->distribution != NULL && i < r->nparameter; i++)
    um_core_free(context, (void *)(uintptr_t)r->distribution[i].value);
  um_core_free(context, r->distribution);
  um_uncertainty_surrogate_destroy(context, &r->surrogate);
  UM_FREE(context, r->unexplained, r->falls_short);
  UM_FREE(context, r->limit, r->time, r->sunlit, r->coordinate, r->parameter, r->value, r->nominal,
          r->at_nominal, r->error, r);
  *result = NULL;
}
