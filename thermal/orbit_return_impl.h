/* What an orbit leaves of an error, turned round, of which sparse solves give:
 *
 *   1/(1 - exp(-x)) ~ 1 + 1/x + sum_k a_k u^k,   u = b/(x + b),   k = 1, 2, 3
 *
 * within 0.0038 for every x > 0, the nearest function of that form (Lawson's weights). */
#ifndef UMBRA_THERMAL_ORBIT_RETURN_IMPL_H
#define UMBRA_THERMAL_ORBIT_RETURN_IMPL_H

#define UM_THERMAL_RETURN_SHIFT  3.52 /* b */
#define UM_THERMAL_RETURN_TERMS  3
#define UM_THERMAL_RETURN_SHARES -0.19062561, -0.94577729, 0.64020059 /* a_1, a_2, a_3 */
#define UM_THERMAL_RETURN_ERROR  0.004

#endif
