/* umbra calibrate: factor and extinction of a telescope from stars, applied to counts. */
#include <math.h>

#include "app/app.h"
#include "app/target.h"
#include "app/terminal.h"
#include "base/core/number.h"
#include "evidence/inversion/photometry.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "model/build/bands.h"
#include "model/build/build.h"

static void print_calibration(const struct um_instrument_calibration *c)
{
  printf("kappa       %.5f +- %.2g, factor of the counts of the scenario's sensor\n", c->kappa,
         c->kappa_sigma);
  printf("extinction  %.4f +- %.2g mag per airmass beyond the scenario's air\n", c->extinction,
         c->extinction_sigma);
  printf("correlation %.3f, chi2 %.4g of %zu degrees of freedom\n", c->correlation, c->chi2,
         c->dof);
}

/* rows: of the measurements that were calibrated, where file is not NULL. */
static void json_calibration(const struct um_instrument_calibration *c, const char *file,
                             size_t rows)
{
  um_core_json_field(stdout, "{", "kappa", c->kappa);
  um_core_json_field(stdout, ", ", "kappa_sigma", c->kappa_sigma);
  um_core_json_field(stdout, ", ", "extinction_mag", c->extinction);
  um_core_json_field(stdout, ", ", "extinction_sigma_mag", c->extinction_sigma);
  um_core_json_field(stdout, ", ", "correlation", c->correlation);
  um_core_json_field(stdout, ", ", "chi2", c->chi2);
  um_core_json_count(stdout, ", ", "dof", c->dof);
  um_core_json_text(stdout, ", ", "file", file);
  um_core_json_count(stdout, ", ", "rows", rows);
  printf("}\n");
}

/* The measurements divided by it, written beside; *rows: how many. */
static enum um_status apply(struct um_context *context, const struct um_app_options *options,
                            const struct um_model *model, size_t sensor,
                            const struct um_instrument_calibration *calibration, size_t *rows)
{
  struct um_compare_measurements *m = NULL;
  enum um_status status;
  UM_TRY(um_compare_measurements_read(context, options->positional[2], &m));
  UM_CHECK(um_compare_calibrate(context, model, sensor, calibration, m, rows));
  UM_CHECK(um_compare_measurements_write(context, m, options->out));
done:
  um_compare_measurements_destroy(context, &m);
  return status;
}

static enum um_status parse(struct um_context *context, const struct um_app_options *options,
                            double *extinction)
{
  bool series = options->npositional > 2, written = options->out != NULL;
  *extinction = NAN;
  if (series != written)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s; accepted: both MEASURED and -o FILE, or neither",
                        series ? "MEASURED without -o" : "-o without MEASURED");
  if (options->extinction != NULL &&
      !(um_core_number_parse(options->extinction, extinction) && fabs(*extinction) <= 10.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "--extinction %s; accepted: a number from -10 to 10 [mag per airmass]",
                        options->extinction);
  return written ? um_app_check_table(context, options) : UM_OK;
}

int um_app_calibrate(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_instrument_calibration calibration;
  struct um_model_options changes = um_app_model_options(options);
  double extinction;
  size_t sensor, rows = 0;
  UM_CHECK(parse(context, options, &extinction));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  status = um_model_sensor_require(context, model, options->sensor, &sensor);
  if (status != UM_OK) um_core_message_prefix(context, "--sensor");
  if (status != UM_OK) goto done;
  UM_CHECK(um_compare_calibration_read(context, model, sensor, options->positional[1], extinction,
                                       &calibration));
  if (options->out != NULL) UM_CHECK(apply(context, options, model, sensor, &calibration, &rows));
  um_app_terminal_clear();
  if (options->json) {
    json_calibration(&calibration, options->out, rows);
    goto done;
  }
  print_calibration(&calibration);
  if (options->out != NULL)
    printf("%s: %zu rows of count_rate '%s' calibrated\n", options->out, rows,
           model->sensor[sensor].name);
done:
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
