/* Reading study.yaml, and what can be said of it without the scenario. */
#include "study/file.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/uncertainty/surrogate.h"

/* --- a parameter ---------------------------------------------------------------------------- */

void um_study_parameter_name(const struct um_study_file_parameter *p, char out[UM_STUDY_NAME])
{
  if (p->name != NULL)
    snprintf(out, UM_STUDY_NAME, "%.190s", p->name);
  else if (p->key != NULL)
    snprintf(out, UM_STUDY_NAME, "%.190s", p->key);
  else if (p->material != NULL)
    snprintf(out, UM_STUDY_NAME, "%.120s.%s", p->material,
             p->property == UM_STUDY_ABSORPTANCE ? "absorptance" : "emittance");
  else
    snprintf(out, UM_STUDY_NAME, "%.60s%s%.60s%s%.60s", p->effect, p->target != NULL ? ":" : "",
             p->target != NULL ? p->target : "", p->parameter != NULL ? "." : "",
             p->parameter != NULL ? p->parameter : "");
}

struct um_uncertainty_distribution um_study_distribution(const struct um_study_file_parameter *p)
{
  static const enum um_uncertainty_kind kind[] = {
      UM_UNCERTAINTY_UNIFORM, UM_UNCERTAINTY_NORMAL, UM_UNCERTAINTY_LOG_UNIFORM,
      UM_UNCERTAINTY_LOG_NORMAL, UM_UNCERTAINTY_TRIANGULAR};
  bool open = p->spread == UM_STUDY_NORMAL || p->spread == UM_STUDY_LOG_NORMAL;
  struct um_uncertainty_distribution d = {.kind = kind[p->spread],
                                          .from = open && isnan(p->from) ? -INFINITY : p->from,
                                          .to = open && isnan(p->to) ? INFINITY : p->to,
                                          .mean = p->mean,
                                          .sigma = p->sigma,
                                          .median = p->median,
                                          .mode = p->mode,
                                          .value = p->values.items,
                                          .nvalue = p->values.count};
  if (p->values.count > 0) d.kind = UM_UNCERTAINTY_LIST;
  return d;
}

/* --- number of points ------------------------------------------------------------------------ */

static double levels_of(const struct um_study_file *file, const struct um_study_file_parameter *p)
{
  if (p->values.count > 0) return (double)p->values.count;
  return p->levels != INT_MIN ? p->levels : file->design->levels;
}

double um_study_file_points(const struct um_study_file *file)
{
  const struct um_study_file_parameter *p = file->parameters.items;
  size_t d = file->parameters.count;
  double points = file->design->points, product = 1.0, sum = 1.0;
  for (size_t i = 0; i < d; i++) {
    product = fmin(product * levels_of(file, &p[i]), 1e18);
    sum += levels_of(file, &p[i]);
  }
  switch ((enum um_study_design)file->design->kind) {
  case UM_STUDY_GRID:
    return product;
  case UM_STUDY_LIST:
    return d > 0 ? (double)p[0].values.count : 0.0;
  case UM_STUDY_ONE_AT_A_TIME:
    return sum;
  case UM_STUDY_SALTELLI:
    return points * (double)(d + 2);
  case UM_STUDY_MORRIS:
    return points * (double)(d + 1);
  case UM_STUDY_LATIN_HYPERCUBE:
  case UM_STUDY_SOBOL:
    break;
  }
  return points;
}

/* --- checks ---------------------------------------------------------------------------------- */

static enum um_status fail(struct um_context *context, const struct um_study_file_parameter *p,
                           const char *key, const char *what)
{
  return um_document_mark_fail(context, um_document_mark_key(&p->at, key), "%s", what);
}

/* What belongs to a material, or to an effect. */
static enum um_status check_words(struct um_context *context,
                                  const struct um_study_file_parameter *p)
{
  if (p->material != NULL && p->property < 0)
    return fail(context, p, "material",
                "a material has several; accepted: property: emittance or absorptance beside it");
  if (p->material == NULL && p->property >= 0)
    return fail(context, p, "property", "of no material; accepted: beside material");
  if (p->effect == NULL && p->target != NULL)
    return fail(context, p, "target", "of no effect; accepted: beside effect");
  if (p->effect == NULL && p->parameter != NULL)
    return fail(context, p, "parameter", "of no effect; accepted: beside effect");
  return UM_OK;
}

static enum um_status check_spread(struct um_context *context, const struct um_study_file *file,
                                   const struct um_study_file_parameter *p)
{
  bool list = p->values.count > 0, paired = file->design->kind == UM_STUDY_LIST;
  struct um_uncertainty_distribution d = um_study_distribution(p);
  if (list && (!isnan(p->from) || !isnan(p->to)))
    return fail(context, p, "values", "beside from or to; accepted: one of them");
  if (paired && !list)
    return fail(context, p, NULL, "design list pairs values; accepted: values for every parameter");
  if (list && file->mode == UM_STUDY_SURROGATE && !paired && file->design->kind != UM_STUDY_GRID)
    return fail(
        context, p, "values",
        "single values have nothing between them for a surrogate; accepted: from and to, or "
        "a design grid or list");
  if (list && p->values.count < 2 && !paired)
    return fail(context, p, "values", "one value has no width; accepted: two or more");
  if (list && paired && file->parameters.count > 0) {
    const struct um_study_file_parameter *first = file->parameters.items;
    if (first->values.count != p->values.count)
      return um_document_mark_fail(
          context, um_document_mark_key(&p->at, "values"),
          "%zu values beside %zu of the first parameter; accepted: as many", p->values.count,
          first->values.count);
  }
  char name[UM_STUDY_NAME];
  um_study_parameter_name(p, name);
  enum um_status status = um_uncertainty_distribution_check(context, name, &d);
  if (status == UM_ERR_INPUT)
    um_core_message_prefix(context, "%s:%d: %s", p->at.file, p->at.line, p->at.path);
  return status;
}

static enum um_status check_names(struct um_context *context, const struct um_study_file *file)
{
  const struct um_study_file_parameter *p = file->parameters.items;
  char a[UM_STUDY_NAME], b[UM_STUDY_NAME];
  for (size_t i = 0; i < file->parameters.count; i++)
    for (size_t j = 0; j < i; j++) {
      um_study_parameter_name(&p[i], a);
      um_study_parameter_name(&p[j], b);
      if (strcmp(a, b) == 0)
        return um_document_mark_fail(context, &p[i].at,
                                     "'%s' is already listed on line %d; accepted: once", a,
                                     p[j].at.line);
    }
  return UM_OK;
}

static enum um_status check(struct um_context *context, const struct um_study_file *file)
{
  const struct um_study_file_parameter *p = file->parameters.items;
  if (file->parameters.count == 0)
    return um_document_mark_fail(context, um_document_mark_key(&file->at, "parameters"),
                                 "none; accepted: 1 to %d", UM_STUDY_PARAMETERS_MAX);
  for (size_t i = 0; i < file->parameters.count; i++) {
    UM_TRY(check_words(context, &p[i]));
    UM_TRY(check_spread(context, file, &p[i]));
  }
  UM_TRY(check_names(context, file));
  int held_out = (1 + UM_UNCERTAINTY_STATING) * file->held_out;
  if (file->mode == UM_STUDY_SURROGATE && file->evaluations <= held_out)
    return um_document_mark_fail(context, um_document_mark_key(&file->at, "evaluations"),
                                 "%d, of which a surrogate holds out %d and twice as many to state "
                                 "its error; accepted: more "
                                 "than %d",
                                 file->evaluations, file->held_out, held_out);
  double points = um_study_file_points(file);
  if (points > UM_STUDY_POINTS_MAX)
    return um_document_mark_fail(context, &file->design->at,
                                 "%.3g points; accepted: at most %d in all", points,
                                 UM_STUDY_POINTS_MAX);
  if (file->design->kind == UM_STUDY_MORRIS && file->design->levels % 2 != 0)
    return um_document_mark_fail(context, um_document_mark_key(&file->design->at, "levels"),
                                 "%d; accepted: an even number for morris", file->design->levels);
  return UM_OK;
}

static enum um_status finish(struct um_context *context, enum um_status status, void *root,
                             struct um_document **document, struct um_study_file **out)
{
  if (status == UM_OK) status = check(context, root);
  if (status != UM_OK) um_document_destroy(document);
  *out = status == UM_OK ? root : NULL;
  return status;
}

enum um_status um_study_file_read(struct um_context *context, const char *path,
                                  struct um_document **document, struct um_study_file **out)
{
  void *root = NULL;
  enum um_status status =
      um_document_read(context, path, &um_study_schema, NULL, 0, document, &root);
  return finish(context, status, root, document, out);
}

enum um_status um_study_file_parse(struct um_context *context, const char *path, const char *text,
                                   struct um_document **document, struct um_study_file **out)
{
  void *root = NULL;
  enum um_status status =
      um_document_parse(context, path, text, &um_study_schema, NULL, 0, document, &root);
  return finish(context, status, root, document, out);
}
