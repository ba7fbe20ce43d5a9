/* What records mirror of what they reflect: the specular share that a smooth record states, less
 * what its facets mask; none of a rough one. */
#include "check.h"

#include "materials/materials.h"

static struct um_context *context;
static struct um_materials_library *library;

static int setup(void **state)
{
  (void)state;
  if (um_core_context_create(NULL, &context) != UM_OK) return 1;
  if (library_under_e490(context, &library) != UM_OK) return 1;
  return um_materials_library_read_folder(context, library, UM_TEST_LIBRARY) == UM_OK ? 0 : 1;
}

static int teardown(void **state)
{
  (void)state;
  um_materials_library_destroy(&library);
  um_core_context_destroy(&context);
  return 0;
}

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
      cmocka_unit_test(rough_records),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
