/* umbra export --as mesh: the outside of the satellite as Wavefront OBJ. */
#include "app/export.h"
#include "app/target.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "output/mesh_obj.h"

static enum um_status write(struct um_context *context, const struct um_model *model,
                            const char *path)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, path, &whole));
  return um_core_whole_end(context, &whole, um_output_write_obj(context, model, whole.file));
}

static int export_mesh(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(um_app_check_picture(context, options, ".obj"));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(write(context, model, options->out));
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  um_app_terminal_clear();
  if (options->json) {
    um_core_json_text(stdout, "{", "file", options->out);
    printf(", \"parts\": %zu, \"facets\": %zu, \"vertices\": %zu}\n",
           um_geometry_part_count(model->geometry), mesh->nfacet, mesh->nvertex);
  } else {
    printf("%s: %zu triangle%s of %zu part%s\n", options->out, mesh->nfacet,
           mesh->nfacet == 1 ? "" : "s", um_geometry_part_count(model->geometry),
           um_geometry_part_count(model->geometry) == 1 ? "" : "s");
  }
done:
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_mesh = {
    .name = "mesh",
    .target = "FILE.obj",
    .summary = "the outside as Wavefront OBJ in metres, groups by part",
    .run = export_mesh};
