/* What of the scenario's own geometry precomputation still holds for a scenario with additions, by
 * what the additions reach. */
#include "sensitivity/variant_impl.h"

#include "core/words.h"
#include "effects/effects.h"
#include "model/precomputed_serves.h"

size_t um_sensitivity_variant_key(const struct um_model *scenario, const struct um_model *variant,
                                  const struct um_model_addition *addition, size_t naddition,
                                  struct um_model_addition *key)
{
  bool lit = !um_model_light_serves(scenario, variant);
  size_t count = 0;
  for (size_t i = 0; i < naddition; i++) {
    uint32_t reach = um_effects_reach(addition[i].effect);
    if ((reach & UM_REACH_PRECOMPUTED) != 0 || (lit && (reach & UM_REACH_LIGHT) != 0))
      key[count++] = addition[i];
  }
  return count;
}

static bool same_addition(const struct um_model_addition *a, const struct um_model_addition *b)
{
  if (a->effect != b->effect || !um_core_words_same(a->target, b->target)) return false;
  for (size_t p = 0; p < a->effect->nparameter; p++)
    if (a->value[p] != b->value[p]) return false;
  return true;
}

bool um_sensitivity_variant_same_key(const struct um_model_addition *a, size_t na,
                                     const struct um_model_addition *b, size_t nb)
{
  if (na != nb) return false;
  for (size_t i = 0; i < na; i++)
    if (!same_addition(&a[i], &b[i])) return false;
  return true;
}
