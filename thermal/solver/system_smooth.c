/* How far an integration may step at once over tabulated loads. Between rows the loads are linear,
 * and a step that is much longer than their spacing could pass over a flash of Sun unseen. Where
 * the table is finer than the loads need, it may: with Q_k the loads of all nodes at row k,
 *
 *   |Q_k - (Q_(k-m) and Q_(k+m), linear between)| <= UNSEEN max |Q|
 *
 * at every row k of the window and for m = 1, 2, 4, ... up to the answer. What shows for a single
 * row already fails at m = 1. */
#include <math.h>
#include <string.h>

#include "thermal/solver/system_group.h"

#define UNSEEN 0.01 /* of the largest load of any node */
#define MOST   16   /* rows that a step may count as one interval */
#define RING   (2 * MOST + 1)

struct scan {
  struct um_thermal_system *system;
  double *ring;    /* [RING][n] Q of the last rows */
  double largest;  /* |Q| so far [W] */
  double worst[5]; /* of m = 1, 2, 4, 8, 16 [W] */
};

static const double *row_of(const struct scan *s, size_t row)
{
  return s->ring + (row % RING) * s->system->n;
}

/* Row `last` is in: what it shows of the rows m before it. */
static void row_judge(struct scan *s, size_t low, size_t last)
{
  const double *grid = s->system->grid;
  for (size_t level = 0, m = 1; m <= MOST; level++, m *= 2) {
    if (last < low + 2 * m) return;
    double width = grid[last] - grid[last - 2 * m];
    double u = width > 0.0 ? (grid[last - m] - grid[last - 2 * m]) / width : 0.5;
    const double *a = row_of(s, last - 2 * m), *b = row_of(s, last - m), *c = row_of(s, last);
    double worst = s->worst[level];
    for (size_t i = 0; i < s->system->n; i++) {
      double bend = fabs(b[i] - (1.0 - u) * a[i] - u * c[i]);
      worst = bend > worst ? bend : worst;
    }
    s->worst[level] = worst;
  }
}

static void largest_see(struct scan *s, size_t row)
{
  um_thermal_system_loads_at(s->system, s->system->grid[row]);
  double largest = s->largest;
  for (size_t i = 0; i < s->system->n; i++) {
    double q = fabs(s->system->now.q[i]);
    largest = q > largest ? q : largest;
  }
  s->largest = largest;
}

/* Rows low to high; false as soon as not even m = 1 will hold: some rows are looked at first, and
 * those between are hardly ten times larger. */
static bool scan_rows(struct scan *s, size_t low, size_t high)
{
  struct um_thermal_system *system = s->system;
  for (size_t row = low; row <= high; row += MOST) largest_see(s, row);
  for (size_t row = low; row <= high; row++) {
    largest_see(s, row);
    memcpy(s->ring + (row % RING) * system->n, system->now.q, system->n * sizeof(double));
    row_judge(s, low, row);
    if (s->worst[0] > 10.0 * UNSEEN * s->largest) return false;
  }
  return s->worst[0] <= UNSEEN * s->largest;
}

/* Rows that count as one interval; SIZE_MAX: the whole window does. */
static size_t rows_at_once(const struct scan *s, size_t low, size_t high)
{
  size_t rows = 1;
  for (size_t level = 0, m = 1; m <= MOST; level++, m *= 2) {
    if (high - low < 2 * m) return SIZE_MAX;
    if (!(s->worst[level] <= UNSEEN * s->largest)) return rows;
    rows = m;
  }
  return rows;
}

enum um_status um_thermal_system_smooth(struct um_thermal_system *system, size_t *rows)
{
  size_t low = system->row_low, high = system->row_high;
  *rows = 1;
  if (system->loads == NULL || high - low < 2) return UM_OK;
  /* a later beginning within the same rows, after a switching */
  if (system->smooth_rows != 0 && system->smooth_high == high && system->smooth_low <= low) {
    *rows = system->smooth_rows;
    return UM_OK;
  }
  struct scan s = {.system = system};
  UM_TRY(um_core_allocate(system->context, RING, system->n * sizeof(double), &s.ring));
  if (scan_rows(&s, low, high)) *rows = rows_at_once(&s, low, high);
  um_core_free(system->context, s.ring);
  system->now.t = NAN;
  system->interval = low;
  system->smooth_low = low;
  system->smooth_high = high;
  system->smooth_rows = *rows;
  return UM_OK;
}
