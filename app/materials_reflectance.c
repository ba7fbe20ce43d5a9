/* umbra material --from-reflectance: a record from what a spectrometer measured against a
 * reference mirror, and, beside --from-profile, from heights: the laboratory of the Flying Laptop
 * paper. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "base/core/number.h"
#include "environment/environment.h"
#include "materials/profile.h"
#include "materials/ratio.h"

struct laboratory {
  const char *name, *reference;
  double angle; /* [deg] */
  struct um_materials_measured_reflectance measured;
  bool rough;
  struct um_materials_slope slope;
};

static void print_list(const char *key, const double *values, size_t n, double scale)
{
  int column = printf("  %s: [", key);
  for (size_t i = 0; i < n; i++) {
    char text[40];
    int length = snprintf(text, sizeof text, "%.6g%s", values != NULL ? values[i] * scale : 0.0,
                          i + 1 < n ? ", " : "]");
    if (column + length > 100) column = printf("\n    ") - 1;
    column += printf("%s", text);
  }
  printf("\n");
}

static void print_record(const struct laboratory *l)
{
  const struct um_materials_measured_reflectance *m = &l->measured;
  printf("name: %s\nsummary: Measured specular reflectance.\ncitation: >-\n", l->name);
  printf("  measured against %s at %g deg, times Fresnel's reflectance of its optical constants "
         "there;\n  taken as the same at every angle\n",
         l->reference, l->angle);
  if (m->nabove > 0)
    printf("# %zu rows reflected more than they received, at most %.4f at %g um: set to 1\n",
           m->nabove, m->largest, m->largest_at * 1e6);
  if (m->wavelength[m->n - 1] < UM_INFRARED_FROM)
    printf("# beyond %g um nothing was measured: add rows, or emittance follows the last one\n",
           m->wavelength[m->n - 1] * 1e6);
  printf("reflectance:\n");
  print_list("wavelength_um", m->wavelength, m->n, 1e6);
  print_list("diffuse", NULL, m->n, 0.0);
  print_list("specular", m->reflectance, m->n, 1.0);
  if (l->rough)
    printf("surface:\n  rq_um: %.6g\n  tau_um: %.6g\n", l->slope.rq * 1e6, l->slope.tau * 1e6);
  else
    printf("lobe: mirror # no roughness was measured: --from-profile\n");
}

static void print_json(const struct laboratory *l)
{
  um_core_json_text(stdout, "{", "reference", l->reference);
  um_core_json_field(stdout, ", ", "angle_deg", l->angle);
  printf(", \"above_one\": %zu, \"largest\": ", l->measured.nabove);
  um_core_json_number(stdout, l->measured.largest);
  if (l->rough) {
    um_core_json_field(stdout, ", ", "rq_um", l->slope.rq * 1e6);
    um_core_json_field(stdout, ", ", "tau_um", l->slope.tau * 1e6);
  }
  printf(", \"rows\": [");
  for (size_t i = 0; i < l->measured.n; i++) {
    um_core_json_field(stdout, i == 0 ? "{" : ", {", "wavelength_um",
                       l->measured.wavelength[i] * 1e6);
    um_core_json_field(stdout, ", ", "reflectance", l->measured.reflectance[i]);
    printf("}");
  }
  printf("]}\n");
}

static enum um_status read_heights(struct um_context *context, const char *path,
                                   struct laboratory *l)
{
  struct um_materials_heights heights = {0};
  UM_TRY(um_materials_heights_read(context, path, &heights));
  enum um_status status = um_materials_heights_roughness(context, &heights, &l->slope);
  um_materials_heights_free(context, &heights);
  l->rough = true;
  return status;
}

static enum um_status check_options(struct um_context *context,
                                    const struct um_app_options *options, struct laboratory *l)
{
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (options->from_brdf != NULL)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--from-brdf beside --from-reflectance; accepted: one of them");
  l->name = options->npositional > 0 ? options->positional[0] : "measured";
  if (l->name[0] == '\0' || l->name[strspn(l->name, letters)] != '\0')
    return um_core_fail(context, UM_ERR_INPUT,
                        "'%.60s' is no name of a record; accepted: letters, digits, _ and -",
                        l->name);
  l->reference = options->reference != NULL ? options->reference : "gold";
  l->angle = 30.0;
  if (options->angle != NULL &&
      !(um_core_number_parse(options->angle, &l->angle) && l->angle >= 0.0 && l->angle < 90.0))
    return um_core_fail(context, UM_ERR_INPUT, "--angle: '%s'; accepted: 0 to below 90 [deg]",
                        options->angle);
  return UM_OK;
}

static enum um_status read_measured(struct um_context *context, const char *path,
                                    const struct um_materials_library *library,
                                    struct laboratory *l)
{
  char near[1024];
  const struct um_materials_record *record = um_materials_library_find(library, l->reference);
  if (record != NULL)
    return um_materials_ratio_read(context, path, record, cos(l->angle * UM_DEG), &l->measured);
  um_materials_library_suggest(library, l->reference, near, sizeof near);
  return um_core_fail(context, UM_ERR_INPUT, "--reference: no material is called '%s'; %s",
                      l->reference, near);
}

int um_app_materials_reflectance(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct laboratory l = {0};
  struct um_materials_library *library = NULL;
  UM_CHECK(check_options(context, options, &l));
  UM_CHECK(um_environment_library_create(context, true, &library));
  UM_CHECK(read_measured(context, options->from_reflectance, library, &l));
  if (options->from_profile != NULL) UM_CHECK(read_heights(context, options->from_profile, &l));
  if (options->json)
    print_json(&l);
  else
    print_record(&l);
done:
  um_materials_ratio_free(context, &l.measured);
  um_materials_library_destroy(&library);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
