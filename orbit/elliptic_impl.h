/* Elliptic functions and integrals of the parameter m = k^2, given with m1 = 1 - m, which says more
 * where m is near 1. Private to orbit/. */
#ifndef UMBRA_ORBIT_ELLIPTIC_IMPL_H
#define UMBRA_ORBIT_ELLIPTIC_IMPL_H

/* Quarter period K, 0 < m1 <= 1: pi / (2 AGM(1, sqrt m1)). Abramowitz & Stegun 17.6.3. */
double um_orbit_elliptic_k(double m1);
/* Integral of the first kind F of any amplitude [rad], by Carlson's R_F, to 1e-14: DLMF 19.25.5. */
double um_orbit_elliptic_f(double amplitude, double m1);
/* Jacobi's sn, cn, dn of -K <= u <= K by descending means, to 1e-14 at m1 = 1e-3 and less, 1e-8
 * where m1 vanishes; sn^2 + cn^2 = 1 always: Abramowitz & Stegun 16.4. */
void um_orbit_elliptic_jacobi(double u, double m1, double *sn, double *cn, double *dn);

#endif
