/* The files of a diagnosis: diagnosis.json, diagnosis.txt, ranking.csv, fit.csv, heat.csv,
 * improved/. */
#include "evidence/diagnosis/report/write.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/file.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/plot.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/report/text.h"
#include "evidence/diagnosis/report/write_json.h"
#include "evidence/measurements/time_text.h"

static const char *state_of(const struct um_sensitivity_candidate *candidate,
                            const struct um_inference_score *score)
{
  if (candidate->insensitive) return candidate->why != NULL ? "refused" : "unseen";
  return score != NULL && score->absorbed ? "absorbed" : "tested";
}

/* An observation per parameter, one without for a switch. rank 0: not tested. */
static void ranking_rows(FILE *file, const struct um_sensitivity_candidate *candidate, size_t rank,
                         const struct um_inference_score *score)
{
  size_t n = candidate->is_switch || score == NULL ? 0 : candidate->ncolumn;
  for (size_t k = 0; k < (n > 0 ? n : 1); k++) {
    if (rank > 0) fprintf(file, "%zu", rank);
    um_core_csv_put_text(file, candidate->off ? candidate->name : candidate->effect->name, "");
    um_core_csv_put_text(file, candidate->target != NULL ? candidate->target : "", "");
    const double figure[] = {
        score == NULL ? (double)NAN : score->statistic, score == NULL ? (double)NAN : score->dof,
        score == NULL ? (double)NAN : score->p, score == NULL ? (double)NAN : score->p_corrected,
        score == NULL ? (double)NAN : score->kept};
    for (size_t i = 0; i < sizeof figure / sizeof figure[0]; i++)
      um_core_csv_put_number(file, figure[i]);
    if (n > 0) {
      const struct um_effect_parameter *parameter =
          &candidate->effect->parameters[candidate->parameter[k]];
      double value, sigma;
      um_diagnosis_report_estimate(candidate, score, k, &value, &sigma);
      um_core_csv_put_text(file, parameter->name, "");
      um_core_csv_put_text(file, parameter->unit, "");
      um_core_csv_put_number(file, value);
      um_core_csv_put_number(file, sigma);
    } else {
      fputs(",,,,", file);
    }
    fprintf(file, ",%s,", state_of(candidate, score));
    um_core_csv_put(file, candidate->why != NULL ? candidate->why : "", "");
    fputc('\n', file);
  }
}

static bool is_ranked(const struct um_diagnosis *d, size_t candidate)
{
  for (size_t i = 0; i < d->nranking; i++)
    if (d->ranking[i].candidate == candidate) return true;
  return false;
}

/* Candidates on the baseline, best first, then those that were not tested. */
static void write_ranking(const struct um_diagnosis *d, FILE *file)
{
  fputs("rank,effect,target,chi2_explained,dof,p,p_corrected,kept,parameter,unit,estimate,sigma,"
        "state,why\n",
        file);
  for (size_t i = 0; i < d->nranking; i++)
    ranking_rows(file, um_diagnosis_report_candidate_of(d, &d->ranking[i]), i + 1,
                 &d->ranking[i].score);
  for (size_t i = 0; i < d->candidates->count; i++)
    if (!is_ranked(d, i)) ranking_rows(file, &d->candidates->candidate[i], 0, NULL);
}

/* Sigma of a measurement in the unit of its quantity, without the model's: as given, or from the
 * linear one. */
static double row_sigma(const struct um_sensitivity_forward *f, size_t i,
                        enum um_compare_quantity quantity)
{
  double given = f->measurements->row[f->observations.row[i]].sigma;
  if (!isnan(given) || !um_compare_is_magnitude(quantity))
    return isnan(given) ? f->observations.stated_sigma[i] : given;
  return UM_POGSON * f->observations.stated_sigma[i] / fabs(f->observations.measured[i]);
}

static void fit_row(const struct um_diagnosis *d, size_t c, size_t i, FILE *file)
{
  const struct um_sensitivity_forward *f = d->forward;
  const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
  char time[40];
  um_compare_time_text(f->observations.t[i], time);
  fprintf(file, "%s,%s,", time, um_compare_quantity_name(channel->quantity));
  um_core_csv_put(file, channel->label, "");
  um_core_csv_put_number(file, f->measurements->row[f->observations.row[i]].value);
  um_core_csv_put_number(file, row_sigma(f, i, channel->quantity));
  um_core_csv_put_number(file, um_diagnosis_report_in_unit(channel->quantity, d->value_before[i]));
  um_core_csv_put_number(file, um_diagnosis_report_in_unit(channel->quantity, d->value_after[i]));
  um_core_csv_put_number(file, (f->observations.measured[i] - d->value_before[i]) /
                                   f->observations.sigma[i]);
  um_core_csv_put_number(file, (f->observations.measured[i] - d->value_after[i]) /
                                   f->observations.sigma[i]);
  fputc('\n', file);
}

/* Channel after channel, each in order of time, in the units of the measurements; residuals in
 * sigma of measurement and model together, of flux for magnitudes. */
static enum um_status write_fit(struct um_context *context, const struct um_diagnosis *d,
                                FILE *file)
{
  fputs("time_utc,quantity,of,measured,sigma,before,after,residual_before_in_sigma,"
        "residual_after_in_sigma\n",
        file);
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) {
    size_t *row, n;
    UM_TRY(um_diagnosis_report_channel_rows(context, d, c, &row, &n));
    for (size_t i = 0; i < n; i++) fit_row(d, c, row[i], file);
    um_core_free(context, row);
  }
  return UM_OK;
}

static void write_heat(const struct um_missing_heat_unexplained *u, FILE *file)
{
  fputs("from_utc,to_utc,place,heat_W,sigma_W,low_W,high_W\n", file);
  for (size_t h = 0; h < u->nheat; h++)
    for (size_t i = 0; i < u->heat[h].nbin; i++) {
      char from[40], to[40];
      um_compare_time_text(u->heat[h].t[i], from);
      um_compare_time_text(u->heat[h].t[i + 1], to);
      fprintf(file, "%s,%s,", from, to);
      um_core_csv_put(file, u->heat[h].place, "");
      um_core_csv_put_number(file, u->heat[h].heat[i]);
      um_core_csv_put_number(file, u->heat[h].sigma[i]);
      um_core_csv_put_number(file, u->heat[h].low[i]);
      um_core_csv_put_number(file, u->heat[h].high[i]);
      fputc('\n', file);
    }
}

enum um_status um_diagnosis_report_write(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, const char *command,
                                         const char *version, bool pictures,
                                         struct um_core_folder *folder)
{
  FILE *file;
  UM_TRY(um_core_folder_open(context, folder, "diagnosis.json", &file));
  enum um_status status =
      um_diagnosis_report_write_json(context, diagnosis, command, version, file);
  enum um_status closed = um_core_file_close(context, "diagnosis.json", &file);
  UM_TRY(status != UM_OK ? status : closed);
  UM_TRY(um_core_folder_open(context, folder, "diagnosis.txt", &file));
  status = um_diagnosis_report_write_text(context, diagnosis, file);
  closed = um_core_file_close(context, "diagnosis.txt", &file);
  UM_TRY(status != UM_OK ? status : closed);
  if (diagnosis->candidates != NULL) {
    UM_TRY(um_core_folder_open(context, folder, "ranking.csv", &file));
    write_ranking(diagnosis, file);
    UM_TRY(um_core_file_close(context, "ranking.csv", &file));
  }
  UM_TRY(um_core_folder_open(context, folder, "fit.csv", &file));
  status = write_fit(context, diagnosis, file);
  closed = um_core_file_close(context, "fit.csv", &file);
  UM_TRY(status != UM_OK ? status : closed);
  UM_TRY(um_diagnosis_report_posterior_write(context, diagnosis, folder));
  if (diagnosis->unexplained != NULL && diagnosis->unexplained->nheat > 0) {
    UM_TRY(um_core_folder_open(context, folder, "heat.csv", &file));
    write_heat(diagnosis->unexplained, file);
    UM_TRY(um_core_file_close(context, "heat.csv", &file));
  }
  UM_TRY(um_diagnosis_report_improved_write(context, diagnosis, command, version,
                                            um_core_folder_path(folder)));
  if (pictures) UM_TRY(um_diagnosis_report_plot(context, diagnosis, um_core_folder_path(folder)));
  return um_diagnosis_report_write_page(context, diagnosis, command, folder);
}
