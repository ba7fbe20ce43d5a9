/* Belts of 10 deg from 85 deg south to 85 deg north, January to December.
 *
 * Temperatures: means over land and sea, 1961-1990, of the climatology of Jones, New, Parker,
 * Martin & Rigor 1999, Rev. Geophys. 37:173. Cloud: means over the sea, of Esbensen & Kushnir 1981,
 * The heat budget of the global ocean (Oregon State University, Climatic Research Institute report
 * 29), taken for land as well; belts that it lacks, of ice, have what the next one has. Land:
 * shares of the belts, ice shelves included, 0.292 of the sphere; a coast line of 1 km gives the
 * same to 0.01 from 60 deg south to 80 deg north. */
#include "environment/zones.h"

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"

#define BELTS  18
#define BELT   10.0 /* [deg] */
#define MONTHS 12

/* clang-format off */
static const short temperature[MONTHS][BELTS] = { /* [K] */
    {250, 258, 273, 278, 285, 292, 297, 299, 299, 299, 297, 291, 281, 271, 263, 251, 247, 243},
    {240, 252, 271, 278, 285, 293, 298, 299, 299, 299, 297, 291, 282, 272, 263, 252, 246, 243},
    {228, 244, 268, 278, 285, 292, 297, 299, 300, 300, 298, 293, 284, 275, 268, 257, 248, 243},
    {224, 239, 265, 277, 284, 291, 296, 299, 300, 300, 299, 295, 287, 280, 275, 264, 255, 251},
    {222, 237, 264, 275, 283, 289, 294, 298, 300, 300, 300, 297, 290, 284, 280, 273, 265, 264},
    {222, 236, 263, 275, 282, 288, 292, 296, 299, 300, 300, 299, 293, 288, 284, 280, 273, 272},
    {220, 235, 261, 274, 281, 287, 291, 296, 298, 299, 300, 300, 296, 291, 287, 283, 275, 273},
    {220, 234, 261, 273, 281, 287, 291, 296, 298, 299, 300, 300, 296, 291, 286, 282, 274, 272},
    {221, 236, 262, 274, 281, 287, 292, 296, 298, 299, 300, 299, 294, 288, 282, 277, 270, 265},
    {229, 242, 265, 275, 282, 288, 293, 297, 299, 299, 300, 297, 290, 283, 277, 268, 261, 256},
    {241, 251, 269, 276, 283, 289, 295, 298, 299, 299, 299, 295, 286, 278, 270, 258, 252, 249},
    {250, 258, 272, 277, 284, 291, 296, 298, 299, 299, 298, 292, 283, 273, 265, 253, 248, 245},
};
static const signed char covered[MONTHS][BELTS] = { /* [%] */
    {93, 93, 92, 87, 69, 60, 55, 57, 60, 59, 50, 55, 66, 76, 78, 77, 77, 69},
    {91, 91, 86, 84, 71, 60, 54, 55, 58, 58, 49, 55, 67, 75, 78, 76, 76, 65},
    {80, 80, 82, 83, 69, 60, 57, 56, 57, 59, 48, 53, 66, 74, 77, 79, 72, 63},
    {82, 82, 82, 81, 71, 61, 55, 53, 56, 61, 51, 54, 66, 76, 78, 75, 78, 67},
    {79, 79, 79, 80, 71, 62, 54, 50, 53, 62, 52, 54, 67, 78, 82, 74, 83, 78},
    {80, 80, 80, 79, 70, 62, 54, 49, 52, 64, 59, 55, 67, 79, 83, 75, 82, 81},
    {79, 79, 79, 79, 69, 61, 56, 53, 53, 63, 62, 56, 61, 78, 85, 76, 84, 85},
    {80, 80, 80, 78, 69, 61, 56, 53, 53, 62, 60, 52, 57, 75, 82, 75, 84, 88},
    {80, 80, 80, 78, 70, 64, 57, 54, 56, 61, 59, 51, 56, 71, 80, 76, 84, 86},
    {81, 81, 81, 81, 71, 65, 60, 56, 56, 60, 56, 54, 62, 70, 78, 77, 86, 87},
    {81, 81, 82, 85, 71, 62, 59, 58, 57, 60, 53, 53, 63, 74, 78, 77, 77, 71},
    {82, 82, 83, 85, 71, 61, 57, 57, 58, 61, 52, 55, 65, 75, 78, 77, 80, 70},
};
static const signed char land[BELTS] = /* [%] */
    {100, 75, 10, 1, 3, 11, 23, 22, 24, 23, 26, 38, 43, 52, 57, 71, 29, 7};
/* clang-format on */

/* Belt below a latitude, and how far it lies toward the next one, 0..1. */
static size_t belt_of(double latitude, double *part)
{
  double row = (latitude / UM_DEG + 90.0) / BELT - 0.5;
  row = fmin(fmax(row, 0.0), BELTS - 1.0);
  size_t b = (size_t)fmin(row, BELTS - 2.0);
  *part = row - (double)b;
  return b;
}

double um_environment_zone_land(double latitude)
{
  double v;
  size_t b = belt_of(latitude, &v);
  return 0.01 * ((1.0 - v) * land[b] + v * land[b + 1]);
}

void um_environment_zones(double latitude, double month, double *surface, double *cloud)
{
  double page = month < 0.0 ? month + MONTHS : month; /* -0.5..11.5 */
  double v, w = page - floor(page);
  size_t b = belt_of(latitude, &v), m = (size_t)page % MONTHS, next = (m + 1) % MONTHS;
  *surface = *cloud = 0.0;
  for (int k = 0; k < 4; k++) {
    size_t at = k & 1 ? next : m, belt = b + (k >> 1 & 1);
    double weight = (k & 1 ? w : 1.0 - w) * (k & 2 ? v : 1.0 - v);
    *surface += weight * temperature[at][belt];
    *cloud += weight * 0.01 * covered[at][belt];
  }
}
