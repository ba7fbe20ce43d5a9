/* Position table: cubic Hermite between rows, in GCRS.
 *
 * Between t_i and t_i+1, h apart, with u = (t - t_i) / h:
 *   r = (1 + 2u)(1-u)^2 r_i + u^2 (3-2u) r_i+1 + h u (1-u)^2 v_i - h u^2 (1-u) v_i+1
 * and v its derivative. Velocities that the table does not give are the slopes of the cubic spline
 * with not-a-knot ends (de Boor 1978, A Practical Guide to Splines, chapter IV). */
#include <string.h>

#include "base/core/constants.h"
#include "base/core/file.h"
#include "base/core/interpolation.h"
#include "orbit/time_column_impl.h"
#include "orbit/trajectory_impl.h"

#define BYTES ((size_t)1 << 30) /* of a file, as of any table */

static const char *const columns[7] = {"time_utc", "x_km",    "y_km",   "z_km",
                                       "vx_km_s",  "vy_km_s", "vz_km_s"};

enum um_status um_orbit_table_state(struct um_context *context, const struct um_orbit_table *table,
                                    double t_tai, struct um_vec3 *r, struct um_vec3 *v)
{
  UM_TRY(um_orbit_time_within(context, table->path, "a position", t_tai, table->t, table->n));
  size_t i = um_core_interval_find(table->t, table->n, t_tai);
  double h = table->t[i + 1] - table->t[i], u = (t_tai - table->t[i]) / h, w = 1.0 - u;
  struct um_vec3 a = table->r[i], b = table->r[i + 1];
  struct um_vec3 step = um_vec3_sub(b, a);
  /* r = a + u^2 (3 - 2u) (b - a) + h u w^2 v_a - h u^2 w v_b, kept as increments for accuracy */
  *r = um_vec3_axpy(a, u * u * (3.0 - 2.0 * u), step);
  *r = um_vec3_axpy(*r, h * u * w * w, table->v[i]);
  *r = um_vec3_axpy(*r, -h * u * u * w, table->v[i + 1]);
  *v = um_vec3_scale(step, 6.0 * u * w / h);
  *v = um_vec3_axpy(*v, w * (1.0 - 3.0 * u), table->v[i]);
  *v = um_vec3_axpy(*v, u * (3.0 * u - 2.0), table->v[i + 1]);
  return UM_OK;
}

void um_orbit_table_clear(struct um_context *context, struct um_orbit_table *table)
{
  UM_FREE(context, table->path, table->t, table->r, table->v);
  *table = (struct um_orbit_table){0};
}

/* Mean slope of interval i. */
static struct um_vec3 chord(const struct um_orbit_table *table, size_t i)
{
  return um_vec3_scale(um_vec3_sub(table->r[i + 1], table->r[i]),
                       1.0 / (table->t[i + 1] - table->t[i]));
}

/* Not-a-knot end condition: coefficients of s_0 and s_1 and the right side, from the two intervals
 * next to the end (h0 outermost). */
static struct um_vec3 end_condition(double h0, double h1, struct um_vec3 d0, struct um_vec3 d1,
                                    double *diagonal, double *off)
{
  double sum = h0 + h1;
  *diagonal = h1;
  *off = sum;
  /* h1 s0 + (h0 + h1) s1 = [ (h0 + 2 (h0 + h1)) h1 d0 + h0^2 d1 ] / (h0 + h1) */
  return um_vec3_axpy(um_vec3_scale(d0, (h0 + 2.0 * sum) * h1 / sum), h0 * h0 / sum, d1);
}

/* Slopes of the spline into table->v: tridiagonal system, Thomas elimination. n >= 4. */
static enum um_status spline_slopes(struct um_context *context, struct um_orbit_table *table)
{
  size_t n = table->n, last = n - 1;
  const double *t = table->t;
  double *ratio = NULL, diagonal, off;
  UM_TRY(um_core_allocate(context, n, sizeof *ratio, &ratio));
  struct um_vec3 *s = table->v;
  s[0] = end_condition(t[1] - t[0], t[2] - t[1], chord(table, 0), chord(table, 1), &diagonal, &off);
  s[0] = um_vec3_scale(s[0], 1.0 / diagonal);
  ratio[0] = off / diagonal;
  for (size_t i = 1; i < last; i++) {
    /* h_i s_i-1 + 2 (h_i-1 + h_i) s_i + h_i-1 s_i+1 = 3 (h_i d_i-1 + h_i-1 d_i) */
    double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    double pivot = 2.0 * (before + after) - after * ratio[i - 1];
    struct um_vec3 right = um_vec3_axpy(um_vec3_scale(chord(table, i - 1), 3.0 * after),
                                        3.0 * before, chord(table, i));
    s[i] = um_vec3_scale(um_vec3_axpy(right, -after, s[i - 1]), 1.0 / pivot);
    ratio[i] = before / pivot;
  }
  s[last] = end_condition(t[last] - t[last - 1], t[last - 1] - t[last - 2], chord(table, last - 1),
                          chord(table, last - 2), &diagonal, &off);
  s[last] = um_vec3_scale(um_vec3_axpy(s[last], -off, s[last - 1]),
                          1.0 / (diagonal - off * ratio[last - 1]));
  for (size_t i = last; i-- > 0;) s[i] = um_vec3_axpy(s[i], -ratio[i], s[i + 1]);
  um_core_free(context, ratio);
  return UM_OK;
}

/* A straight line through two rows, a parabola through three, the spline otherwise. */
static enum um_status slopes(struct um_context *context, struct um_orbit_table *table)
{
  struct um_vec3 *s = table->v;
  if (table->n == 2) {
    s[0] = s[1] = chord(table, 0);
    return UM_OK;
  }
  if (table->n > 3) return spline_slopes(context, table);
  double h0 = table->t[1] - table->t[0], h1 = table->t[2] - table->t[1];
  struct um_vec3 d0 = chord(table, 0), d1 = chord(table, 1);
  struct um_vec3 bend = um_vec3_scale(um_vec3_sub(d1, d0), 1.0 / (h0 + h1)); /* half of r'' */
  s[0] = um_vec3_axpy(d0, -h0, bend);
  s[1] = um_vec3_axpy(d0, h0, bend);
  s[2] = um_vec3_axpy(d1, h1, bend);
  return UM_OK;
}

/* Only known columns, and velocities all or none. */
static enum um_status columns_check(struct um_context *context, const struct um_core_csv *csv,
                                    bool *velocities)
{
  size_t given = 0;
  for (size_t c = 0; c < um_core_csv_columns(csv); c++) {
    bool known = false;
    for (size_t k = 0; k < 7; k++)
      known = known || strcmp(um_core_csv_header(csv, c), columns[k]) == 0;
    if (!known)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: column '%s' is unknown; time_utc,x_km,y_km,z_km and "
                          "vx_km_s,vy_km_s,vz_km_s are accepted",
                          um_core_csv_name(csv), um_core_csv_header(csv, c));
  }
  for (size_t k = 4; k < 7; k++) given += um_core_csv_find(csv, columns[k]) != (size_t)-1;
  if (given != 0 && given != 3)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %zu of the columns vx_km_s,vy_km_s,vz_km_s; all three or none are "
                        "accepted",
                        um_core_csv_name(csv), given);
  *velocities = given == 3;
  return UM_OK;
}

/* Three columns from `first` of the list above as vectors, times `unit`. */
static enum um_status vectors_read(struct um_context *context, const struct um_core_csv *csv,
                                   size_t first, double unit, struct um_vec3 *out)
{
  size_t column[3];
  for (size_t k = 0; k < 3; k++)
    UM_TRY(um_core_csv_require(context, csv, columns[first + k], &column[k]));
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    double x[3];
    for (size_t k = 0; k < 3; k++) UM_TRY(um_core_csv_number(context, csv, i, column[k], &x[k]));
    out[i] = um_vec3(unit * x[0], unit * x[1], unit * x[2]);
  }
  return UM_OK;
}

/* Each position outside the Earth and each velocity below that of light: a period, and states
 * between the rows, that are finite. */
static enum um_status rows_check(struct um_context *context, const struct um_core_csv *csv,
                                 const struct um_orbit_table *table, bool velocities)
{
  size_t x, vx;
  UM_TRY(um_core_csv_require(context, csv, columns[1], &x));
  for (size_t i = 0; i < table->n; i++) {
    double r = um_vec3_norm(table->r[i]);
    if (!(r >= UM_ORBIT_NEAREST && r <= UM_ORBIT_FARTHEST))
      return um_core_csv_fail(context, csv, i, x,
                              "the position is %g km from the geocentre; accepted: %g to %g km",
                              r / 1e3, UM_ORBIT_NEAREST / 1e3, UM_ORBIT_FARTHEST / 1e3);
  }
  if (!velocities) return UM_OK;
  UM_TRY(um_core_csv_require(context, csv, columns[4], &vx));
  for (size_t i = 0; i < table->n; i++) {
    double v = um_vec3_norm(table->v[i]);
    if (!(v < UM_LIGHT_SPEED))
      return um_core_csv_fail(context, csv, i, vx,
                              "the speed is %g km/s; accepted: less than light's", v / 1e3);
  }
  return UM_OK;
}

static enum um_status read_columns(struct um_context *context, const char *path, const char *text,
                                   size_t length, struct um_orbit_table *table)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  bool velocities = false;
  UM_TRY(um_core_csv_parse(context, path, text, length, &csv));
  UM_CHECK(columns_check(context, csv, &velocities));
  UM_CHECK(um_orbit_time_column(context, csv, 2, &table->t));
  table->n = um_core_csv_rows(csv);
  UM_CHECK(um_core_allocate(context, table->n, sizeof *table->r, &table->r));
  UM_CHECK(um_core_allocate(context, table->n, sizeof *table->v, &table->v));
  UM_CHECK(vectors_read(context, csv, 1, 1e3, table->r));
  if (velocities) UM_CHECK(vectors_read(context, csv, 4, 1e3, table->v));
  UM_CHECK(rows_check(context, csv, table, velocities));
  if (!velocities) UM_CHECK(slopes(context, table));
done:
  um_core_csv_destroy(&csv);
  return status;
}

enum um_status um_orbit_table_read(struct um_context *context, const char *path,
                                   const struct um_orbit_earth_orientation *orientation,
                                   struct um_orbit_table *table)
{
  char *text = NULL;
  size_t length;
  UM_TRY(um_core_strdup(context, path, &table->path));
  UM_TRY(um_core_file_read(context, path, BYTES, &text, &length));
  bool is;
  enum um_status status = um_orbit_oem_read(context, path, orientation, text, length, &is, table);
  if (status == UM_OK && !is) status = read_columns(context, path, text, length, table);
  um_core_free(context, text);
  return status;
}

/* 2 pi sqrt(a^3 / mu) of the osculating ellipse in the first row; NaN when it is open. */
static double osculating_period(struct um_vec3 r, struct um_vec3 v)
{
  /* 1/a = 2/r - v^2/mu */
  double inverse_a = 2.0 / um_vec3_norm(r) - um_vec3_dot(v, v) / UM_EARTH_GM;
  if (!(inverse_a > 0.0)) return NAN;
  return 2.0 * UM_PI / sqrt(UM_EARTH_GM * inverse_a * inverse_a * inverse_a);
}

double um_orbit_table_period(const struct um_orbit_table *table)
{
  return osculating_period(table->r[0], table->v[0]);
}
