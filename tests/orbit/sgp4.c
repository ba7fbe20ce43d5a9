/* SGP4/SDP4 against the verification set of AIAA 2006-6753 (33 satellites, WGS-72, mode 'i').
 *
 * The file of results prints 8 decimals of a kilometre and 9 of km/s. Tolerances 2e-7 km and 2e-9
 * km/s: the last digit, and the rounding of 1e6 minutes of mean motion in double precision. */
#include "orbit_test.h"

#include "orbit/sgp4.h"
#include "tests/support/reference.h"

struct worst {
  double r, v; /* [km], [km/s] */
  double at;   /* [min] */
  int satellite, states;
};

static struct um_vec3 vector_of(struct um_context *context, const struct um_core_csv *csv,
                                size_t row, const char *const column[3])
{
  return um_vec3(reference_number(context, csv, row, column[0]),
                 reference_number(context, csv, row, column[1]),
                 reference_number(context, csv, row, column[2]));
}

/* Compare the states of one satellite, which stand together; returns the row behind them and the
 * last time among them [min]. */
static size_t states_compare(struct um_context *context, struct um_orbit_sgp4 *sgp4, int number,
                             const struct um_core_csv *states, size_t row, struct worst *worst,
                             double *last)
{
  static const char *const r_km[3] = {"x_km", "y_km", "z_km"};
  static const char *const v_km_s[3] = {"vx_km_s", "vy_km_s", "vz_km_s"};
  for (; row < um_core_csv_rows(states); row++) {
    if ((int)reference_number(context, states, row, "catalogue_number") != number) break;
    double t = reference_number(context, states, row, "t_min");
    struct um_vec3 r, v, r_expected = vector_of(context, states, row, r_km);
    struct um_vec3 v_expected = vector_of(context, states, row, v_km_s);
    int error = -1;
    *last = t;
    if (um_orbit_sgp4_state(context, sgp4, t, &r, &v, &error) != UM_OK)
      fail_msg("%d at %g min: %s", number, t, um_core_message(context));
    assert_int_equal(error, 0);
    double dr = um_vec3_norm(um_vec3_sub(um_vec3_scale(r, 1e-3), r_expected));
    double dv = um_vec3_norm(um_vec3_sub(um_vec3_scale(v, 1e-3), v_expected));
    if (!(dr <= worst->r)) {
      worst->r = dr;
      worst->satellite = number;
      worst->at = t;
    }
    if (!(dv <= worst->v)) worst->v = dv;
    worst->states++;
  }
  return row;
}

/* The first error met from `start` on in steps, as the file's program ran; 0 when there is none. */
static int first_error(struct um_context *context, struct um_orbit_sgp4 *sgp4, double start,
                       double stop, double step, double *at)
{
  struct um_vec3 r, v;
  int error = 0;
  for (double t = start; t <= stop; t += step) {
    um_core_message_clear(context);
    *at = t;
    if (um_orbit_sgp4_state(context, sgp4, t, &r, &v, &error) != UM_OK) return error;
  }
  return 0;
}

/* One satellite of the set: the code at which its run ends and when, and its states. Returns the
 * row behind them. */
static size_t satellite_compare(struct um_context *context, const struct um_core_csv *elements,
                                size_t k, const struct um_core_csv *states, size_t row,
                                struct worst *worst)
{
  char set[256];
  double last = NAN, at = NAN, step = reference_number(context, elements, k, "step_min");
  int expected = (int)reference_number(context, elements, k, "error");
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  snprintf(set, sizeof set, "%s\n%s", reference_text(context, elements, k, "line_1"),
           reference_text(context, elements, k, "line_2"));
  assert_ok(context, um_orbit_tle_parse(context, set, 0, &tle));
  assert_int_equal(tle.catalogue_number,
                   (int)reference_number(context, elements, k, "catalogue_number"));
  assert_ok(context, um_orbit_sgp4_create(context, &tle, &sgp4));
  int error = first_error(context, sgp4, reference_number(context, elements, k, "start_min"),
                          reference_number(context, elements, k, "stop_min"), step, &at);
  um_core_message_clear(context);
  if (error != expected)
    fail_msg("satellite %d: error %d at %g min, expected %d", tle.catalogue_number, error, at,
             expected);
  size_t after = states_compare(context, sgp4, tle.catalogue_number, states, row, worst, &last);
  if (error != 0) {
    print_message("satellite %d: error %d at %g min\n", tle.catalogue_number, error, at);
    assert_close(at, reference_number(context, elements, k, "failure_min"), 1e-6);
    if (at > 0.0) assert_close(at, last + step, 1e-6); /* one step after its last state */
  }
  assert_true(after > row || (error != 0 && at == 0.0));
  um_orbit_sgp4_destroy(&sgp4);
  return after;
}

static void verification_set(void **state)
{
  struct um_context *context = *state;
  struct um_core_csv *elements = reference_open(context, "sgp4-elements");
  struct um_core_csv *states = reference_open(context, "sgp4-states");
  struct worst worst = {0};
  size_t row = 0;
  assert_int_equal(um_core_csv_rows(elements), 33);
  for (size_t k = 0; k < 33; k++)
    row = satellite_compare(context, elements, k, states, row, &worst);
  assert_int_equal(row, um_core_csv_rows(states));
  print_message("%d states: largest error %.3g km (satellite %d at %g min), %.3g km/s\n",
                worst.states, worst.r, worst.satellite, worst.at, worst.v);
  assert_int_equal(worst.states, 666);
  um_core_csv_destroy(&states);
  um_core_csv_destroy(&elements);
  if (!(worst.r <= 2e-7)) fail_msg("position: %.3g km, tolerance 2e-7 km", worst.r);
  if (!(worst.v <= 2e-9)) fail_msg("velocity: %.3g km/s, tolerance 2e-9 km/s", worst.v);
}

static const char vanguard[] = /* AIAA 2006-6753, satellite 00005 */
    "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753\n"
    "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667\n";

/* The states that the paper prints. Tolerance: their last digit. */
static void printed_states(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  struct um_vec3 r, v;
  assert_ok(context, um_orbit_tle_parse(context, vanguard, 1, &tle));
  assert_ok(context, um_orbit_sgp4_create(context, &tle, &sgp4));
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, 0.0, &r, &v, NULL));
  assert_vec_near(r, um_vec3(7022465.29266, -1400082.96755, 39.95155), 2e-5);
  assert_vec_near(v, um_vec3(1893.841015, 6405.893759, 4534.807250), 2e-6);
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, 360.0, &r, &v, NULL));
  assert_vec_near(r, um_vec3(-7154031.20202, -3783176.82504, -3536194.12294), 2e-5);
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, 4320.0, &r, &v, NULL));
  assert_vec_near(r, um_vec3(-9060473.73569, 4658709.52502, 813686.73153), 2e-5);
  um_orbit_sgp4_destroy(&sgp4);
  assert_null(sgp4);
}

/* The order of calls does not matter, bit for bit, on a resonant deep-space orbit (MOLNIYA 2-14).
 */
static void stateless(void **state)
{
  struct um_context *context = *state;
  static const char molniya[] =
      "1 08195U 75081A   06176.33215444  .00000099  00000-0  11873-3 0   813\n"
      "2 08195  64.1586 279.0717 6877146 264.7651  20.2257  2.00491383225656\n";
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  struct um_vec3 first, v, again;
  assert_ok(context, um_orbit_tle_parse(context, molniya, 1, &tle));
  assert_ok(context, um_orbit_sgp4_create(context, &tle, &sgp4));
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, 2500.0, &first, &v, NULL));
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, -4000.0, &again, &v, NULL));
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, 9000.0, &again, &v, NULL));
  assert_ok(context, um_orbit_sgp4_state(context, sgp4, 2500.0, &again, &v, NULL));
  assert_memory_equal(&first, &again, sizeof first);
  um_orbit_sgp4_destroy(&sgp4);
}

/* 33334 (12 h debris with a mean motion of 1e-5 rev/day): error 3 at the epoch, said in words. */
static void error_message(void **state)
{
  struct um_context *context = *state;
  static const char set[] =
      "1 33334U 78066F   06174.85818871  .00000620  00000-0  10000-3 0  6809\n"
      "2 33334  68.4714 236.1303 5602877 123.7484 302.5767  0.00001000 67521\n";
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  struct um_vec3 r, v;
  int error = 0;
  assert_ok(context, um_orbit_tle_parse(context, set, 0, &tle));
  assert_ok(context, um_orbit_sgp4_create(context, &tle, &sgp4));
  assert_int_equal(um_orbit_sgp4_state(context, sgp4, 0.0, &r, &v, &error), UM_ERR_NUMERIC);
  assert_int_equal(error, 3);
  assert_string_equal(um_core_message(context), "SGP4 error 3 (perturbed eccentricity outside 0 to "
                                                "1) at 0.000 min from the epoch of the elements");
  um_orbit_sgp4_destroy(&sgp4);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(verification_set, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(printed_states, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(stateless, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(error_message, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
