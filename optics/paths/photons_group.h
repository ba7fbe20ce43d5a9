/* Sunlight that mirrors throw on other surfaces, traced from the Sun (photon mapping, Jensen 1996):
 * from the observer it would be found by chance, as rare large values. Private to the rooms of
 * optics/.
 *
 * A mirror is a lobe of alpha below 0.15 or a true one. What falls on a surface after one mirror or
 * more is a photon; what that surface scatters of it, by its flat parts or a wide lobe, comes from
 * here alone, what a further mirror makes of it is its next photon. Sunlight that mirrors throw to
 * the observer himself is none of this: paths find it. */
#ifndef UMBRA_OPTICS_PHOTONS_GROUP_H
#define UMBRA_OPTICS_PHOTONS_GROUP_H

#include "optics/paths/paths_impl.h"

struct um_optics_photon {
  uint32_t surface;  /* that it falls on */
  uint32_t before;   /* photon that fell on its last mirror; UM_GEOMETRY_NONE: that one is sunlit */
  uint32_t root;     /* photon path from the Sun that it is of */
  uint16_t mirrors;  /* on its way, 1 or more */
  uint16_t skin;     /* of the last of them */
  float cos_d, area; /* F there is at cos_d [1]; flux over that before the satellite and over the F
                        of its mirrors [m^2] */
  struct um_vec3 point, from; /* from: unit, toward the last mirror; body frame */
};

/* Photon paths from the Sun that set out from one surface. */
struct um_optics_beam {
  uint32_t surface, first, count; /* root of the first */
};

struct um_optics_photons {
  size_t nband, nsurface, room, root_room;
  size_t count, nbeam, nroot;
  struct um_optics_photon *photon; /* [room] */
  uint32_t *first, *order;         /* [nsurface + 1], [room]: photons by surface */
  struct um_optics_beam *beam;     /* [nsurface] */
  double *
      brought; /* [root_room][nband] what each path brings to the observer [W/sr], as it is found */
};

/* Room for the photon paths of a pose, factor times its own paths; more than there was, never less.
 * nband 0: nothing is kept of what paths bring. UM_ERR_MEMORY. */
enum um_status um_optics_photons_reserve(struct um_context *context,
                                         const struct um_optics_spectra *spectra,
                                         const struct um_optics_posed_scene *posed, int factor,
                                         size_t nband, struct um_optics_photons *photons);
void um_optics_photons_clear(struct um_context *context, struct um_optics_photons *photons);

/* Photons of an instant. seed: as of the view. */
void um_optics_photons_trace(const struct um_optics_paths *paths, uint64_t seed,
                             struct um_optics_photons *photons);
/* Photons that came another way, by surface; nothing is brought yet. */
void um_optics_photons_begin(struct um_optics_photons *photons);

static inline size_t um_optics_photons_on(const struct um_optics_photons *photons, size_t surface)
{
  return photons->first[surface + 1] - photons->first[surface];
}
/* Spectral irradiance before the satellite times the F of its mirrors, row[nbin] [W/m^2/m]. */
void um_optics_photon_row(const struct um_optics_paths *paths,
                          const struct um_optics_photons *photons,
                          const struct um_optics_photon *photon, double *row);

/* Variance of what all paths brought, of band k [W^2/sr^2]. */
double um_optics_photons_variance(const struct um_optics_photons *photons, size_t k);

#endif
