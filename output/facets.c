#include "output/facets.h"

#include "base/core/csv.h"

void um_output_write_facets(const struct um_model *model, const struct um_model_facets *facets,
                            FILE *file)
{
  const struct um_model_facets_round *last = &facets->round[facets->nround - 1];
  fprintf(file,
          "# thermal.facets of %s: %zu facets in place of %zu; mean temperatures of groups "
          "off by %.2g K at most, %g K asked for\n",
          model->scenario->name, last->nfacet, facets->round[0].nfacet, last->error,
          model->scenario->thermal->facet_error_K);
  fprintf(file, "round,part,facets,facet\n");
  for (size_t p = 0; p < facets->npart; p++)
    for (size_t i = 0; i < facets->part[p].nround; i++) {
      const struct um_geometry_halving *round = &facets->part[p].round[i];
      for (size_t k = 0; k < round->nhalved; k++) {
        fprintf(file, "%zu,", i + 1);
        um_core_csv_put(file, um_geometry_part_name(model->geometry, p), "");
        fprintf(file, ",%zu,%lu\n", round->nfacet, (unsigned long)round->facet[k]);
      }
    }
}
