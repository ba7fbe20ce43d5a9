/* Stretches of a curve by the parameter that rules them, and the sentence that says so. */
#include "study/rule.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/plot/plot.h"

#define SHORT  0.01 /* of the whole */
#define LISTED 3    /* stretches of a parameter that a sentence lists */

static size_t ruler(const struct um_study_result *r, const struct um_study_statistics *l,
                    size_t value, double quiet)
{
  size_t best = UM_STUDY_RULED_BY_WITHHELD;
  if (!(l->deviation[value] > quiet)) return UM_STUDY_RULED_BY_NONE;
  for (size_t i = 0; i < r->nparameter; i++) {
    double share = l->first[i * r->nvalue + value];
    if (!isfinite(share)) continue;
    if (best == UM_STUDY_RULED_BY_WITHHELD || share > l->first[best * r->nvalue + value]) best = i;
  }
  return best;
}

static double edge(const struct um_study_result *r, size_t k)
{
  if (k == 0) return r->time[0];
  return k == r->ntime ? r->time[k - 1] : 0.5 * (r->time[k - 1] + r->time[k]);
}

/* Join short stretches and neighbours of one parameter; shares weighed by length. */
static size_t join(struct um_study_stretch *s, size_t n, double shortest)
{
  size_t m = 0;
  for (size_t i = 0; i < n; i++) {
    if (m > 0 && (s[i].to - s[i].from < shortest || s[m - 1].parameter == s[i].parameter)) {
      double a = s[m - 1].to - s[m - 1].from, b = s[i].to - s[i].from;
      if (s[m - 1].parameter == s[i].parameter && a + b > 0.0)
        s[m - 1].share = (s[m - 1].share * a + s[i].share * b) / (a + b);
      s[m - 1].to = s[i].to;
      continue;
    }
    s[m++] = s[i];
  }
  return m;
}

enum um_status um_study_stretches(struct um_context *context, const struct um_study_result *result,
                                  const struct um_study_statistics *statistics,
                                  const struct um_study_quantity *quantity,
                                  struct um_study_stretch **out, size_t *n)
{
  const struct um_study_result *r = result;
  double quiet = um_study_quiet(statistics, quantity);
  *n = 0;
  UM_TRY(um_core_allocate(context, quantity->count, sizeof **out, out));
  for (size_t k = 0; k < quantity->count; k++) {
    size_t value = quantity->first + k, by = ruler(r, statistics, value, quiet);
    double share = by >= r->nparameter ? 0.0 : statistics->first[by * r->nvalue + value];
    (*out)[(*n)++] = (struct um_study_stretch){
        .from = edge(r, k), .to = edge(r, k + 1), .parameter = by, .share = share};
  }
  *n = join(*out, *n, 0.0);
  *n = join(*out, *n, SHORT * (r->time[r->ntime - 1] - r->time[0]));
  *n = join(*out, *n, 0.0);
  return UM_OK;
}

/* Text that grows. */
struct text {
  char *at;
  size_t used;
  enum um_status status;
};
UM_PRINTF(3, 4) static void say(struct um_context *context, struct text *t, const char *format, ...)
{
  char more[400];
  va_list arguments;
  if (t->status != UM_OK) return;
  va_start(arguments, format);
  int n = vsnprintf(more, sizeof more, format, arguments);
  va_end(arguments);
  size_t length = n < 0 ? 0 : (size_t)n < sizeof more ? (size_t)n : sizeof more - 1;
  t->status = um_core_reallocate(context, t->used + length + 1, 1, &t->at);
  if (t->status != UM_OK) return;
  memcpy(t->at + t->used, more, length);
  t->used += length;
  t->at[t->used] = '\0';
}

/* "a causes 80 % of the variance in 3.1 of 10 minutes (0 to 2, 5 to 6.1)" of one parameter, of
 * none, or of what is withheld. */
static void say_stretches(struct um_context *context, const struct um_study_result *r,
                          const struct um_study_stretch *s, size_t n, size_t parameter,
                          struct text *t)
{
  struct um_plot_time axis = um_plot_time(r->time[0], r->time[r->ntime - 1], "");
  double length = 0.0, share = 0.0, whole = (r->time[r->ntime - 1] - r->time[0]) / axis.unit;
  size_t count = 0, listed = 0;
  bool none = parameter >= r->nparameter, quiet = parameter == UM_STUDY_RULED_BY_NONE;
  for (size_t i = 0; i < n; i++) {
    if (s[i].parameter != parameter) continue;
    double here = (s[i].to - s[i].from) / axis.unit;
    length += here;
    share += here * s[i].share;
    count++;
  }
  if (count == 0) return;
  const char *comma = t->used > 0 ? "; " : "";
  if (!none)
    say(context, t, "%s%s causes %.0f %% of the variance", comma, r->parameter_name[parameter],
        length > 0.0 ? 100.0 * share / length : 0.0);
  else
    say(context, t, "%s%s", comma,
        quiet ? "nothing varies it" : "shares of parameters are withheld");
  if (length > (1.0 - SHORT) * whole) {
    say(context, t, " at every instant");
  } else {
    say(context, t, " in %.3g of %.3g %s", length, whole, axis.word);
    for (size_t i = 0; i < n && listed < LISTED; i++) {
      if (s[i].parameter != parameter) continue;
      say(context, t, "%s%.3g to %.3g", listed++ == 0 ? " (" : ", ",
          um_plot_time_at(&axis, s[i].from), um_plot_time_at(&axis, s[i].to));
    }
    say(context, t, count > listed ? ", and %zu more)" : ")", count - listed);
  }
}

static void say_value(struct um_context *context, const struct um_study_result *r,
                      const struct um_study_statistics *l, size_t value, struct text *t)
{
  bool any = false;
  for (size_t i = 0; i < r->nparameter; i++) {
    double share = l->first[i * r->nvalue + value], rank = l->correlation[i * r->nvalue + value];
    if (isfinite(share))
      say(context, t, "%s%s %.0f %%", i > 0 ? ", " : "", r->parameter_name[i], 100.0 * share);
    else if (isfinite(rank))
      say(context, t, "%s%s %+.2f", i > 0 ? ", " : "rank correlations with ", r->parameter_name[i],
          rank);
    any = any || isfinite(share);
  }
  if (any) say(context, t, " of its variance");
}

enum um_status um_study_sentence(struct um_context *context, const struct um_study_result *result,
                                 const struct um_study_statistics *statistics,
                                 const struct um_study_quantity *quantity, char **out)
{
  struct um_study_stretch *s = NULL;
  size_t n = 0;
  struct text t = {.status = UM_OK}, all = {.status = UM_OK};
  *out = NULL;
  bool curve = quantity->count == result->ntime && result->ntime > 1;
  if (statistics->first == NULL) {
    say(context, &t, "%s", um_study_indices_words(statistics->indices));
  } else if (!curve) {
    say_value(context, result, statistics, quantity->first, &t);
  } else {
    t.status = um_study_stretches(context, result, statistics, quantity, &s, &n);
    for (size_t i = 0; i < result->nparameter; i++) say_stretches(context, result, s, n, i, &t);
    say_stretches(context, result, s, n, UM_STUDY_RULED_BY_WITHHELD, &t);
    say_stretches(context, result, s, n, UM_STUDY_RULED_BY_NONE, &t);
  }
  um_core_free(context, s);
  all.status = t.status;
  say(context, &all, "%s: ", quantity->name);
  for (size_t at = 0; t.at != NULL && at < t.used; at += 300) /* within the room of one piece */
    say(context, &all, "%.300s", t.at + at);
  say(context, &all, ".");
  um_core_free(context, t.at);
  if (all.status != UM_OK) um_core_free(context, all.at);
  if (all.status == UM_OK) *out = all.at;
  return all.status;
}
