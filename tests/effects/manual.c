/* docs/effects.md is what the descriptors say. With UMBRA_WRITE_DOCS set it is written anew. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "effects/effects.h"
#include "tests/support/cmocka_all.h"

#define PAGE UMBRA_SOURCE_DIR "/docs/effects.md"

static void page_is_up_to_date(void **state)
{
  (void)state;
  char kept[2048], made[2048];
  if (getenv("UMBRA_WRITE_DOCS") != NULL) {
    FILE *page = fopen(PAGE, "w");
    assert_non_null(page);
    um_effects_write_manual(page);
    assert_int_equal(fclose(page), 0);
  }
  FILE *page = fopen(PAGE, "r"), *fresh = tmpfile();
  if (page == NULL) fail_msg("docs/effects.md is missing; run this test with UMBRA_WRITE_DOCS=1");
  assert_non_null(fresh);
  um_effects_write_manual(fresh);
  rewind(fresh);
  for (int line = 1;; line++) {
    const char *a = fgets(kept, sizeof kept, page), *b = fgets(made, sizeof made, fresh);
    if (a == NULL && b == NULL) break;
    if (a == NULL || b == NULL || strcmp(kept, made) != 0)
      fail_msg("docs/effects.md:%d is not what the effects say; run this test with "
               "UMBRA_WRITE_DOCS=1",
               line);
  }
  fclose(page);
  fclose(fresh);
}

static void write_to(char *out, size_t size, const struct um_effect *effect)
{
  FILE *file = tmpfile();
  assert_non_null(file);
  um_effects_write_markdown(file, effect);
  rewind(file);
  size_t n = fread(out, 1, size - 1, file);
  out[n] = '\0';
  fclose(file);
}

/* A page holds all of its descriptor, for switches and for effects with a target. */
static void page_holds_the_descriptor(void **state)
{
  (void)state;
  char page[4096];
  write_to(page, sizeof page, um_effects_find("albedo"));
  assert_non_null(strstr(page, "on by default"));
  assert_non_null(strstr(page, "{effect: albedo, off: true}"));
  assert_non_null(strstr(page, "--without albedo`"));
  const struct um_effect *e = um_effects_find("panel_extraction");
  write_to(page, sizeof page, e);
  assert_non_null(strstr(page, e->summary));
  assert_non_null(strstr(page, e->reference));
  assert_non_null(strstr(page, e->validity));
  assert_non_null(strstr(page, e->parameters[0].help));
  assert_non_null(strstr(page, "| `efficiency` | 1 | 0 | 0.18 | -0.4 to 0.4 | 0.15 |"));
  assert_non_null(strstr(page, "--with panel_extraction:PART,efficiency=0.18`"));
  write_to(page, sizeof page, um_effects_find("internal_power"));
  assert_non_null(strstr(page, "| none |"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(page_is_up_to_date),
      cmocka_unit_test(page_holds_the_descriptor),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
