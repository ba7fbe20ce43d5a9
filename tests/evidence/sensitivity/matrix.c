/* The matrix of derivatives against central differences of runs at tight tolerances, for every
 * effect of the catalogue, on a target of each kind that small scenarios have. A new effect is in
 * it without a line of its own.
 *
 * The reference: Richardson's extrapolation of central differences (one-sided ones of second order
 * at a bound) over h, h/r, h/r^2, each run anew at a tolerance a hundred times tighter than the
 * scenario's; how well its last two agree is its own error. Heat wants long steps, which stand
 * above its noise, light short ones. Deviations are of the parameter's largest answer, all curves
 * together, each in units of its size. Where lines of sight move, points of facets are shaded one
 * by one, and where heat is integrated there is noise: such a derivative is as good as it says. */
#include "evidence/sensitivity/matrix.h"

#include "evidence/sensitivity/own.h"
#include "evidence/sensitivity/what_if.h"
#include "tests/evidence/sensitivity/satellite_test.h"
#include "tests/support/whole.h"

#define RUNGS 3
#define GOOD  1e-3 /* what is promised */

struct scene {
  const char *name, *path; /* path NULL: the satellite of satellite_test.h */
  const char *const *set;  /* [nset] */
  size_t nset;
};
#define FINE      "thermal.accuracy_K=0.01" /* the reference's noise */
#define SET(list) list, sizeof list / sizeof list[0]

struct matrix {
  struct um_compare_measurements *set;
  struct um_sensitivity_forward *forward, *tight;
  struct um_sensitivity_matrix *m;
};

static const char *path_of(const struct scene *scene)
{
  return scene->path != NULL ? scene->path : SCENARIO;
}

static struct um_sensitivity_forward *forward_near(const struct scene *scene,
                                                   const struct um_compare_measurements *set,
                                                   struct um_model_options *options,
                                                   struct um_variant_tolerance tolerance)
{
  struct um_sensitivity_forward *f;
  options->overrides = scene->set;
  options->noverride = scene->nset;
  assert_ok(um_sensitivity_forward_create(context, path_of(scene), options, set, tolerance, &f));
  return f;
}

static void make(const struct scene *scene, const char *const *only, size_t nonly,
                 struct matrix *out)
{
  struct um_model_options options = {.overrides = scene->set, .noverride = scene->nset};
  const struct um_sensitivity_candidates_options which = {.only = only, .nonly = nonly};
  struct um_model *model;
  if (scene->path == NULL) put_satellite();
  assert_ok(um_model_create(context, path_of(scene), &options, &model));
  assert_ok(um_sensitivity_own_create(context, model, &out->set));
  um_model_destroy(context, &model);
  out->forward = forward_near(scene, out->set, &options, UM_SENSITIVITY_MATRIX_TOLERANCE);
  out->tight = forward_near(scene, out->set, &options, (struct um_variant_tolerance){0.01, 1e-6});
  assert_ok(um_sensitivity_matrix_create(context, out->forward, true, &which, &out->m));
}

static void destroy(struct matrix *matrix)
{
  um_sensitivity_matrix_destroy(context, &matrix->m);
  um_sensitivity_forward_destroy(context, &matrix->tight);
  um_sensitivity_forward_destroy(context, &matrix->forward);
  um_compare_measurements_destroy(context, &matrix->set);
}

/* --- reference -------------------------------------------------------------------------------- */

/* Derivative over a step at tight tolerance into out [nobservation]; false: refused. */
static bool difference(const struct matrix *w, const struct um_sensitivity_row *r, double h,
                       double *out)
{
  struct um_sensitivity_forward *f = w->tight;
  const struct um_sensitivity_candidate *c = r->candidate;
  size_t n = f->observations.count;
  bool central = r->null_value - h >= r->minimum && r->null_value + h <= r->maximum, ok = true;
  double sign = r->null_value + h <= r->maximum ? 1.0 : -1.0;
  const double at[2] = {sign * h, central ? -sign * h : 0.5 * sign * h};
  double *value[2], *base = malloc(n * sizeof *base);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, base));
  for (int i = 0; i < 2; i++) {
    struct um_model_addition a = {.effect = c->effect, .target = c->target};
    memcpy(a.value, c->null_value, sizeof a.value);
    a.value[r->parameter] += at[i];
    value[i] = malloc(n * sizeof *value[i]);
    enum um_status status = um_sensitivity_forward_evaluate(context, f, &a, 1, value[i]);
    ok = ok && status == UM_OK;
    um_core_message_clear(context);
  }
  for (size_t j = 0; ok && j < n; j++)
    out[j] = central ? (value[0][j] - value[1][j]) / (at[0] - at[1])
                     : (4.0 * value[1][j] - value[0][j] - 3.0 * base[j]) / at[0];
  free(value[0]);
  free(value[1]);
  free(base);
  return ok;
}

/* Largest |a - b| of curves [ncurve][ntime], each in units of its size; b NULL: 0. */
static double largest(const struct um_sensitivity_matrix *m, const double *a, const double *b)
{
  double most = 0.0;
  for (size_t c = 0; c < m->ncurve; c++)
    for (size_t k = 0; k < m->ntime && m->curve[c].size > 0.0; k++) {
      size_t at = c * m->ntime + k;
      most = fmax(most, fabs(a[at] - (b != NULL ? b[at] : 0.0)) / m->curve[c].size);
    }
  return most;
}

/* The reference as curves, and its own error of its largest value; INFINITY: there is none. */
static double reference(const struct matrix *w, const struct um_sensitivity_row *r, double *out)
{
  size_t n = w->tight->observations.count, curves = w->m->ncurve * w->m->ntime;
  double *rung[RUNGS], *better[RUNGS - 1], error = INFINITY;
  bool ok = true;
  double room = fmax(r->maximum - r->null_value, r->null_value - r->minimum);
  bool heat =
      r->quality.way == UM_SENSITIVITY_BY_TANGENT || r->quality.way == UM_SENSITIVITY_BY_RUNS;
  double ratio = heat ? 2.0 : 4.0, gain = ratio * ratio;
  /* a reach that is not known is left out */
  double h = fmin(fmin((heat ? 0.5 : 0.1) * r->width, 0.5 * room), 0.5 * r->quality.reach);
  for (int i = 0; i < RUNGS; i++, h /= ratio) {
    rung[i] = malloc(n * sizeof *rung[i]);
    ok = ok && difference(w, r, h, rung[i]);
  }
  for (int i = 0; i + 1 < RUNGS; i++) {
    double *value = malloc(n * sizeof *value);
    better[i] = malloc(curves * sizeof *better[i]);
    for (size_t j = 0; ok && j < n; j++)
      value[j] = (gain * rung[i + 1][j] - rung[i][j]) / (gain - 1.0);
    if (ok) um_sensitivity_matrix_spread(w->m, value, better[i]);
    free(value);
  }
  if (ok) {
    memcpy(out, better[1], curves * sizeof *out);
    error = largest(w->m, better[0], better[1]) / largest(w->m, better[1], NULL);
  }
  for (int i = 0; i < RUNGS; i++) free(rung[i]);
  for (int i = 0; i + 1 < RUNGS; i++) free(better[i]);
  return error;
}

/* --- rows ------------------------------------------------------------------------------------- */

static double strength(const struct um_sensitivity_matrix *m, const struct um_sensitivity_row *r)
{
  return largest(m, r->column, NULL) * r->width;
}

/* Of an effect's parameter on several targets, the one that moves most: its reference is the best.
 */
static bool is_strongest(const struct um_sensitivity_matrix *m, size_t which)
{
  const struct um_sensitivity_row *r = &m->row[which];
  for (size_t i = 0; i < m->nrow; i++) {
    const struct um_sensitivity_row *o = &m->row[i];
    if (i == which || o->candidate->effect != r->candidate->effect ||
        o->parameter != r->parameter || o->column == NULL || !o->smooth)
      continue;
    double a = strength(m, o), b = strength(m, r);
    if (a > b || (a == b && i < which)) return false;
  }
  return true;
}

struct tally {
  size_t held, vague, rough, wrong;
};

/* What forward sensitivities of temperatures miss by more than they promise. Exchange between
 * surfaces has emittances at their mean temperatures (the effect emittance_temperature), which move
 * with the parameter and here do not: 1.2e-2, 2.6e-3 and 2.0e-3 of a law of the heat capacity, of
 * the Earth's infrared and of the Sun; with that effect off 1.5e-3, 1.6e-4 and 6e-4.
 */
static const struct {
  const char *effect;
  double off;
} known[] = {{"specific_heat_law", 2e-2},
             {"earth_ir_level", 5e-3},
             {"local_earth_ir", 5e-3},
             {"solar_irradiance", 5e-3}};

static double allowed_of(const struct um_sensitivity_row *r)
{
  enum um_sensitivity_way way = r->quality.way;
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
    if (strcmp(r->candidate->effect->name, known[i].effect) == 0) return known[i].off;
  if (way == UM_SENSITIVITY_BY_MOTION)
    return fmax(GOOD, 6.0 * r->quality.error); /* area of a box */
  bool stated = way == UM_SENSITIVITY_BY_RUNS || way == UM_SENSITIVITY_BY_BEHIND;
  return stated ? fmax(GOOD, 2.0 * r->quality.error) : GOOD;
}

static void hold(const struct matrix *w, const struct um_sensitivity_row *r, struct tally *tally)
{
  const struct um_sensitivity_matrix *m = w->m;
  double *expected = malloc(m->ncurve * m->ntime * sizeof *expected);
  double own = reference(w, r, expected), allowed = allowed_of(r);
  double off = isinf(own) ? NAN : largest(m, r->column, expected) / largest(m, expected, NULL);
  bool good = off <= allowed, vague = !good && !(own <= 0.5 * allowed && off > allowed + own);
  print_message("  %-52s %-8s off %8.1e, reference %8.1e, stated %8.1e%s\n", r->name,
                um_sensitivity_way_name(r->quality.way), off, own, r->quality.error,
                !good && !vague ? "  WRONG"
                : vague         ? "  vague"
                                : "");
  tally->held += good;
  tally->vague += vague;
  tally->wrong += !good && !vague;
  free(expected);
}

/* least: rows that are held at least, which a reference that is noise alone would not do. */
static void conform(const struct scene *scene, size_t least)
{
  struct matrix w;
  struct tally tally = {0};
  make(scene, NULL, 0, &w);
  print_message("%s: %zu rows in %.1f s, a run %.2f s\n", scene->name, w.m->nrow, w.m->seconds,
                w.m->seconds_run);
  for (size_t i = 0; i < w.m->nrow; i++) {
    const struct um_sensitivity_row *r = &w.m->row[i];
    if (r->column == NULL) continue;
    if (!r->smooth) {
      print_message("  %-52s %s\n", r->name, r->why);
      tally.rough++;
    } else if (is_strongest(w.m, i)) {
      hold(&w, r, &tally);
    }
  }
  print_message("%s: %zu held, %zu beyond the reference, %zu not smooth, %zu wrong\n", scene->name,
                tally.held, tally.vague, tally.rough, tally.wrong);
  assert_int_equal(tally.wrong, 0);
  assert_true(tally.held >= least);
  destroy(&w);
}

static void test_satellite(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=60",           "optics.interreflection_samples=0",
                                    "thermal.start=isothermal", "thermal.orbits_before=0.1",
                                    "thermal.step_s=20",        FINE};
  conform(&(struct scene){"satellite", NULL, SET(set)}, 28);
}
static void test_sphere(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=600", "parts.sphere.facet_size_m=0.5",
                                    "thermal.relative_tolerance=1e-6",
                                    "thermal.absolute_tolerance_K=1e-4"};
  conform(&(struct scene){"sphere", UMBRA_SOURCE_DIR "/scenarios/sphere", SET(set)}, 15);
}
static void test_cube(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=900", FINE};
  conform(&(struct scene){"cube", UMBRA_SOURCE_DIR "/scenarios/cube", SET(set)}, 6);
}
static void test_elbow(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=40", "optics.samples=16", FINE};
  conform(&(struct scene){"elbow", UMBRA_SOURCE_DIR "/tests/scenarios/data/elbow", SET(set)}, 6);
}
static void test_box(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=900", FINE};
  conform(
      &(struct scene){"box", UMBRA_SOURCE_DIR "/tests/scenarios/data/box_inside.yaml", SET(set)},
      6);
}
static void test_hidden(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=30", FINE};
  conform(
      &(struct scene){"hidden effect", UMBRA_SOURCE_DIR "/scenarios/hidden-effect/dawn", SET(set)},
      30);
}

/* The answer by the matrix beside the true one, and how far it is good. */
static void test_what_if(void **state)
{
  (void)state;
  static const char *const set[] = {"time.step_s=60", "optics.interreflection_samples=0",
                                    "thermal.start=isothermal", "thermal.orbits_before=0.1"};
  static const char *const only[] = {"emittance:grey_panel", "zero_point:vis"};
  struct matrix w;
  struct um_sensitivity_what_if near, far, linear;
  make(&(struct scene){"satellite", NULL, SET(set)}, only, 2, &w);
  struct um_model_addition a = addition_of("emittance", "grey_panel", 1.04);
  assert_ok(um_sensitivity_what_if_create(context, w.m, &a, &near));
  a.value[0] = 1.08;
  assert_ok(um_sensitivity_what_if_create(context, w.m, &a, &far));
  assert_int_equal(near.nrow, 1);
  print_message("by the matrix in %.2g s, by a run in %.2g s; within %g and %g of the way\n",
                near.seconds, near.seconds_exact, near.within, far.within);
  assert_true(near.within > 1.0); /* 4 % of an emittance bends little, above steps of heat .. */
  /* .. and the way within which the line is good is the same, seen from either */
  assert_close(0.04 * near.within, 0.08 * far.within, 0.15 * 0.04 * near.within);
  for (size_t c = 0; c < w.m->ncurve; c++) {
    assert_true(near.error[c].rms <= near.error[c].largest);
    assert_true(near.error[c].largest <= 0.011 / (near.within * near.within));
  }
  a = addition_of("zero_point", "vis", 1.5); /* is linear */
  assert_ok(um_sensitivity_what_if_create(context, w.m, &a, &linear));
  for (size_t k = 0; k < w.m->ntime; k++)
    if (!isnan(w.m->value[k]))
      assert_close(linear.linear[k], 1.5 * w.m->value[k], 1e-9 * w.m->curve[0].size);
  um_sensitivity_what_if_release(context, &linear);
  a.value[0] = 1e9;
  assert_int_equal(um_sensitivity_what_if_create(context, w.m, &a, &linear), UM_ERR_INPUT);
  um_sensitivity_what_if_release(context, &linear);
  a = addition_of("zero_point", "lwir", 1.1); /* was not asked for */
  assert_int_equal(um_sensitivity_what_if_create(context, w.m, &a, &linear), UM_ERR_INPUT);
  um_core_message_clear(context);
  um_sensitivity_what_if_release(context, &linear);
  um_sensitivity_what_if_release(context, &near);
  um_sensitivity_what_if_release(context, &far);
  destroy(&w);
}

int main(void)
{
  const struct CMUnitTest part[] = {
      cmocka_unit_test_setup_teardown(test_what_if, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_satellite, model_set_up, model_tear_down),
  };
  const struct CMUnitTest whole[] = {
      cmocka_unit_test_setup_teardown(test_sphere, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_cube, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_elbow, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_box, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(test_hidden, model_set_up, model_tear_down),
  };
  int failed = cmocka_run_group_tests(part, NULL, NULL);
  if (um_test_whole()) failed += cmocka_run_group_tests(whole, NULL, NULL);
  return failed;
}
