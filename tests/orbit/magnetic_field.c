/* The main field against figures of IGRF-14, and what a magnet on board makes of it.
 *
 * Figures: ppigrf 2.1 (K. M. Laundal, a Python package with the coefficients of doi
 * 10.5281/zenodo.14012302), geocentric, turned to Earth-fixed axes; with degrees 1 to 4 and with
 * all 13; and tests/reference/igrf14.csv. The dipole: B = (a/r)^3 (3 (g.e) e - g), g = (g11, h11,
 * g10), e the direction. */
#include "orbit_test.h"

#include "orbit/attitude.h"
#include "orbit/frames.h"
#include "orbit/geodesy.h"
#include "orbit/magnetic_field.h"
#include "tests/support/reference.h"

#define ALL UM_MAGNETIC_DEGREE

/* [nT] */
static struct um_vec3 field(double t, struct um_vec3 r, int degree)
{
  return um_vec3_scale(um_orbit_magnetic_field(t, r, degree), 1e9);
}

static struct um_vec3 about_z(struct um_vec3 r, double angle)
{
  return um_vec3(cos(angle) * r.x - sin(angle) * r.y, sin(angle) * r.x + cos(angle) * r.y, r.z);
}

static struct um_vec3 place(double km, double colatitude, double longitude)
{
  double t = colatitude * UM_DEG, l = longitude * UM_DEG;
  return um_vec3_scale(um_vec3(sin(t) * cos(l), sin(t) * sin(l), cos(t)), km * 1e3);
}

/* 1 nT: the figures count days of each year by themselves, at up to 150 nT a year. */
static void published_values(void **state)
{
  (void)state;
  static const struct {
    double t, km, colatitude, longitude, degree4[3], all[3];
  } row[] = {
      {507816000.0,
       6971.2,
       1,
       10,
       {-1449.656, -666.663, -43944.279},
       {-2206.720, -579.275, -43980.303}},
      {507816000.0,
       6971.2,
       47.3,
       15.5,
       {-34282.029, -8296.616, -6114.400},
       {-33745.591, -8570.068, -7052.983}},
      {507816000.0,
       6971.2,
       90,
       -70,
       {-5040.550, 5378.938, 20164.772},
       {-5221.576, 5670.242, 20179.484}},
      {-43200.0,
       6971.2,
       90,
       100,
       {-1049.854, 10384.896, 29620.231},
       {-1302.820, 10354.999, 29623.543}},
      {709905600.0,
       7171,
       135,
       -45,
       {11880.764, -14278.322, -2841.009},
       {11974.496, -14598.529, -2794.012}},
      {-526132800.0,
       6771,
       170,
       140,
       {1240.706, 1645.347, -51355.339},
       {401.442, 1649.691, -51371.518}},
      {852033600.0,
       6971.2,
       60,
       -150,
       {28337.009, 12006.040, 5641.500},
       {27241.382, 11575.519, 5269.839}},
  };
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct um_vec3 r = place(row[i].km, row[i].colatitude, row[i].longitude);
    const double *low = row[i].degree4, *all = row[i].all;
    assert_vec_near(field(row[i].t, r, 4), um_vec3(low[0], low[1], low[2]), 1.0);
    assert_vec_near(field(row[i].t, r, ALL), um_vec3(all[0], all[1], all[2]), 1.0);
  }
}

/* 48 places in low orbits, 1990 to 2030: 0.005 deg in direction and 0.02 % in strength, what days
 * of a year counted otherwise are worth; 0.1 deg and 0.1 % are promised. */
static void everywhere_in_low_orbits(void **state)
{
  struct um_context *context = *state;
  struct um_core_csv *csv = reference_open(context, "igrf14");
  size_t rows = um_core_csv_rows(csv);
  assert_true(rows >= 48);
  for (size_t i = 0; i < rows; i++) {
    double latitude = reference_number(context, csv, i, "latitude_deg") * UM_DEG;
    double longitude = reference_number(context, csv, i, "longitude_deg") * UM_DEG;
    double height = reference_number(context, csv, i, "height_km") * 1e3;
    struct um_vec3 expected = {reference_number(context, csv, i, "x_nT"),
                               reference_number(context, csv, i, "y_nT"),
                               reference_number(context, csv, i, "z_nT")};
    struct um_vec3 r = um_orbit_geodesy_forward(latitude, longitude, height);
    struct um_vec3 b = field(utc(context, reference_text(context, csv, i, "utc")), r, ALL);
    assert_close(um_vec3_angle(b, expected), 0.0, 0.005 * UM_DEG);
    assert_close(um_vec3_norm(b) / um_vec3_norm(expected), 1.0, 2e-4);
  }
  um_core_csv_destroy(&csv);
}

/* The example of igrfmagm (MathWorks, Aerospace Toolbox): 1000 m over Natick, 2015-07-04, north,
 * east and down 19471, -5086 and 48177 nT. By IGRF-13, whose 2020.0 was a prediction: 5 nT. */
static void over_natick(void **state)
{
  double latitude = 42.283 * UM_DEG, longitude = -71.35 * UM_DEG;
  struct um_vec3 r = um_orbit_geodesy_forward(latitude, longitude, 1000.0);
  struct um_vec3 b = field(utc(*state, "2015-07-04T00:00:00Z"), r, ALL);
  struct um_vec3 enu = um_orbit_geodesy_enu(latitude, longitude, 1000.0, um_vec3_add(r, b));
  assert_vec_near(enu, um_vec3(-5086, 19471, -48177), 5.0);
}

/* The line of the field turns slower than is stated, by how the loads' grid is laid: circular
 * orbits of every inclination and node, seen from the stars. */
static void line_turns_within_its_bound(void **state)
{
  struct um_context *context = *state;
  const struct um_orbit_attitude_law law = {
      .kind = UM_ATTITUDE_MAGNETIC, .axis_body = {0, 0, 1}, .clock_body = {1, 0, 0}};
  struct um_orbit_attitude *attitude = NULL;
  assert_ok(context, um_orbit_attitude_create(context, &law, 1, &attitude));
  double bound = um_orbit_attitude_rate(attitude, 1.0), fastest = 0.0;
  const double step = UM_DEG, earth = 7.292115e-5;
  for (int h = 0; h < 2; h++)
    for (int i = 0; i <= 180; i += 15)
      for (int node = 0; node < 360; node += 30) {
        double a = 6371.2e3 + (h == 0 ? 400e3 : 1000e3), n = sqrt(3.986004418e14 / (a * a * a));
        struct um_vec3 before = {0, 0, 0};
        for (int k = 0; k <= 360; k++) {
          double u = k * step, t = 5e8 + u / n, turn = node * UM_DEG - earth * u / n;
          struct um_vec3 r = {cos(u), sin(u) * cos(i * UM_DEG), sin(u) * sin(i * UM_DEG)};
          struct um_vec3 b = field(t, um_vec3_scale(about_z(r, turn), a), ALL);
          b = um_vec3_unit(about_z(b, -turn));
          if (k > 0) fastest = fmax(fastest, um_vec3_angle(before, b) / step);
          before = b;
        }
      }
  assert_true(fastest < bound);
  um_orbit_attitude_destroy(&attitude);
}

/* 2020.0 is an epoch: the coefficients themselves, g10 -29403.41, g11 -1451.37, h11 4653.35 nT. At
 * a pole the recursions have no singularity. */
static void centred_dipole(void **state)
{
  (void)state;
  const struct um_vec3 g = {-1451.37e-9, 4653.35e-9, -29403.41e-9};
  for (int i = 0; i <= 40; i++) {
    struct um_vec3 r = place(6500.0 + 40.0 * i, 4.5 * i, 97.0 * i), e = um_vec3_unit(r);
    double k = pow(6371.2e3 / um_vec3_norm(r), 3.0);
    struct um_vec3 expected =
        um_vec3_scale(um_vec3_axpy(um_vec3_scale(e, 3.0 * um_vec3_dot(g, e)), -1.0, g), k);
    struct um_vec3 b = um_orbit_magnetic_field(20.0 * 365.25 * 86400.0 - 43200.0, r, 1);
    assert_close(um_vec3_norm(um_vec3_sub(b, expected)), 0.0, 1e-15);
  }
}

/* Beyond 1960 and 2030 the field stays what it was there. */
static void beyond_the_epochs(void **state)
{
  (void)state;
  struct um_vec3 r = place(7000.0, 50.0, 20.0);
  struct um_vec3 a = um_orbit_magnetic_field(30.0 * 365.25 * 86400.0, r, ALL);
  struct um_vec3 b = um_orbit_magnetic_field(60.0 * 365.25 * 86400.0, r, ALL);
  assert_close(um_vec3_norm(um_vec3_sub(a, b)), 0.0, 0.0);
}

static const double PERIOD = 5800.0;

/* A circular orbit over the poles, 600 km up. */
static struct um_orbit_attitude_input polar(double t)
{
  double u = 2.0 * UM_PI * t / PERIOD, n = 2.0 * UM_PI / PERIOD, a = 6978e3;
  struct um_vec3 out = {cos(u), 0.0, sin(u)}, ahead = {-sin(u), 0.0, cos(u)};
  return (struct um_orbit_attitude_input){.t_tai = t,
                                          .r = um_vec3_scale(out, a),
                                          .v = um_vec3_scale(ahead, a * n),
                                          .sun = {1.0, 0.0, 0.0}};
}

static struct um_orbit_attitude *magnet(struct um_context *context, double period)
{
  struct um_orbit_attitude *attitude = NULL;
  const struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_MAGNETIC,
                                            .axis_body = {0, 0, 2},
                                            .clock_body = {1, 0, 0},
                                            .period = period,
                                            .phase = 0.3};
  assert_ok(context, um_orbit_attitude_create(context, &law, 1, &attitude));
  return attitude;
}

static struct um_quat at(struct um_context *context, const struct um_orbit_attitude *attitude,
                         double t)
{
  struct um_orbit_attitude_input input = polar(t);
  struct um_quat q;
  assert_ok(context, um_orbit_attitude_at(context, attitude, &input, &q));
  return q;
}

/* The body's axis is along the field, which over the equator points north within the 15 deg or so
 * by which it is not axial, and down over the north pole. Followed round the orbit in its plane it
 * turns twice. */
static void magnet_follows_the_field(void **state)
{
  (void)state;
  struct um_context *context = NULL;
  assert_ok(NULL, um_core_context_create(NULL, &context));
  struct um_orbit_attitude *attitude = magnet(context, 0.0);
  const struct um_orbit_earth_orientation none = {0};
  double turned = 0.0, before = NAN, fastest = 0.0;
  for (int i = 0; i <= 580; i++) {
    struct um_orbit_attitude_input input = polar(10.0 * i);
    struct um_quat q = at(context, attitude, 10.0 * i);
    struct um_vec3 axis = um_quat_apply(um_quat_conjugate(q), um_vec3(0, 0, 1));
    struct um_mat3 m;
    assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &none, 10.0 * i, &m));
    struct um_vec3 b = um_orbit_magnetic_field(10.0 * i, um_mat3_apply(m, input.r), ALL);
    b = um_mat3_apply(um_mat3_transpose(m), b);
    assert_close(um_vec3_angle(axis, b), 0.0, 1e-7);
    double angle = atan2(axis.z, axis.x);
    if (i > 0) {
      double step = remainder(angle - before, 2.0 * UM_PI);
      turned += step;
      fastest = fmax(fastest, fabs(step) / 10.0);
    }
    before = angle;
    if (i == 0) assert_true(axis.z > cos(20.0 * UM_DEG));
    if (i == 145) assert_true(axis.z < -cos(15.0 * UM_DEG));
    /* the clock: x of the body as near the orbit normal, -y, as the axis lets it, then 0.3 rad on
     */
    struct um_vec3 x = um_quat_apply(um_quat_conjugate(q), um_vec3(cos(0.3), -sin(0.3), 0));
    struct um_vec3 normal = um_vec3(0, -1, 0);
    normal = um_vec3_unit(um_vec3_axpy(normal, -um_vec3_dot(normal, axis), axis));
    assert_close(um_vec3_angle(x, normal), 0.0, 1e-7);
  }
  assert_close(turned / (2.0 * UM_PI), 2.0, 0.1); /* the Earth turns by a fifteenth meanwhile */
  double rate = um_orbit_attitude_rate(attitude, 2.0 * UM_PI / PERIOD);
  assert_true(fastest < rate && rate < 3.0 * fastest);
  um_orbit_attitude_destroy(&attitude);
  um_core_context_destroy(&context);
}

/* With a period the body turns about the axis from where it would stand without: right-handed. */
static void magnet_spins(void **state)
{
  (void)state;
  struct um_context *context = NULL;
  assert_ok(NULL, um_core_context_create(NULL, &context));
  struct um_orbit_attitude *still = magnet(context, 0.0), *spins = magnet(context, 200.0);
  for (int i = 0; i < 50; i++) {
    double t = 37.0 * i;
    struct um_quat a = at(context, still, t), b = at(context, spins, t);
    struct um_vec3 x = um_quat_apply(um_quat_conjugate(a), um_vec3(1, 0, 0));
    double turn = 2.0 * UM_PI * t / 200.0;
    struct um_vec3 now = um_quat_apply(b, x); /* where the body without spin has its x axis */
    assert_close(now.x, cos(turn), 1e-9);
    assert_close(now.y, -sin(turn), 1e-9);
    assert_close(now.z, 0.0, 1e-9);
  }
  um_orbit_attitude_destroy(&still);
  um_orbit_attitude_destroy(&spins);
  um_core_context_destroy(&context);
}

static void refused(void **state)
{
  (void)state;
  struct um_context *context = NULL;
  struct um_orbit_attitude *attitude = NULL;
  assert_ok(NULL, um_core_context_create(NULL, &context));
  struct um_orbit_attitude_law law = {
      .kind = UM_ATTITUDE_MAGNETIC, .axis_body = {0, 0, 1}, .clock_body = {0, 0, 3}};
  assert_int_equal(um_orbit_attitude_create(context, &law, 1, &attitude), UM_ERR_INPUT);
  law.clock_body = um_vec3(1, 0, 0);
  law.period = NAN;
  assert_int_equal(um_orbit_attitude_create(context, &law, 1, &attitude), UM_ERR_INPUT);
  law.period = 0.0;
  law.axis_body = um_vec3(0, 0, 0);
  assert_int_equal(um_orbit_attitude_create(context, &law, 1, &attitude), UM_ERR_INPUT);
  assert_null(attitude);
  um_core_context_destroy(&context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(published_values),
      cmocka_unit_test_setup_teardown(everywhere_in_low_orbits, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(over_natick, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(line_turns_within_its_bound, context_setup, context_teardown),
      cmocka_unit_test(centred_dipole),
      cmocka_unit_test(beyond_the_epochs),
      cmocka_unit_test(magnet_follows_the_field),
      cmocka_unit_test(magnet_spins),
      cmocka_unit_test(refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
