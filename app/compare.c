/* umbra compare: a scenario beside measurements. */
#include <math.h>

#include "app/app.h"
#include "app/measured.h"
#include "app/terminal.h"
#include "evidence/comparison/report.h"
#include "evidence/inversion/whole.h"
#include "orbit/time.h"

#define CORRELATIONS_SHOWN 3
#define CORRELATION_P      0.01 /* weaker ones are not shown */
#define SHARE_SHOWN        1e-3 /* of the largest, of the variance */
#define NUMBER_MAX         1e4  /* ratios beyond it say only that the model is dark there */

/* Metrics of one segment as a line of the table; "-" for what does not exist. Bias and rms of
 * magnitudes stand in magnitudes, the rest in linear flux. */
static void print_metrics(const char *segment, const struct um_compare_metrics *m)
{
  bool magnitude = !isnan(m->rms_mag);
  const double number[] = {magnitude ? m->bias_mag : m->bias,
                           magnitude ? m->rms_mag : m->rms,
                           m->rms_over_mean,
                           m->scale,
                           m->chi2_reduced,
                           m->durbin_watson,
                           m->white_p};
  static const char *const format[] = {" %12.3e", " %11.3e", " %9.4f", " %8.4f",
                                       " %10.3f", " %6.2f",  " %9.1e"};
  static const int width[] = {13, 12, 10, 9, 11, 7, 10};
  printf("  %-9s %12zu", segment, m->count);
  for (size_t i = 0; i < sizeof number / sizeof number[0]; i++)
    if (isnan(number[i]) || (i >= 2 && i <= 3 && fabs(number[i]) > NUMBER_MAX))
      printf("%*s", width[i], "-");
    else
      printf(format[i], number[i]); /* NOLINT: formats are literals of this function */
  printf("\n");
}

static void print_worst(const struct um_compare_interval *w, const char *unit)
{
  char from[32], to[32];
  um_orbit_time_format(w->from, from);
  um_orbit_time_format(w->to, to);
  printf("  worst: %.12s to %.12s, %zu observations, chi2 %.4g, bias %+.3e %s, sunlit %.2f",
         from + 11, to + 11, w->count, w->chi2, w->bias, unit, w->sunlit);
  for (int pass = 0; pass < 2; pass++) {
    const struct um_compare_share *share = pass == 0 ? w->mechanism : w->material;
    size_t n = pass == 0 ? w->nmechanism : w->nmaterial;
    const char *between = pass == 0 ? "; model: " : "; ";
    double largest = 0.0;
    for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(share[i].value));
    for (size_t i = 0; i < n; i++) {
      if (!(fabs(share[i].value) > SHARE_SHOWN * largest)) continue;
      printf("%s%s %.3g", between, share[i].name, share[i].value);
      between = ", ";
    }
    if (n > 0) printf(w->nmaterial == 0 ? " W" : " W/sr");
  }
  printf("\n");
}

static void print_channel(const struct um_compare_comparison *c, size_t i)
{
  const struct um_compare_channel_comparison *channel = &c->channel[i];
  const struct um_compare_channel *of = &c->run.plan->measurements->channel[channel->channel];
  printf("%s %s [%s]", um_compare_quantity_name(of->quantity), of->label,
         um_compare_quantity_unit(of->quantity));
  if (channel->left_out > 0) printf(", %zu observations left out by their flag", channel->left_out);
  bool magnitude = um_compare_is_magnitude(of->quantity);
  printf("\n  %-9s %12s%13s%12s%10s%9s%11s%7s%10s\n", "segment", "observations",
         magnitude ? "bias [mag]" : "bias", magnitude ? "rms [mag]" : "rms", "rms/mean", "scale",
         "chi2/dof", "DW", "p white");
  print_metrics("all", &channel->all);
  for (int s = 0; s < UM_SEGMENT_COUNT; s++)
    if (channel->segment[s].count > 0)
      print_metrics(um_compare_segment_name((enum um_compare_segment)s), &channel->segment[s]);
  if (magnitude)
    printf("  as flux of magnitude 0: bias %.3e, rms %.3e\n", channel->all.bias, channel->all.rms);
  if (!isnan(channel->all.correlation))
    printf("  Pearson correlation of magnitudes %.3f\n", channel->all.correlation);
  if (channel->all.model_share > UM_COMPARE_SHARE_SHOWN)
    printf("  the model's own sampling error is %.2g %% of the variance\n",
           100.0 * channel->all.model_share);
  if (channel->nworst > 0) print_worst(&channel->worst[0], um_compare_residual_unit(of->quantity));
  printf("  residual correlates with:");
  size_t shown = 0;
  for (; shown < channel->ncorrelation && shown < CORRELATIONS_SHOWN; shown++) {
    const struct um_compare_correlation *r = &channel->correlation[shown];
    if (!(r->p < CORRELATION_P)) break;
    printf("%s %s %+.2f", shown > 0 ? "," : "", r->name, r->value);
  }
  printf(shown == 0 ? " nothing\n" : "\n");
}

static void print_comparison(const struct um_compare_comparison *c, const char *folder)
{
  size_t count = 0;
  for (size_t i = 0; i < c->nchannel; i++) count += c->channel[i].count;
  printf("%s against %s: %zu observations at %zu times\n", c->run.model->scenario->name,
         c->run.plan->measurements->path, count, c->run.tables->nobs);
  for (size_t i = 0; i < c->nchannel; i++) print_channel(c, i);
  if (!isnan(c->chi2_reduced))
    printf("all channels: chi2 %.6g of %.6g degrees of freedom, reduced %.4g\n", c->chi2, c->dof,
           c->chi2_reduced);
  if (c->samples != c->samples_before)
    printf(
        "optics.samples %d in place of the scenario's %d, so that the model's own sampling error "
        "stays small\n",
        c->samples, c->samples_before);
  um_app_tell_results(folder);
}

static enum um_status write_folder(struct um_context *context,
                                   const struct um_compare_comparison *comparison,
                                   const struct um_app_options *options,
                                   struct um_core_folder **folder)
{
  UM_TRY(um_compare_write(context, comparison, options->command, UM_APP_VERSION, !options->no_plots,
                          *folder));
  return um_core_folder_commit(context, folder);
}

int um_app_compare(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_compare_measurements *measurements = NULL;
  struct um_compare_whole whole = {0};
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL;
  UM_CHECK(um_app_measured_read(context, options, &measurements));
  UM_CHECK(um_compare_whole_begin(context, options->positional[0], &changes, measurements, &whole));
  UM_CHECK(um_app_out_folder(context, options, whole.model->scenario->name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_compare_whole_run(context, &whole));
  UM_CHECK(write_folder(context, whole.comparison, options, &folder));
  um_app_terminal_clear();
  if (options->json)
    um_compare_write_json(whole.comparison, options->command, UM_APP_VERSION, stdout);
  else
    print_comparison(whole.comparison, out);
done:
  um_core_folder_abort(&folder);
  um_compare_whole_release(context, &whole);
  um_compare_measurements_destroy(context, &measurements);
  um_core_free(context, out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
