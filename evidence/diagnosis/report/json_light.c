/* What is in no catalogue, in diagnosis.json: a correction of light, and which half is wrong. */
#include <math.h>

#include "base/core/json.h"
#include "effects/half.h"
#include "evidence/diagnosis/report/report_impl.h"

static void json_curve(FILE *file, const struct um_missing_light *l)
{
  static const char *const kind[] = {"lines", "bump", "edge", "fall", "waves"};
  bool time = l->coordinate == UM_COORDINATE_TIME;
  um_core_json_text(file, ", \"curve\": {", "kind", kind[l->curve.kind]);
  if (l->curve.kind != UM_CURVE_HATS && l->curve.kind != UM_CURVE_WAVES) {
    if (time)
      um_diagnosis_report_json_time(file, ", ", "at_utc", l->curve.a);
    else
      um_core_json_field(file, ", ", "at", l->curve.a);
    um_core_json_field(file, ", ", "width", l->curve.b);
  }
  fputs(", \"values\": [", file);
  for (size_t i = 0; i < l->nvalue; i++) {
    fputs(i > 0 ? ", {" : "{", file);
    um_core_json_text(file, "", "band", l->grey ? NULL : l->band[i / l->curve.n]);
    um_core_json_field(file, ", ", "value", l->value[i]);
    um_core_json_field(file, ", ", "sigma", l->sigma[i]);
    fputc('}', file);
  }
  fputs("]}", file);
}

static void json_others(FILE *file, const struct um_missing_light *l)
{
  fputs(", \"others\": [", file);
  for (size_t i = 0; i < l->nalternative; i++) {
    const struct um_missing_light_alternative *r = &l->alternative[i];
    um_core_json_text(file, i > 0 ? ", {" : "{", "kind", um_missing_light_kind_name(r->kind));
    um_core_json_text(file, ", ", "material", r->material);
    um_core_json_text(file, ", ", "coordinate", um_missing_light_coordinate_name(r->coordinate));
    um_core_json_field(file, ", ", "bic_behind", r->behind);
    fputc('}', file);
  }
  fputc(']', file);
}

void um_diagnosis_report_json_light(FILE *file, const char *key, const struct um_missing_light *l)
{
  char text[UM_MISSING_LIGHT_TEXT];
  bool time = l->coordinate == UM_COORDINATE_TIME;
  fprintf(file, ", \"%s\": ", key);
  if (!l->any) {
    fputs("null", file);
    return;
  }
  um_missing_light_text(l, text);
  um_core_json_text(file, "{", "text", text);
  um_core_json_bool(file, ", ", "found", l->found);
  um_core_json_text(file, ", ", "kind", um_missing_light_kind_name(l->kind));
  um_core_json_text(file, ", ", "material", l->material);
  fputs(", \"bands\": [", file);
  for (size_t b = 0; b < l->nband; b++) {
    if (b > 0) fputs(", ", file);
    um_core_json_string(file, l->band[b]);
  }
  fputc(']', file);
  um_core_json_bool(file, ", ", "grey", l->grey);
  um_core_json_text(file, ", ", "coordinate", um_missing_light_coordinate_name(l->coordinate));
  if (time) {
    um_diagnosis_report_json_time(file, ", ", "from_utc", l->from);
    um_diagnosis_report_json_time(file, ", ", "to_utc", l->to);
  } else {
    um_core_json_field(file, ", ", "from", l->from);
    um_core_json_field(file, ", ", "to", l->to);
  }
  json_curve(file, l);
  um_core_json_field(file, ", ", "chi2_explained", l->chi2_before - l->chi2_after);
  um_core_json_field(file, ", ", "chi2_after", l->chi2_after);
  um_core_json_field(file, ", ", "bic_gain", l->worth);
  json_others(file, l);
  fputc('}', file);
}

void um_diagnosis_report_json_halves(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"halves\": ", file);
  if (isnan(d->half[0])) {
    fputs("null", file);
    return;
  }
  for (size_t h = 0; h < UM_HALVES; h++)
    um_core_json_field(file, h == 0 ? "{" : ", ", um_effects_half_name((enum um_effects_half)h),
                       d->half[h]);
  fputc('}', file);
}
