/* Private to forecast/: one pass as a run, from its coordinates to its values. */
#ifndef UMBRA_STUDY_FORECAST_IMPL_H
#define UMBRA_STUDY_FORECAST_IMPL_H

#include "forecast/forecast.h"
#include "model/run/result.h"
#include "study/identity.h"
#include "study/parameter.h"
#include "variant/evaluator.h"

/* Coordinates of a pass: number of its station, start, stop, culmination, t_tai [s]. */
#define UM_FORECAST_COORDINATES 4

/* What is uncertain: parameters as those of a study, with sigma in place of a distribution. */
struct um_forecast_unknowns {
  struct um_study_file_parameter *parameter; /* [n] */
  struct um_study_binding *binding;          /* [n] */
  double *sigma;                             /* [n] [its unit] */
  size_t n;
  char **text; /* [ntext] owned, of the parameters */
  size_t ntext;
};

/* What a pass needs to be run; nothing of it changes while a batch lives. */
struct um_forecast_work {
  const struct um_model *model;           /* the scenario as it stands */
  const struct um_forecast_ask *times;    /* of times alone: `model` has no parts; else NULL */
  struct um_variant_evaluator *evaluator; /* of it, at one instant: its heat is where passes' heat
                                             starts from */
  const struct um_forecast_station *station; /* NULL: the scenario's own */
  char **pin; /* [npin] keys: what the scenario leaves to begin at its start begins there, and not
               * at the start of each pass */
  size_t npin, nband, nplace;
  const size_t *place; /* [nplace] of the body's places */
  bool light_has_sign; /* effects change readings, to below 0 perhaps */
  const bool *thermal; /* [nband] shines by its own heat; NULL without unknowns */
  struct um_forecast_unknowns unknowns;
  double checked; /* start of the pass whose bends are found by runs; NaN: none */
};

/* What a forecast keeps for its runs, behind the part that is public. */
struct um_forecast_held {
  struct um_forecast forecast;
  struct um_forecast_work work;
  struct um_forecast_ask ask;
  struct um_model *model;              /* the scenario as it stands */
  struct um_model_instants instant;    /* one, of `from` */
  size_t *place;                       /* [nplace] of the body's */
  double *coordinate;                  /* [npass][UM_FORECAST_COORDINATES] */
  struct um_forecast_band *band;       /* [npass][nband] */
  struct um_forecast_place *places;    /* [npass][nplace] */
  struct um_forecast_band *band_sigma; /* as those; of what is uncertain */
  struct um_forecast_place *places_sigma;
  struct um_study_identity *identity;
  bool holds_files;
};

/* Numbers in a pass: its delay, bands, places, times of the curves, curves. */
static inline size_t um_forecast_values(size_t nband, size_t nplace)
{
  return 1 + nband * sizeof(struct um_forecast_band) / sizeof(double) +
         nplace * sizeof(struct um_forecast_place) / sizeof(double) +
         (1 + 2 * nband) * UM_FORECAST_CURVE;
}

/* What a parameter is told of: bands, then places. */
static inline size_t um_forecast_told(const struct um_forecast_work *work)
{
  return work->nband + work->nplace;
}
/* Numbers in a record of a pass: values; where something is uncertain sigmas of them, too, then
 * parts and bends of each parameter. */
static inline size_t um_forecast_record(const struct um_forecast_work *work)
{
  size_t nvalue = um_forecast_values(work->nband, work->nplace), n = work->unknowns.n;
  return n == 0 ? nvalue : 2 * nvalue + 2 * n * um_forecast_told(work);
}

/* --- forecast_pass.c --- */
/* A run of a pass; user: the work. */
enum um_status um_forecast_compute(struct um_context *context, void *user, const double *coordinate,
                                   double *value);

/* What is kept of a run, in the order of um_forecast_values. */
void um_forecast_store(const struct um_forecast_work *work, const struct um_variant *variant,
                       const struct um_model_result *result, double culmination, double *value);

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

/* --- forecast_uncertain.c --- */
/* Read texts of what is uncertain [n] against work->model. UM_ERR_INPUT "--uncertain TEXT: ..": no
 * such effect, target, parameter, no number in the scenario at that key, one that passes have of
 * their own, no sigma above 0, no room to either side, one number twice, more than
 * UM_FORECAST_UNCERTAIN_MOST. The caller clears, after an error too. */
enum um_status um_forecast_uncertain_read(struct um_context *context,
                                          const struct um_forecast_work *work,
                                          const char *const *text, size_t n,
                                          struct um_forecast_unknowns *out);
void um_forecast_uncertain_clear(struct um_context *context, struct um_forecast_unknowns *unknowns);
/* Of names, values and sigmas. */
uint64_t um_forecast_uncertain_digest(const struct um_forecast_unknowns *unknowns);
/* How far a parameter goes to below (side 0) and above (1) its value [its unit]: sigma, or less
 * where its range ends and the other side is no better; 0: that side is left out. */
double um_forecast_uncertain_step(const struct um_forecast_unknowns *unknowns, size_t which,
                                  int side);

/* What the model says of changes that it does not take. */
static inline bool um_forecast_is_of_changes(enum um_status status)
{
  return status == UM_ERR_REFUSED || status == UM_ERR_INPUT || status == UM_ERR_NUMERIC;
}

/* --- forecast_tangent.c --- */
/* How heat answers to a parameter: number `which` of a run; NULL: heat does not feel it, or runs
 * have to tell. */
struct um_forecast_tangent {
  const struct um_model_thermal_sensitivity *of;
  size_t which;
};
struct um_forecast_tangents {
  struct um_forecast_tangent *of;            /* [unknowns] */
  struct um_model_thermal_sensitivity **run; /* [nrun] owned */
  size_t nrun;
};
/* Of all parameters, at the base of the evaluator. The caller clears, after an error too. */
enum um_status um_forecast_tangents_find(struct um_context *context,
                                         const struct um_forecast_unknowns *unknowns,
                                         struct um_variant_evaluator *evaluator,
                                         const struct um_variant *base,
                                         struct um_forecast_tangents *out);
void um_forecast_tangents_clear(struct um_context *context, struct um_forecast_tangents *tangents);

/* --- forecast_sigma.c --- */
/* Sigmas, parts and bends of a pass that is open over its instants, into a record behind its
 * values. checked: heat that was told by tangents is solved, too, for the bends. UM_ERR_INPUT,
 * UM_ERR_REFUSED, UM_ERR_NUMERIC naming the parameter that can be moved to no side; UM_ERR_INPUT:
 * one that moves the number of instants. */
enum um_status um_forecast_sigma(struct um_context *context, const struct um_forecast_work *work,
                                 const struct um_model_instants *instants, double culmination,
                                 bool checked, const struct um_variant *variant, double *record);

/* --- forecast_contribution.c --- */
/* Warn of parameters that at 1 sigma leave the line by more than this share of an error bar that
 * stands out of what a forecast is solved to, and of those that change nothing. */
#define UM_FORECAST_BEND 0.1
void um_forecast_tell_bends(struct um_context *context, const struct um_forecast *forecast);

/* --- forecast_find.c --- */
/* The scenario over the days as seen from a station. Errors of um_model_variant_create or
 * um_model_create_orbit. The caller destroys. */
enum um_status um_forecast_orbit(struct um_context *context, const struct um_forecast_work *work,
                                 const struct um_forecast *forecast, size_t station,
                                 struct um_model **out);
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
