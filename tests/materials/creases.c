/* Lobes on creased surfaces: the roughness that patches add up to, and the patches themselves. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "materials/lobe.h"
#include "tests/support/near.h"

#define PATCHES 200000
#define SUN     0.00465 /* angular radius of the disc [rad] */

static float along[PATCHES], across[PATCHES], share[PATCHES];

/* Normal slopes of variance s^2 per axis. */
static struct um_materials_patches patches(double s, uint64_t seed, size_t n)
{
  for (size_t k = 0; k < n; k++) {
    uint64_t key = um_core_hash(seed, k);
    double u = 1.0 - um_core_hash_uniform(um_core_hash(key, 1)),
           v = um_core_hash_uniform(um_core_hash(key, 2)), r = s * sqrt(-2.0 * log(u));
    along[k] = (float)(r * cos(2.0 * UM_PI * v));
    across[k] = (float)(r * sin(2.0 * UM_PI * v));
    share[k] = (float)(1.0 / (double)n);
  }
  return (struct um_materials_patches){along, across, share, n};
}

static struct um_materials_lobe lobe_of(const char *kind, double alpha)
{
  return (struct um_materials_lobe){
      .kind = um_materials_lobe_kind_find(kind), .alpha = alpha, .alpha_across = alpha};
}

/* docs/physics/creases.md: alpha 0.0296 with tilts of 1, 3, 5, 10 deg; peaks thinner by
 * (alpha/alpha_eff)^2; the figures are rounded there. */
static void equivalent_roughness(void **state)
{
  static const struct {
    double tilt, alpha, dilution, digits;
  } row[] = {{1.0, 0.03854, 0.590, 5e-4},
             {3.0, 0.07981, 0.138, 5e-4},
             {5.0, 0.12722, 0.0541, 5e-5},
             {10.0, 0.25111, 0.0139, 5e-5}};
  (void)state;
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct um_materials_lobe lobe = lobe_of("beckmann", 0.0296);
    double s = tan(row[i].tilt * UM_DEG);
    struct um_materials_lobe wide = um_materials_lobe_tilted(&lobe, s * s);
    check_near("alpha_eff", wide.alpha, row[i].alpha, 5e-6);
    check_near("alpha_eff across", wide.alpha_across, row[i].alpha, 5e-6);
    check_near("dilution", 0.0296 * 0.0296 / (wide.alpha * wide.alpha), row[i].dilution,
               row[i].digits);
  }
}

/* A mirror is Beckmann's of the tilt alone; Lambert's stays, and all do without a tilt. */
static void other_kinds(void **state)
{
  (void)state;
  struct um_materials_lobe mirror = lobe_of("mirror", 0.0), lambert = lobe_of("lambert", 0.0),
                           ggx = lobe_of("ggx", 0.1);
  struct um_materials_lobe wide = um_materials_lobe_tilted(&mirror, 0.005);
  assert_ptr_equal(wide.kind, um_materials_lobe_kind_find("beckmann"));
  check_near("mirror", wide.alpha, 0.1, 1e-15);
  assert_ptr_equal(um_materials_lobe_tilted(&lambert, 0.005).kind, lambert.kind);
  assert_true(um_materials_lobe_tilted(&lambert, 0.005).alpha == 0.0);
  assert_ptr_equal(um_materials_lobe_tilted(&mirror, 0.0).kind, mirror.kind);
  assert_true(um_materials_lobe_tilted(&ggx, 0.0).alpha == 0.1);
  check_near("ggx", um_materials_lobe_tilted(&ggx, 0.005).alpha, sqrt(0.02), 1e-15);
}

static struct um_vec3 direction(double zenith, double azimuth)
{
  return um_vec3(sin(zenith) * cos(azimuth), sin(zenith) * sin(azimuth), cos(zenith));
}

static double value(const struct um_materials_lobe *lobe, double s, struct um_vec3 i,
                    struct um_vec3 o, const struct um_materials_patches *from)
{
  struct um_materials_lobe wide = um_materials_lobe_tilted(lobe, s * s);
  struct um_materials_pair pair = um_materials_pair(i, o);
  struct um_vec3 h = um_vec3_unit(um_vec3_add(i, o));
  if (from == NULL) return wide.kind->sunlit(&wide, &pair, SUN);
  return um_materials_lobe_patches(lobe, &wide, &pair, h.y, SUN, from);
}

/* The mean over many patches is the wider lobe at every pair of directions, and with it its energy:
 * 200000 of them, fluctuating as the next test says, within 4 standard errors. Mirrors too. */
static void the_mean_is_the_wider_lobe(void **state)
{
  static const struct {
    const char *kind;
    double alpha, tilt;
  } row[] = {{"beckmann", 0.0296, 3.0}, {"beckmann", 0.265, 5.0}, {"mirror", 0.0, 2.0}};
  (void)state;
  for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
    double s = tan(row[k].tilt * UM_DEG);
    struct um_materials_lobe lobe = lobe_of(row[k].kind, row[k].alpha);
    struct um_materials_patches from = patches(s, 7 + k, PATCHES);
    for (int zenith = 0; zenith <= 60; zenith += 20)
      for (int turn = 0; turn < 6; turn++) {
        double off = s * (0.3 * turn);
        struct um_vec3 i = direction(zenith * UM_DEG, 0.4), n = direction(off, 1.1 * turn);
        struct um_vec3 o = um_vec3_axpy(um_vec3_scale(i, -1.0), 2.0 * um_vec3_dot(i, n), n);
        if (!(o.z > 0.05)) continue;
        double expected = value(&lobe, s, i, o, NULL), is = value(&lobe, s, i, o, &from);
        /* E[k^2]/E[k]^2 of normal kernels at the slope x of the half vector */
        double v = 0.5 * row[k].alpha * row[k].alpha + SUN * SUN / 16.0, x = tan(off);
        double square = pow(v + s * s, 2.0) / (v * (v + 2.0 * s * s)) *
                        exp(x * x * (1.0 / (v + s * s) - 1.0 / (v + 2.0 * s * s)));
        double error = sqrt((square - 1.0) / PATCHES);
        if (!(fabs(is / expected - 1.0) <= 4.0 * error + 1e-6))
          fail_msg("%s %g at %d deg, %d: %.6g of the wider lobe; accepted: 1 +- %.2g", row[k].kind,
                   row[k].alpha, zenith, turn, is / expected, 4.0 * error);
        assert_true(value(&lobe, s, o, i, &from) == is || fabs(is) < 1e-300 ||
                    fabs(value(&lobe, s, o, i, &from) / is - 1.0) < 1e-12); /* reciprocal */
      }
  }
}

/* A shower of glints: the light of N patches toward their common normal varies from seed to seed as
 * that of N_eff = N v (v + 2 s^2)/s^4 events, v = alpha^2/2; for wide tilts N (alpha/s)^2
 * (docs/physics/creases.md). 400 seeds hold the variance within 4 sqrt((2 + kurtosis)/400), the
 * excess kurtosis of a sum of N patches being that of one over N: measured below 0.2 here. */
static void glints_fluctuate(void **state)
{
  enum { SEEDS = 400, N = 4000 };
  const double alpha = 0.05, s = tan(5.0 * UM_DEG), v = 0.5 * alpha * alpha + SUN * SUN / 16.0;
  double events = N * v * (v + 2.0 * s * s) / (s * s * s * s), sum = 0.0, square = 0.0;
  struct um_materials_lobe lobe = lobe_of("beckmann", alpha);
  struct um_vec3 n = um_vec3(0.0, 0.0, 1.0);
  (void)state;
  double mean = value(&lobe, s, n, n, NULL);
  for (uint64_t seed = 0; seed < SEEDS; seed++) {
    struct um_materials_patches from = patches(s, 100 + seed, N);
    double x = value(&lobe, s, n, n, &from) / mean;
    sum += x / SEEDS;
    square += (x - 1.0) * (x - 1.0) / SEEDS;
  }
  print_message("%d patches: %.1f events, fluctuation %.4f, expected %.4f\n", N, events,
                sqrt(square), 1.0 / sqrt(events));
  check_near("mean", sum, 1.0, 4.0 / sqrt(events * SEEDS));
  check_near("variance", square * events, 1.0, 4.0 * sqrt(2.2 / SEEDS));
}

/* A single patch is the surface itself, tilted: its glint stands where it mirrors, and the energy
 * under it is the whole: int D cos dw_h = int P dx dy = 1, here by midpoints over slopes. */
static void one_patch_is_a_tilted_lobe(void **state)
{
  const double alpha = 0.03, s = tan(3.0 * UM_DEG);
  const float x0 = 0.05F, y0 = -0.02F, all = 1.0F;
  const struct um_materials_patches one = {&x0, &y0, &all, 1};
  struct um_materials_lobe lobe = lobe_of("beckmann", alpha), wide;
  (void)state;
  wide = um_materials_lobe_tilted(&lobe, s * s);
  double sum = 0.0, step = 0.002, best = 0.0, best_x = 0.0, best_y = 0.0;
  for (double x = -0.3; x < 0.3; x += step)
    for (double y = -0.3; y < 0.3; y += step) {
      struct um_vec3 h = um_vec3_unit(um_vec3(x, y, 1.0));
      /* i = o = h: f = D/(4 cos^2) with masking 1 at these angles */
      double f = value(&lobe, s, h, h, &one), d = 4.0 * f * h.z * h.z;
      sum += d * h.z * h.z * h.z * h.z * step * step; /* D cos dw = D cos^4 dx dy */
      if (f > best) {
        best = f;
        best_x = x;
        best_y = y;
      }
    }
  check_near("int D cos", sum, 1.0, 1e-6);
  check_near("glint along", best_x, (double)x0, step);
  check_near("glint across", best_y, (double)y0, step);
  /* at the surface's own normal, f = exp(-r^2/alpha_w^2)/(4 pi alpha_w^2), alpha_w^2 = alpha^2 +
   * theta_s^2/8; slopes are single precision */
  struct um_materials_pair pair = um_materials_pair(um_vec3(0, 0, 1), um_vec3(0, 0, 1));
  double a2 = alpha * alpha + SUN * SUN / 8.0;
  double expected = exp(-(0.05 * 0.05 + 0.02 * 0.02) / a2) / (4.0 * UM_PI * a2);
  check_near("beside the glint", um_materials_lobe_patches(&lobe, &wide, &pair, 0.0, SUN, &one),
             expected, 1e-6 * expected);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(equivalent_roughness),       cmocka_unit_test(other_kinds),
      cmocka_unit_test(the_mean_is_the_wider_lobe), cmocka_unit_test(glints_fluctuate),
      cmocka_unit_test(one_patch_is_a_tilted_lobe),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
