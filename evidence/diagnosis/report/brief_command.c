/* The command that a user of the program types next, by the verdict. */
#include <string.h>

#include "base/core/text.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "model/build/model.h"
#include "model/scenario/scenario.h"

/* Are the measurements those that the scenario lists? Then a command finds them by itself. */
static bool is_listed(const struct um_diagnosis *d)
{
  const struct um_scenario_measurements *from = d->forward->model->scenario->measurements;
  const struct um_compare_measurements *m = d->forward->measurements;
  if (from == NULL || from->sets.count != m->nfile || m->nfile == 0) return false;
  const struct um_scenario_set *set = from->sets.items;
  for (size_t i = 0; i < m->nfile; i++)
    if (strcmp(set[i].name, m->file[i].name) != 0) return false;
  return true;
}

static void put_files(FILE *file, const struct um_diagnosis *d)
{
  const struct um_compare_measurements *m = d->forward->measurements;
  for (size_t i = 0; i < m->nfile && !is_listed(d); i++) {
    fputc(' ', file);
    um_core_text_put_word(file, m->file[i].path);
  }
}

/* The winner of the largest group; NULL: there is none. */
static const char *group_leader(const struct um_diagnosis *d)
{
  const struct um_diagnosis_step *best = NULL;
  for (size_t i = 0; d->verdict == UM_VERDICT_NOT_IDENTIFIABLE && i < d->naddition; i++) {
    const struct um_diagnosis_step *step = um_diagnosis_step_of(d, &d->addition[i]);
    if (step == NULL || step->confidence != UM_CONFIDENCE_ONE_OF_GROUP) continue;
    if (best == NULL || step->delta_bic < best->delta_bic) best = step;
  }
  return best == NULL ? NULL : d->candidates->candidate[best->candidate].name;
}

/* " --out FOLDER-after": results go beside those of the diagnosis, not in their place. */
static void put_folder(FILE *file, const char *folder, const char *behind)
{
  char beside[4096];
  size_t n = strlen(folder);
  while (n > 1 && folder[n - 1] == '/') n--;
  snprintf(beside, sizeof beside, "%.*s-%s", (int)n, folder, behind);
  fputs(" --out ", file);
  um_core_text_put_word(file, beside);
  fputc('\n', file);
}

/* A word of a command line, quotes and all. */
static size_t word_length(const char *text)
{
  size_t n = 0;
  for (bool quoted = false; text[n] != '\0' && (quoted || text[n] != ' '); n++)
    quoted = quoted != (text[n] == '\'');
  return n;
}

/* The command as it was typed, but for its folder: another comes behind. */
static void put_but_folder(FILE *file, const char *command)
{
  char word[4096];
  bool folder = false;
  for (const char *from = command; *from != '\0'; from += *from == ' ') {
    size_t n = word_length(from);
    snprintf(word, sizeof word, "%.*s", (int)n, from);
    bool option = strcmp(word, "--out") == 0 || strcmp(word, "-o") == 0;
    bool skipped = folder || strncmp(word, "--out=", 6) == 0;
    if (!option && !skipped && from != command) fputc(' ', file);
    if (!option && !skipped) um_core_text_put(file, word);
    folder = option;
    from += n;
  }
}

/* Is what explains all in no catalogue, and not written as an effect yet? */
static bool wants_draft(const struct um_diagnosis *d)
{
  bool heat = d->unexplained != NULL && d->unexplained->found;
  bool asked = d->light_asked.any || d->heat_asked != NULL;
  return d->verdict == UM_VERDICT_UNEXPLAINED && !d->chosen && !asked && (heat || d->light.found);
}

void um_diagnosis_report_put_command(FILE *file, const struct um_diagnosis *diagnosis,
                                     const char *command, const char *folder)
{
  const struct um_diagnosis *d = diagnosis;
  const char *leader = command != NULL ? group_leader(d) : NULL;
  if (leader != NULL) { /* what its user knows beside */
    fprintf(file, "Where you know that it is not %s, type: ", leader);
    put_but_folder(file, command);
    fputs(" --exclude ", file);
    um_core_text_put_word(file, leader);
    put_folder(file, folder, "without");
    return;
  }
  if (command != NULL && wants_draft(d)) {
    fputs("To have it as an effect of your own, type: ", file);
    put_but_folder(file, command);
    fputs(" --draft-effect mine.c", file);
    put_folder(file, folder, "draft");
    return;
  }
  static const struct {
    const char *says, *verb, *folder;
  } nexts[] = {{"To see what these measurements could have shown", "sensitivity", "sensitivity"},
               {"To look through the whole catalogue", "diagnose", "whole"},
               {"To see that it is gone", "compare", "after"},
               {"To see where it is off", "compare", "after"}};
  int n = 3;
  if (d->verdict == UM_VERDICT_COMPLETE && d->forward->measurements->nfile == 1) n = 0;
  if (d->verdict == UM_VERDICT_UNEXPLAINED && d->chosen) n = 1;
  if (d->verdict == UM_VERDICT_FOUND) n = 2;
  char improved[4096];
  snprintf(improved, sizeof improved, "%s/improved", folder);
  fprintf(file, "%s, type: umbra %s ", nexts[n].says, nexts[n].verb);
  um_core_text_put_word(file, improved);
  if (n == 0) fputs(" --data", file);
  put_files(file, d);
  const struct um_model_options *o = &d->forward->options;
  if (o->neffect_file > 0 || o->allow_effects) /* the improved scenario names them */
    fputs(" --allow-effects", file);
  put_folder(file, folder, nexts[n].folder);
}
