/* docs/effects.md is what the descriptors say. With UMBRA_WRITE_DOCS set it is written anew. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/client.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_session.h"

#define PAGE UMBRA_SOURCE_DIR "/docs/effects.md"

static void page_is_up_to_date(void **state)
{
  (void)state;
  char kept[2048], made[2048];
  if (getenv("UMBRA_WRITE_DOCS") != NULL) {
    FILE *page = fopen(PAGE, "w");
    assert_non_null(page);
    um_app_effect_manual(page, umbra);
    assert_int_equal(fclose(page), 0);
  }
  FILE *page = fopen(PAGE, "r"), *fresh = tmpfile();
  if (page == NULL) fail_msg("docs/effects.md is missing; run this test with UMBRA_WRITE_DOCS=1");
  assert_non_null(fresh);
  um_app_effect_manual(fresh, umbra);
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

static const struct umbra_effect *write_to(char *out, size_t size, const char *name)
{
  const struct umbra_effect *effect;
  FILE *file = tmpfile();
  assert_non_null(file);
  assert_int_equal(umbra_effect_find(umbra, name, &effect), UMBRA_OK);
  um_app_effect_page(file, effect);
  rewind(file);
  size_t n = fread(out, 1, size - 1, file);
  out[n] = '\0';
  fclose(file);
  return effect;
}

/* A page holds all of its descriptor, for switches and for effects with a target. */
static void page_holds_the_descriptor(void **state)
{
  (void)state;
  char page[4096];
  write_to(page, sizeof page, "albedo");
  assert_non_null(strstr(page, "on by default"));
  assert_non_null(strstr(page, "{effect: albedo, off: true}"));
  assert_non_null(strstr(page, "--without albedo`"));
  const struct umbra_effect *e = write_to(page, sizeof page, "panel_extraction");
  assert_non_null(strstr(page, e->summary));
  assert_non_null(strstr(page, e->reference));
  assert_non_null(strstr(page, e->validity));
  assert_non_null(strstr(page, e->parameter[0].help));
  assert_non_null(strstr(page, "| `efficiency` | 1 | 0 | 0.18 | -0.4 to 0.4 | 0.15 |"));
  assert_non_null(strstr(page, "--with panel_extraction:PART,efficiency=0.18`"));
  write_to(page, sizeof page, "internal_power");
  assert_non_null(strstr(page, "| none |"));
}

static void page_of_an_effect_of_ones_own(void **state)
{
  (void)state;
  char page[4096];
  assert_int_equal(umbra_effects_load(umbra, PILEUP), UMBRA_OK);
  write_to(page, sizeof page, "pileup");
  assert_non_null(strstr(page, "## pileup"));
  assert_non_null(strstr(page, "- told apart from roughness and exposure"));
  assert_non_null(strstr(page, "--with pileup,q_m2_W=-1e+08`"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(page_is_up_to_date, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(page_holds_the_descriptor, session_set_up, session_tear_down),
      cmocka_unit_test_setup_teardown(page_of_an_effect_of_ones_own, session_set_up,
                                      session_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
