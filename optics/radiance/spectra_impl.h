/* Everything that depends on wavelength and not on time: bins, solar and Earth spectra, material
 * spectra, black-body tables. Built once per light curve or picture, then read by all threads. */
#ifndef UMBRA_OPTICS_SPECTRA_IMPL_H
#define UMBRA_OPTICS_SPECTRA_IMPL_H

#include "optics/radiance/creases.h"
#include "optics/radiance/earth_lobe_impl.h"
#include "optics/radiance/optics.h"

/* Nodes of the emissivity tables, uniform in the square root of the cosine, like those of records.
 */
#define UM_OPTICS_ANGLE_NODES 49

/* Bin means of B_lambda on a uniform grid of x = 1/T, for one band. */
struct um_optics_planck {
  double x_from, step; /* [1/K] */
  size_t nnode;        /* 0: evaluate directly */
  double *radiance;    /* [nnode][bins of the band] [W/m^2/sr/m] */
};

/* Tables of materials stand by skin (creases.h): without creases a skin is a material. */
struct um_optics_spectra {
  size_t nbin, nband, nskin, nmaterial, npart, njoint;
  double *wavelength, *width;     /* [nbin] [m] */
  double *from, *to;              /* [nbin] edges [m] */
  double *transmission;           /* [nbin] of the band's filter [1] */
  uint32_t *band;                 /* [nbin] */
  size_t *first;                  /* [nband + 1] first bin of each band */
  double *sun;                    /* [nbin] bin mean at 1 au [W/m^2/m] */
  double *share;                  /* [nbin] sun / total solar irradiance [1/m] */
  double *earth;                  /* [nbin] B_lambda(T_b) of the Earth, bin mean [W/m^2/sr/m] */
  double *clear, *cloud;          /* [UM_EARTH_TEMPERATURES][UM_EARTH_SEEN_RINGS][nbin] of an Earth
                                     that is spectral (earth_rows.c) [1]; NULL: it is not */
  double *diffuse;                /* [nskin][nbin] rho_d, with the mean of M [1] */
  double *emissivity;             /* [nskin][UM_OPTICS_ANGLE_NODES][nbin] not tilted [1]; a diffuse
                                     emitter has its one value in the first row */
  double *tilt;                   /* [nskin][nbin] of the emissivity, d eps_h of materials.h [1] */
  bool *tilts;                    /* [nskin] it is not 0 */
  bool *diffuse_emitter;          /* [nskin] */
  double *masked;                 /* [nskin][UM_OPTICS_ANGLE_NODES][nbin] M of materials.h [1] */
  double *masked_mean;            /* [nskin][nbin] its hemispherical mean [1] */
  bool *masks;                    /* [nskin] M is not 0 */
  struct um_materials_lobe *lobe; /* [nskin], of kind NULL where there is none */
  double *lobe_share;             /* [nskin] how often a path takes the lobe [1] */
  struct um_materials_lobe *flat; /* [nskin] the same on one patch of a creased surface */
  const struct um_optics_creases *creases; /* of the scene; NULL: nothing is creased */
  bool varies;                             /* the Earth of the scene */
  bool grain; /* a lobe is anisotropic, there are patches, or the Earth varies */
  struct um_optics_lobe_facets *facets; /* [nskin] of the lobe */
  struct um_vec3 *half;                 /* [nskin][rings][cells] behind facets */
  double *fresnel;                 /* [nskin][UM_OPTICS_FRESNEL_NODES][nbin] F at its nodes [1] */
  bool *has_lobe;                  /* [nskin][nband] F is not 0 in all of the band */
  struct um_optics_planck *planck; /* [nband] */
};

/* Skin of a surface, and material of a skin. */
static inline size_t um_optics_skin(const struct um_optics_spectra *spectra,
                                    const struct um_geometry_mesh *mesh, size_t surface)
{
  return spectra->creases != NULL ? spectra->creases->skin[surface]
                                  : mesh->surface[surface].material;
}
static inline size_t um_optics_material(const struct um_optics_spectra *spectra, size_t skin)
{
  return spectra->creases != NULL ? spectra->creases->material[skin] : skin;
}

/* Rows of F around cos_d, one behind the other, and their weights[4]. */
static inline const double *um_optics_fresnel_at(const struct um_optics_spectra *spectra,
                                                 size_t skin, double cos_d, double *weight)
{
  size_t first = skin * UM_OPTICS_FRESNEL_NODES + (size_t)um_optics_fresnel_weights(cos_d, weight);
  return spectra->fresnel + first * spectra->nbin;
}

/* Tables for the surfaces' temperatures of samples [first, first + count) of the scene. Refuses bad
 * bands, missing records and temperatures that are not positive and finite. */
enum um_status um_optics_spectra_create(struct um_context *context,
                                        const struct um_optics_scene *scene, size_t first,
                                        size_t count, const struct um_optics_band *bands,
                                        size_t nband, struct um_optics_spectra **out);
void um_optics_spectra_destroy(struct um_context *context, struct um_optics_spectra **spectra);
/* Spectra of the materials at an instant of the scene; create fills in those of `first`. */
void um_optics_spectra_materials(const struct um_context *context,
                                 const struct um_optics_scene *scene, size_t time,
                                 struct um_optics_spectra *spectra);
/* For surfaces that age: everything borrowed from `from` but the materials, whose tables are new
 * and empty. share_clear frees those, after a failure too. */
enum um_status um_optics_spectra_share(struct um_context *context,
                                       const struct um_optics_spectra *from,
                                       struct um_optics_spectra *to);
void um_optics_spectra_share_clear(struct um_context *context, struct um_optics_spectra *shared);

/* Black-body radiance per bin at a temperature [K]; row[nbin] [W/m^2/sr/m]. Relative error below
 * 5e-9. */
void um_optics_spectra_planck(const struct um_optics_spectra *spectra, double temperature,
                              double *row);
/* M per bin of a material that masks toward a cosine; fills `row`. */
void um_optics_spectra_masked(const struct um_optics_spectra *spectra, size_t skin, double cosine,
                              double *row);
/* Emissivity per bin of a material toward a cosine; a row of the table, or `row` filled. */
const double *um_optics_spectra_emissivity(const struct um_optics_spectra *spectra, size_t skin,
                                           double cosine, double *row);
/* The same before it is tilted. */
const double *um_optics_spectra_untilted(const struct um_optics_spectra *spectra, size_t skin,
                                         double cosine, double *row);

/* earth_rows.c: fills clear and cloud. UM_ERR_MEMORY. */
enum um_status um_optics_earth_ratios_create(struct um_context *context,
                                             struct um_optics_spectra *spectra);

/* planck.c */
/* Tables for temperatures from low to high [K]. UM_ERR_MEMORY. */
enum um_status um_optics_planck_create(struct um_context *context, double low, double high,
                                       struct um_optics_spectra *spectra);
/* Bin mean of B_lambda, evaluated [W/m^2/sr/m]. */
double um_optics_planck_mean(const struct um_optics_spectra *spectra, size_t bin,
                             double temperature);

/* sum_i w_i B(T_i): interpolation is linear in the rows of the tables, so that bodies add weights
 * of nodes and the rows are run through once for all of them. Empty when created and after _end. */
struct um_optics_planck_sum {
  double *weight;    /* of the nodes of all bands, one band after the other */
  size_t *low, *end; /* [nband] nodes with a weight, low to end - 1 */
  double *rest;      /* [nbin] of bodies that the tables do not hold */
  bool *has_rest;    /* [nband] */
};
enum um_status um_optics_planck_sum_create(struct um_context *context,
                                           const struct um_optics_spectra *spectra,
                                           struct um_optics_planck_sum *sum);
void um_optics_planck_sum_clear(struct um_context *context, struct um_optics_planck_sum *sum);
void um_optics_planck_sum_add(const struct um_optics_spectra *spectra, double temperature,
                              double weight, struct um_optics_planck_sum *sum);
/* The sum per bin, row[nbin] overwritten; relative error below 5e-9 where the weights have one
 * sign. */
void um_optics_planck_sum_end(const struct um_optics_spectra *spectra,
                              struct um_optics_planck_sum *sum, double *row);

#endif
