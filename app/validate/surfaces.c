/* Surfaces: Fresnel, emissivity, Beckmann facets, roughness, sheets of the material library.
 *
 * Sources: Born & Wolf 1.5 (Fresnel); Walter et al. 2007 and Heitz 2014 (Beckmann, Smith); Table 1
 * of the Flying Laptop paper, AMOS 2024; refractiveindex.info (optical constants). */
#include <math.h>

#include "app/validate/cases_impl.h"
#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/environment.h"
#include "materials/bsdf.h"
#include "materials/materials.h"

#define FRESNEL "Fresnel's equations"
#define SMITH   "Walter 2007; Heitz 2014"

/* Unpolarised reflectance, six decimals. */
static void fresnel(struct um_validate_report *report)
{
#define FOUR(what) what ", 0 deg", what ", 30 deg", what ", 60 deg", what ", 80 deg"
  static const double angle[4] = {0.0, 30.0, 60.0, 80.0};
  static const struct {
    double n, k, expected[4];
    const char *name[4];
  } row[] = {
      {0.958, 6.69, {0.921136, 0.920467, 0.906922, 0.867856}, {FOUR("Fresnel, Al at 550 nm")}},
      {25.3, 89.8, {0.988442, 0.988324, 0.985613, 0.966713}, {FOUR("Fresnel, Al at 10 um")}},
      {0.42, 2.35, {0.777156, 0.776828, 0.781203, 0.861470}, {FOUR("Fresnel, Au at 550 nm")}},
      {1.5, 0.0, {0.040000, 0.041523, 0.089187, 0.387704}, {FOUR("Fresnel, n 1.5")}},
      {1.7, 0.0, {0.067215, 0.069023, 0.120335, 0.411715}, {FOUR("Fresnel, n 1.7")}}};
#undef FOUR
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    for (int j = 0; j < 4; j++)
      um_validate_report_add(report, row[i].name[j], "1", row[i].expected[j],
                             um_materials_fresnel(row[i].n, row[i].k, cos(angle[j] * UM_DEG)),
                             0.6e-6, FRESNEL);
}

/* 2 int (1 - R) c dc by 4000 midpoints in u, c = u^2: 1e-6, as the printed digits. */
static void hemispherical(struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double n, k, expected;
  } row[] = {{"Hemispherical emissivity, n 1.5", 1.5, 0.0, 0.908222},
             {"Hemispherical emissivity, n 1.7", 1.7, 0.0, 0.879680},
             {"Hemispherical emissivity, n 2", 2.0, 0.0, 0.839403},
             {"Hemispherical emissivity, Al at 10 um", 25.3, 89.8, 0.015037}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double sum = 0.0;
    for (int j = 0; j < 4000; j++) {
      double u = (j + 0.5) / 4000.0;
      sum += 4.0 * u * u * u / 4000.0 * (1.0 - um_materials_fresnel(row[i].n, row[i].k, u * u));
    }
    um_validate_report_add(report, row[i].name, "1", row[i].expected, sum, 1.5e-6, FRESNEL);
  }
}

/* Rounding of Rq and tau in the paper allows 0.8 %. */
static void roughness(struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double rq, tau, alpha; /* [um], [um], [1] */
  } row[] = {{"Roughness alpha, MLI", 2.93, 140.0, 0.0295},
             {"Roughness alpha, CFRP", 8.63, 37.2, 0.326},
             {"Roughness alpha, solar cell", 0.341, 1.814, 0.265},
             {"Roughness alpha, aluminium", 5.33, 14.7, 0.513}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    um_validate_report_add(report, row[i].name, "1", row[i].alpha,
                           um_materials_roughness_alpha(row[i].rq, row[i].tau),
                           0.008 * row[i].alpha, "Flying Laptop, Table 1");
}

/* Weak furnace: the facets visible from o project to cos_o, int D G1 max(o.h, 0) dw = cos_o. */
static double weak_furnace(double alpha, double cos_o)
{
  enum { POLAR = 400, AROUND = 100 };
  double sin_o = sqrt(1.0 - cos_o * cos_o), sum = 0.0;
  double range = fmin(0.5 * UM_PI, atan(6.0 * alpha));
  for (int a = 0; a < POLAR; a++) {
    double t = range * (a + 0.5) / POLAR, around = 0.0;
    for (int b = 0; b < AROUND; b++)
      around += fmax(cos_o * cos(t) + sin_o * sin(t) * cos(UM_PI * (b + 0.5) / AROUND), 0.0);
    sum += um_materials_beckmann_distribution(alpha, cos(t)) * sin(t) * around;
  }
  return 2.0 * sum * (range / POLAR) * (UM_PI / AROUND) *
         um_materials_beckmann_masking(alpha, cos_o) / cos_o;
}

/* Seven digits of D and of the peaks, six decimals of G1. White furnace: the table's own grid is
 * good to 1.5e-4, so 2e-4; weak furnace: 1e-4, its quadrature. */
static void beckmann(struct um_validate_report *report)
{
#define NAMES(a)                                                                                   \
  {                                                                                                \
    "Beckmann " #a ", D(0)", "Beckmann " #a ", masking at 60 deg",                                 \
        "Beckmann " #a ", masking at 75 deg", "Beckmann " #a ", masking at 85 deg",                \
        "Beckmann " #a ", peak at 0 deg", "Beckmann " #a ", peak at 30 deg",                       \
        "Beckmann " #a ", peak at 60 deg", "Beckmann " #a ", white furnace at 0 deg",              \
        "Beckmann " #a ", white furnace at 30 deg", "Beckmann " #a ", white furnace at 60 deg",    \
        "Beckmann " #a ", white furnace at 75 deg", "Beckmann " #a ", weak furnace at 0 deg",      \
        "Beckmann " #a ", weak furnace at 60 deg"                                                  \
  }
  static const struct {
    double alpha, expected[11];
    const char *name[13];
  } row[] = {{0.0296,
              {363.3011, 1.0, 1.0, 0.999999, 90.8253, 121.1004, 363.3011, 1.0, 1.0, 1.0, 1.0},
              NAMES(0.0296)},
             {0.265,
              {4.532715, 0.999907, 0.976565, 0.691596, 1.133179, 1.510905, 4.531873, 0.999986,
               0.996818, 0.939120, 0.903363},
              NAMES(0.265)},
             {0.326,
              {2.995125, 0.999212, 0.950472, 0.615025, 0.748781, 0.998375, 2.990405, 0.999155,
               0.985204, 0.912995, 0.900835},
              NAMES(0.326)},
             {0.513,
              {1.209527, 0.985324, 0.846687, 0.454138, 0.302382, 0.403175, 1.174286, 0.933629,
               0.894827, 0.866644, 0.899773},
              NAMES(0.513)}};
#undef NAMES
  static const double masking[3] = {60.0, 75.0, 85.0}, peak[3] = {0.0, 30.0, 60.0};
  static const double furnace[4] = {0.0, 30.0, 60.0, 75.0};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double a = row[i].alpha, digit = a < 0.1 ? 0.51e-4 : 0.51e-6;
    const double *e = row[i].expected;
    const char *const *name = row[i].name;
    um_validate_report_add(report, name[0], "1/sr", e[0],
                           um_materials_beckmann_distribution(a, 1.0), digit, SMITH);
    for (int j = 0; j < 3; j++)
      um_validate_report_add(report, name[1 + j], "1", e[1 + j],
                             um_materials_beckmann_masking(a, cos(masking[j] * UM_DEG)), 0.6e-6,
                             SMITH);
    for (int j = 0; j < 3; j++) {
      double c = cos(peak[j] * UM_DEG);
      um_validate_report_add(report, name[4 + j], "1/sr", e[4 + j],
                             um_materials_beckmann_lobe(a, 1.0, c, c), digit, SMITH);
    }
    for (int j = 0; j < 4; j++)
      um_validate_report_add(report, name[7 + j], "1", e[7 + j],
                             um_materials_beckmann_albedo(a, cos(furnace[j] * UM_DEG)), 2e-4,
                             SMITH);
    for (int j = 0; j < 2; j++)
      um_validate_report_add(report, name[11 + j], "1", 1.0,
                             weak_furnace(a, cos(60.0 * j * UM_DEG)), 1e-4, "Heitz 2014, eq. 22");
  }
}

/* Normal emittance over a range at 300 K, midpoints in log wavelength. */
static double normal_emittance(const struct um_materials_record *record, double from, double to)
{
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < 5000; i++) {
    double l = from * pow(to / from, (i + 0.5) / 5000.0);
    double w = um_core_planck_radiance(l, 300.0) * l;
    sum += w * um_materials_emissivity(record, NULL, l, 1.0);
    weights += w;
  }
  return sum / weights;
}

/* Incoherent sheets by the full tables of constants. Re-gridding costs up to 0.005, and the records
 * scatter 5 % (Kapton) and 2 % (silica) of the reflectance, a hemispherical mean in place of the
 * normal one: up to 0.006 and 0.004. */
static enum um_status sheets(struct um_context *context, struct um_validate_report *report)
{
  static const struct {
    const char *name, *material;
    double from, to, expected, tolerance; /* [m], [m] */
  } row[] = {{"25.4 um Kapton on Al, normal, 2-20 um", "mli_kapton", 2e-6, 20e-6, 0.685, 0.010},
             {"25.4 um Kapton on Al, normal, 8-13 um", "mli_kapton", 8e-6, 13e-6, 0.709, 0.010},
             {"150 um silica on Ag, normal, 2-20 um", "osr", 2e-6, 20e-6, 0.865, 0.008},
             {"150 um silica on Ag, normal, 8-13 um", "osr", 8e-6, 13e-6, 0.770, 0.008}};
  struct um_materials_library *library = NULL;
  enum um_status status;
  UM_CHECK(um_environment_library_create(context, true, &library));
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    const struct um_materials_record *record = um_materials_library_find(library, row[i].material);
    um_validate_report_add(report, row[i].name, "1", row[i].expected,
                           record == NULL ? NAN : normal_emittance(record, row[i].from, row[i].to),
                           row[i].tolerance, "refractiveindex.info");
  }
done:
  um_materials_library_destroy(&library);
  return status;
}

enum um_status um_validate_surfaces(struct um_context *context, struct um_validate_report *report)
{
  fresnel(report);
  hemispherical(report);
  roughness(report);
  beckmann(report);
  return sheets(context, report);
}
