/* Low-discrepancy points keyed by index. */
#include "base/core/sampling.h"

#include "base/core/constants.h"

/* splitmix64 finaliser (Steele, Lea & Flood 2014). */
static uint64_t mix(uint64_t z)
{
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

uint64_t um_core_hash(uint64_t a, uint64_t b)
{
  return mix(mix(a + UINT64_C(0x9e3779b97f4a7c15)) ^ (b + UINT64_C(0xd1b54a32d192ed03)));
}

double um_core_hash_uniform(uint64_t hash) { return (double)(hash >> 11) * 0x1p-53; }

void um_core_sample_2d(uint64_t key, uint64_t index, double out[2])
{
  /* R2: steps 1/g and 1/g^2 with g^3 = g + 1 (Roberts 2018), as 64-bit fixed-point fractions, so
   * that the sum wraps exactly modulo 1. */
  const uint64_t step_x = UINT64_C(0xc13fa9a902a6328f), step_y = UINT64_C(0x91e10da5c79e7b1d);
  uint64_t n = index + 1;
  uint64_t shift_x = um_core_hash(key, 1), shift_y = um_core_hash(key, 2);
  out[0] = um_core_hash_uniform(n * step_x + shift_x);
  out[1] = um_core_hash_uniform(n * step_y + shift_y);
}

void um_core_sample_triangle(const double u[2], double weight[3])
{
  double root = sqrt(u[0]);
  weight[0] = 1.0 - root;
  weight[1] = root * (1.0 - u[1]);
  weight[2] = root * u[1];
}

void um_core_sample_disc(const double u[2], double xy[2])
{
  double a = 2.0 * u[0] - 1.0, b = 2.0 * u[1] - 1.0;
  double r, phi;
  if (a == 0.0 && b == 0.0) {
    xy[0] = xy[1] = 0.0;
    return;
  }
  if (fabs(a) > fabs(b)) {
    r = a;
    phi = 0.25 * UM_PI * (b / a);
  } else {
    r = b;
    phi = 0.5 * UM_PI - 0.25 * UM_PI * (a / b);
  }
  xy[0] = r * cos(phi);
  xy[1] = r * sin(phi);
}

struct um_vec3 um_core_sample_cosine(const double u[2], struct um_vec3 n)
{
  double xy[2];
  um_core_sample_disc(u, xy);
  struct um_vec3 t, b;
  um_core_vec3_frame(n, &t, &b);
  double z = sqrt(fmax(0.0, 1.0 - xy[0] * xy[0] - xy[1] * xy[1]));
  return um_vec3_axpy(um_vec3_axpy(um_vec3_scale(t, xy[0]), xy[1], b), z, n);
}
