/* umbra material --from-brdf: measured BRDFs as a Lambert term and a lobe, one fit a kind;
 * --from-profile: measured heights as a roughness. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "base/core/number.h"
#include "materials/brdf_fit.h"
#include "materials/profile.h"

#define FITS_MOST 32

/* Every kind that has a roughness, facets with both forms of masking. */
static enum um_status fit_all(struct um_context *context, const struct um_materials_brdf *brdf,
                              size_t surface, double from, struct um_materials_brdf_fit *fit,
                              size_t *count)
{
  *count = 0;
  for (size_t k = 0; k < um_materials_lobe_kind_count(); k++) {
    const struct um_materials_lobe_kind *kind = um_materials_lobe_kind_at(k);
    for (int correlated = 0; kind->rough && !kind->mixed && correlated < (kind->masked ? 2 : 1);
         correlated++) {
      struct um_materials_lobe lobe = {.kind = kind, .correlated = correlated == 1};
      if (*count < FITS_MOST)
        UM_TRY(um_materials_brdf_fit(context, brdf, surface, from, lobe, &fit[(*count)++]));
    }
  }
  return UM_OK;
}

static const char *masking(const struct um_materials_brdf_fit *fit)
{
  if (!fit->lobe.kind->masked) return "-";
  return fit->lobe.correlated ? "height_correlated" : "separable";
}

static void print_fits(const char *surface, const struct um_materials_brdf_fit *fit, size_t count)
{
  size_t best = 0;
  printf("%s: %zu rows\n", surface, fit[0].nrow);
  printf("  %-18s %-18s %10s %10s %10s %9s %9s %10s\n", "kind", "masking", "diffuse", "F", "alpha",
         "rms ln f", "largest", "reflected");
  for (size_t k = 0; k < count; k++) {
    printf("  %-18s %-18s %10.6f %10.6f %10.6f %9.3f %9.3f %10.4f\n", fit[k].lobe.kind->name,
           masking(&fit[k]), fit[k].diffuse, fit[k].specular, fit[k].lobe.alpha, fit[k].rms,
           fit[k].largest, fit[k].albedo);
    if (fit[k].rms < fit[best].rms) best = k;
  }
  const struct um_materials_brdf_fit *b = &fit[best];
  printf("  best, as keys of a record: grey: {vis_reflectance_diffuse: %.6f, specular_reflectance: "
         "%.6f}, lobe: {kind: %s, alpha: %.6f",
         b->diffuse, b->specular, b->lobe.kind->name, b->lobe.alpha);
  if (b->lobe.correlated) printf(", masking: height_correlated");
  printf("}\n");
  if (b->albedo > 1.0)
    printf("  reflects %.1f %% more than it receives at some angle: the rows hold more than energy "
           "allows\n",
           100.0 * (b->albedo - 1.0));
}

static void json_fits(const char *surface, const struct um_materials_brdf_fit *fit, size_t count,
                      bool last)
{
  for (size_t k = 0; k < count; k++) {
    um_core_json_text(stdout, "  {", "surface", surface);
    um_core_json_text(stdout, ", ", "kind", fit[k].lobe.kind->name);
    um_core_json_text(stdout, ", ", "masking", masking(&fit[k]));
    printf(", \"rows\": %zu, \"diffuse\": ", fit[k].nrow);
    um_core_json_number(stdout, fit[k].diffuse);
    um_core_json_field(stdout, ", ", "specular", fit[k].specular);
    um_core_json_field(stdout, ", ", "alpha", fit[k].lobe.alpha);
    um_core_json_field(stdout, ", ", "rms_ln", fit[k].rms);
    um_core_json_field(stdout, ", ", "largest_ln", fit[k].largest);
    um_core_json_field(stdout, ", ", "reflected", fit[k].albedo);
    printf("}%s\n", last && k + 1 == count ? "" : ",");
  }
}

int um_app_materials_fit(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status = UM_OK;
  struct um_materials_brdf *brdf = NULL;
  struct um_materials_brdf_fit fit[FITS_MOST];
  double deg = 0.0;
  size_t count;
  if (options->npositional > 0) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "'%s' beside --from-brdf; accepted: a record, or a file to fit",
                          options->positional[0]);
    goto done;
  }
  if (options->half_angle != NULL &&
      !(um_core_number_parse(options->half_angle, &deg) && deg >= 0.0 && deg < 90.0)) {
    status = um_core_fail(context, UM_ERR_INPUT, "--half-angle: '%s'; accepted: 0 to 90 [deg]",
                          options->half_angle);
    goto done;
  }
  UM_CHECK(um_materials_brdf_read(context, options->from_brdf, &brdf));
  if (options->json) puts("[");
  for (size_t s = 0; s < brdf->nsurface; s++) {
    UM_CHECK(fit_all(context, brdf, s, deg * UM_DEG, fit, &count));
    if (options->json)
      json_fits(brdf->surface[s], fit, count, s + 1 == brdf->nsurface);
    else
      print_fits(brdf->surface[s], fit, count);
  }
  if (options->json) puts("]");
done:
  um_materials_brdf_destroy(context, &brdf);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

int um_app_materials_profile(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status = UM_OK;
  struct um_materials_heights h = {0};
  struct um_materials_slope r;
  if (options->npositional > 0 || options->from_brdf != NULL) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "'%s' beside --from-profile; accepted: one of a record, --from-brdf and "
                          "--from-profile",
                          options->npositional > 0 ? options->positional[0] : "--from-brdf");
    goto done;
  }
  UM_CHECK(um_materials_heights_read(context, options->from_profile, &h));
  UM_CHECK(um_materials_heights_roughness(context, &h, &r));
  if (options->json) {
    um_core_json_field(stdout, "{", "rq_um", r.rq * 1e6);
    um_core_json_field(stdout, ", ", "tau_um", r.tau * 1e6);
    um_core_json_field(stdout, ", ", "alpha", r.alpha);
    um_core_json_field(stdout, ", ", "alpha_gaussian", r.alpha_gaussian);
    um_core_json_field(stdout, ", ", "steps_of_tau", r.samples);
    printf("}\n");
  } else {
    printf("%zu x %zu heights, steps %g x %g um\n", h.nx, h.ny, h.dx * 1e6, h.dy * 1e6);
    printf("  Rq %.6g um, tau %.6g um (%.1f steps)\n", r.rq * 1e6, r.tau * 1e6, r.samples);
    printf("  alpha %.6g as sqrt(2) Rq/tau, which surface: {rq_um, tau_um} gives; %.6g as the "
           "slope of "
           "a Gaussian surface\n",
           r.alpha, r.alpha_gaussian);
    if (r.samples < 3.0) printf("  tau is under 3 steps: slopes shorter than these are not seen\n");
  }
done:
  um_materials_heights_free(context, &h);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
