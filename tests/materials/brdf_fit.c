/* Measured BRDFs and their fit: what is refused, data made by a lobe give it back, and the
 * laboratory rows of a Starlink v1.5, which another program fitted
 * (scenarios/starlink-v15/fit_brdf.py). */
#include "check.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "materials/brdf_fit.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static enum um_status read_text(const char *text, struct um_materials_brdf **out)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_materials_brdf_read(context, path, out);
  unlink(path);
  return status;
}

static void refused(const char *text, const char *line, const char *word)
{
  struct um_materials_brdf *brdf;
  assert_int_equal(read_text(text, &brdf), UM_ERR_INPUT);
  assert_null(brdf);
  if (strstr(um_core_message(context), line) == NULL ||
      strstr(um_core_message(context), word) == NULL)
    fail_msg("'%s' lacks '%s' or '%s'", um_core_message(context), line, word);
}

#define HEAD "incidence_deg,scattering_deg,brdf_1_sr\n"

static void what_is_refused(void **state)
{
  (void)state;
  refused(HEAD, "", "no rows");
  refused("incidence_deg,brdf_1_sr\n5,1\n", "", "scattering_deg");
  refused(HEAD "5,10,1\n5,,1\n", ":3:", "scattering_deg");
  refused(HEAD "5,10,nan\n", ":2:", "brdf_1_sr");
  refused(HEAD "5,10,-0.1\n", ":2:", "above 0");
  refused(HEAD "5,10,0\n", ":2:", "above 0");
  refused(HEAD "-5,10,1\n", ":2:", "0 to 90");
  refused(HEAD "5,91,1\n", ":2:", "-90 to 90");
  refused("incidence_deg,scattering_deg,azimuth_deg,brdf_1_sr\n5,1,181,1\n", ":2:", "180");
  struct um_materials_brdf *brdf;
  struct um_materials_brdf_fit fit;
  struct um_materials_lobe lobe = {
      um_materials_lobe_kind_find("ggx"), 0.0, 0.0, false, NULL, 0.0, NULL, false};
  assert_int_equal(read_text(HEAD "5,10,1\n5,20,1\n5,86,1\n", &brdf), UM_OK);
  assert_int_equal(um_materials_brdf_fit(context, brdf, 0, 0.0, lobe, &fit), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "2 rows"));
  um_core_message_clear(context);
  lobe.kind = um_materials_lobe_kind_find("mirror");
  assert_int_equal(um_materials_brdf_fit(context, brdf, 0, 0.0, lobe, &fit), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "no roughness"));
  um_materials_brdf_destroy(context, &brdf);
}

/* Rows of a known lobe, in the plane and out of it, give its numbers back: alpha to the 1e-6 that
 * the search ends with, F and rho to what follows of it. */
static void what_was_put_in(void **state)
{
  static char text[200000];
  (void)state;
  for (size_t k = 0; k < um_materials_lobe_kind_count(); k++) {
    struct um_materials_lobe lobe = {
        um_materials_lobe_kind_at(k), 0.2, 0.2, k % 2 == 1, NULL, 0.0, NULL, false};
    if (!lobe.kind->rough || lobe.kind->mixed) continue;
    char *at = text + sprintf(text, "incidence_deg,scattering_deg,azimuth_deg,brdf_1_sr\n");
    for (int i = 5; i < 80; i += 20)
      for (int o = -80; o <= 80; o += 5)
        for (int azimuth = 0; azimuth <= 60; azimuth += 30) {
          double s = sin(o * UM_DEG), phi = azimuth * UM_DEG;
          struct um_materials_pair pair =
              um_materials_pair(um_vec3(-sin(i * UM_DEG), 0.0, cos(i * UM_DEG)),
                                um_vec3(s * cos(phi), s * sin(phi), cos(o * UM_DEG)));
          at += sprintf(at, "%d,%d,%d,%.17g\n", i, o, azimuth,
                        0.1 / UM_PI + 0.3 * lobe.kind->evaluate(&lobe, &pair));
        }
    struct um_materials_brdf *brdf;
    struct um_materials_brdf_fit fit;
    assert_int_equal(read_text(text, &brdf), UM_OK);
    assert_int_equal(um_materials_brdf_fit(context, brdf, 0, 0.0, lobe, &fit), UM_OK);
    check_near("alpha", fit.lobe.alpha, 0.2, 1e-6);
    check_near("F", fit.specular, 0.3, 1e-5);
    check_near("rho", fit.diffuse, 0.1, 1e-5);
    assert_true(fit.rms <= 1e-5 && fit.largest >= fit.rms);
    assert_true(fit.albedo > 0.3 && fit.albedo <= 0.4);
    um_materials_brdf_destroy(context, &brdf);
  }
}

/* starlink-v15/materials as fit_brdf.py wrote them: rho and F in six decimals, alpha too; rms of ln
 * f in three. Its golden section ends at 1e-6 of alpha, hence 2e-6. */
static void starlink(void **state)
{
  static const struct {
    const char *surface;
    double rho, specular, alpha, rms;
    size_t nrow;
  } rows[] = {{"chassis", 0.040500, 0.057311, 0.232834, 0.284, 536},
              {"array", 0.007723, 0.008369, 0.217058, 0.207, 536}};
  struct um_materials_brdf *brdf;
  (void)state;
  assert_int_equal(
      um_materials_brdf_read(context, UMBRA_SOURCE_DIR "/scenarios/starlink-v15/brdf.csv", &brdf),
      UM_OK);
  assert_int_equal(brdf->nsurface, 2);
  for (size_t s = 0; s < 2; s++) {
    struct um_materials_lobe lobe = {
        um_materials_lobe_kind_find("beckmann"), 0.0, 0.0, false, NULL, 0.0, NULL, false};
    struct um_materials_brdf_fit fit;
    assert_int_equal(um_materials_brdf_fit(context, brdf, s, 10.0 * UM_DEG, lobe, &fit), UM_OK);
    print_message("%s: rho %.6f, F %.6f, alpha %.6f, rms %.4f, %zu rows\n", brdf->surface[s],
                  fit.diffuse, fit.specular, fit.lobe.alpha, fit.rms, fit.nrow);
    assert_string_equal(brdf->surface[s], rows[s].surface);
    assert_int_equal(fit.nrow, rows[s].nrow);
    check_near("rho", fit.diffuse, rows[s].rho, 2e-6);
    check_near("F", fit.specular, rows[s].specular, 2e-6);
    check_near("alpha", fit.lobe.alpha, rows[s].alpha, 2e-6);
    check_near("rms", fit.rms, rows[s].rms, 5e-4);
  }
  um_materials_brdf_destroy(context, &brdf);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(what_is_refused, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(what_was_put_in, context_set_up, context_tear_down),
      cmocka_unit_test_setup_teardown(starlink, context_set_up, context_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
