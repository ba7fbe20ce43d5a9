/* Low-discrepancy points keyed by index: the same index gives the same point for any number of
 * threads and any order of evaluation. */
#ifndef UMBRA_CORE_SAMPLING_H
#define UMBRA_CORE_SAMPLING_H

#include <stdint.h>

#include "base/core/vec.h"

/* Mixes keys into one well-distributed 64-bit value (splitmix64 finaliser); chain for more keys. */
uint64_t um_core_hash(uint64_t a, uint64_t b);
/* Uniform in [0, 1) from a hash. */
double um_core_hash_uniform(uint64_t hash);
/* Point `index` of the R2 sequence (Roberts 2018, generalised golden ratio), shifted modulo 1 by a
 * value hashed from `key` (Cranley & Patterson 1976); in [0, 1)^2. */
void um_core_sample_2d(uint64_t key, uint64_t index, double out[2]);
/* Uniform on a triangle: barycentric weights, sum 1 (Osada et al. 2002 square-root map). */
void um_core_sample_triangle(const double u[2], double weight[3]);
/* Uniform on the unit disc (Shirley & Chiu 1997 concentric map). */
void um_core_sample_disc(const double u[2], double xy[2]);
/* Cosine-weighted direction about the unit normal n (Malley's method). */
struct um_vec3 um_core_sample_cosine(const double u[2], struct um_vec3 n);

#endif
