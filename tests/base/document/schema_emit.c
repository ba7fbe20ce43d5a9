/* The reference page and the JSON Schema of the sample schema: every key, unit, default and bound
 * must be on the page, and the JSON must be JSON (parsed strictly by libfyaml) with the right
 * members. */
#include <libfyaml.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/base/document/sample_schema.h"
#include "tests/support/cmocka_all.h"

static char *emit(enum um_status (*writer)(FILE *, const struct um_schema_object *))
{
  char *text = NULL;
  size_t size = 0;
  FILE *file = open_memstream(&text, &size);
  assert_non_null(file);
  assert_int_equal(writer(file, &sample_schema), UM_OK);
  assert_int_equal(fclose(file), 0);
  return text;
}

static void test_markdown(void **state)
{
  (void)state;
  char *text = emit(um_document_schema_write_markdown);
  static const char *const lines[] = {
      "# scenario\n\nA sample.\n",
      "| `name` | a text | required | Name of the \"scenario\". |\n",
      "| `tle` | a text | one of group 1 |  (group 1) |\n",
      "| `time` | time | required |  |\n",
      "| `parts` | list of part | none |  |\n",
      "| `materials` | names, each a material | none |  |\n",
      "| `orbits` | a whole number, at least 1, at most 99 | 4 |  |\n",
      "## shell\n\nStands at `parts[].shell`.\n",
      "## material\n\nStands at `materials.NAME`.\n",
      "| `step_s` | a finite number, more than 0 | 1 | Step. |\n",
      "| `size_m` | a list of 3 finite numbers, at least 0, at most 100 | none |  |\n",
      "| `model` | none, clear_sky | required |  |\n",
      "| `emittance` | a finite number, at least 0, at most 1 | none | Emittance \\| "
      "hemispherical. "
      "|\n",
      " A plain value stands for `{model: value}`.",
      "\nKeys of one group exclude each other.\n",
  };
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++)
    if (strstr(text, lines[i]) == NULL) fail_msg("missing: %s\nin\n%s", lines[i], text);
  free(text);
}

static void check_path(struct fy_document *json, const char *path, const char *expected)
{
  struct fy_node *node = fy_node_by_path(fy_document_root(json), path, FY_NT, FYNWF_DONT_FOLLOW);
  if (node == NULL) fail_msg("missing: %s", path);
  char *text = fy_emit_node_to_string(node, FYECF_MODE_JSON_ONELINE | FYECF_NO_ENDING_NEWLINE);
  assert_non_null(text);
  assert_string_equal(text, expected);
  free(text);
}

static void test_json(void **state)
{
  (void)state;
  char *text = emit(um_document_schema_write_json);
  struct fy_parse_cfg cfg = {NULL, FYPCF_QUIET | FYPCF_JSON_FORCE, NULL, NULL};
  struct fy_document *json = fy_document_build_from_string(&cfg, text, FY_NT);
  if (json == NULL) fail_msg("not JSON:\n%s", text);
  static const char *const cases[][2] = {
      {"/$schema", "\"https://json-schema.org/draft/2020-12/schema\""},
      {"/type", "\"object\""},
      {"/additionalProperties", "false"},
      {"/required", "[\"name\", \"time\"]"},
      {"/allOf", "[{\"oneOf\": [{\"required\": [\"tle\"]}, {\"required\": [\"altitude_km\"]}]}]"},
      {"/properties/name/description", "\"Name of the \\\"scenario\\\".\""},
      {"/properties/orbits",
       "{\"type\": \"integer\", \"minimum\": 1, \"maximum\": 99, \"default\": "
       "4}"},
      {"/properties/time/properties/step_s/exclusiveMinimum", "0"},
      {"/properties/time/required", "[\"start\"]"},
      {"/properties/levels/items/type", "\"number\""},
      {"/properties/parts/items/properties/size_m/minItems", "3"},
      {"/properties/parts/items/properties/size_m/items/maximum", "100"},
      {"/properties/materials/additionalProperties/properties/emittance/maximum", "1"},
      {"/properties/atmosphere/anyOf/0/enum", "[\"none\", \"clear_sky\"]"},
      {"/properties/atmosphere/anyOf/1/properties/visibility_km/default", "23"},
      {"/properties/verbose", "{\"type\": \"boolean\", \"default\": false}"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    check_path(json, cases[i][0], cases[i][1]);
  fy_document_destroy(json);
  free(text);
}

/* A full disk is told. */
static void test_write_error(void **state)
{
  (void)state;
  FILE *file = fopen("/dev/full", "wb");
  if (file == NULL) {
    print_message("skipped: this system has no /dev/full\n");
    skip();
  }
  setvbuf(file, NULL, _IONBF, 0);
  assert_int_equal(um_document_schema_write_json(file, &sample_schema), UM_ERR_IO);
  assert_int_equal(um_document_schema_write_markdown(file, &sample_schema), UM_ERR_IO);
  fclose(file);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_markdown),
      cmocka_unit_test(test_json),
      cmocka_unit_test(test_write_error),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
