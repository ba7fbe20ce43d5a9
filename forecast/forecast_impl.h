/* Private to forecast/: one pass as a run, from its coordinates to its values. */
#ifndef UMBRA_STUDY_FORECAST_IMPL_H
#define UMBRA_STUDY_FORECAST_IMPL_H

#include "forecast/forecast.h"
#include "variant/evaluator.h"

/* Coordinates of a pass: number of its station, start, stop, culmination, t_tai [s]. */
#define UM_FORECAST_COORDINATES 4

/* What a pass needs to be run; nothing of it changes while a batch lives. */
struct um_forecast_work {
  const struct um_model *model;           /* the scenario as it stands */
  struct um_variant_evaluator *evaluator; /* of it, at one instant: its heat is where passes' heat
                                             starts from */
  const struct um_forecast_station *station; /* NULL: the scenario's own */
  char **pin; /* [npin] keys: what the scenario leaves to begin at its start begins there, and not
               * at the start of each pass */
  size_t npin, nband, nplace;
  const size_t *place; /* [nplace] of the body's places */
  bool light_has_sign; /* effects change readings, to below 0 perhaps */
};

/* Numbers in a pass: its delay, bands, places, times of the curves, curves. */
static inline size_t um_forecast_values(size_t nband, size_t nplace)
{
  return 1 + nband * sizeof(struct um_forecast_band) / sizeof(double) +
         nplace * sizeof(struct um_forecast_place) / sizeof(double) +
         (1 + 2 * nband) * UM_FORECAST_CURVE;
}

/* --- forecast_pass.c --- */
/* A run of a pass; user: the work. */
enum um_status um_forecast_compute(struct um_context *context, void *user, const double *coordinate,
                                   double *value);

/* Changes of the scenario: those that pin it, then times, then a station. step: between
 * observations [s]; NaN: the scenario's. Cleared by the caller, after a failure too. */
struct um_forecast_changes {
  struct um_document_change *key;
  struct um_model_changes all;
};
enum um_status um_forecast_changes(struct um_context *context, const struct um_forecast_work *work,
                                   size_t station, double start, double stop, double step,
                                   struct um_forecast_changes *out);
void um_forecast_changes_clear(struct um_context *context, struct um_forecast_changes *changes);

/* Find what is to be pinned. The caller frees pin and its texts. UM_ERR_MEMORY. */
enum um_status um_forecast_pin(struct um_context *context, const struct um_model *model,
                               struct um_forecast_work *work);

/* --- forecast_find.c --- */
/* Passes of a station that culminate in the days, behind those that there are. UM_ERR_INPUT: no
 * station, no orbit, more than UM_FORECAST_MOST; errors of um_model_create_orbit. */
enum um_status um_forecast_find(struct um_context *context, const struct um_forecast_work *work,
                                struct um_forecast *forecast, size_t station);
/* Has it a station and an orbit? */
enum um_status um_forecast_check_orbit(struct um_context *context, const struct um_model *orbit);

/* --- forecast_accepts.c --- */
/* um_batch_accepts of a pass; user: the work. The same rules as um_study_accepts, and times lie
 * within the curves'. */
bool um_forecast_accepts(void *user, const double *coordinate, const double *value);

#endif
