/* Metrics of residuals r = y - m (measured less model) in linear flux. The definitions stand beside
 * the fields in metrics.h; the least-squares scale is c = sum(y m) / sum(m^2). */
#include "evidence/comparison/metrics.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/inference/distributions.h"
#include "evidence/comparison/residual.h"
#include "evidence/comparison/statistics_group.h"

/* Residuals gathered for one segment, and room for what is sorted. */
struct observations {
  size_t n;
  struct um_compare_residual *of; /* [n] */
  double *work;                   /* [2 n] */
};

static struct um_compare_metrics no_metrics(void)
{
  return (struct um_compare_metrics){.mean_measured = NAN,
                                     .mean_model = NAN,
                                     .bias = NAN,
                                     .sd = NAN,
                                     .rms = NAN,
                                     .rms_over_mean = NAN,
                                     .median_ratio = NAN,
                                     .scale = NAN,
                                     .rms_scaled = NAN,
                                     .correlation = NAN,
                                     .bias_mag = NAN,
                                     .rms_mag = NAN,
                                     .model_share = NAN,
                                     .chi2 = NAN,
                                     .dof = NAN,
                                     .chi2_reduced = NAN,
                                     .chi2_p = NAN,
                                     .durbin_watson = NAN,
                                     .white_p = NAN};
}

/* Means, scatter and rms, which every quantity has. */
static void set_moments(const struct observations *data, struct um_compare_metrics *out)
{
  double n = (double)data->n, y = 0.0, m = 0.0, squares = 0.0, scatter = 0.0;
  for (size_t i = 0; i < data->n; i++) {
    double r = data->of[i].measured - data->of[i].model;
    y += data->of[i].measured;
    m += data->of[i].model;
    out->bias = i == 0 ? r : out->bias + r;
    squares += r * r;
  }
  out->mean_measured = y / n;
  out->mean_model = m / n;
  out->bias /= n;
  out->rms = sqrt(squares / n);
  for (size_t i = 0; i < data->n; i++) {
    double about = data->of[i].measured - data->of[i].model - out->bias;
    scatter += about * about;
  }
  if (data->n > 1) out->sd = sqrt(scatter / (n - 1.0));
}

/* What only a flux has, which a ratio can change. */
static void set_ratios(struct observations *data, struct um_compare_metrics *out)
{
  double ym = 0.0, mm = 0.0, squares = 0.0;
  size_t ratios = 0;
  if (out->mean_measured > 0.0) out->rms_over_mean = out->rms / out->mean_measured;
  for (size_t i = 0; i < data->n; i++) {
    ym += data->of[i].measured * data->of[i].model;
    mm += data->of[i].model * data->of[i].model;
    if (data->of[i].model > 0.0) data->work[ratios++] = data->of[i].measured / data->of[i].model;
  }
  out->median_ratio = um_compare_median(ratios, data->work);
  if (!(mm > 0.0)) return;
  out->scale = ym / mm;
  for (size_t i = 0; i < data->n; i++) {
    double r = data->of[i].measured - out->scale * data->of[i].model;
    squares += r * r;
  }
  out->rms_scaled = sqrt(squares / (double)data->n);
}

/* Of magnitudes, by the logarithms of the fluxes. */
static void set_magnitudes(struct observations *data, struct um_compare_metrics *out)
{
  const double magnitude = -UM_POGSON; /* of one unit of ln(flux) */
  double *x = data->work, *y = data->work + data->n, sum = 0.0, squares = 0.0;
  size_t n = 0;
  for (size_t i = 0; i < data->n; i++) {
    if (!(data->of[i].measured > 0.0 && data->of[i].model > 0.0)) continue;
    x[n] = log(data->of[i].model);
    y[n] = log(data->of[i].measured);
    sum += magnitude * (y[n] - x[n]);
    squares += magnitude * magnitude * (y[n] - x[n]) * (y[n] - x[n]);
    n++;
  }
  out->correlation = um_compare_pearson(n, x, y);
  if (n == 0) return;
  out->bias_mag = sum / (double)n;
  out->rms_mag = sqrt(squares / (double)n);
}

/* Chi-square over the observations that have a sigma; whiteness over all. share: parameters per
 * observation. */
static void set_statistics(struct observations *data, double share, struct um_compare_metrics *out)
{
  double chi2 = 0.0, model = 0.0;
  size_t weighted = 0;
  for (size_t i = 0; i < data->n; i++) {
    const struct um_compare_residual *of = &data->of[i];
    double z = um_compare_residual_normalised(of);
    data->work[i] = z;
    if (isnan(of->sigma)) continue;
    chi2 += z * z;
    model += um_compare_residual_share(of->sigma, of->model_sigma);
    weighted++;
  }
  if (weighted > 0) {
    out->model_share = model / (double)weighted;
    out->chi2 = chi2;
    out->dof = (double)weighted - share * (double)weighted;
    if (out->dof > 0.0) {
      out->chi2_reduced = chi2 / out->dof;
      out->chi2_p = um_inference_chi2_q(chi2, out->dof);
    }
  }
  for (size_t i = 0; weighted < data->n && i < data->n; i++)
    data->work[i] = data->of[i].measured - data->of[i].model;
  um_compare_durbin_watson(data->n, data->work, &out->durbin_watson, &out->white_p);
}

static struct um_compare_metrics measure(enum um_compare_quantity quantity,
                                         struct observations *data, double share)
{
  struct um_compare_metrics out = no_metrics();
  out.count = data->n;
  if (data->n == 0) return out;
  set_moments(data, &out);
  bool heat =
      quantity == UM_QUANTITY_TEMPERATURE || quantity == UM_QUANTITY_CHARACTERISTIC_TEMPERATURE;
  if (!heat) set_ratios(data, &out);
  if (um_compare_is_magnitude(quantity)) set_magnitudes(data, &out);
  set_statistics(data, share, &out);
  return out;
}

static enum um_status check(struct um_context *context, enum um_compare_quantity quantity,
                            size_t number, const struct um_compare_residual *of)
{
  const char *unit = um_compare_residual_unit(quantity);
  if (!isnan(of->sigma) && (!(of->sigma > 0.0) || !isfinite(of->sigma)))
    return um_core_fail(context, UM_ERR_NUMERIC,
                        "metrics: observation %zu: sigma %g %s; accepted: above 0, or NaN for none",
                        number, of->sigma, unit);
  if (!isfinite(of->measured) || !isfinite(of->model))
    return um_core_fail(
        context, UM_ERR_NUMERIC,
        "metrics: observation %zu: measured %g, model %g %s; accepted: finite numbers", number,
        of->measured, of->model, unit);
  if (!(of->model_sigma >= 0.0) || !isfinite(of->model_sigma))
    return um_core_fail(
        context, UM_ERR_NUMERIC,
        "metrics: observation %zu: standard error of the model %g; accepted: 0 or more", number,
        of->model_sigma);
  return UM_OK;
}

enum um_status um_compare_metrics_compute(struct um_context *context,
                                          enum um_compare_quantity quantity, size_t count,
                                          const struct um_compare_residual *residual,
                                          const size_t *label, size_t nlabel, double fitted,
                                          struct um_compare_metrics *segment,
                                          struct um_compare_metrics *all)
{
  struct observations gathered = {0};
  double share = 0.0;
  enum um_status status;
  for (size_t i = 0; label != NULL && i < count; i++)
    if (label[i] >= nlabel && label[i] != UM_COMPARE_LABEL_NONE)
      return um_core_fail(context, UM_ERR_INPUT,
                          "metrics: observation %zu: segment %zu; accepted: 0 to %zu", i + 1,
                          label[i], nlabel == 0 ? (size_t)0 : nlabel - 1);
  UM_CHECK(um_core_allocate(context, count, sizeof *gathered.of, &gathered.of));
  UM_CHECK(um_core_allocate(context, 2 * count, sizeof *gathered.work, &gathered.work));
  /* all observations first: their number gives each segment its share of the fitted parameters */
  for (size_t s = 0; s <= nlabel; s++) {
    gathered.n = 0;
    size_t weighted = 0;
    for (size_t i = 0; i < count; i++) {
      size_t l = label == NULL ? 0 : label[i];
      if (l == UM_COMPARE_LABEL_NONE || (s > 0 && l != s - 1)) continue;
      UM_CHECK(check(context, quantity, i + 1, &residual[i]));
      gathered.of[gathered.n++] = residual[i];
      if (!isnan(residual[i].sigma)) weighted++;
    }
    if (s == 0 && weighted > 0) share = fitted / (double)weighted;
    struct um_compare_metrics made = measure(quantity, &gathered, share);
    if (s > 0)
      segment[s - 1] = made;
    else if (all != NULL)
      *all = made;
  }
  status = UM_OK;
done:
  UM_FREE(context, gathered.of, gathered.work);
  return status;
}
