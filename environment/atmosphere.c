/* Density of the upper atmosphere and the energy of its flow; see atmosphere.h. */
#include "environment/atmosphere.h"

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"

struct layer {
  double base, density, scale; /* [km], [kg/m^3], [km] */
};

/* Vallado 2013, table 8-4 */
static const struct layer layers[] = {
    {0, 1.225, 7.249},         {25, 3.899e-2, 6.349},    {30, 1.774e-2, 6.682},
    {40, 3.972e-3, 7.554},     {50, 1.057e-3, 8.382},    {60, 3.206e-4, 7.714},
    {70, 8.770e-5, 6.549},     {80, 1.905e-5, 5.799},    {90, 3.396e-6, 5.382},
    {100, 5.297e-7, 5.877},    {110, 9.661e-8, 7.263},   {120, 2.438e-8, 9.473},
    {130, 8.484e-9, 12.636},   {140, 3.845e-9, 16.149},  {150, 2.070e-9, 22.523},
    {180, 5.464e-10, 29.740},  {200, 2.789e-10, 37.105}, {250, 7.248e-11, 45.546},
    {300, 2.418e-11, 53.628},  {350, 9.518e-12, 53.298}, {400, 3.725e-12, 58.515},
    {450, 1.585e-12, 60.828},  {500, 6.967e-13, 63.822}, {600, 1.454e-13, 71.835},
    {700, 3.614e-14, 88.667},  {800, 1.170e-14, 124.64}, {900, 5.245e-15, 181.05},
    {1000, 3.019e-15, 268.00},
};
#define LAYERS (sizeof layers / sizeof layers[0])

#define EARTH_RATE 7.292115e-5           /* [rad/s] */
#define FLATTENING (1.0 / 298.257223563) /* WGS-84 */

double um_environment_atmosphere_density(double height)
{
  double h = fmax(height * 1e-3, 0.0);
  size_t k = LAYERS - 1;
  while (k > 0 && h < layers[k].base) k--;
  return layers[k].density * exp((layers[k].base - h) / layers[k].scale);
}

double um_environment_atmosphere_flow(const struct um_environment_sample *sample,
                                      struct um_vec3 *from)
{
  double r = um_vec3_norm(sample->r);
  *from = um_vec3(0, 0, 0);
  if (!(um_vec3_norm(sample->v) > 0.0)) return 0.0;
  struct um_vec3 turn = um_vec3_cross(um_vec3_scale(sample->pole, EARTH_RATE), sample->r);
  struct um_vec3 over = um_vec3_sub(sample->v, turn);
  double speed = um_vec3_norm(over);
  double s = um_vec3_dot(sample->r, sample->pole) / r; /* sine of the latitude */
  double height = r - UM_EARTH_RADIUS * (1.0 - FLATTENING * s * s);
  *from = um_vec3_scale(over, 1.0 / speed);
  return 0.5 * um_environment_atmosphere_density(height) * speed * speed * speed;
}
