/* Light between patches in all orders of reflection, B of exchange.h. Private to
 * thermal/exchange/. */
#ifndef UMBRA_THERMAL_REFLECTIONS_IMPL_H
#define UMBRA_THERMAL_REFLECTIONS_IMPL_H

#include "geometry/view_factors.h"
#include "thermal/exchange/triangle_impl.h"

struct um_thermal_reflections;

/* For patches of area[npatch], the row sums of the factors [m^2], and reflectance[npatch]; the
 * factors are borrowed. UM_ERR_NUMERIC: a room without a way out whose walls absorb nothing. The
 * caller destroys. */
enum um_status um_thermal_reflections_create(struct um_context *context,
                                             const struct um_geometry_view_factors *factors,
                                             const double *area, const double *reflectance,
                                             struct um_thermal_reflections **out);
void um_thermal_reflections_destroy(struct um_context *context, struct um_thermal_reflections **r);
/* out = B x, both [npatch][UM_THERMAL_TOGETHER], to 1e-9 of what a column sends; scratch: as
 * many numbers as um_thermal_reflections_scratch says. A column has the same
 * bits beside any others. false: as UM_ERR_NUMERIC above. */
bool um_thermal_reflections_apply(const struct um_thermal_reflections *r, const double *x,
                                  double *scratch, double *out);
size_t um_thermal_reflections_scratch(const struct um_thermal_reflections *r);
/* That error. */
enum um_status um_thermal_reflections_fail(struct um_context *context);

#endif
