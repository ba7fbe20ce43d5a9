/* Optics and reflections of patches of which some are mirrors; equations in exchange.h. */
#include <math.h>

#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"

#define MOST                                                                                       \
  0.999 /* of what falls in that a mirror sends on [1]: the rest of its equations has              \
           1 - rho in every place */

/* rho of classes and patches from what those absorb [npatch]; lobe NULL: none. */
static void take_mirrors(struct um_thermal_exchange_maker *m, size_t first, const double *absorbed,
                         const double *lobe)
{
  const struct um_geometry_view_factor_table *table = m->table;
  for (size_t p = 0; p < m->n; p++) m->mirror[p] = 0.0;
  for (uint16_t c = 0; lobe != NULL && c < table->mirrors->nclass; c++) {
    double area = 0.0, sum = 0.0, least = 1.0;
    for (size_t p = 0; p < m->n; p++) {
      if (um_geometry_mirrors_patch(table->mirrors, table->patches, first + p) != c) continue;
      double reflected = fmax(0.0, 1.0 - absorbed[first + p]);
      area += m->out->area[first + p];
      sum += m->out->area[first + p] * reflected;
      least = fmin(least, reflected);
    }
    m->of_class[c] = area > 0.0 ? fmin(fmin(lobe[c] * sum / area, least), MOST) : 0.0;
  }
  for (size_t p = 0; lobe != NULL && p < m->n; p++) {
    uint16_t c = um_geometry_mirrors_patch(table->mirrors, table->patches, first + p);
    if (c != UM_GEOMETRY_NO_MIRROR) m->mirror[p] = m->of_class[c];
  }
}

/* Patches of those factors and their optics are then in hand. */
static void take(struct um_thermal_exchange_maker *m,
                 const struct um_geometry_view_factors *factors, size_t first,
                 const double *absorbed, const double *lobe)
{
  m->first = first;
  m->n = factors->npatch;
  take_mirrors(m, first, absorbed, lobe);
  for (size_t p = 0; p < m->n; p++) {
    m->open[p] = (1.0 - m->mirror[p]) * m->out->area[first + p];
    m->absorbed[p] = absorbed[first + p] / (1.0 - m->mirror[p]);
    m->reflectance[p] = 1.0 - m->absorbed[p];
  }
}

enum um_status um_thermal_exchange_make_reflections(struct um_thermal_exchange_maker *m,
                                                    const struct um_geometry_view_factors *factors,
                                                    size_t first, const double *absorbed)
{
  take(m, factors, first, absorbed, NULL);
  um_thermal_reflections_destroy(m->context, &m->reflections);
  return um_thermal_reflections_create(m->context, factors, m->open, m->reflectance,
                                       &m->reflections);
}

enum um_status um_thermal_exchange_make_pose(struct um_thermal_exchange_maker *m, size_t pose,
                                             const double *absorbed, const double *lobe)
{
  const struct um_geometry_view_factors *factors = m->table->pose[pose];
  if (lobe == NULL) return um_thermal_exchange_make_reflections(m, factors, 0, absorbed);
  take(m, factors, 0, absorbed, lobe);
  um_thermal_reflections_destroy(m->context, &m->reflections);
  um_geometry_view_factors_destroy(m->context, &m->mirrored_factors);
  UM_TRY(um_geometry_view_factors_mirrored(m->context, factors, m->table->mirrored[pose],
                                           m->out->area, m->of_class, m->mirror,
                                           &m->mirrored_factors));
  return um_thermal_reflections_create(m->context, m->mirrored_factors, m->open, m->reflectance,
                                       &m->reflections);
}
