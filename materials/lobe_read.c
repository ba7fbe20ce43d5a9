/* The lobe of a record: its kind, masking and roughness, from the keys that may state them. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/file.h"
#include "materials/bsdf.h"
#include "materials/lobe_impl.h"
#include "materials/measured.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

#define SHARES 1e-6 /* of 1, of shares written in decimals */

/* Exponents: n = 2/alpha^2 of facets, n = 1/(2 alpha^2) of Phong's lobe (lobe_ashikhmin_shirley.c,
 * lobe_phong.c). */
static double alpha_of(const struct um_materials_lobe_kind *kind, double exponent)
{
  return sqrt(kind->exponent / exponent);
}

static enum um_status check_kind(struct um_context *context,
                                 const struct um_materials_lobe_input *in,
                                 const struct um_materials_lobe_kind *kind)
{
  bool across = !isnan(in->alpha_across) || !isnan(in->exponent_across);
  if (in->masking >= 0 && !kind->masked)
    return um_document_mark_fail(context, &in->at,
                                 "masking belongs to facets; accepted: with kind beckmann or ggx, "
                                 "not %s",
                                 kind->name);
  if (kind->exponent == 0.0 && (!isnan(in->exponent) || !isnan(in->exponent_across)))
    return um_document_mark_fail(context, &in->at,
                                 "exponent belongs to phong and ashikhmin_shirley; accepted for "
                                 "kind %s: %s",
                                 kind->name, kind->rough ? "alpha" : "no roughness");
  if (!kind->rough && (!isnan(in->alpha) || across))
    return um_document_mark_fail(context, &in->at,
                                 "kind %s has no roughness; accepted: without alpha, alpha_across",
                                 kind->name);
  if (across && !kind->anisotropic)
    return um_document_mark_fail(context, &in->at,
                                 "kind %s has one roughness; accepted with a second one: kind "
                                 "beckmann, ggx or ashikhmin_shirley",
                                 kind->name);
  if (!isnan(in->exponent_across) && isnan(in->exponent))
    return um_document_mark_fail(context, &in->at,
                                 "exponent_across stands beside exponent; accepted: both, or "
                                 "neither");
  return UM_OK;
}

/* Kind and keys of one lobe as those of a lobe that stands alone. */
static enum um_status mixed_alpha(struct um_context *context,
                                  const struct um_materials_mixed_input *in, double *alpha)
{
  const struct um_materials_lobe_kind *kind = um_materials_lobe_kind_at((size_t)in->kind);
  const struct um_materials_lobe_input alone = {.at = in->at,
                                                .masking = in->masking,
                                                .alpha = in->alpha,
                                                .alpha_across = NAN,
                                                .exponent = in->exponent,
                                                .exponent_across = NAN};
  if (kind->mixed || kind->delta || kind->absorbs)
    return um_document_mark_fail(context, &in->at,
                                 "kind %s cannot be part of a mixture; accepted: beckmann, ggx, "
                                 "phong, ashikhmin_shirley, lambert",
                                 kind->name);
  UM_TRY(check_kind(context, &alone, kind));
  *alpha = !isnan(in->exponent) ? alpha_of(kind, in->exponent) : in->alpha;
  if (!kind->rough) *alpha = 0.0;
  if (isnan(*alpha))
    return um_document_mark_fail(context, &in->at,
                                 "the roughness of kind %s is missing; accepted: alpha%s",
                                 kind->name, kind->masked ? "" : ", or exponent");
  return UM_OK;
}

static enum um_status read_mixture(struct um_context *context,
                                   const struct um_materials_lobe_input *in, double stated,
                                   struct um_materials_record *record)
{
  const struct um_materials_mixed_input *of = in->of.items;
  struct um_materials_lobe *lobe = &record->lobe;
  double alpha[2];
  if (in->of.count != 2)
    return um_document_mark_fail(context, &in->at,
                                 "a mixture is of two lobes, of has %zu; accepted: of: [{share, "
                                 "kind, alpha}, {share, kind, alpha}]",
                                 in->of.count);
  if (!isnan(stated) || !isnan(in->alpha))
    return um_document_mark_fail(context, &in->at,
                                 "the lobes of a mixture have a roughness each; accepted: alpha in "
                                 "of alone");
  if (!(fabs(of[0].share + of[1].share - 1.0) <= SHARES))
    return um_document_mark_fail(context, &in->at,
                                 "the shares of a mixture add up to %.9g; accepted: 1, how much is "
                                 "reflected is said elsewhere",
                                 of[0].share + of[1].share);
  record->mixture.share = of[0].share;
  for (int k = 0; k < 2; k++) UM_TRY(mixed_alpha(context, &of[k], &alpha[k]));
  lobe->alpha = lobe->alpha_across = fmax(alpha[0], alpha[1]);
  if (!(lobe->alpha > 0.0))
    return um_document_mark_fail(context, &in->at,
                                 "a mixture of lambert alone; accepted: one lobe with a roughness");
  for (int k = 0; k < 2; k++) {
    record->mixture.of[k].kind = um_materials_lobe_kind_at((size_t)of[k].kind);
    record->mixture.of[k].ratio = alpha[k] / lobe->alpha;
    record->mixture.of[k].correlated = of[k].masking == 1;
  }
  lobe->mixture = &record->mixture;
  return um_materials_albedo_build(context, record);
}

/* How far the table was from reciprocal, and whether more comes back than arrives. */
static void say_found(struct um_context *context, const struct um_materials_lobe_input *in,
                      const struct um_materials_measured *m)
{
  const struct um_materials_measured_found f = um_materials_measured_found(m);
  um_core_log(context, UM_LOG_INFO,
              "%s: both ways round differ by %.3g rms of ln f, most by %.3g at incidence %g, "
              "reflection %g, azimuth %g deg; right and left by %.3g rms; their mean is taken",
              in->file, f.asymmetry, f.largest, f.largest_at[0] / UM_DEG, f.largest_at[1] / UM_DEG,
              f.largest_at[2] / UM_DEG, f.sides);
  if (f.left_out > 0.0)
    um_core_log(context, UM_LOG_INFO,
                "%s: %zu incidences; each but the outermost follows from the others to %.3g rms of "
                "ln f",
                in->file, f.incidences, f.left_out);
  if (f.albedo > 1.0)
    um_core_log(
        context, UM_LOG_WARNING, "%s:%d: lobe: %s reflects %.4f of what arrives from %.1f deg%s",
        in->at.file, in->at.line, in->file, f.albedo, f.albedo_at / UM_DEG,
        f.renormalised ? "; renormalised to 1" : "; kept, renormalise: true brings it to 1");
}

/* rho_d + F E <= 1 at every wavelength; what the table itself has above 1 was said. */
static enum um_status check_room(struct um_context *context,
                                 const struct um_materials_reflectance_input *r,
                                 const struct um_materials_measured *m)
{
  const double *diffuse = r->diffuse.items, *specular = r->specular.items,
               *wavelength = r->wavelength_um.items;
  double most = fmin(1.0, um_materials_measured_albedo_most(m));
  for (size_t i = 0; i < r->specular.count; i++)
    if (!(diffuse[i] + specular[i] * most <= 1.0 + 1e-9))
      return um_document_mark_fail(
          context, &r->at,
          "diffuse + specular times the table's albedo of %.4f is %g at wavelength_um %g; "
          "accepted: at most 1",
          most, diffuse[i] + specular[i] * most, wavelength[i]);
  return UM_OK;
}

static enum um_status read_measured(struct um_context *context,
                                    const struct um_materials_input *whole,
                                    struct um_materials_record *record)
{
  const struct um_materials_lobe_input *in = whole->lobe;
  struct um_materials_measured_grid grid = {0};
  enum um_status status = UM_OK;
  char *path = NULL;
  if (whole->reflectance == NULL)
    return um_document_mark_fail(context, &in->at,
                                 "kind measured is a whole BRDF; accepted: beside the key "
                                 "reflectance, of which specular is a factor of it");
  if (in->file == NULL)
    return um_document_mark_fail(context, &in->at,
                                 "file is missing; accepted: the table of kind measured");
  UM_CHECK(um_core_path_resolve(context, in->at.file, in->file, &path));
  UM_CHECK(um_materials_measured_read(context, path, &grid));
  status = um_materials_measured_create(context, &grid, in->renormalise, &record->measured);
  if (status == UM_ERR_NUMERIC)
    status = um_document_mark_fail(context, &in->at,
                                   "%s jumps so that renormalising did not converge; accepted: a "
                                   "smoother table",
                                   in->file);
  UM_CHECK(status);
  record->lobe.measured = record->measured;
  say_found(context, in, record->measured);
  UM_CHECK(check_room(context, whole->reflectance, record->measured));
done:
  um_materials_measured_grid_free(context, &grid);
  um_core_free(context, path);
  return status;
}

enum um_status um_materials_lobe_read(struct um_context *context,
                                      const struct um_materials_input *whole, double stated,
                                      struct um_materials_record *record)
{
  const struct um_materials_lobe_input *in = whole->lobe;
  struct um_materials_lobe *lobe = &record->lobe;
  lobe->kind = &um_materials_lobe_beckmann;
  lobe->alpha = lobe->alpha_across = stated;
  lobe->compensated = !record->grey; /* numbers of grey records are taken as they stand */
  if (in == NULL) return um_materials_albedo_build(context, record);
  const struct um_materials_lobe_kind *kind = um_materials_lobe_kind_at((size_t)in->kind);
  lobe->kind = kind;
  lobe->correlated = in->masking == 1;
  UM_TRY(check_kind(context, in, kind));
  if (kind->mixed) return read_mixture(context, in, stated, record);
  if (in->of.count > 0)
    return um_document_mark_fail(context, &in->at,
                                 "of belongs to kind mixture; accepted beside kind %s: without it",
                                 kind->name);
  if (!kind->absorbs && (in->file != NULL || in->renormalise))
    return um_document_mark_fail(context, &in->at,
                                 "file and renormalise belong to kind measured; accepted beside "
                                 "kind %s: without them",
                                 kind->name);
  if (!kind->rough) {
    if (!isnan(stated))
      return um_document_mark_fail(context, &in->at,
                                   "kind %s has no roughness; accepted: without beckmann_alpha, "
                                   "rq_um and tau_um",
                                   kind->name);
    lobe->alpha = lobe->alpha_across = 0.0;
    return kind->absorbs ? read_measured(context, whole, record)
                         : um_materials_albedo_build(context, record);
  }
  double own = !isnan(in->exponent) ? alpha_of(kind, in->exponent) : in->alpha;
  if (isnan(own) == isnan(stated))
    return um_document_mark_fail(context, &in->at,
                                 "%s; accepted: one of lobe.alpha%s, beckmann_alpha, or rq_um and "
                                 "tau_um",
                                 isnan(own) ? "the roughness of the specular part is missing"
                                            : "the roughness is given twice",
                                 kind->masked ? "" : " or lobe.exponent");
  lobe->alpha = lobe->alpha_across = isnan(own) ? stated : own;
  if (!isnan(in->alpha_across)) lobe->alpha_across = in->alpha_across;
  if (!isnan(in->exponent_across)) lobe->alpha_across = alpha_of(kind, in->exponent_across);
  return um_materials_albedo_build(context, record);
}
