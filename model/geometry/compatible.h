/* For which models geometry tables are valid. */
#ifndef UMBRA_MODEL_COMPATIBLE_H
#define UMBRA_MODEL_COMPATIBLE_H

#include "model/build/model.h"
#include "model/geometry/precompute.h"

/* Would the Sun and the Earth of both models put the same loads on the same surfaces, number for
 * number? What `made` has beyond what `model` asks for (angular moments, paths by mirrors) does not
 * count. Geometry tables are light before any optical property acts: factors that act
 * behind it (earthshine, reflected Earth radiation, switches of the heat loads) may differ. */
bool um_model_light_is_compatible(const struct um_model *made, const struct um_model *model);

/* *out: is `tables`, by um_model_precompute_over from `made`, what it would give for `model`
 * over `instants`, so far as a run of `model` looks at it? By comparing what both are built of,
 * number for number: surfaces and joints, times, places, attitudes and directions at every instant
 * and row of the loads, light, mirrors, rooms, and the numbers of rays. false: it may not. Costs
 * some 30 us a row. Errors of um_model_precompute_over for `model`, before it traces. Test:
 * unit_model_compatible, by tracing anew. */
enum um_status um_model_tables_are_compatible(struct um_context *context,
                                              const struct um_model *made,
                                              const struct um_model_tables *tables,
                                              const struct um_model_instants *instants,
                                              const struct um_model *model, bool *out);

/* *out: are loads of `model` over `instants` those of `tables` by other levels alone, of sunlight
 * and of a uniform Earth? All else is compared as there, but for lines of sight. Errors as of
 * um_model_tables_are_compatible. */
enum um_status um_model_loads_are_proportional(struct um_context *context,
                                               const struct um_model *made,
                                               const struct um_model_tables *tables,
                                               const struct um_model_instants *instants,
                                               const struct um_model *model,
                                               struct um_irradiation_levels *levels, bool *out);

/* *out: are tables of the body (body_tables.h) traced of `made` those of `model`, number for
 * number? By comparing what both are built of: surfaces, mirrors, rooms, numbers of rays and files.
 * Not where joints move, since those are tables of times. Errors of um_geometry_mirrors_create.
 * Test: unit_model_precompute_like, by tracing anew. */
enum um_status um_model_body_is_compatible(struct um_context *context, const struct um_model *made,
                                           const struct um_model *model, bool *out);

#endif
