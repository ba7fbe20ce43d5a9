/* Records of several layers: what is refused, the spectral grid against the equations, thicker and
 * thinner ones against records that were written so, and published thicknesses. */
#include "check.h"

#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "materials/bsdf.h"
#include "tests/support/temporary.h"

static struct um_context *context;
static struct um_materials_library *library;

static int setup(void **state)
{
  (void)state;
  if (um_core_context_create(NULL, &context) != UM_OK) return 1;
  return library_under_e490(context, &library) == UM_OK ? 0 : 1;
}

static int teardown(void **state)
{
  (void)state;
  um_materials_library_destroy(&library);
  um_core_context_destroy(&context);
  return 0;
}

#define HEAD  "summary: s\ncitation: c\nsurface: {beckmann_alpha: 0.0005}\n"
#define WAVES "wavelength_um: [0.2, 50]"
#define METAL "substrate: {" WAVES ", n: [1, 1], k: [6, 6]}\n"
#define LAYER(thickness, index, more)                                                              \
  "  - {thickness_um: " thickness ", " WAVES ", n: [" index ", " index "], k: [1e-9, 1e-9]" more   \
  "}\n"

static enum um_status read_text(const char *text)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_materials_library_read_file(context, library, path, NULL, 0);
  unlink(path);
  return status;
}

static const struct um_materials_record *record_of(const char *name, const char *text)
{
  if (read_text(text) != UM_OK) fail_msg("%s", um_core_message(context));
  const struct um_materials_record *record = um_materials_library_find(library, name);
  assert_non_null(record);
  return record;
}

static void refused(const char *text, const char *line, const char *a, const char *b)
{
  assert_int_equal(read_text(text), UM_ERR_INPUT);
  const char *pieces[] = {line, a, b};
  for (size_t i = 0; i < 3; i++)
    if (strstr(um_core_message(context), pieces[i]) == NULL)
      fail_msg("'%s' lacks '%s'", um_core_message(context), pieces[i]);
  assert_null(strchr(um_core_message(context), '\n'));
}

static void what_is_refused(void **state)
{
#define M       "name: m\n" HEAD
#define FOUR(l) l l l l
  (void)state;
  refused(M "reflectance: {" WAVES ", diffuse: [0.1, 0.1]}\nlayers:\n" LAYER("1", "1.5", ""),
          ":1:", "layers", "substrate");
  refused(M METAL "sheet: {thickness_um: 9, " WAVES
                  ", n: [1, 1], k: [0, 0]}\nlayers:\n" LAYER("1", "1.5", ""),
          ":6:", "beside layers", "accepted");
  refused(M METAL "layers:\n" FOUR(FOUR(LAYER("9", "1.5", ""))) LAYER("9", "1.5", ""),
          ":23:", "17 layers", "at most 16");
  refused(M METAL "layers:\n" LAYER("3", "1.5", "") LAYER("2.5", "1.7", ""),
          ":8:", "thickness_um 5.5", "at most 5");
  refused(M METAL "layers:\n" LAYER("6", "1.5", ", passes: coherent"), ":7:", "thickness_um 6",
          "at most 5");
  refused(M METAL "layers:\n" LAYER("1", "1.5", ", passes: both"), ":7:", "both", "incoherent");
  refused(M METAL "layers:\n  - {thickness_um: 1, wavelength_um: [2, 1], n: [1, 1], k: [0, 0]}\n",
          ":7:", "1 follows 2", "ascending");
  refused(M METAL "layers:\n  - {thickness_um: 1, " WAVES ", n: [1], k: [0, 0]}\n",
          ":7:", "n has 1", "2, one per");
  /* films that do not lie on each other count apart, and what is stated to be thick does not */
  assert_int_equal(read_text(M METAL "layers:\n" LAYER("3", "1.5", "") LAYER("50", "1.5", "")
                                 LAYER("3", "1.5", "")),
                   UM_OK);
  assert_int_equal(read_text(M METAL "layers:\n" LAYER("3", "1.5", ", passes: incoherent")
                                 LAYER("3", "1.5", "")),
                   UM_OK);
}

/* Emissivity is one minus the reflectance of the stack at any wavelength and angle (smooth lobe,
 * nothing scattered): linear in wavelength and cubic in angle on the grid holds 3e-3, as for one
 * film (library.c). A list of one layer has the bits of a sheet. */
static void grid_reproduces_stack(void **state)
{
  (void)state;
  const struct um_materials_record *r =
      record_of("r", "name: r\n" HEAD METAL "layers:\n" LAYER("0.1", "1.38", "")
                         LAYER("100", "1.5", "") LAYER("0.06", "2.3", "") LAYER("0.4", "1.6", ""));
  double least = 1.0, most = 0.0;
  for (double l = 0.4e-6; l < 12e-6; l *= 1.0037)
    for (double c = 0.2; c <= 1.0; c += 0.2) {
      const struct um_materials_layer layers[] = {{1.38, 1e-9, 0.1e-6, true},
                                                  {1.5, 1e-9, 100e-6, false},
                                                  {2.3, 1e-9, 0.06e-6, true},
                                                  {1.6, 1e-9, 0.4e-6, true}};
      double exact = um_materials_fresnel_stack(layers, 4, 1.0, 6.0, l, c);
      check_near("stack", um_materials_emissivity(r, NULL, l, c), 1.0 - exact, 3e-3);
      least = fmin(least, exact);
      most = fmax(most, exact);
    }
  assert_true(most - least > 0.05);
  for (int coherent = 0; coherent < 2; coherent++) {
    const struct um_materials_record *a =
        record_of("a", coherent ? "name: a\n" HEAD METAL "layers:\n" LAYER("2", "1.6", "")
                                : "name: a\n" HEAD METAL "layers:\n" LAYER("20", "1.6", ""));
    const struct um_materials_record *b = record_of(
        "b", coherent ? "name: b\n" HEAD METAL "sheet: {coherent: true, thickness_um: 2, " WAVES
                        ", n: [1.6, 1.6], k: [1e-9, 1e-9]}\n"
                      : "name: b\n" HEAD METAL "sheet: {thickness_um: 20, " WAVES
                        ", n: [1.6, 1.6], k: [1e-9, 1e-9]}\n");
    for (double l = 0.4e-6; l < 12e-6; l *= 1.01)
      check_near("one layer", um_materials_emissivity(a, NULL, l, 0.7),
                 um_materials_emissivity(b, NULL, l, 0.7), 0.0);
  }
}

static void same(const struct um_materials_record *a, const struct um_materials_record *b)
{
  check_near("absorptance", um_materials_solar_absorptance(a, NULL),
             um_materials_solar_absorptance(b, NULL), 0.0);
  check_near("emittance", um_materials_emittance(a, NULL, 250.0),
             um_materials_emittance(b, NULL, 250.0), 0.0);
  check_near("mirror", um_materials_mirror(a).infrared, um_materials_mirror(b).infrared, 0.0);
  for (double l = 0.3e-6; l < 20e-6; l *= 1.1) {
    check_near("F", um_materials_specular_reflectance(a, NULL, l, 0.6),
               um_materials_specular_reflectance(b, NULL, l, 0.6), 0.0);
    check_near("diffuse", um_materials_diffuse_reflectance(a, NULL, l),
               um_materials_diffuse_reflectance(b, NULL, l), 0.0);
    check_near("emissivity", um_materials_emissivity(a, NULL, l, 0.6),
               um_materials_emissivity(b, NULL, l, 0.6), 0.0);
  }
}

/* Layers twice as thick are a record that was written so, bit for bit; none are the substrate. */
static void thickened(void **state)
{
#define ABSORBING(a, b)                                                                            \
  "layers:\n  - {thickness_um: " a ", " WAVES ", n: [1.5, 1.5], k: [1e-4, 1e-2]}\n  - "            \
  "{thickness_um: " b ", wavelength_um: [0.25, 1, 30], n: [2.3, 2.2, 3], k: [0, 0.01, 0.2]}\n"
  struct um_materials_record *twice, *bare;
  (void)state;
  const struct um_materials_record *once =
      record_of("once", "name: once\n" HEAD METAL ABSORBING("8", "0.25"));
  assert_true(um_materials_has_layers(once));
  assert_int_equal(um_materials_library_thickened(context, library, once, 2.0, &twice), UM_OK);
  same(twice, record_of("twice", "name: twice\n" HEAD METAL ABSORBING("16", "0.5")));
  assert_true(um_materials_emittance(twice, NULL, 300.0) >
              1.2 * um_materials_emittance(once, NULL, 300.0));
  um_materials_record_destroy(&twice);
  assert_null(twice);
  assert_int_equal(um_materials_library_thickened(context, library, once, 0.0, &bare), UM_OK);
  const struct um_materials_record *metal = record_of("metal", "name: metal\n" HEAD METAL);
  assert_false(um_materials_has_layers(metal));
  same(bare, metal);
  um_materials_record_destroy(&bare);
}

/* Published (Gilmore, ch. 4 and docs/physics/fresnel.md): aluminised Kapton of 25 um has 0.36-0.40
 * and 0.55-0.64, of 50 um 0.41-0.46 and 0.71-0.78, so that emittance grows by 1.11 to 1.42 when the
 * thickness doubles. The record of 25.4 um lies low in its range (hemispherical 0.548), so does
 * what is made of it; absorptance is within. Without its film it is aluminium. */
static void published_thicknesses(void **state)
{
  struct um_materials_record *r;
  (void)state;
  assert_int_equal(um_materials_library_read_folder(context, library, UM_TEST_LIBRARY), UM_OK);
  const struct um_materials_record *kapton = um_materials_library_find(library, "mli_kapton");
  assert_int_equal(um_materials_library_thickened(context, library, kapton, 2.0, &r), UM_OK);
  double growth =
      um_materials_emittance(r, NULL, 300.0) / um_materials_emittance(kapton, NULL, 300.0);
  print_message("Kapton 50.8 um: absorptance %.3f, emittance %.3f, grown by %.3f\n",
                um_materials_solar_absorptance(r, NULL), um_materials_emittance(r, NULL, 300.0),
                growth);
  check_near("absorptance", um_materials_solar_absorptance(r, NULL), 0.435, 0.025);
  check_near("growth", growth, 1.265, 0.155);
  um_materials_record_destroy(&r);
  assert_int_equal(um_materials_library_thickened(context, library, kapton, 0.0, &r), UM_OK);
  check_near("bare", um_materials_emittance(r, NULL, 300.0), 0.015, 0.002);
  um_materials_record_destroy(&r);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(what_is_refused, setup, teardown),
      cmocka_unit_test_setup_teardown(grid_reproduces_stack, setup, teardown),
      cmocka_unit_test_setup_teardown(thickened, setup, teardown),
      cmocka_unit_test_setup_teardown(published_thicknesses, setup, teardown),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
