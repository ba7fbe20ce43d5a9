/* What an observer sees, as a tracking data message. */
#include "output/tdm.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "orbit/time.h"

static void put(FILE *file, const char *key, const char *utc, double value)
{
  char text[32];
  if (!isfinite(value)) return;
  um_core_number_text(value, text);
  fprintf(file, "%s = %s %s\n", key, utc, text);
}

static void put_meta(const struct um_output_run *run, size_t band, FILE *file)
{
  const struct um_model *model = run->model;
  const struct um_scenario_station *station = model->scenario->observer->station;
  const char *site = station != NULL && station->name != NULL ? station->name : "OBSERVER";
  fprintf(file,
          "META_START\nCOMMENT magnitudes of band %s, relative to Vega, above the atmosphere where "
          "the scenario has none\nTIME_SYSTEM = UTC\nPARTICIPANT_1 = %s\nPARTICIPANT_2 = %s\n"
          "MODE = SEQUENTIAL\nPATH = 2,1\nTIMETAG_REF = RECEIVE\nRANGE_UNITS = km\n"
          "ANGLE_TYPE = AZEL\nMETA_STOP\n\nDATA_START\n",
          model->band[band].name, site, model->scenario->name);
}

enum um_status um_output_write_tdm(const struct um_output_run *run, FILE *file)
{
  const struct um_model_result *r = run->result;
  const struct um_model_tables *t = run->tables;
  char utc[32];
  um_orbit_time_format(t->t_obs[0], utc);
  fprintf(file, "CCSDS_TDM_VERS = 2.0\nCREATION_DATE = %s\nORIGINATOR = UMBRA\n\n", utc);
  bool first = true;
  for (size_t b = 0; b < r->nband; b++) {
    if (!isfinite(r->vega_ab[b])) continue;
    put_meta(run, b, file);
    for (size_t k = 0; k < r->nobs; k++) {
      const struct um_orbit_look *look = &t->look[k * t->nsub + t->nsub / 2];
      if (t->hidden[k]) continue;
      um_orbit_time_format(t->t_obs[k], utc);
      put(file, "MAG", utc, r->magnitude_ab[k * r->nband + b] - r->vega_ab[b]);
      if (!first) continue;
      put(file, "ANGLE_1", utc, look->azimuth / UM_DEG);
      put(file, "ANGLE_2", utc, look->elevation / UM_DEG);
      put(file, "RANGE", utc, 1e-3 * look->range);
    }
    fputs("DATA_STOP\n\n", file);
    first = false;
  }
  return UM_OK;
}
