/* Exchange areas by rays.
 *
 * Ray i of surface s leaves a point of its facet in a direction of cosine distribution and stands
 * for the area A_s / n_s. a_pq, the areas of rays from patch p that end on q, estimates S_pq; so
 * does a_qp. A line through both is drawn with the density d_p = n_p / A_p from one end and d_q
 * from the other, and counts of rare events add up, hence both together estimate
 *
 *   s_pq = (d_p a_pq + d_q a_qp) / (d_p + d_q).
 *
 * (view_factor_rays.c says where rays go.) */
#include "geometry/view_factors.h"

#include <math.h>
#include <string.h>

#include "base/core/sort.h"
#include "geometry/view_factor_rays_impl.h"
#include "geometry/view_factors_impl.h"

#define BATCH   ((size_t)1 << 17) /* rays whose ends are kept at a time */
#define BUNDLE  256               /* rays traced at a time, on the stack */
#define FEWEST  4                 /* rays of one surface */
#define SPACE   UINT32_MAX
#define ITSELF  (UINT32_MAX - 1) /* the inside of a closed part: it comes back */
#define NO_RAYS "view factors by %zu rays of each patch; accepted: 1 or more"

/* Entries in rows as they are found. */
struct rows {
  size_t *begin;   /* [npatch + 1] */
  uint32_t *other; /* [room] ascending in a row */
  double *area;    /* [room] [m^2] */
  size_t room;
};

struct trace {
  struct um_context *context;
  const struct um_geometry_mesh *mesh;
  const struct um_geometry_pose *pose;
  const struct um_geometry_visibility *visibility;
  const struct um_geometry_patches *patches;
  bool closed; /* nothing goes to space */
  struct um_geometry_ray_counts rays;
  size_t *first;     /* [nmember] place of its first ray among those of its batch */
  uint32_t *end;     /* [BATCH or more] patch, SPACE or ITSELF */
  double *sum;       /* [npatch] areas of the row being made [m^2] */
  uint32_t *touched; /* [npatch] patches of that row */
  size_t ntouched;
  struct rows rows;
  struct um_geometry_view_factors *out;
};

void um_geometry_view_factor_defaults(struct um_geometry_view_factor_options *options)
{
  *options = (struct um_geometry_view_factor_options){.rays = 4096, .cutoff = 1e-5};
}

/* Where a ray ends. */
static uint32_t end_of(const struct trace *t, const struct um_geometry_hit *hit)
{
  uint32_t out = t->closed ? ITSELF : SPACE;
  if (hit->facet == UM_GEOMETRY_NONE) return out;
  if (hit->surface == UM_GEOMETRY_NONE) return ITSELF;
  uint32_t patch = t->patches->patch[hit->surface];
  return patch == UM_GEOMETRY_NONE ? out : patch; /* grazed within the rounding of a plane */
}

/* Where the rays of member i end. */
static void trace_member(const struct trace *t, size_t i)
{
  uint32_t *end = t->end + t->first[i];
  size_t count = t->rays.count[i];
  struct um_geometry_ray ray[BUNDLE];
  struct um_geometry_hit hit[BUNDLE];
  for (size_t begin = 0; begin < count; begin += BUNDLE) {
    size_t n = count - begin < BUNDLE ? count - begin : BUNDLE;
    um_geometry_view_factor_rays(t->mesh, t->pose, t->patches, &t->rays, i, begin, n, ray);
    um_geometry_visibility_closest(t->visibility, ray, n, hit);
    for (size_t k = 0; k < n; k++) end[begin + k] = end_of(t, &hit[k]);
  }
}

static enum um_status count_rays(struct trace *t, size_t rays)
{
  size_t nmember = t->patches->begin[t->patches->npatch];
  UM_TRY(um_geometry_ray_counts_create(t->context, t->mesh, t->patches, rays, FEWEST, &t->rays));
  t->out->rays = t->rays.all;
  UM_TRY(um_core_allocate(t->context, nmember, sizeof *t->first, &t->first));
  return um_core_allocate(t->context, t->rays.most > BATCH ? t->rays.most : BATCH, sizeof *t->end,
                          &t->end);
}

static void add(struct trace *t, uint32_t patch, double area)
{
  if (t->sum[patch] == 0.0) t->touched[t->ntouched++] = patch;
  t->sum[patch] += area;
}

static int compare_index(const void *pa, const void *pb)
{
  uint32_t a = *(const uint32_t *)pa, b = *(const uint32_t *)pb;
  return (a > b) - (a < b);
}

/* The row of patch p is complete. */
static enum um_status row_end(struct trace *t, size_t p)
{
  struct rows *rows = &t->rows;
  size_t at = rows->begin[p];
  if (at + t->ntouched > rows->room) {
    size_t room = 2 * (at + t->ntouched) + 1024;
    UM_TRY(um_core_reallocate(t->context, room, sizeof *rows->other, &rows->other));
    UM_TRY(um_core_reallocate(t->context, room, sizeof *rows->area, &rows->area));
    rows->room = room;
  }
  UM_TRY(um_core_sort(t->context, t->touched, t->ntouched, sizeof *t->touched, compare_index));
  for (size_t k = 0; k < t->ntouched; k++, at++) {
    rows->other[at] = t->touched[k];
    rows->area[at] = t->sum[t->touched[k]];
    t->sum[t->touched[k]] = 0.0;
  }
  t->ntouched = 0;
  rows->begin[p + 1] = at;
  return UM_OK;
}

/* Ends of the rays of member i, which belongs to patch p, into its row. */
static void member_add(struct trace *t, size_t p, size_t i)
{
  double area = t->mesh->area[t->mesh->surface[t->patches->surface[i]].facet];
  double each = area / (double)t->rays.count[i];
  const uint32_t *end = t->end + t->first[i];
  for (size_t k = 0; k < t->rays.count[i]; k++) {
    if (end[k] == SPACE)
      t->out->space[p] += each;
    else
      add(t, end[k] == ITSELF ? (uint32_t)p : end[k], each);
  }
}

/* Members [from, to) are traced in parallel, every one on its own; then their rows are made. */
static enum um_status batch_run(struct trace *t, size_t from, size_t to, size_t *patch)
{
  long begin = (long)from, end = (long)to;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(t->context))
  for (long i = begin; i < end; i++)
    if (!um_core_stopped(t->context)) trace_member(t, (size_t)i);
  UM_TRY(um_core_stop_check(t->context, "view factors were traced"));
  for (size_t i = from; i < to; i++) {
    member_add(t, *patch, i);
    if (i + 1 == t->patches->begin[*patch + 1]) UM_TRY(row_end(t, (*patch)++));
  }
  return um_core_progress_step(t->context, to - from);
}

static enum um_status trace_rows(struct trace *t)
{
  size_t npatch = t->patches->npatch, nmember = t->patches->begin[npatch], patch = 0;
  UM_TRY(um_core_allocate(t->context, npatch + 1, sizeof *t->rows.begin, &t->rows.begin));
  UM_TRY(um_core_allocate(t->context, npatch, sizeof *t->sum, &t->sum));
  UM_TRY(um_core_allocate(t->context, npatch, sizeof *t->touched, &t->touched));
  for (size_t from = 0, to = 0; from < nmember; from = to) {
    size_t rays = 0;
    for (to = from; to < nmember && (to == from || rays + t->rays.count[to] <= BATCH); to++) {
      t->first[to] = rays;
      rays += t->rays.count[to];
    }
    UM_TRY(batch_run(t, from, to, &patch));
  }
  return UM_OK;
}

/* Rows turned into columns; their entries come in ascending order. */
static enum um_status transpose(struct um_context *context, size_t n, const struct rows *from,
                                struct rows *to)
{
  size_t nentry = from->begin[n];
  UM_TRY(um_core_allocate(context, n + 2, sizeof *to->begin, &to->begin));
  UM_TRY(um_core_allocate(context, nentry, sizeof *to->other, &to->other));
  UM_TRY(um_core_allocate(context, nentry, sizeof *to->area, &to->area));
  for (size_t e = 0; e < nentry; e++) to->begin[from->other[e] + 2]++;
  for (size_t q = 2; q <= n + 1; q++) to->begin[q] += to->begin[q - 1];
  for (size_t p = 0; p < n; p++)
    for (size_t e = from->begin[p]; e < from->begin[p + 1]; e++) {
      size_t at = to->begin[from->other[e] + 1]++;
      to->other[at] = (uint32_t)p;
      to->area[at] = from->area[e];
    }
  return UM_OK;
}

/* What both directions say together; rows a and their transpose b are merged. */
static enum um_status pool(struct trace *t, const struct rows *b, double cutoff)
{
  const struct rows *a = &t->rows;
  struct um_geometry_view_factors *f = t->out;
  const double *area = t->patches->area;
  size_t n = f->npatch;
  double *density = t->sum; /* [npatch], free now */
  size_t room = a->begin[n] + b->begin[n];
  UM_TRY(um_core_allocate(t->context, n + 1, sizeof *f->begin, &f->begin));
  UM_TRY(um_core_allocate(t->context, room, sizeof *f->other, &f->other));
  UM_TRY(um_core_allocate(t->context, room, sizeof *f->area, &f->area));
  for (size_t p = 0; p < n; p++) {
    density[p] = 0.0;
    for (size_t i = t->patches->begin[p]; i < t->patches->begin[p + 1]; i++)
      density[p] += (double)t->rays.count[i] / area[p];
  }
  size_t at = 0;
  for (size_t p = 0; p < n; p++) {
    double cut = 0.0;
    for (size_t i = a->begin[p], j = b->begin[p]; i < a->begin[p + 1] || j < b->begin[p + 1];) {
      uint32_t qa = i < a->begin[p + 1] ? a->other[i] : UINT32_MAX;
      uint32_t qb = j < b->begin[p + 1] ? b->other[j] : UINT32_MAX;
      uint32_t q = qa < qb ? qa : qb;
      double from = qa == q ? a->area[i++] : 0.0, back = qb == q ? b->area[j++] : 0.0;
      /* the smaller index first, so that both rows get the same number */
      double first = density[p] * from, second = density[q] * back;
      double s = (q < p ? second + first : first + second) / (density[p] + density[q]);
      if (s < cutoff * fmin(area[p], area[q])) {
        cut += s;
        continue;
      }
      f->other[at] = q;
      f->area[at++] = s;
    }
    f->cut = fmax(f->cut, cut / area[p]);
    f->begin[p + 1] = at;
  }
  return UM_OK;
}

static void rows_free(struct um_context *context, struct rows *rows)
{
  UM_FREE(context, rows->begin, rows->other, rows->area);
}

enum um_status um_geometry_view_factors_create(
    struct um_context *context, const struct um_geometry_mesh *mesh,
    const struct um_geometry_pose *pose, const struct um_geometry_visibility *visibility,
    const struct um_geometry_patches *patches,
    const struct um_geometry_view_factor_options *options, struct um_geometry_view_factors **out)
{
  enum um_status status;
  struct um_geometry_view_factors *factors = NULL;
  struct rows columns = {0};
  struct trace t = {.context = context,
                    .mesh = mesh,
                    .pose = pose,
                    .visibility = visibility,
                    .patches = patches,
                    .closed = options->closed};
  *out = NULL;
  if (options->rays < 1) return um_core_fail(context, UM_ERR_INPUT, NO_RAYS, options->rays);
  um_core_progress_begin(context, "view factors", patches->begin[patches->npatch]);
  UM_CHECK(um_core_allocate(context, 1, sizeof *factors, &factors));
  t.out = factors;
  factors->npatch = patches->npatch;
  UM_CHECK(um_core_allocate(context, patches->npatch, sizeof *factors->space, &factors->space));
  UM_CHECK(count_rays(&t, options->rays));
  UM_CHECK(trace_rows(&t));
  UM_CHECK(transpose(context, patches->npatch, &t.rows, &columns));
  UM_CHECK(pool(&t, &columns, options->cutoff));
  if (!options->open) UM_CHECK(um_geometry_view_factors_close(context, factors, patches->area));
  *out = factors;
  factors = NULL;
done:
  um_core_progress_end(context);
  rows_free(context, &t.rows);
  rows_free(context, &columns);
  um_geometry_ray_counts_clear(context, &t.rays);
  UM_FREE(context, t.first, t.end, t.sum, t.touched);
  um_geometry_view_factors_destroy(context, &factors);
  return status;
}

void um_geometry_view_factors_destroy(struct um_context *context,
                                      struct um_geometry_view_factors **factors)
{
  if (factors == NULL || *factors == NULL) return;
  UM_FREE(context, (*factors)->begin, (*factors)->other, (*factors)->area, (*factors)->space,
          *factors);
  *factors = NULL;
}

double um_geometry_view_factors_area(const struct um_geometry_view_factors *factors, size_t p,
                                     size_t q)
{
  for (size_t e = factors->begin[p]; e < factors->begin[p + 1]; e++)
    if (factors->other[e] == q) return factors->area[e];
  return 0.0;
}
