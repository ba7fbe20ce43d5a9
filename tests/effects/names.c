/* A parameter by the name it had before: in a scenario and on the command line it means what the
 * present one means, with one warning a use; both names of one parameter are refused. */
#include <stdlib.h>
#include <string.h>

#include "model/build/scenario_text.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define WARNING                                                                                    \
  "effect emittance: parameter emittance_factor is now called factor; the old name is accepted "   \
  "until 0.6"
#define ENTRY "effects:\n  - {effect: emittance, target: grey_panel, "

static int warnings(void)
{
  int n = 0;
  for (const char *at = um_core_log_text(case_context()); (at = strstr(at, WARNING)) != NULL; at++)
    n++;
  return n;
}

/* The plate with an entry of the effect, and what --with says of it; so many warnings. */
static struct case_run run(const char *rest, const char *with, int warned)
{
  char text[4096];
  snprintf(text, sizeof text, "%s%s%s", case_plate, rest != NULL ? ENTRY : "",
           rest != NULL ? rest : "");
  um_core_log_clear(case_context());
  struct case_run out = case_with(text, with);
  assert_int_equal(warnings(), warned);
  return out;
}

static void former_names_mean_the_same(void **state)
{
  (void)state;
  struct case_run plain = run(NULL, NULL, 0), listed = run("factor: 0.9}\n", NULL, 0);
  struct case_run other[] = {
      run(NULL, "emittance:grey_panel,factor=0.9", 0),
      run(NULL, "emittance:grey_panel,emittance_factor=0.9", 1),
      run("emittance_factor: 0.9}\n", NULL, 1),
      run("emittance_factor: 0.7}\n", "emittance:grey_panel,factor=0.9", 1),
      run("factor: 0.7}\n", "emittance:grey_panel,emittance_factor=0.9", 1),
      run("emittance_factor: 0.7}\n", "emittance:grey_panel,emittance_factor=0.9", 2),
  };
  assert_false(case_same(&plain, &listed));
  for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
    if (!case_same(&listed, &other[i])) fail_msg("case %zu is another run", i);
    case_release(&other[i]);
  }
  case_release(&plain);
  case_release(&listed);
}

static void both_names_are_refused(void **state)
{
  (void)state;
  char text[4096];
  const char *const words =
      "effect 'emittance': emittance_factor and factor are one parameter; accepted: factor alone";
  snprintf(text, sizeof text, "%s" ENTRY "factor: 0.9, emittance_factor: 0.9}\n", case_plate);
  case_refused(text, NULL, words);
  case_refused(text, NULL, ".yaml:");
  case_refused(case_plate, "emittance:grey_panel,emittance_factor=0.9,factor=0.9", words);
}

/* A scenario that is written out has each parameter once, by the name that its user wrote. */
static void written_out_once(void **state)
{
  (void)state;
  char *text;
  struct case_run a = run("emittance_factor: 0.7}\n", "emittance:grey_panel,factor=0.9", 1);
  assert_int_equal(um_model_scenario_text(case_context(), a.model, a.model->effect,
                                          a.model->neffect, NULL, ".", &text),
                   UM_OK);
  assert_non_null(strstr(text, "emittance_factor: 0.9"));
  struct case_run b = case_with(text, NULL);
  assert_true(case_same(&a, &b));
  um_core_free(case_context(), text);
  case_release(&a);
  case_release(&b);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(former_names_mean_the_same),
      cmocka_unit_test(both_names_are_refused),
      cmocka_unit_test(written_out_once),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
