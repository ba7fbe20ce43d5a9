/* One instant of the scene, in GCRS: what orbit and environment say together. */
#ifndef UMBRA_ENVIRONMENT_TIMELINE_H
#define UMBRA_ENVIRONMENT_TIMELINE_H

#include "base/core/vec.h"

struct um_environment_sample {
  double t_tai;             /* satellite time [s] */
  struct um_vec3 r, v;      /* satellite, GCRS [m], [m/s] */
  struct um_vec3 sun;       /* apparent unit vector, satellite to Sun, GCRS [1] */
  double sun_distance;      /* [m] */
  struct um_vec3 pole;      /* Earth's pole, unit, GCRS [1] */
  struct um_vec3 greenwich; /* where prime meridian and equator meet, unit, GCRS [1] */
  double sunlit_fraction;   /* [1] */
  double scattered; /* share of sunlight at 0.55 um that the air scatters into the shadow, 0: none
                       that is lit by it (umbra_scatter.h) [1] */
  /* Geometric unit vector, satellite to Moon, GCRS, and distance [m]; zero where the Moon lights
   * nothing that is seen (um_environment_moon_place) */
  struct um_vec3 moon;        /* [1] */
  double moon_distance;       /* [m] */
  struct um_quat q;           /* GCRS to body */
  struct um_vec3 to_observer; /* unit, GCRS; zero when nobody looks at this instant [1] */
  double range;               /* [m]; NaN when nobody looks */
};

#endif
