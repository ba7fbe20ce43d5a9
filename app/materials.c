/* umbra list materials: what the records give when integrated, beside what catalogues say. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "environment/environment.h"
#include "materials/lobe.h"
#include "materials/measured.h"

static void print_value(const char *format, double value)
{
  if (isnan(value))
    printf("%10s", "-");
  else
    printf(format, value);
}

static void print_row(const struct um_materials_record *r)
{
  struct um_materials_catalogue c = um_materials_catalogue(r);
  printf("%-26s", um_materials_name(r));
  print_value("%10.3f", um_materials_solar_absorptance(r, NULL));
  print_value("%10.3f", c.solar_absorptance);
  print_value("%10.3f", um_materials_emittance(r, NULL, UM_REFERENCE_TEMPERATURE));
  print_value("%10.3f", um_materials_normal_emittance(r, NULL, UM_REFERENCE_TEMPERATURE));
  print_value("%10.3f", c.emittance);
  printf("  %s\n", um_materials_is_grey(r) ? "grey" : "spectral");
}

static void print_one(const struct um_materials_record *r)
{
  struct um_materials_bulk b = um_materials_bulk(r);
  struct um_materials_catalogue c = um_materials_catalogue(r);
  printf("%s: %s\n", um_materials_name(r), um_materials_summary(r));
  printf("  source: %s\n", um_materials_citation(r));
  printf("  solar absorptance %.4f", um_materials_solar_absorptance(r, NULL));
  if (!isnan(c.solar_absorptance))
    printf(" (catalogue %.3f +- %.3f, %s)", c.solar_absorptance, c.solar_absorptance_tolerance,
           c.source);
  printf("\n  emittance at %.0f K: hemispherical %.4f, normal %.4f", UM_REFERENCE_TEMPERATURE,
         um_materials_emittance(r, NULL, UM_REFERENCE_TEMPERATURE),
         um_materials_normal_emittance(r, NULL, UM_REFERENCE_TEMPERATURE));
  if (!isnan(c.emittance))
    printf(" (catalogue %.3f +- %.3f, %s)", c.emittance, c.emittance_tolerance, c.source);
  printf("\n  normal emissivity at 8, 9, 10, 11, 12 um:");
  for (int um = 8; um <= 12; um++)
    printf(" %.3f", um_materials_emissivity(r, NULL, um * 1e-6, 1.0));
  printf("\n  diffuse reflectance at 0.4, 0.5, 0.6, 0.7, 0.8 um:");
  for (int i = 4; i <= 8; i++) printf(" %.3f", um_materials_diffuse_reflectance(r, NULL, i * 1e-7));
  if (um_materials_has_lobe(r)) {
    struct um_materials_lobe lobe = um_materials_lobe(r, NULL);
    printf("\n  lobe: %s", lobe.kind->name);
    if (lobe.kind->rough) printf(", alpha %.4f", lobe.alpha);
    if (lobe.mixture != NULL)
      printf(" (%g of %s, alpha %.4f, and of %s, alpha %.4f)", lobe.mixture->share,
             lobe.mixture->of[0].kind->name, lobe.alpha * lobe.mixture->of[0].ratio,
             lobe.mixture->of[1].kind->name, lobe.alpha * lobe.mixture->of[1].ratio);
    if (lobe.measured != NULL) {
      struct um_materials_measured_found found = um_materials_measured_found(lobe.measured);
      printf(
          ", albedo %.4f at normal incidence, at most %.4f; measured both ways round to %.3g rms "
          "of ln f, at most %.3g",
          um_materials_measured_albedo(lobe.measured, 1.0),
          um_materials_measured_albedo_most(lobe.measured), found.asymmetry, found.largest);
      if (found.left_out > 0.0)
        printf(", %zu incidences that follow from each other to %.3g", found.incidences,
               found.left_out);
    }
    if (um_materials_lobe_is_anisotropic(&lobe)) printf(", across %.4f", lobe.alpha_across);
    if (lobe.correlated) printf(", height-correlated masking");
    printf("; F at 30 deg and 0.4 to 0.8 um:");
    for (int i = 4; i <= 8; i++)
      printf(" %.3f",
             um_materials_specular_reflectance(r, NULL, i * 1e-7, cos(0.5235987755982988)));
  }
  printf("\n");
  if (!isnan(b.density))
    printf("  density %g kg/m3, specific heat %g J/kg/K, conductivity %g W/m/K\n", b.density,
           b.specific_heat, b.conductivity);
  if (!isnan(b.areal_heat_capacity))
    printf("  areal heat capacity %g J/m2/K\n", b.areal_heat_capacity);
}

static void json_record(const struct um_materials_record *r)
{
  um_core_json_text(stdout, "{", "name", um_materials_name(r));
  um_core_json_text(stdout, ", ", "summary", um_materials_summary(r));
  um_core_json_text(stdout, ", ", "source", um_materials_citation(r));
  um_core_json_field(stdout, ", ", "solar_absorptance", um_materials_solar_absorptance(r, NULL));
  um_core_json_field(stdout, ", ", "emittance",
                     um_materials_emittance(r, NULL, UM_REFERENCE_TEMPERATURE));
  um_core_json_field(stdout, ", ", "normal_emittance",
                     um_materials_normal_emittance(r, NULL, UM_REFERENCE_TEMPERATURE));
  um_core_json_field(stdout, ", ", "catalogue_solar_absorptance",
                     um_materials_catalogue(r).solar_absorptance);
  um_core_json_field(stdout, ", ", "catalogue_emittance", um_materials_catalogue(r).emittance);
  printf(", \"grey\": %s}", um_materials_is_grey(r) ? "true" : "false");
}

static void print_json(const struct um_materials_library *library)
{
  puts("[");
  size_t n = um_materials_library_count(library);
  for (size_t i = 0; i < n; i++) {
    printf("  ");
    json_record(um_materials_library_at(library, i));
    printf("%s\n", i + 1 < n ? "," : "");
  }
  puts("]");
}

static void print_table(const struct um_materials_library *library)
{
  printf("%-26s%10s%10s%10s%10s%10s\n", "", "solar abs.", "catalogue", "emittance", "normal",
         "catalogue");
  for (size_t i = 0; i < um_materials_library_count(library); i++)
    print_row(um_materials_library_at(library, i));
  printf("Solar absorptance over ASTM E490 at normal incidence; emittance hemispherical and normal "
         "at %.0f K.\n",
         UM_REFERENCE_TEMPERATURE);
}

int um_app_materials(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_materials_library *library = NULL;
  UM_CHECK(um_environment_library_create(context, true, &library));
  if (options->npositional == 1) {
    const char *name = options->positional[0];
    const struct um_materials_record *r = um_materials_library_find(library, name);
    char near[1024];
    if (r == NULL) {
      um_materials_library_suggest(library, name, near, sizeof near);
      status = um_core_fail(context, UM_ERR_INPUT, "no material is called '%s'; %s", name, near);
      goto done;
    }
    if (options->json) {
      json_record(r);
      printf("\n");
    } else {
      print_one(r);
    }
  } else if (options->json) {
    print_json(library);
  } else {
    print_table(library);
  }
done:
  um_materials_library_destroy(&library);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
