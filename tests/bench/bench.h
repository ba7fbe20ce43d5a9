/* What the benchmarks share: clocks, repeated runs, one table on the terminal and the same as JSON.
 *
 * Every figure is a cost or an error, so smaller is better. One that is held against something has
 * a reference in its own unit, measured in the same run where it is a time; ratio = value /
 * reference, and it is met when ratio <= goal. Times are medians of runs that take turns with those
 * of their reference, so that a busy machine slows both; the table also says how far the runs
 * spread. A benchmark fails only when it cannot measure: a goal that is missed is a finding. */
#ifndef UMBRA_BENCH_BENCH_H
#define UMBRA_BENCH_BENCH_H

#include <stddef.h>

#include "base/core/context.h"

#define BENCH_RUNS    64
#define BENCH_FIGURES 96

/* Repeated measurements of one thing. */
struct bench_series {
  double value[BENCH_RUNS];
  size_t n;
};

struct bench_figure {
  char name[80];
  const char *unit;
  double value, reference; /* [unit]; reference NaN: none */
  double goal;             /* largest ratio wanted [1]; NaN: none */
  size_t runs;             /* behind value; 1: a single one or a count */
  double spread;           /* (largest - smallest) / median of them [1]; NaN for one run */
};

struct bench {
  struct um_context *context;
  const char *json; /* path of the result, NULL: the table only */
  int processors;   /* online */
  size_t n;
  struct bench_figure figure[BENCH_FIGURES];
};

/* Arguments: [file.json]. Prints `title`; the context has one thread. Ends the program when it
 * cannot. */
void bench_begin(struct bench *bench, int argc, char **argv, const char *title);
/* Prints the table, writes the JSON; the program's exit code. */
int bench_end(struct bench *bench);
/* Ends the program with the context's message unless status is UM_OK. */
void bench_must(const struct bench *bench, enum um_status status);
/* Zeroed memory, or the end of the program. */
void *bench_allocate(const struct bench *bench, size_t count, size_t size);
/* A new folder below $TMPDIR or, without one, the system's; its owner empties and removes it. Ends
 * the program where there can be none. */
#define BENCH_FOLDER 512
void bench_folder(char path[BENCH_FOLDER]);

double bench_wall(void); /* [s] for what runs on several threads */
double bench_cpu(void);  /* of this thread [s]: others on the machine do not count */

void bench_add(struct bench_series *series, double value);
double bench_median(const struct bench_series *series);
/* Add a figure: the median of a series held against that of another (NULL: nothing), or one number.
 * Give NAN for no reference, no goal. `name` is printf-formatted by the caller where it varies. */
void bench_time(struct bench *bench, const char *name, const char *unit,
                const struct bench_series *series, const struct bench_series *reference,
                double goal);
void bench_number(struct bench *bench, const char *name, const char *unit, double value,
                  double reference, double goal);

#endif
