/* A comparison as it is kept. */
#include "evidence/comparison/comparison.h"

void um_compare_destroy(struct um_context *context, struct um_compare_comparison **comparison)
{
  if (comparison == NULL || *comparison == NULL) return;
  struct um_compare_comparison *c = *comparison;
  for (size_t i = 0; i < c->nchannel; i++) {
    for (size_t w = 0; w < UM_COMPARE_WORST; w++) {
      um_core_free(context, c->channel[i].worst[w].mechanism);
      um_core_free(context, c->channel[i].worst[w].material);
    }
    um_core_free(context, c->channel[i].row);
    um_core_free(context, c->channel[i].correlation);
  }
  um_core_free(context, c->channel);
  um_compare_coordinates_destroy(context, &c->coordinates);
  um_core_free(context, c->model);
  um_core_free(context, c->residual);
  um_core_free(context, c->light);
  um_core_free(context, c->motion);
  um_core_free(context, c);
  *comparison = NULL;
}
