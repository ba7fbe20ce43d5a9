/* The figure of ranges beside their limits (format.md), and its table where there is no viewer. */
#include <math.h>

#include "base/core/json.h"
#include "base/page/page_impl.h"

static void put(FILE *file, const struct um_page_range *r)
{
  um_core_json_text(file, "{", "name", r->name);
  um_page_key(file, "of", r->of);
  um_core_json_field(file, ", ", "low", r->low);
  um_core_json_field(file, ", ", "high", r->high);
  if (isfinite(r->error)) um_core_json_field(file, ", ", "error", r->error);
  if (isfinite(r->minimum)) um_core_json_field(file, ", ", "minimum", r->minimum);
  if (isfinite(r->maximum)) um_core_json_field(file, ", ", "maximum", r->maximum);
  um_page_key(file, "text", r->text);
  if (r->exceeded) um_core_json_bool(file, ", ", "exceeded", true);
  fputc('}', file);
}

static void plain(struct um_page *page, const struct um_page_figure *figure,
                  const struct um_page_axis *value, const struct um_page_range *range, size_t n)
{
  static const char *const head[] = {"lowest", "highest", "uncertainty", "minimum", "maximum"};
  um_page_plain_begin(page, figure);
  um_page_plain_head(page, "", NULL);
  um_page_plain_head(page, "", NULL);
  for (size_t i = 0; i < sizeof head / sizeof head[0]; i++)
    um_page_plain_head(page, head[i], value->unit);
  um_page_plain_head(page, "", NULL);
  for (size_t i = 0; i < n; i++) {
    const struct um_page_range *r = &range[i];
    const double number[] = {r->low, r->high, r->error, r->minimum, r->maximum};
    um_page_plain_row(page);
    um_page_plain_cell(page, r->name, NAN);
    um_page_plain_cell(page, r->of, NAN);
    for (size_t k = 0; k < sizeof number / sizeof number[0]; k++)
      um_page_plain_cell(page, NULL, number[k]);
    um_page_plain_cell(page, r->text != NULL ? r->text : "", NAN);
  }
  um_page_plain_end(page);
}

void um_page_ranges(struct um_page *page, const struct um_page_figure *figure,
                    const struct um_page_axis *value, const struct um_page_range *range,
                    size_t nrange)
{
  FILE *file = um_page_figure_begin(page, figure, "ranges");
  um_page_key(file, "name", value->name);
  um_page_key(file, "unit", value->unit);
  fputs(", \"ranges\": [", file);
  for (size_t i = 0; i < nrange; i++) {
    if (i > 0) fputs(",\n", file);
    put(file, &range[i]);
  }
  fputs("]}", file);
  if (!um_page_has_viewer()) plain(page, figure, value, range, nrange);
}
