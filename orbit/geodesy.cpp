/* GeographicLib behind C: geodetic coordinates on the WGS-84 ellipsoid and local east-north-up.
 * Reference: Karney 2011, "Geodesics on an ellipsoid of revolution", arXiv 1102.1215, appendix B
 * (geocentric to geodetic, valid everywhere). */
#include "orbit/geodesy.h"

#include <GeographicLib/Geocentric.hpp>

#include <vector>

#include "base/core/constants.h"

namespace
{
double degrees(double radians) { return radians / UM_DEG; }
} // namespace

struct um_vec3 um_orbit_geodesy_forward(double latitude, double longitude, double height)
{
  double x, y, z;
  GeographicLib::Geocentric::WGS84().Forward(degrees(latitude), degrees(longitude), height, x, y,
                                             z);
  return {x, y, z};
}

void um_orbit_geodesy_reverse(struct um_vec3 r_itrf, double *latitude, double *longitude,
                              double *height)
{
  double lat, lon;
  GeographicLib::Geocentric::WGS84().Reverse(r_itrf.x, r_itrf.y, r_itrf.z, lat, lon, *height);
  *latitude = lat * UM_DEG;
  *longitude = lon * UM_DEG;
}

struct um_vec3 um_orbit_geodesy_enu(double latitude, double longitude, double height,
                                    struct um_vec3 r_itrf)
{
  double x, y, z;
  std::vector<double> m(9); /* row major, local to geocentric */
  GeographicLib::Geocentric::WGS84().Forward(degrees(latitude), degrees(longitude), height, x, y, z,
                                             m);
  double dx = r_itrf.x - x, dy = r_itrf.y - y, dz = r_itrf.z - z;
  /* enu = transpose(M) (r - r_origin) */
  return {m[0] * dx + m[3] * dy + m[6] * dz, m[1] * dx + m[4] * dy + m[7] * dz,
          m[2] * dx + m[5] * dy + m[8] * dz};
}

struct um_vec3 um_orbit_geodesy_from_enu(double latitude, double longitude, double height,
                                         struct um_vec3 enu)
{
  double x, y, z;
  std::vector<double> m(9);
  GeographicLib::Geocentric::WGS84().Forward(degrees(latitude), degrees(longitude), height, x, y, z,
                                             m);
  /* r = r_origin + M enu */
  return {x + m[0] * enu.x + m[1] * enu.y + m[2] * enu.z,
          y + m[3] * enu.x + m[4] * enu.y + m[5] * enu.z,
          z + m[6] * enu.x + m[7] * enu.y + m[8] * enu.z};
}
