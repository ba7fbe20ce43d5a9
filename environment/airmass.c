/* X = 1 / (sin e + 0.50572 (e + 6.07995 deg)^-1.6364), e in degrees (Kasten & Young 1989). */
#include "environment/airmass.h"

#include <math.h>

#include "core/constants.h"

double um_environment_airmass(double elevation)
{
  if (!(elevation >= 0.0)) return NAN;
  return 1.0 / (sin(elevation) + 0.50572 * pow(elevation / UM_DEG + 6.07995, -1.6364));
}
