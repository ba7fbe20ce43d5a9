/* Directional albedo of a measured BRDF, E(o) = int f cos_i dw_i by three Gauss points to a cell in
 * each angle. Where E > 1 is to be undone: f(i, o) s(i) s(o), s <- s/sqrt(E) until none is above 1,
 * which stays reciprocal and leaves alone what does not reach those directions. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/measured_impl.h"

#define ROUNDS 200  /* of renormalising, at most */
#define CLOSE  1e-7 /* above 1 [1] */

static enum um_status add_point(struct um_context *context, struct um_materials_measured *m,
                                size_t *room, double polar, double width)
{
  if (m->npoint == *room) {
    *room = 2 * *room + 64;
    UM_TRY(um_core_reallocate(context, *room, sizeof *m->point, &m->point));
  }
  m->point[m->npoint++] = (struct um_materials_measured_point){
      um_materials_measured_polar(m, polar), width * cos(polar) * sin(polar)};
  return UM_OK;
}

/* Gauss's points of a cell -0.5 to 0.5 and their weights. */
static const double gauss_at[3] = {-0.3872983346207417, 0.0, 0.3872983346207417};
static const double gauss_weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/* Of every cell; what lies beyond the last node in cells of 3 deg at most. */
static enum um_status place_points(struct um_context *context, struct um_materials_measured *m)
{
  size_t room = 0, n = m->npolar, na = m->nazimuth;
  for (size_t a = 1; a < n; a++) {
    double from = m->polar[a], to = a + 1 < n ? m->polar[a + 1] : 0.5 * UM_PI;
    int cells = a + 1 < n ? 1 : (int)ceil((to - from) / (3.0 * UM_DEG));
    double wide = (to - from) / cells;
    for (int c = 0; c < cells; c++)
      for (int g = 0; g < 3; g++)
        UM_TRY(add_point(context, m, &room, from + wide * (c + 0.5 + gauss_at[g]),
                         gauss_weight[g] * wide));
  }
  UM_TRY(um_core_allocate(context, 3 * (na - 3), sizeof *m->turn, &m->turn));
  for (size_t k = 1; k + 2 < na; k++)
    for (int c = 0; c < 3; c++) {
      double wide = m->azimuth[k + 1] - m->azimuth[k];
      double at = m->azimuth[k] + wide * (0.5 + gauss_at[c]);
      m->turn[m->nturn++] = (struct um_materials_measured_point){
          um_materials_measured_azimuth(m, at), 2.0 * gauss_weight[c] * wide};
    }
  return UM_OK;
}

static double albedo_toward(const struct um_materials_measured *m, double polar)
{
  struct um_materials_stencil o = um_materials_measured_polar(m, polar);
  double sum = 0.0;
  for (size_t p = 0; p < m->npoint; p++)
    for (size_t t = 0; t < m->nturn; t++)
      sum += m->point[p].weight * m->turn[t].weight *
             um_materials_measured_at(m, &m->point[p].at, &o, &m->turn[t].at);
  return sum;
}

static void find_albedo(struct um_materials_measured *m)
{
  m->most = 0.0;
  for (size_t j = 0; j < UM_MATERIALS_COSINES; j++) {
    double polar = acos(um_materials_node_cosine(j));
    m->albedo[j] = albedo_toward(m, polar);
    if (!(m->albedo[j] > m->most)) continue;
    m->most = m->albedo[j];
    m->most_at = polar;
  }
  m->mean = um_materials_hemispherical_mean(m->albedo, UM_MATERIALS_COSINES);
}

static void scale(struct um_materials_measured *m, const double *log_s)
{
  size_t n = m->npolar;
  for (size_t a = 0; a < n; a++)
    for (size_t b = 0; b < n; b++) {
      double by = log_s[a > 0 ? a : 2] + log_s[b > 0 ? b : 2];
      for (size_t k = 0; k < m->nazimuth; k++) um_materials_measured_row(m, a, b)[k] += by;
    }
}

/* At the nodes; false: some are above 1 after all rounds. */
static bool settle(struct um_materials_measured *m, double *log_s)
{
  for (int round = 0; round < ROUNDS; round++) {
    bool above = false;
    for (size_t a = 1; a < m->npolar; a++) {
      double e = albedo_toward(m, m->polar[a]);
      log_s[a] = e > 1.0 ? -0.5 * log(e) : 0.0;
      above = above || e > 1.0 + CLOSE;
    }
    if (!above) return true;
    scale(m, log_s);
  }
  return false;
}

static enum um_status renormalise(struct um_context *context, struct um_materials_measured *m)
{
  double *log_s;
  UM_TRY(um_core_allocate(context, m->npolar, sizeof *log_s, &log_s));
  bool settled = settle(m, log_s);
  find_albedo(m); /* between the nodes what is left is spread over all */
  for (size_t a = 0; a < m->npolar; a++) log_s[a] = m->most > 1.0 ? -0.5 * log(m->most) : 0.0;
  scale(m, log_s);
  find_albedo(m);
  um_core_free(context, log_s);
  if (settled && m->most <= 1.0 + CLOSE) return UM_OK;
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "a BRDF that reflects %g of what arrives could not be renormalised in %d "
                      "rounds; accepted: smoother tables",
                      m->found.albedo, ROUNDS);
}

double um_materials_measured_albedo(const struct um_materials_measured *m, double cosine)
{
  return um_materials_along_cosines(m->albedo, sqrt(fmax(0.0, fmin(1.0, cosine))));
}

double um_materials_measured_albedo_mean(const struct um_materials_measured *m) { return m->mean; }
double um_materials_measured_albedo_most(const struct um_materials_measured *m) { return m->most; }

enum um_status um_materials_measured_energy(struct um_context *context, bool renormalised,
                                            struct um_materials_measured *m)
{
  UM_TRY(place_points(context, m));
  find_albedo(m);
  m->found.albedo = m->most;
  m->found.albedo_at = m->most_at;
  m->found.renormalised = renormalised && m->most > 1.0;
  return m->found.renormalised ? renormalise(context, m) : UM_OK;
}
