/* Tables of a BRDF over the hemisphere, of lobes in closed form. */
#ifndef UMBRA_TESTS_MATERIALS_TABLE_H
#define UMBRA_TESTS_MATERIALS_TABLE_H

#include <stdio.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "materials/lobe.h"
#include "materials/measured.h"

/* share/pi + rest f of a lobe. */
struct test_brdf {
  struct um_materials_lobe lobe; /* kind NULL: none */
  double diffuse, rest;          /* [1] */
};

/* phi: azimuth, 0 forward. */
static inline struct um_materials_pair test_pair(double theta_i, double theta_o, double phi)
{
  return um_materials_pair(um_vec3(-sin(theta_i), 0.0, cos(theta_i)),
                           um_vec3(sin(theta_o) * cos(phi), sin(theta_o) * sin(phi), cos(theta_o)));
}

static inline double test_brdf_at(const struct test_brdf *b, double theta_i, double theta_o,
                                  double phi)
{
  struct um_materials_pair pair = test_pair(theta_i, theta_o, phi);
  double f = b->diffuse / UM_PI;
  return b->lobe.kind == NULL ? f : f + b->rest * b->lobe.kind->evaluate(&b->lobe, &pair);
}

/* Polar angles in steps to `last`, azimuths in steps to 180 [deg]; the caller frees by
 * test_grid_free. */
static inline struct um_materials_measured_grid test_grid(const struct test_brdf *b, double step,
                                                          double last, double turn)
{
  struct um_materials_measured_grid g = {.npolar = (size_t)lround(last / step) + 1,
                                         .nazimuth = (size_t)lround(180.0 / turn) + 1};
  g.polar = malloc(g.npolar * sizeof *g.polar);
  g.azimuth = malloc(g.nazimuth * sizeof *g.azimuth);
  g.f = malloc(g.npolar * g.npolar * g.nazimuth * sizeof *g.f);
  for (size_t a = 0; a < g.npolar; a++) g.polar[a] = step * (double)a * UM_DEG;
  for (size_t k = 0; k < g.nazimuth; k++)
    g.azimuth[k] = UM_PI * (double)k / (double)(g.nazimuth - 1);
  for (size_t a = 0; a < g.npolar; a++)
    for (size_t c = 0; c < g.npolar; c++)
      for (size_t k = 0; k < g.nazimuth; k++)
        g.f[(a * g.npolar + c) * g.nazimuth + k] =
            test_brdf_at(b, g.polar[a], g.polar[c], g.azimuth[k]);
  return g;
}

/* The grid as a file. */
static inline void test_grid_write(const struct um_materials_measured_grid *g, const char *path)
{
  FILE *file = fopen(path, "w");
  if (file == NULL) abort();
  fprintf(file, "# made by a test\nincidence_deg,scattering_deg,azimuth_deg,brdf_1_sr\n");
  for (size_t a = 0; a < g->npolar; a++)
    for (size_t c = 0; c < g->npolar && (g->known == NULL || g->known[a]); c++)
      for (size_t k = 0; k < g->nazimuth; k++)
        fprintf(file, "%.12g,%.12g,%.12g,%.17g\n", g->polar[a] / UM_DEG, g->polar[c] / UM_DEG,
                g->azimuth[k] / UM_DEG, g->f[(a * g->npolar + c) * g->nazimuth + k]);
  if (fclose(file) != 0) abort();
}

/* Every so many of the polar angles to `last` [deg] was an angle of incidence. */
static inline void test_grid_thin(struct um_materials_measured_grid *g, size_t every, double last)
{
  g->known = calloc(g->npolar, sizeof *g->known);
  for (size_t a = 0; a < g->npolar; a += every) g->known[a] = g->polar[a] <= (last + 1e-6) * UM_DEG;
  for (size_t k = 0; k < g->npolar * g->npolar * g->nazimuth; k++)
    if (!g->known[k / g->nazimuth / g->npolar]) g->f[k] = 0.0;
}

static inline void test_grid_free(struct um_materials_measured_grid *g)
{
  free(g->polar);
  free(g->azimuth);
  free(g->f);
  free(g->known);
}

#endif
