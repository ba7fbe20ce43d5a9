/* Paths of light between surfaces: where they turn, and how. Private to optics/paths/. */
#ifndef UMBRA_OPTICS_PATHS_IMPL_H
#define UMBRA_OPTICS_PATHS_IMPL_H

#include "materials/lobe.h"
#include "optics/radiance/glow_group.h"
#include "optics/radiance/posed_scene_group.h"
#include "optics/radiance/radiance_group.h"

#define UM_OPTICS_PATHS 16 /* that are traced together */

/* What of a pose paths go by, whatever the optics are. */
struct um_optics_exchange {
  const struct um_geometry_mesh *mesh;
  uint8_t *closed; /* [nsurface] no ray leaves it to the sky */
  int *count;      /* [nsurface] paths of a surface at an instant; 0: nothing stands before it */
};

/* A direction into the Sun's disc by two numbers of [0, 1). */
struct um_vec3 um_optics_disc_direction(const struct um_optics_instant *instant, const double u[2]);

struct um_optics_first_turns; /* first_turns_group.h */

/* Everything that paths of one instant have in common. */
struct um_optics_paths {
  const struct um_optics_spectra *spectra;
  const struct um_optics_scene *scene;
  const struct um_optics_instant *instant;
  const struct um_optics_posed_scene *posed;
  struct um_optics_work *work;
  int factor;                                  /* times the paths of the exchange */
  const struct um_optics_photon_maps *photons; /* that serve; NULL: they are traced */
  const struct um_optics_first_turns *turns;   /* kept of this instant; NULL: none that serve */
  size_t turn;                                 /* the surface's first bit of them */
  struct um_optics_glow *glow; /* takes what paths see of black bodies; NULL: not asked */
};

/* Is a lobe so narrow that chance does not find what it shows? */
bool um_optics_is_mirror(const struct um_materials_lobe *lobe);

/* Do two lobes send light alike, but for how much? */
bool um_optics_same_lobe(const struct um_materials_lobe *a, const struct um_materials_lobe *b);

/* A point of a surface, seen from a direction. */
struct um_optics_vertex {
  size_t surface, skin, at; /* at: of the scene's [ntime][nsurface] */
  struct um_vec3 point, along, across, normal;
  struct um_vec3 o; /* where it is seen from, in its frame */
  double toward;    /* um_materials_lobe_toward of o */
  bool mirror;      /* um_optics_is_mirror */
};
/* `from`: unit, body frame, toward where it is seen from, before the surface. */
void um_optics_vertex_place(const struct um_optics_paths *paths, size_t surface,
                            struct um_vec3 point, struct um_vec3 from,
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
/* A direction by three numbers of [0, 1): `which` takes the lobe or the flat part. Its density is
 * that of both (balance heuristic, Veach 1997), so that each direction counts once whichever way it
 * was found; a true mirror's direction stands alone. False: no light comes this way. */
bool um_optics_vertex_sample(const struct um_optics_paths *paths,
                             const struct um_optics_vertex *vertex, double which, const double u[2],
                             struct um_optics_turn *turn);
/* The direction that um_optics_vertex_sample finds by the lobe or by the cosine, whatever their
 * shares. False: no light comes this way. */
bool um_optics_vertex_direction(const struct um_optics_paths *paths,
                                const struct um_optics_vertex *vertex, bool by_lobe,
                                const double u[2], struct um_vec3 *direction);
/* A direction into which a mirror throws what comes to it from o; flat is 0. sunlight: what comes
 * is the Sun's disc about o, of which a true mirror takes o alone. */
bool um_optics_vertex_mirror(const struct um_optics_paths *paths,
                             const struct um_optics_vertex *vertex, bool sunlight,
                             const double u[2], struct um_optics_turn *turn);
/* Light of unit irradiance that comes from a direction; flat 1, lobe f, of a mirror 0. False:
 * behind the surface. */
bool um_optics_vertex_lit(const struct um_optics_paths *paths,
                          const struct um_optics_vertex *vertex, struct um_vec3 direction,
                          struct um_optics_turn *turn);
/* Sunlight, of the disc's mean direction; false where it stands behind the surface. */
bool um_optics_vertex_sun(const struct um_optics_paths *paths,
                          const struct um_optics_vertex *vertex, struct um_optics_turn *turn);
/* f_r cos_i/p per bin, of some of its parts. */
enum um_optics_parts { UM_OPTICS_FLAT = 1, UM_OPTICS_LOBE = 2, UM_OPTICS_WHOLE = 3 };
void um_optics_vertex_row(const struct um_optics_paths *paths,
                          const struct um_optics_vertex *vertex, const struct um_optics_turn *turn,
                          enum um_optics_parts parts, double *row);
/* Radiance that leaves a vertex without any further turn, per bin: its emission, and the Earth that
 * its flat parts reflect; emissivity and black body are left in the scratch. */
void um_optics_vertex_glow(const struct um_optics_paths *paths,
                           const struct um_optics_vertex *vertex, double *row);
/* The Earth's radiance from a direction of the body frame [W/m^2/sr/m]; false: space. */
bool um_optics_vertex_earth(const struct um_optics_paths *paths, struct um_vec3 direction,
                            double *row);

#endif
