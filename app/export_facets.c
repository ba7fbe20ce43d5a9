/* umbra export --as facets: which facets of a scenario are cut further, for thermal.facets. */
#include "app/export.h"
#include "app/target.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "model/build/build.h"
#include "model/run/mesh_error.h"
#include "output/facets.h"

static enum um_status write(struct um_context *context, const struct um_model *model,
                            const struct um_model_facets *facets, const char *path)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, path, &whole));
  um_output_write_facets(model, facets, whole.file);
  return um_core_whole_end(context, &whole, UM_OK);
}

static void print(const struct um_app_options *options, const struct um_model *model,
                  const struct um_model_facets *facets)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "file", options->out);
    printf(", \"reached\": %s, \"rounds\": [", facets->reached ? "true" : "false");
    for (size_t i = 0; i < facets->nround; i++) {
      printf("%s{\"facets\": %zu", i > 0 ? ", " : "", facets->round[i].nfacet);
      um_core_json_field(stdout, ", ", "error_K", facets->round[i].error);
      printf("}");
    }
    printf("]}\n");
    return;
  }
  printf("facets  mean temperature off by, at most\n");
  for (size_t i = 0; i < facets->nround; i++) {
    const struct um_model_facets_round *round = &facets->round[i];
    char side[UM_MODEL_MESH_SIDE];
    printf("%6zu  %.2g K  %s\n", round->nfacet, round->error,
           um_model_mesh_side(model, round->group, round->back, side));
  }
  printf("%s: write `thermal: {facets: ...}` with its name into the scenario\n", options->out);
}

static int export_facets(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_facets *facets = NULL;
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(um_app_check_picture(context, options, ".csv"));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_model_facets_adapt(context, model, &facets));
  UM_CHECK(write(context, model, facets, options->out));
  um_app_terminal_clear();
  if (!facets->reached)
    um_core_log(context, UM_LOG_WARNING,
                "facets: the mean temperature of a group is still off by %.2g K; "
                "thermal.facet_error_K asks for %g K",
                facets->round[facets->nround - 1].error, model->scenario->thermal->facet_error_K);
  print(options, model, facets);
done:
  um_model_facets_destroy(context, &facets);
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

const struct um_app_export um_app_export_facets = {
    .name = "facets",
    .target = "FILE.csv",
    .summary = "facets as small as temperatures ask for, for thermal.facets",
    .run = export_facets};
