/* The satellite in three dimensions on a page. */
#ifndef UMBRA_OUTPUT_PAGE_SCENE_H
#define UMBRA_OUTPUT_PAGE_SCENE_H

#include "base/page/writer.h"
#include "model/build/model.h"

struct um_output_scene {
  size_t ntime;                               /* at least 1 */
  const double *time;                         /* [ntime] seconds since 1970, UTC */
  const struct um_environment_sample *sample; /* [ntime] */
  const struct um_page_quantity *quantity;    /* [nquantity] */
  size_t nquantity;
};
/* Put the surfaces of a model on a page, with its moving parts and with the directions of the
 * samples, as far as they have them. UM_ERR_MEMORY. */
enum um_status um_output_page_put_scene(struct um_page_writer *w, const struct um_model *model,
                                        const struct um_output_scene *scene,
                                        const struct um_page_figure *figure);

/* report.html of a scenario before anything is solved: the satellite as it moves through the
 * scenario's window, parts, materials. Into a folder in the making. Errors of
 * um_model_sample_seen; UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_write_view(struct um_context *context, const struct um_model *model,
                                    const char *command, struct um_core_folder *folder);

#endif
