/* One material record serves both halves: what the renderer reflects, the thermal solver absorbs.
 */
#ifndef UMBRA_MATERIALS_MATERIALS_H
#define UMBRA_MATERIALS_MATERIALS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

struct um_materials_lobe;    /* materials/lobe.h */
struct um_materials_record;  /* opaque, immutable after loading */
struct um_materials_library; /* named records */
struct um_schema_object;

/* Changes of the lobe alone; all zero: none. */
struct um_materials_lobe_adjustment {
  double
      slope_variance; /* mean square slope per axis that creases add to the lobe's facets, alpha^2
                         + 2 s^2 [1] */
  double log_across;  /* ln of the factor of alpha_across, of kinds that may be anisotropic [1] */
};

/* Changes that effects make to a record's optics; all null values leave it bit-identical. Those
 * that change absorption or emission keep reflectance + emissivity = 1 for spectral records;
 * diffuse_scale, specular_scale, roughness_scale and those of the lobe act on what is reflected
 * only, not on absorptance, emittance or emissivity. */
struct um_materials_adjustment {
  double absorptance_shift; /* added to solar absorptance; diffuse reflectance below 2.5 um falls
                               alike; null 0 [1] */
  double emittance_scale;   /* of emittance and spectral emissivity above 2.5 um; null 1 [1] */
  double band_emissivity_scale; /* of spectral emissivity above 2.5 um alone (not of the total);
                                   null 1 [1] */
  double roughness_scale;       /* of the lobe's alpha; null 1 [1] */
  double specular_scale;        /* of F; null 1 [1] */
  double diffuse_scale;   /* of the diffuse reflectance below 2.5 um, optics only; null 1 [1] */
  double emissivity_tilt; /* d: emissivity above 2.5 um + d eps_h (1 - 21 (1 - cos)^5) / 20, the
                             hemispherical value eps_h stays; 1 turns a diffuse emitter into a
                             dielectric after Schlick, below 0 it rises to grazing; null 0 [1] */
  struct um_materials_lobe_adjustment lobe;
  double thickness_scale; /* of the layers on a record's substrate, 0 takes them off; null 1. It
                             acts through um_materials_library_thickened, no look-up reads it [1] */
};
extern const struct um_materials_adjustment um_materials_no_adjustment;

/* The Sun that absorptances are taken over: shares of its energy, of sum 1, at wavelengths. It is
 * `environment` that has one (um_environment_sun_shares). */
#define UM_MATERIALS_SUN 2000
struct um_materials_sun {
  double wavelength[UM_MATERIALS_SUN]; /* [m] ascending */
  double share[UM_MATERIALS_SUN];      /* [1] */
  bool measured; /* a measured spectrum, which published absorptances refer to: records that quote
                    one are held against it */
};

/* Library: read every *.yaml of a folder (the product's own), then files of the scenario, which may
 * add or replace names. UM_ERR_INPUT with file and line. */
enum um_status um_materials_library_create(struct um_context *context,
                                           const struct um_materials_sun *sun, /* copied */
                                           struct um_materials_library **out);
void um_materials_library_destroy(struct um_materials_library **library);
/* Was it made for this Sun, number for number? */
bool um_materials_library_is_of(const struct um_materials_library *library,
                                const struct um_materials_sun *sun);
enum um_status um_materials_library_read_folder(struct um_context *context,
                                                struct um_materials_library *library,
                                                const char *folder);
/* Offer the records of a folder, of which none is read until it is wanted. UM_ERR_IO: there is no
 * such folder. */
enum um_status um_materials_library_offer_folder(struct um_context *context,
                                                 struct um_materials_library *library,
                                                 const char *folder);
/* The record of that name, read where it is offered in a file of that name, else from whichever
 * offered file holds it, which all of them are then read for; *out NULL: there is none. Errors as
 * of reading. */
enum um_status um_materials_library_want(struct um_context *context,
                                         struct um_materials_library *library, const char *name,
                                         const struct um_materials_record **out);
enum um_status um_materials_library_read_file(struct um_context *context,
                                              struct um_materials_library *library,
                                              const char *path, const char *const *overrides,
                                              size_t noverride);
/* The product's own folder, um_core_data_folder(context, "materials", out). The caller frees. */
enum um_status um_materials_library_folder(struct um_context *context, char **out);
/* The keys of a record's file, for the reference page and the JSON Schema. */
const struct um_schema_object *um_materials_schema(void);
size_t um_materials_library_count(const struct um_materials_library *library);
const struct um_materials_record *
um_materials_library_at(const struct um_materials_library *library, size_t index);
/* NULL when there is none. */
const struct um_materials_record *
um_materials_library_find(const struct um_materials_library *library, const char *name);
/* One line naming the nearest names, for messages; writes into out. */
void um_materials_library_suggest(const struct um_materials_library *library, const char *name,
                                  char *out, size_t size);

/* Unpolarised reflectance by its optical constants alone, at a cosine, without what it scatters and
 * without its absorption_factor; NaN for a record without constants. */
double um_materials_interface_reflectance(const struct um_materials_record *record,
                                          double wavelength, double cosine);
/* Wavelengths that its tables of constants cover together [m]; NaN for a record without any. */
void um_materials_constants_range(const struct um_materials_record *record, double *from,
                                  double *to);
/* Has it layers on a substrate (keys sheet, layers)? */
bool um_materials_has_layers(const struct um_materials_record *record);
/* A record of the library as it is with its layers `factor` times as thick, 0: bare. It borrows
 * from the record and must go before it, by um_materials_record_destroy, as no record of a library
 * is destroyed. The record must have layers. UM_ERR_MEMORY. */
enum um_status um_materials_library_thickened(struct um_context *context,
                                              const struct um_materials_library *library,
                                              const struct um_materials_record *record,
                                              double factor, struct um_materials_record **out);
/* NULL and a pointer to it are accepted. */
void um_materials_record_destroy(struct um_materials_record **record);

const char *um_materials_name(const struct um_materials_record *record);
const char *um_materials_summary(const struct um_materials_record *record);
const char *um_materials_citation(const struct um_materials_record *record);
bool um_materials_is_grey(const struct um_materials_record *record);

/* --- optics; wavelength [m], cosines of angles from the normal; adjustment NULL for none -------
 * f_r(i, o, lambda) = R/pi + M(i) M(o)/(pi <M>) + F(cos_d, lambda) f(i, o)
 * with f the record's lobe (lobe.h; by default Cook-Torrance with Beckmann's facets,
 * docs/physics/roughness-and-lobes.md), R the Lambert part and M what the masking of the lobe keeps
 * back, so that f_r integrates to 1 - emissivity in every direction; a grey record's numbers are
 * taken as given: its M is 0, its lobe exists below 2.5 um only. Spectral look-ups are tabulated:
 * about 20 ns each. */
/* rho_d = R + <M>: what is scattered of light from all sides. */
double um_materials_diffuse_reflectance(const struct um_materials_record *record,
                                        const struct um_materials_adjustment *adjustment,
                                        double wavelength);
/* M at the cosine of an angle, and <M>, its hemispherical mean. */
double um_materials_masked_reflectance(const struct um_materials_record *record,
                                       const struct um_materials_adjustment *adjustment,
                                       double wavelength, double cosine);
double um_materials_masked_mean(const struct um_materials_record *record,
                                const struct um_materials_adjustment *adjustment,
                                double wavelength);
/* F(cos_h): Fresnel or constant specular reflectance of the lobe; 0 for a record without a lobe. */
double um_materials_specular_reflectance(const struct um_materials_record *record,
                                         const struct um_materials_adjustment *adjustment,
                                         double wavelength, double cos_h);
bool um_materials_has_lobe(const struct um_materials_record *record);
/* The lobe, of kind NULL where there is none. */
struct um_materials_lobe um_materials_lobe(const struct um_materials_record *record,
                                           const struct um_materials_adjustment *adjustment);
/* Its alpha along the grain [1], = sqrt(2) Rq/tau where the record gives Rq and tau; 0 where it has
 * none. */
double um_materials_roughness(const struct um_materials_record *record,
                              const struct um_materials_adjustment *adjustment);
/* Directional spectral emissivity, Kirchhoff: 1 - described Lambert part - F averaged over the
 * facets that the lobe uses at cos_o (what masking keeps back is no absorption), >= 0;
 * grey records: their band emissivity where a band covers the wavelength, else emittance. */
double um_materials_emissivity(const struct um_materials_record *record,
                               const struct um_materials_adjustment *adjustment, double wavelength,
                               double cos_o);
/* Of its tilt: d eps_h at a wavelength, 0 below 2.5 um; and an emissivity so tilted, 0 to 1. */
double um_materials_emissivity_tilt(const struct um_materials_record *record,
                                    const struct um_materials_adjustment *adjustment,
                                    double wavelength);
double um_materials_emissivity_tilted(double emissivity, double tilt, double cos_o);
/* True when the emissivity does not depend on cos_o. */
bool um_materials_emissivity_is_diffuse(const struct um_materials_record *record,
                                        const struct um_materials_adjustment *adjustment);
/* Hemispherical-hemispherical reflectance at a wavelength = 1 - hemispherical emissivity (below
 * 2.5 um a grey record's explicit reflectances). */
double um_materials_hemispherical_reflectance(const struct um_materials_record *record,
                                              const struct um_materials_adjustment *adjustment,
                                              double wavelength);

/* --- integrals for the thermal half --------------------------------------------------------- */
/* Solar absorptance at normal incidence, over the library's Sun; explicit for a grey record. */
double um_materials_solar_absorptance(const struct um_materials_record *record,
                                      const struct um_materials_adjustment *adjustment);
/* The same at a cosine of the angle of incidence, and of what comes from all sides alike. */
double um_materials_solar_absorptance_toward(const struct um_materials_record *record,
                                             const struct um_materials_adjustment *adjustment,
                                             double cosine);
double um_materials_solar_absorptance_diffuse(const struct um_materials_record *record,
                                              const struct um_materials_adjustment *adjustment);
/* Hemispherical total emittance at a temperature [K]; explicit for a grey record. */
double um_materials_emittance(const struct um_materials_record *record,
                              const struct um_materials_adjustment *adjustment, double temperature);
/* Normal total emittance at a temperature [K]. */
double um_materials_normal_emittance(const struct um_materials_record *record,
                                     const struct um_materials_adjustment *adjustment,
                                     double temperature);
/* Directional total emittance at a temperature [K], at n > 1 angles evenly in the square root of
 * the cosine, from grazing to normal: out[n]; 2 int of it cos dcos is um_materials_emittance to
 * 1e-4 unless a tilt meets the bounds 0 and 1. One for all angles of a grey record that nothing
 * tilts. Test: materials/integrals. */
void um_materials_emittance_by_angle(const struct um_materials_record *record,
                                     const struct um_materials_adjustment *adjustment,
                                     double temperature, size_t n, double *out);
/* Shares of what a record reflects that go in a lobe narrow enough (Beckmann alpha at most 0.1, see
 * mirror.c) to be taken as a mirror's where surfaces exchange heat; 0 for others. Adjustments do
 * not change them: they act on absorptance and emittance, which leave the rest to be shared. Test:
 * materials/mirror. */
struct um_materials_mirror {
  double solar;    /* of reflected sunlight [1] */
  double infrared; /* of reflected infrared [1] */
};
struct um_materials_mirror um_materials_mirror(const struct um_materials_record *record);
/* The same of a record's surface that is creased, s^2 per axis [1]: nothing once alpha^2 + 2 s^2 is
 * wider than that. */
struct um_materials_mirror um_materials_mirror_creased(const struct um_materials_record *record,
                                                       double slope_variance);
/* Catalogue values that the record quotes, NaN where none: value and its stated uncertainty. */
struct um_materials_catalogue {
  double solar_absorptance, solar_absorptance_tolerance, emittance, emittance_tolerance; /* [1] */
  const char *source;
  bool emittance_is_normal; /* compare with um_materials_normal_emittance, not the hemispherical */
};
struct um_materials_catalogue um_materials_catalogue(const struct um_materials_record *record);

/* Wavelengths between which the optical numbers of a record are measured [m], NaN where it claims
 * no measurement, and the shares that lie outside [1]: of sunlight, and of the radiation of a black
 * body at UM_REFERENCE_TEMPERATURE. */
struct um_materials_measured_range {
  double from, to, solar_outside, heat_outside;
};
struct um_materials_measured_range
um_materials_measured_range(const struct um_materials_record *record);
/* Published changes of a surface by ageing, in the order of the record; nothing but effects applies
 * them. */
struct um_materials_ageing {
  const char *after;                   /* what the surface went through */
  double solar_absorptance, emittance; /* changes [1]; NaN: not published */
  const char *source;
};
size_t um_materials_ageing_count(const struct um_materials_record *record);
struct um_materials_ageing um_materials_ageing_at(const struct um_materials_record *record,
                                                  size_t index);

/* Bulk properties; NaN where the record has none. */
struct um_materials_bulk {
  double density;             /* [kg/m^3] */
  double specific_heat;       /* [J/kg/K] */
  double conductivity;        /* [W/m/K] */
  double thickness;           /* [m] of the sheet, film or cell as built, where it has one */
  double areal_heat_capacity; /* [J/m^2/K], explicit or density * specific_heat * thickness */
  double coldest, hottest;    /* [K] between which the record holds */
};
struct um_materials_bulk um_materials_bulk(const struct um_materials_record *record);
/* What goes with temperature: ratio to the value at 300 K [1], at a temperature [K]; 1 where the
 * record has no table. */
enum um_materials_bulk_property { UM_BULK_SPECIFIC_HEAT, UM_BULK_CONDUCTIVITY };
bool um_materials_bulk_varies(const struct um_materials_record *record,
                              enum um_materials_bulk_property property);
double um_materials_bulk_ratio(const struct um_materials_record *record,
                               enum um_materials_bulk_property property, double temperature);

#endif
