/* Paths between patches by way of mirrors, in one pose, whatever those reflect: areas of rays with
 * the mirrors that they met, and with any reflectances the exchange areas that follow,
 *
 *   S'_pq = (1 - rho_p) (S_pq + sum_m w_m s_m,pq) (1 - rho_q),   w_m = product of rho of the
 * mirrors
 *
 * of the way, s_m,pq the area of rays that leave p diffusely and come upon q behind the mirrors of
 * the set m. What comes upon a mirror q leaves 1 - rho_q there and goes on with rho_q; so
 *
 *   sum_q S'_pq + S'_p,space = (1 - rho_p) A_p,
 *
 * the equations of diffuse surfaces with (1 - rho) A in place of A (Sarofim and Hottel 1966, J.
 * Heat Transfer 88:37; Siegel and Howell 2002, 9-4). One number stands for a path and its way back.
 */
#ifndef UMBRA_GEOMETRY_MIRROR_PATHS_H
#define UMBRA_GEOMETRY_MIRROR_PATHS_H

#include "geometry/mirrors.h"
#include "geometry/view_factors.h"

#define UM_GEOMETRY_SKY_SIDE  16 /* of the cube of directions (cube.h): 5.6 deg */
#define UM_GEOMETRY_SKY_CELLS (6 * UM_GEOMETRY_SKY_SIDE * UM_GEOMETRY_SKY_SIDE)

/* One patch that is come upon, or one cell of the sky. */
struct um_geometry_mirror_path {
  uint32_t to;   /* patch, or cell of the cube in body frame */
  uint32_t sets; /* number of the mirrors met */
  double area;   /* of rays [m^2] */
};

struct um_geometry_mirror_paths {
  size_t npatch;
  struct um_geometry_mirror_sets sets;
  size_t *begin;                        /* [npatch + 1] */
  struct um_geometry_mirror_path *path; /* by patch from, then `to`, then set */
  size_t *sky_begin;                    /* [npatch + 1] */
  struct um_geometry_mirror_path *sky;  /* the same to space */
  size_t rays;                          /* that met a mirror */
  size_t deepest;                       /* of them that met more than are followed */
};

/* The rays of the patches by which view factors were made (um_geometry_view_factors_create with the
 * same options, or taken from a file), those that meet a mirror traced on. *out NULL: no patch sees
 * a mirror. UM_ERR_CANCELLED, UM_ERR_MEMORY. The caller destroys. Test: geometry/mirror_paths. */
enum um_status um_geometry_mirror_paths_create(
    struct um_context *context, const struct um_geometry_mesh *mesh,
    const struct um_geometry_pose *pose, const struct um_geometry_visibility *visibility,
    const struct um_geometry_patches *patches, const struct um_geometry_view_factors *factors,
    const struct um_geometry_mirrors *mirrors,
    const struct um_geometry_view_factor_options *options, struct um_geometry_mirror_paths **out);
void um_geometry_mirror_paths_destroy(struct um_context *context,
                                      struct um_geometry_mirror_paths **paths);

/* S' for mirrors that reflect reflectance[nclass], of_patch[npatch] the same of patches (0 where
 * none), both below 1, closed like view factors; area[npatch] of patches [m^2]. paths NULL: no path
 * by a mirror. UM_ERR_NUMERIC as there. The caller destroys. */
enum um_status um_geometry_view_factors_mirrored(struct um_context *context,
                                                 const struct um_geometry_view_factors *factors,
                                                 const struct um_geometry_mirror_paths *paths,
                                                 const double *area, const double *reflectance,
                                                 const double *of_patch,
                                                 struct um_geometry_view_factors **out);

#endif
