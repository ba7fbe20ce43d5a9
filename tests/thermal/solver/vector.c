/* Vectors of the integration against SUNDIALS' own: sums and products bit for bit, the norm to the
 * rounding of its sum, n 1e-16. */
#include <math.h>
#include <nvector/nvector_serial.h>

#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"
#include "thermal/solver/sundials_impl.h"
#include "thermal/solver/vector_impl.h"

#define N 1003

static void fill(N_Vector v, uint64_t key)
{
  for (size_t k = 0; k < N; k++)
    N_VGetArrayPointer(v)[k] = 2.0 * um_core_hash_uniform(um_core_hash(key, k)) - 1.0;
}

static void assert_same(N_Vector a, N_Vector b)
{
  assert_memory_equal(N_VGetArrayPointer(a), N_VGetArrayPointer(b), N * sizeof(double));
}

static void as_sundials(void **state)
{
  static const double factor[] = {1.0, -1.0, 0.3, -0.3, 1.0 / 3.0, 0.0};
  const size_t nfactor = sizeof factor / sizeof factor[0];
  SUNContext sun;
  (void)state;
  assert_int_equal(SUNContext_Create(SUN_COMM_NULL, &sun), 0);
  N_Vector x = um_thermal_vector_create(N, sun), y = N_VClone(x), z = N_VClone(x), e = N_VClone(x);
  fill(x, 1);
  fill(y, 2);
  for (size_t i = 0; i < nfactor; i++) {
    for (size_t j = 0; j < nfactor; j++) {
      N_VLinearSum(factor[i], x, factor[j], y, z);
      N_VLinearSum_Serial(factor[i], x, factor[j], y, e);
      assert_same(z, e);
      N_VScale(1.0, y, z); /* onto one of its own arguments */
      N_VLinearSum(factor[i], x, factor[j], z, z);
      assert_same(z, e);
    }
    N_VScale(factor[i], x, z);
    N_VScale_Serial(factor[i], x, e);
    assert_same(z, e);
    N_VScale(factor[i], z, z);
    N_VScale_Serial(factor[i], e, e);
    assert_same(z, e);
  }
  double norm = N_VWrmsNorm_Serial(x, y);
  assert_true(fabs(N_VWrmsNorm(x, y) - norm) <= N * 1e-16 * norm);
  N_VDestroy(x);
  N_VDestroy(y);
  N_VDestroy(z);
  N_VDestroy(e);
  SUNContext_Free(&sun);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_sundials)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
