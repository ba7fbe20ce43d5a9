/* What every lobe is held to (materials/lobes.def), over roughness, grain and masking:
 *
 *   reciprocity     f(i, o) = f(o, i)
 *   energy          int f cos_i dw_i <= 1 for F = 1, by directions; the samples say the same
 *   sampling        densities integrate to what lies above the surface, weights are f
 * cos_i/density, and a chi-square of samples against the density the Sun's disc  takes no energy
 * and gives none, and widens by what it must A new kind is held to them by its line in the list. */
#include "check.h"

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "materials/bsdf.h"
#include "materials/lobe.h"
#include "tests/materials/table.h"
#include "tests/support/whole.h"
#include "tests/support/with_context.h"

static const double alphas[] = {0.03, 0.1, 0.326, 0.7, 1.2};
static const double ratios[] = {1.0, 0.25}; /* alpha_across to alpha */
static const double sun_radius = 0.004652;  /* at 1 au [rad] */

static struct um_vec3 direction(double zenith, double azimuth)
{
  return um_vec3(sin(zenith) * cos(azimuth), sin(zenith) * sin(azimuth), cos(zenith));
}

/* A core on a wide foot, two kinds, and facets on an even floor; and creased. */
static void each_mixture(const struct um_materials_lobe_kind *kind,
                         void (*f)(const struct um_materials_lobe *lobe))
{
  const struct um_materials_lobe_kind *beckmann = um_materials_lobe_kind_find("beckmann");
  const struct um_materials_mixture mixtures[] = {
      {0.6, {{beckmann, 0.2, false}, {beckmann, 1.0, false}}},
      {0.3,
       {{um_materials_lobe_kind_find("ggx"), 1.0, true},
        {um_materials_lobe_kind_find("phong"), 0.5, false}}},
      {0.8, {{beckmann, 1.0, true}, {um_materials_lobe_kind_find("lambert"), 0.0, false}}}};
  for (size_t m = 0; m < sizeof mixtures / sizeof mixtures[0]; m++) {
    if (mixtures[m].of[0].kind == NULL || mixtures[m].of[1].kind == NULL) continue; /* pulled */
    for (size_t a = 0; a < sizeof alphas / sizeof alphas[0]; a++) {
      if (!um_test_whole() && a != 2 && a != 2 * m) continue;
      struct um_materials_lobe lobe = {kind,         alphas[a],           alphas[a], false,
                                       &mixtures[m], a == 2 ? 0.02 : 0.0, NULL,      m == 0};
      f(&lobe);
    }
  }
}

/* Tables: facets on an even floor, a wide lobe with coarser azimuths, and what a bad instrument
 * makes of an even floor: waves of ln f that are not reciprocal, and 1 % of noise. */
static void each_table(const struct um_materials_lobe_kind *kind,
                       void (*f)(const struct um_materials_lobe *lobe))
{
  static const double floors[] = {0.1, 0.05, 0.4};
  for (int n = 0; n < 3; n++) {
    struct test_brdf brdf = {.diffuse = floors[n], .rest = n < 2 ? 0.8 : 0.0};
    const char *name = n == 0 ? "ggx" : "ashikhmin_shirley";
    double alpha = n == 0 ? 0.25 : 0.6;
    brdf.lobe = (struct um_materials_lobe){
        um_materials_lobe_kind_find(name), alpha, alpha, false, NULL, 0.0, NULL, false};
    if (brdf.lobe.kind == NULL) continue; /* pulled */
    struct um_materials_measured_grid grid = test_grid(&brdf, 5.0, 85.0, n == 1 ? 10.0 : 5.0);
    for (size_t k = 0; k < grid.npolar * grid.npolar * grid.nazimuth && n == 2; k++) {
      size_t a = k / grid.nazimuth / grid.npolar, c = k / grid.nazimuth % grid.npolar;
      grid.f[k] *= exp(0.3 * sin(4.0 * grid.polar[a]) * cos(3.0 * grid.polar[c]) +
                       0.02 * (um_core_hash_uniform(um_core_hash(5, k)) - 0.5));
    }
    struct um_materials_measured *m;
    assert_int_equal(um_materials_measured_create(context, &grid, false, &m), UM_OK);
    struct um_materials_lobe lobe = {.kind = kind, .measured = m};
    f(&lobe);
    um_materials_measured_destroy(context, &m);
    test_grid_free(&grid);
  }
}

/* Calls f with every lobe of every kind; in a part of the sweep with a third of the roughnesses,
 * grains and maskings of each, others for each grain and masking. */
static void each_lobe(void (*f)(const struct um_materials_lobe *lobe))
{
  const size_t stride = (size_t)um_test_number(1, 3);
  for (size_t k = 0; k < um_materials_lobe_kind_count(); k++) {
    const struct um_materials_lobe_kind *kind = um_materials_lobe_kind_at(k);
    if (kind->mixed) {
      each_mixture(kind, f);
      continue;
    }
    if (kind->absorbs) {
      each_table(kind, f);
      continue;
    }
    for (size_t a = 0; a < (kind->rough ? sizeof alphas / sizeof alphas[0] : 1); a++)
      for (size_t r = 0; r < (kind->anisotropic ? 2 : 1); r++)
        for (int form = 0; form < (kind->masked ? 4 : 1); form++) { /* of masking */
          if (kind->rough && (a + r + (size_t)form + k) % stride != 0) continue;
          double alpha = kind->rough ? alphas[a] : 0.0;
          struct um_materials_lobe lobe = {.kind = kind,
                                           .alpha = alpha,
                                           .alpha_across = ratios[r] * alpha,
                                           .correlated = (form & 1) != 0,
                                           .compensated = (form & 2) != 0};
          f(&lobe);
        }
  }
}

static const char *say(const struct um_materials_lobe *lobe, const char *what)
{
  static char text[160];
  snprintf(text, sizeof text, "%s of %s, alpha %g, across %g%s%s", what, lobe->kind->name,
           lobe->alpha, lobe->alpha_across, lobe->correlated ? ", height-correlated" : "",
           lobe->compensated ? ", compensated" : "");
  return text;
}

/* --- laws ------------------------------------------------------------------------------------ */

/* Rounding alone: 1e-10 of the larger, where a power of 1e6 amplifies that of cosines. */
static void reciprocal(const struct um_materials_lobe *lobe)
{
  for (uint64_t n = 0; n < 400; n++) {
    double u[2], v[2];
    um_core_sample_2d(1, n, u);
    um_core_sample_2d(2, n, v);
    struct um_vec3 i = direction(acos(0.02 + 0.98 * u[0]), 2.0 * UM_PI * u[1]);
    struct um_vec3 near = um_vec3_unit(
        um_vec3(-i.x + lobe->alpha * (v[0] - 0.5), -i.y + lobe->alpha * (v[1] - 0.5), i.z));
    struct um_vec3 o = n % 2 == 0 ? near : direction(acos(v[0]), 2.0 * UM_PI * v[1]);
    struct um_materials_pair there = um_materials_pair(i, o), back = um_materials_pair(o, i);
    double a = lobe->kind->evaluate(lobe, &there), b = lobe->kind->evaluate(lobe, &back);
    assert_true(a >= 0.0 && isfinite(a));
    check_near(say(lobe, "reciprocity"), a, b, 1e-10 * fmax(a, 1.0));
    there.cos_i = -there.cos_i;
    assert_true(lobe->kind->evaluate(lobe, &there) == 0.0);
  }
}

static void reciprocity(void **state)
{
  (void)state;
  each_lobe(reciprocal);
}

/* int f cos_i dw_i by directions about the mirror direction, radius by a cube so that narrow lobes
 * are met: delta = range s^3, dw = sin(delta) 3 range s^2 ds dphi. A mirror's image has an edge:
 * the range is then that of one more ring than the image has. */
static double over_directions(const struct um_materials_lobe *lobe, struct um_vec3 o, double sun,
                              bool density)
{
  enum { RADII = 500, TURNS = 400 };
  double range = lobe->kind->delta ? sun * pow(RADII / (RADII - 1.0), 3.0) : UM_PI;
  struct um_vec3 axis = um_vec3(-o.x, -o.y, o.z), t, b;
  double sum = 0.0;
  um_core_vec3_frame(axis, &t, &b);
  for (int j = 0; j < RADII; j++) {
    double s = (j + 0.5) / RADII, delta = range * s * s * s;
    double share = sin(delta) * 3.0 * range * s * s / RADII * 2.0 * UM_PI / TURNS;
    for (int k = 0; k < TURNS; k++) {
      double phi = 2.0 * UM_PI * (k + 0.5) / TURNS;
      struct um_vec3 i = um_vec3_scale(axis, cos(delta));
      i = um_vec3_axpy(i, sin(delta) * cos(phi), t);
      i = um_vec3_axpy(i, sin(delta) * sin(phi), b);
      if (!(i.z > 0.0)) continue;
      struct um_materials_pair pair = um_materials_pair(i, o);
      if (density)
        sum += share * lobe->kind->density(lobe, &pair);
      else if (sun > 0.0)
        sum += share * i.z * lobe->kind->sunlit(lobe, &pair, sun);
      else
        sum += share * i.z * lobe->kind->evaluate(lobe, &pair);
    }
  }
  return sum;
}

static const double zeniths[] = {0.0, 30.0, 60.0, 80.0};
#define ZENITHS (sizeof zeniths / sizeof zeniths[0])

/* Two ways to the directional albedo; what um_materials_lobe_albedo gives is the mean of the second
 * over azimuths. Both sums are good to 4e-4 (kinks at the horizon and at the azimuths' poles). */
static void conserves(const struct um_materials_lobe *lobe)
{
  if (lobe->kind->delta) return;
  for (size_t z = 0; z < ZENITHS; z++) {
    struct um_vec3 o = direction(zeniths[z] * UM_DEG, 0.0);
    if (um_materials_lobe_is_anisotropic(lobe)) o = direction(zeniths[z] * UM_DEG, 0.7);
    double directions = over_directions(lobe, o, 0.0, false);
    double samples = um_materials_lobe_quadrature(lobe, o, 256, 256, NULL, NULL);
    double room = lobe->compensated ? 1e-3 : 1e-4; /* of its tables */
    assert_true(directions <= 1.0 + room + 3e-4 && samples <= 1.0 + room);
    check_near(say(lobe, "albedo"), samples, directions, 4e-4);
    if (!um_materials_lobe_is_anisotropic(lobe) && !um_materials_lobe_is_whole(lobe))
      check_near(say(lobe, "albedo by cosine"), um_materials_lobe_albedo(lobe, o.z), samples, 4e-4);
  }
  for (double c = 0.01; c < 1.0; c += 0.03)
    assert_true(um_materials_lobe_albedo(lobe, c) <= 1.0 &&
                um_materials_lobe_albedo(lobe, c) > 0.0);
}

/* Facets that pass light on lose nothing: int f cos_i dw_i = 1 for F = 1 toward all directions,
 * also between the roughnesses of the tables and at grazing angles: within 1e-3, for GGX by the
 * height of the facet within 5e-3. A grain of small roughness does as well, a rough one has single
 * scattering. */
static void nothing_is_lost(void **state)
{
  static const double between[] = {0.013, 0.075, 0.225, 0.275, 0.526, 0.925, 1.43};
  (void)state;
  for (size_t k = 0; k < um_materials_lobe_kind_count(); k++)
    for (int form = 0; form < 2 && um_materials_lobe_kind_at(k)->masked; form++)
      for (size_t a = 0; a < sizeof between / sizeof between[0]; a++)
        for (size_t r = 0; r < 2; r++) {
          struct um_materials_lobe lobe = {.kind = um_materials_lobe_kind_at(k),
                                           .alpha = between[a],
                                           .alpha_across = ratios[r] * between[a],
                                           .correlated = form == 1,
                                           .compensated = true};
          bool ggx = lobe.kind == um_materials_lobe_kind_find("ggx");
          bool is_whole = um_materials_lobe_is_whole(&lobe);
          assert_true(is_whole == (r == 0));
          for (double u = 0.06; u < 1.0; u += 0.0625) {
            double e = um_materials_lobe_mean(&lobe, u * u, 384, 48, NULL, NULL);
            assert_true(e <= 1.0 + 1e-3);
            if (is_whole) check_near(say(&lobe, "albedo"), e, 1.0, ggx && form == 1 ? 5e-3 : 1e-3);
            if (is_whole) assert_true(um_materials_lobe_albedo(&lobe, u * u) == 1.0);
          }
        }
}

static void energy(void **state)
{
  (void)state;
  each_lobe(conserves);
}

/* Independent samples in bins of about equal expectation, of the first number by `density`: bins of
 * the sampled distribution's own cosine and azimuth from the mirror direction. */
enum { RINGS = 8, SECTORS = 6, SAMPLES = 20000, FINE = 24 };

static int bin_of(struct um_vec3 i, struct um_vec3 axis, struct um_vec3 t, struct um_vec3 b,
                  const double edge[RINGS])
{
  if (!(i.z > 0.0)) return RINGS * SECTORS; /* below the surface */
  double c = um_vec3_dot(i, axis), phi = atan2(um_vec3_dot(i, b), um_vec3_dot(i, t)) + UM_PI;
  double delta = acos(fmin(1.0, fmax(-1.0, c)));
  int ring = 0, sector = (int)(phi / (2.0 * UM_PI) * SECTORS);
  while (ring < RINGS - 1 && delta > edge[ring]) ring++;
  return ring * SECTORS + (sector < SECTORS ? sector : SECTORS - 1);
}

/* Expected shares by the midpoint rule within each bin. */
static void expect(const struct um_materials_lobe *lobe, struct um_vec3 o, struct um_vec3 axis,
                   struct um_vec3 t, struct um_vec3 b, const double edge[RINGS], double *share)
{
  double all = 0.0;
  for (int bin = 0; bin < RINGS * SECTORS; bin++) {
    double from = bin < SECTORS ? 0.0 : edge[bin / SECTORS - 1], to = edge[bin / SECTORS];
    share[bin] = 0.0;
    for (int j = 0; j < 4 * FINE; j++)
      for (int k = 0; k < FINE; k++) {
        double delta = from + (to - from) * (j + 0.5) / (4 * FINE);
        double phi = -UM_PI + 2.0 * UM_PI * (bin % SECTORS + (k + 0.5) / FINE) / SECTORS;
        struct um_vec3 i = um_vec3_scale(axis, cos(delta));
        i = um_vec3_axpy(i, sin(delta) * cos(phi), t);
        i = um_vec3_axpy(i, sin(delta) * sin(phi), b);
        if (!(i.z > 0.0)) continue;
        struct um_materials_pair pair = um_materials_pair(i, o);
        share[bin] += lobe->kind->density(lobe, &pair) * sin(delta) * (to - from) / (4 * FINE) *
                      2.0 * UM_PI / SECTORS / FINE;
      }
    all += share[bin];
  }
  share[RINGS * SECTORS] = fmax(0.0, 1.0 - all);
}

/* A sample's weight is f cos_i over its density (1e-9: rounding in narrow lobes); chi-square with
 * the bins that expect 10 or more. Of some 350 tests one in 30 stays below 5 sigma of chi-square's
 * own spread only with one in 1e5 (k = 5 + a margin for its skewness). */
static void samples(const struct um_materials_lobe *lobe)
{
  if (lobe->kind->delta) return;
  for (size_t z = 0; z < 3; z++) {
    struct um_vec3 o = direction(zeniths[z] * UM_DEG, 0.4), axis = um_vec3(-o.x, -o.y, o.z), t, b;
    double edge[RINGS], share[RINGS * SECTORS + 1], width = lobe->kind->rough ? lobe->alpha : 1.0;
    int count[RINGS * SECTORS + 1] = {0};
    um_core_vec3_frame(axis, &t, &b);
    for (int r = 0; r < RINGS; r++)
      edge[r] = r < RINGS - 1 ? fmin(2.0 * atan(width * tan(1.4 * (r + 1) / RINGS)), UM_PI * 0.99)
                              : UM_PI;
    expect(lobe, o, axis, t, b, edge, share);
    double toward = um_materials_lobe_toward(lobe, o);
    for (uint64_t n = 0; n < SAMPLES; n++) {
      double u = um_core_hash_uniform(um_core_hash(7, n)),
             v = um_core_hash_uniform(um_core_hash(8, n));
      struct um_vec3 drawn = lobe->kind->draw(lobe, u, v);
      struct um_materials_reflected r;
      lobe->kind->reflect(lobe, &drawn, 1, o, toward, &r);
      count[bin_of(r.i, axis, t, b, edge)]++;
      assert_true(r.weight >= 0.0 && isfinite(r.weight));
      if (!(r.weight > 0.0)) continue;
      struct um_materials_pair pair = um_materials_pair(r.i, o);
      double density = lobe->kind->density(lobe, &pair);
      if (!lobe->kind->mixed) /* a mixture's are those of its parts, which the energy holds */
        check_near(say(lobe, "weight"),
                   r.weight * density / (lobe->kind->evaluate(lobe, &pair) * r.i.z), 1.0, 1e-6);
      check_near(say(lobe, "cos_d"), r.cos_d, pair.cos_d, 1e-12);
    }
    double chi2 = 0.0;
    int degrees = -1;
    for (int bin = 0; bin <= RINGS * SECTORS; bin++) {
      double expected = share[bin] * SAMPLES, error = count[bin] - expected;
      if (expected < 10.0) continue;
      chi2 += error * error / expected;
      degrees++;
    }
    if (!(chi2 <= degrees + 6.0 * sqrt(2.0 * degrees)))
      fail_msg("%s: chi-square %.1f of %d degrees, zenith %g", say(lobe, "samples"), chi2, degrees,
               zeniths[z]);
  }
}

static void sampling(void **state)
{
  (void)state;
  each_lobe(samples);
}

/* Energy under a lobe does not change with the Sun's width: of all that leaves toward all sides.
 * Where roughness is no wider than the Sun, 3e-3: the disc is a circle in half vectors, which it is
 * to 1/cos_d across the plane of incidence; else 1e-3. */
static void convolves(const struct um_materials_lobe *lobe)
{
  static const double suns[] = {0.004652, 0.02};
  for (size_t s = 0; s < 2; s++) {
    struct um_vec3 o = direction(20.0 * UM_DEG, 0.3);
    double without = lobe->kind->delta ? 1.0 : over_directions(lobe, o, 0.0, false);
    check_near(say(lobe, "energy of a disc"), over_directions(lobe, o, suns[s], false), without,
               lobe->kind->delta ? 5e-3 : 2e-3);
  }
}

static void sun_disc(void **state)
{
  (void)state;
  each_lobe(convolves);
}

/* A mixture is what it is made of, in value and under the Sun's disc, creased too: alpha^2 + 2 s^2.
 */
static void mixtures_are_sums(void **state)
{
  const struct um_materials_lobe_kind *beckmann = um_materials_lobe_kind_find("beckmann"),
                                      *ggx = um_materials_lobe_kind_find("ggx");
  const struct um_materials_mixture m = {0.7, {{beckmann, 0.1, false}, {ggx, 1.0, true}}};
  (void)state;
  for (int creased = 0; creased < 2; creased++)
    for (double zenith = 0.0; zenith < 80.0; zenith += 7.0) {
      double s2 = creased ? 0.01 : 0.0;
      struct um_materials_lobe whole = {
          um_materials_lobe_kind_find("mixture"), 0.4, 0.4, false, &m, 0.0, NULL, false};
      whole = um_materials_lobe_tilted(&whole, s2);
      double a = sqrt(0.0016 + 2.0 * s2), b = sqrt(0.16 + 2.0 * s2);
      struct um_materials_lobe one = {beckmann, a, a, false, NULL, 0.0, NULL, false},
                               two = {ggx, b, b, true, NULL, 0.0, NULL, false};
      struct um_materials_pair pair =
          um_materials_pair(direction(zenith * UM_DEG, 0.3), direction(25.0 * UM_DEG, 3.1));
      check_near("value", whole.kind->evaluate(&whole, &pair),
                 0.7 * beckmann->evaluate(&one, &pair) + 0.3 * ggx->evaluate(&two, &pair), 1e-12);
      check_near("sunlit", whole.kind->sunlit(&whole, &pair, sun_radius),
                 0.7 * beckmann->sunlit(&one, &pair, sun_radius) +
                     0.3 * ggx->sunlit(&two, &pair, sun_radius),
                 1e-12);
      double c = cos(zenith * UM_DEG);
      if (!creased) /* each to 2e-4 */
        check_near("albedo", um_materials_lobe_albedo(&whole, c),
                   0.7 * um_materials_lobe_albedo(&one, c) +
                       0.3 * um_materials_lobe_albedo(&two, c),
                   4e-4);
    }
}

/* --- published numbers ----------------------------------------------------------------------- */

static double albedo(const char *kind, double alpha, bool correlated, double zenith)
{
  struct um_materials_lobe lobe = {
      um_materials_lobe_kind_find(kind), alpha, alpha, correlated, NULL, 0.0, NULL, false};
  return um_materials_lobe_quadrature(&lobe, direction(zenith * UM_DEG, 0.0), 512, 256, NULL, NULL);
}

/* docs/physics/roughness-and-lobes.md: Beckmann, good to 1.5e-4 by their own grid; separable and
 * height-correlated. */
static void furnace(void **state)
{
  static const double alpha[] = {0.0296, 0.265, 0.326, 0.513};
  static const double separable[][4] = {{1.0, 1.0, 1.0, 1.0},
                                        {0.999986, 0.996818, 0.939120, 0.903363},
                                        {0.999155, 0.985204, 0.912995, 0.900835},
                                        {0.933629, 0.894827, 0.866644, 0.899773}};
  static const double correlated[] = {1.0, 0.939122, 0.913012, 0.867127};
  static const double angle[] = {0.0, 30.0, 60.0, 75.0};
  (void)state;
  for (int a = 0; a < 4; a++) {
    for (int z = 0; z < 4; z++)
      check_near("furnace", albedo("beckmann", alpha[a], false, angle[z]), separable[a][z], 2e-4);
    check_near("height-correlated", albedo("beckmann", alpha[a], true, 60.0), correlated[a], 2e-4);
  }
}

/* int D(h) G1(o) max(o.h, 0) dw_h = cos_o (Heitz 2014, eq. 22), to 1e-4: with h drawn from D cos_h
 * the mean of G1 (o.h)/(cos_o cos_h). G1 from the lobe itself: i along the normal has Lambda = 0,
 * so that D G1(o) = 4 cos_o f(n, o) at the same half vector. */
static void weak(const struct um_materials_lobe *lobe)
{
  enum { N = 800 };
  if (!lobe->kind->masked) return;
  for (size_t z = 0; z < ZENITHS; z++) {
    struct um_vec3 o = direction(zeniths[z] * UM_DEG, 0.7);
    double sum = 0.0, g = 1.0 / (1.0 + lobe->kind->toward(lobe, o));
    for (int j = 0; j < N; j++) {
      double s = (j + 0.5) / N, u = s * s * (3.0 - 2.0 * s);
      for (int k = 0; k < N / 2; k++) {
        struct um_vec3 h = lobe->kind->draw(lobe, u, (k + 0.5) / (N / 2));
        sum += 6.0 * s * (1.0 - s) * g * fmax(0.0, um_vec3_dot(o, h)) / (o.z * h.z);
      }
    }
    check_near(say(lobe, "weak furnace"), sum / N / (N / 2), 1.0, 1e-4);
  }
}

static void weak_furnace(void **state)
{
  (void)state;
  each_lobe(weak);
}

/* GGX in closed form (Walter et al. 2007, eqs 33, 34): D(0) = 1/(pi alpha^2), G1 = 2/(1 + sqrt(1 +
 * alpha^2 tan^2 theta)); at alpha tan theta = sqrt(3) G1 = 2/3; f of the mirror geometry. */
static void ggx_closed_forms(void **state)
{
  (void)state;
  for (size_t a = 0; a < sizeof alphas / sizeof alphas[0]; a++)
    for (int correlated = 0; correlated < 2; correlated++) {
      double alpha = alphas[a], zenith = atan(sqrt(3.0) / alpha), c = cos(zenith);
      struct um_materials_lobe lobe = {um_materials_lobe_kind_find("ggx"),
                                       alpha,
                                       alpha,
                                       correlated == 1,
                                       NULL,
                                       0.0,
                                       NULL,
                                       false};
      struct um_materials_pair pair = {c, c, 1.0, c, 0.0, 0.0, 0.0};
      double g = correlated ? 0.5 : 4.0 / 9.0; /* Lambda = 1/2 */
      check_near("peak", lobe.kind->evaluate(&lobe, &pair) * 4.0 * c * c * UM_PI * alpha * alpha, g,
                 1e-12);
      pair = (struct um_materials_pair){1.0, 1.0, cos(atan(alpha)), 1.0, 0.0, 0.0, 0.0};
      double c4 = pow(pair.cos_h, 4.0); /* D = 1/(4 pi alpha^2 c^4) at tan theta_h = alpha */
      check_near("half", lobe.kind->evaluate(&lobe, &pair) * 16.0 * UM_PI * alpha * alpha * c4, 1.0,
                 1e-12);
    }
}

/* The mean of GGX over the Sun's disc against points of the disc, in slopes, where it is exact. */
static void ggx_under_the_sun(void **state)
{
  enum { N = 400 };
  static const double offsets[] = {0.0, 0.5, 0.9, 1.3, 4.0}; /* of the disc's radius */
  double radius = 0.5 * sun_radius;
  (void)state;
  for (int a = 0; a < 3; a++)
    for (int k = 0; k < 5; k++) {
      double alpha = (double[]){0.0005, 0.002, 0.01}[a], t = offsets[k] * radius, sum = 0.0;
      struct um_materials_lobe lobe = {
          um_materials_lobe_kind_find("ggx"), alpha, alpha, false, NULL, 0.0, NULL, false};
      for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
          double r = radius * sqrt((j + 0.5) / N), phi = UM_PI * (i + 0.5) / N;
          double r2 = t * t + r * r - 2.0 * t * r * cos(phi), d = alpha * alpha + r2;
          sum += alpha * alpha / (UM_PI * d * d) / N / N;
        }
      struct um_materials_pair pair = {1.0, 1.0, 1.0 / sqrt(1.0 + t * t), 1.0, 0.0, 0.0, 0.0};
      double c4 = pow(pair.cos_h, 4.0);
      double mean = 4.0 * c4 * lobe.kind->sunlit(&lobe, &pair, sun_radius);
      check_near("GGX under the Sun", mean / sum, 1.0, 3e-3);
    }
}

/* docs/physics/light-curves.md: L = F E/Omega_sun inside the disc, and its edge. */
static void mirror_shows_the_sun(void **state)
{
  struct um_materials_lobe lobe = {
      um_materials_lobe_kind_find("mirror"), 0.0, 0.0, false, NULL, 0.0, NULL, false};
  double solid_angle = 2.0 * UM_PI * (1.0 - cos(sun_radius));
  (void)state;
  for (double zenith = 0.0; zenith < 80.0; zenith += 15.0)
    for (int turn = 0; turn < 8; turn++) {
      struct um_vec3 o = direction(zenith * UM_DEG, 0.0), axis = um_vec3(-o.x, -o.y, o.z), t, b;
      um_core_vec3_frame(axis, &t, &b);
      for (int side = 0; side < 2; side++) {
        double delta = sun_radius * (side == 0 ? 0.999 : 1.001), phi = turn * UM_PI / 4.0;
        struct um_vec3 i = um_vec3_scale(axis, cos(delta));
        i = um_vec3_axpy(i, sin(delta) * cos(phi), t);
        i = um_vec3_axpy(i, sin(delta) * sin(phi), b);
        struct um_materials_pair pair = um_materials_pair(i, o);
        check_near("offset", um_materials_pair_offset(&pair) / (1.0 - cos(delta)), 1.0, 1e-6);
        double radiance = lobe.kind->sunlit(&lobe, &pair, sun_radius) * i.z * solid_angle;
        check_near("radiance", radiance, side == 0 ? 1.0 : 0.0, 1e-6);
      }
    }
}

/* Phong at normal incidence reflects (n + 1)/(n + 2); Ashikhmin and Shirley's weights are min(1,
 * cos_i/cos_o), so that nothing but what falls below the surface is lost at normal incidence:
 * 2^-(n+1) is left of half vectors beyond 45 deg, cos^(n+1) of them, n = 2/alpha^2. */
static void powers_in_closed_form(void **state)
{
  (void)state;
  check_near("Phong", albedo("phong", 0.25, false, 0.0), 9.0 / 10.0, 1e-4);
  struct um_materials_lobe lobe = {
      um_materials_lobe_kind_find("phong"), 0.5, 0.5, false, NULL, 0.0, NULL, false};
  struct um_materials_pair pair = {1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
  check_near("Phong's peak", lobe.kind->evaluate(&lobe, &pair), 3.0 / (2.0 * UM_PI), 1e-12);
  lobe.kind = um_materials_lobe_kind_find("ashikhmin_shirley");
  lobe.alpha_across = 0.25; /* exponents 8 and 32 */
  check_near("peak", lobe.kind->evaluate(&lobe, &pair), sqrt(9.0 * 33.0) / (8.0 * UM_PI), 1e-12);
  /* E = int over half vectors of p(h) cos(2 theta_h): with n = 8, 9 int c^8 (2 c^2 - 1) dc */
  double c = sqrt(0.5), e = 18.0 / 11.0 * (1.0 - pow(c, 11.0)) - (1.0 - pow(c, 9.0));
  check_near("Ashikhmin-Shirley", albedo("ashikhmin_shirley", 0.5, false, 0.0), e, 1e-4);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(mixtures_are_sums),
      cmocka_unit_test(reciprocity),
      cmocka_unit_test(energy),
      cmocka_unit_test(nothing_is_lost),
      cmocka_unit_test(sampling),
      cmocka_unit_test(sun_disc),
      cmocka_unit_test(furnace),
      cmocka_unit_test(weak_furnace),
      cmocka_unit_test(ggx_closed_forms),
      cmocka_unit_test(ggx_under_the_sun),
      cmocka_unit_test(mirror_shows_the_sun),
      cmocka_unit_test(powers_in_closed_form),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
