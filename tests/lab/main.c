/* lab: the hidden-effect laboratory. See lab.h and scenarios/hidden-effect/README.md. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/lab/lab.h"

static const char usage[] =
    "usage: lab [--out DIR] [--part effects|switches|complete|two|pairs|pulse|refusals]\n"
    "           [--only EFFECT] [--world NAME] [--seeds N] [--complete N] [--workers N]\n"
    "           [--quick] [--again] [--list] [--tables]\n"
    "  --out       folder of cases.csv and lab.json (out/lab)\n"
    "  --seeds     noises per effect and pass (5)\n"
    "  --complete  complete models in all (200)\n"
    "  --workers   processes that compute (one per processor)\n"
    "  --quick     a small part, for automatic tests\n"
    "  --again     forget the cases that stand in cases.csv\n"
    "  --list      print what would be tried\n"
    "  --tables    compute nothing, only tables of what stands in cases.csv\n";

static bool number(const char *text, uint64_t *out)
{
  char *end;
  if (text == NULL || text[0] < '0' || text[0] > '9') return false;
  *out = strtoull(text, &end, 10);
  return *end == '\0';
}

static bool parse(int argc, char **argv, struct lab_options *o)
{
  uint64_t workers = (uint64_t)sysconf(_SC_NPROCESSORS_ONLN);
  *o = (struct lab_options){.folder = "out/lab", .seeds = 5, .complete = 200};
  for (int i = 1; i < argc; i++) {
    const char *value = i + 1 < argc ? argv[i + 1] : NULL;
    bool takes = true, ok = value != NULL;
    if (strcmp(argv[i], "--out") == 0)
      o->folder = value;
    else if (strcmp(argv[i], "--part") == 0)
      o->part = value;
    else if (strcmp(argv[i], "--only") == 0)
      o->only = value;
    else if (strcmp(argv[i], "--world") == 0)
      o->world = value;
    else if (strcmp(argv[i], "--seeds") == 0)
      ok = number(value, &o->seeds);
    else if (strcmp(argv[i], "--complete") == 0)
      ok = number(value, &o->complete);
    else if (strcmp(argv[i], "--workers") == 0)
      ok = number(value, &workers) && workers > 0 && workers <= 256;
    else {
      takes = false;
      ok = true;
      if (strcmp(argv[i], "--quick") == 0)
        o->quick = true;
      else if (strcmp(argv[i], "--again") == 0)
        o->again = true;
      else if (strcmp(argv[i], "--list") == 0)
        o->list = true;
      else if (strcmp(argv[i], "--tables") == 0)
        o->tables = true;
      else
        return false;
    }
    if (!ok) return false;
    i += takes;
  }
  o->workers = (int)workers;
  return true;
}

static bool make_folder(const char *path)
{
  char part[LAB_TEXT * 4];
  struct stat st;
  for (size_t i = 1; i <= strlen(path) && i < sizeof part; i++) {
    if (path[i] != '/' && path[i] != '\0') continue;
    memcpy(part, path, i);
    part[i] = '\0';
    if (mkdir(part, 0777) != 0 && (stat(part, &st) != 0 || !S_ISDIR(st.st_mode))) return false;
  }
  return true;
}

static void print_list(const struct lab_case *cases, size_t count)
{
  for (size_t i = 0; i < count; i++) {
    char hidden[LAB_TEXT], with[LAB_HIDDEN * LAB_TEXT] = "";
    lab_case_hidden(&cases[i], hidden);
    for (size_t k = 0; k < cases[i].nhidden; k++) {
      char one[LAB_TEXT] = "?";
      lab_hidden_with(cases[i].world, &cases[i].hidden[k], one, sizeof one);
      lab_append(with, sizeof with, one);
    }
    printf("%-9s %-31s %-60s seed %llu\n", cases[i].part, cases[i].world->name,
           with[0] != '\0' ? with : hidden, (unsigned long long)cases[i].seed);
  }
}

/* The cases that have no row yet. */
static enum um_status work(struct um_context *context, const struct lab_options *o,
                           const struct lab_case *cases, size_t count, bool *done)
{
  struct lab_row *row = NULL;
  struct lab_case *left = NULL;
  size_t nrow, n = 0;
  enum um_status status;
  UM_CHECK(lab_journal_read(context, o->folder, &row, &nrow));
  UM_CHECK(um_core_allocate(context, count, sizeof *left, &left));
  for (size_t i = 0; i < count; i++)
    if (lab_journal_find(row, nrow, &cases[i]) == NULL) left[n++] = cases[i];
  if (n < count) printf("%zu of %zu cases stand in %s/cases.csv\n", count - n, count, o->folder);
  *done = n == 0 || lab_work(o, left, n);
done:
  um_core_free(context, left);
  um_core_free(context, row);
  return status;
}

static enum um_status report(struct um_context *context, const struct lab_options *o,
                             const struct lab_case *cases, size_t count,
                             struct lab_figures *figures)
{
  struct lab_row *row = NULL;
  size_t nrow;
  char path[LAB_TEXT * 4];
  UM_TRY(lab_journal_read(context, o->folder, &row, &nrow));
  lab_tables_effects(cases, count, row, nrow, figures);
  lab_tables_other(cases, count, row, nrow, figures);
  um_core_free(context, row);
  if (o->part == NULL || strcmp(o->part, "refusals") == 0) {
    size_t tried, answered = lab_refusals(context, o, &tried);
    lab_figures_add(figures, "questions that have no answer: answered all the same", "1",
                    (double)answered, 0.0, false);
  }
  lab_figures_print(figures);
  snprintf(path, sizeof path, "%s/lab.json", o->folder);
  if (lab_figures_write(figures, path)) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written", path);
}

int main(int argc, char **argv)
{
  struct lab_options o;
  struct lab_figures figures = {.count = 0};
  struct um_context *context = NULL;
  struct lab_case *cases = NULL;
  enum um_status status;
  bool done = true;
  if (!parse(argc, argv, &o)) {
    fputs(usage, stderr);
    return 2;
  }
  size_t count = lab_cases_make(&o, &cases);
  if (o.list) {
    print_list(cases, count);
    free(cases);
    return 0;
  }
  UM_CHECK(um_core_context_create(NULL, &context));
  um_core_context_set_threads(context, 1); /* before any fork: no pool of threads */
  if (!make_folder(o.folder) || !lab_journal_begin(o.folder, o.again)) {
    status = um_core_fail(context, UM_ERR_IO, "%s: cannot be written", o.folder);
    goto done;
  }
  if (!o.tables) UM_CHECK(work(context, &o, cases, count, &done));
  UM_CHECK(report(context, &o, cases, count, &figures));
done:
  if (status != UM_OK) fprintf(stderr, "lab: %s\n", um_core_message(context));
  um_core_context_destroy(&context);
  free(cases);
  return status == UM_OK && done && lab_figures_met(&figures) ? 0 : 1;
}
