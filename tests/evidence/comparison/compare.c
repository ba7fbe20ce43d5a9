/* Comparison of a model with measurements made from it by a known change, so that every number of
 * the result is known beforehand. */
#include "tests/evidence/model_test.h"

#include "base/core/constants.h"
#include "evidence/comparison/compare.h"
#include "evidence/comparison/correlation_impl.h"
#include "model/build/build.h"
#include "orbit/time.h"

/* Rank correlations against numbers worked out by hand.
 * Spearman: ranks of x 1..5, of y 1 3 2 5 4: sum d^2 = 4, r = 1 - 6 x 4 / (5 x 24) = 0.8; Student's
 * t = 0.8 sqrt(3 / 0.36) = 2.3094, two-sided p of 3 degrees of freedom 0.104088 (closed form
 * 1 - 2/pi (atan u + u / (1 + u^2)), u = t / sqrt 3).
 * Ties: y 1 2 2 3 4 has ranks 1 2.5 2.5 4 5, Pearson's r of the ranks 9.5 / sqrt(10 x 9.5).
 * Circular: y of ranks that go as cos(2 pi x) at twelve phases is a monotone function of it: with
 * y = cos exactly in ranks (6 pairs of ties) r^2 is that of ranks on cos, computed by hand below.
 */
static void test_correlations(void **state)
{
  (void)state;
  const double x[] = {1, 2, 3, 4, 5}, y[] = {10, 30, 20, 90, 40}, tied[] = {1, 2, 2, 3, 4};
  double r, p;
  assert_ok(um_compare_spearman(context, 5, x, y, &r, &p));
  double u = 0.8 * sqrt(3.0 / 0.36) / sqrt(3.0);
  assert_true(fabs(r - 0.8) < 1e-15);
  assert_true(fabs(p - (1.0 - 2.0 / UM_PI * (atan(u) + u / (1.0 + u * u)))) < 1e-14);
  assert_ok(um_compare_spearman(context, 5, x, tied, &r, &p));
  assert_true(fabs(r - 9.5 / sqrt(95.0)) < 1e-15);
  const double flat[] = {2, 2, 2, 2, 2};
  assert_ok(um_compare_spearman(context, 5, x, flat, &r, &p));
  assert_true(isnan(r) && isnan(p));
  assert_ok(um_compare_spearman(context, 4, x, y, &r, &p));
  assert_true(isnan(r));
  assert_ok(um_compare_spearman(context, 5, x, x, &r, &p));
  assert_true(fabs(r - 1.0) < 1e-15 && p < 1e-10);

  /* y = cos of the phase at 12 phases: ranks of 1, .87 .87, .5 .5, 0 0, ... are 11, 9.5 9.5, ...;
   * the centred ranks R go with c = cos: r^2 = (sum R c)^2 / (sum R^2 sum c^2), no sine part */
  double phase[12], cosine[12], rc = 0.0, rr = 0.0;
  static const double ranks[] = {5.5, 4, 2, 0, -2, -4, -5.5, -4, -2, 0, 2, 4};
  for (int i = 0; i < 12; i++) {
    phase[i] = i / 12.0;
    cosine[i] = round(1e6 * cos(2.0 * UM_PI * phase[i])) / 1e6; /* equal ones equal */
    rc += ranks[i] * cos(2.0 * UM_PI * phase[i]);
    rr += ranks[i] * ranks[i];
  }
  assert_ok(um_compare_circular(context, 12, phase, cosine, &r, &p));
  double expected = rc / sqrt(rr * 6.0), f = 9.0 * r * r / (1.0 - r * r) / 2.0;
  assert_true(fabs(r - expected) < 1e-12);
  /* F of 2 and m degrees of freedom: Q = (1 + 2 F / m)^(-m/2) */
  assert_true(fabs(p / pow(1.0 + 2.0 * f / 9.0, -4.5) - 1.0) < 1e-9);
}

/* Both bands at the scenario's times; the values are what the model says at them. */
static struct pair own_pair(struct um_model *model)
{
  FILE *file = fopen("m.csv", "wb");
  assert_non_null(file);
  fputs(HEAD, file);
  for (int k = 0; k < 181; k++)
    for (int b = 0; b < 2; b++)
      fprintf(file, DAY "%02d:%02dZ,band_irradiance,%s,0,%s\n", 8 + k * 4 / 60, k * 4 % 60,
              b == 0 ? "vis" : "lwir", b == 0 ? "1e-13" : "2e-14");
  assert_int_equal(fclose(file), 0);
  struct pair p = pair_of(model, "m.csv", 0.0);
  for (size_t i = 0; i < p.measurements->count; i++)
    p.measurements->row[i].value = p.comparison->model[i];
  return p;
}

static void compare_again(struct pair *p, struct um_model *model, double fitted)
{
  struct um_compare_run run = {model, p->plan, p->tables, p->result};
  um_compare_destroy(context, &p->comparison);
  assert_ok(um_compare_create(context, &run, fitted, &p->comparison));
}

/* What rounding leaves of differences of numbers up to 3000 sigma. */
#define ROUNDING 1e-9

/* Spearman's r of a channel's residual, 3 in the umbra and 0 elsewhere, with the sunlit fraction:
 * not -1, for the Earth's air grades the light of a dozen rows and more behind the umbra. */
static void rank_correlation(const struct pair *p, const struct um_compare_channel_comparison *c,
                             double *r, double *chance)
{
  static double residual[256], sunlit[256];
  assert_true(c->count <= sizeof residual / sizeof residual[0]);
  for (size_t i = 0; i < c->count; i++) {
    residual[i] = um_compare_residual_normalised(&p->comparison->residual[c->row[i]]);
    sunlit[i] = p->tables->sunlit[p->plan->observation[c->row[i]]];
  }
  assert_ok(um_compare_spearman(context, c->count, residual, sunlit, r, chance));
}

static void check_channel(const struct pair *p, size_t i, size_t umbra)
{
  const struct um_compare_channel_comparison *channel = &p->comparison->channel[i];
  const struct um_compare_metrics *s = channel->segment;
  double sigma = i == 0 ? 1e-13 : 2e-14;
  size_t nobs = p->tables->nobs;
  assert_int_equal(channel->count, nobs);
  assert_int_equal(s[UM_SEGMENT_UMBRA].count, umbra);
  assert_int_equal(s[UM_SEGMENT_SUNLIT].count + s[UM_SEGMENT_PENUMBRA].count, nobs - umbra);
  assert_int_equal(s[UM_SEGMENT_RISING].count + s[UM_SEGMENT_SETTING].count, nobs);
  assert_true(fabs(s[UM_SEGMENT_UMBRA].chi2_reduced - 9.0) < ROUNDING);
  assert_true(fabs(s[UM_SEGMENT_UMBRA].bias / sigma - 3.0) < ROUNDING);
  assert_true(s[UM_SEGMENT_SUNLIT].chi2 == 0.0);
  assert_true(fabs(channel->all.chi2 / (9.0 * (double)umbra) - 1.0) < ROUNDING);
  assert_int_equal(channel->nworst, UM_COMPARE_WORST);
  const struct um_compare_interval *worst = &channel->worst[0];
  assert_int_equal(worst->count, nobs / 10);
  assert_true(fabs(worst->chi2 / (9.0 * (double)worst->count) - 1.0) < ROUNDING);
  assert_true(worst->sunlit <= UM_UMBRA_MOST);
  double mechanisms = 0.0, materials = 0.0, total = 0.0; /* [W/sr] */
  for (size_t j = 0; j < worst->nmechanism; j++) mechanisms += worst->mechanism[j].value;
  for (size_t j = 0; j < worst->nmaterial; j++) materials += worst->material[j].value;
  for (size_t k = worst->first; k < worst->first + worst->count; k++)
    total += um_model_result_intensity(p->result, k, i, -1) / (double)worst->count;
  assert_true(fabs(mechanisms / total - 1.0) < 1e-12 && fabs(materials / total - 1.0) < 1e-12);
  size_t j = 0;
  while (strcmp(channel->correlation[j].name, "sunlit_fraction") != 0) j++;
  double r, chance;
  rank_correlation(p, channel, &r, &chance);
  assert_true(r < -0.7 && chance < 1e-10);
  assert_true(fabs(channel->correlation[j].value - r) < 1e-12);
}

/* Three sigmas too much in the umbra, none elsewhere: chi2 there is 9 a row and 0 elsewhere; the
 * worst intervals lie in the umbra; shares add up to the intensity; the residual goes with the
 * light. Four fitted parameters are shared by the channels. Light between surfaces would add its
 * own error to sigma. */
static void test_umbra_only(void **state)
{
  (void)state;
  const char *const off[] = {"inter_reflection"};
  struct um_model *model = model_of(&(struct um_model_options){.without = off, .nwithout = 1});
  struct pair p = own_pair(model);
  size_t umbra = 0, nobs = p.tables->nobs;
  for (size_t i = 0; i < p.measurements->count; i++)
    if (p.tables->sunlit[p.plan->observation[i]] <= UM_UMBRA_MOST)
      p.measurements->row[i].value += 3.0 * p.measurements->row[i].sigma;
  for (size_t k = 0; k < nobs; k++) umbra += p.tables->sunlit[k] <= UM_UMBRA_MOST;
  assert_true(umbra > 20 && umbra < nobs / 2);
  compare_again(&p, model, 0.0);
  assert_int_equal(p.comparison->nchannel, 2);
  for (size_t i = 0; i < 2; i++) check_channel(&p, i, umbra);
  assert_true(fabs(p.comparison->chi2 / (18.0 * (double)umbra) - 1.0) < ROUNDING);
  assert_true(p.comparison->dof == 2.0 * (double)nobs);
  compare_again(&p, model, 4.0);
  assert_true(p.comparison->dof == 2.0 * (double)nobs - 4.0);
  assert_true(fabs(p.comparison->channel[0].all.dof - ((double)nobs - 2.0)) < 1e-9);
  pair_end(&p);
  um_model_destroy(context, &model);
}

static const double *coordinate(const struct um_compare_comparison *c, const char *name)
{
  for (size_t j = 0; j < c->coordinates->count; j++)
    if (strcmp(c->coordinates->coordinate[j].name, name) == 0)
      return c->coordinates->coordinate[j].value;
  fail_msg("no coordinate %s", name);
  return NULL;
}

/* Coordinates with known values. The box is closed and convex, of one material: the mean of its
 * sunlit cosines is (|sx| + |sy| + |sz|) / 6 with the Sun in body axes. The panel, 3 m away, may
 * shade it for moments, never adds. */
static void test_coordinates(void **state)
{
  (void)state;
  struct um_model *model = model_of(NULL);
  struct pair p = own_pair(model);
  const struct um_compare_comparison *c = p.comparison;
  const double *since = coordinate(c, "since_shadow_exit_s"), *time = coordinate(c, "time_s");
  const double *entry = coordinate(c, "since_shadow_entry_s");
  const double *spin = coordinate(c, "spin_phase"), *sun = coordinate(c, "sun_on.grey_white_W_m2");
  const double *moon = coordinate(c, "moon_separation_deg");
  const double *airmass = coordinate(c, "airmass"), *elevation = coordinate(c, "elevation_deg");
  size_t exact = 0, n = p.tables->nobs;
  double leave = NAN;
  for (size_t i = 0; i < p.tables->nevent; i++)
    if (p.tables->event[i].kind == UM_EVENT_HALF_EXIT) leave = p.tables->event[i].t_tai;
  for (size_t k = 0; k < n; k++) {
    const struct um_environment_sample *s = &p.tables->sample[k];
    assert_true(fabs(time[k] - 4.0 * (double)k) < 1e-6);
    /* turned once in 240 s from the scenario's start; satellite times are earlier by light time */
    double turns = (s->t_tai - model->scenario->time->start) / 240.0;
    assert_true(fabs(spin[k] - (turns - floor(turns))) < 1e-12);
    if (s->t_tai > leave) assert_true(fabs(since[k] - (s->t_tai - leave)) < 1e-9);
    if (s->sunlit_fraction <= 0.0) {
      assert_true(entry[k] > 0.0 && entry[k] < 2200.0); /* an eclipse of 765 km lasts 35 min */
      assert_true(since[k] > entry[k]);
    }
    assert_true(moon[k] >= 0.0 && moon[k] <= 180.0);
    if (elevation[k] > 15.0) /* plane-parallel air: 1 / sin, 1 % there (Kasten & Young 1989) */
      assert_true(fabs(airmass[k] * sin(elevation[k] * UM_DEG) - 1.0) < 0.02);
    struct um_vec3 b = um_quat_apply(s->q, s->sun);
    double irradiance = um_environment_solar_irradiance(&model->environment, s->sun_distance);
    double expected = s->sunlit_fraction * irradiance * (fabs(b.x) + fabs(b.y) + fabs(b.z)) / 6.0;
    assert_true(sun[k] <= expected * (1.0 + 1e-6) + 1e-9);
    if (fabs(sun[k] - expected) <= 1e-5 * irradiance) exact++;
  }
  assert_true(exact > n / 2);
  /* half of the pass rises: it is symmetric about 18:14:3x */
  size_t rising = 0;
  for (size_t k = 0; k < n; k++) {
    rising += c->motion[k] == UM_SEGMENT_RISING;
    if (k > 0 && c->motion[k] == UM_SEGMENT_RISING) assert_true(elevation[k] > elevation[k - 1]);
  }
  assert_true(rising > 95 && rising < 101); /* 18:08:00 to 18:14:3x every 4 s */
  pair_end(&p);
  um_model_destroy(context, &model);
}

/* Rows without sigma: no chi-square, the rest remains. */
static void test_no_sigma(void **state)
{
  (void)state;
  struct um_model *model = model_of(NULL);
  put("m.csv",
      HEAD DAY "12:00Z,temperature,interior,280,\n" DAY "12:10Z,temperature,interior,281,\n" DAY
               "12:20Z,temperature,interior,282,\n" DAY "12:30Z,temperature,interior,281,\n");
  struct pair p = pair_of(model, "m.csv", 0.0);
  const struct um_compare_channel_comparison *c = &p.comparison->channel[0];
  assert_true(isnan(c->all.chi2) && isnan(p.comparison->chi2_reduced));
  assert_true(c->all.rms > 0.0 && c->nworst == 1 && c->worst[0].count == 3);
  assert_int_equal(c->worst[0].nmechanism, 8); /* heat flows of the node */
  pair_end(&p);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_correlations), cmocka_unit_test(test_umbra_only),
      cmocka_unit_test(test_coordinates), cmocka_unit_test(test_no_sigma)};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
