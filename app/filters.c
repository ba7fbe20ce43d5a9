/* umbra list filters: transmission curves that come with the program, and the Sun's and Vega's
 * magnitudes in them. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/data.h"
#include "base/core/listing.h"
#include "environment/environment.h"
#include "optics/instrument/filter.h"
#include "optics/instrument/photometry.h"

#define BINS 400

struct row {
  double from, to, pivot, peak; /* [m], [m], [m], [1] */
  double sun_ab, vega_ab;       /* of the Sun at 1 au, and of Vega */
};

static struct row row_of(const struct um_environment *environment,
                         const struct um_instrument_filter *filter)
{
  double wavelength[BINS], width[BINS], transmission[BINS], sun[BINS];
  const struct um_instrument_bins bins = {BINS, wavelength, width, transmission};
  struct row r = {.from = filter->wavelength[0], .to = filter->wavelength[filter->n - 1]};
  for (size_t i = 0; i < filter->n; i++) r.peak = fmax(r.peak, filter->transmission[i]);
  for (int i = 0; i < BINS; i++) {
    double from = r.from + (r.to - r.from) * i / BINS,
           to = r.from + (r.to - r.from) * (i + 1) / BINS;
    wavelength[i] = 0.5 * (from + to);
    width[i] = to - from;
    transmission[i] = um_instrument_filter_mean(filter, from, to);
    sun[i] = um_environment_solar_band(environment, from, to) / width[i];
  }
  r.pivot = um_instrument_filter_pivot(filter);
  r.sun_ab = um_instrument_magnitude_ab(&bins, sun);
  r.vega_ab = um_instrument_vega_ab(&bins);
  return r;
}

static void print_row(const char *name, const struct row *r, bool json, bool last)
{
  if (!json) {
    printf("%-14s%9.4f%9.4f%9.4f%8.3f%10.3f%10.3f\n", name, r->from * 1e6, r->to * 1e6,
           r->pivot * 1e6, r->peak, r->sun_ab, r->vega_ab);
    return;
  }
  const char *const keys[] = {"from_um", "to_um", "pivot_um", "peak", "sun_ab", "vega_ab"};
  const double values[] = {r->from * 1e6, r->to * 1e6, r->pivot * 1e6,
                           r->peak,       r->sun_ab,   r->vega_ab};
  um_core_json_text(stdout, "  {", "name", name);
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    printf(", \"%s\": ", keys[i]);
    um_core_json_number(stdout, values[i]);
  }
  printf("}%s\n", last ? "" : ",");
}

static const char head[] =
    "                from um    to um pivot um    peak    Sun AB   Vega AB\n";
static const char foot[] =
    "Photon counting; the Sun by ASTM E490 at 1 au, Vega by CALSPEC. A magnitude relative to Vega "
    "is the AB one less Vega's.\n";

static enum um_status print_filter(struct um_context *context,
                                   const struct um_environment *environment, const char *name,
                                   bool json, bool last)
{
  struct um_instrument_filter *filter;
  UM_TRY(um_instrument_filter_find(context, name, &filter));
  struct row r = row_of(environment, filter);
  print_row(name, &r, json, last);
  um_instrument_filter_destroy(context, &filter);
  return UM_OK;
}

/* Its row, and the file with its curve. */
static enum um_status print_one(struct um_context *context,
                                const struct um_environment *environment, const char *name,
                                bool json)
{
  char *path;
  UM_TRY(um_core_data_find(context, "filter", "filters", ".csv", name, &path));
  if (!json) fputs(head, stdout);
  enum um_status status = print_filter(context, environment, name, json, true);
  if (!json && status == UM_OK) printf("%scurve: %s\n", foot, path);
  um_core_free(context, path);
  return status;
}

int um_app_filters(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  char **names = NULL;
  size_t count = 0;
  struct um_environment environment;
  um_environment_defaults(&environment);
  if (options->npositional == 1) {
    UM_CHECK(print_one(context, &environment, options->positional[0], options->json));
    goto done;
  }
  UM_CHECK(um_instrument_filter_names(context, &names, &count));
  fputs(options->json ? "[\n" : head, stdout);
  for (size_t i = 0; i < count; i++)
    UM_CHECK(print_filter(context, &environment, names[i], options->json, i + 1 == count));
  fputs(options->json ? "]\n" : foot, stdout);
done:
  um_core_listing_free(context, names, count);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}

void um_app_filters_put(struct um_context *context, FILE *file)
{
  char **names = NULL;
  size_t count = 0;
  if (um_instrument_filter_names(context, &names, &count) == UM_OK)
    for (size_t i = 0; i < count; i++) fprintf(file, "%s%s", i > 0 ? " " : "", names[i]);
  um_core_listing_free(context, names, count);
}
