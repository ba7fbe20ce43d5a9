/* Measurements made from a model, and the model found again in them: noise as stated, chi-square
 * and whiteness as they must be; something left out shows in the channels and segments that feel
 * it. Seeds are fixed, so that a run is like any other; bands are stated as if they were not. */
#include "tests/evidence/model_test.h"

#include "evidence/comparison/compare.h"
#include "evidence/inversion/synth.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "model/build/build.h"
#include "orbit/time.h"

#define SEEDS 20

static const char *const places[] = {"interior", "panel.front"};
static const struct um_compare_synth options = {
    .relative = 0.01, .floor = 2e-3, .place = places, .nplace = 2, .temperature_sigma = 0.5};

static void write_synth(const struct world *w, uint64_t seed, double noise, const char *path)
{
  struct um_compare_measurements *m;
  struct um_compare_synth o = options;
  o.seed = seed;
  o.relative *= noise;
  o.floor *= noise;
  assert_ok(um_compare_synth_create(context, w->model, w->tables, w->result, &o, path, &m));
  assert_ok(um_compare_measurements_write(context, m, path));
  um_compare_measurements_destroy(context, &m);
}

/* Every channel of every seed: chi2 of n rows within 4 sigma of n (80 draws: false alarm 0.5 %);
 * whiteness p below 1 % in at most 4 of 80 (0.8 expected; 5 or more: 0.15 %). All residuals
 * together: mean 0 and variance 1 within 4 standard errors. */
static void test_complete_model(void **state)
{
  (void)state;
  struct world w = world_of(NULL);
  struct pair p = {0};
  size_t n = 0, coloured = 0;
  double sum = 0.0, squares = 0.0;
  for (uint64_t seed = 1; seed <= SEEDS; seed++) {
    write_synth(&w, seed, 1.0, "m.csv");
    if (p.tables == NULL) {
      p = pair_of(w.model, "m.csv", 0.0);
    } else { /* the same times: the same geometry tables and run */
      um_compare_destroy(context, &p.comparison);
      um_compare_plan_destroy(context, &p.plan);
      um_compare_measurements_destroy(context, &p.measurements);
      assert_ok(um_compare_measurements_read(context, "m.csv", &p.measurements));
      assert_ok(um_compare_plan_create(context, w.model, p.measurements, &p.plan));
      struct um_compare_run run = {w.model, p.plan, p.tables, p.result};
      assert_ok(um_compare_create(context, &run, 0.0, &p.comparison));
    }
    assert_int_equal(p.comparison->nchannel, 4);
    for (size_t i = 0; i < 4; i++) {
      const struct um_compare_metrics *all = &p.comparison->channel[i].all;
      assert_int_equal(all->count, w.tables->nobs);
      if (!(fabs(all->chi2 - all->dof) <= 4.0 * sqrt(2.0 * all->dof)))
        fail_msg("seed %zu channel %zu: chi2 %g of %g", (size_t)seed, i, all->chi2, all->dof);
      if (all->white_p < 0.01) coloured++;
    }
    for (size_t i = 0; i < p.measurements->count; i++) {
      const struct um_compare_residual *r = &p.comparison->residual[i];
      double z = (r->measured - r->model) / r->sigma;
      sum += z;
      squares += z * z;
      n++;
    }
  }
  double count = (double)n;
  print_message("%zu residuals: mean %.4f, variance %.4f, %zu of 80 series called coloured\n", n,
                sum / count, squares / count, coloured);
  assert_true(coloured <= 4);
  assert_true(fabs(sum / count) <= 4.0 / sqrt(count));
  assert_true(fabs(squares / count - 1.0) <= 4.0 * sqrt(2.0 / count));
  pair_end(&p);
  world_end(&w);
}

/* Reduced chi-square of a channel, in a segment or in all. */
static double chi2_red(const struct pair *p, const char *of, int segment)
{
  const struct um_compare_channel_comparison *c = channel_named(p->comparison, of);
  return segment < 0 ? c->all.chi2_reduced : c->segment[segment].chi2_reduced;
}

/* Interior power that the model lacks: heat shows, light of the Sun does not, in any segment. */
static void test_hidden_power(void **state)
{
  (void)state;
  const char *power = "parts.bus.interior.power_W=60";
  struct world truth = world_of(&(struct um_model_options){.overrides = &power, .noverride = 1});
  struct um_model *model = model_of(NULL);
  write_synth(&truth, 7, 1.0, "m.csv");
  struct pair p = pair_of(model, "m.csv", 0.0);
  assert_true(chi2_red(&p, "bus.interior", -1) > 100.0); /* 40 W over 2 W/K are some 20 K */
  assert_true(chi2_red(&p, "lwir", UM_SEGMENT_UMBRA) > 2.0);
  assert_true(chi2_red(&p, "lwir", UM_SEGMENT_SUNLIT) > 2.0);
  const struct um_compare_channel_comparison *lwir = channel_named(p.comparison, "lwir");
  assert_true(lwir->all.bias > 0.0 && lwir->all.white_p < 1e-6);
  for (int s = -1; s < UM_SEGMENT_COUNT; s++)
    if (s != UM_SEGMENT_PENUMBRA) assert_true(chi2_red(&p, "vis", s) < 1.6);
  assert_true(chi2_red(&p, "panel.front", -1) < 1.5); /* nothing conducts there */
  pair_end(&p);
  um_model_destroy(context, &model);
  world_end(&truth);
}

/* A model without the Earth's heat: heat and LWIR too low in umbra and sunlight alike. A model
 * without earthshine: VIS too low in sunlight only, heat as it was. The satellite passes over the
 * terminator, where earthshine is 0.1 % of the light: noise is a twentieth of the usual. */
static void test_switches(void **state)
{
  (void)state;
  static const char *const planet = "earth_ir", *const shine = "earthshine";
  struct world truth = world_of(NULL);
  write_synth(&truth, 8, 0.05, "m.csv");
  world_end(&truth);
  struct um_model *model = model_of(&(struct um_model_options){.without = &planet, .nwithout = 1});
  struct pair p = pair_of(model, "m.csv", 0.0);
  assert_true(chi2_red(&p, "panel.front", UM_SEGMENT_UMBRA) > 100.0);
  assert_true(chi2_red(&p, "lwir", UM_SEGMENT_UMBRA) > 10.0);
  assert_true(channel_named(p.comparison, "lwir")->segment[UM_SEGMENT_UMBRA].bias > 0.0);
  assert_true(chi2_red(&p, "vis", -1) < 1.6);
  pair_end(&p);
  um_model_destroy(context, &model);
  model = model_of(&(struct um_model_options){.without = &shine, .nwithout = 1});
  p = pair_of(model, "m.csv", 0.0);
  assert_true(chi2_red(&p, "vis", UM_SEGMENT_SUNLIT) > 2.0);
  assert_true(channel_named(p.comparison, "vis")->segment[UM_SEGMENT_SUNLIT].bias > 0.0);
  assert_true(chi2_red(&p, "vis", UM_SEGMENT_UMBRA) < 1.6);
  assert_true(chi2_red(&p, "lwir", -1) < 1.6 && chi2_red(&p, "bus.interior", -1) < 1.6);
  pair_end(&p);
  um_model_destroy(context, &model);
}

/* The same seed gives the same rows; another channel beside them changes none; another seed all. */
static void test_seeds(void **state)
{
  (void)state;
  struct world w = world_of(NULL);
  struct um_compare_measurements *a, *b, *c;
  struct um_compare_synth o = options, bare = options, other = options;
  o.seed = bare.seed = 3;
  bare.nplace = 0;
  other.seed = 4;
  assert_ok(um_compare_synth_create(context, w.model, w.tables, w.result, &o, "a", &a));
  assert_ok(um_compare_synth_create(context, w.model, w.tables, w.result, &bare, "b", &b));
  assert_ok(um_compare_synth_create(context, w.model, w.tables, w.result, &other, "c", &c));
  assert_int_equal(a->count, 4 * w.tables->nobs);
  assert_int_equal(b->count, 2 * w.tables->nobs);
  for (size_t k = 0; k < w.tables->nobs; k++)
    for (size_t i = 0; i < 2; i++) {
      assert_true(a->row[4 * k + i].value == b->row[2 * k + i].value);
      assert_true(a->row[4 * k + i].value != c->row[4 * k + i].value);
      assert_true(a->row[4 * k + i].sigma == c->row[4 * k + i].sigma);
    }
  um_compare_measurements_destroy(context, &a);
  um_compare_measurements_destroy(context, &b);
  um_compare_measurements_destroy(context, &c);
  world_end(&w);
}

static void test_refusals(void **state)
{
  (void)state;
  static const char *const wrong[] = {"interior", "wheel"}, *const twice[] = {"interior",
                                                                              "bus.interior"};
  struct world w = world_of(NULL);
  struct um_compare_measurements *m;
  const struct {
    struct um_compare_synth o;
    const char *message;
  } cases[] = {
      {{.relative = 0.0, .floor = 0.0},
       "noise 0,0; accepted: relative and floor 0 or more, not both 0"},
      {{.relative = -0.1, .floor = 1.0},
       "noise -0.1,1; accepted: relative and floor 0 or more, not both 0"},
      {{.relative = NAN, .floor = 1.0},
       "noise nan,1; accepted: relative and floor 0 or more, not both 0"},
      {{.relative = 0.1, .place = places, .nplace = 1, .temperature_sigma = 0.0},
       "noise of temperatures 0 K; accepted: above 0 K"},
      {{.relative = 0.1, .place = twice, .nplace = 2, .temperature_sigma = 1.0},
       "place 'bus.interior' is named twice"},
      {{.relative = 0.1, .place = wrong, .nplace = 2, .temperature_sigma = 1.0},
       "the scenario has no place 'wheel'; accepted: bus, bus.+x, bus.-x, bus.+y, bus.-y, bus.+z, "
       "bus.-z, bus.interior, panel, panel.front, panel.back, panel.plate, panel.plate.back, "
       "material:NAME"}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    assert_refused(
        um_compare_synth_create(context, w.model, w.tables, w.result, &cases[i].o, "m", &m),
        UM_ERR_INPUT, cases[i].message);
    assert_null(m);
  }
  world_end(&w);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_complete_model),
                                     cmocka_unit_test(test_hidden_power),
                                     cmocka_unit_test(test_switches), cmocka_unit_test(test_seeds),
                                     cmocka_unit_test(test_refusals)};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
