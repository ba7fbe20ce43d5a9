/* umbra cases: temperatures of every case, and how far they stay from the limits. */
#include <math.h>

#include "app/app.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "output/cases.h"
#include "variant/cases.h"

static void print_cell(double value)
{
  if (isnan(value))
    printf(" %9s", "-");
  else
    printf(" %9.2f", value);
}

/* Returns how many places of the case leave their limits. */
static size_t print_case(const struct um_variant_cases *cases, const struct um_variant_case *c)
{
  size_t exceeded = 0;
  printf("case %s, %s\n", c->name, um_variant_analysis_name(c->analysis));
  printf("%-28s %9s %9s %9s %9s %9s %9s %9s\n", "place [K]", "mean", "lowest", "highest", "minimum",
         "maximum", "uncertain", "margin");
  for (size_t p = 0; p < c->nplace; p++) {
    const struct um_variant_case_place *place = &c->place[p];
    if (!um_output_case_shows(cases, place)) continue;
    printf("%-28s", place->name);
    const double cell[] = {place->mean,
                           place->lowest,
                           place->highest,
                           place->minimum,
                           place->maximum,
                           place->uncertainty,
                           um_variant_case_margin(place)};
    for (size_t k = 0; k < sizeof cell / sizeof cell[0]; k++) print_cell(cell[k]);
    printf("%s\n", um_variant_case_exceeded(place) ? "  EXCEEDED" : "");
    exceeded += um_variant_case_exceeded(place) ? 1 : 0;
  }
  return exceeded;
}

static size_t print_cases(const struct um_variant_cases *cases, const char *folder)
{
  size_t exceeded = 0, limits = 0;
  for (size_t i = 0; i < cases->count; i++) {
    exceeded += print_case(cases, &cases->item[i]);
    for (size_t p = 0; p < cases->item[i].nplace; p++)
      limits += isnan(um_variant_case_margin(&cases->item[i].place[p])) ? 0 : 1;
  }
  if (limits == 0)
    printf(
        "the scenario states no limits; accepted: limits: [{of: PLACE, minimum_K: .., maximum_K: "
        "..}]\n");
  else
    printf("%zu of %zu limits are exceeded\n", exceeded, limits);
  um_app_tell_results(folder);
  return exceeded;
}

static size_t json_cases(const struct um_variant_cases *cases, const char *folder)
{
  size_t exceeded = 0;
  um_core_json_text(stdout, "{", "folder", folder);
  printf(", \"cases\": [");
  for (size_t i = 0; i < cases->count; i++) {
    const struct um_variant_case *c = &cases->item[i];
    um_core_json_text(stdout, i > 0 ? ",\n  {" : "\n  {", "name", c->name);
    printf(", \"analysis\": \"%s\", \"places\": [", um_variant_analysis_name(c->analysis));
    for (size_t p = 0; p < c->nplace; p++) {
      const struct um_variant_case_place *place = &c->place[p];
      um_core_json_text(stdout, p > 0 ? ",\n    {" : "\n    {", "name", place->name);
      um_core_json_field(stdout, ", ", "mean_K", place->mean);
      um_core_json_field(stdout, ", ", "lowest_K", place->lowest);
      um_core_json_field(stdout, ", ", "highest_K", place->highest);
      um_core_json_field(stdout, ", ", "minimum_K", place->minimum);
      um_core_json_field(stdout, ", ", "maximum_K", place->maximum);
      um_core_json_field(stdout, ", ", "uncertainty_K", place->uncertainty);
      um_core_json_field(stdout, ", ", "margin_low_K", place->margin_low);
      um_core_json_field(stdout, ", ", "margin_high_K", place->margin_high);
      bool over = um_variant_case_exceeded(place);
      printf(", \"exceeded\": %s}", over ? "true" : "false");
      exceeded += over ? 1 : 0;
    }
    printf("]}");
  }
  printf("],\n \"exceeded\": %zu}\n", exceeded);
  return exceeded;
}

static enum um_status write_files(struct um_context *context, const struct um_app_options *options,
                                  const struct um_variant_cases *cases,
                                  struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "limits.csv", &file));
  um_output_write_cases(cases, file);
  UM_TRY(um_core_file_close(context, "limits.csv", &file));
  if (!options->no_plots) UM_TRY(um_output_plot_cases(context, cases, um_core_folder_path(folder)));
  return um_output_page_cases(context, cases, folder);
}

int um_app_cases(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_variant_cases *cases = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL, *name = NULL;
  size_t exceeded = 0;
  UM_CHECK(um_variant_cases_create(context, options->positional[0], &changes, &cases));
  UM_CHECK(um_core_asprintf(context, &name, "%s-cases", cases->scenario));
  UM_CHECK(um_app_out_folder(context, options, name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(write_files(context, options, cases, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  exceeded = options->json ? json_cases(cases, out) : print_cases(cases, out);
done:
  um_core_folder_abort(&folder);
  um_variant_cases_destroy(context, &cases);
  UM_FREE(context, out, name);
  if (status != UM_OK) return um_app_fail(context);
  return exceeded > 0 ? UM_APP_EXCEEDED : UM_APP_DONE;
}
