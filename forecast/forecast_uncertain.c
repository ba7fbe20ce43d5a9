/* What is uncertain, from the texts of a user: parameters of effects and keys of the scenario, each
 * with its standard deviation. */
#include <math.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/digest.h"
#include "forecast/forecast_impl.h"

#define PLACE 1024 /* longest place of a key [byte] */

static enum um_status keep(struct um_context *context, struct um_forecast_unknowns *u, char *text)
{
  enum um_status status =
      um_core_reallocate(context, u->ntext + 1, sizeof *u->text, (void **)&u->text);
  if (status == UM_OK)
    u->text[u->ntext++] = text;
  else
    um_core_free(context, text);
  return status;
}

static enum um_status not_understood(struct um_context *context, const struct um_mark *at)
{
  return um_document_mark_fail(context, at,
                               "accepted: EFFECT[:TARGET],NAME=SIGMA, or EFFECT[:TARGET]=SIGMA of "
                               "an effect with one parameter, or KEY=SIGMA of a number that the "
                               "scenario states; SIGMA above 0, in the parameter's unit");
}

/* One more of parameters that were read so far. */
static enum um_status add(struct um_context *context, struct um_forecast_unknowns *u,
                          const struct um_study_file_parameter *parameter, const char *sigma)
{
  double value;
  if (u->n >= UM_FORECAST_UNCERTAIN_MOST)
    return um_document_mark_fail(context, &parameter->at, "more than %d; accepted: fewer",
                                 UM_FORECAST_UNCERTAIN_MOST);
  if (!um_core_number_parse(sigma, &value) || !isfinite(value) || !(value > 0.0))
    return um_document_mark_fail(context, &parameter->at,
                                 "sigma '%.60s'; accepted: a number above 0", sigma);
  UM_TRY(um_core_reallocate(context, u->n + 1, sizeof *u->parameter, &u->parameter));
  UM_TRY(um_core_reallocate(context, u->n + 1, sizeof *u->sigma, &u->sigma));
  u->parameter[u->n] = *parameter;
  u->sigma[u->n++] = value;
  return UM_OK;
}

/* "name=sigma[,name=sigma].." */
static enum um_status add_named(struct um_context *context, struct um_forecast_unknowns *u,
                                struct um_study_file_parameter *parameter, char *rest)
{
  while (rest != NULL) {
    char *next = strchr(rest, ','), *sigma = strchr(rest, '=');
    if (next != NULL) *next++ = '\0';
    if (sigma == NULL || (next != NULL && sigma >= next))
      return not_understood(context, &parameter->at);
    *sigma++ = '\0';
    parameter->parameter = rest;
    UM_TRY(add(context, u, parameter, sigma));
    rest = next;
  }
  return UM_OK;
}

/* A text, cut in place: names of effects have no dot, keys do. */
static enum um_status parse(struct um_context *context, struct um_forecast_unknowns *u,
                            const char *from, char *text)
{
  size_t head = strcspn(text, ":,="), end = strcspn(text, ",=");
  char behind = text[end];
  struct um_study_file_parameter p = {.at = {.file = from}, .property = -1};
  p.from = p.to = p.mean = p.sigma = p.median = p.mode = NAN;
  if (memchr(text, '.', head) != NULL) {
    char *sigma = strrchr(text, '=');
    if (sigma == NULL) return not_understood(context, &p.at);
    *sigma++ = '\0';
    p.key = text;
    return add(context, u, &p, sigma);
  }
  if (behind == '\0' || head == 0) return not_understood(context, &p.at);
  text[end] = '\0';
  if (head < end) {
    text[head] = '\0';
    p.target = text + head + 1;
  }
  p.effect = text;
  if (behind == ',') return add_named(context, u, &p, text + end + 1);
  return add(context, u, &p, text + end + 1);
}

static enum um_status take(struct um_context *context, struct um_forecast_unknowns *u,
                           const char *typed)
{
  char *from, *text;
  UM_TRY(um_core_asprintf(context, &from, "--uncertain %s", typed));
  UM_TRY(keep(context, u, from));
  UM_TRY(um_core_strdup(context, typed, &text));
  UM_TRY(keep(context, u, text));
  return parse(context, u, from, text);
}

/* Is the key one that passes have of their own: times, the station, what is pinned? */
static enum um_status is_of_passes(struct um_context *context, const struct um_forecast_work *work,
                                   const char *key, bool *out)
{
  char place[PLACE], other[PLACE];
  struct um_forecast_changes changes;
  enum um_status status = um_forecast_changes(context, work, 0, 0.0, 0.0, NAN, &changes);
  um_document_place(work->model->document, key, place, sizeof place);
  *out = strncmp(place, ".time.", 6) == 0;
  for (size_t i = 0; status == UM_OK && i < changes.all.nkey; i++) {
    um_document_place(work->model->document, changes.key[i].key, other, sizeof other);
    *out = *out || strcmp(place, other) == 0;
  }
  um_forecast_changes_clear(context, &changes);
  return status;
}

static enum um_status check_key(struct um_context *context, const struct um_forecast_work *work,
                                const struct um_study_binding *binding)
{
  bool of_passes;
  const struct um_study_file_parameter *p = binding->file;
  if (isnan(binding->nominal))
    return um_document_mark_fail(context, &p->at,
                                 "the scenario has no number there; accepted: a key with a number, "
                                 "or one that is given it by --set %s=VALUE",
                                 p->key);
  UM_TRY(is_of_passes(context, work, p->key, &of_passes));
  if (!of_passes) return UM_OK;
  return um_document_mark_fail(context, &p->at,
                               "every pass has its own; accepted: what all passes share");
}

static enum um_status bind(struct um_context *context, const struct um_forecast_work *work,
                           struct um_forecast_unknowns *u, size_t i)
{
  struct um_study_file_parameter *p = &u->parameter[i];
  struct um_study_binding *b = &u->binding[i];
  UM_TRY(um_study_binding_find(context, work->model, p, b));
  if (b->effect == NULL) return check_key(context, work, b);
  const struct um_effect_parameter *of = &b->effect->parameters[b->which];
  if (of->chosen)
    return um_document_mark_fail(context, &p->at, "'%s' is chosen, not measured; accepted: others",
                                 of->name);
  p->parameter = of->name;
  um_study_parameter_name(p, b->name);
  if (um_forecast_uncertain_step(u, i, 0) > 0.0 || um_forecast_uncertain_step(u, i, 1) > 0.0)
    return UM_OK;
  return um_document_mark_fail(context, &p->at, "%s is %g and has no room: %g to %g %s", of->name,
                               b->nominal, of->minimum, of->maximum, of->unit);
}

enum um_status um_forecast_uncertain_read(struct um_context *context,
                                          const struct um_forecast_work *work,
                                          const char *const *text, size_t n,
                                          struct um_forecast_unknowns *out)
{
  *out = (struct um_forecast_unknowns){.n = 0};
  for (size_t i = 0; i < n; i++) UM_TRY(take(context, out, text[i]));
  UM_TRY(um_core_allocate(context, out->n, sizeof *out->binding, &out->binding));
  for (size_t i = 0; i < out->n; i++) UM_TRY(bind(context, work, out, i));
  return um_study_bindings_check(context, work->model, out->binding, out->n);
}

void um_forecast_uncertain_clear(struct um_context *context, struct um_forecast_unknowns *u)
{
  for (size_t i = 0; i < u->ntext; i++) um_core_free(context, u->text[i]);
  UM_FREE(context, u->text, u->parameter, u->binding, u->sigma);
  *u = (struct um_forecast_unknowns){.n = 0};
}

uint64_t um_forecast_uncertain_digest(const struct um_forecast_unknowns *u)
{
  uint64_t digest = UM_CORE_DIGEST_BEGIN;
  for (size_t i = 0; i < u->n; i++) {
    const char *name = u->binding[i].name;
    digest = um_core_digest_texts(digest, &name, 1);
    digest = um_core_digest(digest, &u->sigma[i], sizeof u->sigma[i]);
  }
  return digest;
}

double um_forecast_uncertain_step(const struct um_forecast_unknowns *u, size_t which, int side)
{
  const struct um_study_binding *b = &u->binding[which];
  double sigma = u->sigma[which], room[2] = {sigma, sigma};
  if (b->effect != NULL) {
    const struct um_effect_parameter *of = &b->effect->parameters[b->which];
    room[0] = fmin(sigma, b->nominal - of->minimum);
    room[1] = fmin(sigma, of->maximum - b->nominal);
  }
  /* a side that is cut short is no better than the other one */
  return room[side] == sigma || room[side] > room[1 - side] ? fmax(room[side], 0.0) : 0.0;
}
