/* Reflectances of the scenes, by doubling and adding (scatter_layer.c).
 *
 * Sea and land (daylight_ground.c) and snow, a layer of the phase function of cloud that lets
 * nothing through, lie under air of one atmosphere, in its lowest 2 km with aerosol of depth 0.1
 * (as sky_light.c has both); above all stand 300 DU of ozone, a shell. Cloud: layers that absorb
 * nothing, Henyey & Greenstein's of asymmetry 0.85 (of drops: Hu & Stamnes 1993, J. Climate 6:728),
 * over Lambert ground of 0.1, under 0.58 of the air (tops at 583 hPa: Rossow & Schiffer 1999, Bull.
 * Amer. Meteor. Soc. 80:2261). No cover is of one depth: a scene of cloud is the mean over depths
 * whose logarithms are normal about its own by 1.4, for of the clouds that they count about a half
 * are below 3.6 and a tenth above 23.
 *
 * What is reflected by sea and land without having been scattered is no sum of 32 terms, for glint
 * and hot spot are narrow: it is exact, as is what drops scatter once. */
#include "environment/daylight.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/daylight_ground_impl.h"
#include "environment/limb_air.h"
#include "environment/quadrature_impl.h"
#include "environment/sky_light_impl.h"

enum {
  N = UM_DAYLIGHT_COSINES,
  MODES = UM_SCATTER_MODES,
  DEPTHS = 13,   /* of cloud, each twice the one before */
  LEAST = 2,     /* of them below that of the first scene */
  THIN = 10,     /* doublings to the thinnest cloud */
  THIN_AIR = 10, /* .. to the air */
  OPAQUE = 2     /* .. from the thickest cloud to snow */
};

#define WAVELENGTH   0.55e-6
#define HAZE         0.1    /* as the environment's default */
#define OZONE        300.0  /* [DU] */
#define OZONE_HEIGHT 22e3   /* [m] */
#define DEPOLARISED  0.0141 /* g of sky_light.c */
#define DROPS        0.85
#define HAZY         0.22 /* of the air that has aerosol: the lowest 2 km */
#define BELOW_CLOUD  0.1
#define ABOVE_CLOUD  0.58
#define THINNEST     0.125 /* optical depth of cloud */
#define SPREAD       1.4   /* of its natural logarithm */

static double sine_of(double cosine) { return sqrt((1.0 - cosine) * (1.0 + cosine)); }

static void lambert_make(double albedo, int mode, struct um_environment_scatter_matrix *out)
{
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++)
      out->of[i][j] =
          mode > 0 ? 0.0 : albedo * um_environment_scatter_root(i) * um_environment_scatter_root(j);
}

/* A share of the air with aerosol, and its depth. */
static struct um_environment_scatter_phase air(double share, double haze, double *depth)
{
  double of[UM_LIMB_CONSTITUENTS], rayleigh;
  struct um_environment_scatter_phase phase = {.albedo = 0.0};
  um_environment_limb_depth(WAVELENGTH, of);
  rayleigh = share * of[UM_LIMB_AIR];
  *depth = rayleigh + haze;
  double hazy = UM_SKY_AEROSOL_ALBEDO * haze, scatters = rayleigh + hazy;
  double second = 0.1 * (1.0 - DEPOLARISED) / (1.0 + 2.0 * DEPOLARISED);
  for (int l = 0; l < MODES; l++) {
    double molecules = l == 0 ? 1.0 : l == 2 ? second : 0.0;
    phase.moment[l] = (hazy * pow(UM_SKY_AEROSOL_ASYMMETRY, l) + rayleigh * molecules) / scatters;
  }
  phase.albedo = scatters / *depth;
  return phase;
}

/* Ways through a thin shell over those straight up. */
static double through_shell(double cosine)
{
  double r = 1.0 + OZONE_HEIGHT / UM_EARTH_RADIUS;
  return 1.0 / sqrt(1.0 - (1.0 - cosine * cosine) / (r * r));
}

/* What is left of light that goes through the ozone down and up. */
static double past_ozone(double sun, double view)
{
  double of[UM_LIMB_CONSTITUENTS];
  um_environment_limb_depth(WAVELENGTH, of);
  return exp(-OZONE * of[UM_LIMB_OZONE] * (through_shell(sun) + through_shell(view)));
}

/* One term of all scenes. */
struct term {
  struct um_environment_scatter_matrix of[UM_DAYLIGHT_SCENES];
};
struct grounds {
  struct um_environment_daylight_ground sea, land;
};

/* Shares of the depths in a scene of cloud; those beyond the ends are with them. */
static void shares_of(int cloud, double share[DEPTHS])
{
  double sum = 0.0;
  for (int j = 0; j < DEPTHS; j++) share[j] = 0.0;
  for (int k = -20; k <= 20; k++) {
    double x = k * log(2.0) / SPREAD, weight = exp(-0.5 * x * x);
    int j = cloud + LEAST + k;
    share[j < 0 ? 0 : j < DEPTHS ? j : DEPTHS - 1] += weight;
    sum += weight;
  }
  for (int j = 0; j < DEPTHS; j++) share[j] /= sum;
}

static void layer_make(const struct um_environment_scatter_phase *phase, int mode, double depth,
                       int doublings, struct um_environment_scatter_layer *out)
{
  um_environment_scatter_thin(phase, mode, ldexp(depth, -doublings), out);
  for (int k = 0; k < doublings; k++) um_environment_scatter_double(out);
}

/* A layer of a share of the air with aerosol. */
static void air_make(double share, double haze, int mode, struct um_environment_scatter_layer *out)
{
  double depth;
  struct um_environment_scatter_phase phase = air(share, haze, &depth);
  layer_make(&phase, mode, depth, THIN_AIR, out);
}

static void term_make(int mode, const struct grounds *grounds, struct term *out)
{
  struct um_environment_scatter_layer low, clear, high, cloud;
  struct um_environment_scatter_phase drops = {.albedo = 1.0};
  static const struct um_environment_scatter_matrix nothing = {{{0.0}}};
  struct um_environment_scatter_matrix ground, together, one;
  double share[DEPTHS];
  air_make(HAZY, HAZE, mode, &low);
  air_make(1.0 - HAZY, 0.0, mode, &clear);
  air_make(ABOVE_CLOUD, 0.0, mode, &high);
  um_environment_scatter_over(&low, &grounds->sea.term[mode], &together);
  um_environment_scatter_over(&clear, &together, &out->of[UM_DAYLIGHT_SEA]);
  um_environment_scatter_over(&low, &grounds->land.term[mode], &together);
  um_environment_scatter_over(&clear, &together, &out->of[UM_DAYLIGHT_LAND]);
  lambert_make(BELOW_CLOUD, mode, &ground);
  for (int l = 0; l < MODES; l++) drops.moment[l] = pow(DROPS, l);
  layer_make(&drops, mode, THINNEST, THIN, &cloud);
  for (int k = 0; k < UM_DAYLIGHT_CLOUDS; k++) out->of[UM_DAYLIGHT_CLOUD + k] = nothing;
  for (int d = 0; d < DEPTHS; d++) {
    um_environment_scatter_over(&cloud, &ground, &together);
    um_environment_scatter_over(&high, &together, &one);
    for (int k = 0; k < UM_DAYLIGHT_CLOUDS; k++) {
      shares_of(k, share);
      for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
          out->of[UM_DAYLIGHT_CLOUD + k].of[i][j] += share[d] * one.of[i][j];
    }
    um_environment_scatter_double(&cloud);
  }
  for (int k = 1; k < OPAQUE; k++) um_environment_scatter_double(&cloud);
  um_environment_scatter_over(&low, &cloud.reflect, &together);
  um_environment_scatter_over(&clear, &together, &out->of[UM_DAYLIGHT_SNOW]);
}

/* What the moments leave out of the phase function of drops. */
static double clipped(double cosine)
{
  double sum = 0.0, before = 0.0, now = 1.0, moment = 1.0;
  for (int l = 0; l < MODES; l++) {
    double next = ((2.0 * l + 1.0) * cosine * now - l * before) / (l + 1.0);
    sum += (2.0 * l + 1.0) * moment * now;
    before = now;
    now = next;
    moment *= DROPS;
  }
  return (1.0 - DROPS * DROPS) * pow(1.0 + DROPS * DROPS - 2.0 * DROPS * cosine, -1.5) - sum;
}

/* Drops that scatter once: what is clipped of it; shares of their depths, NULL: of no end. */
static double once(double sun, double view, double c, const double *share)
{
  double part = share == NULL ? 1.0 : 0.0;
  for (int d = 0; d < DEPTHS && share != NULL; d++)
    part += share[d] * (1.0 - exp(-ldexp(THINNEST, d) * (1.0 / sun + 1.0 / view)));
  return 0.25 * part / (sun + view) * clipped(sine_of(sun) * sine_of(view) * c - sun * view);
}

/* Sum of the terms; and where light met the air no more than it must, the exact law in place of
 * theirs. ground: NULL, drops. above: depth of the air. */
static void scene_add_up(const struct term *term,
                         const struct um_environment_daylight_ground *ground, const double *share,
                         double above, enum um_daylight_scene scene,
                         struct um_environment_daylight *out)
{
  static const int steps = UM_DAYLIGHT_AZIMUTHS - 1;
  double cosine[2 * (UM_DAYLIGHT_AZIMUTHS - 1)];
  for (int k = 0; k < 2 * steps; k++) cosine[k] = cos(UM_PI * k / steps);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      double x = um_environment_scatter_cosine(i), y = um_environment_scatter_cosine(j);
      double roots = um_environment_scatter_root(i) * um_environment_scatter_root(j);
      double ozone = past_ozone(x, y), through = exp(-above * (1.0 / x + 1.0 / y)), sum[MODES];
      for (int m = 0; m < MODES; m++)
        sum[m] = (m > 0 ? 2.0 : 1.0) / roots *
                 (term[m].of[scene].of[i][j] -
                  (ground != NULL ? through * ground->term[m].of[i][j] : 0.0));
      for (int k = 0; k <= steps; k++) {
        double rho = through * (ground != NULL ? ground->rho[i][j][k * (UM_DAYLIGHT_FINE / steps)]
                                               : once(x, y, cosine[k], share));
        for (int m = 0; m < MODES; m++) rho += sum[m] * cosine[m * k % (2 * steps)];
        out->reflectance[scene][i][j][k] = (float)fmax(ozone * rho, 0.0);
      }
    }
}

/* Integrals of 2 mu over the hats of which the table is made, constant beyond its ends. */
static void hats_make(double hat[N])
{
  for (int i = 0; i < N; i++) {
    double x = um_environment_scatter_cosine(i), sum = 0.0;
    if (i > 0) {
      double y = um_environment_scatter_cosine(i - 1);
      sum += (x - y) * (2.0 * x + y) / 3.0;
    } else {
      sum += x * x;
    }
    if (i + 1 < N) {
      double y = um_environment_scatter_cosine(i + 1);
      sum += (y - x) * (2.0 * x + y) / 3.0;
    } else {
      sum += 1.0 - x * x;
    }
    hat[i] = sum;
  }
}

static void fluxes_make(enum um_daylight_scene scene, struct um_environment_daylight *out)
{
  static const int steps = UM_DAYLIGHT_AZIMUTHS - 1;
  double hat[N];
  hats_make(hat);
  out->albedo[scene] = 0.0;
  for (int i = 0; i < N; i++) {
    out->flux[scene][i] = 0.0;
    for (int j = 0; j < N; j++)
      for (int k = 0; k <= steps; k++)
        out->flux[scene][i] += hat[j] * (k == 0 || k == steps ? 0.5 : 1.0) / steps *
                               (double)out->reflectance[scene][i][j][k];
    out->albedo[scene] += hat[i] * out->flux[scene][i];
  }
}

static void scene_make(const struct term *term, const struct grounds *grounds, int scene,
                       struct um_environment_daylight *out)
{
  const struct um_environment_daylight_ground *ground = scene == UM_DAYLIGHT_SEA    ? &grounds->sea
                                                        : scene == UM_DAYLIGHT_LAND ? &grounds->land
                                                                                    : NULL;
  bool cloud = scene >= UM_DAYLIGHT_CLOUD;
  double above, share[DEPTHS];
  air(cloud ? ABOVE_CLOUD : 1.0, cloud ? 0.0 : HAZE, &above);
  if (cloud) shares_of(scene - UM_DAYLIGHT_CLOUD, share);
  scene_add_up(term, ground, cloud ? share : NULL, above, (enum um_daylight_scene)scene, out);
  fluxes_make((enum um_daylight_scene)scene, out);
}

enum um_status um_environment_daylight_make(struct um_context *context,
                                            struct um_environment_daylight **out)
{
  enum um_status status;
  struct um_environment_daylight *made = NULL;
  struct grounds *grounds = NULL;
  struct term *term = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *made, &made));
  UM_CHECK(um_core_allocate(context, 1, sizeof *grounds, &grounds));
  UM_CHECK(um_core_allocate(context, MODES, sizeof *term, &term));
  um_environment_daylight_sea(&grounds->sea);
  um_environment_daylight_land(&grounds->land);
#pragma omp parallel for schedule(dynamic) num_threads(um_core_context_threads(context))
  for (int m = 0; m < MODES; m++) term_make(m, grounds, &term[m]);
#pragma omp parallel for schedule(dynamic) num_threads(um_core_context_threads(context))
  for (int s = 0; s < UM_DAYLIGHT_SCENES; s++) scene_make(term, grounds, s, made);
  *out = made;
  made = NULL;
done:
  UM_FREE(context, made, grounds, term);
  return status;
}
