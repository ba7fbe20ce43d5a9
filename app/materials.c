/* umbra list materials: what the records give when integrated, beside what catalogues say. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "environment/environment.h"
#include "materials/lobe.h"
#include "materials/measured.h"
#include "output/spectrum_plot.h"

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
  struct um_materials_measured_range m = um_materials_measured_range(r);
  if (isnan(m.from))
    printf("  %s\n", um_materials_is_grey(r) ? "grey" : "spectral");
  else
    printf("  measured %.4g to %.4g um\n", m.from * 1e6, m.to * 1e6);
}

static void print_measured(const struct um_materials_record *r)
{
  struct um_materials_measured_range m = um_materials_measured_range(r);
  if (isnan(m.from))
    printf("  not measured: no range of the record's optics is claimed to be\n");
  else
    printf("  measured from %.4g to %.4g um, constant outside: %.2f %% of sunlight, %.1f %% of "
           "heat at "
           "%.0f K\n",
           m.from * 1e6, m.to * 1e6, 100.0 * m.solar_outside, 100.0 * m.heat_outside,
           UM_REFERENCE_TEMPERATURE);
}

static void print_ageing(const struct um_materials_record *r)
{
  for (size_t i = 0; i < um_materials_ageing_count(r); i++) {
    struct um_materials_ageing a = um_materials_ageing_at(r, i);
    printf("  ageing, after %s:", a.after);
    if (!isnan(a.solar_absorptance))
      printf(" solar absorptance %+.3g (--with solar_absorptance:%s,shift=%g)", a.solar_absorptance,
             um_materials_name(r), a.solar_absorptance);
    if (!isnan(a.emittance)) printf(" emittance %+.3g", a.emittance);
    printf(" (%s)\n", a.source);
  }
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
  printf("\n");
  print_measured(r);
  print_ageing(r);
  printf("  normal emissivity at 8, 9, 10, 11, 12 um:");
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

static void json_ageing(const struct um_materials_record *r)
{
  printf(", \"ageing\": [");
  for (size_t i = 0; i < um_materials_ageing_count(r); i++) {
    struct um_materials_ageing a = um_materials_ageing_at(r, i);
    um_core_json_text(stdout, i == 0 ? "{" : ", {", "after", a.after);
    um_core_json_field(stdout, ", ", "solar_absorptance_change", a.solar_absorptance);
    um_core_json_field(stdout, ", ", "emittance_change", a.emittance);
    um_core_json_text(stdout, ", ", "source", a.source);
    printf("}");
  }
  printf("]");
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
  um_core_json_field(stdout, ", ", "catalogue_solar_absorptance_tolerance",
                     um_materials_catalogue(r).solar_absorptance_tolerance);
  um_core_json_field(stdout, ", ", "catalogue_emittance_tolerance",
                     um_materials_catalogue(r).emittance_tolerance);
  um_core_json_text(stdout, ", ", "catalogue_source", um_materials_catalogue(r).source);
  printf(", \"catalogue_emittance_is_normal\": %s",
         um_materials_catalogue(r).emittance_is_normal ? "true" : "false");
  struct um_materials_measured_range m = um_materials_measured_range(r);
  um_core_json_field(stdout, ", ", "measured_from_um", m.from * 1e6);
  um_core_json_field(stdout, ", ", "measured_to_um", m.to * 1e6);
  um_core_json_field(stdout, ", ", "solar_outside", m.solar_outside);
  um_core_json_field(stdout, ", ", "heat_outside", m.heat_outside);
  json_ageing(r);
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

/* --out: spectra of one record or of all. */
static enum um_status write_spectra(struct um_context *context,
                                    const struct um_app_options *options,
                                    const struct um_materials_library *library,
                                    const struct um_materials_record *one)
{
  enum um_status status;
  size_t n = one != NULL ? 1 : um_materials_library_count(library);
  const struct um_materials_record **record = NULL;
  struct um_core_folder *folder = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof(void *), &record));
  for (size_t i = 0; i < n; i++)
    record[i] = one != NULL ? one : um_materials_library_at(library, i);
  UM_CHECK(um_core_folder_begin(context, options->out, options->force, &folder));
  UM_CHECK(um_output_spectra(context, record, n, !options->no_plots, folder));
  status = um_core_folder_commit(context, &folder);
done:
  um_core_folder_abort(&folder);
  um_core_free(context, record);
  return status;
}

/* The library with the record of that name alone; other names are told where there is none. */
static enum um_status open_one(struct um_context *context, const char *name,
                               struct um_materials_library **library,
                               const struct um_materials_record **out)
{
  char near[1024], *folder = NULL;
  UM_TRY(um_environment_library_create(context, false, library));
  UM_TRY(um_materials_library_folder(context, &folder));
  enum um_status status = um_materials_library_offer_folder(context, *library, folder);
  um_core_free(context, folder);
  UM_TRY(status);
  UM_TRY(um_materials_library_want(context, *library, name, out));
  if (*out != NULL) return UM_OK;
  um_materials_library_suggest(*library, name, near, sizeof near);
  return um_core_fail(context, UM_ERR_INPUT, "no material is called '%s'; %s", name, near);
}

int um_app_materials(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_materials_library *library = NULL;
  const struct um_materials_record *r = NULL;
  if (options->npositional == 1)
    UM_CHECK(open_one(context, options->positional[0], &library, &r));
  else
    UM_CHECK(um_environment_library_create(context, true, &library));
  if (r != NULL && options->json) {
    json_record(r);
    printf("\n");
  } else if (r != NULL) {
    print_one(r);
  } else if (options->json) {
    print_json(library);
  } else {
    print_table(library);
  }
  if (options->out != NULL) UM_CHECK(write_spectra(context, options, library, r));
  if (options->out != NULL && !options->json) um_app_tell_results(options->out);
  status = UM_OK;
done:
  um_materials_library_destroy(&library);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
