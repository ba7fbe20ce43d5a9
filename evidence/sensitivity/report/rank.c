/* Strongest rows of a matrix, of all its instants or of some. */
#include "evidence/sensitivity/report/rank.h"

#include <math.h>
#include <string.h>

#define LEAST 1e-6 /* of a curve's size, that counts */

size_t um_sensitivity_report_groups(const struct um_sensitivity_matrix *m)
{
  return m->nlight + (m->ncurve > m->nlight ? 1 : 0);
}

struct um_sensitivity_report_group
um_sensitivity_report_group(const struct um_sensitivity_matrix *m, size_t index)
{
  if (index < m->nlight)
    return (struct um_sensitivity_report_group){m->curve[index].name, index, index + 1};
  return (struct um_sensitivity_report_group){"temperature", m->nlight, m->ncurve};
}

struct um_sensitivity_report_leader
um_sensitivity_report_strongest(const struct um_sensitivity_matrix *m, size_t row,
                                const struct um_sensitivity_report_group *group, size_t from,
                                size_t to)
{
  const struct um_sensitivity_row *r = &m->row[row];
  struct um_sensitivity_report_leader out = {row, group->first, 0.0};
  for (size_t c = group->first; c < group->last; c++) {
    double share = um_sensitivity_matrix_strength(m, r, c, from, to, r->width);
    if (share > out.share) out = (struct um_sensitivity_report_leader){row, c, share};
  }
  return out;
}

double um_sensitivity_report_by_percent(const struct um_sensitivity_matrix *m,
                                        const struct um_sensitivity_report_leader *l)
{
  const struct um_sensitivity_row *row = &m->row[l->row];
  return l->share * 0.01 * fabs(row->log_scale) / row->width;
}

size_t um_sensitivity_report_leaders(const struct um_sensitivity_matrix *m,
                                     const struct um_sensitivity_report_group *group, size_t from,
                                     size_t to, bool behind, size_t most,
                                     struct um_sensitivity_report_leader *out)
{
  size_t n = 0;
  for (size_t i = 0; i < m->nrow; i++) {
    if (m->row[i].column == NULL || (m->row[i].quality.way == UM_SENSITIVITY_BY_BEHIND) != behind)
      continue;
    const struct um_sensitivity_report_leader l =
        um_sensitivity_report_strongest(m, i, group, from, to);
    size_t at = n;
    if (!(l.share >= LEAST)) continue;
    while (at > 0 && out[at - 1].share < l.share) at--;
    if (at == most) continue;
    if (n < most) n++;
    memmove(out + at + 1, out + at, (n - at - 1) * sizeof *out);
    out[at] = l;
  }
  return n;
}

size_t um_sensitivity_report_piece(const struct um_sensitivity_matrix *m, size_t from,
                                   double seconds)
{
  size_t to = from;
  while (to < m->ntime && m->time[to] < m->time[from] + seconds) to++;
  return to;
}
