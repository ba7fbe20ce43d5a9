/* STEP-TAS: a header that says so, before bytes that are the section of data and what follows; or
 * the whole file, where the bytes begin as one. */
#include <stdlib.h>
#include <string.h>

#include "geometry/obj_look.h"
#include "geometry/step_tas.h"
#include "tests/fuzz/fuzz.h"

static const char head[] = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('tas_arm'));\nENDSEC;\n";

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_geometry_obj_look look;
  size_t n = sizeof head - 1;
  uint8_t *whole = malloc(n + size);
  if (whole == NULL) abort();
  if (size >= 13 && memcmp(data, head, 13) == 0) n = 0;
  memcpy(whole, head, n);
  memcpy(whole + n, data, size);
  const char *path = um_fuzz_file(0, whole, n + size);
  if (um_fuzz_good(context, um_geometry_obj_look(context, path, &look))) {
    for (size_t g = 0; g < look.ngroup; g++)
      if (look.group[g].part >= look.npart || look.group[g].name[0] == '\0' ||
          look.group[g].nfacet == 0)
        um_fuzz_finding("group %zu of no part, without a name or a facet", g);
    um_fuzz_finite(look.high.x - look.low.x, "the size");
  }
  um_geometry_obj_look_clear(context, &look);
  struct um_geometry_step_tas_optical *optical;
  size_t noptical;
  bool is;
  if (um_fuzz_good(context,
                   um_geometry_step_tas_materials(context, path, &optical, &noptical, &is)))
    for (size_t i = 0; i < noptical; i++)
      if (!(optical[i].emittance >= 0.0 && optical[i].emittance <= 1.0))
        um_fuzz_finding("an emittance of %g", optical[i].emittance);
  um_core_free(context, optical);
  free(whole);
}
