/* Studies whose surrogate does not reach what is asked: they end with a result all the same, and
 * what it states holds at points that had no say. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/uncertainty/surrogate.h"
#include "study/shortfall.h"
#include "study/statistics.h"
#include "study/study_impl.h"
#include "tests/study/world.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

/* Attitude and a size beside what moves heat alone: 11 terms, no more, follow four parameters. */
#define SHORT                                                                                      \
  "mode: surrogate\n"                                                                              \
  "evaluations: 44\n"                                                                              \
  "parameters:\n"                                                                                  \
  "  - {material: grey_panel, property: emittance, from: 0.6, to: 0.9}\n"                          \
  "  - {key: parts.box.interior.power_W, from: 0, to: 100}\n"                                      \
  "  - {effect: attitude_offset, parameter: z_deg, from: -40, to: 40}\n"                           \
  "  - {key: parts.wing.plate.size_m.1, from: 0.9, to: 1.1}\n"                                     \
  "outputs: {bands: [vis, lwir], places: [box, wing.front]}\n"
#define DESIGN "design: {kind: latin_hypercube, points: 200, seed: 7}\n"
enum { POINTS = 200, FRESH = 20 };

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static struct um_study_result *run(const char *text, int workers, struct um_study **study)
{
  world_clear(context);
  return world_run(context, text, workers, false, study);
}

static void release(struct um_study **study, struct um_study_result **result)
{
  um_study_result_destroy(context, result);
  um_study_destroy(context, study);
  world_clear(context);
}

/* Which points of the design were solved: those that have a quantity that is withheld elsewhere. */
static bool is_solved(const struct um_study_result *r, size_t point, size_t withheld)
{
  return !isnan(um_study_result_values(r, point, &r->quantity[withheld])[0]);
}

/* Share of a quantity's values that are off by more than is stated, at points that nothing was made
 * of, solved now. */
static double beyond(struct um_study *study, const struct um_study_result *r, size_t q,
                     size_t withheld)
{
  double share = 0.0, *own = malloc(r->nvalue * sizeof *own);
  size_t fresh = 0;
  assert_non_null(own);
  for (size_t i = 0; i < r->npoint && fresh < FRESH; i++) {
    if (is_solved(r, i, withheld)) continue;
    need(um_study_point(context, study, r->parameter + i * r->nparameter, own));
    fresh++;
    const double *value = um_study_result_values(r, i, &r->quantity[q]);
    const struct um_variant_curve *of = &study->curve[q];
    for (size_t k = 0; k < r->ntime; k++) {
      double at = own[r->quantity[q].first + k];
      double unit = of->relative ? fmax(fabs(at), of->floor) : 1.0;
      share += fabs(value[k] - at) > r->error[q] * unit ? 1.0 / (double)(FRESH * r->ntime) : 0.0;
    }
  }
  free(own);
  assert_int_equal(fresh, FRESH);
  return share;
}

/* Light is withheld, by name: it has no polynomial of so few terms. Temperatures have one, whose
 * error is more than asked, said, and holds. Light's statistics are those of the solved points. */
static void test_withheld(void **state)
{
  (void)state;
  struct um_study *study = NULL;
  struct um_study_result *r = run(SHORT DESIGN, 1, &study);
  char *text = NULL, name[80];
  need(um_study_shortfall(context, r, &text));
  print_message("%s\n", text);
  assert_non_null(r->falls_short);
  assert_int_equal(r->npoint, POINTS);
  assert_int_equal(r->exact, 44);
  assert_true(r->nsolved >= 20 && r->nsolved < 44);
  assert_true(r->quantity[0].withheld && !r->quantity[3].withheld);
  for (size_t q = 0; q < 4; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    size_t has = 0;
    for (size_t i = 0; i < POINTS; i++) has += isnan(um_study_result_values(r, i, of)[3]) ? 0 : 1;
    assert_int_equal(has, of->withheld ? r->nsolved : POINTS);
    assert_int_equal(um_study_points_of(r, of), has);
    assert_true(of->withheld == (of->unexplained > UM_STUDY_BORNE));
    snprintf(name, sizeof name, "%s: from the %zu points", of->name, r->nsolved);
    assert_true(of->withheld == (strstr(text, name) != NULL));
    snprintf(name, sizeof name, "%s: error at most", of->name);
    assert_true((r->error[q] > of->asked) == (strstr(text, name) != NULL));
    double left = study->accuracy.error[q];
    if (!of->withheld)
      left += um_uncertainty_surrogate_errors(r->surrogate)[q].stated *
              (of->asked - fmin(left, 0.3 * of->asked));
    assert_close(r->error[q], left, 1e-12);
    if (of->withheld) continue;
    double share = beyond(study, r, q, 0);
    print_message("%s: %.4f of the values beyond %.3g\n", of->name, share, r->error[q]);
    assert_true(r->error[q] > of->asked && share <= 0.01);
  }
  um_core_free(context, text);
  release(&study, &r);
}

/* What is said of them. */
static void test_statistics(void **state)
{
  (void)state;
  struct um_study *study = NULL;
  struct um_study_statistics *l;
  struct um_study_result *r = run(SHORT DESIGN, 1, &study);
  size_t n = r->nparameter, lit = 3, warm = 3 * r->ntime + 3;
  double sum = 0.0, *own = malloc(r->nvalue * sizeof *own);
  need(um_study_statistics_create(context, r, NULL, &l));
  for (size_t i = 0; i < POINTS; i++) {
    if (!is_solved(r, i, 0)) continue;
    need(um_study_point(context, study, r->parameter + i * n, own)); /* its own, to the bit */
    assert_true(own[lit] == r->value[i * r->nvalue + lit]);
    assert_true(own[warm] == r->value[i * r->nvalue + warm]);
    sum += own[lit];
  }
  free(own);
  assert_close(l->mean[lit], sum / (double)r->nsolved, 1e-12 * l->mean[lit]);
  for (size_t i = 0; i < n; i++) {
    size_t at = i * r->nvalue;
    assert_true(isnan(l->first[at + lit]) && isnan(l->first_error[at + lit]));
    assert_true(isfinite(l->correlation[at + lit]));
    assert_true(isfinite(l->first[at + warm]) && l->first_error[at + warm] > 0.0);
    assert_true(isnan(l->over_curve[i * r->nquantity]));
    assert_true(isfinite(l->over_curve[i * r->nquantity + 3]));
  }
  um_study_statistics_destroy(context, &l);
  release(&study, &r);
}

/* Where it bears nothing, the solved points are the result; any number of processes the same. */
static void test_none(void **state)
{
  (void)state;
  static const char text[] =
      "mode: surrogate\nevaluations: 44\nparameters:\n"
      "  - {effect: attitude_offset, parameter: z_deg, from: -170, to: 170}\n"
      "  - {key: parts.wing.plate.size_m.1, from: 0.9, to: 1.1}\n"
      "outputs: {bands: [vis, lwir]}\n"
      "design: {kind: sobol, points: 60, seed: 7}\n";
  struct um_study *study[2] = {NULL, NULL};
  struct um_study_result *a = run(text, 1, &study[0]), *b = run(text, 2, &study[1]);
  char *words = NULL;
  need(um_study_shortfall(context, a, &words));
  print_message("%s\n", words);
  assert_non_null(strstr(words, "no surrogate: "));
  um_core_free(context, words);
  assert_null(a->surrogate);
  assert_int_equal(a->wanted, 60);
  assert_true(a->npoint >= 20 && a->npoint < 44 && a->npoint == a->nsolved);
  for (size_t q = 0; q < 2; q++) assert_true(a->quantity[q].withheld);
  for (size_t i = 0; i < a->npoint * a->nvalue; i++) assert_true(isfinite(a->value[i]));
  assert_int_equal(a->npoint, b->npoint);
  assert_memory_equal(a->value, b->value, a->npoint * a->nvalue * sizeof(double));
  release(&study[0], &a);
  release(&study[1], &b);
}

/* A surrogate wants every point. Where one fails, as many as are allowed are solved by themselves,
 * and those that fail say why. */
static void test_failed(void **state)
{
  (void)state;
  struct um_study *study = NULL;
  struct um_study_result *r = run("mode: surrogate\nevaluations: 60\nparameters:\n"
                                  "  - {key: bands.vis.from_um, from: 0.30, to: 0.60}\n"
                                  "  - {key: bands.vis.to_um, from: 0.45, to: 0.80}\n"
                                  "outputs: {bands: [vis]}\n"
                                  "design: {kind: grid, levels: 20}\n",
                                  1, &study);
  size_t failed = 0;
  print_message("%zu points: %s\n", r->npoint, r->falls_short);
  assert_non_null(strstr(r->falls_short, "wants every point"));
  assert_null(r->surrogate);
  assert_true(r->npoint >= 15 && r->npoint <= 60 && r->exact <= 60);
  for (size_t i = 0; i < r->npoint; i++) {
    bool none = r->parameter[2 * i] >= r->parameter[2 * i + 1];
    assert_true(none == (r->reason[i] != NULL) && none == isnan(r->value[i * r->nvalue + 3]));
    failed += none;
  }
  assert_true(failed > 0 && failed < r->npoint);
  release(&study, &r);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_withheld),
                                     cmocka_unit_test(test_statistics), cmocka_unit_test(test_none),
                                     cmocka_unit_test(test_failed)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
