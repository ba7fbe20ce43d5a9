/* What places of the Earth reflect and emit: Knocke's model against values computed independently
 * (docs/physics/loads.md), calendar, window temperatures, and the region that differs. */
#include "check.h"

#include "base/core/constants.h"
#include "environment/ground_view.h"
#include "environment/knocke.h"

#define DAY        86400.0
#define EQUINOX_16 (6107.5 * DAY) /* 2016-09-21 0 h, 12692 days from 1981-12-22 */
#define WINTER_81  (-6584.5 * DAY)

static const struct um_environment_globe globe = {
    .t_tai = EQUINOX_16, .pole = {0, 0, 1}, .greenwich = {1, 0, 0}};

static struct um_vec3 place(double latitude, double longitude)
{
  double c = cos(latitude * UM_DEG), l = longitude * UM_DEG;
  return um_vec3(c * cos(l), c * sin(l), sin(latitude * UM_DEG));
}

static struct um_environment knocke(void)
{
  struct um_environment e;
  um_environment_defaults(&e);
  e.earth = UM_EARTH_KNOCKE;
  return e;
}

/* Printed digits. */
static void knocke_values(void **state)
{
  (void)state;
  static const struct {
    double t, latitude, albedo, emissivity;
  } row[] = {
      {EQUINOX_16, 0, 0.195, 0.77},         {EQUINOX_16, 47.067, 0.427628, 0.625654},
      {EQUINOX_16, 60, 0.520598, 0.567956}, {EQUINOX_16, 90, 0.629247, 0.500527},
      {WINTER_81, 45, 0.483211, 0.585503},  {WINTER_81 + 182.625 * DAY, 45, 0.341789, 0.684497}};
  check_near("season", um_environment_knocke_season(EQUINOX_16), -0.0075260, 5e-8);
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double albedo, emissivity, season = um_environment_knocke_season(row[i].t);
    um_environment_knocke(sin(row[i].latitude * UM_DEG), season, &albedo, &emissivity);
    check_near("albedo", albedo, row[i].albedo, 6e-7);
    check_near("emissivity", emissivity, row[i].emissivity, 6e-7);
    struct um_environment e = knocke();
    struct um_environment_globe at = globe;
    at.t_tai = row[i].t;
    struct um_environment_ground_view view = um_environment_ground_view(&e, &at, UM_AU);
    struct um_environment_ground g = um_environment_ground_at(&view, place(row[i].latitude, 77.0));
    check_near("albedo of the ground", g.albedo, row[i].albedo, 6e-7);
    check_near("longwave", g.longwave, row[i].emissivity * 1361.0 / 4.0, 6e-7 * 341.0);
  }
}

/* Means over the area, uniform in the sine of the latitude; both terms of P1 and P2 vanish. */
static void knocke_means(void **state)
{
  (void)state;
  for (int month = 0; month < 12; month++) {
    struct um_environment e = knocke();
    struct um_environment_globe at = globe;
    at.t_tai += 30.0 * DAY * month;
    struct um_environment_ground_view view = um_environment_ground_view(&e, &at, UM_AU);
    double albedo = 0.0, longwave = 0.0;
    for (int i = 0; i < 1000; i++) {
      double s = -1.0 + (2.0 * i + 1.0) / 1000.0;
      struct um_environment_ground g =
          um_environment_ground_at(&view, um_vec3(0.0, sqrt(1.0 - s * s), s));
      albedo += 1e-3 * g.albedo;
      longwave += 1e-3 * g.longwave;
    }
    check_near("mean albedo", albedo, 0.34, 1e-6);
    check_near("mean longwave", longwave, 231.37, 1e-3);
  }
}

/* The relation read forward must give the flux back; 270 K in the window is 224.8233 W/m^2. */
static void window_temperature(void **state)
{
  (void)state;
  for (double longwave = 100.0; longwave <= 320.0; longwave += 20.0) {
    double t = um_environment_window_temperature(longwave);
    double flux = t * (1.228 - 1.106e-3 * t);
    check_near("flux", UM_STEFAN_BOLTZMANN * pow(flux, 4.0), longwave, 1e-9);
  }
  check_near("270 K", um_environment_window_temperature(224.8233), 270.0, 1e-3);
}

/* Dates by python's calendar: middle of a month is a whole number, its ends are halves. */
static void months(void **state)
{
  (void)state;
  static const struct {
    double day, month; /* since 2000-01-01 12 h */
  } row[] = {
      {0.0, 0.5 / 31 - 0.5},            /* 2000-01-01 12 h */
      {15.0, 0.0},                      /* 2000-01-16 12 h */
      {59.0, 1.5 - 0.0},                /* 2000-02-29 12 h, the leap day is the end of February */
      {59.5, 1.5},                      /* 2000-03-01 0 h */
      {6107.5, 8.0 + 20.0 / 30 - 0.5},  /* 2016-09-21 0 h */
      {-6584.5, 11.0 + 21.0 / 31 - 0.5} /* 1981-12-22 0 h */
  };
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    check_near("month", um_environment_month_of(row[i].day * DAY), row[i].month, 1e-12);
  double before = um_environment_month_of(-4000.0 * DAY);
  for (int i = 1; i < 40000; i++) { /* no jump but from December to January, back by 12 */
    double now = um_environment_month_of((-4000.0 + 0.25 * i) * DAY), step = now - before;
    if (step < 0.0) step += 12.0;
    check_below("step of a quarter day", step, 0.5 / 28.0 + 1e-9);
    assert_true(step >= 0.0 && now >= -0.5 && now <= 11.5);
    before = now;
  }
}

static double region_albedo(const struct um_environment *e, double t, double latitude,
                            double longitude)
{
  struct um_environment_globe at = globe;
  at.t_tai = t;
  struct um_environment_ground_view view = um_environment_ground_view(e, &at, UM_AU);
  return um_environment_ground_at(&view, place(latitude, longitude)).albedo;
}

/* Half way at its radius and at its times, all inside, nothing outside; factor, then offset. */
static void region(void **state)
{
  (void)state;
  struct um_environment e;
  um_environment_defaults(&e);
  assert_false(um_environment_earth_varies(&e));
  e.region = (struct um_environment_region){.latitude = 20 * UM_DEG,
                                            .longitude = -60 * UM_DEG,
                                            .radius = 10 * UM_DEG,
                                            .edge = 4 * UM_DEG,
                                            .from_tai = 1000.0,
                                            .to_tai = 2000.0,
                                            .ramp = 100.0,
                                            .albedo_factor = 1.5,
                                            .albedo_offset = 0.05,
                                            .longwave_factor = 1.0};
  assert_true(um_environment_earth_varies(&e));
  check_near("centre", region_albedo(&e, 1500.0, 20, -60), 0.50, 1e-12);
  check_near("inside", region_albedo(&e, 1500.0, 27.9, -60), 0.50, 1e-12);
  check_near("at its radius", region_albedo(&e, 1500.0, 30, -60), 0.40, 1e-12);
  check_near("a quarter of the edge out", region_albedo(&e, 1500.0, 31, -60),
             0.30 + 0.20 * 0.5 * (1.0 - sqrt(0.5)), 1e-12);
  check_near("outside", region_albedo(&e, 1500.0, 32.1, -60), 0.30, 1e-15);
  check_near("on the other side", region_albedo(&e, 1500.0, -20, 120), 0.30, 1e-15);
  check_near("before", region_albedo(&e, 949.0, 20, -60), 0.30, 1e-15);
  check_near("at its beginning", region_albedo(&e, 1000.0, 20, -60), 0.40, 1e-12);
  check_near("at its end", region_albedo(&e, 2000.0, 20, -60), 0.40, 1e-12);
  check_near("after", region_albedo(&e, 2051.0, 20, -60), 0.30, 1e-15);
  e.region.ramp = e.region.edge = 0.0; /* at once */
  check_near("begins", region_albedo(&e, 1000.0, 29.999, -60), 0.50, 1e-12);
  check_near("not yet", region_albedo(&e, 999.999, 20, -60), 0.30, 1e-15);
  check_near("not here", region_albedo(&e, 1500.0, 30.001, -60), 0.30, 1e-15);
  e.region.everywhere = true;
  check_near("everywhere", region_albedo(&e, 1500.0, -80, 10), 0.50, 1e-12);
  e.region.albedo_factor = 9.0; /* no place reflects more than it gets */
  check_near("most", region_albedo(&e, 1500.0, -80, 10), 1.0, 0.0);
}

/* Factors and shift act on an Earth that is not uniform. */
static void levels(void **state)
{
  (void)state;
  struct um_environment e = knocke(), f = knocke();
  f.albedo_factor = 1.2;
  f.longwave_factor = 0.9;
  f.brightness_shift = 7.0;
  struct um_environment_ground_view u = um_environment_ground_view(&e, &globe, UM_AU);
  struct um_environment_ground_view v = um_environment_ground_view(&f, &globe, UM_AU);
  struct um_environment_ground a = um_environment_ground_at(&u, place(30, 0));
  struct um_environment_ground b = um_environment_ground_at(&v, place(30, 0));
  check_near("albedo", b.albedo, 1.2 * a.albedo, 1e-15);
  check_near("longwave", b.longwave, 0.9 * a.longwave, 1e-12);
  check_near("brightness", b.brightness, a.brightness + 7.0, 1e-12);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(knocke_values),
      cmocka_unit_test(knocke_means),
      cmocka_unit_test(window_temperature),
      cmocka_unit_test(months),
      cmocka_unit_test(region),
      cmocka_unit_test(levels),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
