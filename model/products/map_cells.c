/* Interpolation in the cells of a map. A lobe is a parabola in the logarithm, a diffuse surface a
 * plane in the value, so a cell has the one or the other. */
#include "model/products/map_cells_impl.h"

#include <math.h>

#include "base/core/constants.h"

double um_model_map_between(const struct um_model_map *map, size_t phase, const uint32_t corner[4],
                            bool logarithmic, const double f[2], size_t band)
{
  const double weight[4] = {(1.0 - f[0]) * (1.0 - f[1]), (1.0 - f[0]) * f[1], f[0] * (1.0 - f[1]),
                            f[0] * f[1]};
  double sum = 0.0, floor = logarithmic ? map->floor[phase * map->nband + band] : 0.0;
  if (!(floor > 0.0)) logarithmic = false; /* a band that is dark everywhere */
  for (int k = 0; k < 4; k++) {
    double value = map->value[corner[k] * map->nband + band];
    sum += weight[k] * (logarithmic ? log(value + floor) : value);
  }
  return logarithmic ? exp(sum) - floor : sum;
}

void um_model_map_cell_add(const struct um_model_map *map, size_t phase,
                           const struct um_model_map_cell *cell, const double f[2], double weight,
                           double *out)
{
  double at[2] = {f[0], f[1]};
  if (weight == 0.0) return;
  while (cell->half != 0) {
    double *own = &at[cell->along];
    bool second = *own >= 0.5;
    *own = 2.0 * *own - (second ? 1.0 : 0.0);
    cell = &map->cell[cell->half + second];
  }
  for (size_t b = 0; b < map->nband; b++)
    out[b] += weight * um_model_map_between(map, phase, cell->corner, cell->logarithmic, at, b);
}

/* ---- mean ---- */

/* A cell and where it lies [rad]. */
struct patch {
  const struct um_model_map_cell *cell;
  double south, north, wide;
};

/* Integral over the solid angle by Simpson's rule, exact where the value is bilinear. */
static double integral(const struct um_model_map *map, size_t phase, const struct patch *p,
                       size_t band)
{
  double sum = 0.0;
  if (p->cell->half != 0) {
    const struct um_model_map_cell *half = &map->cell[p->cell->half];
    double middle = p->cell->along ? p->north : 0.5 * (p->south + p->north);
    struct patch first = {half, p->south, middle, p->wide},
                 second = {half + 1, middle, p->north, p->wide};
    if (p->cell->along) {
      first.wide = second.wide = 0.5 * p->wide;
      second.south = p->south;
    }
    return integral(map, phase, &first, band) + integral(map, phase, &second, band);
  }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      sum += (i == 1 ? 4.0 : 1.0) * (j == 1 ? 4.0 : 1.0) / 36.0 *
             um_model_map_between(map, phase, p->cell->corner, p->cell->logarithmic,
                                  (const double[2]){0.5 * i, 0.5 * j}, band);
  return sum * p->wide * (sin(p->north) - sin(p->south));
}

static struct um_model_map_cell of_grid(const struct um_model_map *map, size_t plane, size_t i,
                                        size_t j)
{
  if (map->cell != NULL) return *um_model_map_cell_of(map, plane, i, j);
  struct um_model_map_cell cell = {{0}, 0, false, false};
  for (size_t k = 0; k < 4; k++)
    cell.corner[k] = (uint32_t)((plane * map->nlatitude + i + k / 2) * map->nlongitude +
                                (j + k % 2) % map->nlongitude);
  return cell;
}

double um_model_map_mean(const struct um_model_map *map, size_t phase, size_t band)
{
  double sum = 0.0;
  for (size_t k = 0; k < map->nplane[phase]; k++)
    for (size_t i = 0; i + 1 < map->nlatitude; i++)
      for (size_t j = 0; j < map->nlongitude; j++) {
        double south = -0.5 * UM_PI + (double)i * map->step;
        struct um_model_map_cell cell = of_grid(map, map->first[phase] + k, i, j);
        struct patch patch = {&cell, south, south + map->step, map->step};
        sum += integral(map, phase, &patch, band);
      }
  return sum / (4.0 * UM_PI * (double)map->nplane[phase]);
}
