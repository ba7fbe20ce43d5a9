/* The spectral grid of a record: reflectance tabulated over wavelength and angle, so that a look-up
 * costs a few multiplications.
 *
 * Angles: cos = u^2 with u uniform resolves the pseudo-Brewster dip of metals near grazing; cubic
 * Lagrange between nodes. A hemispherical mean 2 int X cos dcos = 4 int X u^3 du is Simpson's sum.
 *
 * Facets that shadow each other send light on to other facets; the single-scattering lobe loses it.
 * It must not turn into absorption. With E(o) the lobe's directional albedo for F = 1 and
 *   Fbar(o) = <F(o.h)>, the mean of F over the facets that the lobe uses at o,
 * a facetted surface that loses nothing reflects rho_d + Fbar(o), hence (Kirchhoff)
 *   emissivity(o) = 1 - rho_d - Fbar(o),
 * and what the lobe misses, M(o) = Fbar(o) (1 - E(o)), is given back: of facets with Smith's
 * masking by the lobe itself, E = 1 (compensation.c), and M = 0; of others by a second lobe, f_M(i,
 * o) = M(i) M(o) / (pi Mbar),  Mbar = 2 int M(o) cos_o dcos_o, which is reciprocal and reflects
 * M(i) of what arrives from i (after Kulla & Conty 2017; M carries F itself, so that the sum is
 * exact at every wavelength and angle). A measured BRDF is whole: what it lacks was absorbed. It
 * reflects rho_d + F E(o), F a factor without angle, emits the rest, and M = 0
 * (docs/decisions/0012-measured-brdfs.md). */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "materials/record_impl.h"

#define COSINES UM_MATERIALS_COSINES

/* Largest ratio of neighbouring wavelengths on the grid. */
static const double largest_step = 1.02;
/* Lobes below this alpha are treated as a mirror in the averages over facets. */
static const double smallest_alpha = 1e-3;

size_t um_materials_spectrum_locate(const struct um_materials_spectrum *spectrum, double wavelength,
                                    double *fraction)
{
  const double *x = spectrum->wavelength;
  size_t n = spectrum->n;
  if (!(wavelength > x[0])) {
    *fraction = 0.0;
    return 0;
  }
  if (wavelength >= x[n - 1]) {
    *fraction = 1.0;
    return n - 2;
  }
  double b = (log(wavelength) - spectrum->log_first) * spectrum->buckets_per_log;
  size_t bucket =
      b < 0.0 ? 0 : (b > UM_MATERIALS_BUCKETS - 1 ? UM_MATERIALS_BUCKETS - 1 : (size_t)b);
  size_t i = spectrum->bucket[bucket];
  while (i > 0 && x[i] > wavelength) i--; /* a bucket edge that rounded up */
  while (x[i + 1] <= wavelength) i++;
  *fraction = (wavelength - x[i]) / (x[i + 1] - x[i]);
  return i;
}

double um_materials_spectrum_angular(const struct um_materials_spectrum *spectrum,
                                     const double *table, size_t i, double t, double cosine)
{
  size_t ncos = spectrum->ncos;
  const double *low = table + i * ncos, *high = low + ncos;
  if (ncos == 1) return low[0] + t * (high[0] - low[0]);
  double c = cosine > 0.0 ? (cosine < 1.0 ? cosine : 1.0) : 0.0;
  double x = sqrt(c) * (COSINES - 1);
  size_t j = (size_t)x;
  j = j < 1 ? 1 : (j > COSINES - 3 ? COSINES - 3 : j);
  double s = x - (double)j; /* in -1..2 */
  /* Lagrange polynomial through the nodes j-1 .. j+2 */
  double w0 = -s * (s - 1.0) * (s - 2.0) / 6.0, w1 = (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0;
  double w2 = -(s + 1.0) * s * (s - 2.0) / 2.0, w3 = (s + 1.0) * s * (s - 1.0) / 6.0;
  double a = w0 * low[j - 1] + w1 * low[j] + w2 * low[j + 1] + w3 * low[j + 2];
  double b = w0 * high[j - 1] + w1 * high[j] + w2 * high[j + 1] + w3 * high[j + 2];
  double value = a + t * (b - a);
  return value < 0.0 ? 0.0 : (value > 1.0 ? 1.0 : value);
}

/* Nodes of a fringe, which is lambda^2/(2 n d) wide and sharper than a sine toward grazing. */
static const double nodes_per_fringe = 96.0;

/* Largest ratio of neighbouring wavelengths above this one. */
static double step_at(const struct um_materials_law *law, double wavelength)
{
  if (!(law->fringes > 0.0)) return largest_step;
  return fmin(largest_step, 1.0 + wavelength / (2.0 * law->fringes * nodes_per_fringe));
}

/* Nodes of the grid: the law's own, its range, and points between so that no step is large. Called
 * with out = NULL to count. */
static size_t place_nodes(const struct um_materials_law *law, double *out)
{
  size_t n = 0, next = 0;
  double last = fmax(law->last, law->nnode > 0 ? law->nodes[law->nnode - 1] : 0.0);
  double at = law->nnode > 0 ? fmin(law->first, law->nodes[0]) : law->first;
  while (next < law->nnode && law->nodes[next] <= at) next++;
  if (out != NULL) out[n] = at;
  n++;
  while (at < last) {
    double goal = next < law->nnode ? law->nodes[next++] : last;
    if (!(goal > at)) continue;
    for (; law->fringes > 0.0 && goal > at * largest_step;
         n++) { /* fringes widen with wavelength */
      at *= step_at(law, at);
      if (out != NULL) out[n] = at;
    }
    size_t steps = (size_t)ceil(log(goal / at) / log(step_at(law, at)));
    if (steps < 1) steps = 1;
    for (size_t s = 1; s <= steps; s++, n++)
      if (out != NULL) out[n] = s == steps ? goal : at * pow(goal / at, (double)s / (double)steps);
    at = goal;
  }
  return n;
}

static void index_nodes(struct um_materials_spectrum *spectrum)
{
  const double *x = spectrum->wavelength;
  size_t n = spectrum->n, i = 0;
  spectrum->log_first = log(x[0]);
  spectrum->buckets_per_log = UM_MATERIALS_BUCKETS / (log(x[n - 1]) - spectrum->log_first);
  for (size_t b = 0; b < UM_MATERIALS_BUCKETS; b++) {
    double edge = exp(spectrum->log_first + (double)b / spectrum->buckets_per_log);
    while (i + 2 < n && x[i + 1] <= edge) i++;
    spectrum->bucket[b] = (uint32_t)i;
  }
}

/* How the facets that the lobe uses at each outgoing node see the F nodes. */
struct facet_weights {
  double share[COSINES][COSINES]; /* [o][h] sums to 1 over h */
};

/* Spread one sample over the two F nodes around its o.h. */
static void add_sample(void *self, double cos_oh, double weight)
{
  double *row = self;
  double x = sqrt(cos_oh < 1.0 ? cos_oh : 1.0) * (COSINES - 1);
  size_t j = (size_t)x;
  if (j > COSINES - 2) j = COSINES - 2;
  /* linear in the cosine, so that a linear F is averaged exactly */
  double low = um_materials_node_cosine(j), high = um_materials_node_cosine(j + 1),
         t = (cos_oh - low) / (high - low);
  row[j] += (1.0 - t) * weight;
  row[j + 1] += t * weight;
}

static void weigh_facets(const struct um_materials_lobe *lobe, struct facet_weights *out)
{
  bool mirror = lobe->kind == NULL || lobe->kind->delta || lobe->kind->absorbs || /* F is even */
                (lobe->kind->rough && fmax(lobe->alpha, lobe->alpha_across) < smallest_alpha);
  memset(out, 0, sizeof *out);
  for (size_t o = 0; o < COSINES; o++) {
    if (mirror) {
      out->share[o][o] = 1.0;
      continue;
    }
    double cos_o = fmax(um_materials_node_cosine(o), 1e-4);
    double sum = um_materials_lobe_mean(lobe, cos_o, 64, 32, add_sample, out->share[o]);
    for (size_t h = 0; h < COSINES; h++) out->share[o][h] /= sum;
  }
}

/* Fbar, of what absorbs Fbar E, and the means of it and of M at one wavelength. */
static void average_facets(struct um_materials_spectrum *spectrum, size_t i,
                           const struct facet_weights *weights, const double albedo[COSINES],
                           bool absorbs)
{
  const double *facet = spectrum->facet + i * spectrum->ncos;
  double *lobe = spectrum->lobe + i * spectrum->ncos;
  double masked[COSINES];
  for (size_t o = 0; o < COSINES; o++) {
    double mean = facet[0];
    if (spectrum->ncos > 1) {
      mean = 0.0;
      for (size_t h = 0; h < COSINES; h++) mean += weights->share[o][h] * facet[h];
      if (absorbs) mean *= albedo[o];
      mean = fmin(fmax(mean, 0.0), 1.0 - spectrum->diffuse[i]);
      lobe[o] = mean;
    }
    masked[o] = absorbs ? 0.0 : mean * (1.0 - albedo[o]);
  }
  if (spectrum->ncos == 1) lobe[0] = facet[0];
  spectrum->lobe_mean[i] = um_materials_hemispherical_mean(lobe, spectrum->ncos);
  spectrum->masked_mean[i] = um_materials_hemispherical_mean(masked, COSINES);
}

/* R of an angular law at one wavelength, split into Lambert part and facets:
 *   1 - R' = min(1, f (1 - R)),  rho_d = s mean(R'),  F = (1 - s) R' */
static void split_reflectance(const struct um_materials_law *law, double wavelength,
                              double *diffuse, double *facet, size_t ncos)
{
  double all[COSINES];
  for (size_t j = 0; j < COSINES; j++) {
    double r = law->reflectance(law->self, wavelength, um_materials_node_cosine(j), diffuse);
    all[j] = fmax(0.0, 1.0 - law->absorption_factor * (1.0 - r));
  }
  *diffuse = law->diffuse_fraction * um_materials_hemispherical_mean(all, COSINES);
  for (size_t j = 0; j < ncos; j++) facet[j] = (1.0 - law->diffuse_fraction) * all[j];
}

static enum um_status allocate_grid(struct um_context *context, struct um_materials_spectrum *s)
{
  UM_TRY(um_core_allocate(context, s->n, sizeof(double), &s->wavelength));
  UM_TRY(um_core_allocate(context, s->n, sizeof(double), &s->diffuse));
  UM_TRY(um_core_allocate(context, s->n, sizeof(double), &s->masked_mean));
  UM_TRY(um_core_allocate(context, s->n, sizeof(double), &s->lobe_mean));
  UM_TRY(um_core_allocate(context, s->n * s->ncos, sizeof(double), &s->facet));
  return um_core_allocate(context, s->n * s->ncos, sizeof(double), &s->lobe);
}

enum um_status um_materials_spectrum_build(struct um_context *context,
                                           struct um_materials_record *record,
                                           const struct um_materials_law *law)
{
  struct um_materials_spectrum *s = &record->spectrum;
  s->n = place_nodes(law, NULL);
  bool absorbs = record->lobe.kind != NULL && record->lobe.kind->absorbs;
  s->ncos = absorbs || (law->angular && law->diffuse_fraction < 1.0) ? COSINES : 1;
  assert(s->n >= 2);
  UM_TRY(allocate_grid(context, s));
  place_nodes(law, s->wavelength);
  index_nodes(s);

  struct facet_weights *weights;
  UM_TRY(um_core_allocate(context, 1, sizeof *weights, &weights));
  weigh_facets(&record->lobe, weights);
  double albedo[COSINES];
  for (size_t o = 0; o < COSINES; o++)
    albedo[o] = um_materials_albedo(record, &record->lobe, um_materials_node_cosine(o));
  for (size_t i = 0; i < s->n; i++) {
    double *facet = s->facet + i * s->ncos;
    if (law->angular)
      split_reflectance(law, s->wavelength[i], &s->diffuse[i], facet, s->ncos);
    else
      facet[0] = law->reflectance(law->self, s->wavelength[i], 1.0, &s->diffuse[i]);
    for (size_t j = 1; j < s->ncos && !law->angular; j++) facet[j] = facet[0];
    average_facets(s, i, weights, albedo, absorbs);
  }
  um_core_free(context, weights);
  return UM_OK;
}

void um_materials_spectrum_free(struct um_context *context, struct um_materials_spectrum *spectrum)
{
  UM_FREE(context, spectrum->wavelength, spectrum->diffuse, spectrum->masked_mean,
          spectrum->lobe_mean, spectrum->facet, spectrum->lobe);
}
