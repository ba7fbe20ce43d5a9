/* The geometry tables of a timeline. */
#ifndef UMBRA_MODEL_PRECOMPUTE_H
#define UMBRA_MODEL_PRECOMPUTE_H

#include "model/build/model.h"
#include "model/build/timeline.h"
#include "model/geometry/tables.h"

/* When and how finely a model is looked at. */
struct um_model_instants {
  const double *time;     /* [count] t_tai [s], as um_model_precompute_at takes them; NULL without
                             points: the scenario's own window */
  const double *exposure; /* [count] [s]; NULL: the scenario's */
  /* [count] the set of measurements of each, NULL: of none; NULL: of none all. Two times may be the
   * same in different sets. Names are told apart by their text, and outlive the tables. */
  const char *const *set;
  const size_t *station; /* [count] who looks, of the model's stations; NULL: the observer at all */
  const struct um_model_point *point; /* [count] of a scenario with orbit.points; NULL: an orbit */
  size_t count;
  struct um_model_sampling sampling;
  bool sparse; /* observed instants are no rows of the loads (load_grid.c). Nothing is sparse where
                  thermal.step_s is stated, loads are means over a turn, or observations are points.
                  Test: model/geometry/sparse */
};

/* Times of the scenario's own observations, every step from start to stop, t_tai [s]; the caller
 * frees *times. UM_ERR_MEMORY. */
enum um_status um_model_scenario_times(struct um_context *context, const struct um_model *model,
                                       double **times, size_t *count);
/* Which of these observations [count], with the scenario's exposures, the observer cannot see;
 * nothing is traced. None where there is no observer. *hidden: [count], the caller frees. Errors of
 * um_model_precompute_at. */
enum um_status um_model_hidden_at(struct um_context *context, const struct um_model *model,
                                  const double *times, size_t count, bool **hidden);
/* Over the scenario's own window. UM_ERR_INPUT; the caller destroys. */
enum um_status um_model_precompute(struct um_context *context, const struct um_model *model,
                                   struct um_model_tables **out);
/* The same at given observation times [ntime], t_tai, strictly ascending, in place of the
 * scenario's start, stop and step (measurements have times of their own). UM_ERR_INPUT for none or
 * out of order. exposures: NULL, or [ntime] [s] in place of the scenario's. sampling: of its lines
 * of sight and of the runs on it. */
enum um_status um_model_precompute_at(struct um_context *context, const struct um_model *model,
                                      const double *times, const double *exposures, size_t ntime,
                                      struct um_model_sampling sampling,
                                      struct um_model_tables **out);
/* Whichever of um_model_precompute, um_model_precompute_at and um_model_precompute_points the
 * instants ask for; NULL: the scenario's own window. */
enum um_status um_model_precompute_over(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_tables **out);
/* Observations as um_model_precompute_over has them, of an orbit or of points: samples, what the
 * observer sees, no loads and no lines of sight. Nothing is traced: the attitude of a sample may be
 * changed before um_model_precompute_posed (posed.h). Errors of um_model_precompute_over; the
 * caller destroys. */
enum um_status um_model_precompute_unposed(struct um_context *context, const struct um_model *model,
                                           const struct um_model_instants *instants,
                                           struct um_model_tables **out);
/* The same as um_model_precompute_over, number for number, with what `like`, traced of `made`, has
 * of the body alone (body_tables.h), where that is valid for the model: times, orbit, attitude and
 * light may be others. `like` may be destroyed before or after. */
enum um_status um_model_precompute_like(struct um_context *context, const struct um_model *made,
                                        const struct um_model_tables *like,
                                        const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_tables **out);
/* The same, traced by nobody, where the loads of `like`, traced of `made`, are in proportion to
 * those of the model (um_model_loads_are_proportional); else *out is NULL. Loads are those of
 * um_model_precompute_over but for the last of 24 bits (means over turns: of each summand), all
 * else is number for number. Test: unit_model_precompute_like. */
enum um_status um_model_precompute_scaled(struct um_context *context, const struct um_model *made,
                                          const struct um_model_tables *like,
                                          const struct um_model *model,
                                          const struct um_model_instants *instants,
                                          struct um_model_tables **out);
/* Memory that it takes beside `like`, but for some per cent: tables of the body that both share do
 * not count; like NULL: they do [bytes]. */
size_t um_model_tables_bytes(const struct um_model_tables *tables,
                             const struct um_model_tables *like);
/* Look again: lines of sight of the geometry tables with another number of points per
 * facet, everything else of it as it was; its `sampling` says what runs on it look with. Paths
 * stay the model's where optics.interreflection_samples is 0. UM_ERR_INPUT: no observer, or a
 * number out of range (then nothing is changed); UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED.
 */
enum um_status um_model_tables_resample(struct um_context *context, const struct um_model *model,
                                        struct um_model_tables *tables,
                                        struct um_model_sampling sampling);
/* Keep the sunlight that mirrors throw on other surfaces as the model has it, for many runs of it
 * and of others that have the same mirrors (optics/paths/photon_maps.h). Errors of
 * um_optics_photon_maps_create. */
enum um_status um_model_precompute_photons(struct um_context *context, const struct um_model *model,
                                           struct um_model_tables *tables);
void um_model_tables_destroy(struct um_context *context, struct um_model_tables **tables);

#endif
