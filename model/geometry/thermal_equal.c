/* What temperatures hang on beside the network, compared number for number. */
#include "model/geometry/thermal_equal_group.h"

#include <math.h>
#include <string.h>

static bool same(const void *a, const void *b, size_t count, size_t size)
{
  return a == b || count == 0 || memcmp(a, b, count * size) == 0;
}

static bool moments_equal(const struct um_irradiation_loads *a,
                          const struct um_irradiation_loads *b)
{
  size_t n = a->ntime * a->nsurface * UM_ANGULAR_MOMENTS;
  if (a->planet_moments == NULL || b->planet_moments == NULL)
    return a->planet_moments == b->planet_moments;
  return same(a->albedo_moments, b->albedo_moments, n, sizeof(float)) &&
         same(a->planet_moments, b->planet_moments, n, sizeof(float));
}

bool um_model_loads_equal(const struct um_irradiation_loads *a,
                          const struct um_irradiation_loads *b)
{
  if (a == b) return true;
  if (a == NULL || b == NULL || a->ntime != b->ntime || a->nsurface != b->nsurface ||
      a->nedge != b->nedge || (a->by_cosine == NULL) != (b->by_cosine == NULL))
    return false;
  size_t n = a->ntime * a->nsurface, ncosine = a->by_cosine != NULL ? UM_IRRADIATION_COSINES : 0;
  return same(a->t, b->t, a->ntime, sizeof *a->t) &&
         same(a->sunlit, b->sunlit, a->ntime, sizeof *a->sunlit) &&
         same(a->irradiance, b->irradiance, a->ntime, sizeof *a->irradiance) &&
         same(a->edge, b->edge, a->nedge, sizeof *a->edge) &&
         same(a->sun, b->sun, n, sizeof *a->sun) &&
         same(a->incidence, b->incidence, n, sizeof *a->incidence) &&
         same(a->by_cosine, b->by_cosine, n * ncosine, sizeof *a->by_cosine) &&
         same(a->albedo, b->albedo, n, sizeof *a->albedo) &&
         same(a->planet, b->planet, n, sizeof *a->planet) && (a->gas == NULL) == (b->gas == NULL) &&
         (a->gas == NULL || same(a->gas, b->gas, n, sizeof *a->gas)) && moments_equal(a, b);
}

bool um_model_mirror_classes_equal(const struct um_geometry_mirrors *a,
                                   const struct um_geometry_mirrors *b)
{
  if (a == NULL || b == NULL) return a == b;
  return a->nsurface == b->nsurface && a->nclass == b->nclass &&
         same(a->of, b->of, a->nsurface, sizeof *a->of);
}

static bool factors_equal(const struct um_geometry_view_factors *a,
                          const struct um_geometry_view_factors *b)
{
  size_t n = a->npatch, nentry = a->begin[n];
  return a->npatch == b->npatch && same(a->begin, b->begin, n + 1, sizeof *a->begin) &&
         same(a->other, b->other, nentry, sizeof *a->other) &&
         same(a->area, b->area, nentry, sizeof *a->area);
}

bool um_model_view_factors_equal(const struct um_geometry_view_factor_table *a,
                                 const struct um_geometry_view_factor_table *b)
{
  if (a == b) return true;
  if (a == NULL || b == NULL || a->npose != b->npose || a->ntime != b->ntime ||
      a->ncorner != b->ncorner || a->nroom != b->nroom || a->noutside != b->noutside ||
      a->patches->npatch != b->patches->npatch || a->patches->nsurface != b->patches->nsurface)
    return false;
  if (!um_model_mirror_classes_equal(a->mirrors, b->mirrors)) return false;
  size_t n = a->ntime * a->ncorner;
  for (size_t k = 0; k < a->npose; k++)
    if (!factors_equal(a->pose[k], b->pose[k])) return false;
  for (size_t k = 0; k < a->nroom; k++)
    if (a->room[k].first != b->room[k].first ||
        !factors_equal(a->room[k].factors, b->room[k].factors))
      return false;
  return same(a->corner, b->corner, n, sizeof *a->corner) &&
         same(a->weight, b->weight, n, sizeof *a->weight) &&
         same(a->patches->patch, b->patches->patch, a->patches->nsurface,
              sizeof *a->patches->patch);
}

bool um_model_times_equal(const struct um_model_tables *a, const struct um_model_tables *b)
{
  if (a == b) return true;
  if (a->nobs != b->nobs || a->nsub != b->nsub || a->t_start != b->t_start ||
      a->t_first != b->t_first || !(a->period == b->period || isnan(a->period + b->period)))
    return false;
  for (size_t i = 0; i < a->nobs * a->nsub; i++)
    if (a->sample[i].t_tai != b->sample[i].t_tai) return false;
  return true;
}

bool um_model_heat_options_equal(const struct um_thermal_solve_options *a,
                                 const struct um_thermal_solve_options *b)
{
  return a->relative_tolerance == b->relative_tolerance &&
         a->absolute_tolerance == b->absolute_tolerance &&
         a->space_temperature == b->space_temperature && a->albedo_on == b->albedo_on &&
         a->planet_on == b->planet_on;
}
