/* What the thermal cases share. Private to app/validate/. */
#ifndef UMBRA_VALIDATE_THERMAL_CASE_IMPL_H
#define UMBRA_VALIDATE_THERMAL_CASE_IMPL_H

#include "app/validate/validate.h"
#include "thermal/solver/solve.h"

/* Integration so tight that its error is below every printed digit; space at `space` [K]. */
struct um_thermal_solve_options um_validate_tight(double space);
/* Surface number `surface` of `area` [m^2] on one node. */
enum um_status um_validate_surface(struct um_thermal_network *network, uint32_t surface,
                                   uint32_t node, double area, double absorptance,
                                   double emittance);
/* Constant loads on surfaces whose share of sunlight is sun[nsurface] and whose incident infrared
 * is planet[nsurface] [W/m^2] (NULL: none); irradiance [W/m^2]. The caller destroys. */
enum um_status um_validate_loads(struct um_context *context, size_t nsurface, double irradiance,
                                 const double *sun, const double *planet,
                                 struct um_irradiation_loads **out);

#endif
