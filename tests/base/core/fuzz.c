/* Damaged input: cut off at every byte, and with random bytes changed. Nothing may crash; every
 * refusal has a status of the list and a one-line message; nothing is left allocated (the build
 * with sanitizers sees that). The damage is keyed by index and the same in every run. */
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/sampling.h"
#include "tests/base/document/sample_schema.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define FLIPS 4000

static const char csv_text[] = "# comment\ntime_utc,quantity,\"of\",value,sigma\n"
                               "2016-09-21T20:36:40.000Z,band_irradiance,lwir,1.23e-10,2.0e-12\r\n"
                               "\n2016-09-21T20:36:41.000Z,\"a \"\"b\"\"\",lwir,-1,\n";

static void check_failure(enum um_status status)
{
  assert_true(status == UM_ERR_INPUT || status == UM_ERR_IO || status == UM_ERR_LIBRARY);
  const char *message = um_core_message(context);
  assert_true(message[0] != '\0');
  assert_null(strpbrk(message, "\n\r"));
}

static bool try_csv(const char *text, size_t length)
{
  struct um_core_csv *csv;
  um_core_message_clear(context);
  enum um_status status = um_core_csv_parse(context, "fuzz.csv", text, length, &csv);
  if (status != UM_OK) {
    check_failure(status);
    return false;
  }
  for (size_t i = 0; i < um_core_csv_rows(csv); i++)
    for (size_t j = 0; j < um_core_csv_columns(csv); j++) {
      double v;
      (void)um_core_csv_number(context, csv, i, j, &v);
      assert_true(um_core_csv_line(csv, i) >= 1);
    }
  um_core_csv_destroy(&csv);
  return true;
}

static bool try_yaml(const char *text, const char *set)
{
  struct um_document *document;
  void *root;
  um_core_message_clear(context);
  enum um_status status = um_document_parse(context, "fuzz.yaml", text, &sample_schema, &set,
                                            set != NULL ? 1 : 0, &document, &root);
  if (status != UM_OK) {
    check_failure(status);
    assert_null(document);
    return false;
  }
  char *again;
  assert_int_equal(um_document_text(context, document, &again), UM_OK);
  um_core_free(context, again);
  um_document_destroy(&document);
  return true;
}

/* Change up to four bytes: to any value, to a character YAML or CSV cares for, or by one bit. */
static void damage(char *text, size_t length, uint64_t index)
{
  static const char special[] = "{}[]:,-#&*!|>'\"%@`?\n\t \r\\~0.=";
  uint64_t h = um_core_hash(index, 77);
  for (uint64_t k = 0; k <= h % 4; k++) {
    uint64_t r = um_core_hash(h, k);
    size_t at = (size_t)((r >> 8) % length);
    unsigned kind = (unsigned)(r & 3), value = (unsigned)((r >> 40) & 0xff);
    if (kind == 0)
      text[at] = (char)value;
    else if (kind == 1)
      text[at] = (char)(text[at] ^ (1 << (value % 8)));
    else
      text[at] = special[value % (sizeof special - 1)];
  }
}

static void test_csv(void **state)
{
  (void)state;
  size_t n = strlen(csv_text), accepted = 0;
  assert_true(try_csv(csv_text, n));
  for (size_t i = 0; i < n; i++) {
    /* an exact copy on the heap, so that a read behind the end is seen */
    char *cut = malloc(i + 1);
    assert_non_null(cut);
    memcpy(cut, csv_text, i);
    (void)try_csv(cut, i);
    free(cut);
  }
  char text[sizeof csv_text];
  for (uint64_t i = 0; i < FLIPS; i++) {
    memcpy(text, csv_text, sizeof text);
    damage(text, n, i);
    accepted += try_csv(text, n);
  }
  print_message("csv: %zu of %d damaged texts were still valid\n", accepted, FLIPS);
}

static void test_yaml(void **state)
{
  (void)state;
  size_t n = strlen(sample_text), accepted = 0;
  char *text = malloc(n + 1);
  assert_non_null(text);
  assert_true(try_yaml(sample_text, NULL));
  for (size_t i = 0; i < n; i++) {
    char *cut = malloc(i + 1);
    assert_non_null(cut);
    memcpy(cut, sample_text, i);
    cut[i] = '\0';
    (void)try_yaml(cut, NULL);
    free(cut);
  }
  for (uint64_t i = 0; i < FLIPS; i++) {
    memcpy(text, sample_text, n + 1);
    damage(text, n, i);
    accepted += try_yaml(text, i % 2 == 0 ? NULL : "parts.bus.lumped=true");
  }
  free(text);
  print_message("yaml: %zu of %d damaged texts were still valid\n", accepted, FLIPS);
}

static void test_overrides(void **state)
{
  (void)state;
  static const char *const sources[] = {"parts.bus={name: bus, size_m: [1, 2, 3], lumped: true}",
                                        "effects.panel:bus.efficiency=0.25",
                                        "materials.mli.emittance=0.5"};
  size_t accepted = 0;
  for (uint64_t i = 0; i < FLIPS / 2; i++) {
    char text[128];
    const char *source = sources[i % 3];
    size_t n = strlen(source);
    memcpy(text, source, n + 1);
    damage(text, n, i);
    accepted += try_yaml(sample_text, text);
  }
  print_message("overrides: %zu of %d damaged texts were still valid\n", accepted, FLIPS / 2);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_csv),
      cmocka_unit_test(test_yaml),
      cmocka_unit_test(test_overrides),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
