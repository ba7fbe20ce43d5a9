/* From timeline and temperatures to spectral radiant intensity toward the observer. */
#ifndef UMBRA_OPTICS_OPTICS_H
#define UMBRA_OPTICS_OPTICS_H

#include "environment/environment.h"
#include "environment/timeline.h"
#include "geometry/visibility.h"
#include "materials/materials.h"

/* A band is cut into `bins` bins of equal width; radiometry is evaluated at bin centres with the
 * solar irradiance integrated exactly over each bin. */
struct um_optics_band {
  const char *name;
  double from, to; /* [m] */
  int bins;
};

enum um_optics_mechanism {
  UM_MECHANISM_SUN,   /* sunlight reflected once */
  UM_MECHANISM_EARTH, /* earthshine and reflected Earth radiation */
  UM_MECHANISM_EMITTED,
  UM_MECHANISM_INTERREFLECTED, /* light that left one surface and was reflected by another */
  UM_MECHANISM_OTHER,
  UM_MECHANISM_COUNT
};

/* Geometry of sight, traced once per timeline; no optical property acts on it. */
struct um_optics_view {
  size_t ntime, nsurface;
  float *seen; /* [ntime][nsurface] fraction of the area that the observer sees */
  float *lit;  /* [ntime][nsurface] fraction that the observer sees and the Sun lights */
  float *seen_error, *lit_error; /* [ntime][nsurface] standard errors of those fractions */
  float *cos_observer, *cos_sun; /* [ntime][nsurface] cosines of the surface normal; <= 0: away */
  float *cos_half; /* [ntime][nsurface] cosine of the normal to the Sun-observer bisector */
  double *area;    /* [nsurface] [m^2] */
  uint32_t *material, *part; /* [nsurface] */
};
/* samples whose to_observer is zero are refused. nsample points per facet. */
enum um_status um_optics_view_trace(struct um_context *context, const struct um_geometry *geometry,
                                    const struct um_environment_sample *samples, size_t ntime,
                                    int nsample, struct um_optics_view **out);
void um_optics_view_destroy(struct um_context *context, struct um_optics_view **view);

struct um_optics_lightcurve {
  size_t ntime, nband, nbin /* of all bands together */, nmaterial;
  double *wavelength; /* [nbin] centres [m] */
  double *width;      /* [nbin] [m] */
  uint32_t *band;     /* [nbin] band of each bin */
  /* spectral radiant intensity [W/sr/m] */
  double *spectral; /* [ntime][nbin][UM_MECHANISM_COUNT] */
  /* band radiant intensity [W/sr] */
  double *intensity; /* [ntime][nband][nmaterial][UM_MECHANISM_COUNT] */
  double *stderr_;   /* [ntime][nband] [W/sr], of the total */
};

struct um_optics_scene {
  const struct um_geometry *geometry;
  const struct um_environment *environment;
  const struct um_environment_sample *samples; /* [ntime] */
  const struct um_optics_view *view;
  const struct um_materials_record *const *material; /* [nmaterial], order of the geometry */
  const struct um_materials_adjustment *adjustment;  /* [nmaterial] or NULL */
  const double *temperature;                         /* [ntime][nsurface] [K] */
  const float *albedo;      /* [ntime][nsurface] incident albedo flux [W/m^2], free share applied */
  const float *view_factor; /* [ntime][nsurface] free view factor to the Earth */
  int interreflection_samples; /* rays per visible facet sample; 0: off */
};
/* Light curve. The Sun term is multiplied by the sunlit fraction, so it is exactly zero in the
 * umbra. Radiance of a surface toward the observer:
 *   sun:     E_sun(lambda) nu f_r(i, o) cos_i
 *   earth:   rho_d E_albedo(lambda)/pi + (1 - eps(cos_o)) F L_lambda(T_b)
 *   emitted: eps(lambda, cos_o) B_lambda(T)
 * The lobe's alpha is widened by the Sun's disc: alpha^2 + (theta_s/(2 sqrt 2))^2. */
enum um_status um_optics_lightcurve_compute(struct um_context *context,
                                            const struct um_optics_scene *scene,
                                            const struct um_optics_band *bands, size_t nband,
                                            struct um_optics_lightcurve **out);
void um_optics_lightcurve_destroy(struct um_context *context, struct um_optics_lightcurve **curve);

/* Picture of one instant: orthographic toward the observer, radiance per pixel and bin. */
struct um_optics_image {
  int width, height;
  double pixel_size; /* [m] on the satellite */
  size_t nbin;
  double *wavelength, *bin_width; /* [nbin] [m] */
  float *radiance;   /* [height][width][nbin] spectral radiance [W/m^2/sr/m]; row 0 on top */
  uint32_t *surface; /* [height][width] surface seen at the pixel centre, UM_GEOMETRY_NONE */
};
struct um_optics_image_options {
  int width; /* pixels; height follows; square pixels */
  int samples_per_pixel;
  struct um_vec3 up_gcrs; /* direction that points up in the picture */
};
/* time: index of the sample in the scene; the view is not used and may be NULL. */
enum um_status um_optics_image_render(struct um_context *context,
                                      const struct um_optics_scene *scene, size_t time,
                                      const struct um_optics_band *band,
                                      const struct um_optics_image_options *options,
                                      struct um_optics_image **out);
void um_optics_image_destroy(struct um_context *context, struct um_optics_image **image);

/* AB magnitude of a band irradiance given per bin [W/m^2/m] (photon counting, D.6 of the notes). */
double um_optics_magnitude_ab(const double *spectral_irradiance, const double *wavelength,
                              const double *width, size_t nbin);

#endif
