/* Directional albedo of a record's lobe, for F = 1, at roughnesses that effects may give it.
 *
 * Where facets pass light on (compensation.c) it is 1, or for a grain as much of it as s brings.
 * That of single scattering: Beckmann's has a table of its own (beckmann_albedo.c). Others are
 * integrated when the record is read: at the cosines of the spectral grid and at roughnesses of
 * 2^(k/4) times the record's, k = -14 .. 10, at its own to 2e-4, at the others to 1e-3; Catmull-Rom
 * in k, cubic Lagrange in the square root of the cosine, constant beyond. A lobe that an effect
 * makes more anisotropic than its record, or less, has the mean over azimuths of albedos of the
 * roughness toward each: 0.005 for factors to 2 (test: materials/records). */
#include <math.h>

#include "base/core/constants.h"
#include "materials/compensation_impl.h"
#include "materials/lobe_impl.h"
#include "materials/record_impl.h"

#define COSINES UM_MATERIALS_COSINES
#define SCALES  UM_MATERIALS_SCALES
#define STATED  14 /* the k of the record's own roughness */

enum um_status um_materials_albedo_build(struct um_context *context,
                                         struct um_materials_record *record)
{
  const struct um_materials_lobe_kind *kind = record->lobe.kind;
  if (kind == NULL || !kind->rough || um_materials_lobe_is_tabulated(&record->lobe)) return UM_OK;
  UM_TRY(um_core_allocate(context, SCALES * COSINES, sizeof *record->albedo, &record->albedo));
  for (size_t k = 0; k < SCALES; k++) {
    struct um_materials_lobe lobe = record->lobe;
    if (kind->masked) lobe.compensated = false;
    double scale = exp2(0.25 * ((double)k - STATED));
    lobe.alpha *= scale;
    lobe.alpha_across *= scale;
    for (size_t j = 0; j < COSINES; j++) {
      double c = fmax(1e-4, um_materials_node_cosine(j));
      record->albedo[k * COSINES + j] =
          k == STATED ? um_materials_lobe_albedo(&lobe, c)
                      : fmin(1.0, um_materials_lobe_mean(&lobe, c, 96, 16, NULL, NULL));
    }
  }
  return UM_OK;
}

/* Square of the roughness, mean over azimuths. */
static double mean_square(const struct um_materials_lobe *lobe)
{
  return 0.5 * (lobe->alpha * lobe->alpha + lobe->alpha_across * lobe->alpha_across) + lobe->tilted;
}

/* Mean over azimuths of what a lobe that is alike all round has, of the roughness toward each. */
static double round_about(const struct um_materials_lobe *lobe, double cosine)
{
  enum { TURNS = 4 };
  double sum = 0.0;
  for (int k = 0; k < TURNS; k++) {
    double phi = 0.5 * UM_PI * (k + 0.5) / TURNS;
    struct um_materials_lobe one = *lobe;
    one.compensated = false;
    one.alpha = one.alpha_across = hypot(lobe->alpha * cos(phi), lobe->alpha_across * sin(phi));
    sum += um_materials_lobe_albedo(&one, cosine) / TURNS;
  }
  return sum;
}

static double of_single_scattering(const struct um_materials_record *record,
                                   const struct um_materials_lobe *lobe, double cosine)
{
  if (lobe->kind->absorbs) return um_materials_lobe_albedo(lobe, cosine);
  if (!lobe->kind->rough && record->albedo == NULL) return 1.0;
  if (record->albedo == NULL)
    return um_materials_lobe_is_anisotropic(lobe) ? round_about(lobe, cosine)
                                                  : um_materials_lobe_albedo(lobe, cosine);
  double u = sqrt(fmax(0.0, fmin(1.0, cosine))), value[4];
  double y = 2.0 * log2(mean_square(lobe) / mean_square(&record->lobe)) + STATED;
  y = fmax(0.0, fmin(SCALES - 1.0, y));
  size_t k = y < SCALES - 2.0 ? (size_t)y : SCALES - 2;
  double t = y - (double)k;
  for (size_t p = 0; p < 4; p++) {
    size_t node = k + p > 0 ? k + p - 1 : 0;
    value[p] = um_materials_along_cosines(
        record->albedo + (node < SCALES ? node : SCALES - 1) * COSINES, u);
  }
  double a = value[1], b = value[2], low = 0.5 * (b - value[0]), high = 0.5 * (value[3] - a);
  return fmax(0.0, fmin(1.0, a + t * (low + t * (3.0 * (b - a) - 2.0 * low - high +
                                                 t * (2.0 * (a - b) + low + high)))));
}

double um_materials_albedo(const struct um_materials_record *record,
                           const struct um_materials_lobe *lobe, double cosine)
{
  if (lobe->kind == NULL || um_materials_lobe_is_whole(lobe)) return 1.0;
  double share = um_materials_compensation_share(lobe);
  return share + (1.0 - share) * of_single_scattering(record, lobe, cosine);
}
