/* Which draft, under what name, and its file. */
#include "evidence/diagnosis/report/draft.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/core/file.h"
#include "effects/effects.h"

/* BIC by which an explanation is better than nothing. scale: reduced chi-square that is left. */
static double worth(double explained, size_t nparameter, double scale, double n)
{
  return explained / scale - (double)nparameter * log(n);
}

enum um_diagnosis_draft um_diagnosis_report_draft_choose(const struct um_diagnosis *d)
{
  const struct um_missing_heat_unexplained *u = d->heat_asked;
  const struct um_missing_light *l = &d->light_asked;
  bool heats = u != NULL && u->nheat > 0;
  double n = (double)d->forward->observations.count, heat = -INFINITY, light = -INFINITY;
  double left = fmin(heats ? u->chi2_after : INFINITY, l->any ? l->chi2_after : INFINITY);
  double scale = fmax(1.0, left / n);
  if (heats) heat = worth(u->chi2_before - u->chi2_after, u->heat[0].nparameter, scale, n);
  if (l->any) light = worth(l->chi2_before - l->chi2_after, l->nparameter, scale, n);
  if (!(fmax(heat, light) > 0.0)) return UM_DRAFT_NONE;
  return heat >= light ? UM_DRAFT_HEAT : UM_DRAFT_LIGHT;
}

void um_diagnosis_report_draft_text(const struct um_diagnosis *d, enum um_diagnosis_draft draft,
                                    char out[UM_DIAGNOSIS_DRAFT_TEXT])
{
  if (draft == UM_DRAFT_HEAT) {
    const struct um_missing_heat *h = &d->heat_asked->heat[0];
    char shape[UM_MISSING_HEAT_TEXT];
    um_missing_heat_text(h, shape);
    snprintf(out, UM_DIAGNOSIS_DRAFT_TEXT, "heat in %.100s, %.4g +- %.2g J%s", h->place, h->energy,
             h->energy_sigma, shape);
  } else if (draft == UM_DRAFT_LIGHT) {
    um_missing_light_text(&d->light_asked, out);
  } else {
    snprintf(out, UM_DIAGNOSIS_DRAFT_TEXT, "nothing");
  }
}

void um_diagnosis_report_draft_name(const struct um_diagnosis *d, const char *path,
                                    char out[UM_DIAGNOSIS_DRAFT_NAME])
{
  const char *slash = strrchr(path, '/'), *stem = slash != NULL ? slash + 1 : path;
  size_t n = 0;
  char plain[40];
  for (; *stem != '\0' && *stem != '.' && n < sizeof plain - 1; stem++)
    plain[n++] = isalnum((unsigned char)*stem) ? (char)tolower((unsigned char)*stem) : '_';
  plain[n] = '\0';
  bool taken = um_effects_registry_find(d->forward->model->registry, plain) != NULL;
  snprintf(out, UM_DIAGNOSIS_DRAFT_NAME, "%s%s",
           taken || !isalpha((unsigned char)plain[0]) ? "draft_" : "", plain);
}

enum um_status um_diagnosis_report_draft_write(struct um_context *context,
                                               const struct um_diagnosis *d, const char *path,
                                               const char *command, const char *version)
{
  enum um_diagnosis_draft draft = um_diagnosis_report_draft_choose(d);
  char name[UM_DIAGNOSIS_DRAFT_NAME];
  struct um_core_whole_file whole;
  if (draft == UM_DRAFT_NONE)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: there is nothing to draft: neither heat nor a correction of light "
                        "explains more than its numbers cost",
                        path);
  um_diagnosis_report_draft_name(d, path, name);
  UM_TRY(um_core_whole_begin(context, path, &whole));
  um_diagnosis_report_draft_put(d, draft, name, command, version, whole.file);
  return um_core_whole_end(context, &whole, UM_OK);
}
