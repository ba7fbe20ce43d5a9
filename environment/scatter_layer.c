/* Layers by doubling and adding. With R and T of a layer,
 *
 *   R_2 = R + T (1 - R R)^-1 R T,   T_2 = T (1 - R R)^-1 T,
 *
 * the same with a ground R_g in place of the lower R. The first layer is thin: light d down and u
 * up on its two sides obeys, with A and B half its depth times
 *
 *   alpha_ij = (delta_ij - w/2 P_ij sqrt(w_i w_j))/sqrt(mu_i mu_j),   beta the same of backward
 *
 * and u = 0 below, (1 + A - B)(d + u) = (1 - A + B) d_0 and (1 + A + B)(d - u) = (1 - A - B) d_0
 * (Wiscombe 1976, J. Quant. Spectrosc. Radiat. Transf. 16:637). P_ij is the Fourier term of the
 * phase function, by associated Legendre functions. */
#include "environment/scatter_layer_impl.h"

#include <math.h>

#include "environment/quadrature_impl.h"

enum { N = UM_SCATTER_NODES };
typedef struct um_environment_scatter_matrix matrix;

double um_environment_scatter_cosine(int node) { return um_environment_gauss_16[node].x; }

double um_environment_scatter_root(int node)
{
  return sqrt(2.0 * um_environment_gauss_16[node].x * um_environment_gauss_16[node].w);
}

/* out = a b */
static void product(const matrix *a, const matrix *b, matrix *out)
{
  for (int i = 0; i < N; i++) {
    double row[N] = {0.0};
    for (int k = 0; k < N; k++)
      for (int j = 0; j < N; j++) row[j] += a->of[i][k] * b->of[k][j];
    for (int j = 0; j < N; j++) out->of[i][j] = row[j];
  }
}

/* a x = b for all columns of b, which x replaces; a, in which the diagonal leads, is lost. */
static void solve(matrix *a, matrix *b)
{
  for (int k = 0; k < N; k++) {
    double pivot = 1.0 / a->of[k][k];
    for (int j = 0; j < N; j++) b->of[k][j] *= pivot;
    for (int j = k; j < N; j++) a->of[k][j] *= pivot;
    for (int i = 0; i < N; i++) {
      double factor = a->of[i][k];
      if (i == k || factor == 0.0) continue;
      for (int j = k; j < N; j++) a->of[i][j] -= factor * a->of[k][j];
      for (int j = 0; j < N; j++) b->of[i][j] -= factor * b->of[k][j];
    }
  }
}

/* sqrt((l - m)!/(l + m)!) P_lm(mu) for l of m to the last, at a node. */
static void legendre(int mode, double mu, double out[UM_SCATTER_MODES])
{
  double s2 = (1.0 - mu) * (1.0 + mu), first = 1.0;
  for (int k = 1; k <= mode; k++) first *= sqrt((2.0 * k - 1.0) / (2.0 * k) * s2);
  for (int l = 0; l < UM_SCATTER_MODES; l++) {
    double k = l, m = mode;
    if (l < mode)
      out[l] = 0.0;
    else if (l == mode)
      out[l] = first;
    else if (l == mode + 1)
      out[l] = mu * sqrt(2.0 * m + 1.0) * first;
    else
      out[l] =
          ((2.0 * k - 1.0) * mu * out[l - 1] - sqrt((k - 1.0) * (k - 1.0) - m * m) * out[l - 2]) /
          sqrt(k * k - m * m);
  }
}

/* Fourier terms of the phase function from node to node, forward and backward. */
static void scattered(const struct um_environment_scatter_phase *phase, int mode, matrix *forward,
                      matrix *backward)
{
  double p[N][UM_SCATTER_MODES];
  for (int i = 0; i < N; i++) legendre(mode, um_environment_gauss_16[i].x, p[i]);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      double sum[2] = {0.0, 0.0};
      for (int l = mode; l < UM_SCATTER_MODES; l++)
        sum[(l + mode) % 2] += (2.0 * l + 1.0) * phase->moment[l] * p[i][l] * p[j][l];
      forward->of[i][j] = sum[0] + sum[1];
      backward->of[i][j] = sum[0] - sum[1];
    }
}

void um_environment_scatter_thin(const struct um_environment_scatter_phase *phase, int mode,
                                 double depth, struct um_environment_scatter_layer *out)
{
  matrix forward, backward, plus, minus, sum, difference;
  scattered(phase, mode, &forward, &backward);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      const struct um_environment_gauss *a = &um_environment_gauss_16[i],
                                        *b = &um_environment_gauss_16[j];
      double same = i == j ? 1.0 : 0.0, half = 0.5 * depth / sqrt(a->x * b->x);
      double part = 0.5 * phase->albedo * sqrt(a->w * b->w);
      double along = half * (same - part * forward.of[i][j]),
             back = half * part * backward.of[i][j];
      plus.of[i][j] = same + along - back;
      sum.of[i][j] = same - along + back;
      minus.of[i][j] = same + along + back;
      difference.of[i][j] = same - along - back;
    }
  solve(&plus, &sum);
  solve(&minus, &difference);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      out->pass.of[i][j] = 0.5 * (sum.of[i][j] + difference.of[i][j]);
      out->reflect.of[i][j] = 0.5 * (sum.of[i][j] - difference.of[i][j]);
    }
}

/* (1 - R S)^-1 T: what goes down between a layer and what lies below it. */
static void between(const struct um_environment_scatter_layer *layer, const matrix *below,
                    matrix *out)
{
  matrix left;
  product(&layer->reflect, below, &left);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) left.of[i][j] = (i == j ? 1.0 : 0.0) - left.of[i][j];
  *out = layer->pass;
  solve(&left, out);
}

void um_environment_scatter_over(const struct um_environment_scatter_layer *layer,
                                 const struct um_environment_scatter_matrix *ground,
                                 struct um_environment_scatter_matrix *out)
{
  matrix down, up;
  between(layer, ground, &down);
  product(ground, &down, &up);
  product(&layer->pass, &up, &down);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) out->of[i][j] = layer->reflect.of[i][j] + down.of[i][j];
}

void um_environment_scatter_double(struct um_environment_scatter_layer *layer)
{
  struct um_environment_scatter_layer twice;
  matrix down;
  between(layer, &layer->reflect, &down);
  product(&layer->pass, &down, &twice.pass);
  um_environment_scatter_over(layer, &layer->reflect, &twice.reflect);
  *layer = twice;
}
