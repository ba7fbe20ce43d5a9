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

/* To as many decimals, which may be below 0. */
static double rounded(double value, int decimals)
{
  double unit = pow(10.0, -decimals);
  return round(value / unit) * unit;
}

void um_diagnosis_value_text(double value, double sigma, const char *between, char out[80])
{
  int decimals = sigma > 0.0 && isfinite(sigma) ? 1 - (int)floor(log10(sigma)) : -1;
  if (!isfinite(sigma))
    snprintf(out, 80, "%.4g", value);
  else if (sigma > 0.0 && decimals < 0 && fabs(value) < 1e6 && sigma < 1e6)
    snprintf(out, 80, "%.0f %s %.0f", rounded(value, decimals), between, rounded(sigma, decimals));
  else if (sigma > 0.0 && decimals <= 6 && fabs(value) < 1e6 && sigma < 1e6)
    snprintf(out, 80, "%.*f %s %.*f", decimals > 0 ? decimals : 0, value, between,
             decimals > 0 ? decimals : 0, sigma);
  else
    snprintf(out, 80, "%.4g %s %.2g", value, between, sigma);
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
  char value[80];
  um_diagnosis_value_text(whole->value, whole->sigma, "+-", value);
  snprintf(out, 160, "%s %s instead of %.4g%s%s", whole->what, value, whole->instead_of,
           plain ? "" : " ", plain ? "" : whole->unit);
}

/* Is the whole the parameter itself? */
static bool is_same(const struct um_diagnosis_whole *whole, double value)
{
  return fabs(whole->value - value) <= 1e-9 * fabs(value);
}

static void add_parameter(const struct um_sensitivity_forward *forward,
                          const struct um_effect *effect, const char *target, size_t p,
                          double value, double sigma, bool wholes,
                          char out[UM_DIAGNOSIS_VALUES_MAX])
{
  const struct um_effect_parameter *of = &effect->parameters[p];
  struct um_diagnosis_whole whole;
  char text[160];
  bool plain = strcmp(of->unit, "1") == 0;
  bool has_whole =
      wholes && um_diagnosis_whole_find(forward, effect, target, p, value, sigma, &whole);
  um_diagnosis_value_text(value, sigma, "+-", text);
  append(out, UM_DIAGNOSIS_VALUES_MAX, "%s%s %s", out[0] != '\0' ? ", " : "", of->name, text);
  if (has_whole && is_same(&whole, value))
    append(out, UM_DIAGNOSIS_VALUES_MAX, " instead of %.4g", whole.instead_of);
  if (!plain) append(out, UM_DIAGNOSIS_VALUES_MAX, " %s", of->unit);
  if (!has_whole || is_same(&whole, value)) return;
  um_diagnosis_whole_text(&whole, text);
  append(out, UM_DIAGNOSIS_VALUES_MAX, ", %s", text);
}

void um_diagnosis_values_text(const struct um_sensitivity_forward *forward,
                              const struct um_effect *effect, const char *target,
                              const double *value, const double *sigma, bool wholes,
                              char out[UM_DIAGNOSIS_VALUES_MAX])
{
  out[0] = '\0';
  for (size_t p = 0; p < effect->nparameter; p++)
    if (!isnan(sigma[p]) || value[p] != effect->parameters[p].null_value)
      add_parameter(forward, effect, target, p, value[p], sigma[p], wholes, out);
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
