/* Spectra of records as umbra list materials --out writes them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "output/spectrum_plot.h"
#include "tests/materials/sun.h"
#include "tests/support/near.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

/* The columns are the reflectances that the renderer and the heat network use, to their four
 * decimals, from 0.25 to 25 um. */
static void table_is_the_record(void **state)
{
  (void)state;
  struct um_materials_library *library;
  const struct um_materials_record *osr;
  struct um_core_folder *to = NULL;
  struct um_core_csv *csv;
  char top[UM_TEST_PATH], path[UM_TEST_PATH + 32];
  assert_int_equal(um_test_folder_create(top), 0);
  assert_int_equal(library_under_e490(context, &library), UM_OK);
  assert_int_equal(um_materials_library_read_file(
                       context, library, UMBRA_SOURCE_DIR "/materials/library/osr.yaml", NULL, 0),
                   UM_OK);
  osr = um_materials_library_find(library, "osr");
  snprintf(path, sizeof path, "%s/spectra", top);
  assert_int_equal(um_core_folder_begin(context, path, false, &to), UM_OK);
  assert_int_equal(um_output_spectra(context, &osr, 1, false, to), UM_OK);
  assert_int_equal(um_core_folder_commit(context, &to), UM_OK);
  snprintf(path, sizeof path, "%s/spectra/osr.csv", top);
  assert_int_equal(um_core_csv_read(context, path, &csv), UM_OK);
  size_t n = um_core_csv_rows(csv);
  double row[3], before = 0.0;
  assert_true(n > 1000);
  for (size_t i = 0; i < n; i++) {
    for (size_t k = 0; k < 3; k++)
      assert_int_equal(um_core_csv_number(context, csv, i, k, &row[k]), UM_OK);
    if (i == 0) check_near("first", row[0], 0.25, 1e-12);
    if (i == n - 1) check_near("last", row[0], 25.0, 1e-12);
    assert_true(row[0] > before);
    before = row[0];
    /* the wavelength is rounded to 5 digits: 1e-3 of a steep edge */
    check_near("normal", row[1], 1.0 - um_materials_emissivity(osr, NULL, row[0] * 1e-6, 1.0),
               2e-3);
    check_near("from all sides", row[2],
               um_materials_hemispherical_reflectance(osr, NULL, row[0] * 1e-6), 2e-3);
  }
  um_core_csv_destroy(&csv);
  um_materials_library_destroy(&library);
  remove(path);
  snprintf(path, sizeof path, "%s/spectra/.umbra", top);
  remove(path);
  snprintf(path, sizeof path, "%s/spectra", top);
  assert_int_equal(um_test_folder_remove(path), 0);
  assert_int_equal(um_test_folder_remove(top), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(table_is_the_record)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
