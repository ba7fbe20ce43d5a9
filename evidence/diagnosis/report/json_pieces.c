/* Pieces of diagnosis.json: texts, times, uses of effects with their values. */
#include "evidence/diagnosis/report/report_impl.h"

#include <math.h>

#include "base/core/json.h"
#include "evidence/diagnosis/value_text.h"
#include "evidence/measurements/time_text.h"

void um_diagnosis_report_json_time(FILE *file, const char *before, const char *key, double t_tai)
{
  char text[40];
  if (isfinite(t_tai)) um_compare_time_text(t_tai, text);
  um_core_json_text(file, before, key, isfinite(t_tai) ? text : NULL);
}

void um_diagnosis_report_json_use(FILE *file, const struct um_diagnosis *d,
                                  const struct um_effect *effect, const char *target)
{
  um_core_json_text(file, "", "effect", effect->name);
  um_core_json_text(file, ", ", "target", target);
  if (um_sensitivity_is_on(d->forward, effect)) um_core_json_bool(file, ", ", "off", true);
}

void um_diagnosis_report_json_parameter(FILE *file, const struct um_effect_parameter *parameter,
                                        double value, double sigma)
{
  um_core_json_text(file, "{", "name", parameter->name);
  um_core_json_field(file, ", ", "value", value);
  um_core_json_field(file, ", ", "sigma", sigma);
  um_core_json_text(file, ", ", "unit", parameter->unit);
}

/* With what the scenario states as a whole, where it states something. */
void um_diagnosis_report_json_parameters(FILE *file, const struct um_diagnosis *d,
                                         const struct um_effect *effect, const char *target,
                                         const double *value, const double *sigma)
{
  fputs(", \"parameters\": [", file);
  for (size_t p = 0; p < effect->nparameter; p++) {
    struct um_diagnosis_whole whole;
    fputs(p > 0 ? ", " : "", file);
    um_diagnosis_report_json_parameter(file, &effect->parameters[p], value[p], sigma[p]);
    if (um_diagnosis_whole_find(d->forward, effect, target, p, value[p], sigma[p], &whole)) {
      um_core_json_text(file, ", \"whole\": {", "what", whole.what);
      um_core_json_field(file, ", ", "value", whole.value);
      um_core_json_field(file, ", ", "sigma", whole.sigma);
      um_core_json_field(file, ", ", "instead_of", whole.instead_of);
      um_core_json_text(file, ", ", "unit", whole.unit);
      fputc('}', file);
    }
    fputc('}', file);
  }
  fputc(']', file);
}
