/* What was wanted and what came: a table and JSON of the shape the benchmarks have. */
#include <math.h>
#include <string.h>

#include "base/core/json.h"
#include "tests/lab/lab.h"

void lab_figures_add(struct lab_figures *figures, const char *name, const char *unit, double value,
                     double goal, bool at_least)
{
  if (isnan(value)) return; /* nothing was tried */
  if (figures->count == sizeof figures->figure / sizeof figures->figure[0]) return;
  struct lab_figure *f = &figures->figure[figures->count++];
  *f = (struct lab_figure){.unit = unit, .value = value, .goal = goal, .at_least = at_least};
  snprintf(f->name, sizeof f->name, "%s", name);
}

static bool is_met(const struct lab_figure *f)
{
  return f->at_least ? f->value >= f->goal : f->value <= f->goal;
}

bool lab_figures_met(const struct lab_figures *figures)
{
  bool all = true;
  for (size_t i = 0; i < figures->count; i++)
    all &= isnan(figures->figure[i].goal) || is_met(&figures->figure[i]);
  return all;
}

void lab_figures_print(const struct lab_figures *figures)
{
  printf("\n%-66s %10s %-5s %10s %4s\n", "figure", "value", "unit", "goal", "met");
  for (size_t i = 0; i < figures->count; i++) {
    const struct lab_figure *f = &figures->figure[i];
    char goal[32] = "";
    if (!isnan(f->goal)) snprintf(goal, sizeof goal, "%s %.4g", f->at_least ? ">=" : "<=", f->goal);
    printf("%-66s %10.4g %-5s %10s %4s\n", f->name, f->value, f->unit, goal,
           isnan(f->goal) ? "" : (is_met(f) ? "yes" : "no"));
  }
}

bool lab_figures_write(const struct lab_figures *figures, const char *path)
{
  FILE *file = fopen(path, "w");
  if (file == NULL) return false;
  fputs("[\n", file);
  for (size_t i = 0; i < figures->count; i++) {
    const struct lab_figure *f = &figures->figure[i];
    fputs("  {\"name\": ", file);
    um_core_json_string(file, f->name);
    um_core_json_field(file, ", ", "value", f->value);
    fprintf(file, ", \"unit\": \"%s\", \"reference\": null, \"ratio\": null", f->unit);
    um_core_json_field(file, ", ", "goal", f->goal);
    fprintf(file, ", \"met\": %s}%s\n", isnan(f->goal) ? "null" : (is_met(f) ? "true" : "false"),
            i + 1 < figures->count ? "," : "");
  }
  fputs("]\n", file);
  bool written = ferror(file) == 0;
  return fclose(file) == 0 && written;
}
