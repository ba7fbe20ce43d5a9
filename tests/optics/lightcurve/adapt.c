/* Does a light curve have the error that it states, and the one that was asked for?
 *
 *        wing (turned, moved)
 *      ----/----
 *        +-----+   the bus is hidden and shaded by the wing in part, seen and lit from INSTANTS
 *        | bus |   directions drawn at random; each of 100 draws (40 in a part of the sweep) of the
 * points has errors that
 *        +-----+   are independent of those of the others
 *
 * Truth is the mean of two draws with 2048 points, whose own variance is a hundredth of what is
 * looked at. Sums over draws and instants of (value - truth)^2 and of the stated variance are held
 * against each other: their ratio is chi-square per degree of freedom, as many as instants times
 * draws, of which those of one draw have much in common; the ratio of one scene is good to 10 %,
 * and SCENES of them differ, since edges are no random lines. */
#include "optics/lightcurve/adapt.h"

#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/optics/fixture.h"
#include "tests/support/whole.h"

enum { SCENES = 3, INSTANTS = 10, VALUES = 2 * INSTANTS, TRUTHS = 2 };

static void configure(struct fixture *f, uint64_t c)
{
  fixture_pair(f, c, 1.5, INSTANTS);
  for (uint64_t t = 0; t < INSTANTS; t++) {
    struct um_environment_sample *s = &f->samples[t];
    s->sun = fixture_direction(c, 30 + 4 * t);
    s->to_observer = um_vec3_unit(um_vec3_axpy(s->sun, 0.9, fixture_direction(c, 32 + 4 * t)));
  }
}

static const struct um_optics_band bands[2] = {{"vis", 0.38e-6, 0.78e-6, 2, NULL},
                                               {"lwir", 8e-6, 12e-6, 2, NULL}};

/* Intensities and stated errors of all instants and bands for a seed [VALUES]; asked NaN: 16
 * points, or `nsample` of them. */
static void draw(struct fixture *f, uint64_t seed, int nsample, double asked, double *value,
                 double *error)
{
  f->seed = seed;
  fixture_run(f, nsample, bands, 2);
  if (!isnan(asked)) {
    struct um_optics_adaptation did;
    FIXTURE_OK(f, um_optics_adapt(f->context, &f->scene, bands, 2, asked, f->view, &did));
    assert_true(did.missed == 0 && did.largest <= 1.05 * asked);
    um_optics_lightcurve_destroy(f->context, &f->curve);
    FIXTURE_OK(f, um_optics_lightcurve_compute(f->context, &f->scene, bands, 2, &f->curve));
  }
  size_t n = f->curve->nmaterial * UM_MECHANISM_COUNT;
  for (size_t k = 0; k < VALUES; k++) {
    value[k] = 0.0;
    for (size_t i = 0; i < n; i++) value[k] += f->curve->intensity[k * n + i];
    if (error != NULL) error[k] = f->curve->stderr_[k];
  }
}

static void truth_of(struct fixture *f, double *truth)
{
  double value[VALUES];
  for (size_t k = 0; k < VALUES; k++) truth[k] = 0.0;
  for (uint64_t s = 0; s < TRUTHS; s++) {
    draw(f, 1000 + s, 2048, NAN, value, NULL);
    for (size_t k = 0; k < VALUES; k++) truth[k] += value[k] / TRUTHS;
  }
}

/* Mean square of relative errors, of stated ones, over the instants and bands whose stated error is
 * not 0; where an error was asked for, of the larger band of the instants that took more points. */
struct scatter {
  double error, stated;
  size_t n;
};

static void look(struct fixture *f, const double *truth, uint64_t seed, double asked,
                 struct scatter sum[2])
{
  double value[VALUES], error[VALUES];
  draw(f, seed, asked > 0.0 ? 4 : 16, asked, value, error);
  for (size_t t = 0; t < INSTANTS; t++) {
    if (asked > 0.0 && f->view->nsample[t] == 4) continue;
    double stated[2];
    for (size_t k = 0; k < 2; k++)
      stated[k] = truth[2 * t + k] > 0.0 ? error[2 * t + k] / truth[2 * t + k] : 0.0;
    for (size_t k = 0; k < 2; k++) {
      if (!(stated[k] > 0.0) || (asked > 0.0 && stated[k] < stated[1 - k])) continue;
      double e = value[2 * t + k] / truth[2 * t + k] - 1.0;
      sum[k].error += e * e;
      sum[k].stated += stated[k] * stated[k];
      sum[k].n++;
    }
  }
}

static void test_stated(void **state)
{
  (void)state;
  struct scatter sum[2] = {{0.0, 0.0, 0}};
  double truth[VALUES];
  for (uint64_t c = 0; c < SCENES; c++) {
    struct fixture f;
    configure(&f, 700 + c);
    truth_of(&f, truth);
    for (uint64_t s = 0; s < (uint64_t)um_test_number(100, 40); s++) look(&f, truth, s, NAN, sum);
    fixture_destroy(&f);
  }
  for (size_t k = 0; k < 2; k++) {
    double is = sqrt(sum[k].error / (double)sum[k].n),
           said = sqrt(sum[k].stated / (double)sum[k].n);
    print_message("%s: error %.4f %%, stated %.4f %%, ratio %.3f\n", bands[k].name, 100.0 * is,
                  100.0 * said, is / said);
    assert_true(fabs(is / said - 1.0) <= 0.1);
  }
}

/* Each instant's error in the band that needs more. */
static void test_asked(void **state)
{
  (void)state;
  const double asked = 0.003;
  struct scatter all = {0.0, 0.0, 0};
  double truth[VALUES];
  for (uint64_t c = 0; c < SCENES; c++) {
    struct fixture f;
    struct scatter sum[2] = {{0.0, 0.0, 0}};
    configure(&f, 700 + c);
    truth_of(&f, truth);
    for (uint64_t s = 0; s < (uint64_t)um_test_number(100, 40); s++) look(&f, truth, s, asked, sum);
    for (size_t k = 0; k < 2; k++) {
      all.error += sum[k].error;
      all.stated += sum[k].stated;
      all.n += sum[k].n;
    }
    fixture_destroy(&f);
  }
  double is = sqrt(all.error / (double)all.n), said = sqrt(all.stated / (double)all.n);
  print_message("asked %.2f %%: error %.4f %%, stated %.4f %%\n", 100.0 * asked, 100.0 * is,
                100.0 * said);
  assert_true(fabs(is / asked - 1.0) <= 0.2);
}

/* Light between surfaces is of both: paths are added as points are. */
static void test_asked_between(void **state)
{
  (void)state;
  const double asked = 0.003;
  struct scatter sum[2] = {{0.0, 0.0, 0}};
  double truth[VALUES];
  struct fixture f;
  configure(&f, 701);
  f.scene.interreflection_samples = 2048;
  truth_of(&f, truth);
  f.scene.interreflection_samples = 16;
  int most = 1;
  for (uint64_t s = 0; s < (uint64_t)um_test_number(100, 40); s++) {
    look(&f, truth, s, asked, sum);
    for (size_t t = 0; t < INSTANTS; t++) most = (int)fmax(most, f.view->path_factor[t]);
  }
  double n = (double)(sum[0].n + sum[1].n), is = sqrt((sum[0].error + sum[1].error) / n),
         said = sqrt((sum[0].stated + sum[1].stated) / n);
  print_message("asked %.2f %%: error %.4f %%, stated %.4f %%, up to %d times the paths\n",
                100.0 * asked, 100.0 * is, 100.0 * said, most);
  assert_true(most > 1);
  assert_true(fabs(is / asked - 1.0) <= 0.2);
  fixture_destroy(&f);
}

/* Numbers of points and all values are the same for any number of threads. */
static void test_threads(void **state)
{
  (void)state;
  struct fixture f;
  double one[VALUES], two[VALUES];
  configure(&f, 700);
  um_core_context_set_threads(f.context, 1);
  draw(&f, 3, 4, 0.004, one, NULL);
  um_core_context_set_threads(f.context, 3);
  draw(&f, 3, 4, 0.004, two, NULL);
  assert_memory_equal(one, two, sizeof one);
  fixture_destroy(&f);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_stated), cmocka_unit_test(test_asked),
                                     cmocka_unit_test(test_asked_between),
                                     cmocka_unit_test(test_threads)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
