/* Values of effects as text. */
#include "evidence/diagnosis/value_text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "evidence/sensitivity/stated.h"

static void append(char *out, size_t size, const char *format, ...) UM_PRINTF(3, 4);
static void append(char *out, size_t size, const char *format, ...)
{
  size_t used = strlen(out);
  va_list list;
  va_start(list, format);
  if (used < size) vsnprintf(out + used, size - used, format, list);
  va_end(list);
}

bool um_diagnosis_whole_find(const struct um_sensitivity_forward *forward,
                             const struct um_effect *effect, const char *target, size_t p,
                             double value, double sigma, struct um_diagnosis_whole *out)
{
  double present[UM_EFFECT_PARAMETERS_MAX];
  struct um_effect_stated stated;
  um_sensitivity_forward_null(forward, effect, target, present);
  if (!um_sensitivity_stated_find(forward, effect, target, p, present[p], &stated)) return false;
  double above = um_sensitivity_stated_whole(&stated, value + sigma);
  double below = um_sensitivity_stated_whole(&stated, value - sigma);
  *out = (struct um_diagnosis_whole){.what = stated.what,
                                     .unit = stated.unit,
                                     .value = um_sensitivity_stated_whole(&stated, value),
                                     .sigma = isfinite(sigma) ? 0.5 * fabs(above - below) : NAN,
                                     .instead_of = stated.value};
  return true;
}

void um_diagnosis_whole_text(const struct um_diagnosis_whole *whole, char out[160])
{
  bool plain = strcmp(whole->unit, "1") == 0;
  snprintf(out, 160, "(%s %.4g", whole->what, whole->value);
  if (isfinite(whole->sigma)) append(out, 160, " +- %.2g", whole->sigma);
  append(out, 160, " instead of %.4g%s%s)", whole->instead_of, plain ? "" : " ",
         plain ? "" : whole->unit);
}

void um_diagnosis_values_text(const struct um_sensitivity_forward *forward,
                              const struct um_effect *effect, const char *target,
                              const double *value, const double *sigma,
                              char out[UM_DIAGNOSIS_VALUES_MAX])
{
  out[0] = '\0';
  for (size_t p = 0; p < effect->nparameter; p++) {
    const struct um_effect_parameter *of = &effect->parameters[p];
    struct um_diagnosis_whole whole;
    char text[160];
    bool plain = strcmp(of->unit, "1") == 0;
    if (isnan(sigma[p]) && value[p] == of->null_value) continue;
    append(out, UM_DIAGNOSIS_VALUES_MAX, "%s%s %.4g", out[0] != '\0' ? " " : "", of->name,
           value[p]);
    if (isfinite(sigma[p])) append(out, UM_DIAGNOSIS_VALUES_MAX, " +- %.2g", sigma[p]);
    if (!plain) append(out, UM_DIAGNOSIS_VALUES_MAX, " %s", of->unit);
    if (!um_diagnosis_whole_find(forward, effect, target, p, value[p], sigma[p], &whole)) continue;
    um_diagnosis_whole_text(&whole, text);
    append(out, UM_DIAGNOSIS_VALUES_MAX, " %s", text);
  }
}

double um_diagnosis_prior_widths(const struct um_sensitivity_candidate *candidate,
                                 const double *value)
{
  double most = 0.0;
  for (size_t k = 0; k < candidate->ncolumn && !candidate->is_switch; k++) {
    size_t p = candidate->parameter[k];
    const struct um_effect_parameter *of = &candidate->effect->parameters[p];
    double away =
        um_effect_transformed(of, value[p]) - um_effect_transformed(of, candidate->null_value[p]);
    if (isfinite(of->prior_sigma)) most = fmax(most, fabs(away) / of->prior_sigma);
  }
  return most;
}
