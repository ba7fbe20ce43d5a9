/* A cube through two orbits against ESATAN-TMS (F. Meijering, MSc thesis, TU Delft 2024): 1 m,
 * alpha = eps = 1 outside, no radiation inside, 1000 J/K a face, 1 W/K between neighbours, 20 degC
 * at the start, 408 km, beta 0, LVLH. The whole thermal chain takes part: geometry, lumped body,
 * contacts, orbital loads, integration.
 *
 * Solar irradiance 1413.55 W/m2 and albedo 0.3084 are what ESATAN's own flux files say (test
 * thermal_loads_esatan). What remains is ESATAN's: ray noise of 1 % on what the Earth sends (known
 * from the same files), on the nadir face, which absorbs up to 590 W/m2 from it, conducts 4 W/K and
 * radiates 4 sigma T^3 = 6.4 W/m2/K, 6 / (4 + 6.4) = 0.6 K; and its step of 22 s over the edge of
 * the shadow, 7.7 s wide in its tables: up to 3 s misplaced are 3 s * 1.41 K/s = 4.2 K on a face
 * that the Sun leaves or meets at full strength, for a few rows. */
#include "tests/support/reference.h"
#include "tests/thermal/body_help.h"
#include "thermal/loads/loads.h"

#define ROWS    512
#define SAMPLES 109

/* Rows of time [s] and six temperatures [K]. */
static size_t read_rows(double *t, double (*temperature)[6])
{
  static const char *const column[6] = {"velocity_K", "y_minus_K", "zenith_K",
                                        "y_plus_K",   "nadir_K",   "wake_K"};
  struct um_core_csv *csv = reference_open(help_context, "esatan-cube");
  size_t n = um_core_csv_rows(csv);
  assert_int_equal(n, 501);
  for (size_t k = 0; k < n; k++) {
    t[k] = reference_number(help_context, csv, k, "time_s");
    for (int e = 0; e < 6; e++)
      temperature[k][e] = reference_number(help_context, csv, k, column[e]);
  }
  um_core_csv_destroy(&csv);
  return n;
}

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* ESATAN's own sampling: 50 steps an orbit, and 3.862 s before and after the edges of the cylinder
 * shadow (as in its flux files); loads are linear in between. */
static struct um_irradiation_loads *trace(const struct help_satellite *s, double period, double end)
{
  static struct um_environment_sample sample[SAMPLES];
  static double t[SAMPLES];
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.solar_irradiance = 1413.55;
  environment.albedo = 0.3084;
  environment.outgoing_longwave = 239.0;
  environment.earth_radius = environment.shadow_radius = 6371e3;
  environment.shadow = UM_SHADOW_CYLINDER;
  environment.disc = UM_DISC_POINT;
  double a = 6779e3, edge[4], half = asin(6371.0 / 6779.0) / (2.0 * UM_PI); /* of the shadow */
  size_t n = 0;
  for (int e = 0; e < 4; e++) edge[e] = period * (0.5 + (e & 1 ? half : -half) + e / 2);
  for (int k = 0; k <= 100; k++) t[n++] = k == 100 ? end : k * period / 50.0;
  for (int e = 0; e < 4; e++) {
    t[n++] = edge[e] - 3.862;
    t[n++] = edge[e] + 3.862;
  }
  assert_true(n <= SAMPLES);
  qsort(t, n, sizeof t[0], ascending);
  for (size_t k = 0; k < n; k++) {
    double u = 2.0 * UM_PI * t[k] / period;
    struct um_vec3 z = um_vec3(-cos(u), -sin(u), 0), x = um_vec3(-sin(u), cos(u), 0);
    sample[k] = (struct um_environment_sample){.t_tai = t[k],
                                               .r = um_vec3_scale(z, -a),
                                               .sun = {1, 0, 0},
                                               .sun_distance = UM_AU,
                                               .pole = {0, 0, 1}};
    sample[k].q = um_core_quat_from_matrix(um_mat3_from_axes(x, um_vec3_cross(z, x), z));
    sample[k].sunlit_fraction = um_environment_sunlit_fraction(
        &environment, sample[k].r, sample[k].sun, UM_AU, sample[k].pole);
  }
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_trace(help_context, s->geometry, &environment, sample, n, edge, 4, 16,
                                &loads));
  return loads;
}

static void test_cube(void **state)
{
  (void)state;
  static double t[ROWS], reference[ROWS][6];
  size_t n = read_rows(t, reference);
  static const char *face[6] = {"cube.+x", "cube.-y", "cube.-z", "cube.+y", "cube.+z", "cube.-x"};
  struct help_satellite s = {0};
  help_part(&s, "cube", UM_SHAPE_BOX, NULL);
  s.spec[0].kind = UM_THERMAL_LUMPED;
  s.spec[0].shell.areal_heat_capacity = 1000.0;
  s.spec[0].start_temperature = 293.15;
  struct um_thermal_contact contact[12];
  size_t ncontact = 0;
  for (int i = 0; i < 6; i++)
    for (int j = i + 1; j < 6; j++)
      if (face[i][6] != face[j][6]) /* not the opposite face */
        contact[ncontact++] = (struct um_thermal_contact){face[i], face[j], 1.0, 0.0};
  assert_int_equal(ncontact, 12);
  help_build(&s, contact, ncontact);
  struct um_irradiation_loads *loads = trace(&s, 5560.988495051516, t[n - 1]);
  struct um_thermal_solve_options options = help_options(1e-7, 1e-6, 0.0);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, s.body->network, loads, &options, NULL, 0.0, t, n, &history));
  for (int e = 0; e < 6; e++) {
    double worst = 0.0, rms = 0.0, worst_at = 0.0;
    uint32_t node = help_place(&s, face[e])->node[0];
    for (size_t k = 0; k < n; k++) {
      double d = history->temperature[k * history->nnode + node] - reference[k][e];
      rms += d * d / (double)n;
      if (!(fabs(d) <= worst)) {
        worst = fabs(d);
        worst_at = t[k];
      }
    }
    print_message("%s: rms %.3f K, worst %.3f K at %.0f s\n", face[e], sqrt(rms), worst, worst_at);
    NEAR(face[e], sqrt(rms), 0.0, 0.6);
    NEAR(face[e], worst, 0.0, 4.2);
  }
  um_thermal_history_destroy(help_context, &history);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_cube)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
