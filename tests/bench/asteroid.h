/* A body without an Earth that turns in the Sun and heats itself: a ball with dents, in so many
 * facets. */
#ifndef UMBRA_BENCH_ASTEROID_H
#define UMBRA_BENCH_ASTEROID_H

#include "tests/bench/bench.h"

/* The stages of one computation [s], and what it takes. */
struct asteroid_cost {
  size_t facets, pairs, steps; /* steps: of the integration */
  double sun;                  /* rays of 72 instants, every facet */
  double factors;              /* view factors between patches */
  double exchange;             /* reflections, and what is reflected of the sunlight */
  double heat;                 /* one turn integrated, temperatures at 72 instants */
  double mean;                 /* temperature by area at its end [K] */
  double memory;               /* most that the program has held so far [bytes] */
};

/* 12 cells^2 facets; cache: folder of view factors, NULL: none; tighter: than tolerances of
 * thermal.accuracy_K 0.1. Time of this thread where the context has one, else of the clock. */
struct asteroid_cost asteroid_run(const struct bench *bench, size_t cells, const char *cache,
                                  double tighter);
/* Start temperatures such that the turn repeats, to 0.01 K [s]; turns: integrated. */
double asteroid_periodic(const struct bench *bench, size_t cells, size_t *turns);
#endif
