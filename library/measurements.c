/* Measurements, from a file or from arrays. */
#include "library/measurements_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "evidence/measurements/join.h"
#include "evidence/measurements/make.h"
#include "evidence/measurements/measurements.h"
#include "orbit/time_form.h"

#define NAME "measurements" /* what messages call arrays */

enum um_status um_library_measurements_take(struct um_context *context, struct umbra *umbra,
                                            struct um_compare_measurements **set,
                                            struct umbra_measurements **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  atomic_init(&(*out)->users, 1);
  (*out)->session = um_library_session_share(umbra);
  (*out)->set = *set;
  *set = NULL;
  return UM_OK;
}

enum umbra_status umbra_measurements_read(struct umbra *umbra, const char *path,
                                          struct umbra_measurements **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_compare_measurements *set = NULL;
  *out = NULL;
  enum um_status status = um_compare_measurements_read(context, path, &set);
  if (status == UM_OK) status = um_library_measurements_take(context, umbra, &set, out);
  um_compare_measurements_destroy(context, &set);
  return um_library_status(status);
}

static double number(const double *column, size_t i, double unit)
{
  return column == NULL ? (double)NAN : unit * column[i];
}

static enum um_status fill_row(struct um_context *context, const struct umbra_columns *c, size_t i,
                               struct um_compare_row *row)
{
  if (!um_orbit_time_from_unix(c->time_unix_s[i], &row->t_tai))
    return um_core_fail(context, UM_ERR_INPUT,
                        NAME ":%zu: time_unix_s %.10g; accepted: seconds of 1960 to 2100", i + 1,
                        c->time_unix_s[i]);
  row->quantity = c->quantity[i];
  row->of = c->of[i];
  row->value = c->value[i];
  row->sigma = number(c->sigma, i, 1.0);
  row->exposure = number(c->exposure_s, i, 1.0);
  row->flag = c->flag == NULL ? 0 : c->flag[i];
  row->track = c->track == NULL ? NULL : c->track[i];
  row->station = c->station == NULL ? NULL : c->station[i];
  row->satellite_height = number(c->satellite_height_km, i, 1e3);
  row->azimuth = number(c->azimuth_deg, i, UM_DEG);
  row->elevation = number(c->elevation_deg, i, UM_DEG);
  return UM_OK;
}

static enum um_status check_columns(struct um_context *context, const struct umbra_columns *c)
{
  UM_TRY(um_library_check_size(context, "struct umbra_columns", c->size, sizeof *c));
  if (c->time_unix_s != NULL && c->quantity != NULL && c->of != NULL && c->value != NULL)
    return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "a column is missing; accepted: time_unix_s, quantity, of and value at least");
}

enum umbra_status umbra_measurements_make(struct umbra *umbra, const struct umbra_columns *columns,
                                          struct umbra_measurements **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_compare_measurements *set = NULL;
  struct um_compare_row *row = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(check_columns(context, columns));
  UM_CHECK(um_core_allocate(context, columns->count, sizeof *row, &row));
  for (size_t i = 0; i < columns->count; i++) UM_CHECK(fill_row(context, columns, i, &row[i]));
  UM_CHECK(um_compare_measurements_make(context, NAME, row, columns->count, &set));
  UM_CHECK(um_library_measurements_take(context, umbra, &set, out));
done:
  um_core_free(context, row);
  um_compare_measurements_destroy(context, &set);
  return um_library_status(status);
}

/* The parts are only read; their type has no const, as of an array of pointers. */
static enum um_status join(struct um_context *context, const struct umbra_measurements *const *part,
                           const char *const *name, size_t n, struct um_compare_measurements **out)
{
  enum um_status status;
  struct um_compare_measurements **set = NULL;
  *out = NULL;
  if (n == 0)
    return um_core_fail(context, UM_ERR_INPUT, "no measurements to join; accepted: one and more");
  UM_TRY(um_core_allocate(context, n, sizeof(*set), (void **)&set));
  for (size_t i = 0; i < n; i++) {
    if (part[i]->set->nfile > 1)
      UM_CHECK(um_core_fail(context, UM_ERR_INPUT,
                            "measurements %zu are several sets already; accepted: one set each",
                            i + 1));
    set[i] = part[i]->set;
  }
  status = um_compare_measurements_join(context, set, name, n, out);
done:
  um_core_free(context, (void *)set);
  return status;
}

enum umbra_status umbra_measurements_join(struct umbra *umbra,
                                          const struct umbra_measurements *const *part,
                                          const char *const *name, size_t n,
                                          struct umbra_measurements **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_compare_measurements *set = NULL;
  *out = NULL;
  enum um_status status = join(context, part, name, n, &set);
  if (status == UM_OK) status = um_library_measurements_take(context, umbra, &set, out);
  um_compare_measurements_destroy(context, &set);
  return um_library_status(status);
}

struct umbra_measurements *um_library_measurements_share(struct umbra_measurements *measurements)
{
  atomic_fetch_add(&measurements->users, 1);
  return measurements;
}

void um_library_measurements_drop(struct umbra_measurements **measurements)
{
  if (measurements == NULL || *measurements == NULL) return;
  struct umbra_measurements *m = *measurements;
  *measurements = NULL;
  if (atomic_fetch_sub(&m->users, 1) != 1) return;
  struct umbra *session = m->session;
  um_compare_measurements_destroy(session->context, &m->set);
  UM_FREE(session->context, m->number, (void *)m->text, m->flag, m);
  um_library_session_drop(&session);
}

void umbra_measurements_close(struct umbra_measurements **measurements)
{
  um_library_measurements_drop(measurements);
}
