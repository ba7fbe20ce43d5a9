/* Private to the rooms of thermal/: links that go with temperature. */
#ifndef UMBRA_THERMAL_LINK_LAW_GROUP_H
#define UMBRA_THERMAL_LINK_LAW_GROUP_H

#include "thermal/network/temperature_law.h"

/* r at the mean temperature of the ends [1], and its derivative [1/K]. */
double um_thermal_link_law_ratio(const struct um_thermal_link_law *law, double mean, double *slope);

/* Heat into the end at `own` [K] from the one at `other` [W], of a conductor `linear` [W/K] or a
 * radiator `fourth` = sigma R [W/K^4] (the other one is 0). out: -d/d own, in: d/d other [W/K]. */
double um_thermal_link_law_heat(const struct um_thermal_link_law *law, double linear, double fourth,
                                double own, double other, double *out, double *in);

#endif
