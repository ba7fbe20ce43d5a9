/* The heat that a place may miss. */
#ifndef UMBRA_MISSING_HEAT_HEAT_H
#define UMBRA_MISSING_HEAT_HEAT_H

#include "thermal/network/course.h"

/* Missing heat of one place: the wall of a group ("bus.+y"; "panel" where a part has one group) or
 * an interior. Its shape is that of the least BIC among those of thermal/network/course.h. Heat
 * before the first observation, at the satellite, is not looked for. */
struct um_missing_heat {
  char *place;                     /* "bus.+y", "bus.interior" */
  struct um_thermal_course course; /* shape, start and what else it has */
  size_t nparameter;               /* of that, with place and power */
  double chi2_explained;
  double stop;         /* t_tai of the end of a pulse, else of the last observation [s] */
  double power;        /* [W] while it is on; of a decay where it starts; below 0: heat that goes */
  double energy;       /* [J] until `stop` */
  double start_sigma;  /* [s] marginal over all that is fitted, and over the shapes */
  double energy_sigma; /* [J] the same, with what the linear response was off by */
  double last_sigma, period_sigma; /* [s] of course.last, course.period; NaN where there is none */
  double behind[UM_HEAT_SHAPES];   /* BIC of each shape less the least; 0: this one */
  /* history with few changes, and the band that holds it with probability UM_MISSING_HEAT_BAND */
  size_t nbin;
  double *t;          /* [nbin + 1] edges, t_tai [s] */
  double *heat;       /* [nbin] median [W] */
  double *sigma;      /* [nbin] standard deviation [W] */
  double *low, *high; /* [nbin] band [W] */
};
#define UM_MISSING_HEAT_TEXT 240
/* How the heat goes: ", a pulse of 120 W for 90 +- 4 s", and which shapes do nearly as well, "; or
 * a decay (BIC +3.1)". */
void um_missing_heat_text(const struct um_missing_heat *heat, char out[UM_MISSING_HEAT_TEXT]);

#endif
