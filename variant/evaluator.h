/* One scenario, computed again and again with something changed. What a change leaves the same,
 * number for number, is not computed again: geometry, then heat. Every question about a changed
 * scenario goes this way: studies, forecasts, cases, sensitivities, missing heat, error in space.
 */
#ifndef UMBRA_VARIANT_EVALUATOR_H
#define UMBRA_VARIANT_EVALUATOR_H

#include "model/build/model.h"
#include "model/geometry/precompute.h"
#include "model/products/light_sensitivity.h"
#include "model/run/result.h"
#include "model/run/thermal_solution.h"
#include "variant/tolerance.h"

struct um_variant_settings {
  const struct um_model_instants *instants; /* when all are looked at; borrowed while the evaluator
                                               lives. NULL: each over its own window */
  struct um_variant_tolerance base;         /* of the scenario as it stands */
  bool scaled;  /* loads that differ from the scenario's by levels of sunlight and of the Earth
                   alone are made of those: an answer is off by the last of 24 bits of them */
  bool photons; /* sunlight from mirror to mirror is kept with the scenario's geometry */
  size_t bytes; /* that geometries may take beside what they share with the scenario's; 0:
                   UM_VARIANT_BYTES */
};
#define UM_VARIANT_BYTES ((size_t)1 << 30)

/* From where the heat of a variant is looked for. */
enum um_variant_start {
  UM_VARIANT_COLD, /* as a run of its own, whose bits it has */
  UM_VARIANT_WARM, /* from the heat of the scenario as it stands, never from another variant's: a
                      variant has the same bits in any order and process */
  UM_VARIANT_EXTRAPOLATED /* T + step dT/dp, T of the scenario as it stands */
};
struct um_variant_heat {
  enum um_variant_start start;
  struct um_variant_tolerance tolerance; /* WARM */
  /* EXTRAPOLATED: parameter `which` of the sensitivity, moved by `step` [its unit], and with it the
   * light where nothing but temperatures moves it; light NULL: it is computed */
  const struct um_model_thermal_sensitivity *sensitivity;
  const struct um_model_light_sensitivity *light;
  size_t which;
  double step;
};

/* A variant that is computed; all but what is said to be private may be looked at until it is
 * closed. */
struct um_variant {
  const struct um_model *model;
  const struct um_model_tables *tables;
  const struct um_model_thermal_solution *heat;
  bool fresh_geometry, fresh_heat; /* computed for it: nothing at hand served */
  bool light_alike;             /* at the scenario's temperatures its light leaves the satellite */
  double seconds_heat;          /* wall time of fresh heat, 0 without [s] */
  struct um_variant_heat moved; /* as it was asked for where heat is extrapolated */
  /* private */
  struct um_variant_kept *kept;
  struct um_model *own_model;
  struct um_model_tables *own_tables;
  struct um_model_thermal_solution *own_heat;
};

struct um_variant_evaluator;
/* model: the scenario as it stands; it, and its own origin, outlive the evaluator. Nothing is
 * computed yet. UM_ERR_MEMORY. The caller destroys, after every variant is closed. */
enum um_status um_variant_evaluator_create(struct um_context *context, const struct um_model *model,
                                           const struct um_variant_settings *settings,
                                           struct um_variant_evaluator **out);
/* The same of a variant that is open over instants of its own, with heat: its model is the scenario
 * as it stands, its geometry and heat are that one's, and are lent: it is closed after the
 * evaluator is destroyed, and not given other heat before. settings->instants: those that it was
 * opened over; settings->base is not used. UM_ERR_MEMORY. */
enum um_status um_variant_evaluator_of(struct um_context *context, const struct um_variant *variant,
                                       const struct um_variant_settings *settings,
                                       struct um_variant_evaluator **out);
void um_variant_evaluator_destroy(struct um_context *context,
                                  struct um_variant_evaluator **evaluator);
/* Another bound in bytes for what is kept from now on; the one before. */
size_t um_variant_evaluator_bound(struct um_variant_evaluator *evaluator, size_t bytes);
/* Bytes of geometries of their own that open variants hold, tables of the body that are the
 * scenario's not counted. */
size_t um_variant_evaluator_open_bytes(const struct um_variant_evaluator *evaluator);

/* The scenario as it stands: its geometry is traced and its heat solved when they are first asked
 * for, and stay. Errors of um_model_precompute_over and of the thermal solvers. */
enum um_status um_variant_base(struct um_context *context, struct um_variant_evaluator *evaluator,
                               struct um_variant *out);
/* What variants take of it, for who opens many in other processes: its geometry, its heat for
 * starts that need it, and with `light` its light. Errors as of um_variant_base. */
enum um_status um_variant_share(struct um_context *context, struct um_variant_evaluator *evaluator,
                                enum um_variant_start start, bool light);
/* Does all that is changed act on light that has left the satellite? */
bool um_variant_acts_behind(const struct um_model_changes *changes);
/* Wall time of its heat [s]; 0 before it is asked for. */
double um_variant_base_seconds_heat(const struct um_variant_evaluator *evaluator);
/* Its geometry, for who traces lines of sight again (um_model_tables_resample): light that is
 * kept is given up. NULL before um_variant_base. */
struct um_model_tables *um_variant_base_tables(struct um_context *context,
                                               struct um_variant_evaluator *evaluator);

/* Light between surfaces by so many paths from now on, 0: as the scenario has them: `base` on the
 * scenario's own geometry, `others` on every other that is at hand; those that are traced later go
 * by settings.instants, which the caller has set to the same. Light that is kept is given up;
 * sunlight between mirrors is kept anew where the settings ask for it. After um_variant_base.
 * Errors of um_model_precompute_photons. */
enum um_status um_variant_paths(struct um_context *context, struct um_variant_evaluator *evaluator,
                                int base, int others);

/* The scenario with changes, its geometry and, with `heat`, its heat; heat NULL: none is asked for.
 * What is refused because of the changes is UM_ERR_REFUSED. Errors of um_model_variant_create,
 * um_model_precompute_over and the thermal solvers. Closed by the caller, after a failure too. */
enum um_status um_variant_open(struct um_context *context, struct um_variant_evaluator *evaluator,
                               const struct um_model_changes *changes,
                               const struct um_variant_heat *heat, struct um_variant *out);
/* *out: do these effects, by what they declare, ask for another geometry than the scenario's?
 * Errors of um_model_variant_create. */
enum um_status um_variant_reaches_geometry(struct um_context *context,
                                           const struct um_variant_evaluator *evaluator,
                                           const struct um_model_addition *addition,
                                           size_t naddition, bool *out);
/* The same over other instants than the evaluator's (NULL: the variant's own window). Its geometry
 * is traced for it alone. */
enum um_status um_variant_open_over(struct um_context *context,
                                    struct um_variant_evaluator *evaluator,
                                    const struct um_model_instants *instants,
                                    const struct um_model_changes *changes,
                                    const struct um_variant_heat *heat, struct um_variant *out);
/* Heat of a variant that was opened without, or with another tolerance: some that is at hand and is
 * the same number for number, or solved. */
enum um_status um_variant_find_heat(struct um_context *context,
                                    struct um_variant_evaluator *evaluator,
                                    const struct um_variant_heat *heat, struct um_variant *variant);
/* Heat is solved though some is at hand: to hold tolerances against each other. */
enum um_status um_variant_heat_again(struct um_context *context,
                                     struct um_variant_evaluator *evaluator,
                                     const struct um_variant_heat *heat,
                                     struct um_variant *variant);
/* Light and temperatures of an open variant with heat (um_model_run_observed). Light of the
 * scenario as it stands is computed once, and serves variants of its geometry and temperatures that
 * are `light_alike`. The caller destroys *out. */
enum um_status um_variant_observe(struct um_context *context,
                                  struct um_variant_evaluator *evaluator,
                                  const struct um_variant *variant, struct um_model_result **out);
void um_variant_close(struct um_context *context, struct um_variant *variant);

#endif
