/* study.yaml by itself: what is read, how many points that makes, what is refused and in which
 * words. */
#include <math.h>
#include <string.h>

#include "study/file.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define HEAD "schema: 1\nname: n\nscenario: s\n"
#define ONE  "parameters: [{key: a.b, from: 0, to: 1}]\n"
#define TWO                                                                                        \
  "parameters: [{key: a.b, from: 0, to: 1}, {material: m, property: emittance, from: 0.1, to: "    \
  "0.9}]\n"

static const struct {
  const char *text;
  double points;
} counted[] = {
    {ONE "design: {points: 7}\n", 7},
    {ONE "design: saltelli\n", 300},
    {TWO "design: {kind: saltelli, points: 8}\n", 32},
    {TWO "design: {kind: morris, points: 5}\n", 15},
    {TWO "design: {kind: one_at_a_time, levels: 6}\n", 13},
    {TWO "design: {kind: grid, levels: 6}\n", 36},
    {"parameters: [{key: a, values: [1, 2, 3]}, {key: b, from: 0, to: 1, levels: 4}]\n"
     "design: grid\n",
     12},
    {"parameters: [{key: a, values: [1, 2, 3]}, {key: b, values: [4, 5, 6]}]\ndesign: list\n", 3},
};

static void test_counted(void **state)
{
  (void)state;
  for (size_t i = 0; i < sizeof counted / sizeof counted[0]; i++) {
    char text[1000];
    struct um_document *document = NULL;
    struct um_study_file *file = NULL;
    snprintf(text, sizeof text, HEAD "%s", counted[i].text);
    if (um_study_file_parse(context, "s.yaml", text, &document, &file) != UM_OK)
      fail_msg("%s: %s", counted[i].text, um_core_message(context));
    double points = um_study_file_points(file);
    if (points != counted[i].points) fail_msg("%s: %g points", counted[i].text, points);
    um_document_destroy(&document);
  }
}

static const struct {
  const char *text, *words;
} refused[] = {
    {"parameters: []\n", "none; accepted: 1 to"},
    {"parameters: [{from: 0, to: 1}]\n", "key"},
    {"parameters: [{key: a, material: m, from: 0, to: 1}]\n", "material"},
    {"parameters: [{key: a, from: 1, to: 1}]\n", "a"},
    {"parameters: [{key: a, from: 2, to: 1}]\n", "a"},
    {"parameters: [{key: a}]\n", "a"},
    {"parameters: [{key: a, distribution: normal, mean: 1, sigma: 0}]\n", "sigma"},
    {"parameters: [{key: a, distribution: normal, mean: 1}]\n", "sigma"},
    {"parameters: [{key: a, distribution: log_uniform, from: 0, to: 1}]\n", "a"},
    {"parameters: [{key: a, values: [1]}]\n", "one value has no width"},
    {"parameters: [{key: a, values: [1, 2], from: 0}]\n", "beside from or to"},
    {"parameters: [{material: m, from: 0, to: 1}]\n", "property: emittance or absorptance"},
    {"parameters: [{key: a, property: emittance, from: 0, to: 1}]\n", "of no material"},
    {"parameters: [{key: a, target: b, from: 0, to: 1}]\n", "of no effect"},
    {"parameters: [{key: a, from: 0, to: 1}, {key: a, from: 0, to: 2}]\n", "already listed"},
    {ONE "design: {kind: sobol, points: 1000000000}\n", "1e+09 points; accepted: at most 1000000"},
    {TWO "design: {kind: grid, levels: 40000}\n", "1.6e+09 points"},
    {ONE "design: {kind: morris, levels: 5}\n", "even"},
    {ONE "design: list\n", "values for every parameter"},
    {"parameters: [{key: a, values: [1, 2, 3]}, {key: b, values: [4, 5]}]\ndesign: list\n",
     "2 values beside 3"},
    {"parameters: [{key: a, values: [1, 2, 3]}]\nmode: surrogate\n", "nothing between them"},
    {"parameters: [{key: a, from: 1, to: 2}]\nmode: surrogate\nevaluations: 30\n",
     "accepted: more than 30"},
    {ONE "mode: guess\n", "exact"},
    {ONE "error: {light: 0}\n", "light"},
    {ONE "outputs: {bands: vis}\n", "bands"},
    {ONE "desing: grid\n", "design"},
};

static void test_refused(void **state)
{
  (void)state;
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    char text[1000];
    struct um_document *document = NULL;
    struct um_study_file *file = NULL;
    snprintf(text, sizeof text, HEAD "%s", refused[i].text);
    enum um_status status = um_study_file_parse(context, "s.yaml", text, &document, &file);
    const char *message = um_core_message(context);
    if (status != UM_ERR_INPUT || strncmp(message, "s.yaml:", 7) != 0 ||
        strstr(message, refused[i].words) == NULL || strchr(message, '\n') != NULL)
      fail_msg("%s -> %d %s", refused[i].text, (int)status, message);
    assert_null(document);
    assert_null(file);
    um_core_message_clear(context);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_counted),
                                     cmocka_unit_test(test_refused)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
