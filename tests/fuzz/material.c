/* A material record: nothing absorbs or sends less than nothing or more than all. */
#include <math.h>

#include "materials/materials.h"
#include "tests/fuzz/fuzz.h"
#include "tests/materials/sun.h"

static void share(double value, const char *what)
{
  if (!(value >= -1e-9 && value <= 1.0 + 1e-9)) um_fuzz_finding("%s is %.17g", what, value);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_materials_library *library = NULL;
  if (!um_fuzz_good(context, library_under_e490(context, &library))) return;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_materials_library_read_file(context, library, path, NULL, 0)))
    for (size_t i = 0; i < um_materials_library_count(library); i++) {
      const struct um_materials_record *record = um_materials_library_at(library, i);
      share(um_materials_solar_absorptance(record, NULL), "the solar absorptance");
      share(um_materials_emittance(record, NULL, 300.0), "the emittance");
      share(um_materials_normal_emittance(record, NULL, 90.0), "the normal emittance");
      for (int k = 0; k < 8; k++) {
        double wavelength = 0.3e-6 * pow(2.0, k);
        share(um_materials_emissivity(record, NULL, wavelength, 0.7), "an emissivity");
        share(um_materials_hemispherical_reflectance(record, NULL, wavelength), "a reflectance");
        share(um_materials_specular_reflectance(record, NULL, wavelength, 0.3), "the lobe");
      }
      um_fuzz_finite(um_materials_roughness(record, NULL), "the roughness");
    }
  um_materials_library_destroy(&library);
}
