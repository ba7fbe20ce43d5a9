/* Paths of light between surfaces: where they turn, and how. Private to optics/. */
#ifndef UMBRA_OPTICS_PATHS_IMPL_H
#define UMBRA_OPTICS_PATHS_IMPL_H

#include "materials/lobe.h"
#include "optics/radiance_impl.h"
#include "optics/set_impl.h"

#define UM_OPTICS_PLANES 12 /* flat mirrors whose sunlight is looked for */

/* Surfaces of one material that lie in planes of one direction. */
struct um_optics_plane {
  size_t surface; /* one of them */
  struct um_vec3 normal;
  double area; /* of all [m^2] */
};

/* What of a pose paths go by, whatever the optics are. */
struct um_optics_exchange {
  const struct um_geometry_mesh *mesh;
  uint8_t *closed; /* [nsurface] no ray leaves it to the sky */
  int *count;      /* [nsurface] paths of a surface at an instant; 0: nothing stands before it */
  size_t nplane;
  struct um_optics_plane plane[UM_OPTICS_PLANES]; /* the largest that other surfaces can see */
};

/* A flat mirror in sunlight: where it throws it. */
struct um_optics_glint {
  struct um_materials_lobe lobe; /* widened by the Sun's disc */
  struct um_vec3 along, across, normal;
  struct um_vec3 sun;      /* in that frame */
  struct um_vec3 mirrored; /* body frame */
  double toward;           /* um_materials_lobe_toward of the Sun */
  double radius;           /* 1 - cosine of the Sun's [1] */
};

/* Everything that paths of one instant have in common. */
struct um_optics_paths {
  const struct um_optics_spectra *spectra;
  const struct um_optics_scene *scene;
  const struct um_optics_instant *instant;
  const struct um_optics_set *set;
  struct um_optics_work *work;
  size_t nglint;
  struct um_optics_glint glint[UM_OPTICS_PLANES];
};
void um_optics_paths_glints(struct um_optics_paths *paths);

/* A point of a surface, seen from a direction. */
struct um_optics_vertex {
  size_t surface, skin, at; /* at: of the scene's [ntime][nsurface] */
  struct um_vec3 point, along, across, normal;
  struct um_vec3 o;               /* where it is seen from, in its frame */
  double toward;                  /* um_materials_lobe_toward of o */
  bool soft;                      /* sunlight through a lobe that is widened */
  double p_flat, p_lobe, p_glint; /* how often each way on is taken; sum 1 */
  int nglint;                     /* of the paths' that can shine on it */
  uint8_t glint[UM_OPTICS_PLANES];
  double share[UM_OPTICS_PLANES]; /* of p_glint; sum 1 */
};
/* `from`: unit, body frame, toward where it is seen from, before the surface. shines[nglint]: the
 * mirrors of which something is known to shine on it; NULL: nothing is known. */
void um_optics_vertex_place(const struct um_optics_paths *paths, size_t surface,
                            struct um_vec3 point, struct um_vec3 from, const bool *shines,
                            struct um_optics_vertex *vertex);

/* Light that comes from a direction and goes on to where the vertex is seen from:
 *   f_r(i, o) cos_i/p = flat f_flat(i, o) + lobe F(cos_d)
 * with p the density of the direction, or 1 for a given one. */
struct um_optics_turn {
  struct um_vec3 direction; /* unit, body frame */
  double cos_i, cos_d;
  double flat; /* cos_i/p [sr] */
  double lobe; /* f cos_i/p [1] */
};
/* A direction by three numbers of [0, 1): `which` takes the lobe, the flat part or a glint. Its
 * density is that of the mixture (balance heuristic, Veach 1997), so that each direction counts
 * once whichever way it was found; a true mirror's direction stands alone. False: no light comes
 * this way. */
bool um_optics_vertex_sample(const struct um_optics_paths *paths,
                             const struct um_optics_vertex *vertex, double which, const double u[2],
                             struct um_optics_turn *turn);
/* Did the turn that `which` made come of a lobe so narrow that no other way would find it? */
bool um_optics_vertex_is_narrow(const struct um_optics_paths *paths,
                                const struct um_optics_vertex *vertex, double which);
/* Sunlight, of the disc's mean direction; false where it stands behind the surface. */
bool um_optics_vertex_sun(const struct um_optics_paths *paths,
                          const struct um_optics_vertex *vertex, struct um_optics_turn *turn);
/* f_r cos_i/p per bin; lobe_only: without the flat part. */
void um_optics_vertex_row(const struct um_optics_paths *paths,
                          const struct um_optics_vertex *vertex, const struct um_optics_turn *turn,
                          bool lobe_only, double *row);
/* Radiance that leaves a vertex without any further turn, per bin: its emission, and the Earth that
 * its flat parts reflect; emissivity and black body are left in the scratch. */
void um_optics_vertex_glow(const struct um_optics_paths *paths,
                           const struct um_optics_vertex *vertex, double *row);
/* The Earth's radiance in a direction that leaves a vertex to it [W/m^2/sr/m]; false: space. */
bool um_optics_vertex_earth(const struct um_optics_paths *paths,
                            const struct um_optics_vertex *vertex, struct um_vec3 direction,
                            double *row);

#endif
