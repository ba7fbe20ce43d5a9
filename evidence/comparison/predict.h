/* What a model says of every row of a measurement set: one set of geometry tables and one run for
 * all of them. */
#ifndef UMBRA_COMPARE_PREDICT_H
#define UMBRA_COMPARE_PREDICT_H

#include "evidence/measurements/set.h"
#include "model/build/model.h"
#include "model/build/timeline.h"
#include "model/geometry/precompute.h"
#include "model/run/result.h"

/* Which observation of geometry tables, and which number of it, answers each row. It
 * depends on the times, names and exposures of the rows and on the names of bands and places, so it
 * serves every variant of a scenario with the same parts and bands. */
struct um_compare_plan {
  const struct um_compare_measurements *measurements; /* borrowed */
  size_t ntime;
  double *time;     /* [ntime] observation times, t_tai [s]: not descending, strictly ascending
                       within a set but for points */
  double *exposure; /* [ntime] [s] */
  const char **set; /* [ntime] name of the set of measurements; borrowed from them */
  size_t *station;  /* [ntime] who looks, of the model's stations */
  struct um_model_point *point; /* [ntime] of a scenario with orbit.points; NULL with an orbit */
  size_t *observation; /* [count] of each row; UM_COMPARE_NOWHERE for a row that is left out */
  size_t *source;      /* [nchannel] band or place; UM_COMPARE_NOWHERE: no row of it is used */
};

/* Find the source of every channel and merge the times of all rows with flag 0: times within half a
 * microsecond are one observation, of one set. An empty exposure is that of other rows of the time,
 * else the scenario's. Temperatures are of a place: its full name ("bus.+x", "bus.interior",
 * "material:cfrp"), or the part of it behind the part's name ("+x", "interior", "front") where only
 * one place has it.
 *
 * Who looks is what column `station` of a row says, else its set, else the observer.
 *
 * With orbit.points every row says where the satellite is; rows are one observation where time,
 * station and geometry are the same, so that satellites seen at one time stay apart, and exposures
 * are their middles. With an orbit the geometry of rows is not used, and a warning says so.
 *
 * UM_ERR_INPUT, one line naming file and line of the first row at fault: a band, sensor, place or
 * observer that the scenario has not, a station that it has not, an ambiguous place, a time more
 * than one step outside time.start_utc to time.stop_utc, a time that orbit or attitude do not
 * cover, two exposures of one time or exposures that overlap, no row with flag 0; with orbit.points
 * a set without geometry, a satellite not above its station, a temperature (heat is not followed).
 * UM_ERR_MEMORY. The caller destroys. */
enum um_status um_compare_plan_create(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_measurements *measurements,
                                      struct um_compare_plan **out);
void um_compare_plan_destroy(struct um_context *context, struct um_compare_plan **plan);

/* When a plan looks at a model; borrowed from it. */
struct um_model_instants um_compare_plan_instants(const struct um_compare_plan *plan);
/* The scene at observation k of a plan. Errors of um_model_sample_from and um_model_sample_point.
 */
enum um_status um_compare_plan_sample(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_plan *plan, size_t k,
                                      struct um_environment_sample *sample,
                                      struct um_orbit_look *look);
/* The geometry tables of a plan: um_model_precompute_over at its instants. */
enum um_status um_compare_plan_trace(struct um_context *context, const struct um_model *model,
                                     const struct um_compare_plan *plan,
                                     struct um_model_tables **out);

/* Model value of every row in the unit of its quantity, from a run on geometry tables of
 * the plan; value: shape [count of the set]; NaN for rows that are left out, +infinity for a
 * magnitude of no light. UM_ERR_INPUT with file and line: a row of irradiance or magnitude while
 * the satellite is below the horizon; a row of a grey body where none fits the light. */
enum um_status um_compare_predict(struct um_context *context, const struct um_compare_plan *plan,
                                  const struct um_model_tables *tables,
                                  const struct um_model_result *result, double *value);

/* The same of a channel with a source at observation k, whether or not a row is measured then; NaN
 * where um_compare_predict refuses a row. */
double um_compare_predict_at(const struct um_compare_plan *plan,
                             const struct um_model_tables *tables,
                             const struct um_model_result *result, size_t channel, size_t k);

/* Standard error of those values by the sampling of the model: sigma of each observation in linear
 * flux (magnitudes: of the flux relative to magnitude 0), shape [count of the set]; NaN for rows
 * that are left out, 0 for temperatures, whose error the model does not state. All instants look at
 * the same points of the body, so the errors of neighbouring observations are not independent:
 * their squares add to chi-square as stated, but they do not average out. Does not fail. */
void um_compare_predict_error(const struct um_compare_plan *plan,
                              const struct um_model_result *result, double *model_sigma);

/* Band whose light a channel that is not of temperatures holds: its own, or its sensor's; of all
 * thermal bands together the first. */
size_t um_compare_band(const struct um_compare_plan *plan, const struct um_model *model,
                       size_t channel);

#endif
