/* scenarios/envisat-graz-2016: with the array at 65 deg both statements of the published study
 * about the LWIR curve are contradicted, at -35 deg, which the scenario has, both hold. Figures are
 * those of the README for the Earth of September and facets of 1.2 m, as its search had them;
 * tolerances are half of their last digit, and 0.001 for another order of sums. */
#include <string.h>

#include "tests/scenarios/support.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"
#define LAST     15 /* observations: 150 s */

struct figures {
  double share;       /* of cells and their backs in the LWIR of the pass [1] */
  double ratio;       /* mean LWIR of the last part over that of the time before [1] */
  double array, rest; /* by how much the means of array and rest fall [W/sr] */
};

static struct figures figures_of(const char *angle)
{
  const char *const overrides[] = {"thermal.facets=''",
                                   "time.step_s=10",
                                   "thermal.step_s=10",
                                   "thermal.accuracy_K=0.2",
                                   "thermal.exchange_patches=64",
                                   "thermal.view_factor_rays=512",
                                   "parts.bus.interior.conductivity_W_m_K=0",
                                   "bands.vis.bins=4",
                                   "bands.lwir.bins=8",
                                   "optics.samples=4",
                                   angle};
  struct support_run run;
  support_compute(SCENARIO, overrides, sizeof overrides / sizeof overrides[0], &run);
  const struct um_model_result *r = run.result;
  double sum[2][2] = {{0.0, 0.0}, {0.0, 0.0}}; /* [before, last][array, rest] */
  assert_int_equal(r->nobs, 80);
  assert_string_equal(run.model->band[1].name, "lwir");
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t m = 0; m < r->nmaterial; m++) {
      const char *name = um_geometry_material_name(run.model->geometry, m);
      bool array = strcmp(name, "cell_silicon") == 0 || strcmp(name, "cfrp") == 0;
      const double *at =
          r->intensity + ((k * r->nband + 1) * r->nmaterial + m) * UM_MECHANISM_COUNT;
      for (int i = 0; i < UM_MECHANISM_COUNT; i++) sum[k + LAST >= r->nobs][array ? 0 : 1] += at[i];
    }
  struct figures f;
  double before = (double)r->nobs - LAST, all = sum[0][0] + sum[0][1] + sum[1][0] + sum[1][1];
  f.share = (sum[0][0] + sum[1][0]) / all;
  f.ratio = (sum[1][0] + sum[1][1]) / LAST / ((sum[0][0] + sum[0][1]) / before);
  f.array = sum[0][0] / before - sum[1][0] / LAST;
  f.rest = sum[0][1] / before - sum[1][1] / LAST;
  support_release(&run);
  return f;
}

static void both_statements(void **state)
{
  (void)state;
  struct figures before = figures_of("parts.solar_array.joint.angle_deg=65");
  struct figures turned = figures_of("parts.solar_array.joint.angle_deg=-35");
  print_message("65 deg: share %.4f, ratio %.4f; -35 deg: share %.4f, ratio %.4f, array falls by "
                "%.1f, the rest by %.1f W/sr\n",
                before.share, before.ratio, turned.share, turned.ratio, turned.array, turned.rest);
  support_close("share at 65 deg", before.share, 0.43, 0.006);
  support_close("last over before at 65 deg", before.ratio, 1.71, 0.006);
  support_close("share at -35 deg", turned.share, 0.52, 0.006);
  support_close("last over before at -35 deg", turned.ratio, 0.85, 0.006);
  assert_true(turned.array > fabs(turned.rest));
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(both_statements)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
