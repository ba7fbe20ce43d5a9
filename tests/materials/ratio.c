/* Reflectance relative to a reference: Fresnel's law in closed form, back from what a spectrometer
 * would have shown, refusals. */
#include "with_library.h"

#include <complex.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "materials/ratio.h"
#include "tests/support/temporary.h"

static enum um_status read_text(const char *text, const char *reference, double deg,
                                struct um_materials_measured_reflectance *out)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_materials_ratio_read(
      context, path, um_materials_library_find(library, reference), cos(deg * UM_DEG), out);
  unlink(path);
  return status;
}

/* Born & Wolf 1999, 1.5 (21), 14.2, with the angle inside, complex: another form than fresnel.c. */
static double by_snell(double complex n, double deg)
{
  double complex inside = csqrt(1.0 - pow(sin(deg * UM_DEG), 2.0) / (n * n));
  double c = cos(deg * UM_DEG);
  double s = cabs((c - n * inside) / (c + n * inside)),
         p = cabs((n * c - inside) / (n * c + inside));
  return 0.5 * (s * s + p * p);
}

/* At nodes of the gold table (Olmon et al. 2012): 0.5529 um 0.3152 + 2.545i, 0.9786 um 0.1511 +
 * 6.446i, 10 um 10.89 + 65.95i. The library's record absorbs 1.3 times as much: not that. */
static void fresnel_of_gold(void **state)
{
  static const struct {
    double um, n, k;
  } row[] = {{0.5529, 0.3152, 2.545}, {0.9786, 0.1511, 6.446}, {10.0, 10.89, 65.95}};
  struct um_materials_measured_reflectance m;
  (void)state;
  for (int deg = 0; deg <= 60; deg += 30) {
    assert_int_equal(
        read_text("wavelength_um,ratio\n0.5529,1\n0.9786,0.5\n10,0.01\n", "gold", deg, &m), UM_OK);
    assert_int_equal(m.n, 3);
    for (int i = 0; i < 3; i++) {
      double exact = by_snell(row[i].n + row[i].k * I, deg), ratio[] = {1.0, 0.5, 0.01};
      check_near("wavelength", m.wavelength[i], row[i].um * 1e-6, 1e-18);
      check_near("gold", m.reflectance[i], ratio[i] * exact, 1e-12);
    }
    um_materials_ratio_free(context, &m);
  }
  const struct um_materials_record *gold = um_materials_library_find(library, "gold");
  double finish = um_materials_specular_reflectance(gold, NULL, 0.5529e-6, cos(30.0 * UM_DEG));
  assert_true(by_snell(0.3152 + 2.545 * I, 30.0) - finish > 0.03);
}

/* What is divided by gold comes back: aluminium at 30 deg, as a spectrometer with a gold mirror
 * shows it, above 1 where aluminium is the better mirror. */
static void there_and_back(void **state)
{
  static char text[4000];
  enum { N = 40 };
  char *at = text + sprintf(text, "wavelength_um,ratio\n");
  double c = cos(30.0 * UM_DEG), most = 0.0;
  const struct um_materials_record *gold = um_materials_library_find(library, "gold"),
                                   *metal = um_materials_library_find(library, "mli_kapton");
  struct um_materials_measured_reflectance m;
  (void)state;
  for (int i = 0; i < N; i++) {
    double l = (0.4 + 0.02 * i) * 1e-6;
    double ratio = um_materials_interface_reflectance(metal, l, c) /
                   um_materials_interface_reflectance(gold, l, c);
    most = fmax(most, ratio);
    at += sprintf(at, "%.17g,%.17g\n", l * 1e6, ratio);
  }
  assert_int_equal(read_text(text, "gold", 30.0, &m), UM_OK);
  for (size_t i = 0; i < N; i++)
    check_near("back", m.reflectance[i],
               um_materials_interface_reflectance(metal, m.wavelength[i], c), 1e-14);
  assert_int_equal(m.nabove, 0);
  um_materials_ratio_free(context, &m);
  assert_int_equal(read_text("wavelength_um,ratio\n0.5,1\n1,1.05\n2,1.03\n", "gold", 30.0, &m),
                   UM_OK);
  assert_int_equal(m.nabove, 2);
  check_near("set to 1", m.reflectance[1], 1.0, 0.0);
  check_near("where", m.largest_at, 1e-6, 1e-18);
  check_near("most", m.largest / 1.05, um_materials_interface_reflectance(gold, 1e-6, c), 1e-12);
  um_materials_ratio_free(context, &m);
}

static void refused(const char *text, const char *reference, const char *a, const char *b)
{
  struct um_materials_measured_reflectance m;
  assert_int_equal(read_text(text, reference, 30.0, &m), UM_ERR_INPUT);
  if (strstr(um_core_message(context), a) == NULL || strstr(um_core_message(context), b) == NULL)
    fail_msg("'%s' lacks '%s' or '%s'", um_core_message(context), a, b);
  assert_null(strchr(um_core_message(context), '\n'));
  assert_null(m.wavelength);
}

static void what_is_refused(void **state)
{
#define HEAD "wavelength_um,ratio\n"
  (void)state;
  refused(HEAD "0.5,1\n0.2,1\n", "gold", ":3: column 'wavelength_um'", "0.3 to 24.93");
  refused(HEAD "0.5,1\n40,1\n", "gold", ":3:", "0.3 to 24.93");
  refused(HEAD "0.5,1\n0.5,1\n", "gold", ":3:", "ascending");
  refused(HEAD "0.5,-0.1\n0.6,1\n", "gold", ":2: column 'ratio'", "0 or more");
  refused(HEAD "0.5,nan\n0.6,1\n", "gold", ":2:", "ratio");
  refused(HEAD "0.5,1\n", "gold", "1 rows", "at least 2");
  refused("wavelength_um,value\n0.5,1\n0.6,1\n", "gold", "ratio", "value");
  refused(HEAD "0.5,1\n0.6,1\n", "white_paint", "white_paint", "no optical constants");
  assert_true(isnan(um_materials_interface_reflectance(
      um_materials_library_find(library, "grey_mli"), 1e-6, 1.0)));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(fresnel_of_gold, library_set_up, library_tear_down),
      cmocka_unit_test_setup_teardown(there_and_back, library_set_up, library_tear_down),
      cmocka_unit_test_setup_teardown(what_is_refused, library_set_up, library_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
