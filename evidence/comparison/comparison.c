/* A comparison as it is kept. */
#include "evidence/comparison/comparison.h"

void um_compare_destroy(struct um_context *context, struct um_compare_comparison **comparison)
{
  if (comparison == NULL || *comparison == NULL) return;
  struct um_compare_comparison *c = *comparison;
  for (size_t i = 0; i < c->nchannel; i++) {
    for (size_t w = 0; w < UM_COMPARE_WORST; w++) {
      UM_FREE(context, c->channel[i].worst[w].mechanism, c->channel[i].worst[w].material);
    }
    UM_FREE(context, c->channel[i].row, c->channel[i].correlation);
  }
  um_core_free(context, c->channel);
  um_compare_coordinates_destroy(context, &c->coordinates);
  UM_FREE(context, c->model, c->residual, c->light, c->motion, c);
  *comparison = NULL;
}
