/* improved/scenario.yaml: the user's scenario as it was run, with what was found.
 *
 * The text is the user's own with its comments; --set, --with and --without stand in it, names of
 * files lead from the new folder, fitted nuisances and effects are entries of `effects`. */
#include "evidence/diagnosis/report/report_impl.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/core/file.h"
#include "base/core/suggestions.h"
#include "model/build/effect_files.h"
#include "model/build/scenario_text.h"

/* ---- the effects as they are at the end ---- */

/* The same effect on the same target is replaced. */
static void take(struct um_model_effect *use, size_t *count,
                 const struct um_model_addition *addition)
{
  size_t i = 0;
  while (i < *count && !(use[i].effect == addition->effect &&
                         um_core_words_same(use[i].target, addition->target)))
    i++;
  if (i == *count)
    use[(*count)++] =
        (struct um_model_effect){.effect = addition->effect, .target = addition->target};
  use[i].off = addition->off;
  use[i].option = "found";
  memcpy(use[i].value, addition->value, sizeof use[i].value);
}

/* Uses of the model, then nuisances and what was added in the order in which they acted; the caller
 * frees. */
static enum um_status collect(struct um_context *context, const struct um_diagnosis *d,
                              struct um_model_effect **out, size_t *count)
{
  const struct um_model *model = d->forward->model;
  *count = model->neffect;
  UM_TRY(um_core_allocate(context, *count + d->nnuisance + d->naddition, sizeof **out, out));
  if (*count > 0) memcpy(*out, model->effect, *count * sizeof **out);
  for (size_t i = 0; i < d->nnuisance; i++) take(*out, count, &d->nuisance[i]);
  for (size_t i = 0; i < d->naddition; i++) take(*out, count, &d->addition[i]);
  um_model_effects_sort(model, *out + model->neffect, *count - model->neffect);
  return UM_OK;
}

/* ---- the text ---- */

/* Text of a comment: one line. */
static void put_line(FILE *file, const char *text)
{
  for (; *text != '\0'; text++) fputc((unsigned char)*text < 0x20 ? ' ' : *text, file);
  fputc('\n', file);
}

static void put_head(FILE *file, const struct um_diagnosis *d, const char *command,
                     const char *version)
{
  fprintf(file, "# Written by umbra %s: ", version);
  put_line(file, command);
  fprintf(file, "# Verdict: %s. ", um_diagnosis_verdict_name(d->verdict));
  put_line(file, d->summary != NULL ? d->summary : "");
  fprintf(file, "# Reduced chi-square %.4g before, %.4g after.\n", d->chi2_reduced,
          d->chi2_reduced_after);
}

enum um_status um_diagnosis_report_improved_write(struct um_context *context,
                                                  const struct um_diagnosis *diagnosis,
                                                  const char *command, const char *version,
                                                  const char *path)
{
  char *folder = NULL, *name = NULL, *text = NULL;
  struct um_model_effect *use = NULL;
  size_t count;
  enum um_status status;
  UM_CHECK(um_core_asprintf(context, &folder, "%s/improved", path));
  UM_CHECK(um_core_asprintf(context, &name, "%s/scenario.yaml", folder));
  if (mkdir(folder, 0777) != 0)
    UM_CHECK(um_core_fail(context, UM_ERR_IO, "%s: %s", folder, strerror(errno)));
  UM_CHECK(collect(context, diagnosis, &use, &count));
  UM_CHECK(um_model_scenario_text(context, diagnosis->forward->model, use, count,
                                  &diagnosis->forward->options, folder, &text));
  FILE *file;
  UM_CHECK(um_core_file_create(context, name, &file));
  put_head(file, diagnosis, command, version);
  fputs(text, file);
  status = um_core_file_close(context, "improved/scenario.yaml", &file);
done:
  UM_FREE(context, folder, name, text, use);
  return status;
}
