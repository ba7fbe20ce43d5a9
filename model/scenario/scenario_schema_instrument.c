/* Keys of scenario.yaml: bands, filters and sensors. */
#include "model/scenario/scenario_schema_group.h"

#define OF struct um_scenario_band
static const struct um_schema_field band_fields[] = {
    F(from_um, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0.2, 100),
      HELP("lower edge; with to_um, in place of a filter")),
    F(to_um, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0.2, 100), HELP("upper edge")),
    F(filter, UM_SCHEMA_TEXT, NAME,
      HELP("of the program's own, see `umbra list filters`; in place of edges")),
    F(filter_file, UM_SCHEMA_TEXT, NAMES_FILE,
      HELP("CSV with wavelength_um or wavelength_nm, and transmission; in place of edges")),
    F(bins, UM_SCHEMA_INTEGER, DEFAULT(40), BETWEEN(1, 2000), HELP("of equal width")),
    F(vega_magnitude, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(-2, 2),
      HELP("that the photometric system gives Vega; 0.03 in Johnson's V. Where it is stated "
           "magnitudes that run and forecast tell are relative to Vega")),
};
#undef OF
SHARED_OBJECT(um_model_band_schema, struct um_scenario_band, "band", "A spectral band.",
              FIELDS(band_fields));
#define OF struct um_scenario_sensor
/* Keys that a preset may hold too. */
/* clang-format off */
#define COMMON                                                                                     \
    F(aperture_m, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(100), \
      HELP("diameter of the telescope; to be given where there is no preset")), \
    F(obstruction, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 0.99), \
      HELP("diameter of what stands before it, of the aperture's")), \
    F(throughput, UM_SCHEMA_NUMBER, DEFAULT(1.0), POSITIVE(1), \
      HELP("of mirrors, lenses and windows")), \
    F(quantum_efficiency, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1), \
      HELP("electrons per photon, at every wavelength; default: 1, or that of the file")), \
    F(quantum_efficiency_file, UM_SCHEMA_TEXT, NAMES_FILE, \
      HELP("CSV with wavelength_um or wavelength_nm, and transmission: electrons per photon")), \
    F(gain_e, UM_SCHEMA_NUMBER, DEFAULT(1.0), POSITIVE(1e6), \
      HELP("electrons per count; 1: counts are electrons")), \
    F(pixel_arcsec, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5), \
      HELP("side of a pixel on the sky; noise is computed where it is given")), \
    F(fwhm_arcsec, UM_SCHEMA_NUMBER, DEFAULT(2.0), POSITIVE(1e5), \
      HELP("of the image of a star, a Gaussian")), \
    F(radius_fwhm, UM_SCHEMA_NUMBER, DEFAULT(1.0), POSITIVE(100), \
      HELP("of the circle in which counts are summed")), \
    F(annulus_pixels, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e9), \
      HELP("from which the background is read; default: so many that it is known")), \
    F(read_noise_e, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e6), \
      HELP("of a pixel in an exposure")), \
    F(dark_e_s, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1e12), \
      HELP("dark current of a pixel")), \
    F(sky_mag_arcsec2, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(-30, 30), \
      HELP("AB brightness of the sky per square arc second; default: dark")), \
    F(optics_emissivity, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1), \
      HELP("of mirrors, lenses and windows, whose heat is background in the infrared")), \
    F(optics_temperature_K, UM_SCHEMA_NUMBER, DEFAULT(283.0), \
      BETWEEN(1, 400), HELP("of them")), \
    F(saturation_e, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e12), \
      HELP("electrons that a pixel holds; default: any number")), \
    F(exposure_s, UM_SCHEMA_NUMBER, NO_DEFAULT, POSITIVE(1e5), \
      HELP("of one picture; default: time.exposure_s")), \
    F(noise_equivalent_irradiance_W_m2, UM_SCHEMA_NUMBER, \
      NO_DEFAULT, POSITIVE(1e6), \
      HELP("of an exposure, through the filter, as thermal imagers are rated; in place of noise " \
           "by pixels"))
/* clang-format on */
static const struct um_schema_field sensor_fields[] = {
    F(band, UM_SCHEMA_TEXT, NAME, REQUIRED, HELP("whose light it counts")),
    F(preset, UM_SCHEMA_TEXT, NAME,
      HELP("of the program's own, see `umbra list sensors`, for the keys that are not given here")),
    COMMON,
};
static const struct um_schema_field preset_sensor_fields[] = {COMMON};
#undef OF
SHARED_OBJECT(um_model_sensor_schema, struct um_scenario_sensor, "sensor",
              "A telescope with its detector, which counts the photons of a band.",
              FIELDS(sensor_fields));
SHARED_OBJECT(um_model_preset_sensor_schema, struct um_scenario_sensor, "sensor of a preset",
              "Keys of a sensor.", FIELDS(preset_sensor_fields));

#define OF struct um_scenario_preset
static const struct um_schema_field preset_fields[] = {
    F(summary, UM_SCHEMA_TEXT, REQUIRED, HELP("what it is")),
    F(source, UM_SCHEMA_TEXT, REQUIRED, HELP("where its figures are from")),
    F(assumed, UM_SCHEMA_TEXT, REQUIRED, HELP("which of them are not known")),
    F(sensor, UM_SCHEMA_MAP, REQUIRED, .object = &um_model_preset_sensor_schema, HELP("its keys")),
};
#undef OF
SHARED_OBJECT(um_model_preset_schema, struct um_scenario_preset, "preset",
              "A sensor that comes with the program.", FIELDS(preset_fields));
