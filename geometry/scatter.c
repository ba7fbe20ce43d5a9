/* Points that are evenly spread over a facet scatter less than independent ones. Where a straight
 * edge cuts a facet, the variance of the fraction that n points find falls as n^-3/2 (Mitchell
 * 1996, Proc. SIGGRAPH, 277), not as 1/n; by how much less it is depends on the sequence.
 * `evenness` is that ratio for the points of points.c: the mean square of the error over the mean
 * of f (1 - f)/(n - 1), for lines drawn at random (isotropic, of uniform distance) of those that
 * cross a triangle, and all first indices. Errors of fractions that all points, or none, agree on
 * are in it. Good to 5 % for straight edges (test: geometry/scatter draws such lines). */
#include "geometry/scatter.h"

#include <math.h>
#include <stddef.h>

struct evenness {
  int n;
  double ratio; /* of variances [1] */
};

/* Logarithmic in both between entries; as n^-1/2 behind the last. */
static const struct evenness evenness[] = {
    {2, 0.676},    {3, 0.519},    {4, 0.404},    {6, 0.495},   {8, 0.41},    {12, 0.391},
    {16, 0.4},     {20, 0.399},   {24, 0.373},   {28, 0.32},   {32, 0.294},  {36, 0.248},
    {40, 0.211},   {44, 0.179},   {48, 0.152},   {64, 0.159},  {80, 0.156},  {96, 0.103},
    {128, 0.128},  {160, 0.082},  {192, 0.085},  {256, 0.069}, {320, 0.076}, {384, 0.07},
    {512, 0.0454}, {768, 0.0348}, {1024, 0.0299}};

static double evenness_of(int n)
{
  const size_t last = sizeof evenness / sizeof evenness[0] - 1;
  if (n >= evenness[last].n) return evenness[last].ratio * sqrt((double)evenness[last].n / n);
  size_t i = 0;
  while (n >= evenness[i + 1].n) i++;
  const struct evenness *a = &evenness[i], *b = a + 1;
  double way = log((double)n / a->n) / log((double)b->n / a->n);
  return a->ratio * pow(b->ratio / a->ratio, way);
}

double um_geometry_scatter(int nsample)
{
  /* e^2 = f (1 - f) s; f (1 - f) is 1/4 at most */
  return nsample < 2 ? 1.0 : evenness_of(nsample) / (nsample - 1);
}
