/* Reflectance tables of a spectral record, checked, as a law that the spectral grid is filled from;
 * checks that they share with optical constants (layers.c). */
#include <math.h>

#include "base/core/interpolation.h"
#include "materials/bsdf.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

static const double *numbers(const struct um_schema_list *list) { return list->items; }

enum um_status um_materials_check_wavelengths(struct um_context *context, const struct um_mark *at,
                                              const struct um_schema_list *wavelength)
{
  const double *x = numbers(wavelength);
  if (wavelength->count < 2)
    return um_document_mark_fail(context, at,
                                 "wavelength_um has %zu values; accepted: at least 2, ascending",
                                 wavelength->count);
  for (size_t i = 1; i < wavelength->count; i++)
    if (!(x[i] > x[i - 1]))
      return um_document_mark_fail(context, at,
                                   "wavelength_um: %g follows %g [um]; accepted: ascending values",
                                   x[i], x[i - 1]);
  return UM_OK;
}

enum um_status um_materials_check_length(struct um_context *context, const struct um_mark *at,
                                         const char *key, const struct um_schema_list *values,
                                         const struct um_schema_list *wavelength)
{
  if (values->count == wavelength->count) return UM_OK;
  return um_document_mark_fail(context, at,
                               "%s has %zu values; accepted: %zu, one per wavelength_um", key,
                               values->count, wavelength->count);
}

static enum um_status check_reflectance(struct um_context *context,
                                        const struct um_materials_reflectance_input *r,
                                        bool measured)
{
  UM_TRY(um_materials_check_wavelengths(context, &r->at, &r->wavelength_um));
  UM_TRY(um_materials_check_length(context, &r->at, "diffuse", &r->diffuse, &r->wavelength_um));
  if (r->specular.count == 0) return UM_OK;
  UM_TRY(um_materials_check_length(context, &r->at, "specular", &r->specular, &r->wavelength_um));
  for (size_t i = 0; i < r->diffuse.count && !measured; i++) { /* held to its albedo when read */
    double sum = numbers(&r->diffuse)[i] + numbers(&r->specular)[i];
    if (!(sum <= 1.0 + 1e-12))
      return um_document_mark_fail(
          context, &r->at, "diffuse + specular is %g at wavelength_um %g; accepted: at most 1", sum,
          numbers(&r->wavelength_um)[i]);
  }
  return UM_OK;
}

enum um_status um_materials_spectral_lobe_read(struct um_context *context,
                                               const struct um_materials_input *in, bool needed,
                                               struct um_materials_record *record)
{
  const struct um_materials_surface_input *s = in->surface;
  double alpha = NAN;
  if (!needed) return UM_OK;
  if (s != NULL && !isnan(s->alpha))
    alpha = s->alpha;
  else if (s != NULL && !isnan(s->rq_um) && !isnan(s->tau_um))
    alpha = um_materials_roughness_alpha(s->rq_um, s->tau_um);
  else if (in->lobe == NULL)
    return um_document_mark_fail(context, s != NULL ? &s->at : &in->at,
                                 "the roughness of the specular part is missing; accepted: "
                                 "surface: {beckmann_alpha} or surface: {rq_um, tau_um}");
  if (alpha > 1.5)
    return um_document_mark_fail(
        context, &s->at, "rq_um and tau_um give a Beckmann alpha of %g; accepted: at most 1.5",
        alpha);
  return um_materials_lobe_read(context, in, alpha, record);
}

struct table_law {
  const struct um_materials_reflectance_input *in;
  const double *wavelength; /* [m] */
};

static double table_reflectance(void *self, double wavelength, double cos_theta, double *diffuse)
{
  const struct table_law *law = self;
  size_t n = law->in->wavelength_um.count;
  (void)cos_theta;
  *diffuse = um_core_interpolate(law->wavelength, numbers(&law->in->diffuse), n, wavelength);
  if (law->in->specular.count == 0) return 0.0;
  return um_core_interpolate(law->wavelength, numbers(&law->in->specular), n, wavelength);
}

enum um_status um_materials_reflectance_read(struct um_context *context,
                                             const struct um_materials_input *in,
                                             struct um_materials_record *record)
{
  const struct um_materials_reflectance_input *r = in->reflectance;
  bool measured = in->lobe != NULL && um_materials_lobe_kind_at((size_t)in->lobe->kind)->absorbs;
  UM_TRY(check_reflectance(context, r, measured));
  if (in->surface != NULL &&
      (!isnan(in->surface->diffuse_fraction) || !isnan(in->surface->absorption_factor)))
    return um_document_mark_fail(
        context, &in->surface->at,
        "diffuse_fraction and absorption_factor belong to a substrate; "
        "accepted beside a reflectance table: beckmann_alpha, or rq_um and tau_um");
  bool lobe = false;
  for (size_t i = 0; i < r->specular.count; i++) lobe = lobe || numbers(&r->specular)[i] > 0.0;
  UM_TRY(um_materials_spectral_lobe_read(context, in, lobe, record));

  double *nodes;
  UM_TRY(um_core_allocate(context, r->wavelength_um.count, sizeof *nodes, &nodes));
  size_t n = r->wavelength_um.count;
  for (size_t i = 0; i < n; i++) nodes[i] = numbers(&r->wavelength_um)[i] * 1e-6;
  struct table_law self = {.in = r, .wavelength = nodes};
  struct um_materials_law law = {.nodes = nodes,
                                 .nnode = n,
                                 .first = nodes[0],
                                 .last = nodes[n - 1],
                                 .self = &self,
                                 .reflectance = table_reflectance};
  enum um_status status = um_materials_spectrum_build(context, record, &law);
  um_core_free(context, nodes);
  return status;
}
