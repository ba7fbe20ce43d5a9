/* Crystals of some tens of um are large against light: twice their cross-section, whatever the
 * colour. At 10.5 um ice refracts hardly more than air and scatters least (Christiansen's effect),
 * beyond 11 um it absorbs most. */
#include "environment/cirrus.h"

#include <stddef.h>

#define FROM    7.0e-6  /* [m] */
#define STEP    0.25e-6 /* [m] */
#define GREY_TO 2e-6    /* [m] */
#define NROW    31
static const struct um_environment_ice row[NROW] = {
    {1.051, 0.425}, {1.055, 0.413}, {1.060, 0.402}, {1.067, 0.389}, {1.069, 0.380}, {1.068, 0.372},
    {1.076, 0.366}, {1.066, 0.362}, {1.049, 0.359}, {1.037, 0.356}, {1.049, 0.357}, {1.002, 0.363},
    {0.977, 0.373}, {0.898, 0.399}, {0.819, 0.425}, {0.820, 0.449}, {0.867, 0.465}, {0.907, 0.474},
    {0.935, 0.481}, {0.957, 0.488}, {0.975, 0.493}, {0.989, 0.497}, {1.001, 0.501}, {1.012, 0.506},
    {1.021, 0.509}, {1.028, 0.510}, {1.034, 0.512}, {1.041, 0.513}, {1.051, 0.514}, {1.056, 0.513},
    {1.060, 0.509},
};

struct um_environment_ice um_environment_ice_at(double wavelength)
{
  if (wavelength < GREY_TO) return (struct um_environment_ice){1.0, 0.0};
  double place = (wavelength - FROM) / STEP;
  if (!(place > 0.0)) return row[0];
  if (place >= NROW - 1) return row[NROW - 1];
  size_t k = (size_t)place;
  double f = place - (double)k;
  return (struct um_environment_ice){
      row[k].extinction + f * (row[k + 1].extinction - row[k].extinction),
      row[k].absorption + f * (row[k + 1].absorption - row[k].absorption)};
}
