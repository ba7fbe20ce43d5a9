/* GeographicLib behind C: the main field as the gradient of a potential,
 *
 *   B = -grad U,  U = a sum_n (a/r)^(n+1) sum_m (g cos(m lon) + h sin(m lon)) P_nm(sin lat),
 *
 * with Schmidt's normalisation and a = 6371.2 km. Its sum by Clenshaw's recursion has no pole
 * (Holmes & Featherstone 2002, J. Geodesy 76:279). */
#include "orbit/magnetic_field.h"

#include <GeographicLib/SphericalHarmonic1.hpp>

#include <algorithm>
#include <functional>
#include <vector>

#include "orbit/magnetic_field_impl.h"

using GeographicLib::SphericalHarmonic1;

namespace
{
const double RADIUS = 6371.2e3;       /* of the reference sphere of IGRF [m] */
const double YEAR = 365.25 * 86400.0; /* [s] */
const int SPANS = UM_IGRF_EPOCHS - 1;

/* Coefficients where a span between epochs begins, and their change over it. */
struct igrf {
  std::vector<double> g[SPANS], h[SPANS], dg[SPANS], dh[SPANS];
  igrf()
  {
    for (int i = 0; i < SPANS; i++) {
      span(um_orbit_igrf_g[i], um_orbit_igrf_g[i + 1], g[i], dg[i]);
      span(um_orbit_igrf_h[i], um_orbit_igrf_h[i + 1], h[i], dh[i]);
    }
    /* the library's table of square roots is made here, once, not by several threads */
    GeographicLib::SphericalEngine::RootTable(UM_MAGNETIC_DEGREE);
  }
  template <size_t N>
  static void span(const double (&from)[N], const double (&to)[N], std::vector<double> &value,
                   std::vector<double> &change)
  {
    value.assign(from, from + N);
    change.resize(N);
    std::transform(to, to + N, from, change.begin(), std::minus<double>());
  }
};
} // namespace

struct um_vec3 um_orbit_magnetic_field(double t_tai, struct um_vec3 r_itrf, int degree)
{
  static const igrf all;
  const int N = UM_MAGNETIC_DEGREE;
  double year = 2000.0 + (t_tai + 43200.0) / YEAR;
  double place = std::clamp((year - UM_IGRF_FIRST) / UM_IGRF_STEP, 0.0, (double)SPANS);
  int i = std::min((int)place, SPANS - 1);
  SphericalHarmonic1 potential(all.g[i], all.h[i], N, degree, degree, all.dg[i], all.dh[i], N,
                               degree, degree, RADIUS, SphericalHarmonic1::SCHMIDT);
  double x, y, z;
  potential(place - i, r_itrf.x, r_itrf.y, r_itrf.z, x, y, z);
  const double k = -1e-9 * RADIUS;
  return {k * x, k * y, k * z};
}
