/* A block that cools to space, in tetrahedra, for the benchmark of solvers: one mesh for Umbra's
 * network and for CalculiX's input. */
#ifndef UMBRA_BENCH_BLOCK_H
#define UMBRA_BENCH_BLOCK_H

#include "base/core/vec.h"
#include "tests/bench/bench.h"
#include "thermal/solver/solve.h"

/* 1 m by 0.5 m by 0.25 m of k 5 W/m/K, 500 kg/m^3, 900 J/kg/K, emittance 0.9 all around, from 400 K
 * beneath a sky of 3 K. Biot number 0.08 to 0.3: gradients inside and slopes at the skin both
 * count. */
#define BLOCK_START        400.0
#define BLOCK_SKY          3.0
#define BLOCK_DURATION     7200.0 /* [s] */
#define BLOCK_CONDUCTIVITY 5.0
#define BLOCK_DENSITY      500.0
#define BLOCK_HEAT         900.0
#define BLOCK_EMITTANCE    0.9

struct block {
  size_t nvertex, ntetrahedron, nface;
  struct um_vec3 *vertex;     /* [nvertex] [m] */
  uint32_t (*tetrahedron)[4]; /* [ntetrahedron] of positive volume */
  uint32_t (*face)[2];        /* [nface] tetrahedron; its corner that is not on the border */
};

/* A grid of `cells` cubes along the short edge, each in six tetrahedra, inner vertices moved a
 * little (the same way every time). */
void block_create(const struct bench *bench, size_t cells, struct block *out);
void block_free(const struct bench *bench, struct block *block);
struct um_thermal_network *block_network(const struct bench *bench, const struct block *block);

/* CalculiX (`ccx`) on the same tetrahedra with one thread, in a folder of its own: mean temperature
 * over volume at the end [K] and wall time [s]. NaN where it is not installed or fails; says so on
 * the terminal. largest_change: of a temperature in a step (its DELTMX) [K]. */
struct block_peer {
  double mean, seconds;
};
struct block_peer block_calculix(const struct bench *bench, const struct block *block,
                                 double largest_change);

#endif
