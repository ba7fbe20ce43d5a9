/* Incident loads per surface on a grid of times, before any optical property acts: traced once,
 * used by every thermal run of the same timeline. Linear between grid times. */
#ifndef UMBRA_IRRADIATION_LOADS_H
#define UMBRA_IRRADIATION_LOADS_H

#include "environment/environment.h"
#include "environment/timeline.h"
#include "geometry/visibility.h"
#include "thermal/loads/sky.h"

#define UM_IRRADIATION_COSINES 9

struct um_irradiation_loads {
  size_t ntime, nsurface;
  double *t;          /* [ntime] t_tai, ascending [s] */
  double *sunlit;     /* [ntime] fraction of the disc [1] */
  double *irradiance; /* [ntime] solar irradiance outside the shadow [W/m^2] */
  float *sun;         /* [ntime][nsurface] free fraction * max(cos incidence, 0) [1] */
  float *incidence; /* [ntime][nsurface] max(cos incidence, 0) of the Sun; 0 in deep eclipse [1] */
  float *by_cosine; /* [ntime][nsurface][UM_IRRADIATION_COSINES] over a turn: `sun` spread over
                       nodes at cosines of (b / (COSINES - 1))^2, so that sums with values there
                       are those with a cubic in the root of the cosine between four; NULL:
                       `incidence` is all of it */
  float *albedo;    /* [ntime][nsurface] incident [W/m^2]; switches not applied */
  float *planet;    /* [ntime][nsurface] incident [W/m^2] */
  float *view_factor; /* [ntime][nsurface] free view factor to the Earth [1] */
  float *brightness;  /* [ntime][nsurface] brightness temperature in 8-12 um of the Earth before the
                         surface [K]; NULL: the environment's, everywhere and always */
  float *albedo_moments, *planet_moments; /* [ntime][nsurface][UM_ANGULAR_MOMENTS] by which angles
                                             `albedo` and `planet` arrive: E_1 to E_5 of
                                             environment/angular_moments.h [W/m^2]; NULL: unknown */
  float *gas; /* [ntime][nsurface] energy of the atmosphere that a surface takes [W/m^2]; NULL: none
               */
  double *edge; /* [nedge] times at which the integrator must stop: eclipse edges [s] */
  size_t nedge;
};

/* samples[ntime] ascending; sun samples per facet nsample. Poses follow the joints of each sample.
 * Earth loads: exact unobstructed flux per normal times the free share of the cap (rigid body: its
 * sky; moving joints: rays in the pose of the sample; about 1 % of the hemisphere on covered
 * surfaces, exact on open ones); nothing of it is traced and left 0 where albedo, longwave and
 * brightness temperature are. Moments are there where the environment has absorptance_by_angle, of
 * what is free of the Earth as its loads are (test: thermal/loads/angles). Sun: rays, left 0
 * farther than 120 s and one sample from sunlight. Parallel over times. Progress is reported. */
enum um_status um_irradiation_loads_trace(struct um_context *context,
                                          const struct um_geometry *geometry,
                                          const struct um_environment *environment,
                                          const struct um_environment_sample *samples, size_t ntime,
                                          const double *edges, size_t nedge, int nsample,
                                          struct um_irradiation_loads **out);
/* A body that turns while all else hardly moves. */
struct um_irradiation_spin {
  size_t n;       /* attitudes of a turn that are looked at */
  double period;  /* [s] */
  bool variation; /* see below */
  /* attitude `before` [s] ahead of sample `row`, all else as there */
  enum um_status (*attitude)(void *self, size_t row, double before, struct um_quat *q);
  void *self;
};
struct um_irradiation_loads_options {
  int nsample;
  /* of a geometry that equals the table's: the same bits as without; NULL: it is made */
  const struct um_irradiation_sky *sky;
  const struct um_irradiation_spin *spin; /* NULL: attitudes are those of the samples */
  bool earth_alone; /* `sun` and `incidence` are left 0: who asks for light follows no heat */
};
/* Loads of the same meaning; with a turn each is the mean over the turn that ends at its sample,
 * position, Sun and Earth as they are there,
 *
 *   mean_k = 1/P integral q(u) du,   u in [0, P] since the turn began,
 *
 * by n midpoints, which begin elsewhere in each row; so `sun` is up to 1.1 / n^2
 * off where nothing shades, another way in every row, and not in the mean over rows. With variation
 * what a surface has taken beyond that mean since the middle of it, with mean 0 over the turn,
 *
 *   variation_k = integral (u / P - 1/2) q(u) du   [s] times the unit of the load.
 *
 * With a turn no joint may move. Errors of um_irradiation_loads_trace and of `attitude`. Test:
 * thermal/loads/spin_averaged. */
enum um_status um_irradiation_loads_make(struct um_context *context,
                                         const struct um_geometry *geometry,
                                         const struct um_environment *environment,
                                         const struct um_environment_sample *samples, size_t ntime,
                                         const double *edges, size_t nedge,
                                         const struct um_irradiation_loads_options *options,
                                         struct um_irradiation_loads **out);
/* Does the Earth send anything, so that it is traced? */
bool um_irradiation_earth_shines(const struct um_environment *environment);
/* Would a table of both look at a sky? Not where joints move, nor where the Earth is dark. */
bool um_irradiation_wants_sky(const struct um_geometry *geometry,
                              const struct um_environment *environment);
/* Uniform loads given by the caller (tests, imported fluxes): arrays as in the struct, zeroed. */
enum um_status um_irradiation_loads_create(struct um_context *context, size_t ntime,
                                           size_t nsurface, size_t nedge,
                                           struct um_irradiation_loads **out);
/* Rows at times [n] within those of a table, not one over turns, linear between its rows; without
 * edges. UM_ERR_MEMORY. The caller destroys. Test: model/geometry/sparse. */
enum um_status um_irradiation_loads_between(struct um_context *context,
                                            const struct um_irradiation_loads *loads,
                                            const double *times, size_t n,
                                            struct um_irradiation_loads **out);
/* How much stronger the Sun and the Earth shine. */
struct um_irradiation_levels {
  double irradiance, albedo, planet; /* of direct sunlight, of what the Earth reflects, of its own
                                        radiation [1] */
};
/* The same table with these loads, in which it is linear: what would be traced, but for the last of
 * 24 bits. UM_ERR_MEMORY. The caller destroys.
 * Test: model/geometry/scaled. */
enum um_status um_irradiation_loads_scaled(struct um_context *context,
                                           const struct um_irradiation_loads *loads,
                                           const struct um_irradiation_levels *by,
                                           struct um_irradiation_loads **out);
void um_irradiation_loads_destroy(struct um_context *context, struct um_irradiation_loads **loads);

#endif
