/* The optical description of a spectral record: its tables, checked, as a law that the spectral
 * grid is filled from. */
#include <math.h>

#include "core/interpolation.h"
#include "materials/bsdf.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

/* Range of the grid of constants that hold beyond their table [m]. */
static const double first_wavelength = 0.2e-6, last_wavelength = 100e-6;
/* Films in which light may be coherent: thickness, and optical thickness that is resolved [m]. */
static const double thickest_film = 5e-6, most_fringes = 25e-6;

static const double *numbers(const struct um_schema_list *list) { return list->items; }

static enum um_status check_wavelengths(struct um_context *context, const struct um_mark *at,
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

static enum um_status check_length(struct um_context *context, const struct um_mark *at,
                                   const char *key, const struct um_schema_list *values,
                                   const struct um_schema_list *wavelength)
{
  if (values->count == wavelength->count) return UM_OK;
  return um_document_mark_fail(context, at,
                               "%s has %zu values; accepted: %zu, one per wavelength_um", key,
                               values->count, wavelength->count);
}

static enum um_status check_constants(struct um_context *context,
                                      const struct um_materials_constants_input *c)
{
  UM_TRY(check_wavelengths(context, &c->at, &c->wavelength_um));
  UM_TRY(check_length(context, &c->at, "n", &c->n, &c->wavelength_um));
  return check_length(context, &c->at, "k", &c->k, &c->wavelength_um);
}

static enum um_status check_reflectance(struct um_context *context,
                                        const struct um_materials_reflectance_input *r)
{
  UM_TRY(check_wavelengths(context, &r->at, &r->wavelength_um));
  UM_TRY(check_length(context, &r->at, "diffuse", &r->diffuse, &r->wavelength_um));
  if (r->specular.count == 0) return UM_OK;
  UM_TRY(check_length(context, &r->at, "specular", &r->specular, &r->wavelength_um));
  for (size_t i = 0; i < r->diffuse.count; i++) {
    double sum = numbers(&r->diffuse)[i] + numbers(&r->specular)[i];
    if (!(sum <= 1.0 + 1e-12))
      return um_document_mark_fail(
          context, &r->at, "diffuse + specular is %g at wavelength_um %g; accepted: at most 1", sum,
          numbers(&r->wavelength_um)[i]);
  }
  return UM_OK;
}

/* Lobe of a spectral record; `needed` when it has a specular part. */
static enum um_status read_lobe(struct um_context *context, const struct um_materials_input *in,
                                bool needed, struct um_materials_record *record)
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

struct interface_law {
  const struct um_materials_constants_input *substrate, *sheet; /* sheet may be NULL */
  double wavelength;                                            /* [m] of the constants below */
  double n, k, ns, ks;
};

static double constant_at(const struct um_materials_constants_input *in, double wavelength,
                          double *k)
{
  const double *x = numbers(&in->wavelength_um);
  size_t count = in->wavelength_um.count;
  *k = um_core_interpolate_log(x, numbers(&in->k), count, wavelength * 1e6);
  return um_core_interpolate(x, numbers(&in->n), count, wavelength * 1e6);
}

static double interface_reflectance(void *self, double wavelength, double cos_theta,
                                    double *diffuse)
{
  struct interface_law *law = self;
  (void)diffuse;
  if (wavelength != law->wavelength) {
    law->wavelength = wavelength;
    law->ns = constant_at(law->substrate, wavelength, &law->ks);
    if (law->sheet != NULL) law->n = constant_at(law->sheet, wavelength, &law->k);
  }
  if (law->sheet == NULL) return um_materials_fresnel(law->ns, law->ks, cos_theta);
  double thickness = law->sheet->thickness_um * 1e-6;
  return (law->sheet->coherent ? um_materials_fresnel_film : um_materials_fresnel_sheet)(
      law->n, law->k, thickness, law->ns, law->ks, wavelength, cos_theta);
}

/* n d of a film that interferes [m]; 0 for a sheet, or none. */
static enum um_status film_fringes(struct um_context *context,
                                   const struct um_materials_constants_input *sheet, double *out)
{
  *out = 0.0;
  if (sheet == NULL || !sheet->coherent) return UM_OK;
  if (!(sheet->thickness_um <= thickest_film * 1e6))
    return um_document_mark_fail(context, &sheet->at,
                                 "a coherent film of thickness_um %g has more fringes than are "
                                 "resolved; accepted: at most %g, or coherent: false",
                                 sheet->thickness_um, thickest_film * 1e6);
  for (size_t i = 0; i < sheet->n.count; i++)
    *out = fmax(*out, numbers(&sheet->n)[i] * sheet->thickness_um * 1e-6);
  *out = fmin(*out, most_fringes);
  return UM_OK;
}

/* Ascending union of two wavelength lists [um], in metres. */
static size_t merge(const struct um_schema_list *a, const struct um_schema_list *b, double *out)
{
  size_t i = 0, j = 0, n = 0, nb = b != NULL ? b->count : 0;
  while (i < a->count || j < nb) {
    bool from_a = j >= nb || (i < a->count && numbers(a)[i] <= numbers(b)[j]);
    double next = (from_a ? numbers(a)[i++] : numbers(b)[j++]) * 1e-6;
    if (n == 0 || next > out[n - 1] * (1.0 + 1e-9)) out[n++] = next;
  }
  return n;
}

enum um_status um_materials_reflectance_read(struct um_context *context,
                                             const struct um_materials_input *in,
                                             struct um_materials_record *record)
{
  const struct um_materials_reflectance_input *r = in->reflectance;
  UM_TRY(check_reflectance(context, r));
  if (in->surface != NULL &&
      (!isnan(in->surface->diffuse_fraction) || !isnan(in->surface->absorption_factor)))
    return um_document_mark_fail(
        context, &in->surface->at,
        "diffuse_fraction and absorption_factor belong to a substrate; "
        "accepted beside a reflectance table: beckmann_alpha, or rq_um and tau_um");
  bool lobe = false;
  for (size_t i = 0; i < r->specular.count; i++) lobe = lobe || numbers(&r->specular)[i] > 0.0;
  UM_TRY(read_lobe(context, in, lobe, record));

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

enum um_status um_materials_substrate_read(struct um_context *context,
                                           const struct um_materials_input *in,
                                           struct um_materials_record *record)
{
  const struct um_materials_constants_input *base = in->substrate, *sheet = in->sheet;
  UM_TRY(check_constants(context, base));
  if (sheet != NULL) UM_TRY(check_constants(context, sheet));
  double fraction = 0.0, factor = 1.0;
  if (in->surface != NULL && !isnan(in->surface->diffuse_fraction))
    fraction = in->surface->diffuse_fraction;
  if (in->surface != NULL && !isnan(in->surface->absorption_factor))
    factor = in->surface->absorption_factor;
  UM_TRY(read_lobe(context, in, fraction < 1.0, record));
  double fringes;
  UM_TRY(film_fringes(context, sheet, &fringes));

  double *nodes;
  size_t room = base->wavelength_um.count + (sheet != NULL ? sheet->wavelength_um.count : 0);
  UM_TRY(um_core_allocate(context, room, sizeof *nodes, &nodes));
  struct interface_law self = {.substrate = base, .sheet = sheet, .wavelength = -1.0};
  struct um_materials_law law = {
      .nodes = nodes,
      .nnode = merge(&base->wavelength_um, sheet != NULL ? &sheet->wavelength_um : NULL, nodes),
      .first = first_wavelength,
      .last = last_wavelength,
      .fringes = fringes,
      .angular = true,
      .diffuse_fraction = fraction,
      .absorption_factor = factor,
      .self = &self,
      .reflectance = interface_reflectance};
  enum um_status status = um_materials_spectrum_build(context, record, &law);
  um_core_free(context, nodes);
  return status;
}
