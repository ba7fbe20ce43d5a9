/* What falls short, said once for the terminal, the log, tables and study.nc. */
#include "study/shortfall.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

size_t um_study_points_of(const struct um_study_result *r, const struct um_study_quantity *quantity)
{
  size_t n = 0;
  for (size_t i = 0; i < r->npoint; i++) n += r->reason[i] == NULL ? 1 : 0;
  return quantity->withheld && r->nsolved < n ? r->nsolved : n;
}

/* One more line. */
UM_PRINTF(3, 4)
static enum um_status say(struct um_context *context, char **text, const char *format, ...)
{
  char line[1000], *both = NULL;
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  UM_TRY(um_core_asprintf(context, &both, "%s%s%s", *text != NULL ? *text : "",
                          *text != NULL ? "\n" : "", line));
  um_core_free(context, *text);
  *text = both;
  return UM_OK;
}

static enum um_status say_quantity(struct um_context *context, const struct um_study_result *r,
                                   size_t q, char **text)
{
  const struct um_study_quantity *of = &r->quantity[q];
  const char *unit = of->light && of->unit[0] == 'W' ? "" : of->unit;
  if (of->withheld)
    UM_TRY(say(context, text,
               "%s: from the %zu points that were solved alone, its mean within %.2g standard "
               "deviations: the surrogate leaves %.2g of one open, %.2g is borne; withheld: its "
               "values at other points, and Sobol shares",
               of->name, um_study_points_of(r, of), 1.0 / sqrt((double)um_study_points_of(r, of)),
               of->unexplained, UM_STUDY_BORNE));
  if (of->asked > 0.0 && r->error[q] > of->asked)
    UM_TRY(say(context, text, "%s: error at most %.2g%s%s, %.3g times the %.2g that is asked",
               of->name, r->error[q], unit[0] != '\0' ? " " : "", unit, r->error[q] / of->asked,
               of->asked));
  return UM_OK;
}

static enum um_status fill(struct um_context *context, const struct um_study_result *r, char **text)
{
  if (r->falls_short != NULL) UM_TRY(say(context, text, "%s", r->falls_short));
  if (r->npoint < r->wanted)
    UM_TRY(say(context, text, "no surrogate: %zu of %zu points, each solved by itself", r->npoint,
               r->wanted));
  for (size_t q = 0; q < r->nquantity; q++) UM_TRY(say_quantity(context, r, q, text));
  return UM_OK;
}

enum um_status um_study_shortfall(struct um_context *context, const struct um_study_result *result,
                                  char **out)
{
  char *text = NULL;
  enum um_status status = fill(context, result, &text);
  if (status != UM_OK) um_core_free(context, text);
  *out = status == UM_OK ? text : NULL;
  return status;
}
