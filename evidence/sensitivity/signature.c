/* How the observations change with the parameters of an effect (difference.c).
 *
 * A parameter that changes nothing alone, while another one of the effect does, is unidentified
 * under the null (a period, a delay): it is not free but stays at its default value. Where no
 * parameter changes anything alone, each is tried with the others at their default value. */
#include "evidence/sensitivity/signature_impl.h"

#include <string.h>

#include "effects/effects.h"

/* The change of the observations when a switch is turned. */
static enum um_status make_switch(struct um_context *context,
                                  const struct um_sensitivity_point *point,
                                  struct um_sensitivity_candidate *c)
{
  struct um_sensitivity_change change;
  c->ncolumn = 1;
  c->step[0] = 1.0;
  UM_TRY(um_sensitivity_step_to(context, point, c, c->null_value, NULL, c->signature, &change));
  c->insensitive = !um_sensitivity_alive(&change, point->noise);
  c->quality[0] = (struct um_sensitivity_quality){.way = UM_SENSITIVITY_BY_SWITCH, .step = 1.0};
  return UM_OK;
}

/* Columns of the parameters that change something at `at`; the others are left out. */
static enum um_status make_columns(struct um_context *context,
                                   const struct um_sensitivity_point *point, const double *at,
                                   struct um_sensitivity_candidate *c)
{
  size_t n = point->forward->observations.count;
  c->ncolumn = 0;
  for (size_t p = 0; p < um_effect_fitted(c->effect); p++) {
    struct um_sensitivity_change change;
    double step = um_sensitivity_first_step(c, p, at[p]);
    double *column = c->signature + c->ncolumn * n;
    if (c->trials > 0 && c->effect->parameters[p].is_rate) continue; /* it was looked for */
    const struct um_sensitivity_mover mover = {context, point, c, at, p, column};
    UM_TRY(um_sensitivity_derivative(&mover, &step, &change, &c->quality[p]));
    if (!um_sensitivity_alive(&change, point->noise)) continue;
    c->parameter[c->ncolumn] = p;
    c->step[c->ncolumn++] = step;
  }
  return UM_OK;
}

/* Where derivatives are taken: null values, but unidentified parameters at their default. */
static bool put_shapes(struct um_sensitivity_candidate *c)
{
  bool any = false;
  for (size_t p = 0; p < um_effect_fitted(c->effect); p++) {
    bool is_free = false;
    for (size_t k = 0; k < c->ncolumn; k++) is_free = is_free || c->parameter[k] == p;
    const struct um_effect_parameter *parameter = &c->effect->parameters[p];
    if (is_free || c->null_value[p] != parameter->null_value ||
        c->null_value[p] == parameter->default_value)
      continue;
    c->null_value[p] = parameter->default_value;
    any = true;
  }
  return any;
}

/* Default values of all parameters, but the temperatures that the scan found. */
static void set_defaults(const struct um_sensitivity_candidate *c, double *at)
{
  for (size_t k = 0; k < c->effect->nparameter; k++)
    at[k] = c->effect->parameters[k].is_temperature ? c->null_value[k]
                                                    : c->effect->parameters[k].default_value;
}

/* The parameter whose null value makes the effect vanish, whatever the others are. There is none
 * where even all default values together change nothing. */
static enum um_status find_amplitude(struct um_context *context,
                                     const struct um_sensitivity_point *point,
                                     struct um_sensitivity_candidate *c)
{
  size_t n = c->effect->nparameter;
  double at[UM_EFFECT_PARAMETERS_MAX];
  struct um_sensitivity_change change;
  set_defaults(c, at);
  UM_TRY(um_sensitivity_step_to(context, point, c, at, NULL, c->signature, &change));
  if (!um_sensitivity_alive(&change, point->noise)) return UM_OK;
  for (size_t p = 0; p < um_effect_fitted(c->effect); p++) {
    set_defaults(c, at);
    at[p] = c->null_value[p];
    if (memcmp(at, c->null_value, n * sizeof *at) == 0) continue; /* tried */
    UM_TRY(um_sensitivity_step_to(context, point, c, at, NULL, c->signature, &change));
    if (!um_sensitivity_is_nothing(&change))
      continue; /* a change by the noise of an integration is not nothing */
    double step = um_sensitivity_first_step(c, p, at[p]);
    const struct um_sensitivity_mover mover = {context, point, c, at, p, c->signature};
    UM_TRY(um_sensitivity_derivative(&mover, &step, &change, &c->quality[p]));
    if (!um_sensitivity_alive(&change, point->noise)) continue;
    memcpy(c->null_value, at, n * sizeof *at);
    c->ncolumn = 1;
    c->parameter[0] = p;
    c->step[0] = step;
    return UM_OK;
  }
  return UM_OK;
}

/* Parameters that are not free are unidentified under the null. */
static void put_rest(struct um_sensitivity_candidate *c)
{
  c->nunidentified = 0;
  for (size_t p = 0; p < um_effect_fitted(c->effect) && !c->insensitive; p++) {
    bool is_free = false;
    for (size_t k = 0; k < c->ncolumn; k++) is_free = is_free || c->parameter[k] == p;
    if (!is_free) c->unidentified[c->nunidentified++] = p;
  }
}

size_t um_sensitivity_signature_moves(const struct um_sensitivity_candidate *c,
                                      struct um_sensitivity_move *out)
{
  size_t n = c->effect->nparameter,
         nfree = c->insensitive || c->is_switch ? 0 : um_effect_fitted(c->effect);
  for (size_t p = 0; p < nfree; p++) {
    out[p] =
        (struct um_sensitivity_move){.effect = c->effect,
                                     .target = c->target,
                                     .parameter = p,
                                     .step = um_sensitivity_first_step(c, p, c->null_value[p])};
    memcpy(out[p].at, c->null_value, n * sizeof *out[p].at);
  }
  return nfree;
}

enum um_status um_sensitivity_signature_make(struct um_context *context,
                                             const struct um_sensitivity_point *point,
                                             struct um_sensitivity_candidate *c)
{
  if (c->is_switch) return make_switch(context, point, c);
  UM_TRY(make_columns(context, point, c->null_value, c));
  if (um_effect_fitted(c->effect) > 1) {
    if (c->ncolumn == 0)
      UM_TRY(find_amplitude(context, point, c));
    else if (c->ncolumn < um_effect_fitted(c->effect) && put_shapes(c))
      UM_TRY(um_sensitivity_signature_renew(context, point, c));
  }
  c->insensitive = c->ncolumn == 0;
  put_rest(c);
  return UM_OK;
}

enum um_status um_sensitivity_signature_renew(struct um_context *context,
                                              const struct um_sensitivity_point *point,
                                              struct um_sensitivity_candidate *c)
{
  size_t n = point->forward->observations.count;
  if (c->is_switch) return make_switch(context, point, c);
  for (size_t k = 0; k < c->ncolumn; k++) {
    struct um_sensitivity_change change;
    double *column = c->signature + k * n;
    const struct um_sensitivity_mover mover = {context,       point,           c,
                                               c->null_value, c->parameter[k], column};
    UM_TRY(um_sensitivity_derivative(&mover, &c->step[k], &change, &c->quality[c->parameter[k]]));
  }
  return UM_OK;
}
