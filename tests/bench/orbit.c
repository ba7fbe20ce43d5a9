/* Orbit: what a state costs, SGP4 against a two-body ellipse, and what the frames add to it.
 *
 * References, measured in the same run: a Kepler state (Kepler's equation, two rotated axes) for
 * the propagator; ERFA's eraC2t06a, which the frames wrap, for them. Errors: SGP4 at the three
 * states of Vanguard 1 printed in AIAA 2006-6753 (a centimetre, a thousand times their last digit),
 * Kepler against itself one revolution later (1e-9 of the radius: rounding of the time).
 *
 * Goals. SGP4 four times a Kepler state: it solves the same equation and has some twenty more sines
 * and cosines. Deep space twice that: lunar and solar terms, resonance steps from the epoch on. A
 * frame matrix, and a state of elements in GCRS, 1.1 times ERFA: time scales and SGP4 are all that
 * is added. What the frame costs beside a bare SGP4 state is shown without a goal. */
#include <math.h>
#include <string.h>

#include <erfa.h>

#include "base/core/constants.h"
#include "orbit/frames.h"
#include "orbit/sgp4.h"
#include "orbit/sun.h"
#include "orbit/time.h"
#include "orbit/trajectory.h"
#include "tests/bench/bench.h"

#define RUNS   9
#define STATES 20000
#define FRAMES 2000

static const char vanguard[] =
    "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753\n"
    "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667\n";
static const char molniya[] =
    "1 08195U 75081A   06176.33215444  .00000099  00000-0  11873-3 0   813\n"
    "2 08195  64.1586 279.0717 6877146 264.7651  20.2257  2.00491383225656\n";
static const char envisat[] =
    "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n";

static volatile double sink; /* keeps results from being optimised away */

static struct um_orbit_sgp4 *sgp4_create(const struct bench *bench, const char *text, int checksum)
{
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  bench_must(bench, um_orbit_tle_parse(bench->context, text, checksum, &tle));
  bench_must(bench, um_orbit_sgp4_create(bench->context, &tle, &sgp4));
  return sgp4;
}

/* Nanoseconds of a state, every 0.1 min. */
static double sgp4_cost(const struct bench *bench, const struct um_orbit_sgp4 *sgp4)
{
  struct um_vec3 r, v;
  double began = bench_cpu();
  for (int k = 0; k < STATES; k++) {
    bench_must(bench, um_orbit_sgp4_state(bench->context, sgp4, 0.1 * k, &r, &v, NULL));
    sink = r.x;
  }
  return 1e9 * (bench_cpu() - began) / STATES;
}

static double trajectory_cost(const struct bench *bench, const struct um_orbit_trajectory *orbit,
                              double epoch, int n)
{
  struct um_vec3 r, v;
  double began = bench_cpu();
  for (int k = 0; k < n; k++) {
    bench_must(bench, um_orbit_trajectory_state(bench->context, orbit, epoch + 6.0 * k, &r, &v));
    sink = r.x;
  }
  return 1e9 * (bench_cpu() - began) / n;
}

static double frame_cost(const struct bench *bench,
                         const struct um_orbit_earth_orientation *orientation, double epoch)
{
  struct um_mat3 m;
  double began = bench_cpu();
  for (int k = 0; k < FRAMES; k++) {
    bench_must(bench, um_orbit_frames_gcrs_to_itrf(bench->context, orientation, epoch + k, &m));
    sink = m.m[0][0];
  }
  return 1e9 * (bench_cpu() - began) / FRAMES;
}

static double erfa_cost(double epoch)
{
  double m[3][3], tt[2];
  um_orbit_time_tt(epoch, tt);
  double began = bench_cpu();
  for (int k = 0; k < FRAMES; k++) {
    double day = tt[1] + k / 86400.0;
    eraC2t06a(tt[0], day, tt[0], day - 68e-5, 1e-6, 1e-6, m);
    sink = m[0][0];
  }
  return 1e9 * (bench_cpu() - began) / FRAMES;
}

static double sun_cost(double epoch)
{
  double began = bench_cpu();
  for (int k = 0; k < FRAMES; k++) sink = um_orbit_sun_position(NULL, epoch + k).x;
  return 1e9 * (bench_cpu() - began) / FRAMES;
}

/* Largest distance from the printed states [m]. */
static double sgp4_error(const struct bench *bench, const struct um_orbit_sgp4 *sgp4)
{
  static const struct {
    double minutes;
    struct um_vec3 r; /* [m] */
  } printed[] = {{0.0, {7022465.29266, -1400082.96755, 39.95155}},
                 {360.0, {-7154031.20202, -3783176.82504, -3536194.12294}},
                 {4320.0, {-9060473.73569, 4658709.52502, 813686.73153}}};
  double worst = 0.0;
  for (size_t k = 0; k < sizeof printed / sizeof printed[0]; k++) {
    struct um_vec3 r, v;
    bench_must(bench, um_orbit_sgp4_state(bench->context, sgp4, printed[k].minutes, &r, &v, NULL));
    worst = fmax(worst, um_vec3_norm(um_vec3_sub(r, printed[k].r)));
  }
  return worst;
}

/* Distance between two states one revolution apart, of the radius [1]. */
static double kepler_error(const struct bench *bench, const struct um_orbit_trajectory *kepler,
                           double epoch)
{
  struct um_vec3 a, b;
  double period = um_orbit_trajectory_period(kepler);
  bench_must(bench, um_orbit_trajectory_state(bench->context, kepler, epoch + 1000.0, &a, NULL));
  bench_must(bench,
             um_orbit_trajectory_state(bench->context, kepler, epoch + 1000.0 + period, &b, NULL));
  return um_vec3_norm(um_vec3_sub(a, b)) / um_vec3_norm(a);
}

int main(int argc, char **argv)
{
  struct bench bench;
  bench_begin(&bench, argc, argv, "orbit: states and frames, one thread");
  struct um_context *context = bench.context;
  const struct um_orbit_earth_orientation orientation = {-0.267794, 1.1e-6, 1.7e-6, NULL, NULL};
  struct um_orbit_tle tle;
  struct um_orbit_trajectory *kepler = NULL, *orbit = NULL;
  bench_must(&bench, um_orbit_tle_parse(context, envisat, 1, &tle));
  bench_must(&bench, um_orbit_trajectory_create_tle(context, &tle, &orientation, &orbit));
  double epoch = tle.epoch_tai;
  const struct um_orbit_kepler elements = {epoch, 8.6e6, 0.186, 0.6, 6.08, 5.79, 0.337};
  bench_must(&bench, um_orbit_trajectory_create_kepler(context, &elements, &kepler));
  struct um_orbit_sgp4 *near = sgp4_create(&bench, vanguard, 1);
  struct um_orbit_sgp4 *deep = sgp4_create(&bench, molniya, 1);

  struct bench_series two = {.n = 0}, sgp4 = {.n = 0}, sdp4 = {.n = 0}, gcrs = {.n = 0};
  struct bench_series same = {.n = 0}, frame = {.n = 0}, erfa = {.n = 0}, sun = {.n = 0};
  struct um_orbit_sgp4 *bare = sgp4_create(&bench, envisat, 1);
  for (int i = 0; i < RUNS; i++) {
    bench_add(&two, trajectory_cost(&bench, kepler, epoch, STATES));
    bench_add(&sgp4, sgp4_cost(&bench, near));
    bench_add(&sdp4, sgp4_cost(&bench, deep));
    bench_add(&same, sgp4_cost(&bench, bare));
    bench_add(&gcrs, trajectory_cost(&bench, orbit, epoch, FRAMES));
    bench_add(&frame, frame_cost(&bench, &orientation, epoch));
    bench_add(&erfa, erfa_cost(epoch));
    bench_add(&sun, sun_cost(epoch));
  }
  bench_time(&bench, "SGP4 state to Kepler state", "ns", &sgp4, &two, 4.0);
  bench_number(&bench, "SGP4 error, printed states", "m", sgp4_error(&bench, near), 1e-2, 1.0);
  bench_time(&bench, "SDP4 state, 12 h resonance, to Kepler state", "ns", &sdp4, &two, 8.0);
  bench_number(&bench, "Kepler error after a revolution", "1", kepler_error(&bench, kepler, epoch),
               1e-9, 1.0);
  bench_time(&bench, "GCRS to ITRF matrix to eraC2t06a", "ns", &frame, &erfa, 1.1);
  bench_time(&bench, "state of elements in GCRS to eraC2t06a", "ns", &gcrs, &erfa, 1.1);
  bench_time(&bench, "state of elements in GCRS to bare SGP4 state", "ns", &gcrs, &same, NAN);
  bench_time(&bench, "position of the Sun", "ns", &sun, NULL, NAN);
  um_orbit_sgp4_destroy(&near);
  um_orbit_sgp4_destroy(&deep);
  um_orbit_sgp4_destroy(&bare);
  um_orbit_trajectory_destroy(&orbit);
  um_orbit_trajectory_destroy(&kepler);
  return bench_end(&bench);
}
