/* Published models, data and libraries that a run may rest on. Private to library/. */
#ifndef UMBRA_LIBRARY_SOURCES_IMPL_H
#define UMBRA_LIBRARY_SOURCES_IMPL_H

#include "model/build/model.h"

struct um_library_citation {
  const char *words;  /* "SGP4 (Vallado et al. 2006)" */
  const char *bibtex; /* one entry, with its line end */
  bool (*is_used)(const struct um_model *model);
};

/* NULL behind the last; borrowed. */
const struct um_library_citation *um_library_source_at(size_t index);

#endif
