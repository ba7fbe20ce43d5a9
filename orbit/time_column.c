/* The time column of a table of positions or quaternions. */
#include "orbit/time.h"
#include "orbit/time_column_impl.h"

enum um_status um_orbit_time_column(struct um_context *context, const struct um_core_csv *csv,
                                    size_t minimum, double **t_tai)
{
  enum um_status status;
  size_t column, rows = um_core_csv_rows(csv);
  double *t = NULL;
  *t_tai = NULL;
  UM_TRY(um_core_csv_require(context, csv, "time_utc", &column));
  if (rows < minimum)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows, at least %zu are accepted",
                        um_core_csv_name(csv), rows, minimum);
  UM_TRY(um_core_allocate(context, rows, sizeof *t, &t));
  for (size_t i = 0; i < rows; i++) {
    char why[160];
    if (!um_orbit_time_parse_field(um_core_csv_text(csv, i, column), &t[i], why, sizeof why))
      UM_CHECK(um_core_csv_fail(context, csv, i, column, "%s", why));
    if (i > 0 && !(t[i] > t[i - 1]))
      UM_CHECK(
          um_core_csv_fail(context, csv, i, column,
                           "%s is not after the row before it (%s); ascending times are accepted",
                           um_core_csv_text(csv, i, column), um_core_csv_text(csv, i - 1, column)));
  }
  *t_tai = t;
  return UM_OK;
done:
  um_core_free(context, t);
  return status;
}

enum um_status um_orbit_time_within(struct um_context *context, const char *path, const char *what,
                                    double t_tai, const double *t, size_t n)
{
  char at[32], first[32], last[32];
  if (t_tai >= t[0] && t_tai <= t[n - 1]) return UM_OK;
  um_orbit_time_format(t_tai, at);
  um_orbit_time_format(t[0], first);
  um_orbit_time_format(t[n - 1], last);
  return um_core_fail(context, UM_ERR_INPUT, "%s: %s is wanted at %s; the table covers %s to %s",
                      path, what, at, first, last);
}
