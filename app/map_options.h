/* Options of what is mapped, for the commands that make a map. */
#ifndef UMBRA_APP_MAP_OPTIONS_H
#define UMBRA_APP_MAP_OPTIONS_H

#include "app/app.h"
#include "model/products/reflectivity_map.h"

#define UM_APP_MAP_PHASES 64 /* at most */

struct um_app_map_options {
  double phase_angle[UM_APP_MAP_PHASES]; /* [rad] */
  struct um_model_map_grid grid;         /* its phase angles are those */
};
/* default_step [deg]. Without --phase-angles: one, of 0 deg. UM_APP_DONE, or UM_APP_MISUSE with
 * what is wrong said. */
int um_app_map_options_parse(const struct um_app_options *options, double default_step,
                             struct um_app_map_options *out);

#endif
