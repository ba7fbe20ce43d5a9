/* Private: a material record in memory, its spectral grid, and how one is built. */
#ifndef UMBRA_MATERIALS_RECORD_IMPL_H
#define UMBRA_MATERIALS_RECORD_IMPL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"
#include "materials/bsdf.h"
#include "materials/cosines_impl.h"
#include "materials/lobe.h"
#include "materials/materials.h"

#define UM_MATERIALS_BUCKETS      1024   /* of the wavelength index, uniform in log */
#define UM_MATERIALS_TEMPERATURES 49     /* nodes of the emittance tables, uniform in log T */
#define UM_MATERIALS_INCIDENCES   25     /* nodes of the solar absorptance, cos = u^2, u uniform */
#define UM_MATERIALS_SCALES       25     /* of roughness that albedos of lobes are tabulated at */
#define UM_MATERIALS_COLDEST      40.0   /* [K] first node; constant below */
#define UM_MATERIALS_HOTTEST      1280.0 /* [K] last node; constant above */

struct um_materials_band {
  double from, to;   /* [m] */
  double emissivity; /* [1] */
};

/* Explicit numbers of a grey record. */
struct um_materials_grey {
  double solar_absorptance, emittance; /* [1] */
  double diffuse, specular;            /* reflectances below 2.5 um [1] */
  struct um_materials_band *bands;     /* [nband] ascending, without overlap */
  size_t nband;
};

/* Reflectance on a grid; linear in wavelength, cubic in u = sqrt(cos); constant outside. */
struct um_materials_spectrum {
  size_t n, ncos;      /* ncos: 1 (no angular dependence) or UM_MATERIALS_COSINES */
  double *wavelength;  /* [n] [m] ascending */
  double *diffuse;     /* [n] Lambert part as described */
  double *masked_mean; /* [n] what the lobe's masking keeps back, hemispherical mean */
  double *facet;       /* [n][ncos] F(cos_h) */
  double *lobe;        /* [n][ncos] F averaged over the facets seen at cos_o */
  double *lobe_mean;   /* [n] hemispherical mean of `lobe` */
  uint32_t bucket[UM_MATERIALS_BUCKETS]; /* interval that holds each bucket's lower edge */
  double log_first, buckets_per_log;
};

/* A property at temperatures; n 0: none. */
struct um_materials_table {
  double *temperature, *value; /* [n] [K] ascending, [its unit] */
  size_t n;
};

/* Optical constants as the file has them, and of layers their thickness. */
struct um_materials_constants {
  double *wavelength_um, *n, *k; /* [count] [um], [1], [1] */
  size_t count;
  double thickness; /* [m] */
  bool coherent;    /* light interferes in it */
};

/* What a spectral record of optical constants is made of. */
struct um_materials_layers {
  struct um_materials_constants substrate, layer[UM_MATERIALS_LAYERS]; /* outermost first */
  size_t count;
  double diffuse_fraction, absorption_factor; /* [1] */
};

struct um_materials_record {
  struct um_context *context;
  bool borrows; /* all but the spectrum and the struct itself is another record's */
  char *name, *summary, *citation, *source;
  bool grey;
  struct um_materials_lobe lobe;       /* kind NULL: none */
  struct um_materials_mixture mixture; /* of a lobe of that kind */
  double *albedo; /* [UM_MATERIALS_SCALES][UM_MATERIALS_COSINES] of the lobe; NULL where
                     um_materials_lobe_albedo has a table of its own */
  struct um_materials_measured *measured; /* of a lobe of that kind; NULL of others */
  struct um_materials_catalogue catalogue;
  struct um_materials_measured_range measured_range;
  struct um_materials_ageing *ageing; /* [nageing] */
  size_t nageing;
  struct um_materials_bulk bulk;
  struct um_materials_table specific_heat, conductivity;            /* [J/kg/K], [W/m/K] */
  struct um_materials_grey explicit_values;                         /* of a grey record */
  struct um_materials_spectrum spectrum;                            /* of the others */
  struct um_materials_layers *layers;                               /* NULL: no constants */
  double solar_absorptance;                                         /* normal incidence */
  double absorptance[UM_MATERIALS_INCIDENCES], diffuse_absorptance; /* by angle; from all sides */
  double emittance[UM_MATERIALS_TEMPERATURES], normal_emittance[UM_MATERIALS_TEMPERATURES];
  struct um_materials_mirror mirror;
};

/* Reflectance R [1] of the surface at a wavelength [m] and cosine, split into what is scattered
 * (Lambert; for a table) or left to be split by `diffuse_fraction` (NaN: use `diffuse`). */
struct um_materials_law {
  const double *nodes; /* [nnode] wavelengths that must be on the grid [m], ascending */
  size_t nnode;
  double first, last;       /* [m] the grid covers at least this range */
  double fringes;           /* optical thickness n d of what interferes [m]; 0: nothing does */
  bool angular;             /* R depends on the angle */
  double diffuse_fraction;  /* of the reflectance that is scattered; angular laws */
  double absorption_factor; /* of 1 - R; angular laws */
  void *self;
  /* angular: reflectance at (wavelength, cos); else: specular, and the diffuse part in *diffuse */
  double (*reflectance)(void *self, double wavelength, double cos_theta, double *diffuse);
};

/* Fill record->spectrum from a law; record->lobe is set before. UM_ERR_MEMORY. */
enum um_status um_materials_spectrum_build(struct um_context *context,
                                           struct um_materials_record *record,
                                           const struct um_materials_law *law);
void um_materials_spectrum_free(struct um_context *context, struct um_materials_spectrum *spectrum);
/* Interval and fraction of a wavelength, clamped to the grid. */
size_t um_materials_spectrum_locate(const struct um_materials_spectrum *spectrum, double wavelength,
                                    double *fraction);
/* Angular table [n][ncos] at interval i, fraction t, cosine. */
double um_materials_spectrum_angular(const struct um_materials_spectrum *spectrum,
                                     const double *table, size_t i, double t, double cosine);

void um_materials_layers_free(struct um_context *context, struct um_materials_layers **layers);

/* Fill record->albedo, where its lobe needs it. UM_ERR_MEMORY. */
enum um_status um_materials_albedo_build(struct um_context *context,
                                         struct um_materials_record *record);
/* Directional albedo of a record's lobe, with F = 1, toward a cosine. */
double um_materials_albedo(const struct um_materials_record *record,
                           const struct um_materials_lobe *lobe, double cosine);

/* Fill solar_absorptance and the emittance tables from the optics. */
void um_materials_integrals_build(const struct um_materials_sun *sun,
                                  struct um_materials_record *record);

/* Fill mirror from the optics. */
void um_materials_mirror_build(const struct um_materials_sun *sun,
                               struct um_materials_record *record);

/* Read one file into a new record; the caller destroys (um_materials_record_destroy). */
enum um_status um_materials_record_read(struct um_context *context,
                                        const struct um_materials_sun *sun, const char *path,
                                        const char *const *overrides, size_t noverride,
                                        struct um_materials_record **out);

/* The record with its layers `factor` times as thick, 0: without them; all else is borrowed. */
enum um_status um_materials_record_thickened(struct um_context *context,
                                             const struct um_materials_sun *sun,
                                             const struct um_materials_record *record,
                                             double factor, struct um_materials_record **out);

#endif
