/* Private: the structs that a record's file is bound into. */
#ifndef UMBRA_MATERIALS_SCHEMA_IMPL_H
#define UMBRA_MATERIALS_SCHEMA_IMPL_H

#include "base/document/schema.h"
#include "materials/materials.h"

struct um_materials_band_input {
  struct um_mark at;
  double from_um, to_um; /* [um] */
  double value;          /* [1] */
};

struct um_materials_grey_input {
  struct um_mark at;
  double solar_absorptance, emittance, diffuse, specular, alpha, balance; /* [1] */
  struct um_schema_list bands; /* of struct um_materials_band_input */
};

struct um_materials_reflectance_input {
  struct um_mark at;
  struct um_schema_list wavelength_um, diffuse, specular; /* of double: [um], [1], [1] */
};

/* Substrate, sheet and layers. */
struct um_materials_constants_input {
  struct um_mark at;
  struct um_schema_list wavelength_um, n, k; /* of double: [um], [1], [1] */
  double thickness_um;                       /* [um] of sheet and layers */
  bool coherent;                             /* of a sheet: light interferes in it */
  int passes;                                /* of a layer: 1 interfere, 0 not, -1 by thickness */
};

struct um_materials_surface_input {
  struct um_mark at;
  double diffuse_fraction, absorption_factor, alpha; /* [1] */
  double rq_um, tau_um;                              /* [um] */
};

/* One of two lobes of a mixture. */
struct um_materials_mixed_input {
  struct um_mark at;
  int kind, masking;             /* as below; kind -1: not given */
  double share, alpha, exponent; /* [1] */
};

struct um_materials_lobe_input {
  struct um_mark at;
  struct um_schema_list of;         /* of struct um_materials_mixed_input */
  int kind;                         /* index of materials/lobes.def */
  int masking;                      /* 0 separable, 1 height-correlated; -1: not given */
  double alpha, alpha_across;       /* [1] */
  double exponent, exponent_across; /* [1] */
  const char *file;                 /* of kind measured */
  bool renormalise;
};

struct um_materials_by_temperature_input {
  struct um_mark at;
  struct um_schema_list temperature, specific_heat, conductivity; /* of double: [K], as below */
};

struct um_materials_thermal_input {
  struct um_mark at;
  double density;             /* [kg/m^3] */
  double specific_heat;       /* [J/kg/K] */
  double conductivity;        /* [W/m/K] */
  double thickness_mm;        /* [mm] */
  double areal_heat_capacity; /* [J/m^2/K] */
  struct um_materials_by_temperature_input *by_temperature;
  struct um_schema_list range; /* of double [K] */
};

struct um_materials_catalogue_input {
  struct um_mark at;
  double solar_absorptance, solar_absorptance_tolerance, emittance, emittance_tolerance; /* [1] */
  int kind; /* 0 hemispherical, 1 normal */
  const char *source;
};

/* One published change. */
struct um_materials_ageing_input {
  struct um_mark at;
  double absorptance, emittance; /* changes [1]; NaN: not published */
  const char *after, *source;
};

struct um_materials_input {
  struct um_mark at;
  const char *name, *summary, *citation;
  struct um_schema_list measured; /* of double: from, to [um] */
  struct um_materials_grey_input *grey;
  struct um_materials_reflectance_input *reflectance;
  struct um_materials_constants_input *substrate, *sheet;
  struct um_schema_list layers; /* of struct um_materials_constants_input, outermost first */
  struct um_materials_surface_input *surface;
  struct um_materials_lobe_input *lobe;
  struct um_materials_thermal_input *thermal;
  struct um_materials_catalogue_input *catalogue;
  struct um_schema_list ageing; /* of struct um_materials_ageing_input */
};

/* Check the description, set the record's lobe and build its spectral grid. UM_ERR_INPUT names
 * file, line and key; UM_ERR_MEMORY. */
struct um_materials_record;
enum um_status um_materials_reflectance_read(struct um_context *context,
                                             const struct um_materials_input *in,
                                             struct um_materials_record *record);
enum um_status um_materials_substrate_read(struct um_context *context,
                                           const struct um_materials_input *in,
                                           struct um_materials_record *record);

/* What both have in common: ascending wavelengths, one value for each, and the lobe of a spectral
 * record, `needed` when it has a specular part. UM_ERR_INPUT as above. */
enum um_status um_materials_check_wavelengths(struct um_context *context, const struct um_mark *at,
                                              const struct um_schema_list *wavelength);
enum um_status um_materials_check_length(struct um_context *context, const struct um_mark *at,
                                         const char *key, const struct um_schema_list *values,
                                         const struct um_schema_list *wavelength);
enum um_status um_materials_spectral_lobe_read(struct um_context *context,
                                               const struct um_materials_input *in, bool needed,
                                               struct um_materials_record *record);

/* lobe_read.c: the record's lobe, of a record with a specular part; stated: the roughness that keys
 * outside `lobe` give, NaN for none. UM_ERR_INPUT as above; UM_ERR_MEMORY. */
enum um_status um_materials_lobe_read(struct um_context *context,
                                      const struct um_materials_input *in, double stated,
                                      struct um_materials_record *record);

/* published.c: what a record says of its numbers: over which wavelengths they are measured, how the
 * surface ages. UM_ERR_INPUT as above; UM_ERR_MEMORY. */
enum um_status um_materials_published_read(struct um_context *context,
                                           const struct um_materials_sun *sun,
                                           const struct um_materials_input *in,
                                           struct um_materials_record *record);
void um_materials_published_free(struct um_materials_record *record);

/* bulk.c: the record's bulk properties. UM_ERR_INPUT as above; UM_ERR_MEMORY. */
enum um_status um_materials_bulk_read(struct um_context *context,
                                      const struct um_materials_thermal_input *in,
                                      struct um_materials_record *record);
void um_materials_bulk_free(struct um_materials_record *record);

#endif
