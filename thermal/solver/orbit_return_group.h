/* What an orbit leaves of an error, turned round, of which sparse solves give:
 *
 *   1/(1 - exp(-x)) ~ 1 + 1/x + sum_k a_k u^k,   u = b/(x + b),   k = 1 .. 5
 *
 * within 0.00075 for every x > 0, the nearest function of that form. What it misses of fast nodes,
 * which start far from where an orbit leaves them, is why five terms pay: a sparse solve each. */
#ifndef UMBRA_THERMAL_ORBIT_RETURN_GROUP_H
#define UMBRA_THERMAL_ORBIT_RETURN_GROUP_H

#define UM_THERMAL_RETURN_SHIFT  3.84 /* b */
#define UM_THERMAL_RETURN_TERMS  5
#define UM_THERMAL_RETURN_SHARES /* a_1 to a_5 */                                                  \
  -0.29907834, 0.35190591, -3.10660309, 4.22582083, -1.67279433
#define UM_THERMAL_RETURN_ERROR 0.00076

#endif
