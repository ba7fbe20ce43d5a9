/* Plane layers of air or cloud over a ground: what they reflect and let through, by doubling and
 * adding (van de Hulst 1963; Hansen 1971, J. Atmos. Sci. 28:1400). Private to environment/.
 *
 * A layer is held by one term m of its Fourier series in azimuth, rho = pi L/(mu' E):
 *
 *   rho(mu, mu', phi) = sum_m (2 - delta_m0) rho_m(mu, mu') cos(m phi),   phi = 0: forward,
 *
 * at the 16 Gauss nodes mu_i of (0, 1) with weights w_i, times sqrt(c_i c_j), c = 2 mu w. So light
 * that goes through two of them is the product of two symmetric matrices. */
#ifndef UMBRA_ENVIRONMENT_SCATTER_LAYER_IMPL_H
#define UMBRA_ENVIRONMENT_SCATTER_LAYER_IMPL_H

#define UM_SCATTER_NODES 16
#define UM_SCATTER_MODES 32

struct um_environment_scatter_matrix {
  double of[UM_SCATTER_NODES][UM_SCATTER_NODES];
};
/* Alike from above and below; what passes holds what was not scattered. */
struct um_environment_scatter_layer {
  struct um_environment_scatter_matrix reflect, pass;
};

/* sqrt(2 mu w) of a node, and mu. */
double um_environment_scatter_root(int node);
double um_environment_scatter_cosine(int node);

/* A phase function by its moments chi_l, chi_0 = 1: P = sum (2 l + 1) chi_l P_l(cos), 1 in the
 * mean, and the share of what is met that scatters [1]. */
struct um_environment_scatter_phase {
  double moment[UM_SCATTER_MODES];
  double albedo;
};
/* A layer of so small a depth [1] that mu_0^2 is beyond its square: the middle-point rule, which
 * keeps energy. */
void um_environment_scatter_thin(const struct um_environment_scatter_phase *phase, int mode,
                                 double depth, struct um_environment_scatter_layer *out);
/* Twice the layer, in place. */
void um_environment_scatter_double(struct um_environment_scatter_layer *layer);
/* A layer over a ground that reflects: what both reflect together. */
void um_environment_scatter_over(const struct um_environment_scatter_layer *layer,
                                 const struct um_environment_scatter_matrix *ground,
                                 struct um_environment_scatter_matrix *out);

#endif
