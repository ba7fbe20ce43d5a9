/* Sun and Moon against a table computed with an independent program (astropy 6 with its built-in
 * ephemeris, which rests on the same theories: epv00 and moon98).
 *
 * Tolerances: Sun 2e-5 rad (below it nothing in this program notices; 4", a fiftieth of the
 * sixtieth of its diameter); Moon 10". Printed digits of the table are finer and are held more
 * tightly. */
#include "orbit_test.h"

#include "orbit/sun.h"

static const struct {
  const char *utc;
  double sun[3];      /* geometric, GCRS [km] */
  double au;          /* distance */
  double apparent[3]; /* unit, geocentric */
  double moon[3];     /* GCRS [km] */
} table[] = {
    {"2000-01-01T12:00:00Z",
     {26500942.0, -132757095.5, -57556577.3},
     0.983327667,
     {0.180052009, -0.902489394, -0.391272499},
     {-291564.159, -266757.981, -76118.376}},
    {"2006-04-02T00:00:00Z",
     {146233224.8, 28597693.0, 12398187.2},
     0.999467591,
     {0.978050165, 0.191176387, 0.082882229},
     {187606.032, 286887.996, 155684.221}},
    {"2016-09-21T20:33:00Z",
     {-150133961.9, 2288788.1, 992563.5},
     1.003722092,
     {-0.999860321, 0.015333643, 0.006649626},
     {133884.176, 326694.230, 104874.670}},
    {"2019-07-23T21:00:00Z",
     {-77042934.5, 120198770.8, 52105734.2},
     1.015933346,
     {-0.506838945, 0.790923295, 0.342862399},
     {381462.992, 122866.980, 13116.193}},
};

static struct um_vec3 vector(const double p[3], double unit)
{
  return um_vec3(unit * p[0], unit * p[1], unit * p[2]);
}

static void sun(void **state)
{
  struct um_context *context = *state;
  double worst = 0.0, worst_apparent = 0.0;
  for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
    double t = utc(context, table[k].utc), distance;
    struct um_vec3 r = um_orbit_sun_position(NULL, t), direction;
    worst = fmax(worst, um_vec3_angle(r, vector(table[k].sun, 1.0)));
    /* 0.1 km are printed; TDB taken as TT moves the Earth by 60 m */
    assert_vec_near(r, vector(table[k].sun, 1e3), 300.0);
    assert_close(um_vec3_norm(r) / UM_AU, table[k].au, 2e-9);
    um_orbit_sun_apparent(NULL, t, um_vec3(0, 0, 0), um_vec3(0, 0, 0), &direction, &distance);
    worst_apparent = fmax(worst_apparent, um_vec3_angle(direction, vector(table[k].apparent, 1.0)));
    assert_close(um_vec3_norm(direction), 1.0, 1e-15);
    /* distance along the light's path: the Earth moves radially by up to 0.5 km/s x 500 s */
    assert_close(distance / UM_AU, table[k].au, 2e-6);
  }
  print_message("Sun: geometric %.2g rad, apparent %.2g rad from the table\n", worst,
                worst_apparent);
  assert_true(worst <= 2e-5 && worst_apparent <= 2e-5);
}

/* Annual aberration of the Sun is 20.5" (20.4955" / (1 - e^2)^1/2 (1 + e cos nu)), against the
 * Earth's motion; a satellite's 7.5 km/s across the line of sight adds v / c = 5.16". */
static void aberration(void **state)
{
  struct um_context *context = *state;
  double t = utc(context, "2016-09-21T20:33:00Z"), distance;
  struct um_vec3 geometric = um_vec3_unit(um_orbit_sun_position(NULL, t)), apparent, moving;
  struct um_vec3 still = um_vec3(0, 0, 0);
  um_orbit_sun_apparent(NULL, t, still, still, &apparent, &distance);
  assert_close(um_vec3_angle(geometric, apparent) / UM_ARCSEC, 20.5, 0.4);
  struct um_vec3 across = um_vec3_unit(um_vec3_cross(apparent, um_vec3(0, 0, 1)));
  um_orbit_sun_apparent(NULL, t, still, um_vec3_scale(across, 7500.0), &moving, &distance);
  assert_close(um_vec3_angle(moving, apparent), 7500.0 / UM_LIGHT_SPEED, 1e-8);
  assert_true(um_vec3_dot(moving, across) >
              um_vec3_dot(apparent, across)); /* ahead of the motion */
}

/* Parallax: from 7000 km beside the line to the Sun the direction turns by 7000 km / r. */
static void parallax(void **state)
{
  struct um_context *context = *state;
  double t = utc(context, "2006-04-02T00:00:00Z"), distance, beside_distance;
  struct um_vec3 centre, beside, still = um_vec3(0, 0, 0);
  um_orbit_sun_apparent(NULL, t, still, still, &centre, &distance);
  struct um_vec3 across = um_vec3_unit(um_vec3_cross(centre, um_vec3(0, 0, 1)));
  um_orbit_sun_apparent(NULL, t, um_vec3_scale(across, 7e6), still, &beside, &beside_distance);
  assert_close(um_vec3_angle(centre, beside), 7e6 / distance, 1e-8);
  um_orbit_sun_apparent(NULL, t, um_vec3_scale(centre, 7e6), still, &beside, &beside_distance);
  /* along the apparent direction, 20" off the true one: cos differs by 5e-9 */
  assert_close(distance - beside_distance, 7e6, 1.0);
}

static void moon(void **state)
{
  struct um_context *context = *state;
  double worst = 0.0;
  for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
    struct um_vec3 r = um_orbit_moon_position(utc(context, table[k].utc));
    worst = fmax(worst, um_vec3_angle(r, vector(table[k].moon, 1.0)) / UM_ARCSEC);
    assert_close(um_vec3_norm(r) / um_vec3_norm(vector(table[k].moon, 1e3)), 1.0, 1e-5);
  }
  print_message("Moon: %.2g\" from the table\n", worst);
  assert_true(worst <= 10.0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(sun, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(aberration, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(parallax, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(moon, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
