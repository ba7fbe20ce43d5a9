/* The linear answer beside the true one. */
#include "evidence/sensitivity/what_if.h"

#include <math.h>
#include <omp.h>
#include <stdint.h>
#include <string.h>

#include "base/core/suggestions.h"

#define LINEAR 0.01 /* of a curve's size, that may be left where the matrix is called good */

static bool is_of(const struct um_sensitivity_row *row, const struct um_model_addition *wanted)
{
  return row->candidate->effect == wanted->effect &&
         um_core_words_same(row->candidate->target, wanted->target);
}

static enum um_status refuse(struct um_context *context, const struct um_sensitivity_row *row,
                             double value)
{
  return um_core_fail(context, UM_ERR_INPUT, "what if %s is %g; accepted: from %g to %g %s",
                      row->name, value, row->minimum, row->maximum, row->unit);
}

/* Rows of the values that are given. */
static enum um_status find_rows(struct um_context *context, const struct um_sensitivity_matrix *m,
                                const struct um_model_addition *wanted,
                                struct um_sensitivity_what_if *w)
{
  bool any = false;
  for (size_t i = 0; i < m->nrow; i++) {
    const struct um_sensitivity_row *row = &m->row[i];
    if (!is_of(row, wanted)) continue;
    bool is_switch = row->parameter == SIZE_MAX;
    double value = is_switch ? 1.0 : wanted->value[row->parameter];
    any = true;
    if (isnan(value) || (is_switch && w->nrow > 0)) continue;
    if (!is_switch && !(value >= row->minimum && value <= row->maximum))
      return refuse(context, row, value);
    w->row[w->nrow] = i;
    w->to[w->nrow++] = value;
  }
  if (w->nrow > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "what if %s%s%s: %s", wanted->effect->name,
                      wanted->target != NULL ? ":" : "",
                      wanted->target != NULL ? wanted->target : "",
                      any ? "no value; accepted: NAME=VALUE of a parameter"
                          : "the matrix has no such row; accepted: an effect and target that it "
                            "has, by the name that it goes by");
}

/* Additions of the rows, one a candidate: its own null values, and what is given. Returns how many.
 */
static size_t additions_of(const struct um_sensitivity_matrix *m, const size_t *row,
                           const double *to, size_t n, struct um_model_addition *out)
{
  size_t count = 0;
  for (size_t i = 0; i < n; i++) {
    const struct um_sensitivity_row *r = &m->row[row[i]];
    const struct um_sensitivity_candidate *c = r->candidate;
    size_t at = 0;
    if (r->parameter == SIZE_MAX && !(to[i] > 0.5)) continue;
    while (at < count &&
           (out[at].effect != c->effect || !um_core_words_same(out[at].target, c->target)))
      at++;
    if (at == count) {
      out[count] = (struct um_model_addition){.effect = c->effect, .target = c->target};
      memcpy(out[count++].value, c->null_value, c->effect->nparameter * sizeof *out->value);
    }
    if (r->parameter != SIZE_MAX) out[at].value[r->parameter] = to[i];
  }
  return count;
}

enum um_status um_sensitivity_exact(struct um_context *context,
                                    const struct um_sensitivity_matrix *m, const size_t *row,
                                    const double *to, size_t n, double *out)
{
  enum um_status status;
  struct um_model_addition *addition = NULL;
  double *value = NULL;
  for (size_t i = 0; i < n; i++)
    if (!(to[i] >= m->row[row[i]].minimum && to[i] <= m->row[row[i]].maximum) &&
        m->row[row[i]].parameter != SIZE_MAX)
      return refuse(context, &m->row[row[i]], to[i]);
  UM_CHECK(um_core_allocate(context, n, sizeof *addition, &addition));
  UM_CHECK(um_core_allocate(context, m->list->nobservation, sizeof *value, &value));
  size_t count = additions_of(m, row, to, n, addition);
  UM_CHECK(um_sensitivity_forward_evaluate(context, m->forward, addition, count, value));
  um_sensitivity_matrix_spread(m, value, out);
done:
  UM_FREE(context, addition, value);
  return status;
}

static void hold_against(const struct um_sensitivity_matrix *m, struct um_sensitivity_what_if *w)
{
  double worst = 0.0;
  for (size_t c = 0; c < m->ncurve; c++) {
    double largest = 0.0, sum = 0.0;
    size_t n = 0;
    for (size_t k = 0; k < m->ntime; k++) {
      double d = w->linear[c * m->ntime + k] - w->exact[c * m->ntime + k];
      if (isnan(d) || !(m->curve[c].size > 0.0)) continue;
      d = fabs(d) / m->curve[c].size;
      largest = fmax(largest, d);
      sum += d * d;
      n++;
    }
    w->error[c].largest = largest;
    w->error[c].rms = n > 0 ? sqrt(sum / (double)n) : 0.0;
    worst = fmax(worst, largest);
  }
  w->within = worst > 0.0 ? sqrt(LINEAR / worst) : INFINITY;
}

enum um_status um_sensitivity_what_if_create(struct um_context *context,
                                             const struct um_sensitivity_matrix *m,
                                             const struct um_model_addition *wanted,
                                             struct um_sensitivity_what_if *w)
{
  enum um_status status;
  size_t n = m->ncurve * m->ntime;
  double begin;
  *w = (struct um_sensitivity_what_if){.nrow = 0};
  UM_CHECK(find_rows(context, m, wanted, w));
  UM_CHECK(um_core_allocate(context, n, sizeof *w->linear, &w->linear));
  UM_CHECK(um_core_allocate(context, n, sizeof *w->exact, &w->exact));
  UM_CHECK(um_core_allocate(context, m->ncurve, sizeof *w->error, &w->error));
  begin = omp_get_wtime();
  um_sensitivity_matrix_apply(m, w->row, w->to, w->nrow, w->linear);
  w->seconds = omp_get_wtime() - begin;
  begin = omp_get_wtime();
  UM_CHECK(um_sensitivity_exact(context, m, w->row, w->to, w->nrow, w->exact));
  w->seconds_exact = omp_get_wtime() - begin;
  hold_against(m, w);
done:
  return status;
}

void um_sensitivity_what_if_release(struct um_context *context, struct um_sensitivity_what_if *w)
{
  UM_FREE(context, w->linear, w->exact, w->error);
  *w = (struct um_sensitivity_what_if){.nrow = 0};
}
