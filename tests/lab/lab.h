/* The hidden-effect laboratory: measurements are made from a truth that has an effect the analyst's
 * scenario lacks, on another mesh, with other sampling and with noise; the diagnosis is then asked
 * what is missing, and what it says is counted.
 *
 * A world is what the analyst has: a scenario, what was measured of it and how well. A case is one
 * set of measurements in a world: what is hidden, how strong, which noise. Each case ends as one
 * row of cases.csv; tables and lab.json are made from the rows alone. */
#ifndef UMBRA_TESTS_LAB_H
#define UMBRA_TESTS_LAB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "evidence/sensitivity/candidates.h"
#include "model/build/model.h"
#include "thermal/network/course.h"

#define LAB_TEXT     256
#define LAB_KEYS     8
#define LAB_PLACES   4
#define LAB_HIDDEN   2
#define LAB_INTERVAL 6.0 /* between observations of both passes [s] */

/* Which rows are measured; 0 or NULL where nothing is left out. */
struct lab_filter {
  const char *channels;             /* "vis,lwir,bus.+x"; NULL: all */
  double sunlit_from, sunlit_to;    /* fraction of the Sun seen; both 0: all */
  double elevation_from_deg;        /* of the satellite at the station */
  double from_s, to_s;              /* since the first observation; both 0: all */
  size_t every, temperatures_every; /* only each n-th observation; 0: each */
};

struct lab_world {
  const char *name;
  const char *folder;             /* below scenarios/hidden-effect */
  const char *set[LAB_KEYS];      /* KEY=VALUE, for truth and analyst alike */
  const char *without;            /* core switch that the analyst left out; NULL: none */
  const char *place[LAB_PLACES];  /* whose temperatures are measured beside the bands */
  const char *nuisance;           /* "effect:target" that is free to the analyst; NULL: none */
  double relative, floor, kelvin; /* noise, as of um_compare_synth */
  struct lab_filter filter;
};

/* An effect that the truth has. */
struct lab_hidden {
  const char *effect, *target; /* target NULL: global */
  size_t parameter;            /* the one that is off */
  double value;
};

struct lab_case {
  const char *part; /* "effects", "switches", "complete", "two", "pairs", "pulse" */
  const struct lab_world *world;
  struct lab_hidden hidden[LAB_HIDDEN];
  size_t nhidden;
  const struct lab_pulse *pulse; /* NULL: none */
  bool tie_breaker;              /* of a pair: the measurements tell it from its partner */
  uint64_t seed;
};

/* Heat that is in no catalogue. */
struct lab_pulse {
  const char *place; /* that it heats */
  const char *key;   /* of the scenario, that takes a table of power */
  enum um_thermal_course_shape shape;
  double power; /* [W] */
  double from_s, last_s,
      period_s; /* the first since the first observation; 0 where there is none */
};
#define LAB_PULSE_END 690.0 /* last observation of that pass, since the first [s] */

/* What came of a case: a row of cases.csv. Texts hold no comma; lists are joined by '+'. */
struct lab_row {
  char part[32], world[64], hidden[LAB_TEXT], value[LAB_TEXT];
  uint64_t seed;
  char verdict[32]; /* "error" where the diagnosis failed */
  char first[96];   /* of the first step; "-" for none */
  char group[4096]; /* those that the first step cannot tell apart, its winner first */
  char found[LAB_TEXT];
  char fitted[LAB_TEXT], sigma[LAB_TEXT]; /* of each hidden effect; nan where it was not fitted */
  double chi2_before, chi2_after;         /* reduced */
  double rms_before, rms_after;           /* worst channel, in sigmas */
  double start_error_s;                   /* of a pulse; NaN otherwise */
  double seconds;                         /* of computing */
  char note[LAB_TEXT];
};

struct lab_options {
  const char *folder; /* of the results */
  const char *only, *world, *part;
  uint64_t seeds, complete; /* per effect and world; of complete models in all */
  int workers;
  bool quick, again, list, tables;
};

/* cases.c: everything that is to be tried, in order; *out is freed by the caller. */
size_t lab_cases_make(const struct lab_options *options, struct lab_case **out);
/* "effect:target+effect:target", "shape:place" or "-"; "value+value", of heat energy [J] and
 * start [s since the first observation] */
void lab_case_hidden(const struct lab_case *c, char out[LAB_TEXT]);
void lab_case_value(const struct lab_case *c, char out[LAB_TEXT]);
void lab_hidden_name(const struct lab_hidden *hidden, char *out, size_t size);
/* As --with has it: "effect:target,NAME=VALUE", other parameters that are off behind. False where
 * there is no such effect or parameter. */
bool lab_hidden_with(const struct lab_world *world, const struct lab_hidden *hidden, char *out,
                     size_t size);

/* The effect that a hidden one of a pair is confused with; NULL where it is of no pair. */
const char *lab_pair_partner(const struct lab_case *c);

/* worlds.c */
/* Keys that make the truth's mesh, samples, bins and tolerances finer than the analyst's,
 * KEY=VALUE. tests/scenarios/hidden_effect.c holds what the analyst's cost against them. */
#define LAB_FINE 10
extern const char *const lab_fine[LAB_FINE];
const struct lab_world *lab_world_find(const char *name);
const struct lab_world *lab_worlds(size_t *count);
/* Path of its scenario; static size. */
void lab_world_path(const struct lab_world *world, char out[LAB_TEXT * 4]);
/* The analyst's options of the model; texts borrowed from the world. */
struct lab_analyst {
  const char *override[LAB_KEYS], *without[1];
  struct um_model_options options;
};
void lab_world_analyst(const struct lab_world *world, struct lab_analyst *out);

/* truth.c: a run of what really happens, made once and measured with many noises. */
struct lab_truth {
  const struct lab_world *world;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};
/* plain: on the mesh of the analyst, without the switch he left out. */
enum um_status lab_truth_create(struct um_context *context, const struct lab_case *c, bool plain,
                                const char *folder, struct lab_truth *out);
void lab_truth_release(struct um_context *context, struct lab_truth *truth);
/* The noise depends on what is hidden and on the seed of the case. Rows that the world's filter
 * leaves out have flag 1. The caller destroys. */
enum um_status lab_truth_measure(struct um_context *context, const struct lab_truth *truth,
                                 const struct lab_case *c, struct um_compare_measurements **out);

/* analyst.c: what an analyst has before measurements come: candidates of a world. */
struct lab_desk {
  const struct lab_world *world;
  struct lab_analyst analyst;
  char path[LAB_TEXT * 4];
  struct um_compare_measurements *measurements;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
};
enum um_status lab_desk_create(struct um_context *context, const struct lab_world *world,
                               const char *folder, struct lab_desk *out);
void lab_desk_release(struct um_context *context, struct lab_desk *desk);

/* examine.c: diagnose one set and describe what came of it. Failures are a row too. */
void lab_examine(struct um_context *context, const struct lab_desk *desk,
                 const struct lab_truth *truth, const struct lab_case *c, struct lab_row *row);
/* Name of a candidate, a list of them behind what is there. */
void lab_append(char *list, size_t size, const char *text);

/* journal.c: cases.csv. */
bool lab_journal_begin(const char *folder, bool again); /* again: without earlier rows */
bool lab_journal_append(const char *folder, const struct lab_row *row);
/* The caller frees *out by um_core_free. */
enum um_status lab_journal_read(struct um_context *context, const char *folder,
                                struct lab_row **out, size_t *count);
/* The row of a case; NULL where it has none. */
const struct lab_row *lab_journal_find(const struct lab_row *row, size_t count,
                                       const struct lab_case *c);

/* work.c: the cases, those of a world one after another, on so many processes; each row is written
 * as soon as it is known. False where a process failed. */
bool lab_work(const struct lab_options *options, const struct lab_case *cases, size_t count);

/* refusals.c: what must not be answered; prints a line each; how many were all the same. */
size_t lab_refusals(struct um_context *context, const struct lab_options *options, size_t *tried);

/* figures.c: what was wanted and what came, printed and written. */
struct lab_figure {
  char name[96];
  const char *unit;
  double value, goal; /* goal NaN: none */
  bool at_least;      /* value >= goal is wanted, otherwise value <= goal */
};
struct lab_figures {
  struct lab_figure figure[96];
  size_t count;
};
void lab_figures_add(struct lab_figures *figures, const char *name, const char *unit, double value,
                     double goal, bool at_least);
void lab_figures_print(const struct lab_figures *figures);
bool lab_figures_write(const struct lab_figures *figures, const char *path);
bool lab_figures_met(const struct lab_figures *figures);

/* tables.c, tables_other.c: printed from the rows of the cases, and added to the figures. */
void lab_tables_effects(const struct lab_case *cases, size_t count, const struct lab_row *row,
                        size_t nrow, struct lab_figures *figures);
void lab_tables_other(const struct lab_case *cases, size_t count, const struct lab_row *row,
                      size_t nrow, struct lab_figures *figures);
/* Is the name in a list joined by '+'? */
bool lab_list_has(const char *list, const char *name);
/* The first step named one effect and no other does as well. */
bool lab_row_is_separable(const struct lab_row *row);
/* Of hidden effect number i as fitted: sign as hidden, and (value - truth) / sigma. */
void lab_row_value(const struct lab_row *row, const struct lab_case *c, size_t i, bool *sign,
                   double *deviation);

#endif
