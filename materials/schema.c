/* The schema of a material record: which keys a file may hold (materials/library/README.md). */
#include <math.h>

#include "materials/schema_impl.h"

#define RATIO .minimum = 0.0, .maximum = 1.0

static const struct um_schema_field band_fields[] = {
    UM_FIELD(struct um_materials_band_input, from_um, "from_um", UM_SCHEMA_NUMBER, .required = true,
             .minimum = 0.0, .maximum = 1e6, .open_minimum = true, .help = "Start of the band."),
    UM_FIELD(struct um_materials_band_input, to_um, "to_um", UM_SCHEMA_NUMBER, .required = true,
             .minimum = 0.0, .maximum = 1e6, .open_minimum = true, .help = "End of the band."),
    UM_FIELD(struct um_materials_band_input, value, "value", UM_SCHEMA_NUMBER, .required = true,
             RATIO, .help = "Emissivity in the band."),
};
static const struct um_schema_object band_object = {
    .name = "emissivity band",
    .help = "Emissivity of a grey record between two wavelengths.",
    .size = sizeof(struct um_materials_band_input),
    .fields = band_fields,
    .nfield = UM_FIELD_COUNT(band_fields)};

static const struct um_schema_field grey_fields[] = {
    UM_FIELD(struct um_materials_grey_input, solar_absorptance, "solar_absorptance",
             UM_SCHEMA_NUMBER, .required = true, RATIO, .help = "Absorbed share of sunlight."),
    UM_FIELD(struct um_materials_grey_input, emittance, "emittance", UM_SCHEMA_NUMBER,
             .required = true, RATIO, .help = "Total hemispherical emittance."),
    UM_FIELD(struct um_materials_grey_input, bands, "band_emissivity", UM_SCHEMA_LIST,
             .object = &band_object, .help = "Emissivity in bands; elsewhere it is the emittance."),
    UM_FIELD(struct um_materials_grey_input, diffuse, "vis_reflectance_diffuse", UM_SCHEMA_NUMBER,
             RATIO, .default_value = NAN,
             .help = "Lambert reflectance below 2.5 um; default 1 - solar_absorptance - "
                     "specular_reflectance, not below 0."),
    UM_FIELD(struct um_materials_grey_input, specular, "specular_reflectance", UM_SCHEMA_NUMBER,
             RATIO, .default_value = 0.0,
             .help = "F of the lobe below 2.5 um, at every angle; from there on 1 - emissivity is "
                     "reflected evenly."),
    UM_FIELD(struct um_materials_grey_input, alpha, "beckmann_alpha", UM_SCHEMA_NUMBER,
             .minimum = 0.0, .maximum = 1.5, .open_minimum = true, .default_value = NAN,
             .help = "Roughness of the lobe; needed with specular_reflectance."),
    UM_FIELD(struct um_materials_grey_input, balance, "balance_tolerance", UM_SCHEMA_NUMBER, RATIO,
             .default_value = 0.02,
             .help =
                 "By how much solar_absorptance and the reflectances may miss 1 together before "
                 "it is said: they may hold for different parts of the spectrum; default 0.02."),
};
static const struct um_schema_object grey_object = {.name = "grey description",
                                                    .help = "Explicit numbers in place of spectra.",
                                                    .size = sizeof(struct um_materials_grey_input),
                                                    .fields = grey_fields,
                                                    .nfield = UM_FIELD_COUNT(grey_fields)};

#define WAVELENGTHS(structure)                                                                     \
  UM_FIELD(structure, wavelength_um, "wavelength_um", UM_SCHEMA_NUMBERS, .required = true,         \
           .minimum = 0.0, .maximum = 1e6, .open_minimum = true,                                   \
           .help = "Ascending; the first and last values hold outside, in light and in heat.")

static const struct um_schema_field reflectance_fields[] = {
    WAVELENGTHS(struct um_materials_reflectance_input),
    UM_FIELD(struct um_materials_reflectance_input, diffuse, "diffuse", UM_SCHEMA_NUMBERS,
             .required = true, RATIO, .help = "Lambert reflectance at each wavelength."),
    UM_FIELD(struct um_materials_reflectance_input, specular, "specular", UM_SCHEMA_NUMBERS, RATIO,
             .help =
                 "F of the lobe at each wavelength, at every angle, in light and in heat; default "
                 "0."),
};
static const struct um_schema_object reflectance_object = {
    .name = "reflectance table",
    .help = "Piecewise linear spectral reflectance.",
    .size = sizeof(struct um_materials_reflectance_input),
    .fields = reflectance_fields,
    .nfield = UM_FIELD_COUNT(reflectance_fields)};

#define CONSTANTS(structure)                                                                       \
  WAVELENGTHS(structure),                                                                          \
      UM_FIELD(structure, n, "n", UM_SCHEMA_NUMBERS, .required = true, .minimum = 0.0,             \
               .maximum = 1e4, .open_minimum = true,                                               \
               .help = "Refractive index at each wavelength; linear between."),                    \
      UM_FIELD(structure, k, "k", UM_SCHEMA_NUMBERS, .required = true, .minimum = 0.0,             \
               .maximum = 1e4,                                                                     \
               .help = "Extinction coefficient at each wavelength; linear in log k between.")

static const struct um_schema_field substrate_fields[] = {
    CONSTANTS(struct um_materials_constants_input)};
static const struct um_schema_object substrate_object = {
    .name = "substrate",
    .help = "Opaque body by its optical constants.",
    .size = sizeof(struct um_materials_constants_input),
    .fields = substrate_fields,
    .nfield = UM_FIELD_COUNT(substrate_fields)};

static const struct um_schema_field sheet_fields[] = {
    CONSTANTS(struct um_materials_constants_input),
    UM_FIELD(struct um_materials_constants_input, thickness_um, "thickness_um", UM_SCHEMA_NUMBER,
             .required = true, .minimum = 0.0, .maximum = 1e5, .open_minimum = true,
             .help =
                 "Thickness; unless coherent many coherence lengths, passes add as intensities."),
    UM_FIELD(struct um_materials_constants_input, coherent, "coherent", UM_SCHEMA_BOOL,
             .default_value = 0.0,
             .help = "A film of up to 5 um in which passes add as amplitudes: interference.")};
static const struct um_schema_object sheet_object = {
    .name = "sheet",
    .help = "Film or cover on the substrate.",
    .size = sizeof(struct um_materials_constants_input),
    .fields = sheet_fields,
    .nfield = UM_FIELD_COUNT(sheet_fields)};

static const char *const layer_passes[] = {"incoherent", "coherent", NULL};
static const struct um_schema_field layer_fields[] = {
    CONSTANTS(struct um_materials_constants_input),
    UM_FIELD(struct um_materials_constants_input, thickness_um, "thickness_um", UM_SCHEMA_NUMBER,
             .required = true, .minimum = 0.0, .maximum = 1e5, .open_minimum = true,
             .help = "Thickness."),
    UM_FIELD(struct um_materials_constants_input, passes, "passes", UM_SCHEMA_CHOICE,
             .choices = layer_passes, .default_value = NAN,
             .help = "Do passes interfere or add as intensities? Default coherent to 5 um, above "
                     "incoherent; films that lie on each other interfere together, to 5 um."),
};
static const struct um_schema_object layer_object = {
    .name = "layer",
    .help = "One of several films and covers on the substrate.",
    .size = sizeof(struct um_materials_constants_input),
    .fields = layer_fields,
    .nfield = UM_FIELD_COUNT(layer_fields)};

static const struct um_schema_field surface_fields[] = {
    UM_FIELD(struct um_materials_surface_input, diffuse_fraction, "diffuse_fraction",
             UM_SCHEMA_NUMBER, RATIO, .default_value = NAN,
             .help = "Share of the reflectance that is scattered (Lambert); default 0."),
    UM_FIELD(struct um_materials_surface_input, absorption_factor, "absorption_factor",
             UM_SCHEMA_NUMBER, .minimum = 0.0, .maximum = 100.0, .open_minimum = true,
             .default_value = NAN,
             .help = "Factor on 1 - reflectance at every wavelength and angle, for a finish that "
                     "absorbs more than the tabulated substance; default 1."),
    UM_FIELD(struct um_materials_surface_input, alpha, "beckmann_alpha", UM_SCHEMA_NUMBER,
             .minimum = 0.0, .maximum = 1.5, .open_minimum = true, .default_value = NAN,
             .alternative = 1, .help = "Roughness of the lobe."),
    UM_FIELD(struct um_materials_surface_input, rq_um, "rq_um", UM_SCHEMA_NUMBER, .minimum = 0.0,
             .maximum = 1e6, .open_minimum = true, .default_value = NAN, .alternative = 1,
             .help = "RMS height; with tau_um gives alpha = sqrt(2) Rq/tau."),
    UM_FIELD(struct um_materials_surface_input, tau_um, "tau_um", UM_SCHEMA_NUMBER, .minimum = 0.0,
             .maximum = 1e6, .open_minimum = true, .default_value = NAN,
             .help = "Correlation length of the height."),
};
static const struct um_schema_object surface_object = {
    .name = "surface",
    .help = "Roughness and scattering of a spectral record.",
    .size = sizeof(struct um_materials_surface_input),
    .fields = surface_fields,
    .nfield = UM_FIELD_COUNT(surface_fields)};

static const char *const lobe_kinds[] = {
#define UM_LOBE(name) #name,
#include "materials/lobes.def"
#undef UM_LOBE
    NULL};
static const char *const maskings[] = {"separable", "height_correlated", NULL};
static const struct um_schema_field mixed_fields[] = {
    UM_FIELD(struct um_materials_mixed_input, share, "share", UM_SCHEMA_NUMBER, .required = true,
             .minimum = 0.0, .maximum = 1.0, .open_minimum = true,
             .help = "Share of the specular part; both add up to 1."),
    UM_FIELD(struct um_materials_mixed_input, kind, "kind", UM_SCHEMA_CHOICE, .choices = lobe_kinds,
             .default_value = 0.0, .help = "As of a lobe, neither mirror nor mixture."),
    UM_FIELD(struct um_materials_mixed_input, masking, "masking", UM_SCHEMA_CHOICE,
             .choices = maskings, .default_value = NAN, .help = "As of a lobe."),
    UM_FIELD(struct um_materials_mixed_input, alpha, "alpha", UM_SCHEMA_NUMBER, .minimum = 0.0,
             .maximum = 1.5, .open_minimum = true, .default_value = NAN, .alternative = 1,
             .help = "Roughness."),
    UM_FIELD(struct um_materials_mixed_input, exponent, "exponent", UM_SCHEMA_NUMBER,
             .minimum = 1.0, .maximum = 1e8, .default_value = NAN, .alternative = 1,
             .help = "As of a lobe."),
};
static const struct um_schema_object mixed_object = {
    .name = "lobe of a mixture",
    .help = "One of the two lobes of kind mixture, alike all round.",
    .size = sizeof(struct um_materials_mixed_input),
    .fields = mixed_fields,
    .nfield = UM_FIELD_COUNT(mixed_fields),
    .scalar_key = NULL};

static const struct um_schema_field lobe_fields[] = {
    UM_FIELD(struct um_materials_lobe_input, kind, "kind", UM_SCHEMA_CHOICE, .choices = lobe_kinds,
             .default_value = 0.0,
             .help = "What spreads the specular part; default beckmann. Facets: beckmann, ggx."),
    UM_FIELD(struct um_materials_lobe_input, masking, "masking", UM_SCHEMA_CHOICE,
             .choices = maskings, .default_value = NAN,
             .help = "Smith's masking of facets toward both directions apart, or by their common "
                     "height; default separable."),
    UM_FIELD(struct um_materials_lobe_input, alpha, "alpha", UM_SCHEMA_NUMBER, .minimum = 0.0,
             .maximum = 1.5, .open_minimum = true, .default_value = NAN, .alternative = 1,
             .help = "Roughness, along the grain; in place of surface or grey.beckmann_alpha."),
    UM_FIELD(struct um_materials_lobe_input, exponent, "exponent", UM_SCHEMA_NUMBER, .minimum = 1.0,
             .maximum = 1e8, .default_value = NAN, .alternative = 1,
             .help = "Exponent of phong (1/(2 alpha^2)) or ashikhmin_shirley (2/alpha^2), in place "
                     "of alpha."),
    UM_FIELD(struct um_materials_lobe_input, alpha_across, "alpha_across", UM_SCHEMA_NUMBER,
             .minimum = 0.0, .maximum = 1.5, .open_minimum = true, .default_value = NAN,
             .alternative = 2,
             .help = "Roughness across the grain (a part's `grain`); default that along it."),
    UM_FIELD(struct um_materials_lobe_input, exponent_across, "exponent_across", UM_SCHEMA_NUMBER,
             .minimum = 1.0, .maximum = 1e8, .default_value = NAN, .alternative = 2,
             .help = "Exponent across the grain, of ashikhmin_shirley."),
    UM_FIELD(struct um_materials_lobe_input, of, "of", UM_SCHEMA_LIST, .object = &mixed_object,
             .help = "The two lobes of kind mixture."),
    UM_FIELD(struct um_materials_lobe_input, file, "file", UM_SCHEMA_TEXT, .file = true,
             .help = "Table of kind measured: CSV of incidence_deg, scattering_deg, azimuth_deg, "
                     "brdf_1_sr."),
    UM_FIELD(struct um_materials_lobe_input, renormalise, "renormalise", UM_SCHEMA_BOOL,
             .default_value = 0.0,
             .help = "Is a measured table that sends back more than arrives from a direction "
                     "brought to 1 there? Default false: it is said and kept."),
};
static const struct um_schema_object lobe_object = {
    .name = "lobe",
    .help = "How the specular part is spread about the mirror direction.",
    .size = sizeof(struct um_materials_lobe_input),
    .fields = lobe_fields,
    .nfield = UM_FIELD_COUNT(lobe_fields),
    .scalar_key = "kind"};

#define TABLE(member, key, text)                                                                   \
  UM_FIELD(struct um_materials_by_temperature_input, member, key, UM_SCHEMA_NUMBERS,               \
           .minimum = 0.0, .maximum = 1e9, .open_minimum = true, .help = text)
static const struct um_schema_field by_temperature_fields[] = {
    UM_FIELD(struct um_materials_by_temperature_input, temperature, "temperature_K",
             UM_SCHEMA_NUMBERS, .required = true, .minimum = 0.0, .maximum = 1e5,
             .help = "Temperatures, ascending."),
    TABLE(specific_heat, "specific_heat_J_kg_K", "Specific heat at each of them; linear between."),
    TABLE(conductivity, "conductivity_W_m_K", "Conductivity at each of them; linear between."),
};
static const struct um_schema_object by_temperature_object = {
    .name = "properties by temperature",
    .help = "Tables that count by their ratio to their own value at 300 K, where the record's "
            "numbers hold; constant beyond their ends.",
    .size = sizeof(struct um_materials_by_temperature_input),
    .fields = by_temperature_fields,
    .nfield = UM_FIELD_COUNT(by_temperature_fields)};

#define THERMAL(member, key, text)                                                                 \
  UM_FIELD(struct um_materials_thermal_input, member, key, UM_SCHEMA_NUMBER, .minimum = 0.0,       \
           .maximum = 1e9, .open_minimum = true, .default_value = NAN, .help = text)
static const struct um_schema_field thermal_fields[] = {
    THERMAL(density, "density_kg_m3", "Density."),
    THERMAL(specific_heat, "specific_heat_J_kg_K", "Specific heat."),
    THERMAL(conductivity, "conductivity_W_m_K", "Conductivity (in the plane of a sheet)."),
    THERMAL(thickness_mm, "thickness_mm", "Thickness as built, for sheets and cells."),
    THERMAL(areal_heat_capacity, "areal_heat_capacity_J_m2_K",
            "Heat capacity per area; default density * specific heat * thickness."),
    UM_FIELD(struct um_materials_thermal_input, range, "temperature_range_K", UM_SCHEMA_NUMBERS,
             .minimum = 0.0, .maximum = 1e5,
             .help =
                 "[coldest, hottest] between which the record holds; a run that leaves it warns, "
                 "or fails where the scenario says so."),
    UM_FIELD(struct um_materials_thermal_input, by_temperature, "by_temperature", UM_SCHEMA_MAP,
             .object = &by_temperature_object,
             .help = "Specific heat and conductivity at other temperatures than 300 K."),
};
static const struct um_schema_object thermal_object = {
    .name = "thermal properties",
    .help = "Bulk properties.",
    .size = sizeof(struct um_materials_thermal_input),
    .fields = thermal_fields,
    .nfield = UM_FIELD_COUNT(thermal_fields)};

#define CATALOGUE(member, key, text)                                                               \
  UM_FIELD(struct um_materials_catalogue_input, member, key, UM_SCHEMA_NUMBER, .required = true,   \
           RATIO, .help = text)
static const char *const emittance_kinds[] = {"hemispherical", "normal", NULL};
static const struct um_schema_field catalogue_fields[] = {
    CATALOGUE(solar_absorptance, "solar_absorptance", "Published solar absorptance."),
    CATALOGUE(solar_absorptance_tolerance, "solar_absorptance_tolerance", "Its uncertainty."),
    CATALOGUE(emittance, "emittance", "Published emittance near 300 K."),
    CATALOGUE(emittance_tolerance, "emittance_tolerance", "Its uncertainty."),
    UM_FIELD(struct um_materials_catalogue_input, kind, "emittance_kind", UM_SCHEMA_CHOICE,
             .choices = emittance_kinds, .default_value = 0.0,
             .help = "What the published emittance is; default hemispherical."),
    UM_FIELD(struct um_materials_catalogue_input, source, "source", UM_SCHEMA_TEXT,
             .required = true, .help = "Where the two numbers come from."),
};
static const struct um_schema_object catalogue_object = {
    .name = "catalogue values",
    .help = "Published integrals that the record is held against when it is loaded.",
    .size = sizeof(struct um_materials_catalogue_input),
    .fields = catalogue_fields,
    .nfield = UM_FIELD_COUNT(catalogue_fields)};

#define PART(member, key, part, text, ...)                                                         \
  UM_FIELD(struct um_materials_input, member, key, UM_SCHEMA_MAP, .object = &part, .help = text,   \
           __VA_ARGS__)
static const struct um_schema_field record_fields[] = {
    UM_FIELD(struct um_materials_input, name, "name", UM_SCHEMA_TEXT, .name = true,
             .required = true, .help = "Name that scenarios use: letters, digits, _ and -."),
    UM_FIELD(struct um_materials_input, summary, "summary", UM_SCHEMA_TEXT, .required = true,
             .help = "One line."),
    UM_FIELD(struct um_materials_input, citation, "citation", UM_SCHEMA_TEXT, .required = true,
             .help = "Where the numbers come from, and what was assumed."),
    PART(grey, "grey", grey_object, "Explicit numbers.", .alternative = 1),
    PART(reflectance, "reflectance", reflectance_object, "Reflectance table.", .alternative = 1),
    PART(substrate, "substrate", substrate_object, "Optical constants.", .alternative = 1),
    PART(sheet, "sheet", sheet_object, "Film or cover on the substrate.", .alternative = 0),
    UM_FIELD(struct um_materials_input, layers, "layers", UM_SCHEMA_LIST, .object = &layer_object,
             .help = "Films and covers on the substrate, outermost first, in place of sheet."),
    PART(surface, "surface", surface_object, "Roughness and scattering.", .alternative = 0),
    PART(lobe, "lobe", lobe_object, "Spread of the specular part.", .alternative = 0),
    PART(thermal, "thermal", thermal_object, "Bulk properties.", .alternative = 0),
    PART(catalogue, "catalogue", catalogue_object, "Published integrals.", .alternative = 0),
};
static const int one_description[] = {1, 0};
static const struct um_schema_object record_object = {
    .name = "material",
    .help = "One surface for both halves: what the renderer reflects, the thermal solver absorbs.",
    .size = sizeof(struct um_materials_input),
    .fields = record_fields,
    .nfield = UM_FIELD_COUNT(record_fields),
    .exactly_one = one_description};

const struct um_schema_object *um_materials_schema(void) { return &record_object; }
