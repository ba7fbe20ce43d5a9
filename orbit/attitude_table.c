/* Attitude from a table of quaternions: time_utc,q0,q1,q2,q3, GCRS to body, scalar first, or a
 * message (aem.c); slerp between rows (Shoemake 1985). A gap longer than the limit is an error of
 * the file. */
#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/interpolation.h"
#include "base/core/order.h"
#include "orbit/attitude_table_impl.h"
#include "orbit/time.h"
#include "orbit/time_column_impl.h"

#include <stdlib.h>

#define BYTES ((size_t)1 << 30) /* of a file, as of any table */

static const double DEFAULT_GAP = 10.0; /* in median steps */

void um_orbit_attitude_table_clear(struct um_context *context,
                                   struct um_orbit_attitude_table *table)
{
  UM_FREE(context, table->path, table->t, table->q);
  *table = (struct um_orbit_attitude_table){0};
}

static enum um_status quaternions_read(struct um_context *context, const struct um_core_csv *csv,
                                       struct um_quat *q)
{
  static const char *const name[4] = {"q0", "q1", "q2", "q3"};
  size_t column[4];
  for (size_t k = 0; k < 4; k++) UM_TRY(um_core_csv_require(context, csv, name[k], &column[k]));
  if (um_core_csv_columns(csv) != 5)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu columns; time_utc,q0,q1,q2,q3 are accepted",
                        um_core_csv_name(csv), um_core_csv_columns(csv));
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    double x[4];
    for (size_t k = 0; k < 4; k++) UM_TRY(um_core_csv_number(context, csv, i, column[k], &x[k]));
    double norm = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
    if (!(fabs(norm - 1.0) <= UM_ORBIT_ATTITUDE_NORM))
      return um_core_csv_fail(context, csv, i, column[0],
                              "the quaternion has norm %.6g, 1 within %g is accepted", norm,
                              UM_ORBIT_ATTITUDE_NORM);
    q[i] = um_quat_normalize((struct um_quat){x[0], x[1], x[2], x[3]});
  }
  return UM_OK;
}

/* Median of the steps of t; n >= 2. */
static enum um_status median_step(struct um_context *context, const double *t, size_t n,
                                  double *median)
{
  double *step = NULL;
  UM_TRY(um_core_allocate(context, n - 1, sizeof *step, &step));
  for (size_t i = 0; i + 1 < n; i++) step[i] = t[i + 1] - t[i];
  qsort(step, n - 1, sizeof *step, um_core_order_double);
  *median = step[(n - 1) / 2];
  um_core_free(context, step);
  return UM_OK;
}

/* csv: NULL where the table is of a message. */
static enum um_status gaps_check(struct um_context *context, const struct um_core_csv *csv,
                                 const struct um_orbit_attitude_table *table, double max_gap)
{
  const double *t = table->t;
  if (!(max_gap > 0.0)) {
    UM_TRY(median_step(context, t, table->n, &max_gap));
    max_gap *= DEFAULT_GAP;
  }
  for (size_t i = 1; i < table->n; i++) {
    char at[32];
    if (t[i] - t[i - 1] <= max_gap) continue;
    if (csv != NULL) {
      size_t column = um_core_csv_find(csv, "time_utc");
      return um_core_csv_fail(context, csv, i, column,
                              "a gap of %.3f s before %s, at most %.3f s is accepted",
                              t[i] - t[i - 1], um_core_csv_text(csv, i, column), max_gap);
    }
    um_orbit_time_format(t[i], at);
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: a gap of %.3f s before %s, at most %.3f s is accepted", table->path,
                        t[i] - t[i - 1], at, max_gap);
  }
  return UM_OK;
}

static enum um_status read_columns(struct um_context *context, const char *text, size_t length,
                                   double max_gap, struct um_orbit_attitude_table *table)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  UM_TRY(um_core_csv_parse(context, table->path, text, length, &csv));
  UM_CHECK(um_orbit_time_column(context, csv, 2, &table->t));
  table->n = um_core_csv_rows(csv);
  UM_CHECK(um_core_allocate(context, table->n, sizeof *table->q, &table->q));
  UM_CHECK(quaternions_read(context, csv, table->q));
  UM_CHECK(gaps_check(context, csv, table, max_gap));
done:
  um_core_csv_destroy(&csv);
  return status;
}

enum um_status um_orbit_attitude_table_read(struct um_context *context, const char *path,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double max_gap, struct um_orbit_attitude_table *table)
{
  char *text = NULL;
  size_t length;
  UM_TRY(um_core_strdup(context, path, &table->path));
  UM_TRY(um_core_file_read(context, path, BYTES, &text, &length));
  bool is;
  enum um_status status = um_orbit_aem_read(context, path, orientation, text, length, &is, table);
  if (status == UM_OK && is) status = gaps_check(context, NULL, table, max_gap);
  if (status == UM_OK && !is) status = read_columns(context, text, length, max_gap, table);
  um_core_free(context, text);
  return status;
}

enum um_status um_orbit_attitude_table_at(struct um_context *context,
                                          const struct um_orbit_attitude_table *table, double t_tai,
                                          struct um_quat *q)
{
  UM_TRY(um_orbit_time_within(context, table->path, "an attitude", t_tai, table->t, table->n));
  size_t i = um_core_interval_find(table->t, table->n, t_tai);
  double u = (t_tai - table->t[i]) / (table->t[i + 1] - table->t[i]);
  *q = um_core_quat_slerp(table->q[i], table->q[i + 1], u);
  return UM_OK;
}

double um_orbit_attitude_table_rate(const struct um_orbit_attitude_table *table)
{
  double fastest = 0.0;
  for (size_t i = 0; i + 1 < table->n; i++) {
    struct um_quat turn = um_quat_then(um_quat_conjugate(table->q[i]), table->q[i + 1]);
    double s = sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    double angle = 2.0 * atan2(s, fabs(turn.w)); /* [rad] */
    fastest = fmax(fastest, angle / (table->t[i + 1] - table->t[i]));
  }
  return fastest;
}
