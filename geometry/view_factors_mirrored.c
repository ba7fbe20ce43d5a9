/* Exchange areas with the paths by way of mirrors; equations in mirror_paths.h. */
#include "geometry/mirror_paths.h"

#include "geometry/view_factors_impl.h"

struct merge {
  const struct um_geometry_view_factors *direct;
  const struct um_geometry_mirror_paths *paths; /* NULL: none */
  const double *weight;                         /* [paths->sets.n] */
  const double *of_patch;                       /* [npatch] */
  struct um_geometry_view_factors *out;
};

/* Row p, or with out->other NULL only its end. */
static void merge_row(const struct merge *m, size_t p)
{
  const struct um_geometry_view_factors *f = m->direct;
  struct um_geometry_view_factors *out = m->out;
  size_t at = out->begin[p], i = f->begin[p], end = f->begin[p + 1];
  size_t j = m->paths != NULL ? m->paths->begin[p] : 0;
  size_t last = m->paths != NULL ? m->paths->begin[p + 1] : 0;
  while (i < end || j < last) {
    uint32_t a = i < end ? f->other[i] : UINT32_MAX;
    uint32_t b = j < last ? m->paths->path[j].to : UINT32_MAX, q = a < b ? a : b;
    double sum = a == q ? f->area[i++] : 0.0;
    for (; j < last && m->paths->path[j].to == q; j++)
      sum += m->weight[m->paths->path[j].sets] * m->paths->path[j].area;
    if (out->other != NULL) {
      out->other[at] = q;
      out->area[at] = sum * ((1.0 - m->of_patch[p]) * (1.0 - m->of_patch[q]));
    }
    at++;
  }
  out->begin[p + 1] = at;
  if (out->other == NULL) return;
  double space = f->space[p];
  for (size_t k = m->paths != NULL ? m->paths->sky_begin[p] : 0;
       m->paths != NULL && k < m->paths->sky_begin[p + 1]; k++)
    space += m->weight[m->paths->sky[k].sets] * m->paths->sky[k].area;
  out->space[p] = space * (1.0 - m->of_patch[p]);
}

enum um_status um_geometry_view_factors_mirrored(struct um_context *context,
                                                 const struct um_geometry_view_factors *factors,
                                                 const struct um_geometry_mirror_paths *paths,
                                                 const double *area, const double *reflectance,
                                                 const double *of_patch,
                                                 struct um_geometry_view_factors **out)
{
  enum um_status status;
  size_t n = factors->npatch, nset = paths != NULL ? paths->sets.n : 0;
  double *weight = NULL, *wanted = NULL;
  struct um_geometry_view_factors *own = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, nset, sizeof *weight, &weight));
  UM_CHECK(um_core_allocate(context, n, sizeof *wanted, &wanted));
  UM_CHECK(um_core_allocate(context, 1, sizeof *own, &own));
  for (size_t k = 0; k < nset; k++)
    weight[k] = um_geometry_mirror_set_weight(&paths->sets.set[k], reflectance);
  for (size_t p = 0; p < n; p++) wanted[p] = (1.0 - of_patch[p]) * area[p];
  own->npatch = n;
  own->rays = factors->rays;
  own->cut = factors->cut;
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *own->begin, &own->begin));
  UM_CHECK(um_core_allocate(context, n, sizeof *own->space, &own->space));
  const struct merge m = {factors, paths, weight, of_patch, own};
  for (size_t p = 0; p < n; p++) merge_row(&m, p);
  UM_CHECK(um_core_allocate(context, own->begin[n], sizeof *own->area, &own->area));
  UM_CHECK(um_core_allocate(context, own->begin[n], sizeof *own->other, &own->other));
  for (size_t p = 0; p < n; p++) merge_row(&m, p);
  UM_CHECK(um_geometry_view_factors_close(context, own, wanted));
  *out = own;
  own = NULL;
done:
  UM_FREE(context, weight, wanted);
  um_geometry_view_factors_destroy(context, &own);
  return status;
}
