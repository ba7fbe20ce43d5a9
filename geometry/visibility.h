/* What sees what: the only place that knows Embree. Coordinates in body frame, metres. */
#ifndef UMBRA_GEOMETRY_VISIBILITY_H
#define UMBRA_GEOMETRY_VISIBILITY_H

#include "geometry/geometry.h"

struct um_geometry_visibility;

/* Scene of one pose; mesh and pose are borrowed for its life. Self-hits are excluded by facet id,
 * not by an epsilon. UM_ERR_LIBRARY carries Embree's text. */
enum um_status um_geometry_visibility_create(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_pose *pose,
                                             struct um_geometry_visibility **out);
void um_geometry_visibility_destroy(struct um_geometry_visibility **visibility);

struct um_geometry_ray {
  struct um_vec3 origin, direction; /* [m], unit [1] */
  double limit;                     /* [m]; INFINITY */
  uint32_t from_facet; /* where the origin lies; never hit, nor is what does not rise above its
                          plane on the ray's side; UM_GEOMETRY_NONE for none */
};
struct um_geometry_hit {
  uint32_t facet;   /* UM_GEOMETRY_NONE: missed */
  uint32_t surface; /* the side that was hit; UM_GEOMETRY_NONE when that side is not a surface */
  double distance;  /* [m] */
  double weight[3]; /* barycentric weights of the corners [1] */
};
/* Thread-safe; packets inside. occluded[i] = 1 when something lies within the limit. */
void um_geometry_visibility_occluded(const struct um_geometry_visibility *visibility,
                                     const struct um_geometry_ray *rays, size_t n,
                                     uint8_t *occluded);
void um_geometry_visibility_closest(const struct um_geometry_visibility *visibility,
                                    const struct um_geometry_ray *rays, size_t n,
                                    struct um_geometry_hit *hits);

/* True when nothing can stand before this surface: every vertex lies on or behind its plane. Such
 * surfaces need no rays and their fractions are exact. */
bool um_geometry_visibility_is_open(const struct um_geometry_visibility *visibility,
                                    size_t surface);

/* Fraction of each surface's area from which the unit direction d is free, 0 where the surface
 * faces away; nsample points per facet, keyed by (facet, sample) so that repeated calls use the
 * same points. fraction[nsurface]. */
void um_geometry_visibility_toward(const struct um_geometry_visibility *visibility,
                                   struct um_vec3 d, int nsample, double *fraction);
/* Toward two at once. seen[s]: fraction that sees direction o. lit[s]: fraction that sees both o
 * and the Sun (a disc of angular radius `radius` [rad] about direction s: each point sample also
 * samples the disc). seen_error/lit_error: standard errors of the two fractions,
 * sqrt(f (1 - f) um_geometry_scatter(nsample)); 1/2, the largest possible, for nsample =
 * 1; 0 where no ray was needed (open, or facing away). seed: other points of the same kind, for
 * errors that are independent of those of another seed; 0 are the points of
 * um_geometry_visibility_toward. Arrays [nsurface]; errors may be NULL. */
void um_geometry_visibility_toward_both(const struct um_geometry_visibility *visibility,
                                        struct um_vec3 o, struct um_vec3 s, double radius,
                                        int nsample, uint64_t seed, double *seen, double *lit,
                                        double *seen_error, double *lit_error);

/* Body-frame sky: for each surface, which directions are free; one per pose. */
struct um_geometry_sky;
enum um_status um_geometry_sky_create(struct um_context *context,
                                      const struct um_geometry_visibility *visibility, int nsample,
                                      struct um_geometry_sky **out);
void um_geometry_sky_destroy(struct um_geometry_sky **sky);
/* Free fraction of surface s toward direction d (0..1), nearest cell; 1 for open surfaces. d is
 * assumed to lie before the surface. */
double um_geometry_sky_free(const struct um_geometry_sky *sky, size_t surface, struct um_vec3 d);
/* The same in two steps, since the cell of a direction, 0..UM_GEOMETRY_OPEN_CELLS - 1, is the same
 * for all surfaces; freedom: the fraction times 255, 0..255. */
#define UM_GEOMETRY_OPEN_CELLS 1024 /* of one solid angle, about 6 deg across */
uint16_t um_geometry_sky_cell(struct um_vec3 d);
uint8_t um_geometry_sky_freedom(const struct um_geometry_sky *sky, size_t surface, uint16_t cell);

#endif
