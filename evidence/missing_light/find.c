/* The correction of light that explains most for what its numbers cost. */
#include "evidence/missing_light/light.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "evidence/missing_light/policy.h"
#include "evidence/missing_light/search_impl.h"

#define REFINED 8 /* slots whose place and width are found better */

/* The best attempt of a slot. */
static struct um_missing_light_attempt *best_of(const struct um_missing_light_search *s,
                                                size_t slot, double scale)
{
  struct um_missing_light_attempt *best = NULL, *all = s->best + slot * UM_MISSING_LIGHT_COUNTS;
  for (size_t k = 0; k < UM_MISSING_LIGHT_COUNTS; k++) {
    if (!(all[k].chi2 > 0.0)) continue;
    if (best == NULL ||
        um_missing_light_worth(s->o, &all[k], scale) > um_missing_light_worth(s->o, best, scale))
      best = &all[k];
  }
  return best;
}

/* The best slot that is not `done`, NULL: no more. */
static struct um_missing_light_attempt *next_best(const struct um_missing_light_search *s,
                                                  const bool *done, double scale, size_t *slot)
{
  struct um_missing_light_attempt *best = NULL;
  for (size_t i = 0; i < s->nslot; i++) {
    struct um_missing_light_attempt *a = done[i] ? NULL : best_of(s, i, scale);
    if (a == NULL) continue;
    if (best != NULL &&
        !(um_missing_light_worth(s->o, a, scale) > um_missing_light_worth(s->o, best, scale)))
      continue;
    best = a;
    *slot = i;
  }
  return best;
}

/* Reduced chi-square that the most that was explained leaves, at least 1. */
static double scale_of(const struct um_missing_light_search *s, double dof)
{
  double most = 0.0;
  for (size_t i = 0; i < s->nslot * UM_MISSING_LIGHT_COUNTS; i++)
    most = fmax(most, s->best[i].chi2);
  return fmax(1.0, (s->o->square - most) / dof);
}

static const char *material_of(const struct um_missing_light_observations *o,
                               const struct um_missing_light_attempt *a)
{
  return a->kind == UM_LIGHT_FACTOR && a->material < o->nmaterial ? o->material[a->material] : NULL;
}

static void describe(const struct um_missing_light_observations *o,
                     const struct um_missing_light_attempt *a, struct um_missing_light *out)
{
  out->any = true;
  out->kind = a->kind;
  out->material = material_of(o, a);
  out->coordinate = a->coordinate;
  out->curve = a->curve;
  um_missing_light_range(o, a->coordinate, &out->from, &out->to);
  out->grey = a->band == UM_MISSING_LIGHT_GREY;
  bool all = out->grey || a->band == UM_MISSING_LIGHT_OWN;
  for (size_t b = 0; b < o->nband && out->nband < UM_MISSING_LIGHT_NUMBERS; b++)
    if (all || b == a->band) out->band[out->nband++] = o->band[b];
  out->nvalue = a->nvalue;
  for (size_t i = 0; i < a->nvalue; i++) {
    out->value[i] = a->value[i];
    out->sigma[i] = a->sigma[i] * sqrt(out->scale);
  }
  out->nparameter = um_missing_light_numbers(a) + UM_MISSING_LIGHT_CHOSEN;
  out->chi2_after = out->chi2_before - a->chi2;
  out->worth = um_missing_light_worth(o, a, out->scale);
}

/* The best, then what could be in its place. done: [nslot] false. */
static void choose(struct um_missing_light_search *s, bool *done, struct um_missing_light *out)
{
  size_t slot = 0;
  struct um_missing_light_attempt *a;
  for (int i = 0; i < REFINED && (a = next_best(s, done, out->scale, &slot)) != NULL; i++) {
    um_missing_light_refine(s, a);
    done[slot] = true;
  }
  memset(done, 0, s->nslot * sizeof *done);
  while ((a = next_best(s, done, out->scale, &slot)) != NULL) {
    done[slot] = true;
    if (!out->any) {
      describe(s->o, a, out);
      continue;
    }
    double behind = out->worth - um_missing_light_worth(s->o, a, out->scale);
    if (behind > UM_MISSING_LIGHT_TIED || out->nalternative == UM_MISSING_LIGHT_ALTERNATIVES) break;
    out->alternative[out->nalternative++] =
        (struct um_missing_light_alternative){a->kind, material_of(s->o, a), a->coordinate, behind};
  }
}

static bool is_found(const struct um_missing_light *l, double dof)
{
  double left = fmax(UM_MISSING_LIGHT_LEFT * (l->chi2_before - dof),
                     UM_MISSING_LIGHT_SCATTER * sqrt(2.0 * dof));
  double needed = UM_MISSING_LIGHT_EVIDENCE + 2.0 * log((double)l->tried);
  return l->any && l->worth > needed && l->chi2_after - dof < left;
}

enum um_status um_missing_light_find(struct um_context *context,
                                     struct um_sensitivity_forward *forward,
                                     const struct um_model_addition *addition, size_t naddition,
                                     const double *value, const double *nuisance, size_t nnuisance,
                                     struct um_missing_light *out)
{
  enum um_status status;
  double begin = omp_get_wtime();
  struct um_missing_light_observations o = {0};
  struct um_missing_light_search s = {0};
  bool *done = NULL;
  double dof = (double)forward->observations.count - (double)nnuisance;
  *out = (struct um_missing_light){.scale = 1.0};
  um_core_quiet_begin(context);
  status = um_missing_light_observations_create(context, forward, addition, naddition, value,
                                                nuisance, nnuisance, &o);
  um_core_quiet_end(context);
  if (status != UM_OK) goto done;
  out->chi2_before = out->chi2_after = o.square;
  if (o.nband == 0) goto done;
  UM_CHECK(um_missing_light_search_create(context, &o, &s));
  UM_CHECK(um_core_allocate(context, s.nslot, sizeof *done, &done));
  out->scale = scale_of(&s, dof);
  choose(&s, done, out);
  out->tried = s.tried;
  out->found = is_found(out, dof);
done:
  forward->seconds += omp_get_wtime() - begin;
  um_core_free(context, done);
  um_missing_light_search_release(context, &s);
  um_missing_light_observations_release(context, &o);
  return status;
}
