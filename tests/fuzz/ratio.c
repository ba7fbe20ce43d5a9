/* A table of reflectance relative to a reference mirror. */
#include "materials/ratio.h"

#include "tests/fuzz/fuzz.h"
#include "tests/materials/sun.h"

static const char mirror[] = "name: m\nsummary: s\ncitation: c\nsurface: {beckmann_alpha: 0.1}\n"
                             "substrate: {wavelength_um: [0.3, 20], n: [1, 9], k: [2, 60]}\n";

static void one(struct um_context *context, const struct um_materials_record *reference,
                const char *path)
{
  struct um_materials_measured_reflectance m;
  if (um_fuzz_good(context, um_materials_ratio_read(context, path, reference, 0.9, &m))) {
    for (size_t i = 0; i < m.n; i++)
      if (!(m.reflectance[i] >= 0.0 && m.reflectance[i] <= 1.0))
        um_fuzz_finding("a reflectance that is none");
  } else if (m.wavelength != NULL || m.reflectance != NULL) {
    um_fuzz_finding("rows in spite of the failure");
  }
  um_materials_ratio_free(context, &m);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_materials_library *library = NULL;
  if (!um_fuzz_good(context, library_under_e490(context, &library))) return;
  const char *record = um_fuzz_file(1, mirror, sizeof mirror - 1);
  if (um_fuzz_good(context, um_materials_library_read_file(context, library, record, NULL, 0)))
    one(context, um_materials_library_at(library, 0), um_fuzz_file(0, data, size));
  um_materials_library_destroy(&library);
}
