/* run.nc: when and where of the observations.
 *
 * `time` counts what a UTC clock shows: seconds since 00:00 of the first observation's day, every
 * day being taken as 86400 s, as readers do that know of no leap seconds (CF 1.8, 4.4.1, calendar
 * "standard"). It decodes to UTC at any time but inside a leap second, whose instants read as the
 * second after it. `time_tai` is the elapsed time, without a gap. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "orbit/time.h"
#include "output/netcdf_impl.h"

static const enum um_output_dimension t = UM_NC_TIME;

/* The instant nearest mid-exposure stands for the geometry of an observation, as in the CSV. */
static size_t middle(const struct um_model_tables *tables, size_t k)
{
  return k * tables->nsub + tables->nsub / 2;
}

static enum um_status put_clock(const struct um_output_netcdf *w, double *v)
{
  const struct um_model_tables *tables = w->run->tables;
  double day, mjd, seconds;
  char units[64], first[32], leap[160];
  um_orbit_time_utc_clock(tables->t_obs[0], &day, &seconds);
  um_orbit_time_format(um_orbit_time_from_utc_jd(2400000.5, day + 0.5), first); /* its noon */
  for (size_t k = 0; k < tables->nobs; k++) {
    um_orbit_time_utc_clock(tables->t_obs[k], &mjd, &seconds);
    v[k] = (mjd - day) * 86400.0 + seconds;
  }
  snprintf(units, sizeof units, "seconds since %.10s 00:00:00", first);
  UM_TRY(um_output_netcdf_double(w, "time", &t, 1, units,
                                 "UTC of mid-exposure at the observer, light received", v));
  UM_TRY(um_output_netcdf_note(w, "time", "standard_name", "time"));
  UM_TRY(um_output_netcdf_note(w, "time", "calendar", "standard"));
  int leaps = um_orbit_time_leap_seconds(tables->t_obs[0], tables->t_obs[tables->nobs - 1]);
  if (leaps == 0)
    snprintf(leap, sizeof leap, "none between the first and the last observation");
  else
    snprintf(leap, sizeof leap,
             "%d between the first and the last observation, not counted: the count is the UTC "
             "clock's, elapsed time is time_tai",
             leaps);
  UM_TRY(um_output_netcdf_note(w, "time", "leap_seconds", leap));
  for (size_t k = 0; k < tables->nobs; k++) v[k] = tables->t_obs[k];
  return um_output_netcdf_double(w, "time_tai", &t, 1, "s",
                                 "TAI of mid-exposure, counted from 2000-01-01T12:00:00 TAI", v);
}

/* What the age of two-line elements means for the place. */
static enum um_status note_orbit(const struct um_output_netcdf *w)
{
  const struct um_model *model = w->run->model;
  char text[160];
  if (isnan(model->orbit_age)) return UM_OK;
  snprintf(text, sizeof text,
           "elements %.2f days old at the first observation: ", model->orbit_age / 86400.0);
  size_t n = strlen(text);
  if (isnan(model->orbit_error))
    snprintf(text + n, sizeof text - n, "error not known");
  else
    snprintf(text + n, sizeof text - n, "1 sigma %.3g km, %.3g s along the track",
             1e-3 * model->orbit_error, model->orbit_delay);
  return um_output_netcdf_note(w, "position", "accuracy", text);
}

static enum um_status put_vectors(const struct um_output_netcdf *w, double *v)
{
  static const char *const names[3][3] = {
      {"position", "m", "satellite, GCRS"},
      {"sun_direction", "1", "satellite to Sun, GCRS, apparent"},
      {"observer_direction", "1", "satellite to observer, GCRS"}};
  const enum um_output_dimension tx[2] = {UM_NC_TIME, UM_NC_XYZ};
  const struct um_model_tables *tables = w->run->tables;
  for (int which = 0; which < (w->run->model->has_observer ? 3 : 2); which++) {
    for (size_t k = 0; k < tables->nobs; k++) {
      const struct um_environment_sample *s = &tables->sample[middle(tables, k)];
      struct um_vec3 x = which == 0 ? s->r : which == 1 ? s->sun : s->to_observer;
      v[3 * k] = x.x;
      v[3 * k + 1] = x.y;
      v[3 * k + 2] = x.z;
    }
    UM_TRY(um_output_netcdf_double(w, names[which][0], tx, 2, names[which][1], names[which][2], v));
  }
  return UM_OK;
}

/* What the observer sees, as in lightcurve.csv; NaN where it is not defined. */
static enum um_status put_look(const struct um_output_netcdf *w, double *v)
{
  static const char *const names[][3] = {
      {"azimuth", "degree", "of the satellite at the station, north over east"},
      {"elevation", "degree", "of the satellite at the station, without refraction"},
      {"apparent_elevation", "degree", "where refraction lifts it to, visible light at sea level"},
      {"range", "m", "satellite to observer"},
      {"airmass", "1",
       "relative optical airmass of the apparent elevation (Kasten and Young 1989)"},
      {"phase_angle", "degree", "Sun - satellite - observer"},
      {"sun_elevation", "degree", "of the Sun at the station, without refraction"}};
  const struct um_model_tables *tables = w->run->tables;
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    for (size_t k = 0; k < tables->nobs; k++) {
      const struct um_orbit_look *look = &tables->look[middle(tables, k)];
      const struct um_environment_sample *s = &tables->sample[middle(tables, k)];
      const double all[] = {look->azimuth / UM_DEG,
                            look->elevation / UM_DEG,
                            um_environment_apparent_elevation(look->elevation) / UM_DEG,
                            s->range,
                            um_environment_airmass_toward(look->elevation),
                            um_vec3_angle(s->sun, s->to_observer) / UM_DEG,
                            look->sun_elevation / UM_DEG};
      v[k] = all[i];
    }
    UM_TRY(um_output_netcdf_double(w, names[i][0], &t, 1, names[i][1], names[i][2], v));
  }
  return UM_OK;
}

static enum um_status put_hidden(const struct um_output_netcdf *w)
{
  const struct um_model_tables *tables = w->run->tables;
  int *hidden = NULL;
  UM_TRY(um_core_allocate(w->context, tables->nobs, sizeof *hidden, &hidden));
  for (size_t k = 0; k < tables->nobs; k++) hidden[k] = tables->hidden[k];
  enum um_status status = um_output_netcdf_int(
      w, "hidden", &t, 1, "1: below the horizon or behind the Earth, nothing arrives", hidden);
  um_core_free(w->context, hidden);
  return status;
}

enum um_status um_output_netcdf_times(const struct um_output_netcdf *w)
{
  enum um_status status;
  const struct um_model_tables *tables = w->run->tables;
  const enum um_output_dimension tq[2] = {UM_NC_TIME, UM_NC_QUATERNION};
  double *v = NULL;
  UM_TRY(um_core_allocate(w->context, 4 * tables->nobs, sizeof *v, &v));
  UM_CHECK(put_clock(w, v));
  UM_CHECK(um_output_netcdf_double(w, "sunlit_fraction", &t, 1, "1",
                                   "sunlit fraction of the solar disc", tables->sunlit));
  for (size_t k = 0; k < tables->nobs; k++) {
    struct um_quat q = tables->sample[middle(tables, k)].q;
    const double c[4] = {q.w, q.x, q.y, q.z};
    memcpy(v + 4 * k, c, sizeof c);
  }
  UM_CHECK(um_output_netcdf_double(w, "attitude", tq, 2, "1",
                                   "quaternion GCRS to body, scalar first, passive", v));
  UM_CHECK(put_vectors(w, v));
  UM_CHECK(note_orbit(w));
  if (w->run->model->has_observer) {
    UM_CHECK(put_look(w, v));
    UM_CHECK(put_hidden(w));
  }
done:
  um_core_free(w->context, v);
  return status;
}
