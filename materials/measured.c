/* A measured BRDF between its nodes.
 *
 *   ln f(theta_i, theta_o, phi) by cubics along each of the three, of three-point slopes:
 * continuous with its slope, above 0. Near its peak the logarithm of a lobe is smooth in the two
 * polar angles even where the lobe itself is as narrow as the steps: ln D = -tan^2(theta_h)/alpha^2
 * of Beckmann, theta_h = (theta_i - theta_o)/2 in the plane of incidence. Both polar angles go on
 * through the normal, f(-theta, phi) = f(theta, pi - phi) in a table that is even in phi; phi is
 * mirrored at 0 and pi.
 *
 * Reciprocity (Helmholtz): the table holds (f(i, o) + f(o, i))/2 on the same nodes for i and o.
 * Along the normal there is no azimuth: the mean over it. */
#include "materials/measured.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "materials/measured_impl.h"

/* --- interpolation --------------------------------------------------------------------------- */

struct um_materials_stencil um_materials_stencil_at(const double *x, size_t n, bool beyond,
                                                    double at)
{
  size_t most = beyond ? n - 2 : n - 1;
  if (!(at > x[1])) at = x[1];
  if (at > x[most]) at = x[most];
  size_t low = 1 + um_core_interval_find(x + 1, most, at);
  double a = x[low] - x[low - 1], b = x[low + 1] - x[low], t = (at - x[low]) / b;
  double left = t * (1.0 - t) * (1.0 - t) * b, right = -t * t * (1.0 - t) * b;
  double w[4] = {-left * b / (a * (a + b)), (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t),
                 t * t * (3.0 - 2.0 * t), 0.0};
  w[1] += left * (b - a) / (a * b);
  w[2] += left * a / (b * (a + b));
  struct um_materials_stencil s = {low - 1, {0.0}};
  if (low + 2 < n) {
    double c = x[low + 2] - x[low + 1];
    w[1] -= right * c / (b * (b + c));
    w[2] += right * (c - b) / (b * c);
    w[3] = right * b / (c * (b + c));
    for (int k = 0; k < 4; k++) s.weight[k] = w[k];
    return s;
  }
  /* the last cell: the parabola through its two nodes and the one before */
  w[0] += right * b / (a * (a + b));
  w[1] -= right * (a + b) / (a * b);
  w[2] += right * (2.0 * b + a) / (b * (a + b));
  s.first = low - 2;
  for (int k = 0; k < 3; k++) s.weight[k + 1] = w[k];
  return s;
}

struct um_materials_stencil um_materials_measured_polar(const struct um_materials_measured *m,
                                                        double polar)
{
  return um_materials_stencil_at(m->polar, m->npolar, false, polar);
}

struct um_materials_stencil um_materials_measured_azimuth(const struct um_materials_measured *m,
                                                          double azimuth)
{
  return um_materials_stencil_at(m->azimuth, m->nazimuth, true, azimuth);
}

double um_materials_measured_at(const struct um_materials_measured *m,
                                const struct um_materials_stencil *i,
                                const struct um_materials_stencil *o,
                                const struct um_materials_stencil *phi)
{
  double sum = 0.0;
  for (size_t p = 0; p < 4; p++) {
    double row = 0.0;
    for (size_t q = 0; q < 4; q++) {
      const double *g =
          m->log_f + ((i->first + p) * m->npolar + o->first + q) * m->nazimuth + phi->first;
      row += o->weight[q] * (phi->weight[0] * g[0] + phi->weight[1] * g[1] + phi->weight[2] * g[2] +
                             phi->weight[3] * g[3]);
    }
    sum += i->weight[p] * row;
  }
  return exp(um_materials_measured_bounded(sum));
}

double um_materials_measured_evaluate(const struct um_materials_measured *m, double cos_i,
                                      double cos_o, double cos_d)
{
  if (!(cos_i > 0.0 && cos_o > 0.0)) return 0.0;
  double ci = fmin(cos_i, 1.0), co = fmin(cos_o, 1.0);
  double sines = sqrt((1.0 - ci) * (1.0 + ci) * (1.0 - co) * (1.0 + co));
  /* i.o = 2 cos_d^2 - 1 = cos_i cos_o - sin_i sin_o cos(phi), phi 0 forward */
  double forward = sines > 0.0 ? (ci * co - 2.0 * cos_d * cos_d + 1.0) / sines : 1.0;
  struct um_materials_stencil i = um_materials_measured_polar(m, acos(ci)),
                              o = um_materials_measured_polar(m, acos(co)),
                              phi = um_materials_measured_azimuth(
                                  m, acos(fmax(-1.0, fmin(1.0, forward))));
  return um_materials_measured_at(m, &i, &o, &phi);
}

/* --- from the grid --------------------------------------------------------------------------- */

static double of(const struct um_materials_measured_grid *grid, size_t a, size_t b, size_t k)
{
  return grid->f[(a * grid->npolar + b) * grid->nazimuth + k];
}

static bool known(const struct um_materials_measured_grid *grid, size_t a)
{
  return grid->known == NULL || grid->known[a];
}

static void find_asymmetry(const struct um_materials_measured_grid *grid,
                           struct um_materials_measured_found *found)
{
  double squares = 0.0, count = 0.0;
  for (size_t a = 0; a < grid->npolar; a++)
    for (size_t b = a + 1; b < grid->npolar; b++)
      for (size_t k = 0; k < grid->nazimuth && known(grid, a) && known(grid, b); k++) {
        double difference = log(of(grid, a, b, k) / of(grid, b, a, k));
        squares += difference * difference;
        count += 1.0;
        if (!(fabs(difference) > found->largest)) continue;
        found->largest = fabs(difference);
        found->largest_at[0] = grid->polar[a];
        found->largest_at[1] = grid->polar[b];
        found->largest_at[2] = grid->azimuth[k];
      }
  found->asymmetry = sqrt(squares / count);
  found->sides = grid->sides;
}

/* Both ways round in the mean, or the one that was measured. */
static double both_ways(const struct um_materials_measured_grid *grid, size_t a, size_t b, size_t k)
{
  if (!known(grid, a)) return of(grid, b, a, k);
  if (!known(grid, b)) return of(grid, a, b, k);
  return 0.5 * (of(grid, a, b, k) + of(grid, b, a, k));
}

/* The same; along the normal over all azimuths, by trapezia. */
static double reciprocal(const struct um_materials_measured_grid *grid, size_t a, size_t b,
                         size_t k)
{
  if (a > 0 && b > 0) return both_ways(grid, a, b, k);
  double sum = 0.0;
  for (size_t j = 0; j + 1 < grid->nazimuth; j++) {
    double width = (grid->azimuth[j + 1] - grid->azimuth[j]) / UM_PI;
    sum += 0.5 * width * (both_ways(grid, a, b, j) + both_ways(grid, a, b, j + 1));
  }
  return sum;
}

/* What lies beyond the normal, in place 0 of either polar angle: the row of the first node behind
 * it at pi - phi, and beyond both the same phi again. */
static void go_through(struct um_materials_measured *m)
{
  for (size_t k = 0; k < m->nazimuth; k++) {
    double back = UM_PI - m->azimuth[k];
    struct um_materials_stencil s =
        um_materials_measured_azimuth(m, acos(cos(back))); /* folded into 0..pi */
    for (size_t a = 1; a < m->npolar; a++) {
      const double *row = um_materials_measured_row(m, a, 2) + s.first;
      double value = 0.0;
      for (size_t p = 0; p < 4; p++) value += s.weight[p] * row[p];
      um_materials_measured_row(m, a, 0)[k] = um_materials_measured_row(m, 0, a)[k] = value;
    }
    um_materials_measured_row(m, 0, 0)[k] = um_materials_measured_row(m, 2, 2)[k];
  }
}

/* What lies beyond 0 and pi of the azimuth, and beyond the normal. */
static void surround(struct um_materials_measured *m)
{
  size_t na = m->nazimuth;
  for (size_t a = 1; a < m->npolar; a++)
    for (size_t b = 1; b < m->npolar; b++) {
      double *row = um_materials_measured_row(m, a, b);
      row[0] = row[2];
      row[na - 1] = row[na - 3];
    }
  go_through(m);
}

static enum um_status fill(struct um_context *context,
                           const struct um_materials_measured_grid *grid,
                           struct um_materials_measured *m)
{
  size_t n = grid->npolar, na = grid->nazimuth;
  for (size_t a = 0; a < n; a++) m->polar[a + 1] = grid->polar[a];
  m->polar[0] = -grid->polar[1];
  for (size_t k = 0; k < na; k++) m->azimuth[k + 1] = grid->azimuth[k];
  m->azimuth[0] = -grid->azimuth[1];
  m->azimuth[na + 1] = 2.0 * UM_PI - grid->azimuth[na - 2];
  for (size_t a = 0; a < n; a++)
    for (size_t b = 0; b < n; b++) {
      double *row = um_materials_measured_row(m, a + 1, b + 1);
      for (size_t k = 0; k < na && (known(grid, a) || known(grid, b)); k++)
        row[k + 1] = log(reciprocal(grid, a, b, k));
    }
  surround(m);
  for (size_t a = 0; a < n; a++) m->found.incidences += known(grid, a);
  if (m->found.incidences == n) return UM_OK;
  UM_TRY(um_materials_measured_fill(context, grid, m));
  surround(m);
  return UM_OK;
}

/* --- life ------------------------------------------------------------------------------------ */

static enum um_status build(struct um_context *context,
                            const struct um_materials_measured_grid *grid, bool renormalised,
                            struct um_materials_measured *m)
{
  m->npolar = grid->npolar + 1;
  m->nazimuth = grid->nazimuth + 2;
  UM_TRY(um_core_allocate(context, m->npolar, sizeof *m->polar, &m->polar));
  UM_TRY(um_core_allocate(context, m->nazimuth, sizeof *m->azimuth, &m->azimuth));
  UM_TRY(
      um_core_allocate(context, m->npolar * m->npolar * m->nazimuth, sizeof *m->log_f, &m->log_f));
  UM_TRY(fill(context, grid, m));
  find_asymmetry(grid, &m->found);
  UM_TRY(um_materials_measured_energy(context, renormalised, m));
  um_materials_measured_shares(m);
  return UM_OK;
}

enum um_status um_materials_measured_create(struct um_context *context,
                                            const struct um_materials_measured_grid *grid,
                                            bool renormalised, struct um_materials_measured **out)
{
  struct um_materials_measured *m;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *m, &m));
  enum um_status status = build(context, grid, renormalised, m);
  if (status == UM_OK)
    *out = m;
  else
    um_materials_measured_destroy(context, &m);
  return status;
}

void um_materials_measured_destroy(struct um_context *context, struct um_materials_measured **m)
{
  if (m == NULL || *m == NULL) return;
  UM_FREE(context, (*m)->polar, (*m)->azimuth, (*m)->log_f, (*m)->point, (*m)->turn, *m);
  *m = NULL;
}

struct um_materials_measured_found
um_materials_measured_found(const struct um_materials_measured *m)
{
  return m->found;
}
