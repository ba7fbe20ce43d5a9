/* umbra period: the period of measured light curves, before any model. */
#include <math.h>

#include "app/app.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "evidence/inversion/period_report.h"
#include "evidence/inversion/period_write.h"
#include "evidence/measurements/measurements.h"
#include "orbit/time.h"

static void print_report(const struct um_compare_period_report *r, const char *folder)
{
  printf("%-28s %14s %12s %8s %12s  %s\n", "light curve", "period [s]", "sigma [s]", "power",
         "false alarm", "a maximum at");
  for (size_t i = 0; i < r->count; i++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[i].channel];
    const struct um_compare_period *p = r->entry[i].period;
    char name[80], epoch[32];
    snprintf(name, sizeof name, "%s %s", um_compare_quantity_name(of->quantity), of->of);
    um_orbit_time_format(p->epoch, epoch);
    if (um_compare_period_is_named(p))
      printf("%-28s %14.6g %12.2g %8.3f %12.2g  %s\n", name, p->period, p->period_sigma,
             p->best_power, p->false_alarm, epoch);
    else
      printf("%-28s %14s %12s %8.3f %12.2g  no period: noise peaks as high (at %.4g s)\n", name,
             "-", "-", p->best_power, p->false_alarm, p->period);
    if (p->red > 0.0)
      printf("%28s red noise: %.2g times the white variance, correlated over %.3g s\n", "", p->red,
             p->red_time);
  }
  printf(
      "a trend of every track (polynomial, up to the seventh degree) is taken out, of the folded "
      "curve too; two turns in the longest track is the slowest looked for; named below a false "
      "alarm of %g\n",
      UM_COMPARE_PERIOD_LEVEL);
  printf("the light of a tumbling body often repeats twice or more a turn: look at 2 and 4 times "
         "the period too\n");
  um_app_tell_results(folder);
}

static void print_json(const struct um_compare_period_report *r, const char *folder)
{
  um_core_json_text(stdout, "{", "folder", folder);
  printf(",\n  \"channels\": [");
  for (size_t i = 0; i < r->count; i++) {
    const struct um_compare_channel *of = &r->measurements->channel[r->entry[i].channel];
    const struct um_compare_period *p = r->entry[i].period;
    char epoch[32];
    um_orbit_time_format(p->epoch, epoch);
    printf("%s{\"quantity\": \"%s\", \"of\": ", i > 0 ? ", " : "",
           um_compare_quantity_name(of->quantity));
    um_core_json_string(stdout, of->of);
    printf(", \"named\": %s, \"period_s\": ", um_compare_period_is_named(p) ? "true" : "false");
    um_core_json_number(stdout, um_compare_period_is_named(p) ? p->period : (double)NAN);
    um_core_json_field(stdout, ", ", "highest_peak_s", p->period);
    um_core_json_field(stdout, ", ", "red_noise", p->red);
    um_core_json_field(stdout, ", ", "red_noise_time_s", p->red_time);
    um_core_json_field(stdout, ", ", "sigma_s", p->period_sigma);
    um_core_json_field(stdout, ", ", "power", p->best_power);
    um_core_json_field(stdout, ", ", "false_alarm", p->false_alarm);
    printf(", \"maximum_utc\": \"%s\"}", epoch);
  }
  printf("]}\n");
}

int um_app_period(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_compare_measurements *measurements = NULL;
  struct um_compare_period_report *report = NULL;
  struct um_core_folder *folder = NULL;
  const struct um_compare_period_options search = {0};
  const char *out = options->out != NULL ? options->out : "out/period";
  UM_CHECK(um_compare_measurements_read(context, options->positional[0], &measurements));
  UM_CHECK(um_compare_period_report_create(context, measurements, options->band, &search, &report));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_compare_period_write(context, report, !options->no_plots, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  if (options->json)
    print_json(report, out);
  else
    print_report(report, out);
done:
  um_core_folder_abort(&folder);
  um_compare_period_report_destroy(context, &report);
  um_compare_measurements_destroy(context, &measurements);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
