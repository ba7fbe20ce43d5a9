/* What measurements say of the points of a study, as tables and for a person. */

#include "base/core/csv.h"
#include "base/uncertainty/statistics.h"
#include "study/measured.h"

#define FEW 20.0 /* equal points, below which a posterior rests on too little */

static void points(const struct um_study_result *r, const struct um_study_measured *m, FILE *file)
{
  fputs("point", file);
  for (size_t i = 0; i < r->nparameter; i++) um_core_csv_put_text(file, r->parameter_name[i], "");
  fputs(",chi2,weight\n", file);
  for (size_t p = 0; p < r->npoint; p++) {
    fprintf(file, "%zu", p);
    for (size_t i = 0; i < r->nparameter; i++)
      um_core_csv_put_exact(file, r->parameter[p * r->nparameter + i]);
    um_core_csv_put_exact(file, m->chi2[p]);
    um_core_csv_put_exact(file, m->weight[p]);
    fputs("\n", file);
  }
}

struct row {
  double before, before_deviation, after, deviation, quantile[UM_STUDY_QUANTILES], best;
};

/* Every parameter before and after, out [nparameter]. */
static enum um_status rows(struct um_context *context, const struct um_study_result *r,
                           const struct um_study_measured *m, struct row *out)
{
  enum um_status status;
  size_t n = r->nparameter;
  double *work = NULL;
  UM_CHECK(um_core_allocate(context, n, (4 + UM_STUDY_QUANTILES) * sizeof *work, &work));
  um_uncertainty_mean(r->npoint, n, r->parameter, NULL, work, work + n);
  um_uncertainty_mean(r->npoint, n, r->parameter, m->weight, work + 2 * n, work + 3 * n);
  UM_CHECK(um_uncertainty_quantiles(context, r->npoint, n, r->parameter, m->weight,
                                    UM_STUDY_QUANTILES, um_study_quantile, work + 4 * n));
  for (size_t i = 0; i < n; i++) {
    out[i] = (struct row){.before = work[i],
                          .before_deviation = work[n + i],
                          .after = work[2 * n + i],
                          .deviation = work[3 * n + i],
                          .best = r->parameter[m->best * n + i]};
    for (size_t p = 0; p < UM_STUDY_QUANTILES; p++) out[i].quantile[p] = work[(4 + p) * n + i];
  }
done:
  um_core_free(context, work);
  return status;
}

static void parameters(const struct um_study_result *r, const struct row *row, FILE *file)
{
  fputs("parameter,unit,mean_before,standard_deviation_before,mean,standard_deviation,q05,q25,q50,"
        "q75,q95,best\n",
        file);
  for (size_t i = 0; i < r->nparameter; i++) {
    um_core_csv_put(file, r->parameter_name[i], "");
    um_core_csv_put_text(file, r->parameter_unit[i], "");
    um_core_csv_put_exact(file, row[i].before);
    um_core_csv_put_exact(file, row[i].before_deviation);
    um_core_csv_put_exact(file, row[i].after);
    um_core_csv_put_exact(file, row[i].deviation);
    for (size_t p = 0; p < UM_STUDY_QUANTILES; p++) um_core_csv_put_exact(file, row[i].quantile[p]);
    um_core_csv_put_exact(file, row[i].best);
    fputs("\n", file);
  }
}

enum um_status um_study_measured_write(struct um_context *context,
                                       const struct um_study_result *result,
                                       const struct um_study_measured *measured,
                                       struct um_core_folder *folder)
{
  enum um_status status;
  struct row *row = NULL;
  FILE *file = NULL;
  UM_CHECK(um_core_allocate(context, result->nparameter, sizeof *row, &row));
  UM_CHECK(rows(context, result, measured, row));
  UM_CHECK(um_core_folder_open(context, folder, "measured.csv", &file));
  points(result, measured, file);
  UM_CHECK(um_core_file_close(context, "measured.csv", &file));
  UM_CHECK(um_core_folder_open(context, folder, "parameters.csv", &file));
  parameters(result, row, file);
  UM_CHECK(um_core_file_close(context, "parameters.csv", &file));
done:
  um_core_free(context, row);
  return status;
}

enum um_status um_study_measured_print(struct um_context *context,
                                       const struct um_study_result *result,
                                       const struct um_study_measured *measured, FILE *file)
{
  enum um_status status;
  struct row *row = NULL;
  const struct um_study_measured *m = measured;
  UM_CHECK(um_core_allocate(context, result->nparameter, sizeof *row, &row));
  UM_CHECK(rows(context, result, m, row));
  fprintf(file,
          "%zu measured rows, %zu left out; best is point %zu with chi2 %.4g; the points are worth "
          "%.3g "
          "equal ones\n",
          m->used, m->left_out, m->best, m->chi2[m->best], m->effective);
  if (m->effective < FEW)
    fprintf(file,
            "too few for a posterior that can be trusted: more points, or narrower ranges about "
            "the best\n");
  for (size_t i = 0; i < result->nparameter; i++)
    fprintf(file, "  %s: %.4g +- %.2g %s before, %.4g +- %.2g after (90 %%: %.4g to %.4g)\n",
            result->parameter_name[i], row[i].before, row[i].before_deviation,
            result->parameter_unit[i], row[i].after, row[i].deviation, row[i].quantile[0],
            row[i].quantile[4]);
done:
  um_core_free(context, row);
  return status;
}
