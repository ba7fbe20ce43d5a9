/* What a record mirrors, of what it reflects.
 *
 * A lobe of Beckmann alpha a is 2 atan a wide from its middle to 1/e
 * (docs/physics/roughness-and-lobes.md): 11 deg at the limit. A mixture mirrors nothing here: part
 * of it may be as wide as a Lambert surface. Patches of a satellite see each other under such
 * angles and more, so that what the lobe spreads mostly stays with the patch that a mirror would
 * send it to. Of the reflected
 *
 *   rho_d + <F>,   <F> = <F E> + <M>,
 *
 * <F E> goes with the lobe, and what masking keeps back, <M>, is scattered like rho_d. Shares are
 * means over reflected sunlight and over reflected infrared of a black body of 300 K, from all
 * sides: they multiply 1 - absorptance and 1 - emittance, so that what is absorbed, scattered and
 * mirrored adds up to what falls in, whatever changes the absorptance. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "materials/record_impl.h"

#define WIDEST 0.1 /* Beckmann alpha of a lobe that is taken as a mirror [1], at most */

/* Reflected and mirrored at a wavelength, added to sums with a weight. */
static void add(const struct um_materials_record *record, double wavelength, double weight,
                double *reflected, double *mirrored)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double t;
  size_t i = um_materials_spectrum_locate(s, wavelength, &t);
  double lobe = s->lobe_mean[i] + t * (s->lobe_mean[i + 1] - s->lobe_mean[i]);
  double masked = s->masked_mean[i] + t * (s->masked_mean[i + 1] - s->masked_mean[i]);
  double diffuse = s->diffuse[i] + t * (s->diffuse[i + 1] - s->diffuse[i]);
  *reflected += weight * (diffuse + lobe);
  *mirrored += weight * (lobe - masked);
}

static double share(double reflected, double mirrored)
{
  if (!(reflected > 0.0 && mirrored > 0.0)) return 0.0;
  return mirrored < reflected ? mirrored / reflected : 1.0;
}

void um_materials_mirror_build(const struct um_materials_sun *sun,
                               struct um_materials_record *record)
{
  double reflected = 0.0, mirrored = 0.0, before = 0.0;
  record->mirror = (struct um_materials_mirror){0.0, 0.0};
  if (!um_materials_has_lobe(record)) return;
  const struct um_materials_lobe *lobe = &record->lobe;
  if (!(lobe->kind->rough || lobe->kind->delta) || lobe->kind->mixed) return;
  if (!(fmax(lobe->alpha, lobe->alpha_across) <= WIDEST)) return;
  if (record->grey) { /* its lobe ends at 2.5 um; its numbers are taken as given */
    const struct um_materials_grey *g = &record->explicit_values;
    record->mirror.solar = share(g->diffuse + g->specular, g->specular);
    return;
  }
  for (size_t i = 0; i < UM_MATERIALS_SUN; i++)
    if (sun->share[i] > 0.0) add(record, sun->wavelength[i], sun->share[i], &reflected, &mirrored);
  record->mirror.solar = share(reflected, mirrored);
  reflected = mirrored = 0.0;
  const struct um_materials_spectrum *s = &record->spectrum;
  for (size_t i = 0; i < s->n; i++) { /* shares of Planck's law between the nodes */
    double fraction = um_core_planck_fraction(s->wavelength[i] * UM_REFERENCE_TEMPERATURE);
    add(record, s->wavelength[i], fraction - before, &reflected, &mirrored);
    before = fraction;
  }
  add(record, s->wavelength[s->n - 1], 1.0 - before, &reflected, &mirrored);
  record->mirror.infrared = share(reflected, mirrored);
}

struct um_materials_mirror um_materials_mirror(const struct um_materials_record *record)
{
  return record->mirror;
}

struct um_materials_mirror um_materials_mirror_creased(const struct um_materials_record *record,
                                                       double slope_variance)
{
  struct um_materials_lobe lobe = um_materials_lobe_tilted(&record->lobe, slope_variance);
  if (slope_variance > 0.0 && !(fmax(lobe.alpha, lobe.alpha_across) <= WIDEST))
    return (struct um_materials_mirror){0.0, 0.0};
  return record->mirror;
}
