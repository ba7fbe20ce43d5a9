/* Orbit and attitude as tables (orbit/trajectory_table.c and orbit/attitude_table.c read them). */
#include "output/trajectory.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "model/build/timeline.h"
#include "orbit/attitude.h"
#include "orbit/time.h"

#define STEP  5.0  /* [s] */
#define TURN  0.2  /* [rad] between two rows */
#define SPARE 0.05 /* of what lies before the start, and */
#define ROUND 60.0 /* [s] at both ends: a table's period is not the orbit's to the second */
#define MOST  2e6  /* rows */
#define LEAST 1e-3 /* [s] between rows */

static bool is_there(struct um_context *context, const struct um_model *model, double t)
{
  struct um_environment_sample s;
  if (um_model_sample_at(context, model, t, &s) == UM_OK) return true;
  um_core_message_clear(context);
  return false;
}

enum um_status um_output_instants_choose(struct um_context *context, const struct um_model *model,
                                         struct um_output_instants *out)
{
  const struct um_scenario_time *time = model->scenario->time;
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  if (model->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: observations that stand alone have no orbit; accepted: an orbit other "
                        "than points",
                        model->scenario->at.file);
  double period = um_orbit_trajectory_period(model->trajectory);
  double orbits = fmax(thermal->orbits_before, thermal->start == UM_START_PERIODIC ? 1.0 : 0.0);
  double before = isnan(period) ? 0.0 : orbits * period;
  double from = time->start - before * (1.0 + SPARE) - time->exposure_s - ROUND;
  double to = time->stop + time->exposure_s + ROUND;
  /* tables of the scenario may end sooner: then what a run asks for, and no more */
  from = floor(from); /* a whole second of UTC */
  if (!is_there(context, model, from)) from = time->start - before;
  if (!is_there(context, model, from)) from = time->start;
  if (!is_there(context, model, to)) to = time->stop;
  double rate = um_orbit_attitude_rate(model->attitude, isnan(period) ? 0.0 : 2.0 * UM_PI / period);
  double step = rate > 0.0 ? fmin(STEP, TURN / rate) : STEP;
  out->step = fmax(LEAST, 1e-3 * floor(1e3 * step));
  double rows = floor((to - from) / out->step) + 2.0;
  if (!(rows <= MOST))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %.3g rows every %g s; accepted: at most %g, by a shorter time or "
                        "fewer thermal.orbits_before",
                        model->scenario->at.file, rows, out->step, MOST);
  out->from = from;
  out->count = (size_t)rows;
  /* the last row does not lie beyond what there is */
  while (out->count > 2 && !is_there(context, model, from + out->step * (double)(out->count - 1)))
    out->count--;
  return UM_OK;
}

/* Files of a trajectory: places, then turns; of each a table, a message of CCSDS, one of CNES. */
enum { TABLE, CCSDS, CIC, FORMS, FILES = 2 * FORMS };
static const char *const names[FILES] = {"orbit.csv",    "orbit.oem",    "orbit.cic",
                                         "attitude.csv", "attitude.aem", "attitude.cic"};

/* Numbers behind a time, into the three files of one kind. CNES counts days of a modified Julian
 * date and seconds of it. */
static void put_numbers(FILE *const file[FORMS], double t, const char *utc, const double *value,
                        int n)
{
  double day, seconds;
  um_orbit_time_utc_clock(t, &day, &seconds);
  fputs(utc, file[TABLE]);
  fputs(utc, file[CCSDS]);
  fprintf(file[CIC], "%.0f %.3f", day, seconds);
  for (int k = 0; k < n; k++) {
    char text[32];
    um_core_csv_put_exact(file[TABLE], value[k]);
    um_core_number_text(value[k], text);
    for (int form = CCSDS; form <= CIC; form++) fprintf(file[form], " %s", text);
  }
  for (int form = 0; form < FORMS; form++) fputc('\n', file[form]);
}

static void put_row(FILE *const file[FILES], double t, const char *utc,
                    const struct um_environment_sample *s)
{
  const double state[] = {1e-3 * s->r.x, 1e-3 * s->r.y, 1e-3 * s->r.z,
                          1e-3 * s->v.x, 1e-3 * s->v.y, 1e-3 * s->v.z};
  const double q[] = {s->q.w, s->q.x, s->q.y, s->q.z};
  put_numbers(file, t, utc, state, 6);
  put_numbers(file + FORMS, t, utc, q, 4);
}

/* Messages are dated by their first row: the same scenario gives the same bytes. */
static void put_heads(const struct um_model *model, const struct um_output_instants *instants,
                      FILE *const file[FILES])
{
  static const char *const versions[FILES] = {NULL, "CCSDS_OEM_VERS = 2.0", "CIC_OEM_VERS = 2.0",
                                              NULL, "CCSDS_AEM_VERS = 1.0", "CIC_AEM_VERS = 1.0"};
  const char *name = model->scenario->name;
  char first[32], last[32];
  um_orbit_time_format(instants->from, first);
  um_orbit_time_format(instants->from + instants->step * (double)(instants->count - 1), last);
  fputs("# GCRS\ntime_utc,x_km,y_km,z_km,vx_km_s,vy_km_s,vz_km_s\n", file[TABLE]);
  fputs("# GCRS to body axes, scalar first\ntime_utc,q0,q1,q2,q3\n", file[FORMS + TABLE]);
  for (int k = 0; k < FILES; k++) {
    bool cic = k % FORMS == CIC, turns = k >= FORMS;
    const char *frame = cic ? "ICRF" : "GCRF"; /* CNES knows no GCRF; their axes are one */
    if (versions[k] == NULL) continue;
    fprintf(file[k],
            "%s\nCREATION_DATE = %s\nORIGINATOR = UMBRA\n\nMETA_START\nOBJECT_NAME = %s\n"
            "OBJECT_ID = %s\nCENTER_NAME = EARTH\n",
            versions[k], first, name, name);
    if (turns)
      fprintf(file[k], "REF_FRAME_A = %s\nREF_FRAME_B = SC_BODY_1\nATTITUDE_DIR = A2B\n", frame);
    else
      fprintf(file[k], "REF_FRAME = %s\n", frame);
    fputs("TIME_SYSTEM = UTC\n", file[k]);
    if (!cic) fprintf(file[k], "START_TIME = %s\nSTOP_TIME = %s\n", first, last);
    if (turns) fputs("ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = FIRST\n", file[k]);
    if (!cic && !turns) fputs("INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 3\n", file[k]);
    fprintf(file[k], "META_STOP\n\n%s", turns && !cic ? "DATA_START\n" : "");
  }
}

static enum um_status put_rows(struct um_context *context, const struct um_model *model,
                               const struct um_output_instants *instants, FILE *const file[FILES])
{
  put_heads(model, instants, file);
  for (size_t i = 0; i < instants->count; i++) {
    struct um_environment_sample s;
    char utc[32];
    double t;
    if (i % 256 == 0) UM_TRY(um_core_stop_check(context, "tables were written"));
    um_orbit_time_format(instants->from + instants->step * (double)i, utc);
    UM_TRY(um_orbit_time_parse(context, utc, &t)); /* to the millisecond: that of the row */
    UM_TRY(um_model_sample_at(context, model, t, &s));
    put_row(file, t, utc, &s);
  }
  fputs("DATA_STOP\n", file[FORMS + CCSDS]);
  return UM_OK;
}

enum um_status um_output_write_trajectory(struct um_context *context, const struct um_model *model,
                                          const struct um_output_instants *instants,
                                          struct um_core_folder *folder)
{
  FILE *file[FILES] = {NULL};
  enum um_status status;
  for (int k = 0; k < FILES; k++)
    UM_CHECK(um_core_folder_open(context, folder, names[k], &file[k]));
  UM_CHECK(put_rows(context, model, instants, file));
done:
  for (int k = 0; k < FILES; k++) {
    if (file[k] == NULL) continue;
    enum um_status closed = um_core_file_close(context, names[k], &file[k]);
    if (status == UM_OK) status = closed;
  }
  return status;
}
