/* What no effect of the catalogue explains: missing heat and missing light, held against the
 * effects that were added and against what is called a discrepancy. */
#include <math.h>

#include "evidence/diagnosis/diagnosis_impl.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* Look for missing heat in the residual of a state. */
static enum um_status look_for_heat(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state,
                                    struct um_missing_heat_unexplained **out)
{
  struct um_model_addition *addition = NULL;
  UM_TRY(um_core_allocate(context, state->nblock, sizeof *addition, &addition));
  um_diagnosis_state_additions(state, addition);
  enum um_status status = um_missing_heat_unexplained_create(
      context, work->forward, addition, state->nblock, state->fit->value, state->fit->jacobian,
      state->nparameter, out);
  um_core_free(context, addition);
  return status;
}

/* The effects that were added give way to what is in no catalogue. */
static enum um_status drop_effects(struct um_context *context, const struct um_diagnosis_work *work,
                                   struct um_diagnosis_state *state,
                                   const struct um_diagnosis_state *bare, struct um_diagnosis *d)
{
  if (d->naddition == 0) return UM_OK;
  um_diagnosis_steps_clear(context, d);
  um_diagnosis_state_release(context, state);
  UM_TRY(um_diagnosis_state_copy(context, bare, bare->nblock, state));
  UM_TRY(um_diagnosis_state_fit(context, work, state, bare->fit->value, NULL, INFINITY));
  return um_diagnosis_keep_end(context, work, state, d);
}

/* The effects that were added may only mimic heat. So the BIC of the scenario with the best heat,
 * which has the parameters of its shape, is compared with that of the scenario with the effects. */
enum um_status um_diagnosis_weigh_heat(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       struct um_diagnosis_state *state,
                                       const struct um_diagnosis_state *bare,
                                       struct um_diagnosis *d)
{
  struct um_missing_heat_unexplained *heat = NULL;
  if (work->options->no_heat) return UM_OK;
  UM_TRY(look_for_heat(context, work, bare, &heat));
  bool explained = d->verdict != UM_VERDICT_UNEXPLAINED; /* with a discrepancy */
  bool better = heat->nheat > 0 && um_diagnosis_pulse_bic(heat, bare->fit) <
                                       state->fit->bic - (explained ? UM_DIAGNOSIS_EVIDENCE : 0.0);
  if ((d->naddition > 0 || explained) && !better) {
    um_missing_heat_unexplained_destroy(context, &heat);
    return explained ? UM_OK : look_for_heat(context, work, state, &d->unexplained);
  }
  d->unexplained = heat;
  d->verdict = UM_VERDICT_UNEXPLAINED;
  if (better) d->nscatter = d->noutlier = 0; /* of what the heat is in place of */
  return drop_effects(context, work, state, bare, d);
}

static enum um_status look_for_light(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     const struct um_diagnosis_state *state,
                                     struct um_missing_light *out)
{
  struct um_model_addition *addition = NULL;
  UM_TRY(um_core_allocate(context, state->nblock, sizeof *addition, &addition));
  um_diagnosis_state_additions(state, addition);
  enum um_status status =
      um_missing_light_find(context, work->forward, addition, state->nblock, state->fit->value,
                            state->fit->jacobian, state->nparameter, out);
  um_core_free(context, addition);
  return status;
}

/* Whether a discrepancy of light is so large that light may explain it, too. */
static bool leaves_much_light(const struct um_diagnosis *d)
{
  for (size_t i = 0; i < d->nscatter; i++)
    if (d->scatter[i].sigmas > UM_DIAGNOSIS_LARGE_SIGMAS &&
        d->forward->measurements->channel[d->scatter[i].channel].quantity !=
            UM_QUANTITY_TEMPERATURE)
      return true;
  return false;
}

/* Light in place of the effects that were added: they give way, and so does the noise that was
 * estimated beside them. */
static enum um_status take_light(struct um_context *context, const struct um_diagnosis_work *work,
                                 struct um_diagnosis_state *state,
                                 const struct um_diagnosis_state *bare, struct um_diagnosis *d)
{
  d->verdict = UM_VERDICT_UNEXPLAINED;
  d->nscatter = d->noutlier = 0;
  if (!work->options->no_heat) {
    um_missing_heat_unexplained_destroy(context, &d->unexplained);
    UM_TRY(look_for_heat(context, work, bare, &d->unexplained));
  }
  return drop_effects(context, work, state, bare, d);
}

/* A verdict that calls much of what is left a discrepancy: light that explains all must not do
 * better, by what so many curves find in noise. */
static enum um_status hold_against_light(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         struct um_diagnosis_state *state,
                                         const struct um_diagnosis_state *bare,
                                         struct um_diagnosis *d)
{
  struct um_missing_light light;
  if (!leaves_much_light(d)) return UM_OK;
  UM_TRY(look_for_light(context, work, bare, &light));
  double needed = UM_DIAGNOSIS_EVIDENCE + 2.0 * log(fmax(1.0, (double)light.tried));
  if (!light.found || !(um_diagnosis_light_bic(&light, bare->fit) < state->fit->bic - needed))
    return UM_OK;
  d->light = light;
  return take_light(context, work, state, bare, d);
}

/* Light of an unexplained residual: of the scenario as it is where it does better so than with the
 * effects that were added, which then only mimicked it; else of what they leave. */
enum um_status um_diagnosis_weigh_light(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        struct um_diagnosis_state *state,
                                        const struct um_diagnosis_state *bare,
                                        struct um_diagnosis *d)
{
  if (work->options->no_light) return UM_OK;
  if (d->verdict != UM_VERDICT_UNEXPLAINED)
    return hold_against_light(context, work, state, bare, d);
  UM_TRY(look_for_light(context, work, bare, &d->light));
  if (d->naddition == 0) {
    if (d->light.found) d->nscatter = d->noutlier = 0; /* of what the light is in place of */
    return UM_OK;
  }
  double with_effects = um_diagnosis_gain(d, bare, state->fit->bic);
  if (!(d->light.any && d->light.worth > with_effects + UM_DIAGNOSIS_EVIDENCE))
    return look_for_light(context, work, state, &d->light);
  return take_light(context, work, state, bare, d);
}

/* What a draft is made of: heat and light of the scenario as it is. */
enum um_status um_diagnosis_look_as_asked(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          const struct um_diagnosis_state *bare,
                                          struct um_diagnosis *d)
{
  if (!work->options->draft) return UM_OK;
  UM_TRY(look_for_light(context, work, bare, &d->light_asked));
  return look_for_heat(context, work, bare, &d->heat_asked);
}
