/* What-ifs of a page: curves, and their derivatives by parameters. */
#include <math.h>

#include "base/core/json.h"
#include "base/page/page_impl.h"

static void put_slider(FILE *file, const struct um_page_slider *s)
{
  um_core_json_text(file, "{", "name", s->name);
  um_page_key(file, "label", s->label);
  um_page_key(file, "unit", s->unit);
  um_core_json_field(file, ", ", "null", s->null_value);
  um_core_json_field(file, ", ", "minimum", s->minimum);
  um_core_json_field(file, ", ", "maximum", s->maximum);
  if (!isinf(s->reach)) /* absent: the line holds everywhere; not known: nowhere is promised */
    um_core_json_field(file, ", ", "reach", isnan(s->reach) ? 0.0 : s->reach);
  um_core_json_field(file, ", ", "width", s->width);
  um_core_json_bool(file, ", ", "switch", s->is_switch);
  um_core_json_bool(file, ", ", "logarithmic", s->logarithmic);
  um_page_key(file, "text", s->text);
  fputc('}', file);
}

void um_page_sliders(struct um_page *page, const struct um_page_figure *figure,
                     const struct um_page_axis *x, const struct um_page_shade *shade, size_t nshade,
                     const struct um_page_slider *slider, size_t nslider,
                     const struct um_page_curve *curve, size_t ncurve)
{
  FILE *file = um_page_figure_begin(page, figure, "sliders");
  um_page_put_axis(page, file, "x", x);
  um_page_put_shade(file, shade, nshade);
  fputs(", \"parameters\": [\n", file);
  for (size_t i = 0; i < nslider; i++) {
    if (i > 0) fputs(",\n", file);
    put_slider(file, &slider[i]);
  }
  fputs("], \"curves\": [\n", file);
  for (size_t c = 0; c < ncurve; c++) {
    um_core_json_text(file, c > 0 ? ",\n{" : "{", "name", curve[c].name);
    um_page_key(file, "unit", curve[c].unit);
    um_page_key(file, "panel", curve[c].panel);
    fputs(", \"base\": ", file);
    um_page_put_doubles(page, file, curve[c].base, x->count);
    fputs(", \"derivative\": [", file);
    for (size_t i = 0; i < nslider; i++) {
      if (i > 0) fputs(", ", file);
      um_page_put_floats(page, file, curve[c].derivative[i], x->count);
    }
    fputs("], \"error\": [", file);
    for (size_t i = 0; i < nslider; i++) {
      if (i > 0) fputs(", ", file);
      um_core_json_number(file, curve[c].error[i]);
    }
    fputs("]}", file);
  }
  fputs("]}", file);
  if (um_page_has_viewer()) return;
  um_page_plain_begin(page, figure);
  um_page_plain_head(page, "parameter", NULL);
  um_page_plain_head(page, "value in the scenario", NULL);
  um_page_plain_head(page, "from", NULL);
  um_page_plain_head(page, "to", NULL);
  for (size_t i = 0; i < nslider; i++) {
    um_page_plain_row(page);
    um_page_plain_cell(page, slider[i].name, NAN);
    um_page_plain_cell(page, NULL, slider[i].null_value);
    um_page_plain_cell(page, NULL, slider[i].minimum);
    um_page_plain_cell(page, NULL, slider[i].maximum);
  }
  um_page_plain_end(page);
}
