/* Total exchange areas eps B eps in rows, without what is small for both patches: that is taken to
 * come back to where it left, which keeps sums of rows and symmetry, and is nothing in a room of
 * one temperature.
 *
 * Rows are made a batch at a time, each as a column of B, and keep what is large for their own
 * patch; what is so for the other alone is in that one's row, and added at the end. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"

/* Of what a patch emits, in small exchange areas: below 10 mK at 300 K [1]; and in Newton's matrix,
 * whose iteration converges by so much a round. */
#define LEFT_OUT        1e-4
#define LEFT_OUT_STRONG 0.03
#define BATCH           16 /* blocks of TOGETHER rows */
#define TOGETHER        UM_THERMAL_TOGETHER

/* What is large for the patch of a row, of those in hand. */
struct own {
  double left_out;
  size_t *begin;   /* [n + 1] */
  uint32_t *other; /* [room] */
  double *area;    /* [room] [m^2] */
  double *rest;    /* [n] what is left out [m^2] */
  size_t room;
};

struct keeper {
  const struct um_thermal_exchange_maker *m;
  double *scratch; /* [thread][each] */
  size_t each;
  double *row; /* [BATCH TOGETHER][n] exchange areas of the batch [m^2] */
};

/* Rows first .. of B in hand as its columns, times emittances. */
static bool make_block(const struct keeper *k, size_t first, double *scratch, double *row)
{
  const struct um_thermal_exchange_maker *m = k->m;
  size_t n = m->n, count = n - first < TOGETHER ? n - first : TOGETHER;
  double *unit = scratch, *column = unit + n * TOGETHER;
  memset(unit, 0, n * TOGETHER * sizeof *unit);
  for (size_t i = 0; i < count; i++) unit[(first + i) * TOGETHER + i] = 1.0;
  if (!um_thermal_reflections_apply(m->reflections, unit, column + n * TOGETHER, column))
    return false;
  for (size_t i = 0; i < count; i++)
    for (size_t q = 0; q < n; q++)
      row[i * n + q] = column[q * TOGETHER + i] * (m->absorbed[first + i] * m->absorbed[q]);
  return true;
}

/* Exchange areas of patch p, row[n], below which all together are left_out of its emission [m^2]:
 * the largest of a few. */
static double small_of(const struct um_thermal_exchange_maker *m, double left_out, size_t p,
                       const double *row)
{
  double emitted = m->emittance[m->first + p] * m->out->area[m->first + p], limit = 0.1 * emitted;
  while (limit > 1e-12 * emitted) {
    double sum = 0.0;
    for (size_t q = 0; q < m->n; q++)
      if (q != p && row[q] < limit) sum += row[q];
    if (sum <= left_out * emitted) return limit;
    limit *= 0.25;
  }
  return 0.0;
}

/* Row p behind those that are there. */
static enum um_status own_add(const struct um_thermal_exchange_maker *m, size_t p,
                              const double *row, struct own *own)
{
  double small = small_of(m, own->left_out, p, row);
  size_t at = own->begin[p];
  if (at + m->n > own->room) {
    own->room = 2 * own->room + m->n;
    UM_TRY(um_core_reallocate(m->context, own->room, sizeof *own->other, &own->other));
    UM_TRY(um_core_reallocate(m->context, own->room, sizeof *own->area, &own->area));
  }
  for (size_t q = 0; q < m->n; q++) {
    if (q != p && row[q] < small) {
      own->rest[p] += row[q];
      continue;
    }
    own->other[at] = (uint32_t)q;
    own->area[at++] = row[q];
  }
  own->begin[p + 1] = at;
  return UM_OK;
}

/* Whether own row p has q; asked with ascending q, `at` [n] moves along the rows. */
static bool has(const struct own *own, size_t p, size_t q, size_t *at)
{
  size_t end = own->begin[p + 1];
  while (at[p] < end && own->other[at[p]] < q) at[p]++;
  return at[p] < end && own->other[at[p]] == q;
}

/* What is large for the other patch alone, in rows: columns of `own` without what the row has. */
static enum um_status others_find(const struct um_thermal_exchange_maker *m, const struct own *own,
                                  struct um_thermal_between *out)
{
  enum um_status status;
  size_t n = m->n, *at = NULL;
  UM_CHECK(um_core_allocate(m->context, n, sizeof *at, &at));
  UM_CHECK(um_core_allocate(m->context, n + 2, sizeof *out->begin, &out->begin));
  for (int pass = 0; pass < 2; pass++) {
    memcpy(at, own->begin, n * sizeof *at);
    for (size_t q = 0; q < n; q++)
      for (size_t e = own->begin[q]; e < own->begin[q + 1]; e++) {
        size_t p = own->other[e];
        if (has(own, p, q, at)) continue;
        if (pass == 0) {
          out->begin[p + 2]++;
          continue;
        }
        size_t to = out->begin[p + 1]++;
        out->other[to] = (uint32_t)q;
        out->area[to] = own->area[e];
      }
    if (pass == 1) break;
    for (size_t p = 2; p <= n + 1; p++) out->begin[p] += out->begin[p - 1];
    UM_CHECK(um_core_allocate(m->context, out->begin[n + 1], sizeof *out->other, &out->other));
    UM_CHECK(um_core_allocate(m->context, out->begin[n + 1], sizeof *out->area, &out->area));
  }
done:
  um_core_free(m->context, at);
  return status;
}

/* Of patches p and q, entry e of row p: the number of the lower patch's row. */
static double area_of(const struct own *own, size_t p, size_t e, size_t *at)
{
  size_t q = own->other[e];
  return q < p && has(own, q, p, at) ? own->area[at[q]] : own->area[e];
}

/* Both in one row, ascending. at [n]: as `has` moves it, of rows above p. */
static void merge_row(const struct um_thermal_exchange_maker *m, const struct own *own,
                      const struct um_thermal_between *others, size_t p, size_t *at,
                      struct um_thermal_between *out)
{
  size_t to = out->begin[m->first + p], diagonal = to;
  size_t i = own->begin[p], j = others->begin[p];
  double rest = own->rest[p];
  while (i < own->begin[p + 1] || j < others->begin[p + 1]) {
    uint32_t a = i < own->begin[p + 1] ? own->other[i] : UINT32_MAX;
    uint32_t b = j < others->begin[p + 1] ? others->other[j] : UINT32_MAX;
    uint32_t q = a < b ? a : b;
    if (q == p) diagonal = to;
    out->other[to] = (uint32_t)(m->first + q);
    if (a < b) {
      out->area[to++] = area_of(own, p, i++, at);
    } else {
      rest -= others->area[j];
      out->area[to++] = others->area[j++];
    }
  }
  out->area[diagonal] += fmax(rest, 0.0);
  out->begin[m->first + p + 1] = to;
}

static enum um_status merge(const struct um_thermal_exchange_maker *m, const struct own *own,
                            struct um_thermal_between *out)
{
  enum um_status status;
  struct um_thermal_between others = {0};
  size_t n = m->n, *at = NULL;
  UM_CHECK(um_core_allocate(m->context, n, sizeof *at, &at));
  UM_CHECK(others_find(m, own, &others));
  if (out->begin == NULL) /* rows of a room's first patch begin where nothing is */
    UM_CHECK(um_core_allocate(m->context, m->out->npatch + 1, sizeof *out->begin, &out->begin));
  size_t nentry = out->begin[m->first] + own->begin[n] + others.begin[n];
  UM_CHECK(um_core_reallocate(m->context, nentry, sizeof *out->area, &out->area));
  UM_CHECK(um_core_reallocate(m->context, nentry, sizeof *out->other, &out->other));
  memcpy(at, own->begin, n * sizeof *at);
  for (size_t p = 0; p < n; p++) merge_row(m, own, &others, p, at, out);
done:
  um_core_free(m->context, at);
  um_thermal_between_clear(m->context, &others, 1);
  return status;
}

/* Rows [first, last) of B in hand. */
static enum um_status batch_run(const struct keeper *k, size_t first, size_t last)
{
  struct um_context *context = k->m->context;
  bool ends = true;
  long nblock = (long)((last - first + TOGETHER - 1) / TOGETHER);
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))        \
    reduction(&& : ends)
  for (long b = 0; b < nblock; b++) {
    size_t at = (size_t)b * TOGETHER;
    if (um_core_stopped(context)) continue;
    ends = make_block(k, first + at, k->scratch + (size_t)omp_get_thread_num() * k->each,
                      k->row + at * k->m->n) &&
           ends;
  }
  UM_TRY(um_core_stop_check(context, "reflections were added up"));
  return ends ? UM_OK : um_thermal_reflections_fail(context);
}

enum um_status um_thermal_exchange_keep(struct um_thermal_exchange_maker *m,
                                        struct um_thermal_between *between,
                                        struct um_thermal_between *strong)
{
  enum um_status status;
  struct um_context *context = m->context;
  struct keeper k = {.m = m};
  struct own own[2] = {{.left_out = LEFT_OUT}, {.left_out = LEFT_OUT_STRONG}};
  size_t n = m->n, batch = BATCH * TOGETHER;
  k.each = 2 * TOGETHER * n + um_thermal_reflections_scratch(m->reflections);
  UM_CHECK(um_core_allocate(context, k.each * (size_t)um_core_context_threads(context),
                            sizeof *k.scratch, &k.scratch));
  UM_CHECK(um_core_allocate(context, batch * n, sizeof *k.row, &k.row));
  for (int i = 0; i < 2; i++) {
    UM_CHECK(um_core_allocate(context, n + 1, sizeof *own[i].begin, &own[i].begin));
    UM_CHECK(um_core_allocate(context, n, sizeof *own[i].rest, &own[i].rest));
  }
  for (size_t first = 0; first < n; first += batch) {
    size_t last = first + batch < n ? first + batch : n;
    UM_CHECK(batch_run(&k, first, last));
    for (size_t p = first; p < last; p++)
      for (int i = 0; i < 2; i++) UM_CHECK(own_add(m, p, k.row + (p - first) * n, &own[i]));
  }
  UM_CHECK(merge(m, &own[0], between));
  UM_CHECK(merge(m, &own[1], strong));
done:
  for (int i = 0; i < 2; i++)
    UM_FREE(context, own[i].begin, own[i].other, own[i].area, own[i].rest);
  UM_FREE(context, k.scratch, k.row);
  return status;
}
