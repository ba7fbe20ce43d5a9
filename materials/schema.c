/* The schema of a material record: which keys a file may hold (materials/library/README.md). */
#include "base/document/schema_words.h"
#include "materials/schema_impl.h"

#define RATIO BETWEEN(0.0, 1.0)

#define OF struct um_materials_band_input
static const struct um_schema_field band_fields[] = {
    F(from_um, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e6), HELP("Start of the band.")),
    F(to_um, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e6), HELP("End of the band.")),
    F(value, UM_SCHEMA_NUMBER, REQUIRED, RATIO, HELP("Emissivity in the band.")),
};
#undef OF
OBJECT(band_object, struct um_materials_band_input, "emissivity band",
       "Emissivity of a grey record between two wavelengths.", FIELDS(band_fields));

#define OF struct um_materials_grey_input
static const struct um_schema_field grey_fields[] = {
    F(solar_absorptance, UM_SCHEMA_NUMBER, REQUIRED, RATIO, HELP("Absorbed share of sunlight.")),
    F(emittance, UM_SCHEMA_NUMBER, REQUIRED, RATIO, HELP("Total hemispherical emittance.")),
    F_AS(bands, "band_emissivity", UM_SCHEMA_LIST, .object = &band_object,
         HELP("Emissivity in bands; elsewhere it is the emittance.")),
    F_AS(diffuse, "vis_reflectance_diffuse", UM_SCHEMA_NUMBER, RATIO, NO_DEFAULT,
         HELP("Lambert reflectance below 2.5 um; default 1 - solar_absorptance - "
              "specular_reflectance, not below 0.")),
    F_AS(specular, "specular_reflectance", UM_SCHEMA_NUMBER, RATIO, DEFAULT(0.0),
         HELP("F of the lobe below 2.5 um, at every angle; from there on 1 - emissivity is "
              "reflected evenly.")),
    F_AS(alpha, "beckmann_alpha", UM_SCHEMA_NUMBER, POSITIVE(1.5), NO_DEFAULT,
         HELP("Roughness of the lobe; needed with specular_reflectance.")),
    F_AS(balance, "balance_tolerance", UM_SCHEMA_NUMBER, RATIO, DEFAULT(0.02),
         HELP("By how much solar_absorptance and the reflectances may miss 1 together before "
              "it is said: they may hold for different parts of the spectrum; default 0.02.")),
};
#undef OF
OBJECT(grey_object, struct um_materials_grey_input, "grey description",
       "Explicit numbers in place of spectra.", FIELDS(grey_fields));

#define WAVELENGTHS                                                                                \
  F(wavelength_um, UM_SCHEMA_NUMBERS, REQUIRED, POSITIVE(1e6),                                     \
    HELP("Ascending; the first and last values hold outside, in light and in heat."))

#define OF struct um_materials_reflectance_input
static const struct um_schema_field reflectance_fields[] = {
    WAVELENGTHS,
    F(diffuse, UM_SCHEMA_NUMBERS, REQUIRED, RATIO, HELP("Lambert reflectance at each wavelength.")),
    F(specular, UM_SCHEMA_NUMBERS, RATIO,
      HELP("F of the lobe at each wavelength, at every angle, in light and in heat; default "
           "0.")),
};
#undef OF
OBJECT(reflectance_object, struct um_materials_reflectance_input, "reflectance table",
       "Piecewise linear spectral reflectance.", FIELDS(reflectance_fields));

#define CONSTANTS                                                                                  \
  WAVELENGTHS,                                                                                     \
      F(n, UM_SCHEMA_NUMBERS, REQUIRED, POSITIVE(1e4),                                             \
        HELP("Refractive index at each wavelength; linear between.")),                             \
      F(k, UM_SCHEMA_NUMBERS, REQUIRED, BETWEEN(0.0, 1e4),                                         \
        HELP("Extinction coefficient at each wavelength; linear in log k between."))

#define OF struct um_materials_constants_input
static const struct um_schema_field substrate_fields[] = {CONSTANTS};
#undef OF
OBJECT(substrate_object, struct um_materials_constants_input, "substrate",
       "Opaque body by its optical constants.", FIELDS(substrate_fields));

#define OF struct um_materials_constants_input
static const struct um_schema_field sheet_fields[] = {
    CONSTANTS,
    F(thickness_um, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e5),
      HELP("Thickness; unless coherent many coherence lengths, passes add as intensities.")),
    F(coherent, UM_SCHEMA_BOOL, DEFAULT(0.0),
      HELP("A film of up to 5 um in which passes add as amplitudes: interference."))};
#undef OF
OBJECT(sheet_object, struct um_materials_constants_input, "sheet",
       "Film or cover on the substrate.", FIELDS(sheet_fields));

static const char *const layer_passes[] = {"incoherent", "coherent", NULL};
#define OF struct um_materials_constants_input
static const struct um_schema_field layer_fields[] = {
    CONSTANTS,
    F(thickness_um, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1e5), HELP("Thickness.")),
    F(passes, UM_SCHEMA_CHOICE, .choices = layer_passes, NO_DEFAULT,
      HELP("Do passes interfere or add as intensities? Default coherent to 5 um, above "
           "incoherent; films that lie on each other interfere together, to 5 um.")),
};
#undef OF
OBJECT(layer_object, struct um_materials_constants_input, "layer",
       "One of several films and covers on the substrate.", FIELDS(layer_fields));

#define OF struct um_materials_surface_input
static const struct um_schema_field surface_fields[] = {
    F(diffuse_fraction, UM_SCHEMA_NUMBER, RATIO, NO_DEFAULT,
      HELP("Share of the reflectance that is scattered (Lambert); default 0.")),
    F(absorption_factor, UM_SCHEMA_NUMBER, POSITIVE(100.0), NO_DEFAULT,
      HELP("Factor on 1 - reflectance at every wavelength and angle, for a finish that "
           "absorbs more than the tabulated substance; default 1.")),
    F_AS(alpha, "beckmann_alpha", UM_SCHEMA_NUMBER, POSITIVE(1.5), NO_DEFAULT, .alternative = 1,
         HELP("Roughness of the lobe.")),
    F(rq_um, UM_SCHEMA_NUMBER, POSITIVE(1e6), NO_DEFAULT, .alternative = 1,
      HELP("RMS height; with tau_um gives alpha = sqrt(2) Rq/tau.")),
    F(tau_um, UM_SCHEMA_NUMBER, POSITIVE(1e6), NO_DEFAULT,
      HELP("Correlation length of the height.")),
};
#undef OF
OBJECT(surface_object, struct um_materials_surface_input, "surface",
       "Roughness and scattering of a spectral record.", FIELDS(surface_fields));

static const char *const lobe_kinds[] = {
#define UM_LOBE(name) #name,
#include "materials/lobes.def"
#undef UM_LOBE
    NULL};
static const char *const maskings[] = {"separable", "height_correlated", NULL};
#define OF struct um_materials_mixed_input
static const struct um_schema_field mixed_fields[] = {
    F(share, UM_SCHEMA_NUMBER, REQUIRED, POSITIVE(1.0),
      HELP("Share of the specular part; both add up to 1.")),
    F(kind, UM_SCHEMA_CHOICE, .choices = lobe_kinds, DEFAULT(0.0),
      HELP("As of a lobe, neither mirror nor mixture.")),
    F(masking, UM_SCHEMA_CHOICE, .choices = maskings, NO_DEFAULT, HELP("As of a lobe.")),
    F(alpha, UM_SCHEMA_NUMBER, POSITIVE(1.5), NO_DEFAULT, .alternative = 1, HELP("Roughness.")),
    F(exponent, UM_SCHEMA_NUMBER, BETWEEN(1.0, 1e8), NO_DEFAULT, .alternative = 1,
      HELP("As of a lobe.")),
};
#undef OF
OBJECT(mixed_object, struct um_materials_mixed_input, "lobe of a mixture",
       "One of the two lobes of kind mixture, alike all round.", FIELDS(mixed_fields));

#define OF struct um_materials_lobe_input
static const struct um_schema_field lobe_fields[] = {
    F(kind, UM_SCHEMA_CHOICE, .choices = lobe_kinds, DEFAULT(0.0),
      HELP("What spreads the specular part; default beckmann. Facets: beckmann, ggx.")),
    F(masking, UM_SCHEMA_CHOICE, .choices = maskings, NO_DEFAULT,
      HELP("Smith's masking of facets toward both directions apart, or by their common "
           "height; default separable.")),
    F(alpha, UM_SCHEMA_NUMBER, POSITIVE(1.5), NO_DEFAULT, .alternative = 1,
      HELP("Roughness, along the grain; in place of surface or grey.beckmann_alpha.")),
    F(exponent, UM_SCHEMA_NUMBER, BETWEEN(1.0, 1e8), NO_DEFAULT, .alternative = 1,
      HELP("Exponent of phong (1/(2 alpha^2)) or ashikhmin_shirley (2/alpha^2), in place "
           "of alpha.")),
    F(alpha_across, UM_SCHEMA_NUMBER, POSITIVE(1.5), NO_DEFAULT, .alternative = 2,
      HELP("Roughness across the grain (a part's `grain`); default that along it.")),
    F(exponent_across, UM_SCHEMA_NUMBER, BETWEEN(1.0, 1e8), NO_DEFAULT, .alternative = 2,
      HELP("Exponent across the grain, of ashikhmin_shirley.")),
    F(of, UM_SCHEMA_LIST, .object = &mixed_object, HELP("The two lobes of kind mixture.")),
    F(file, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("Table of kind measured: CSV of incidence_deg, scattering_deg, azimuth_deg, "
           "brdf_1_sr.")),
    F(renormalise, UM_SCHEMA_BOOL, DEFAULT(0.0),
      HELP("Is a measured table that sends back more than arrives from a direction "
           "brought to 1 there? Default false: it is said and kept.")),
};
#undef OF
OBJECT(lobe_object, struct um_materials_lobe_input, "lobe",
       "How the specular part is spread about the mirror direction.", FIELDS(lobe_fields),
       .scalar_key = "kind");

#define TABLE(member, key, text)                                                                   \
  UM_FIELD(struct um_materials_by_temperature_input, member, key, UM_SCHEMA_NUMBERS,               \
           POSITIVE(1e9), .help = text)
#define OF struct um_materials_by_temperature_input
static const struct um_schema_field by_temperature_fields[] = {
    F_AS(temperature, "temperature_K", UM_SCHEMA_NUMBERS, REQUIRED, BETWEEN(0.0, 1e5),
         HELP("Temperatures, ascending.")),
    TABLE(specific_heat, "specific_heat_J_kg_K", "Specific heat at each of them; linear between."),
    TABLE(conductivity, "conductivity_W_m_K", "Conductivity at each of them; linear between."),
};
#undef OF
OBJECT(by_temperature_object, struct um_materials_by_temperature_input, "properties by temperature",
       "Tables that count by their ratio to their own value at 300 K, where the record's "
       "numbers hold; constant beyond their ends.",
       FIELDS(by_temperature_fields));

#define THERMAL(member, key, text)                                                                 \
  UM_FIELD(struct um_materials_thermal_input, member, key, UM_SCHEMA_NUMBER, POSITIVE(1e9),        \
           NO_DEFAULT, .help = text)
#define OF struct um_materials_thermal_input
static const struct um_schema_field thermal_fields[] = {
    THERMAL(density, "density_kg_m3", "Density."),
    THERMAL(specific_heat, "specific_heat_J_kg_K", "Specific heat."),
    THERMAL(conductivity, "conductivity_W_m_K", "Conductivity (in the plane of a sheet)."),
    THERMAL(thickness_mm, "thickness_mm", "Thickness as built, for sheets and cells."),
    THERMAL(areal_heat_capacity, "areal_heat_capacity_J_m2_K",
            "Heat capacity per area; default density * specific heat * thickness."),
    F_AS(range, "temperature_range_K", UM_SCHEMA_NUMBERS, BETWEEN(0.0, 1e5),
         HELP("[coldest, hottest] between which the record holds; a run that leaves it warns, "
              "or fails where the scenario says so.")),
    F(by_temperature, UM_SCHEMA_MAP, .object = &by_temperature_object,
      HELP("Specific heat and conductivity at other temperatures than 300 K.")),
};
#undef OF
OBJECT(thermal_object, struct um_materials_thermal_input, "thermal properties", "Bulk properties.",
       FIELDS(thermal_fields));

#define CATALOGUE(member, key, text)                                                               \
  UM_FIELD(struct um_materials_catalogue_input, member, key, UM_SCHEMA_NUMBER, REQUIRED, RATIO,    \
           .help = text)
static const char *const emittance_kinds[] = {"hemispherical", "normal", NULL};
#define OF struct um_materials_catalogue_input
static const struct um_schema_field catalogue_fields[] = {
    CATALOGUE(solar_absorptance, "solar_absorptance", "Published solar absorptance."),
    CATALOGUE(solar_absorptance_tolerance, "solar_absorptance_tolerance", "Its uncertainty."),
    CATALOGUE(emittance, "emittance", "Published emittance near 300 K."),
    CATALOGUE(emittance_tolerance, "emittance_tolerance", "Its uncertainty."),
    F_AS(kind, "emittance_kind", UM_SCHEMA_CHOICE, .choices = emittance_kinds, DEFAULT(0.0),
         HELP("What the published emittance is; default hemispherical.")),
    F(source, UM_SCHEMA_TEXT, REQUIRED, HELP("Where the two numbers come from.")),
};
#undef OF
OBJECT(catalogue_object, struct um_materials_catalogue_input, "catalogue values",
       "Published integrals that the record is held against when it is loaded.",
       FIELDS(catalogue_fields));

#define OF struct um_materials_ageing_input
static const struct um_schema_field ageing_fields[] = {
    F(after, UM_SCHEMA_TEXT, REQUIRED, HELP("What the surface went through: light, years, orbit.")),
    F_AS(absorptance, "solar_absorptance_change", UM_SCHEMA_NUMBER, BETWEEN(-1.0, 1.0), NO_DEFAULT,
         HELP("Published change of the solar absorptance; the `shift` of the effect "
              "solar_absorptance.")),
    F_AS(emittance, "emittance_change", UM_SCHEMA_NUMBER, BETWEEN(-1.0, 1.0), NO_DEFAULT,
         HELP("Published change of the emittance.")),
    F(source, UM_SCHEMA_TEXT, REQUIRED, HELP("Where it comes from.")),
};
#undef OF
OBJECT(ageing_object, struct um_materials_ageing_input, "ageing",
       "A published change of the surface; shown, and never applied without an effect.",
       FIELDS(ageing_fields));

#define PART(member, key, part, text, ...)                                                         \
  UM_FIELD(struct um_materials_input, member, key, UM_SCHEMA_MAP, .object = &part, .help = text,   \
           __VA_ARGS__)
#define OF struct um_materials_input
static const struct um_schema_field record_fields[] = {
    F(name, UM_SCHEMA_TEXT, NAME, REQUIRED,
      HELP("Name that scenarios use: letters, digits, _ and -.")),
    F(summary, UM_SCHEMA_TEXT, REQUIRED, HELP("One line.")),
    F(citation, UM_SCHEMA_TEXT, REQUIRED,
      HELP("Where the numbers come from, and what was assumed.")),
    F_AS(measured, "measured_um", UM_SCHEMA_NUMBERS, POSITIVE(1e6),
         HELP("[from, to] between which the optical numbers are measured; without it the record "
              "claims no measurement.")),
    PART(grey, "grey", grey_object, "Explicit numbers.", .alternative = 1),
    PART(reflectance, "reflectance", reflectance_object, "Reflectance table.", .alternative = 1),
    PART(substrate, "substrate", substrate_object, "Optical constants.", .alternative = 1),
    PART(sheet, "sheet", sheet_object, "Film or cover on the substrate.", .alternative = 0),
    F(layers, UM_SCHEMA_LIST, .object = &layer_object,
      HELP("Films and covers on the substrate, outermost first, in place of sheet.")),
    PART(surface, "surface", surface_object, "Roughness and scattering.", .alternative = 0),
    PART(lobe, "lobe", lobe_object, "Spread of the specular part.", .alternative = 0),
    PART(thermal, "thermal", thermal_object, "Bulk properties.", .alternative = 0),
    PART(catalogue, "catalogue", catalogue_object, "Published integrals.", .alternative = 0),
    F(ageing, UM_SCHEMA_LIST, .object = &ageing_object, HELP("Published changes by ageing.")),
};
#undef OF
static const int one_description[] = {1, 0};
OBJECT(record_object, struct um_materials_input, "material",
       "One surface for both halves: what the renderer reflects, the thermal solver absorbs.",
       FIELDS(record_fields), .exactly_one = one_description);

const struct um_schema_object *um_materials_schema(void) { return &record_object; }
