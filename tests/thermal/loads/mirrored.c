/* The Earth in cells of the body's cube, as mirrors show it, against lines of sight that are drawn
 * here, many through each cell, from the satellite to the ground:
 *
 *   cell = mean of M(place) / pi over its lines, 0 where they pass the Earth
 *
 * and its sum, for an Earth that is the same everywhere, against the solid angle of its disc. */
#include "environment/environment.h"
#include "geometry/cube.h"
#include "geometry/mirror_paths.h"
#include "tests/thermal/loads/region_help.h"
#include "tests/thermal/network_help.h"
#include "thermal/loads/mirrored_impl.h"

#define LINES  24 /* through a cell, an axis */
#define RADIUS 6378137.0

static struct um_environment environment;
static struct um_vec3 middle[UM_GEOMETRY_SKY_CELLS];
static float albedo[UM_GEOMETRY_SKY_CELLS], planet[UM_GEOMETRY_SKY_CELLS];

static int setup(void **state)
{
  for (size_t c = 0; c < UM_GEOMETRY_SKY_CELLS; c++)
    middle[c] = um_geometry_cube_direction(UM_GEOMETRY_SKY_SIDE, c, 0.5, 0.5);
  return help_setup(state);
}

/* 800 km above a place of middle latitude, the body turned by some angle about some axis. */
static struct um_environment_sample somewhere(void)
{
  return (struct um_environment_sample){
      .r = um_vec3_scale(um_vec3_unit(um_vec3(0.6, -0.5, 0.4)), RADIUS + 800e3),
      .sun = um_vec3_unit(um_vec3(0.8, 0.1, 0.5)),
      .sun_distance = UM_AU,
      .pole = {0.0, 0.0, 1.0},
      .greenwich = um_vec3_unit(um_vec3(0.3, 1.0, 0.0)),
      .sunlit_fraction = 1.0,
      .q = um_quat_from_axis(um_vec3_unit(um_vec3(1.0, -2.0, 0.5)), 1.1)};
}

static void uniform(void)
{
  um_environment_defaults(&environment);
  environment.earth_radius = RADIUS;
}

static void shine(const struct um_environment_sample *sample, double weight)
{
  um_irradiation_mirrored_earth(&environment, sample, weight, middle, albedo, planet);
}

static void darken(void)
{
  memset(albedo, 0, sizeof albedo);
  memset(planet, 0, sizeof planet);
}

/* Share of a cell that the disc fills; what comes from it on average [W/m^2/sr]. */
static double look(const struct um_environment_sample *sample, size_t cell, double *reflected,
                   double *emitted)
{
  double distance = um_vec3_norm(sample->r), seen = 0.0;
  double light = environment.albedo * um_environment_solar_irradiance(&environment, UM_AU) / UM_PI;
  *reflected = *emitted = 0.0;
  for (int i = 0; i < LINES * LINES; i++) {
    int row = i / LINES;
    struct um_vec3 body = um_geometry_cube_direction(
        UM_GEOMETRY_SKY_SIDE, cell, (i % LINES + 0.5) / LINES, (row + 0.5) / LINES);
    struct um_vec3 d = um_quat_apply(um_quat_conjugate(sample->q), body);
    double along = um_vec3_dot(sample->r, d);
    double inside = along * along - (distance * distance - RADIUS * RADIUS);
    if (!(along < 0.0 && inside > 0.0)) continue;
    struct um_vec3 place = um_vec3_unit(um_vec3_axpy(sample->r, -along - sqrt(inside), d));
    double w = region_weight(&environment.region, sample->pole, sample->greenwich, place),
           high = um_vec3_dot(place, sample->sun);
    seen += 1.0;
    *reflected += light * (1.0 + w * (environment.region.albedo_factor - 1.0)) * fmax(high, 0.0);
    *emitted += environment.outgoing_longwave / UM_PI *
                (1.0 + w * (environment.region.longwave_factor - 1.0));
  }
  *reflected /= LINES * LINES;
  *emitted /= LINES * LINES;
  return seen / (LINES * LINES);
}

/* Solid angle of a cell [sr]: by its corners, atan(u v / sqrt(1 + u^2 + v^2)) of a face's. */
static double solid_angle(size_t cell)
{
  const size_t side = UM_GEOMETRY_SKY_SIDE;
  double wide = 2.0 / UM_GEOMETRY_SKY_SIDE, sum = 0.0;
  double u = wide * (double)(cell % side) - 1.0, v = wide * (double)(cell / side % side) - 1.0;
  for (int k = 0; k < 4; k++) {
    double a = u + (k & 1 ? wide : 0.0), b = v + (k & 2 ? wide : 0.0);
    sum += (k == 1 || k == 2 ? -1.0 : 1.0) * atan(a * b / sqrt(1.0 + a * a + b * b));
  }
  return sum;
}

/* An Earth that is the same everywhere: nothing where no line meets it, all of it where all do, and
 * at its edge the share to the nine lines that are drawn there. */
static void the_disc_in_cells(void **state)
{
  (void)state;
  struct um_environment_sample sample = somewhere();
  uniform();
  darken();
  shine(&sample, 0.25);
  shine(&sample, 0.75);
  double full = environment.outgoing_longwave / UM_PI, sum = 0.0, sphere = 0.0, worst = 0.0,
         square = 0.0;
  size_t edge = 0;
  for (size_t c = 0; c < UM_GEOMETRY_SKY_CELLS; c++) {
    double reflected, emitted, share = look(&sample, c, &reflected, &emitted);
    double got = (double)planet[c] / full;
    if (share == 0.0 || share == 1.0) NEAR("beside or inside", got, share, 1e-6);
    edge += share > 0.0 && share < 1.0;
    worst = fmax(worst, fabs(got - share));
    square += (got - share) * (got - share);
    sum += got * solid_angle(c);
    sphere += solid_angle(c);
  }
  double sine = RADIUS / um_vec3_norm(sample.r);
  double disc = 2.0 * UM_PI * (1.0 - sqrt(1.0 - sine * sine));
  double rms = sqrt(square / (double)edge);
  print_message("%zu cells at the edge, share to %.3f, rms %.3f; disc %.5f sr, expected %.5f\n",
                edge, worst, rms, sum, disc);
  NEAR("all directions", sphere, 4.0 * UM_PI, 1e-9);
  assert_true(edge > 50);
  assert_true(worst <= 1.0 / 6.0 && rms < 0.1);
  NEAR("disc", sum, disc, 2.0 * rms * 4.0 * UM_PI / UM_GEOMETRY_SKY_CELLS * sqrt((double)edge));
}

/* One that is not, half of it darker and colder: every cell, those at the edge too, has what its
 * lines bring. The nearest of 128 directions stands for a cell, and nine lines for its share. */
static void edge_cells_of_a_varying_earth(void **state)
{
  (void)state;
  struct um_environment_sample sample = somewhere();
  double full[2], square[2][2] = {{0.0, 0.0}, {0.0, 0.0}}, low = 1.0, high = 0.0;
  size_t count[2] = {0, 0}; /* inside, at the edge */
  uniform();
  struct um_environment_region *region = &environment.region;
  region->everywhere = false;
  region->latitude = 10.0 * UM_DEG;
  region->longitude = -70.0 * UM_DEG;
  region->radius = 30.0 * UM_DEG;
  region->edge = 40.0 * UM_DEG;
  region->albedo_factor = 0.5;
  region->longwave_factor = 0.2;
  assert_true(um_environment_earth_varies(&environment));
  darken();
  shine(&sample, 1.0);
  full[0] = environment.albedo * um_environment_solar_irradiance(&environment, UM_AU) / UM_PI;
  full[1] = environment.outgoing_longwave / UM_PI;
  for (size_t c = 0; c < UM_GEOMETRY_SKY_CELLS; c++) {
    double expected[2], share = look(&sample, c, &expected[0], &expected[1]);
    if (share == 0.0) assert_true(planet[c] == 0.0f && albedo[c] == 0.0f);
    if (share == 0.0) continue;
    double got[2] = {(double)albedo[c], (double)planet[c]};
    count[share < 1.0]++;
    for (int b = 0; b < 2; b++)
      square[b][share < 1.0] += pow((got[b] - expected[b]) / full[b], 2.0);
    if (share > 0.9) low = fmin(low, expected[1] / full[1] / share);
    if (share > 0.9) high = fmax(high, expected[1] / full[1] / share);
  }
  for (int b = 0; b < 2; b++) {
    double rms[2];
    for (int k = 0; k < 2; k++) rms[k] = sqrt(square[b][k] / (double)count[k]);
    print_message("%s: %.4f off inside, %.4f at the edge, rms\n", b == 0 ? "light" : "heat", rms[0],
                  rms[1]);
    assert_true(rms[0] < 0.02 && rms[1] < 0.06);
  }
  assert_true(low < 0.6 && high > 0.95);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(the_disc_in_cells),
                                     cmocka_unit_test(edge_cells_of_a_varying_earth)};
  return cmocka_run_group_tests(tests, setup, help_teardown);
}
