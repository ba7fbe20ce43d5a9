/* Private: a measured BRDF in memory. */
#ifndef UMBRA_MATERIALS_MEASURED_IMPL_H
#define UMBRA_MATERIALS_MEASURED_IMPL_H

#include <math.h>

#include "materials/cosines_impl.h"
#include "materials/measured.h"

#define UM_MATERIALS_MEASURED_BINS 256 /* of half vectors, theta_h = pi/2 s^2, s uniform */

/* Four nodes in a row and their weights. */
struct um_materials_stencil {
  size_t first;
  double weight[4]; /* [1] */
};

struct um_materials_measured_point {
  struct um_materials_stencil at;
  double weight; /* polar: cos sin dtheta; azimuth: dphi, both sides [rad] */
};

struct um_materials_measured {
  size_t npolar, nazimuth; /* with what lies beyond the normal, and beyond 0 and pi */
  double *polar, *azimuth; /* [npolar], [nazimuth] [rad] */
  double *log_f;           /* [npolar][npolar][nazimuth] of f in 1/sr */
  struct um_materials_measured_point *point, *turn; /* [npoint], [nturn] of integrals */
  size_t npoint, nturn;
  double albedo[UM_MATERIALS_COSINES]; /* directional, at the cosines of the spectral grid [1] */
  double mean, most, most_at;          /* of it [1], [1], [rad] */
  double below[UM_MATERIALS_MEASURED_BINS + 1]; /* share of half vectors before a bin [1] */
  double density[UM_MATERIALS_MEASURED_BINS];   /* of them [1/sr] */
  struct um_materials_measured_found found;
};

/* ln f at the azimuths of a pair of polar nodes, [nazimuth]. */
static inline double *um_materials_measured_row(const struct um_materials_measured *m, size_t a,
                                                size_t b)
{
  return m->log_f + (a * m->npolar + b) * m->nazimuth;
}
/* ln f that cubics through absurd values, of uneven steps, may not leave: e^60 is no BRDF. */
static inline double um_materials_measured_bounded(double log_f)
{
  return fmax(-60.0, fmin(60.0, log_f));
}
/* Of nodes x[n] whose first lies before the range, the last beyond it where `beyond`; n 4 or more.
 */
struct um_materials_stencil um_materials_stencil_at(const double *x, size_t n, bool beyond,
                                                    double at);
struct um_materials_stencil um_materials_measured_polar(const struct um_materials_measured *m,
                                                        double polar);
struct um_materials_stencil um_materials_measured_azimuth(const struct um_materials_measured *m,
                                                          double azimuth);
/* f [1/sr]. */
double um_materials_measured_at(const struct um_materials_measured *m,
                                const struct um_materials_stencil *i,
                                const struct um_materials_stencil *o,
                                const struct um_materials_stencil *phi);
/* Set ln f of pairs of which neither angle was one of incidence, and found.left_out.
 * UM_ERR_MEMORY. */
enum um_status um_materials_measured_fill(struct um_context *context,
                                          const struct um_materials_measured_grid *grid,
                                          struct um_materials_measured *m);
/* Find the albedo, and bring it to 1 where it is above. UM_ERR_NUMERIC, UM_ERR_MEMORY. */
enum um_status um_materials_measured_energy(struct um_context *context, bool renormalised,
                                            struct um_materials_measured *m);
/* Fill `below` and `density`. */
void um_materials_measured_shares(struct um_materials_measured *m);

#endif
