/* How far evenly spread points are from the truth. */
#ifndef UMBRA_GEOMETRY_SCATTER_H
#define UMBRA_GEOMETRY_SCATTER_H

/* Mean square of the error of a fraction f that nsample points of a facet find, over f (1 - f),
 * where straight edges cut facets [1]: 1/(nsample - 1) would be that of independent points. Good to
 * 10 % (test: geometry/scatter); 1 for a single point. */
double um_geometry_scatter(int nsample);

#endif
