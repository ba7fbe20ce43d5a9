/* What records mirror of what they reflect: the specular share that a smooth record states, less
 * what its facets mask; none of a rough one. */
#include "with_library.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "materials/materials.h"
#include "tests/support/temporary.h"

static struct um_materials_mirror mirror_of(const char *name)
{
  const struct um_materials_record *record = um_materials_library_find(library, name);
  assert_non_null(record);
  struct um_materials_mirror mirror = um_materials_mirror(record);
  print_message("%s: %.4f of reflected sunlight, %.4f of reflected infrared\n", name, mirror.solar,
                mirror.infrared);
  return mirror;
}

/* Whatever the wavelength, 1 - diffuse_fraction of what a substrate reflects is the lobe's; masking
 * keeps back less than 1 % below alpha 0.05. */
static void smooth_records(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    double share;
  } row[] = {{"mli_kapton", 0.95}, {"mli_kapton_ito", 0.95}, {"cell_silicon", 0.90}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct um_materials_mirror mirror = mirror_of(row[i].name);
    assert_true(mirror.solar <= row[i].share && mirror.solar > 0.99 * row[i].share);
    assert_true(mirror.infrared <= row[i].share && mirror.infrared > 0.99 * row[i].share);
  }
}

/* 0.50 of 0.12 + 0.50 of a grey record, whose lobe ends at 2.5 um. */
static void grey_record(void **state)
{
  (void)state;
  struct um_materials_mirror mirror = mirror_of("grey_mli");
  assert_close(mirror.solar, 0.50 / 0.62, 1e-12);
  assert_close(mirror.infrared, 0.0, 0.0);
}

/* A table's mirror in one of two bands or in both: the share that is stated there, 0.4 of 0.5, and
 * nothing in the other; beyond its ends a table goes on. Of sunlight 0.9 % lies beyond 4 um, of
 * 300 K radiation 0.2 % below. */
static void tables_by_band(void **state)
{
  (void)state;
  static const struct {
    const char *table;
    double solar, infrared;
  } row[] = {
      {"[0.3, 5], diffuse: [0.1, 0.1], specular: [0.4, 0.4]", 0.8, 0.8},
      {"[5, 20], diffuse: [0.1, 0.1], specular: [0.4, 0.4]", 0.8, 0.8},
      {"[0.3, 3.9, 4, 20], diffuse: [0.5, 0.5, 0.1, 0.1], specular: [0, 0, 0.4, 0.4]", 0.0, 0.8},
      {"[0.3, 3.9, 4, 20], diffuse: [0.1, 0.1, 0.5, 0.5], specular: [0.4, 0.4, 0, 0]", 0.8, 0.0}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    char path[UM_TEST_PATH], text[256];
    snprintf(text, sizeof text,
             "name: table\nsummary: s\ncitation: c\nreflectance: {wavelength_um: %s}\n"
             "lobe: mirror\n",
             row[i].table);
    um_test_file_create(path, text, strlen(text));
    assert_int_equal(um_materials_library_read_file(context, library, path, NULL, 0), UM_OK);
    unlink(path);
    struct um_materials_mirror mirror = mirror_of("table");
    assert_close(mirror.solar, row[i].solar, 0.8 * 0.01);
    assert_close(mirror.infrared, row[i].infrared, 0.8 * 0.003);
  }
}

static void rough_records(void **state)
{
  (void)state;
  static const char *const name[] = {"cfrp", "white_paint", "black", "aluminium_anodised",
                                     "cell_triple_junction"};
  for (size_t i = 0; i < sizeof name / sizeof name[0]; i++) {
    struct um_materials_mirror mirror = mirror_of(name[i]);
    assert_true(mirror.solar == 0.0 && mirror.infrared == 0.0);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(smooth_records),
      cmocka_unit_test(grey_record),
      cmocka_unit_test(tables_by_band),
      cmocka_unit_test(rough_records),
  };
  return cmocka_run_group_tests(tests, library_set_up, library_tear_down);
}
