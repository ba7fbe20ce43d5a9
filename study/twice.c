/* What is moved twice: of two parameters that move one number the last would win, and the results
 * would state values of the other that no point was computed with. */
#include <string.h>

#include "base/core/suggestions.h"
#include "study/parameter.h"

#define PLACE 1024 /* longest place of a key [byte] */

static enum um_status refuse(struct um_context *context, const struct um_study_binding *binding,
                             const struct um_study_binding *other)
{
  if (other->file->at.line == 0)
    return um_document_mark_fail(context, &binding->file->at,
                                 "moves what '%s' moves; accepted: one parameter for one number",
                                 other->name);
  return um_document_mark_fail(context, &binding->file->at,
                               "'%s' moves what '%s' of line %d moves; accepted: one parameter for "
                               "one number",
                               binding->name, other->name, other->file->at.line);
}

/* Is `part` the place `whole`, or within it? */
static bool lies_in(const char *part, const char *whole)
{
  size_t n = strlen(whole);
  return strncmp(part, whole, n) == 0 && (part[n] == '\0' || part[n] == '.');
}

static bool same_place(const struct um_model *model, const struct um_study_binding *a,
                       const struct um_study_binding *b)
{
  char of_a[PLACE], of_b[PLACE];
  if (a->effect != NULL || b->effect != NULL)
    return a->effect == b->effect && a->which == b->which &&
           um_core_words_same(a->target, b->target);
  um_document_place(model->document, a->file->key, of_a, sizeof of_a);
  um_document_place(model->document, b->file->key, of_b, sizeof of_b);
  return lies_in(of_a, of_b) || lies_in(of_b, of_a);
}

enum um_status um_study_bindings_check(struct um_context *context, const struct um_model *model,
                                       const struct um_study_binding *binding, size_t nbinding)
{
  for (size_t i = 0; i < nbinding; i++)
    for (size_t j = 0; j < i; j++)
      if (same_place(model, &binding[i], &binding[j]))
        return refuse(context, &binding[i], &binding[j]);
  return UM_OK;
}

enum um_status um_study_bindings_check_moved(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model *moved,
                                             const struct um_study_binding *binding,
                                             size_t nbinding, size_t at)
{
  if (binding[at].effect != NULL) return UM_OK; /* effects were held against each other by name */
  for (size_t j = 0; j < nbinding; j++)
    if (!um_study_binding_same(&binding[j], model, moved))
      return refuse(context, &binding[at], &binding[j]);
  return UM_OK;
}
