/* scenarios/cube and two plates against ESATAN-TMS (F. Meijering, MSc thesis, TU Delft 2024).
 *
 * What separates a correct answer from the reference is the reference's own, and was measured by
 * computing it again in its manner apart from this program:
 *
 *   step   22.244 s steps with the mean of the loads at both ends. The Sun goes 13.908 s before a
 *          row and returns 8.336 s before one; ESATAN counts half a step, 11.122 s, both times, so
 *          that the face which meets the Sun is hotter there by 2.786 s * 1.38 W/m2 / (1000
 *          J/m2/K) = 3.8 K, and comes back within minutes.
 *   table  loads linear between 50 positions of the orbit, 111.2 s apart. Where zenith and nadir
 *          face meet grazing Sun amid two positions that adds S w h^2/8 = 2.5 K (w = 2 pi / 5561
 * s). rays   the Earth's part, by rays: about 1 % (its plate files: -1.0 to +0.4 %); on the cube
 * the faces come out between -1.9 and +2.6 %. 1 % of up to 600 W/m2 on the nadir face over 4 W/K +
 * 4 sigma T^3 = 10.3 W/K is 0.6 K; 2.6 % of 190 W/m2 on a side face over 8.8 W/K as much.
 *
 * With the three in it, the repeated computation meets all six temperatures to 0.03 K (rms 0.008).
 * S and the albedo coefficient are those of ESATAN's flux files
 * (tests/thermal/loads/loads_esatan.c).
 */
#include "tests/scenarios/support.h"
#include "tests/support/reference.h"

#define ROWS     512
#define ELEMENTS 6

struct reference {
  double t[ROWS];                     /* [s] */
  double temperature[ROWS][ELEMENTS]; /* [K] */
  size_t n;
};

/* Column 0 is the time, those behind it the elements. */
static void reference_read(const char *name, size_t elements, struct reference *out)
{
  struct um_context *context = NULL;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  struct um_core_csv *csv = reference_open(context, name);
  out->n = um_core_csv_rows(csv);
  assert_int_equal(out->n, 501);
  assert_int_equal(um_core_csv_columns(csv), elements + 1);
  for (size_t k = 0; k < out->n; k++) {
    out->t[k] = reference_number(context, csv, k, "time_s");
    for (size_t e = 0; e < elements; e++)
      out->temperature[k][e] = reference_number(context, csv, k, um_core_csv_header(csv, e + 1));
  }
  um_core_csv_destroy(&csv);
  um_core_context_destroy(&context);
}

/* Differences of one element: rms and largest [K] within what is allowed. */
static void compare(const struct support_run *run, const struct reference *reference,
                    size_t element, const char *place, double rms_allowed, double largest_allowed)
{
  const double *temperature = support_temperature(run, place);
  double square = 0.0, largest = 0.0, at = 0.0;
  for (size_t k = 0; k < reference->n; k++) {
    support_close("time [s]", support_time(run, k), reference->t[k], 1e-2);
    double d = temperature[k] - reference->temperature[k][element];
    square += d * d / (double)reference->n;
    if (!(fabs(d) <= largest)) {
      largest = fabs(d);
      at = reference->t[k];
    }
  }
  print_message("%-10s rms %.3f K (allowed %.2f), largest %.2f K (allowed %.2f) at %.0f s\n", place,
                sqrt(square), rms_allowed, largest, largest_allowed, at);
  support_close(place, sqrt(square), 0.0, rms_allowed);
  support_close(place, largest, 0.0, largest_allowed);
}

static void cube(void **state)
{
  (void)state;
  static struct reference reference;
  reference_read("esatan-cube", 6, &reference);
  struct support_run run;
  support_compute(UMBRA_SOURCE_DIR "/scenarios/cube", NULL, 0, &run);
  assert_int_equal(run.result->nobs, reference.n);
  /* elements: velocity, y-, zenith, y+, nadir, wake; LVLH z looks down */
  compare(&run, &reference, 0, "cube.+x", 0.6, 3.8 + 0.6);
  compare(&run, &reference, 5, "cube.-x", 0.6, 3.8 + 0.6);
  compare(&run, &reference, 2, "cube.-z", 0.6, 2.5 + 0.6);
  compare(&run, &reference, 4, "cube.+z", 0.6, 2.5 + 0.6);
  /* sides: what the faces beside them pass on, 3 K * 150 s * 1 W/K / (1000 J/K) */
  compare(&run, &reference, 1, "cube.-y", 0.6, 0.45 + 0.6);
  compare(&run, &reference, 3, "cube.+y", 0.6, 0.45 + 0.6);
  support_release(&run);
}

/* Joined by 1 W/K only, so that 1 % of 190 W/m2 on the velocity plate over 1 + 5.3 W/K is 0.3 K. */
static void plates(void **state)
{
  (void)state;
  static struct reference reference;
  reference_read("esatan-two-plates", 2, &reference);
  struct support_run run;
  support_compute(UMBRA_SOURCE_DIR "/tests/scenarios/data/plates.yaml", NULL, 0, &run);
  assert_int_equal(run.result->nobs, reference.n);
  compare(&run, &reference, 0, "velocity", 0.6, 3.8 + 0.6);
  compare(&run, &reference, 1, "zenith", 0.6, 2.5 + 0.6);
  support_release(&run);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(cube), cmocka_unit_test(plates)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
