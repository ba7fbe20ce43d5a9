/* Light curves of bodies with closed forms, by the renderer: Lambert sphere, cylinder and plate, a
 * Cook-Torrance plate, hot plates, the Earth's light, surroundings at one temperature.
 *
 *   Lambert sphere    I = E a r^2 p(g),    p = (2 / 3 pi) [sin g + (pi - g) cos g]
 *   cylinder          I = E a r L c(g),    c = (1 / 2 pi) [sin g + (pi - g) cos g], broadside
 *   plate             I = E a A cos i cos o / pi
 *
 * The cosines behind projected areas are kept as float: 6e-8 each. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/validate/cases_impl.h"
#include "base/core/constants.h"
#include "base/core/planck.h"
#include "optics/radiance/optics.h"

#define CLOSED "closed form"
#define FLOAT  3e-7 /* relative */

static const struct um_optics_band vis = {"vis", 0.38e-6, 0.78e-6, 20, NULL};
static const struct um_optics_band lwir = {"lwir", 8e-6, 12e-6, 40, NULL};

/* One part of one material, at most 64 instants. */
struct scene {
  struct um_context *context;
  struct um_materials_library *library;
  struct um_geometry *geometry;
  struct um_environment environment;
  struct um_environment_sample samples[64];
  size_t ntime;
  const struct um_materials_record *record;
  double *temperature; /* [ntime][nsurface] */
  float *albedo, *view_factor;
  struct um_optics_view *view;
  struct um_optics_lightcurve *curve;
};

/* The product's grey panel with other numbers: Lambert reflectance, F of the lobe, its alpha,
 * emittance. */
static enum um_status scene_grey(struct scene *s, double diffuse, double specular, double alpha,
                                 double emittance)
{
  char text[6][80];
  const char *overrides[6];
  char *folder = NULL, *path = NULL;
  enum um_status status;
  snprintf(text[0], sizeof text[0], "name=skin");
  snprintf(text[1], sizeof text[1], "grey.solar_absorptance=%.17g", 1.0 - diffuse - specular);
  snprintf(text[2], sizeof text[2], "grey.emittance=%.17g", emittance);
  snprintf(text[3], sizeof text[3], "grey.vis_reflectance_diffuse=%.17g", diffuse);
  snprintf(text[4], sizeof text[4], "grey.specular_reflectance=%.17g", specular);
  snprintf(text[5], sizeof text[5], "grey.beckmann_alpha=%.17g", alpha);
  for (int i = 0; i < 6; i++) overrides[i] = text[i];
  UM_CHECK(um_materials_library_folder(s->context, &folder));
  UM_CHECK(um_core_asprintf(s->context, &path, "%s/grey_panel.yaml", folder));
  UM_CHECK(um_environment_library_create(s->context, false, &s->library));
  UM_CHECK(um_materials_library_read_file(s->context, s->library, path, overrides, 6));
  s->record = um_materials_library_find(s->library, "skin");
done:
  UM_FREE(s->context, path, folder);
  return status;
}

static struct um_geometry_part_spec shape_of(enum um_geometry_shape shape, double x, double y)
{
  static const struct um_geometry_skin open = {NULL, "skin", "skin"}, closed = {NULL, "skin", NULL};
  return (struct um_geometry_part_spec){.name = "body",
                                        .shape = shape,
                                        .size = {x, y, x},
                                        .radius = x,
                                        .height = y,
                                        .rotation = {1.0, 0.0, 0.0, 0.0},
                                        .skins = shape == UM_SHAPE_PLATE ? &open : &closed,
                                        .nskin = 1};
}

/* Identity attitude, 1 au, full sunlight, Sun and observer toward +z; 300 K; no Earth. */
static enum um_status scene_set(struct scene *s, struct um_context *context,
                                const struct um_geometry_part_spec *shape, size_t ntime)
{
  s->context = context;
  s->ntime = ntime;
  um_environment_defaults(&s->environment);
  UM_TRY(um_geometry_create(context, shape, 1, &s->geometry));
  size_t n = ntime * um_geometry_mesh(s->geometry)->nsurface;
  UM_TRY(um_core_allocate(context, n, sizeof *s->temperature, &s->temperature));
  UM_TRY(um_core_allocate(context, n, sizeof *s->albedo, &s->albedo));
  UM_TRY(um_core_allocate(context, n, sizeof *s->view_factor, &s->view_factor));
  for (size_t i = 0; i < n; i++) s->temperature[i] = 300.0;
  for (size_t t = 0; t < ntime; t++)
    s->samples[t] = (struct um_environment_sample){.r = {7.0e6, 0.0, 0.0},
                                                   .q = {1.0, 0.0, 0.0, 0.0},
                                                   .sun = {0.0, 0.0, 1.0},
                                                   .to_observer = {0.0, 0.0, 1.0},
                                                   .pole = {0.0, 0.0, 1.0},
                                                   .sun_distance = UM_AU,
                                                   .sunlit_fraction = 1.0,
                                                   .range = 1e6};
  return UM_OK;
}

static enum um_status scene_run(struct scene *s, const struct um_optics_band *band)
{
  const struct um_optics_scene scene = {.geometry = s->geometry,
                                        .environment = &s->environment,
                                        .samples = s->samples,
                                        .material = &s->record,
                                        .temperature = s->temperature,
                                        .albedo = s->albedo,
                                        .view_factor = s->view_factor};
  UM_TRY(um_optics_view_trace(s->context, s->geometry, s->samples, s->ntime, 1, 0, &s->view));
  struct um_optics_scene seen = scene;
  seen.view = s->view;
  return um_optics_lightcurve_compute(s->context, &seen, band, 1, &s->curve);
}

static void scene_end(struct scene *s)
{
  um_optics_lightcurve_destroy(s->context, &s->curve);
  um_optics_view_destroy(s->context, &s->view);
  UM_FREE(s->context, s->temperature, s->albedo, s->view_factor);
  um_geometry_destroy(&s->geometry);
  um_materials_library_destroy(&s->library);
  memset(s, 0, sizeof *s);
}

/* Band intensity [W/sr] of a mechanism. */
static double intensity(const struct scene *s, size_t time, enum um_optics_mechanism mechanism)
{
  return s->curve->intensity[time * UM_MECHANISM_COUNT + (size_t)mechanism];
}

static struct um_vec3 polar(double theta, double phi)
{
  return um_vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

/* Magnitude at 1000 km on V = -26.74 for the Sun, of an intensity over the irradiance [m^2/sr]. */
static double magnitude(double ratio) { return -26.74 - 2.5 * log10(ratio / 1e12); }

/* Facets of h 0.05 r leave a relative error of h^2 / 12 = 2e-4 where most of the lit side is seen
 * (second order: tests/optics/lightcurve); crescents, a few facets wide, are held to it in units of
 * the full phase. Magnitudes: 1.0857 times that over the phase function. */
static enum um_status sphere(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name, *bright;
    double phase, p, magnitude; /* [deg], [1], [mag] or 0 */
  } row[] = {{"Lambert sphere, phase function at 0 deg", "Lambert sphere, V at 0 deg", 0.0,
              0.666667, 5.4477},
             {"Lambert sphere, phase function at 30 deg", NULL, 30.0, 0.587229, 0.0},
             {"Lambert sphere, phase function at 60 deg", "Lambert sphere, V at 60 deg", 60.0,
              0.405999, 5.9861},
             {"Lambert sphere, phase function at 90 deg", "Lambert sphere, V at 90 deg", 90.0,
              0.212207, 6.6905},
             {"Lambert sphere, phase function at 120 deg", "Lambert sphere, V at 120 deg", 120.0,
              0.072665, 7.8541},
             {"Lambert sphere, phase function at 150 deg", NULL, 150.0, 0.009878, 0.0},
             {"Lambert sphere, phase function at 180 deg", NULL, 180.0, 0.0, 0.0}};
  enum { ROWS = sizeof row / sizeof row[0] };
  const double mesh = 2e-4 * 2.0 / 3.0;
  struct um_geometry_part_spec shape = shape_of(UM_SHAPE_SPHERE, 1.0, 0.0);
  struct scene s = {.context = context};
  enum um_status status;
  shape.facet_size = 0.05;
  UM_CHECK(scene_grey(&s, 0.2, 0.0, 0.265, 0.8));
  UM_CHECK(scene_set(&s, context, &shape, ROWS));
  for (size_t t = 0; t < ROWS; t++) {
    struct um_vec3 side, other, sun = polar(0.7, 0.4);
    um_core_vec3_frame(sun, &side, &other);
    double g = row[t].phase * UM_DEG;
    s.samples[t].sun = sun;
    s.samples[t].to_observer = um_vec3_axpy(um_vec3_scale(sun, cos(g)), sin(g), side);
  }
  UM_CHECK(scene_run(&s, &vis));
  double e = um_environment_solar_band(&s.environment, vis.from, vis.to);
  for (size_t t = 0; t < ROWS; t++) {
    double i = intensity(&s, t, UM_MECHANISM_SUN) / e;
    um_validate_report_add(report, row[t].name, "1", row[t].p, i / 0.2, mesh, CLOSED);
    if (row[t].bright != NULL)
      um_validate_report_add(report, row[t].bright, "mag", row[t].magnitude, magnitude(i),
                             1.0857 * mesh / row[t].p + 5e-5, CLOSED);
  }
done:
  scene_end(&s);
  return status;
}

/* Facets of 0.05 m around a radius of 0.5 m, n = 63, of exact area: what remains is the spread of
 * the normal within a facet, (pi/n)^2 / 6 = 4e-4 of the scale 1/2. */
static enum um_status cylinder(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double phase, c; /* [deg], [1] */
  } row[] = {{"Lambert cylinder, phase function at 0 deg", 0.0, 0.5},
             {"Lambert cylinder, phase function at 60 deg", 60.0, 0.304499},
             {"Lambert cylinder, phase function at 90 deg", 90.0, 0.159155}};
  struct um_geometry_part_spec shape = shape_of(UM_SHAPE_CYLINDER, 0.5, 2.0);
  struct scene s = {.context = context};
  enum um_status status;
  shape.facet_size = 0.05;
  UM_CHECK(scene_grey(&s, 0.3, 0.0, 0.265, 0.8));
  UM_CHECK(scene_set(&s, context, &shape, 3));
  for (size_t t = 0; t < 3; t++) {
    s.samples[t].sun = polar(0.5 * UM_PI, 0.2);
    s.samples[t].to_observer = polar(0.5 * UM_PI, 0.2 + row[t].phase * UM_DEG);
  }
  UM_CHECK(scene_run(&s, &vis));
  double e = um_environment_solar_band(&s.environment, vis.from, vis.to);
  for (size_t t = 0; t < 3; t++)
    um_validate_report_add(report, row[t].name, "1", row[t].c,
                           intensity(&s, t, UM_MECHANISM_SUN) / (e * 0.3 * 0.5 * 2.0), 2e-4,
                           CLOSED);
done:
  scene_end(&s);
  return status;
}

/* 1 m^2 at 1000 km; four decimals of a magnitude. */
static enum um_status plate(struct um_context *context, struct um_validate_report *report,
                            const char *name, double diffuse, double specular, double alpha,
                            double expected, double towards)
{
  struct um_geometry_part_spec shape = shape_of(UM_SHAPE_PLATE, 1.0, 1.0);
  struct scene s = {.context = context};
  enum um_status status;
  UM_CHECK(scene_grey(&s, diffuse, specular, alpha, 0.8));
  UM_CHECK(scene_set(&s, context, &shape, 1));
  s.samples[0].sun = polar(30.0 * UM_DEG, 0.0);
  s.samples[0].to_observer = polar(30.0 * UM_DEG, towards);
  UM_CHECK(scene_run(&s, &vis));
  double e = um_environment_solar_band(&s.environment, vis.from, vis.to);
  um_validate_report_add(report, name, "mag", expected,
                         magnitude(intensity(&s, 0, UM_MECHANISM_SUN) / e), 1e-4, CLOSED);
done:
  scene_end(&s);
  return status;
}

/* The printed magnitudes are of a Sun without size; its disc widens the lobe by theta^2/8 and so
 * lowers the peak by 2.5 log10(1 + theta^2 / (8 alpha^2)). */
static enum um_status plates(struct um_context *context, struct um_validate_report *report)
{
  double theta = asin(UM_SOLAR_RADIUS / UM_AU), w = theta * theta / 8.0;
  UM_TRY(plate(context, report, "Lambert plate, V at 30 and 30 deg", 0.2, 0.0, 0.265, 6.5626, 2.0));
  UM_TRY(plate(context, report, "Cook-Torrance plate, alpha 0.0296, V of the glint", 0.0, 0.9,
               0.0296, -1.5211 + 2.5 * log10(1.0 + w / (0.0296 * 0.0296)), UM_PI));
  return plate(context, report, "Cook-Torrance plate, alpha 0.265, V of the glint", 0.0, 0.9, 0.265,
               3.2386 + 2.5 * log10(1.0 + w / (0.265 * 0.265)), UM_PI);
}

/* 65 m^2 of eps 0.85 face-on at 1000 km; printed digits. */
static enum um_status hot_array(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double kelvin, irradiance, digit; /* [K], [W/m^2], [W/m^2] */
  } row[] = {{"65 m^2 at 280 K, 1000 km, 8-12 um", 280.0, 1.5001e-9, 0.6e-13},
             {"65 m^2 at 250 K, 1000 km, 8-12 um", 250.0, 8.044e-10, 0.6e-13},
             {"65 m^2 at 200 K, 1000 km, 8-12 um", 200.0, 1.923e-10, 0.6e-13},
             {"65 m^2 at 320 K, 1000 km, 8-12 um", 320.0, 2.894e-9, 0.6e-12}};
  const struct um_geometry_part_spec shape = shape_of(UM_SHAPE_PLATE, 13.0, 5.0);
  struct scene s = {.context = context};
  enum um_status status;
  UM_CHECK(scene_grey(&s, 0.2, 0.0, 0.265, 0.85));
  UM_CHECK(scene_set(&s, context, &shape, 4));
  size_t n = um_geometry_mesh(s.geometry)->nsurface;
  for (size_t i = 0; i < 4 * n; i++) s.temperature[i] = row[i / n].kelvin;
  UM_CHECK(scene_run(&s, &lwir));
  for (size_t t = 0; t < 4; t++)
    um_validate_report_add(report, row[t].name, "W/m^2", row[t].irradiance,
                           intensity(&s, t, UM_MECHANISM_EMITTED) / 1e12, row[t].digit,
                           "Planck's law");
done:
  scene_end(&s);
  return status;
}

/* Unit cube along (1, 1, 1): projected area sqrt(3). */
static enum um_status cube(struct um_context *context, struct um_validate_report *report)
{
  const struct um_geometry_part_spec shape = shape_of(UM_SHAPE_BOX, 1.0, 1.0);
  struct scene s = {.context = context};
  enum um_status status;
  UM_CHECK(scene_grey(&s, 0.2, 0.0, 0.265, 0.85));
  UM_CHECK(scene_set(&s, context, &shape, 1));
  s.samples[0].to_observer = um_vec3_unit(um_vec3(1.0, 1.0, 1.0));
  UM_CHECK(scene_run(&s, &lwir));
  um_validate_report_add(report, "Unit cube along its diagonal, projected area", "m^2", sqrt(3.0),
                         intensity(&s, 0, UM_MECHANISM_EMITTED) /
                             (0.85 * um_core_planck_band(lwir.from, lwir.to, 300.0)),
                         FLOAT * sqrt(3.0), CLOSED);
done:
  scene_end(&s);
  return status;
}

/* Nadir face at 765 km (F 0.797, T_b 270 K): reflected Earth over own emission in 8-12 um. Half of
 * the printed digit and of that of F. */
static enum um_status reflected_earth(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double emissivity, kelvin, ratio, digit;
  } row[] = {{"Reflected Earth over emission, Kapton 0.78 at 240 K", 0.78, 240.0, 0.44, 0.005},
             {"Reflected Earth over emission, Kapton 0.62 at 240 K", 0.62, 240.0, 0.96, 0.005},
             {"Reflected Earth over emission, panel 0.85 at 210 K", 0.85, 210.0, 0.65, 0.005},
             {"Reflected Earth over emission, bare Al 0.05 at 280 K", 0.05, 280.0, 12.5, 0.05},
             {"Reflected Earth over emission, OSR 0.80 at 260 K", 0.80, 260.0, 0.25, 0.005}};
  const struct um_geometry_part_spec shape = shape_of(UM_SHAPE_PLATE, 1.0, 1.0);
  for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
    struct scene s = {.context = context};
    enum um_status status;
    UM_CHECK(scene_grey(&s, 0.1, 0.0, 0.265, row[k].emissivity));
    UM_CHECK(scene_set(&s, context, &shape, 1));
    s.environment.brightness_temperature = 270.0;
    for (size_t i = 0; i < um_geometry_mesh(s.geometry)->nsurface; i++) {
      s.temperature[i] = row[k].kelvin;
      s.view_factor[i] = 0.797F;
    }
    UM_CHECK(scene_run(&s, &lwir));
    um_validate_report_add(report, row[k].name, "1", row[k].ratio,
                           intensity(&s, 0, UM_MECHANISM_EARTH) /
                               intensity(&s, 0, UM_MECHANISM_EMITTED),
                           row[k].digit + 0.0005 / 0.797 * row[k].ratio, CLOSED);
  done:
    scene_end(&s);
    UM_TRY(status);
  }
  return UM_OK;
}

/* Kirchhoff: a plate at 300 K before surroundings at 300 K sends out B(300 K), whatever its optics.
 * The Earth is all that it sees: it lies on the ground and looks down. Float cosine at 80 deg: 0.5
 * ulp of 0.17, 9e-8 of it. */
static enum um_status isothermal(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name, *material;
  } row[] = {{"Isothermal surroundings, bare Al, 80 deg", "aluminium_bare"},
             {"Isothermal surroundings, Kapton, 80 deg", "mli_kapton"},
             {"Isothermal surroundings, OSR, 80 deg", "osr"},
             {"Isothermal surroundings, CFRP, 80 deg", "cfrp"}};
  const struct um_geometry_part_spec shape = shape_of(UM_SHAPE_PLATE, 1.0, 1.0);
  for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
    struct scene s = {.context = context};
    char *folder = NULL;
    enum um_status status;
    UM_CHECK(um_materials_library_folder(context, &folder));
    UM_CHECK(um_environment_library_create(context, false, &s.library));
    UM_CHECK(um_materials_library_read_folder(context, s.library, folder));
    s.record = um_materials_library_find(s.library, row[k].material);
    UM_CHECK(scene_set(&s, context, &shape, 1));
    s.environment.brightness_temperature = 300.0;
    s.samples[0].to_observer = polar(80.0 * UM_DEG, 0.3);
    s.samples[0].r = um_vec3(0.0, 0.0, -s.environment.earth_radius * (1.0 + 1e-15));
    for (size_t i = 0; i < um_geometry_mesh(s.geometry)->nsurface; i++) s.view_factor[i] = 1.0F;
    UM_CHECK(scene_run(&s, &lwir));
    um_validate_report_add(
        report, row[k].name, "1", 1.0,
        (intensity(&s, 0, UM_MECHANISM_EARTH) + intensity(&s, 0, UM_MECHANISM_EMITTED)) /
            (cos(80.0 * UM_DEG) * um_core_planck_band(lwir.from, lwir.to, 300.0)),
        FLOAT, "Kirchhoff");
  done:
    um_core_free(context, folder);
    scene_end(&s);
    UM_TRY(status);
  }
  return UM_OK;
}

enum um_status um_validate_bodies(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(sphere(context, report));
  UM_TRY(cylinder(context, report));
  UM_TRY(plates(context, report));
  UM_TRY(hot_array(context, report));
  UM_TRY(cube(context, report));
  UM_TRY(reflected_earth(context, report));
  return isothermal(context, report);
}
