/* A measured BRDF over the hemisphere, made reciprocal, interpolated, sampled. */
#ifndef UMBRA_MATERIALS_MEASURED_H
#define UMBRA_MATERIALS_MEASURED_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

#define UM_MATERIALS_MEASURED_NODES 4000000 /* directions of a table, at most */
#define UM_MATERIALS_MEASURED_REACH 75.0    /* polar angle that a table must reach [deg] */
#define UM_MATERIALS_MEASURED_FROM  60.0    /* incidence that a table must reach [deg] */

/* f on a grid, every direction of the one with every direction of the other. */
struct um_materials_measured_grid {
  double *polar;   /* [npolar] of incidence and of reflection alike, from 0, ascending [rad] */
  double *azimuth; /* [nazimuth] between the planes, from 0 (forward) to pi, ascending [rad] */
  double *f;       /* [npolar of incidence][npolar][nazimuth] [1/sr] above 0 where known */
  bool *known;     /* [npolar] was light sent from there? 0 and 3 others at least; NULL: all */
  size_t npolar, nazimuth;
  double sides; /* root of the mean square of ln f, right over left; 0 where one was measured [1] */
};

/* What a table was before it was made fit for use. */
struct um_materials_measured_found {
  double asymmetry;     /* root of the mean square of ln f(i, o)/f(o, i) [1] */
  double largest;       /* of |ln f(i, o)/f(o, i)| [1] */
  double largest_at[3]; /* where: incidence, reflection, azimuth [rad] */
  double sides;         /* as above [1] */
  size_t incidences;    /* how many angles were measured as incidences */
  double left_out; /* each of them but the outermost from the others: rms of ln f; 0 where all polar
                      angles were incidences [1] */
  double albedo;   /* the largest directional albedo [1]; above 1: more than arrives */
  double albedo_at;  /* polar angle of it [rad] */
  bool renormalised; /* brought to 1 where it was above */
};

struct um_materials_measured;

/* CSV of the columns incidence_deg, scattering_deg, azimuth_deg and brdf_1_sr, a row for every
 * direction, ascending in that order. Azimuth is 0 forward, where a mirror would send it, to 180,
 * or to 360: then both sides count. UM_ERR_INPUT with file, line and column: gaps, rows out of
 * order, a BRDF that is not above 0, angles that do not begin at 0, polar angles that end below
 * UM_MATERIALS_MEASURED_REACH, fewer than 4 incidences, or not to UM_MATERIALS_MEASURED_FROM, an
 * incidence that is no angle of reflection, too many rows; not finite numbers. UM_ERR_IO,
 * UM_ERR_MEMORY. The caller frees. */
enum um_status um_materials_measured_read(struct um_context *context, const char *path,
                                          struct um_materials_measured_grid *out);
void um_materials_measured_grid_free(struct um_context *context,
                                     struct um_materials_measured_grid *grid);

/* f = exp of ln f interpolated, f(i, o) on the grid the mean of both ways round; what was measured
 * neither way follows from the incidences about it (measured_fill.c). renormalise: where
 * the directional albedo is above 1, f(i, o) s(i) s(o) with the largest s that bring it to 1. The
 * grid stays the caller's. UM_ERR_NUMERIC: that did not converge; UM_ERR_MEMORY. */
enum um_status um_materials_measured_create(struct um_context *context,
                                            const struct um_materials_measured_grid *grid,
                                            bool renormalise, struct um_materials_measured **out);
void um_materials_measured_destroy(struct um_context *context, struct um_materials_measured **m);
struct um_materials_measured_found
um_materials_measured_found(const struct um_materials_measured *m);

/* f [1/sr] by the cosines with the normal and that of half the angle between the directions; 0
 * where a cosine is not positive. Beyond the last polar angle that of the last. */
double um_materials_measured_evaluate(const struct um_materials_measured *m, double cos_i,
                                      double cos_o, double cos_d);
/* Directional albedo int f cos_i dw_i toward a cosine, and its hemispherical mean [1]. */
double um_materials_measured_albedo(const struct um_materials_measured *m, double cosine);
double um_materials_measured_albedo_mean(const struct um_materials_measured *m);
/* The largest of it [1]. */
double um_materials_measured_albedo_most(const struct um_materials_measured *m);

/* Cosine of a half vector with the normal, by a number of [0, 1), and its density [1/sr]. */
double um_materials_measured_draw(const struct um_materials_measured *m, double u);
double um_materials_measured_half_density(const struct um_materials_measured *m, double cos_h);

#endif
