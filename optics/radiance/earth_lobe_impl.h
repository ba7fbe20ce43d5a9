/* The Earth as the lobe of a surface reflects it toward the observer. */
#ifndef UMBRA_OPTICS_EARTH_LOBE_IMPL_H
#define UMBRA_OPTICS_EARTH_LOBE_IMPL_H

#include "environment/earth_seen.h"
#include "materials/lobe.h"

/* Nodes of the facet's cosine o.h, (k/(nodes - 1))^2, at which Fresnel's reflectance is taken;
 * cubic between them: 1e-3 of it for dielectrics and metals. */
#define UM_OPTICS_FRESNEL_NODES 12
double um_optics_fresnel_node(int node);
/* Lagrange's weights of the nodes around a cosine, in its square root; returns the first of them.
 */
int um_optics_fresnel_weights(double cosine, double weight[4]);
/* Cosine of the Sun's zenith angle where a direction i, of cosine cos_eta with the nadir, meets the
 * Earth; 0 in the dark. h: distance of the geocentre over the Earth's radius. */
double um_optics_earth_lit(struct um_vec3 nadir, struct um_vec3 sun, double h, struct um_vec3 i,
                           double cos_eta);

/* Facets of a lobe, or what its kind draws in their place, in the frame of the surface: on rings of
 * equal share and at equal azimuths, [rings][cells]. */
#define UM_OPTICS_LOBE_RINGS     8
#define UM_OPTICS_LOBE_CELLS     16
#define UM_OPTICS_LOBE_CELLS_MAX 512
struct um_optics_lobe_facets {
  struct um_materials_lobe lobe;
  int rings, cells;
  struct um_vec3 *half; /* unit */
};
void um_optics_lobe_facets_fill(struct um_optics_lobe_facets *facets);

/* A surface before the Earth: cosines between its normal, the observer, the nadir and the Sun.
 * Which side of the plane of normal and observer the others stand on does not matter. */
struct um_optics_earth_before {
  double normal_observer, normal_nadir, normal_sun;
  double observer_nadir, observer_sun, nadir_sun;
  double h_ratio; /* distance of the geocentre over the Earth's radius [1], above 1 */
  /* directions with x along the grain, for lobes that are anisotropic; NULL: x toward the observer
   */
  const struct um_optics_frame *grain;
  /* an Earth that varies, and its axes in the frame of `grain`, which is then there; NULL: alike */
  const struct um_environment_earth_seen *seen;
  struct um_environment_earth_axes axes;
};
/* The frame of a surface: z its normal. */
struct um_optics_frame {
  struct um_vec3 observer, nadir, sun; /* unit */
};

/* Shares of a lobe with F = 1 by the cosine at which its facets mirror, so that a reflectance F
 * weighs them: sum over nodes of share F(node). All dimensionless, per unit of the Earth's radiance
 * (lit: of E_sun albedo/pi under an overhead Sun). */
struct um_optics_earth_lobe {
  double all[UM_OPTICS_FRESNEL_NODES];   /* of the whole lobe: its directional albedo */
  double earth[UM_OPTICS_FRESNEL_NODES]; /* of what comes from the visible Earth */
  /* of that, weighted by the cosine of the Sun's zenith angle, and by albedo where it varies */
  double lit[UM_OPTICS_FRESNEL_NODES];
  /* of `earth` with F = 1, by where the Earth is seen; set where it varies */
  double where[UM_EARTH_SEEN_NODES];
};

/* The edge of the Earth is put between facets linearly: with 8 x
 * 16 of them shares of the Earth are within 0.02 of the lobe's albedo, 0.004 rms; test:
 * optics/radiance/earth_lobe. Zero for a surface that the observer does not see. */
void um_optics_earth_lobe(const struct um_optics_earth_before *before,
                          const struct um_optics_lobe_facets *facets,
                          struct um_optics_earth_lobe *out);

#endif
