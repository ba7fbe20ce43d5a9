/* Records whose lobe is a measured table: what it does not reflect it absorbs and emits, in every
 * direction and whatever is adjusted; what is refused. */
#include "check.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "materials/bsdf.h"
#include "materials/materials.h"
#include "tests/materials/table.h"
#include "tests/support/temporary.h"

static struct um_context *context;
static struct um_materials_library *library;
static char table[UM_TEST_PATH]; /* 0.15/pi + 0.5 Beckmann of alpha 0.3 */
static char warned[512];

static void hear(void *self, enum um_core_log_level level, const char *line)
{
  (void)self;
  if (level == UM_LOG_WARNING) snprintf(warned, sizeof warned, "%s", line);
}

static struct test_brdf brdf_of(void)
{
  struct test_brdf b = {.diffuse = 0.15, .rest = 0.5};
  b.lobe = (struct um_materials_lobe){
      .kind = um_materials_lobe_kind_find("beckmann"), .alpha = 0.3, .alpha_across = 0.3};
  return b;
}

static int create(void **state)
{
  (void)state;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  um_core_log_set_sink(context, hear, NULL);
  warned[0] = '\0';
  const struct test_brdf b = brdf_of();
  struct um_materials_measured_grid grid = test_grid(&b, 5.0, 85.0, 5.0);
  um_test_file_create(table, "", 0);
  test_grid_write(&grid, table);
  test_grid_free(&grid);
  return library_under_e490(context, &library) == UM_OK ? 0 : -1;
}

static int destroy(void **state)
{
  (void)state;
  unlink(table);
  um_materials_library_destroy(&library);
  um_core_context_destroy(&context);
  return 0;
}

/* A record of keys behind the first three; %s of them is the table. */
static enum um_status read_record(const char *keys)
{
  char path[UM_TEST_PATH], text[2048], with[1600];
  snprintf(with, sizeof with, keys, table);
  snprintf(text, sizeof text, "name: m\nsummary: s\ncitation: c\n%s", with);
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_materials_library_read_file(context, library, path, NULL, 0);
  unlink(path);
  return status;
}

static const struct um_materials_record *record(void)
{
  static const char keys[] =
      "reflectance: {wavelength_um: [0.3, 1, 2, 30], diffuse: [0, 0, 0.1, 0.2], specular: [1, 1, "
      "0.5, 0.3]}\nlobe: {kind: measured, file: %s}\n";
  if (read_record(keys) != UM_OK) fail_msg("%s", um_core_message(context));
  return um_materials_library_find(library, "m");
}

static const double wavelengths[] = {0.3e-6, 0.6e-6, 1.4e-6, 2.0e-6, 3.0e-6, 9.0e-6, 40e-6};
#define NWAVELENGTH (sizeof wavelengths / sizeof wavelengths[0])

/* The table's albedo in closed form of its lobe, 1e-3 as it is constant beyond 85 deg. */
static double albedo(double cosine)
{
  const struct test_brdf b = brdf_of();
  return b.diffuse + b.rest * um_materials_lobe_albedo(&b.lobe, cosine);
}

/* Kirchhoff: emissivity(o) = 1 - rho_d - F E(o), nothing is given back by scattering, and the
 * integrals of heat are means of the same. */
static void kirchhoff(void **state)
{
  static const double specular[] = {1.0, 1.0, 0.8, 0.5, 0.49285714, 0.45, 0.3};
  static const double diffuse[] = {0.0, 0.0, 0.04, 0.1, 0.10357143, 0.125, 0.2};
  const struct um_materials_record *r = record();
  (void)state;
  assert_false(um_materials_emissivity_is_diffuse(r, NULL));
  for (size_t k = 0; k < NWAVELENGTH; k++) {
    double l = wavelengths[k], mean = 0.0;
    check_near("F", um_materials_specular_reflectance(r, NULL, l, 0.7), specular[k], 1e-6);
    check_near("rho_d", um_materials_diffuse_reflectance(r, NULL, l), diffuse[k], 1e-6);
    assert_true(um_materials_masked_mean(r, NULL, l) == 0.0);
    assert_true(um_materials_masked_reflectance(r, NULL, l, 0.5) == 0.0);
    for (double z = 0.0; z <= 75.0; z += 15.0)
      check_near("emissivity", um_materials_emissivity(r, NULL, l, cos(z * UM_DEG)),
                 1.0 - diffuse[k] - specular[k] * albedo(cos(z * UM_DEG)), 1e-3);
    for (int i = 0; i < 200; i++) {
      double u = (i + 0.5) / 200.0;
      mean += 4.0 * u * u * u / 200.0 * um_materials_emissivity(r, NULL, l, u * u);
    }
    check_near("hemispherical", 1.0 - um_materials_hemispherical_reflectance(r, NULL, l), mean,
               1e-4);
  }
  double normal = um_materials_solar_absorptance(r, NULL);
  assert_true(normal > 1.0 - albedo(1.0) - 1e-3 && normal < 1.0 - 0.3 * albedo(1.0));
  check_near("emittance of 30 um and more at 3 K", um_materials_normal_emittance(r, NULL, 3.0),
             1.0 - 0.2 - 0.3 * albedo(1.0), 0.02);
}

/* What is reflected and emitted makes 1 toward every direction, whatever is asked of absorptance
 * and emittance; hemispherical emissivity is what was asked. */
static void adjusted(void **state)
{
  const struct um_materials_record *r = record();
  (void)state;
  struct um_materials_lobe lobe = um_materials_lobe(r, NULL);
  for (int k = 0; k < 7; k++) {
    struct um_materials_adjustment a = um_materials_no_adjustment;
    a.emittance_scale = (double[]){0.5, 0.9, 1.1, 1.2, 1.0, 1.0, 1.0}[k];
    a.absorptance_shift = (double[]){0.0, 0.0, 0.0, 0.0, -0.2, 0.1, 0.3}[k];
    for (size_t w = 0; w < NWAVELENGTH; w++) {
      double l = wavelengths[w];
      for (double z = 0.0; z <= 75.0; z += 25.0) {
        double c = cos(z * UM_DEG);
        check_near(
            "reflected and absorbed",
            um_materials_emissivity(r, &a, l, c) + um_materials_diffuse_reflectance(r, &a, l) +
                um_materials_specular_reflectance(r, &a, l, c) * um_materials_lobe_albedo(&lobe, c),
            1.0, 1e-9);
      }
      double before = 1.0 - um_materials_hemispherical_reflectance(r, NULL, l);
      double after = 1.0 - um_materials_hemispherical_reflectance(r, &a, l);
      check_near("asked", after,
                 l < 2.5e-6 ? before + a.absorptance_shift : before * a.emittance_scale, 1e-4);
    }
  }
  struct um_materials_adjustment a = um_materials_no_adjustment;
  a.specular_scale = 100.0; /* no more than all */
  double f = um_materials_specular_reflectance(r, &a, 0.6e-6, 0.5), most = 0.0;
  for (double z = 0.0; z < 90.0; z += 1.0)
    most = fmax(most, um_materials_lobe_albedo(&lobe, cos(z * UM_DEG)));
  check_near("all of it", f * most, 1.0, 1e-3);
  a = um_materials_no_adjustment;
  a.roughness_scale = 3.0;
  lobe = um_materials_lobe(r, &a);
  assert_ptr_equal(lobe.measured, um_materials_lobe(r, NULL).measured);
  check_near("a table has no roughness", um_materials_specular_reflectance(r, &a, 0.6e-6, 0.5), 1.0,
             1e-12);
}

static void refused(const char *keys, const char *word)
{
  assert_int_equal(read_record(keys), UM_ERR_INPUT);
  if (strstr(um_core_message(context), word) == NULL)
    fail_msg("'%s' lacks '%s'", um_core_message(context), word);
}

#define PLAIN "reflectance: {wavelength_um: [0.3, 30], diffuse: [0, 0], specular: [1, 1]}\n"

static void what_is_refused(void **state)
{
  (void)state;
  refused(PLAIN "lobe: {kind: measured}\n", "file is missing");
  refused(PLAIN "lobe: {kind: measured, file: %s, alpha: 0.2}\n", "has no roughness");
  refused(PLAIN "lobe: {kind: measured, file: %s}\nsurface: {beckmann_alpha: 0.2}\n",
          "has no roughness");
  refused(PLAIN "lobe: {kind: ggx, alpha: 0.2, file: %s}\n", "belong to kind measured");
  refused(PLAIN "lobe: {kind: lambert, renormalise: true}\n", "belong to kind measured");
  refused(PLAIN "lobe: {kind: mixture, of: [{share: 0.5, kind: measured}, {share: 0.5, alpha: "
                "0.1}]}\n",
          "cannot be part of a mixture");
  refused("grey: {solar_absorptance: 0.5, emittance: 0.5, specular_reflectance: 0.5}\n"
          "lobe: {kind: measured, file: %s}\n",
          "beside the key reflectance");
  refused("substrate: {wavelength_um: [0.3, 30], n: [1, 9], k: [2, 60]}\n"
          "lobe: {kind: measured, file: %s}\n",
          "beside the key reflectance");
  refused("reflectance: {wavelength_um: [0.3, 30], diffuse: [0, 0.5], specular: [1, 1]}\n"
          "lobe: {kind: measured, file: %s}\n",
          "times the table's albedo");
  assert_int_equal(read_record(PLAIN "lobe: {kind: measured, file: no%s}\n"), UM_ERR_IO);
}

/* What is above one is said with its amount and what brings it to one. */
static void above_one(void **state)
{
  const struct test_brdf even = {{0}, 1.25, 0.0};
  struct um_materials_measured_grid grid = test_grid(&even, 5.0, 85.0, 30.0);
  (void)state;
  test_grid_write(&grid, table);
  test_grid_free(&grid);
  assert_int_equal(read_record(PLAIN "lobe: {kind: measured, file: %s}\n"), UM_OK);
  assert_non_null(strstr(warned, "reflects 1.25"));
  assert_non_null(strstr(warned, "renormalise: true"));
  struct um_materials_lobe lobe = um_materials_lobe(um_materials_library_find(library, "m"), NULL);
  struct um_materials_pair pair = test_pair(0.5, 0.5, 0.5);
  check_near("kept", lobe.kind->evaluate(&lobe, &pair), 1.25 / UM_PI, 1e-9);
  assert_int_equal(read_record(PLAIN "lobe: {kind: measured, file: %s, renormalise: true}\n"),
                   UM_OK);
  assert_non_null(strstr(warned, "renormalised to 1"));
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  lobe = um_materials_lobe(r, NULL);
  check_near("renormalised", lobe.kind->evaluate(&lobe, &pair), 1.0 / UM_PI, 1e-6);
  check_near("nothing is absorbed", um_materials_solar_absorptance(r, NULL), 0.0, 1e-6);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(kirchhoff, create, destroy),
      cmocka_unit_test_setup_teardown(adjusted, create, destroy),
      cmocka_unit_test_setup_teardown(what_is_refused, create, destroy),
      cmocka_unit_test_setup_teardown(above_one, create, destroy),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
