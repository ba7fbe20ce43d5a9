/* Incidences between those that were measured.
 *
 * A lobe goes with the mirror direction. In the plane whose radius is the polar angle and whose
 * angle is the azimuth, p = theta_o (cos phi, sin phi), that is at (theta_i, 0), and
 *   ln f(theta_i, p) = sum_a w_a ln f(a, p - (theta_i, 0) + (a, 0))
 * over four measured incidences a, w of the cubic between them: in the plane of incidence the half
 * angle stays, as facets want it. Incidence -a is a seen from the other side, f(-a, x, y) = f(a,
 * -x, y); beyond the last incidence the last goes on. What either way round was measured is taken
 * before what neither was. */
#include <math.h>

#include "materials/measured_impl.h"

/* ln f of the measured row `node` toward p. */
static double toward(const struct um_materials_measured *m, size_t node, double x, double y)
{
  struct um_materials_stencil o = um_materials_measured_polar(m, hypot(x, y)),
                              phi = um_materials_measured_azimuth(m, atan2(fabs(y), x));
  double sum = 0.0;
  for (size_t q = 0; q < 4; q++) {
    const double *g = um_materials_measured_row(m, node, o.first + q) + phi.first;
    for (size_t p = 0; p < 4; p++) sum += o.weight[q] * phi.weight[p] * g[p];
  }
  return sum;
}

/* Measured incidences with the mirror image of the second before the first; `without` a place of
 * the polar angles, or none. */
struct incidences {
  double *angle; /* [n] [rad] */
  size_t *node;  /* [n] rows of the table */
  size_t n;
};

static void collect(const struct um_materials_measured_grid *grid, size_t without,
                    struct incidences *out)
{
  out->n = 1;
  for (size_t a = 0; a < grid->npolar; a++) {
    if (!grid->known[a] || a == without) continue;
    out->angle[out->n] = grid->polar[a];
    out->node[out->n++] = a + 1;
  }
  out->angle[0] = -out->angle[2];
  out->node[0] = out->node[2];
}

/* ln f(theta_i, p). */
static double between(const struct um_materials_measured *m, const struct incidences *in,
                      double theta_i, double theta_o, double phi)
{
  struct um_materials_stencil s = um_materials_stencil_at(in->angle, in->n, false, theta_i);
  double sum = 0.0, x = theta_o * cos(phi) - theta_i, y = theta_o * sin(phi);
  for (size_t p = 0; p < 4; p++) {
    double a = in->angle[s.first + p], side = a < 0.0 ? -1.0 : 1.0;
    if (s.weight[p] != 0.0)
      sum += s.weight[p] * toward(m, in->node[s.first + p], side * (x + a), y);
  }
  return sum;
}

/* How well each incidence but the outermost two follows from the others. */
static double left_out(const struct um_materials_measured *m,
                       const struct um_materials_measured_grid *grid, struct incidences *in)
{
  size_t last = grid->npolar - 1;
  double squares = 0.0, count = 0.0;
  while (!grid->known[last]) last--;
  for (size_t a = 1; a < last; a++) {
    if (!grid->known[a]) continue;
    collect(grid, a, in);
    for (size_t b = 0; b < grid->npolar; b++)
      for (size_t k = 0; k < grid->nazimuth; k++) {
        double d = between(m, in, grid->polar[a], grid->polar[b], grid->azimuth[k]) -
                   um_materials_measured_row(m, a + 1, b + 1)[k + 1];
        squares += d * d;
        count += 1.0;
      }
  }
  return sqrt(squares / count);
}

enum um_status um_materials_measured_fill(struct um_context *context,
                                          const struct um_materials_measured_grid *grid,
                                          struct um_materials_measured *m)
{
  enum um_status status = UM_OK;
  struct incidences in = {NULL, NULL, 0};
  size_t n = grid->npolar, na = grid->nazimuth;
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *in.angle, &in.angle));
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *in.node, &in.node));
  m->found.left_out = left_out(m, grid, &in);
  collect(grid, n, &in);
  for (size_t a = 0; a < n; a++)
    for (size_t b = a; b < n; b++) {
      if (grid->known[a] || grid->known[b]) continue;
      for (size_t k = 0; k < na; k++) {
        double phi = grid->azimuth[k];
        double there = between(m, &in, grid->polar[a], grid->polar[b], phi),
               back = between(m, &in, grid->polar[b], grid->polar[a], phi);
        double value = 0.5 * (exp(um_materials_measured_bounded(there)) +
                              exp(um_materials_measured_bounded(back)));
        um_materials_measured_row(m, a + 1, b + 1)[k + 1] =
            um_materials_measured_row(m, b + 1, a + 1)[k + 1] = log(value);
      }
    }
done:
  UM_FREE(context, in.angle, in.node);
  return status;
}
