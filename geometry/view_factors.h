/* View factors between patches of a satellite in one pose: the share of what leaves one diffusely
 * that reaches another, F_pq, kept as exchange areas
 *
 *   S_pq = A_p F_pq = A_q F_qp  [m^2],   sum_q S_pq + S_p,space = A_p.
 *
 * One number stands for both directions, so reciprocity is exact; the second equation, closure, is
 * made to hold by the smallest change of the sampled areas in the sense of their errors, which
 * keeps zeros and is not negative (view_factors_close.c). */
#ifndef UMBRA_GEOMETRY_VIEW_FACTORS_H
#define UMBRA_GEOMETRY_VIEW_FACTORS_H

#include "geometry/patches.h"
#include "geometry/visibility.h"

struct um_geometry_mirrors;

struct um_geometry_view_factor_options {
  size_t rays;        /* from each patch, shared among its surfaces by area */
  double cutoff;      /* pairs with both view factors below are left out [1] */
  bool open;          /* leave out closure: exchange areas as sampled, for tests */
  bool closed;        /* nothing has a way out: a ray that slips through an edge comes back */
  const char *cache;  /* folder of those made before (view_factor_file.h); NULL: none */
  const char *import; /* folder of those to take instead; NULL: none */
  const struct um_geometry_mirrors *mirrors; /* surfaces of the outside whose mirrored paths a table
                                                is to have too, borrowed; NULL: none */
};
/* rays 4096, cutoff 1e-5. */
void um_geometry_view_factor_defaults(struct um_geometry_view_factor_options *options);

/* Hashes of what view factors are made of. */
struct um_geometry_view_factor_key {
  uint64_t surfaces, positions, angles, sampling;
};

/* Rows in order of patches, columns ascending. */
struct um_geometry_view_factors {
  size_t npatch;
  size_t *begin;   /* [npatch + 1] */
  uint32_t *other; /* [nentry] */
  double *area;    /* [nentry] S_pq [m^2]; S_pp of a patch that is not flat, or looks at the inside
                      of a closed part, which is no surface: that comes back */
  double *space;   /* [npatch] S_p,space [m^2] */
  size_t rays;     /* traced */
  double cut;      /* largest share of a patch that the cut-off left out [1] */
  double unclosed; /* largest |sum of a row - 1| as sampled, the cut-off's share included [1] */
  double residual; /* the same after closure [1] */
};

/* Cosine-weighted rays from low-discrepancy points of every surface, keyed by facet and index: the
 * same for any number of threads. The standard error of a view factor before closure is below
 * sqrt(F (1 - F) / N), N rays of the patch (independent ones; these are evenly spread).
 * patches of the same mesh. Progress is reported. UM_ERR_INPUT: no rays; UM_ERR_NUMERIC: closure
 * does not converge; UM_ERR_CANCELLED, UM_ERR_MEMORY. The caller destroys. Test:
 * geometry/view_factors. */
enum um_status um_geometry_view_factors_create(
    struct um_context *context, const struct um_geometry_mesh *mesh,
    const struct um_geometry_pose *pose, const struct um_geometry_visibility *visibility,
    const struct um_geometry_patches *patches,
    const struct um_geometry_view_factor_options *options, struct um_geometry_view_factors **out);
/* The share of each surface's view that something stands in, by a few rays, added to seen[nsurface]
 * where it is not negative: for um_geometry_patches_create. UM_ERR_CANCELLED. */
enum um_status um_geometry_view_factors_seen(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_pose *pose,
                                             const struct um_geometry_visibility *visibility,
                                             double *seen);
void um_geometry_view_factors_destroy(struct um_context *context,
                                      struct um_geometry_view_factors **factors);
/* S_pq [m^2], 0 where there is no entry. */
double um_geometry_view_factors_area(const struct um_geometry_view_factors *factors, size_t p,
                                     size_t q);

#endif
