/* X = 1 / (sin a + 0.50572 (a + 6.07995 deg)^-1.6364), a in degrees (Kasten & Young 1989),
 * R = 1.02' cot(h + 10.3/(h + 5.11)), h in degrees without air, a = h + R, of air of 1010 hPa and
 * 283 K (Saemundsson 1986), times what our air has of that. */
#include "environment/airmass.h"

#include <math.h>

#include "base/core/constants.h"

/* Least error against rays through the US Standard Atmosphere; its density alone would give 0.986.
 */
#define FITTED 0.97
#define LOWEST (-1.0) /* where the form still ascends; nothing is seen there [deg] */

double um_environment_airmass(double apparent_elevation)
{
  if (!(apparent_elevation >= 0.0)) return NAN;
  return 1.0 /
         (sin(apparent_elevation) + 0.50572 * pow(apparent_elevation / UM_DEG + 6.07995, -1.6364));
}

double um_environment_apparent_elevation(double elevation)
{
  double h = fmax(elevation / UM_DEG, LOWEST);
  double r = FITTED * 1.02 / 60.0 / tan((h + 10.3 / (h + 5.11)) * UM_DEG); /* [deg] */
  return elevation + fmax(r, 0.0) * UM_DEG;
}

double um_environment_airmass_toward(double elevation)
{
  return um_environment_airmass(um_environment_apparent_elevation(elevation));
}
