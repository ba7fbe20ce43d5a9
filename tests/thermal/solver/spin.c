/* A skin of time constant tau under a load that turns with period P passes the amplitude
 * 1/sqrt(1 + (2 pi tau / P)^2) with the lag atan(2 pi tau / P).
 *
 *   Q = Q0 + Q1 cos(2 pi t / P) --> o C --K-- 250 K          tau = C / K
 *
 * Linear, so the formula is exact; the table has 720 rows a turn, which costs 6e-6 of the
 * amplitude. Also the formula's values for P = 215 s, rounded. */
#include "tests/thermal/network_help.h"

#define TURN 215.0
#define ROWS 721

static const struct {
  double tau, amplitude, lag; /* [s], [1], [deg] */
} rows[] = {{16.0, 0.906, 25.1},
            {28.0, 0.774, 39.3},
            {264.0, 0.129, 82.6},
            {345.0, 0.0987, 84.3},
            {1524.0, 0.0224, 88.7}};

static void test_filter(void **state)
{
  (void)state;
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, ROWS, 1, 0, &loads));
  for (size_t k = 0; k < ROWS; k++) {
    loads->t[k] = TURN * (double)k / (ROWS - 1);
    loads->irradiance[k] = 400.0 + 200.0 * cos(2.0 * UM_PI * (double)k / (ROWS - 1));
    loads->sunlit[k] = 1.0;
    loads->sun[k] = 1.0f;
  }
  for (size_t c = 0; c < sizeof rows / sizeof rows[0]; c++) {
    const double conductance = 5.0;
    struct um_thermal_network *network = help_network();
    uint32_t skin = help_node(network, rows[c].tau * conductance, 300.0);
    OK(um_thermal_network_conductor_add(network, skin, help_boundary(network, 250.0), conductance));
    help_surface(network, 0, skin, 1.0, 1.0, 0.0);
    struct um_thermal_solve_options options = help_options(1e-9, 1e-7, 0.0);
    double start[2], drift;
    /* what is left of the start drifts by 1e-4 K a turn at most: 3e-5 K in the lag's component */
    OK(um_thermal_solve_periodic(help_context, network, loads, &options, NULL, 0.0, TURN, 1e-4,
                                 start, &drift));
    struct um_thermal_history *history = NULL;
    OK(um_thermal_solve(help_context, network, loads, &options, start, 0.0, loads->t, ROWS,
                        &history));
    double in_phase = 0.0, behind = 0.0;
    for (size_t k = 0; k + 1 < ROWS; k++) {
      double angle = 2.0 * UM_PI * (double)k / (ROWS - 1);
      in_phase += history->temperature[k * 2 + skin] * cos(angle) * 2.0 / (ROWS - 1);
      behind += history->temperature[k * 2 + skin] * sin(angle) * 2.0 / (ROWS - 1);
    }
    double x = 2.0 * UM_PI * rows[c].tau / TURN;
    double amplitude = hypot(in_phase, behind) / (200.0 / conductance);
    double lag = atan2(behind, in_phase) / UM_DEG;
    print_message("tau %.0f s: amplitude %.6f (%.6f), lag %.4f (%.4f) deg\n", rows[c].tau,
                  amplitude, 1.0 / sqrt(1.0 + x * x), lag, atan(x) / UM_DEG);
    NEAR("amplitude", amplitude * sqrt(1.0 + x * x), 1.0, 2e-5);
    NEAR("lag", lag, atan(x) / UM_DEG, 1e-3);
    /* half a unit of the last digit */
    NEAR("amplitude, rounded", amplitude, rows[c].amplitude,
         rows[c].amplitude < 0.1 ? 5.1e-5 : 5.1e-4);
    NEAR("lag, rounded", lag, rows[c].lag, 0.051);
    um_thermal_history_destroy(help_context, &history);
    um_thermal_network_destroy(&network);
  }
  um_irradiation_loads_destroy(help_context, &loads);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_filter)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
