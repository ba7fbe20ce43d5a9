/* Layers on a substrate against closed forms: Airy's film, the sheet, quarter and half waves,
 * V-coats and quarter-wave mirrors (Born & Wolf 1999, 1.6.4-1.6.5), a slab between half-spaces; and
 * laws: energy, order of what is not there, reciprocity of what passes. */
#include "check.h"

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "materials/bsdf.h"

static const double l = 0.55e-6;

static double cos_deg(double angle) { return cos(angle * UM_DEG); }

static struct um_materials_layer layer(double n, double k, double thickness, bool coherent)
{
  return (struct um_materials_layer){n, k, thickness, coherent};
}

static double matrix(const struct um_materials_layer *layers, size_t n, double ns, double ks,
                     double c)
{
  return um_materials_stack_passes(layers, n, ns, ks, l, c).reflected;
}

/* No layer is Fresnel's interface, one coherent is Airy's film, one thick the sheet, to rounding;
 * halves of a layer are the layer, and layers of vacuum or without thickness are not there. */
static void one_layer(void **state)
{
  (void)state;
  for (double angle = 0.0; angle < 90.0; angle += 12.5)
    for (int s = 0; s < 4; s++) {
      static const double substrate[][2] = {{0.958, 6.69}, {1.52, 0.0}, {0.3, 0.05}, {3.9, 0.02}};
      double c = cos_deg(angle), ns = substrate[s][0], ks = substrate[s][1];
      check_near("interface", matrix(NULL, 0, ns, ks, c), um_materials_fresnel(ns, ks, c), 1e-13);
      for (double k = 0.0; k < 0.6; k += 0.25) {
        struct um_materials_layer film = layer(1.7, k, 0.4e-6, true),
                                  sheet = layer(1.7, 0.01 * k, 25e-6, false);
        double airy = um_materials_fresnel_film(1.7, k, 0.4e-6, ns, ks, l, c);
        double sum = um_materials_fresnel_sheet(1.7, 0.01 * k, 25e-6, ns, ks, l, c);
        check_near("Airy", matrix(&film, 1, ns, ks, c), airy, 1e-13);
        check_near("sheet", matrix(&sheet, 1, ns, ks, c), sum, 1e-13);
        check_near("dispatch", um_materials_fresnel_stack(&film, 1, ns, ks, l, c), airy, 0.0);
        check_near("dispatch", um_materials_fresnel_stack(&sheet, 1, ns, ks, l, c), sum, 0.0);
        const struct um_materials_layer parts[] = {
            layer(1.0, 0.0, 3e-6, true), layer(1.7, k, 0.3e-6, true), layer(2.4, 0.3, 0.0, true),
            layer(1.7, k, 0.1e-6, true), layer(ns, ks, 0.2e-6, true)};
        check_near("parts of a film", matrix(parts, 5, ns, ks, c), airy, 1e-12);
      }
    }
}

/* A quarter wave of n1 with n1^2 = n0 n2 reflects nothing; two quarter waves n1, n2 on ns reflect
 * ((n2^2 - ns n1^2)/(n2^2 + ns n1^2))^2, none where (n2/n1)^2 = ns; half waves are absent. */
static void antireflection(void **state)
{
  double ns = 3.9, n1 = sqrt(ns);
  struct um_materials_layer v[] = {layer(n1, 0.0, l / (4.0 * n1), true),
                                   layer(1.0, 0.0, 0.0, true)};
  (void)state;
  check_near("n1^2 = n0 n2", matrix(v, 2, ns, 0.0, 1.0), 0.0, 1e-28);
  static const double pairs[][2] = {{1.38, 2.35}, {1.45, 2.1}, {2.0, 1.5}};
  for (int i = 0; i < 3; i++) {
    double a = pairs[i][0], b = pairs[i][1], w = (b * b - ns * a * a) / (b * b + ns * a * a);
    struct um_materials_layer two[] = {layer(a, 0.0, l / (4.0 * a), true),
                                       layer(b, 0.0, l / (4.0 * b), true)};
    check_near("two quarter waves", matrix(two, 2, ns, 0.0, 1.0), w * w, 1e-14);
    two[0].thickness *= 2.0;
    check_near("half over quarter", matrix(two, 2, ns, 0.0, 1.0),
               um_materials_fresnel_film(b, 0.0, two[1].thickness, ns, 0.0, l, 1.0), 1e-14);
  }
}

/* N pairs of quarter waves: R = ((1 - ns (h/g)^2N)/(1 + ns (h/g)^2N))^2, high index h outermost
 * (Born & Wolf 1.6.5, eq. 102 for a stack on ns). */
static void quarter_wave_mirror(void **state)
{
  struct um_materials_layer mirror[16];
  double h = 2.3, g = 1.38, ns = 1.52;
  (void)state;
  for (int n = 1; n <= 8; n++) {
    for (int i = 0; i < 2 * n; i++) {
      double index = i % 2 == 0 ? h : g;
      mirror[i] = layer(index, 0.0, l / (4.0 * index), true);
    }
    double y = ns * pow(h / g, 2.0 * n), r = (1.0 - y) / (1.0 + y);
    check_near("mirror", matrix(mirror, (size_t)(2 * n), ns, 0.0, 1.0), r * r, 1e-13);
  }
}

/* Thick slabs in closed form: R and T of a lossy plate before a half-space, with r, r' and t of one
 * pass, R = r + (1-r)^2 r' t^2/(1 - r r' t^2), T = (1-r)(1-r') t/(1 - r r' t^2) (Siegel & Howell,
 * ch. 18); a plate seen through a coated one: the coat's R, T from both sides enter. */
static void thick_slab(void **state)
{
  (void)state;
  for (double k = 0.0; k < 5e-3; k += 2e-3) {
    struct um_materials_layer slab[] = {layer(1.5, k, 20e-6, false), layer(2.5, 0.0, 1e-3, false)};
    double r = um_materials_fresnel(1.5, 0.0, 1.0), b = 0.0625,
           t = exp(-4.0 * UM_PI * k * 20e-6 / l);
    double more = um_materials_stack_passes(slab, 1, 2.5, 0.0, l, 1.0).transmitted;
    check_near("slab, T", more, (1.0 - r) * (1.0 - b) * t / (1.0 - r * b * t * t), 2e-6);
    /* a layer of the substrate's own index, lossless, changes nothing */
    check_near("own index", matrix(slab, 2, 2.5, 0.0, 1.0), matrix(slab, 1, 2.5, 0.0, 1.0), 1e-14);
  }
  /* coat of a quarter wave that takes the cover's own reflection away: what is left is the metal
   * below, and of what returns from it nothing is sent back. */
  double n = 1.45, coat = sqrt(n), metal = um_materials_fresnel(0.958 / n, 6.69 / n, 1.0);
  const struct um_materials_layer covered[] = {layer(coat, 0.0, l / (4.0 * coat), true),
                                               layer(n, 0.0, 150e-6, false)};
  check_near("coated cover", matrix(covered, 2, 0.958, 6.69, 1.0), metal, 1e-13);
  assert_true(matrix(covered + 1, 1, 0.958, 6.69, 1.0) > metal);
}

/* R + T = 1 where nothing absorbs, whatever lies on what, and never more where something does;
 * between lossless half-spaces a coherent stack passes the same both ways. */
static void energy(void **state)
{
  (void)state;
  for (uint64_t s = 0; s < 4000; s++) {
    struct um_materials_layer layers[8], turned[8];
    size_t n = 1 + um_core_hash(1, s) % 8;
    double lossy = s % 3 == 0 ? 0.3 : 0.0,
           ns = 1.0 + 3.0 * um_core_hash_uniform(um_core_hash(2, s));
    for (size_t i = 0; i < n; i++) {
      double u = um_core_hash_uniform(um_core_hash(3 + i, s)),
             v = um_core_hash_uniform(um_core_hash(20 + i, s));
      layers[i] = layer(1.0 + 2.0 * u, lossy * v, v * 1e-6, s % 2 == 0 || v < 0.6);
      turned[n - 1 - i] = layers[i];
    }
    double c = 0.05 + 0.95 * um_core_hash_uniform(um_core_hash(40, s));
    struct um_materials_passed p = um_materials_stack_passes(layers, n, ns, 0.0, l, c);
    assert_true(p.reflected >= 0.0 && p.transmitted >= 0.0);
    assert_true(p.reflected + p.transmitted <= 1.0 + 1e-12);
    if (lossy == 0.0) check_near("R + T", p.reflected + p.transmitted, 1.0, 1e-12);
    if (s % 2 == 0) {
      double there = um_materials_stack_passes(layers, n, 1.0, 0.0, l, c).transmitted;
      check_near("both ways", um_materials_stack_passes(turned, n, 1.0, 0.0, l, c).transmitted,
                 there, 1e-12);
    }
  }
}

/* The mean over a fringe of a lossless thin plate is the plate whose passes add as intensities,
 * also with a coherent coat above it and one below; a coat of metal reflects less on one side than
 * on the other. */
static void fringes_average(void **state)
{
  enum { STEPS = 256 };
  (void)state;
  for (int metal = 0; metal < 2; metal++)
    for (double angle = 0.0; angle < 80.0; angle += 20.0) {
      double c = cos_deg(angle), q = sqrt(1.5 * 1.5 - 1.0 + c * c), sum = 0.0;
      struct um_materials_layer three[] = {
          metal ? layer(0.4, 2.4, 12e-9, true) : layer(1.38, 0.0, 0.1e-6, true),
          layer(1.5, 0.0, 3e-6, true), layer(2.4, 0.0, 0.07e-6, true)};
      for (int i = 0; i < STEPS; i++) {
        three[1].thickness = 3e-6 + l / (2.0 * q) * i / STEPS;
        sum += matrix(three, 3, 3.9, 2.0 * metal, c) / STEPS;
      }
      three[1].coherent = false;
      check_near("fringe", sum, matrix(three, 3, 3.9, 2.0 * metal, c), 1e-9);
    }
}

/* Absorbing far beyond what exp holds: the first layer alone is seen, and no number is lost. */
static void opaque(void **state)
{
  struct um_materials_layer deep[] = {layer(0.1, 5.0, 4e-4, true), layer(2.0, 0.0, 1e-7, true),
                                      layer(1.5, 3.0, 1e-2, false)};
  (void)state;
  for (double angle = 0.0; angle < 90.0; angle += 15.0)
    check_near("opaque", matrix(deep, 3, 1.0, 0.0, cos_deg(angle)),
               um_materials_fresnel(0.1, 5.0, cos_deg(angle)), 1e-12);
  check_near("grazing", matrix(deep, 3, 1.5, 0.0, 0.0), 1.0, 0.0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(one_layer),  cmocka_unit_test(antireflection),
      cmocka_unit_test(energy),     cmocka_unit_test(quarter_wave_mirror),
      cmocka_unit_test(thick_slab), cmocka_unit_test(fringes_average),
      cmocka_unit_test(opaque),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
