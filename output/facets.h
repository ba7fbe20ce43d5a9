/* Which facets are cut further, as a table that thermal.facets reads. */
#ifndef UMBRA_OUTPUT_FACETS_H
#define UMBRA_OUTPUT_FACETS_H

#include <stdio.h>

#include "model/products/facets.h"

/* Rows round, part, facets, facet of every facet that is halved, after a comment that says what
 * they were made for. The stream's errors are the caller's to ask for. */
void um_output_write_facets(const struct um_model *model, const struct um_model_facets *facets,
                            FILE *file);

#endif
