/* Which material records a model reads, and what it says of those that were not measured. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/build/build.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static const char *const scenario =
    "schema: 1\n"
    "name: materials\n"
    "time: {start_utc: 2016-09-21T09:17:00Z, stop_utc: 2016-09-21T09:18:00Z, step_s: 60}\n"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude: [{lvlh: {}}]\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "bands:\n"
    "  vis: {from_um: 0.51, to_um: 0.54, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

static char base[UM_TEST_PATH], path[UM_TEST_PATH + 32], logged[1024];
static int warnings;

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static void keep_log(void *self, enum um_core_log_level level, const char *line)
{
  (void)self;
  if (level < UM_LOG_WARNING || strstr(line, "measured") == NULL) return;
  snprintf(logged, sizeof logged, "%s", line);
  warnings++;
}

/* A model reads the records that it names and no others; a variant borrows them, and reads its own
 * where it names another. */
static void reads_what_it_names(void **state)
{
  (void)state;
  const struct um_document_change gold = {
      .key = "parts.box.outside", .number = NAN, .text = "gold"};
  const struct um_document_change none = {
      .key = "parts.box.outside", .number = NAN, .text = "goldd"};
  const struct um_document_change albedo = {.key = "environment.albedo", .number = 0.25};
  struct um_model *origin = NULL, *variant = NULL;
  need(um_model_create(context, path, NULL, &origin));
  assert_int_equal(um_materials_library_count(origin->library), 1);
  need(um_model_variant_create(context, origin,
                               &(struct um_model_changes){.key = &albedo, .nkey = 1}, &variant));
  assert_ptr_equal(variant->library, origin->library);
  um_model_destroy(context, &variant);
  need(um_model_variant_create(context, origin, &(struct um_model_changes){.key = &gold, .nkey = 1},
                               &variant));
  assert_ptr_not_equal(variant->library, origin->library);
  assert_int_equal(um_materials_library_count(origin->library), 1);
  assert_string_equal(um_materials_name(variant->material[0]), "gold");
  um_model_destroy(context, &variant);
  assert_int_equal(um_model_variant_create(context, origin,
                                           &(struct um_model_changes){.key = &none, .nkey = 1},
                                           &variant),
                   UM_ERR_REFUSED);
  assert_non_null(strstr(um_core_message(context), "did you mean gold"));
  um_model_destroy(context, &origin);
}

/* Light in a band in which nothing was measured is said; a record that claims nothing is not. */
static void bands_beyond_what_was_measured(void **state)
{
  (void)state;
  static const struct {
    const char *override;
    int warnings;
  } cases[] = {{"parts.box.outside=gold", 0},
               {"parts.box.outside=white_paint", 0},
               {"parts.box.outside=steel_austenitic", 1},
               {"parts.box.outside=mylar_aluminium_6um", 0}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct um_model *model = NULL;
    const struct um_model_options options = {.overrides = &cases[i].override, .noverride = 1};
    warnings = 0;
    need(um_model_create(context, path, &options, &model));
    if (warnings != cases[i].warnings) fail_msg("%s: %s", cases[i].override, logged);
    if (warnings > 0)
      assert_non_null(strstr(logged, "band lwir, 8 to 12 um: material steel_austenitic is measured "
                                     "from 0.24 to 2.5 um only"));
    um_model_destroy(context, &model);
  }
}

static int set_up(void **state)
{
  if (um_test_folder_create(base) != 0) return -1;
  snprintf(path, sizeof path, "%s/scenario.yaml", base);
  FILE *file = fopen(path, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  fclose(file);
  if (context_set_up(state) != 0) return -1;
  um_core_log_set_sink(context, keep_log, NULL);
  return 0;
}

static int tear_down(void **state)
{
  remove(path);
  return um_test_folder_remove(base) == 0 ? context_tear_down(state) : -1;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(reads_what_it_names),
                                     cmocka_unit_test(bands_beyond_what_was_measured)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
