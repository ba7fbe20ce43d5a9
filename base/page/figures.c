/* Figures of a page as JSON (format.md), and as tables where there is no viewer. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "base/core/json.h"
#include "base/page/page_impl.h"

static const char *const scales[] = {[UM_PAGE_LINEAR] = "linear",
                                     [UM_PAGE_LOG] = "log",
                                     [UM_PAGE_MAGNITUDE] = "magnitude",
                                     [UM_PAGE_TIME] = "time"};
static const char *const marks[] = {[UM_PAGE_LINE] = "line",
                                    [UM_PAGE_POINTS] = "points",
                                    [UM_PAGE_STEP] = "step",
                                    [UM_PAGE_AREA] = "area"};

static void number(FILE *file, const char *key, double value)
{
  um_core_json_field(file, ", ", key, value);
}

static void array(struct um_page *page, FILE *file, const char *key, const double *value,
                  size_t count)
{
  if (value == NULL) return;
  fprintf(file, ", \"%s\": ", key);
  um_page_put_doubles(page, file, value, count);
}

void um_page_put_axis(struct um_page *page, FILE *file, const char *key,
                      const struct um_page_axis *axis)
{
  fprintf(file, ", \"%s\": ", key);
  um_core_json_text(file, "{", "name", axis->name);
  um_page_key(file, "unit", axis->unit);
  um_page_key(file, "scale", scales[axis->scale]);
  array(page, file, "data", axis->value, axis->count);
  fputc('}', file);
}

void um_page_put_shade(FILE *file, const struct um_page_shade *shade, size_t nshade)
{
  fputs(", \"shade\": [", file);
  for (size_t i = 0; i < nshade; i++) {
    fprintf(file, "%s{\"from\": %.13g, \"to\": %.13g", i > 0 ? ", " : "", shade[i].from,
            shade[i].to);
    um_page_key(file, "name", shade[i].name);
    fputc('}', file);
  }
  fputc(']', file);
}

static void put_series(struct um_page *page, FILE *file, const struct um_page_series *s,
                       size_t count)
{
  um_core_json_text(file, "{", "name", s->name);
  um_page_key(file, "role", s->role);
  um_page_key(file, "column", s->column);
  um_page_key(file, "mark", marks[s->mark]);
  if (s->hidden) um_core_json_bool(file, ", ", "hidden", true);
  array(page, file, "data", s->value, count);
  array(page, file, "error", s->error, count);
  array(page, file, "low", s->low, count);
  array(page, file, "high", s->high, count);
  array(page, file, "x", s->x, count);
  fputc('}', file);
}

static size_t count_of(const struct um_page_series *s, const struct um_page_axis *x)
{
  return s->count > 0 ? s->count : x->count;
}

/* A place on an axis as a text: of times ISO 8601. */
static void plain_place(struct um_page *page, const struct um_page_axis *axis, double value)
{
  char text[40];
  struct tm tm;
  double whole = floor(value);
  time_t seconds = (time_t)whole;
  if (axis->scale != UM_PAGE_TIME || !isfinite(value) || gmtime_r(&seconds, &tm) == NULL ||
      strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &tm) == 0) {
    um_page_plain_cell(page, NULL, value);
    return;
  }
  size_t n = strlen(text);
  snprintf(text + n, sizeof text - n, ".%03dZ", (int)((value - whole) * 1e3));
  um_page_plain_cell(page, text, NAN);
}

/* One table of a figure: series that stand on its axis; those with an axis of their own follow. */
static void plain_axes(struct um_page *page, const struct um_page_figure *figure,
                       const struct um_page_axis *x, const struct um_page_panel *panel,
                       size_t npanel)
{
  um_page_plain_begin(page, figure);
  um_page_plain_head(page, x->name, x->unit);
  for (size_t p = 0; p < npanel; p++)
    for (size_t s = 0; s < panel[p].nseries; s++)
      if (panel[p].series[s].x == NULL)
        um_page_plain_head(page, panel[p].series[s].name, panel[p].unit);
  for (size_t k = 0; k < x->count; k++) {
    um_page_plain_row(page);
    plain_place(page, x, x->value[k]);
    for (size_t p = 0; p < npanel; p++)
      for (size_t s = 0; s < panel[p].nseries; s++)
        if (panel[p].series[s].x == NULL)
          um_page_plain_cell(page, NULL, panel[p].series[s].value[k]);
  }
  um_page_plain_end(page);
  for (size_t p = 0; p < npanel; p++)
    for (size_t i = 0; i < panel[p].nseries; i++) {
      const struct um_page_series *s = &panel[p].series[i];
      const struct um_page_figure own = {.id = figure->id, .title = s->name};
      if (s->x == NULL) continue;
      um_page_plain_begin(page, &own);
      um_page_plain_head(page, x->name, x->unit);
      um_page_plain_head(page, s->name, panel[p].unit);
      for (size_t k = 0; k < s->count; k++) {
        um_page_plain_row(page);
        plain_place(page, x, s->x[k]);
        um_page_plain_cell(page, NULL, s->value[k]);
      }
      um_page_plain_end(page);
    }
}

void um_page_axes(struct um_page *page, const struct um_page_figure *figure,
                  const struct um_page_axis *x, const struct um_page_shade *shade, size_t nshade,
                  const struct um_page_panel *panel, size_t npanel)
{
  FILE *file = um_page_figure_begin(page, figure, "axes");
  um_page_put_axis(page, file, "x", x);
  um_page_put_shade(file, shade, nshade);
  fputs(", \"panels\": [", file);
  for (size_t p = 0; p < npanel; p++) {
    um_core_json_text(file, p > 0 ? ",\n{" : "\n{", "name", panel[p].name);
    um_page_key(file, "unit", panel[p].unit);
    um_page_key(file, "scale", scales[panel[p].scale]);
    if (panel[p].stacked) um_core_json_bool(file, ", ", "stacked", true);
    if (panel[p].zero) um_core_json_bool(file, ", ", "zero", true);
    fputs(", \"series\": [", file);
    for (size_t s = 0; s < panel[p].nseries; s++) {
      if (s > 0) fputs(",\n", file);
      put_series(page, file, &panel[p].series[s], count_of(&panel[p].series[s], x));
    }
    fputs("]}", file);
  }
  fputs("]}", file);
  if (!um_page_has_viewer()) plain_axes(page, figure, x, panel, npanel);
}

void um_page_table(struct um_page *page, const struct um_page_figure *figure,
                   const struct um_page_column *column, size_t ncolumn, size_t nrow)
{
  FILE *file = um_page_figure_begin(page, figure, "table");
  fputs(", \"columns\": [", file);
  for (size_t c = 0; c < ncolumn; c++) {
    um_core_json_text(file, c > 0 ? ",\n{" : "{", "name", column[c].name);
    um_page_key(file, "unit", column[c].unit);
    fputs(", \"values\": [", file);
    for (size_t r = 0; r < nrow; r++) {
      if (r > 0) fputs(", ", file);
      if (column[c].text == NULL)
        um_core_json_number(file, column[c].value[r]);
      else
        um_core_json_string(file, column[c].text[r] != NULL ? column[c].text[r] : "");
    }
    fputs("]}", file);
  }
  fputs("]}", file);
  if (um_page_has_viewer()) return;
  um_page_plain_begin(page, figure);
  for (size_t c = 0; c < ncolumn; c++) um_page_plain_head(page, column[c].name, column[c].unit);
  for (size_t r = 0; r < nrow; r++) {
    um_page_plain_row(page);
    for (size_t c = 0; c < ncolumn; c++)
      um_page_plain_cell(page, column[c].text != NULL ? column[c].text[r] : NULL,
                         column[c].text != NULL ? (double)NAN : column[c].value[r]);
  }
  um_page_plain_end(page);
}

void um_page_bars(struct um_page *page, const struct um_page_figure *figure,
                  const struct um_page_axis *value, const struct um_page_bar *bar, size_t nbar)
{
  FILE *file = um_page_figure_begin(page, figure, "bars");
  um_page_key(file, "name", value->name);
  um_page_key(file, "unit", value->unit);
  um_page_key(file, "scale", scales[value->scale]);
  fputs(", \"bars\": [", file);
  for (size_t i = 0; i < nbar; i++) {
    um_core_json_text(file, i > 0 ? ",\n{" : "{", "name", bar[i].name);
    number(file, "value", bar[i].value);
    if (isfinite(bar[i].error)) number(file, "error", bar[i].error);
    um_page_key(file, "text", bar[i].text);
    fputc('}', file);
  }
  fputs("]}", file);
  if (um_page_has_viewer()) return;
  um_page_plain_begin(page, figure);
  um_page_plain_head(page, "", NULL);
  um_page_plain_head(page, value->name, value->unit);
  for (size_t i = 0; i < nbar; i++) {
    um_page_plain_row(page);
    um_page_plain_cell(page, bar[i].name, NAN);
    um_page_plain_cell(page, NULL, bar[i].value);
  }
  um_page_plain_end(page);
}

void um_page_map(struct um_page *page, const struct um_page_figure *figure,
                 const struct um_page_axis *x, const struct um_page_axis *y, const char *name,
                 const char *unit, const double *z, bool diverging)
{
  FILE *file = um_page_figure_begin(page, figure, "map");
  um_page_put_axis(page, file, "x", x);
  um_page_put_axis(page, file, "y", y);
  um_core_json_text(file, ", \"z\": {", "name", name);
  um_page_key(file, "unit", unit);
  array(page, file, "data", z, x->count * y->count);
  fputc('}', file);
  if (diverging) um_core_json_bool(file, ", ", "diverging", true);
  fputc('}', file);
  if (um_page_has_viewer()) return;
  um_page_plain_begin(page, figure);
  um_page_plain_head(page, y->name, y->unit);
  for (size_t i = 0; i < x->count; i++) um_page_plain_head(page, "", NULL);
  for (size_t j = 0; j < y->count; j++) {
    um_page_plain_row(page);
    plain_place(page, y, y->value[j]);
    for (size_t i = 0; i < x->count; i++) um_page_plain_cell(page, NULL, z[j * x->count + i]);
  }
  um_page_plain_end(page);
}

void um_page_sky(struct um_page *page, const struct um_page_figure *figure,
                 const struct um_page_sky *sky)
{
  FILE *file = um_page_figure_begin(page, figure, "sky");
  array(page, file, "time", sky->time, sky->count);
  array(page, file, "azimuth_deg", sky->azimuth_deg, sky->count);
  array(page, file, "elevation_deg", sky->elevation_deg, sky->count);
  array(page, file, "sunlit", sky->sunlit, sky->count);
  fputs(", \"marks\": [", file);
  for (size_t i = 0; i < sky->nmark; i++) {
    fprintf(file, "%s{\"time\": %.13g", i > 0 ? ", " : "", sky->mark[i].time);
    um_page_key(file, "name", sky->mark[i].name);
    fputc('}', file);
  }
  fputs("]}", file);
  if (um_page_has_viewer()) return;
  const struct um_page_axis time = {"time", "UTC", UM_PAGE_TIME, sky->time, sky->count};
  const struct um_page_series series[] = {{.name = "azimuth", .value = sky->azimuth_deg},
                                          {.name = "elevation", .value = sky->elevation_deg}};
  const struct um_page_panel panel = {.unit = "deg", .series = series, .nseries = 2};
  plain_axes(page, figure, &time, &panel, 1);
}
