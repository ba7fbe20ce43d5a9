/* The benchmark of diagnosis (bench/worlds/README.md): worlds whose hidden effect is known, what a
 * program answered to each, and how good that is.
 *
 * An answer is one row of a journal, made by this program, by one of four baselines or by another
 * program. Judgements and tables are made from worlds and answers alone. */
#ifndef UMBRA_BENCH_WORLDS_H
#define UMBRA_BENCH_WORLDS_H

#include <stdio.h>

#include "evidence/sensitivity/candidates.h"

#define WORLDS_TEXT   256
#define WORLDS_LONG   8192
#define WORLDS_HIDDEN 8
#define WORLDS_VALUES 4

/* An effect that the truth has and the scenario lacks. */
struct worlds_hidden {
  char names[WORLDS_TEXT]; /* that all mean it: "a:b|c*"; '*' stands for any end */
  bool optional;           /* the measurements need not tell it */
  size_t nvalue;
  char parameter[WORLDS_VALUES][32];
  double value[WORLDS_VALUES]; /* true, unit of the parameter */
};

/* What a good verdict is. */
enum worlds_good {
  WORLDS_FOUND,       /* the effect */
  WORLDS_GROUP,       /* the effect, or one of those that look alike */
  WORLDS_COMPLETE,    /* nothing is missing */
  WORLDS_NOBODY,      /* no effect is accused, whatever is said of the noise */
  WORLDS_UNEXPLAINED, /* none of the catalogue */
  WORLDS_NOT_ALL /* the effect, or that not all is known: the model is off by more than is hidden */
};
#define WORLDS_GOODS (WORLDS_NOT_ALL + 1)
extern const char *const worlds_good_name[WORLDS_GOODS]; /* as worlds.csv has them */

struct worlds_world {
  char name[32], scenario[WORLDS_TEXT], measurement[WORLDS_TEXT]; /* below bench/worlds */
  char without[WORLDS_TEXT]; /* switches the analyst leaves out, joined by '+' */
  char set[WORLDS_TEXT];     /* KEY=VALUE for the analyst; "": none */
  char also[WORLDS_TEXT];    /* names that look alike, as in worlds_hidden */
  enum worlds_good good;
  size_t nhidden;
  struct worlds_hidden hidden[WORLDS_HIDDEN];
};

/* A row of the journal. Lists are parted by blanks. */
struct worlds_answer {
  char world[32], method[32];
  char verdict[32];          /* complete, found, not_identifiable, unexplained; error */
  char certain[WORLDS_LONG]; /* effects that are named: "albedo_level zero_point:vis" */
  char groups[WORLDS_LONG];  /* of effects of which one is meant: "a+b c+d+e"; one alone: small
                                or uncertain; a heat pulse is "pulse:PLACE" */
  char values[WORLDS_LONG];  /* "effect:target parameter value sigma", joined by " + " */
  double probability;        /* stated for the truth [1]; NaN: none is */
  char half[32];             /* of the model, that is most probably wrong; "": none is said */
  char stated[WORLDS_LONG];  /* every probability that is stated: "albedo_level 0.93", joined by
                                " + " */
  double seconds;            /* processor time */
  char note[WORLDS_LONG];
};

struct worlds_judgement {
  bool is_null;           /* nothing is hidden that is to be told */
  bool detected;          /* something is said to be missing */
  bool accused;           /* an effect is named, or a group, that is not there */
  bool abstained;         /* no effect is certain */
  bool false_certain;     /* an effect is certain that is not hidden */
  bool right;             /* or rightly abstaining */
  double isolation;       /* probability given to the truth [1]; NaN where nothing is hidden */
  size_t nvalue, nwithin; /* of parameters: stated, and within 3 stated sigmas */
};

/* worlds_truth.c: the table of worlds. *out is freed by the caller. */
enum um_status worlds_read(struct um_context *context, const char *path, struct worlds_world **out,
                           size_t *count);

/* worlds_judge.c */
bool worlds_names_match(const char *names, const char *name);
/* Whether the world hides an effect of that name. */
bool worlds_is_hidden(const struct worlds_world *world, const char *name);
double worlds_isolation(const struct worlds_world *world, const struct worlds_answer *answer);
void worlds_judge(const struct worlds_world *world, const struct worlds_answer *answer,
                  struct worlds_judgement *out);

/* worlds_journal.c: answers as CSV; of two of one world and method the later holds. */
enum um_status worlds_journal_read(struct um_context *context, const char *path,
                                   struct worlds_answer **out, size_t *count);
bool worlds_journal_append(const char *path, const struct worlds_answer *answer);
const struct worlds_answer *worlds_journal_find(const struct worlds_answer *answer, size_t count,
                                                const char *world, const char *method);
/* A word more for a list. */
void worlds_append(char *list, size_t size, const char *between, const char *text);

/* worlds_baselines.c: what four simple methods say, by the linear model about the scenario as it
 * stands, of the candidates of this program. Errors of memory. */
#define WORLDS_BASELINES 4
extern const char *const worlds_baselines[WORLDS_BASELINES];
enum um_status worlds_baseline(struct um_context *context,
                               const struct um_sensitivity_forward *forward,
                               const struct um_sensitivity_candidates *candidates, size_t which,
                               struct worlds_answer *out);

/* worlds_discrepancy.c: per channel, a smooth Gaussian process in time under the whitened residual
 * r [n]; out [n] its mean. *found: whether any channel has one, by likelihood ratio at 1 %. */
enum um_status worlds_discrepancy(struct um_context *context, size_t n, const double *t,
                                  const size_t *channel, size_t nchannel, const double *r,
                                  double *out, bool *found);

/* worlds_diagnose.c: all methods on one world, appended to the journal as they come. Nuisances are
 * those of the scenario. only: [nonly] candidates; none: all. open_set: this program alone, with
 * what is hidden, and what looks like it, taken out of the catalogue on every target. */
struct worlds_options {
  const char *folder, *journal; /* of the worlds; path */
  const char *const *only;
  size_t nonly;
  bool open_set;
};
enum um_status worlds_diagnose(struct um_context *context, const struct worlds_options *options,
                               const struct worlds_world *world);
#define WORLDS_PROGRAM "umbra"
#define WORLDS_OPEN    "umbra-open" /* with the open set */

/* worlds_reliability.c: of statements with a probability in a bin, how many are true. Statements
 * about worlds that `also` has are left out: both names are true there, or neither. */
#define WORLDS_BINS 6
struct worlds_reliability {
  size_t count[WORLDS_BINS], right[WORLDS_BINS];
  double sum[WORLDS_BINS]; /* of the probabilities */
};
void worlds_reliability_add(const struct worlds_world *world, const struct worlds_answer *answer,
                            struct worlds_reliability *out);
/* As a table; nothing where nothing was stated. */
void worlds_reliability_print(const struct worlds_reliability *reliability);

/* worlds_open.c: names of the effects that are hidden or look like it, without targets, each once:
 * [*count] of text. */
#define WORLDS_LEFT_OUT 16
void worlds_left_out(const struct worlds_world *world, char text[WORLDS_LEFT_OUT][WORLDS_TEXT],
                     size_t *count);
/* Whether the half is that of something that is hidden. */
bool worlds_half_is_right(const struct worlds_world *world, const char *half);

#endif
