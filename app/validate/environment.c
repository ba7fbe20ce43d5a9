/* Cases of the environment: sunlight, the Earth's shadow, eclipses of circular orbits, what plates
 * receive of the Earth.
 *
 * Sources: Montenbruck & Gill 2000, 3.4.2 (overlap of plane discs); rays over the disc; Howell's
 * catalogue and Juul 1979 (plate and Earth), checked by 1.3 million points to 2e-6; 72 million
 * areas of the visible cap, good to 2e-8 (albedo); ASTM E490; Planck's law. */
#include "app/validate/validate.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/environment.h"

#define PLANE_DISCS "Montenbruck & Gill 3.4.2"
#define RAYS        "rays over the disc"
#define CLOSED      "closed form"

static const struct um_vec3 north = {0.0, 0.0, 1.0};

static struct um_environment with(enum um_environment_shadow shadow, enum um_environment_disc disc)
{
  struct um_environment e;
  um_environment_defaults(&e);
  e.shadow = shadow;
  e.disc = disc;
  return e;
}

/* Seasonal factor: distances are given to 1e-5 au, that is 0.015 W/m^2. Bands: printed digits. */
static void sunlight(struct um_validate_report *report)
{
  struct um_environment e = with(UM_SHADOW_NONE, UM_DISC_UNIFORM), sun = e, own = e;
  um_validate_report_add(report, "Solar irradiance at perihelion", "W/m^2", 1407.65,
                         um_environment_solar_irradiance(&e, 0.98329 * UM_AU), 0.02, CLOSED);
  um_validate_report_add(report, "Solar irradiance at aphelion", "W/m^2", 1316.63,
                         um_environment_solar_irradiance(&e, 1.01671 * UM_AU), 0.02, CLOSED);
  um_validate_report_add(report, "Solar irradiance on 2016-09-21", "W/m^2", 1350.92,
                         um_environment_solar_irradiance(&e, 1.0037221 * UM_AU), 0.005, CLOSED);
  sun.spectrum = UM_SPECTRUM_BLACK_BODY;
  um_validate_report_add(report, "Sun as a black body, 0.38-0.78 um", "W/m^2", 632.82,
                         um_environment_solar_band(&sun, 0.38e-6, 0.78e-6), 0.005,
                         "Planck, 5772 K");
  um_validate_report_add(report, "Sun as a black body, 0.45-1.15 um", "W/m^2", 820.87,
                         um_environment_solar_band(&sun, 0.45e-6, 1.15e-6), 0.005,
                         "Planck, 5772 K");
  um_validate_report_add(report, "Sun as a black body, 8-12 um", "W/m^2", 1.298,
                         um_environment_solar_band(&sun, 8e-6, 12e-6), 5e-4, "Planck, 5772 K");
  um_validate_report_add(report, "Sun as a black body, share below 2.5 um", "1", 0.965644,
                         um_environment_solar_band(&sun, 0.0, 2.5e-6) / 1361.0, 5e-7,
                         "Planck, 5772 K");
  /* trapezoids of the standard's own points; it is re-gridded here, edges of bands are kept */
  own.solar_irradiance = 1366.0908;
  um_validate_report_add(report, "E490, 0.38-0.78 um", "W/m^2", 654.9465,
                         um_environment_solar_band(&own, 0.38e-6, 0.78e-6), 2e-3, "ASTM E490");
  um_validate_report_add(report, "E490, 0.45-1.15 um", "W/m^2", 849.5357,
                         um_environment_solar_band(&own, 0.45e-6, 1.15e-6), 0.02, "ASTM E490");
  um_validate_report_add(report, "E490, 8-12 um", "W/m^2", 1.095933,
                         um_environment_solar_band(&own, 8e-6, 12e-6), 1e-5, "ASTM E490");
  um_validate_report_add(report, "E490 scaled to 1361 W/m^2, 0.38-0.78 um", "W/m^2", 652.5058,
                         um_environment_solar_band(&e, 0.38e-6, 0.78e-6), 2e-3, "ASTM E490");
}

/* Discs of angular radius a (Sun) and b (Earth) whose centres are c apart [deg]. */
static double overlap(double a, double b, double c)
{
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  e.shadow_radius = 7e6 * sin(b * UM_DEG);
  return um_environment_sunlit_fraction(&e, um_vec3(-7e6, 0.0, 0.0),
                                        um_vec3(cos(c * UM_DEG), sin(c * UM_DEG), 0.0),
                                        UM_SOLAR_RADIUS / sin(a * UM_DEG), north);
}

/* Satellite at 7136 km, theta [deg] from the anti-solar direction toward `side`; Sun 1 au from the
 * geocentre along +x. Returns the sunlit fraction; *limb (or NULL) the limb angle [rad]. */
static double behind(enum um_environment_shadow shadow, enum um_environment_disc disc, double theta,
                     struct um_vec3 side, double *limb)
{
  struct um_environment e = with(shadow, disc);
  double a = theta * UM_DEG, radius = 7136e3;
  struct um_vec3 r = um_vec3_axpy(um_vec3(-radius * cos(a), 0.0, 0.0), radius * sin(a), side);
  struct um_vec3 sun = um_vec3_sub(um_vec3(UM_AU, 0.0, 0.0), r);
  double distance = um_vec3_norm(sun);
  sun = um_vec3_scale(sun, 1.0 / distance);
  if (limb != NULL) *limb = um_environment_limb_angle(&e, r, sun, distance, north);
  return um_environment_sunlit_fraction(&e, r, sun, distance, north);
}

/* Where the centre of an infinitely far Sun stands on the limb [deg from the anti-solar direction]:
 * the limb angle is solved for, since the limb depends on where the satellite is. */
static double limb_at(struct um_vec3 side)
{
  struct um_environment e = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  double theta = 63.2 * UM_DEG;
  for (int k = 0; k < 40; k++) {
    struct um_vec3 r =
        um_vec3_axpy(um_vec3(-7136e3 * cos(theta), 0.0, 0.0), 7136e3 * sin(theta), side);
    theta -= um_environment_limb_angle(&e, r, um_vec3(1, 0, 0), UM_AU, north);
  }
  return theta / UM_DEG;
}

/* From first to full light behind a limb 3200.3 km away [km], by bisection to 1 m. */
static double penumbra_width(void)
{
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  double edge[2];
  for (int full = 0; full < 2; full++) {
    double low = -40e3, high = 40e3; /* [m] above the shadow of the limb */
    while (high - low > 1.0) {
      double x = 0.5 * (low + high);
      double f = um_environment_sunlit_fraction(&e, um_vec3(-3200.3e3, UM_EARTH_RADIUS + x, 0.0),
                                                um_vec3(1, 0, 0), UM_AU, north);
      if (full ? f < 1.0 : f == 0.0)
        low = x;
      else
        high = x;
    }
    edge[full] = low;
  }
  return 1e-3 * (edge[1] - edge[0]);
}

/* 5e-4: plane discs are within 2.3e-4 of the true contour. Rays: 1e-4 (printed, and sampled). */
static void shadow(struct um_validate_report *report)
{
  const struct um_vec3 equator = {0.0, 1.0, 0.0};
  static const struct {
    const char *name;
    double a, b, c, fraction; /* [deg], [1] */
  } disc[] = {{"Sunlit fraction, discs a = b = c = 1 deg", 1.0, 1.0, 1.0, 0.6089978},
              {"Sunlit fraction, Sun 63.9 deg from 64 deg Earth", 0.2666, 64.0, 63.9, 0.267284},
              {"Sunlit fraction, Sun 64.0 deg from 64 deg Earth", 0.2666, 64.0, 64.0, 0.500442},
              {"Sunlit fraction, Sun 64.1 deg from 64 deg Earth", 0.2666, 64.0, 64.1, 0.733420}};
  for (size_t i = 0; i < sizeof disc / sizeof disc[0]; i++)
    um_validate_report_add(report, disc[i].name, "1", disc[i].fraction,
                           overlap(disc[i].a, disc[i].b, disc[i].c), 5e-4, PLANE_DISCS);
  static const struct {
    const char *name;
    enum um_environment_shadow shadow;
    enum um_environment_disc disc;
    double theta, fraction, tolerance;
    int polar;
  } row[] = {
      {"7136 km, sphere, 63.0 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 63.0, 0.0, 0.0, 0},
      {"7136 km, sphere, 63.2 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 63.2, 0.14853, 5e-4, 0},
      {"7136 km, sphere, 63.362 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 63.362, 0.51288, 5e-4, 0},
      {"7136 km, sphere, 63.4 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 63.4, 0.60320, 5e-4, 0},
      {"7136 km, sphere, 63.5 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 63.5, 0.82515, 5e-4, 0},
      {"7136 km, sphere, 63.6 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 63.6, 0.98477, 5e-4, 0},
      {"7136 km, sphere, 64.0 deg", UM_SHADOW_SPHERE, UM_DISC_UNIFORM, 64.0, 1.0, 0.0, 0},
      {"7136 km, oblate, equator, 63.2 deg", UM_SHADOW_OBLATE, UM_DISC_UNIFORM, 63.2, 0.1484, 1e-4,
       0},
      {"7136 km, oblate, pole, 63.2 deg", UM_SHADOW_OBLATE, UM_DISC_UNIFORM, 63.2, 0.9622, 1e-4, 1},
      {"7136 km, oblate, pole, 63.0 deg", UM_SHADOW_OBLATE, UM_DISC_UNIFORM, 63.0, 0.55646, 1e-4,
       1},
      {"7136 km, oblate, pole, 63.0 deg, darkened limb", UM_SHADOW_OBLATE, UM_DISC_LIMB_DARKENED,
       63.0, 0.56140, 1e-4, 1}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    um_validate_report_add(
        report, row[i].name, "1", row[i].fraction,
        behind(row[i].shadow, row[i].disc, row[i].theta, row[i].polar ? north : equator, NULL),
        row[i].tolerance, row[i].shadow == UM_SHADOW_SPHERE ? PLANE_DISCS : RAYS);
  /* printed digits */
  um_validate_report_add(report, "Limb of the oblate Earth, equator", "deg", 63.35435,
                         limb_at(equator), 1e-5, RAYS);
  um_validate_report_add(report, "Limb of the oblate Earth, pole", "deg", 62.97401, limb_at(north),
                         1e-5, RAYS);
  um_validate_report_add(report, "Penumbra 3200.3 km behind the limb, width", "km", 29.77,
                         penumbra_width(), 0.01, CLOSED);
}

struct circle {
  double radius, beta, rate; /* [m], [rad], [rad/s] */
};

static enum um_status circle_at(void *self, double t, struct um_vec3 *r, struct um_vec3 *sun,
                                double *distance, struct um_vec3 *pole)
{
  const struct circle *c = self;
  double phi = c->rate * t;
  *r = um_vec3(-c->radius * cos(phi), c->radius * sin(phi), 0.0);
  *sun = um_vec3(cos(c->beta), 0.0, sin(c->beta));
  *distance = UM_AU;
  *pole = north;
  return UM_OK;
}

/* f_E = acos(sqrt(h^2 + 2 R h) / ((R + h) cos(beta))) / pi; printed digits. */
static enum um_status eclipses(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double altitude, beta, fraction; /* [m], [deg], [1] */
  } row[] = {{"Eclipse fraction, 765 km, beta 0", 765e3, 0.0, 0.351336},
             {"Eclipse fraction, 765 km, beta 42.956 deg", 765e3, 42.956, 0.289078},
             {"Eclipse fraction, 600 km, beta 0", 600e3, 0.0, 0.367036},
             {"Eclipse fraction, 600 km, beta 60 deg", 600e3, 60.0, 0.198733},
             {"Eclipse fraction, 400 km, beta 0", 400e3, 0.0, 0.390100}};
  struct um_environment e = with(UM_SHADOW_CYLINDER, UM_DISC_UNIFORM);
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct circle c = {UM_EARTH_RADIUS + row[i].altitude, row[i].beta * UM_DEG, 0.0};
    c.rate = sqrt(UM_EARTH_GM / pow(c.radius, 3.0));
    struct um_environment_event *event = NULL;
    size_t count;
    double half = UM_PI / c.rate;
    UM_TRY(
        um_environment_events_find(context, &e, circle_at, &c, -half, half, 60.0, &event, &count));
    double length = count == 6 ? event[3].t_tai - event[0].t_tai : NAN;
    um_core_free(context, event);
    um_validate_report_add(report, row[i].name, "1", row[i].fraction, length / (2.0 * half), 6e-7,
                           CLOSED);
    if (i > 0) continue;
    um_validate_report_add(report, "Eclipse, 765 km, beta 0, duration", "s", 2110.90, length, 0.005,
                           CLOSED);
  }
  static const struct {
    const char *name;
    double altitude, beta; /* [m], [deg] */
  } critical[] = {{"No eclipse beyond beta, 765 km", 765e3, 63.2405},
                  {"No eclipse beyond beta, 600 km", 600e3, 66.0665},
                  {"No eclipse beyond beta, 400 km", 400e3, 70.2179}};
  for (size_t i = 0; i < 3; i++) {
    double low = 0.0, high = 90.0;
    while (high - low > 1e-7) {
      double beta = 0.5 * (low + high) * UM_DEG;
      struct um_vec3 r = {-UM_EARTH_RADIUS - critical[i].altitude, 0.0, 0.0};
      struct um_vec3 sun = {cos(beta), 0.0, sin(beta)};
      if (um_environment_limb_angle(&e, r, sun, UM_AU, north) < 0.0)
        low = beta / UM_DEG;
      else
        high = beta / UM_DEG;
    }
    um_validate_report_add(report, critical[i].name, "deg", critical[i].beta, low, 6e-5, CLOSED);
  }
  return UM_OK;
}

/* Plate and sphere before the Earth; six decimals are printed. */
static void view_factors(struct um_validate_report *report)
{
#define PLATES(h)                                                                                  \
  {                                                                                                \
    "Plate to Earth, " #h " km, tilt 0", "Plate to Earth, " #h " km, tilt 30",                     \
        "Plate to Earth, " #h " km, tilt 45", "Plate to Earth, " #h " km, tilt 60",                \
        "Plate to Earth, " #h " km, tilt 90", "Plate to Earth, " #h " km, tilt 120",               \
        "Plate to Earth, " #h " km, tilt 135", "Plate to Earth, " #h " km, tilt 150",              \
        "Sphere to Earth, " #h " km"                                                               \
  }
  static const double tilt[] = {0.0, 30.0, 45.0, 60.0, 90.0, 120.0, 135.0, 150.0};
  static const struct {
    double altitude, factor[9];
    const char *name[9];
  } row[] = {
      {400e3,
       {0.885456, 0.771249, 0.660629, 0.537163, 0.288727, 0.094435, 0.034517, 0.004422, 0.330778},
       PLATES(400)},
      {600e3,
       {0.835427, 0.724685, 0.612558, 0.489329, 0.249009, 0.071616, 0.021821, 0.001184, 0.297162},
       PLATES(600)},
      {765e3,
       {0.797278, 0.690707, 0.578861, 0.456749, 0.223367, 0.058110, 0.015101, 0.000244, 0.274877},
       PLATES(765)},
      {800e3,
       {0.789522, 0.683899, 0.572242, 0.450437, 0.218529, 0.055676, 0.013966, 0.000153, 0.270611},
       PLATES(800)},
      {35786e3,
       {0.022882, 0.019817, 0.016180, 0.011441, 0.000740, 0.0, 0.0, 0.0, 0.005754},
       PLATES(35786)}};
#undef PLATES
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    for (int k = 0; k < 9; k++) {
      double h = 1.0 + row[i].altitude / UM_EARTH_RADIUS;
      um_validate_report_add(report, row[i].name[k], "1", row[i].factor[k],
                             k < 8 ? um_environment_plate_view_factor(h, tilt[k] * UM_DEG)
                                   : um_environment_sphere_view_factor(h),
                             6e-7, k < 8 ? "Howell; Juul 1979" : CLOSED);
    }
}

/* Mean over normals of equal weight: 200 tilts by 100 turns resolve 2e-6 of a sphere. */
static double sphere_albedo(const struct um_environment *e, struct um_vec3 r, struct um_vec3 sun)
{
  struct um_vec3 normal[100];
  struct um_environment_earth_flux flux[100];
  double sum = 0.0;
  for (int i = 0; i < 200; i++) {
    double c = -1.0 + 2.0 * (i + 0.5) / 200.0, s = sqrt(1.0 - c * c);
    for (int j = 0; j < 100; j++) {
      double phi = 2.0 * UM_PI * (j + 0.5) / 100.0;
      normal[j] = um_vec3(c, s * cos(phi), s * sin(phi));
    }
    um_environment_earth_flux(e, NULL, r, sun, UM_AU, normal, 100, flux);
    for (int j = 0; j < 100; j++) sum += flux[j].albedo / 20000.0;
  }
  return sum;
}

/* E/(a S) at 765 km. 1e-6: eight nodes across the cap at a plate's own horizon; nadir plates see
 * all of the cap and are held to the reference's 8 decimals. */
static void albedo(struct um_validate_report *report)
{
#define ZENITH(z)                                                                                  \
  {                                                                                                \
    "Albedo factor, Sun at " #z ", sphere", "Albedo factor, Sun at " #z ", nadir plate",           \
        "Albedo factor, Sun at " #z ", plate to horizon"                                           \
  }
  static const struct {
    double zenith, factor[3]; /* [deg], [1] */
    const char *name[3];
  } row[] = {{0.0, {0.27110554, 0.78874193, 0.21947271}, ZENITH(0)},
             {30.0, {0.23478428, 0.68307055, 0.20441682}, ZENITH(30)},
             {60.0, {0.13555277, 0.39437097, 0.13458762}, ZENITH(60)},
             {75.0, {0.07044877, 0.20466470, 0.08452170}, ZENITH(75)},
             {90.0, {0.01217855, 0.03068494, 0.02869577}, ZENITH(90)},
             {100.0, {0.00123956, 0.00242414, 0.00393072}, ZENITH(100)},
             {110.0, {0.00003335, 0.00006057, 0.00011491}, ZENITH(110)}};
#undef ZENITH
  static const double tolerance[3] = {3e-6, 3e-8, 1e-6};
  struct um_environment e = with(UM_SHADOW_NONE, UM_DISC_UNIFORM);
  e.albedo = e.solar_irradiance = 1.0;
  const struct um_vec3 r = {UM_EARTH_RADIUS + 765e3, 0.0, 0.0};
  const struct um_vec3 plate[2] = {{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double z = row[i].zenith * UM_DEG;
    struct um_vec3 sun = {cos(z), sin(z), 0.0};
    struct um_environment_earth_flux flux[2];
    um_environment_earth_flux(&e, NULL, r, sun, UM_AU, plate, 2, flux);
    const double value[3] = {sphere_albedo(&e, r, sun), flux[0].albedo, flux[1].albedo};
    for (int k = 0; k < 3; k++)
      um_validate_report_add(report, row[i].name[k], "1", row[i].factor[k], value[k], tolerance[k],
                             "72 million areas");
  }
}

enum um_status um_validate_environment(struct um_context *context,
                                       struct um_validate_report *report)
{
  sunlight(report);
  shadow(report);
  UM_TRY(eclipses(context, report));
  view_factors(report);
  albedo(report);
  return UM_OK;
}
