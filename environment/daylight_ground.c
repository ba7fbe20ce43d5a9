/* Laws of sea and land, and their Fourier terms in azimuth.
 *
 * Sea: facets of normal slopes of mean square 0.003 + 0.00512 v (Cox & Munk 1954, J. Opt. Soc. Am.
 * 44:838) at the wind v = 7 m/s, about the mean over the sea (Archer & Jacobson 2005, J. Geophys.
 * Res. 110:D12110), of index 1.34, with Smith's masking; over water that sends back 0.02, and foam
 * of 0.22 on 2.95e-6 v^3.52 of it (Koepke 1984, Appl. Opt. 23:1816). Land:
 *
 *   rho_0 (mu mu_0 (mu + mu_0))^(k - 1) F H
 *
 * of Rahman, Pinty & Verstraete 1993, J. Geophys. Res. 98:20791, F Henyey & Greenstein's of the
 * angle between Sun and view, H the hot spot; with k 0.75 and asymmetry -0.10. */
#include <math.h>

#include "base/core/constants.h"
#include "environment/daylight_ground_impl.h"
#include "materials/bsdf.h"

#define WIND          7.0  /* [m/s] */
#define WATER         1.34 /* index */
#define WATER_ALBEDO  0.02
#define FOAM          0.22
#define LAND          0.10 /* rho_0 */
#define LAND_EXPONENT 0.75
#define LAND_PHASE    (-0.10)

enum { N = UM_SCATTER_NODES };

/* rho of a ground; c: cosine of the azimuth from the mirrored Sun's. */
typedef double (*ground_law)(double sun, double view, double c);

static double sine_of(double cosine) { return sqrt((1.0 - cosine) * (1.0 + cosine)); }

static double sea(double sun, double view, double c)
{
  double along = sun * view - sine_of(sun) * sine_of(view) * c; /* i.o */
  double cos_d = sqrt(fmax(0.0, 0.5 * (1.0 + along)));
  double cos_h = cos_d > 0.0 ? fmin(0.5 * (sun + view) / cos_d, 1.0) : 1.0;
  double alpha = sqrt(0.003 + 0.00512 * WIND), foam = 2.95e-6 * pow(WIND, 3.52);
  return UM_PI * um_materials_fresnel(WATER, 0.0, cos_d) *
             um_materials_beckmann_lobe(alpha, cos_h, sun, view) +
         (1.0 - foam) * WATER_ALBEDO + foam * FOAM;
}

static double land(double sun, double view, double c)
{
  double phase = sun * view - sine_of(sun) * sine_of(view) * c; /* of the angle to the Sun */
  double a = sine_of(sun) / sun, b = sine_of(view) / view;
  double apart = sqrt(fmax(0.0, a * a + b * b + 2.0 * a * b * c)), t = LAND_PHASE;
  return LAND * pow(sun * view * (sun + view), LAND_EXPONENT - 1.0) * (1.0 - t * t) *
         pow(1.0 + t * t + 2.0 * t * phase, -1.5) * (1.0 + (1.0 - LAND) / (1.0 + apart));
}

static void ground_make(ground_law law, struct um_environment_daylight_ground *out)
{
  double cosine[2 * UM_DAYLIGHT_FINE];
  for (int k = 0; k < 2 * UM_DAYLIGHT_FINE; k++) cosine[k] = cos(UM_PI * k / UM_DAYLIGHT_FINE);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      double x = um_environment_scatter_cosine(i), y = um_environment_scatter_cosine(j);
      double roots = um_environment_scatter_root(i) * um_environment_scatter_root(j);
      for (int k = 0; k <= UM_DAYLIGHT_FINE; k++)
        out->rho[i][j][k] = j < i ? out->rho[j][i][k] : law(x, y, cosine[k]);
      for (int m = 0; m < UM_SCATTER_MODES; m++) {
        double sum =
            0.5 * (out->rho[i][j][0] + cosine[m * UM_DAYLIGHT_FINE % (2 * UM_DAYLIGHT_FINE)] *
                                           out->rho[i][j][UM_DAYLIGHT_FINE]);
        for (int k = 1; k < UM_DAYLIGHT_FINE; k++)
          sum += cosine[m * k % (2 * UM_DAYLIGHT_FINE)] * out->rho[i][j][k];
        out->term[m].of[i][j] = sum / UM_DAYLIGHT_FINE * roots;
      }
    }
}

void um_environment_daylight_sea(struct um_environment_daylight_ground *out)
{
  ground_make(sea, out);
}

void um_environment_daylight_land(struct um_environment_daylight_ground *out)
{
  ground_make(land, out);
}
