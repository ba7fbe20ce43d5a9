/* The pictures of a diagnosis that is filled by hand: titles say what its verdict says. */
#include <dirent.h>

#include "evidence/diagnosis/report/plot.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "tests/evidence/diagnosis/report_test.h"

/* Whatever gnuplot, where there is one, has drawn. */
static void remove_pictures(void)
{
  static const char *const kinds[] = {".png", ".svg", ".pdf"};
  char path[300];
  DIR *folder = opendir("out");
  assert_non_null(folder);
  for (struct dirent *entry; (entry = readdir(folder)) != NULL;)
    for (size_t k = 0; k < 3; k++) {
      if (strstr(entry->d_name, kinds[k]) == NULL) continue;
      snprintf(path, sizeof path, "out/%s", entry->d_name);
      remove(path);
    }
  closedir(folder);
}

/* What pictures say of the verdict is what the verdict says: an effect that was not found is not
 * said to be, and what cannot be told apart stands side by side. */
static void test_titles(void **state)
{
  (void)state;
  struct world w;
  char text[200];
  world_make(&w);
  struct um_sensitivity_candidates *candidates = w.d.candidates;
  const struct {
    enum um_diagnosis_verdict verdict;
    size_t naddition;
    bool chosen;
    enum um_diagnosis_confidence confidence;
    bool not_tried;
    const char *says;
  } cases[] = {
      {UM_VERDICT_COMPLETE, 0, false, UM_CONFIDENCE_CERTAIN, false, "complete, nothing added"},
      {UM_VERDICT_FOUND, 2, false, UM_CONFIDENCE_CERTAIN, false,
       "found: internal_power of bus, panel_extraction of panel"},
      {UM_VERDICT_FOUND, 1, true, UM_CONFIDENCE_CERTAIN, false, "fitted: internal_power of bus"},
      {UM_VERDICT_NOT_IDENTIFIABLE, 1, false, UM_CONFIDENCE_ONE_OF_GROUP, false,
       "not identifiable: internal_power of bus (drawn) or emittance:grey_white"},
      {UM_VERDICT_NOT_IDENTIFIABLE, 1, false, UM_CONFIDENCE_ONE_OF_GROUP, true,
       "not identifiable: internal_power of bus, 1 not tried"},
      {UM_VERDICT_NOT_IDENTIFIABLE, 1, false, UM_CONFIDENCE_UNCERTAIN, false,
       "not identifiable: internal_power of bus (not certain)"},
      {UM_VERDICT_NOT_IDENTIFIABLE, 0, false, UM_CONFIDENCE_CERTAIN, false,
       "not identifiable, nothing added: a nuisance took it up"},
      {UM_VERDICT_UNEXPLAINED, 1, false, UM_CONFIDENCE_CERTAIN, false,
       "unexplained, even with internal_power of bus"},
      {UM_VERDICT_UNEXPLAINED, 0, false, UM_CONFIDENCE_CERTAIN, false,
       "unexplained, nothing added"},
      {UM_VERDICT_UNEXPLAINED, 1, true, UM_CONFIDENCE_CERTAIN, false,
       "fitted, and not explained by: internal_power of bus"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    w.d.verdict = cases[i].verdict;
    w.d.naddition = cases[i].naddition;
    w.d.candidates = cases[i].chosen ? NULL : candidates;
    w.step[0].confidence = cases[i].confidence;
    w.alternative[1].not_tried = cases[i].not_tried;
    w.alternative[1].indistinguishable = !cases[i].not_tried;
    um_diagnosis_report_plot_verdict(&w.d, text, sizeof text);
    assert_string_equal(text, cases[i].says);
  }
  w.d.candidates = candidates;
  w.d.naddition = 2;
  w.d.verdict = UM_VERDICT_NOT_IDENTIFIABLE;
  w.step[0].confidence = UM_CONFIDENCE_ONE_OF_GROUP;
  w.unexplained.found = false;
  write_out(&w);
  assert_ok(um_diagnosis_report_plot(context, &w.d, "out"));
  char *script = read_text("out/plots.gp");
  static const char *const want[] = {
      ("'not identifiable: internal_power of bus (drawn) or emittance:grey_white, "
       "panel_extraction of panel'"),
      "'pass: band irradiance lwir: rms ",
      "'explains only a part: heat of bus.interior: pulse of 4400 ± 300 J'"};
  expect_in(script, want, sizeof want / sizeof want[0]);
  assert_null(strstr(script, "'with "));
  um_core_free(context, script);
  remove_pictures();
  remove_out();
  world_end(&w);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_titles)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
