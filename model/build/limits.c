/* Limits of temperatures: do they name places of this satellite? */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "model/scenario/fail_group.h"

static enum um_status fail_unknown(struct um_context *context, const struct um_model *model,
                                   const struct um_scenario_limit *limit)
{
  char names[512] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = limit->of};
  for (size_t p = 0; p < model->body->nplace; p++) {
    um_core_words_append(names, sizeof names, model->body->place[p].name);
    um_core_words_consider(&guess, model->body->place[p].name);
  }
  return um_model_fail(context, &limit->at, "of", "no place '%s'%s; accepted: %s", limit->of,
                       um_core_words_hint(&guess, hint), names);
}

enum um_status um_model_check_limits(struct um_context *context, const struct um_model *model)
{
  const struct um_scenario_limit *limit = model->scenario->limits.items;
  for (size_t i = 0; i < model->scenario->limits.count; i++) {
    const struct um_scenario_limit *l = &limit[i];
    if (um_thermal_body_place_find(model->body, l->of) == (size_t)-1)
      return fail_unknown(context, model, l);
    for (size_t k = 0; k < i; k++)
      if (strcmp(limit[k].of, l->of) == 0)
        return um_model_fail(context, &l->at, "of",
                             "'%s' has a limit on line %d; accepted: one for each place", l->of,
                             limit[k].at.line);
    if (isnan(l->minimum_K) && isnan(l->maximum_K))
      return um_model_fail(context, &l->at, NULL,
                           "no bound is given; accepted: minimum_K, maximum_K or both");
    if (l->minimum_K >= l->maximum_K)
      return um_model_fail(context, &l->at, "minimum_K",
                           "%g is not below maximum_K %g; accepted: a lower minimum", l->minimum_K,
                           l->maximum_K);
  }
  return UM_OK;
}
