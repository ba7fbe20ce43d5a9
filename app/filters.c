/* umbra filters: transmission curves that come with the program, and the Sun's and Vega's
 * magnitudes in them. */
#include <math.h>
#include <string.h>

#include "app/app.h"
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

int um_app_filters(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  char **names = NULL;
  size_t count = 0;
  struct um_environment environment;
  um_environment_defaults(&environment);
  UM_CHECK(um_instrument_filter_names(context, &names, &count));
  if (options->json)
    puts("[");
  else
    printf("%-14s%9s%9s%9s%8s%10s%10s\n", "", "from um", "to um", "pivot um", "peak", "Sun AB",
           "Vega AB");
  for (size_t i = 0; i < count; i++) {
    struct um_instrument_filter *filter;
    UM_CHECK(um_instrument_filter_find(context, names[i], &filter));
    struct row r = row_of(&environment, filter);
    print_row(names[i], &r, options->json, i + 1 == count);
    um_instrument_filter_destroy(context, &filter);
  }
  if (options->json)
    puts("]");
  else
    puts("Photon counting; the Sun by ASTM E490 at 1 au, Vega by CALSPEC. A magnitude relative to "
         "Vega is the AB one less Vega's.");
done:
  um_core_listing_free(context, names, count);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
