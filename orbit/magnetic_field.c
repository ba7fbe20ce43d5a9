/* The main field as the gradient of a potential,
 *
 *   B = -grad U,  U = a sum_n (a/r)^(n+1) sum_m (g cos(m lon) + h sin(m lon)) P_nm(sin lat),
 *
 * with Schmidt's normalisation, N_nm^2 = (2 - delta_m0) (n - m)!/(n + m)!, and a = 6371.2 km. The
 * gradient is taken in Cartesian coordinates, which have no pole, by Cunningham's recursions
 * (Montenbruck & Gill 2000, Satellite Orbits, 3.2.4 and 3.2.5). */
#include "orbit/magnetic_field.h"

#include <math.h>

#include "orbit/magnetic_field_impl.h"

#define RADIUS 6371.2e3           /* of the reference sphere of IGRF [m] */
#define YEAR   (365.25 * 86400.0) /* [s] */
#define SIZE   (UM_MAGNETIC_DEGREE + 2)

/* V_nm and W_nm = (a/r)^(n+1) P_nm(sin lat) times cosine and sine of m lon. */
struct harmonics {
  double v[SIZE][SIZE], w[SIZE][SIZE];
};

static void harmonics_make(struct um_vec3 r, int most, struct harmonics *out)
{
  double r2 = um_vec3_dot(r, r), rho = RADIUS * RADIUS / r2;
  double x = RADIUS * r.x / r2, y = RADIUS * r.y / r2, z = RADIUS * r.z / r2;
  out->v[0][0] = RADIUS / sqrt(r2);
  out->w[0][0] = 0.0;
  for (int m = 0; m <= most; m++) {
    if (m > 0) {
      double k = 2.0 * m - 1.0, v = out->v[m - 1][m - 1], w = out->w[m - 1][m - 1];
      out->v[m][m] = k * (x * v - y * w);
      out->w[m][m] = k * (x * w + y * v);
    }
    for (int n = m + 1; n <= most; n++) {
      double k = (2.0 * n - 1.0) / (n - m) * z, l = (n + m - 1.0) / (n - m) * rho;
      out->v[n][m] = k * out->v[n - 1][m] - (n > m + 1 ? l * out->v[n - 2][m] : 0.0);
      out->w[n][m] = k * out->w[n - 1][m] - (n > m + 1 ? l * out->w[n - 2][m] : 0.0);
    }
  }
}

/* Gradient of one term of the potential, coefficients c and s without normalisation. */
static struct um_vec3 gradient(const struct harmonics *h, int n, int m, double c, double s)
{
  const double *v = h->v[n + 1], *w = h->w[n + 1];
  struct um_vec3 g = {.z = -(n - m + 1.0) * (c * v[m] + s * w[m])};
  if (m == 0) {
    g.x = -c * v[1];
    g.y = -c * w[1];
    return g;
  }
  double k = (n - m + 2.0) * (n - m + 1.0);
  g.x = 0.5 * (-c * v[m + 1] - s * w[m + 1] + k * (c * v[m - 1] + s * w[m - 1]));
  g.y = 0.5 * (-c * w[m + 1] + s * v[m + 1] + k * (-c * w[m - 1] + s * v[m - 1]));
  return g;
}

static double schmidt(int n, int m)
{
  double ratio = 1.0; /* (n - m)!/(n + m)! */
  for (int i = n - m + 1; i <= n + m; i++) ratio /= i;
  return m == 0 ? 1.0 : sqrt(2.0 * ratio);
}

struct um_vec3 um_orbit_magnetic_field(double t_tai, struct um_vec3 r_itrf, int degree)
{
  struct um_vec3 sum = {0, 0, 0};
  struct harmonics h;
  double year = 2000.0 + (t_tai + 43200.0) / YEAR;
  double place = fmin(fmax((year - UM_IGRF_FIRST) / UM_IGRF_STEP, 0.0), UM_IGRF_EPOCHS - 1.0);
  int epoch = (int)fmin(place, UM_IGRF_EPOCHS - 2.0);
  double after = place - epoch;
  harmonics_make(r_itrf, degree + 1, &h);
  for (int i = 0; i < (int)(sizeof um_orbit_igrf / sizeof um_orbit_igrf[0]); i++) {
    const struct um_orbit_igrf_row *row = &um_orbit_igrf[i];
    if (row->n > degree) continue;
    double value = row->value[epoch] + after * (row->value[epoch + 1] - row->value[epoch]);
    value *= 1e-9 * schmidt(row->n, row->m);
    sum = um_vec3_add(sum, gradient(&h, row->n, row->m, row->part == 'g' ? value : 0.0,
                                    row->part == 'h' ? value : 0.0));
  }
  return um_vec3_scale(sum, -1.0);
}
