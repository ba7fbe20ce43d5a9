/* libumbra: what a telescope sees of a satellite, in the visible and the thermal infrared.
 *
 * A session (struct umbra) holds settings and the message of the last error. A scenario is read and
 * changed, built into a model, and run; a result has arrays. Everything is opaque; every object is
 * closed by its own function, in any order: what is made from another keeps it alive.
 *
 * Errors are statuses; umbra_message says in one line what was wrong, with value, unit and what is
 * accepted. Where a function fails, *out is NULL and nothing has changed.
 *
 * Structures that a caller fills begin with `size`, which the macro beside each sets; everything
 * else may stay zero, which is its default. Structures that are returned are borrowed from the
 * object they were asked of. Texts are UTF-8. Angles in names of keys are degrees.
 *
 * Threads: a session belongs to one thread at a time, and so do the objects made with it; several
 * sessions work side by side. They may run one model at once, which a run only reads, where it is
 * closed after their results. Work inside a call is shared among settings.threads threads; results
 * do not depend on their number.
 *
 * Processes: nothing here prints, ends the process, installs a signal handler or keeps state of its
 * own outside of the session. What works in forked children, which are gone when the call returns:
 * TetGen (solid parts), netCDF of maps that a scenario names, gnuplot (pictures); and, where
 * settings.threads is above 1, many variants at once, in umbra_evaluate_many, umbra_diagnose,
 * umbra_fit, umbra_study and umbra_forecast: such a child computes with one thread, and calls none
 * of the callbacks. A child has
 * the calling thread alone, and locks that others held stay held in it: a host that has such
 * threads sets settings.threads to 1. Foreign libraries keep state of the process: GSL's error
 * handler is turned off; a large solid opens CHOLMOD, and sets OPENBLAS_NUM_THREADS to 1 in the
 * environment; netCDF/HDF5 are for one thread at a time, so umbra_result_write is, too. */
#ifndef UMBRA_UMBRA_H
#define UMBRA_UMBRA_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum umbra_status {
  UMBRA_OK,
  UMBRA_ERR_INPUT,     /* what was given is wrong */
  UMBRA_ERR_IO,        /* a file could not be read or written */
  UMBRA_ERR_MEMORY,    /* out of memory */
  UMBRA_ERR_NUMERIC,   /* a computation did not converge or left its domain */
  UMBRA_ERR_LIBRARY,   /* a foreign library failed */
  UMBRA_ERR_CANCELLED, /* a callback ended the work */
  UMBRA_ERR_REFUSED    /* a model refuses the values it is asked for */
};

/* "0.4.0"; borrowed for good. */
const char *umbra_version(void);

/* --- session --------------------------------------------------------------------------------- */

struct umbra;

enum umbra_log_level { UMBRA_LOG_DEBUG, UMBRA_LOG_INFO, UMBRA_LOG_WARNING, UMBRA_LOG_ERROR };

struct umbra_settings {
  size_t size;
  /* Folder that holds materials/, filters/, sensors/ and scenarios/. NULL: the one that the
   * environment variable UMBRA_DATA names, else share/umbra beside the shared library. A program
   * that is linked with the static library gives the one or the other. */
  const char *data;
  const char *cache; /* folder where view factors are kept between runs; NULL: none */
  int threads;       /* 0: as many as OpenMP would take */
  void *self;        /* handed to the callbacks */
  /* Each may be NULL. A line of the log, without its end. */
  void (*log)(void *self, enum umbra_log_level level, const char *line);
  /* `done` of `total` steps of a task, total 0 where nobody knows. 0 ends the work. */
  int (*progress)(void *self, const char *task, size_t done, size_t total);
  /* Not 0 ends the work, within 2 s. Asked from several threads at once; must be cheap. */
  int (*stop)(void *self);
};
#define UMBRA_SETTINGS                                                                             \
  {                                                                                                \
    sizeof(struct umbra_settings), NULL, NULL, 0, NULL, NULL, NULL, NULL                           \
  }

/* settings: NULL for the defaults; its texts are copied. The data folder is looked for when
 * something of it is wanted. UMBRA_ERR_INPUT: `size` is of no version; UMBRA_ERR_MEMORY. */
enum umbra_status umbra_open(const struct umbra_settings *settings, struct umbra **out);
/* Accepts NULL, sets NULL; likewise all that close. */
void umbra_close(struct umbra **umbra);
/* What was wrong with the last call, where it failed; borrowed until the next call that may fail.
 */
const char *umbra_message(const struct umbra *umbra);
/* End the call of this session that is under way, within 2 s, with UMBRA_ERR_CANCELLED; nothing
 * where there is none. From any thread, and from a signal handler. */
void umbra_interrupt(struct umbra *umbra);

/* --- scenario -------------------------------------------------------------------------------- */

struct umbra_scenario;

/* A scenario: text NULL: of a folder or file; else of YAML text, whose relative names of files lead
 * from `path` as if it were its file (NULL: from the working folder). The file is read now, once.
 * UMBRA_ERR_IO, UMBRA_ERR_INPUT with file, line and key, UMBRA_ERR_MEMORY. */
enum umbra_status umbra_scenario_read(struct umbra *umbra, const char *path, const char *text,
                                      struct umbra_scenario **out);
/* Set a key, "parts.bus.interior.power_W"; names address elements of lists, integers their
 * positions; missing mappings are made. The value is YAML text, or a number, which arrives with all
 * its bits; a time is text. Later changes go before earlier ones. UMBRA_ERR_INPUT: no such key, or
 * a value that it does not accept. */
enum umbra_status umbra_scenario_set(struct umbra *umbra, struct umbra_scenario *scenario,
                                     const char *key, const char *value);
enum umbra_status umbra_scenario_set_number(struct umbra *umbra, struct umbra_scenario *scenario,
                                            const char *key, double value);

struct umbra_effect_change {
  size_t size;
  const char *effect;
  const char *target; /* NULL: an effect on everything; of one that is turned off: all its uses */
  int off;            /* not 0: off */
  /* [nparameter] names and values in the parameters' units; others keep what the scenario says, or
   * their defaults. The name that a parameter had in the version before is accepted with a warning
   * in the log. */
  const char *const *parameter;
  const double *value;
  size_t nparameter;
};
#define UMBRA_EFFECT_CHANGE                                                                        \
  {                                                                                                \
    sizeof(struct umbra_effect_change), NULL, NULL, 0, NULL, NULL, 0                               \
  }

/* Turn an effect on or off. Texts are copied. UMBRA_ERR_INPUT: no such effect or parameter, a value
 * out of range, a target that it cannot have; that the target exists is seen when a model is built.
 */
enum umbra_status umbra_scenario_effect(struct umbra *umbra, struct umbra_scenario *scenario,
                                        const struct umbra_effect_change *change);
/* One change: a key with a number (with YAML text where `text` is not NULL, as a time has it), or
 * an effect, whose other parameters keep what they are. */
struct umbra_change {
  size_t size;
  const char *key; /* as of umbra_scenario_set; NULL: `effect` */
  double number;
  const char *text;
  const struct umbra_effect_change *effect;
};
#define UMBRA_CHANGE                                                                               \
  {                                                                                                \
    sizeof(struct umbra_change), NULL, 0.0, NULL, NULL                                             \
  }

/* Several changes [nchange] at once, all or none: only what they make together is checked, so that
 * a window of time may move. Errors of the three above. */
enum umbra_status umbra_scenario_change(struct umbra *umbra, struct umbra_scenario *scenario,
                                        const struct umbra_change *change, size_t nchange);
enum umbra_value_kind {
  UMBRA_VALUE_NUMBER,
  UMBRA_VALUE_FLAG, /* true or false */
  UMBRA_VALUE_TEXT, /* times, too */
  UMBRA_VALUE_LIST, /* elements by position: "parts.0" */
  UMBRA_VALUE_GROUP /* elements by name */
};
struct umbra_value {
  enum umbra_value_kind kind;
  double number;           /* of a number, with all its bits; of a flag 1 or 0; else NaN */
  const char *text;        /* of a number, a flag or a text, as it is written; else NULL */
  size_t count;            /* of elements */
  const char *const *name; /* of a group [nname]; else NULL */
  size_t nname;
};

/* What a key says, changes of keys included; effects that changes turned on stand in no key. *out:
 * borrowed from the scenario until it is changed or asked again. UMBRA_ERR_INPUT: the scenario
 * states nothing there (umbra_key_at has defaults), UMBRA_ERR_MEMORY. */
enum umbra_status umbra_scenario_get(struct umbra *umbra, struct umbra_scenario *scenario,
                                     const char *key, const struct umbra_value **out);
void umbra_scenario_close(struct umbra_scenario **scenario);

/* --- model ----------------------------------------------------------------------------------- */

struct umbra_model;

/* Build what the scenario says at this time; later changes of it leave the model as it is. Errors
 * as of umbra_scenario_read, and of files that the scenario names. */
enum umbra_status umbra_model_build(struct umbra *umbra, const struct umbra_scenario *scenario,
                                    struct umbra_model **out);

enum umbra_names {
  UMBRA_PARTS,
  UMBRA_PLACES,
  UMBRA_MATERIALS,
  UMBRA_BANDS,
  UMBRA_SENSORS,
  UMBRA_MECHANISMS
};

/* Names, in the order of arrays that have an axis of that kind. Mechanisms are how light comes
 * about: "sun", "earth", "emitted", "interreflected", "other". Places are what has a temperature
 * in results: parts, sides, interiors, and materials ("material:NAME"). *out: [count], borrowed
 * from the model. UMBRA_ERR_INPUT: no such kind. */
enum umbra_status umbra_model_names(struct umbra *umbra, const struct umbra_model *model,
                                    enum umbra_names kind, const char *const **out, size_t *count);
void umbra_model_close(struct umbra_model **model);

/* --- results --------------------------------------------------------------------------------- */

struct umbra_result;

/* Light and heat over the scenario's own window. UMBRA_ERR_NUMERIC, UMBRA_ERR_LIBRARY,
 * UMBRA_ERR_CANCELLED and those of umbra_model_build. */
enum umbra_status umbra_run(struct umbra *umbra, struct umbra_model *model,
                            struct umbra_result **out);

/* Numbers in the order of C: the last index moves first. */
struct umbra_array {
  const char *name, *unit; /* "K"; "1" for what has none */
  size_t dimensions;       /* at most 4 */
  size_t shape[4];
  const char *axis[4]; /* "time", "band", "place", "material", "mechanism", "bin", "surface",
                          "node", "sensor", "observation", "fitted observation", "set",
                          "parameter" */
  const double *data;
};

/* An array by its name, NULL where the result has none of it; borrowed from the result, so that
 * nothing is copied. A run has
 *   time_unix_s [time], of mid-exposure, sunlit [time], the share of the Sun's energy that arrives,
 *   hidden [time] (1 below the horizon or behind the Earth),
 *   range_m, phase_angle_rad [time] (at the satellite, Sun to observer) with an observer,
 *   irradiance, magnitude_ab, magnitude_vega, intensity, intensity_error [time, band],
 *   intensity_parts [time, band, material, mechanism],
 *   spectral_intensity [time, bin, mechanism] before any filter, wavelength_m [bin],
 *   count_rate, count_rate_error [time, sensor],
 *   temperature, temperature_lowest, temperature_highest [place, time],
 *   surface_temperature [time, surface], node_temperature [time, node],
 *   facet_error [surface], how far its temperature lies from that of finer facets, rms over time,
 *   facet_error_light [band], the share by which finer facets would change intensity, largest over
 *   time; both estimated, of a run that is not one of many points.
 * NaN is what does not exist. */
const struct umbra_array *umbra_result_array(const struct umbra_result *result, const char *name);
/* The same by number; NULL behind the last. */
const struct umbra_array *umbra_result_array_at(const struct umbra_result *result, size_t index);

struct umbra_write {
  size_t size;
  int force;           /* not 0: a folder that Umbra did not write is replaced, too */
  int pictures;        /* not 0: pictures by gnuplot; where there is none, a warning */
  const char *command; /* what files say they come from; NULL: "libumbra" */
};
#define UMBRA_WRITE                                                                                \
  {                                                                                                \
    sizeof(struct umbra_write), 0, 0, NULL                                                         \
  }

/* Write the files that the command writes for such a result (docs/files.md); the folder appears
 * whole or not at all. write: NULL for the defaults. UMBRA_ERR_IO; UMBRA_ERR_INPUT: results of
 * variants, which have none. */
enum umbra_status umbra_result_write(struct umbra *umbra, const struct umbra_result *result,
                                     const char *folder, const struct umbra_write *write);
void umbra_result_close(struct umbra_result **result);

/* --- variants --------------------------------------------------------------------------------- */

/* A model, changed again and again: what a change leaves the same, number for number, is not
 * computed again. Keeps its model. */
struct umbra_variants;

struct umbra_variants_settings {
  size_t size;
  int exact;            /* not 0: heat of each as umbra_run has it; else to the errors below */
  double temperature_K; /* error asked of temperatures; 0: 0.1 */
  size_t memory;        /* that kept geometries may take [bytes]; 0: 1 GiB */
  double light;         /* error asked of light, of its value; 0: 1e-3 */
};
#define UMBRA_VARIANTS_SETTINGS                                                                    \
  {                                                                                                \
    sizeof(struct umbra_variants_settings), 0, 0.0, 0, 0.0                                         \
  }

/* Nothing is computed before a variant asks for it. settings: NULL for the defaults.
 * UMBRA_ERR_INPUT: a setting out of range; UMBRA_ERR_MEMORY. */
enum umbra_status umbra_variants_open(struct umbra *umbra, struct umbra_model *model,
                                      const struct umbra_variants_settings *settings,
                                      struct umbra_variants **out);
void umbra_variants_close(struct umbra_variants **variants);

/* Light and temperatures of the model with changes [nchange], borrowed for the call: keys in their
 * order, then effects that are turned off, then those that are turned on. The result has the arrays
 * of umbra_run. It does not depend on what was run before. It is not written: for that
 * the changes are made to a scenario, which is run. UMBRA_ERR_INPUT: what umbra_scenario_set and
 * umbra_scenario_effect refuse; and errors of umbra_run. */
enum umbra_status umbra_variant_run(struct umbra *umbra, struct umbra_variants *variants,
                                    const struct umbra_change *change, size_t nchange,
                                    struct umbra_result **out);

/* Changes of one variant. */
struct umbra_changes {
  const struct umbra_change *change; /* [nchange] */
  size_t nchange;
};

struct umbra_many {
  size_t size;
  const char *const *array; /* [narray] names of arrays of umbra_run, of three dimensions at most;
                               none: irradiance */
  size_t narray;
  int workers; /* processes that compute; 0: as many as settings.threads; 1: none beside this one */
};
#define UMBRA_MANY                                                                                 \
  {                                                                                                \
    sizeof(struct umbra_many), NULL, 0, 0                                                          \
  }

/* umbra_variant_run of every set [nset], many at once in forked processes; numbers do not depend on
 * how many. The result has the arrays that are asked for, each behind an axis "set", as large as
 * those of the first set that is computed. What the model refuses of a set is no error: its numbers
 * are NaN, and umbra_result_refusal has the reason. many: NULL for the defaults. UMBRA_ERR_INPUT
 * with the number of the set, counted from 1: an effect's change that umbra_scenario_effect
 * refuses; no set, every set refused, or an array that a run has not; and other errors of
 * umbra_run. */
enum umbra_status umbra_evaluate_many(struct umbra *umbra, struct umbra_variants *variants,
                                      const struct umbra_changes *set, size_t nset,
                                      const struct umbra_many *many, struct umbra_result **out);
/* Why a set, counted from 0, was not computed, or has arrays of another size; NULL where it was,
 * and for results of no such call. Borrowed. */
const char *umbra_result_refusal(const struct umbra_result *result, size_t set);

/* --- measurements ----------------------------------------------------------------------------- */

struct umbra_measurements;

/* A CSV file of them (docs/files.md). UMBRA_ERR_IO, UMBRA_ERR_INPUT with file and line. */
enum umbra_status umbra_measurements_read(struct umbra *umbra, const char *path,
                                          struct umbra_measurements **out);

/* Columns of a table; every pointer leads to [count], and those from sigma on may be NULL. */
struct umbra_columns {
  size_t size;
  size_t count;
  const double *time_unix_s;   /* of mid-exposure, in order within a track */
  const char *const *quantity; /* "magnitude_ab", "band_irradiance", "temperature" (K) ... */
  const char *const *of;       /* band, place, filter or sensor */
  const double *value;         /* in the quantity's unit */
  const double *sigma;         /* NaN: what the scenario's noise model says */
  const double *exposure_s;    /* NaN: the scenario's */
  const int *flag;             /* not 0: left out */
  const char *const *track, *const *station;
  /* of orbit.points, all or none: height above the ellipsoid, north over east, airless */
  const double *satellite_height_km, *azimuth_deg, *elevation_deg;
};
#define UMBRA_COLUMNS                                                                              \
  {                                                                                                \
    sizeof(struct umbra_columns), 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL,   \
        NULL, NULL                                                                                 \
  }

/* Measurements from arrays, which are copied. UMBRA_ERR_INPUT with the row, counted from 1. */
enum umbra_status umbra_measurements_make(struct umbra *umbra, const struct umbra_columns *columns,
                                          struct umbra_measurements **out);
/* Several measurements [n] as one, each a set: a night, a telescope. Effects on clock, exposure and
 * reading are then a matter of each set, "zero_point:vis@night1" (docs/diagnosis.md). name: [n] of
 * the sets, or NULL and NULL among them for those of their files. The parts stay as they are.
 * UMBRA_ERR_INPUT: no part, one that was joined itself, a name that is there twice, parts with and
 * without geometry of their own. */
enum umbra_status umbra_measurements_join(struct umbra *umbra,
                                          const struct umbra_measurements *const *part,
                                          const char *const *name, size_t n,
                                          struct umbra_measurements **out);
/* Their columns, in the order of rows; those that no row has are NULL. Borrowed from the
 * measurements. UMBRA_ERR_MEMORY. */
enum umbra_status umbra_measurements_columns(struct umbra *umbra,
                                             struct umbra_measurements *measurements,
                                             const struct umbra_columns **out);
/* A CSV file of them, whole or not at all. A file that is there is replaced where force is not 0.
 * UMBRA_ERR_IO: the file is there; it cannot be written. */
enum umbra_status umbra_measurements_write(struct umbra *umbra,
                                           const struct umbra_measurements *measurements,
                                           const char *path, int force);
void umbra_measurements_close(struct umbra_measurements **measurements);

struct umbra_synth_settings {
  size_t size;
  /* 1 sigma of the noise: a share of each value, and a share of the band's largest one; not both 0
   */
  double noise, floor;
  unsigned long long seed;
  const char *const *place; /* [nplace] whose temperatures are measured, too */
  size_t nplace;
  double temperature_sigma; /* [K]; 0: 0.5 */
  int grey_body; /* not 0: characteristic temperature and infrared cross-section, too, of three
                    thermal bands or more */
};
#define UMBRA_SYNTH_SETTINGS                                                                       \
  {                                                                                                \
    sizeof(struct umbra_synth_settings), 0.0, 0.0, 0, NULL, 0, 0.0, 0                              \
  }

/* Measurements made of a scenario as it stands: the irradiance of every band and the count rate of
 * every sensor at its instants, and what the settings name, with Gaussian noise. The same seed
 * gives the same noise. UMBRA_ERR_INPUT: noise out of range, no such place, nothing that is seen;
 * and errors of umbra_model_build and umbra_run. */
enum umbra_status umbra_synth(struct umbra *umbra, const struct umbra_scenario *scenario,
                              const struct umbra_synth_settings *settings,
                              struct umbra_measurements **out);

/* --- comparison ------------------------------------------------------------------------------- */

/* One quantity of one thing. NaN is what does not exist, as chi2 without sigma. */
struct umbra_channel {
  const char *quantity, *of, *unit; /* unit: of bias and rms; magnitudes are compared as flux */
  size_t count, left_out;           /* observations in use; with a flag */
  double bias, rms;                 /* mean of measured - model, and root of the mean square */
  double bias_mag, rms_mag;         /* the same of magnitudes [mag] */
  double scale;                     /* of the model, that makes the rest least [1] */
  double chi2, dof, chi2_reduced;
  double durbin_watson, white_p; /* of residuals in order of time: 2 white, 0 slow drifts */
  double model_share;            /* of the model's own sampling in the variance [1] */
};
struct umbra_comparison {
  double chi2, dof, chi2_reduced;      /* of all observations with a sigma */
  const struct umbra_channel *channel; /* [nchannel] */
  size_t nchannel;
};

/* The scenario beside measurements, with as many samples as they want. The result has arrays of
 * rows [observation], NaN where a row is left out: model in the quantity's unit; residual, sigma,
 * model_sigma in the unit of residuals. UMBRA_ERR_INPUT: a band, place or time that the scenario
 * has not; and errors of umbra_model_build and umbra_run. */
enum umbra_status umbra_compare(struct umbra *umbra, const struct umbra_scenario *scenario,
                                struct umbra_measurements *measurements, struct umbra_result **out);
/* NULL for other results. */
const struct umbra_comparison *umbra_result_comparison(const struct umbra_result *result);

/* --- fit and diagnosis -------------------------------------------------------------------------
 */

enum umbra_verdict_kind {
  UMBRA_COMPLETE,         /* nothing is missing */
  UMBRA_FOUND,            /* what is missing was found */
  UMBRA_NOT_IDENTIFIABLE, /* it is one of a group that these measurements cannot tell apart */
  UMBRA_UNEXPLAINED       /* something is missing, and no effect explains it */
};

enum umbra_confidence {
  UMBRA_CERTAIN,      /* no other comes near */
  UMBRA_ONE_OF_GROUP, /* it or one of the alternatives that are tied with it */
  UMBRA_SMALL,        /* it explains so little that what it is cannot be known */
  UMBRA_UNCERTAIN,    /* none comes near, but the summary says why it may be wrong */
  UMBRA_CHOSEN        /* the caller said it */
};

struct umbra_estimate {
  const char *name, *unit;
  double value, sigma; /* sigma NaN or 0: not fitted */
  double null_value;   /* where the effect vanishes */
};

struct umbra_alternative {
  const char *effect, *target; /* target NULL: everything */
  int off;                     /* not 0: it is on by default, and turned off */
  int fitted;                  /* 0: tested by the linear model alone, which has no estimates */
  int tied;                    /* these measurements cannot tell it from what was found */
  int implausible;             /* further than 3 prior widths from where it vanishes */
  double delta_bic;            /* its BIC less that of what was found; NaN: not fitted */
  const struct umbra_estimate *estimate; /* [nestimate] */
  size_t nestimate;
};

struct umbra_finding {
  const char *effect, *target; /* target NULL: everything */
  int off;                     /* not 0: it is on by default, and too much */
  enum umbra_confidence confidence;
  double p_value;                        /* corrected for all that were tested; NaN: chosen */
  double delta_bic;                      /* below 0: better than without; NaN: chosen */
  const struct umbra_estimate *estimate; /* [nestimate] all fitted together */
  size_t nestimate;
  const struct umbra_alternative *alternative; /* [nalternative] the best first */
  size_t nalternative;
};

/* A half of the model: "heat", "surface", "geometry_attitude", "earth_shadow", "air", "instrument".
 */
struct umbra_half {
  const char *name;
  double probability; /* that it is what is wrong; NaN: nothing is. They sum to 1. */
};

struct umbra_verdict {
  enum umbra_verdict_kind kind; /* of a fit: how the rest looks */
  const char *sentence;         /* for a person */
  double chi2_before, dof_before, chi2_after, dof_after;
  const struct umbra_finding *finding; /* [nfinding] what stayed */
  size_t nfinding;
  const struct umbra_finding *nuisance; /* [nnuisance] what was uncertain anyway, as fitted */
  size_t nnuisance;
  /* of what is missing, NaN of a fit; they sum to 1: nothing, one effect of the catalogue, several,
   * something that the catalogue has not */
  double probability_nothing, probability_one, probability_several, probability_none;
  const struct umbra_half *half; /* [nhalf]; of a fit nhalf is 0 */
  size_t nhalf;
  const char *next; /* the measurement that would tell most; NULL: nothing is ambiguous, or
                       nothing that the scenario has would */
};

struct umbra_diagnose_settings {
  size_t size;
  const char *const *only; /* [nonly] "effect" or "effect:target" to look for; none: all */
  size_t nonly;
  const char *const *exclude; /* [nexclude] likewise, taken out, beside the scenario's own */
  size_t nexclude;
  double level; /* family-wise false-alarm rate, below 1; 0: 0.01 */
  size_t steps; /* effects at most, up to 20; 0: 4 */
};
#define UMBRA_DIAGNOSE_SETTINGS                                                                    \
  {                                                                                                \
    sizeof(struct umbra_diagnose_settings), NULL, 0, NULL, 0, 0.0, 0                               \
  }

/* Which effect the scenario lacks. What is uncertain anyway (nuisances, excluded effects, noise) is
 * what the scenario says under measurements. settings: NULL for the defaults. The result has the
 * arrays before and after [fitted observation]: model values in the unit of residuals. Takes up to
 * hours; progress is reported. UMBRA_ERR_INPUT: no such effect, a setting out of range, fewer
 * observations than free parameters; and errors of umbra_compare. */
enum umbra_status umbra_diagnose(struct umbra *umbra, const struct umbra_scenario *scenario,
                                 struct umbra_measurements *measurements,
                                 const struct umbra_diagnose_settings *settings,
                                 struct umbra_result **out);
/* Parameters of chosen effects [nchange]; values are where the fit starts, and an effect that
 * states none is added as a diagnosis adds it. UMBRA_ERR_INPUT: what umbra_scenario_effect refuses,
 * an effect that is off or named twice; and errors of umbra_diagnose. */
enum umbra_status umbra_fit(struct umbra *umbra, const struct umbra_scenario *scenario,
                            struct umbra_measurements *measurements,
                            const struct umbra_effect_change *change, size_t nchange,
                            struct umbra_result **out);
/* NULL for results that are of no fit and no diagnosis. */
const struct umbra_verdict *umbra_result_verdict(const struct umbra_result *result);

/* --- sensitivity ------------------------------------------------------------------------------ */

/* A column of the matrix: a parameter of an effect on a target. */
struct umbra_derivative {
  const char *name;                    /* "emittance:mli.factor"; a switch that is off, "albedo" */
  const char *effect, *target;         /* target NULL: everything */
  const char *parameter;               /* NULL: a switch, of which the column is the whole change */
  const char *unit;                    /* of the parameter */
  double null_value, minimum, maximum; /* in the scenario, and where it may go */
  double width;                        /* of its prior, or a step as a fit begins with */
  const char *method; /* "tangent", "light", "runs", "motion", "behind", "switch" (docs/files.md) */
  double step, error; /* of the differences; estimated error of the column, of its largest value */
  double reach;       /* way from null_value within which a line leaves 1 % of every curve's size;
                         INFINITY:       no bend was seen, NaN: not known */
  const char *not_smooth; /* why a small step does not follow it; NULL: it does */
};
struct umbra_sensitivity {
  const struct umbra_derivative *derivative; /* [nderivative], the axis "parameter" */
  size_t nderivative;
  const char *const *band;  /* [nband], the axis "band": bands, of measurements other light, too */
  const char *const *place; /* [nplace], the axis "place" */
  size_t nband, nplace;
};

struct umbra_sensitivity_settings {
  size_t size;
  const char *const *only; /* [nonly] "effect" or "effect:target"; none: all */
  size_t nonly;
  const char *const *exclude; /* [nexclude] likewise, taken out */
  size_t nexclude;
};
#define UMBRA_SENSITIVITY_SETTINGS                                                                 \
  {                                                                                                \
    sizeof(struct umbra_sensitivity_settings), NULL, 0, NULL, 0                                    \
  }

/* d(light of every band, temperature of every place)/d(every parameter of every effect on every
 * target) at the scenario's own instants, or, with measurements (NULL: none), at theirs. The result
 * has time_unix_s [time], light [band, time], temperature [place, time] as the scenario stands, and
 * d_light [parameter, band, time], d_temperature [parameter, place, time]; NaN where nothing is
 * observed. settings: NULL for the defaults. Takes as long as tens of runs; progress is reported.
 * UMBRA_ERR_INPUT: no such effect; and errors of umbra_compare. */
enum umbra_status umbra_sensitivity(struct umbra *umbra, const struct umbra_scenario *scenario,
                                    struct umbra_measurements *measurements,
                                    const struct umbra_sensitivity_settings *settings,
                                    struct umbra_result **out);
/* NULL for other results. */
const struct umbra_sensitivity *umbra_result_sensitivity(const struct umbra_result *result);
/* What the matrix says when columns [n] take values, in less than 50 ms: light [band, time] and
 * temperature [place, time], which outlive `sensitivity`. A switch takes 1 for on. Such a result is
 * not written. UMBRA_ERR_INPUT: no result of umbra_sensitivity, no such column, or a value that its
 * parameter may not have. */
enum umbra_status umbra_what_if(struct umbra *umbra, const struct umbra_result *sensitivity,
                                const size_t *column, const double *value, size_t n,
                                struct umbra_result **out);

/* --- studies and forecasts ---------------------------------------------------------------------
 */

/* Many points into a folder. Each that is done is safe on disk, in a folder beside it
 * (FOLDER.points), which goes when the results are written. */
struct umbra_points {
  size_t size;
  const char *folder; /* of the results */
  int force;          /* not 0: a folder that Umbra did not write is replaced, too */
  int pictures;       /* not 0: pictures by gnuplot; where there is none, a warning */
  int workers;        /* processes that compute; 0: as many as settings.threads */
  int resume;         /* not 0: points on record are taken; else records there are an error */
  /* of a job array: points of number share of nshare alone, from 1, are put on record, and no
   * results are written; a call without that resumes writes them. nshare 0: all */
  size_t share, nshare;
};
#define UMBRA_POINTS                                                                               \
  {                                                                                                \
    sizeof(struct umbra_points), NULL, 0, 0, 0, 0, 0, 0                                            \
  }

/* The study of a file (docs/files.md). measured: measurements in place of those that it names, or
 * NULL. *missing: points whose processes died, which a call that resumes computes; results are
 * written without them, and the records stay. UMBRA_ERR_IO: a folder of somebody else's, records of
 * something else; UMBRA_ERR_INPUT with file, line and key; and errors of umbra_run. */
enum umbra_status umbra_study(struct umbra *umbra, const char *path, const char *measured,
                              const struct umbra_points *points, size_t *missing);

struct umbra_station {
  const char *name;
  double latitude_deg, longitude_deg, height_m; /* north, east */
};

struct umbra_forecast_settings {
  size_t size;
  double from_unix_s;                  /* 0: the scenario's start */
  double days;                         /* 0: 1; at most 400 */
  double minimum_elevation_deg;        /* 0: the scenario's */
  const struct umbra_station *station; /* [nstation] none: the scenario's */
  size_t nstation;
  const char *const *uncertain; /* [nuncertain] "effect[:target],parameter=sigma", "key=sigma" */
  size_t nuncertain;
};
#define UMBRA_FORECAST_SETTINGS                                                                    \
  {                                                                                                \
    sizeof(struct umbra_forecast_settings), 0.0, 0.0, 0.0, NULL, 0, NULL, 0                        \
  }

/* Passes to come, with what is seen of them: passes.csv, curves.csv, passes.ics and, where
 * something is uncertain, contributions.csv (docs/files.md). settings: NULL for the defaults.
 * *missing as above. UMBRA_ERR_INPUT: no station, no orbit, a setting out of range; and errors of
 * umbra_study. */
enum umbra_status umbra_forecast(struct umbra *umbra, const struct umbra_scenario *scenario,
                                 const struct umbra_forecast_settings *settings,
                                 const struct umbra_points *points, size_t *missing);

/* --- what there is: effects, keys, sources ------------------------------------------------------
 */

struct umbra_parameter {
  const char *name, *unit, *help; /* name with its unit, "power_W"; unit "1": none */
  double null_value;              /* the effect vanishes here */
  double default_value, minimum, maximum;
  double prior_sigma; /* of a weak prior about null_value, of a logarithmic one of ln(value /
                         null_value); INFINITY: none */
  const char *prior;  /* where that comes from; NULL: not said */
  int logarithmic;    /* a positive factor that may be off either way */
  int fitted;         /* 0: a number that is chosen, never fitted */
};

enum umbra_target { /* or-ed */
                    UMBRA_TARGET_GLOBAL = 1,
                    UMBRA_TARGET_PART = 2,
                    UMBRA_TARGET_SIDE = 4, /* "PART.SIDE" */
                    UMBRA_TARGET_MATERIAL = 8,
                    UMBRA_TARGET_BAND = 16,
                    UMBRA_TARGET_SENSOR = 32,
                    UMBRA_TARGET_INTERIOR =
                        64 /* "PART.NAME" of what a part lists under interiors */
};

struct umbra_effect {
  const char *name, *summary, *reference, *validity;
  const char *separated_by; /* reads behind "told apart from"; NULL: not said */
  unsigned targets;         /* or-ed umbra_target */
  int on_by_default;
  const struct umbra_parameter *parameter; /* [nparameter] */
  size_t nparameter;
};

/* The effects that a scenario may use, in the order of the manual; NULL behind the last. Borrowed
 * from the session. */
const struct umbra_effect *umbra_effect_at(const struct umbra *umbra, size_t index);
/* The one of that name. UMBRA_ERR_INPUT with the nearest name. */
enum umbra_status umbra_effect_find(struct umbra *umbra, const char *name,
                                    const struct umbra_effect **out);
/* Effects of one's own (examples/effects): a shared object, whose code runs inside the process.
 * They stand behind the others, and models that are built from now on may use them; a scenario's
 * own effect_files are refused where they are not loaded so. What their hooks call of Umbra the
 * process has to export: the command does, libumbra has umbra_* alone. UMBRA_ERR_IO,
 * UMBRA_ERR_INPUT: no such object, or a name that is taken. */
enum umbra_status umbra_effects_load(struct umbra *umbra, const char *path);

enum umbra_key_type {
  UMBRA_KEY_NUMBER,
  UMBRA_KEY_INTEGER,
  UMBRA_KEY_BOOL,
  UMBRA_KEY_TEXT,   /* a date, too */
  UMBRA_KEY_CHOICE, /* a text out of `choice` */
  UMBRA_KEY_NUMBERS,
  UMBRA_KEY_TEXTS,
  UMBRA_KEY_MAP, /* holds keys */
  UMBRA_KEY_LIST /* of elements that hold keys, or a mapping of names to such */
};

struct umbra_key {
  const char *path;     /* "parts.interior.power_W": without names of elements */
  const char *unit;     /* "W/(m^2 K)"; NULL where the key's name ends in none */
  const char *help;     /* one sentence; NULL of a mapping that its keys explain */
  const char *accepted; /* "a finite number, more than 0" */
  enum umbra_key_type type;
  int required;
  double minimum, maximum;   /* NaN: no bound */
  double default_value;      /* of numbers and choices (by number); NaN: none */
  const char *const *choice; /* [ends with NULL]; NULL: of no choice */
};

/* The keys of a scenario, a mapping before what it holds; NULL behind the last. Borrowed from the
 * session. */
const struct umbra_key *umbra_key_at(const struct umbra *umbra, size_t index);

/* What the data folder has: UMBRA_MATERIALS and UMBRA_SENSORS. *out: [count], borrowed from the
 * session. UMBRA_ERR_INPUT: another kind, or a record that is wrong; UMBRA_ERR_IO. */
enum umbra_status umbra_data_names(struct umbra *umbra, enum umbra_names kind,
                                   const char *const **out, size_t *count);

struct umbra_citation {
  const char *sentence; /* "Computed with Umbra 0.4.0 ..., with ..." */
  const char *bibtex;   /* the entries it names, the program's first */
};

/* What a result rests on: the program, the models and data it used, the libraries that computed it,
 * the records of its materials, the references of its effects. Owned by the result, like *out.
 * UMBRA_ERR_MEMORY; UMBRA_ERR_INPUT: a result of umbra_what_if. */
enum umbra_status umbra_cite(struct umbra *umbra, struct umbra_result *result,
                             const struct umbra_citation **out);

#ifdef __cplusplus
}
#endif

#endif
