/* What a result rests on: a sentence and BibTeX. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "library/result_impl.h"
#include "library/sources_impl.h"

#define NOTE 512 /* of an entry, longer ones are cut [bytes] */

/* Two texts that grow. */
struct text {
  struct um_context *context;
  char *sentence, *bibtex;
};

static enum um_status append(struct um_context *context, char **text, const char *more)
{
  size_t n = *text == NULL ? 0 : strlen(*text), m = strlen(more) + 1;
  UM_TRY(um_core_reallocate(context, n + m, 1, text));
  memcpy(*text + n, more, m);
  return UM_OK;
}

/* BibTeX takes braces and some signs for its own. */
static void escape(const char *from, char out[NOTE])
{
  size_t n = 0;
  for (; *from != '\0' && n < NOTE - 3; from++) {
    if (strchr("&%$#_", *from) != NULL) out[n++] = '\\';
    out[n++] = strchr("{}\\", *from) != NULL ? ' ' : *from;
  }
  out[n] = '\0';
}

/* A reference that stands as text: of a record or an effect. kind: "material". */
static enum um_status cite_note(struct text *t, const char *kind, const char *name,
                                const char *note)
{
  char clean[NOTE], label[NOTE], entry[3 * NOTE];
  escape(note, clean);
  escape(name, label);
  snprintf(entry, sizeof entry,
           "@misc{umbra:%s:%.100s,\n  title = {%s %s of Umbra},\n  note = {%s}\n}\n", kind, name,
           kind, label, clean);
  return append(t->context, &t->bibtex, entry);
}

static enum um_status cite_sources(struct text *t, const struct um_model *model)
{
  size_t used = 0, n = 0;
  for (size_t i = 0; um_library_source_at(i) != NULL; i++)
    used += um_library_source_at(i)->is_used(model);
  for (size_t i = 0; um_library_source_at(i) != NULL; i++) {
    const struct um_library_citation *s = um_library_source_at(i);
    if (!s->is_used(model)) continue;
    n++;
    UM_TRY(append(t->context, &t->sentence, n == 1 ? "" : n == used ? " and " : ", "));
    UM_TRY(append(t->context, &t->sentence, s->words));
    UM_TRY(append(t->context, &t->bibtex, s->bibtex));
  }
  return append(t->context, &t->sentence, ".");
}

static enum um_status cite_records(struct text *t, const struct um_model *model)
{
  for (size_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    const char *citation = um_materials_citation(model->material[m]);
    if (citation == NULL || citation[0] == '\0') continue;
    UM_TRY(cite_note(t, "material", um_materials_name(model->material[m]), citation));
  }
  const struct um_scenario_band *band = model->scenario->bands.items;
  for (size_t b = 0; b < model->scenario->bands.count; b++)
    if (band[b].filter != NULL)
      UM_TRY(cite_note(t, "filter", band[b].filter,
                       "its file of filters/ says whose figures they are"));
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    bool again = false;
    for (size_t k = 0; k < i; k++)
      again = again || (model->effect[k].effect == e->effect && !model->effect[k].off);
    if (e->off || again) continue;
    UM_TRY(cite_note(t, "effect", e->effect->name, e->effect->reference));
  }
  return UM_OK;
}

static enum um_status compose(struct text *t, const struct um_model *model)
{
  UM_TRY(append(t->context, &t->sentence,
                "Computed with Umbra " UM_LIBRARY_VERSION " from the scenario "));
  UM_TRY(append(t->context, &t->sentence, model->scenario->name));
  UM_TRY(append(t->context, &t->sentence, ", with "));
  UM_TRY(append(t->context, &t->bibtex,
                "@software{umbra,\n  title = {Umbra},\n  version = {" UM_LIBRARY_VERSION
                "},\n  license = {GPL-3.0-or-later}\n}\n"));
  UM_TRY(cite_sources(t, model));
  return cite_records(t, model);
}

enum umbra_status umbra_cite(struct umbra *umbra, struct umbra_result *result,
                             const struct umbra_citation **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct text t = {.context = context};
  *out = NULL;
  if (result->citation.sentence == NULL) {
    const struct um_model *model = result->kind->model(result->work);
    enum um_status status =
        model != NULL ? compose(&t, model)
                      : um_core_fail(context, UM_ERR_INPUT,
                                     "what a matrix says of other values; accepted: the matrix");
    if (status != UM_OK) {
      UM_FREE(context, t.sentence, t.bibtex);
      return um_library_status(status);
    }
    result->citation = (struct umbra_citation){t.sentence, t.bibtex};
  }
  *out = &result->citation;
  return UMBRA_OK;
}
