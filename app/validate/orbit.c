/* Cases of orbit and of the pass of ENVISAT over Graz: SGP4, frames, Sun and Moon, sight from a
 * station, the return of sunlight.
 *
 * Sources: Vallado, Crawford, Hujsak & Kelso 2006, AIAA 2006-6753 (SGP4 and frames); astropy with
 * ERFA (Sun, Moon, Graz); python-sgp4 with astropy and, apart from them, Skyfield (ENVISAT). */
#include "app/validate/validate.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/environment.h"
#include "orbit/geodesy.h"
#include "orbit/observer.h"
#include "orbit/sgp4.h"
#include "orbit/sun.h"
#include "orbit/time.h"

#define VALLADO  "AIAA 2006-6753"
#define ASTROPY  "astropy, ERFA"
#define PROGRAMS "python-sgp4, astropy, Skyfield"

/* Positions of 00005 to 1e-8 km; 2e-7 km is the spread of the published programs themselves. */
static enum um_status sgp4_positions(struct um_context *context, struct um_validate_report *report)
{
  static const char elements[] =
      "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753\n"
      "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667\n";
  static const struct {
    double minutes, r[3];
    const char *name[3];
  } row[] = {{0.0,
              {7022.46529266, -1400.08296755, 0.03995155},
              {"SGP4 00005, 0 min, x", "SGP4 00005, 0 min, y", "SGP4 00005, 0 min, z"}},
             {360.0,
              {-7154.03120202, -3783.17682504, -3536.19412294},
              {"SGP4 00005, 360 min, x", "SGP4 00005, 360 min, y", "SGP4 00005, 360 min, z"}},
             {4320.0,
              {-9060.47373569, 4658.70952502, 813.68673153},
              {"SGP4 00005, 4320 min, x", "SGP4 00005, 4320 min, y", "SGP4 00005, 4320 min, z"}}};
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  enum um_status status;
  UM_CHECK(um_orbit_tle_parse(context, elements, 1, &tle));
  UM_CHECK(um_orbit_sgp4_create(context, &tle, &sgp4));
  for (int i = 0; i < 3; i++) {
    struct um_vec3 r, v;
    UM_CHECK(um_orbit_sgp4_state(context, sgp4, row[i].minutes, &r, &v, NULL));
    const double at[3] = {r.x, r.y, r.z}, speed[3] = {v.x, v.y, v.z};
    static const double expected[3] = {1.893841015, 6.405893759, 4.534807250};
    static const char *const name[3] = {"SGP4 00005, 0 min, vx", "SGP4 00005, 0 min, vy",
                                        "SGP4 00005, 0 min, vz"};
    for (int k = 0; k < 3; k++)
      um_validate_report_add(report, row[i].name[k], "km", row[i].r[k], 1e-3 * at[k], 2e-7,
                             VALLADO);
    for (int k = 0; k < 3 && i == 0; k++) /* nine decimals are printed */
      um_validate_report_add(report, name[k], "km/s", expected[k], 1e-3 * speed[k], 1e-9, VALLADO);
  }
done:
  um_orbit_sgp4_destroy(&sgp4);
  return status;
}

/* 33334 has no orbit at its epoch: error 3, perturbed eccentricity. */
static enum um_status sgp4_error(struct um_context *context, struct um_validate_report *report)
{
  static const char elements[] =
      "1 33334U 78066F   06174.85818871  .00000620  00000-0  10000-3 0  6809\n"
      "2 33334  68.4714 236.1303 5602877 123.7484 302.5767  0.00001000 67521\n";
  struct um_orbit_tle tle;
  struct um_orbit_sgp4 *sgp4 = NULL;
  struct um_vec3 r, v;
  enum um_status status;
  int error = 0;
  UM_CHECK(um_orbit_tle_parse(context, elements, 0, &tle));
  UM_CHECK(um_orbit_sgp4_create(context, &tle, &sgp4));
  if (um_orbit_sgp4_state(context, sgp4, 0.0, &r, &v, &error) != UM_OK)
    um_core_message_clear(context);
  um_validate_report_add(report, "SGP4 33334, 0 min, error code", "1", 3.0, error, 0.0, VALLADO);
done:
  um_orbit_sgp4_destroy(&sgp4);
  return status;
}

static void add_vector(struct um_validate_report *report, const char *const name[3],
                       const char *unit, const double expected[3], struct um_vec3 computed,
                       double tolerance, const char *source)
{
  const double value[3] = {computed.x, computed.y, computed.z};
  for (int k = 0; k < 3; k++)
    um_validate_report_add(report, name[k], unit, expected[k], value[k], tolerance, source);
}

/* 2004-04-06 07:51:28.386009 UTC. 2e-5 km: 3e-9 rad, at which IAU-76 and IAU 2006 frames differ. */
static enum um_status frames(struct um_context *context, struct um_validate_report *report)
{
  const struct um_orbit_earth_orientation still = {.ut1_utc = -0.4399619};
  const struct um_orbit_earth_orientation eop = {
      .ut1_utc = -0.4399619, .xp = -0.140682 * UM_ARCSEC, .yp = 0.333309 * UM_ARCSEC};
  static const double itrf[3] = {-1033.4793830, 7901.2952754, 6380.3565958};
  static const double speed[3] = {-3.225636517, -2.872451453, 5.531924446};
  static const double gcrs[3] = {5102.508959, 6123.011403, 6378.136925};
  static const char *const itrf_name[3] = {"TEME to ITRF, x", "TEME to ITRF, y", "TEME to ITRF, z"};
  static const char *const speed_name[3] = {"TEME to ITRF, vx", "TEME to ITRF, vy",
                                            "TEME to ITRF, vz"};
  static const char *const gcrs_name[3] = {"TEME to GCRS, x", "TEME to GCRS, y", "TEME to GCRS, z"};
  const struct um_vec3 r_teme = {5094180.16210, 6127644.65950, 6380344.53270};
  const struct um_vec3 v_teme = {-4746.131487, 785.818041, 5531.931288};
  const struct um_vec3 zero = {0.0, 0.0, 0.0};
  struct um_vec3 r, v;
  struct um_mat3 to_gcrs;
  double t;
  UM_TRY(um_orbit_time_parse(context, "2004-04-06T07:51:28.386009Z", &t));
  /* without polar motion ITRF is turned from TEME by the sidereal time alone; printed to 1e-7 */
  UM_TRY(um_orbit_frames_teme_to_itrf(context, &still, t, 0.0, um_vec3(1, 0, 0), zero, &r, &v));
  um_validate_report_add(report, "GMST82", "deg", 312.8098942,
                         fmod(atan2(-r.y, r.x) / UM_DEG + 360.0, 360.0), 1e-7, VALLADO);
  UM_TRY(um_orbit_frames_teme_to_itrf(context, &eop, t, 1.5563e-3, r_teme, v_teme, &r, &v));
  add_vector(report, itrf_name, "km", itrf, um_vec3_scale(r, 1e-3), 2e-5, VALLADO);
  /* v_TEME is printed to 1e-6 km/s */
  add_vector(report, speed_name, "km/s", speed, um_vec3_scale(v, 1e-3), 2e-6, VALLADO);
  UM_TRY(um_orbit_frames_teme_to_gcrs(context, &eop, t, &to_gcrs));
  add_vector(report, gcrs_name, "km", gcrs, um_vec3_scale(um_mat3_apply(to_gcrs, r_teme), 1e-3),
             2e-5, ASTROPY);
  static const double graz[3] = {4194.415343, 1162.662485, 4647.203875};
  static const char *const graz_name[3] = {"Graz in ITRF, x", "Graz in ITRF, y", "Graz in ITRF, z"};
  r = um_orbit_geodesy_forward(47.067 * UM_DEG, 15.493 * UM_DEG, 495.0);
  add_vector(report, graz_name, "km", graz, um_vec3_scale(r, 1e-3), 1e-6, ASTROPY); /* printed */
  return UM_OK;
}

/* Angles from the table's directions: 2e-5 rad for the Sun (4", of 1919" across), 10" for the Moon,
 * the accuracy of its theory; distance to the digits printed. */
static enum um_status sun_and_moon(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *utc, *name[4];
    double sun[3], au, apparent[3], moon[3]; /* [km], [au], [1], [km] */
  } row[] = {{"2000-01-01T12:00:00Z",
              {"Sun 2000-01-01, direction off by", "Sun 2000-01-01, apparent, off by",
               "Sun 2000-01-01, distance", "Moon 2000-01-01, direction off by"},
              {26500942.0, -132757095.5, -57556577.3},
              0.983327667,
              {0.180052009, -0.902489394, -0.391272499},
              {-291564.159, -266757.981, -76118.376}},
             {"2006-04-02T00:00:00Z",
              {"Sun 2006-04-02, direction off by", "Sun 2006-04-02, apparent, off by",
               "Sun 2006-04-02, distance", "Moon 2006-04-02, direction off by"},
              {146233224.8, 28597693.0, 12398187.2},
              0.999467591,
              {0.978050165, 0.191176387, 0.082882229},
              {187606.032, 286887.996, 155684.221}},
             {"2016-09-21T20:33:00Z",
              {"Sun 2016-09-21, direction off by", "Sun 2016-09-21, apparent, off by",
               "Sun 2016-09-21, distance", "Moon 2016-09-21, direction off by"},
              {-150133961.9, 2288788.1, 992563.5},
              1.003722092,
              {-0.999860321, 0.015333643, 0.006649626},
              {133884.176, 326694.230, 104874.670}},
             {"2019-07-23T21:00:00Z",
              {"Sun 2019-07-23, direction off by", "Sun 2019-07-23, apparent, off by",
               "Sun 2019-07-23, distance", "Moon 2019-07-23, direction off by"},
              {-77042934.5, 120198770.8, 52105734.2},
              1.015933346,
              {-0.506838945, 0.790923295, 0.342862399},
              {381462.992, 122866.980, 13116.193}}};
  const struct um_vec3 zero = {0.0, 0.0, 0.0};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double t, distance;
    struct um_vec3 apparent;
    UM_TRY(um_orbit_time_parse(context, row[i].utc, &t));
    struct um_vec3 sun = um_orbit_sun_position(NULL, t), moon = um_orbit_moon_position(t);
    um_orbit_sun_apparent(NULL, t, zero, zero, &apparent, &distance);
    const double *s = row[i].sun, *a = row[i].apparent, *m = row[i].moon;
    um_validate_report_add(report, row[i].name[0], "rad", 0.0,
                           um_vec3_angle(sun, um_vec3(s[0], s[1], s[2])), 2e-5, ASTROPY);
    um_validate_report_add(report, row[i].name[1], "rad", 0.0,
                           um_vec3_angle(apparent, um_vec3(a[0], a[1], a[2])), 2e-5, ASTROPY);
    um_validate_report_add(report, row[i].name[2], "au", row[i].au, um_vec3_norm(sun) / UM_AU, 2e-9,
                           ASTROPY);
    um_validate_report_add(report, row[i].name[3], "arcsec", 0.0,
                           um_vec3_angle(moon, um_vec3(m[0], m[1], m[2])) / UM_ARCSEC, 10.0,
                           ASTROPY);
  }
  return UM_OK;
}

/* The satellite of 2016-09-21, seen from Graz without light time and refraction. */
struct pass {
  struct um_context *context;
  struct um_orbit_trajectory *orbit;
  struct um_orbit_observer graz;
};

static const struct um_orbit_earth_orientation iers = {
    .ut1_utc = -0.267794, .xp = 0.23662 * UM_ARCSEC, .yp = 0.35129 * UM_ARCSEC};

static enum um_status envisat_look(struct pass *pass, const char *utc, struct um_orbit_look *look,
                                   double *phase)
{
  double t, distance;
  struct um_vec3 sun;
  UM_TRY(um_orbit_time_parse(pass->context, utc, &t));
  UM_TRY(um_orbit_observer_look(pass->context, &pass->graz, pass->orbit, t, look));
  um_orbit_sun_apparent(NULL, look->t_satellite, look->r_gcrs, look->v_gcrs, &sun, &distance);
  *phase = um_vec3_angle(sun, look->to_observer);
  return UM_OK;
}

/* Angles to 1e-3 deg (printed, and in what the programs agree), range to 10 m, state to 1 m (they
 * treat UT1 and polar motion apart from each other by that much). */
static enum um_status envisat_at_2033(struct pass *pass, struct um_validate_report *report)
{
  static const double gcrs[3] = {4099.22041742, -4721.16605404, 3450.55087333};
  static const char *const name[3] = {"ENVISAT 20:33:00, GCRS x", "ENVISAT 20:33:00, GCRS y",
                                      "ENVISAT 20:33:00, GCRS z"};
  struct um_orbit_look look;
  double phase;
  UM_TRY(envisat_look(pass, "2016-09-21T20:33:00Z", &look, &phase));
  um_validate_report_add(report, "ENVISAT 20:33:00, azimuth", "deg", 215.6793,
                         look.azimuth / UM_DEG, 1e-3, PROGRAMS);
  um_validate_report_add(report, "ENVISAT 20:33:00, elevation", "deg", 6.6881,
                         look.elevation / UM_DEG, 1e-3, PROGRAMS);
  um_validate_report_add(report, "ENVISAT 20:33:00, range", "km", 2562.928, 1e-3 * look.range, 0.01,
                         PROGRAMS);
  um_validate_report_add(report, "ENVISAT 20:33:00, phase angle", "deg", 76.868, phase / UM_DEG,
                         1e-3, PROGRAMS);
  um_validate_report_add(report, "ENVISAT 20:33:00, Sun's elevation", "deg", -33.9,
                         look.sun_elevation / UM_DEG, 0.05, PROGRAMS); /* printed to 0.1 */
  add_vector(report, name, "km", gcrs, um_vec3_scale(look.r_gcrs, 1e-3), 1e-3, PROGRAMS);
  UM_TRY(envisat_look(pass, "2016-09-21T20:37:34.76Z", &look, &phase));
  um_validate_report_add(report, "ENVISAT culmination, phase angle", "deg", 108.327, phase / UM_DEG,
                         1e-3, PROGRAMS);
  return UM_OK;
}

/* Times: half a printed digit and 1e-4 deg at 0.05 deg/s. Azimuth of the culmination moves by 0.15
 * deg/s; culmination is flat, hence 0.02 s and 3e-3 deg. */
static enum um_status envisat_pass(struct pass *pass, struct um_validate_report *report)
{
  struct um_context *context = pass->context;
  static const struct {
    double limit, rise, set, rise_azimuth, set_azimuth; /* [deg], [s after 20:31, 20:41], [deg] */
    const char *name[4];
  } row[] = {
      {0.0,
       1.14,
       192.41,
       205.328,
       333.306,
       {"ENVISAT rises, s after 20:31", "ENVISAT sets, s after 20:41", "ENVISAT rises, azimuth",
        "ENVISAT sets, azimuth"}},
      {10.0,
       173.68,
       17.34,
       222.264,
       316.206,
       {"ENVISAT rises past 10 deg, s after 20:31", "ENVISAT sets past 10 deg, s after 20:41",
        "ENVISAT rises past 10 deg, azimuth", "ENVISAT sets past 10 deg, azimuth"}}};
  double t31, t37, t41;
  struct um_orbit_pass *found = NULL;
  enum um_status status;
  UM_CHECK(um_orbit_time_parse(context, "2016-09-21T20:31:00Z", &t31));
  UM_CHECK(um_orbit_time_parse(context, "2016-09-21T20:37:00Z", &t37));
  UM_CHECK(um_orbit_time_parse(context, "2016-09-21T20:41:00Z", &t41));
  for (int i = 0; i < 2; i++) {
    size_t count = 0;
    um_core_free(context, found);
    found = NULL;
    UM_CHECK(um_orbit_passes_find(context, &pass->graz, pass->orbit, t31 - 1800.0, t31 + 3000.0,
                                  row[i].limit * UM_DEG, &found, &count));
    if (count == 0) continue;
    um_validate_report_add(report, row[i].name[0], "s", row[i].rise, found->rise - t31, 0.01,
                           PROGRAMS);
    um_validate_report_add(report, row[i].name[2], "deg", row[i].rise_azimuth,
                           found->rise_azimuth / UM_DEG, 1e-3, PROGRAMS);
    um_validate_report_add(report, row[i].name[1], "s", row[i].set, found->set - t41, 0.01,
                           PROGRAMS);
    um_validate_report_add(report, row[i].name[3], "deg", row[i].set_azimuth,
                           found->set_azimuth / UM_DEG, 1e-3, PROGRAMS);
    if (i > 0) continue;
    um_validate_report_add(report, "ENVISAT culminates, s after 20:37", "s", 34.76,
                           found->culmination - t37, 0.02, PROGRAMS);
    um_validate_report_add(report, "ENVISAT culmination, elevation", "deg", 19.998,
                           found->culmination_elevation / UM_DEG, 1e-3, PROGRAMS);
    um_validate_report_add(report, "ENVISAT culmination, azimuth", "deg", 269.207,
                           found->culmination_azimuth / UM_DEG, 3e-3, PROGRAMS);
    um_validate_report_add(report, "ENVISAT culmination, range", "km", 1716.44,
                           1e-3 * found->culmination_range, 0.02, PROGRAMS);
  }
done:
  um_core_free(context, found);
  return status;
}

static enum um_status scene_at(void *self, double t, struct um_vec3 *r, struct um_vec3 *sun,
                               double *distance, struct um_vec3 *pole)
{
  struct pass *pass = self;
  struct um_vec3 v;
  struct um_mat3 to_itrf;
  UM_TRY(um_orbit_trajectory_state(pass->context, pass->orbit, t, r, &v));
  UM_TRY(um_orbit_frames_gcrs_to_itrf(pass->context, &iers, t, &to_itrf));
  um_orbit_sun_apparent(NULL, t, *r, v, sun, distance);
  *pole = um_vec3(to_itrf.m[2][0], to_itrf.m[2][1], to_itrf.m[2][2]);
  return UM_OK;
}

/* 0.1 s: the reference samples the disc by rays and so shortens the 13.6 s of its rise by some
 * 0.3 % at either end; times are printed to 0.01 s. */
static enum um_status light_returns(struct pass *pass, struct um_validate_report *report)
{
  static const struct {
    enum um_environment_shadow shadow;
    double radius, at[3]; /* [m], [s after 20:36] */
    const char *name[3];
  } row[] = {{UM_SHADOW_OBLATE,
              6378137.0,
              {51.86, 58.68, 65.48},
              {"First light, oblate Earth, s after 20:36", "Half light, oblate Earth",
               "Full light, oblate Earth"}},
             {UM_SHADOW_SPHERE,
              6378137.0,
              {57.65, 64.50, 71.34},
              {"First light, sphere 6378.137 km", "Half light, sphere 6378.137 km",
               "Full light, sphere 6378.137 km"}},
             {UM_SHADOW_SPHERE,
              6371000.0,
              {54.35, 61.21, 68.06},
              {"First light, sphere 6371 km", "Half light, sphere 6371 km",
               "Full light, sphere 6371 km"}}};
  double t36;
  UM_TRY(um_orbit_time_parse(pass->context, "2016-09-21T20:36:00Z", &t36));
  for (int i = 0; i < 3; i++) {
    struct um_environment environment;
    struct um_environment_event *event = NULL;
    size_t count;
    um_environment_defaults(&environment);
    environment.disc = UM_DISC_UNIFORM;
    environment.shadow = row[i].shadow;
    environment.shadow_radius = row[i].radius;
    UM_TRY(um_environment_events_find(pass->context, &environment, scene_at, pass, t36 - 300.0,
                                      t36 + 480.0, 60.0, &event, &count));
    for (size_t k = 0; k < 3; k++)
      um_validate_report_add(report, row[i].name[k], "s", row[i].at[k],
                             k < count ? event[k].t_tai - t36 : NAN, 0.1,
                             "python-sgp4, ERFA, rays");
    um_core_free(pass->context, event);
  }
  return UM_OK;
}

static enum um_status envisat(struct um_context *context, struct um_validate_report *report)
{
  static const char elements[] =
      "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
      "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n";
  struct pass pass = {.context = context,
                      .graz = {.kind = UM_OBSERVER_STATION,
                               .latitude = 47.067 * UM_DEG,
                               .longitude = 15.493 * UM_DEG,
                               .height = 495.0,
                               .orientation = iers}};
  struct um_orbit_tle tle;
  enum um_status status;
  UM_CHECK(um_orbit_tle_parse(context, elements, 1, &tle));
  UM_CHECK(um_orbit_trajectory_create_tle(context, &tle, &iers, &pass.orbit));
  UM_CHECK(envisat_at_2033(&pass, report));
  UM_CHECK(envisat_pass(&pass, report));
  UM_CHECK(light_returns(&pass, report));
done:
  um_orbit_trajectory_destroy(&pass.orbit);
  return status;
}

enum um_status um_validate_orbit(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(sgp4_positions(context, report));
  UM_TRY(sgp4_error(context, report));
  UM_TRY(frames(context, report));
  UM_TRY(sun_and_moon(context, report));
  return envisat(context, report);
}
