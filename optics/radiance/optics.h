/* From timeline and temperatures to spectral radiant intensity toward the observer. */
#ifndef UMBRA_OPTICS_OPTICS_H
#define UMBRA_OPTICS_OPTICS_H

#include "environment/environment.h"
#include "environment/moonlight.h"
#include "environment/timeline.h"
#include "environment/umbra_scatter.h"
#include "geometry/visibility.h"
#include "materials/materials.h"

/* A band is cut into `bins` bins of equal width; materials are evaluated at bin centres, sources
 * (Sun, black bodies) are exact means over each bin, so that grey bands do not depend on `bins`. */
struct um_optics_band {
  const char *name;
  double from, to; /* [m] */
  int bins;
  const double *transmission; /* [bins] of the filter, mean over each bin [1]; NULL: all passes */
};

/* Edge i of the bins of a band, i from 0 to bins [m]. */
static inline double um_optics_band_edge(const struct um_optics_band *band, int i)
{
  return band->from + (band->to - band->from) * i / band->bins;
}

/* Sunlight at an instant: what distance, shadow and the Earth's air leave of it. */
struct um_optics_sunlight {
  double share;  /* sunlit fraction (1 au / d)^2 [1] */
  double near;   /* (1 au / d)^2 [1] */
  double sunlit; /* fraction of the disc [1] */
  struct um_environment_shadow_light air;
  struct um_environment_scattered scattered; /* by the air, into the shadow */
};
void um_optics_sunlight_at(const struct um_environment *environment,
                           const struct um_environment_sample *sample,
                           struct um_optics_sunlight *out);
/* Spectral irradiance at a wavelength [m], of that at 1 au above all air; both [W/m^2/m]. */
double um_optics_sunlight(const struct um_optics_sunlight *light, double solar, double wavelength);

/* What shines on the satellite from far away. */
enum um_optics_lamp_name { UM_LAMP_SUN, UM_LAMP_MOON };

enum um_optics_mechanism {
  UM_MECHANISM_SUN,   /* sunlight reflected once */
  UM_MECHANISM_EARTH, /* earthshine and reflected Earth radiation */
  UM_MECHANISM_EMITTED,
  UM_MECHANISM_INTERREFLECTED, /* light that left one surface and was reflected by another */
  UM_MECHANISM_OTHER,          /* moonlight reflected once */
  UM_MECHANISM_COUNT
};
/* "sun", "earth", "emitted", "interreflected", "other"; borrowed for good. */
const char *um_optics_mechanism_name(enum um_optics_mechanism mechanism);

/* What a lamp lights of what the observer sees, by instants that it shines at. */
struct um_optics_lit {
  size_t nrow;
  float *share;  /* [nrow][nsurface] fraction that the observer sees and the lamp lights; of a Sun
                    that  does not shine, beside a Moon that does, 0 */
  float *error;  /* [nrow][nsurface] its standard error */
  float *cosine; /* [nrow][nsurface] of the surface normal to the lamp; <= 0: away */
  /* [nrow][nsurface] cosine of the normal to the lamp-observer bisector; double, because narrow
   * lobes depend on 1 - cos; 0 where the lamp stands opposite to the observer [1] */
  double *cos_half;
};

/* Geometry of sight, traced once per timeline; no optical property acts on it. */
struct um_optics_view {
  size_t ntime, nsurface;
  uint64_t seed;
  int *nsample;     /* [ntime] points per facet of surfaces that something can hide */
  int *path_factor; /* [ntime] times the paths between surfaces that the scene has; 1 when traced */
  float *seen;      /* [ntime][nsurface] fraction of the area that the observer sees */
  float *seen_error;              /* [ntime][nsurface] standard error of that fraction */
  float *cos_observer;            /* [ntime][nsurface] cosine of the surface normal; <= 0: away */
  struct um_optics_lit sun, moon; /* of the Sun every instant is a row */
  size_t *moon_row;          /* [ntime] row of an instant in `moon`; SIZE_MAX: it is not moonlit */
  float *cos_nadir;          /* [ntime][nsurface] cosine of the normal to the geocentre */
  double *area;              /* [nsurface] [m^2] */
  uint32_t *material, *part; /* [nsurface] */
};
/* Directions to the observer, to the Sun and, where a sample has one, to the Moon are turned into
 * the body frame by each sample's attitude, joints by its Sun; Sun and Moon are discs of their true
 * angular radii. Samples whose to_observer is zero are refused (UM_ERR_INPUT), as is nsample
 * outside 1..UM_OPTICS_SAMPLES_MAX: points per facet of surfaces that something can hide; open
 * surfaces are exact. seed: another one takes other points of the same kind. Same bytes for any
 * number of threads. UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED. The caller destroys. */
#define UM_OPTICS_SAMPLES_MAX 65536
enum um_status um_optics_view_trace(struct um_context *context, const struct um_geometry *geometry,
                                    const struct um_environment_sample *samples, size_t ntime,
                                    int nsample, uint64_t seed, struct um_optics_view **out);
/* Trace again the times whose number of points is not nsample[time]; geometry and samples as they
 * were for the view. Errors as above; the times traced before one stay traced. */
enum um_status um_optics_view_retrace(struct um_context *context,
                                      const struct um_geometry *geometry,
                                      const struct um_environment_sample *samples,
                                      const int *nsample /* [ntime] */,
                                      struct um_optics_view *view);
void um_optics_view_destroy(struct um_context *context, struct um_optics_view **view);

struct um_optics_lightcurve {
  size_t ntime, nband, nbin /* of all bands together */, nmaterial;
  double *wavelength;   /* [nbin] centres [m] */
  double *width;        /* [nbin] [m] */
  double *transmission; /* [nbin] of the band's filter [1] */
  uint32_t *band;       /* [nbin] band of each bin */
  /* before any filter: spectral radiant intensity [W/sr/m] */
  double *spectral; /* [ntime][nbin][UM_MECHANISM_COUNT] */
  /* band radiant intensity, what passes the filter [W/sr] */
  double *intensity; /* [ntime][nband][nmaterial][UM_MECHANISM_COUNT] */
  /* Standard error of the total [ntime][nband] [W/sr]: of the traced fractions (seen and lit of one
   * surface taken as fully correlated, surfaces as independent) and of inter-reflection. */
  double *stderr_;
  double *between_stderr; /* [ntime][nband] of it, by inter-reflection [W/sr] */
};

struct um_optics_creases;     /* creases.h */
struct um_optics_photon_maps; /* photon_maps.h */

struct um_optics_scene {
  const struct um_geometry *geometry;
  const struct um_optics_creases *creases; /* of surfaces that are not flat; NULL: all are */
  const struct um_environment *environment;
  const struct um_environment_sample *samples; /* [ntime] */
  const struct um_optics_view *view;
  const struct um_materials_record *const *material; /* [nmaterial], order of the geometry */
  /* [nmaterial], or [ntime][nmaterial] where surfaces age, or NULL */
  const struct um_materials_adjustment *adjustment;
  bool ages;
  const double *temperature; /* [ntime][nsurface] [K] */
  const float *albedo;      /* [ntime][nsurface] incident albedo flux [W/m^2], free share applied */
  const float *view_factor; /* [ntime][nsurface] free view factor to the Earth */
  const float *brightness;  /* [ntime][nsurface] brightness temperature of the Earth before the
                               surface [K]; NULL: the environment's */
  int interreflection_samples; /* paths per surface that is not open, at an instant, in the mean, or
                                  1024 of all if that is more; 0: off */
  const struct um_optics_photon_maps *photons; /* of a scene of the same geometry and view; taken
                                                  where mirrors are the same. NULL: traced */
  int interreflection_most; /* surfaces after the first that a path meets; 0: any number */
  bool sunlight_only;       /* neither the Earth nor heat is added up */
};
/* Light curve. The Sun term is multiplied by the sunlit fraction, so it is exactly zero in the
 * umbra. Radiance of a surface toward the observer:
 *   sun:     E_sun(lambda) nu f_r(i, o) cos_i
 *   earth:   rho_d E_albedo(lambda)/pi + (1 - eps(cos_o)) F L_lambda(T_b)
 *   emitted: eps(lambda, cos_o) B_lambda(T)
 *   inter-reflected: f_r times what comes from the other surfaces that it faces, sunlight, the
 *   Earth's light and their emission, after any number of reflections (interreflection.c)
 * rho_d E_albedo is spread over wavelength like sunlight. F of the lobe is taken at half the phase
 * angle. The lobe's alpha is widened by the Sun's disc: alpha^2 + (theta_s/(2 sqrt 2))^2.
 * UM_ERR_INPUT: bad band (named), material without record, view of another mesh; UM_ERR_NUMERIC: a
 * temperature that is not positive (part and facet named); UM_ERR_MEMORY, UM_ERR_LIBRARY,
 * UM_ERR_CANCELLED. Same bytes for any number of threads. The caller destroys. */
enum um_status um_optics_lightcurve_compute(struct um_context *context,
                                            const struct um_optics_scene *scene,
                                            const struct um_optics_band *bands, size_t nband,
                                            struct um_optics_lightcurve **out);
void um_optics_lightcurve_destroy(struct um_context *context, struct um_optics_lightcurve **curve);
/* Adjustment of a material at an instant of the scene; NULL: none. */
static inline const struct um_materials_adjustment *
um_optics_adjustment(const struct um_optics_scene *scene, size_t time, size_t material)
{
  size_t nmaterial = um_geometry_material_count(scene->geometry);
  if (scene->adjustment == NULL) return NULL;
  return &scene->adjustment[(scene->ages ? time * nmaterial : 0) + material];
}

#endif
