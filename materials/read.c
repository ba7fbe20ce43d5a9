/* From a file to a record: checks that the schema table cannot express, and units to SI. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/document/schema.h"
#include "materials/measured.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

#define ROUNDING 1e-9 /* of numbers given in full [1] */

static enum um_status check_name(struct um_context *context, const struct um_materials_input *in)
{
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (in->name[0] != '\0' && in->name[strspn(in->name, letters)] == '\0') return UM_OK;
  return um_document_mark_fail(context, &in->at,
                               "name: '%.60s' is not accepted; accepted: letters, digits, _ and -",
                               in->name);
}

static enum um_status read_bands(struct um_context *context,
                                 const struct um_materials_grey_input *in,
                                 struct um_materials_grey *out)
{
  const struct um_materials_band_input *bands = in->bands.items;
  UM_TRY(um_core_allocate(context, in->bands.count, sizeof *out->bands, &out->bands));
  for (size_t i = 0; i < in->bands.count; i++) {
    const struct um_materials_band_input *b = &bands[i];
    if (!(b->from_um < b->to_um))
      return um_document_mark_fail(context, &b->at, "to_um %g is not above from_um %g [um]",
                                   b->to_um, b->from_um);
    if (i > 0 && !(b->from_um >= bands[i - 1].to_um))
      return um_document_mark_fail(context, &b->at,
                                   "from_um %g lies in the band before, which ends at %g [um]; "
                                   "accepted: ascending bands without overlap",
                                   b->from_um, bands[i - 1].to_um);
    out->bands[i] = (struct um_materials_band){b->from_um * 1e-6, b->to_um * 1e-6, b->value};
  }
  out->nband = in->bands.count;
  return UM_OK;
}

/* Share of the Sun's energy in the visible [1]. */
static double visible_share(const struct um_materials_sun *sun)
{
  double sum = 0.0;
  for (size_t i = 0; i < UM_MATERIALS_SUN; i++)
    if (sun->wavelength[i] >= 0.38e-6 && sun->wavelength[i] <= 0.78e-6) sum += sun->share[i];
  return sum;
}

/* What is not reflected is absorbed. A record may state its solar absorptance beside reflectances
 * that hold in the visible alone: with the visible's share s of sunlight and R in it, the
 * absorptance lies between s (1 - R), when nothing else is absorbed, and 1 - s R, when everything
 * else is. Outside is impossible; inside, but not 1 - R, is said with both numbers. */
static enum um_status check_balance(struct um_context *context, const struct um_materials_sun *sun,
                                    const struct um_materials_input *record,
                                    const struct um_materials_grey *g)
{
  const struct um_materials_grey_input *in = record->grey;
  double reflected = g->diffuse + g->specular, left = 1.0 - reflected, s = visible_share(sun);
  double least = s * left, most = 1.0 - s * reflected;
  if (!(g->solar_absorptance >= least - ROUNDING && g->solar_absorptance <= most + ROUNDING))
    return um_document_mark_fail(
        context, &in->at,
        "solar_absorptance is %g, while vis_reflectance_diffuse + specular_reflectance is %g: more "
        "than all sunlight is accounted for, or less; accepted beside that reflectance: %.3f to "
        "%.3f (%.3f when it holds at every wavelength)",
        g->solar_absorptance, reflected, least, most, left);
  if (!(fabs(g->solar_absorptance - left) <= in->balance + ROUNDING))
    um_core_log(
        context, UM_LOG_WARNING,
        "%s:%d: grey: material %s absorbs %.3f of sunlight by solar_absorptance, %.3f by its "
        "reflectances (balance_tolerance %.3g): heat and light do not add up",
        in->at.file, in->at.line, record->name, g->solar_absorptance, left, in->balance);
  return UM_OK;
}

static enum um_status read_grey(struct um_context *context, const struct um_materials_sun *sun,
                                const struct um_materials_input *whole,
                                struct um_materials_record *record)
{
  const struct um_materials_grey_input *in = whole->grey;
  struct um_materials_grey *g = &record->explicit_values;
  record->grey = true;
  g->solar_absorptance = in->solar_absorptance;
  g->emittance = in->emittance;
  g->specular = in->specular;
  g->diffuse =
      isnan(in->diffuse) ? fmax(0.0, 1.0 - in->solar_absorptance - in->specular) : in->diffuse;
  if (!(g->diffuse + g->specular <= 1.0 + 1e-12))
    return um_document_mark_fail(
        context, &in->at,
        "vis_reflectance_diffuse + specular_reflectance is %g; accepted: at most 1",
        g->diffuse + g->specular);
  UM_TRY(check_balance(context, sun, whole, g));
  if (g->specular > 0.0 && isnan(in->alpha) && whole->lobe == NULL)
    return um_document_mark_fail(context, &in->at,
                                 "beckmann_alpha is missing; accepted: a number above 0 beside "
                                 "specular_reflectance, or lobe: {kind, alpha}");
  if (g->specular > 0.0) UM_TRY(um_materials_lobe_read(context, whole, in->alpha, record));
  return read_bands(context, in, g);
}

static enum um_status read_texts(struct um_context *context, const struct um_materials_input *in,
                                 struct um_materials_record *record)
{
  const struct um_materials_catalogue_input *c = in->catalogue;
  UM_TRY(um_core_strdup(context, in->name, &record->name));
  UM_TRY(um_core_strdup(context, in->summary, &record->summary));
  UM_TRY(um_core_strdup(context, in->citation, &record->citation));
  record->catalogue = (struct um_materials_catalogue){NAN, NAN, NAN, NAN, NULL, false};
  if (c == NULL) return UM_OK;
  UM_TRY(um_core_strdup(context, c->source, &record->source));
  record->catalogue =
      (struct um_materials_catalogue){c->solar_absorptance, c->solar_absorptance_tolerance,
                                      c->emittance,         c->emittance_tolerance,
                                      record->source,       c->kind == 1};
  return UM_OK;
}

/* One description must serve both halves: warn when its integrals leave the published values. */
static void compare_catalogue(struct um_context *context, const struct um_materials_sun *sun,
                              const struct um_materials_record *record)
{
  const struct um_materials_catalogue *c = &record->catalogue;
  if (c->source == NULL) return;
  double absorptance = um_materials_solar_absorptance(record, NULL);
  double emittance = c->emittance_is_normal
                         ? um_materials_normal_emittance(record, NULL, UM_REFERENCE_TEMPERATURE)
                         : um_materials_emittance(record, NULL, UM_REFERENCE_TEMPERATURE);
  if (sun->measured &&
      !(fabs(absorptance - c->solar_absorptance) <= c->solar_absorptance_tolerance))
    um_core_log(context, UM_LOG_WARNING,
                "material %s: solar absorptance %.3f from its optics, %.3f +- %.3f in %s",
                record->name, absorptance, c->solar_absorptance, c->solar_absorptance_tolerance,
                c->source);
  if (!(fabs(emittance - c->emittance) <= c->emittance_tolerance))
    um_core_log(context, UM_LOG_WARNING,
                "material %s: %s emittance %.3f at 300 K from its optics, %.3f +- %.3f in %s",
                record->name, c->emittance_is_normal ? "normal" : "hemispherical", emittance,
                c->emittance, c->emittance_tolerance, c->source);
}

static enum um_status read_input(struct um_context *context, const struct um_materials_sun *sun,
                                 const struct um_materials_input *in,
                                 struct um_materials_record *record)
{
  UM_TRY(check_name(context, in));
  UM_TRY(read_texts(context, in, record));
  UM_TRY(um_materials_published_read(context, sun, in, record));
  UM_TRY(um_materials_bulk_read(context, in->thermal, record));
  if (in->sheet != NULL && in->substrate == NULL)
    return um_document_mark_fail(context, &in->sheet->at,
                                 "a sheet lies on a substrate; accepted: beside the key substrate");
  if (in->layers.count > 0 && in->substrate == NULL)
    return um_document_mark_fail(context, &in->at,
                                 "layers lie on a substrate; accepted: beside the key substrate");
  if (in->grey != NULL && in->surface != NULL)
    return um_document_mark_fail(
        context, &in->surface->at,
        "belongs to a spectral record; a grey one has grey.beckmann_alpha");
  if (in->grey != NULL)
    UM_TRY(read_grey(context, sun, in, record));
  else if (in->reflectance != NULL)
    UM_TRY(um_materials_reflectance_read(context, in, record));
  else
    UM_TRY(um_materials_substrate_read(context, in, record));
  um_materials_integrals_build(sun, record);
  um_materials_mirror_build(sun, record);
  compare_catalogue(context, sun, record);
  return UM_OK;
}

enum um_status um_materials_record_read(struct um_context *context,
                                        const struct um_materials_sun *sun, const char *path,
                                        const char *const *overrides, size_t noverride,
                                        struct um_materials_record **out)
{
  enum um_status status = UM_OK;
  struct um_document *document = NULL;
  struct um_materials_record *record = NULL;
  void *root = NULL;
  *out = NULL;
  UM_CHECK(um_document_read(context, path, um_materials_schema(), overrides, noverride, &document,
                            &root));
  UM_CHECK(um_core_allocate(context, 1, sizeof *record, &record));
  record->context = context;
  UM_CHECK(read_input(context, sun, root, record));
  *out = record;
  record = NULL;
done:
  um_materials_record_destroy(&record);
  um_document_destroy(&document);
  return status;
}

void um_materials_record_destroy(struct um_materials_record **record)
{
  if (record == NULL || *record == NULL) return;
  struct um_materials_record *r = *record;
  struct um_context *context = r->context;
  um_materials_spectrum_free(context, &r->spectrum);
  if (r->borrows) {
    um_core_free(context, r);
    *record = NULL;
    return;
  }
  um_materials_layers_free(context, &r->layers);
  um_materials_bulk_free(r);
  um_materials_published_free(r);
  um_core_free(context, r->albedo);
  um_materials_measured_destroy(context, &r->measured);
  UM_FREE(context, r->explicit_values.bands, r->name, r->summary, r->citation, r->source, r);
  *record = NULL;
}
