/* Two sets of geometry tables, number for number. */
#ifndef UMBRA_TESTS_MODEL_TRACED_HELP_H
#define UMBRA_TESTS_MODEL_TRACED_HELP_H

#include <string.h>

#include "model/geometry/precompute.h"
#include "model/geometry/thermal_equal_group.h"

static bool same(const void *a, const void *b, size_t count, size_t size)
{
  if (a == NULL || b == NULL) return a == b;
  return memcmp(a, b, count * size) == 0;
}

static bool lit_equal(const struct um_optics_lit *a, const struct um_optics_lit *b, size_t nsurface)
{
  size_t n = a->nrow * nsurface;
  return a->nrow == b->nrow && same(a->share, b->share, n, sizeof(float)) &&
         same(a->cosine, b->cosine, n, sizeof(float)) &&
         same(a->cos_half, b->cos_half, n, sizeof(double));
}

static bool views_equal(const struct um_optics_view *a, const struct um_optics_view *b)
{
  size_t n = a->ntime * a->nsurface;
  return a->ntime == b->ntime && a->nsurface == b->nsurface && a->seed == b->seed &&
         same(a->nsample, b->nsample, a->ntime, sizeof(int)) &&
         same(a->seen, b->seen, n, sizeof(float)) &&
         same(a->cos_observer, b->cos_observer, n, sizeof(float)) &&
         same(a->cos_nadir, b->cos_nadir, n, sizeof(float)) &&
         same(a->area, b->area, a->nsurface, sizeof(double)) &&
         same(a->material, b->material, a->nsurface, sizeof(uint32_t)) &&
         lit_equal(&a->sun, &b->sun, a->nsurface) && lit_equal(&a->moon, &b->moon, a->nsurface);
}

static bool mirrored_equal(const struct um_irradiation_mirrored *a,
                           const struct um_irradiation_mirrored *b)
{
  if (a == NULL || b == NULL) return a == b;
  size_t n = a->ntime * UM_GEOMETRY_SKY_CELLS;
  return a->ntime == b->ntime && same(a->begin, b->begin, a->ntime + 1, sizeof *a->begin) &&
         same(a->sun, b->sun, a->begin[a->ntime], sizeof *a->sun) &&
         same(a->albedo, b->albedo, n, sizeof(float)) &&
         same(a->planet, b->planet, n, sizeof(float));
}

/* All that a run looks at, by brute force. */
static bool traced_equal(const struct um_model_tables *a, const struct um_model_tables *b)
{
  if (a->nobs != b->nobs || a->nsub != b->nsub) return false;
  size_t n = a->nobs * a->nsub, rows = a->loads->ntime * a->loads->nsurface;
  return same(a->t_obs, b->t_obs, a->nobs, sizeof(double)) &&
         same(a->sample, b->sample, n, sizeof *a->sample) &&
         same(a->look, b->look, n, sizeof *a->look) &&
         same(a->hidden, b->hidden, a->nobs, sizeof(bool)) && um_model_times_equal(a, b) &&
         a->t_periodic_end == b->t_periodic_end && um_model_loads_equal(a->loads, b->loads) &&
         same(a->loads->view_factor, b->loads->view_factor, rows, sizeof(float)) &&
         same(a->loads->brightness, b->loads->brightness, rows, sizeof(float)) &&
         um_model_view_factors_equal(a->view_factors, b->view_factors) &&
         um_model_loads_equal(a->seen, b->seen) &&
         um_model_loads_equal(a->spin_variation, b->spin_variation) &&
         mirrored_equal(a->mirrored, b->mirrored) && views_equal(a->view, b->view);
}

#endif
