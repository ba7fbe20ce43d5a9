/* Optical constants of a spectral record: a substrate and what lies on it, checked and kept, as a
 * law that the spectral grid is filled from. Kept, because effects make layers thicker or take them
 * off: such a record is the old one with another grid. */
#include <math.h>
#include <string.h>

#include "base/core/interpolation.h"
#include "materials/bsdf.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

/* Range of the grid of constants that hold beyond their table [m]. */
static const double first_wavelength = 0.2e-6, last_wavelength = 100e-6;
/* Films in which light may be coherent: thickness, and optical thickness that is resolved [m]. */
static const double thickest_film = 5e-6, most_fringes = 25e-6;

/* --- from the file --------------------------------------------------------------------------- */

static enum um_status keep(struct um_context *context, const struct um_schema_list *list,
                           double **out)
{
  UM_TRY(um_core_allocate(context, list->count, sizeof **out, out));
  memcpy(*out, list->items, list->count * sizeof **out);
  return UM_OK;
}

static enum um_status read_constants(struct um_context *context,
                                     const struct um_materials_constants_input *in,
                                     struct um_materials_constants *out)
{
  UM_TRY(um_materials_check_wavelengths(context, &in->at, &in->wavelength_um));
  UM_TRY(um_materials_check_length(context, &in->at, "n", &in->n, &in->wavelength_um));
  UM_TRY(um_materials_check_length(context, &in->at, "k", &in->k, &in->wavelength_um));
  out->count = in->wavelength_um.count;
  out->thickness = in->thickness_um * 1e-6;
  out->coherent = in->coherent || in->passes == 1;
  UM_TRY(keep(context, &in->wavelength_um, &out->wavelength_um));
  UM_TRY(keep(context, &in->n, &out->n));
  return keep(context, &in->k, &out->k);
}

/* What interferes must be resolved: films that lie on each other count together. */
static enum um_status check_films(struct um_context *context,
                                  const struct um_materials_constants_input *const *in,
                                  const struct um_materials_layers *layers)
{
  double together = 0.0;
  for (size_t i = 0; i < layers->count; i++) {
    together = layers->layer[i].coherent ? together + layers->layer[i].thickness : 0.0;
    if (!(together <= thickest_film * (1.0 + 1e-12)))
      return um_document_mark_fail(context, &in[i]->at,
                                   "a coherent film of thickness_um %g has more fringes than are "
                                   "resolved; accepted: at most %g, with the films that lie on it, "
                                   "or coherent: false",
                                   together * 1e6, thickest_film * 1e6);
  }
  return UM_OK;
}

static enum um_status read_stack(struct um_context *context, const struct um_materials_input *in,
                                 struct um_materials_layers *out)
{
  const struct um_materials_constants_input *one[UM_MATERIALS_LAYERS] = {in->sheet};
  const struct um_materials_constants_input *list = in->layers.items;
  size_t n = in->sheet != NULL ? 1 : in->layers.count;
  if (in->sheet != NULL && in->layers.count > 0)
    return um_document_mark_fail(context, &in->sheet->at,
                                 "stands beside layers; accepted: sheet for one, layers for more");
  if (n > UM_MATERIALS_LAYERS)
    return um_document_mark_fail(context, &list[UM_MATERIALS_LAYERS].at,
                                 "there are %zu layers; accepted: at most %d", n,
                                 UM_MATERIALS_LAYERS);
  UM_TRY(read_constants(context, in->substrate, &out->substrate));
  for (size_t i = 0; i < n; i++) {
    if (in->sheet == NULL) one[i] = &list[i];
    out->count = i + 1;
    UM_TRY(read_constants(context, one[i], &out->layer[i]));
    if (in->sheet == NULL && list[i].passes < 0)
      out->layer[i].coherent = out->layer[i].thickness <= thickest_film;
  }
  return check_films(context, one, out);
}

static void constants_free(struct um_context *context, struct um_materials_constants *c)
{
  UM_FREE(context, c->wavelength_um, c->n, c->k);
}

void um_materials_layers_free(struct um_context *context, struct um_materials_layers **layers)
{
  if (*layers == NULL) return;
  constants_free(context, &(*layers)->substrate);
  for (size_t i = 0; i < (*layers)->count; i++) constants_free(context, &(*layers)->layer[i]);
  um_core_free(context, *layers);
  *layers = NULL;
}

/* --- the law --------------------------------------------------------------------------------- */

struct layers_law {
  const struct um_materials_layers *layers;
  size_t count;      /* of layers that are there */
  double factor;     /* of their thickness [1] */
  double wavelength; /* [m] of the constants below */
  double ns, ks;
  struct um_materials_layer layer[UM_MATERIALS_LAYERS];
};

static double constant_at(const struct um_materials_constants *c, double wavelength, double *k)
{
  *k = um_core_interpolate_log(c->wavelength_um, c->k, c->count, wavelength * 1e6);
  return um_core_interpolate(c->wavelength_um, c->n, c->count, wavelength * 1e6);
}

static double layers_reflectance(void *self, double wavelength, double cos_theta, double *diffuse)
{
  struct layers_law *law = self;
  (void)diffuse;
  if (wavelength != law->wavelength) {
    law->wavelength = wavelength;
    law->ns = constant_at(&law->layers->substrate, wavelength, &law->ks);
    for (size_t i = 0; i < law->count; i++) {
      const struct um_materials_constants *c = &law->layers->layer[i];
      struct um_materials_layer *layer = &law->layer[i];
      layer->n = constant_at(c, wavelength, &layer->k);
      layer->thickness = law->factor * c->thickness;
      layer->coherent = c->coherent;
    }
  }
  return um_materials_fresnel_stack(law->layer, law->count, law->ns, law->ks, wavelength,
                                    cos_theta);
}

/* n d of a film [m], its most at wavelengths below ten of them: beyond, the grid is fine enough as
 * it is. */
static double optical_thickness(const struct um_materials_constants *c, double thickness)
{
  double most = 0.0, index = c->n[0];
  for (size_t k = 0; k < c->count; k++) most = fmax(most, c->n[k]);
  for (size_t k = 0; k < c->count && c->wavelength_um[k] * 1e-6 < 10.0 * most * thickness; k++)
    index = fmax(index, c->n[k]);
  return index * thickness;
}

/* The same of what interferes, the most of films that lie on each other [m]. */
static double fringes_of(const struct layers_law *law)
{
  double most = 0.0, together = 0.0;
  for (size_t i = 0; i < law->count; i++) {
    const struct um_materials_constants *c = &law->layers->layer[i];
    together = c->coherent ? together + optical_thickness(c, c->thickness * law->factor) : 0.0;
    most = fmax(most, together);
  }
  return fmin(most, most_fringes);
}

/* Ascending union [m] of wavelengths [um] that are there already and more. */
static size_t merge(double *nodes, size_t n, const struct um_materials_constants *more,
                    double *scratch)
{
  size_t i = 0, j = 0, m = 0;
  while (i < n || j < more->count) {
    bool old = j >= more->count || (i < n && nodes[i] <= more->wavelength_um[j] * 1e-6);
    double next = old ? nodes[i++] : more->wavelength_um[j++] * 1e-6;
    if (m == 0 || next > scratch[m - 1] * (1.0 + 1e-9)) scratch[m++] = next;
  }
  memcpy(nodes, scratch, m * sizeof *nodes);
  return m;
}

/* Fill record->spectrum with its layers `factor` times as thick; 0: without them. */
static enum um_status fill(struct um_context *context, double factor,
                           struct um_materials_record *record)
{
  const struct um_materials_layers *layers = record->layers;
  struct layers_law self = {.layers = layers,
                            .count = factor > 0.0 ? layers->count : 0,
                            .factor = factor,
                            .wavelength = -1.0};
  double *nodes = NULL;
  size_t room = layers->substrate.count, n;
  enum um_status status;
  for (size_t i = 0; i < self.count; i++) room += layers->layer[i].count;
  UM_TRY(um_core_allocate(context, 2 * room, sizeof *nodes, &nodes));
  n = merge(nodes, 0, &layers->substrate, nodes + room);
  for (size_t i = 0; i < self.count; i++) n = merge(nodes, n, &layers->layer[i], nodes + room);
  struct um_materials_law law = {.nodes = nodes,
                                 .nnode = n,
                                 .first = first_wavelength,
                                 .last = last_wavelength,
                                 .fringes = fringes_of(&self),
                                 .angular = true,
                                 .diffuse_fraction = layers->diffuse_fraction,
                                 .absorption_factor = layers->absorption_factor,
                                 .self = &self,
                                 .reflectance = layers_reflectance};
  status = um_materials_spectrum_build(context, record, &law);
  um_core_free(context, nodes);
  return status;
}

enum um_status um_materials_substrate_read(struct um_context *context,
                                           const struct um_materials_input *in,
                                           struct um_materials_record *record)
{
  const struct um_materials_surface_input *surface = in->surface;
  struct um_materials_layers *layers;
  UM_TRY(um_core_allocate(context, 1, sizeof *layers, &record->layers));
  layers = record->layers;
  layers->absorption_factor = 1.0;
  if (surface != NULL && !isnan(surface->diffuse_fraction))
    layers->diffuse_fraction = surface->diffuse_fraction;
  if (surface != NULL && !isnan(surface->absorption_factor))
    layers->absorption_factor = surface->absorption_factor;
  UM_TRY(read_stack(context, in, layers));
  UM_TRY(um_materials_spectral_lobe_read(context, in, layers->diffuse_fraction < 1.0, record));
  return fill(context, 1.0, record);
}

double um_materials_interface_reflectance(const struct um_materials_record *record,
                                          double wavelength, double cosine)
{
  double none = 0.0;
  struct layers_law law = {.layers = record->layers, .factor = 1.0, .wavelength = -1.0};
  if (record->layers == NULL) return NAN;
  law.count = record->layers->count;
  return layers_reflectance(&law, wavelength, cosine, &none);
}

void um_materials_constants_range(const struct um_materials_record *record, double *from,
                                  double *to)
{
  const struct um_materials_layers *layers = record->layers;
  *from = *to = NAN;
  for (size_t i = 0; layers != NULL && i <= layers->count; i++) {
    const struct um_materials_constants *c = i == 0 ? &layers->substrate : &layers->layer[i - 1];
    *from = fmax(*from, c->wavelength_um[0] * 1e-6); /* of NaN and a number the number */
    *to = fmin(*to, c->wavelength_um[c->count - 1] * 1e-6);
  }
}

/* --- with other layers ----------------------------------------------------------------------- */

bool um_materials_has_layers(const struct um_materials_record *record)
{
  return record->layers != NULL && record->layers->count > 0;
}

enum um_status um_materials_record_thickened(struct um_context *context,
                                             const struct um_materials_sun *sun,
                                             const struct um_materials_record *record,
                                             double factor, struct um_materials_record **out)
{
  struct um_materials_record *thickened;
  enum um_status status;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *thickened, &thickened));
  *thickened = *record;
  thickened->context = context;
  thickened->borrows = true;
  memset(&thickened->spectrum, 0, sizeof thickened->spectrum);
  UM_CHECK(fill(context, factor, thickened));
  um_materials_integrals_build(sun, thickened);
  um_materials_mirror_build(sun, thickened);
  *out = thickened;
  thickened = NULL;
done:
  um_materials_record_destroy(&thickened);
  return status;
}
