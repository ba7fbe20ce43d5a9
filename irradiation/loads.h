/* Incident loads per surface on a grid of times, before any optical property acts: traced once,
 * used by every thermal run of the same timeline. Linear between grid times. */
#ifndef UMBRA_IRRADIATION_LOADS_H
#define UMBRA_IRRADIATION_LOADS_H

#include "environment/environment.h"
#include "environment/timeline.h"
#include "geometry/visibility.h"

struct um_irradiation_loads {
  size_t ntime, nsurface;
  double *t;          /* [ntime] t_tai, ascending */
  double *sunlit;     /* [ntime] fraction of the disc */
  double *irradiance; /* [ntime] solar irradiance outside the shadow [W/m^2] */
  float *sun;         /* [ntime][nsurface] free fraction * max(cos incidence, 0) [1] */
  float *incidence; /* [ntime][nsurface] max(cos incidence, 0) of the Sun; 0 in deep eclipse [1] */
  float *albedo;    /* [ntime][nsurface] incident [W/m^2]; switches not applied */
  float *planet;    /* [ntime][nsurface] incident [W/m^2] */
  float *view_factor; /* [ntime][nsurface] free view factor to the Earth [1] */
  float *brightness;  /* [ntime][nsurface] brightness temperature in 8-12 um of the Earth before the
                         surface [K]; NULL: the environment's, everywhere and always */
  float *gas; /* [ntime][nsurface] energy of the atmosphere that a surface takes [W/m^2]; NULL: none
               */
  double *edge; /* [nedge] times at which the integrator must stop: eclipse edges */
  size_t nedge;
};

/* samples[ntime] ascending; sun samples per facet nsample. Poses follow the joints of each sample.
 * Earth loads: exact unobstructed flux per normal times the free share of the cap (rigid body: its
 * sky; moving joints: rays in the pose of the sample; about 1 % of the hemisphere on covered
 * surfaces, exact on open ones); Sun: rays, left 0 farther than 120 s and one sample from sunlight.
 * Parallel over times. Progress is reported. */
enum um_status um_irradiation_loads_trace(struct um_context *context,
                                          const struct um_geometry *geometry,
                                          const struct um_environment *environment,
                                          const struct um_environment_sample *samples, size_t ntime,
                                          const double *edges, size_t nedge, int nsample,
                                          struct um_irradiation_loads **out);
/* Uniform loads given by the caller (tests, imported fluxes): arrays as in the struct, zeroed. */
enum um_status um_irradiation_loads_create(struct um_context *context, size_t ntime,
                                           size_t nsurface, size_t nedge,
                                           struct um_irradiation_loads **out);
void um_irradiation_loads_destroy(struct um_context *context, struct um_irradiation_loads **loads);

#endif
