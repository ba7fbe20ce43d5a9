/* umbra synth: measurements made from a scenario, with noise. */
#include "evidence/inversion/synth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/target.h"
#include "app/terminal.h"
#include "base/core/csv.h"
#include "evidence/measurements/write.h"

#define SEED_MAX 9007199254740992.0 /* 2^53: whole numbers that a double holds */

/* A list "a,b" cut in place; names borrow from it. */
static enum um_status split_places(struct um_context *context, char *list, const char ***out,
                                   size_t *count)
{
  size_t n = 1;
  for (const char *c = list; *c != '\0'; c++) n += *c == ',';
  UM_TRY(um_core_allocate(context, n, sizeof **out, out));
  for (char *at = list, *comma; at != NULL; at = comma) {
    comma = strchr(at, ',');
    if (comma != NULL) *comma++ = '\0';
    (*out)[(*count)++] = at;
  }
  return UM_OK;
}

static int misuse(const char *what)
{
  fprintf(stderr, "umbra: %s\n", what);
  return UM_APP_MISUSE;
}

static int read_options(const struct um_app_options *options, struct um_compare_synth *o)
{
  double seed;
  if (!um_app_noise_parse(options->noise, UM_APP_FLOOR, &o->relative, &o->floor))
    return misuse("--noise takes one number, or two with a comma between them");
  if (!um_core_number_parse(options->seed, &seed) || !(seed >= 0.0 && seed <= SEED_MAX) ||
      seed != floor(seed))
    return misuse("--seed takes a whole number from 0 to 2^53");
  o->seed = (uint64_t)seed;
  o->temperature_sigma = UM_APP_TEMPERATURE_SIGMA;
  if (options->temperature_sigma != NULL &&
      !um_core_number_parse(options->temperature_sigma, &o->temperature_sigma))
    return misuse("--temperature-sigma takes a number [K]");
  return UM_APP_DONE;
}

static void json_set(const struct um_compare_measurements *m, const char *out)
{
  um_core_json_text(stdout, "{", "file", out);
  um_core_json_count(stdout, ", ", "rows", m->count);
  printf(", \"channels\": [");
  for (size_t i = 0; i < m->nchannel; i++) {
    um_core_json_text(stdout, i > 0 ? ", {" : "{", "quantity",
                      um_compare_quantity_name(m->channel[i].quantity));
    um_core_json_text(stdout, ", ", "of", m->channel[i].of);
    um_core_json_count(stdout, ", ", "rows", m->channel[i].count);
    printf("}");
  }
  printf("]}\n");
}

static void print_set(const struct um_compare_measurements *m, const char *out)
{
  printf("%s: %zu observations", out, m->count);
  for (size_t i = 0; i < m->nchannel; i++)
    printf("%s %s %s %zu", i > 0 ? "," : ":", um_compare_quantity_name(m->channel[i].quantity),
           m->channel[i].of, m->channel[i].count);
  printf("\n");
}

int um_app_synth(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_compare_synth o = {0};
  struct um_compare_measurements *made = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *list = NULL;
  const char **place = NULL;
  int code = read_options(options, &o);
  if (code != UM_APP_DONE) return code;
  UM_CHECK(um_app_check_table(context, options));
  if (options->temperatures != NULL) {
    UM_CHECK(um_core_strdup(context, options->temperatures, &list));
    UM_CHECK(split_places(context, list, &place, &o.nplace));
    o.place = place;
  }
  o.grey_body = options->grey_body;
  UM_CHECK(
      um_compare_synth_run(context, options->positional[0], &changes, &o, options->out, &made));
  UM_CHECK(um_compare_measurements_write(context, made, options->out));
  um_app_terminal_clear();
  if (options->json)
    json_set(made, options->out);
  else
    print_set(made, options->out);
done:
  um_compare_measurements_destroy(context, &made);
  UM_FREE(context, (void *)place, list);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
