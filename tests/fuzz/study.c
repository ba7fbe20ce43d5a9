/* study.yaml as text: what is read has a number of points that can be computed, and distributions
 * whose values lie between their ends. */
#include <stdlib.h>

#include "base/uncertainty/distribution.h"
#include "study/file.h"
#include "tests/fuzz/fuzz.h"

static void try_parameter(const struct um_study_file_parameter *p)
{
  struct um_uncertainty_distribution d = um_study_distribution(p);
  double least, largest;
  um_uncertainty_distribution_ends(&d, &least, &largest);
  um_fuzz_finite(least, "the least value");
  um_fuzz_finite(largest, "the largest value");
  for (int i = 0; i <= 4; i++) {
    double value = um_uncertainty_distribution_value(&d, 0.25 * i);
    um_fuzz_finite(value, "a value");
    if (p->values.count == 0 && !(value >= least && value <= largest))
      um_fuzz_finding("%g is not between %g and %g", value, least, largest);
  }
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  char *text = um_fuzz_text(data, size), name[UM_STUDY_NAME];
  struct um_document *document = NULL;
  struct um_study_file *file = NULL;
  if (um_fuzz_good(context, um_study_file_parse(context, "study.yaml", text, &document, &file))) {
    const struct um_study_file_parameter *p = file->parameters.items;
    double points = um_study_file_points(file);
    if (!(points >= 1.0 && points <= UM_STUDY_POINTS_MAX)) um_fuzz_finding("%g points", points);
    for (size_t i = 0; i < file->parameters.count; i++) {
      um_study_parameter_name(&p[i], name);
      try_parameter(&p[i]);
    }
  }
  um_document_destroy(&document);
  free(text);
}
