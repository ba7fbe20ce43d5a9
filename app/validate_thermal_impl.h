/* What the thermal cases share. */
#ifndef UMBRA_APP_VALIDATE_THERMAL_IMPL_H
#define UMBRA_APP_VALIDATE_THERMAL_IMPL_H

#include "app/validate.h"
#include "thermal/solve.h"

/* Groups of cases, one per file. */
enum um_status um_app_validate_conduction(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_radiation(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_networks(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_orbiting(struct um_context *context, struct um_app_report *report);
enum um_status um_app_validate_view_factors(struct um_context *context,
                                            struct um_app_report *report);

/* Integration so tight that its error is below every printed digit; space at `space` [K]. */
struct um_thermal_solve_options um_app_validate_tight(double space);
/* Surface number `surface` of `area` [m^2] on one node. */
enum um_status um_app_validate_surface(struct um_thermal_network *network, uint32_t surface,
                                       uint32_t node, double area, double absorptance,
                                       double emittance);
/* Constant loads on surfaces whose share of sunlight is sun[nsurface] and whose incident infrared
 * is planet[nsurface] [W/m^2] (NULL: none); irradiance [W/m^2]. The caller destroys. */
enum um_status um_app_validate_loads(struct um_context *context, size_t nsurface, double irradiance,
                                     const double *sun, const double *planet,
                                     struct um_thermal_loads **out);

#endif
