/* Steps of building a model, private to the folder. */
#ifndef UMBRA_MODEL_MODEL_IMPL_H
#define UMBRA_MODEL_MODEL_IMPL_H

#include "model/model.h"

/* registry: effect_files of the scenario, then those of the command line (effect_files.c). */
enum um_status um_model_build_effect_files(struct um_context *context, struct um_model *model,
                                           const struct um_model_options *options);
/* effect: the scenario's list, --with and --without (effects.c). */
enum um_status um_model_build_effects(struct um_context *context, struct um_model *model,
                                      const struct um_model_options *options);
/* Additions to the effects of a variant. */
enum um_status um_model_add_effects(struct um_context *context, struct um_model *model,
                                    const struct um_model_addition *addition, size_t naddition);
/* Every target names something that the built parts have (after um_model_build_parts). */
enum um_status um_model_check_effects(struct um_context *context, const struct um_model *model);
/* The next effect that is on, from *index, which moves behind it; false at the end. */
bool um_model_effect_next(const struct um_model *model, size_t *index, struct um_effect_use *use);
/* The scenario's mapping as it stands, without effects (scenario_environment.c). */
void um_model_scenario_environment(const struct um_scenario_environment *from,
                                   struct um_environment *to);
/* environment: from the scenario's mapping, then its effects (build_environment.c). */
enum um_status um_model_build_environment(struct um_context *context, struct um_model *model);
/* orientation, trajectory, attitude, observer (build_orbit.c). */
enum um_status um_model_build_orbit(struct um_context *context, struct um_model *model);
/* library, geometry, material records of it (build_parts.c). */
enum um_status um_model_build_parts(struct um_context *context, struct um_model *model);
/* What of each surface's sky the satellite itself covers, into the heat network (build_blocked.c).
 */
enum um_status um_model_build_blocked(struct um_context *context, struct um_model *model);
/* A power history from the file of a key `power_file` (build_power.c); *out is owned by the
 * document, NULL without a file. at: the mapping that holds the key. */
struct um_thermal_power_history;
enum um_status um_model_power_history(struct um_context *context, struct um_model *model,
                                      const struct um_mark *at, const char *file,
                                      const struct um_thermal_power_history **out);
/* start_offset, from what effects did to the parts (start_offset.c). */
enum um_status um_model_build_start_offset(struct um_context *context, struct um_model *model,
                                           const struct um_thermal_part_spec *parts, size_t npart);
/* heat network (build_thermal.c). */
enum um_status um_model_build_thermal(struct um_context *context, struct um_model *model);
/* Into model->surface_law (surface_law.c). */
enum um_status um_model_build_surface_laws(struct um_context *context, struct um_model *model);

/* Path relative to the file of a mark; owned by the document. */
enum um_status um_model_resolve(struct um_context *context, struct um_model *model,
                                const struct um_mark *at, const char *relative, const char **out);
/* Put "file:line: path.key: " before the recorded message, with the line of the key where the
 * mapping has it; key NULL: the mapping itself. Returns status. */
enum um_status um_model_blame(struct um_context *context, const struct um_mark *at, const char *key,
                              enum um_status status);
/* Record "file:line: path.key: message" and return UM_ERR_INPUT. */
enum um_status um_model_fail(struct um_context *context, const struct um_mark *at, const char *key,
                             const char *format, ...) UM_PRINTF(4, 5);
/* True for a name that can stand in a CSV header, in a key path and in a netCDF name: not empty, no
 * control characters, none of . / : , ; ' " and backslash. */
bool um_model_name_is_plain(const char *name);
/* Put file and line of the part before a message that begins with "part NAME", "part 'NAME'" or the
 * path of its mesh, as those of geometry and heat network do; else the file. Returns status. */
enum um_status um_model_blame_part(struct um_context *context, struct um_model *model,
                                   enum um_status status);
/* Put file and line of its key before a message that begins with the path of a table of orbit,
 * attitude or observer, as those of tables that do not reach an instant do. Returns status. */
enum um_status um_model_blame_table(struct um_context *context, const struct um_model *model,
                                    enum um_status status);
/* The time at which an observation of that tag was really made (geometry precomputation.c). */
double um_model_true_time(const struct um_model *model, double tag);
/* hidden: rows that the observer cannot see, said in the log; UM_ERR_INPUT for an observer inside
 * the satellite (line_of_sight.c). After the observations are placed. */
enum um_status um_model_precomputed_hide(struct um_context *context, const struct um_model *model,
                                         struct um_model_precomputed *precomputed);
/* stations of orbit.points, and what such a scenario cannot have (points.c). */
enum um_status um_model_build_points(struct um_context *context, struct um_model *model);
/* UM_ERR_INPUT for a scenario of points, naming what it wants (bounds.c). */
enum um_status um_model_check_track(struct um_context *context, const struct um_model *model);
/* What the instants that are observed ask of memory (bounds.c). UM_ERR_INPUT naming the key. */
enum um_status um_model_check_instants(struct um_context *context, const struct um_model *model,
                                       size_t nobs, size_t nsub);
/* The same of the heat loads over `span` [s], one instant every `step` [s]. */
enum um_status um_model_check_load_rows(struct um_context *context, const struct um_model *model,
                                        const struct um_model_precomputed *precomputed, double span,
                                        double step);

/* Unit vector of three numbers; UM_ERR_INPUT naming `key` when it is zero. */
enum um_status um_model_unit(struct um_context *context, const struct um_mark *at, const char *key,
                             const double v[3], struct um_vec3 *out);

#endif
