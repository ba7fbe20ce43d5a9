/* The steps of a build. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_STEPS_IMPL_H
#define UMBRA_MODEL_BUILD_STEPS_IMPL_H

#include "model/build/model.h"
#include "optics/instrument/filter.h"

/* orientation, trajectory, attitude, observer. */
enum um_status um_model_build_orbit(struct um_context *context, struct um_model *model);

/* The laws, as effects change them. */
enum um_status um_model_build_attitude(struct um_context *context, struct um_model *model);
/* What lies between two laws is known where the second begins: wants orbit, Sun and observer. */
enum um_status um_model_build_slews(struct um_context *context, struct um_model *model);

/* environment: from the scenario's mapping, then its effects. */
enum um_status um_model_build_environment(struct um_context *context, struct um_model *model);

/* The scenario's keys as they stand, without effects. */
void um_model_scenario_environment(const struct um_scenario *scenario, struct um_environment *to);

/* What observer.air scatters in the wavelengths of the model's bands, into model->sky_light; left
 * NULL without air, with air of a file, whose radiance is the file's, and where no band is known.
 * A variant borrows that of its origin where it is the same. After the bands. UM_ERR_MEMORY. */
enum um_status um_model_build_sky_light(struct um_context *context, struct um_model *model);

/* Edges, bins and filters of the bands, Vega in them, and the scenario's sensors; a variant has
 * those of its origin. UM_ERR_INPUT with file, line and key, and what filters and their files are
 * refused for; UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_build_bands(struct um_context *context, struct um_model *model);

/* The sensors alone, once the bands stand. */
enum um_status um_model_build_sensors(struct um_context *context, struct um_model *model);

/* A curve of the scenario's folder, as um_instrument_filter_read; the caller destroys. */
enum um_status um_model_curve_read(struct um_context *context, struct um_model *model,
                                   const struct um_mark *at, const char *key, const char *relative,
                                   struct um_instrument_filter **out);
/* [n] ones, of the model. */
enum um_status um_model_bins_ones(struct um_context *context, struct um_model *model, int n,
                                  double **out);
/* The mean of a curve over each bin of a band, multiplied into to [bins]. Does not fail. */
void um_model_bins_pass(const struct um_instrument_filter *curve, const struct um_optics_band *band,
                        double *to);

/* registry: effect_files of the scenario, then those of the command line. */
enum um_status um_model_build_effect_files(struct um_context *context, struct um_model *model,
                                           const struct um_model_options *options);

/* thermal.facets into model->halvings, left NULL without. UM_ERR_INPUT with file, line, column. */
enum um_status um_model_build_facets(struct um_context *context, struct um_model *model);

/* library with the records that the scenario names, which a variant borrows where it names none
 * else. UM_ERR_INPUT: no record is called so, and what records are refused for. */
enum um_status um_model_build_library(struct um_context *context, struct um_model *model);
/* material, adjustment and thickened: the records of the geometry's materials. */
enum um_status um_model_build_records(struct um_context *context, struct um_model *model);

/* library, geometry, material records of it. */
enum um_status um_model_build_parts(struct um_context *context, struct um_model *model);

/* model->creasing and model->creases; after parts and their records. UM_ERR_INPUT with file and
 * line of the part. */
enum um_status um_model_build_creases(struct um_context *context, struct um_model *model);

/* Say in the log which parts have surfaces in one place (geometry/coincident.h), and which have an
 * interior that bodies share which do not touch (geometry/bodies.h). After the parts are built.
 * UM_ERR_MEMORY, UM_ERR_CANCELLED. */
enum um_status um_model_warn_coincident(struct um_context *context, const struct um_model *model);

/* Where a station of the scenario stands, into its observer. */
void um_model_station_place(const struct um_scenario_station *from, struct um_orbit_observer *to);
/* model->station: the observer, and behind it the others that measurements may name. UM_ERR_INPUT:
 * one without a name, with a name that is taken, or beside an observer that is no station. */
enum um_status um_model_build_stations(struct um_context *context, struct um_model *model);
/* What a scenario with orbit.points cannot have. */
enum um_status um_model_build_points(struct um_context *context, struct um_model *model);

/* What of each surface's sky the satellite itself covers, into the heat network, where
 * mutual_radiation is off. */
enum um_status um_model_build_blocked(struct um_context *context, struct um_model *model);

/* What the part states for one of its groups, or NULL. */
const struct um_scenario_group *um_model_group_named(const struct um_scenario_part *part,
                                                     const char *name);

enum um_status um_model_build_shell(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_shell *from,
                                    struct um_thermal_shell *to);
enum um_status um_model_build_shell_of_materials(struct um_context *context, struct um_model *model,
                                                 const struct um_scenario_part *part,
                                                 const struct um_geometry_group *group,
                                                 struct um_thermal_shell *to);
enum um_status um_model_build_solid(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_part *part,
                                    struct um_thermal_part_spec *to);
void um_model_warn_of_bare_blanket(struct um_context *context, const struct um_model *model,
                                   const struct um_scenario_part *part,
                                   const struct um_thermal_group_spec *groups, size_t n);

/* A wall of layers with nodes in its thickness; shell->layers is not empty. */
enum um_status um_model_build_layers(struct um_context *context, struct um_model *model,
                                     const struct um_scenario_shell *shell,
                                     struct um_thermal_shell *to);
/* Fills what of *to is not stated (NaN); shell->honeycomb is there. */
enum um_status um_model_build_honeycomb(struct um_context *context, struct um_model *model,
                                        const struct um_scenario_shell *shell,
                                        struct um_thermal_shell *to);

/* area: of all groups that `from` covers [m^2], over which its seams spread. *out lives as long as
 * the model. */
enum um_status um_model_build_mli(struct um_context *context, struct um_model *model,
                                  const struct um_scenario_part *part,
                                  const struct um_scenario_mli *from, double area,
                                  struct um_thermal_mli **out);

/* *out: ratios over 300 K, as long as the model lives; NULL where they are constant or the scenario
 * takes them so. */
enum um_status um_model_bulk_ratio(struct um_context *context, struct um_model *model,
                                   const struct um_materials_record *record,
                                   enum um_materials_bulk_property property,
                                   const struct um_thermal_ratio **out);

/* Into model->surface_law. */
enum um_status um_model_build_surface_laws(struct um_context *context, struct um_model *model);

/* heat network. */
enum um_status um_model_build_thermal(struct um_context *context, struct um_model *model);

/* to->interior; index: of the part in the geometry. UM_ERR_INPUT at the key. */
enum um_status um_model_build_interiors(struct um_context *context, struct um_model *model,
                                        const struct um_scenario_part *part, uint32_t index,
                                        struct um_thermal_part_spec *to);
/* What a group states of its conductances to the interiors; own NULL: nothing. */
enum um_status um_model_build_conductances(struct um_context *context, struct um_model *model,
                                           const struct um_scenario_part *part,
                                           const struct um_scenario_group *own,
                                           struct um_thermal_group_spec *to);
/* The conductance of each interior goes to the groups that state none, by area [m^2]. */
void um_model_share_conductances(const struct um_model *model, const struct um_scenario_part *part,
                                 const double *group_area, struct um_thermal_group_spec *groups,
                                 size_t n);
/* Heat that is released inside must get out; a node without capacity must be held by something. */
enum um_status um_model_check_way_out(struct um_context *context, const struct um_model *model,
                                      const struct um_scenario_part *part,
                                      const struct um_thermal_part_spec *to);

#define UM_MODEL_NO_INTERIOR ((size_t)-1)

/* Interiors of a part are counted as in its thermal spec: `interior` where it has one, then
 * `interiors` in the order of the scenario. */
size_t um_model_interior_count(const struct um_scenario_part *part);
const struct um_scenario_interior *um_model_interior_at(const struct um_scenario_part *part,
                                                        size_t index);
/* Does one of them fill the part with tetrahedra? */
bool um_model_interior_is_solid(const struct um_scenario_part *part);
/* "interior" or the scenario's own name. */
const char *um_model_interior_name(const struct um_scenario_interior *interior);
/* UM_MODEL_NO_INTERIOR when there is none of that name. */
size_t um_model_interior_find(const struct um_scenario_part *part, const char *name);
/* "no interior 'NAME'; accepted: ..." at a key; other: one more word that is accepted, or NULL. */
enum um_status um_model_refuse_interior(struct um_context *context,
                                        const struct um_scenario_part *part,
                                        const struct um_mark *at, const char *key, const char *name,
                                        const char *other);

/* to->network, which the caller destroys, and its interiors; index: of the part in the geometry.
 * UM_ERR_INPUT with file and line. */
enum um_status um_model_build_network(struct um_context *context, struct um_model *model,
                                      const struct um_scenario_part *part, uint32_t index,
                                      struct um_thermal_part_spec *to);

/* Numbers by time from a file, owned by the model. */
struct um_model_series {
  size_t nrow;
  double *t;     /* [nrow] ascending, two at one time being a jump; t_tai [s] */
  double *value; /* [nrow] */
};
struct um_model_series_kind {
  const char *key, *column; /* of the scenario; of the file */
  double unit;              /* what a number of the file is [its SI unit] */
  const char *outside;      /* what holds before the first row and after the last, in words */
};
/* From the file of a key, CSV of time_utc and the column. UM_ERR_INPUT with file and line. */
enum um_status um_model_series_read(struct um_context *context, struct um_model *model,
                                    const struct um_mark *at, const char *file,
                                    const struct um_model_series_kind *kind,
                                    struct um_model_series *out);
/* A power history from the file of a key `power_file`; *out is owned by the
 * document, NULL without a file. at: the mapping that holds the key. */
enum um_status um_model_power_history(struct um_context *context, struct um_model *model,
                                      const struct um_mark *at, const char *file,
                                      const struct um_thermal_power_history **out);

/* UM_ERR_INPUT: a limit of an unknown place or of one that has a limit, without a bound, or with a
 * minimum above its maximum. */
enum um_status um_model_check_limits(struct um_context *context, const struct um_model *model);

/* Does the scenario of a variant say the same as its origin's at these paths of keys, so that what
 * is built of them alone may be borrowed? paths: NULL-terminated. false: there is no origin. */
bool um_model_origin_says(const struct um_model *model, const char *const *paths);

#endif
