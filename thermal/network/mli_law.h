/* What a blanket of MLI lets through, by temperature. With T_m the mean temperature of its sides:
 *
 * Doenecke 1993 (SAE 932117), a fit to blankets as flown,
 *   q = e* sigma (T_h^4 - T_c^4),  e* = (0.000136 / (4 sigma T_m^2) + 0.000121 T_m^0.667) f,
 *   f = f_N f_A f_p of number of layers, area and perforation, 1 for 20 layers on a large area;
 *
 * the Lockheed equation (Keller, Cunnington and Glassford 1974, NASA CR-134477), of double-
 * aluminised Mylar with silk net between,
 *   q = C_s N^2.56 T_m / (n + 1) (T_h - T_c) + C_r eps / n (T_h^4.67 - T_c^4.67)  [W/m^2],
 *   C_s = 8.95e-8, C_r = 5.39e-10, N layers per cm, n layers, eps 0.031 of a shield.
 *
 * Both are stated as e* at 300 K, the slope of q over 4 sigma T^3, and the share of it that spacers
 * conduct; what goes with temperature follows from the law. */
#ifndef UMBRA_THERMAL_MLI_LAW_H
#define UMBRA_THERMAL_MLI_LAW_H

#include "thermal/network/temperature_law.h"

enum um_thermal_mli_law { UM_MLI_CONSTANT, UM_MLI_DOENECKE, UM_MLI_LOCKHEED };

struct um_thermal_mli_slope {
  double effective_emittance; /* at 300 K [1] */
  double conducted;           /* share of it [1] */
};
/* factor: f_N f_A f_p [1]. */
struct um_thermal_mli_slope um_thermal_mli_doenecke(double factor);
/* layers n [1], density N [1/m], emittance of a shield [1]. */
struct um_thermal_mli_slope um_thermal_mli_lockheed(double layers, double density,
                                                    double emittance);
#endif
