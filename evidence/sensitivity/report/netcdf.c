/* sensitivity.nc: curves, and their derivatives by every parameter that has a column. */
#include <math.h>
#include <string.h>

#include "evidence/sensitivity/report/write.h"
#include "output/netcdf_grid.h"

enum axis { PARAMETER, BAND, TIME, PLACE };

struct writer {
  struct um_context *context;
  const struct um_sensitivity_report *report;
  const struct um_sensitivity_matrix *m;
  struct um_output_grid grid;
  const struct um_sensitivity_row **row; /* [n] those with a column */
  size_t n;
};

static enum um_status put_text(const struct writer *w, const char *name, const char *long_name,
                               const char *(*of)(const struct um_sensitivity_row *))
{
  const char **text;
  UM_TRY(um_core_allocate(w->context, w->n, sizeof *text, &text));
  for (size_t i = 0; i < w->n; i++) text[i] = of(w->row[i]);
  enum um_status status = um_output_grid_texts(&w->grid, name, PARAMETER, long_name, text);
  um_core_free(w->context, (void *)text);
  return status;
}

static const char *name_of(const struct um_sensitivity_row *r) { return r->name; }
static const char *unit_of(const struct um_sensitivity_row *r) { return r->unit; }
static const char *effect_of(const struct um_sensitivity_row *r)
{
  return r->candidate->effect->name;
}
static const char *target_of(const struct um_sensitivity_row *r)
{
  return r->candidate->target != NULL ? r->candidate->target : "";
}
static const char *method_of(const struct um_sensitivity_row *r)
{
  return um_sensitivity_way_name(r->quality.way);
}
static const char *why_of(const struct um_sensitivity_row *r)
{
  return r->why != NULL ? r->why : "";
}

static enum um_status put_texts(const struct writer *w)
{
  UM_TRY(put_text(w, "parameter", "EFFECT[:TARGET].PARAMETER", name_of));
  UM_TRY(put_text(w, "parameter_unit", "unit of the parameter", unit_of));
  UM_TRY(put_text(w, "effect", "effect of the parameter", effect_of));
  UM_TRY(put_text(w, "target", "what the effect acts on; empty: everything", target_of));
  UM_TRY(put_text(w, "method", "how the derivative was found", method_of));
  return put_text(w, "not_smooth", "why a small step does not follow it; empty: it does", why_of);
}

static double null_of(const struct um_sensitivity_row *r) { return r->null_value; }
static double width_of(const struct um_sensitivity_row *r) { return r->width; }
static double minimum_of(const struct um_sensitivity_row *r) { return r->minimum; }
static double maximum_of(const struct um_sensitivity_row *r) { return r->maximum; }
static double step_of(const struct um_sensitivity_row *r) { return r->quality.step; }
static double error_of(const struct um_sensitivity_row *r) { return r->quality.error; }
static double reach_of(const struct um_sensitivity_row *r) { return r->quality.reach; }

static enum um_status put_numbers(const struct writer *w)
{
  static const struct {
    const char *name, *units, *long_name;
    double (*of)(const struct um_sensitivity_row *);
  } all[] = {
      {"null_value", NULL, "value in the scenario [parameter_unit]", null_of},
      {"width", NULL, "width of the prior, or the first step of a fit [parameter_unit]", width_of},
      {"minimum", NULL, "least value that the parameter may have [parameter_unit]", minimum_of},
      {"maximum", NULL, "largest value that the parameter may have [parameter_unit]", maximum_of},
      {"step", NULL, "of the differences [parameter_unit]", step_of},
      {"error", "1", "estimated error of the derivative, of its largest value in a curve",
       error_of},
      {"reach", NULL,
       "way from null_value within which the derivative says every curve to a hundredth of its "
       "size [parameter_unit]",
       reach_of},
  };
  const int axis = PARAMETER;
  double *value;
  enum um_status status;
  UM_TRY(um_core_allocate(w->context, w->n, sizeof *value, &value));
  for (size_t a = 0; a < sizeof all / sizeof all[0]; a++) {
    for (size_t i = 0; i < w->n; i++) value[i] = all[a].of(w->row[i]);
    UM_CHECK(um_output_grid_numbers(&w->grid, all[a].name, &axis, 1, all[a].units, all[a].long_name,
                                    value));
  }
done:
  um_core_free(w->context, value);
  return status;
}

/* Curves from `first` on, of an axis [n]. */
struct curves {
  const char *name, *units, *long_name;
  int axis;
  size_t first, n;
};

static enum um_status put_axis(const struct writer *w, const struct curves *c)
{
  const char **name = NULL, **unit = NULL;
  char label[64];
  enum um_status status;
  UM_CHECK(um_core_allocate(w->context, c->n, sizeof *name, &name));
  UM_CHECK(um_core_allocate(w->context, c->n, sizeof *unit, &unit));
  for (size_t i = 0; i < c->n; i++) {
    name[i] = w->m->curve[c->first + i].name;
    unit[i] = w->m->curve[c->first + i].unit;
  }
  const char *axis = c->axis == BAND ? "band" : "place";
  UM_CHECK(um_output_grid_texts(
      &w->grid, axis, c->axis,
      c->axis == BAND ? "what light was observed" : "place of the satellite", name));
  snprintf(label, sizeof label, "%s_unit", c->name);
  UM_CHECK(um_output_grid_texts(&w->grid, label, c->axis, "unit of the curve", unit));
done:
  UM_FREE(w->context, (void *)name, (void *)unit);
  return status;
}

/* d ln(curve)/d ln(what is changed); NaN where there is no light, or no such thing. */
static void elasticities(const struct writer *w, const struct curves *c, double *value)
{
  size_t n = c->n * w->m->ntime;
  const double *curve = w->m->value + c->first * w->m->ntime;
  for (size_t i = 0; i < w->n; i++)
    for (size_t j = 0; j < n; j++)
      value[i * n + j] =
          curve[j] == 0.0 ? (double)NAN : value[i * n + j] * w->row[i]->log_scale / curve[j];
}

static enum um_status put_curves(const struct writer *w, const struct curves *c)
{
  const int of[] = {c->axis, TIME}, all[] = {PARAMETER, c->axis, TIME};
  const struct um_sensitivity_matrix *m = w->m;
  size_t n = c->n * m->ntime;
  char name[64], words[160], units[80];
  double *value = NULL;
  enum um_status status;
  if (c->n == 0) return UM_OK;
  UM_CHECK(put_axis(w, c));
  UM_CHECK(um_output_grid_numbers(&w->grid, c->name, of, 2, c->units, c->long_name,
                                  m->value + c->first * m->ntime));
  if (w->n == 0) goto done;
  UM_CHECK(um_core_allocate(w->context, w->n * n, sizeof *value, &value));
  for (size_t i = 0; i < w->n; i++)
    memcpy(value + i * n, w->row[i]->column + c->first * m->ntime, n * sizeof *value);
  snprintf(name, sizeof name, "d_%s", c->name);
  snprintf(words, sizeof words, "derivative of %s by the parameter", c->name);
  snprintf(units, sizeof units, "%s%sper parameter_unit", c->units != NULL ? c->units : "",
           c->units != NULL ? " " : "");
  UM_CHECK(um_output_grid_numbers(&w->grid, name, all, 3, units, words, value));
  if (!w->report->elasticity) goto done;
  elasticities(w, c, value);
  snprintf(name, sizeof name, "elasticity_%s", c->name);
  snprintf(words, sizeof words, "d ln(%s) / d ln(what the parameter changes)", c->name);
  UM_CHECK(um_output_grid_numbers(&w->grid, name, all, 3, "1", words, value));
done:
  um_core_free(w->context, value);
  return status;
}

/* The unit of all curves of light, or NULL where they have several. */
static const char *light_unit(const struct um_sensitivity_matrix *m)
{
  for (size_t c = 1; c < m->nlight; c++)
    if (strcmp(m->curve[c].unit, m->curve[0].unit) != 0) return NULL;
  return m->nlight == 0                           ? NULL
         : strcmp(m->curve[0].unit, "W/m^2") == 0 ? "W m-2"
                                                  : m->curve[0].unit;
}

static enum um_status put_all(struct writer *w)
{
  const struct um_sensitivity_matrix *m = w->m;
  const struct curves light = {"light", light_unit(m), "light in the scenario as it stands", BAND,
                               0,       m->nlight};
  const struct curves heat = {"temperature", "K",       "temperature in the scenario as it stands",
                              PLACE,         m->nlight, m->ncurve - m->nlight};
  UM_TRY(um_output_grid_axis(&w->grid, PARAMETER, "parameter", w->n));
  UM_TRY(um_output_grid_axis(&w->grid, BAND, "band", light.n));
  UM_TRY(um_output_grid_axis(&w->grid, PLACE, "place", heat.n));
  UM_TRY(um_output_grid_axis(&w->grid, TIME, "time", m->ntime));
  UM_TRY(um_output_grid_note(&w->grid, "title", m->forward->model->scenario->name));
  UM_TRY(um_output_grid_note(&w->grid, "Conventions", "CF-1.8"));
  UM_TRY(um_output_grid_note(&w->grid, "source", w->report->command));
  UM_TRY(um_output_grid_note(&w->grid, "umbra_version", w->report->version));
  UM_TRY(um_output_grid_times(&w->grid, TIME, m->time, m->ntime));
  if (w->n > 0) {
    UM_TRY(put_texts(w));
    UM_TRY(put_numbers(w));
  }
  UM_TRY(put_curves(w, &light));
  return put_curves(w, &heat);
}

enum um_status um_sensitivity_report_write_netcdf(struct um_context *context,
                                                  const struct um_sensitivity_report *report,
                                                  FILE *file)
{
  struct writer w = {.context = context, .report = report, .m = report->matrix};
  enum um_status status;
  UM_TRY(um_core_allocate(context, w.m->nrow, sizeof *w.row, &w.row));
  for (size_t i = 0; i < w.m->nrow; i++)
    if (w.m->row[i].column != NULL) w.row[w.n++] = &w.m->row[i];
  UM_CHECK(um_output_grid_begin(context, "sensitivity.nc", &w.grid));
  status = um_output_grid_end(&w.grid, put_all(&w), file);
done:
  um_core_free(context, (void *)w.row);
  return status;
}
