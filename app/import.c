/* umbra import: a table of any header, or tracks of a survey, as a measurement file. */
#include "evidence/measurements/import.h"

#include <math.h>
#include <string.h>

#include "app/app.h"
#include "app/target.h"
#include "app/terminal.h"
#include "base/core/suggestions.h"
#include "evidence/measurements/mmt.h"
#include "evidence/measurements/noise.h"
#include "evidence/measurements/write.h"

/* What the option of a word of the columns says; NULL: nothing. */
static const char *said(const struct um_app_options *options, const char *word)
{
  char id[40];
  snprintf(id, sizeof id, "column-%s", word);
  const struct um_app_option *option = um_app_option_find(id);
  return *(const char *const *)(const void *)((const char *)options + option->at);
}

static bool is_value(const struct um_compare_columns *c)
{
  return c->magnitude != NULL || c->flux != NULL || c->counts != NULL || c->temperature != NULL;
}

/* The columns by --like, and before them by the options: another value is another thing with
 * another unit. *any: something is said of a table. */
static enum um_status find_columns(struct um_context *context, const struct um_app_options *options,
                                   struct um_compare_columns *columns, char **text, bool *any)
{
  struct um_compare_columns own = {0};
  const char *word;
  *columns = own;
  *any = options->like != NULL;
  for (size_t i = 0; (word = um_compare_columns_word(i)) != NULL; i++) {
    *um_compare_columns_member(&own, i) = said(options, word);
    *any = *any || said(options, word) != NULL;
  }
  if (options->like != NULL) UM_TRY(um_compare_columns_read(context, options->like, columns, text));
  if (is_value(&own))
    columns->magnitude = columns->flux = columns->counts = columns->temperature = columns->band =
        columns->of = columns->system = columns->unit = NULL;
  for (size_t i = 0; um_compare_columns_word(i) != NULL; i++) {
    const char *value = *um_compare_columns_member(&own, i);
    if (value != NULL) *um_compare_columns_member(columns, i) = value;
  }
  return UM_OK;
}

/* A table of which nothing is said: the guess, to be typed. */
static enum um_status refuse_bare(struct um_context *context, const char *path)
{
  char *command = NULL;
  UM_TRY(um_compare_import_suggest(context, path, &command));
  enum um_status status = um_core_fail(context, UM_ERR_INPUT,
                                       "%s: which column is what? as it seems: %s", path, command);
  um_core_free(context, command);
  return status;
}

static enum um_status choose_format(struct um_context *context,
                                    const struct um_app_options *options, bool any, bool *mmt)
{
  const char *format = options->format;
  *mmt = format != NULL && strcmp(format, "mmt") == 0;
  if (format != NULL && !*mmt && strcmp(format, "table") != 0)
    return um_core_fail(context, UM_ERR_INPUT, "--format %s: accepted: mmt, table", format);
  if (*mmt && any)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--format mmt: a track has its own columns; accepted: no column beside it");
  if (format == NULL && !any) UM_TRY(um_compare_mmt_is(context, options->positional[0], mmt));
  return any || *mmt ? UM_OK : refuse_bare(context, options->positional[0]);
}

static const char *form_text(enum um_orbit_time_form form)
{
  switch (form) {
  case UM_ORBIT_TIME_ISO:
    return "UTC";
  case UM_ORBIT_TIME_UNIX:
    return "POSIX seconds";
  case UM_ORBIT_TIME_JD:
    return "Julian dates of UTC";
  case UM_ORBIT_TIME_MJD:
    return "modified Julian dates of UTC";
  case UM_ORBIT_TIME_FORMS:
    break;
  }
  return "";
}

static void print_json(const char *out, const struct um_compare_measurements *m, const char *times,
                       const struct um_compare_imported *found)
{
  um_core_json_text(stdout, "{", "file", out);
  printf(", \"rows\": %zu, \"tracks\": %zu", m->count, m->ntrack);
  um_core_json_text(stdout, ", ", "quantity", um_compare_quantity_name(m->channel[0].quantity));
  um_core_json_text(stdout, ", ", "of", m->channel[0].of);
  printf(", \"channels\": %zu", m->nchannel);
  um_core_json_text(stdout, ", ", "times", times);
  printf(", \"put_in_order\": %s, \"without_value\": %zu, \"rows_of_zeros\": %zu, "
         "\"rows_held\": %zu, \"rows_doubled\": %zu}\n",
         found->sorted ? "true" : "false", found->empty, found->zeros, found->held, found->doubled);
}

static void print_table(const char *out, const struct um_compare_measurements *m,
                        const struct um_compare_imported *found)
{
  printf("%s: %zu row%s of %s ", out, m->count, m->count == 1 ? "" : "s",
         um_compare_quantity_name(m->channel[0].quantity));
  if (m->nchannel == 1)
    printf("%s", m->channel[0].of);
  else
    printf("of %zu places", m->nchannel);
  printf(", times read as %s", form_text(found->form));
  if (found->sorted) printf(", put in their order");
  if (found->empty > 0)
    printf(", %zu value%s that %s not there left out", found->empty, found->empty == 1 ? "" : "s",
           found->empty == 1 ? "is" : "are");
  if (found->zeros > 0)
    printf(", %zu row%s of zeros flagged", found->zeros, found->zeros == 1 ? "" : "s");
  if (found->held > 0)
    printf(", %zu row%s flagged that repeat%s the row before", found->held,
           found->held == 1 ? "" : "s", found->held == 1 ? "s" : "");
  if (found->doubled > 0)
    printf(", %zu row%s left out at the time of another", found->doubled,
           found->doubled == 1 ? "" : "s");
  printf("%s\n", isnan(m->row[0].sigma)
                     ? ", without sigma: --sigma, --noise or the scenario's noise gives one"
                     : "");
}

static enum um_status fill_noise(struct um_context *context, const struct um_app_options *options,
                                 const struct um_compare_noise *noise,
                                 struct um_compare_measurements *m)
{
  for (size_t c = 0; c < m->nchannel && options->noise != NULL; c++)
    UM_TRY(um_compare_noise_fill(context, m, c, noise, NULL));
  return UM_OK;
}

static enum um_status import_table(struct um_context *context, const struct um_app_options *options,
                                   const struct um_compare_columns *columns,
                                   const struct um_compare_noise *noise)
{
  enum um_status status;
  struct um_compare_measurements *m = NULL;
  struct um_compare_imported found;
  char *map = NULL, *note = NULL;
  UM_CHECK(um_compare_import(context, options->positional[0], columns, &found, &m));
  UM_CHECK(fill_noise(context, options, noise, m));
  UM_CHECK(um_compare_columns_text(context, &found.columns, &map));
  UM_CHECK(um_core_asprintf(context, &note, UM_COMPARE_IMPORT_MARK "%s", map));
  UM_CHECK(um_compare_measurements_write_noted(context, m, note, options->out));
  um_app_terminal_clear();
  if (options->json)
    print_json(options->out, m, form_text(found.form), &found);
  else
    print_table(options->out, m, &found);
done:
  um_compare_measurements_destroy(context, &m);
  UM_FREE(context, map, note);
  return status;
}

static enum um_status import_track(struct um_context *context, const struct um_app_options *options,
                                   const struct um_compare_noise *noise)
{
  enum um_status status;
  struct um_compare_measurements *m = NULL;
  const struct um_compare_imported none = {0};
  UM_CHECK(um_compare_mmt_read(context, options->positional[0], &m, NULL));
  UM_CHECK(fill_noise(context, options, noise, m));
  UM_CHECK(um_compare_measurements_write(context, m, options->out));
  um_app_terminal_clear();
  if (options->json)
    print_json(options->out, m, form_text(UM_ORBIT_TIME_ISO), &none);
  else
    printf("%s: %zu observations, %zu tracks%s\n", options->out, m->count, m->ntrack,
           options->noise == NULL ? ", without sigma: --noise or the scenario's noise gives one"
                                  : "");
done:
  um_compare_measurements_destroy(context, &m);
  return status;
}

int um_app_import(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_compare_columns columns;
  struct um_compare_noise noise = {0};
  char *text = NULL;
  bool any, mmt;
  if (options->noise != NULL &&
      !um_app_noise_parse(options->noise, 0.0, &noise.relative, &noise.floor)) {
    fputs("umbra: --noise takes one number, or two with a comma between them\n", stderr);
    return UM_APP_MISUSE;
  }
  UM_CHECK(um_app_check_table(context, options));
  UM_CHECK(find_columns(context, options, &columns, &text, &any));
  UM_CHECK(choose_format(context, options, any, &mmt));
  if (mmt)
    UM_CHECK(import_track(context, options, &noise));
  else
    UM_CHECK(import_table(context, options, &columns, &noise));
done:
  um_core_free(context, text);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
